//! Collects what a file has, and makes the scene of it.

use std::collections::HashMap;
use std::sync::Arc;

use glam::{DVec2, DVec3, Vec3};
use scenes::{Light, Material, Mesh, Scene, View};

use crate::framing::{self, Up};
use crate::mask::{Corner, Mask};
use crate::notes::Notes;
use crate::texture::shrink;
use crate::{Fault, Loaded, colours};

/// The most triangles of a file.
pub const MAX_TRIANGLES: usize = 1 << 23;
/// The most materials that the triangles of a file have.
pub const MAX_MATERIALS: usize = 65_536;
/// The most corners of a face. The time to cut it into triangles grows with their square.
pub const MAX_CORNERS: usize = 4096;
/// The largest coordinate: SPUs' singles hold the squares of the numbers up to it.
pub(crate) const LARGEST: f64 = (1_u64 << 62) as f64;

/// The parts of a scene, as a format's reader finds them.
#[derive(Default)]
pub(crate) struct Builder {
    vertices: Vertices,
    triangles: Vec<[u32; 3]>,
    triangle_materials: Vec<u32>,
    materials: Vec<Material>,
    /// For each material, where its surfaces have holes.
    masks: Vec<Option<Arc<Mask>>>,
    pub two_sided: bool,
    /// Whether all vertices stay as they were added, because an animation moves them.
    pub keeps_vertices: bool,
    /// The corners of a box that the view shows beside all vertices.
    pub reach: Option<[DVec3; 2]>,
    /// The vertices that were added on triangles with holes.
    pub cuts: Vec<Cut>,
    /// Where up is, for a view of the mesh.
    pub up: Up,
    pub view: Option<View>,
    pub lights: Vec<Light>,
    pub notes: Notes,
}

/// A vertex, with those of its properties that the file has.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Vertex {
    pub position: DVec3,
    /// Of any length; 0 makes the triangle flat.
    pub normal: Option<DVec3>,
    pub coordinates: Option<[f32; 2]>,
    /// A colour that multiplies the material's, encoded for the screen.
    pub colour: Option<[f32; 3]>,
}

/// A vertex on a triangle, as shares of the triangle's corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cut {
    vertex: u32,
    corners: [u32; 3],
    shares: DVec3,
}

impl Cut {
    /// Makes the vertex's property of those of the corners, if they have it.
    pub fn mix(&self, properties: &mut [[f32; 3]]) {
        if properties.is_empty() {
            return;
        }
        let of = |corner: u32| Vec3::from(properties[corner as usize]).as_dvec3();
        let parts = self.corners.iter().zip(self.shares.to_array());
        let mixed: DVec3 = parts.map(|(&corner, share)| share * of(corner)).sum();
        properties[self.vertex as usize] = mixed.as_vec3().to_array();
    }
}

/// Vertices as arrays. Those of properties that no vertex has are empty, all others are as long as
/// that of the positions.
#[derive(Default)]
struct Vertices {
    positions: Vec<DVec3>,
    normals: Vec<[f32; 3]>,
    coordinates: Vec<[f32; 2]>,
    colours: Vec<[f32; 3]>,
}

/// Adds a property of vertex `index` to an array, if it has one.
fn put<T: Copy>(array: &mut Vec<T>, index: usize, value: Option<T>, otherwise: T) {
    if value.is_some() || !array.is_empty() {
        array.resize(index, otherwise);
        array.push(value.unwrap_or(otherwise));
    }
}

impl Vertices {
    fn push(&mut self, vertex: &Vertex) {
        let index = self.positions.len();
        let normal = vertex.normal.map(|normal| normal.as_vec3().to_array());
        put(&mut self.normals, index, normal, [0.0; 3]);
        put(&mut self.coordinates, index, vertex.coordinates, [0.0; 2]);
        put(&mut self.colours, index, vertex.colour, [1.0; 3]);
        self.positions.push(vertex.position);
    }

    fn vertex(&self, index: u32) -> Vertex {
        let index = index as usize;
        let wide = |it: &[f32; 3]| DVec3::from(it.map(f64::from));
        Vertex {
            position: self.positions[index],
            normal: self.normals.get(index).map(wide),
            coordinates: self.coordinates.get(index).copied(),
            colour: self.colours.get(index).copied(),
        }
    }

    /// Makes the arrays that are not empty as long as that of the positions.
    fn even_out(&mut self) {
        let count = self.positions.len();
        if !self.normals.is_empty() {
            self.normals.resize(count, [0.0; 3]);
        }
        if !self.coordinates.is_empty() {
            self.coordinates.resize(count, [0.0; 2]);
        }
        if !self.colours.is_empty() {
            self.colours.resize(count, [1.0; 3]);
        }
    }
}

impl Builder {
    /// Adds a material, and returns its index.
    pub fn material(&mut self, material: Material, mask: Option<Arc<Mask>>) -> Result<u32, Fault> {
        if self.materials.len() == MAX_MATERIALS {
            return Err(Fault::TooManyMaterials);
        }
        self.materials.push(material);
        self.masks.push(mask);
        Ok(self.materials.len() as u32 - 1)
    }

    /// Adds a vertex, and returns its index.
    pub fn vertex(&mut self, vertex: &Vertex) -> Result<u32, Fault> {
        let index = self.vertices.positions.len();
        let numbers = [vertex.position, vertex.normal.unwrap_or_default()];
        for (what, vector) in ["vertex", "normal"].into_iter().zip(numbers) {
            let is_bad = |number: &f64| !number.is_finite();
            if let Some(value) = vector.to_array().into_iter().find(is_bad) {
                return Err(Fault::NotFinite { what, index, value });
            }
        }
        let coordinates = vertex.coordinates.unwrap_or_default();
        if let Some(value) = coordinates.into_iter().find(|it| !it.is_finite()) {
            let (what, value) = ("texture coordinate", value.into());
            return Err(Fault::NotFinite { what, index, value });
        }
        if vertex.position.abs().max_element() > LARGEST {
            let position = vertex.position.to_array();
            return Err(Fault::OutOfRange { index, position });
        }
        if index >= 3 * MAX_TRIANGLES {
            return Err(Fault::TooManyVertices);
        }
        self.vertices.push(vertex);
        Ok(index as u32)
    }

    /// Adds a triangle of vertices that were added.
    pub fn triangle(&mut self, corners: [u32; 3], material: u32) -> Result<(), Fault> {
        let mask = self.masks.get(material as usize).and_then(Option::as_ref);
        if let Some(mask) = mask.filter(|_| !self.vertices.coordinates.is_empty()) {
            let mask = mask.clone();
            return self.cut_out(&mask, corners, material);
        }
        self.add(corners, material)
    }

    fn add(&mut self, corners: [u32; 3], material: u32) -> Result<(), Fault> {
        if self.triangles.len() == MAX_TRIANGLES {
            return Err(Fault::TooManyTriangles);
        }
        self.triangles.push(corners);
        self.triangle_materials.push(material);
        Ok(())
    }

    /// Adds the parts of a triangle that a mask leaves.
    fn cut_out(&mut self, mask: &Mask, corners: [u32; 3], material: u32) -> Result<(), Fault> {
        let ends = corners.map(|corner| self.vertices.vertex(corner));
        let places = ends.map(|end| {
            let [u, v] = end.coordinates.unwrap_or_default();
            DVec2::new(u.into(), v.into())
        });
        for part in mask.parts(places) {
            let mut numbers = Vec::with_capacity(part.len());
            for corner in part {
                numbers.push(match corner {
                    Corner::Own(corner) => corners[corner],
                    Corner::Within(shares) => {
                        let vertex = self.vertex(&mixed(&ends, shares))?;
                        if self.keeps_vertices {
                            self.cuts.push(Cut { vertex, corners, shares });
                        }
                        vertex
                    }
                });
            }
            for pair in numbers[1..].windows(2) {
                self.add([numbers[0], pair[0], pair[1]], material)?;
            }
        }
        Ok(())
    }

    /// Adds a polygon of vertices that were added, which may be concave. Returns whether it is
    /// drawn right: triangles around the first corner stand for a polygon whose edges cross.
    pub fn face(&mut self, corners: &[u32], material: u32) -> Result<bool, Fault> {
        let &[start, ref rest @ ..] = corners else {
            return Ok(true);
        };
        let fan = |builder: &mut Self| {
            let mut pairs = rest.windows(2);
            pairs.try_for_each(|pair| builder.triangle([start, pair[0], pair[1]], material))
        };
        if corners.len() <= 3 {
            fan(self)?;
            return Ok(true);
        }
        if corners.len() > MAX_CORNERS {
            return Err(Fault::TooManyCorners(corners.len()));
        }
        let place = |&corner: &u32| self.vertices.positions[corner as usize];
        let places: Vec<DVec3> = corners.iter().map(place).collect();
        if is_fan(&places) {
            fan(self)?;
            return Ok(true);
        }
        let Some(found) = scenes::triangles(&places) else {
            fan(self)?;
            return Ok(false);
        };
        for triangle in found {
            self.triangle(triangle.map(|corner| corners[corner as usize]), material)?;
        }
        Ok(true)
    }

    /// The scene of all parts. What the file doesn't have is added: a material, a view, lights.
    pub fn finish(mut self, name: &str) -> Result<Loaded, Fault> {
        if self.triangles.is_empty() {
            return Err(Fault::NoTriangles);
        }
        if self.materials.is_empty() {
            self.materials.push(Material::matte(DVec3::splat(0.8)));
        }
        let mut vertices = self.vertices;
        vertices.even_out();
        if !vertices.colours.is_empty() {
            let is_folded = colours::fold(
                &vertices.colours,
                &self.triangles,
                &mut self.triangle_materials,
                &mut self.materials,
            );
            if is_folded {
                vertices.colours.clear();
            }
        }
        if vertices.coordinates.is_empty() {
            // Of materials whose faces all lack coordinates.
            self.materials.iter_mut().for_each(|it| it.texture = None);
        } else if self.materials.iter().all(|it| it.texture.is_none()) {
            vertices.coordinates.clear();
        }
        if let Some(note) = shrink(&mut self.materials) {
            self.notes.add(note);
        }

        let used = self.triangles.iter().flatten();
        let mut used = used.map(|&vertex| vertices.positions[vertex as usize]);
        let first = used.next().unwrap_or_default();
        let [low, high] = self.reach.unwrap_or([first; 2]);
        let (low, high) = used
            .chain([first])
            .fold((low, high), |(low, high), place| (low.min(place), high.max(place)));
        let origin = Mesh::origin_for(low, high);
        let relative = |place: &DVec3| (*place - origin).as_vec3().to_array();
        let mut mesh = Mesh {
            origin,
            positions: vertices.positions.iter().map(relative).collect(),
            normals: vertices.normals,
            texture_coordinates: vertices.coordinates,
            colours: vertices.colours,
            triangles: self.triangles,
            materials: self.triangle_materials,
            visibility: Vec::new(),
            two_sided: self.two_sided,
        };
        let has_area = |triangle: usize| {
            let [a, b, c] = mesh.corners(triangle).map(|corner| corner.as_dvec3());
            (b - a).cross(c - a) != DVec3::ZERO
        };
        if !(0..mesh.triangles.len()).any(has_area) {
            return Err(Fault::NoArea(mesh.triangles.len()));
        }
        if !self.keeps_vertices {
            join_vertices(&mut mesh);
        }
        let added_light = self.lights.is_empty();
        let (lights, ambient) = if added_light {
            framing::lights(self.up, self.view.as_ref())
        } else {
            (self.lights, framing::AMBIENT)
        };
        let scene = Scene {
            name: name.to_owned(),
            view: match self.view {
                Some(view) => framing::aimed(view, low, high, self.up),
                None => framing::view(low, high, self.up),
            },
            background: framing::BACKGROUND,
            sky: None,
            ambient,
            lights,
            materials: self.materials,
            objects: Vec::new(),
            mesh: Some(Arc::new(mesh)),
            heights: None,
            height_map: None,
            fog: None,
        };
        Ok(Loaded { scene, added_light, animation: None, notes: self.notes.finish(name) })
    }
}

/// Whether the triangles around the first corner of a polygon are the right ones: all of them turn
/// the same way, and so does the polygon at each corner.
fn is_fan(places: &[DVec3]) -> bool {
    let whole = scenes::area_vector(places);
    let turns = |a: DVec3, b: DVec3, c: DVec3| (b - a).cross(c - a).dot(whole) > 0.0;
    let count = places.len();
    let mut fan = places[1..].windows(2);
    let convex = |at: usize| turns(places[at], places[(at + 1) % count], places[(at + 2) % count]);
    fan.all(|pair| turns(places[0], pair[0], pair[1])) && (count == 4 || (0..count).all(convex))
}

/// The vertex at a place of a triangle, as shares of its corners.
fn mixed(ends: &[Vertex; 3], shares: DVec3) -> Vertex {
    let shares = shares.to_array();
    let each = || ends.iter().zip(shares);
    let mix = |of: fn(&Vertex) -> Option<DVec3>| {
        each().try_fold(DVec3::ZERO, |sum, (end, share)| Some(sum + share * of(end)?))
    };
    let colour = mix(|end| end.colour.map(|it| DVec3::from(it.map(f64::from))));
    let coordinates = mix(|end| {
        let [u, v] = end.coordinates?.map(f64::from);
        Some(DVec3::new(u, v, 0.0))
    });
    Vertex {
        position: mix(|end| Some(end.position)).unwrap_or_default(),
        normal: mix(|end| end.normal),
        coordinates: coordinates.map(|it| [it.x as f32, it.y as f32]),
        colour: colour.map(|it| it.as_vec3().to_array()),
    }
}

/// Makes equal vertices one vertex, if the file gives each triangle its own: shared ones take less
/// memory.
fn join_vertices(mesh: &mut Mesh) {
    if mesh.positions.len() < 2 * mesh.triangles.len() {
        return;
    }
    let mut numbers = HashMap::with_capacity(mesh.triangles.len());
    let mut joined = Mesh::default();
    for vertex in mesh.triangles.iter_mut().flatten() {
        let old = *vertex as usize;
        let position = mesh.positions[old];
        let normal = mesh.normals.get(old).copied();
        let place = mesh.texture_coordinates.get(old).copied();
        let colour = mesh.colours.get(old).copied();
        // Hashing a few words takes half the time of hashing each number.
        let ([x, y, z], [nx, ny, nz]) = (position, normal.unwrap_or_default());
        let [red, green, blue] = colour.unwrap_or_default();
        let place_or = place.unwrap_or_default();
        let pairs = [[x, y], [z, nx], [ny, nz], place_or, [red, green], [blue, 0.0]];
        let bits =
            pairs.map(|[one, other]| u64::from(one.to_bits()) << 32 | u64::from(other.to_bits()));
        *vertex = *numbers.entry(bits).or_insert_with(|| {
            joined.positions.push(position);
            joined.normals.extend(normal);
            joined.texture_coordinates.extend(place);
            joined.colours.extend(colour);
            joined.positions.len() as u32 - 1
        });
    }
    mesh.positions = joined.positions;
    mesh.normals = joined.normals;
    mesh.texture_coordinates = joined.texture_coordinates;
    mesh.colours = joined.colours;
}
