//! The scene in the form that is traced: all of it for Whitted's model, only its spheres for depth
//! shading.
//!
//! Invariant: every number that depth shading uses is in the domain that the kernels state.

pub(crate) mod block;
mod colour;
pub(crate) mod eye_side;
pub(crate) mod height;
pub mod mesh;
#[cfg(test)]
pub(crate) mod random;
mod render_options;
pub(crate) mod single;
pub mod texture;

use glam::DVec3;
use scenes::depth::{self, DepthShading, NotDrawn};
use scenes::{Fog, Sky};

use self::block::ShaderEntries;
pub use self::block::{BlockError, MaterialTable, MeshPlace, SceneBlock};
pub use self::colour::Colour;
pub use self::mesh::{MeshBlocks, MeshError, MeshStatistics, NumberWidth};
pub use self::render_options::{
    BuildBy, CONTRAST, Look, Model, NodeVolumes, RefitBy, RenderOptions, Samples,
};
use self::single::{LARGEST, SMALLEST};
pub use self::texture::Textures;
use crate::spe::Program;
use protocol::formulation::{Formulations, SphereFormulation};
use protocol::layout::MAX_SPHERES;

/// Why a scene can't be drawn.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// Depth shading: the local store is too small for the scene's spheres.
    #[error(
        "{file}: {count} spheres do not fit: the maximum is {MAX_SPHERES}; leave out \
         {} of them", count - MAX_SPHERES as usize
    )]
    TooManySpheres {
        /// Name of the scene's file.
        file: String,
        /// Number of spheres in the scene.
        count: usize,
    },
    /// Whitted's model can't trace it.
    #[error(transparent)]
    Block(#[from] BlockError),
    /// The SPU program has no code for meshes in main memory.
    #[error(
        "{file}: {objects} triangles, spheres and cones do not fit the local store, and the SPU \
         program can't stream them from main memory"
    )]
    NoStreaming {
        /// Name of the scene's file.
        file: String,
        /// The triangles, spheres and cones that would have to be streamed.
        objects: usize,
    },
    /// The SPU program has no code for textures.
    #[error("{file}: the mesh has textures, and the SPU program can't look them up")]
    NoTextures {
        /// Name of the scene's file.
        file: String,
    },
    /// The SPU program has no code for colours of vertices.
    #[error(
        "{file}: the mesh has colours at its vertices, and the SPU program can't interpolate them"
    )]
    NoColours {
        /// Name of the scene's file.
        file: String,
    },
    /// The SPU program has no code for height fields.
    #[error("{file}: the scene has a height field, and the SPU program can't trace it")]
    NoHeights {
        /// Name of the scene's file.
        file: String,
    },
    /// A number is outside of the range in which the SPU's single format can hold its square.
    #[error("{file}: {what} {value} is out of range: its magnitude must be at most 2^62{also}")]
    OutOfRange {
        /// Name of the scene's file.
        file: String,
        /// Name of the number.
        what: String,
        /// Its value.
        value: f64,
        /// A further bound, as a part of the message.
        also: &'static str,
    },
    /// The camera can't be made for this size.
    #[error("{file}: {source}")]
    View {
        /// Name of the scene's file.
        file: String,
        /// The reason.
        source: scenes::ViewError,
    },
}

/// A sphere of depth shading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Centre, in the scene's coordinates.
    pub centre: DVec3,
    /// Radius, above 0.
    pub radius: f64,
    /// The light that it sends at its brightest: red, green and blue, each 0 to 1.
    pub colour: DVec3,
}

/// A scene in the form that an [`Engine`](crate::Engine) traces.
#[derive(Clone, Debug)]
pub struct Scene {
    file: String,
    view: scenes::View,
    background: DVec3,
    sky: Option<Sky>,
    fog: Option<Fog>,
    spheres: Vec<Sphere>,
    depth: DepthShading,
    not_drawn: Vec<NotDrawn>,
    render_options: RenderOptions,
    block: Option<SceneBlock>,
}

impl Scene {
    /// A scene with the default [`RenderOptions`] and the built-in SPU program.
    ///
    /// # Errors
    /// As for [`Scene::new`].
    pub fn from_nff(scene: &scenes::Scene) -> Result<Self, SceneError> {
        Self::new(scene, RenderOptions::default(), &Program::tracer())
    }

    /// A scene with these options, for the SPU program that will trace it and that has its
    /// shaders. With depth shading, [`Scene::not_drawn`] lists the parts that are left out.
    ///
    /// # Errors
    /// - The scene doesn't fit the local store, or a number is out of range.
    /// - Whitted's model: see [`BlockError`].
    pub fn new(
        scene: &scenes::Scene,
        render_options: RenderOptions,
        program: &Program,
    ) -> Result<Self, SceneError> {
        if !render_options.is_whitted(scene.lights.len()) {
            return Self::by_depth(scene, render_options);
        }
        let shader = |name: &str| program.shader(name).ok();
        let gathered = mesh::gathered(scene);
        let scene = match Self::whitted(&gathered, render_options, &shader) {
            Err(SceneError::Block(error)) if error.is_out_of_memory() => {
                let all = mesh::gathered_all(scene).ok_or(error)?;
                Self::whitted(&all, render_options, &shader)
            }
            outcome => outcome,
        }?;
        scene.check_streaming(program)?;
        Ok(scene)
    }

    /// Checks that a program can trace the scene's mesh, if it has one in main memory.
    pub(crate) fn check_streaming(&self, program: &Program) -> Result<(), SceneError> {
        match self.block.as_ref().and_then(SceneBlock::mesh) {
            Some(mesh) if program.mesh_code().is_empty() => Err(SceneError::NoStreaming {
                file: self.file.clone(),
                objects: mesh.blocks.statistics().objects(),
            }),
            Some(mesh) if mesh.heights.is_some() && program.height_code().is_empty() => {
                Err(SceneError::NoHeights { file: self.file.clone() })
            }
            Some(mesh) if mesh.textures.is_some() && program.texture_code().is_empty() => {
                Err(SceneError::NoTextures { file: self.file.clone() })
            }
            Some(mesh) if mesh.blocks.is_coloured() && program.colour_code().is_empty() => {
                Err(SceneError::NoColours { file: self.file.clone() })
            }
            _ => Ok(()),
        }
    }

    /// [`Scene::new`] with spare capacity for more objects in Whitted's model, so that the scene
    /// can be changed in place.
    pub(crate) fn with_spare_capacity(
        scene: &scenes::Scene,
        render_options: RenderOptions,
        shaders: &ShaderEntries,
    ) -> Result<Self, SceneError> {
        if !render_options.is_whitted(scene.lights.len()) {
            return Self::by_depth(scene, render_options);
        }
        let block = SceneBlock::with_spare_capacity(scene, render_options, shaders)?;
        Ok(Self::by_whitted(scene, render_options, block))
    }

    fn whitted(
        scene: &scenes::Scene,
        render_options: RenderOptions,
        shader: &dyn Fn(&str) -> Option<u32>,
    ) -> Result<Self, SceneError> {
        let block = SceneBlock::new(scene, render_options, shader)?;
        Ok(Self::by_whitted(scene, render_options, block))
    }

    fn by_whitted(scene: &scenes::Scene, render_options: RenderOptions, block: SceneBlock) -> Self {
        Self {
            file: scene.name.clone(),
            view: scene.view.clone(),
            background: scene.background,
            sky: scene.sky,
            fog: scene.fog,
            spheres: Vec::new(),
            depth: DepthShading { near: 0.0, far: 0.0 },
            not_drawn: Vec::new(),
            render_options,
            block: Some(block),
        }
    }

    fn by_depth(scene: &scenes::Scene, render_options: RenderOptions) -> Result<Self, SceneError> {
        let file = &scene.name;
        let out_of_range = |what: String, value: f64, also: &'static str| SceneError::OutOfRange {
            file: file.clone(),
            what,
            value,
            also,
        };
        let in_range = |what: &dyn Fn() -> String, vector: DVec3| match vector
            .to_array()
            .into_iter()
            .find(|value| !value.is_finite() || value.abs() > LARGEST)
        {
            Some(value) => Err(out_of_range(what(), value, "")),
            None => Ok(()),
        };
        in_range(&|| "view from".into(), scene.view.from)?;

        let count = depth::drawn(scene).count();
        if count > MAX_SPHERES as usize {
            return Err(SceneError::TooManySpheres { file: file.clone(), count });
        }
        let mut spheres = Vec::with_capacity(count);
        for (number, sphere) in depth::drawn(scene).enumerate() {
            in_range(&|| format!("centre of sphere {}", number + 1), sphere.centre)?;
            if !(SMALLEST..=LARGEST).contains(&sphere.radius) {
                let what = format!("radius of sphere {}", number + 1);
                return Err(out_of_range(what, sphere.radius, " and at least 2^-62"));
            }
            let colour = scene.materials[sphere.material as usize].colour;
            let colour = render_options.colour.light(colour);
            spheres.push(Sphere { centre: sphere.centre, radius: sphere.radius, colour });
        }
        Ok(Self {
            file: file.clone(),
            view: scene.view.clone(),
            background: scene.background,
            sky: None,
            fog: None,
            spheres,
            depth: DepthShading::of(scene),
            not_drawn: depth::not_drawn(scene),
            render_options,
            block: None,
        })
    }

    /// The name of the scene or of its file.
    #[must_use]
    pub fn file(&self) -> &str {
        &self.file
    }

    /// The scene's view: the eye, its target, and the angle.
    #[must_use]
    pub fn view(&self) -> &scenes::View {
        &self.view
    }

    /// The camera for a picture of this size in pixels.
    ///
    /// # Errors
    /// The view has no camera for this size.
    pub fn camera(&self, width: u32, height: u32) -> Result<scenes::Camera, SceneError> {
        let corners = self.render_options.corners;
        let one = u32::from(corners);
        let mut camera = self
            .view
            .camera(width.saturating_sub(one), height.saturating_sub(one))
            .map_err(|source| SceneError::View { file: self.file.clone(), source })?;
        if corners {
            camera.corner -= (camera.right + camera.down) / 2.0;
        }
        Ok(camera)
    }

    /// The model and its settings.
    #[must_use]
    pub fn render_options(&self) -> RenderOptions {
        self.render_options
    }

    /// The records of Whitted's model; `None` with depth shading.
    #[must_use]
    pub fn block(&self) -> Option<&SceneBlock> {
        self.block.as_ref()
    }

    /// The one of a program's formulations that intersects the scene's primary rays with spheres.
    #[must_use]
    pub fn sphere_formulation(&self, formulations: &Formulations) -> &'static SphereFormulation {
        match self.block {
            Some(_) => formulations.seen,
            None => formulations.eye,
        }
    }

    /// The background: the colour of rays that hit nothing, or of those to the horizon.
    #[must_use]
    pub fn background(&self) -> DVec3 {
        self.background
    }

    /// The background's gradient, if there is one.
    #[must_use]
    pub fn sky(&self) -> Option<Sky> {
        self.sky
    }

    /// The fog, if there is any.
    pub(crate) fn fog(&self) -> Option<Fog> {
        self.fog
    }

    /// The spheres of depth shading, in the order of the file.
    #[must_use]
    pub fn spheres(&self) -> &[Sphere] {
        &self.spheres
    }

    /// The distances between which depth shading fades.
    #[must_use]
    pub fn depth(&self) -> DepthShading {
        self.depth
    }

    /// Moves the eye. Call [`Scene::write`] afterwards.
    pub fn set_view(&mut self, view: &scenes::View) {
        self.view.clone_from(view);
    }

    /// Writes the records of Whitted's model for the scene's eye. This is the last step of a
    /// change.
    ///
    /// # Errors
    /// The eye is out of range.
    pub fn write(&mut self) -> Result<(), SceneError> {
        match &mut self.block {
            Some(block) => Ok(block.write_for(self.view.from)?),
            None => Ok(()),
        }
    }

    /// Sets the background, its gradient, and the fog.
    pub(crate) fn set_background(
        &mut self,
        colour: DVec3,
        sky: Option<Sky>,
        fog: Option<Fog>,
        shaders: &ShaderEntries,
    ) -> Result<(), SceneError> {
        (self.background, self.sky, self.fog) = (colour, sky, fog);
        match &mut self.block {
            Some(block) => Ok(block.set_background(colour, sky, fog, shaders)?),
            None => Ok(()),
        }
    }

    /// Sets the spheres of depth shading and the distances between which it fades; without those
    /// the spheres' own range. The spheres' numbers must be in range, and the spheres must fit.
    pub(crate) fn set_spheres(
        &mut self,
        spheres: impl Iterator<Item = Sphere>,
        depth: Option<DepthShading>,
    ) {
        self.spheres.clear();
        self.spheres.extend(spheres);
        let spheres = self.spheres.iter();
        let spheres = spheres.map(|sphere| (sphere.centre, sphere.radius));
        let from = self.view.from;
        self.depth = depth.unwrap_or_else(|| DepthShading::around(from, spheres));
    }

    /// The records of Whitted's model. Call [`Scene::write`] after a change.
    pub(crate) fn block_mut(&mut self) -> Option<&mut SceneBlock> {
        self.block.as_mut()
    }

    /// The parts of the file that depth shading leaves out.
    #[must_use]
    pub fn not_drawn(&self) -> &[NotDrawn] {
        &self.not_drawn
    }
}

/// A note about objects of a scene that rays leave so far off that they can't see others, if there
/// are any: their numbers, relative to the eye, are too large for singles beside the others' sizes.
/// Only Whitted's model has such rays.
#[must_use]
pub fn offset_note(scene: &scenes::Scene, render_options: RenderOptions) -> Option<String> {
    let is_whitted = render_options.is_whitted(scene.lights.len());
    is_whitted.then(|| block::offset_note(scene)).flatten()
}
