//! `isect_rectangle_r16`, `any_rectangle_r16`, `isect_plane_r16`: compared with `f64`.

use super::keeps_stated_errors;
use kernels::cases::flat::rectangles::{ANY, NEAREST, PLANE, WithRectangle};
use kernels::cases::flat::{around_rectangle, on_plane, rectangle};
use kernels::flat_records::Ray;
use kernels::prelude::*;
use kernels::vector::ulps;
use twins::flat::FlatHit;
use twins::rectangle::Rectangle;

/// Runs the kernels on sixteen rays and compares with the twins. Returns the hits on the rectangle
/// and on its plane.
fn check(bench: &mut Bench, rays: [Ray; 16], rectangle: Rectangle) -> [[FlatHit; 16]; 2] {
    let object = 7;
    WithRectangle::<ANY> { rays, rectangle, object }.check(bench);
    let (_, within) = WithRectangle::<NEAREST> { rays, rectangle, object }.check(bench);
    let (_, plane) = WithRectangle::<PLANE> { rays, rectangle, object }.check(bench);
    [within, plane]
}

#[test]
fn hits_keep_their_error_bounds() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut worst_t, mut worst_uv, mut hits, mut by_plane) = (0.0_f64, 0.0_f64, 0, 0);
    let mut wrong = 0;
    for _ in 0..2000 {
        let (rectangle, rays, distance) = around_rectangle(&mut random);
        let [within, plane] = check(&mut bench, rays, rectangle);
        for ((ray, within), plane) in rays.iter().zip(within).zip(plane) {
            let ([t, u, v], incidence) = on_plane(ray, &rectangle);
            if incidence < 0.1 || t < distance / 2.0 {
                continue;
            }
            by_plane += 1;
            assert_ne!(plane.t, ray.hit.t, "{ray:x?} misses the plane");
            let error = (to_f64(plane.u) - u).abs().max((to_f64(plane.v) - v).abs());
            worst_t = worst_t.max(ulps(to_f64(plane.t), t));
            worst_uv = worst_uv.max(error);
            let inside = (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v);
            if inside == (within.t != ray.hit.t) {
                hits += u32::from(inside);
            } else {
                wrong += 1;
                // Only where rounding decides.
                let beyond = [u, 1.0 - u, v, 1.0 - v].map(f64::abs);
                assert!(beyond.iter().any(|beyond| *beyond <= error), "{u}, {v} are taken wrongly");
            }
        }
    }
    println!("{by_plane} hits of planes, {hits} of rectangles, {wrong} wrong");
    assert!(by_plane > 15_000 && hits > 4000, "too few hits within the domain");
    keeps_stated_errors("isect_rectangle_r16", &[worst_t, worst_uv]);
    keeps_stated_errors("isect_plane_r16", &[worst_t, worst_uv]);
}

/// Name, rectangle, origin, direction, distance limit, and whether the rectangle and its plane are
/// hit.
type Case = (&'static str, Rectangle, [f64; 3], [f64; 3], f64, bool, bool);

#[test]
fn sides_edges_behind_and_along() {
    let mut bench = Bench::new();
    let ahead = rectangle([-1.0, -1.0, 5.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]);
    let turned = rectangle([-1.0, -1.0, 5.0], [0.0, 2.0, 0.0], [2.0, 0.0, 0.0]);
    let forward = [0.0, 0.0, 1.0];
    let cases: [Case; 12] = [
        ("ahead", ahead, [0.0; 3], forward, 1e9, true, true),
        ("its other side", turned, [0.0; 3], forward, 1e9, true, true),
        ("beside", ahead, [1.5, 0.0, 0.0], forward, 1e9, false, true),
        ("on an edge", ahead, [1.0, 0.0, 0.0], forward, 1e9, true, true),
        ("on its corner", ahead, [-1.0, -1.0, 0.0], forward, 1e9, true, true),
        ("on its far corner", ahead, [1.0, 1.0, 0.0], forward, 1e9, true, true),
        ("behind the origin", ahead, [0.0, 0.0, 9.0], forward, 1e9, false, false),
        ("where the ray begins", ahead, [0.0, 0.0, 5.0], forward, 1e9, false, false),
        ("beyond what is allowed", ahead, [0.0; 3], forward, 4.9999, false, false),
        ("nothing is allowed", ahead, [0.0; 3], forward, 0.0, false, false),
        ("along it", ahead, [0.0; 3], [1.0, 0.0, 0.0], 1e30, false, false),
        ("within it", ahead, [-3.0, 0.0, 5.0], [1.0, 0.0, 0.0], 1e30, false, false),
    ];
    for (name, rectangle, origin, direction, farthest, within, plane) in cases {
        let mut ray = Ray::new(point(origin), point(direction));
        ray.hit.t = from_f64(farthest);
        let found = check(&mut bench, [ray; 16], rectangle);
        for (found, expected) in found.into_iter().zip([within, plane]) {
            assert!(
                found.iter().all(|found| (found.t != ray.hit.t) == expected),
                "{name}: {found:x?}"
            );
        }
    }
}
