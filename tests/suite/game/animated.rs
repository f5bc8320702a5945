//! The animation of a glTF file in a world: each picture is that of a new scene, by any number of
//! SPUs.

use cellray::game::RenderOptions;

use super::refit::{engine, picture};
use crate::prelude::*;

/// The file's scene, and its animation.
fn reef() -> meshes::Loaded {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/reef.glb");
    meshes::load(&file).unwrap()
}

#[test]
fn pictures_of_an_animation_are_those_of_new_scenes_by_any_number_of_spus() {
    let mut loaded = reef();
    let animation = loaded.animation.as_mut().unwrap();
    assert_eq!((animation.name(), animation.duration()), ("swell", 4.0));
    let options = RenderOptions::default();
    let mut world = World::from_nff(&loaded.scene, options).unwrap();
    let mesh = world.meshes().next().unwrap();
    let mut engines = [1, 2, 3, 4, 5, 6].map(engine);
    let mut pictures = Vec::new();
    for time in [0.0, 0.7, 1.9, 3.3, 4.0] {
        let (positions, normals) = animation.at(time);
        let still = Arc::make_mut(loaded.scene.mesh.as_mut().unwrap());
        still.positions.copy_from_slice(positions);
        still.normals.copy_from_slice(normals);
        world.shape_mesh(mesh, positions, normals).unwrap();
        let moved = world.scene(&Program::tracer()).unwrap();
        let found = engines.each_mut().map(|engine| picture(engine, moved));
        let still = Scene::new(&loaded.scene, options, &Program::tracer()).unwrap();
        let expected = picture(&mut engine(6), &still);
        assert!(found.iter().all(|found| *found == expected), "{time}");
        pictures.push(expected);
    }
    assert!(pictures[0] == pictures[4], "the animation is repeated");
    assert!((0..4).all(|it| pictures[it] != pictures[it + 1]));
}

/// The tree keeps its form, too: a new one would take memory.
#[test]
fn frames_of_an_animation_allocate_no_memory() {
    let mut loaded = reef();
    let animation = loaded.animation.as_mut().unwrap();
    let options = RenderOptions { refit_pictures: u32::MAX, ..RenderOptions::default() };
    let mut world = World::from_nff(&loaded.scene, options).unwrap();
    let mesh = world.meshes().next().unwrap();
    let mut engine = engine(2);
    for frame in 0..20 {
        let asked = allocations::during(|| {
            let (positions, normals) = animation.at(f64::from(frame) / 5.0);
            world.shape_mesh(mesh, positions, normals).unwrap();
            engine.render(world.scene(&Program::tracer()).unwrap(), &mut |_| ()).unwrap();
        });
        assert!(frame < 3 || asked.is_empty(), "frame {frame}: {}", asked[0]);
    }
}
