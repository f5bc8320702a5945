//! Selects the frame that is on the screen, and the time when it changes.
//!
//! Tries the calls that a driver's numbers promise. A call that the driver doesn't support is not
//! made again. Invariant: all changes of the device are undone on drop.

use super::FramebufferError;
use super::ioctl::{FB_ACTIVATE_VBL, FBIOPAN_DISPLAY, FbVarScreeninfo};
use super::last_resort::{Argument, Place, RestorePromise};
use super::surface::{Scheme, Surface};
use super::video_mode::VideoModeGuard;
use std::io;
use std::path::{Path, PathBuf};

/// A driver, and the scheme by which it shows frames.
pub(super) struct Display {
    // Dropped first, because it needs the open driver.
    _promise: Option<RestorePromise>,
    driver: VideoModeGuard,
    path: PathBuf,
    /// The screen's original settings, to be restored.
    found: FbVarScreeninfo,
    scheme: Scheme,
    frames: u32,
    vsync: bool,
    /// Whether the driver has fulfilled a request to wait.
    waited: bool,
    /// Whether the screen was restored because it was released.
    left: bool,
}

impl Display {
    /// Takes over the screen with the scheme that `surface` promises, or a simpler one if the
    /// driver lacks the calls. With two frames, the second one is shown first. Without `vsync`,
    /// showing doesn't wait for the vertical blank.
    pub(super) fn start(
        driver: VideoModeGuard,
        path: &Path,
        found: FbVarScreeninfo,
        surface: &Surface,
        vsync: bool,
    ) -> Result<Display, FramebufferError> {
        let mut display = Display {
            _promise: None,
            driver,
            path: path.to_owned(),
            found,
            scheme: Scheme::Single,
            frames: 1,
            vsync,
            waited: false,
            left: false,
        };
        match surface.scheme() {
            Scheme::Ps3fb => display.start_ps3fb(surface)?,
            Scheme::Pan => display.start_pan(surface)?,
            Scheme::Single => {}
        }
        Ok(display)
    }

    pub(super) fn scheme(&self) -> Scheme {
        self.scheme
    }

    pub(super) fn frames(&self) -> u32 {
        self.frames
    }

    /// A text on whether showing waits for the vertical blank.
    pub(super) fn vsync(&self) -> &'static str {
        match (self.vsync, self.waited) {
            (true, true) => "vsync",
            (true, false) => "vsync if the driver can",
            (false, _) => "no vsync",
        }
    }

    /// Waits until the visible frame may be written to, if it is the only one.
    pub(super) fn before_write(&mut self) -> Result<(), FramebufferError> {
        if self.scheme == Scheme::Single { self.wait_for_vsync() } else { Ok(()) }
    }

    /// Shows a finished frame, and returns when the previous one may be written to.
    pub(super) fn show(&mut self, frame: u32) -> Result<(), FramebufferError> {
        match self.scheme {
            Scheme::Ps3fb => {
                self.wait_for_vsync()?;
                // Returns when the frame has been copied to the video memory.
                self.driver
                    .ps3fb_fsel(frame)
                    .map_err(|source| self.ioctl("PS3FB_IOCTL_FSEL", source))
            }
            Scheme::Pan => {
                self.pan(frame).map_err(|source| self.ioctl("FBIOPAN_DISPLAY", source))?;
                // Most drivers move the screen at the vertical blank; until then the old frame is
                // visible.
                self.wait_for_vsync()
            }
            Scheme::Single => Ok(()),
        }
    }

    /// Restores the screen's original settings until [`Display::come_back`].
    pub(super) fn leave(&mut self) {
        if !self.left {
            self.left = true;
            self.restore();
        }
    }

    /// Takes over the screen again after [`Display::leave`]. Returns whether it had been left.
    pub(super) fn come_back(&mut self) -> Result<bool, FramebufferError> {
        if !self.left {
            return Ok(false);
        }
        if self.scheme == Scheme::Ps3fb {
            self.driver.ps3fb_on().map_err(|source| self.ioctl("PS3FB_IOCTL_ON", source))?;
        }
        self.left = false;
        Ok(true)
    }

    fn start_ps3fb(&mut self, surface: &Surface) -> Result<(), FramebufferError> {
        let screen = self.driver.ps3fb_screeninfo();
        let Some(screen) = self.optional("PS3FB_IOCTL_SCREENINFO", screen)? else {
            return Ok(());
        };
        let on = self.driver.ps3fb_on();
        if self.optional("PS3FB_IOCTL_ON", on)?.is_none() {
            return Ok(());
        }
        // From now on, drop switches it off.
        self.scheme = Scheme::Ps3fb;
        self.frames = surface.frames(Scheme::Ps3fb).min(screen.num_frames).max(1);
        loop {
            let selected = self.driver.ps3fb_fsel(self.frames - 1);
            if self.optional("PS3FB_IOCTL_FSEL", selected)?.is_some() {
                return Ok(());
            }
            if self.frames == 1 {
                self.restore();
                self.scheme = Scheme::Single;
                return Ok(());
            }
            self.frames -= 1;
        }
    }

    fn start_pan(&mut self, surface: &Surface) -> Result<(), FramebufferError> {
        let found = Argument::Screen(self.found);
        let promise = self.driver.promise(Place::Offset, FBIOPAN_DISPLAY, found);
        let panned = self.pan(1);
        if self.optional("FBIOPAN_DISPLAY", panned)?.is_some() {
            self.scheme = Scheme::Pan;
            self.frames = surface.frames(Scheme::Pan);
            self._promise = promise;
        }
        Ok(())
    }

    fn pan(&mut self, frame: u32) -> io::Result<()> {
        let yoffset = frame * self.found.yres;
        self.driver.pan_display(&FbVarScreeninfo {
            yoffset,
            activate: FB_ACTIVATE_VBL,
            ..self.found
        })
    }

    fn wait_for_vsync(&mut self) -> Result<(), FramebufferError> {
        if !self.vsync {
            return Ok(());
        }
        match self.driver.wait_for_vsync() {
            // There was no blank within the driver's timeout, or a signal arrived. The frame is
            // shown anyway.
            Err(source) if matches!(source.raw_os_error(), Some(libc::ETIMEDOUT | libc::EINTR)) => {
            }
            waited => self.vsync = self.optional("FBIO_WAITFORVSYNC", waited)?.is_some(),
        }
        self.waited = true;
        Ok(())
    }

    /// `None` if the driver doesn't support the request.
    fn optional<T>(
        &self,
        request: &'static str,
        result: io::Result<T>,
    ) -> Result<Option<T>, FramebufferError> {
        match result {
            Ok(value) => Ok(Some(value)),
            Err(source) => match source.raw_os_error() {
                Some(libc::ENOTTY | libc::ENOSYS | libc::EINVAL | libc::EOPNOTSUPP) => Ok(None),
                _ => Err(self.ioctl(request, source)),
            },
        }
    }

    fn ioctl(&self, request: &'static str, source: io::Error) -> FramebufferError {
        FramebufferError::Ioctl { path: self.path.clone(), request, source }
    }

    fn restore(&mut self) {
        // An error can't be reported here, and closing the device undoes the rest.
        let _ = match self.scheme {
            Scheme::Ps3fb => self.driver.ps3fb_off(),
            Scheme::Pan => self.driver.pan_display(&self.found),
            Scheme::Single => Ok(()),
        };
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        self.leave();
    }
}
