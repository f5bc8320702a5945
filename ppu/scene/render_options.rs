//! How a scene is made to look, which no file says.

/// How a scene is made to look.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Model {
    /// Whitted's if the scene has lights, else depth shading.
    #[default]
    Scene,
    /// The paper's: spheres that fade to black with their distance.
    Depth,
    /// Whitted's: lights, shadows, mirrors, glass, all shapes.
    Whitted,
}

/// A model and its settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RenderOptions {
    /// Which.
    pub model: Model,
    /// Whitted's model: most rays in a chain, the eye's counted, from 1 to 16.
    pub ray_depth: u32,
    /// Whitted's model: whether what lets light through reflects by Schlick's approximation.
    pub fresnel: bool,
    /// Whitted's model: whether rays are sent as the Standard Procedural Databases count them,
    /// those that add nothing to the picture too: by every surface that mirrors or lets light
    /// through a reflected ray, whatever its share is, and by every surface that is lit, whatever
    /// it makes of that, a shadow ray for each light in front of it. What leaves out rays of no or
    /// little weight hangs on this.
    pub spd_rays: bool,
    /// Whitted's model: whether objects throw shadows.
    pub shadows: bool,
    /// Whether rays go through the corners of the pixels of a picture that is one smaller each
    /// way.
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
            corners: false,
        }
    }
}

impl RenderOptions {
    /// Whether a scene with so many lights is traced by Whitted's model.
    pub(crate) fn is_whitted(self, lights: usize) -> bool {
        match self.model {
            Model::Scene => lights > 0,
            Model::Depth => false,
            Model::Whitted => true,
        }
    }
}
