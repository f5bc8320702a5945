//! `cull_nodes` and `filter_children_r16`, and those for boxes, compared with their twins.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::rays::call::{self, BareBox, BareSphere, Child, Listed, Volume};
use kernels::cases::whitted::rays::fans::{self, FANS};
use kernels::vector::{in_cube, magnitude};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::from_f64;
use twins::bound::{Bound, bound};
use twins::primary_rays::Ray;
use twins::{FARTHEST, Single};

use super::COUNTS;

const NODES: usize = 8;
const BOUNDS: usize = 4;

/// The radius, and the half sizes, of a lane without a child.
const NO_CHILD: Single = FARTHEST | 1 << 31;

/// Checks the kernel, and returns how many children it kept.
fn check<V: Volume>(
    bench: &mut Bench,
    nodes: &[[Child<V>; 4]],
    bounds: &[Bound],
    pairs: &[[usize; 2]],
) -> usize {
    let (given, found) = call::cull_nodes(bench, nodes, bounds, pairs, Listed::Address);
    let mut expected = Vec::new();
    let mut expected_children = Vec::new();
    for (candidate, &[node, bound]) in given.iter().zip(pairs) {
        let [a_node, packet, a_bound, shear] = call::words(candidate);
        for (lane, child) in (0..).zip(&nodes[node]) {
            if child.volume.may_meet(&bounds[bound]) {
                expected.push([child.address, packet, a_bound, shear]);
                expected_children.push([a_node + 4 * lane, packet, a_bound, shear]);
            }
        }
    }
    assert_eq!(found, expected, "{nodes:x?} {bounds:x?} {pairs:?}");
    let (_, found) = call::cull_nodes(bench, nodes, bounds, pairs, Listed::Lane);
    assert_eq!(found, expected_children, "{nodes:x?} {bounds:x?} {pairs:?}");
    found.len()
}

/// Checks `filter_children_r16`, with packets that have the bounds' numbers.
fn check_rays<V: Volume>(
    bench: &mut Bench,
    nodes: &[[Child<V>; 4]],
    bounds: &[Bound],
    packets: &[[Ray; 16]],
    pairs: &[[usize; 2]],
) -> usize {
    let (given, found) = call::filter_children_r16(bench, nodes, bounds, packets, pairs);
    let mut expected = Vec::new();
    for (candidates, &[node, packet]) in given.chunks(4).zip(pairs) {
        let (bound, rays) = (&bounds[packet], &packets[packet]);
        for (candidate, child) in candidates.iter().zip(&nodes[node]) {
            let [_, a_packet, a_bound, shear] = call::words(candidate);
            if child.volume.any_may_meet(bound, rays) {
                expected.push([child.address, a_packet, a_bound, shear]);
            }
        }
    }
    assert_eq!(found, expected, "{nodes:x?} {packets:x?} {pairs:?}");
    found.len()
}

fn pairs(count: usize, random: &mut ChaCha8Rng) -> Vec<[usize; 2]> {
    let pair = |_| [random.random_range(0..NODES), random.random_range(0..BOUNDS)];
    (0..count).map(pair).collect()
}

/// Volumes for tests.
trait Random: Volume {
    /// One around the eye.
    fn around(random: &mut ChaCha8Rng) -> Self;
    /// One of random bits.
    fn bits(random: &mut ChaCha8Rng) -> Self;
    /// That of a lane without a child.
    fn nobody(self) -> Self;
}

impl Random for BareSphere {
    fn around(random: &mut ChaCha8Rng) -> Self {
        Self {
            centre: in_cube(20.0, random).map(from_f64),
            radius: from_f64(magnitude(0.01..20.0, random)),
        }
    }

    fn bits(random: &mut ChaCha8Rng) -> Self {
        Self { centre: random.random(), radius: random.random() }
    }

    fn nobody(self) -> Self {
        Self { radius: NO_CHILD, ..self }
    }
}

impl Random for BareBox {
    fn around(random: &mut ChaCha8Rng) -> Self {
        Self {
            centre: in_cube(20.0, random).map(from_f64),
            half: std::array::from_fn(|_| match random.random_range(0..5) {
                0 => 0,
                _ => from_f64(magnitude(0.1..20.0, random)),
            }),
        }
    }

    fn bits(random: &mut ChaCha8Rng) -> Self {
        Self { centre: random.random(), half: random.random() }
    }

    fn nobody(self) -> Self {
        Self { half: [NO_CHILD; 3], ..self }
    }
}

/// A child around the eye, or none.
fn child<V: Random>(random: &mut ChaCha8Rng) -> Child<V> {
    let volume = V::around(random);
    Child {
        volume: match random.random_range(0..5) {
            0 => volume.nobody(),
            _ => volume,
        },
        address: random.random(),
    }
}

#[test]
fn candidates_equal_the_twin_in_lists_of_any_length() {
    candidates_equal_the_twin::<BareSphere>();
    candidates_equal_the_twin::<BareBox>();
}

fn candidates_equal_the_twin<V: Random>() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut tested, mut kept, mut kept_by_rays) = (0, 0, 0);
    for _ in 0..50 {
        for count in COUNTS {
            let nodes: [[Child<V>; 4]; NODES] =
                std::array::from_fn(|_| std::array::from_fn(|_| child(&mut random)));
            let packets: [[Ray; 16]; BOUNDS] = std::array::from_fn(|_| {
                let fan = FANS[random.random_range(0..FANS.len())];
                fans::packet(fan, 1.0, &mut random)
            });
            let bounds = packets.each_ref().map(bound);
            let pairs = pairs(count, &mut random);
            let by_bounds = check(&mut bench, &nodes, &bounds, &pairs);
            kept_by_rays += check_rays(&mut bench, &nodes, &bounds, &packets, &pairs);
            kept += by_bounds;
            tested += 4 * count;
        }
    }
    assert!(kept > tested / 10 && kept < tested * 9 / 10, "{kept} of {tested}");
    assert!(kept_by_rays > tested / 50 && kept_by_rays < kept, "{kept_by_rays} of {tested}");
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    any_bits_equal_the_twin::<BareSphere>();
    any_bits_equal_the_twin::<BareBox>();
}

fn any_bits_equal_the_twin<V: Random>() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut kept, mut kept_by_rays) = (0, 0);
    for _ in 0..500 {
        let nodes: [[Child<V>; 4]; NODES] = std::array::from_fn(|_| {
            std::array::from_fn(|_| Child {
                volume: V::bits(&mut random),
                address: random.random(),
            })
        });
        let bounds: [Bound; BOUNDS] = std::array::from_fn(|_| Bound {
            apex: random.random(),
            axis: random.random(),
            cosine: random.random(),
            sine: random.random(),
            radius: random.random(),
            farthest: random.random(),
        });
        kept += check(&mut bench, &nodes, &bounds, &pairs(7, &mut random));
        let packets: [[Ray; 16]; BOUNDS] = std::array::from_fn(|_| {
            std::array::from_fn(|_| Ray {
                origin: random.random(),
                direction: random.random(),
                t: random.random(),
                object: 0,
                weight: random.random(),
                pixel: 0,
            })
        });
        let pairs = pairs(7, &mut random);
        kept_by_rays += check_rays(&mut bench, &nodes, &bounds, &packets, &pairs);
    }
    assert!(kept > 100 && kept_by_rays > 100, "{kept} {kept_by_rays}");
}

#[test]
fn no_candidate_gives_no_list() {
    nothing_gives_no_list::<BareSphere>();
    nothing_gives_no_list::<BareBox>();
}

fn nothing_gives_no_list<V: Random>() {
    let mut bench = Bench::new();
    let mut random = random();
    let node = std::array::from_fn(|_| child::<V>(&mut random));
    let bound = bound(&fans::packet(FANS[0], 1.0, &mut random));
    assert_eq!(check(&mut bench, &[node], &[bound], &[]), 0);
    let packet = fans::packet(FANS[0], 1.0, &mut random);
    let found = check_rays(&mut bench, &[node], &[bound], &[packet], &[]);
    assert_eq!(found, 0);
}

/// A lane without a child and a bound without rays meet nothing.
#[test]
fn nothing_meets_nothing() {
    nobody_is_met::<BareSphere>();
    nobody_is_met::<BareBox>();
}

fn nobody_is_met<V: Random>() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..2000 {
        let fan = FANS[random.random_range(0..FANS.len())];
        let rays = fans::packet(fan, 1.0, &mut random);
        let absent =
            rays.map(|ray| twins::primary_rays::Ray { t: twins::primary_rays::ABSENT, ..ray });
        let nobody: [Child<V>; 4] = std::array::from_fn(|_| {
            let child = child::<V>(&mut random);
            Child { volume: child.volume.nobody(), ..child }
        });
        let anybody = std::array::from_fn(|_| child(&mut random));
        let bounds = [bound(&rays), bound(&absent)];
        let pairs = [[0, 0], [0, 1], [1, 1]];
        assert_eq!(check(&mut bench, &[nobody, anybody], &bounds, &pairs), 0);
        let packets = [rays, absent];
        let found = check_rays(&mut bench, &[nobody, anybody], &bounds, &packets, &pairs);
        assert_eq!(found, 0);
    }
}
