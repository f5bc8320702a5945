//! Random content for worlds. No two surfaces are in the same place, because which of them is
//! visible is undefined (`docs/shading.md`).

use crate::prelude::*;
use cellray::game::{DVec3, Shader, Shape};

pub fn vector(random: &mut ChaCha8Rng, most: f64) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| random.random_range(-most..most)))
}

pub fn colour(random: &mut ChaCha8Rng) -> DVec3 {
    vector(random, 1.0).abs()
}

/// A shape of any kind, at most 4 from the origin in each direction.
pub fn shape(random: &mut ChaCha8Rng) -> Shape {
    let middle = vector(random, 3.0);
    let [a, b, c] = std::array::from_fn(|_| vector(random, 0.8));
    match random.random_range(0..8) {
        0..3 => sphere(random),
        3 => Shape::Cone {
            base: middle,
            base_radius: random.random_range(0.05..0.6),
            apex: middle + a,
            apex_radius: random.random_range(0.0..0.6),
        },
        4 => {
            // The vertices need not be in a plane.
            let bent = if random.random() { 0.7 * c } else { DVec3::ZERO };
            Shape::Polygon { vertices: vec![middle, middle + a, middle + a + b + bent, middle + b] }
        }
        5 => Shape::Polygon { vertices: vec![middle, middle + a, middle + b] },
        6 => Shape::Polygon {
            vertices: vec![
                middle,
                middle + a,
                middle + 1.2 * a + 0.5 * b,
                middle + 0.8 * a + b,
                middle + b,
            ],
        },
        _ => Shape::Patch {
            vertices: vec![middle, middle + a, middle + b],
            normals: vec![a.cross(b), a.cross(b) + 0.2 * c, a.cross(b) + 0.1 * b],
        },
    }
}

pub fn sphere(random: &mut ChaCha8Rng) -> Shape {
    Shape::Sphere {
        centre: vector(random, 3.0),
        radius: libm::exp2(random.random_range(-5.0..0.0f64)),
    }
}

/// A random material. `goes_on` allows it to reflect or refract rays.
pub fn material(random: &mut ChaCha8Rng, goes_on: bool) -> Material {
    let shader = match random.random_range(0..8) {
        0 => Shader::Flat,
        1 => Shader::Lambert,
        2 => Shader::Checker { other: colour(random), size: random.random_range(0.2..1.0) },
        3 => Shader::Depth { far: 20.0, near: 4.0 },
        _ => Shader::Phong,
    };
    let mut material = Material {
        colour: colour(random),
        diffuse: random.random_range(0.2..0.9),
        shader,
        ..Material::matte(0.0, 0.0, 0.0)
    };
    if goes_on && random.random_bool(0.3) {
        material.specular = random.random_range(0.1..0.5);
        material.shine = 20.0;
    }
    if goes_on && random.random_bool(0.2) {
        material.transmittance = 0.7;
        material.refraction_index = 1.4;
    }
    material
}

pub fn light(random: &mut ChaCha8Rng) -> Light {
    let place = vector(random, 1.0) + DVec3::new(1.0, 6.0, 4.0);
    let light = if random.random() { Light::at(place).within(20.0) } else { Light::sun(place) };
    if random.random() {
        let [red, green, blue] = colour(random).to_array();
        light.coloured(red, green, blue)
    } else {
        light
    }
}
