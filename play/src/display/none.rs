//! No display: frames are only traced and measured.

use std::io;

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry, Memory};
use image::RgbImage;

use super::{Display, DisplayEvent};
use crate::overlay::Overlay;

/// A display that shows nothing.
pub struct NoDisplay(Geometry);

impl NoDisplay {
    #[must_use]
    pub fn new(size: Geometry) -> Self {
        Self(size)
    }
}

impl Display for NoDisplay {
    fn area(&self) -> Geometry {
        self.0
    }

    fn scales(&self) -> bool {
        false
    }

    fn measure_in(&mut self, _size: Geometry) {}

    fn framebuffer(&mut self, size: Geometry) -> Result<Box<dyn Framebuffer>, FramebufferError> {
        Ok(Box::new(Memory::new(size)?))
    }

    fn poll(&mut self, _display_events: &mut Vec<DisplayEvent>) -> io::Result<()> {
        Ok(())
    }

    fn draws(&self) -> bool {
        false
    }

    fn show(&mut self, _picture: &RgbImage, _overlay: &Overlay) -> io::Result<()> {
        Ok(())
    }
}
