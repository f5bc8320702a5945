//! The vertices of a mesh that has moved, from which SPUs refit its blocks.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::{DVec3, Vec3};
use protocol::layout::{MAX_SIDE, MeshVertex, TILE_HEIGHT, TILE_WIDTH};
use scenes::Mesh;
use zerocopy::FromZeros as _;
use zerocopy::big_endian::F32;

use super::MeshBlocks;
use super::normal::packed;
use super::tree::Bounds;
use super::write::coordinate;

/// The most blocks of a mesh that SPUs refit: a frame has no more work units.
const MOST_BLOCKS: u32 = MAX_SIDE / TILE_WIDTH * (MAX_SIDE / TILE_HEIGHT);

static VERSIONS: AtomicU64 = AtomicU64::new(1);

/// As many vertices or triangles as fill a line.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(128))]
pub(super) struct Line<T>(pub [T; 8]);

/// New vertices of a mesh. An engine that renders the scene has its SPUs refit the blocks.
#[derive(Debug, Default)]
pub struct MovedVertices {
    lines: Vec<Line<MeshVertex>>,
    count: u32,
    version: u64,
    /// The cost of the blocks with these vertices.
    cost: OnceLock<f64>,
}

impl MovedVertices {
    /// The most vertices.
    pub(super) const MOST: usize = 1 << 24;

    /// Writes the vertices of a mesh, and returns the box around them. `None` if those with a
    /// normal of 0 are not these. In memory for as many vertices nothing is allocated.
    pub(super) fn write(&mut self, mesh: &Mesh, flat: &[u32]) -> Option<Bounds> {
        let vertices = &mesh.positions;
        let count = vertices.len().div_ceil(8);
        self.lines.clear();
        if self.lines.capacity() < count {
            self.lines = memory(count);
        }
        self.count = vertices.len() as u32;
        self.are_others();
        self.cost = OnceLock::new();
        let mut around = Bounds::EMPTY;
        let mut flat = flat.iter();
        for (line, positions) in vertices.chunks(8).enumerate() {
            let mut records = [MeshVertex::new_zeroed(); 8];
            for (index, &position) in positions.iter().enumerate() {
                let point = Vec3::from(position);
                around = around.with(Bounds { low: point, high: point });
                records[index].position = position.map(coordinate);
                let vertex = 8 * line + index;
                let Some(&normal) = mesh.normals.get(vertex) else { continue };
                let normal = Vec3::from(normal).as_dvec3();
                if normal != DVec3::ZERO {
                    records[index].normal = packed(normal).into();
                } else if flat.next() != Some(&(vertex as u32)) {
                    return None;
                }
            }
            self.lines.push(Line(records));
        }
        flat.next().is_none().then_some(around)
    }

    /// The position of a vertex, or the first three words of a record's quadword.
    pub(super) fn position(&self, vertex: u32) -> [f32; 3] {
        let vertex = vertex as usize;
        self.lines[vertex / 8].0[vertex % 8].position.map(F32::get)
    }

    /// Vertices for these quadwords of records.
    pub(super) fn of_records(records: &[MeshVertex]) -> Self {
        let mut lines = memory(records.len().div_ceil(8));
        for chunk in records.chunks(8) {
            let mut line = [MeshVertex::new_zeroed(); 8];
            line[..chunk.len()].copy_from_slice(chunk);
            lines.push(Line(line));
        }
        let mut vertices = Self { lines, count: records.len() as u32, ..Self::default() };
        vertices.are_others();
        vertices
    }

    /// A quadword of a record.
    pub(super) fn record(&self, at: u32) -> &MeshVertex {
        &self.lines[at as usize / 8].0[at as usize % 8]
    }

    /// Replaces the quadwords of a record. Call [`MovedVertices::are_others`] after the last one.
    #[inline]
    pub(super) fn put_record<const QUADWORDS: usize>(
        &mut self,
        first: u32,
        record: &[MeshVertex; QUADWORDS],
    ) {
        self.quadwords()[first as usize..][..QUADWORDS].copy_from_slice(record);
    }

    /// The quadwords of all records.
    #[inline]
    fn quadwords(&mut self) -> &mut [MeshVertex] {
        let (first, count) = (self.lines.as_mut_ptr(), 8 * self.lines.len());
        // SAFETY: a line is eight quadwords without padding, and the lines are lent out.
        unsafe { std::slice::from_raw_parts_mut(first.cast(), count) }
    }

    /// Gives them another version.
    pub(super) fn are_others(&mut self) {
        self.version = VERSIONS.fetch_add(1, Ordering::Relaxed);
    }

    /// A number that no other vertices of this process have.
    pub(crate) fn version(&self) -> u64 {
        self.version
    }

    /// The address of the first `MESH_VERTEX`. All have the same upper word in their addresses.
    pub(crate) fn address(&self) -> u64 {
        self.lines.as_ptr().expose_provenance() as u64
    }

    pub(crate) fn count(&self) -> u32 {
        self.count
    }

    /// Notes the cost of the refitted blocks, as [`MeshBlocks::refit_inner`] returns it.
    pub(crate) fn set_cost(&self, cost: f64) {
        // Every engine finds the same.
        let _ = self.cost.set(cost);
    }
}

/// Empty memory for lines, all in one segment of 4 GB: the elements of a DMA list share the upper
/// word of their addresses.
pub(super) fn memory<T>(lines: usize) -> Vec<Line<T>> {
    let memory: Vec<Line<T>> = Vec::with_capacity(lines);
    let first = memory.as_ptr().addr();
    let last = first + memory.capacity() * size_of::<Line<T>>() - 1;
    // As long as this memory is kept, other memory is elsewhere.
    if first as u64 >> 32 == last as u64 >> 32 { memory } else { self::memory(lines) }
}

impl MeshBlocks {
    /// Writes the vertices of the same triangles with other positions and normals for SPUs. Returns
    /// the corners of the box around the triangles. In memory for as many vertices nothing is
    /// allocated.
    ///
    /// `None` if the PPU must look at the triangles: the mesh has other vertices or, at one of
    /// them, a normal that it had not or no longer has, the blocks have spheres or cones, too, or
    /// there are too many.
    pub(crate) fn move_vertices(
        &self,
        mesh: &Mesh,
        moved: &mut MovedVertices,
    ) -> Option<[DVec3; 2]> {
        let vertices = &mesh.positions;
        if self.vertices != vertices.len()
            || self.statistics.spheres + self.statistics.cones > 0
            || self.count() > MOST_BLOCKS
            || vertices.len() > MovedVertices::MOST
        {
            return None;
        }
        let around = moved.write(mesh, &self.flat)?;
        match self.uses_all {
            true => Some([around.low, around.high].map(|corner| mesh.origin + corner.as_dvec3())),
            false => mesh.bounds().map(|(low, high)| [low, high]),
        }
    }

    /// [`MeshBlocks::wear`] with these vertices; `None` before an engine's SPUs have refitted the
    /// blocks.
    pub(crate) fn wear_of(&self, moved: &MovedVertices) -> Option<f64> {
        moved.cost.get().map(|cost| cost / self.cost_when_built)
    }
}
