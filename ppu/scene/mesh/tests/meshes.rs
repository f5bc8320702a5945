//! Meshes for the tests.

use glam::{DVec3, Vec3};
use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use scenes::{Material, Mesh, Shader};

use crate::scene::random::unit;

/// An opaque material, and one that transmits light.
pub fn materials() -> Vec<Material> {
    let material = |transmittance: f64| Material {
        line: 0,
        colour: DVec3::ONE,
        diffuse: 1.0,
        specular: 0.0,
        shine: 1.0,
        transmittance,
        refraction_index: 1.5,
        emission: DVec3::ZERO,
        shader: Shader::Phong,
        texture: None,
    };
    vec![material(0.0), material(0.5)]
}

/// Triangles of the first material.
pub fn mesh(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>) -> Mesh {
    Mesh { positions, materials: vec![0; triangles.len()], triangles, ..Mesh::default() }
}

/// Random triangles that share no vertices, about `size` large in a cube of side 2.
pub fn soup(count: u32, size: f32, seed: u64) -> Mesh {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut positions = Vec::new();
    for _ in 0..count {
        let middle = Vec3::from_array(std::array::from_fn(|_| random.random_range(-1.0..1.0)));
        for _ in 0..3 {
            let off = unit(&mut random).as_vec3();
            positions.push((middle + size * off).to_array());
        }
    }
    let triangle = |index: u32| [3 * index, 3 * index + 1, 3 * index + 2];
    mesh(positions, (0..count).map(triangle).collect())
}

/// A closed surface of `rows` times twice `rows` squares, of two triangles each: a lumpy sphere.
pub fn ball(rows: u32) -> Mesh {
    let columns = 2 * rows;
    let mut positions = Vec::new();
    for row in 0..=rows {
        for column in 0..columns {
            let up = std::f64::consts::PI * f64::from(row) / f64::from(rows);
            let around = std::f64::consts::TAU * f64::from(column) / f64::from(columns);
            let (ring, height) = (libm::sin(up), libm::cos(up));
            let radius = 1.0 + 0.1 * libm::sin(7.0 * around) * ring;
            let point = DVec3::new(ring * libm::cos(around), ring * libm::sin(around), height);
            positions.push((radius * point).as_vec3().to_array());
        }
    }
    let mut triangles = Vec::new();
    for row in 0..rows {
        for column in 0..columns {
            let at = |row: u32, column: u32| row * columns + column % columns;
            let (a, b) = (at(row, column), at(row, column + 1));
            let (c, d) = (at(row + 1, column), at(row + 1, column + 1));
            triangles.extend([[a, c, d], [a, d, b]]);
        }
    }
    mesh(positions, triangles)
}
