//! A map of the pixels that a frame kept of the one before, and of why it traced the others.

use std::sync::{Arc, Mutex, PoisonError};

use cellray_inspector::PixelMap;
use image::RgbImage;
use protocol::layout::{TILE_HEIGHT, TILE_WIDTH};

use crate::engine::TracedUnits;
use crate::framebuffer::{Framebuffer, FramebufferError, Geometry, Memory, Target};
use crate::statistics::Causes;

/// Why pixels were traced; the first is that they were not.
const KINDS: [&str; 5] = [
    "kept",
    "traced: the framebuffer's contents were not known",
    "traced: the camera, a light or an option has changed",
    "traced: no record of what the tile's rays had crossed",
    "traced: a ray had crossed a changed object's place",
];
const UNKNOWN: u8 = 1;
const VIEW: u8 = 2;
const UNRECORDED: u8 = 3;
const REACHED: u8 = 4;

/// Which of the picture's pixels the last frame has written.
pub type Written = Arc<Mutex<Vec<bool>>>;

/// A framebuffer in memory with the pixels that its last frame has written.
pub struct Watched {
    memory: Memory,
    written: Written,
}

impl Watched {
    pub fn new(geometry: Geometry, written: Written) -> Result<Self, FramebufferError> {
        Ok(Self { memory: Memory::new(geometry)?, written })
    }
}

impl Framebuffer for Watched {
    fn geometry(&self) -> Geometry {
        self.memory.geometry()
    }

    fn target(&mut self) -> Target {
        self.memory.target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        let written = self.memory.take_written();
        *self.written.lock().unwrap_or_else(PoisonError::into_inner) = written;
        Ok(())
    }

    fn keeps_contents(&self) -> bool {
        true
    }

    fn picture(&self) -> Option<RgbImage> {
        self.memory.picture()
    }

    fn describe(&self) -> String {
        self.memory.describe()
    }
}

/// The map of a frame that has written these pixels.
pub fn map(
    geometry: Geometry,
    written: &Written,
    traced: &TracedUnits,
    causes: Causes,
) -> PixelMap {
    // Only a tile with a record can be reached, except with depth shading, which needs none.
    let reason = match causes {
        Causes { unknown: 1.., .. } => UNKNOWN,
        Causes { view: 1.., .. } => VIEW,
        Causes { unrecorded: 1.., .. } => UNRECORDED,
        _ => REACHED,
    };
    let across = geometry.width.div_ceil(TILE_WIDTH);
    let mut reasons = vec![reason; (across * geometry.height.div_ceil(TILE_HEIGHT)) as usize];
    for tile in traced.units.iter().flatten().filter(|tile| tile.had_paths) {
        reasons[tile.number as usize] = REACHED;
    }
    let written = written.lock().unwrap_or_else(PoisonError::into_inner);
    let value = |(pixel, is_written): (u32, &bool)| {
        let (x, y) = (pixel % geometry.width, pixel / geometry.width);
        let tile = y / TILE_HEIGHT * across + x / TILE_WIDTH;
        u8::from(*is_written) * reasons[tile as usize]
    };
    PixelMap {
        id: "kept",
        name: "kept",
        remark: "Which pixels were traced, and why. The others are those of the frame before."
            .into(),
        values: (0..).zip(written.iter()).map(value).collect(),
        kinds: &KINDS,
    }
}
