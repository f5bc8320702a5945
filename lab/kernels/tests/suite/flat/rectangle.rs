//! `isect_rectangle_r16`, `any_rectangle_r16`, `isect_plane_r16`: compared with their twin bit for
//! bit, and with `f64`.

use super::rays::{code, keeps_stated_errors};
use kernels::cases::flat::{around_rectangle, on_plane, put_rectangle, rectangle};
use kernels::description::any_bits;
use kernels::flat_records::{Ray, Rays, point};
use kernels::vector::ulps;
use kernels::{Bench, random};
use rand::Rng;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::flat::FlatHit;
use twins::rectangle::{Rectangle, any_rectangle, isect_plane, isect_rectangle};
use zerocopy::IntoBytes as _;

/// Runs the kernels on sixteen rays and compares every lane with the twin. Returns the hits on the
/// rectangle and on its plane.
fn check(
    bench: &mut Bench,
    random: &mut impl Rng,
    rays: &[Ray; 16],
    rectangle: &Rectangle,
) -> [[FlatHit; 16]; 2] {
    bench.reset();
    let rectangle_place = put_rectangle(bench, rectangle, || random.random());
    let places = [(); 2].map(|()| bench.place(Rays::pack(rays).as_bytes()));
    let object = random.random();

    let blocked = bench.call("any_rectangle_r16", &[places[0].address, rectangle_place.address]);
    let expected = rays.map(|ray| any_rectangle(ray.origin, ray.direction, rectangle, ray.hit.t));
    assert_eq!(blocked.value, code(expected), "{rays:x?}, {rectangle:x?}");

    let kernels = [
        ("isect_rectangle_r16", isect_rectangle as fn(_, _, &_, _, _) -> _),
        ("isect_plane_r16", isect_plane),
    ];
    std::array::from_fn(|number| {
        let (kernel, twin) = kernels[number];
        let place = places[number];
        bench.call(kernel, &[place.address, rectangle_place.address, object]);
        let found = bench.read::<Rays>(place).hits();
        for (ray, found) in rays.iter().zip(found) {
            let expected = twin(ray.origin, ray.direction, rectangle, object, ray.hit);
            assert_eq!(found, expected, "{kernel}: {ray:x?}, {rectangle:x?}");
        }
        found
    })
}

#[test]
fn equals_its_twin_and_keeps_its_error_bounds() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut worst_t, mut worst_uv, mut hits, mut by_plane) = (0.0_f64, 0.0_f64, 0, 0);
    let mut wrong = 0;
    for _ in 0..2000 {
        let (rectangle, rays, distance) = around_rectangle(&mut random);
        let [within, plane] = check(&mut bench, &mut random, &rays, &rectangle);
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
fn rectangle_ray_relations_give_expected_hits() {
    let mut random = random();
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
        let found = check(&mut bench, &mut random, &[ray; 16], &rectangle);
        for (found, expected) in found.into_iter().zip([within, plane]) {
            assert!(
                found.iter().all(|found| (found.t != ray.hit.t) == expected),
                "{name}: {found:x?}"
            );
        }
    }
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut hits = [0; 2];
    for _ in 0..3000 {
        let rays: [Ray; 16] = any_bits(&mut random);
        let rectangle = any_bits(&mut random);
        let found = check(&mut bench, &mut random, &rays, &rectangle);
        for (hits, found) in hits.iter_mut().zip(found) {
            *hits += rays.iter().zip(found).filter(|(ray, found)| ray.hit != *found).count();
        }
    }
    assert!(hits[0] > 5 && hits[1] > 1000, "junk hit only {hits:?} times");
}
