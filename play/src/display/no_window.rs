//! In the place of a window on a console, and in programs that are built without the feature
//! `window`.

use std::convert::Infallible;
use std::io;

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry};
use image::RgbImage;

use super::{Display, DisplayError, DisplayEvent};
use crate::overlay::Overlay;

/// A window. This build has no windows, so there is no value of this type.
#[derive(Debug)]
pub struct Window(Infallible);

impl Window {
    /// Whether there is a display server.
    #[must_use]
    pub fn is_possible() -> bool {
        false
    }

    /// Fails with the reason.
    pub fn open(_title: &str, _size: Geometry) -> Result<Self, DisplayError> {
        let built = match cfg!(target_arch = "powerpc64") {
            true => "for the console, which has none",
            false => "without the feature `window`",
        };
        let why = format!("this program is built {built}: take --display terminal or --display fb");
        Err(DisplayError::None { kind: "window", why })
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
