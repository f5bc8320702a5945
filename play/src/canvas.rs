//! The picture between the SPUs and a display that shows it otherwise than they write it.
//!
//! Invariant: a [`Picture`] is always a whole frame: the SPUs write to memory of their own, from which it is
//! copied when a frame is done.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry, Memory, Target};
use image::{Rgb, RgbImage};

/// The last whole frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Red, green and blue, from the top left.
    pub pixels: Vec<[u8; 3]>,
}

impl Picture {
    /// A pixel; it has to be in the picture.
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> [u8; 3] {
        self.pixels[y as usize * self.width as usize + x as usize]
    }

    /// The same as an image.
    #[must_use]
    pub fn to_image(&self) -> RgbImage {
        RgbImage::from_fn(self.width, self.height, |x, y| Rgb(self.at(x, y)))
    }
}

/// Where a display finds the picture.
#[derive(Clone, Default)]
pub struct Shown(Arc<Mutex<Picture>>);

impl Shown {
    /// The picture; nobody else has it until this is dropped.
    pub fn picture(&self) -> MutexGuard<'_, Picture> {
        // A picture half copied is still one of the right size.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A framebuffer whose frames become the picture.
    pub fn canvas(&self, geometry: Geometry) -> Result<Canvas, FramebufferError> {
        Ok(Canvas {
            memory: Memory::new(geometry)?,
            shown: self.clone(),
        })
    }
}

/// A framebuffer whose frames become a [`Picture`].
pub struct Canvas {
    memory: Memory,
    shown: Shown,
}

impl Framebuffer for Canvas {
    fn geometry(&self) -> Geometry {
        self.memory.geometry()
    }

    fn target(&mut self) -> Target {
        self.memory.target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        let Geometry { width, height } = self.memory.geometry();
        let mut picture = self.shown.picture();
        (picture.width, picture.height) = (width, height);
        picture.pixels.clear();
        picture.pixels.extend(self.memory.pixels());
        Ok(())
    }

    fn keeps_contents(&self) -> bool {
        self.memory.keeps_contents()
    }

    fn describe(&self) -> String {
        format!("picture of {}", self.geometry())
    }
}
