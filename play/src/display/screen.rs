//! The console's framebuffer: the SPUs write to it as they do for `cellray fb`, and the overlay is
//! drawn over each frame before it is shown.
//!
//! Known weaknesses: there is no screenshot, because the picture is in the driver's memory. If the
//! driver has a single page, which is always visible, text may flicker while a frame is traced.

use std::io;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use cellray::framebuffer::{self, Framebuffer, FramebufferError, Geometry};
use image::RgbImage;

use super::text::Printed;
use super::{Display, DisplayError, DisplayEvent};
use crate::overlay::Overlay;
use crate::print_line;

/// A framebuffer device, or a file instead of one.
pub struct Screen {
    /// `None` after it was handed out.
    framebuffer: Option<Box<dyn Framebuffer>>,
    area: Geometry,
    overlay: Arc<Mutex<Overlay>>,
}

impl Screen {
    /// Opens the device or file at `path`. A file needs a size.
    ///
    /// # Errors
    /// The framebuffer can't be opened.
    pub fn open(path: &Path, size: Option<Geometry>) -> Result<Self, DisplayError> {
        let framebuffer = framebuffer::open(path, size)?;
        print_line(framebuffer.describe());
        Ok(Self {
            area: framebuffer.geometry(),
            framebuffer: Some(framebuffer),
            overlay: Arc::default(),
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
        let inner = self
            .framebuffer
            .take()
            .ok_or_else(|| FramebufferError::BadSize(scenes::ViewError::Size(size.to_string())))?;
        Ok(Box::new(Printed::new(inner, Arc::clone(&self.overlay))))
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

    fn print(&mut self, overlay: &Overlay) {
        let mut printed = self.overlay.lock().unwrap_or_else(PoisonError::into_inner);
        printed.clone_from(overlay);
    }
}
