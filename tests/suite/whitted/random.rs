//! Random scenes with everything that a scene can contain, including content that nobody would
//! write. No two surfaces are in the same place, because which of them is visible is undefined
//! (`docs/shading.md`).

use std::f64::consts::TAU;

use glam::{DQuat, Vec3Swizzles as _};
use scenes::{Fog, Light, LightKind, Material, Object, Scene, Sky, View};

use crate::prelude::*;
use crate::whitted::placed::place;

/// A sphere with at least this radius is vast, like a ground, among objects with a size of about
/// 1.
const VAST: f64 = 16.0;

pub struct Drawn {
    pub scene: Scene,
    /// Whether there is a vast sphere.
    pub vast: bool,
}

/// A small scene: a few objects of all shapes, some without area, some around the eye, at any
/// scale from 1e-4 to 1e6, and sometimes far from the origin.
pub fn scene(random: &mut ChaCha8Rng) -> Drawn {
    let scale = libm::pow(10f64, random.random_range(-4.0..6.0));
    let middle = if random.random_bool(0.2) { vector(random, 1000.0) } else { DVec3::ZERO };
    let materials: Vec<Material> =
        (0..random.random_range(1..5)).map(|_| material(random)).collect();
    let mut scene = Scene {
        name: "random".into(),
        view: view(random),
        background: vector(random, 1.0).abs(),
        sky: None,
        ambient: if random.random_bool(0.3) { vector(random, 0.3).abs() } else { DVec3::ZERO },
        lights: (0..random.random_range(0..4)).map(|_| light(random)).collect(),
        objects: (0..random.random_range(1..9))
            .map(|_| Object {
                line: 0,
                material: random.random_range(0..materials.len()) as u32,
                shape: shape(random),
            })
            .collect(),
        materials,
        mesh: None,
        heights: None,
        height_map: None,
        fog: None,
    };
    // Without a random number, so that the scenes are the same ones as without fog and skies.
    scene.fog = scene
        .objects
        .len()
        .is_multiple_of(5)
        .then(|| Fog { colour: scene.background.yzx(), density: 0.15 / scale });
    scene.sky = scene
        .objects
        .len()
        .is_multiple_of(3)
        .then(|| Sky { zenith: scene.background.zxy(), up: scene.view.up });
    let is_vast = |object: &Object| matches!(object.shape, Shape::Sphere { radius, .. } if radius.abs() >= VAST);
    let vast = scene.objects.iter().any(is_vast);
    place(&mut scene, middle, scale);
    Drawn { scene, vast }
}

fn vector(random: &mut ChaCha8Rng, most: f64) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| random.random_range(-most..most)))
}

fn view(random: &mut ChaCha8Rng) -> View {
    // Sometimes in the middle of the objects, perhaps inside one.
    let distance = if random.random_bool(0.3) { 1.5 } else { 6.0 };
    View {
        from: vector(random, distance),
        at: vector(random, 0.7) + DVec3::new(0.0, 0.0, 0.8),
        up: DVec3::new(0.3, 0.5, 1.0),
        angle: random.random_range(10.0..70.0),
        hither: 0.0,
        resolution: (16, 16),
    }
}

fn light(random: &mut ChaCha8Rng) -> Light {
    let colour = random.random_bool(0.5).then(|| vector(random, 0.9).abs());
    let kind = if random.random_bool(0.3) {
        LightKind::Directional { to_light: vector(random, 1.0) }
    } else {
        let position = vector(random, 8.0);
        let range = if position.x > 0.0 { 9.0 } else { f64::INFINITY };
        LightKind::Point { position, range }
    };
    Light { line: 0, kind, colour }
}

fn material(random: &mut ChaCha8Rng) -> Material {
    let mut share = |chance: f64, most: f64| {
        if random.random_bool(chance) { random.random_range(0.0..most) } else { 0.0 }
    };
    let (diffuse, specular, transmittance) = (share(0.9, 1.0), share(0.6, 0.9), share(0.4, 0.95));
    let shine = libm::pow(10f64, share(0.9, 2.5));
    let colour = vector(random, 1.0).abs();
    let emission = if transmittance > 0.5 { 0.3 * colour } else { DVec3::ZERO };
    Material {
        line: 0,
        colour,
        diffuse,
        specular,
        shine: if random.random_bool(0.1) { 0.0 } else { shine },
        transmittance,
        refraction_index: random.random_range(0.6..2.4),
        emission,
        shader: shader(random),
        texture: None,
    }
}

fn shader(random: &mut ChaCha8Rng) -> Shader {
    match random.random_range(0..10) {
        0 => Shader::Flat,
        1 => Shader::Lambert,
        2 => Shader::Checker {
            other: vector(random, 1.0).abs(),
            size: random.random_range(0.3..2.0),
        },
        3 => {
            let near = random.random_range(0.0..4.0);
            Shader::Depth { far: near + random.random_range(0.5..8.0), near }
        }
        4 => Shader::Portal { by: vector(random, 3.0), turn: random.random_range(-180.0..=180.0) },
        _ => Shader::Phong,
    }
}

fn shape(random: &mut ChaCha8Rng) -> Shape {
    let hollow = if random.random_bool(0.2) { -1.0 } else { 1.0 };
    match random.random_range(0..20) {
        0 => {
            let radius = VAST * libm::exp2(random.random_range(0.0..6.0f64));
            let to_centre = DQuat::from_scaled_axis(vector(random, 3.0)) * DVec3::X;
            Shape::Sphere {
                centre: (radius + random.random_range(0.0..3.0)) * to_centre,
                radius: hollow * radius,
            }
        }
        1..8 => Shape::Sphere {
            centre: vector(random, 2.0),
            radius: hollow * libm::exp2(random.random_range(-4.0..1.2f64)),
        },
        8..12 => {
            let radius = libm::exp2(random.random_range(-8.0..0.3f64));
            let apex_radius = match random.random_range(0..3) {
                0 => 0.0,
                1 => radius,
                _ => libm::exp2(random.random_range(-8.0..0.3f64)),
            };
            Shape::Cone {
                base: vector(random, 2.0),
                base_radius: hollow * radius,
                apex: vector(random, 2.0),
                apex_radius: hollow * apex_radius,
            }
        }
        12..17 => Shape::Polygon { vertices: polygon(random) },
        _ => {
            let vertices = polygon(random);
            let up = scenes::unit(scenes::area_vector(&vertices)).unwrap_or(DVec3::Z);
            let normals = vertices.iter().map(|_| up + vector(random, 0.3)).collect();
            Shape::Patch { vertices, normals }
        }
    }
}

/// A polygon in a random plane: regular, star-shaped, a parallelogram, or without area.
fn polygon(random: &mut ChaCha8Rng) -> Vec<DVec3> {
    let middle = vector(random, 2.0);
    let turn = DQuat::from_scaled_axis(vector(random, 3.0));
    let (right, up) = (turn * DVec3::X, turn * DVec3::Y);
    let reach = random.random_range(0.3..3.0);
    let corners = random.random_range(3..9);
    let ring = |radius: &mut dyn FnMut(u32) -> f64| {
        let corner = |number: u32| {
            let angle = TAU * f64::from(number) / f64::from(corners);
            middle + radius(number) * (libm::cos(angle) * right + libm::sin(angle) * up)
        };
        (0..corners).map(corner).collect()
    };
    match random.random_range(0..10) {
        0..4 => ring(&mut |_| reach),
        4..6 => ring(&mut |_| reach * random.random_range(0.3..1.0)),
        6..9 => {
            let (side, other) = (reach * right, reach * (0.4 * right + 0.8 * up));
            vec![middle, middle + side, middle + side + other, middle + other]
        }
        _ => vec![middle, middle + reach * right, middle + 0.5 * reach * right],
    }
}
