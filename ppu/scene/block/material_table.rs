//! The materials of a mesh in main memory, for scenes that have too many for local store.

use protocol::layout::{MATERIAL_STRIDE, MESH_MATERIALS, Material};
use zerocopy::IntoBytes as _;

/// A material's record, aligned as its DMA transfer needs it.
#[derive(Clone, Copy)]
#[repr(C, align(128))]
struct Line([u8; MATERIAL_STRIDE as usize]);

impl Line {
    const BLACK: Self = Self([0; MATERIAL_STRIDE as usize]);

    fn put(&mut self, record: &Material) {
        let record = record.as_bytes();
        self.0[..record.len()].copy_from_slice(record);
    }
}

/// The records of a mesh's materials, in the order of their numbers in blocks.
///
/// Invariant: there is one for every number whose upper byte is that of a material's number, so
/// that an SPU need not check the last byte. Those that nothing has are black.
#[derive(Clone)]
pub struct MaterialTable(Vec<Line>);

impl MaterialTable {
    /// The table of these records.
    pub(super) fn new(records: &[Material]) -> Self {
        let count = records.len().next_multiple_of(MESH_MATERIALS as usize);
        let mut lines = vec![Line::BLACK; count];
        for (line, record) in lines.iter_mut().zip(records) {
            line.put(record);
        }
        Self(lines)
    }

    /// Replaces a record.
    pub(super) fn set(&mut self, number: usize, record: &Material) {
        self.0[number].put(record);
    }

    /// The bytes of a material's record; empty if there is none.
    #[must_use]
    pub fn record(&self, number: u32) -> &[u8] {
        let line = self.0.get(number as usize);
        line.map_or(&[], |line| &line.0[..size_of::<Material>()])
    }

    /// The number of records.
    #[must_use]
    pub fn count(&self) -> u32 {
        self.0.len() as u32
    }

    /// The bytes of all records. SPUs read them by their address.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        let start = self.0.as_ptr().cast::<u8>();
        // SAFETY: the lines are arrays of bytes, without padding, one after another: their size is
        // a multiple of their alignment. The slice borrows `self`, and bytes have no alignment.
        unsafe { std::slice::from_raw_parts(start, self.0.len() * MATERIAL_STRIDE as usize) }
    }

    /// The address of the first record, for SPUs.
    #[must_use]
    pub fn address(&self) -> u64 {
        self.0.as_ptr().expose_provenance() as u64
    }
}

impl std::fmt::Debug for MaterialTable {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut table = f.debug_struct("MaterialTable");
        table.field("count", &self.count()).finish_non_exhaustive()
    }
}
