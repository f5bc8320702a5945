//! `shear_r16`, `isect_triangles_r16`, `any_triangles_r16`, `isect_triangle_r1`: compared with
//! `f64`. `watertight.rs` tests that meshes are watertight.

use super::keeps_stated_errors;
use kernels::cases::flat::error::error_of_shear;
use kernels::cases::flat::triangles::{One, Sheared, Triangles};
use kernels::cases::flat::{aimed_at_triangle, on_triangle};
use kernels::flat_records::Ray;
use kernels::prelude::*;
use kernels::vector::ulps;
use twins::flat::FlatHit;
use twins::triangle::Triangle;

/// Runs the kernels on sixteen rays and on the first of them, compares with the twins, and returns
/// the hits.
fn check(bench: &mut Bench, rays: [Ray; 16], triangles: &[Triangle], first: u32) -> [FlatHit; 16] {
    let triangles = triangles.to_vec();
    One { ray: rays[0], triangle: triangles[0], object: first }.check(bench);
    Triangles::<true> { rays, triangles: triangles.clone(), first }.check(bench);
    Triangles::<false> { rays, triangles, first }.check(bench).1
}

#[test]
fn hits_keep_their_error_bounds() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut worst_t, mut worst_uv, mut worst_slope, mut hits) = (0.0_f64, 0.0_f64, 0.0_f64, 0);
    for _ in 0..2000 {
        let cases: [(Ray, Triangle); 16] = std::array::from_fn(|_| aimed_at_triangle(&mut random));
        let rays = cases.map(|(ray, _)| ray);
        let triangles = cases.map(|(_, triangle)| triangle);
        let shears = Sheared { rays }.check(&mut bench);
        for (lane, hit) in check(&mut bench, rays, &triangles, 1).iter().enumerate() {
            let ray = &rays[lane];
            assert_ne!(hit.object, 0, "{ray:x?} misses what it is aimed at");
            worst_slope = worst_slope.max(error_of_shear(ray, &shears[lane]));
            // Another triangle may be in front of it, whose domain is not known.
            if hit.object as usize == lane + 1 {
                hits += 1;
                let [t, u, v] = on_triangle(ray, &triangles[lane]);
                worst_t = worst_t.max(ulps(to_f64(hit.t), t));
                worst_uv = worst_uv.max((to_f64(hit.u) - u).abs()).max((to_f64(hit.v) - v).abs());
            }
        }
    }
    println!("{hits} hits");
    assert!(hits > 25_000, "too few hits within the domain");
    keeps_stated_errors("shear_r16", &[worst_slope]);
    keeps_stated_errors("isect_triangles_r16", &[worst_t, worst_uv]);
}

#[test]
fn behind_beyond_along_and_without_size() {
    let mut bench = Bench::new();
    let flat =
        |depth: f64| [[-1.0, -1.0, depth], [3.0, -1.0, depth], [-1.0, 3.0, depth]].map(point);
    let through = |points: [[f64; 3]; 3]| points.map(point);
    let far = 2_f64.powi(59);
    let cases: [(&str, Triangle, f64, bool); 14] = [
        ("ahead", flat(5.0), 1e9, true),
        (
            "from its other side",
            through([[-1.0, -1.0, 5.0], [-1.0, 3.0, 5.0], [3.0, -1.0, 5.0]]),
            1e9,
            true,
        ),
        ("behind the origin", flat(-5.0), 1e9, false),
        ("where the ray begins", flat(0.0), 1e9, false),
        ("just ahead", flat(1e-30), 1e9, true),
        ("beyond what is allowed", flat(5.0), 4.9999, false),
        ("just within what is allowed", flat(5.0), 5.0001, true),
        ("nothing is allowed", flat(5.0), 0.0, false),
        (
            "an edge through the ray",
            through([[0.0, -1.0, 5.0], [0.0, 3.0, 5.0], [3.0, 0.0, 5.0]]),
            1e9,
            true,
        ),
        (
            "a vertex on the ray",
            through([[0.0, 0.0, 5.0], [0.0, 3.0, 5.0], [3.0, 0.0, 5.0]]),
            1e9,
            true,
        ),
        (
            "the ray within it",
            through([[0.0, -1.0, 5.0], [0.0, 3.0, 5.0], [0.0, 0.0, 9.0]]),
            1e9,
            false,
        ),
        ("one point", through([[0.0, 0.0, 5.0]; 3]), 1e9, false),
        ("one line", through([[-1.0, 0.0, 5.0], [1.0, 0.0, 5.0], [3.0, 0.0, 5.0]]), 1e9, false),
        (
            "as large as may be",
            through([[-far, -far, far], [far, -far, far], [0.0, far, far]]),
            1e30,
            true,
        ),
    ];
    for (name, triangle, farthest, hit) in cases {
        // Along each axis in both directions. The scene turns with the ray.
        for turn in 0..3 {
            for way in [1.0, -1.0] {
                let turned = |from: [f64; 3]| {
                    let mut to = [0.0; 3];
                    for axis in 0..3 {
                        to[(axis + turn) % 3] = from[axis] * way;
                    }
                    point(to)
                };
                let mut ray = Ray::new(point([0.0; 3]), turned([0.0, 0.0, 1.0]));
                ray.hit.t = from_f64(farthest);
                let triangle = triangle.map(|vertex| turned(vertex.map(to_f64)));
                let hits = check(&mut bench, [ray; 16], &[triangle], 1);
                assert!(
                    hits.iter().all(|found| (found.object == 1) == hit),
                    "{name}, turned by {turn}, {way}: {hits:x?}"
                );
            }
        }
    }
}

#[test]
fn a_hit_has_to_be_nearer_than_the_last() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..100 {
        let (mut ray, triangle) = aimed_at_triangle(&mut random);
        let [hit, ..] = check(&mut bench, [ray; 16], &[triangle], 1);
        for (ulps, object) in [(0, 7), (1, 2)] {
            ray.hit = FlatHit { t: hit.t + ulps, object: 7, ..hit };
            let [again, ..] = check(&mut bench, [ray; 16], &[triangle], 2);
            assert_eq!(again.object, object, "{ulps} ulp, {ray:x?}, {triangle:x?}");
        }
    }
}
