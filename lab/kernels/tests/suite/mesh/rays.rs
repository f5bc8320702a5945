//! The kernels that take rays through blocks one by one, compared with their twins; and that no
//! ray is left out that enters a box.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::mesh::call::{self, Node};
use kernels::cases::whitted::rays::fans::{self, FANS, SCALES};
use kernels::description::any_bits;
use kernels::vector::{in_cube, magnitude};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::from_f64;
use twins::mesh::Corners;
use twins::mesh_rays::{self, MeshRay, Visit, bit};
use twins::primary_rays::Ray;

use super::conservative::{self, AXES, SLACK};

/// A number of rays so small that the list of all nodes that they may meet has capacity.
const FEW: u32 = 16;
/// Packets of a batch.
const MOST: usize = 8;

fn batch(count: usize, scale: f64, random: &mut ChaCha8Rng) -> Vec<[Ray; 16]> {
    let mut fan = || fans::packet(FANS[random.random_range(0..FANS.len())], scale, random);
    (0..count).map(|_| fan()).collect()
}

fn junk(count: usize, random: &mut ChaCha8Rng) -> Vec<[Ray; 16]> {
    (0..count).map(|_| any_bits(random)).collect()
}

fn records(packets: &[[Ray; 16]]) -> Vec<MeshRay> {
    packets.iter().flatten().map(mesh_rays::mesh_ray).collect()
}

/// Bits of rays of the packets, of all of them or of a few.
fn some(packets: &[[Ray; 16]], random: &mut ChaCha8Rng) -> u128 {
    let there = u128::MAX << (128 - 16 * packets.len());
    let any = |random: &mut ChaCha8Rng| random.random::<u128>();
    there
        & match random.random_range(0..4) {
            0 => u128::MAX,
            1 => any(random),
            2 => any(random) & any(random) & any(random) & any(random),
            _ => bit(random.random_range(0..128)) | bit(random.random_range(0..128)),
        }
}

#[test]
fn records_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for round in 0..400 {
        let count = random.random_range(1..=MOST);
        let scale = magnitude(SCALES, &mut random);
        let packets = match round % 2 {
            0 => batch(count, scale, &mut random),
            _ => junk(count, &mut random),
        };
        let expected = call::ray_words(&records(&packets));
        assert_eq!(call::mesh_rays(&mut bench, &packets), expected, "{packets:x?}");
    }
}

#[test]
fn living_rays_equal_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut left = 0;
    for round in 0..600 {
        let count = random.random_range(1..=MOST);
        let packets = match round % 2 {
            0 => batch(count, 1.0, &mut random),
            _ => junk(count, &mut random),
        };
        let near = match round % 3 {
            0 => packets[0][0].t,
            1 => from_f64(random.random_range(-1.0..50.0)),
            _ => random.random(),
        };
        let bits = random.random();
        let expected = mesh_rays::alive(&packets, near, bits);
        assert_eq!(call::alive(&mut bench, &packets, near, bits), expected);
        left += expected.count_ones();
    }
    assert!(left > 1000);
}

/// Nodes of a block: levels of them, with boxes near the rays. Words below the lowest level are not
/// 0 where there is a child.
fn nodes(lowest: usize, boxes: &mut dyn FnMut() -> Corners, random: &mut ChaCha8Rng) -> Vec<Node> {
    let middle = match lowest {
        0..=4 => 0,
        _ => lowest.div_ceil(4),
    };
    let upper = usize::from(lowest > 1) + middle;
    let count = upper + lowest;
    let mut below = 1;
    (0..count)
        .map(|node| {
            let lanes = match node {
                _ if node >= upper => random.random_range(0..=4),
                0 if middle > 0 => middle,
                _ => (count - below).min(4),
            };
            if node < upper {
                below += lanes;
            }
            Node {
                boxes: std::array::from_fn(|_| boxes()),
                words: std::array::from_fn(|lane| match lane {
                    _ if lane < lanes => random.random_range(1..u32::MAX),
                    _ => 0,
                }),
            }
        })
        .collect()
}

/// The nodes as the twin takes them.
fn of_twin(nodes: &[Node]) -> Vec<([Corners; 4], [u32; 4])> {
    nodes.iter().map(|node| (node.boxes, node.words)).collect()
}

/// Checks the three kernels that make lists. Returns how many children were met.
fn check(bench: &mut Bench, packets: &[[Ray; 16]], nodes: &[Node], bits: u128, base: u32) -> usize {
    let rays = records(packets);
    let (visits, tests) = mesh_rays::filter_rays(&rays, bits, &of_twin(nodes));
    let found = call::filter_rays(bench, packets, nodes, bits);
    assert_eq!(found, (visits.clone(), tests), "{packets:x?} {nodes:x?} {bits:x}");

    let of_packet = |visit: &Visit| {
        let there = (0..8).filter(|packet| visit.rays << (16 * packet) >> 112 != 0);
        let child = visit.child.wrapping_add(base);
        there.map(move |packet| (child, packet)).collect::<Vec<_>>()
    };
    let expected: Vec<(u32, u32)> = visits.iter().flat_map(of_packet).collect();
    assert_eq!(call::candidates(bench, &visits, base), expected);

    if (1..=FEW).contains(&bits.count_ones()) {
        let expected: Vec<(u32, u32)> = mesh_rays::few_rays(&rays, bits, &of_twin(nodes))
            .into_iter()
            .map(|(word, ray)| (word.wrapping_add(base), ray / 16))
            .collect();
        let found = call::few_rays(bench, packets, nodes, bits, base);
        assert_eq!(found, expected, "{packets:x?} {nodes:x?} {bits:x}");
    }
    visits.len()
}

#[test]
fn lists_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut met = 0;
    for _ in 0..300 {
        let packets = batch(random.random_range(1..=MOST), 1.0, &mut random);
        let lowest = random.random_range(1..=13);
        let mut boxes = {
            let mut random = random.clone();
            move || {
                let centre = in_cube(20.0, &mut random);
                let half = magnitude(1.0..30.0, &mut random);
                [-half, half].map(|way| centre.map(|c| from_f64(c + way)))
            }
        };
        let nodes = nodes(lowest, &mut boxes, &mut random);
        let bits = some(&packets, &mut random);
        met += check(&mut bench, &packets, &nodes, bits, random.random());
    }
    println!("{met} met");
    assert!(met > 200);
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut met = 0;
    for _ in 0..300 {
        let packets = junk(random.random_range(1..=MOST), &mut random);
        let mut boxes = {
            let mut random = random.clone();
            move || random.random()
        };
        let nodes = nodes(random.random_range(1..=13), &mut boxes, &mut random);
        let bits = some(&packets, &mut random);
        met += check(&mut bench, &packets, &nodes, bits, random.random());
    }
    assert!(met > 100);
}

/// Boxes that touch a ray or almost do, with the slack that they have in blocks, are met by it:
/// by f64 from the singles of the records.
#[test]
fn entered_boxes_are_kept() {
    let mut random = random();
    let mut bench = Bench::new();
    let [mut met, mut found] = [0; 2];
    for round in 0..800 {
        let scale = magnitude(1e-6..1e9, &mut random);
        let fan = FANS[round % FANS.len()];
        let axes = AXES[round % AXES.len()];
        let rays = conservative::packet(fan, axes, scale, &mut random);
        let number = random.random_range(0..16);
        let ray = rays[number as usize];
        if ray.t >> 31 != 0 {
            continue;
        }
        let corners: [Corners; 4] =
            std::array::from_fn(|_| conservative::touching(&ray, scale, &mut random));
        let node = Node {
            boxes: corners.map(|corners| conservative::widened(&corners, SLACK)),
            words: [1, 2, 3, 4],
        };
        let (visits, _) = call::filter_rays(&mut bench, &[rays], &[node], bit(number));
        let few = call::few_rays(&mut bench, &[rays], &[node], bit(number), 0);
        for (word, corners) in (1..).zip(&corners) {
            if conservative::meets(&ray, corners) {
                met += 1;
                assert!(visits.iter().any(|visit| visit.child == word), "{ray:x?} {corners:x?}");
                assert!(few.contains(&(word, 0)), "{ray:x?} {corners:x?}");
            }
        }
        found += visits.len();
    }
    println!("{found} found, {met} met");
    assert!(met > 300);
}
