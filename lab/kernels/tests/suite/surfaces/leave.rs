//! The origin offset of rays that leave a surface: it must be large enough that the ray does not
//! hit the same object again, with the steps of the kernels that look for hits.

use kernels::cases::whitted::shade::error::{any_hits, any_material};
use kernels::cases::whitted::shade::shapes::Shape;
use spu_emulator::float::single::{fm, fma, fnms};
use twins::flat::FlatHit;
use twins::rectangle::{Rectangle, isect_plane};
use twins::sphere_ray::{self, BareSphere};
use twins::surfaces::{Surface, surface};

use super::vector;
use kernels::prelude::*;

/// The number of the object that rays leave.
const OBJECT: u32 = 7;

/// The origins of a ray that leaves on the side of the normal and of one that goes through.
fn starts(surface: &Surface, leave: Single) -> [[Single; 3]; 2] {
    let Surface { point, plane, .. } = *surface;
    [
        std::array::from_fn(|k| fma(leave, plane[k], point[k])),
        std::array::from_fn(|k| fnms(leave, plane[k], point[k])),
    ]
}

#[test]
fn rays_start_on_the_side_that_they_go_to() {
    let mut random = random();
    let material = any_material(&mut random);
    let mut nearest = f64::INFINITY;
    for _ in 0..4000 {
        let (shapes, objects, hits) = any_hits(&mut random);
        for (lane, (shape, hit)) in shapes.iter().zip(&hits).enumerate() {
            let found = surface(&hit.ray, &objects[lane + 1].0, &material);
            let (_, normal) = shape.at(vector(found.point));
            let side = dot(normal, vector(found.plane)).signum();
            let [outside, inside] =
                starts(&found, found.leave).map(|start| side * shape.at(vector(start)).0);
            nearest = nearest.min(outside.min(-inside) / to_f64(found.leave));
        }
    }
    println!("nearest start: {nearest:.3} of leave");
    assert!(nearest >= 0.5, "{nearest}");
}

/// Whether a ray meets a shape that it may have left.
type Meets = fn(&Shape, [Single; 3], Vector) -> bool;

/// Starts rays at this share of `leave` from a shape. Counts the rays that leave it and meet it
/// again, and the rays that continue inside it, in both directions, and differ from `within`.
fn lost_rays(
    share: f64,
    shape: fn(&mut ChaCha8Rng) -> Shape,
    meets: Meets,
    within: [bool; 2],
) -> u32 {
    let mut lost = 0;
    let mut random = random();
    let material = any_material(&mut random);
    for _ in 0..40_000 {
        let shape = shape(&mut random);
        let hit = shape.any_ray(&mut random);
        let found = surface(&hit, &shape.object(), &material);
        let (_, outwards) = shape.at(vector(found.point));
        let mut leaving = any_direction(&mut random);
        if random.random() {
            // Almost parallel to the surface.
            let rise = magnitude(1e-6..0.1, &mut random);
            let along = unit(cross(leaving, outwards));
            leaving = unit(std::array::from_fn(|k| along[k] + rise * outwards[k]));
        } else if dot(leaving, outwards) < 0.0 {
            leaving = leaving.map(|x| -x);
        }
        let [near, beyond] = starts(&found, fm(found.leave, from_f64(share)));
        let (outside, inside) =
            if dot(outwards, vector(found.plane)) > 0.0 { (near, beyond) } else { (beyond, near) };
        let back = leaving.map(|x| -x);
        let wrong = [
            meets(&shape, outside, leaving),
            meets(&shape, inside, leaving) != within[0],
            meets(&shape, inside, back) != within[1],
        ];
        lost += wrong.into_iter().map(u32::from).sum::<u32>();
    }
    lost
}

/// Checks that half of `leave` is enough, and prints which share is not.
fn check(shape: fn(&mut ChaCha8Rng) -> Shape, meets: Meets, within: [bool; 2]) {
    for power in 0..6 {
        let share = 0.5_f64.powi(power);
        let lost = lost_rays(share, shape, meets, within);
        println!("{share} of leave: {lost} of 120000 rays lost");
        assert!(lost == 0 || share < 0.5, "{lost} with {share}");
    }
}

/// A position nearer than 1000 that a record can represent.
fn any_place(random: &mut ChaCha8Rng) -> Vector {
    let distance = magnitude(0.1..1000.0, random);
    any_direction(random).map(|x| to_f64(from_f64(distance * x)))
}

#[test]
fn spheres_are_left_and_entered() {
    let shape = |random: &mut ChaCha8Rng| {
        let radius = to_f64(from_f64(magnitude(0.01..30.0, random)));
        Shape::sphere(any_place(random), radius)
    };
    let meets = |shape: &Shape, origin, direction: Vector| {
        let radius = from_f64(shape.offset);
        let sphere =
            BareSphere { centre: shape.centre.map(from_f64), radius_squared: fm(radius, radius) };
        let ray =
            sphere_ray::Ray { origin, direction: direction.map(from_f64), t: FARTHEST, object: 0 };
        sphere_ray::nearest(ray, &sphere, OBJECT).object == OBJECT
    };
    check(shape, meets, [true, true]);
}

#[test]
fn planes_are_left_and_gone_through() {
    let shape = |random: &mut ChaCha8Rng| Shape::plane(any_place(random), any_direction(random));
    let meets = |shape: &Shape, origin, direction: Vector| {
        let plane = Rectangle {
            point: shape.centre.map(from_f64),
            normal: shape.axis.map(from_f64),
            dual_u: [0; 3],
            dual_v: [0; 3],
        };
        let none = FlatHit { t: FARTHEST, object: 0, u: 0, v: 0 };
        let direction = direction.map(from_f64);
        isect_plane(origin, direction, &plane, OBJECT, none).object == OBJECT
    };
    check(shape, meets, [true, false]);
}
