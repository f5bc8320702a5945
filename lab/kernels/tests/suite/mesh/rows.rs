//! `mesh_eye_bounds_r16`, `filter_triangles_r16` and `isect_mesh_rows_r4` together find what the
//! test of every triangle with every ray finds.

use kernels::cases::whitted::isect;
use kernels::cases::whitted::isect::call::whole;
use kernels::cases::whitted::mesh::triangles::{FilterTriangles, IsectRows, aimed};
use kernels::prelude::*;
use twins::mesh::mesh_bound;
use twins::mesh_rows::{mesh_eye_bound, mesh_window};
use twins::primary_rays;
use twins::sphere_ray::Ray;

/// What `mesh_bounds_r16` makes of all rays of a packet from the eye, `mesh_eye_bounds_r16` makes.
#[test]
fn bounds_are_those_of_rays_from_anywhere() {
    let mut random = random();
    for _ in 0..400 {
        for rays in aimed(&mut random).1 {
            let there = rays.map(|ray| Ray { t: FARTHEST, ..ray });
            let from_anywhere = there.map(|ray| primary_rays::Ray {
                origin: ray.origin,
                direction: ray.direction,
                t: ray.t,
                object: 0,
                weight: ZERO,
                pixel: 0,
            });
            assert_eq!(mesh_eye_bound(&there), mesh_bound(&from_anywhere));
        }
    }
}

/// The hits are those of `isect_mesh_pairs_r16`, whose watertightness therefore is these kernels',
/// too: no ray to an edge or a vertex is left out.
#[test]
fn all_three_find_the_hits_of_every_ray_with_every_triangle() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut rays, mut hits, mut tested, mut rows_tested) = (0, 0, 0, 0);
    for _ in 0..randomness::rounds(375) {
        let (block, packets) = aimed(&mut random);
        let windows: Vec<_> = packets.iter().map(mesh_window).collect();
        let runs: Vec<_> = (0..packets.len())
            .flat_map(|packet| {
                (0..block.faces.len()).step_by(7).map(move |first| (first..first + 7, packet))
            })
            .collect();
        let filter =
            FilterTriangles { windows, block: block.clone(), runs: runs.clone(), anything: 0 };
        filter.check(&mut bench);
        let inputs = IsectRows {
            packets: packets.clone(),
            block: block.clone(),
            rows: filter.rows(),
            anything: 0,
        };
        let found = inputs.check(&mut bench);
        let mut every = packets.clone();
        for (run, packet) in &runs {
            for ray in &mut every[*packet] {
                *ray = block.isect_run(*ray, run.clone());
            }
        }
        assert_eq!(found, whole(&isect::call::packets(&every, 0)), "{block:x?}");
        rays += 16 * every.len();
        hits += every.iter().flatten().filter(|ray| ray.object != 0).count();
        tested += 4 * packets.len() * block.faces.len();
        rows_tested += inputs.rows.iter().flat_map(|of| of.rows).map(usize::from).sum::<usize>();
    }
    assert!(hits > rays / 3, "{hits} of {rays}");
    assert!(rows_tested < tested * 19 / 20, "{rows_tested} of {tested}");
}
