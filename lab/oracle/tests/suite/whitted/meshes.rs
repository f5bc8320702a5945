//! A mesh looks like polygons in the same places.

use std::sync::Arc;

use glam::DVec3;
use oracle::whitted::{Options, trace};
use scenes::{Mesh, Scene, Shape};

/// The scene with its triangles in a mesh. Their coordinates are singles.
fn with_mesh(scene: &Scene) -> Scene {
    let mut mesh = Mesh::default();
    for object in &scene.objects {
        let Shape::Polygon { vertices } = &object.shape else {
            panic!("{object:?}");
        };
        let first = mesh.positions.len() as u32;
        let singles = vertices.iter().map(|vertex| vertex.as_vec3().to_array());
        mesh.positions.extend(singles);
        mesh.triangles.push([first, first + 1, first + 2]);
        mesh.materials.push(object.material);
    }
    Scene { objects: Vec::new(), mesh: Some(Arc::new(mesh)), ..scene.clone() }
}

#[test]
fn a_mesh_is_drawn_as_polygons_are() {
    let polygons = scenes::load("tetra:3".as_ref()).expect("a scene");
    let mesh = with_mesh(&polygons);
    let draw = |scene: &Scene| trace(scene, 90, 90, &Options::default()).expect("a picture");
    let (polygons, counts) = draw(&polygons);
    assert!(counts.hit > 1000, "{counts:?}");
    assert_eq!(draw(&mesh), (polygons, counts));
}

#[test]
fn back_of_two_sided_mesh_is_visible() {
    let front = with_mesh(&scenes::load("tetra:0".as_ref()).expect("a scene"));
    let mut mesh = Mesh::clone(front.mesh.as_deref().expect("a mesh"));
    // Wound the other way, only the far faces are visible from the front.
    for triangle in &mut mesh.triangles {
        triangle.swap(0, 1);
    }
    let draw = |mesh: &Mesh| {
        let scene = Scene {
            mesh: Some(Arc::new(mesh.clone())),
            lights: Vec::new(),
            ambient: DVec3::ONE,
            ..front.clone()
        };
        let (reference, counts) = trace(&scene, 60, 60, &Options::default()).expect("a picture");
        (reference.picture, counts.hit)
    };
    let (inside, hits) = draw(&mesh);
    mesh.two_sided = true;
    let (both, as_many) = draw(&mesh);
    // The outline is the same, and so is the colour by ambient light.
    assert_eq!((inside, hits), (both, as_many));
    mesh.triangles.truncate(1);
    mesh.materials.truncate(1);
    let (_, seen) = draw(&mesh);
    mesh.triangles[0].swap(0, 1);
    assert_eq!(draw(&mesh).1, seen);
    mesh.two_sided = false;
    let one_way = draw(&mesh).1;
    mesh.triangles[0].swap(0, 1);
    let other_way = draw(&mesh).1;
    assert!(one_way.min(other_way) == 0 && one_way.max(other_way) == seen);
}
