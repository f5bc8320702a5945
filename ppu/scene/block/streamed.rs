//! The part of a scene that SPUs stream from main memory: its mesh, and what of it is in local
//! store.

use std::sync::Arc;

use glam::DVec3;
use nff::Scene;
use protocol::layout::{
    MESH_BLOCK, MESH_CODE, MESH_CODE_ROOM, MESH_MOST_SLOTS, SCENE_ADDRESS, SCENE_ROOM,
};
use zerocopy::big_endian::F32;

use super::error::BlockError;
use super::objects::{LEAVE, taxicab};
use crate::scene::mesh::{MeshBlocks, RESIDENT};
use crate::scene::single::singles;

/// The fewest blocks that the cache has room for.
const LEAST_SLOTS: usize = 8;
/// The bytes that a mesh takes from the room of a scene and its queues, at least.
pub(super) const LEAST_ROOM: usize = MESH_CODE_ROOM as usize + LEAST_SLOTS * MESH_BLOCK as usize;

/// A scene's mesh in main memory.
#[derive(Clone, Debug)]
pub(super) struct Streamed {
    pub blocks: Arc<MeshBlocks>,
    /// The corners of the box around it.
    bounds: [DVec3; 2],
    /// The address of the first of its materials, which are in a row.
    pub materials: u32,
}

/// What a frame tells SPUs of a scene's mesh.
#[derive(Clone, Copy, Debug)]
pub struct MeshPlace<'a> {
    /// The blocks in main memory.
    pub blocks: &'a Arc<MeshBlocks>,
    /// The local-store address of the first material.
    pub materials: u32,
    /// The number of materials.
    pub material_count: u32,
    /// The local-store address of the cache.
    pub cache: u32,
    /// The number of blocks that the cache has room for.
    pub slots: u32,
    /// The eye in the mesh's coordinates, and 0.
    pub eye: [F32; 4],
}

impl Streamed {
    /// The blocks of a scene's mesh; `None` if it has none.
    pub fn of(scene: &Scene) -> Result<Option<Self>, BlockError> {
        let Some(mesh) = &scene.mesh else {
            return Ok(None);
        };
        let wrong = |source| BlockError::Mesh {
            file: scene.name.clone(),
            source,
        };
        let blocks = MeshBlocks::new(mesh, &scene.materials).map_err(wrong)?;
        let (low, high) = mesh.bounds().unwrap_or_default();
        Ok(Some(Self {
            blocks: Arc::new(blocks),
            bounds: [low, high],
            materials: SCENE_ADDRESS,
        }))
    }

    /// The largest origin offset of its triangles, as `Object::leave` has it for one.
    pub fn leave(&self, eye: DVec3) -> f64 {
        let [low, high] = self.bounds;
        let farthest = (low - eye).abs().max((high - eye).abs());
        LEAVE * (taxicab(farthest) + taxicab(high - low))
    }

    /// Its place beside a scene's block and queues of these sizes.
    pub fn place(&self, used: usize, eye: DVec3) -> MeshPlace<'_> {
        let room = (SCENE_ROOM - MESH_CODE_ROOM).saturating_sub(used as u32);
        let slots = (room / MESH_BLOCK).min(MESH_MOST_SLOTS);
        let [x, y, z] = singles(eye);
        MeshPlace {
            blocks: &self.blocks,
            materials: self.materials,
            material_count: self.blocks.materials().len() as u32,
            cache: MESH_CODE - slots * MESH_BLOCK,
            slots,
            eye: [x, y, z, F32::ZERO],
        }
    }
}

/// Whether a scene's mesh is small enough to be tried in local store, where it is faster.
pub(super) fn may_stay(scene: &Scene) -> bool {
    let mesh = scene.mesh.as_ref();
    mesh.is_none_or(|mesh| mesh.triangles.len() <= RESIDENT)
}
