//! The general sphere kernels: compared with their twin bit for bit for every relation of a ray
//! and a sphere, and for rays that leave a surface.

use kernels::cases::sphere_ray::{bare_sphere, case_rays, one_by_one, ray, together, truth, unit};
use kernels::prelude::*;
use kernels::records;
use twins::sphere_ray::{self as twin, BareSphere, Ray};

/// The object number that the calls of `kernels::cases::sphere_ray` pass.
const OBJECT: u32 = 77;

/// Calls every kernel that finds the nearest hit with one sphere. All must return the twin's bits.
fn check_nearest(bench: &mut Bench, rays: &[Ray; 16], sphere: &BareSphere) -> [Ray; 16] {
    let expected = rays.map(|ray| twin::nearest(ray, sphere, OBJECT));
    for (kernel, call) in [
        ("isect_sphere_r1", one_by_one as fn(&mut Bench, &_, &_) -> _),
        ("isect_sphere_r16", together),
    ] {
        let found: [Ray; 16] = call(bench, rays, sphere);
        for (ray, (found, expected)) in rays.iter().zip(found.iter().zip(&expected)) {
            assert_eq!(found, expected, "{kernel}: {ray:x?}, {sphere:x?}");
        }
    }
    expected
}

/// Calls the two any-hit kernels. Returns the bits, and the number of instructions of the one for
/// arrays.
fn check_any(bench: &mut Bench, rays: &[Ray; 16], spheres: &[BareSphere]) -> (u32, u64) {
    bench.reset();
    let record = bench.place(records::rows::<_, records::Rays, 16>(rays).as_bytes());
    let places: Vec<records::BareSphere> = spheres.iter().map(records::BareSphere::new).collect();
    let places = bench.place(places.as_bytes());
    let expected = |spheres: &[BareSphere]| {
        let blocked = |ray: &Ray| spheres.iter().any(|sphere| twin::any(ray, sphere));
        rays.iter().fold(0, |bits, ray| bits << 1 | u32::from(blocked(ray)))
    };
    for (number, sphere) in spheres.iter().enumerate() {
        let address = places.address + (number * size_of::<records::BareSphere>()) as u32;
        let found = bench.call("any_sphere_r16", &[record.address, address]);
        assert_eq!(found.value, expected(std::slice::from_ref(sphere)), "{rays:x?}, {sphere:x?}");
    }
    let arguments = [record.address, places.address, spheres.len() as u32];
    let found = bench.call("any_spheres_r16", &arguments);
    assert_eq!(found.value, expected(spheres), "{rays:x?}, {spheres:x?}");
    (found.value, found.instructions)
}

#[test]
fn ray_sphere_relations_give_expected_hits() {
    let mut bench = Bench::new();
    let at = |centre, radius| bare_sphere(centre, radius);
    let cases: [(&str, BareSphere, Option<f64>); 12] = [
        ("ahead", at([0.0, 0.0, -5.0], 1.0), Some(4.0)),
        ("behind the origin", at([0.0, 0.0, 5.0], 1.0), None),
        ("around, its centre ahead", at([0.0, 0.0, -0.5], 1.0), Some(1.5)),
        ("around, its centre behind the origin", at([0.0, 0.0, 0.5], 1.0), Some(0.5)),
        ("around, its centre here", at([0.0; 3], 1.0), Some(1.0)),
        ("around, its centre beside", at([0.6, 0.0, 0.0], 1.0), Some(0.8)),
        ("tangent", at([1.0, 0.0, -5.0], 1.0), Some(5.0)),
        ("beside", at([3.0, 0.0, -5.0], 1.0), None),
        ("beside and behind the origin", at([3.0, 0.0, 5.0], 1.0), None),
        ("tiny and far", at([0.0, 0.0, -4096.0], 1.0 / 16.0), Some(4096.0 - 1.0 / 16.0)),
        ("huge", at([0.0, 0.0, -1e9], 0.999e9), Some(1e6)),
        (
            "at the limit of the domain",
            at([0.0, 0.0, -(2_f64.powi(61))], 2_f64.powi(60)),
            Some(2_f64.powi(60)),
        ),
    ];
    let straight = ray([0.0; 3], [0.0, 0.0, -1.0], FARTHEST);
    for (name, sphere, expected) in cases {
        let found = check_nearest(&mut bench, &[straight; 16], &sphere)[0];
        let t = (found.object == OBJECT).then(|| to_f64(found.t));
        let radius = to_f64(sphere.radius_squared).sqrt();
        assert_eq!(t.is_some(), expected.is_some(), "{name}: {t:?}");
        if let (Some(t), Some(expected)) = (t, expected) {
            let error = (t - expected).abs() / expected.max(radius);
            assert!(error < 1e-6, "{name}: {t}");
        }
        // A t before the hit and one after it, if there is a hit.
        for (part, sees) in [(0.999, false), (1.001, true)] {
            let ray = Ray { t: from_f64(expected.unwrap_or(1.0) * part), ..straight };
            let (bits, _) = check_any(&mut bench, &[ray; 16], &[sphere]);
            let blocked = expected.is_some() && sees;
            assert_eq!(bits, if blocked { 0xffff } else { 0 }, "{name}, {part}");
        }
    }
}

#[test]
fn ulps_around_a_tangent_equal_the_twin() {
    let mut bench = Bench::new();
    let rays = std::array::from_fn(|lane| {
        let sine: f64 = 0.2 + (lane as f64 - 8.0) * 2_f64.powi(-26);
        ray([0.0; 3], [sine, 0.0, -(1.0 - sine * sine).sqrt()], FARTHEST)
    });
    let sphere = bare_sphere([0.0, 0.0, -5.0], 1.0);
    let hits = check_nearest(&mut bench, &rays, &sphere).map(|ray| ray.object == OBJECT);
    assert!(hits.contains(&true) && hits.contains(&false), "{hits:?}");
    check_any(&mut bench, &rays, &[sphere]);
}

#[test]
fn idle_ray_is_unchanged_and_does_not_delay_others() {
    let mut bench = Bench::new();
    let mut rays = case_rays();
    for ray in rays.iter_mut().step_by(3) {
        ray.t = 0;
        ray.object = 9;
    }
    let ahead = bare_sphere([0.0, 0.0, -5.0], 1.0);
    let found = check_nearest(&mut bench, &rays, &ahead);
    for (lane, (before, after)) in rays.iter().zip(&found).enumerate() {
        assert_eq!(before == after, lane % 3 == 0, "ray {lane}");
    }
    let beside = bare_sphere([9.0, 0.0, -5.0], 1.0);
    let mut spheres = vec![beside; 100];
    let (none, longest) = check_any(&mut bench, &rays, &spheres);
    assert_eq!(none, 0);
    spheres[0] = ahead;
    let (bits, instructions) = check_any(&mut bench, &rays, &spheres);
    assert_eq!(bits, 0b0110_1101_1011_0110);
    assert!(instructions * 8 < longest, "{instructions} instructions, {longest} without a hit");
    for ray in &mut rays {
        ray.t = 0;
    }
    let (bits, instructions) = check_any(&mut bench, &rays, &spheres);
    assert_eq!(bits, 0);
    assert!(instructions < 100, "{instructions} instructions for no ray");
}

#[test]
fn every_length_of_an_array() {
    let mut bench = Bench::new();
    for count in 0..=26 {
        // One ray finds its sphere at each place, and the others find none.
        for place in 0..count {
            let mut spheres = vec![bare_sphere([9.0, 0.0, -5.0], 1.0); count];
            spheres[place] = bare_sphere([0.0, 0.0, -5.0], 0.5);
            let mut rays = [ray([0.0, 2.0, 0.0], [0.0, 0.0, -1.0], FARTHEST); 16];
            rays[place % 16] = ray([0.0; 3], [0.0, 0.0, -1.0], FARTHEST);
            let (bits, _) = check_any(&mut bench, &rays, &spheres);
            assert_eq!(bits, 0x8000 >> (place % 16), "{place} of {count}");
        }
    }
    let (bits, _) = check_any(&mut bench, &case_rays(), &[]);
    assert_eq!(bits, 0);
}

/// The height above the surface, in ulps of the radius, from which a ray must miss the sphere that
/// it leaves, as the kernels' headers state.
const CLEAR_OF_SURFACE: f64 = 6.0;

#[test]
fn leaving_ray_does_not_meet_its_surface_again() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut nearest_miss, mut tried) = (0.0_f64, 0);
    for _ in 0..4000 {
        let radius = random.random_range(0.1..1000.0);
        let centre: [f64; 3] = std::array::from_fn(|_| random.random_range(-0.5..0.5) * radius);
        let sphere = bare_sphere(centre, radius);
        let ulp = libm::exp2(libm::log2(to_f64(sphere.radius_squared).sqrt()).floor() - 23.0);
        let rays = std::array::from_fn(|lane| {
            let normal = any_direction(&mut random);
            let height = radius + random.random_range(0.0..12.0) * ulp;
            let origin = std::array::from_fn(|axis| centre[axis] + height * normal[axis]);
            let any = any_direction(&mut random);
            let along: f64 = (0..3).map(|axis| any[axis] * normal[axis]).sum();
            // Half of them graze the surface.
            let rise = if lane % 2 == 0 { along.abs() } else { random.random_range(0.0..1e-3) };
            let direction = std::array::from_fn(|axis| any[axis] + (rise - along) * normal[axis]);
            ray(origin, unit(direction), FARTHEST)
        });
        let found = check_nearest(&mut bench, &rays, &sphere);
        let (blocked, _) = check_any(&mut bench, &rays, &[sphere]);
        for (lane, (ray, found)) in rays.iter().zip(&found).enumerate() {
            let truth = truth(ray, &sphere);
            if truth.t.is_some() {
                continue;
            }
            tried += 1;
            if found.object == OBJECT || blocked & 0x8000 >> lane != 0 {
                nearest_miss = nearest_miss.max(truth.height * truth.radius / ulp);
            }
        }
    }
    println!("a ray from {nearest_miss:.2} ulp above the surface met it again");
    assert!(tried > 30_000, "only {tried} rays left");
    assert!(nearest_miss < CLEAR_OF_SURFACE, "{nearest_miss} ulp");
}
