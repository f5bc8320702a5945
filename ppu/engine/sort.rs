//! A mesh whose leaf blocks the SPUs make of its triangles, or of spheres and cones, before they
//! trace a frame.

use std::sync::Arc;

use protocol::layout::{self, BUILD_SORT, BuildBounds, BuildTriangle, Frame, MESH_BLOCK};
use zerocopy::big_endian::U32;
use zerocopy::{FromZeros as _, IntoBytes as _};

use super::build::describe;
use crate::scene::mesh::SortedMesh;
use crate::shared::SharedMemory;

/// The records of a mesh that is built, and its blocks.
pub(super) struct Sort {
    /// The mesh, until its blocks are made.
    mesh: Option<Arc<SortedMesh>>,
    /// The maximum number of blocks of the mesh.
    blocks: u32,
    /// Whether the SPUs have sorted the chunks of its triangles.
    is_sorted: bool,
    /// A buffer for the bounds of all blocks.
    around: Vec<BuildBounds>,
    record: SharedMemory,
    units: SharedMemory,
    sources: SharedMemory,
    sorted: SharedMemory,
    bounds: SharedMemory,
    new_blocks: SharedMemory,
    /// The version of the vertices that the blocks have.
    version: Option<u64>,
}

impl Sort {
    /// Takes a mesh with this maximum number of blocks. The memory of the one before it is used
    /// again if it is large enough.
    pub fn new(before: Option<Self>, mesh: &Arc<SortedMesh>, blocks: u32) -> Self {
        let bytes = |count: u32, size: usize| count as usize * size;
        let sorted = bytes(mesh.count(), size_of::<BuildTriangle>());
        let bounds = bytes(blocks, size_of::<BuildBounds>());
        let new_blocks = bytes(blocks, MESH_BLOCK as usize);
        let mut sort = before.unwrap_or_else(|| Self {
            mesh: None,
            blocks,
            is_sorted: false,
            around: Vec::new(),
            record: SharedMemory::new(size_of::<layout::Build>()),
            units: SharedMemory::new(0),
            sources: SharedMemory::new(0),
            sorted: SharedMemory::new(0),
            bounds: SharedMemory::new(0),
            new_blocks: SharedMemory::new(0),
            version: None,
        });
        if !sort.mesh.as_ref().is_some_and(|it| Arc::ptr_eq(it, mesh)) {
            // An error may have ended the frames for the mesh before.
            sort.is_sorted = false;
        }
        sort.mesh = Some(mesh.clone());
        sort.blocks = blocks;
        sort.sorted.reserve(sorted);
        sort.bounds.reserve(bounds);
        sort.new_blocks.reserve(new_blocks);
        sort.around.resize_with(blocks as usize, BuildBounds::new_zeroed);
        sort
    }

    /// Whether the blocks are those of this mesh.
    pub fn has(&self, mesh: &SortedMesh) -> bool {
        self.version == Some(mesh.version())
    }

    /// The address of the first block.
    pub fn address(&self) -> u64 {
        self.new_blocks.address()
    }

    /// Copies the bytes of all blocks.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = vec![0; self.blocks as usize * MESH_BLOCK as usize];
        self.new_blocks.read(0, &mut bytes);
        bytes
    }

    /// Writes its record, and describes the next frame that the SPUs need for the blocks. After the
    /// first one they sort chunks of triangles, after the second one they pack them into blocks.
    pub fn describe(&mut self) -> Option<Frame> {
        self.version = None;
        let mesh = self.mesh.as_ref()?;
        let count = mesh.count();
        let (task, (units, words)) = match self.is_sorted {
            false => (BUILD_SORT, (mesh.chunks(), Vec::new())),
            true => {
                let code = |at| self.sorted.peek_word(at as usize * size_of::<BuildTriangle>());
                (mesh.pack_task(), mesh.ranges(code))
            }
        };
        let grid = mesh.grid();
        let record = layout::Build {
            blocks: self.new_blocks.address().into(),
            vertices: mesh.vertices().address().into(),
            sources: self.sources.put(words.as_bytes()).into(),
            bounds: self.bounds.address().into(),
            vertex_count: mesh.vertices().count().into(),
            source_count: (words.len() as u32).into(),
            task: task.into(),
            triangle_count: count.into(),
            triangles: mesh.address().into(),
            sorted: self.sorted.address().into(),
            low: grid.low.map(U32::new),
            scale: grid.scale.into(),
            shift: grid.shift.into(),
            ..layout::Build::new_zeroed()
        };
        self.record.write(0, record.as_bytes());
        if self.is_sorted {
            // SPUs write 0 where they make a block.
            self.around.iter_mut().for_each(|bounds| bounds.unused = 1.into());
            self.bounds.write(0, self.around.as_bytes());
        }
        Some(Frame {
            units: self.units.put(units.as_bytes()).into(),
            unit_count: (units.len() as u32).into(),
            scene: self.record.address().into(),
            mesh_blocks: self.blocks.into(),
            ..describe()
        })
    }

    /// Goes on after a frame: makes the blocks above the leaves after the second one.
    pub fn finish(&mut self) {
        self.is_sorted = !self.is_sorted;
        if self.is_sorted {
            return;
        }
        let Some(mesh) = self.mesh.take() else { return };
        self.bounds.read(0, self.around.as_mut_bytes());
        let new_blocks = &mut self.new_blocks;
        mesh.join_made(&self.around, |number, block| {
            new_blocks.write(number * MESH_BLOCK as usize, block);
        });
        self.version = Some(mesh.version());
    }
}
