//! Traces single primary rays, at the pixels' centres or between them.

use glam::DVec3;
use scenes::{Camera, Scene};

use super::path::Path;
use super::stage::Stage;
use super::{Options, Rounding};
use crate::Error;

/// A scene and its camera, to trace single primary rays.
pub struct Probe<'a> {
    stage: Stage<'a>,
    camera: Camera,
}

impl<'a> Probe<'a> {
    /// A probe with the camera of a picture of this size. Of the options of pixels, only the
    /// meaning of the scene's colours is used.
    ///
    /// # Errors
    /// As for [`super::trace`].
    pub fn new(
        scene: &'a Scene,
        width: u32,
        height: u32,
        options: &Options,
    ) -> Result<Self, Error> {
        let camera = crate::camera(scene, width, height)?;
        Ok(Self { stage: Stage::new(scene, &camera, options)?, camera })
    }

    /// Changes what happens to the numbers of the rays' records.
    pub fn set_rounding(&mut self, rounding: Rounding) {
        self.stage.set_rounding(rounding);
    }

    /// The colour that the ray through a point of the picture sees, each channel 0 to 1. The
    /// centre of the top left pixel is (0, 0).
    #[must_use]
    pub fn colour(&self, x: f64, y: f64) -> DVec3 {
        self.light(x, y).clamp(DVec3::ZERO, DVec3::ONE)
    }

    /// The light that the ray through a point of the picture sees; of [`Self::colour`], this is
    /// what may be brighter than white.
    #[must_use]
    pub fn light(&self, x: f64, y: f64) -> DVec3 {
        self.along(self.direction(x, y))
    }

    /// The direction of the ray through a point of the picture.
    pub(crate) fn direction(&self, x: f64, y: f64) -> DVec3 {
        self.camera.corner + x * self.camera.right + y * self.camera.down
    }

    /// The light that the eye sees in a direction.
    pub(crate) fn along(&self, direction: DVec3) -> DVec3 {
        self.stage.eye(self.camera.eye, direction, &mut Path::default())
    }
}
