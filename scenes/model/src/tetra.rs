//! Generates the tetrahedra, the Standard Procedural Databases' scene "tetra".
//!
//! A tetrahedron has its vertices at every other corner of a cube. Each further level replaces it
//! by four of half the size in its corners.
//!
//! Source of the numbers: the published tetra.nff of SPD 3. Invariant: the line numbers in the
//! generated scene are those of its own text.

use glam::DVec3;

use crate::names::{Count, largest};
use crate::{Excerpt, Light, LightKind, Limits, Material, Object, Scene, Shader, Shape, View};

/// The prefix of generated tetrahedra's name: `tetra:LEVEL`.
pub(crate) const PREFIX: &str = "tetra:";

/// The vertices of a tetrahedron in its cube: the corners whose signs have a positive product.
const CORNERS: [DVec3; 4] = [
    DVec3::new(-1.0, -1.0, 1.0),
    DVec3::new(-1.0, 1.0, -1.0),
    DVec3::new(1.0, -1.0, -1.0),
    DVec3::ONE,
];

/// Its faces, each counter-clockwise from outside.
const FACES: [[usize; 3]; 4] = [[0, 1, 2], [3, 2, 1], [2, 3, 0], [1, 0, 3]];

/// Lines of the text before the first polygon.
const LINES_BEFORE: u32 = 10;
/// Lines of a polygon.
const LINES_EACH: u32 = 4;

/// Why tetrahedra can't be generated.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// The level is not a number.
    #[error(
        "tetra level {0} is not a whole number from 0 to {most}, as in tetra:3",
        most = largest(Limits::default().objects, polygon_count)
    )]
    Level(Excerpt),
    /// The scene exceeds the default [`Limits`].
    #[error(
        "tetra of level {level} has {} polygons, more than {limit} objects; the largest level is {}",
        Count(*count),
        largest(*limit, polygon_count)
    )]
    TooMany {
        /// The requested level.
        level: u32,
        /// The number of its polygons, or `u128::MAX` if that is larger.
        count: u128,
        /// Most objects.
        limit: usize,
    },
}

/// How many polygons a level has, four for each of 4^level tetrahedra; the largest number there is
/// stands for all beyond it.
#[must_use]
pub fn polygon_count(level: u32) -> u128 {
    let power = level.checked_add(1);
    power.and_then(|power| 4u128.checked_pow(power)).unwrap_or(u128::MAX)
}

/// Generates the scene; level 0 is one tetrahedron, SPD's default of 4096 polygons is level 5.
///
/// # Errors
/// A level with more objects than the default [`Limits`] allow.
pub fn generate(level: u32) -> Result<Scene, Error> {
    let limit = Limits::default().objects;
    let count = polygon_count(level);
    // Below the limit the count fits a usize and the line numbers a u32.
    if count > limit as u128 {
        return Err(Error::TooMany { level, count, limit });
    }
    let mut objects = Vec::with_capacity(count as usize);
    grow(&mut objects, DVec3::ZERO, 1.0, level);
    Ok(Scene {
        name: format!("{PREFIX}{level}"),
        view: View {
            from: DVec3::new(1.022846, -3.177154, -2.174512),
            at: DVec3::new(-0.004103, -0.004103, 0.216539),
            up: DVec3::new(-0.816497, -0.816497, 0.816497),
            angle: 45.0,
            hither: 1.0,
            resolution: (512, 512),
        },
        background: DVec3::new(0.078, 0.361, 0.753),
        sky: None,
        ambient: DVec3::ZERO,
        lights: vec![Light {
            line: 9,
            kind: LightKind::Point { position: DVec3::new(2.0, -18.0, -5.0), range: f64::INFINITY },
            colour: None,
        }],
        materials: vec![Material {
            line: 10,
            colour: DVec3::new(1.0, 0.2, 0.2),
            diffuse: 1.0,
            specular: 0.0,
            shine: 0.0,
            transmittance: 0.0,
            refraction_index: 1.0,
            emission: DVec3::ZERO,
            shader: Shader::Phong,
            texture: None,
        }],
        objects,
        mesh: None,
        heights: None,
        height_map: None,
        fog: None,
    })
}

/// Adds a tetrahedron, or for each further level the four in its corners.
fn grow(objects: &mut Vec<Object>, centre: DVec3, half: f64, levels: u32) {
    let corners = |reach: f64| CORNERS.map(|corner| centre + reach * corner);
    if levels > 0 {
        let half = half / 2.0;
        for corner in corners(half) {
            grow(objects, corner, half, levels - 1);
        }
        return;
    }
    let vertices = corners(half);
    for face in FACES {
        objects.push(Object {
            line: LINES_BEFORE + 1 + LINES_EACH * objects.len() as u32,
            material: 0,
            shape: Shape::Polygon { vertices: face.map(|vertex| vertices[vertex]).to_vec() },
        });
    }
}
