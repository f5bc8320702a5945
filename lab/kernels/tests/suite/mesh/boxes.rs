//! `cull_boxes` and `filter_boxes_r16` compared with their twins.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::mesh::call::{self, Node};
use kernels::cases::whitted::rays::fans::{self, FANS};
use kernels::description::any_bits;
use kernels::vector::{in_cube, magnitude};
use protocol::layout::NO_BOX;
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::from_f64;
use twins::mesh::{Corners, MeshBound, Slab, any_enters, enters, mesh_bound};
use twins::primary_rays::{ABSENT, Ray};

use super::COUNTS;

const NODES: usize = 8;
const PACKETS: usize = 4;

/// The corners of a lane without a child.
const NOBODY: Corners = [[NO_BOX; 3], [NO_BOX | 1 << 31; 3]];

type Bounded = ([Ray; 16], MeshBound);

/// Checks both kernels. Returns how many children each kept.
fn check(
    bench: &mut Bench,
    nodes: &[Node],
    packets: &[Bounded],
    pairs: &[[usize; 2]],
    base: u32,
) -> [usize; 2] {
    let [given, found] = call::listed(bench, "cull_boxes", nodes, packets, pairs, base);
    let mut expected = Vec::new();
    for ([_, packet, bound, _], &[node, of]) in given.into_iter().zip(pairs) {
        let Node { boxes, words } = &nodes[node];
        for (corners, word) in boxes.iter().zip(words) {
            if let Some(near) = enters(&packets[of].1, corners) {
                expected.push([word.wrapping_add(base), packet, bound, near]);
            }
        }
    }
    assert_eq!(found, expected, "{nodes:x?} {packets:x?} {pairs:?}");
    let culled = found.len();

    let [given, found] = call::listed(bench, "filter_boxes_r16", nodes, packets, pairs, base);
    let mut expected = Vec::new();
    for ([_, packet, bound, near], &[node, of]) in given.into_iter().zip(pairs) {
        let (rays, MeshBound { slack, .. }) = &packets[of];
        let Node { boxes, words } = &nodes[node];
        for (corners, word) in boxes.iter().zip(words) {
            if any_enters(*slack, rays, corners) {
                expected.push([word.wrapping_add(base), packet, bound, near]);
            }
        }
    }
    assert_eq!(found, expected, "{nodes:x?} {packets:x?} {pairs:?}");
    [culled, found.len()]
}

fn pairs(count: usize, random: &mut ChaCha8Rng) -> Vec<[usize; 2]> {
    let pair = |_| [random.random_range(0..NODES), random.random_range(0..PACKETS)];
    (0..count).map(pair).collect()
}

/// A box near the eye, or none.
fn corners(random: &mut ChaCha8Rng) -> Corners {
    if random.random_range(0..5) == 0 {
        return NOBODY;
    }
    let centre = in_cube(20.0, random);
    let half: [f64; 3] = std::array::from_fn(|_| magnitude(0.01..20.0, random));
    let corner = |way: f64| std::array::from_fn(|axis| from_f64(centre[axis] + way * half[axis]));
    [corner(-1.0), corner(1.0)]
}

fn node(random: &mut ChaCha8Rng) -> Node {
    Node { boxes: std::array::from_fn(|_| corners(random)), words: random.random() }
}

fn packet(random: &mut ChaCha8Rng) -> Bounded {
    let fan = FANS[random.random_range(0..FANS.len())];
    let rays = fans::packet(fan, 1.0, random);
    (rays, mesh_bound(&rays))
}

#[test]
fn candidates_equal_the_twin_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut tested, mut kept) = (0, [0; 2]);
    for _ in 0..50 {
        for count in COUNTS {
            let nodes: [Node; NODES] = std::array::from_fn(|_| node(&mut random));
            let packets: [Bounded; PACKETS] = std::array::from_fn(|_| packet(&mut random));
            let pairs = pairs(count, &mut random);
            let found = check(&mut bench, &nodes, &packets, &pairs, random.random());
            kept = [kept[0] + found[0], kept[1] + found[1]];
            tested += 4 * count;
        }
    }
    println!("{kept:?} of {tested}");
    assert!(kept[0] > tested / 10 && kept[0] < tested * 8 / 10);
    assert!(kept[1] > tested / 50 && kept[1] < kept[0]);
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut kept = [0; 2];
    for _ in 0..500 {
        let nodes: [Node; NODES] =
            std::array::from_fn(|_| Node { boxes: random.random(), words: random.random() });
        let packets: [Bounded; PACKETS] = std::array::from_fn(|_| {
            let slab = |random: &mut ChaCha8Rng| Slab {
                down: random.random(),
                near_scale: random.random(),
                near_shift: random.random(),
                far_scale: random.random(),
                far_shift: random.random(),
            };
            let bound = MeshBound {
                slabs: std::array::from_fn(|_| slab(&mut random)),
                slack: random.random::<u32>() & 0xfffc_0000,
                farthest: random.random(),
            };
            (any_bits(&mut random), bound)
        });
        let pairs = pairs(7, &mut random);
        let found = check(&mut bench, &nodes, &packets, &pairs, random.random());
        kept = [kept[0] + found[0], kept[1] + found[1]];
    }
    assert!(kept[0] > 100 && kept[1] > 100, "{kept:?}");
}

/// A lane without a child and a packet without rays meet nothing, wherever the eye moves the former
/// and however it is widened.
#[test]
fn empty_nodes_and_bounds_meet_nothing() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..500 {
        let (rays, bound) = packet(&mut random);
        let absent = rays.map(|ray| Ray { t: ABSENT, ..ray });
        let packets = [(rays, bound), (absent, mesh_bound(&absent))];
        let nobody = Node {
            boxes: [NOBODY.map(|corner| corner.map(|c| c - (1 << 5))); 4],
            words: random.random(),
        };
        let nodes = [nobody, node(&mut random)];
        let pairs = [[0, 0], [0, 1], [1, 1]];
        assert_eq!(check(&mut bench, &nodes, &packets, &pairs, 0), [0, 0]);
    }
}
