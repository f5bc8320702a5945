//! Every triangle in exactly one leaf, boxes as small as they can be, numbers in order.

use std::sync::Arc;

use super::super::{Colour, MeshBlocks, MeshObjects, NumberWidth, Numbers};
use super::meshes::{ball, materials, mesh, soup};
use super::valid::check;

fn checked(mesh: &scenes::Mesh) -> MeshBlocks {
    let materials = materials();
    let blocks = MeshBlocks::new(mesh, &MeshObjects::default(), &materials).unwrap();
    check(mesh, &materials, &blocks);
    assert_eq!(blocks.bytes().as_ptr().addr() % 128, 0);
    blocks
}

#[test]
fn meshes_of_all_sizes() {
    for count in [1, 2, 8, 9, 16, 17, 60, 300, 5000] {
        checked(&soup(count, 0.1, u64::from(count)));
        checked(&soup(count, 3.0, u64::from(count)));
    }
    for rows in [2, 3, 10, 60] {
        checked(&ball(rows));
    }
}

#[test]
fn single_triangle_is_one_leaf() {
    assert_eq!(checked(&soup(1, 1.0, 1)).count(), 1);
}

#[test]
fn triangles_in_one_place_and_in_a_line() {
    let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    checked(&mesh(positions, vec![[0, 1, 2]; 1000]));
    let mut line = soup(1000, 1e-3, 5);
    for position in &mut line.positions {
        position[1] *= 1e-6;
        position[2] *= 1e-6;
    }
    checked(&line);
}

#[test]
fn triangles_whose_sizes_have_all_magnitudes() {
    let mut wide = soup(600, 0.5, 6);
    for (index, position) in wide.positions.iter_mut().enumerate() {
        let scale = libm::exp2(120.0 * (index / 3) as f64 / 600.0 - 60.0) as f32;
        *position = position.map(|number| number * scale);
    }
    checked(&wide);
}

#[test]
fn triangles_without_an_area_are_left_out() {
    let mut found = soup(100, 0.2, 7);
    found.triangles[3] = [5, 5, 7];
    found.triangles[4] = [1, 1, 1];
    found.positions[30] = [0.0, 0.0, 0.0];
    found.positions[31] = [0.25, 0.5, 1.0];
    found.positions[32] = [0.5, 1.0, 2.0];
    let statistics = checked(&found).statistics();
    assert_eq!((statistics.triangles, statistics.left_out), (97, 3));
}

#[test]
fn blocks_have_one_side_mode() {
    let mut mixed = ball(20);
    mixed.normals = mixed.positions.clone();
    for (index, normal) in mixed.normals.iter_mut().enumerate() {
        if index % 3 == 0 {
            *normal = [0.0; 3];
        }
    }
    for (index, material) in mixed.materials.iter_mut().enumerate() {
        *material = (index % 5 == 0).into();
    }
    checked(&mixed);
    mixed.two_sided = true;
    checked(&mixed);
}

#[test]
fn texture_coordinates_are_kept_for_textured_materials() {
    let texture = scenes::Texture::new(1, vec![[1, 2, 3]], [scenes::Wrap::Clamp; 2]);
    let mut materials = materials();
    materials[0].texture = texture.map(Arc::new);
    for rows in [2, 5, 40] {
        let mut mesh = ball(rows);
        let plain = MeshBlocks::new(&mesh, &MeshObjects::default(), &materials).unwrap();
        check(&mesh, &materials, &plain);
        let places = mesh.positions.iter().map(|[x, y, z]| [2.0 * x + z, 9.0 * y]);
        mesh.texture_coordinates = places.collect();
        for (triangle, material) in mesh.materials.iter_mut().enumerate() {
            *material = u32::from(triangle % 5 == 0);
        }
        let blocks = MeshBlocks::new(&mesh, &MeshObjects::default(), &materials).unwrap();
        check(&mesh, &materials, &blocks);
        assert!(blocks.count() > plain.count() || rows == 2);
    }
}

#[test]
fn materials_with_wide_numbers() {
    let materials = vec![materials().remove(0); 5000];
    for (count, width) in [(256, NumberWidth::Byte), (5000, NumberWidth::TwoBytes)] {
        let mut mesh = ball(50);
        for (triangle, material) in mesh.materials.iter_mut().enumerate() {
            *material = (triangle as u32 * 7919) % count;
        }
        let blocks = MeshBlocks::new(&mesh, &MeshObjects::default(), &materials).unwrap();
        assert_eq!(blocks.materials().len(), count as usize);
        assert_eq!(blocks.width(), width);
        check(&mesh, &materials, &blocks);
    }
}

#[test]
fn equal_materials_share_a_number() {
    let materials = vec![materials().remove(0); 3];
    let mut mesh = ball(20);
    for (triangle, material) in mesh.materials.iter_mut().enumerate() {
        *material = triangle as u32 % 3;
    }
    let firsts = [0, 1, 0];
    let numbers = Numbers { firsts: &firsts, minimum: NumberWidth::TwoBytes };
    let blocks = MeshBlocks::numbered(
        &mesh,
        &MeshObjects::default(),
        None,
        &materials,
        numbers,
        Colour::Linear,
    );
    let blocks = blocks.unwrap();
    assert_eq!(blocks.materials(), [0, 1]);
    for material in &mut mesh.materials {
        *material = firsts[*material as usize];
    }
    check(&mesh, &materials, &blocks);
}

#[test]
fn colours_are_stored_with_vertices() {
    let texture = scenes::Texture::new(1, vec![[1, 2, 3]], [scenes::Wrap::Clamp; 2]);
    let mut materials = materials();
    materials[0].texture = texture.map(Arc::new);
    for rows in [2, 5, 40] {
        let mut mesh = ball(rows);
        let plain = MeshBlocks::new(&mesh, &MeshObjects::default(), &materials).unwrap();
        assert!(!plain.is_coloured());
        let colours = mesh.positions.iter();
        let colours = colours.map(|position| position.map(|axis| axis.abs().min(1.0)));
        mesh.colours = colours.collect();
        let blocks = MeshBlocks::new(&mesh, &MeshObjects::default(), &materials).unwrap();
        assert!(blocks.is_coloured());
        check(&mesh, &materials, &blocks);
        assert!(blocks.count() > plain.count() || rows == 2);
        let places = mesh.positions.iter().map(|[x, y, _]| [*x, *y]);
        mesh.texture_coordinates = places.collect();
        check(
            &mesh,
            &materials,
            &MeshBlocks::new(&mesh, &MeshObjects::default(), &materials).unwrap(),
        );
    }
}

#[test]
fn visibility_is_stored_with_triangles() {
    let materials = materials();
    for rows in [2, 5, 40] {
        let mut mesh = ball(rows);
        mesh.visibility = (0..mesh.triangles.len())
            .map(|it| scenes::Visibility { lit: (it * 40_503) as u16, dark: it as u16 })
            .collect();
        let plain = MeshBlocks::new(&mesh, &MeshObjects::default(), &materials).unwrap();
        assert!(!plain.has_visibility(), "there are no colours");
        mesh.colours = vec![[0.5; 3]; mesh.positions.len()];
        let blocks = MeshBlocks::new(&mesh, &MeshObjects::default(), &materials).unwrap();
        assert!(blocks.has_visibility());
        check(&mesh, &materials, &blocks);
    }
}

#[test]
fn blocks_are_full() {
    let blocks = checked(&ball(100));
    let statistics = blocks.statistics();
    // At the poles a triangle of each square has no area, as far as rounding leaves none.
    assert_eq!(statistics.triangles + statistics.left_out, 40_000);
    assert!(statistics.left_out >= 200, "{statistics:?}");
    let bytes = statistics.bytes_a_triangle();
    assert!(bytes < 29.0, "{bytes} {statistics:?}");
    assert!(statistics.inner * 16 < statistics.leaves, "{statistics:?}");
    assert!(statistics.expected_triangles < 40.0, "{statistics:?}");
}

#[test]
fn same_mesh_gives_same_bytes() {
    let mesh = ball(30);
    assert_eq!(checked(&mesh).bytes(), checked(&mesh).bytes());
}
