//! Render options: settings of a picture that scene files don't have.

use protocol::layout::MESH_MAX_SLOTS;

use super::colour::Colour;

/// The model that a scene is rendered with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "choices", derive(clap::ValueEnum))]
pub enum Model {
    /// Whitted's model if the scene has lights, otherwise depth shading.
    #[default]
    Scene,
    /// The paper's model, depth shading: spheres that fade to black with their distance.
    Depth,
    /// Whitted's model: lights, shadows, mirrors, glass, and all shapes.
    Whitted,
}

/// Who refits the blocks of a mesh that has moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RefitBy {
    /// This program.
    Ppu,
    /// The SPUs, before they trace the next frame.
    Spus,
}

/// How the tree of a mesh is made, or that of spheres and cones in main memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BuildBy {
    /// By this program, with the surface area heuristic: rays need the fewest tests.
    PpuSurfaces,
    /// By this program, in the order of codes: the tree that the SPUs make.
    PpuCodes,
    /// By the SPUs, in the order of codes, before they trace the next frame.
    SpuCodes,
}

/// The volumes of the nodes of a scene's trees, in Whitted's model. All give the same picture,
/// except where a ray meets several surfaces at equal distance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NodeVolumes {
    /// For each tree those with which it is expected to be faster, spheres or boxes.
    #[default]
    Best,
    /// Spheres.
    Spheres,
    /// Boxes along the axes, above all shapes except spheres.
    Boxes,
}

/// How many samples, evenly spread, an antialiased pixel is the mean of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "choices", derive(clap::ValueEnum))]
pub enum Samples {
    /// Its centre alone: no antialiasing.
    #[default]
    #[cfg_attr(feature = "choices", value(name = "1"))]
    One = 1,
    /// Four samples.
    #[cfg_attr(feature = "choices", value(name = "4"))]
    Four = 4,
    /// Sixteen samples.
    #[cfg_attr(feature = "choices", value(name = "16"))]
    Sixteen = 16,
}

/// The default of [`RenderOptions::contrast`].
pub const CONTRAST: u8 = 32;

/// The default of [`RenderOptions::refit_pictures`]. `docs/meshes.md` has the measurements.
const REFIT_PICTURES: u32 = 50;

/// A model and its settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RenderOptions {
    /// The model.
    pub model: Model,
    /// Whitted's model: the longest chain of rays, including the primary ray, from 1 to 16.
    pub ray_depth: u32,
    /// Whitted's model: whether transparent surfaces reflect by Schlick's approximation.
    pub fresnel: bool,
    /// Whitted's model: whether to trace all rays that the Standard Procedural Databases count,
    /// even those that add nothing to the picture. Then every surface that reflects or lets light
    /// through sends a reflected ray, whatever its share. Every lit surface sends a shadow ray to
    /// each light in front of it, whether or not it uses the light. No ray is left out for its
    /// small weight.
    pub spd_rays: bool,
    /// Whitted's model: whether objects cast shadows.
    pub shadows: bool,
    /// The samples of a pixel that is antialiased.
    pub samples: Samples,
    /// A pixel is antialiased if a channel differs by at least this, in 1/255, from a neighbour in
    /// its tile; 0: every pixel is.
    pub contrast: u8,
    /// The colour space of the scene's colours and of pixels.
    pub colour: Colour,
    /// Whether light that is nearly white or brighter is limited to less than white without a
    /// step, instead of all becoming white.
    pub roll_off: bool,
    /// Whether rays go through the corners of the pixels instead of their centres. The picture of
    /// corners is one pixel wider and higher than the picture that is made of it.
    pub corners: bool,
    /// The maximum number of blocks of a mesh that an SPU caches, for measurements: 4 to 28.
    /// Without a limit, there are as many as fit into local store.
    pub mesh_cache: u32,
    /// When the meshes of a world have moved, their tree is refitted, and serves rays worse. A new
    /// one is built when rays have made as many more tests for it as they make in this many
    /// pictures with a new tree. With 0, one is built whenever a mesh has moved.
    pub refit_pictures: u32,
    /// Who refits it; without a choice, the SPUs if most of many vertices have moved.
    pub refit_by: Option<RefitBy>,
    /// How the tree of a mesh is made, if its triangles have neither textures nor colours of
    /// vertices, or that of spheres and cones, if there is no mesh. Others are built with the
    /// surface area heuristic. Without a choice, so are those of scenes, and those of worlds unless
    /// they need a new tree of a mesh for each picture, or their spheres and cones move.
    pub build_by: Option<BuildBy>,
    /// The volumes of the trees' nodes.
    pub volumes: NodeVolumes,
    /// Whether rays from the eye may find a height field by cuts, if the view allows it.
    pub cuts: bool,
    /// Whether rays to a light that is infinitely far are left out where it is known whether the
    /// ground hides it. Only where cuts are used.
    pub shades: bool,
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
            mesh_cache: MESH_MAX_SLOTS,
            refit_pictures: REFIT_PICTURES,
            refit_by: None,
            build_by: None,
            volumes: NodeVolumes::Best,
            cuts: true,
            shades: true,
        }
    }
}

impl RenderOptions {
    /// Whether a scene with `lights` lights is traced with Whitted's model.
    pub(crate) fn is_whitted(self, lights: usize) -> bool {
        match self.model {
            Model::Scene => lights > 0,
            Model::Depth => false,
            Model::Whitted => true,
        }
    }
}

/// The part of the [`RenderOptions`] that the viewer of a picture chooses, not its author. The
/// default is that of the command line: antialiased, in sRGB unless shades are distances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// [`RenderOptions::samples`].
    pub samples: Samples,
    /// [`RenderOptions::contrast`].
    pub contrast: u8,
    /// [`RenderOptions::colour`]. With `None` it is sRGB with Whitted's model, and linear with
    /// depth shading, whose shades are distances and not light.
    pub colour: Option<Colour>,
    /// [`RenderOptions::roll_off`].
    pub roll_off: bool,
}

impl Default for Look {
    fn default() -> Self {
        Self { samples: Samples::Four, contrast: CONTRAST, colour: None, roll_off: false }
    }
}

impl Look {
    /// These options with this look, for a scene with `lights` lights.
    #[must_use]
    pub fn of(self, options: RenderOptions, lights: usize) -> RenderOptions {
        let usual = match options.is_whitted(lights) {
            true => Colour::Srgb,
            false => Colour::Linear,
        };
        RenderOptions {
            samples: self.samples,
            contrast: self.contrast,
            colour: self.colour.unwrap_or(usual),
            roll_off: self.roll_off,
            ..options
        }
    }
}
