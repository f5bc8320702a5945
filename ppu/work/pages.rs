//! What the framebuffer's pages show, so that what has not changed is not traced again.
//!
//! Invariant: a page is known only while it shows a whole frame: from the moment it is to be
//! written to until it is whole again, nothing is assumed of it.

use nff::Camera;

use super::projection::Projection;
use super::snapshot::Snapshot;
use super::tiles::TileSet;
use super::units;
use crate::framebuffer::{Geometry, PixelFormat, Target};
use crate::scene::Scene;
use protocol::layout::{TILE_BLANK, UnitCost, WorkUnit};

/// Most pages that are remembered: no framebuffer has more.
const MOST: usize = 4;

/// The pages of a framebuffer.
#[derive(Default)]
pub struct Pages {
    pages: Vec<Page>,
    /// Number of the page that is being written to.
    open: usize,
    /// What it is to show; once the page has taken that over, the room for the next.
    to_show: Snapshot,
}

/// Where a page lies, and in which form.
#[derive(Clone, Copy, PartialEq)]
struct Place {
    address: usize,
    stride: u32,
    geometry: Geometry,
    format: PixelFormat,
}

struct Page {
    place: Place,
    /// Whether it shows all of that.
    whole: bool,
    shown: Snapshot,
    /// Tiles that show nothing but the background.
    blank: TileSet,
}

impl Pages {
    /// Nothing is known any more.
    pub fn forget(&mut self) {
        self.pages.clear();
    }

    /// Finds the tiles that differ between what a page shows and what it is to show; then it
    /// counts as unknown until [`Pages::close`].
    pub fn open(
        &mut self,
        target: &Target,
        scene: &Scene,
        camera: &Camera,
        projection: &Projection,
        changed: &mut TileSet,
    ) {
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
            if self.pages.len() == MOST {
                self.pages.clear();
            }
            self.pages.push(Page::new(place));
            self.pages.len() - 1
        });
        let page = &mut self.pages[self.open];
        if !page.whole || !page.shown.has_background_of(&self.to_show) {
            page.blank.clear(target.geometry);
        }
        if page.whole {
            self.to_show.changes(&page.shown, projection, changed);
        } else {
            changed.add_all();
        }
        page.whole = false;
        std::mem::swap(&mut page.shown, &mut self.to_show);
    }

    /// Tiles of the page opened last that show nothing but the background.
    pub fn blank(&self) -> Option<&TileSet> {
        self.pages.get(self.open).map(|page| &page.blank)
    }

    /// The page opened last shows its frame, after these units with these costs.
    pub fn close(&mut self, units: &[WorkUnit], costs: &[UnitCost]) {
        if let Some(page) = self.pages.get_mut(self.open) {
            page.whole = true;
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
            whole: false,
            shown: Snapshot::default(),
            blank: TileSet::default(),
        }
    }
}

#[cfg(test)]
mod tests;
