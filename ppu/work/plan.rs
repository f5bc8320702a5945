//! The plan of a frame: which tiles are traced, in which units, with which spheres.
//!
//! Owns everything that is kept from one frame to the next: the pages' contents and the tiles'
//! costs. Its buffers are reused for every frame.

use glam::DVec3;
use scenes::Camera;

use super::cuts::Cuts;
use super::pages::{Changes, Contents, Pages};
use super::policy::{Policy, Skip, Split};
use super::projection::Projection;
use super::spheres::EyeSpheres;
use super::tiles::{TileSet, tile_count, tile_pixels};
use super::units::{TileCosts, Units};
use crate::framebuffer::{Geometry, Target};
use crate::scene::Scene;
use crate::scene::block::{BoundingSphere, LANES, change_nodes, enclose_groups};
use crate::statistics::Causes;
use protocol::layout::{Node, TILE_BLANK, TILE_HAS_PATHS, TILE_WIDTH, UnitCost};

#[derive(Default)]
pub(crate) struct Plan {
    spheres: EyeSpheres,
    units: Units,
    pages: Pages,
    changes: Changes,
    /// The places that the frame's changes are in, as the SPUs get them.
    nodes: Vec<Node>,
    /// The page whose tiles' paths the frame keeps.
    paths: Option<usize>,
    /// The tiles that this frame leaves out.
    missing: TileSet,
    costs: TileCosts,
    cuts: Option<Cuts>,
    size: Size,
    keeps: bool,
}

/// Makes the nodes around changed places. If there are several, one around all of them is the
/// first, since most tiles have no ray that comes near any. The places are used up.
fn write_changes(eye: DVec3, places: &mut [BoundingSphere], nodes: &mut Vec<Node>) {
    nodes.clear();
    nodes.extend(change_nodes(eye, places));
    if nodes.len() > 1 {
        let groups = enclose_groups(places, LANES);
        nodes.splice(0..0, change_nodes(eye, &places[..groups]));
    }
}

/// Why a number of tiles are planned, of which `may_be_reached` are known to be near a change.
fn causes(contents: Contents, retain: bool, tiles: usize, may_be_reached: usize) -> Causes {
    let (tiles, reached) = (tiles as u64, may_be_reached.min(tiles) as u64);
    let none = Causes::default();
    match if retain { contents } else { Contents::Unknown } {
        Contents::Unknown => Causes { unknown: tiles, ..none },
        Contents::Other => Causes { view: tiles, ..none },
        Contents::Same => Causes { left: tiles, ..none },
        Contents::Moved => Causes { reached, unrecorded: tiles - reached, ..none },
    }
}

/// The size of a planned frame.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Size {
    /// The number of pixels to trace, or to keep if no change reaches them.
    pub pixels: u64,
    /// The number of tiles that need no tracing, because the page shows them already.
    pub tiles_retained: u64,
    /// The number of tiles that are left for the next frame.
    pub tiles_left: u64,
    /// Why tiles are traced.
    pub causes: Causes,
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
        let contents = self.pages.open(target, scene, camera, &projection, &mut self.changes);
        let Changes { tiles, in_part, places, keeps_paths } = &mut self.changes;
        let most = policy.most_tiles.filter(|_| policy.retain);
        let has_moved = matches!(contents, Contents::Moved | Contents::Other);
        let is_put_off = most.is_some() && has_moved;
        // A postponed frame starts again with all tiles.
        if !policy.retain || is_put_off {
            tiles.add_all();
            in_part.clear(geometry);
        }
        tiles.add_set(in_part);
        let most = if is_put_off { Some(0) } else { most };
        tiles.keep(most, &mut self.missing);
        write_changes(camera.eye, places, &mut self.nodes);
        let follows = policy.retain && policy.skip == Skip::Misses && scene.block().is_some();
        self.paths = (follows && *keeps_paths).then(|| self.pages.number());
        let may_be_reached = match scene.block() {
            Some(_) => in_part.numbers().len(),
            // With depth shading, these are the tiles that show changed spheres.
            None => tiles.numbers().len(),
        };
        let tiles_left = self.missing.numbers().len() as u64;
        self.spheres.cull(scene.spheres(), &projection, policy.skip, policy.record);
        let tiles = tiles.numbers();
        let costs = self.costs.of(geometry, in_part);
        self.cuts = Cuts::of_frame(scene, camera, geometry);
        if self.cuts.is_some() && policy.split == Split::Units {
            let across = geometry.width.div_ceil(TILE_WIDTH);
            self.units.split_upwards(tiles, across, policy.spus, costs);
        } else {
            self.units.split(tiles, policy.spus, policy.split, costs);
        }
        if let Some(blank) = self.pages.blank() {
            self.units.mark(blank, TILE_BLANK);
        }
        self.units.mark(in_part, TILE_HAS_PATHS);
        self.size = Size {
            pixels: tiles.iter().map(|&tile| u64::from(tile_pixels(geometry, tile))).sum(),
            tiles_retained: u64::from(tile_count(geometry)) - tiles.len() as u64 - tiles_left,
            tiles_left,
            causes: causes(contents, policy.retain, tiles.len(), may_be_reached),
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

    /// The nodes around the frame's changes.
    pub fn changes(&self) -> &[Node] {
        &self.nodes
    }

    /// The number of the page whose tiles' paths the frame keeps, if it keeps any.
    pub fn paths(&self) -> Option<usize> {
        self.paths
    }

    /// The cuts by which the frame's rays from the eye find the ground, if they do.
    pub fn cuts(&self) -> Option<Cuts> {
        self.cuts
    }

    pub fn units(&self) -> &Units {
        &self.units
    }

    pub fn size(&self) -> Size {
        self.size
    }
}
