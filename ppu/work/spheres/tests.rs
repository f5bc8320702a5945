use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;

use super::super::arithmetic::{
    Singles, camera, direction, entry, form, is_above, is_outside, sphere, wide,
};
use super::*;
use crate::framebuffer::Geometry;
use crate::scene::random::{across, magnitude, unit};
use glam::DVec3;
use scenes::Camera;

const SIZE: Geometry = Geometry { width: 320, height: 200 };

/// A random direction close to the sphere's edge, or elsewhere near the sphere.
fn near_the_edge(random: &mut ChaCha8Rng, sphere: &scene::Sphere, eye: DVec3) -> Singles {
    let to_centre = sphere.centre - eye;
    let along = to_centre.normalize();
    let edge = libm::asin((sphere.radius / to_centre.length()).min(1.0));
    let angle = edge
        * match random.random_range(0..3) {
            0 => 1.0 + random.random_range(-1.0..1.0) * magnitude(random, -24.0, 0.0),
            1 => 1.0 + random.random_range(-1.0..1.0) * magnitude(random, -30.0, -20.0),
            _ => random.random_range(0.0..1.0),
        };
    let exact = along * libm::cos(angle) + across(random, along) * libm::sin(angle);
    // The length is off 1 by as much as the kernels' domain allows.
    let exact = exact * (1.0 + random.random_range(-4.0..4.0) * f64::from(f32::EPSILON) / 2.0);
    exact.to_array().map(|value| (value as f32).to_bits())
}

/// Whether a ray enters the sphere from outside, by f64 alone.
fn enters(sphere: &scene::Sphere, eye: DVec3, direction: DVec3) -> bool {
    let to_centre = sphere.centre - eye;
    let along = to_centre.dot(direction.normalize());
    let nearest = to_centre.reject_from(direction).length();
    along > 0.0 && to_centre.length() > sphere.radius && nearest < sphere.radius
}

#[test]
fn hitting_rays_pass_sphere_test() {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let mut counts = [0; 4];
    for _ in 0..400 {
        let camera = camera(&mut random, SIZE.width, SIZE.height);
        let projection = Projection::new(&camera, SIZE);
        for _ in 0..500 {
            let towards = unit(&mut random);
            let sphere = sphere(&mut random, camera.eye, towards);
            let form = form(&mut random);
            let record = record(&sphere, &projection, form);
            let ray = near_the_edge(&mut random, &sphere, camera.eye);
            let (exact, found) =
                (enters(&sphere, camera.eye, wide(ray)), entry(&record, form, ray));
            let passes = is_above(record.ray_limit, record.centre, ray);
            assert!(passes || !exact, "{sphere:?} {record:?} {ray:x?}");
            assert!(passes || found.is_none(), "{sphere:?} {record:?} {ray:x?}");
            if let Some(t) = found {
                assert!(t >= f64::from(record.near.get()), "{sphere:?} {record:?} {ray:x?}");
            }
            for (count, event) in
                counts.iter_mut().zip([exact, found.is_some(), exact != found.is_some(), !passes])
            {
                *count += u32::from(event);
            }
        }
    }
    // Rays at edges: many of each kind, and some where the SPU's rounding decides.
    assert!(counts.iter().all(|&count| count > 300), "{counts:?}");
}

#[test]
fn sphere_test_rejects_nearly_all_misses() {
    let mut random = ChaCha8Rng::seed_from_u64(2);
    let camera = camera(&mut random, SIZE.width, SIZE.height);
    let projection = Projection::new(&camera, SIZE);
    for _ in 0..10_000 {
        let along = unit(&mut random);
        let distance = magnitude(&mut random, -10.0, 10.0);
        let share = random.random_range(0.01..0.9);
        let sphere = scene::Sphere {
            centre: camera.eye + along * distance,
            radius: distance * share,
            colour: DVec3::ONE,
        };
        let form = form(&mut random);
        let record = record(&sphere, &projection, form);
        let angle = libm::asin(share) + 0.001;
        let passing = along * libm::cos(angle) + across(&mut random, along) * libm::sin(angle);
        let passing = passing.to_array().map(|value| (value as f32).to_bits());
        assert!(!is_above(record.ray_limit, record.centre, passing), "{sphere:?}");
    }
}

/// A packet of 4x4 rays, possibly beyond the picture's edge, and its middle direction.
fn packet(random: &mut ChaCha8Rng, camera: &Camera) -> (Vec<Singles>, Singles) {
    let x = f64::from(random.random_range(0..SIZE.width / 4) * 4);
    let y = f64::from(random.random_range(0..SIZE.height / 4) * 4);
    let place = |lane: u32| (x + f64::from(lane % 4), y + f64::from(lane / 4));
    let rays = (0..16).map(place).map(|(x, y)| direction(camera, x, y));
    (rays.collect(), direction(camera, x + 1.5, y + 1.5))
}

#[test]
fn hitting_packets_pass_sphere_test() {
    let mut random = ChaCha8Rng::seed_from_u64(3);
    let (mut hits, mut misses) = (0, 0);
    for _ in 0..300 {
        let camera = camera(&mut random, SIZE.width, SIZE.height);
        let projection = Projection::new(&camera, SIZE);
        for _ in 0..100 {
            let (rays, middle) = packet(&mut random, &camera);
            // Its edge is near one of the rays, on this side of it or beyond.
            let ray = wide(rays[random.random_range(0..16)]).normalize();
            let anywhere = unit(&mut random);
            let mut sphere = sphere(&mut random, camera.eye, anywhere);
            let distance = (sphere.centre - camera.eye).length();
            let edge = libm::asin(sphere.radius / distance);
            let beside = projection.packet_spread().min(0.1) * random.random_range(0.0..3.0);
            let angle = match random.random_range(0..3) {
                0 => edge + beside,
                1 => edge * random.random_range(0.0..1.0),
                _ => {
                    edge * (1.0
                        + random.random_range(-1.0..1.0) * magnitude(&mut random, -24.0, -10.0))
                }
            };
            let towards = ray * libm::cos(angle) + across(&mut random, ray) * libm::sin(angle);
            sphere.centre = camera.eye + towards * distance;
            let form = form(&mut random);
            let record = record(&sphere, &projection, form);
            let passes = is_above(record.packet_limit, record.centre, middle);
            for &ray in &rays {
                let hit =
                    entry(&record, form, ray).is_some() || enters(&sphere, camera.eye, wide(ray));
                assert!(passes || !hit, "{camera:?} {sphere:?} {record:?}");
                hits += u32::from(hit);
            }
            misses += u32::from(!passes);
        }
    }
    assert!(hits > 10_000 && misses > 500, "{hits} {misses}");
}

#[test]
fn plane_test_keeps_hit_spheres() {
    let mut random = ChaCha8Rng::seed_from_u64(4);
    let mut outside = 0;
    for _ in 0..300 {
        let camera = camera(&mut random, SIZE.width, SIZE.height);
        let projection = Projection::new(&camera, SIZE);
        for _ in 0..300 {
            let towards = unit(&mut random);
            let sphere = sphere(&mut random, camera.eye, towards);
            let form = form(&mut random);
            let record = record(&sphere, &projection, form);
            let ray = near_the_edge(&mut random, &sphere, camera.eye);
            // A plane (nearly) through the ray, with the ray on its inner side. In the worst case
            // the sphere is on the other side.
            let along = wide(ray).normalize();
            let to_sphere = (sphere.centre - camera.eye).reject_from(along);
            let Some(away) = (-to_sphere).try_normalize() else {
                continue;
            };
            let inner = away + along * magnitude(&mut random, -40.0, 0.0);
            let normal = inner.normalize().to_array().map(|value| (value as f32).to_bits());
            if wide(normal).dot(along) < 0.0 {
                continue;
            }
            let hit = entry(&record, form, ray).is_some() || enters(&sphere, camera.eye, wide(ray));
            let left_out = is_outside(&record, normal);
            assert!(!(hit && left_out), "{sphere:?} {record:?} {ray:x?} {normal:x?}");
            outside += u32::from(left_out);
        }
    }
    assert!(outside > 1000, "{outside}");
}

#[test]
fn no_ray_enters_a_sphere_around_the_eye() {
    let mut random = ChaCha8Rng::seed_from_u64(5);
    for _ in 0..300 {
        let camera = camera(&mut random, SIZE.width, SIZE.height);
        let projection = Projection::new(&camera, SIZE);
        for _ in 0..300 {
            let towards = unit(&mut random);
            let mut sphere = sphere(&mut random, camera.eye, towards);
            let distance = (sphere.centre - camera.eye).length();
            sphere.radius = distance * (1.0 + magnitude(&mut random, -17.99, 4.0));
            assert!(!can_be_seen(&sphere, &projection));
            let form = form(&mut random);
            let record = record(&sphere, &projection, form);
            for _ in 0..10 {
                let ray = unit(&mut random).to_array().map(|value| (value as f32).to_bits());
                assert_eq!(entry(&record, form, ray), None, "{sphere:?} {ray:x?}");
            }
        }
    }
}

#[test]
fn sphere_touching_the_eye_is_visible_from_outside() {
    let mut random = ChaCha8Rng::seed_from_u64(6);
    let camera = camera(&mut random, SIZE.width, SIZE.height);
    let projection = Projection::new(&camera, SIZE);
    for shift in [-1e-7, 0.0, 1e-7] {
        let sphere = scene::Sphere {
            centre: camera.eye + DVec3::X * 8.0,
            radius: 8.0 * (1.0 + shift),
            colour: DVec3::ONE,
        };
        let is_outside = shift < 0.0;
        assert_eq!(can_be_seen(&sphere, &projection), is_outside, "{shift}");
        let form = form(&mut random);
        let record = record(&sphere, &projection, form);
        assert_eq!(record.ray_limit.get(), -f32::MAX);
        assert_eq!(record.packet_limit.get(), -f32::MAX);
        assert_eq!(record.near.get(), 0.0);
        for _ in 0..1000 {
            let ray = unit(&mut random);
            // Near the tangent plane, rounding decides.
            if ray.x.abs() > 0.01 {
                let bits = ray.to_array().map(|value| (value as f32).to_bits());
                let found = entry(&record, form, bits).is_some();
                assert_eq!(found, is_outside && ray.x > 0.0, "{shift} {ray}");
            }
        }
    }
}

#[test]
fn extreme_numbers_stay_finite_f32() {
    let mut random = ChaCha8Rng::seed_from_u64(7);
    let most = (1_u64 << 62) as f64;
    let mut camera = camera(&mut random, SIZE.width, SIZE.height);
    for eye in [DVec3::ZERO, DVec3::splat(most), DVec3::splat(-most)] {
        camera.eye = eye;
        let projection = Projection::new(&camera, SIZE);
        for centre in [DVec3::ZERO, DVec3::splat(most), DVec3::new(most, -most, 1.0)] {
            for radius in [1.0 / most, 1.0, most] {
                let colour = DVec3::ONE;
                let record = record(
                    &scene::Sphere { centre, radius, colour },
                    &projection,
                    form(&mut random),
                );
                for value in [
                    record.centre[0],
                    record.radius_squared,
                    record.near,
                    record.ray_limit,
                    record.packet_limit,
                    record.reach,
                ] {
                    assert!(value.get().is_finite(), "{centre} {radius} {record:?}");
                }
                assert!(record.near.get() >= 0.0 && record.reach.get() > 0.0);
                assert!(record.radius_squared.get() > 0.0);
            }
        }
    }
}

#[test]
fn records_are_sorted_and_visible_only() {
    let view = scenes::View {
        from: DVec3::ZERO,
        at: DVec3::Z,
        up: DVec3::Y,
        angle: 40.0,
        hither: 0.0,
        resolution: (SIZE.width, SIZE.height),
    };
    let camera = view.camera(SIZE.width, SIZE.height).unwrap();
    let projection = Projection::new(&camera, SIZE);
    let sphere = |x: f64, z: f64, red: f64| scene::Sphere {
        centre: DVec3::new(x, 0.0, z),
        radius: 1.0,
        colour: DVec3::new(red, 0.0, 0.0),
    };
    let spheres = [
        sphere(0.0, 9.0, 0.1),
        // Behind, next to, and around the eye.
        sphere(0.0, -5.0, 0.2),
        sphere(50.0, 5.0, 0.3),
        sphere(0.0, 0.5, 0.4),
        sphere(0.0, 5.0, 0.5),
        // As near as the first sphere, so their order in the scene decides.
        sphere(0.0, 9.0, 0.6),
    ];
    let mut eye_spheres = EyeSpheres::default();
    let reds = |eye_spheres: &EyeSpheres| -> Vec<f32> {
        eye_spheres.records().iter().map(|record| record.colour[0].get()).collect()
    };
    for _ in 0..2 {
        eye_spheres.cull(&spheres, &projection, Skip::Misses, EyeRecord::Centre);
        assert_eq!(reds(&eye_spheres), [0.5, 0.1, 0.6]);
        eye_spheres.cull(&spheres, &projection, Skip::Nothing, EyeRecord::Centre);
        assert_eq!(reds(&eye_spheres), [0.4, 0.2, 0.5, 0.1, 0.6, 0.3]);
    }
    let nears: Vec<f32> = eye_spheres.records().iter().map(|record| record.near.get()).collect();
    assert!(nears.is_sorted(), "{nears:?}");
}

#[test]
fn bounds_are_rounded_to_the_safe_side() {
    let mut random = ChaCha8Rng::seed_from_u64(8);
    for _ in 0..10_000 {
        let value = random.random_range(-1.0..1.0) * magnitude(&mut random, -60.0, 60.0);
        let (below, above) = (down(value).get(), up(value).get());
        assert!(f64::from(below) <= value && value <= f64::from(above));
        assert!(above == below || above == below.next_up());
    }
}
