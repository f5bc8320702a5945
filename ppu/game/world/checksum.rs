//! A checksum of a world's content, the same on every machine.

use glam::DVec3;
use scenes::{LightKind, Material, Mesh, Shader, Shape};

use super::Light;

/// FNV-1a over the big-endian bytes of everything that is added.
pub(super) struct Checksum(u64);

impl Checksum {
    pub fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    pub fn number(&self) -> u64 {
        self.0
    }

    pub fn word(&mut self, word: u64) {
        self.bytes(&word.to_be_bytes());
    }

    pub fn float(&mut self, value: f64) {
        self.word(value.to_bits());
    }

    pub fn vector(&mut self, vector: DVec3) {
        vector.to_array().into_iter().for_each(|value| self.float(value));
    }

    fn vectors(&mut self, vectors: &[DVec3]) {
        self.word(vectors.len() as u64);
        vectors.iter().for_each(|&vector| self.vector(vector));
    }

    pub fn shape(&mut self, shape: &Shape) {
        match shape {
            Shape::Sphere { centre, radius } => {
                self.word(0);
                self.vector(*centre);
                self.float(*radius);
            }
            Shape::Cone { base, base_radius, apex, apex_radius } => {
                self.word(1);
                self.vectors(&[*base, *apex]);
                self.float(*base_radius);
                self.float(*apex_radius);
            }
            Shape::Polygon { vertices } => {
                self.word(2);
                self.vectors(vertices);
            }
            Shape::Patch { vertices, normals } => {
                self.word(3);
                self.vectors(vertices);
                self.vectors(normals);
            }
        }
    }

    /// A mesh without its place and its materials. The visibility of lights changes no picture.
    pub fn mesh(&mut self, mesh: &Mesh) {
        if mesh.origin != DVec3::ZERO {
            self.vector(mesh.origin);
        }
        for vectors in [&mesh.positions, &mesh.normals] {
            self.word(vectors.len() as u64);
            for number in vectors.iter().flatten() {
                self.bytes(&number.to_bits().to_be_bytes());
            }
        }
        for number in mesh.texture_coordinates.iter().flatten() {
            self.bytes(&number.to_bits().to_be_bytes());
        }
        for number in mesh.colours.iter().flatten() {
            self.bytes(&number.to_bits().to_be_bytes());
        }
        for number in mesh.triangles.iter().flatten().chain(&mesh.materials) {
            self.bytes(&number.to_be_bytes());
        }
        self.word(u64::from(mesh.two_sided));
    }

    pub fn light(&mut self, light: &Light) {
        match light.kind {
            LightKind::Point { position, range } => {
                self.word(if range == f64::INFINITY { 0 } else { 2 });
                self.vector(position);
                if range != f64::INFINITY {
                    self.float(range);
                }
            }
            LightKind::Directional { to_light } => {
                self.word(1);
                self.vector(to_light);
            }
        }
        self.word(u64::from(light.colour.is_some()));
        self.vector(light.colour.unwrap_or_default());
    }

    pub fn material(&mut self, material: &Material) {
        self.vector(material.colour);
        for share in [
            material.diffuse,
            material.specular,
            material.shine,
            material.transmittance,
            material.refraction_index,
        ] {
            self.float(share);
        }
        // Properties that most materials lack are omitted, so that sums of older recordings stay
        // valid.
        if material.emission != DVec3::ZERO {
            self.vector(material.emission);
        }
        if let Some(texture) = &material.texture {
            self.word(texture.checksum());
        }
        match &material.shader {
            Shader::Flat => self.word(0),
            Shader::Lambert => self.word(1),
            Shader::Phong => self.word(2),
            Shader::Checker { other, size } => {
                self.word(3);
                self.vector(*other);
                self.float(*size);
            }
            Shader::Depth { far, near } => {
                self.word(4);
                self.float(*far);
                self.float(*near);
            }
            Shader::Portal { by, turn } => {
                self.word(6);
                self.vector(*by);
                self.float(*turn);
            }
            Shader::Own { name, parameters } => {
                self.word(5);
                self.word(name.len() as u64);
                self.bytes(name.as_bytes());
                parameters.iter().for_each(|&value| self.float(value));
            }
        }
    }

    fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}
