//! In the place of a window where there is no display server to open one.

use std::convert::Infallible;
use std::io;

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry};
use image::RgbImage;

use super::{Display, DisplayError, DisplayEvent};
use crate::overlay::Overlay;

/// A window; there are none of them here.
#[derive(Debug)]
pub struct Window(Infallible);

impl Window {
    /// Whether there is a display server.
    #[must_use]
    pub fn is_possible() -> bool {
        false
    }

    /// Says that there are none.
    pub fn open(_title: &str, _size: Geometry) -> Result<Self, DisplayError> {
        Err(DisplayError::None {
            kind: "window",
            why: "this program is built for the console, which has none: take the framebuffer or the \
                  terminal"
                .to_owned(),
        })
    }
}

impl Display for Window {
    fn area(&self) -> Geometry {
        match self.0 {}
    }

    fn scales(&self) -> bool {
        match self.0 {}
    }

    fn measure_in(&mut self, _size: Geometry) {
        match self.0 {}
    }

    fn framebuffer(&mut self, _size: Geometry) -> Result<Box<dyn Framebuffer>, FramebufferError> {
        match self.0 {}
    }

    fn poll(&mut self, _display_events: &mut Vec<DisplayEvent>) -> io::Result<()> {
        match self.0 {}
    }

    fn draws(&self) -> bool {
        match self.0 {}
    }

    fn show(&mut self, _picture: &RgbImage, _overlay: &Overlay) -> io::Result<()> {
        match self.0 {}
    }
}
