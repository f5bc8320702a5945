//! Single rays of a picture's camera, also between the pixels' centres.

use glam::DVec3;
use nff::{Camera, Scene};

use super::Options;
use super::path::Path;
use super::stage::Stage;
use crate::Error;

/// A scene and its camera, to be asked what single primary rays see.
pub struct Probe<'a> {
    stage: Stage<'a>,
    camera: Camera,
}

impl<'a> Probe<'a> {
    /// The rays of a picture of this size; of the options, `corners` plays no part.
    ///
    /// # Errors
    /// As [`super::trace`].
    pub fn new(
        scene: &'a Scene,
        width: u32,
        height: u32,
        options: &Options,
    ) -> Result<Self, Error> {
        let camera = scene
            .view
            .camera(width, height)
            .map_err(|source| Error::View {
                scene: scene.name.clone(),
                source,
            })?;
        Ok(Self {
            stage: Stage::new(scene, options)?,
            camera,
        })
    }

    /// The colour that the ray through a place sees, each channel 0 to 1; the centre of the top
    /// left pixel is (0, 0).
    #[must_use]
    pub fn colour(&self, x: f64, y: f64) -> DVec3 {
        let direction = self.camera.corner + x * self.camera.right + y * self.camera.down;
        let colour = self
            .stage
            .eye(self.camera.eye, direction, &mut Path::default());
        colour.clamp(DVec3::ZERO, DVec3::ONE)
    }
}
