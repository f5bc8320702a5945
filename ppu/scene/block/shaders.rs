//! The SPU program's shaders.

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
