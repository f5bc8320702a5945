//! `shear_r16`, `isect_triangles_r16`, `any_triangles_r16`, `isect_triangle_r1`: against their twin
//! bit for bit and against `f64`. That meshes are watertight is tested in `watertight.rs`.

use crate::rays::{
    Point, Ray, Rays, code, cross, dot, in_cube, keeps_stated_errors, less, magnitude, point, quad,
    sheared, ulps, unit,
};
use kernels::single::{bits, single};
use kernels::{Bench, random};
use oracle::twin::flat::FlatHit;
use oracle::twin::triangle::{Shear, Triangle, any_triangle, isect_triangles, shear};
use rand::Rng;
use spu_emulator::float::single::{from_f64, to_f64};
use zerocopy::big_endian::{F32, U32};
use zerocopy::{FromBytes, FromZeros as _, Immutable, IntoBytes, KnownLayout, Unaligned};

#[derive(FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct RayRecord {
    origin: [F32; 4],
    direction: [F32; 4],
    t: [F32; 4],
    object: [U32; 4],
    u: [F32; 4],
    v: [F32; 4],
}

/// Runs the kernels on sixteen rays, compares every lane with the twin, and gives the hits.
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
        assert_eq!(sheared.lane(lane), expected, "{:x?}", rays[lane]);
        expected
    });

    let records: Vec<[[F32; 4]; 3]> = triangles
        .iter()
        .map(|triangle| triangle.map(|vertex| quad(vertex, random)))
        .collect();
    let triangles_place = bench.place(records.as_bytes());
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
    let mut record = RayRecord::new_zeroed();
    random.fill(record.as_mut_bytes());
    record.origin = quad(ray.origin, random);
    record.direction = quad(ray.direction, random);
    record.t[0] = single(ray.hit.t);
    record.object[0] = ray.hit.object.into();
    record.u[0] = single(ray.hit.u);
    record.v[0] = single(ray.hit.v);
    let ray_place = bench.place(record.as_bytes());
    let record = triangle.map(|vertex| quad(vertex, random));
    let triangle_place = bench.place(record.as_bytes());
    bench.call(
        "isect_triangle_r1",
        &[ray_place.address, triangle_place.address, object],
    );
    let record: RayRecord = bench.read(ray_place);
    FlatHit {
        t: bits(record.t[0]),
        object: record.object[0].get(),
        u: bits(record.u[0]),
        v: bits(record.v[0]),
    }
}

/// t, u, v where the ray meets the triangle's plane, in f64 for the very singles that the kernel was
/// given (Möller and Trumbore).
fn exact(ray: &Ray, triangle: &Triangle) -> [f64; 3] {
    let [a, b, c] = triangle.map(|vertex| vertex.map(to_f64));
    let direction = ray.direction.map(to_f64);
    let (first, second) = (less(a, c), less(b, c));
    let beside = less(ray.origin.map(to_f64), c);
    let across = cross(direction, second);
    let turned = cross(beside, first);
    let determinant = dot(first, across);
    [
        dot(second, turned) / determinant,
        dot(beside, across) / determinant,
        dot(direction, turned) / determinant,
    ]
}

/// A triangle of the stated domain and a ray to a point in it.
fn in_domain(random: &mut impl Rng) -> (Ray, Triangle) {
    let origin = point(in_cube(10.0, random));
    loop {
        let distance = magnitude(1.0..100.0, random);
        let size = distance * magnitude(0.01..1.0, random);
        let towards = unit(in_cube(1.0, random));
        let triangle: Triangle = std::array::from_fn(|_| {
            let offset = in_cube(size / 2.0, random);
            point(std::array::from_fn(|axis| {
                to_f64(origin[axis]) + distance * towards[axis] + offset[axis]
            }))
        });
        let [a, b, c] = triangle.map(|vertex| vertex.map(to_f64));
        let mut weights: [f64; 3] = std::array::from_fn(|_| random.random_range(0.01..1.0));
        let sum: f64 = weights.iter().sum();
        weights = weights.map(|weight| weight / sum);
        let target: [f64; 3] = std::array::from_fn(|axis| {
            weights[0] * a[axis] + weights[1] * b[axis] + weights[2] * c[axis]
        });
        let direction = unit(less(target, origin.map(to_f64)));
        // How large it looks: twice its area across the ray, by its size.
        let seen = dot(cross(less(a, c), less(b, c)), direction).abs();
        if seen > 0.1 * size * size {
            return (Ray::new(origin, point(direction)), triangle);
        }
    }
}

#[test]
fn equals_its_twin_and_keeps_its_error_bounds() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut worst_t, mut worst_uv, mut worst_slope, mut hits) = (0.0_f64, 0.0_f64, 0.0_f64, 0);
    for _ in 0..2000 {
        let cases: [(Ray, Triangle); 16] = std::array::from_fn(|_| in_domain(&mut random));
        let rays = cases.map(|(ray, _)| ray);
        let triangles = cases.map(|(_, triangle)| triangle);
        for (lane, hit) in check(&mut bench, &mut random, &rays, &triangles, 1)
            .iter()
            .enumerate()
        {
            let ray = &rays[lane];
            assert_ne!(hit.object, 0, "{ray:x?} misses what it is aimed at");
            let shear = shear(ray.origin, ray.direction);
            let [x, y, z] = shear.axes.map(|axis| to_f64(ray.direction[axis]));
            for (slope, exact) in shear.slopes.into_iter().zip([x / z, y / z]) {
                worst_slope = worst_slope.max((to_f64(slope) - exact).abs() * 2_f64.powi(23));
            }
            worst_slope = worst_slope.max(ulps(to_f64(shear.minus_per_z), -1.0 / z));
            // Another triangle may stand before it: then that one's domain is not known.
            if hit.object as usize == lane + 1 {
                hits += 1;
                let [t, u, v] = exact(ray, &triangles[lane]);
                worst_t = worst_t.max(ulps(to_f64(hit.t), t));
                worst_uv = worst_uv
                    .max((to_f64(hit.u) - u).abs())
                    .max((to_f64(hit.v) - v).abs());
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
fn behind_beyond_along_and_without_size() {
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
        ("behind", flat(-5.0), 1e9, false),
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
        (
            "one line",
            through([[-1.0, 0.0, 5.0], [1.0, 0.0, 5.0], [3.0, 0.0, 5.0]]),
            1e9,
            false,
        ),
        (
            "as large as may be",
            through([[-far, -far, far], [far, -far, far], [0.0, far, far]]),
            1e30,
            true,
        ),
    ];
    for (name, triangle, farthest, hit) in cases {
        // Along each axis, either way: the scene turned with the ray.
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
        let (mut ray, triangle) = in_domain(&mut random);
        let [hit, ..] = check(&mut bench, &mut random, &[ray; 16], &[triangle], 1);
        for (ulps, object) in [(0, 7), (1, 2)] {
            ray.hit = FlatHit {
                t: hit.t + ulps,
                object: 7,
                ..hit
            };
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
        let rays = std::array::from_fn(|_| Ray::junk(&mut random));
        let triangles: Vec<Triangle> = (0..random.random_range(1..20))
            .map(|_| -> [Point; 3] { random.random() })
            .collect();
        let found = check(&mut bench, &mut random, &rays, &triangles, 1);
        hits += found.iter().filter(|hit| hit.object < 20).count();
    }
    assert!(hits > 1000, "junk hit only {hits} times");
}
