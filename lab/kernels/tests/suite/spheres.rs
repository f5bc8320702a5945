//! Calls the kernels of all formulations of spheres by name.

use std::collections::BTreeSet;

use kernels::cases::eye::formulation::Seen;
use kernels::cases::sphere_ray::case_rays;
use kernels::cases::spheres::{Distances, EyeSphere, cycles_a_ray, eye, general};
use kernels::cases::whitted::isect::sphere::{FRONT, sphere};
use kernels::catalogue;
use kernels::prelude::*;
use protocol::formulation::{EyeRecord, SPHERES};
use twins::sphere::Axis;
use twins::sphere_ray::BareSphere;

/// A sphere whose nearest point is 4 in front of the rays of the cases.
const CENTRE: [f64; 3] = [0.0, 0.0, -5.0];

fn all_about(expected: f64, found: &[Distances], kernel: &str) {
    assert_eq!(found.len(), 3, "{kernel}");
    for t in found.iter().flatten() {
        let t = to_f64(t.unwrap_or_else(|| panic!("{kernel}: a ray misses")));
        // The root of an estimate has an error of some hundredths, and a ray at the edge of the
        // packet is farther by a few thousandths.
        assert!((t - expected).abs() < 0.1, "{kernel}: {t}");
    }
}

#[test]
fn every_formulation_has_kernels_that_hit() {
    let mut bench = Bench::new();
    let rays = case_rays();
    let directions = rays.map(|ray| ray.direction);
    let beside = sphere([9.0, 0.0, -5.0], 1.0, FRONT);
    for formulation in SPHERES {
        if let Some(kernel) = formulation.general {
            let ahead = sphere(CENTRE, 1.0, FRONT);
            all_about(4.0, &general(&mut bench, kernel, &[rays; 3], &ahead), kernel);
            let missed = general(&mut bench, kernel, &[rays; 3], &beside);
            assert_eq!(missed, [[None; 16]; 3], "{kernel}");
        }
        if let Some(kernel) = formulation.eye {
            let at = |centre| -> EyeSphere {
                match formulation.record {
                    EyeRecord::Centre => BareSphere::at(centre, 1.0).words(),
                    EyeRecord::Axis => Axis::at(centre, 1.0).words(),
                }
            };
            all_about(4.0, &eye(&mut bench, kernel, &[directions; 3], &at(CENTRE)), kernel);
            let missed = eye(&mut bench, kernel, &[directions; 3], &at([9.0, 0.0, -5.0]));
            assert_eq!(missed, [[None; 16]; 3], "{kernel}");
        }
    }
}

#[test]
fn directions_of_any_length_scale_the_distance() {
    let mut bench = Bench::new();
    let ahead = sphere(CENTRE, 1.0, FRONT);
    let rays = case_rays().map(|mut ray| {
        ray.direction = ray.direction.map(|component| from_f64(to_f64(component) * 8.0));
        ray
    });
    let kernel = "isect_sphere_pairs_unnormalised_r16";
    let found = general(&mut bench, kernel, &[rays; 3], &ahead);
    all_about(0.5, &found, kernel);
}

#[test]
fn every_kernel_of_a_formulation_is_timed() {
    let mut bench = Bench::new();
    let formulations = SPHERES.iter();
    let named: BTreeSet<&str> = formulations
        .flat_map(|formulation| [formulation.general, formulation.eye])
        .flatten()
        .collect();
    for kernel in &named {
        let cycles = cycles_a_ray(&mut bench, kernel);
        let cycles = cycles.unwrap_or_else(|| panic!("{kernel} is not in the catalogue"));
        assert!((3.0..300.0).contains(&cycles), "{kernel}: {cycles}");
    }
    assert_eq!(cycles_a_ray(&mut bench, "isect_pairs_by_guess_r16"), None);
    let of_spheres =
        |name: &str| name.starts_with("isect_pairs") || name.starts_with("isect_sphere_pairs");
    let known = catalogue::kernels().map(|kernel| kernel.name);
    let known: BTreeSet<&str> = known.filter(|name| of_spheres(name)).collect();
    assert_eq!(named, known);
}
