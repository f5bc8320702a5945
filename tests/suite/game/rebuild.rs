//! Meshes that SPUs build: the same blocks as the PPU makes in the order of codes, by any number of
//! SPUs, and the pictures of trees that are built with the surface area heuristic.

use std::env;

use cellray::game::{DVec3, Mesh, RenderOptions};
use cellray::scene::{BuildBy, SceneBlock};

use super::meshes::pear;
use super::refit::{bend, engine, mixed, picture};
use crate::prelude::*;

/// A world with this mesh, whose tree is made in this way.
fn world(mesh: &Mesh, build_by: BuildBy) -> World {
    let mut world = World::new();
    world.set_background([0.3, 0.4, 0.6]).unwrap();
    world.look_from([1.0, 2.5, 7.0], DVec3::ZERO).unwrap();
    world.add_light(Light::at(DVec3::new(4.0, 6.0, 3.0))).unwrap();
    world
        .set_render_options(RenderOptions { build_by: Some(build_by), ..RenderOptions::default() });
    let red = world.add_material(Material::matte(0.9, 0.2, 0.1)).unwrap();
    let green = world.add_material(Material::matte(0.1, 0.7, 0.2)).unwrap();
    world.add_mesh(Arc::new(mesh.clone()), &[red, green], DAffine3::IDENTITY).unwrap();
    world
}

/// Triangles in no order, which share nothing.
fn soup(count: u32) -> Mesh {
    let mut random = ChaCha8Rng::seed_from_u64(40);
    let mut mesh = Mesh::default();
    for triangle in 0..count {
        let middle = [(); 3].map(|()| random.random_range(-2.0_f32..2.0));
        for _ in 0..3 {
            mesh.positions.push(middle.map(|axis| axis + random.random_range(-0.1..0.1)));
        }
        mesh.triangles.push([3 * triangle, 3 * triangle + 1, 3 * triangle + 2]);
        mesh.materials.push(triangle % 2);
    }
    mesh
}

pub(super) fn blocks(scene: &Scene) -> &[u8] {
    scene.block().and_then(SceneBlock::mesh).unwrap().blocks.bytes()
}

/// Whether all blocks that the PPU has made are among those of the SPUs.
pub(super) fn has_all(made: &[u8], expected: &[u8]) -> bool {
    let size = MESH_BLOCK as usize;
    let mut pairs = expected.chunks(size).zip(made.chunks(size));
    expected.len() == made.len()
        && pairs.all(|(expected, made)| expected[0] == 0 || expected == made)
}

#[test]
fn blocks_are_those_of_the_ppu() {
    let program = Program::tracer();
    let mut engines: Vec<Engine> = (1..=6).map(engine).collect();
    for mesh in [mixed(60), soup(3000), pear(90, 100)] {
        let ways = [BuildBy::PpuSurfaces, BuildBy::PpuCodes, BuildBy::SpuCodes];
        let mut worlds = ways.map(|by| world(&mesh, by));
        for number in 0..3 {
            let bent = bend(&mesh, number);
            for world in &mut worlds {
                let id = world.meshes().next().unwrap();
                world.shape_mesh(id, &bent.positions, &bent.normals).unwrap();
            }
            let [surfaces, ppu, spus] = worlds.each_mut().map(|it| it.scene(&program).unwrap());
            let shown = picture(&mut engines[0], surfaces);
            assert!(picture(&mut engines[0], ppu) == shown, "{number}");
            for engine in &mut engines {
                assert!(picture(engine, spus) == shown, "{number}");
                assert!(has_all(&engine.made_blocks().unwrap(), blocks(ppu)), "{number}");
            }
        }
    }
}

/// The same test with transfers that are carried out as late as the SPUs allow.
#[test]
fn late_transfers_make_the_same_blocks() {
    let outcome = Command::new(env::current_exe().unwrap())
        .args(["game::rebuild::blocks_are_those_of_the_ppu", "frames::sort::blocks_are_the_same"])
        .env("LIBSPE2_MFC", "at-last")
        .env_remove("LIBSPE2_TIMING")
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&outcome.stdout);
    assert!(outcome.status.success() && text.contains("2 passed"), "{text}");
}

/// The pictures of a mesh by all ways, which must be the same; `None` without blocks of SPUs.
fn shown(mesh: &Mesh) -> Option<image::RgbImage> {
    let program = Program::tracer();
    let mut engine = engine(3);
    let mut made = None;
    let pictures = [BuildBy::PpuSurfaces, BuildBy::PpuCodes, BuildBy::SpuCodes].map(|by| {
        let shown = picture(&mut engine, world(mesh, by).scene(&program).unwrap());
        made = engine.made_blocks();
        shown
    });
    let [surfaces, ppu, spus] = pictures;
    assert!(surfaces == ppu && ppu == spus);
    made.map(|_| spus)
}

/// Few triangles are in local store, where nothing is built.
#[test]
fn there_may_be_one_triangle() {
    assert!(shown(&soup(1)).is_none());
}

/// Texture coordinates need no space in blocks if there is no texture.
#[test]
fn texture_coordinates_may_be_unused() {
    let mut mesh = soup(600);
    let expected = shown(&mesh).unwrap();
    mesh.texture_coordinates = vec![[0.5; 2]; mesh.positions.len()];
    assert!(shown(&mesh).unwrap() == expected);
}

/// Copies of one triangle, in no order with triangles that have no area. The picture is that of the
/// one.
#[test]
fn all_codes_may_be_equal() {
    let mut one = soup(600);
    for triangle in one.positions.chunks_mut(3).skip(1) {
        triangle.fill([0.5; 3]);
    }
    let expected = shown(&one).unwrap();
    let mut all = one.clone();
    let corners = all.positions[..3].to_vec();
    all.positions.chunks_mut(3).step_by(2).for_each(|it| it.copy_from_slice(&corners));
    all.materials.fill(0);
    assert!(shown(&all).unwrap() == expected);
    // All with the same three vertices.
    all.triangles.fill([0, 1, 2]);
    assert!(shown(&all).unwrap() == expected);
}

#[test]
fn coordinates_may_be_huge_or_tiny() {
    for scale in [2_f32.powi(60), 2_f32.powi(-60), 2_f32.powi(-125)] {
        let mut mesh = soup(700);
        mesh.positions.iter_mut().flatten().for_each(|axis| *axis *= scale);
        let program = Program::tracer();
        let mut engine = engine(2);
        let mut worlds = [BuildBy::PpuCodes, BuildBy::SpuCodes].map(|by| world(&mesh, by));
        let [ppu, spus] = worlds.each_mut().map(|it| it.scene(&program).unwrap());
        picture(&mut engine, spus);
        assert!(has_all(&engine.made_blocks().unwrap(), blocks(ppu)), "{scale}");
    }
}

/// Without a choice, SPUs build the trees of a world whose triangles are others in each picture.
/// The last of these does not stay.
#[test]
fn a_world_that_needs_new_trees_has_them_built_by_the_spus() {
    let program = Program::tracer();
    let [mut engine, mut other] = [3, 2].map(engine);
    let mut one = world(&soup(600), BuildBy::PpuSurfaces);
    one.set_render_options(RenderOptions { refit_pictures: 2, ..RenderOptions::default() });
    let red = one.add_material(Material::matte(0.9, 0.2, 0.1)).unwrap();
    let mut by_spus = Vec::new();
    for number in 0..6 {
        let id = one.meshes().next().unwrap();
        one.remove_mesh(id).unwrap();
        let mesh = bend(&soup(600 + 50 * number), number);
        one.add_mesh(Arc::new(mesh), &[red, red], DAffine3::IDENTITY).unwrap();
        let shown = picture(&mut engine, one.scene(&program).unwrap());
        by_spus.push(engine.made_blocks().is_some());
        let fresh = Scene::new(&one.to_nff(), RenderOptions::default(), &program).unwrap();
        assert!(picture(&mut other, &fresh) == shown, "{number}");
    }
    assert_eq!(by_spus, [false, false, true, true, true, true]);
    let mut pictures = 0..100_u32;
    pictures.find(|&number| {
        one.look_from([1.0, 2.5, 7.0 + 0.01 * f64::from(number)], DVec3::ZERO).unwrap();
        picture(&mut engine, one.scene(&program).unwrap());
        engine.made_blocks().is_none()
    });
    assert_eq!(pictures.next(), Some(9));
}

/// More triangles than SPUs sort, of which few have an area.
#[test]
fn two_million_triangles_are_built_by_the_ppu() {
    let mut mesh = soup(900);
    mesh.triangles.resize(2_000_000, [0, 0, 0]);
    mesh.materials.resize(2_000_000, 0);
    let program = Program::tracer();
    let mut engine = engine(3);
    let mut many = world(&mesh, BuildBy::SpuCodes);
    let many = picture(&mut engine, many.scene(&program).unwrap());
    assert!(engine.made_blocks().is_none());
    assert!(many == shown(&soup(900)).unwrap());
}
