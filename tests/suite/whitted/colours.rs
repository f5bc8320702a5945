//! Colours at the vertices of meshes, compared with the reference.

use oracle::whitted::trace;
use scenes::{Mesh, Texture, Wrap};

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED, options, picture};

const SIZE: (u32, u32) = (160, 120);
const SRGB: RenderOptions = RenderOptions { colour: Colour::Srgb, ..WHITTED };

/// A ball on a mirror, without a mesh.
fn scene() -> scenes::Scene {
    let text = "v\nfrom 0.5 2.5 6\nat 0 -0.1 0\nup 0 1 0\nangle 45\nhither 0\nresolution 8 8\n\
        b 0.3 0.4 0.6\nl 4 6 3 0.9 0.9 0.9\n#cellray ambient 0.3 0.3 0.3\n\
        f 1 0.9 0.8 1 0 0 0 1\nf 0.9 0.5 0.5 0.4 0.5 30 0 1\n\
        s 0.8 0.3 1 0.5\n";
    scenes::parse(text.as_bytes(), "colours", &scenes::Limits::default()).unwrap()
}

/// A bumpy sheet of 2 `side`^2 smooth triangles, whose vertices have colours at random.
fn sheet(side: u32) -> Mesh {
    let mut random = ChaCha8Rng::seed_from_u64(11);
    let mut mesh = Mesh { two_sided: true, ..Mesh::default() };
    for (row, column) in (0..=side).flat_map(|row| (0..=side).map(move |column| (row, column))) {
        let place = [row, column].map(|it| it as f32 / side as f32);
        let bump = 0.4 * libm::sinf(9.0 * place[0]) * libm::cosf(7.0 * place[1]);
        mesh.positions.push([6.0 * place[1] - 3.0, bump - 0.8, 6.0 * place[0] - 3.5]);
        mesh.normals.push([bump, 1.0, -bump]);
        mesh.colours.push(random.random());
    }
    for (row, column) in (0..side).flat_map(|row| (0..side).map(move |column| (row, column))) {
        let at = |row: u32, column: u32| row * (side + 1) + column;
        let (a, b) = (at(row, column), at(row, column + 1));
        let (c, d) = (at(row + 1, column), at(row + 1, column + 1));
        mesh.triangles.extend([[a, c, d], [a, d, b]]);
        mesh.materials.extend([u32::from(row % 7 == 0); 2]);
    }
    mesh
}

fn textured(mesh: &mut Mesh) -> Option<Arc<Texture>> {
    let places = mesh.positions.iter().map(|[x, _, z]| [0.4 * x, 0.3 * z]);
    mesh.texture_coordinates = places.collect();
    let texel = |at: u32| [at * 7, at * 3, 255 - at].map(|it| it as u8);
    let texels = (0..24 * 10).map(texel).collect();
    Texture::new(24, texels, [Wrap::Repeat; 2]).map(Arc::new)
}

/// Compares a mesh's picture with the reference, and returns it.
fn checked(scene: &scenes::Scene, render_options: RenderOptions, what: &str) -> image::RgbImage {
    let found = Frame::of(scene, render_options, SIZE, Settings::default()).picture;
    let (reference, _) = trace(scene, SIZE.0, SIZE.1, &options(render_options)).unwrap();
    let off = oracle::compare(&picture(&found), &reference).unwrap();
    println!("{what}: {off:?}");
    assert!(off.max_error_off_silhouette <= 1, "{what}: {off:?}");
    assert!(off.wrong_fraction < 0.004, "{what}: {off:?}");
    // Without the colours it is another picture.
    let mut plain = scene.clone();
    let mut mesh = Mesh::clone(plain.mesh.as_deref().unwrap());
    mesh.colours.clear();
    plain.mesh = Some(Arc::new(mesh));
    let (bare, _) = trace(&plain, SIZE.0, SIZE.1, &options(render_options)).unwrap();
    let off = oracle::compare(&picture(&found), &bare).unwrap();
    assert!(off.wrong_fraction > 0.1, "{what}: {off:?}");
    found
}

#[test]
fn single_triangle() {
    let mut scene = scene();
    scene.mesh = Some(Arc::new(Mesh {
        positions: vec![[-2.5, -1.0, 0.0], [2.5, -1.0, 0.5], [0.0, 2.0, -1.0]],
        colours: vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.1, 0.2, 1.0]],
        triangles: vec![[0, 1, 2]],
        materials: vec![0],
        ..Mesh::default()
    }));
    checked(&scene, WHITTED, "linear");
    checked(&scene, SRGB, "sRGB");
}

#[test]
fn thousands_of_triangles() {
    for side in [12, 50] {
        let mut scene = scene();
        scene.mesh = Some(Arc::new(sheet(side)));
        checked(&scene, WHITTED, "linear");
        checked(&scene, SRGB, "sRGB");
        let mut flat = sheet(side);
        flat.normals.clear();
        scene.mesh = Some(Arc::new(flat));
        checked(&scene, SRGB, "flat triangles");
    }
}

#[test]
fn colours_and_textures_are_both_multiplied() {
    let mut scene = scene();
    let mut mesh = sheet(40);
    scene.materials[0].texture = textured(&mut mesh);
    scene.mesh = Some(Arc::new(mesh));
    checked(&scene, WHITTED, "linear");
    let both = checked(&scene, SRGB, "sRGB");
    scene.materials[0].texture = None;
    assert!(checked(&scene, SRGB, "without its texture") != both);
}

/// What a flat material shows is texel times colour times the colours of the vertices.
#[test]
fn flat_materials_show_textures_and_colours() {
    let mut scene = scene();
    let mut mesh = sheet(30);
    scene.materials[0].shader = Shader::Flat;
    scene.materials[0].emission = [0.05, 0.0, 0.1].into();
    scene.materials[0].texture = textured(&mut mesh);
    scene.mesh = Some(Arc::new(mesh.clone()));
    checked(&scene, WHITTED, "both");
    checked(&scene, SRGB, "both, sRGB");
    let texture = scene.materials[0].texture.take();
    checked(&scene, SRGB, "colours");
    scene.materials[0].texture = texture;
    mesh.colours.clear();
    scene.mesh = Some(Arc::new(mesh));
    let found = Frame::of(&scene, SRGB, SIZE, Settings::default()).picture;
    let (reference, _) = trace(&scene, SIZE.0, SIZE.1, &options(SRGB)).unwrap();
    let off = oracle::compare(&picture(&found), &reference).unwrap();
    assert!(off.max_error_off_silhouette <= 1, "texture: {off:?}");
    assert!(off.wrong_fraction < 0.004, "texture: {off:?}");
}

/// With materials in main memory, too.
#[test]
fn colours_and_many_materials() {
    let mut scene = scene();
    let mut mesh = sheet(20);
    let texture = textured(&mut mesh);
    let plain = scene.materials[0].clone();
    mesh.materials = (0..800).collect();
    let material = |number: u32| scenes::Material {
        colour: [f64::from(number) / 800.0, 0.7, 1.0].into(),
        texture: texture.clone().filter(|_| number.is_multiple_of(3)),
        ..plain.clone()
    };
    scene.materials = (0..800).map(material).collect();
    scene.mesh = Some(Arc::new(mesh));
    checked(&scene, SRGB, "many materials");
}

/// White leaves every byte as it is.
#[test]
fn white_colours_change_nothing() {
    let mut scene = scene();
    let mut mesh = sheet(40);
    mesh.colours.fill([1.0; 3]);
    scene.mesh = Some(Arc::new(mesh.clone()));
    let white = Frame::of(&scene, SRGB, SIZE, Settings::default()).picture;
    mesh.colours.clear();
    scene.mesh = Some(Arc::new(mesh));
    let plain = Frame::of(&scene, SRGB, SIZE, Settings::default()).picture;
    assert!(white == plain);
}
