//! The ground of a world.

use cellray::game::{DVec3, HeightField, HeightRegion, HeightSample};

use super::kind;
use super::refit::{engine, picture};
use crate::prelude::*;

fn slope(unit: f64) -> HeightField {
    let heights = (0..64 * 64).map(|sample| sample % 64 * 100).collect();
    HeightField::new([64, 64], heights, Vec::new(), 1.0, unit).unwrap()
}

#[test]
fn invalid_ground_is_refused() {
    let mut world = World::new();
    let white = world.add_material(Material::matte(1.0, 1.0, 1.0)).unwrap();
    let gone = world.add_material(Material::matte(1.0, 1.0, 1.0)).unwrap();
    world.remove_material(gone).unwrap();
    let before = world.checksum();
    let refused = world.add_terrain(Arc::new(slope(0.01)), gone);
    assert!(matches!(kind(&refused), Some(WorldErrorKind::NoMaterial)));
    for (unit, x) in [(1e30, 0.0), (0.01, 1e30), (0.01, f64::NAN)] {
        let mut far = slope(unit);
        far.corner.x += x;
        let refused = world.add_terrain(Arc::new(far), white);
        assert!(matches!(kind(&refused), Some(WorldErrorKind::OutOfRange { .. })), "{unit} {x}");
    }
    assert_eq!(world.checksum(), before);
    world.add_terrain(Arc::new(slope(0.01)), white).unwrap();
    let second = world.add_terrain(Arc::new(slope(0.01)), white);
    assert!(matches!(kind(&second), Some(WorldErrorKind::SecondTerrain)));
    let used = world.remove_material(white);
    assert!(matches!(kind(&used), Some(WorldErrorKind::MaterialInUse { .. })), "{used:?}");
}

/// A world that is made of a scene has its ground, at the same place and of the same material.
#[test]
fn scene_keeps_its_ground() {
    let mut field = slope(0.01);
    field.corner += DVec3::new(3.0, -2.0, 1.0);
    let mut world = World::new();
    let materials = [0.5, 1.0].map(|it| Material::matte(it, it, it));
    let [_, white] = materials.map(|it| world.add_material(it).unwrap());
    world.add_terrain(Arc::new(field.clone()), white).unwrap();
    let scene = world.to_nff();
    field.material = 1;
    assert_eq!(scene.heights.as_deref(), Some(&field));
    let options = world.render_options();
    assert_eq!(World::from_nff(&scene, options).unwrap().to_nff(), scene);
}

/// A world of ground with a colour for each sample, seen from above one of its edges.
fn ground() -> World {
    let mut world = World::new();
    world.set_background([0.3, 0.4, 0.6]).unwrap();
    world.look_from([10.0, 14.0, 40.0], DVec3::ZERO).unwrap();
    world.add_light(Light::sun(DVec3::new(4.0, 6.0, 3.0))).unwrap();
    let white = world.add_material(Material::matte(1.0, 1.0, 1.0)).unwrap();
    let heights = (0..64 * 64).map(|sample| 300 + ((sample % 64 * 7) ^ (sample / 64 * 5)) as u16);
    let colours = (0..64 * 64).map(|sample| [(sample % 64 * 4) as u8, (sample / 16) as u8, 90]);
    let field = HeightField::new([64, 64], heights.collect(), colours.collect(), 1.0, 0.01);
    world.add_terrain(Arc::new(field.unwrap()), white).unwrap();
    world
}

/// Raises or lowers a square of samples by as much as `by`, and makes it red.
fn brush(world: &mut World, [column, row]: [u32; 2], by: i16) {
    let region = HeightRegion { columns: column..column + 9, rows: row..row + 9 };
    let change = |_, sample: HeightSample| HeightSample {
        height: sample.height.saturating_add_signed(by),
        colour: [200, 40, 30],
    };
    world.shape_terrain(&region, change).unwrap();
}

#[test]
fn shaped_ground_is_seen_as_new_ground_is() {
    let program = Program::tracer();
    let mut world = ground();
    let mut engines = [engine(1), engine(4)];
    let mut last = picture(&mut engines[0], world.scene(&program).unwrap());
    let mut checksum = world.checksum();
    // The last ones make the ground lower and higher than it was, beyond its edges.
    let brushes =
        [([30, 40], 120), ([33, 44], -90), ([0, 0], 60), ([50, 60], -3000), ([60, 2], 9000)];
    for (number, (at, by)) in brushes.into_iter().enumerate() {
        brush(&mut world, at, by);
        brush(&mut world, [20, 50], 3);
        if number % 2 == 1 {
            world.look_from([8.0, 15.0, 41.0 + number as f64], DVec3::ZERO).unwrap();
        }
        let options = world.render_options();
        let fresh = Scene::new(&world.to_nff(), options, &program).unwrap();
        let scene = world.scene(&program).unwrap();
        let [one, four] = engines.each_mut().map(|engine| picture(engine, scene));
        assert!(one == four, "{number}: four SPUs");
        assert!(one == picture(&mut engines[1], &fresh), "{number}: a new scene");
        assert!(one != last, "{number} changes nothing");
        assert_ne!(world.checksum(), checksum);
        checksum = world.checksum();
        last = one;
    }
}

/// From the third change on, there are as many versions of the samples as pictures may need.
#[test]
fn brush_at_work_allocates_no_memory() {
    let program = Program::tracer();
    let mut world = ground();
    let mut engine = engine(1);
    for number in 0..20 {
        let asked = allocations::during(|| {
            brush(&mut world, [20 + number % 3, 30], if number % 2 == 0 { 5 } else { -5 });
            world.scene(&program).unwrap();
        });
        assert!(number < 3 || asked.is_empty(), "{number}: {}", asked[0]);
        engine.render(world.scene(&program).unwrap(), &mut |_| ()).unwrap();
    }
}

#[test]
fn shapes_without_ground_or_beyond_it_change_no_sample() {
    let region = HeightRegion { columns: 0..9, rows: 0..9 };
    let refused = World::new().shape_terrain(&region, |_, sample| sample);
    assert!(matches!(kind(&refused), Some(WorldErrorKind::NoTerrain)));
    let mut world = ground();
    let before = world.checksum();
    brush(&mut world, [64, 0], 9);
    brush(&mut world, [0, u32::MAX - 9], 9);
    assert_eq!(world.checksum(), before);
}
