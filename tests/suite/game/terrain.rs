//! The ground of a world.

use std::sync::Arc;

use cellray::game::{DVec3, HeightField, Material, World, WorldErrorKind};

use super::kind;

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
