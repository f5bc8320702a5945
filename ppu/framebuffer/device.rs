//! The kernel's framebuffer device, /dev/fb0.
//!
//! Frames are made in the device's memory if SPUs can and should write to it. Otherwise they are
//! made in private memory, and copied as whole lines. While another terminal is on the screen,
//! frames wait. Invariant: the order of dropping is display, memory, console, so that the console
//! redraws its text after the screen has been restored.

use super::buffer::FrameBuffer;
use super::console::Console;
use super::display::Display;
use super::driver::{Driver, KernelDriver, Mapping};
use super::forward;
use super::interrupted;
use super::ioctl::FbVarScreeninfo;
use super::surface::{Scheme, Surface, driver_name};
use super::video_mode::VideoModeGuard;
use super::{Framebuffer, FramebufferError, Geometry, Options, Target};
use std::io;
use std::path::{Path, PathBuf};
use std::ptr::NonNull;
use std::sync::atomic::{Ordering, fence};

/// Where a device's frames are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// In the device's memory, so that this program copies nothing.
    Direct,
    /// In private memory, and copied to the device when complete. This works with every driver.
    Shadow,
}

/// A framebuffer device and the virtual terminal that it shows.
pub struct Device {
    path: PathBuf,
    surface: Surface,
    display: Display,
    map: Mapping,
    /// The private memory for frames, with [`Mode::Shadow`].
    shadow: Option<FrameBuffer>,
    /// The number of the frame that the next picture is written to.
    next: u32,
    /// Whether other programs have drawn on the frames since one was shown.
    lost: bool,
    console: io::Result<Console>,
}

/// A driver that has responded. So far only its video mode may have been changed.
struct Found {
    driver: VideoModeGuard,
    var: FbVarScreeninfo,
    surface: Surface,
    map: Mapping,
}

impl Found {
    fn summary(mut self, path: &Path) -> String {
        let surface = &self.surface;
        let frames = match surface.frames(surface.scheme()) {
            1 => "1 frame".to_owned(),
            frames => format!("{frames} frames"),
        };
        let mode = match self.driver.ps3fb_getmode() {
            Ok(mode) => format!(", video mode {mode}"),
            Err(_) => String::new(),
        };
        format!(
            "{}, driver {}, {}, stride {} bytes, memory for {frames}{mode}",
            path.display(),
            surface.driver,
            surface.geometry,
            surface.line_length,
        )
    }
}

impl Device {
    /// Opens the device at `path`, and takes over the screen and its console.
    ///
    /// # Errors
    /// The device can't be opened, its driver's replies are not supported, or the options don't
    /// suit it.
    pub fn open(path: &Path, options: Options) -> Result<Device, FramebufferError> {
        let driver = KernelDriver::open(path)
            .map_err(|source| FramebufferError::io("open", path, source))?;
        // Done before the video mode is changed, so that an unexpected signal restores it too.
        interrupted::watch()
            .map_err(|source| FramebufferError::io("catch signals for", path, source))?;
        let found = Device::look(Box::new(driver), path, options)?;
        Device::start(found, path, options, Console::enter())
    }

    /// A line of text about the device at `path`, which is not changed.
    ///
    /// # Errors
    /// The device can't be opened, or its driver's replies are not supported.
    pub fn inspect(path: &Path) -> Result<String, FramebufferError> {
        let driver = KernelDriver::open(path)
            .map_err(|source| FramebufferError::io("open", path, source))?;
        Device::look(Box::new(driver), path, Options::default()).map(|found| found.summary(path))
    }

    fn look(
        driver: Box<dyn Driver>,
        path: &Path,
        options: Options,
    ) -> Result<Found, FramebufferError> {
        let refused = |request| {
            move |source| FramebufferError::Ioctl { path: path.to_owned(), request, source }
        };
        let mut driver = VideoModeGuard::keep(driver);
        let ask = |driver: &mut VideoModeGuard| {
            let var = driver.var_screeninfo().map_err(refused("FBIOGET_VSCREENINFO"))?;
            let fix = driver.fix_screeninfo().map_err(refused("FBIOGET_FSCREENINFO"))?;
            Ok((var, fix))
        };
        let (mut var, mut fix) = ask(&mut driver)?;
        if let Some(raster) = options.raster {
            driver.set(raster, &driver_name(&fix.id), path)?;
            (var, fix) = ask(&mut driver)?;
        }
        let surface = Surface::new(path, &var, &fix)?;
        match options.size {
            Some(requested) if requested != surface.geometry => {
                return Err(FramebufferError::SizeMismatch {
                    path: path.to_owned(),
                    requested,
                    actual: surface.geometry,
                });
            }
            _ => {}
        }
        let map = driver.map(&fix).map_err(|source| FramebufferError::io("map", path, source))?;
        Ok(Found { driver, var, surface, map })
    }

    fn start(
        found: Found,
        path: &Path,
        options: Options,
        console: io::Result<Console>,
    ) -> Result<Device, FramebufferError> {
        let Found { driver, var, mut surface, map } = found;
        if !options.two_frames {
            surface.use_one_frame();
        }
        let promised = surface.scheme();
        for frame in 0..surface.frames(promised) {
            // The second frame is shown before anything was written to it.
            blacken(&map, &surface, promised, frame);
        }
        let display = Display::start(driver, path, var, &surface, options.vsync)?;
        let scheme = display.scheme();
        let obstacle = (0..display.frames()).find_map(|frame| {
            let offset = surface.frame_offset(scheme, frame);
            surface.direct_obstacle(address(&map, offset) as usize, offset)
        });
        let shadow = match (options.mode, obstacle) {
            (Some(Mode::Direct), Some(why)) => {
                return Err(FramebufferError::NoDirect {
                    path: path.to_owned(),
                    driver: surface.driver.clone(),
                    why,
                });
            }
            (Some(Mode::Direct), None) => None,
            // Only memory that ps3fb shows on request is known to be main memory that isn't
            // visible.
            (None, None) if scheme == Scheme::Ps3fb => None,
            _ => Some(FrameBuffer::new(surface.geometry)?),
        };
        Ok(Device {
            path: path.to_owned(),
            surface,
            display,
            map,
            shadow,
            next: 0,
            lost: false,
            console,
        })
    }

    /// Where frames are made.
    pub fn mode(&self) -> Mode {
        if self.shadow.is_some() { Mode::Shadow } else { Mode::Direct }
    }

    /// Releases the screen if another terminal requests it, and waits until it is returned.
    /// Returns whether this program has the screen; `false` if it is asked to end meanwhile.
    fn hold_screen(&mut self) -> Result<bool, FramebufferError> {
        let Ok(console) = &mut self.console else {
            return Ok(true);
        };
        if let Some(asked) = console.request() {
            self.display.leave();
            console.leave(asked);
        }
        if !console.come_back() {
            return Ok(false);
        }
        self.lost = self.display.come_back()?;
        Ok(true)
    }

    fn next_offset(&self) -> u64 {
        self.surface.frame_offset(self.display.scheme(), self.next)
    }
}

/// The address of a byte, `offset` bytes into the device's memory.
fn address(map: &Mapping, offset: u64) -> *mut u8 {
    // Every offset comes from a surface, which keeps it below a 32-bit length.
    map.base().wrapping_add(offset as usize)
}

fn blacken(map: &Mapping, surface: &Surface, scheme: Scheme, frame: u32) {
    let mut line = address(map, surface.frame_offset(scheme, frame));
    for _ in 0..surface.geometry.height {
        // SAFETY: a surface's frames have all their shown pixels within the mapping.
        unsafe { forward::clear(line, surface.geometry.shown_row_bytes()) };
        line = line.wrapping_add(surface.line_length as usize);
    }
}

impl Framebuffer for Device {
    fn geometry(&self) -> Geometry {
        self.surface.geometry
    }

    fn target(&mut self) -> Target {
        // Copying to the device converts nothing, so the shadow has the device's pixel format.
        let format = self.surface.format;
        if let Some(shadow) = &mut self.shadow {
            return shadow.target(format);
        }
        let base = address(&self.map, self.next_offset());
        Target {
            base: NonNull::new(base).expect("a mapping is never at address zero"),
            bytes: self.surface.line_length as usize * self.surface.geometry.height as usize,
            stride: self.surface.line_length,
            geometry: self.surface.geometry,
            format,
        }
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        // A frame in memory that others have drawn on is lost too.
        if !self.hold_screen()? || (self.lost && self.shadow.is_none()) {
            return Ok(());
        }
        self.display.before_write()?;
        if let Some(shadow) = &self.shadow {
            let mut line = address(&self.map, self.next_offset());
            for row in shadow.rows() {
                // SAFETY: a surface's frames have all their shown pixels within the mapping, which
                // is no part of the shadow.
                unsafe { forward::copy(row, line) };
                line = line.wrapping_add(self.surface.line_length as usize);
            }
        }
        // The kernel's copy must not begin before this program's stores are visible.
        fence(Ordering::SeqCst);
        self.display.show(self.next)?;
        self.next = (self.next + 1) % self.display.frames();
        Ok(())
    }

    /// Private memory keeps its contents. The device's memory keeps them as long as no other
    /// terminal is on the screen.
    fn keeps_contents(&self) -> bool {
        let undisturbed = || self.console.as_ref().is_ok_and(Console::has_the_screen);
        self.shadow.is_some() || (!self.lost && undisturbed())
    }

    fn describe(&self) -> String {
        let frames = match self.display.frames() {
            1 => "1 frame".to_owned(),
            frames => format!("{frames} frames"),
        };
        let made = match self.mode() {
            Mode::Direct => "made in its memory",
            Mode::Shadow => "made in private memory and copied",
        };
        let vsync = self.display.vsync();
        let console = match &self.console {
            Ok(console) => format!("console {console} in graphics mode"),
            Err(error) => format!("console left in text mode: {error}"),
        };
        format!(
            "{}, driver {}, {}, stride {} bytes, {frames} {made}, {vsync}, {console}",
            self.path.display(),
            self.surface.driver,
            self.surface.geometry,
            self.surface.line_length,
        )
    }
}

#[cfg(test)]
mod tests;
