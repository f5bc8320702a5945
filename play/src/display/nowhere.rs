//! No display: frames are traced and measured.

use std::io;

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry, Memory};
use image::RgbImage;

use super::{Display, DisplayEvent};
use crate::overlay::Overlay;

/// A display that nobody sees.
pub struct Nowhere(Geometry);

impl Nowhere {
    /// Of this size.
    #[must_use]
    pub fn new(size: Geometry) -> Self {
        Self(size)
    }
}

impl Display for Nowhere {
    fn area(&self) -> Geometry {
        self.0
    }

    fn scales(&self) -> bool {
        false
    }

    fn framebuffer(&mut self, size: Geometry) -> Result<Box<dyn Framebuffer>, FramebufferError> {
        Ok(Box::new(Memory::new(size)?))
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
