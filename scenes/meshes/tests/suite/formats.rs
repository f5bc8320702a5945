//! What is read from right files.

use glam::DVec3;
use scenes::LightKind;

use super::files::{JSON, OBJ, PLY, binary_ply, container, glb, load, triangle};

#[test]
fn obj_file_has_its_materials_and_normals() {
    let loaded = load("t.obj", OBJ.as_bytes()).unwrap();
    let mesh = loaded.scene.mesh.unwrap();
    assert_eq!(mesh.triangles.len(), 4);
    assert!(mesh.two_sided);
    let material = |triangle: usize| &loaded.scene.materials[mesh.materials[triangle] as usize];
    assert_eq!(material(0).colour, DVec3::X);
    assert_eq!(material(0).specular, 0.5);
    assert_eq!(material(0).shine, 20.0);
    assert_eq!(material(3).transmittance, 0.75);
    assert_eq!(material(3).refraction_index, 1.5);
    assert!(mesh.corner_normals(0).is_some());
    assert!(mesh.corner_normals(3).is_none());
    assert_eq!(mesh.bounds(), Some((DVec3::ZERO, DVec3::ONE)));
    assert!(loaded.notes.is_empty(), "{:?}", loaded.notes);
}

#[test]
fn obj_file_without_library_is_grey_with_note() {
    let loaded = load("t.obj", OBJ.replace("m.mtl", "gone.mtl").as_bytes()).unwrap();
    assert!(loaded.notes[0].contains("gone.mtl"), "{:?}", loaded.notes);
    assert_eq!(loaded.scene.materials[0].colour, DVec3::splat(0.8));
}

#[test]
fn all_ply_forms_give_same_mesh() {
    let text = load("s.ply", PLY.as_bytes()).unwrap();
    let mesh = text.scene.mesh.clone().unwrap();
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3], [0, 1, 2]]);
    assert_eq!(mesh.positions[2], [1.0, 1.0, 0.0]);
    for big_endian in [false, true] {
        let binary = load("s.ply", &binary_ply(big_endian)).unwrap();
        assert_eq!(binary.scene, text.scene);
    }
}

#[test]
fn glb_file_has_transforms_camera_and_light() {
    let loaded = load("t.glb", &glb()).unwrap();
    let mesh = loaded.scene.mesh.as_ref().unwrap();
    let corners = mesh.corners(0).map(|corner| corner.to_array());
    // Mirrored in x, so wound the other way.
    assert_eq!(corners, [[10.0, 0.0, 0.0], [10.0, 2.0, 0.0], [9.0, 0.0, 0.0]]);
    assert_eq!(mesh.corner_normals(0).unwrap()[0].to_array(), [0.0, 0.0, 1.0]);
    let [a, b, c] = mesh.corners(0);
    assert!((b - a).cross(c - a).z > 0.0);
    assert!(!mesh.two_sided);
    let view = &loaded.scene.view;
    // It looks along z, past the triangle, which is 5 units ahead.
    assert_eq!((view.from, view.at), (DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO));
    assert_eq!(view.resolution, (1024, 512));
    let light = &loaded.scene.lights[0];
    let position = DVec3::new(0.0, 4.0, 0.0);
    assert_eq!(light.kind, LightKind::Point { position, range: 7.0 });
    assert_eq!(light.colour, Some(DVec3::new(1.0, 0.5, 0.25)));
    let material = &loaded.scene.materials[0];
    assert!((material.colour - DVec3::X).length() < 1e-9);
    assert!((material.specular - 0.6).abs() < 1e-6);
    assert_eq!(material.emission, DVec3::X);
}

#[test]
fn nodes_place_shared_mesh_separately() {
    let json = JSON.replace("[0,1,2]", "[0,1,3]").replace(
        r#"{"translation":[0,4,0],"#,
        r#"{"mesh":0,"translation":[0,0,-3]},{"children":[2],"scale":[2,2,2],"#,
    );
    let loaded = load("t.glb", &container(json.as_bytes(), &triangle())).unwrap();
    let mesh = loaded.scene.mesh.as_ref().unwrap();
    assert_eq!(mesh.triangles.len(), 2);
    let corners = |triangle| mesh.corners(triangle).map(|corner| corner.to_array());
    assert_eq!(corners(0), [[10.0, 0.0, 0.0], [10.0, 2.0, 0.0], [9.0, 0.0, 0.0]]);
    // The inner node's place is doubled by the outer one.
    assert_eq!(corners(1), [[0.0, 0.0, -6.0], [2.0, 0.0, -6.0], [0.0, 2.0, -6.0]]);
}

#[test]
fn strips_and_missing_indices_make_triangles() {
    let json = JSON.replace(r#""indices":2,"#, r#""mode":5,"#);
    let strip = load("t.glb", &container(json.as_bytes(), &triangle())).unwrap();
    let whole = load("t.glb", &glb()).unwrap();
    assert_eq!(strip.scene.mesh, whole.scene.mesh);
}

#[test]
fn file_without_view_shows_whole_bounding_box() {
    for (name, bytes) in [("t.obj", OBJ), ("s.ply", PLY)] {
        let scene = load(name, bytes.as_bytes()).unwrap().scene;
        let (low, high) = scene.mesh.as_ref().unwrap().bounds().unwrap();
        let camera = scene.view.camera(101, 101).unwrap();
        let (right, down) = (camera.right.normalize(), camera.down.normalize());
        let sight = right.cross(down).normalize();
        let sight = sight * sight.dot(camera.direction(50, 50)).signum();
        let limit = camera.right.length() * 50.0 / camera.direction(50, 50).length();
        for corner in 0..8 {
            let pick = |bit: usize, axis: usize| {
                if corner >> bit & 1 == 0 { low[axis] } else { high[axis] }
            };
            let corner = DVec3::new(pick(0, 0), pick(1, 1), pick(2, 2)) - scene.view.from;
            let depth = corner.dot(sight);
            assert!(depth > 0.0);
            assert!(corner.dot(right).abs() <= limit * depth, "{name}");
            assert!(corner.dot(down).abs() <= limit * depth, "{name}");
        }
    }
}

#[test]
fn equal_vertices_are_merged() {
    let soup = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n";
    let mesh = load("s.obj", soup.as_bytes()).unwrap().scene.mesh.unwrap();
    assert_eq!(mesh.positions.len(), 4);
    assert_eq!(mesh.triangles, [[0, 1, 2], [1, 3, 2]]);
}

#[test]
fn terrain_is_viewed_from_above_with_all_materials() {
    let scene = meshes::load("terrain:6".as_ref()).unwrap().scene;
    let mesh = scene.mesh.unwrap();
    assert_eq!(mesh.triangles.len(), 2 * 64 * 64);
    assert_eq!(mesh.positions.len(), 65 * 65);
    let ups = (0..mesh.triangles.len()).map(|triangle| {
        let [a, b, c] = mesh.corners(triangle);
        (b - a).cross(c - a).y
    });
    assert!(ups.into_iter().all(|up| up > 0.0));
    for material in 0..3 {
        let count = mesh.materials.iter().filter(|&&it| it == material).count();
        assert!(count > 100, "{material}: {count}");
    }
}

#[test]
fn other_names_are_generated_scenes() {
    let loaded = meshes::load("tetra:1".as_ref()).unwrap();
    assert_eq!(loaded.scene.objects.len(), 16);
}
