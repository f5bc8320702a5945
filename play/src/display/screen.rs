//! The console's framebuffer: the SPUs write to it as they do for `cellray fb`.
//!
//! Known weakness: there is no overlay and no screenshot, because the picture is in the driver's
//! memory.

use std::io;
use std::path::Path;

use cellray::framebuffer::{self, Framebuffer, FramebufferError, Geometry};
use image::RgbImage;

use super::{Display, DisplayError, DisplayEvent};
use crate::overlay::Overlay;
use crate::talk::say;

/// A framebuffer device, or a file instead of one.
pub struct Screen {
    /// `None` after it was handed out.
    framebuffer: Option<Box<dyn Framebuffer>>,
    area: Geometry,
}

impl Screen {
    /// Opens the device or file at `path`. A file needs a size.
    ///
    /// # Errors
    /// The framebuffer can't be opened.
    pub fn open(path: &Path, size: Option<Geometry>) -> Result<Self, DisplayError> {
        let framebuffer = framebuffer::open(path, size)?;
        say(framebuffer.describe());
        Ok(Self {
            area: framebuffer.geometry(),
            framebuffer: Some(framebuffer),
        })
    }
}

impl Display for Screen {
    fn area(&self) -> Geometry {
        self.area
    }

    fn scales(&self) -> bool {
        false
    }

    fn measure_in(&mut self, _size: Geometry) {}

    fn framebuffer(&mut self, size: Geometry) -> Result<Box<dyn Framebuffer>, FramebufferError> {
        self.framebuffer
            .take()
            .ok_or_else(|| FramebufferError::BadSize(nff::ViewError::Size(size.to_string())))
    }

    fn poll(&mut self, _display_events: &mut Vec<DisplayEvent>) -> io::Result<()> {
        Ok(())
    }

    fn draws(&self) -> bool {
        false
    }

    fn show(&mut self, _picture: &RgbImage, _overlay: Option<&Overlay>) -> io::Result<()> {
        Ok(())
    }
}
