//! How the spheres and rays of each family are made.

use crate::generator::Generator;
use rand::Rng as _;
use spu_emulator::float::single::to_f64;
use twins::sphere_ray::Ray;

use super::{Form, PACKETS, Shot};
use crate::space::{
    across, add_scaled, direction, fresh, in_cube, in_sphere, nearest, on_disc, point, sub, unit,
};
use crate::truth::Vector;

/// How far origins are from 0, in radii.
const AROUND: f64 = 8.0;

/// A random radius of any order of magnitude.
fn radius(random: &mut Generator) -> f64 {
    random.random_range(0.5..2.0)
}

/// The origin of a form's rays, within a cube with this half side.
fn origin(form: Form, half: f64, random: &mut Generator) -> Vector {
    match form {
        Form::Eye => [0.0; 3],
        Form::General => in_cube(half, random).map(rounded),
    }
}

/// The value of the nearest single. Rays are aimed from their rounded origins.
fn rounded(value: f64) -> f64 {
    to_f64(nearest(value))
}

fn ray(origin: Vector, direction: Vector) -> Ray {
    fresh(point(origin), point(direction))
}

/// A ray towards a point.
fn ray_to(target: Vector, from: Vector) -> Ray {
    ray(from, unit(sub(target, from)))
}

/// A sphere, and packets of the rays that `aim` returns.
fn shot(
    centre: Vector,
    radius: f64,
    random: &mut Generator,
    mut aim: impl FnMut(&mut Generator) -> Ray,
) -> Shot {
    let packet = |_| std::array::from_fn(|_| aim(random));
    Shot {
        centre: point(centre),
        radius: nearest(radius),
        packets: (0..PACKETS).map(packet).collect(),
    }
}

/// The rays' origin, an axis, and the centre of a sphere at this distance along the axis.
fn ahead(from: Vector, distance: f64, random: &mut Generator) -> [Vector; 3] {
    let axis = direction(random);
    [from, axis, add_scaled(from, distance, axis)]
}

/// Rays from a point to the disc within 2 radii of a sphere.
fn over([from, axis, centre]: [Vector; 3], radius: f64, random: &mut Generator) -> Shot {
    shot(centre, radius, random, |random| ray_to(on_disc(centre, axis, 2.0 * radius, random), from))
}

pub(super) fn at_ratio(random: &mut Generator, form: Form, ratio: f64) -> Shot {
    let radius = radius(random);
    let from = origin(form, AROUND * radius, random);
    let places = ahead(from, ratio * radius, random);
    over(places, radius, random)
}

pub(super) fn tiny(random: &mut Generator, form: Form, size: f64) -> Shot {
    let from = origin(form, 1.0, random);
    let radius = size * radius(random);
    // By its ratio, like the others.
    let ratio = 1e3 / radius;
    let places = ahead(from, ratio * radius, random);
    over(places, radius, random)
}

pub(super) fn grazing(random: &mut Generator, form: Form, ratio: f64) -> Shot {
    let radius = radius(random);
    let from = origin(form, AROUND * radius, random);
    let [_, axis, centre] = ahead(from, ratio * radius, random);
    shot(centre, radius, random, |random| {
        let sine = random.random_range(0.999..1.001) / ratio;
        let sideways = unit(sub(on_disc([0.0; 3], axis, 1.0, random), [0.0; 3]));
        let cosine = (1.0 - sine * sine).sqrt();
        let towards = add_scaled(axis.map(|component| cosine * component), sine, sideways);
        ray(from, unit(towards))
    })
}

pub(super) fn inside(random: &mut Generator, _: Form, scale: f64) -> Shot {
    let radius = scale * radius(random);
    let centre = in_cube(radius, random);
    shot(centre, radius, random, |random| {
        let from = add_scaled(centre, 1.0, in_sphere(0.5 * radius, random));
        ray(from, direction(random))
    })
}

pub(super) fn ground(random: &mut Generator, form: Form, radius: f64) -> Shot {
    let from = origin(form, 100.0, random);
    let up = direction(random);
    let height = random.random_range(1.0..100.0);
    let centre = add_scaled(from, -(radius + height), up);
    shot(centre, radius, random, |random| {
        let below = add_scaled(from, -height, up);
        let target = on_disc(below, up, 20.0 * height, random);
        ray_to(target, from)
    })
}

pub(super) fn coherent(random: &mut Generator, _: Form, ratio: f64) -> Shot {
    let radius = radius(random);
    let centre = in_cube(AROUND * radius, random);
    let packet = |_| {
        let axis = direction(random);
        let from = add_scaled(centre, -ratio * radius, axis).map(rounded);
        let [right, down] = across(axis);
        let middle = on_disc(centre, axis, 2.0 * radius, random);
        std::array::from_fn(|lane| {
            let step = |at: usize| (at as f64 - 1.5) * 0.02 * radius;
            let target =
                add_scaled(add_scaled(middle, step(lane % 4), right), step(lane / 4), down);
            ray_to(target, from)
        })
    };
    Shot {
        packets: (0..PACKETS).map(packet).collect(),
        centre: point(centre),
        radius: nearest(radius),
    }
}

pub(super) fn incoherent(random: &mut Generator, _: Form, _: f64) -> Shot {
    let radius = radius(random);
    let centre = in_cube(AROUND * radius, random);
    shot(centre, radius, random, |random| {
        let doublings = random.random_range(1..7);
        let ratio = f64::from(1_u32 << doublings) * random.random_range(1.0..2.0);
        let axis = direction(random);
        let from = add_scaled(centre, -ratio * radius, axis).map(rounded);
        let target = on_disc(centre, axis, 2.0 * radius, random);
        ray_to(target, from)
    })
}

pub(super) fn lengths(random: &mut Generator, form: Form, ratio: f64) -> Shot {
    let radius = radius(random);
    let from = origin(form, AROUND * radius, random);
    let [_, axis, centre] = ahead(from, ratio * radius, random);
    shot(centre, radius, random, |random| {
        let target = on_disc(centre, axis, 2.0 * radius, random);
        let doublings = random.random_range(0..8);
        let length = f64::from(1_u32 << doublings) / 16.0 * random.random_range(1.0..2.0);
        let towards = unit(sub(target, from));
        ray(from, towards.map(|component| length * component))
    })
}
