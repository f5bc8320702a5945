//! Closed meshes with a point inside each, and rays from there to their edges and vertices.
//!
//! Invariant: the surface encloses the point, however the vertices were rounded.

use twins::triangle::Triangle;

use crate::flat_records::Point;
use crate::prelude::*;

/// A place far from the origin, as in embree's tests.
pub const FAR_OUT: Vector = [148_376.0, 1234.0, -223_423.0];

/// A closed mesh and a point inside it.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// The vertices.
    pub vertices: Vec<Point>,
    /// The numbers of the faces' vertices.
    pub faces: Vec<[usize; 3]>,
    /// The point inside.
    pub inside: Point,
}

impl Mesh {
    /// The vertices of an icosahedron, each scaled. Every ray from `inside` in the direction of
    /// one of the icosahedron's vertices meets that vertex of the mesh, as long as rounding moves
    /// it by less than the mesh's smallest width.
    pub fn icosahedron(place: Vector, size: f64, widths: Vector, random: &mut impl Rng) -> Self {
        let golden = (1.0 + 5_f64.sqrt()) / 2.0;
        let mut vertices = Vec::new();
        for axis in 0..3 {
            for (one, long) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
                let mut vertex = [0.0; 3];
                vertex[(axis + 1) % 3] = one;
                vertex[(axis + 2) % 3] = long * golden;
                vertices.push(unit(vertex));
            }
        }
        // All edges have the distance of neighbours as their length. Three vertices that are
        // neighbours of each other form a face.
        let near = |a: usize, b: usize| dot(vertices[a], vertices[b]) > 0.4;
        let mut faces = Vec::new();
        for a in 0..12 {
            for b in (a + 1..12).filter(|b| near(a, *b)) {
                faces.extend((b + 1..12).filter(|c| near(a, *c) && near(b, *c)).map(|c| [a, b, c]));
            }
        }
        let vertices = vertices
            .iter()
            .map(|vertex| {
                let stretch = size * random.random_range(0.5..2.0);
                point(std::array::from_fn(|axis| {
                    place[axis] + stretch * widths[axis] * vertex[axis]
                }))
            })
            .collect();
        let offset = in_cube(0.05 * size, random);
        let inside = point(std::array::from_fn(|axis| place[axis] + widths[axis] * offset[axis]));
        Self { vertices, faces, inside }
    }

    /// The triangles, each with a random orientation.
    pub fn triangles(&self, random: &mut impl Rng) -> Vec<Triangle> {
        let triangle = |face: &[usize; 3]| {
            let mut face = *face;
            if random.random() {
                face.swap(0, 1);
            }
            face.rotate_left(random.random_range(0..3));
            face.map(|vertex| self.vertices[vertex])
        };
        self.faces.iter().map(triangle).collect()
    }

    /// The origin and direction of a ray to a vertex or to a point on an edge, or within about an
    /// ulp of these.
    pub fn aimed(&self, random: &mut impl Rng) -> [Point; 2] {
        let towards = self.towards_edge(random);
        self.nearly(unit(towards), random)
    }

    /// From the point inside to a vertex or to a point on an edge.
    pub fn towards_edge(&self, random: &mut impl Rng) -> Vector {
        let face = self.faces[random.random_range(0..self.faces.len() as u32) as usize];
        let from = random.random_range(0..3_usize);
        let ends = [face[from], face[(from + 1) % 3]];
        let [a, b] = ends.map(|vertex| self.vertices[vertex].map(to_f64));
        let share = match random.random_range(0..4) {
            0 => 0.0,
            1 => 0.5,
            2 => random.random_range(0.0..1e-6),
            _ => random.random_range(0.0..1.0),
        };
        let target = std::array::from_fn(|axis| a[axis] + share * (b[axis] - a[axis]));
        sub(target, self.inside.map(to_f64))
    }

    /// The origin and direction of a ray from inside in this direction, or within an ulp of it.
    pub fn nearly(&self, towards: Vector, random: &mut impl Rng) -> [Point; 2] {
        let mut direction = towards.map(from_f64);
        if random.random() {
            let axis = random.random_range(0..3_usize);
            if to_f64(direction[axis]) != 0.0 {
                direction[axis] = direction[axis].wrapping_add_signed(random.random_range(-1..=1));
            }
        }
        [self.inside, direction]
    }
}
