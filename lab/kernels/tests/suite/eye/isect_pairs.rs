//! `isect_pairs_r16` and the kernels of the other formulations.

use std::collections::BTreeSet;

use kernels::bench::{Bench, random};
use kernels::cases::eye::formulation::{Seen, around_a_sphere};
use kernels::cases::eye::{call, error};
use kernels::cases::formulation::ForTheEye;
use kernels::cases::sphere_ray::unit;
use kernels::description::any_bits;
use kernels::eye_records::{self, Hits, Vectors};
use protocol::layout::{Packet, Sphere};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::FARTHEST;
use twins::isect_pairs::{Hit, isect_pair};
use twins::sphere::{
    Constants, Estimate, Factored, InDouble, Interpolated, Newton2, Paper, Perpendicular, Refined,
    Stable, Unnormalised,
};

use super::COUNTS;

/// Runs the kernel, compares with the twin pair by pair, and returns the hits and the spheres'
/// objects.
fn check<F: ForTheEye<Sphere: Seen>>(
    bench: &mut Bench,
    packets: &[Packet],
    spheres: &[F::Sphere],
    pairs: &[[usize; 2]],
) -> (Vec<Hits>, Vec<u32>) {
    let records: Vec<Sphere> = spheres.iter().map(Seen::record).collect();
    let (after, objects) = call::isect_pairs(bench, F::EYE, packets, &records, pairs);
    let mut expected: Vec<Hits> = packets.iter().map(eye_records::hits).collect();
    for &[sphere, packet] in pairs {
        let rays = eye_records::directions(&packets[packet]);
        for (hit, direction) in expected[packet].iter_mut().zip(rays) {
            *hit = isect_pair::<F>(direction, &spheres[sphere], objects[sphere], *hit);
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

/// Rays close to -z.
fn rays(random: &mut ChaCha8Rng) -> Vectors {
    std::array::from_fn(|_| {
        let [x, y] = [(); 2].map(|()| random.random_range(-0.3..0.3));
        unit([x, y, -1.0]).map(from_f64)
    })
}

/// A random sphere around z = -6 and near the z axis.
fn sphere<S: Seen>(random: &mut ChaCha8Rng) -> S {
    let [x, y, z] = [(); 3].map(|()| random.random_range(-2.0..2.0));
    S::at([x, y, z - 6.0], random.random_range(0.1..1.5))
}

fn straight(hit: Hit) -> Packet {
    let forward = [0.0, 0.0, -1.0].map(from_f64);
    eye_records::packet(&[forward; 16], &[hit; 16])
}

fn the_nearest_of_many_in_lists_of_any_length<F: ForTheEye<Sphere: Seen>>() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut hit_objects = BTreeSet::new();
    for _ in 0..30 {
        for count in COUNTS.into_iter().chain([0]) {
            let before = Hit { t: from_f64(random.random_range(1.0..20.0)), object: 7 };
            let packets: Vec<Packet> = (0..random.random_range(1..5))
                .map(|_| eye_records::packet(&rays(&mut random), &[before; 16]))
                .collect();
            let spheres: Vec<F::Sphere> = (0..12).map(|_| sphere(&mut random)).collect();
            let pairs: Vec<[usize; 2]> = (0..count)
                .map(|_| [spheres.len(), packets.len()].map(|end| random.random_range(0..end)))
                .collect();
            let (hits, objects) = check::<F>(&mut bench, &packets, &spheres, &pairs);
            for hit in hits.iter().flatten() {
                hit_objects.extend(objects.iter().position(|object| *object == hit.object));
            }
        }
    }
    assert_eq!(hit_objects.len(), 12, "only {hit_objects:?} were hit");
}

fn a_packet_in_pair_after_pair_keeps_its_nearest_hit<F: ForTheEye<Sphere: Seen>>() {
    let mut random = random();
    let mut bench = Bench::new();
    let distances: Vec<f64> = (0..40).map(|step| 5.0 + f64::from(step)).collect();
    let spheres: Vec<F::Sphere> =
        distances.iter().map(|distance| F::Sphere::at([0.0, 0.0, -distance], 1.0)).collect();
    let none = Hit { t: FARTHEST, object: 7 };
    for count in COUNTS {
        let farther: Vec<[usize; 2]> = (0..count).map(|sphere| [sphere, 0]).collect();
        let nearer: Vec<[usize; 2]> = farther.iter().rev().copied().collect();
        for pairs in [farther, nearer] {
            let (hits, objects) = check::<F>(&mut bench, &[straight(none)], &spheres, &pairs);
            assert!(hits[0].iter().all(|hit| hit.object == objects[0]));
        }
        // In runs of random length, mixed with other packets.
        let mut packet = 0;
        let pairs: Vec<[usize; 2]> = (0..count)
            .map(|_| {
                if random.random_range(0..3) == 0 {
                    packet = random.random_range(0..3);
                }
                [random.random_range(0..spheres.len()), packet]
            })
            .collect();
        check::<F>(&mut bench, &[straight(none); 3], &spheres, &pairs);
    }
}

fn ulps_around_a_tangent_equal_the_twin<F: ForTheEye<Sphere: Seen>>() {
    let mut bench = Bench::new();
    let rays = std::array::from_fn(|lane| {
        // By ulps, or by more for formulations that lose digits.
        let step = if lane % 2 == 0 { -26 } else { -20 };
        let sine: f64 = 0.2 + (lane as f64 - 8.0) * 2_f64.powi(step);
        unit([sine, 0.0, -(1.0 - sine * sine).sqrt()]).map(from_f64)
    });
    let packet = eye_records::packet(&rays, &error::NO_HITS);
    let sphere = F::Sphere::at([0.0, 0.0, -5.0], 1.0);
    let (hits, objects) = check::<F>(&mut bench, &[packet], &[sphere], &[[0, 0]]);
    let hit = hits[0].map(|hit| hit.object == objects[0]);
    assert!(hit.contains(&true) && hit.contains(&false), "{hit:?}");
}

fn all_that_an_eye_and_a_sphere_can_be_to_each_other<F: ForTheEye<Sphere: Seen>>() {
    let mut bench = Bench::new();
    let cases: [(&str, F::Sphere, bool); 11] = [
        ("ahead", F::Sphere::at([0.0, 0.0, -5.0], 1.0), true),
        ("behind", F::Sphere::at([0.0, 0.0, 5.0], 1.0), false),
        ("around the eye", F::Sphere::at([0.0, 0.0, -0.5], 1.0), false),
        ("at the eye", F::Sphere::at([0.0; 3], 1.0), false),
        ("tangent", F::Sphere::at([1.0, 0.0, -5.0], 1.0), true),
        ("tangent at the eye", F::Sphere::at([1.0, 0.0, 0.0], 1.0), true),
        ("beside", F::Sphere::at([3.0, 0.0, -5.0], 1.0), false),
        ("beside and behind", F::Sphere::at([3.0, 0.0, 5.0], 1.0), false),
        ("tiny and far", F::Sphere::at([0.0, 0.0, -4096.0], 1.0 / 16.0), true),
        ("huge", F::Sphere::at([0.0, 0.0, -1e9], 0.999e9), true),
        (
            "at the limit of the domain",
            F::Sphere::at([0.0, 0.0, -(2_f64.powi(62))], 2_f64.powi(60)),
            true,
        ),
    ];
    for (name, sphere, is_hit) in cases {
        let touches = name.starts_with("tangent");
        // From 1/1000 of the radius away.
        let rounded_off = name == "huge" && F::DOMAIN.rough > 1e-3;
        if touches && !F::DOMAIN.touches || rounded_off {
            continue;
        }
        let packet = straight(Hit { t: FARTHEST, object: 7 });
        let (hits, objects) = check::<F>(&mut bench, &[packet], &[sphere], &[[0, 0]]);
        let object = if is_hit { objects[0] } else { 7 };
        for hit in hits[0] {
            assert_eq!(hit.object, object, "{name}: {hit:x?}");
        }
    }
}

fn an_entry_counts_at_0_but_not_at_what_was_there<F: ForTheEye<Sphere: Seen>>() {
    let mut bench = Bench::new();
    if !F::DOMAIN.touches {
        return;
    }
    let touching = F::Sphere::at([1.0, 0.0, 0.0], 1.0);
    let mut hit_before = |t| {
        let packet = straight(Hit { t, object: 7 });
        let (hits, _) = check::<F>(&mut bench, &[packet], &[touching], &[[0, 0]]);
        hits[0][0]
    };
    let first = hit_before(from_f64(1.0));
    assert_eq!(first.t, 0);
    assert_ne!(first.object, 7);
    assert_eq!(hit_before(0).object, 7, "a hit as near was replaced");
}

fn sensible_rays_equal_the_twin<F: ForTheEye<Sphere: Seen>>() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut hit_count = 0;
    for _ in 0..1000 {
        let (rays, sphere) = around_a_sphere::<F>(&mut random);
        let packet = eye_records::packet(&rays, &error::NO_HITS);
        let (hits, objects) = check::<F>(&mut bench, &[packet], &[sphere], &[[0, 0]]);
        for hit in hits[0].iter().filter(|hit| hit.object == objects[0]) {
            assert!(to_f64(hit.t) > 0.0);
            hit_count += 1;
        }
    }
    assert!((4000..15_000).contains(&hit_count), "{hit_count} of 16000");
}

fn any_bits_at_all_equal_the_twin<F: ForTheEye<Sphere: Seen>>() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let packets: Vec<Packet> =
            (0..2).map(|_| eye_records::packet(&random.random(), &any_bits(&mut random))).collect();
        let spheres: Vec<F::Sphere> = (0..4).map(|_| any_bits(&mut random)).collect();
        let pairs: Vec<[usize; 2]> = (0..8).map(|pair| [pair % 4, pair / 4]).collect();
        check::<F>(&mut bench, &packets, &spheres, &pairs);
    }
}

/// The tests of every formulation.
macro_rules! asked_of_all {
    ($module:ident, $formulation:ty: $($test:ident)*) => {
        mod $module {
            use super::*;
            $(
                #[test]
                fn $test() {
                    super::$test::<$formulation>();
                }
            )*
        }
    };
    ($($module:ident: $formulation:ty;)*) => {
        $(asked_of_all! { $module, $formulation:
            the_nearest_of_many_in_lists_of_any_length
            a_packet_in_pair_after_pair_keeps_its_nearest_hit
            ulps_around_a_tangent_equal_the_twin
            all_that_an_eye_and_a_sphere_can_be_to_each_other
            an_entry_counts_at_0_but_not_at_what_was_there
            sensible_rays_equal_the_twin
            any_bits_at_all_equal_the_twin
        })*
    };
}

asked_of_all! {
    by_perpendicular: Perpendicular;
    by_paper: Paper;
    by_estimate: Estimate;
    by_interpolated: Interpolated;
    by_newton2: Newton2;
    by_stable: Stable;
    by_factored: Factored;
    by_constants: Constants;
    by_refined: Refined;
    by_unnormalised: Unnormalised;
    in_double: InDouble;
}
