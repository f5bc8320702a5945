//! `isect_sphere_pairs_r16` and the kernels of the other formulations.

use kernels::cases::formulation::ForAnyRay;
use kernels::cases::sphere_ray::ray;
use kernels::cases::whitted::isect::sphere::{By, sphere};
use twins::pairs::Sides;
use twins::sphere::{
    Estimate, Factored, InDouble, Interpolated, Newton2, Paper, Perpendicular, Refined, Stable,
    Unnormalised,
};

use super::{around_a_tangent, check};
use kernels::prelude::*;

/// A name, a sphere's centre and radius, and the distances at which a ray along -z from the origin
/// enters and leaves it.
type Case = (&'static str, [f64; 3], f64, Option<f64>, Option<f64>);

fn ray_sphere_relations_give_expected_hits<F: ForAnyRay>() {
    let mut bench = Bench::new();
    let cases: [Case; 12] = [
        ("ahead", [0.0, 0.0, -5.0], 1.0, Some(4.0), Some(6.0)),
        ("of a negative radius", [0.0, 0.0, -5.0], -1.0, Some(4.0), Some(6.0)),
        ("behind the origin", [0.0, 0.0, 5.0], 1.0, None, None),
        ("around, its centre ahead", [0.0, 0.0, -0.5], 1.0, None, Some(1.5)),
        ("around, its centre behind the origin", [0.0, 0.0, 0.5], 1.0, None, Some(0.5)),
        ("around, its centre here", [0.0; 3], 1.0, None, Some(1.0)),
        ("around, its centre beside", [0.6, 0.0, 0.0], 1.0, None, Some(0.8)),
        ("tangent", [1.0, 0.0, -5.0], 1.0, Some(5.0), Some(5.0)),
        ("beside", [3.0, 0.0, -5.0], 1.0, None, None),
        (
            "tiny and far",
            [0.0, 0.0, -4096.0],
            1.0 / 16.0,
            Some(4096.0 - 1.0 / 16.0),
            Some(4096.0 + 1.0 / 16.0),
        ),
        ("huge", [0.0, 0.0, -1e9], 0.999e9, Some(1e6), Some(1.999e9)),
        (
            "at the limit of the domain",
            [0.0, 0.0, -(2_f64.powi(61))],
            2_f64.powi(60),
            Some(2_f64.powi(60)),
            Some(3.0 * 2_f64.powi(60)),
        ),
    ];
    let straight = ray([0.0; 3], [0.0, 0.0, -1.0], FARTHEST);
    let domain = F::DOMAIN;
    for (name, centre, radius, enters, leaves) in cases {
        let radii = centre[2].abs() / radius.abs();
        let rounded_off = enters.is_some_and(|t| t < domain.rough * radius.abs());
        // In the last case, squares of squares are too large.
        let too_large = centre[2] < -1e15 && !domain.lengths.is_empty();
        if domain.farthest < radii.min(30.0)
            || rounded_off
            || too_large
            || name == "tangent" && !domain.touches
        {
            continue;
        }
        for (both, exit, expected) in [
            (false, false, enters),
            (false, true, leaves),
            (true, false, enters.or(leaves)),
            (true, true, enters.or(leaves)),
        ] {
            let sphere = sphere(centre, radius, Sides { both, exit });
            let (rays, objects) =
                check(&mut bench, &[[straight; 16]], &[By::<F>::from(sphere)], &[[0, 0]], 0);
            let found = (rays[0][0].object == objects[0]).then(|| to_f64(rays[0][0].t));
            assert_eq!(found.is_some(), expected.is_some(), "{name}: {found:?}");
            if let (Some(found), Some(expected)) = (found, expected) {
                let error = (found - expected).abs() / expected.max(radius.abs());
                assert!(error < domain.rough, "{name}: {found}, not {expected}");
            }
        }
    }
}

fn hit_at_distance_0_is_ignored<F: ForAnyRay>() {
    let mut bench = Bench::new();
    if !F::DOMAIN.touches {
        return;
    }
    // Both crossings are exactly at the origin of the ray.
    let straight = ray([0.0; 3], [0.0, 0.0, -1.0], FARTHEST);
    for (both, exit) in [(false, false), (false, true), (true, false)] {
        let sphere = sphere([1.0, 0.0, 0.0], 1.0, Sides { both, exit });
        let (rays, _) =
            check(&mut bench, &[[straight; 16]], &[By::<F>::from(sphere)], &[[0, 0]], 0);
        assert_eq!(rays[0][0], straight);
    }
}

fn ulps_around_a_tangent_equal_the_twin<F: ForAnyRay>() {
    let mut bench = Bench::new();
    let rays = std::array::from_fn(|lane| {
        let sine = 0.2 + around_a_tangent(lane);
        ray([0.0; 3], [sine, 0.0, -(1.0 - sine * sine).sqrt()], FARTHEST)
    });
    for both in [false, true] {
        let sphere = sphere([0.0, 0.0, -5.0], 1.0, Sides { both, exit: false });
        let (after, objects) = check(&mut bench, &[rays], &[By::<F>::from(sphere)], &[[0, 0]], 0);
        let hit = after[0].map(|ray| ray.object == objects[0]);
        assert!(hit.contains(&true) && hit.contains(&false), "{hit:?}");
    }
}

/// The tests of every formulation.
macro_rules! tests_of_formulations {
    ($($module:ident: $formulation:ty;)*) => {
        $(mod $module {
            use super::*;

            #[test]
            fn ray_sphere_relations_give_expected_hits() {
                super::ray_sphere_relations_give_expected_hits::<$formulation>();
            }

            #[test]
            fn hit_at_distance_0_is_ignored() {
                super::hit_at_distance_0_is_ignored::<$formulation>();
            }

            #[test]
            fn ulps_around_a_tangent_equal_the_twin() {
                super::ulps_around_a_tangent_equal_the_twin::<$formulation>();
            }
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
    by_refined: Refined;
    by_unnormalised: Unnormalised;
    in_double: InDouble;
}
