//! Snapshots of the content of a picture, and where two of them differ. This is the only place
//! that looks for differences. A changed world has no record of where the picture changes, and a
//! new scene is compared in the same way as a scene that was changed in place.
//!
//! With depth shading, the picture changes where a changed sphere is or was visible. With
//! Whitted's model, it changes where a ray of any kind meets or met a changed object: the SPUs have
//! kept what the rays crossed (`PATHS`), and find these rays.
//!
//! Invariant: all other pixels are equal in both pictures. The exception is a pixel with two
//! surfaces at bit-identical distances: each picture may show either.

use std::sync::Arc;

use glam::DVec3;
use scenes::depth::DepthShading;
use scenes::{Camera, Fog, Sky};
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::F32;

use super::projection::Projection;
use super::tiles::TileSet;
use crate::scene::block::{
    BoundingSphere, Chains, Light, MaterialTable, MeshPlace, VisiblePrimitive, merge_nearest,
};
use crate::scene::height::HeightView;
use crate::scene::mesh::MeshBlocks;
use crate::scene::texture::Textures;
use crate::scene::{RenderOptions, Scene, Sphere};
use protocol::layout::{self, SCENE_ADDRESS};

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
    mesh: Option<MeshContent>,
    /// The objects by their slots, kind after kind.
    objects: Vec<Option<VisiblePrimitive>>,
    /// The addresses of the slots.
    addresses: Vec<u32>,
    bytes: Vec<u8>,
}

/// A mesh in main memory. As long as a snapshot shares its parts, they are replaced and not changed
/// in place.
struct MeshContent {
    blocks: Arc<MeshBlocks>,
    /// The version of the vertices that SPUs have refitted the blocks with.
    moved: Option<u64>,
    table: Option<Arc<MaterialTable>>,
    textures: Option<Arc<Textures>>,
    heights: Option<Arc<HeightView>>,
    /// The address of the first material, unless `table` has the materials.
    materials: u32,
    material_count: u32,
    /// The eye relative to the blocks' origin.
    eye: [F32; 4],
}

impl MeshContent {
    fn of(mesh: &MeshPlace) -> Self {
        Self {
            blocks: mesh.blocks.clone(),
            moved: mesh.moved.map(|moved| moved.version()).or(mesh.sorted.map(|it| it.version())),
            table: mesh.table.cloned(),
            textures: mesh.textures.cloned(),
            heights: mesh.heights.cloned(),
            materials: mesh.materials,
            material_count: mesh.material_count,
            eye: mesh.eye,
        }
    }

    /// Whether both have the same height field, as the same eye sees it.
    fn has_ground_of(&self, other: &Self) -> bool {
        self.heights.as_ref().map(Arc::as_ptr) == other.heights.as_ref().map(Arc::as_ptr)
    }

    /// Whether both have the same textures.
    fn is_textured_as(&self, other: &Self) -> bool {
        self.textures.as_ref().map(Arc::as_ptr) == other.textures.as_ref().map(Arc::as_ptr)
    }
}

/// The settings that every pixel depends on.
#[derive(Clone, Copy, PartialEq)]
struct GlobalState {
    camera: Camera,
    background: DVec3,
    sky: Option<Sky>,
    fog: Option<Fog>,
    depth: DepthShading,
    render_options: RenderOptions,
}

/// The most spheres around changed places.
const MAX_PLACES: usize = 32;

impl Snapshot {
    /// Records the content of a scene for a camera. The scene's block must be written for the
    /// camera's eye.
    pub fn take(&mut self, scene: &Scene, camera: &Camera) {
        self.global = Some(GlobalState {
            camera: *camera,
            background: scene.background(),
            sky: scene.sky(),
            fog: scene.fog(),
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
        self.mesh = block.mesh().map(|mesh| MeshContent::of(&mesh));
        self.lights.extend_from_slice(block.lights());
        self.bytes.extend_from_slice(block.bytes());
        for (address, object) in block.slots() {
            self.addresses.push(address);
            self.objects.push(object);
        }
    }

    /// Whether both pictures have the same background.
    pub fn has_background_of(&self, other: &Self) -> bool {
        let background = |shown: &Self| shown.global.map(|all| all.background);
        background(self) == background(other)
    }

    /// Whether both pictures are of one camera and of the same settings.
    pub fn is_seen_as(&self, other: &Self) -> bool {
        self.global.is_some() && self.global == other.global
    }

    /// Adds the tiles in which `self` differs from `before`, and the places that it differs in:
    /// what rays show that have not crossed any of these is the same. Returns `false` if anything
    /// may differ, for instance because the cameras, the lights or the render options do; then
    /// these are all tiles, and no place.
    pub fn changes(
        &self,
        before: &Self,
        projection: &Projection,
        changed: &mut TileSet,
        places: &mut Vec<BoundingSphere>,
    ) -> bool {
        if !self.is_seen_as(before) || !self.changed_objects(before, places) {
            places.clear();
            changed.add_all();
            return false;
        }
        self.changed_spheres(before, projection, changed);
        true
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

    /// Adds the places of objects that differ, at most [`MAX_PLACES`]; `false` if anything may
    /// differ.
    fn changed_objects(&self, before: &Self, places: &mut Vec<BoundingSphere>) -> bool {
        if self.options != before.options
            || self.chains != before.chains
            || self.addresses != before.addresses
            || self.ambient.as_bytes() != before.ambient.as_bytes()
            || !self.lights_as(before)
        {
            return false;
        }
        if !self.changed_mesh(before, places) {
            return false;
        }
        for (new, old) in self.objects.iter().zip(&before.objects) {
            if self.differs(new.as_ref(), before, old.as_ref()) {
                cover(new.as_ref(), old.as_ref(), places);
            }
        }
        merge_nearest::<MAX_PLACES>(places);
        true
    }

    /// Adds the places of a mesh's surfaces that differ; `false` if anything may differ.
    fn changed_mesh(&self, before: &Self, places: &mut Vec<BoundingSphere>) -> bool {
        let (new, old, camera) = match (&self.mesh, &before.mesh, &self.global) {
            (None, None, _) => return true,
            (Some(new), Some(old), Some(global)) if new.eye == old.eye => (new, old, global.camera),
            _ => return false,
        };
        if new.moved != old.moved {
            // The PPU has no new blocks to compare.
            return false;
        }
        let count = new.material_count.max(old.material_count);
        let is_textured_as = new.is_textured_as(old);
        let texture = std::mem::offset_of!(layout::Material, texture);
        let texture = texture..texture + size_of::<u32>();
        let is_other = |number: u32| {
            let material = self.material(new, number);
            let is_textured = material.get(texture.clone()).is_none_or(|it| it != [0; 4]);
            material != before.material(old, number) || (is_textured && !is_textured_as)
        };
        let any_is_other = (0..count).any(is_other);
        // Where SPUs have made the blocks, the PPU does not find the surfaces of a material.
        if !new.has_ground_of(old) || any_is_other && new.moved.is_some() {
            return false;
        }
        if Arc::ptr_eq(&new.blocks, &old.blocks) && !any_is_other {
            return true;
        }
        let eye = DVec3::from_array([0, 1, 2].map(|axis| f64::from(new.eye[axis].get())));
        let is_other = |number| any_is_other && is_other(number);
        new.blocks.changes(&old.blocks, is_other, |corners| {
            let [low, high] = corners.map(|corner| camera.eye + (corner.as_dvec3() - eye));
            let (centre, radius) = (low.midpoint(high), 0.5 * low.distance(high));
            places.push(BoundingSphere { centre, radius });
        });
        true
    }

    /// The record of a mesh's material; empty if there is none.
    fn material<'a>(&'a self, mesh: &'a MeshContent, number: u32) -> &'a [u8] {
        let size = size_of::<layout::Material>();
        match &mesh.table {
            Some(table) => table.record(number),
            None => self.record(mesh.materials + number * size as u32, size),
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

    /// Whether an object differs in place, form or appearance, or only one picture has it.
    fn differs(
        &self,
        new: Option<&VisiblePrimitive>,
        before: &Self,
        old: Option<&VisiblePrimitive>,
    ) -> bool {
        let (Some(new), Some(old)) = (new, old) else {
            return new.is_some() || old.is_some();
        };
        let (address, size) = new.record;
        let material = size_of::<layout::Material>();
        new.record != old.record
            || !same_form(self.record(address, size), before.record(address, size))
            || self.record(new.material, material) != before.record(old.material, material)
    }
}

/// Adds the places of an object that has changed: one if it has moved little for its size.
fn cover(
    new: Option<&VisiblePrimitive>,
    old: Option<&VisiblePrimitive>,
    places: &mut Vec<BoundingSphere>,
) {
    if let (Some(new), Some(old)) = (new, old) {
        let around = new.sphere.with(&old.sphere);
        let is_round = new.ends.is_none() && old.ends.is_none();
        if is_round && around.radius < 1.5 * new.sphere.radius.max(old.sphere.radius) {
            return places.push(around);
        }
    }
    let both = new.into_iter().chain(old);
    both.for_each(|seen| seen.cover(places));
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
