//! A mesh whose blocks the SPUs refit before they trace a frame.

use std::sync::Arc;

use protocol::layout::{
    self, BuildBounds, FEATURE_BUILD, Frame, MAGIC, MAX_SIDE, MESH_BLOCK, SPLIT_UNITS, VERSION,
};
use zerocopy::{FromZeros as _, IntoBytes as _};

use crate::scene::mesh::{MeshBlocks, MovedVertices};
use crate::shared::SharedMemory;

/// The records of a mesh that is refitted, and its new blocks.
pub(super) struct Build {
    /// The blocks as they were built.
    blocks: Arc<MeshBlocks>,
    /// The vertices that the SPUs are to refit the blocks with.
    moved: Option<Arc<MovedVertices>>,
    /// The version of those that the new blocks have.
    version: Option<u64>,
    /// A buffer for the bounds of all blocks.
    around: Vec<BuildBounds>,
    record: SharedMemory,
    units: SharedMemory,
    unit_count: u32,
    sources: SharedMemory,
    source_count: u32,
    bounds: SharedMemory,
    new_blocks: SharedMemory,
}

impl Build {
    /// Allocates memory for refitting a mesh by this number of SPUs.
    pub fn new(blocks: &Arc<MeshBlocks>, spus: u32) -> Self {
        let (units, sources) = blocks.units(spus);
        let count = blocks.count() as usize;
        let shared = |bytes: &[u8]| {
            let mut memory = SharedMemory::new(bytes.len());
            memory.write(0, bytes);
            memory
        };
        Self {
            blocks: blocks.clone(),
            moved: None,
            version: None,
            around: vec![BuildBounds::new_zeroed(); count],
            record: SharedMemory::new(size_of::<layout::Build>()),
            units: shared(units.as_bytes()),
            unit_count: units.len() as u32,
            sources: shared(sources.as_bytes()),
            source_count: sources.len() as u32,
            bounds: SharedMemory::new(count * size_of::<BuildBounds>()),
            new_blocks: SharedMemory::new(count * MESH_BLOCK as usize),
        }
    }

    /// Whether its memory is for these blocks.
    pub fn is_of(&self, blocks: &Arc<MeshBlocks>) -> bool {
        Arc::ptr_eq(&self.blocks, blocks)
    }

    /// Whether the new blocks have these vertices.
    pub fn has(&self, moved: &MovedVertices) -> bool {
        self.version == Some(moved.version())
    }

    /// The address of the first new block.
    pub fn address(&self) -> u64 {
        self.new_blocks.address()
    }

    /// Copies the bytes of the new blocks.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = vec![0; self.blocks.count() as usize * MESH_BLOCK as usize];
        self.new_blocks.read(0, &mut bytes);
        bytes
    }

    /// Writes its record, and describes the frame in which the SPUs refit the leaf blocks. Its
    /// number, its SPUs, its code and the addresses of the engine's own records are left to set.
    pub fn describe(&mut self, moved: &Arc<MovedVertices>) -> Frame {
        self.moved = Some(moved.clone());
        self.version = None;
        let record = layout::Build {
            blocks: self.new_blocks.address().into(),
            vertices: moved.address().into(),
            sources: self.sources.address().into(),
            bounds: self.bounds.address().into(),
            vertex_count: moved.count().into(),
            source_count: self.source_count.into(),
            ..layout::Build::new_zeroed()
        };
        self.record.write(0, record.as_bytes());
        Frame {
            units: self.units.address().into(),
            unit_count: self.unit_count.into(),
            scene: self.record.address().into(),
            mesh: self.blocks.address().into(),
            mesh_blocks: self.blocks.count().into(),
            ..describe()
        }
    }

    /// Refits the inner blocks, after the SPUs have refitted the leaves.
    pub fn finish(&mut self) {
        let Some(moved) = self.moved.take() else { return };
        self.bounds.read(0, self.around.as_mut_bytes());
        let new_blocks = &mut self.new_blocks;
        let cost = self.blocks.refit_inner(&mut self.around, |number, block| {
            new_blocks.write(number * MESH_BLOCK as usize, block);
        });
        moved.set_cost(cost);
        self.version = Some(moved.version());
    }
}

/// A frame in which the SPUs refit or build a mesh, without its addresses.
pub(super) fn describe() -> Frame {
    Frame {
        magic: MAGIC.into(),
        version: VERSION.into(),
        size: (size_of::<Frame>() as u32).into(),
        features: FEATURE_BUILD.into(),
        split: SPLIT_UNITS.into(),
        // The largest picture has space for the most units; nothing is drawn.
        width: MAX_SIDE.into(),
        height: MAX_SIDE.into(),
        stride: (MAX_SIDE * size_of::<u32>() as u32).into(),
        green_shift: 8.into(),
        blue_shift: 16.into(),
        samples: 1.into(),
        ..Frame::new_zeroed()
    }
}
