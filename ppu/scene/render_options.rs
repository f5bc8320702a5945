//! Render options: settings of a picture that scene files don't have.

/// The model that a scene is rendered with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Model {
    /// Whitted's model if the scene has lights, otherwise depth shading.
    #[default]
    Scene,
    /// Depth shading, the paper's model: spheres that fade to black with their distance.
    Depth,
    /// Whitted's model: lights, shadows, mirrors, glass, and all shapes.
    Whitted,
}

/// What a pixel's channels say about its light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Colour {
    /// They are proportional to it.
    #[default]
    Linear,
    /// They have sRGB's values, which displays and viewers of pictures expect.
    Srgb,
}

/// How many samples, evenly spread, an antialiased pixel is the mean of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Samples {
    /// Its centre alone: no antialiasing.
    #[default]
    One = 1,
    /// Four.
    Four = 4,
    /// Sixteen.
    Sixteen = 16,
}

/// The default of [`RenderOptions::contrast`].
pub const CONTRAST: u8 = 48;

/// A model and its settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RenderOptions {
    /// The model.
    pub model: Model,
    /// Whitted's model: the longest chain of rays, including the primary ray, from 1 to 16.
    pub ray_depth: u32,
    /// Whitted's model: whether transparent surfaces reflect by Schlick's approximation.
    pub fresnel: bool,
    /// Whitted's model: whether to trace all rays that the Standard Procedural Databases count, even
    /// those that add nothing to the picture. Then every surface that reflects or lets light through
    /// sends a reflected ray, whatever its share. Every lit surface sends a shadow ray to each light
    /// in front of it, whether or not it uses the light. No ray is left out for its small weight.
    pub spd_rays: bool,
    /// Whitted's model: whether objects cast shadows.
    pub shadows: bool,
    /// The samples of a pixel that is antialiased.
    pub samples: Samples,
    /// A pixel is antialiased if a channel differs by at least this, in 1/255, from a neighbour in
    /// its tile; 0: every pixel is.
    pub contrast: u8,
    /// What a pixel's channels say about its light.
    pub colour: Colour,
    /// Whether light that is nearly white or brighter is limited to less than white without a
    /// step, instead of all becoming white.
    pub roll_off: bool,
    /// Whether rays go through the corners of the pixels instead of their centres. The picture of
    /// corners is one pixel wider and higher than the picture that is made of it.
    pub corners: bool,
}

impl Default for RenderOptions {
    fn default() -> Self {
        Self {
            model: Model::Scene,
            ray_depth: 5,
            fresnel: false,
            spd_rays: false,
            shadows: true,
            samples: Samples::One,
            contrast: CONTRAST,
            colour: Colour::Linear,
            roll_off: false,
            corners: false,
        }
    }
}

impl RenderOptions {
    /// Whether a scene with `lights` lights is traced by Whitted's model.
    pub(crate) fn is_whitted(self, lights: usize) -> bool {
        match self.model {
            Model::Scene => lights > 0,
            Model::Depth => false,
            Model::Whitted => true,
        }
    }
}
