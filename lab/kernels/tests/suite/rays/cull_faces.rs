//! `cull_faces` compared with its twin, and with f64 from the singles of the records.

use kernels::bench::{Bench, random};
use kernels::cases::sphere_ray::any_direction;
use kernels::cases::whitted::rays::call::{self, Point};
use kernels::cases::whitted::rays::faces::cull_faces;
use kernels::cases::whitted::rays::fans::{self, FANS, Fan, SCALES};
use kernels::vector::{Vector, cross, dot, in_cube, less, magnitude, unit};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::bound::{Bound, bound};
use twins::cull_faces::{Face, may_meet};
use twins::primary_rays::{ABSENT, Ray};
use twins::{ONE, ZERO};

use super::COUNTS;

const MINUS_ONE: u32 = 0xbf80_0000;

/// How much an object's numbers add to `leave`, as a share of the magnitudes of its centre's
/// components.
const LEAVE: f64 = 1.0 / (1 << 20) as f64;

/// Checks the kernel, and returns the numbers of the pairs that it kept.
fn check(
    bench: &mut Bench,
    faces: &[Face],
    bounds: &[Bound],
    pairs: &[[usize; 2]],
    along: u32,
) -> Vec<usize> {
    let (given, found) = cull_faces(bench, faces, bounds, pairs, along);
    let kept: Vec<usize> = (0..pairs.len())
        .filter(|&number| {
            let [face, bound] = pairs[number];
            may_meet(&bounds[bound], &faces[face], along)
        })
        .collect();
    let expected: Vec<[u32; 4]> = kept.iter().map(|&number| given[number]).collect();
    assert_eq!(found, expected, "{faces:x?} {bounds:x?} {pairs:?}");
    kept
}

fn face(point: Vector, random: &mut ChaCha8Rng) -> Face {
    let leave: f64 = point.iter().map(|component| component.abs()).sum();
    Face {
        point: point.map(from_f64),
        normal: any_direction(random).map(from_f64),
        leave: from_f64(leave * LEAVE * (1.0 + 1e-6)),
        both: random.random(),
    }
}

fn pairs(count: usize, of: [usize; 2], random: &mut ChaCha8Rng) -> Vec<[usize; 2]> {
    (0..count).map(|_| of.map(|end| random.random_range(0..end))).collect()
}

#[test]
fn candidates_equal_the_twin_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut tested, mut kept) = (0, 0);
    for _ in 0..50 {
        for count in COUNTS {
            let faces: [Face; 8] =
                std::array::from_fn(|_| face(in_cube(20.0, &mut random), &mut random));
            let bounds: [Bound; 4] = std::array::from_fn(|_| {
                let fan = FANS[random.random_range(0..FANS.len())];
                bound(&fans::packet(fan, 1.0, &mut random))
            });
            let pairs = pairs(count, [8, 4], &mut random);
            let along = if random.random() { ONE } else { MINUS_ONE };
            kept += check(&mut bench, &faces, &bounds, &pairs, along).len();
            tested += count;
        }
    }
    assert!(kept > tested / 10 && kept < tested * 9 / 10, "{kept} of {tested}");
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut kept = 0;
    for _ in 0..500 {
        let faces: [Face; 8] = std::array::from_fn(|_| Face {
            point: random.random(),
            normal: random.random(),
            leave: random.random(),
            both: random.random(),
        });
        let bounds: [Bound; 4] = std::array::from_fn(|_| Bound {
            apex: random.random(),
            axis: random.random(),
            cosine: random.random(),
            sine: random.random(),
            radius: random.random(),
            farthest: random.random(),
        });
        let pairs = pairs(7, [8, 4], &mut random);
        kept += check(&mut bench, &faces, &bounds, &pairs, random.random()).len();
    }
    assert!(kept > 100, "{kept}");
}

#[test]
fn no_candidate_gives_no_list() {
    assert!(check(&mut Bench::new(), &[], &[], &[], ONE).is_empty());
}

/// A bound without rays meets no face that is visible from one side.
#[test]
fn nobody_meets_a_front() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..500 {
        let absent =
            fans::packet(Fan::Coherent, 1.0, &mut random).map(|ray| Ray { t: ABSENT, ..ray });
        let front = Face { both: false, ..face(in_cube(20.0, &mut random), &mut random) };
        let kept = check(&mut bench, &[front], &[bound(&absent)], &[[0, 0]], ONE);
        assert!(kept.is_empty());
    }
}

/// Whether a ray goes through the plane from a visible side, by the singles of the records.
fn meets(ray: &Ray, face: &Face) -> bool {
    let [point, normal] = [face.point, face.normal].map(|vector| vector.map(to_f64));
    let direction = ray.direction.map(to_f64);
    let height = dot(less(ray.origin.map(to_f64), point), normal);
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
    let faces: [Face; 16] = std::array::from_fn(|_| tempting(&rays, *scale, random));
    let pairs: [[usize; 2]; 16] = std::array::from_fn(|face| [face, 0]);
    let kept = check(bench, &faces, &[*bound], &pairs, *along);
    for (number, face) in faces.iter().enumerate() {
        let met = rays.iter().any(|ray| meets(ray, face));
        let is_kept = kept.contains(&number);
        assert!(is_kept || !met, "{face:x?} {packet:x?} {bound:x?}");
        sums[0] += usize::from(!met);
        sums[1] += usize::from(!met && !is_kept);
        sums[2] += usize::from(met);
    }
}

#[test]
fn no_face_that_a_ray_meets_is_left_out() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut sums = [0; 3];
    let eye = Point { place: [ZERO; 3], near: ZERO, along: ONE };
    for _ in 0..1500 {
        let scale = magnitude(SCALES, &mut random);
        let fan = FANS[random.random_range(0..FANS.len())];
        let anywhere = fans::packet(fan, scale, &mut random);
        let (to_light, light) = fans::to_light(scale, &mut random);
        let from_eye = fans::packet(Fan::Eye, scale, &mut random);
        let bounded = [
            (anywhere, call::bounds(&mut bench, &[anywhere]), ONE),
            (to_light, call::fans(&mut bench, &[to_light], &light), light.along),
            (from_eye, call::fans(&mut bench, &[from_eye], &eye), eye.along),
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
