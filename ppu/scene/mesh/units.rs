//! The work units by which SPUs refit the leaf blocks of a mesh.

use protocol::layout::{BUILD_LEAVES, BuildUnit, MESH_LEAF, MeshHeader};
use zerocopy::big_endian::U32;
use zerocopy::{FromBytes as _, FromZeros as _};

use super::MeshBlocks;

/// The fewest blocks of a unit, unless others are between them: an SPU works on three at a time.
const FEWEST: usize = 4;

impl MeshBlocks {
    /// The units, of which each SPU gets about four if there are `spus`, and the words that list
    /// the leaf blocks' vertices.
    pub(crate) fn units(&self, spus: u32) -> (Vec<BuildUnit>, Vec<U32>) {
        let most = self.statistics.leaves.div_ceil(4 * spus as usize);
        let most = most.clamp(FEWEST, BUILD_LEAVES as usize) as u32;
        let mut units: Vec<BuildUnit> = Vec::new();
        let mut words: Vec<U32> = Vec::new();
        let mut rest = &self.sources[..];
        for (number, block) in self.blocks.iter().enumerate() {
            let Ok((header, _)) = MeshHeader::ref_from_prefix(&block.0) else { continue };
            if header.kind.get() != MESH_LEAF {
                continue;
            }
            let (own, others) = rest.split_at(header.vertices.get() as usize);
            rest = others;
            let first = words.len();
            words.push(U32::ZERO);
            for run in own.chunk_by(|vertex, next| vertex + 1 == *next) {
                words.push(((run.len() as u32) << 24 | run[0]).into());
            }
            words[first] = ((words.len() - first - 1) as u32).into();
            words.resize(words.len().next_multiple_of(4), U32::ZERO);
            let number = number as u32;
            let follows = |unit: &&mut BuildUnit| {
                let count = unit.count.get();
                count < most && unit.first.get() + count == number
            };
            let unit = match units.last_mut().filter(follows) {
                Some(unit) => unit,
                None => {
                    let source = (first as u32).into();
                    units.push(BuildUnit {
                        first: number.into(),
                        source,
                        ..BuildUnit::new_zeroed()
                    });
                    let last = units.len() - 1;
                    &mut units[last]
                }
            };
            unit.count += 1;
            unit.source_count += (words.len() - first) as u32;
        }
        (units, words)
    }
}
