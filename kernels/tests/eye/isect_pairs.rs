//! `isect_pairs_r16`.

use std::collections::BTreeSet;

use kernels::bench::{Bench, random};
use kernels::cases::ball::{ball, unit};
use kernels::cases::eye::{call, error};
use kernels::eye_records::{self, Hits, Vectors};
use kernels::layout::{Packet, Sphere};
use oracle::twin::FARTHEST;
use oracle::twin::ball::Ball;
use oracle::twin::isect_pairs::{Hit, isect_pair};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, to_f64};

use crate::COUNTS;

/// Runs the kernel, compares with the twin pair by pair, and gives the hits and the spheres' objects.
fn check(
    bench: &mut Bench,
    packets: &[Packet],
    spheres: &[Ball],
    pairs: &[[usize; 2]],
) -> (Vec<Hits>, Vec<u32>) {
    let records: Vec<Sphere> = spheres.iter().map(eye_records::sphere).collect();
    let (after, objects) = call::isect_pairs(bench, "isect_pairs_r16", packets, &records, pairs);
    let mut expected: Vec<Hits> = packets.iter().map(eye_records::hits).collect();
    for &[sphere, packet] in pairs {
        let rays = eye_records::directions(&packets[packet]);
        for (hit, direction) in expected[packet].iter_mut().zip(rays) {
            *hit = isect_pair(direction, &spheres[sphere], objects[sphere], *hit);
        }
    }
    for ((before, after), expected) in packets.iter().zip(&after).zip(&expected) {
        let rays = eye_records::directions(before);
        assert_eq!(eye_records::directions(after), rays, "rays were changed");
        let found = eye_records::hits(after);
        for ((found, expected), ray) in found.iter().zip(expected).zip(rays) {
            assert_eq!(found, expected, "ray {ray:x?}, {spheres:x?}, {pairs:?}");
        }
    }
    (expected, objects)
}

/// Rays about -z.
fn rays(random: &mut ChaCha8Rng) -> Vectors {
    std::array::from_fn(|_| {
        let [x, y] = [(); 2].map(|()| random.random_range(-0.3..0.3));
        unit([x, y, -1.0]).map(from_f64)
    })
}

/// A sphere about as far as it is wide from -z.
fn sphere(random: &mut ChaCha8Rng) -> Ball {
    let [x, y, z] = [(); 3].map(|()| random.random_range(-2.0..2.0));
    ball([x, y, z - 6.0], random.random_range(0.1..1.5))
}

fn straight(hit: Hit) -> Packet {
    let forward = [0.0, 0.0, -1.0].map(from_f64);
    eye_records::packet(&[forward; 16], &[hit; 16])
}

#[test]
fn the_nearest_of_many_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut hit_objects = BTreeSet::new();
    for _ in 0..30 {
        for count in COUNTS.into_iter().chain([0]) {
            let before = Hit {
                t: from_f64(random.random_range(1.0..20.0)),
                object: 7,
            };
            let packets: Vec<Packet> = (0..random.random_range(1..5))
                .map(|_| eye_records::packet(&rays(&mut random), &[before; 16]))
                .collect();
            let spheres: Vec<Ball> = (0..12).map(|_| sphere(&mut random)).collect();
            let pairs: Vec<[usize; 2]> = (0..count)
                .map(|_| [spheres.len(), packets.len()].map(|end| random.random_range(0..end)))
                .collect();
            let (hits, objects) = check(&mut bench, &packets, &spheres, &pairs);
            for hit in hits.iter().flatten() {
                hit_objects.extend(objects.iter().position(|object| *object == hit.object));
            }
        }
    }
    assert_eq!(hit_objects.len(), 12, "only {hit_objects:?} were hit");
}

#[test]
fn a_packet_in_pair_after_pair_keeps_its_nearest_hit() {
    let mut random = random();
    let mut bench = Bench::new();
    let distances: Vec<f64> = (0..40).map(|step| 5.0 + f64::from(step)).collect();
    let spheres: Vec<Ball> = distances
        .iter()
        .map(|distance| ball([0.0, 0.0, -distance], 1.0))
        .collect();
    let none = Hit {
        t: FARTHEST,
        object: 7,
    };
    for count in COUNTS {
        let farther: Vec<[usize; 2]> = (0..count).map(|sphere| [sphere, 0]).collect();
        let nearer: Vec<[usize; 2]> = farther.iter().rev().copied().collect();
        for pairs in [farther, nearer] {
            let (hits, objects) = check(&mut bench, &[straight(none)], &spheres, &pairs);
            assert!(hits[0].iter().all(|hit| hit.object == objects[0]));
        }
        // In runs of random length, among other packets.
        let mut packet = 0;
        let pairs: Vec<[usize; 2]> = (0..count)
            .map(|_| {
                if random.random_range(0..3) == 0 {
                    packet = random.random_range(0..3);
                }
                [random.random_range(0..spheres.len()), packet]
            })
            .collect();
        check(&mut bench, &[straight(none); 3], &spheres, &pairs);
    }
}

#[test]
fn ulps_around_a_tangent_equal_the_twin() {
    let mut bench = Bench::new();
    let rays = std::array::from_fn(|lane| {
        let sine: f64 = 0.2 + (lane as f64 - 8.0) * 2_f64.powi(-26);
        unit([sine, 0.0, -(1.0 - sine * sine).sqrt()]).map(from_f64)
    });
    let packet = eye_records::packet(&rays, &error::NO_HITS);
    let sphere = ball([0.0, 0.0, -5.0], 1.0);
    let (hits, objects) = check(&mut bench, &[packet], &[sphere], &[[0, 0]]);
    let hit = hits[0].map(|hit| hit.object == objects[0]);
    assert!(hit.contains(&true) && hit.contains(&false), "{hit:?}");
}

#[test]
fn all_that_an_eye_and_a_sphere_can_be_to_each_other() {
    let mut bench = Bench::new();
    let cases: [(&str, Ball, bool); 11] = [
        ("ahead", ball([0.0, 0.0, -5.0], 1.0), true),
        ("behind", ball([0.0, 0.0, 5.0], 1.0), false),
        ("around the eye", ball([0.0, 0.0, -0.5], 1.0), false),
        ("at the eye", ball([0.0; 3], 1.0), false),
        ("tangent", ball([1.0, 0.0, -5.0], 1.0), true),
        ("tangent at the eye", ball([1.0, 0.0, 0.0], 1.0), true),
        ("beside", ball([3.0, 0.0, -5.0], 1.0), false),
        ("beside and behind", ball([3.0, 0.0, 5.0], 1.0), false),
        ("tiny and far", ball([0.0, 0.0, -4096.0], 1.0 / 16.0), true),
        ("huge", ball([0.0, 0.0, -1e9], 0.999e9), true),
        (
            "at the limit of the domain",
            ball([0.0, 0.0, -(2_f64.powi(62))], 2_f64.powi(60)),
            true,
        ),
    ];
    for (name, sphere, is_hit) in cases {
        let packet = straight(Hit {
            t: FARTHEST,
            object: 7,
        });
        let (hits, objects) = check(&mut bench, &[packet], &[sphere], &[[0, 0]]);
        let object = if is_hit { objects[0] } else { 7 };
        for hit in hits[0] {
            assert_eq!(hit.object, object, "{name}: {hit:x?}");
        }
    }
}

#[test]
fn an_entry_counts_at_0_but_not_at_what_was_there() {
    let mut bench = Bench::new();
    let touching = ball([1.0, 0.0, 0.0], 1.0);
    let mut hit_before = |t| {
        let packet = straight(Hit { t, object: 7 });
        let (hits, _) = check(&mut bench, &[packet], &[touching], &[[0, 0]]);
        hits[0][0]
    };
    let first = hit_before(from_f64(1.0));
    assert_eq!(first.t, 0);
    assert_ne!(first.object, 7);
    assert_eq!(hit_before(0).object, 7, "a hit as near was replaced");
}

#[test]
fn sensible_rays_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut hit_count = 0;
    for _ in 0..1000 {
        let (rays, sphere) = error::around_a_sphere(&mut random);
        let packet = eye_records::packet(&rays, &error::NO_HITS);
        let (hits, objects) = check(&mut bench, &[packet], &[sphere], &[[0, 0]]);
        for hit in hits[0].iter().filter(|hit| hit.object == objects[0]) {
            assert!(to_f64(hit.t) > 0.0);
            hit_count += 1;
        }
    }
    assert!((4000..15_000).contains(&hit_count), "{hit_count} of 16000");
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let packets: Vec<Packet> = (0..2)
            .map(|_| {
                let rays = std::array::from_fn(|_| random.random());
                let hits = std::array::from_fn(|_| Hit {
                    t: random.random(),
                    object: random.random(),
                });
                eye_records::packet(&rays, &hits)
            })
            .collect();
        let spheres: Vec<Ball> = (0..4)
            .map(|_| Ball {
                centre: random.random(),
                radius_squared: random.random(),
            })
            .collect();
        let pairs: Vec<[usize; 2]> = (0..8).map(|pair| [pair % 4, pair / 4]).collect();
        check(&mut bench, &packets, &spheres, &pairs);
    }
}
