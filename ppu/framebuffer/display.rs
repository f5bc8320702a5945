//! Which frame is on the screen, and when it changes.
//!
//! Tries what a driver's numbers promise, once; a call that it does not know is not made again.
//! Invariant: what was changed on the device is put back on drop.

use super::FramebufferError;
use super::ioctl::{FB_ACTIVATE_VBL, FBIOPAN_DISPLAY, FbVarScreeninfo};
use super::last_resort::{Argument, Place, PutBack};
use super::surface::{Scheme, Surface};
use super::video_mode::Moded;
use std::io;
use std::path::{Path, PathBuf};

/// A driver and the way frames are shown by it.
pub(super) struct Display {
    // Dropped first: it needs the driver open.
    _promise: Option<PutBack>,
    driver: Moded,
    path: PathBuf,
    /// The screen as it was found, to be put back.
    found: FbVarScreeninfo,
    scheme: Scheme,
    frames: u32,
    vsync: bool,
    /// Whether the driver has answered to waiting.
    waited: bool,
    /// Whether the screen was put back for somebody else.
    left: bool,
}

impl Display {
    /// Takes the screen over by the scheme that `surface` promises, or a simpler one where the
    /// driver lacks the calls. With two frames the second is the one shown first. Without `vsync`
    /// the vertical blank is not waited for.
    pub(super) fn start(
        driver: Moded,
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

    /// Whether the vertical blank is waited for, in words.
    pub(super) fn vsync(&self) -> &'static str {
        match (self.vsync, self.waited) {
            (true, true) => "vsync",
            (true, false) => "vsync if the driver can",
            (false, _) => "no vsync",
        }
    }

    /// Waits until the visible frame may be written to, where that is the only one there is.
    pub(super) fn before_write(&mut self) -> Result<(), FramebufferError> {
        if self.scheme == Scheme::Single {
            self.wait_for_vsync()
        } else {
            Ok(())
        }
    }

    /// Shows a finished frame, and returns when the one shown before may be written to.
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
                self.pan(frame)
                    .map_err(|source| self.ioctl("FBIOPAN_DISPLAY", source))?;
                // Most drivers move the screen at the blank: until then the old frame is visible.
                self.wait_for_vsync()
            }
            Scheme::Single => Ok(()),
        }
    }

    /// Puts the screen back as it was found, until [`Display::come_back`].
    pub(super) fn leave(&mut self) {
        if !self.left {
            self.left = true;
            self.restore();
        }
    }

    /// Takes the screen over again after [`Display::leave`]; whether it had been left.
    pub(super) fn come_back(&mut self) -> Result<bool, FramebufferError> {
        if !self.left {
            return Ok(false);
        }
        if self.scheme == Scheme::Ps3fb {
            self.driver
                .ps3fb_on()
                .map_err(|source| self.ioctl("PS3FB_IOCTL_ON", source))?;
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
        // From here on drop switches it off.
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
            // No blank within the driver's patience, or a signal: the frame is shown all the same.
            Err(source) if matches!(source.raw_os_error(), Some(libc::ETIMEDOUT | libc::EINTR)) => {
            }
            waited => self.vsync = self.optional("FBIO_WAITFORVSYNC", waited)?.is_some(),
        }
        self.waited = true;
        Ok(())
    }

    /// `None` where the driver does not know the request.
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
        FramebufferError::Ioctl {
            path: self.path.clone(),
            request,
            source,
        }
    }

    fn restore(&mut self) {
        // There is nobody to tell, and closing the device undoes the rest.
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
