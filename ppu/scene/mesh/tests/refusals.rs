//! Meshes that can't be converted.

use super::super::{MeshBlocks, MeshError, MeshObjects};
use super::meshes::{materials, mesh, soup};

fn refused(mesh: &scenes::Mesh, materials: &[scenes::Material]) -> String {
    MeshBlocks::new(mesh, &MeshObjects::default(), materials).unwrap_err().to_string()
}

#[test]
fn meshes_without_an_area() {
    let flat = mesh(vec![[1.0; 3]; 3], vec![[0, 1, 2]; 2]);
    let message = "all 2 triangles of the mesh are degenerate: their area is 0";
    assert_eq!(refused(&flat, &materials()), message);
    let empty = mesh(Vec::new(), Vec::new());
    assert_eq!(
        MeshBlocks::new(&empty, &MeshObjects::default(), &materials()).unwrap_err(),
        MeshError::NoArea(0)
    );
}

#[test]
fn coordinates_without_a_square() {
    let mut large = soup(10, 1.0, 1);
    large.positions[7][1] = 5e18;
    assert!(refused(&large, &materials()).starts_with("vertex 7 is at ["));
    large.positions[7][1] = f32::NAN;
    assert!(refused(&large, &materials()).starts_with("vertex 7 is at ["));
}

#[test]
fn too_many_materials_are_refused() {
    let mut colourful = soup(65_537, 1.0, 1);
    let materials = vec![materials().remove(0); 65_537];
    colourful.materials = (0..65_537).collect();
    let message = "the scene's objects have 65537 different materials; there may be 65536";
    assert_eq!(refused(&colourful, &materials), message);
    colourful.materials[65_536] = 7;
    assert!(MeshBlocks::new(&colourful, &MeshObjects::default(), &materials).is_ok());
}
