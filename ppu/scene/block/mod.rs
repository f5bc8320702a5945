//! The scene of Whitted's model in the SPUs' format: one block of records, at `SCENE_ADDRESS` of
//! every local store.
//!
//! All addresses, the materials and the trees are determined once, when the scene is loaded. For
//! each eye only the records with positions are written again. Positions are relative to the eye,
//! computed in `f64` and rounded once, so a scene far from its origin loses no precision near the
//! eye. The block begins with the background's object, for rays that hit nothing.
//!
//! The block of a scene that changes has spare capacity, and is edited in place.
//!
//! Invariant: a block fits the local store together with the queue of rays, and all addresses in
//! it are within it. The order of the file is not kept: a ray that hits several surfaces at equal
//! distance may take any of them.

mod alike;
mod bounding_sphere;
mod bounds;
mod build;
mod bvh;
mod bytes;
mod chains;
mod cost;
mod edit;
mod error;
mod found;
mod material_table;
mod materials;
mod memory_use;
mod objects;
mod offsets;
mod polygons;
mod primitive;
mod primitives;
mod shaders;
mod source_location;
mod streamed;
mod visible;

use std::collections::HashSet;
use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;
use scenes::Texture;
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::F32;

use self::bvh::Volumes;
use self::bytes::Block;
use self::chains::{Sends, largest_channel};
use self::memory_use::{MemoryUse, capacity, large_batch_bytes, queue_bytes};
use self::primitive::PrimitiveId;
use self::primitives::Primitives;
use self::source_location::SourceLocation;
use self::streamed::Streamed;
use crate::scene::render_options::RenderOptions;
use protocol::layout::{self, BVH_TRIANGLES, Bvh, LARGE_OBJECTS, MAX_BATCH, SMALL_BATCH};

pub(crate) use bounding_sphere::{BoundingSphere, enclose_groups, merge_nearest};
pub(crate) use bvh::{LANES, change_nodes};
pub(crate) use chains::Chains;
pub use error::BlockError;
pub use material_table::MaterialTable;
pub(crate) use materials::Light;
pub(crate) use offsets::offset_note;
pub(crate) use shaders::ShaderEntries;
pub use streamed::MeshPlace;
pub(crate) use visible::VisiblePrimitive;

/// A scene's block of records. Its buffers are reused for every eye.
#[derive(Clone, Debug)]
pub struct SceneBlock {
    file: String,
    options: RenderOptions,
    /// The largest channel of the background's light.
    background: f64,
    ambient: [F32; 4],
    fog: [F32; 4],
    lights: Vec<Light>,
    light_address: u32,
    /// The materials by their numbers in the scene; `None` for materials that no object has.
    materials: Vec<Option<Surface>>,
    /// Addresses of unused records of materials.
    spare_materials: Vec<u32>,
    primitives: [Primitives; 4],
    /// For each object, by its number in the scene, the range of its primitives in `parts`.
    objects: Vec<Range<usize>>,
    parts: Vec<PrimitiveId>,
    chains: Chains,
    /// The mesh, if it is in main memory.
    streamed: Option<Streamed>,
    block: Block,
    /// The eye that the block is written for.
    eye: Option<DVec3>,
    /// The eye that the objects are made for: spheres that are seen from both sides are two if it
    /// is on their surface.
    objects_eye: DVec3,
}

/// A material in the block.
#[derive(Clone, Debug)]
struct Surface {
    /// The address of its record; `None` if it is only in main memory.
    address: Option<u32>,
    /// Whether other materials of the scene have the same record.
    is_shared: bool,
    sends: Sends,
    texture: Option<Arc<Texture>>,
}

impl SceneBlock {
    /// Writes the block for an eye: only the changes if the eye is the last one, otherwise all
    /// records with positions.
    ///
    /// # Errors
    /// The eye is out of range; the block stays as it was.
    pub fn write_for(&mut self, eye: DVec3) -> Result<(), BlockError> {
        let place = SourceLocation { file: &self.file, line: None };
        place.vector("eye", eye)?;
        let is_other_eye = self.eye.replace(eye) != Some(eye);
        for primitives in &mut self.primitives {
            primitives.write(eye, is_other_eye, &mut self.block);
        }
        if let Some(heights) = self.streamed.as_mut().and_then(|it| it.heights.as_mut()) {
            let RenderOptions { shadows, cuts, shades, .. } = self.options;
            let mut suns = (0..).zip(&self.lights).filter_map(|(number, light)| {
                let to_light = light.far_away()?;
                Some((number, to_light))
            });
            heights.look(eye, suns.next().filter(|_| shadows && cuts && shades));
        }
        let leave = self.primitives.iter().map(Primitives::leave);
        let streamed = self.streamed.as_ref();
        let leave = leave.chain(streamed.map(|streamed| streamed.leave(eye)));
        let leave = leave.fold(0.0, f64::max);
        let size = size_of::<layout::Light>();
        let places = (self.light_address..).step_by(size);
        for (address, light) in places.zip(&self.lights) {
            let record = light.record(eye, leave);
            self.block.at(address, size).copy_from_slice(record.as_bytes());
        }
        Ok(())
    }

    /// The block's bytes, in whole lines, as they are copied to local store.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.block.bytes()
    }

    /// The BVHs of spheres, parallelograms, triangles and cones.
    #[must_use]
    pub fn bvhs(&self) -> [Bvh; 4] {
        self.primitives.each_ref().map(Primitives::record)
    }

    /// The trees whose nodes are boxes, as the frame has them. With any, the block has space for
    /// the code that tests boxes, at `BOX_CODE`.
    #[must_use]
    pub fn box_trees(&self) -> u32 {
        let trees = (0..).zip(&self.primitives);
        let bits = trees.map(|(tree, primitives)| match primitives.volumes() {
            Volumes::Spheres => 0,
            Volumes::Boxes => 1 << tree,
        });
        bits.sum()
    }

    /// The ambient light's brightness: red, green, blue, and 0.
    #[must_use]
    pub fn ambient(&self) -> [F32; 4] {
        self.ambient
    }

    /// The fog as a frame has it.
    pub(crate) fn fog(&self) -> [F32; 4] {
        self.fog
    }

    /// The local-store address of the first light.
    #[must_use]
    pub fn light_address(&self) -> u32 {
        self.light_address
    }

    /// The number of lights.
    #[must_use]
    pub fn light_count(&self) -> u32 {
        self.lights.len() as u32
    }

    /// The longest chain of rays. It is the requested ray depth, or less if the scene's materials
    /// give no longer chain enough weight.
    #[must_use]
    pub fn ray_depth(&self) -> u32 {
        self.chains.ray_depth
    }

    /// The minimum weight of a secondary ray; lighter rays are not sent.
    #[must_use]
    pub fn least_weight(&self) -> f32 {
        self.chains.least_weight
    }

    /// The number of packets in a batch: as many as fit.
    #[must_use]
    pub fn batch(&self) -> u32 {
        self.batch_at(self.ray_depth()).unwrap_or(1)
    }

    /// The number of packets in a batch that fits with chains of `ray_depth` rays.
    fn batch_at(&self, ray_depth: u32) -> Option<u32> {
        self.batch_without(0, ray_depth)
    }

    /// The same, if the block had fewer bytes.
    fn batch_without(&self, bytes: usize, ray_depth: u32) -> Option<u32> {
        let fits = |batch: &u32| self.bytes().len() - bytes <= self.capacity(*batch, ray_depth);
        let counts = self.primitives.iter().map(Primitives::count);
        let may_be_large = self.streamed.is_none() && counts.max() <= Some(LARGE_OBJECTS as usize);
        // Batches between these gained nothing in the scenes that have no space for the largest.
        let large = may_be_large.then_some(MAX_BATCH);
        large.into_iter().chain((1..=SMALL_BATCH).rev()).find(fits)
    }

    /// The same, of which only the size of a small batch counts.
    fn small_batch_at(&self, ray_depth: u32) -> Option<u32> {
        self.small_batch_without(0, ray_depth)
    }

    /// The same, if the block had fewer bytes.
    fn small_batch_without(&self, bytes: usize, ray_depth: u32) -> Option<u32> {
        let batch = self.batch_without(bytes, ray_depth)?;
        Some(batch.min(SMALL_BATCH))
    }

    /// The bytes that the queue of rays, the buffers of a large batch, and a mesh's cache and code
    /// leave for the scene.
    fn capacity(&self, batch: u32, ray_depth: u32) -> usize {
        let mesh = self.streamed.as_ref().map_or(0, Streamed::minimum_size);
        let has_triangles = self.primitives[BVH_TRIANGLES as usize].count() > 0;
        let large = large_batch_bytes(batch, has_triangles);
        capacity(batch, ray_depth).saturating_sub(mesh + large)
    }

    /// The mesh that SPUs stream from main memory; `None` if the scene has none, or if it is small
    /// enough to be in local store.
    #[must_use]
    pub fn mesh(&self) -> Option<MeshPlace<'_>> {
        let streamed = self.streamed.as_ref()?;
        let queue = queue_bytes(self.batch(), self.ray_depth());
        let eye = self.eye.unwrap_or_default();
        Some(streamed.place(self.bytes().len() + queue, eye, self.options.mesh_cache))
    }

    /// Computes the bounds of the chains from the scene's materials and lights. Call it after
    /// these have changed. Returns whether there is space for the chains' rays.
    pub(crate) fn bound_chains(&mut self) -> bool {
        let lights = self.lights.iter().map(Light::brightness).sum();
        let bright = [self.background, largest_channel(&self.ambient), lights];
        let materials = self.materials.iter().flatten();
        let sends = materials.map(|surface| surface.sends);
        self.chains = Chains::of(self.options, sends, bright);
        self.batch_at(self.ray_depth()).is_some()
    }

    fn check_size(&self) -> Result<(), BlockError> {
        let (needed, capacity) = (self.bytes().len(), self.capacity(1, self.ray_depth()));
        if needed <= capacity {
            return Ok(());
        }
        let objects = self.primitives.each_ref();
        let objects = objects.map(|primitives| (primitives.count(), primitives.size()));
        let addresses = self.materials.iter().flatten();
        let addresses: HashSet<u32> = addresses.filter_map(|it| it.address).collect();
        let materials = addresses.len();
        let memory_use = MemoryUse::new(objects, materials, self.lights.len());
        Err(BlockError::TooLarge {
            file: self.file.clone(),
            needed,
            capacity,
            ray_depth: self.ray_depth(),
            consumers: memory_use.consumers(),
            fits: memory_use.fits(capacity),
        })
    }
}

#[cfg(test)]
mod tests;
