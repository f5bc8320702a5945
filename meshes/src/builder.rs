//! Collects what a file has, and makes the scene of it.

use std::collections::HashMap;
use std::sync::Arc;

use glam::DVec3;
use nff::{Light, Material, Mesh, Scene, Shader, Texture, View};

use crate::framing;
use crate::texture::MAX_TEXELS;
use crate::{Fault, Loaded};

/// The most triangles of a file.
pub const MAX_TRIANGLES: usize = 1 << 23;
/// The most materials that the triangles of a file have.
pub const MAX_MATERIALS: usize = 65_536;

/// The parts of a scene, as a format's reader finds them.
#[derive(Default)]
pub(crate) struct Builder {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    has_normals: bool,
    texture_coordinates: Vec<[f32; 2]>,
    texels: usize,
    triangles: Vec<[u32; 3]>,
    triangle_materials: Vec<u32>,
    materials: Vec<Material>,
    pub two_sided: bool,
    pub view: Option<View>,
    pub lights: Vec<Light>,
    notes: Vec<String>,
}

impl Builder {
    /// Adds a note for the user, once.
    pub fn note(&mut self, note: impl Into<String>) {
        let note = note.into();
        if !self.notes.contains(&note) {
            self.notes.push(note);
        }
    }

    /// Adds a material, and returns its index.
    pub fn material(&mut self, material: Material) -> Result<u32, Fault> {
        if self.materials.len() == MAX_MATERIALS {
            return Err(Fault::TooManyMaterials);
        }
        self.materials.push(material);
        Ok(self.materials.len() as u32 - 1)
    }

    /// Adds a texture to the file's texels.
    pub fn texture(&mut self, texture: Texture) -> Result<Arc<Texture>, Fault> {
        self.texels += texture.texels().len();
        if self.texels > MAX_TEXELS {
            return Err(Fault::TooManyTexels(self.texels));
        }
        Ok(Arc::new(texture))
    }

    /// Adds vertices, and returns the index of the first one. `normals` and `texture_coordinates`
    /// are as long as `positions`, or empty.
    pub fn add_vertices(
        &mut self,
        positions: impl IntoIterator<Item = [f32; 3]>,
        normals: impl IntoIterator<Item = [f32; 3]>,
        texture_coordinates: impl IntoIterator<Item = [f32; 2]>,
    ) -> Result<usize, Fault> {
        let first = self.positions.len();
        self.positions.extend(positions);
        self.normals.extend(normals);
        self.has_normals |= self.normals.len() > first;
        self.normals.resize(self.positions.len(), [0.0; 3]);
        self.texture_coordinates.extend(texture_coordinates);
        self.texture_coordinates
            .resize(self.positions.len(), [0.0; 2]);
        check("vertex", &self.positions, first)?;
        check("normal", &self.normals, first)?;
        check("texture coordinate", &self.texture_coordinates, first)?;
        Ok(first)
    }

    /// Adds a polygon as triangles around its first vertex. The vertices count from `first`.
    pub fn face(
        &mut self,
        face: usize,
        first: usize,
        corners: &[i64],
        material: u32,
    ) -> Result<(), Fault> {
        let vertices = self.positions.len() - first;
        let &[start, ref rest @ ..] = corners else {
            return Err(Fault::Corners { face, corners: 0 });
        };
        if rest.len() < 2 {
            let corners = corners.len();
            return Err(Fault::Corners { face, corners });
        }
        let vertex = |index: i64| match usize::try_from(index) {
            Ok(found) if found < vertices => Ok((first + found) as u32),
            _ => Err(Fault::Vertex {
                face,
                index,
                vertices,
            }),
        };
        for pair in rest.windows(2) {
            if self.triangles.len() == MAX_TRIANGLES {
                return Err(Fault::TooManyTriangles);
            }
            let triangle = [vertex(start)?, vertex(pair[0])?, vertex(pair[1])?];
            self.triangles.push(triangle);
            self.triangle_materials.push(material);
        }
        Ok(())
    }

    /// The scene of all parts. What the file doesn't have is added: a material, a view, lights.
    pub fn finish(mut self, name: &str) -> Result<Loaded, Fault> {
        if self.materials.is_empty() {
            self.materials.push(plain(DVec3::splat(0.8)));
        }
        if !self.has_normals {
            self.normals.clear();
        }
        if !self
            .materials
            .iter()
            .any(|material| material.texture.is_some())
        {
            self.texture_coordinates.clear();
        }
        self.join_vertices();
        let mesh = Mesh {
            positions: self.positions,
            normals: self.normals,
            texture_coordinates: self.texture_coordinates,
            triangles: self.triangles,
            materials: self.triangle_materials,
            two_sided: self.two_sided,
            ..Mesh::default()
        };
        let (low, high) = mesh.bounds().ok_or(Fault::NoTriangles)?;
        let (lights, ambient) = if self.lights.is_empty() {
            framing::lights()
        } else {
            (self.lights, framing::AMBIENT)
        };
        let scene = Scene {
            name: name.to_owned(),
            view: self.view.unwrap_or_else(|| framing::view(low, high)),
            background: framing::BACKGROUND,
            sky: None,
            ambient,
            lights,
            materials: self.materials,
            objects: Vec::new(),
            mesh: Some(Arc::new(mesh)),
        };
        Ok(Loaded {
            scene,
            notes: self.notes,
        })
    }

    /// Makes equal vertices one vertex, if the file gives each triangle its own: shared ones take
    /// less room.
    fn join_vertices(&mut self) {
        if self.positions.len() < 2 * self.triangles.len() {
            return;
        }
        let mut numbers = HashMap::with_capacity(self.triangles.len());
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        let mut texture_coordinates = Vec::new();
        for vertex in self.triangles.iter_mut().flatten() {
            let old = *vertex as usize;
            let position = self.positions[old];
            let normal = self.normals.get(old).copied();
            let place = self.texture_coordinates.get(old).copied();
            // Hashing a few words takes half the time of hashing each number.
            let ([x, y, z], [nx, ny, nz]) = (position, normal.unwrap_or_default());
            let pairs = [[x, y], [z, nx], [ny, nz], place.unwrap_or_default()];
            let bits = pairs
                .map(|[one, other]| u64::from(one.to_bits()) << 32 | u64::from(other.to_bits()));
            *vertex = *numbers.entry(bits).or_insert_with(|| {
                positions.push(position);
                normals.extend(normal);
                texture_coordinates.extend(place);
                positions.len() as u32 - 1
            });
        }
        (self.positions, self.normals) = (positions, normals);
        self.texture_coordinates = texture_coordinates;
    }
}

/// A material without reflection.
pub(crate) fn plain(colour: DVec3) -> Material {
    Material {
        line: 0,
        colour,
        diffuse: 1.0,
        specular: 0.0,
        shine: 1.0,
        transmittance: 0.0,
        refraction_index: 1.0,
        emission: DVec3::ZERO,
        shader: Shader::Phong,
        texture: None,
    }
}

/// Checks that all numbers from `first` on are finite.
fn check<const N: usize>(
    what: &'static str,
    vectors: &[[f32; N]],
    first: usize,
) -> Result<(), Fault> {
    let is_bad = |vector: &[f32; N]| vector.iter().any(|number| !number.is_finite());
    let Some(index) = vectors[first..].iter().position(is_bad) else {
        return Ok(());
    };
    let numbers = vectors[first + index];
    let value = numbers.into_iter().find(|number| !number.is_finite());
    Err(Fault::NotFinite {
        what,
        index,
        value: value.unwrap_or_default(),
    })
}
