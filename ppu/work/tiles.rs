//! The tiles of a picture: their number, their sizes, and sets of them.

use super::projection::Rectangle;
use crate::framebuffer::Geometry;
use protocol::layout::{TILE_HEIGHT, TILE_WIDTH};

/// The number of tiles in a picture.
#[must_use]
pub fn tile_count(geometry: Geometry) -> u32 {
    across(geometry) * geometry.height.div_ceil(TILE_HEIGHT)
}

/// The number of a tile's pixels that are within the picture.
#[must_use]
pub fn tile_pixels(geometry: Geometry, tile: u32) -> u32 {
    let x = tile % across(geometry) * TILE_WIDTH;
    let y = tile / across(geometry) * TILE_HEIGHT;
    (geometry.width - x).min(TILE_WIDTH) * geometry.height.saturating_sub(y).min(TILE_HEIGHT)
}

fn across(geometry: Geometry) -> u32 {
    geometry.width.div_ceil(TILE_WIDTH)
}

/// A number without a common divisor with `count`, so that its multiples modulo `count` are all
/// numbers below. It is near the golden section of `count`, so successive multiples, and any run
/// of them, are spread evenly.
fn stride(count: usize) -> usize {
    let gcd = |mut a: usize, mut b: usize| {
        while b > 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    let from = count * 618 / 1000;
    (from.max(1)..=count.max(1)).find(|&step| gcd(step, count) == 1).unwrap_or(1)
}

/// A set of a picture's tiles. Its memory is reused for the next picture.
#[derive(Default)]
pub struct TileSet {
    geometry: Option<Geometry>,
    wanted: Vec<bool>,
    numbers: Vec<u32>,
}

impl TileSet {
    /// Empties the set, for a picture of this size.
    pub fn clear(&mut self, geometry: Geometry) {
        self.geometry = Some(geometry);
        self.wanted.clear();
        self.wanted.resize(tile_count(geometry) as usize, false);
    }

    /// Adds all tiles.
    pub fn add_all(&mut self) {
        self.wanted.fill(true);
    }

    /// Adds the tiles of another set.
    pub fn add_set(&mut self, other: &Self) {
        for (wanted, other) in self.wanted.iter_mut().zip(&other.wanted) {
            *wanted |= other;
        }
    }

    /// Adds the tiles that another set does not have.
    pub fn add_missing(&mut self, other: &Self) {
        for (tile, wanted) in self.wanted.iter_mut().enumerate() {
            *wanted |= !other.contains(tile as u32);
        }
    }

    /// Empties the set if it is of a picture of another size.
    pub fn fit(&mut self, geometry: Geometry) {
        if self.geometry != Some(geometry) {
            self.clear(geometry);
        }
    }

    /// Keeps at most `most` tiles, from all over the picture. The others are moved to `rest`.
    pub fn keep(&mut self, most: Option<u32>, rest: &mut Self) {
        rest.geometry = self.geometry;
        rest.wanted.clear();
        let Some(mut left) = most else {
            return;
        };
        let count = self.wanted.len();
        rest.wanted.resize(count, false);
        let step = stride(count);
        for tile in (0..count).map(|number| number * step % count) {
            if !self.wanted[tile] {
                continue;
            }
            match left.checked_sub(1) {
                Some(fewer) => left = fewer,
                None => (self.wanted[tile], rest.wanted[tile]) = (false, true),
            }
        }
    }

    /// Adds a tile, or removes it.
    pub fn set(&mut self, tile: u32, wanted: bool) {
        if let Some(is_wanted) = self.wanted.get_mut(tile as usize) {
            *is_wanted = wanted;
        }
    }

    /// Whether the set has a tile.
    #[must_use]
    pub fn contains(&self, tile: u32) -> bool {
        self.wanted.get(tile as usize).is_some_and(|wanted| *wanted)
    }

    /// Adds the tiles that contain these pixels.
    pub fn add(&mut self, pixels: &Rectangle) {
        let Some(geometry) = self.geometry.filter(|_| !pixels.is_empty()) else {
            return;
        };
        let columns = pixels.x.start / TILE_WIDTH..pixels.x.end.div_ceil(TILE_WIDTH);
        for row in pixels.y.start / TILE_HEIGHT..pixels.y.end.div_ceil(TILE_HEIGHT) {
            let first = (row * across(geometry)) as usize;
            self.wanted[first + columns.start as usize..first + columns.end as usize].fill(true);
        }
    }

    /// The tiles' numbers, ascending.
    pub fn numbers(&mut self) -> &[u32] {
        self.numbers.clear();
        let wanted = (0..).zip(&self.wanted).filter(|(_, wanted)| **wanted);
        self.numbers.extend(wanted.map(|(tile, _)| tile));
        &self.numbers
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ODD: Geometry = Geometry { width: 200, height: 50 };

    #[test]
    fn tiles_cover_picture() {
        for (width, height) in [(1, 1), (64, 16), (65, 17), (200, 50), (1280, 720), (8192, 8192)] {
            let geometry = Geometry { width, height };
            let pixels: u32 =
                (0..tile_count(geometry)).map(|tile| tile_pixels(geometry, tile)).sum();
            assert_eq!(pixels, width * height);
        }
        // Four across, four down, the last column 8 wide, the last row 2 high.
        assert_eq!(tile_count(ODD), 16);
        assert_eq!([0, 3, 12, 15].map(|tile| tile_pixels(ODD, tile)), [1024, 128, 128, 16]);
    }

    #[test]
    fn pixels_add_the_tiles_they_lie_in() {
        let mut tiles = TileSet::default();
        tiles.clear(ODD);
        assert!(tiles.numbers().is_empty());
        for (x, y, expected) in [
            (0..0, 0..50, &[][..]),
            (63..64, 15..16, &[0]),
            (63..65, 15..17, &[0, 1, 4, 5]),
            (192..200, 48..50, &[15]),
            (64..128, 0..50, &[1, 5, 9, 13]),
        ] {
            tiles.clear(ODD);
            tiles.add(&Rectangle { x, y });
            assert_eq!(tiles.numbers(), expected);
        }
        tiles.add_all();
        assert_eq!(tiles.numbers().len(), 16);
        tiles.add(&Rectangle { x: 0..0, y: 0..0 });
        assert_eq!(tiles.numbers().len(), 16);
    }

    #[test]
    fn deferred_tiles_are_spread_over_picture() {
        for (width, height) in [(64, 16), (200, 50), (1280, 720), (640, 16)] {
            let geometry = Geometry { width, height };
            let count = tile_count(geometry) as usize;
            let (mut tiles, mut rest) = (TileSet::default(), TileSet::default());
            tiles.clear(geometry);
            tiles.add_all();
            tiles.keep(None, &mut rest);
            assert_eq!((tiles.numbers().len(), rest.numbers().len()), (count, 0));
            let mut seen = Vec::new();
            loop {
                tiles.keep(Some(10), &mut rest);
                let kept = tiles.numbers();
                assert_eq!(kept.len(), (count - seen.len()).min(10));
                let middle = kept.iter().filter(|&&tile| tile as usize >= count / 2);
                assert!(kept.len() < 10 || (4..=6).contains(&middle.count()));
                seen.extend_from_slice(kept);
                if rest.numbers().is_empty() {
                    break;
                }
                tiles.clear(geometry);
                tiles.add_set(&rest);
            }
            seen.sort_unstable();
            assert!(seen.into_iter().eq(0..count as u32));
        }
    }
}
