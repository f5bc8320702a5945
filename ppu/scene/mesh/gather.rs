//! Makes a mesh of a scene's polygons, if they are too many for local store.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

use glam::DVec3;
use scenes::{Mesh, Object, Scene, Shape, Visibility, triangles, unit};

/// The most triangles that stay in local store. Records and bounding volumes of more don't fit it.
pub(crate) const RESIDENT: usize = 512;
/// Parallelograms take one record instead of two triangles, and stay in local store if there are
/// only this many.
const PARALLELOGRAMS: usize = 64;

/// The scene, with its polygons and patches in its mesh if they are more than fit local store.
/// Positions become singles there.
#[must_use]
pub fn gathered(scene: &Scene) -> Cow<'_, Scene> {
    let knows_material = |object: &Object| (object.material as usize) < scene.materials.len();
    let known = scene.objects.iter().filter(|object| knows_material(object));
    let shapes = known.map(|object| &object.shape);
    if !are_many(shapes.clone()) {
        return Cow::Borrowed(scene);
    }
    Cow::Owned(with_polygons_in_mesh(scene, keeps_quads(shapes)))
}

/// The scene with all of its polygons and patches in its mesh, for scenes whose other shapes need
/// their space; `None` if it has none that can be there, so that this changes nothing.
#[must_use]
pub(crate) fn gathered_all(scene: &Scene) -> Option<Scene> {
    let mut shapes = scene.objects.iter().map(|object| &object.shape);
    if !shapes.any(|shape| size(shape) > 0) {
        return None;
    }
    let gathered = with_polygons_in_mesh(scene, false);
    (gathered.objects.len() < scene.objects.len()).then_some(gathered)
}

fn with_polygons_in_mesh(scene: &Scene, keeps_quads: bool) -> Scene {
    let is_moved = |object: &Object| {
        let is_kept = keeps_quads && is_quad(&object.shape);
        let knows_material = (object.material as usize) < scene.materials.len();
        size(&object.shape) > 0 && knows_material && !is_kept
    };
    let corners = 3 * scene.objects.iter().map(|it| size(&it.shape)).sum::<usize>();
    let mut gatherer = Gatherer::new(scene, corners);
    let mut rest = Vec::new();
    for object in &scene.objects {
        if !is_moved(object) || !gatherer.add(object) {
            rest.push(object.clone());
        }
    }
    Scene {
        name: scene.name.clone(),
        view: scene.view.clone(),
        lights: scene.lights.clone(),
        materials: scene.materials.clone(),
        objects: rest,
        mesh: Some(Arc::new(gatherer.mesh)),
        heights: scene.heights.clone(),
        height_map: scene.height_map.clone(),
        ..*scene
    }
}

/// Whether enough of the shapes are polygons and patches to gather these.
pub(crate) fn are_many<'a>(shapes: impl Iterator<Item = &'a Shape> + Clone) -> bool {
    let keeps_quads = keeps_quads(shapes.clone());
    let moved = shapes.filter(|shape| !(keeps_quads && is_quad(shape)));
    moved.map(size).sum::<usize>() > RESIDENT
}

fn keeps_quads<'a>(shapes: impl Iterator<Item = &'a Shape>) -> bool {
    shapes.filter(|shape| is_quad(shape)).count() <= PARALLELOGRAMS
}

/// The triangles of a shape; 0 if it is no polygon or patch.
fn size(shape: &Shape) -> usize {
    match shape {
        Shape::Polygon { vertices } | Shape::Patch { vertices, .. } => {
            vertices.len().saturating_sub(2)
        }
        Shape::Sphere { .. } | Shape::Cone { .. } => 0,
    }
}

/// Whether a shape is a polygon of four vertices, which may be a parallelogram.
fn is_quad(shape: &Shape) -> bool {
    matches!(shape, Shape::Polygon { vertices } if vertices.len() == 4)
}

/// A vertex as bits: its position, and its normal or zeros. Hashing a few words takes half the
/// time of hashing each number.
type Bits = [u64; 3];

struct Gatherer {
    mesh: Mesh,
    /// The vertices of the mesh that polygons share.
    known: HashMap<Bits, u32>,
}

impl Gatherer {
    /// `corners`: those of all triangles that may be added.
    fn new(scene: &Scene, corners: usize) -> Self {
        let mut mesh = scene
            .mesh
            .as_deref()
            .cloned()
            .unwrap_or_else(|| Mesh { origin: origin(&scene.objects), ..Mesh::default() });
        mesh.normals.resize(mesh.positions.len(), [0.0; 3]);
        let known = HashMap::with_capacity(corners);
        Self { mesh, known }
    }

    /// Adds the triangles of a polygon; `false` if it has none, because its edges cross or a
    /// coordinate is no single.
    fn add(&mut self, object: &Object) -> bool {
        let (vertices, normals) = match &object.shape {
            Shape::Polygon { vertices } => (vertices, None),
            Shape::Patch { vertices, normals } => (vertices, Some(normals)),
            Shape::Sphere { .. } | Shape::Cone { .. } => return false,
        };
        let in_range = |vertex: &DVec3| vertex.as_vec3().is_finite();
        if !vertices.iter().all(in_range) {
            return false;
        }
        let Some(found) = triangles(vertices) else {
            return false;
        };
        for triangle in found {
            let corners = triangle.map(|corner| {
                let corner = corner as usize;
                let normal = normals.and_then(|normals| unit(normals[corner]));
                self.vertex(vertices[corner], normal.unwrap_or_default())
            });
            self.mesh.triangles.push(corners);
            self.mesh.materials.push(object.material);
            if !self.mesh.visibility.is_empty() {
                self.mesh.visibility.push(Visibility::default());
            }
        }
        true
    }

    fn vertex(&mut self, position: DVec3, normal: DVec3) -> u32 {
        let vertex = [position - self.mesh.origin, normal].map(|it| it.as_vec3().to_array());
        let [[x, y, z], [nx, ny, nz]] = vertex;
        let bits = [[x, y], [z, nx], [ny, nz]]
            .map(|[one, other]| u64::from(one.to_bits()) << 32 | u64::from(other.to_bits()));
        let Self { mesh, known } = self;
        *known.entry(bits).or_insert_with(|| {
            let [position, normal] = vertex;
            mesh.positions.push(position);
            mesh.normals.push(normal);
            if !mesh.texture_coordinates.is_empty() {
                mesh.texture_coordinates.push([0.0; 2]);
            }
            if !mesh.colours.is_empty() {
                mesh.colours.push([1.0; 3]);
            }
            mesh.positions.len() as u32 - 1
        })
    }
}

/// The origin for the polygons and patches among some objects.
fn origin(objects: &[Object]) -> DVec3 {
    let vertices = objects.iter().flat_map(|object| match &object.shape {
        Shape::Polygon { vertices } | Shape::Patch { vertices, .. } => vertices.as_slice(),
        Shape::Sphere { .. } | Shape::Cone { .. } => &[],
    });
    let around = vertices.map(|&vertex| [vertex; 2]);
    let around = around.reduce(|[low, high], [vertex, _]| [low.min(vertex), high.max(vertex)]);
    around.map_or(DVec3::ZERO, |[low, high]| Mesh::origin_for(low, high))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn scene(name: &str) -> Scene {
        scenes::load(Path::new(name)).expect("a scene")
    }

    #[test]
    fn few_triangles_are_not_gathered() {
        let scene = scene("tetra:3");
        assert!(matches!(gathered(&scene), Cow::Borrowed(_)));
    }

    #[test]
    fn many_triangles_share_their_vertices() {
        let scene = scene("tetra:5");
        let gathered = gathered(&scene);
        assert!(gathered.objects.is_empty());
        let mesh = gathered.mesh.as_ref().expect("a mesh");
        assert_eq!(mesh.triangles.len(), 4096);
        // A tetrahedron's corner is one of four around a point, or one of the six outermost.
        assert!(mesh.positions.len() < 2100, "{}", mesh.positions.len());
        for (triangle, object) in scene.objects.iter().enumerate() {
            assert_eq!(mesh.shape(triangle), object.shape);
        }
    }

    #[test]
    fn all_polygons_are_gathered_if_required() {
        let few = scene("tetra:1");
        let gathered = gathered_all(&few).expect("polygons");
        assert!(gathered.objects.is_empty());
        assert_eq!(gathered.mesh.map(|mesh| mesh.triangles.len()), Some(16));
        assert!(gathered_all(&scene("sphereflake:0")).is_some(), "the floor");
        let mut balls = scene("sphereflake:1");
        balls.objects.retain(|object| size(&object.shape) == 0);
        assert!(gathered_all(&balls).is_none());
    }

    #[test]
    fn other_shapes_stay_objects() {
        let mut scene = scene("tetra:5");
        scene.objects.push(Object {
            line: 0,
            material: 0,
            shape: Shape::Sphere { centre: DVec3::ZERO, radius: 1.0 },
        });
        let gathered = gathered(&scene);
        assert_eq!(gathered.objects.len(), 1);
    }
}
