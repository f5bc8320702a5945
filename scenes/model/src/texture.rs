//! Textures: pictures that colour the triangles of a mesh.

use std::fmt;

/// What is beyond the edges of a texture.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Wrap {
    /// The texture again.
    #[default]
    Repeat,
    /// The colours of its edge.
    Clamp,
    /// The texture again, every second time mirrored.
    Mirror,
}

/// A picture by which the colour of a material is multiplied, where a mesh has texture
/// coordinates.
///
/// The coordinates (0, 0) are its upper left corner and (1, 1) its lower right one, and a texel is
/// a square between them, not a point.
#[derive(Clone, PartialEq, Eq)]
pub struct Texture {
    width: u32,
    texels: Vec<[u8; 3]>,
    wrap: [Wrap; 2],
    checksum: u64,
}

impl Texture {
    /// The most texels across and down.
    pub const MAX_SIDE: u32 = 4096;

    /// A texture of `width` columns. The texels are red, green and blue as a screen gets them
    /// (sRGB), row by row from the top. `wrap` is the continuation beyond the edges at the sides,
    /// and beyond those above and below.
    ///
    /// `None` if the texels are no whole rows, or a side is 0 or above [`Texture::MAX_SIDE`].
    #[must_use]
    pub fn new(width: u32, texels: Vec<[u8; 3]>, wrap: [Wrap; 2]) -> Option<Self> {
        let height = texels.len().checked_div(width as usize)?;
        let fits = (1..=Self::MAX_SIDE as usize).contains(&height) && width <= Self::MAX_SIDE;
        let is_whole = height * width as usize == texels.len();
        (fits && is_whole).then(|| Self {
            checksum: checksum(width, &texels, wrap),
            width,
            texels,
            wrap,
        })
    }

    /// Texels across.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Texels down.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.texels.len() as u32 / self.width
    }

    /// The texels, row by row from the top.
    #[must_use]
    pub fn texels(&self) -> &[[u8; 3]] {
        &self.texels
    }

    /// A checksum of all of it, the same on every machine.
    #[must_use]
    pub fn checksum(&self) -> u64 {
        self.checksum
    }

    /// The continuation beyond the edges: at the sides, and above and below.
    #[must_use]
    pub fn wrap(&self) -> [Wrap; 2] {
        self.wrap
    }
}

/// FNV-1a over the bytes.
fn checksum(width: u32, texels: &[[u8; 3]], wrap: [Wrap; 2]) -> u64 {
    let head = width.to_be_bytes().into_iter().chain(wrap.map(|wrap| wrap as u8));
    let bytes = head.chain(texels.as_flattened().iter().copied());
    bytes.fold(0xcbf2_9ce4_8422_2325, |sum: u64, byte| {
        (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

impl fmt::Debug for Texture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = (self.width(), self.height());
        let mut all = f.debug_struct("Texture");
        all.field("size", &size).field("wrap", &self.wrap).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texels_must_fill_supported_size() {
        let make = |width: u32, count: usize| {
            Texture::new(width, vec![[0; 3]; count], [Wrap::Repeat; 2])
                .map(|texture| (texture.width(), texture.height()))
        };
        assert_eq!(make(3, 6), Some((3, 2)));
        assert_eq!(make(4096, 4096), Some((4096, 1)));
        for (width, count) in [(0, 0), (3, 0), (0, 3), (3, 7), (4097, 4097), (1, 4097)] {
            assert_eq!(make(width, count), None, "{width}, {count}");
        }
    }
}
