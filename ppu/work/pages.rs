//! What the framebuffer's pages show, so that what has not changed is not traced again.
//!
//! Invariant: a page is known only while it shows a whole frame: from the moment it is to be written
//! to until it is whole again, nothing is assumed of it.

use glam::DVec3;
use nff::Camera;
use nff::depth::DepthShading;

use super::lens::Lens;
use super::tiles::TileSet;
use super::{Shown, units};
use crate::framebuffer::{Geometry, PixelFormat, Target};
use crate::scene::{Look, Scene, Sphere};
use protocol::layout::{TILE_BLANK, UnitCost, WorkUnit};

/// Most pages that are remembered: no framebuffer has more.
const MOST: usize = 4;

/// The pages of a framebuffer.
#[derive(Default)]
pub struct Pages {
    pages: Vec<Page>,
    /// Number of the page that is being written to.
    open: usize,
    /// What is to be seen there by Whitted's model.
    to_show: Shown,
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
    /// Whether it shows what is said below.
    whole: bool,
    camera: Camera,
    background: DVec3,
    depth: DepthShading,
    look: Look,
    spheres: Vec<Sphere>,
    /// What is seen of a scene by Whitted's model.
    shown: Shown,
    /// Tiles that show nothing but the background.
    blank: TileSet,
}

impl Pages {
    /// Nothing is known any more.
    pub fn forget(&mut self) {
        self.pages.clear();
    }

    /// Finds the tiles that differ between what a page shows and what it is to show; then it counts
    /// as unknown until [`Pages::close`].
    pub fn open(
        &mut self,
        target: &Target,
        scene: &Scene,
        camera: &Camera,
        lens: &Lens,
        changed: &mut TileSet,
    ) {
        let place = Place {
            address: target.base.as_ptr().addr(),
            stride: target.stride,
            geometry: target.geometry,
            format: target.format,
        };
        changed.clear(target.geometry);
        self.to_show.take(scene.block(), camera.eye);
        let Some(found) = self.pages.iter().position(|page| page.place == place) else {
            if self.pages.len() == MOST {
                self.pages.clear();
            }
            changed.add_all();
            self.open = self.pages.len();
            let mut page = Page::new(place, scene, camera);
            page.show(scene, camera, &mut self.to_show);
            page.blank.clear(target.geometry);
            self.pages.push(page);
            return;
        };
        self.open = found;
        let page = &mut self.pages[found];
        let same_view = page.camera == *camera
            && page.background == scene.background()
            && page.depth == scene.depth()
            && page.look == scene.look();
        if !page.whole || page.background != scene.background() {
            page.blank.clear(target.geometry);
        }
        if page.whole && same_view {
            page.changes(scene.spheres(), lens, changed);
            let shadows = scene.look().shadows;
            self.to_show.changes(&page.shown, shadows, lens, changed);
        } else {
            changed.add_all();
        }
        page.show(scene, camera, &mut self.to_show);
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
    fn new(place: Place, scene: &Scene, camera: &Camera) -> Self {
        Self {
            place,
            whole: false,
            camera: *camera,
            background: scene.background(),
            depth: scene.depth(),
            look: scene.look(),
            spheres: Vec::new(),
            shown: Shown::default(),
            blank: TileSet::default(),
        }
    }

    /// Adds the tiles that old and new spheres may be seen in, where they differ.
    fn changes(&self, spheres: &[Sphere], lens: &Lens, changed: &mut TileSet) {
        let mut add = |sphere: &Sphere| changed.add(&lens.bounds(sphere.centre, sphere.radius));
        for (old, new) in self.spheres.iter().zip(spheres) {
            if old != new {
                add(old);
                add(new);
            }
        }
        let both = self.spheres.len().min(spheres.len());
        self.spheres[both..].iter().for_each(&mut add);
        spheres[both..].iter().for_each(&mut add);
    }

    /// Takes over what the page is to show; `to_show` becomes what it showed before.
    fn show(&mut self, scene: &Scene, camera: &Camera, to_show: &mut Shown) {
        self.whole = false;
        self.camera = *camera;
        self.background = scene.background();
        self.depth = scene.depth();
        self.look = scene.look();
        std::mem::swap(&mut self.shown, to_show);
        self.spheres.clear();
        self.spheres.extend_from_slice(scene.spheres());
    }
}

#[cfg(test)]
mod tests;
