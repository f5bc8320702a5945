//! `bound_fan_r16` and `bound_origins_r16`.

use kernels::cases::whitted::rays::bounds::{Fans, Origins, Point, any_fan};
use kernels::prelude::*;
use twins::bound::NOTHING;
use twins::primary_rays::{ABSENT, Ray};

/// How much larger than that of the rays a length or a sine may be.
const LOOSE: f64 = 1.0 / (1 << 16) as f64;
/// How much smaller a cosine may be.
const LOOSE_COSINE: f64 = 1.0 / (1 << 11) as f64;
/// The smallest cosine for which a cone is required.
const WIDE: f64 = 0.19;

/// The cone of rays that end at a point equals that of the reversed rays.
#[test]
fn reversed_rays_have_same_cone() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..500 {
        let packet = any_fan(&mut random);
        let turned = packet.map(|ray| Ray {
            direction: ray.direction.map(|component| component ^ 0x8000_0000),
            ..ray
        });
        let from = Point { along: from_f64(1.0), ..Point::any(&mut random) };
        let to = Point { along: from_f64(-1.0), ..from };
        let turned = Fans { packets: vec![turned], point: to }.check(&mut bench);
        assert_eq!(Fans { packets: vec![packet], point: from }.check(&mut bench), turned);
    }
}

#[test]
fn bound_without_rays_has_negative_radius() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..200 {
        let packet = [(); 16].map(|()| Ray { t: ABSENT, ..any_bits(&mut random) });
        let packets = vec![packet];
        let origins = Origins { packets: packets.clone() };
        assert_eq!(origins.check(&mut bench)[0].radius, NOTHING);
        let fan = Fans { packets, point: Point::any(&mut random) }.check(&mut bench)[0];
        assert_eq!([fan.radius, fan.sine], [NOTHING; 2]);
    }
}

#[test]
fn bound_contains_all_rays_tightly() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut cones = 0;
    for _ in 0..20_000 {
        let packet = any_fan(&mut random);
        let rays: Vec<&Ray> = packet.iter().filter(|ray| ray.t >> 31 == 0).collect();
        if rays.is_empty() {
            continue;
        }
        let found = Origins { packets: vec![packet] }.check(&mut bench)[0];
        let at = format!("{packet:x?}, {found:x?}");
        let [apex, axis]: [Vector; 2] = [found.apex, found.axis].map(|v| v.map(to_f64));
        let [cosine, sine, radius, farthest] =
            [found.cosine, found.sine, found.radius, found.farthest].map(to_f64);

        let largest = |of: &dyn Fn(&Ray) -> f64| {
            rays.iter().map(|ray| of(ray)).fold(f64::NEG_INFINITY, f64::max)
        };
        let apart = largest(&|ray| {
            let apart = sub(ray.origin.map(to_f64), apex);
            dot(apart, apart).sqrt()
        });
        let away = dot(apex, apex).sqrt();
        assert!(apart <= radius, "{apart} {at}");
        assert!(radius <= apart * (1.0 + LOOSE) + away * LOOSE, "{apart} {at}");
        assert!(farthest == largest(&|ray| to_f64(ray.t)), "{at}");

        let direction = |ray: &Ray| unit(ray.direction.map(to_f64));
        if axis == [0.0; 3] {
            assert_eq!([cosine, sine], [0.0; 2], "{at}");
            let sum = rays.iter().fold([0.0; 3], |sum, ray| {
                let direction = direction(ray);
                std::array::from_fn(|k| sum[k] + direction[k])
            });
            let narrowest = -largest(&|ray| -dot(direction(ray), unit(sum)));
            assert!(narrowest < WIDE, "{narrowest} {at}");
            continue;
        }
        cones += 1;
        let middle = unit(axis);
        let smallest = -largest(&|ray| -dot(direction(ray), middle));
        let beside = largest(&|ray| {
            let normal = cross(direction(ray), middle);
            dot(normal, normal).sqrt()
        });
        assert!((dot(axis, axis) - 1.0).abs() < LOOSE, "{at}");
        assert!(cosine <= smallest && smallest - LOOSE_COSINE <= cosine, "{smallest} {at}");
        assert!(sine >= beside && beside + LOOSE >= sine, "{beside} {at}");
        assert!(cosine * cosine + sine * sine <= 1.0, "{at}");
    }
    assert!(cones > 5000, "only {cones}");
}
