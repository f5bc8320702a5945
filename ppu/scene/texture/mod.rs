//! Textures in the form that SPUs fetch from main memory: levels, each about half as large as the
//! one before, cut into tiles of one DMA transfer each.
//!
//! A tile has the first texels of its neighbours, too, and the edges of a level are continued, so
//! that the four texels of a filter are always in one tile (`protocol/src/layout/mesh.rs`).

mod level;
#[cfg(test)]
mod tests;

use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

use protocol::layout::{
    self, TEXTURE_SIDE, TEXTURE_TILE, TextureLevel, WRAP_ACROSS, WRAP_BITS, WRAP_DOWN,
    WRAP_MIRRORED_ACROSS, WRAP_MIRRORED_DOWN,
};
use scenes::{Texture, Wrap};
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::U32;

use self::level::{Level, root};
use super::colour::Colour;
use super::single::single;

/// Texels from one tile to the next.
const STEP: usize = TEXTURE_SIDE as usize - 1;
/// Words of a tile.
const WORDS: usize = TEXTURE_TILE as usize / 4;

/// A tile's texels, aligned as its DMA transfer needs it.
#[derive(Clone)]
#[repr(C, align(128))]
struct Tile([U32; WORDS]);

/// The textures of a scene's mesh.
#[derive(Clone)]
pub struct Textures {
    tiles: Vec<Tile>,
    sources: Vec<Arc<Texture>>,
    /// For each texture, its levels and the number of its first tile.
    parts: Vec<(Range<usize>, usize)>,
    /// The levels of each size that textures have: local store has few bytes for them.
    levels: Vec<TextureLevel>,
}

impl Textures {
    /// Cuts textures into tiles. They should be distinct. `colour` is the colour space of the
    /// scene. If it is sRGB's, tiles have the square roots of their light: of light
    /// itself, bytes would have too few steps in the dark.
    #[must_use]
    pub fn new(sources: Vec<Arc<Texture>>, colour: Colour) -> Self {
        let mut textures =
            Self { tiles: Vec::new(), parts: Vec::new(), levels: Vec::new(), sources: Vec::new() };
        let mut sizes = HashMap::new();
        for source in &sources {
            let first = textures.tiles.len();
            let mut own = Vec::new();
            let mut level = Some(Level::new(source));
            while let Some(largest) = level {
                own.push(textures.cut(&largest, first, source.wrap(), colour));
                level = largest.half();
            }
            let all = &mut textures.levels;
            let levels =
                sizes.entry((source.width(), source.texels().len())).or_insert_with(|| {
                    let start = all.len();
                    all.extend(own);
                    start..all.len()
                });
            textures.parts.push((levels.clone(), first));
        }
        textures.sources = sources;
        textures
    }

    /// Adds the tiles of a level of the texture whose first tile is `first`.
    fn cut(
        &mut self,
        level: &Level,
        first: usize,
        wrap: [Wrap; 2],
        colour: Colour,
    ) -> TextureLevel {
        let (width, height) = (level.width(), level.height());
        let (across, down) = (width / STEP + 1, height / STEP + 1);
        let record = TextureLevel {
            width: single(width as f64),
            height: single(height as f64),
            across: (across as u32).into(),
            first: ((self.tiles.len() - first) as u32).into(),
        };
        for top in (0..down).map(|row| row * STEP) {
            for left in (0..across).map(|column| column * STEP) {
                let mut tile = Tile([U32::ZERO; WORDS]);
                let rows = tile.0.chunks_mut(STEP + 1).take(STEP + 1);
                for (row, texels) in rows.enumerate() {
                    let y = continued(top + row, height, wrap[1]);
                    for (column, texel) in texels.iter_mut().enumerate() {
                        let x = continued(left + column, width, wrap[0]);
                        let [red, green, blue] = match colour {
                            Colour::Linear => level.texel(x, y),
                            Colour::Srgb => level.texel(x, y).map(root),
                        };
                        *texel = u32::from_be_bytes([red, green, blue, 0]).into();
                    }
                }
                self.tiles.push(tile);
            }
        }
        record
    }

    /// The number of tiles.
    #[must_use]
    pub fn tiles(&self) -> u32 {
        self.tiles.len() as u32
    }

    /// The bytes of all tiles. SPUs read them by their address.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        let start = self.tiles.as_ptr().cast::<u8>();
        // SAFETY: the tiles are arrays of bytes, without padding, one after another: their size is
        // a multiple of their alignment. The slice borrows `self`, and bytes have no alignment.
        unsafe { std::slice::from_raw_parts(start, self.tiles.len() * TEXTURE_TILE as usize) }
    }

    /// The address of the first tile, for SPUs.
    #[must_use]
    pub fn address(&self) -> u64 {
        self.tiles.as_ptr().expose_provenance() as u64
    }

    /// The number of textures.
    #[must_use]
    pub fn count(&self) -> u32 {
        self.sources.len() as u32
    }

    /// The number of all levels.
    #[must_use]
    pub fn level_count(&self) -> u32 {
        self.levels.len() as u32
    }

    pub(super) fn number_of(&self, texture: &Arc<Texture>) -> Option<usize> {
        let mut sources = self.sources.iter();
        sources.position(|source| Arc::ptr_eq(source, texture))
    }

    /// The records of all textures and their levels, for this local-store address.
    pub(super) fn records(&self, address: u32) -> Vec<u8> {
        let levels = address as usize + self.sources.len() * size_of::<layout::Texture>();
        let mut bytes = Vec::new();
        for (source, (own, first)) in self.sources.iter().zip(&self.parts) {
            let record = layout::Texture {
                levels: ((levels + own.start * size_of::<TextureLevel>()) as u32).into(),
                last: (own.len() as u32 - 1).into(),
                texels: single(source.texels().len() as f64),
                wraps: (wraps(source.wrap()) | (*first as u32) << WRAP_BITS).into(),
            };
            bytes.extend_from_slice(record.as_bytes());
        }
        bytes.extend_from_slice(self.levels.as_bytes());
        bytes
    }
}

impl std::fmt::Debug for Textures {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut all = f.debug_struct("Textures");
        all.field("sources", &self.sources).finish_non_exhaustive()
    }
}

/// The texel that is at `place`, counted from one before the first of `count`.
fn continued(place: usize, count: usize, wrap: Wrap) -> usize {
    match wrap {
        Wrap::Repeat => (place + count - 1) % count,
        Wrap::Clamp | Wrap::Mirror => place.saturating_sub(1).min(count - 1),
    }
}

fn wraps([across, down]: [Wrap; 2]) -> u32 {
    let bits = |wrap: Wrap, repeated: u32, mirrored: u32| match wrap {
        Wrap::Clamp => 0,
        Wrap::Repeat => repeated,
        Wrap::Mirror => repeated | mirrored,
    };
    bits(across, WRAP_ACROSS, WRAP_MIRRORED_ACROSS) | bits(down, WRAP_DOWN, WRAP_MIRRORED_DOWN)
}
