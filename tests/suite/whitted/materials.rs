//! Scenes with many materials, compared with the reference.

use std::fmt::Write as _;

use oracle::whitted::trace;

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED, options, picture};

const SIZE: (u32, u32) = (96, 72);
const VIEW: &str = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\n\
                    b 0.1 0.2 0.3\nl 5 5 9\n";

fn parsed(text: &str) -> scenes::Scene {
    scenes::parse(text.as_bytes(), "fills", &scenes::Limits::default()).unwrap()
}

/// Spheres, each after a fill: all different, or one of `kinds`.
fn spheres(count: u32, kinds: u32) -> scenes::Scene {
    let mut text = VIEW.to_owned();
    for number in 0..count {
        let kind = number % kinds;
        let [red, green, blue] = [7, 13, 29].map(|step| f64::from(kind * step % 101) / 100.0);
        let (across, down, back) = (number % 40, number / 40 % 30, number / 1200);
        let [x, y, z] = [across, down, back].map(f64::from);
        let (x, y) = (x * 0.2 - 4.0 + 0.03 * z, y * 0.2 - 3.0);
        writeln!(text, "f {red} {green} {blue} 0.8 0.2 {kind} 0 0").unwrap();
        writeln!(text, "s {x} {y} {} 0.09", -0.4 * z).unwrap();
    }
    parsed(&text)
}

/// As many triangles, each with a material of its own.
fn triangles(count: u32) -> scenes::Scene {
    let mut text = VIEW.to_owned();
    for number in 0..count {
        let [red, green, blue] = [7, 13, 29].map(|step| f64::from(number * step % 101) / 100.0);
        let (x, y) = (f64::from(number % 100), f64::from(number / 100));
        let (x, y, z) = (x * 0.06 - 3.0, y * 0.09 - 2.2, f64::from(number % 7) * 0.05);
        writeln!(text, "f {red} {green} {blue} 0.8 0.2 {number} 0 0").unwrap();
        writeln!(text, "p 3\n{x} {y} {z}\n{} {y} 0\n{x} {} {z}", x + 0.08, y + 0.11).unwrap();
    }
    parsed(&text)
}

fn blocks_used(frame: &Frame) -> u64 {
    let spus = frame.statistics.spus.iter();
    spus.map(|spu| spu.blocks.used).sum()
}

fn checked(scene: &scenes::Scene) -> Frame {
    let found = Frame::of(scene, WHITTED, SIZE, Settings::default());
    assert!(blocks_used(&found) > 0);
    let (reference, _) = trace(scene, SIZE.0, SIZE.1, &options(WHITTED)).unwrap();
    let compared = oracle::compare(&picture(&found.picture), &reference).unwrap();
    assert!(compared.max_error_off_silhouette <= 1, "{compared:?}");
    assert!(compared.wrong_fraction < 0.01, "{compared:?}");
    // With the materials in any other order the picture is another one.
    let mut turned = scene.clone();
    turned.materials.rotate_left(1);
    let (other, _) = trace(&turned, SIZE.0, SIZE.1, &options(WHITTED)).unwrap();
    let compared = oracle::compare(&picture(&found.picture), &other).unwrap();
    assert!(compared.wrong_fraction > 0.2, "{compared:?}");
    found
}

#[test]
fn spheres_with_one_material_each() {
    checked(&spheres(1200, u32::MAX));
    checked(&spheres(4800, u32::MAX));
}

#[test]
fn triangles_with_one_material_each() {
    let plain = triangles(5000);
    checked(&plain);
    // The same with normals at the vertices, and a floor in local store.
    let mut scene = triangles(5000);
    for object in &mut scene.objects {
        let scenes::Shape::Polygon { vertices } = &object.shape else {
            continue;
        };
        let normals = vertices.iter().map(|it| it.with_z(4.0)).collect();
        let vertices = vertices.clone();
        object.shape = scenes::Shape::Patch { vertices, normals };
    }
    let floor = [[-9, -3, 9], [9, -3, 9], [9, -3, -9], [-9, -3, -9]];
    let vertices = floor.map(|corner| corner.map(f64::from).into()).to_vec();
    scene.objects.push(scenes::Object {
        line: 0,
        material: 77,
        shape: scenes::Shape::Polygon { vertices },
    });
    checked(&scene);
}

#[test]
fn repeated_fills_share_a_record() {
    let repeated = spheres(8281, 4);
    let found = checked(&repeated);
    let mut single = repeated.clone();
    single.materials.truncate(4);
    for object in &mut single.objects {
        object.material %= 4;
    }
    let single = Frame::of(&single, WHITTED, SIZE, Settings::default());
    assert!(found.picture == single.picture);
}

/// Objects in local store are drawn to the same bytes with one record for each fill or for each
/// object.
#[test]
fn repeated_fills_in_local_store() {
    let repeated = spheres(300, 5);
    let mut single = repeated.clone();
    single.materials.truncate(5);
    for object in &mut single.objects {
        object.material %= 5;
    }
    let [repeated, single] =
        [repeated, single].map(|scene| Frame::of(&scene, WHITTED, SIZE, Settings::default()));
    assert_eq!(blocks_used(&repeated), 0);
    assert!(repeated.picture == single.picture);
    // The records are as many, so all batches are.
    assert_eq!(repeated.rays(), single.rays());
}

/// The pictures with materials in main memory are those with materials in local store.
#[test]
fn picture_is_independent_of_material_memory() {
    let few = triangles(600);
    let mut few = scenes::Scene { materials: few.materials[..6].to_vec(), ..few };
    for object in &mut few.objects {
        object.material %= 6;
    }
    // 300 more materials, of which each has a triangle behind the eye.
    let mut many = few.clone();
    for number in 0..300_u32 {
        let material = scenes::Material {
            shine: f64::from(number),
            specular: 0.2,
            ..many.materials[0].clone()
        };
        many.materials.push(material);
        let y = f64::from(number);
        let vertices = [[0.0, y, 90.0], [1.0, y, 90.0], [0.0, y, 91.0]];
        many.objects.push(scenes::Object {
            line: 0,
            material: 6 + number,
            shape: scenes::Shape::Polygon { vertices: vertices.map(Into::into).to_vec() },
        });
    }
    let [few, many] =
        [few, many].map(|scene| Frame::of(&scene, WHITTED, SIZE, Settings::default()));
    assert!(few.picture == many.picture);
}

/// A floor of many materials, of which two in three have one of two textures.
#[test]
fn many_materials_with_textures() {
    let mut scene = parsed(&format!("{VIEW}f 1 1 1 0.8 0.2 9 0 0\n"));
    let texture = |width: u32, height: u32| {
        let texel = |number: u32| [number * 37, number * 11, !number].map(|it| it as u8);
        let texels = (0..width * height).map(texel).collect();
        scenes::Texture::new(width, texels, [scenes::Wrap::Repeat; 2]).map(Arc::new)
    };
    let textures = [texture(16, 16), texture(9, 30), None];
    let mut mesh = scenes::Mesh::default();
    for (row, column) in (0..=20_u16).flat_map(|row| (0..=20_u16).map(move |column| (row, column)))
    {
        let [x, y] = [column, row].map(|it| f32::from(it) * 0.25 - 2.5);
        mesh.positions.push([x, y, 0.1 * (x * y).abs()]);
        mesh.texture_coordinates.push([0.7 * x, 0.4 * y + 0.1 * x]);
    }
    let [plain] = &scene.materials[..] else {
        panic!("{} materials", scene.materials.len());
    };
    let plain = plain.clone();
    scene.materials.clear();
    for (row, column) in (0..20).flat_map(|row| (0..20).map(move |column| (row, column))) {
        let [a, b, c, d] = [0, 1, 21, 22].map(|corner| row * 21 + column + corner);
        for triangle in [[a, b, d], [a, d, c]] {
            let number = scene.materials.len() as u32;
            mesh.triangles.push(triangle);
            mesh.materials.push(number);
            scene.materials.push(scenes::Material {
                colour: DVec3::new(1.0, f64::from(number) / 800.0, 0.6),
                texture: textures[number as usize % 3].clone(),
                ..plain.clone()
            });
        }
    }
    scene.mesh = Some(Arc::new(mesh));
    checked(&scene);
}
