//! `isect_pairs_r16` and the kernels of the other formulations.

use kernels::cases::eye::error::NO_HITS;
use kernels::cases::eye::formulation::Seen;
use kernels::cases::eye::pairs::Pairs;
use kernels::cases::formulation::ForTheEye;
use kernels::cases::sphere_ray::unit;
use kernels::eye_records::Hits;
use kernels::prelude::*;
use twins::isect_pairs::Hit;
use twins::sphere::{
    Constants, Estimate, Factored, InDouble, Interpolated, Newton2, Paper, Perpendicular, Refined,
    Stable, Unnormalised,
};

/// A packet of rays along -z whose hits so far are at this distance.
fn straight(t: Single) -> (Vectors, Hits) {
    ([[0.0, 0.0, -1.0].map(from_f64); 16], [Hit { t, object: 7 }; 16])
}

fn one_sphere<F: ForTheEye<Sphere: Seen>>(packet: (Vectors, Hits), sphere: F::Sphere) -> Pairs<F> {
    Pairs { packets: vec![packet], spheres: vec![sphere], pairs: vec![[0, 0]] }
}

fn a_packet_in_pair_after_pair_keeps_its_nearest_hit<F: ForTheEye<Sphere: Seen>>() {
    let mut bench = Bench::new();
    let spheres: Vec<F::Sphere> =
        (0..40).map(|step| F::Sphere::at([0.0, 0.0, -5.0 - f64::from(step)], 1.0)).collect();
    for count in [1, 2, 3, 7, 16, 40] {
        let farther: Vec<[usize; 2]> = (0..count).map(|sphere| [sphere, 0]).collect();
        let nearer: Vec<[usize; 2]> = farther.iter().rev().copied().collect();
        for pairs in [farther, nearer] {
            let packets = vec![straight(FARTHEST)];
            let inputs = Pairs::<F> { packets, spheres: spheres.clone(), pairs };
            assert_eq!(inputs.hits(&mut bench), [[Some(0); 16]]);
        }
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
    let sphere = F::Sphere::at([0.0, 0.0, -5.0], 1.0);
    let hits = one_sphere::<F>((rays, NO_HITS), sphere).hits(&mut bench)[0];
    assert!(hits.contains(&Some(0)) && hits.contains(&None), "{hits:?}");
}

fn eye_sphere_relations_give_expected_hits<F: ForTheEye<Sphere: Seen>>() {
    let mut bench = Bench::new();
    let cases: [(&str, F::Sphere, bool); 11] = [
        ("ahead", F::Sphere::at([0.0, 0.0, -5.0], 1.0), true),
        ("behind the eye", F::Sphere::at([0.0, 0.0, 5.0], 1.0), false),
        ("around the eye", F::Sphere::at([0.0, 0.0, -0.5], 1.0), false),
        ("at the eye", F::Sphere::at([0.0; 3], 1.0), false),
        ("tangent", F::Sphere::at([1.0, 0.0, -5.0], 1.0), true),
        ("tangent at the eye", F::Sphere::at([1.0, 0.0, 0.0], 1.0), true),
        ("beside", F::Sphere::at([3.0, 0.0, -5.0], 1.0), false),
        ("beside and behind the eye", F::Sphere::at([3.0, 0.0, 5.0], 1.0), false),
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
        let hits = one_sphere::<F>(straight(FARTHEST), sphere).hits(&mut bench);
        assert_eq!(hits, [[is_hit.then_some(0); 16]], "{name}");
    }
}

fn an_entry_counts_at_0_but_not_at_what_was_there<F: ForTheEye<Sphere: Seen>>() {
    let mut bench = Bench::new();
    if !F::DOMAIN.touches {
        return;
    }
    let touching = F::Sphere::at([1.0, 0.0, 0.0], 1.0);
    let mut hit_before = |t| one_sphere::<F>(straight(t), touching).check(&mut bench)[0].1[0];
    let first = hit_before(from_f64(1.0));
    assert_eq!(first.t, 0);
    assert_ne!(first.object, 7);
    assert_eq!(hit_before(0).object, 7, "a hit as near was replaced");
}

/// The tests of every formulation.
macro_rules! tests_of_formulations {
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
        $(tests_of_formulations! { $module, $formulation:
            a_packet_in_pair_after_pair_keeps_its_nearest_hit
            ulps_around_a_tangent_equal_the_twin
            eye_sphere_relations_give_expected_hits
            an_entry_counts_at_0_but_not_at_what_was_there
        })*
    };
}

tests_of_formulations! {
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
