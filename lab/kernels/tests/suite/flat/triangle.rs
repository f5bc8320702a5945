//! `shear_r16`, `isect_triangles_r16`, `any_triangles_r16`, `isect_triangle_r1`: compared with
//! their twin bit for bit, and with `f64`. `watertight.rs` tests that meshes are watertight.

use super::rays::{code, keeps_stated_errors, sheared};
use kernels::cases::flat::error::error_of_shear;
use kernels::cases::flat::{aimed_at_triangle, on_triangle, put_triangles};
use kernels::description::any_bits;
use kernels::flat_records::{self, OneRay, Point, Ray, Rays, point};
use kernels::vector::{in_cube, ulps, unit};
use kernels::{Bench, random};
use rand::Rng;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::flat::FlatHit;
use twins::triangle::{Shear, Triangle, any_triangle, isect_triangles, shear};
use zerocopy::IntoBytes as _;

/// Runs the kernels on sixteen rays, compares every lane with the twin, and returns the hits.
fn check(
    bench: &mut Bench,
    random: &mut impl Rng,
    rays: &[Ray; 16],
    triangles: &[Triangle],
    first: u32,
) -> [FlatHit; 16] {
    let packed = Rays::pack(rays);
    let sheared = sheared(bench, &[packed]).remove(0);
    let shears: [Shear; 16] = std::array::from_fn(|lane| {
        let expected = shear(rays[lane].origin, rays[lane].direction);
        assert_eq!(flat_records::shear(&sheared, lane), expected, "{:x?}", rays[lane]);
        expected
    });

    let triangles_place = put_triangles(bench, triangles.iter().copied(), || random.random());
    let rays_place = bench.place(packed.as_bytes());
    let shear_place = bench.place(sheared.as_bytes());
    let arguments = [
        rays_place.address,
        shear_place.address,
        triangles_place.address,
        triangles.len() as u32,
        first,
    ];
    let blocked = bench.call("any_triangles_r16", &arguments[..4]).value;
    let expected = std::array::from_fn(|lane| {
        any_triangle(&shears[lane], triangles, rays[lane].hit.t) && (to_f64(rays[lane].hit.t) > 0.0)
    });
    assert_eq!(blocked, code(expected), "{rays:x?}, {triangles:x?}");

    bench.call("isect_triangles_r16", &arguments);
    let found = bench.read::<Rays>(rays_place).hits();
    for lane in 0..16 {
        let expected = isect_triangles(&shears[lane], triangles, first, rays[lane].hit);
        assert_eq!(found[lane], expected, "{:x?}, {triangles:x?}", rays[lane]);
    }

    if !triangles.is_empty() {
        let lane = random.random_range(0..16);
        let number = random.random_range(0..triangles.len());
        let ray = &rays[lane];
        let one = one_ray(bench, random, ray, &triangles[number], first);
        let expected = isect_triangles(&shears[lane], &triangles[number..=number], first, ray.hit);
        assert_eq!(one, expected, "{ray:x?}, {:x?}", triangles[number]);
    }
    found
}

fn one_ray(
    bench: &mut Bench,
    random: &mut impl Rng,
    ray: &Ray,
    triangle: &Triangle,
    object: u32,
) -> FlatHit {
    let ray = bench.place(OneRay::new(ray, random).as_bytes());
    let triangle = put_triangles(bench, [*triangle], || random.random());
    bench.call("isect_triangle_r1", &[ray.address, triangle.address, object]);
    bench.read::<OneRay>(ray).hit()
}

#[test]
fn equals_its_twin_and_keeps_its_error_bounds() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut worst_t, mut worst_uv, mut worst_slope, mut hits) = (0.0_f64, 0.0_f64, 0.0_f64, 0);
    for _ in 0..2000 {
        let cases: [(Ray, Triangle); 16] = std::array::from_fn(|_| aimed_at_triangle(&mut random));
        let rays = cases.map(|(ray, _)| ray);
        let triangles = cases.map(|(_, triangle)| triangle);
        let shears = sheared(&mut bench, &[Rays::pack(&rays)]).remove(0);
        for (lane, hit) in check(&mut bench, &mut random, &rays, &triangles, 1).iter().enumerate() {
            let ray = &rays[lane];
            assert_ne!(hit.object, 0, "{ray:x?} misses what it is aimed at");
            worst_slope = worst_slope.max(error_of_shear(ray, &shears, lane));
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
fn the_nearest_of_many() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut numbers = std::collections::BTreeSet::new();
    for _ in 0..300 {
        let count = random.random_range(0..30);
        let triangles: Vec<Triangle> = (0..count)
            .map(|_| {
                let depth = random.random_range(-9.0..9.0);
                std::array::from_fn(|_| {
                    let [x, y, _] = in_cube(3.0, &mut random);
                    point([x, y, depth])
                })
            })
            .collect();
        let rays = std::array::from_fn(|_| {
            let [x, y, _] = in_cube(1.0, &mut random);
            let mut ray = Ray::new(point([y, x, 0.0]), point(unit([x, y, 3.0])));
            ray.hit.t = from_f64(random.random_range(0.0..20.0));
            ray.hit.object = 7;
            ray
        });
        for hit in check(&mut bench, &mut random, &rays, &triangles, 100) {
            numbers.insert(hit.object);
        }
    }
    assert!(numbers.len() > 25, "only {numbers:?} were hit");
}

#[test]
fn triangle_ray_relations_give_expected_hits() {
    let mut random = random();
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
                let hits = check(&mut bench, &mut random, &[ray; 16], &[triangle], 1);
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
        let [hit, ..] = check(&mut bench, &mut random, &[ray; 16], &[triangle], 1);
        for (ulps, object) in [(0, 7), (1, 2)] {
            ray.hit = FlatHit { t: hit.t + ulps, object: 7, ..hit };
            let [again, ..] = check(&mut bench, &mut random, &[ray; 16], &[triangle], 2);
            assert_eq!(again.object, object, "{ulps} ulp, {ray:x?}, {triangle:x?}");
        }
    }
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut hits = 0;
    for _ in 0..3000 {
        let rays = any_bits(&mut random);
        let triangles: Vec<Triangle> =
            (0..random.random_range(1..20)).map(|_| -> [Point; 3] { random.random() }).collect();
        let found = check(&mut bench, &mut random, &rays, &triangles, 1);
        hits += found.iter().filter(|hit| hit.object < 20).count();
    }
    assert!(hits > 1000, "junk hit only {hits} times");
}
