//! The kernels that cull nodes' children, and those that test them with every ray.

use twins::bound::{Bound, bound};
use twins::primary_rays::Ray;
use twins::{cull_box_nodes, cull_nodes};
use zerocopy::Immutable;

use super::call::{listed, put_bounds, put_packets, words};
use super::fans::{self, FANS};
use crate::prelude::*;
use protocol::layout::{BoxNode, Candidate, Node};

/// The radius, and the half sizes, of a lane without a child.
const NO_CHILD: Single = FARTHEST | 1 << 31;
/// The numbers of nodes and of bounds that lists of random pairs have.
const NODES: usize = 8;
const BOUNDS: usize = 4;

/// A bounding sphere.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct BareSphere {
    /// The centre.
    pub centre: [Single; 3],
    /// The radius, including the margin for the test's rounding.
    pub radius: Single,
}

/// A box along the axes.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct BareBox {
    /// The centre.
    pub centre: [Single; 3],
    /// Half of the sizes, including the margin for the test's rounding.
    pub half: [Single; 3],
}

/// A child of a node.
#[derive(Clone, Copy, Debug)]
pub struct Child<V> {
    /// Its bounding volume.
    pub volume: V,
    /// The address of its record.
    pub address: u32,
}

/// The volumes of nodes, and the kernels and twins that test them.
pub trait Volume: Copy + FromBytes + std::fmt::Debug {
    /// The record of a node.
    type Node: IntoBytes + Immutable;
    /// The kernel that tests nodes with packets' bounds.
    const CULL: &'static str;
    /// The kernel that tests children with packets' rays.
    const FILTER: &'static str;
    /// The record of a node with these children.
    fn node(children: &[Child<Self>; 4]) -> Self::Node;
    /// The twin of the first kernel.
    fn may_meet(&self, bound: &Bound) -> bool;
    /// The twin of the second kernel.
    fn any_may_meet(&self, bound: &Bound, rays: &[Ray; 16]) -> bool;
    /// One around the eye.
    fn around(random: &mut ChaCha8Rng) -> Self;
    /// That of a lane without a child.
    fn nobody(self) -> Self;
}

impl Volume for BareSphere {
    type Node = Node;
    const CULL: &'static str = "cull_nodes";
    const FILTER: &'static str = "filter_children_r16";

    fn node(children: &[Child<Self>; 4]) -> Node {
        rows(&children.map(|Child { volume: Self { centre: [x, y, z], radius }, address }| {
            [x, y, z, radius, address]
        }))
    }

    fn may_meet(&self, bound: &Bound) -> bool {
        cull_nodes::may_meet(bound, self.centre, self.radius)
    }

    fn any_may_meet(&self, bound: &Bound, rays: &[Ray; 16]) -> bool {
        cull_nodes::any_may_meet(bound, rays, self.centre, self.radius)
    }

    fn around(random: &mut ChaCha8Rng) -> Self {
        Self {
            centre: in_cube(20.0, random).map(from_f64),
            radius: from_f64(magnitude(0.01..20.0, random)),
        }
    }

    fn nobody(self) -> Self {
        Self { radius: NO_CHILD, ..self }
    }
}

impl Volume for BareBox {
    type Node = BoxNode;
    const CULL: &'static str = "cull_box_nodes";
    const FILTER: &'static str = "filter_box_children_r16";

    fn node(children: &[Child<Self>; 4]) -> BoxNode {
        rows(&children.map(
            |Child { volume: Self { centre: [x, y, z], half: [i, j, k] }, address }| {
                [x, y, z, i, j, k, address]
            },
        ))
    }

    fn may_meet(&self, bound: &Bound) -> bool {
        cull_box_nodes::may_meet(bound, self.centre, self.half)
    }

    fn any_may_meet(&self, bound: &Bound, rays: &[Ray; 16]) -> bool {
        cull_box_nodes::any_may_meet(bound, rays, self.centre, self.half)
    }

    fn around(random: &mut ChaCha8Rng) -> Self {
        Self {
            centre: in_cube(20.0, random).map(from_f64),
            half: std::array::from_fn(|_| match random.random_range(0..5) {
                0 => 0,
                _ => from_f64(magnitude(0.1..20.0, random)),
            }),
        }
    }

    fn nobody(self) -> Self {
        Self { half: [NO_CHILD; 3], ..self }
    }
}

impl<V: Volume> Child<V> {
    /// A child around the eye, or none.
    pub fn around(random: &mut ChaCha8Rng) -> Self {
        let volume = V::around(random);
        let is_there = random.random_range(0..5) > 0;
        let volume = if is_there { volume } else { volume.nobody() };
        Self { volume, address: random.random() }
    }
}

/// The inputs of `cull_nodes`, `cull_faces`, `filter_children_r16` and those for boxes.
pub struct Candidates {
    /// The candidates.
    pub given: Vec<Candidate>,
    /// The buffer for the list.
    pub buffer: Place,
}

/// What `cull_nodes` puts in its list of a child.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Listed {
    /// Its address.
    Address = 0,
    /// The address of its node plus 4 times its lane.
    Lane = 4,
}

/// Nodes and bounds, and pairs of both by their numbers.
#[derive(Clone, Debug)]
pub struct CullNodes<V> {
    /// The nodes' children.
    pub nodes: Vec<[Child<V>; 4]>,
    /// The bounds.
    pub bounds: Vec<Bound>,
    /// A node and a bound.
    pub pairs: Vec<[usize; 2]>,
    /// The part of a child that the list has.
    pub what: Listed,
}

fn some_nodes<V>(mut child: impl FnMut() -> Child<V>) -> Vec<[Child<V>; 4]> {
    (0..NODES).map(|_| std::array::from_fn(|_| child())).collect()
}

fn some_packets(random: &mut ChaCha8Rng) -> Vec<[Ray; 16]> {
    let mut fan = || fans::packet(FANS[random.random_range(0..FANS.len())], 1.0, random);
    (0..BOUNDS).map(|_| fan()).collect()
}

fn some_pairs(count: usize, random: &mut ChaCha8Rng) -> Vec<[usize; 2]> {
    let pair = |_| [random.random_range(0..NODES), random.random_range(0..BOUNDS)];
    (0..count).map(pair).collect()
}

fn any_child<V: Volume>(random: &mut ChaCha8Rng) -> Child<V> {
    Child { volume: any_bits(random), address: random.random() }
}

impl<V: Volume> Description for CullNodes<V> {
    const KERNEL: &'static str = V::CULL;
    const ROUNDS: [usize; 2] = [100, 1000];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [0.1..0.9, 0.01..0.99];
    type Placed = Candidates;
    type Found = Vec<[u32; 4]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self {
            nodes: some_nodes(|| Child::around(random)),
            bounds: some_packets(random).iter().map(bound).collect(),
            pairs: some_pairs(count, random),
            what: if random.random() { Listed::Address } else { Listed::Lane },
        }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let nodes = some_nodes(|| any_child(random));
        let bounds = (0..BOUNDS).map(|_| any_bits(random)).collect();
        Self { nodes, bounds, ..Self::sensible(count, random) }
    }

    fn place(&self, bench: &mut Bench) -> (Candidates, Vec<u32>) {
        let nodes: Vec<V::Node> = self.nodes.iter().map(V::node).collect();
        let nodes = put(bench, &nodes);
        let bounds = put_bounds(bench, &self.bounds);
        let candidate = |(number, &[node, bound]): (u32, &[usize; 2])| Candidate {
            object: address::<V::Node>(nodes, node).into(),
            packet: (0x5000_0000 + number).into(),
            bound: address::<layout::Bound>(bounds, bound).into(),
            shear: (0x6000_0000 + number).into(),
        };
        let given: Vec<Candidate> = (0..).zip(&self.pairs).map(candidate).collect();
        let list = put(bench, &given);
        let buffer = put(bench, &vec![Candidate::new_zeroed(); 4 * given.len() + 1]);
        let count = given.len() as u32;
        let arguments = vec![list.address, count, buffer.address, self.what as u32];
        (Candidates { given, buffer }, arguments)
    }

    fn found(&self, bench: &Bench, placed: &Candidates, end: u32) -> Vec<[u32; 4]> {
        listed(bench, placed.buffer, end)
    }

    fn twin(&self, placed: &Candidates) -> Vec<[u32; 4]> {
        let mut list = Vec::new();
        for (candidate, &[node, bound]) in placed.given.iter().zip(&self.pairs) {
            let [object, packet, at, shear] = words(candidate);
            for (lane, child) in (0..).zip(&self.nodes[node]) {
                if child.volume.may_meet(&self.bounds[bound]) {
                    let listed = match self.what {
                        Listed::Address => child.address,
                        Listed::Lane => object + 4 * lane,
                    };
                    list.push([listed, packet, at, shear]);
                }
            }
        }
        list
    }

    fn part(&self, found: &Vec<[u32; 4]>) -> [usize; 2] {
        [found.len(), 4 * self.pairs.len()]
    }
}

/// Nodes and packets with their bounds, and pairs of both by their numbers, of which all four
/// children are candidates.
#[derive(Clone, Debug)]
pub struct FilterChildren<V> {
    /// The nodes' children.
    pub nodes: Vec<[Child<V>; 4]>,
    /// The packets' bounds.
    pub bounds: Vec<Bound>,
    /// The packets.
    pub packets: Vec<[Ray; 16]>,
    /// A node and a packet.
    pub pairs: Vec<[usize; 2]>,
    /// Whether the list goes to the candidates' own place.
    pub in_place: bool,
}

impl<V: Volume> Description for FilterChildren<V> {
    const KERNEL: &'static str = V::FILTER;
    const ROUNDS: [usize; 2] = [100, 1000];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [0.02..0.9, ANY_SHARE];
    type Placed = Candidates;
    type Found = Vec<[u32; 4]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let nodes = some_nodes(|| Child::around(random));
        let packets = some_packets(random);
        let bounds = packets.iter().map(bound).collect();
        Self { nodes, bounds, packets, pairs: some_pairs(count, random), in_place: random.random() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let nodes = some_nodes(|| any_child(random));
        let bounds = (0..BOUNDS).map(|_| any_bits(random)).collect();
        let packets = (0..BOUNDS).map(|_| any_bits(random)).collect();
        Self { nodes, bounds, packets, ..Self::sensible(count, random) }
    }

    fn place(&self, bench: &mut Bench) -> (Candidates, Vec<u32>) {
        let nodes: Vec<V::Node> = self.nodes.iter().map(V::node).collect();
        let nodes = put(bench, &nodes);
        let bounds = put_bounds(bench, &self.bounds);
        let packets = put_packets(bench, &self.packets);
        let candidate = |(number, lane): (usize, u32)| {
            let [node, packet] = self.pairs[number];
            Candidate {
                object: (address::<V::Node>(nodes, node) + 4 * lane).into(),
                packet: address::<RayPacket>(packets, packet).into(),
                bound: address::<layout::Bound>(bounds, packet).into(),
                shear: (0x6000_0000 + number as u32).into(),
            }
        };
        let pairs = 0..self.pairs.len();
        let children = pairs.flat_map(|number| (0..4).map(move |lane| (number, lane)));
        let given: Vec<Candidate> = children.map(candidate).collect();
        let list = put(bench, &given);
        let apart = put(bench, &vec![Candidate::new_zeroed(); given.len() + 1]);
        let buffer = if self.in_place { list } else { apart };
        let arguments = vec![list.address, given.len() as u32, buffer.address, 0];
        (Candidates { given, buffer }, arguments)
    }

    fn found(&self, bench: &Bench, placed: &Candidates, end: u32) -> Vec<[u32; 4]> {
        listed(bench, placed.buffer, end)
    }

    fn twin(&self, placed: &Candidates) -> Vec<[u32; 4]> {
        let mut list = Vec::new();
        for (candidates, &[node, packet]) in placed.given.chunks(4).zip(&self.pairs) {
            let (bound, rays) = (&self.bounds[packet], &self.packets[packet]);
            for (candidate, child) in candidates.iter().zip(&self.nodes[node]) {
                let [_, a_packet, a_bound, shear] = words(candidate);
                if child.volume.any_may_meet(bound, rays) {
                    list.push([child.address, a_packet, a_bound, shear]);
                }
            }
        }
        list
    }

    fn part(&self, found: &Vec<[u32; 4]>) -> [usize; 2] {
        [found.len(), 4 * self.pairs.len()]
    }
}
