//! Refitted blocks are right in every field, and are those of the tree if nothing has moved.

use glam::{DAffine3, DVec3};
use scenes::Mesh;

use super::super::{MeshBlocks, MeshObjects};
use super::meshes::{ball, materials, soup};
use super::valid::check;

fn moved(mesh: &Mesh, place: DAffine3) -> Mesh {
    let mut moved = mesh.clone();
    for position in &mut moved.positions {
        let [x, y, z] = position.map(f64::from);
        let there = place.transform_point3(DVec3::new(x, y, z));
        *position = there.as_vec3().to_array();
    }
    moved
}

fn blocks(mesh: &Mesh) -> MeshBlocks {
    MeshBlocks::new(mesh, &MeshObjects::default(), &materials()).unwrap()
}

#[test]
fn blocks_are_unchanged_if_vertices_are() {
    for mesh in [soup(1, 1.0, 1), soup(300, 0.1, 2), ball(60)] {
        let blocks = blocks(&mesh);
        let refitted = blocks.refitted(&mesh).unwrap();
        assert!(refitted.bytes() == blocks.bytes());
        assert!((refitted.wear() - 1.0).abs() < 1e-9);
    }
}

#[test]
fn boxes_are_made_around_moved_triangles() {
    let turned = DAffine3::from_rotation_z(0.7) * DAffine3::from_rotation_x(0.3);
    // The ball has slivers at its poles, which only an exact quarter turn leaves with an area.
    let quarter = DAffine3::from_cols(DVec3::Y, DVec3::NEG_X, DVec3::Z, DVec3::ZERO);
    for (mesh, place) in [
        (soup(1, 1.0, 1), turned),
        (soup(9, 1.0, 1), turned),
        (soup(5000, 0.1, 2), turned),
        (ball(60), quarter),
    ] {
        let there = moved(&mesh, place);
        let refitted = blocks(&mesh).refitted(&there).unwrap();
        check(&there, &materials(), &refitted);
    }
}

#[test]
fn tree_degrades_when_triangles_move_apart() {
    let mesh = soup(5000, 0.1, 3);
    let blocks = blocks(&mesh);
    let wear = |there: &Mesh| blocks.refitted(there).unwrap().wear();
    let turned = wear(&moved(&mesh, DAffine3::from_rotation_y(0.2)));
    assert!(turned < 1.3, "{turned}");
    let mut torn = mesh.clone();
    for (triangle, corners) in torn.positions.chunks_mut(3).enumerate() {
        for corner in corners {
            corner[0] += (triangle % 2) as f32 * 4.0;
        }
    }
    let torn = wear(&torn);
    assert!(torn > 5.0, "{torn}");
    assert!(blocks.refitted(&soup(4999, 0.1, 3)).is_none());
}
