//! Meshes that SPUs refit: the same blocks as the PPU makes, by any number of SPUs, and pictures
//! like those of new scenes.

use std::env;

use cellray::game::{DVec3, Mesh, RenderOptions};
use cellray::scene::RefitBy;

use super::kind;
use super::meshes::pear;
use crate::prelude::*;

pub fn engine(spus: u32) -> Engine {
    let framebuffer = Memory::new(cellray::framebuffer::Geometry::new(64, 48).unwrap()).unwrap();
    Engine::start(Settings { spus, ..Settings::default() }, Box::new(framebuffer)).unwrap()
}

pub fn picture(engine: &mut Engine, scene: &Scene) -> RgbImage {
    engine.render(scene, &mut |_| ()).unwrap();
    engine.picture().unwrap()
}

/// A world whose meshes are refitted by the PPU or by SPUs.
fn world(by: RefitBy) -> World {
    let mut world = World::new();
    world.set_background([0.3, 0.4, 0.6]).unwrap();
    world.look_from([1.0, 2.5, 7.0], DVec3::ZERO).unwrap();
    world.add_light(Light::at(DVec3::new(4.0, 6.0, 3.0))).unwrap();
    let refit_by = Some(by);
    world.set_render_options(RenderOptions {
        refit_by,
        refit_pictures: u32::MAX,
        ..RenderOptions::default()
    });
    world
}

/// Moves the vertices of a mesh as in picture `number`, but not in picture 0.
pub fn bend(mesh: &Mesh, number: u32) -> Mesh {
    let mut bent = mesh.clone();
    for [x, y, z] in &mut bent.positions {
        let by = 0.1 * number as f32 * (*y + *z * *z);
        *x += by;
        *z -= by * by;
    }
    for (normal, [x, _, z]) in bent.normals.iter_mut().zip(&bent.positions) {
        if *normal != [0.0; 3] {
            normal[1] += 0.2 * number as f32 * (x - z);
        }
    }
    bent
}

/// A mesh with smooth and with flat triangles, in blocks of both kinds.
pub fn mixed(size: u32) -> Mesh {
    let mut mesh = pear(size, size);
    let half = mesh.positions.len() / 2;
    mesh.normals[..half].fill([0.0; 3]);
    mesh
}

#[test]
fn blocks_are_those_of_the_ppu() {
    let program = Program::tracer();
    let mut engines: Vec<Engine> = (1..=6).map(engine).collect();
    for mesh in [pear(24, 24), mixed(60), pear(90, 100)] {
        let mut worlds = [RefitBy::Ppu, RefitBy::Spus].map(world);
        let ids = worlds.each_mut().map(|world| {
            let red = world.add_material(Material::matte(0.9, 0.2, 0.1)).unwrap();
            let id = world.add_mesh(Arc::new(mesh.clone()), &[red], DAffine3::IDENTITY).unwrap();
            world.scene(&program).unwrap();
            id
        });
        let mut last = Vec::new();
        for number in 1..=3 {
            let bent = bend(&mesh, number);
            for (world, id) in worlds.iter_mut().zip(ids) {
                world.shape_mesh(id, &bent.positions, &bent.normals).unwrap();
            }
            let [ppu, spus] = worlds.each_mut().map(|world| world.scene(&program).unwrap());
            let expected = ppu.block().unwrap().mesh().unwrap().blocks.bytes();
            assert!(expected != last, "{number}");
            last = expected.to_vec();
            let shown = picture(&mut engines[0], ppu);
            assert!(engines[0].made_blocks().is_none());
            for engine in &mut engines {
                assert!(picture(engine, spus) == shown);
                assert!(engine.made_blocks().unwrap() == expected);
            }
            let ppu = ppu.block().unwrap().mesh().unwrap().blocks.wear();
            let spus = spus.block().unwrap().wear().unwrap();
            assert!((ppu / spus - 1.0).abs() < 1e-5, "{ppu} {spus}");
            let fresh = Scene::new(&worlds[1].to_nff(), RenderOptions::default(), &program);
            assert!(picture(&mut engines[2], &fresh.unwrap()) == shown);
        }
    }
}

/// The same tests with transfers that are carried out as late as the SPUs allow.
#[test]
fn late_transfers_make_the_same_blocks() {
    let tests = ["game::refit::blocks_are_those_of_the_ppu", "frames::build::blocks_are_the_same"];
    let outcome = Command::new(env::current_exe().unwrap())
        .args(tests)
        .env("LIBSPE2_MFC", "at-last")
        .env_remove("LIBSPE2_TIMING")
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&outcome.stdout);
    assert!(outcome.status.success() && text.contains("2 passed"), "{text}");
}

/// All triangles in one point have no area; nor has one of them alone. A tree that was built
/// without them is built anew.
#[test]
fn triangles_without_an_area() {
    let program = Program::tracer();
    let (mut world, mesh) = (world(RefitBy::Spus), pear(30, 30));
    let red = world.add_material(Material::matte(0.9, 0.2, 0.1)).unwrap();
    let id = world.add_mesh(Arc::new(mesh.clone()), &[red], DAffine3::IDENTITY).unwrap();
    let mut engine = engine(3);
    let whole = picture(&mut engine, world.scene(&program).unwrap());
    let points = vec![[0.5; 3]; mesh.positions.len()];
    world.shape_mesh(id, &points, &mesh.normals).unwrap();
    let nothing = picture(&mut engine, world.scene(&program).unwrap());
    assert!(engine.made_blocks().is_some());
    let background = nothing.pixels().next().unwrap();
    assert!(nothing.pixels().all(|pixel| pixel == background));
    let mut one = points;
    for vertex in mesh.triangles[900] {
        one[vertex as usize] = mesh.positions[vertex as usize];
    }
    world.shape_mesh(id, &one, &mesh.normals).unwrap();
    assert!(picture(&mut engine, world.scene(&program).unwrap()) != nothing);
    world.shape_mesh(id, &mesh.positions, &mesh.normals).unwrap();
    assert!(picture(&mut engine, world.scene(&program).unwrap()) == whole);
}

#[test]
fn wrong_vertices_are_refused() {
    let (mut world, mesh) = (world(RefitBy::Spus), pear(30, 30));
    let red = world.add_material(Material::matte(0.9, 0.2, 0.1)).unwrap();
    let id = world.add_mesh(Arc::new(mesh.clone()), &[red], DAffine3::IDENTITY).unwrap();
    let sum = world.checksum();
    for wrong in [f32::NAN, f32::INFINITY, -1e30] {
        let mut positions = mesh.positions.clone();
        positions[17][1] = wrong;
        let refused = world.shape_mesh(id, &positions, &mesh.normals);
        assert!(refused.unwrap_err().to_string().contains("positions of vertex 17"));
        let refused = world.shape_mesh(id, &mesh.positions, &positions);
        assert!(refused.unwrap_err().to_string().contains("normals of vertex 17"));
    }
    let refused = world.shape_mesh(id, &mesh.positions[1..], &mesh.normals).unwrap_err();
    assert!(refused.to_string().contains("it has 930 positions, not 929"), "{refused}");
    let refused = world.shape_mesh(id, &mesh.positions, &[]).unwrap_err();
    assert!(refused.to_string().contains("it has 930 normals, not 0"), "{refused}");
    assert_eq!(world.checksum(), sum);
    // Coordinates as large as they may be.
    let huge: Vec<_> =
        mesh.positions.iter().map(|it| it.map(|axis| axis * 2_f32.powi(60))).collect();
    world.shape_mesh(id, &huge, &mesh.normals).unwrap();
    picture(&mut engine(2), world.scene(&Program::tracer()).unwrap());
    world.remove_mesh(id).unwrap();
    let refused = world.shape_mesh(id, &mesh.positions, &mesh.normals);
    assert!(matches!(kind(&refused), Some(WorldErrorKind::NoMesh)));
}
