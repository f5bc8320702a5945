//! `isect_spheres_r16`.

use cellray::work::layout::{EyeSphere, Packet};
use oracle::twin::isect_spheres::{self, Hit, isect_spheres};
use oracle::twin::{FARTHEST, Single};
use rand::Rng as _;
use spu_emulator::float::single::{from_f64, to_f64};
use zerocopy::{FromZeros as _, IntoBytes as _};

use crate::harness::{self, Bench, bits, single};

const SOURCE: &str = include_str!("../../spu/isect/isect_spheres_r16.s");

/// A sphere in singles that are exact, and their f64 values.
#[derive(Clone, Copy, Debug)]
struct Sphere {
    centre: [Single; 3],
    radius_squared: Single,
}

impl Sphere {
    fn new(centre: [f64; 3], radius: f64) -> Self {
        Self {
            centre: centre.map(from_f64),
            radius_squared: from_f64(radius * radius),
        }
    }
}

/// A unit direction, rounded to singles.
fn unit(direction: [f64; 3]) -> [Single; 3] {
    let length = direction
        .iter()
        .map(|component| component * component)
        .sum::<f64>()
        .sqrt();
    direction.map(|component| from_f64(component / length))
}

/// Runs the kernel on sixteen rays, compares every lane with the twin, and gives the hits.
fn check(
    bench: &mut Bench,
    rays: &[[Single; 3]; 16],
    spheres: &[Sphere],
    first: u32,
    before: Hit,
) -> [Hit; 16] {
    bench.reset();
    let mut packet = Packet::new_zeroed();
    for (lane, [x, y, z]) in rays.iter().enumerate() {
        packet.direction_x[lane] = single(*x);
        packet.direction_y[lane] = single(*y);
        packet.direction_z[lane] = single(*z);
        packet.t[lane] = single(before.t);
        packet.object[lane] = before.object.into();
    }
    let packet_place = bench.place(packet.as_bytes());
    let records: Vec<EyeSphere> = spheres
        .iter()
        .map(|sphere| EyeSphere {
            centre: sphere.centre.map(|value| [single(value); 4]),
            radius_squared: [single(sphere.radius_squared); 4],
        })
        .collect();
    let spheres_place = bench.place(records.as_bytes());
    let arguments = [
        packet_place.address,
        spheres_place.address,
        spheres.len() as u32,
        first,
    ];
    bench.call("isect_spheres_r16", &arguments);
    let packet: Packet = bench.read(packet_place);

    let twins: Vec<isect_spheres::EyeSphere> = spheres
        .iter()
        .map(|sphere| isect_spheres::EyeSphere {
            centre: sphere.centre,
            radius_squared: sphere.radius_squared,
        })
        .collect();
    std::array::from_fn(|lane| {
        let found = Hit {
            t: bits(packet.t[lane]),
            object: packet.object[lane].get(),
        };
        let expected = isect_spheres(rays[lane], &twins, first, before);
        assert_eq!(
            found, expected,
            "ray {:x?}, spheres {spheres:x?}",
            rays[lane]
        );
        found
    })
}

const NO_HIT: Hit = Hit {
    t: FARTHEST,
    object: 0,
};

/// The entry in f64, for the very singles that the kernel was given; the direction is made a unit
/// one, and how far from tangency the ray is comes along: disc / r^2.
fn exact(ray: [Single; 3], sphere: &Sphere) -> (Option<f64>, f64) {
    let d = ray.map(to_f64);
    let length = d
        .iter()
        .map(|component| component * component)
        .sum::<f64>()
        .sqrt();
    let d = d.map(|component| component / length);
    let c = sphere.centre.map(to_f64);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let b = dot(c, d);
    let l: [f64; 3] = std::array::from_fn(|axis| c[axis] - b * d[axis]);
    let radius_squared = to_f64(sphere.radius_squared);
    let disc = radius_squared - dot(l, l);
    let t = b - disc.max(0.0).sqrt();
    ((disc >= 0.0 && t > 0.0).then_some(t), disc / radius_squared)
}

#[test]
fn equals_its_twin_and_keeps_its_error_bound() {
    let mut random = harness::random();
    let mut bench = Bench::new();
    let (mut worst, mut hits, mut wrong, mut rays_tried) = (0.0_f64, 0, 0, 0);
    for _ in 0..3000 {
        // Distance from 1.5 to 30 radii, rays around the sphere's outline and within.
        let radius: f64 = random.random_range(0.1..10.0);
        let distance = radius * random.random_range(1.5..30.0);
        let axis: [f64; 3] = std::array::from_fn(|_| random.random_range(-1.0..1.0));
        let sphere = Sphere::new(
            unit(axis).map(|component| to_f64(component) * distance),
            radius,
        );
        let centre = sphere.centre.map(to_f64);
        let rays = std::array::from_fn(|_| {
            unit(std::array::from_fn(|axis| {
                centre[axis] + radius * random.random_range(-0.9..0.9)
            }))
        });
        let found = check(&mut bench, &rays, &[sphere], 1, NO_HIT);
        for (ray, found) in rays.iter().zip(found) {
            rays_tried += 1;
            let (entry, from_tangency) = exact(*ray, &sphere);
            if entry.is_some() != (found.object == 1) {
                wrong += 1;
                // Only where the direction's own rounding decides.
                assert!(
                    from_tangency.abs() < 1e-3,
                    "{ray:x?} {sphere:x?}: {from_tangency}"
                );
            } else if let (Some(entry), true) = (entry, from_tangency > 0.01) {
                hits += 1;
                worst = worst.max((to_f64(found.t) - entry).abs() / entry * 2_f64.powi(23));
            }
        }
    }
    println!(
        "{rays_tried} rays, {hits} hits away from tangency, worst t {worst:.2} ulp, {wrong} wrong hits"
    );
    assert!(hits > 10_000, "the spheres are mostly missed");
    assert!(
        wrong * 1000 < rays_tried,
        "{wrong} of {rays_tried} rays hit or miss wrongly"
    );
    harness::keeps_stated_error(SOURCE, worst);
}

#[test]
fn the_nearest_of_many_in_any_order() {
    let mut random = harness::random();
    let mut bench = Bench::new();
    let mut numbers = std::collections::BTreeSet::new();
    for _ in 0..300 {
        let count = random.random_range(0..12);
        let spheres: Vec<Sphere> = (0..count)
            .map(|_| {
                let centre = std::array::from_fn(|axis| {
                    random.random_range(-2.0..2.0) + if axis == 2 { -6.0 } else { 0.0 }
                });
                Sphere::new(centre, random.random_range(0.1..1.5))
            })
            .collect();
        let rays = std::array::from_fn(|_| {
            unit([
                random.random_range(-0.3..0.3),
                random.random_range(-0.3..0.3),
                -1.0,
            ])
        });
        let before = Hit {
            t: from_f64(random.random_range(1.0..20.0)),
            object: 7,
        };
        for hit in check(&mut bench, &rays, &spheres, 100, before) {
            numbers.insert(hit.object);
        }
    }
    assert!(numbers.len() > 10, "only {numbers:?} were hit");
}

#[test]
fn tangents_insides_behind_and_extremes() {
    let mut bench = Bench::new();
    let forward = unit([0.0, 0.0, -1.0]);
    let rays: [[Single; 3]; 16] = std::array::from_fn(|lane| {
        // Ulps around the tangent of the unit sphere at distance 5.
        let sine: f64 = 0.2 + (lane as f64 - 8.0) * 2_f64.powi(-26);
        unit([sine, 0.0, -(1.0 - sine * sine).sqrt()])
    });
    check(
        &mut bench,
        &rays,
        &[Sphere::new([0.0, 0.0, -5.0], 1.0)],
        1,
        NO_HIT,
    );

    let straight = [forward; 16];
    let cases: [(&str, Sphere, u32); 9] = [
        ("ahead", Sphere::new([0.0, 0.0, -5.0], 1.0), 1),
        ("behind", Sphere::new([0.0, 0.0, 5.0], 1.0), 0),
        ("around the eye", Sphere::new([0.0, 0.0, -0.5], 1.0), 0),
        ("at the eye", Sphere::new([0.0; 3], 1.0), 0),
        ("tangent", Sphere::new([1.0, 0.0, -5.0], 1.0), 1),
        ("beside", Sphere::new([3.0, 0.0, -5.0], 1.0), 0),
        (
            "tiny and far",
            Sphere::new([0.0, 0.0, -4096.0], 1.0 / 16.0),
            1,
        ),
        ("huge", Sphere::new([0.0, 0.0, -1e9], 0.999e9), 1),
        (
            "at the limit of the domain",
            Sphere::new([0.0, 0.0, -(2_f64.powi(62))], 2_f64.powi(60)),
            1,
        ),
    ];
    for (name, sphere, object) in cases {
        let hits = check(&mut bench, &straight, &[sphere], 1, NO_HIT);
        assert!(
            hits.iter().all(|hit| hit.object == object),
            "{name}: {hits:?}"
        );
    }
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = harness::random();
    let mut bench = Bench::new();
    for _ in 0..2000 {
        let rays = std::array::from_fn(|_| std::array::from_fn(|_| random.random()));
        let spheres: Vec<Sphere> = (0..3)
            .map(|_| Sphere {
                centre: std::array::from_fn(|_| random.random()),
                radius_squared: random.random(),
            })
            .collect();
        let before = Hit {
            t: random.random(),
            object: random.random(),
        };
        check(
            &mut bench,
            &rays,
            &spheres,
            random.random_range(1..1000),
            before,
        );
    }
}
