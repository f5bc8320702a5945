//! Generates the sphereflake, the Standard Procedural Databases' scene "balls".
//!
//! Each sphere has nine children that touch it, with a third of its radius: six around its equator
//! and three around its pole. A child's pole points away from its parent.
//!
//! Source of the numbers: the published balls.nff of SPD 3. Invariant: the line numbers in the
//! generated scene are those of its own text.

use std::f64::consts::{FRAC_PI_3, FRAC_PI_4, PI};

use glam::{DQuat, DVec3};

use crate::names::{Count, largest};
use crate::{Excerpt, Light, LightKind, Limits, Material, Object, Scene, Shader, Shape, View};

/// The prefix of a generated sphereflake's name: `sphereflake:LEVEL`.
pub(crate) const PREFIX: &str = "sphereflake:";

/// The radius of the first sphere. It is at the origin, and the ground is below it.
const RADIUS: f64 = 0.5;
/// Half the side of the square ground.
const GROUND: f64 = 12.0;
/// A child's radius, relative to its parent's.
const SHRINK: f64 = 1.0 / 3.0;
/// The pole of the first sphere.
const POLE: DVec3 = DVec3::Z;
/// The positions of the lights.
const LIGHTS: [DVec3; 3] =
    [DVec3::new(4.0, 3.0, 2.0), DVec3::new(1.0, -4.0, 4.0), DVec3::new(-3.0, 1.0, 5.0)];

/// Why a sphereflake can't be generated.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// The level is not a number.
    #[error(
        "sphereflake level {0} is not a whole number from 0 to {most}, as in sphereflake:2",
        most = largest_level(Limits::default().objects)
    )]
    Level(Excerpt),
    /// The scene exceeds the default [`Limits`].
    #[error(
        "a sphereflake of level {level} has {} spheres and a polygon, more than {limit} objects; the \
         largest level is {}", Count(*count), largest_level(*limit)
    )]
    TooMany {
        /// The requested level.
        level: u32,
        /// The number of its spheres, or `u128::MAX` if that is larger.
        count: u128,
        /// The most objects.
        limit: usize,
    },
}

/// The number of spheres of a level: the sum of 9^n for n from 0 to the level, or `u128::MAX` if
/// that is larger.
#[must_use]
pub fn sphere_count(level: u32) -> u128 {
    let next = level.checked_add(1).and_then(|levels| 9u128.checked_pow(levels));
    next.map_or(u128::MAX, |next| (next - 1) / 8)
}

/// The largest level of at most `limit` objects.
fn largest_level(limit: usize) -> u32 {
    largest(limit, |level| sphere_count(level).saturating_add(1))
}

/// Generates the scene. Level 0 is one sphere on the ground; SPD's default is 4.
///
/// # Errors
/// The level has more objects than the default [`Limits`] allow.
pub fn generate(level: u32) -> Result<Scene, Error> {
    let limit = Limits::default().objects;
    let count = sphere_count(level);
    // Below the limit the count fits a usize and the line numbers a u32.
    if count >= limit as u128 {
        return Err(Error::TooMany { level, count, limit });
    }
    let view = View {
        from: DVec3::new(2.1, 1.3, 1.7),
        at: DVec3::ZERO,
        up: POLE,
        angle: 45.0,
        hither: 0.01,
        resolution: (512, 512),
    };
    let ground = Material {
        line: 12,
        colour: DVec3::new(1.0, 0.75, 0.33),
        diffuse: 0.8,
        specular: 0.0,
        shine: 100_000.0,
        transmittance: 0.0,
        refraction_index: 1.0,
        emission: DVec3::ZERO,
        shader: Shader::Phong,
        texture: None,
    };
    let sphere = Material {
        line: 18,
        colour: DVec3::new(1.0, 0.9, 0.7),
        diffuse: 0.5,
        specular: 0.5,
        shine: 3.0827,
        transmittance: 0.0,
        refraction_index: 1.0,
        emission: DVec3::ZERO,
        shader: Shader::Phong,
        texture: None,
    };
    let corner = |x: f64, y: f64| DVec3::new(x * GROUND, y * GROUND, -RADIUS);
    let vertices = vec![corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0), corner(1.0, -1.0)];
    let mut objects = Vec::with_capacity(count as usize + 1);
    objects.push(Object { line: 13, material: 0, shape: Shape::Polygon { vertices } });
    grow(
        &mut objects,
        &children(),
        &Flake { centre: DVec3::ZERO, radius: RADIUS, pole: POLE },
        level,
    );
    Ok(Scene {
        name: format!("{}{level}", PREFIX),
        view,
        background: DVec3::new(0.078, 0.361, 0.753),
        sky: None,
        ambient: DVec3::ZERO,
        lights: LIGHTS
            .into_iter()
            .zip(9..)
            .map(|(position, line)| Light {
                line,
                kind: LightKind::Point { position, range: f64::INFINITY },
                colour: None,
            })
            .collect(),
        materials: vec![ground, sphere],
        objects,
        mesh: None,
        heights: None,
        height_map: None,
        fog: None,
    })
}

/// A sphere, and the direction of its pole, of length 1.
struct Flake {
    centre: DVec3,
    radius: f64,
    pole: DVec3,
}

/// Adds `sphere` and, down to `levels` below it, its descendants, each right after its parent.
fn grow(objects: &mut Vec<Object>, children: &[DVec3; 9], sphere: &Flake, levels: u32) {
    let shape = Shape::Sphere { centre: sphere.centre, radius: sphere.radius };
    // The first sphere is on line 19 and follows one polygon.
    let line = objects.len() as u32 + 18;
    objects.push(Object { line, material: 1, shape });
    if levels == 0 {
        return;
    }
    let turn = DQuat::from_rotation_arc(POLE, sphere.pole);
    let radius = sphere.radius * SHRINK;
    for &child in children {
        let pole = (turn * child).normalize();
        let centre = sphere.centre + (sphere.radius + radius) * pole;
        grow(objects, children, &Flake { centre, radius, pole }, levels - 1);
    }
}

/// The directions of the children of a sphere with its pole at [`POLE`]: nine of a cuboctahedron's
/// twelve vertices, so that neighbours are 60 degrees apart. There are three sets, each with one
/// child near the pole and the two next to it on the equator.
fn children() -> [DVec3; 9] {
    // The face around the pole is an equilateral triangle of chords of length 1.
    let near_pole = libm::asin(1.0 / 3.0f64.sqrt());
    let direction = |from_pole: f64, azimuth: f64| {
        let (across, along) = libm::sincos(from_pole);
        DVec3::new(across * libm::cos(azimuth), across * libm::sin(azimuth), along)
    };
    std::array::from_fn(|index| {
        let azimuth = FRAC_PI_4 + (index / 3) as f64 * 2.0 * FRAC_PI_3;
        match index % 3 {
            0 => direction(near_pole, azimuth),
            1 => direction(PI / 2.0, azimuth - PI / 6.0),
            _ => direction(PI / 2.0, azimuth + PI / 6.0),
        }
    })
}
