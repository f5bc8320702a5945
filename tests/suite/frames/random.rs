//! Random scenes.

use crate::prelude::*;
use scenes::{Material, Object, Scene, View};

/// A vector with coordinates between -`most` and `most`.
pub fn vector(random: &mut ChaCha8Rng, most: f64) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| random.random_range(-most..most)))
}

/// A sphere with a random one of the scene's materials.
pub fn sphere(random: &mut ChaCha8Rng, materials: usize) -> Object {
    Object {
        line: 0,
        material: random.random_range(0..materials) as u32,
        shape: Shape::Sphere {
            centre: vector(random, 4.0),
            radius: libm::exp2(random.random_range(-6.0..0.5f64)),
        },
    }
}

/// Spheres of several colours, at most 4 from the origin in each direction, seen from a distance
/// of 12.
pub fn random_scene(random: &mut ChaCha8Rng, count: usize) -> Scene {
    let material = |colour| Material {
        line: 0,
        colour,
        diffuse: 1.0,
        specular: 0.0,
        shine: 0.0,
        transmittance: 0.0,
        refraction_index: 1.0,
        emission: DVec3::ZERO,
        shader: Shader::Phong,
        texture: None,
    };
    let materials: Vec<Material> = (0..5).map(|_| material(vector(random, 1.0).abs())).collect();
    Scene {
        name: "random".into(),
        view: View {
            from: DVec3::new(0.0, -12.0, 0.0),
            at: DVec3::ZERO,
            up: DVec3::new(0.1, 0.2, 1.0),
            angle: 40.0,
            hither: 0.0,
            resolution: (64, 64),
        },
        background: DVec3::new(0.1, 0.2, 0.3),
        sky: None,
        ambient: DVec3::ZERO,
        lights: Vec::new(),
        objects: (0..count).map(|_| sphere(random, materials.len())).collect(),
        materials,
        mesh: None,
        heights: None,
        height_map: None,
        fog: None,
    }
}
