//! The plan of a frame: which tiles are traced, in which units, with which spheres.
//!
//! Owns everything that is kept from one frame to the next: the pages' contents and the tiles'
//! costs. Its buffers are reused for every frame.

use scenes::Camera;

use super::pages::{Contents, Pages};
use super::policy::Policy;
use super::projection::Projection;
use super::spheres::EyeSpheres;
use super::tiles::{TileSet, tile_count, tile_pixels};
use super::units::{TileCosts, Units};
use crate::framebuffer::{Geometry, Target};
use crate::scene::Scene;
use protocol::layout::UnitCost;

#[derive(Default)]
pub(crate) struct Plan {
    spheres: EyeSpheres,
    units: Units,
    pages: Pages,
    tiles: TileSet,
    /// The tiles that this frame leaves out.
    missing: TileSet,
    costs: TileCosts,
    size: Size,
    keeps: bool,
}

/// The size of a planned frame.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Size {
    /// The number of pixels to trace.
    pub pixels: u64,
    /// The number of tiles that need no tracing, because the page shows them already.
    pub tiles_retained: u64,
    /// The number of tiles that are left for the next frame.
    pub tiles_left: u64,
    /// Whether nothing is traced, because the number of tiles is limited and something has moved.
    pub is_put_off: bool,
    /// The number of spheres that are not sent, because the picture can't show them.
    pub spheres_unseen: u64,
}

impl Plan {
    /// Plans a frame into `target`.
    pub fn make(&mut self, scene: &Scene, camera: &Camera, target: &Target, policy: Policy) {
        let geometry = target.geometry;
        let projection = Projection::new(camera, geometry);
        self.keeps = policy.keeps;
        if !self.keeps {
            self.pages.forget();
        }
        let contents = self.pages.open(target, scene, camera, &projection, &mut self.tiles);
        let most = policy.most_tiles.filter(|_| policy.retain);
        let is_put_off = most.is_some() && contents == Contents::Moved;
        // A postponed frame starts again with all tiles.
        if !policy.retain || is_put_off {
            self.tiles.add_all();
        }
        let most = if is_put_off { Some(0) } else { most };
        self.tiles.keep(most, &mut self.missing);
        let tiles_left = self.missing.numbers().len() as u64;
        self.spheres.cull(scene.spheres(), &projection, policy.skip, policy.record);
        let tiles = self.tiles.numbers();
        let costs = self.costs.of(geometry);
        self.units.split(tiles, policy.spus, policy.split, costs);
        if let Some(blank) = self.pages.blank() {
            self.units.mark_blank(blank);
        }
        self.size = Size {
            pixels: tiles.iter().map(|&tile| u64::from(tile_pixels(geometry, tile))).sum(),
            tiles_retained: u64::from(tile_count(geometry)) - tiles.len() as u64 - tiles_left,
            tiles_left,
            is_put_off,
            spheres_unseen: (scene.spheres().len() - self.spheres.records().len()) as u64,
        };
    }

    /// Records that the frame is in its page, and its units' costs.
    pub fn done(&mut self, geometry: Geometry, costs: &[UnitCost]) {
        self.costs.learn(geometry, self.units.lines(), costs);
        if self.keeps && !self.size.is_put_off {
            self.pages.close(self.units.lines(), costs, &mut self.missing);
        }
    }

    /// Forgets the contents of all pages.
    pub fn forget_pages(&mut self) {
        self.pages.forget();
    }

    pub fn spheres(&self) -> &EyeSpheres {
        &self.spheres
    }

    pub fn units(&self) -> &Units {
        &self.units
    }

    pub fn size(&self) -> Size {
        self.size
    }
}
