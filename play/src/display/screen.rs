//! The console's framebuffer: the SPUs write to it as they do for `cellray fb`.
//!
//! Known weakness: nothing is drawn over the picture and no picture is taken of it, as it is the
//! driver's.

use std::io;
use std::path::Path;

use cellray::framebuffer::{self, Framebuffer, FramebufferError, Geometry};
use image::RgbImage;

use super::{Display, DisplayError, DisplayEvent};
use crate::overlay::Overlay;
use crate::talk::say;

/// A framebuffer device, or a file in the place of one.
pub struct Screen {
    /// Until it is handed out.
    framebuffer: Option<Box<dyn Framebuffer>>,
    area: Geometry,
}

impl Screen {
    /// Opens it; a file needs a size.
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

    fn framebuffer(&mut self, size: Geometry) -> Result<Box<dyn Framebuffer>, FramebufferError> {
        self.framebuffer
            .take()
            .ok_or_else(|| FramebufferError::BadSize(nff::ViewError::Size(size.to_string())))
    }

    fn poll(&mut self, _happenings: &mut Vec<DisplayEvent>) -> io::Result<()> {
        Ok(())
    }

    fn draws(&self) -> bool {
        false
    }

    fn show(&mut self, _picture: &RgbImage, _overlay: Option<&Overlay>) -> io::Result<()> {
        Ok(())
    }
}
