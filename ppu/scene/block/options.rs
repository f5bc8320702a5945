//! The settings of a block, and the SPU program's shaders.

use crate::scene::Colour;
use crate::scene::render_options::{NodeVolumes, REFIT_PICTURES};
use protocol::layout::MESH_MOST_SLOTS;

/// Settings of Whitted's model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockOptions {
    /// The longest chain of rays, including the primary ray, from 1 to
    /// [`MAX_DEPTH`](protocol::layout::MAX_DEPTH).
    pub ray_depth: u32,
    /// Whether transparent surfaces reflect by Schlick's approximation in addition to their Ks.
    pub fresnel: bool,
    /// Whether to trace all rays that the Standard Procedural Databases count, even those that add
    /// nothing to the picture.
    pub spd_rays: bool,
    /// What the channels of the scene's colours say about light.
    pub colour: Colour,
    /// The most blocks of a mesh that an SPU caches.
    pub mesh_cache: u32,
    /// How many pictures' tests of rays a refitted tree may waste, as in
    /// [`RenderOptions`](crate::scene::RenderOptions).
    pub refit_pictures: u32,
    /// The volumes of the trees' nodes. Where boxes and their code have no room, they are spheres.
    pub volumes: NodeVolumes,
}

impl Default for BlockOptions {
    fn default() -> Self {
        Self {
            ray_depth: 5,
            fresnel: false,
            spd_rays: false,
            colour: Colour::Linear,
            mesh_cache: MESH_MOST_SLOTS,
            refit_pictures: REFIT_PICTURES,
            volumes: NodeVolumes::Best,
        }
    }
}

/// The entries of a program's shaders by their names. Looking one up allocates no memory.
pub(crate) struct ShaderEntries(Vec<String>);

impl ShaderEntries {
    /// `names` are the shaders in the program's table, in its order.
    pub fn new(names: Vec<String>) -> Self {
        Self(names)
    }

    pub fn entry(&self, name: &str) -> Option<u32> {
        let place = self.0.iter().position(|known| known == name);
        place.map(|place| place as u32)
    }
}
