//! The kernels that test nodes' boxes with packets: with their bounds, or with every ray.

use twins::mesh::{Corners, MeshBound, Slab, any_enters, enters, mesh_bound};
use twins::primary_rays::Ray;

use super::call::{Node, bound_record, boxes};
use crate::cases::whitted::rays::call::put_packets;
use crate::cases::whitted::rays::fans::{self, FANS};
use crate::prelude::*;
use protocol::layout::{MeshCandidate, NO_BOX};

/// The corners of a lane without a child.
pub const NOBODY: Corners = [[NO_BOX; 3], [NO_BOX | 1 << 31; 3]];

/// The numbers of nodes and of packets that lists of random pairs have.
const NODES: usize = 8;
const PACKETS: usize = 4;

/// Nodes, and packets with their bounds, and pairs of both by their numbers: for the kernel that
/// tests every ray, or for the one that tests the bound.
#[derive(Clone, Debug)]
pub struct Boxed<const EVERY: bool> {
    /// The nodes.
    pub nodes: Vec<Node>,
    /// The packets.
    pub packets: Vec<([Ray; 16], MeshBound)>,
    /// A node and a packet. The near distance of the candidate is its own number.
    pub pairs: Vec<[usize; 2]>,
    /// The offset that is added to the children's words.
    pub base: u32,
}

/// A node with boxes near the eye, of which some are missing.
pub fn some_node(random: &mut ChaCha8Rng) -> Node {
    let mut corners = || {
        if random.random_range(0..5) == 0 {
            return NOBODY;
        }
        let centre = in_cube(20.0, random);
        let half: [f64; 3] = std::array::from_fn(|_| magnitude(0.01..20.0, random));
        [-1.0, 1.0].map(|way| std::array::from_fn(|axis| from_f64(centre[axis] + way * half[axis])))
    };
    Node { boxes: std::array::from_fn(|_| corners()), words: random.random() }
}

/// A packet of any relation, and its bound.
pub fn some_packet(random: &mut ChaCha8Rng) -> ([Ray; 16], MeshBound) {
    let rays = fans::packet(FANS[random.random_range(0..FANS.len())], 1.0, random);
    (rays, mesh_bound(&rays))
}

fn any_packet(random: &mut ChaCha8Rng) -> ([Ray; 16], MeshBound) {
    let slab = |random: &mut ChaCha8Rng| Slab {
        down: random.random(),
        near_scale: random.random(),
        near_shift: random.random(),
        far_scale: random.random(),
        far_shift: random.random(),
    };
    let bound = MeshBound {
        slabs: std::array::from_fn(|_| slab(random)),
        slack: random.random::<u32>() & 0xfffc_0000,
        farthest: random.random(),
    };
    (any_bits(random), bound)
}

impl<const EVERY: bool> Description for Boxed<EVERY> {
    const KERNEL: &'static str = if EVERY { "filter_boxes_r16" } else { "cull_boxes" };
    const ROUNDS: [usize; 2] = [50, 500];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [if EVERY { 0.01 } else { 0.1 }..0.8, 0.005..0.8];
    /// The candidates' words, and the buffer for the list.
    type Placed = (Vec<[u32; 4]>, Place);
    /// Words: object, packet, bound, near.
    type Found = Vec<[u32; 4]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let nodes = (0..NODES).map(|_| some_node(random)).collect();
        let packets = (0..PACKETS).map(|_| some_packet(random)).collect();
        let pair = |_| [random.random_range(0..NODES), random.random_range(0..PACKETS)];
        Self { nodes, packets, pairs: (0..count).map(pair).collect(), base: random.random() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let node = |_| Node { boxes: random.random(), words: random.random() };
        let nodes = (0..NODES).map(node).collect();
        let packets = (0..PACKETS).map(|_| any_packet(random)).collect();
        Self { nodes, packets, ..Self::sensible(count, random) }
    }

    fn place(&self, bench: &mut Bench) -> (Self::Placed, Vec<u32>) {
        let nodes: Vec<layout::Boxes> = self.nodes.iter().map(boxes).collect();
        let nodes = put(bench, &nodes);
        let (packets, bounds): (Vec<_>, Vec<_>) = self.packets.iter().copied().unzip();
        let bounds: Vec<_> = bounds.iter().map(|bound| bound_record(bound, u32::MAX)).collect();
        let bounds = put(bench, &bounds);
        let packets = put_packets(bench, &packets);
        let candidate = |(number, &[node, packet]): (u32, &[usize; 2])| MeshCandidate {
            object: address::<layout::Boxes>(nodes, node).into(),
            packet: address::<RayPacket>(packets, packet).into(),
            bound: address::<layout::MeshBound>(bounds, packet).into(),
            near: single(number),
        };
        let given: Vec<MeshCandidate> = (0..).zip(&self.pairs).map(candidate).collect();
        let list = put(bench, &given).address;
        let buffer = put(bench, &vec![MeshCandidate::new_zeroed(); 4 * given.len() + 3]);
        let arguments = vec![list, given.len() as u32, buffer.address, self.base];
        ((given.iter().map(words).collect(), buffer), arguments)
    }

    fn found(&self, bench: &Bench, (_, buffer): &Self::Placed, end: u32) -> Self::Found {
        bench.read_list(*buffer, end).iter().map(words).collect()
    }

    fn twin(&self, (given, _): &Self::Placed) -> Self::Found {
        let mut list = Vec::new();
        for (&[_, packet, at, near], &[node, of]) in given.iter().zip(&self.pairs) {
            let (rays, bound) = &self.packets[of];
            let Node { boxes, words } = &self.nodes[node];
            for (corners, word) in boxes.iter().zip(words) {
                let near = if EVERY {
                    any_enters(bound.slack, rays, corners).then_some(near)
                } else {
                    enters(bound, corners)
                };
                list.extend(near.map(|near| [word.wrapping_add(self.base), packet, at, near]));
            }
        }
        list
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        [found.len(), 4 * self.pairs.len()]
    }
}

fn words(candidate: &MeshCandidate) -> [u32; 4] {
    [candidate.object.get(), candidate.packet.get(), candidate.bound.get(), bits(candidate.near)]
}
