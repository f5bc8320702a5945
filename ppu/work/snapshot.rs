//! What a picture was made of, and where another differs from it. It is here alone that
//! differences are looked for: a world that has changed says nothing of where, and a scene that
//! was made anew is compared as well as one that was changed in place.
//!
//! By depth shading a sphere that has changed is in the picture where it is seen or was. By
//! Whitted's model a primary ray sees what it hits, and whether that is in the shadow of anything:
//! so if an object has changed, the picture has where the object is seen or was, and where its
//! shadow falls or fell. What is seen in mirrors, in glass and by a game's own shaders may be
//! anywhere: where one is, everything that changes shows.
//!
//! Invariant: pixels that are not among the answer are the same in both pictures, unless two
//! surfaces are equally far from the eye to the bit: then either may be hit in either picture.

use glam::DVec3;
use nff::Camera;
use nff::depth::DepthShading;
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::F32;

use super::projection::{Projection, Rectangle};
use super::shadow::Shadow;
use super::tiles::TileSet;
use crate::scene::block::{BlockOptions, BoundingSphere, Chains, Light, VisiblePrimitive, widened};
use crate::scene::{RenderOptions, Scene, Sphere};
use protocol::layout::{self, SCENE_ADDRESS};

/// Most pairs of an object that has changed and one that its shadow may fall on: the whole picture
/// is traced in less time than more are looked at.
const MOST_SHADOWS: usize = 4096;

/// What a picture was made of; its buffers serve for the next.
#[derive(Default)]
pub struct Snapshot {
    /// Nothing before the first picture.
    everywhere: Option<Everywhere>,
    /// By depth shading.
    spheres: Vec<Sphere>,
    /// By Whitted's model.
    options: Option<BlockOptions>,
    chains: Option<Chains>,
    ambient: [F32; 4],
    lights: Vec<Light>,
    /// The objects by their plots, kind after kind.
    objects: Vec<Option<VisiblePrimitive>>,
    /// Where the plots are.
    addresses: Vec<u32>,
    bytes: Vec<u8>,
}

/// What every pixel depends on.
#[derive(Clone, Copy, PartialEq)]
struct Everywhere {
    camera: Camera,
    background: DVec3,
    depth: DepthShading,
    render_options: RenderOptions,
}

/// In which way an object of two pictures differs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Change {
    None,
    /// It looks otherwise.
    RenderOptions,
    /// It is elsewhere, of another shape, or not in both.
    Place,
}

/// Pixels on which an object may be seen.
fn place(seen: &VisiblePrimitive, projection: &Projection) -> Rectangle {
    let spheres = seen.hull.spheres().iter();
    projection.hull(spheres.map(|&sphere| {
        let BoundingSphere { centre, radius } = widened(projection.eye(), sphere);
        (centre, radius)
    }))
}

impl Snapshot {
    /// Takes down what a scene shows to a camera, for whose eye its block was written.
    pub fn take(&mut self, scene: &Scene, camera: &Camera) {
        self.everywhere = Some(Everywhere {
            camera: *camera,
            background: scene.background(),
            depth: scene.depth(),
            render_options: scene.render_options(),
        });
        self.spheres.clear();
        self.spheres.extend_from_slice(scene.spheres());
        let block = scene.block();
        self.options = block.map(|block| block.options());
        self.chains = block.map(|block| block.chains());
        self.ambient = Default::default();
        self.lights.clear();
        self.objects.clear();
        self.addresses.clear();
        self.bytes.clear();
        let Some(block) = block else { return };
        self.ambient = block.ambient();
        self.lights.extend_from_slice(block.lights());
        self.bytes.extend_from_slice(block.bytes());
        for (address, object) in block.slots(camera.eye) {
            self.addresses.push(address);
            self.objects.push(object);
        }
    }

    /// Whether both have the same background.
    pub fn has_background_of(&self, other: &Self) -> bool {
        let background = |shown: &Self| shown.everywhere.map(|all| all.background);
        background(self) == background(other)
    }

    /// Adds the tiles in which `self` differs from `before`; all of them where the two are seen
    /// otherwise, or are made of different things altogether.
    pub fn changes(&self, before: &Self, projection: &Projection, changed: &mut TileSet) {
        match self.everywhere {
            Some(all) if before.everywhere == Some(all) => {
                self.changed_spheres(before, projection, changed);
                self.changed_objects(before, all.render_options.shadows, projection, changed);
            }
            _ => changed.add_all(),
        }
    }

    /// Adds the tiles that old and new spheres may be seen in, where they differ.
    fn changed_spheres(&self, before: &Self, projection: &Projection, changed: &mut TileSet) {
        let (old, new) = (&before.spheres, &self.spheres);
        let mut add =
            |sphere: &Sphere| changed.add(&projection.bounds(sphere.centre, sphere.radius));
        for (old, new) in old.iter().zip(new) {
            if old != new {
                add(old);
                add(new);
            }
        }
        let both = old.len().min(new.len());
        old[both..].iter().for_each(&mut add);
        new[both..].iter().for_each(&mut add);
    }

    /// Adds the tiles in which objects, their shadows or what is seen in them differ.
    fn changed_objects(
        &self,
        before: &Self,
        shadows: bool,
        projection: &Projection,
        changed: &mut TileSet,
    ) {
        if self.options != before.options
            || self.addresses != before.addresses
            || self.ambient.as_bytes() != before.ambient.as_bytes()
            || !self.lights_as(before)
        {
            return changed.add_all();
        }
        let mut pairs = 0;
        // Where chains end otherwise, what goes on looks otherwise.
        let mut any = self.chains != before.chains;
        for (new, old) in self.objects.iter().zip(&before.objects) {
            let change = self.change(new.as_ref(), before, old.as_ref());
            if change == Change::None {
                continue;
            }
            any = true;
            for (seen, all) in [(old, before), (new, self)] {
                let Some(seen) = seen else { continue };
                changed.add(&place(seen, projection));
                if change == Change::Place && shadows {
                    pairs += self.lights.len() * self.objects.len();
                    if pairs > MOST_SHADOWS || !all.shadows(seen, projection, changed) {
                        return changed.add_all();
                    }
                }
            }
        }
        if any && self.options.is_some_and(|options| options.ray_depth > 1) {
            for seen in self
                .objects
                .iter()
                .flatten()
                .filter(|seen| seen.sees_others)
            {
                changed.add(&place(seen, projection));
            }
        }
    }

    fn lights_as(&self, other: &Self) -> bool {
        let mut pairs = self.lights.iter().zip(&other.lights);
        self.lights.len() == other.lights.len() && pairs.all(|(a, b)| a.lights_as(b))
    }

    fn record(&self, address: u32, size: usize) -> &[u8] {
        let start = (address - SCENE_ADDRESS) as usize;
        self.bytes.get(start..start + size).unwrap_or_default()
    }

    fn change(
        &self,
        new: Option<&VisiblePrimitive>,
        before: &Self,
        old: Option<&VisiblePrimitive>,
    ) -> Change {
        let (Some(new), Some(old)) = (new, old) else {
            return if new.is_none() && old.is_none() {
                Change::None
            } else {
                Change::Place
            };
        };
        let (address, size) = new.record;
        if new.record != old.record
            || !same_form(self.record(address, size), before.record(address, size))
        {
            return Change::Place;
        }
        let size = size_of::<layout::Material>();
        let same_material = self.record(new.material, size) == before.record(old.material, size);
        if same_material && new.sees_others == old.sees_others {
            Change::None
        } else {
            Change::RenderOptions
        }
    }

    /// Adds the tiles that the shadows of an object fall on; `false` if there is no saying which.
    fn shadows(
        &self,
        seen: &VisiblePrimitive,
        projection: &Projection,
        changed: &mut TileSet,
    ) -> bool {
        for light in &self.lights {
            let Some(shadow) = Shadow::of(seen.sphere, light.kind(), projection) else {
                return false;
            };
            for on in self.objects.iter().flatten() {
                if on.is_bent {
                    changed.add(&place(on, projection));
                    continue;
                }
                // Most objects are out of the shadow's way: theirs are not asked for.
                let mut bounds = None;
                shadow.on(
                    on.sphere,
                    on.plane,
                    projection,
                    &mut |pixels: &Rectangle| {
                        let bounds = bounds.get_or_insert_with(|| place(on, projection));
                        changed.add(&pixels.intersection(bounds));
                    },
                );
            }
        }
        true
    }
}

/// Whether two records are of the same surface, whatever it is made of.
fn same_form(one: &[u8], other: &[u8]) -> bool {
    let material = std::mem::offset_of!(layout::Object, material);
    let behind = material + size_of::<u32>();
    one.len() == other.len()
        && one.len() >= behind
        && one[..material] == other[..material]
        && one[behind..] == other[behind..]
}
