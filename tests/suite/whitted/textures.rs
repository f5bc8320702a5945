//! Textures of meshes, compared with the reference.

use oracle::whitted::trace;
use scenes::{Mesh, Texture, Wrap};

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED, compared, options, picture};

const SIZE: (u32, u32) = (200, 150);

/// A texture of soft blobs, with an edge that shows where it begins again.
fn texture(width: u32, height: u32, wrap: [Wrap; 2]) -> Arc<Texture> {
    let texel = |x: u32, y: u32| {
        let [u, v] = [x, y].map(|it| f64::from(it) * 0.3);
        let wave = |phase: f64| 127.0 + 120.0 * libm::sin(u + phase) * libm::sin(1.3 * v + phase);
        let edge = x == 0 || y == 0;
        [0.0, 1.0, 2.5].map(|phase| if edge { 255 } else { wave(phase) as u8 })
    };
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let texels = places.map(|(x, y)| texel(x, y)).collect();
    Arc::new(Texture::new(width, texels, wrap).unwrap())
}

/// A large floor and a wall that reflects it, each of two triangles.
fn scene(texture: Arc<Texture>) -> scenes::Scene {
    let text = "v\nfrom 0.5 1.5 6\nat 0 -0.1 0\nup 0 1 0\nangle 45\nhither 0\nresolution 8 8\n\
        b 0.3 0.4 0.6\nl 4 6 3 0.9 0.9 0.9\n#cellray ambient 0.3 0.3 0.3\n\
        f 1 0.9 0.8 1 0 0 0 1\nf 0.5 0.5 0.5 0.4 0.5 30 0 1\n\
        s 0.8 -0.3 1 0.5\n";
    let mut scene = scenes::parse(text.as_bytes(), "floor", &scenes::Limits::default()).unwrap();
    scene.materials[0].texture = Some(texture);
    scene.mesh = Some(Arc::new(Mesh {
        positions: vec![
            [-20.0, -1.0, 6.0],
            [20.0, -1.0, 6.0],
            [20.0, -1.0, -30.0],
            [-20.0, -1.0, -30.0],
            [-3.0, -1.0, -3.0],
            [2.0, -1.0, -4.0],
            [2.0, 3.0, -4.0],
            [-3.0, 3.0, -3.0],
        ],
        texture_coordinates: vec![
            [-6.0, 5.0],
            [6.5, 5.0],
            [6.5, -7.0],
            [-6.0, -7.0],
            [0.0, 0.0],
            [0.0, 0.0],
            [0.0, 0.0],
            [0.0, 0.0],
        ],
        triangles: vec![[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]],
        materials: vec![0, 0, 1, 1],
        ..Mesh::default()
    }));
    scene
}

/// The scene with a texture so dark that its light, in bytes, has only 11 values.
pub fn dark_scene() -> scenes::Scene {
    let texels = (0..64 * 64).map(|at| {
        let [x, y] = [at % 64, at / 64];
        [x, y, (x + y) / 2]
    });
    let texels = texels.map(|texel| texel.map(|byte| byte as u8)).collect();
    let texture = Texture::new(64, texels, [Wrap::Mirror; 2]).unwrap();
    scene(Arc::new(texture))
}

#[test]
fn texture_equals_reference() {
    for (width, height, wrap) in [
        (64, 64, [Wrap::Repeat, Wrap::Mirror]),
        (37, 90, [Wrap::Mirror, Wrap::Repeat]),
        (40, 20, [Wrap::Clamp, Wrap::Clamp]),
        (1, 1, [Wrap::Repeat, Wrap::Clamp]),
    ] {
        let scene = scene(texture(width, height, wrap));
        let found = Frame::of(&scene, WHITTED, SIZE, Settings::default());
        let (reference, _) = trace(&scene, SIZE.0, SIZE.1, &options(WHITTED)).unwrap();
        let off = oracle::compare(&picture(&found.picture), &reference).unwrap();
        println!("{width}x{height} {wrap:?}: {off:?}");
        assert!(off.wrong_fraction < 0.001, "{width}x{height} {wrap:?}: {off:?}");

        let spus = &found.statistics.spus;
        let used: u64 = spus.iter().map(|spu| spu.texture_tiles.used).sum();
        let fetched = spus.iter().map(|spu| spu.texture_tiles.fetched);
        let all: u64 = fetched.clone().sum();
        assert!(0 < all && all < used, "{all} of {used}");
        // A texture of one texel is white here, and has one tile.
        if width == 1 {
            assert!(fetched.clone().all(|count| count <= 1));
            continue;
        }
        let mut plain = scene.clone();
        plain.materials[0].texture = None;
        let (bare, _) = trace(&plain, SIZE.0, SIZE.1, &options(WHITTED)).unwrap();
        let off = oracle::compare(&picture(&found.picture), &bare).unwrap();
        assert!(off.wrong_fraction > 0.2, "{off:?}");
    }
}

/// Many small triangles with normals, and coordinates at random.
#[test]
fn triangles_of_several_blocks() {
    let mut random = ChaCha8Rng::seed_from_u64(9);
    let mut scene = scene(texture(64, 32, [Wrap::Repeat; 2]));
    let mut mesh = Mesh { two_sided: true, ..Mesh::default() };
    let side = 30;
    for (row, column) in (0..=side).flat_map(|row| (0..=side).map(move |column| (row, column))) {
        let place = [row, column].map(|it| it as f32 / side as f32);
        let bump = 0.4 * libm::sinf(9.0 * place[0]) * libm::cosf(7.0 * place[1]);
        mesh.positions.push([6.0 * place[1] - 3.0, bump - 0.8, 6.0 * place[0] - 3.5]);
        mesh.normals.push([bump, 1.0, -bump]);
        let shift = random.random_range(-0.01..0.01);
        mesh.texture_coordinates.push(place.map(|it| 3.0 * it + shift));
    }
    for (row, column) in (0..side).flat_map(|row| (0..side).map(move |column| (row, column))) {
        let at = |row: u32, column: u32| row * (side + 1) + column;
        let (a, b) = (at(row, column), at(row, column + 1));
        let (c, d) = (at(row + 1, column), at(row + 1, column + 1));
        mesh.triangles.extend([[a, c, d], [a, d, b]]);
        mesh.materials.extend([u32::from(row % 7 == 0); 2]);
    }
    scene.mesh = Some(Arc::new(mesh));
    let off = compared(&scene, WHITTED, SIZE);
    assert!(off.max_error_off_silhouette <= 2, "{off:?}");
    assert!(off.wrong_fraction < 0.003, "{off:?}");
}

#[test]
fn chess_scene_equals_reference() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/chess.glb");
    let scene = meshes::load(&path).unwrap().scene;
    let off = compared(&scene, WHITTED, SIZE);
    println!("{off:?}");
    assert!(off.wrong_fraction < 0.005, "{off:?}");
}
