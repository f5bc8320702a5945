//! `cull_faces` compared with its twin, and with f64 from the singles of the records.

use kernels::cases::whitted::rays::bounds::{Fans, Origins, Point};
use kernels::cases::whitted::rays::faces::{CullFaces, face};
use kernels::cases::whitted::rays::fans::{self, FANS, Fan, SCALES};
use kernels::prelude::*;
use twins::bound::{Bound, bound};
use twins::cull_faces::Face;
use twins::primary_rays::{ABSENT, Ray};

/// A bound without rays meets no face that is visible from one side.
#[test]
fn one_sided_faces_are_culled_for_absent_rays() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..500 {
        let absent =
            fans::packet(Fan::Coherent, 1.0, &mut random).map(|ray| Ray { t: ABSENT, ..ray });
        let front = Face { both: false, ..face(in_cube(20.0, &mut random), &mut random) };
        let (faces, bounds) = (vec![front], vec![bound(&absent)]);
        let kept = CullFaces { faces, bounds, pairs: vec![[0, 0]], along: ONE }.check(&mut bench);
        assert!(kept.is_empty());
    }
}

/// Whether a ray goes through the plane from a visible side, by the singles of the records.
fn meets(ray: &Ray, face: &Face) -> bool {
    let [point, normal] = [face.point, face.normal].map(|vector| vector.map(to_f64));
    let direction = ray.direction.map(to_f64);
    let height = dot(sub(ray.origin.map(to_f64), point), normal);
    let against = dot(direction, normal);
    let t = -height / against;
    t > 0.0 && t < to_f64(ray.t) && (face.both || against < 0.0)
}

/// A plane almost through a ray's origin, or almost parallel to a ray.
fn tempting(rays: &[&Ray], scale: f64, random: &mut ChaCha8Rng) -> Face {
    let ray = rays[random.random_range(0..rays.len())];
    let origin = ray.origin.map(to_f64);
    let across = cross(ray.direction.map(to_f64), any_direction(random));
    let tilt = any_direction(random);
    let hair = magnitude(1e-9..1e-1, random);
    let normal = match random.random_range(0..3) {
        0 => tilt,
        _ => std::array::from_fn(|k| across[k] + hair * tilt[k]),
    };
    let normal = unit(normal);
    let step = scale * magnitude(1e-9..10.0, random);
    let point = std::array::from_fn(|k| origin[k] + step * (normal[k] + tilt[k] * hair));
    Face { normal: normal.map(from_f64), ..face(point, random) }
}

/// Rays with their bounds, of which no face may be lost.
struct Bounded {
    packet: [Ray; 16],
    bound: Bound,
    along: u32,
    scale: f64,
}

/// Adds to the numbers of missed faces, of culled faces among these, and of faces that are met.
fn no_face_is_lost(
    bench: &mut Bench,
    of: &Bounded,
    sums: &mut [usize; 3],
    random: &mut ChaCha8Rng,
) {
    let Bounded { packet, bound, along, scale } = of;
    let rays: Vec<&Ray> = packet.iter().filter(|ray| ray.t >> 31 == 0).collect();
    if rays.is_empty() {
        return;
    }
    let faces = (0..16).map(|_| tempting(&rays, *scale, random)).collect();
    let pairs = (0..16).map(|face| [face, 0]).collect();
    let culled = CullFaces { faces, bounds: vec![*bound], pairs, along: *along };
    let kept: Vec<usize> = culled.check(bench).iter().map(CullFaces::number).collect();
    for (number, face) in culled.faces.iter().enumerate() {
        let met = rays.iter().any(|ray| meets(ray, face));
        let is_kept = kept.contains(&number);
        assert!(is_kept || !met, "{face:x?} {packet:x?} {bound:x?}");
        sums[0] += usize::from(!met);
        sums[1] += usize::from(!met && !is_kept);
        sums[2] += usize::from(met);
    }
}

fn through(packet: [Ray; 16], point: Point) -> Fans {
    Fans { packets: vec![packet], point }
}

#[test]
fn met_faces_are_kept() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut sums = [0; 3];
    for _ in 0..1500 {
        let scale = magnitude(SCALES, &mut random);
        let fan = FANS[random.random_range(0..FANS.len())];
        let anywhere = fans::packet(fan, scale, &mut random);
        let (to_light, light) = fans::to_light(scale, &mut random);
        let from_eye = fans::packet(Fan::Eye, scale, &mut random);
        let bounded = [
            (anywhere, Origins { packets: vec![anywhere] }.call(&mut bench), ONE),
            (to_light, through(to_light, light).call(&mut bench), light.along),
            (from_eye, through(from_eye, Point::EYE).call(&mut bench), ONE),
        ];
        for (packet, bounds, along) in bounded {
            let of = Bounded { packet, bound: bounds[0], along, scale };
            no_face_is_lost(&mut bench, &of, &mut sums, &mut random);
        }
    }
    let [missed, left_out, met] = sums;
    println!("of {missed} missed {left_out} left out; {met} met");
    assert!(3 * left_out > missed && met > 1000, "{sums:?}");
}
