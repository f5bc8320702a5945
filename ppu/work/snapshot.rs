//! Snapshots of the content of a picture, and the tiles in which two of them differ. This is the
//! only place that looks for differences. A changed world has no record of where the picture
//! changes, and a new scene is compared in the same way as a scene that was changed in place.
//!
//! With depth shading, the picture changes where a changed sphere is or was visible. With
//! Whitted's model, it also changes where the shadow of a changed object falls or fell. In
//! addition, any change may show in mirrors, in glass and on objects with a game's own shader, so
//! the picture changes wherever one of these is visible.
//!
//! Invariant: all other pixels are equal in both pictures. The exception is a pixel with two
//! surfaces at bit-identical distances: each picture may show either.

use std::sync::Arc;

use glam::DVec3;
use scenes::depth::DepthShading;
use scenes::{Camera, Sky};
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::F32;

use super::projection::{Projection, Rectangle};
use super::shadow::Shadow;
use super::tiles::TileSet;
use crate::scene::block::{BoundingSphere, Chains, Light, VisiblePrimitive, widened};
use crate::scene::mesh::MeshBlocks;
use crate::scene::{RenderOptions, Scene, Sphere};
use protocol::layout::{self, SCENE_ADDRESS};

/// The most pairs of a changed object and an object that its shadow may fall on. Looking at more
/// pairs would take longer than tracing the whole picture.
const MAX_SHADOWS: usize = 4096;

/// The content of a picture. Its buffers are reused for the next.
#[derive(Default)]
pub struct Snapshot {
    /// `None` before the first picture.
    global: Option<GlobalState>,
    /// The spheres of depth shading.
    spheres: Vec<Sphere>,
    /// This and all further fields: Whitted's model.
    options: Option<RenderOptions>,
    chains: Option<Chains>,
    ambient: [F32; 4],
    lights: Vec<Light>,
    mesh: Option<Arc<MeshBlocks>>,
    /// The objects by their slots, kind after kind.
    objects: Vec<Option<VisiblePrimitive>>,
    /// The addresses of the slots.
    addresses: Vec<u32>,
    bytes: Vec<u8>,
}

/// The settings that every pixel depends on.
#[derive(Clone, Copy, PartialEq)]
struct GlobalState {
    camera: Camera,
    background: DVec3,
    sky: Option<Sky>,
    depth: DepthShading,
    render_options: RenderOptions,
}

/// How an object differs in two pictures.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Change {
    None,
    /// Its material differs, or whether others are visible in it.
    Appearance,
    /// Its position or its shape differs, or only one picture has it.
    Place,
}

/// The pixels on which an object may be visible.
fn place(seen: &VisiblePrimitive, projection: &Projection) -> Rectangle {
    let spheres = seen.hull.spheres().iter();
    projection.hull(spheres.map(|&sphere| {
        let BoundingSphere { centre, radius } = widened(projection.eye(), sphere);
        (centre, radius)
    }))
}

impl Snapshot {
    /// Records the content of a scene for a camera. The scene's block must be written for the
    /// camera's eye.
    pub fn take(&mut self, scene: &Scene, camera: &Camera) {
        self.global = Some(GlobalState {
            camera: *camera,
            background: scene.background(),
            sky: scene.sky(),
            depth: scene.depth(),
            render_options: scene.render_options(),
        });
        self.spheres.clear();
        self.spheres.extend_from_slice(scene.spheres());
        let block = scene.block();
        self.options = block.map(|block| block.options());
        self.chains = block.map(|block| block.chains());
        self.ambient = Default::default();
        self.mesh = None;
        self.lights.clear();
        self.objects.clear();
        self.addresses.clear();
        self.bytes.clear();
        let Some(block) = block else { return };
        self.ambient = block.ambient();
        self.mesh = block.mesh().map(|mesh| mesh.blocks.clone());
        self.lights.extend_from_slice(block.lights());
        self.bytes.extend_from_slice(block.bytes());
        for (address, object) in block.slots(camera.eye) {
            self.addresses.push(address);
            self.objects.push(object);
        }
    }

    /// Whether both pictures have the same background.
    pub fn has_background_of(&self, other: &Self) -> bool {
        let background = |shown: &Self| shown.global.map(|all| all.background);
        background(self) == background(other)
    }

    /// Adds the tiles in which `self` differs from `before`. If the cameras or the render options
    /// differ, these are all tiles.
    pub fn changes(&self, before: &Self, projection: &Projection, changed: &mut TileSet) {
        match self.global {
            Some(all) if before.global == Some(all) => {
                self.changed_spheres(before, projection, changed);
                self.changed_objects(before, all.render_options.shadows, projection, changed);
            }
            _ => changed.add_all(),
        }
    }

    /// Adds the tiles in which changed spheres are or were visible.
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

    /// Adds the tiles in which objects, their shadows, or reflected and refracted objects differ.
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
        // Where the mesh shows others or their shadows is not looked for.
        let same_mesh = match (&self.mesh, &before.mesh) {
            (None, None) => true,
            (Some(new), Some(old)) => Arc::ptr_eq(new, old) && self.bytes == before.bytes,
            _ => false,
        };
        if !same_mesh {
            return changed.add_all();
        }
        let mut are_few = false;
        // If the bounds of chains differ, everything that is reflected or refracted may differ.
        let mut any = self.chains != before.chains;
        for (new, old) in self.objects.iter().zip(&before.objects) {
            let change = self.change(new.as_ref(), before, old.as_ref());
            if change == Change::None {
                continue;
            }
            any = true;
            let has_moved = change == Change::Place && shadows;
            if has_moved && !are_few {
                if self.has_many_shadows(before) {
                    return changed.add_all();
                }
                are_few = true;
            }
            for (seen, all) in [(old, before), (new, self)] {
                let Some(seen) = seen else { continue };
                changed.add(&place(seen, projection));
                if has_moved && !all.shadows(seen, projection, changed) {
                    return changed.add_all();
                }
            }
        }
        if any && self.options.is_some_and(|options| options.ray_depth > 1) {
            for seen in self.objects.iter().flatten().filter(|seen| seen.sees_others) {
                changed.add(&place(seen, projection));
            }
        }
    }

    /// Whether the objects that have moved have more shadows than are looked at.
    fn has_many_shadows(&self, before: &Self) -> bool {
        let of_one = self.lights.len() * self.objects.len();
        let mut pairs = 0;
        self.objects.iter().zip(&before.objects).any(|(new, old)| {
            if self.change(new.as_ref(), before, old.as_ref()) == Change::Place {
                pairs += of_one * new.iter().chain(old).count();
            }
            pairs > MAX_SHADOWS
        })
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
            return if new.is_none() && old.is_none() { Change::None } else { Change::Place };
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
            Change::Appearance
        }
    }

    /// Adds the tiles that the shadows of an object may fall on; `false` if they may fall
    /// anywhere.
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
                // Computed only when needed, because the shadow misses most objects.
                let mut bounds = None;
                shadow.on(on.sphere, on.plane, projection, &mut |pixels: &Rectangle| {
                    let bounds = bounds.get_or_insert_with(|| place(on, projection));
                    changed.add(&pixels.intersection(bounds));
                });
            }
        }
        true
    }
}

/// Whether two records have the same surface. Their materials may differ.
fn same_form(one: &[u8], other: &[u8]) -> bool {
    let material = std::mem::offset_of!(layout::Object, material);
    let end = material + size_of::<u32>();
    one.len() == other.len()
        && one.len() >= end
        && one[..material] == other[..material]
        && one[end..] == other[end..]
}
