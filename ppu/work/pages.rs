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
use protocol::layout::{TILE_BLANK, UnitCost, WorkUnit};

/// The number of pages that are remembered; no framebuffer has more.
const MAX_PAGES: usize = 4;

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
    /// Something else.
    Moved,
}

struct Page {
    place: Place,
    /// Whether it shows `shown`, except in the tiles of `missing`.
    is_known: bool,
    shown: Snapshot,
    missing: TileSet,
    /// Tiles that show nothing but the background.
    blank: TileSet,
}

impl Pages {
    /// Forgets the contents of all pages.
    pub fn forget(&mut self) {
        self.pages.clear();
    }

    /// Finds the tiles in which a page's contents differ from the frame that it will show. The
    /// page's contents then count as unknown until [`Pages::close`].
    pub fn open(
        &mut self,
        target: &Target,
        scene: &Scene,
        camera: &Camera,
        projection: &Projection,
        changed: &mut TileSet,
    ) -> Contents {
        let place = Place {
            address: target.base.as_ptr().addr(),
            stride: target.stride,
            geometry: target.geometry,
            format: target.format,
        };
        changed.clear(target.geometry);
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
        let contents = if page.is_known {
            self.to_show.changes(&page.shown, projection, changed);
            let contents = match changed.numbers() {
                [] => Contents::Same,
                _ => Contents::Moved,
            };
            changed.add_set(&page.missing);
            contents
        } else {
            changed.add_all();
            Contents::Unknown
        };
        page.is_known = false;
        std::mem::swap(&mut page.shown, &mut self.to_show);
        contents
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
            std::mem::swap(&mut page.missing, missing);
            for (tile, cost) in units::tiles_and_costs(units, costs) {
                page.blank.set(tile, cost & TILE_BLANK != 0);
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
        }
    }
}

#[cfg(test)]
mod tests;
