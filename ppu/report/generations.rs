//! The rays of a run by generation, with what each of them costs.

use std::fmt;

use serde::Serialize;

use super::BlockReport;
use crate::statistics::{GENERATIONS, Generation, PACKET_RAYS};

/// The names of the generations, in the order of the SPUs' statistics.
const NAMES: [&str; GENERATIONS] = [
    "eye rays",
    "shadow rays of eye rays",
    "second rays",
    "shadow rays of second rays",
    "later rays",
    "shadow rays of later rays",
];

/// The rays of one generation over all frames. Only Whitted's model has generations. A batch of
/// rays counts as its first ray's generation.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct GenerationReport {
    /// Which rays these are: from the eye, sent on by a surface that an eye ray has hit, or later.
    pub name: &'static str,
    /// Number of rays.
    pub rays: u64,
    /// Number of packets that these rays filled, some of them only in part.
    pub packets: u64,
    /// Of these, the ones whose rays were themselves tested with nodes, because they were
    /// scattered; those of other packets were tested by their cone.
    pub packets_scattered: u64,
    /// Tests of nodes, for each of the rays.
    pub nodes_a_ray: f64,
    /// Tests of objects, for each of the rays.
    pub tests_a_ray: f64,
    /// Blocks of meshes in main memory.
    pub blocks: BlockReport,
    #[serde(skip)]
    sum: Generation,
}

impl GenerationReport {
    /// The generations, without rays.
    pub(super) fn all() -> [Self; GENERATIONS] {
        NAMES.map(|name| Self { name, ..Self::default() })
    }

    /// Adds an SPU's counts.
    pub(super) fn add(&mut self, generation: &Generation, timebase: f64) {
        self.sum += *generation;
        self.blocks.add(generation.blocks, timebase);
    }

    /// Computes the quotients from the sums. `seconds` is the time of all SPUs.
    pub(super) fn share(&mut self, seconds: f64) {
        let Generation { rays, packets, packets_scattered, nodes, tests, .. } = self.sum;
        let a_ray = |packets: u64| (packets * PACKET_RAYS) as f64 / rays.max(1) as f64;
        (self.rays, self.packets) = (rays, packets);
        self.packets_scattered = packets_scattered;
        (self.nodes_a_ray, self.tests_a_ray) = (a_ray(nodes), a_ray(tests));
        self.blocks.share(rays, seconds);
    }
}

impl fmt::Display for GenerationReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, rays, .. } = self;
        let scattered = 100.0 * self.packets_scattered as f64 / self.packets.max(1) as f64;
        write!(
            f,
            "{name}: {rays}, each tested with {:.1} nodes and {:.1} objects; {scattered:.0} % scattered",
            self.nodes_a_ray, self.tests_a_ray
        )?;
        if self.blocks.used > 0 {
            write!(f, "; {}", self.blocks)?;
        }
        Ok(())
    }
}
