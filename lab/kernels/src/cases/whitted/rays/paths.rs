//! The kernels that keep what rays have crossed, and find out whether something has changed there.

use twins::bound::{Bound, bound};
use twins::paths::{Path, meet, path};
use twins::primary_rays::Ray;

use super::bounds::any_fan;
use super::call::{ANYTHING, put_bounds, put_packets};
use super::nodes::{BareSphere, Child, Volume as _};
use crate::prelude::*;
use protocol::layout::{Node, Site};

/// The bytes of a tile's sums.
const SUMS: u32 = 16384;

/// Packets of rays with their bounds.
#[derive(Clone, Debug)]
pub struct PathBounds {
    /// The packets.
    pub packets: Vec<[Ray; 16]>,
    /// Their bounds.
    pub bounds: Vec<Bound>,
    /// Whether the rays end at their t.
    pub to_hits: bool,
    /// The address of the tile's first sum.
    pub sums: u32,
    /// Whether the paths go to the bounds' own place.
    pub in_place: bool,
}

impl PathBounds {
    /// Packets within their bounds.
    #[must_use]
    pub fn of(packets: Vec<[Ray; 16]>, to_hits: bool) -> Self {
        let bounds = packets.iter().map(bound).collect();
        Self { packets, bounds, to_hits, sums: 0, in_place: false }
    }

    fn mixed(self, random: &mut ChaCha8Rng) -> Self {
        Self { to_hits: random.random(), in_place: random.random(), sums: random.random(), ..self }
    }
}

impl Description for PathBounds {
    const KERNEL: &'static str = "path_bounds_r16";
    const ROUNDS: [usize; 2] = [40, 1000];
    const LENGTHS: &'static [usize] = &[4, 5, 7, 8, 16];
    type Placed = Place;
    type Found = Vec<Path>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let paths = Self::of((0..count).map(|_| any_fan(random)).collect(), false).mixed(random);
        let mut packets = paths.packets;
        for ray in packets.as_flattened_mut() {
            ray.pixel = paths.sums.wrapping_add(random.random_range(0..SUMS / 16) * 16);
        }
        Self { packets, ..paths }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let packets = (0..count).map(|_| any_bits(random)).collect();
        let bounds = (0..count).map(|_| any_bits(random)).collect();
        Self { packets, bounds, ..Self::of(Vec::new(), false) }.mixed(random)
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let rays = put_packets(bench, &self.packets);
        let bounds = put_bounds(bench, &self.bounds);
        let site = |number| Site {
            surfaces: ANYTHING.into(),
            rays: address::<RayPacket>(rays, number).into(),
            shines: ANYTHING.into(),
            shadow: ANYTHING.into(),
        };
        let count = self.packets.len();
        let sites: Vec<Site> = (0..count).map(site).collect();
        let sites = put(bench, &sites).address;
        let paths = match self.in_place {
            true => bounds.first(count * size_of::<layout::Path>()),
            false => put(bench, &vec![layout::Path::new_zeroed(); count]),
        };
        let to_hits = if self.to_hits { u32::MAX } else { 0 };
        let [rays, at] = [rays.address, bounds.address];
        (paths, vec![rays, count as u32, at, sites, to_hits, paths.address, self.sums])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Vec<Path> {
        let record = |path: layout::Path| {
            assert_eq!(path.reserved.get(), 0, "the word after a path");
            Path {
                bound: Bound {
                    apex: path.apex.map(bits),
                    axis: path.axis.map(bits),
                    cosine: bits(path.cosine),
                    sine: bits(path.sine),
                    radius: bits(path.radius),
                    farthest: bits(path.farthest),
                },
                subtiles: path.subtiles.get(),
            }
        };
        bench.read_all(*placed).into_iter().map(record).collect()
    }

    fn twin(&self, _: &Place) -> Vec<Path> {
        let packets = self.packets.iter().zip(&self.bounds);
        packets
            .map(|(rays, bound)| {
                path(rays, bound, &rays.map(|ray| ray.pixel), self.to_hits, self.sums)
            })
            .collect()
    }
}

/// Paths, and nodes of spheres.
#[derive(Clone, Debug)]
pub struct PathsMeet {
    /// The paths.
    pub paths: Vec<Path>,
    /// The nodes.
    pub nodes: Vec<[Child<BareSphere>; 4]>,
}

impl Description for PathsMeet {
    const KERNEL: &'static str = "paths_meet";
    const ROUNDS: [usize; 2] = [100, 1000];
    const LENGTHS: &'static [usize] = &[8, 9, 11, 40];
    const SHARES: [Range<f64>; 2] = [0.02..0.98, ANY_SHARE];
    type Placed = ();
    type Found = u32;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let path = |random: &mut ChaCha8Rng| {
            let rays = any_fan(random);
            let farthest = from_f64(magnitude(0.1..100.0, random));
            let subtiles = 1 << random.random_range(0..32);
            Path { bound: Bound { farthest, ..bound(&rays) }, subtiles }
        };
        let paths = (0..count).map(|_| path(random)).collect();
        let nodes = random.random_range(1..3);
        Self { paths, nodes: (0..nodes).map(|_| [(); 4].map(|()| Child::around(random))).collect() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let paths = (0..count).map(|_| any_bits(random)).collect();
        let child = |random: &mut ChaCha8Rng| Child { volume: any_bits(random), address: 0 };
        Self { paths, nodes: vec![[(); 4].map(|()| child(random))] }
    }

    fn place(&self, bench: &mut Bench) -> ((), Vec<u32>) {
        let record = |path: &Path| layout::Path {
            apex: path.bound.apex.map(single),
            radius: single(path.bound.radius),
            axis: path.bound.axis.map(single),
            cosine: single(path.bound.cosine),
            sine: single(path.bound.sine),
            farthest: single(path.bound.farthest),
            subtiles: path.subtiles.into(),
            reserved: ANYTHING.into(),
        };
        let paths: Vec<layout::Path> = self.paths.iter().map(record).collect();
        let nodes: Vec<Node> = self.nodes.iter().map(BareSphere::node).collect();
        let [paths, nodes] = [put(bench, &paths).address, put(bench, &nodes).address];
        ((), vec![paths, self.paths.len() as u32, nodes, self.nodes.len() as u32])
    }

    fn found(&self, _: &Bench, (): &(), subtiles: u32) -> u32 {
        subtiles
    }

    fn twin(&self, (): &()) -> u32 {
        let volumes = self.nodes.as_flattened().iter().map(|child| child.volume);
        let spheres: Vec<_> = volumes.map(|sphere| (sphere.centre, sphere.radius)).collect();
        meet(&self.paths, &spheres)
    }

    /// How many subtiles are met.
    fn part(&self, found: &u32) -> [usize; 2] {
        let all = self.paths.iter().fold(0, |subtiles, path| subtiles | path.subtiles);
        [found.count_ones() as usize, (all.count_ones() as usize).max(1)]
    }
}
