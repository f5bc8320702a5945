//! What a block is made by beside the scene: how far rays go, and the program's shaders.

/// How a scene is traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockOptions {
    /// Most rays in a chain, the eye's counted, from 1 to
    /// [`MAX_DEPTH`](protocol::layout::MAX_DEPTH).
    pub ray_depth: u32,
    /// Whether transmitting surfaces reflect by Schlick's approximation beyond their Ks.
    pub fresnel: bool,
    /// Whether rays that add nothing to the picture are sent where the Standard Procedural
    /// Databases count them.
    pub spd_rays: bool,
}

impl Default for BlockOptions {
    fn default() -> Self {
        Self {
            ray_depth: 5,
            fresnel: false,
            spd_rays: false,
        }
    }
}

/// The entries of a program's shaders by their names, looked up without taking memory.
pub(crate) struct ShaderEntries(Vec<String>);

impl ShaderEntries {
    /// Of the shaders in the program's table.
    pub fn new(names: Vec<String>) -> Self {
        Self(names)
    }

    pub fn entry(&self, name: &str) -> Option<u32> {
        let place = self.0.iter().position(|known| known == name);
        place.map(|place| place as u32)
    }
}
