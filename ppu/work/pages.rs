//! The contents of the framebuffer's pages, so that unchanged tiles are not traced again.
//!
//! Invariant: a page's contents are known only while no SPU may write to it. From the moment that
//! SPUs may write to it until the frame is done, nothing is assumed about it. After that it shows
//! the frame, except in the tiles that were left out.

use scenes::Camera;

use super::projection::Projection;
use super::snapshot::Snapshot;
use super::tiles::TileSet;
use super::units;
use crate::framebuffer::{Geometry, PixelFormat, Target};
use crate::scene::Scene;
use crate::scene::block::BoundingSphere;
use protocol::layout::{TILE_BLANK, TILE_HAS_PATHS, UnitCost, WorkUnit};

/// The number of pages that are remembered; no framebuffer has more.
pub const MAX_PAGES: usize = 4;

/// The pages of a framebuffer.
#[derive(Default)]
pub struct Pages {
    pages: Vec<Page>,
    /// Index of the page that is being written to.
    open: usize,
    /// The contents that the page will show. After the page has taken them over, this is a buffer.
    to_show: Snapshot,
}

/// The address and the format of a page.
#[derive(Clone, Copy, PartialEq)]
struct Place {
    address: usize,
    stride: u32,
    geometry: Geometry,
    format: PixelFormat,
}

/// The contents of a page, compared with the frame that it will show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contents {
    /// Nothing is known about it.
    Unknown,
    /// The same, except where tiles were left out.
    Same,
    /// Objects are elsewhere, or look otherwise.
    Moved,
    /// Anything may differ: the camera has moved, or a light or an option has changed.
    Other,
}

struct Page {
    place: Place,
    /// Whether it shows `shown`, except in the tiles of `missing`.
    is_known: bool,
    shown: Snapshot,
    missing: TileSet,
    /// Tiles that show nothing but the background.
    blank: TileSet,
    /// Tiles whose rays' paths the SPUs have kept, as of `shown`.
    has_paths: TileSet,
}

/// The tiles and places to trace so that a page shows a frame.
#[derive(Default)]
pub struct Changes {
    /// Tiles to trace as a whole.
    pub tiles: TileSet,
    /// Tiles in which only those rays are traced that have crossed a changed place.
    pub in_part: TileSet,
    /// These places.
    pub places: Vec<BoundingSphere>,
    /// Whether it pays to keep the rays' paths, because objects move before a resting camera.
    pub keeps_paths: bool,
}

impl Pages {
    /// Forgets the contents of all pages.
    pub fn forget(&mut self) {
        self.pages.clear();
    }

    /// Finds where a page's contents differ from the frame that it will show. The page's contents
    /// then count as unknown until [`Pages::close`].
    pub fn open(
        &mut self,
        target: &Target,
        scene: &Scene,
        camera: &Camera,
        projection: &Projection,
        changes: &mut Changes,
    ) -> Contents {
        let place = Place {
            address: target.base.as_ptr().addr(),
            stride: target.stride,
            geometry: target.geometry,
            format: target.format,
        };
        let Changes { tiles, in_part, places, keeps_paths } = changes;
        tiles.clear(target.geometry);
        in_part.clear(target.geometry);
        places.clear();
        self.to_show.take(scene, camera);
        let found = self.pages.iter().position(|page| page.place == place);
        self.open = found.unwrap_or_else(|| {
            if self.pages.len() == MAX_PAGES {
                self.pages.clear();
            }
            self.pages.push(Page::new(place));
            self.pages.len() - 1
        });
        let page = &mut self.pages[self.open];
        if !page.is_known || !page.shown.has_background_of(&self.to_show) {
            page.blank.clear(target.geometry);
        }
        *keeps_paths = false;
        let contents = if page.is_known {
            let is_found = self.to_show.changes(&page.shown, projection, tiles, places);
            let is_same = places.is_empty() && tiles.numbers().is_empty();
            *keeps_paths = !is_same && page.shown.is_seen_as(&self.to_show);
            if !places.is_empty() {
                tiles.add_missing(&page.has_paths);
            }
            tiles.add_set(&page.missing);
            if !places.is_empty() {
                in_part.add_missing(tiles);
            }
            match (is_found, is_same) {
                (false, _) => Contents::Other,
                (_, true) => Contents::Same,
                _ => Contents::Moved,
            }
        } else {
            tiles.add_all();
            Contents::Unknown
        };
        page.is_known = false;
        std::mem::swap(&mut page.shown, &mut self.to_show);
        contents
    }

    /// The number of the page that was opened last, below [`MAX_PAGES`].
    pub fn number(&self) -> usize {
        self.open
    }

    /// The tiles that show only the background, in the page that was opened last.
    pub fn blank(&self) -> Option<&TileSet> {
        self.pages.get(self.open).map(|page| &page.blank)
    }

    /// Records that the page that was opened last shows its frame, except in the tiles of
    /// `missing`. `costs` are those of `units`.
    pub fn close(&mut self, units: &[WorkUnit], costs: &[UnitCost], missing: &mut TileSet) {
        if let Some(page) = self.pages.get_mut(self.open) {
            page.is_known = true;
            page.has_paths.fit(page.place.geometry);
            std::mem::swap(&mut page.missing, missing);
            for (tile, cost) in units::tiles_and_costs(units, costs) {
                page.blank.set(tile, cost & TILE_BLANK != 0);
                page.has_paths.set(tile, cost & TILE_HAS_PATHS != 0);
            }
        }
    }
}

impl Page {
    fn new(place: Place) -> Self {
        Self {
            place,
            is_known: false,
            shown: Snapshot::default(),
            missing: TileSet::default(),
            blank: TileSet::default(),
            has_paths: TileSet::default(),
        }
    }
}

#[cfg(test)]
mod tests;
