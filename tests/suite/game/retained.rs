//! Which tiles are retained when little changes.

use crate::prelude::*;
use cellray::game::{DVec3, DepthShading};
use cellray::statistics::Causes;

/// A moving ball over one end of a ground and a still one over the other, seen from above.
fn balls(ground: Material, lights: &[Light]) -> Result<(World, ObjectId), WorldError> {
    let mut world = World::new();
    world.set_default_light(false);
    world.look_from(DVec3::new(0.0, 20.0, 0.1), DVec3::ZERO)?;
    for light in lights {
        world.add_light(*light)?;
    }
    let ground = world.add_material(ground)?;
    let corners = [(-20.0, 20.0), (20.0, 20.0), (20.0, -20.0), (-20.0, -20.0)];
    let corners = corners.map(|(x, z)| DVec3::new(x, 0.0, z));
    let floor = world.add_polygon(&corners, ground)?;
    world.fix(floor)?;
    let red = world.add_material(Material::matte(0.9, 0.1, 0.1))?;
    let ball = world.add_sphere(DVec3::new(-8.0, 1.0, 0.0), 0.5, red)?;
    world.add_sphere(DVec3::new(8.0, 1.0, 0.0), 0.5, red)?;
    Ok((world, ball))
}

/// How many of the 10 x 8 tiles are traced after the ball has moved a little, and how many after
/// no change. The ball has moved before, since the SPUs keep no paths of rays until then.
fn traced(world: &mut World, ball: ObjectId) -> [u64; 2] {
    let (framebuffer, _) = Recorder::pair(640, 128);
    let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
    let program = Program::tracer();
    let mut trace = |world: &mut World, cause: fn(&Causes) -> u64| {
        let scene = world.scene(&program).unwrap();
        let statistics = engine.render(scene, &mut |_| ()).unwrap();
        let traced = 80 - statistics.tiles_retained;
        assert_eq!(cause(&statistics.causes), traced, "{:?}", statistics.causes);
        traced
    };
    assert_eq!(trace(world, |causes| causes.unknown), 80);
    let place = world.position(ball).unwrap();
    world.move_to(ball, place + DVec3::new(0.1, 0.0, 0.0)).unwrap();
    trace(world, |causes| causes.unrecorded + causes.reached + causes.view);
    world.move_to(ball, place + DVec3::new(0.1, 0.0, 0.1)).unwrap();
    [trace(world, |causes| causes.reached + causes.view), trace(world, |_| 0)]
}

#[test]
fn moving_ball_changes_few_tiles() {
    let above = Light::at(DVec3::new(-8.0, 30.0, 5.0));
    let sun = Light::sun(DVec3::new(0.2, 1.0, 0.3));
    let ground = Material::matte(0.5, 0.6, 0.5);
    let (mut world, ball) = balls(ground, &[above, sun]).unwrap();
    let [moved, still] = traced(&mut world, ball);
    assert!((1..=12).contains(&moved), "{moved}");
    assert_eq!(still, 0);
}

/// Tiles along a long shadow are traced, and few others.
#[test]
fn low_sun_changes_tiles_of_long_shadow() {
    let low = Light::sun(DVec3::new(-1.0, 0.12, 0.0));
    let ground = Material::matte(0.5, 0.6, 0.5);
    let (mut world, ball) = balls(ground, &[low]).unwrap();
    let [moved, _] = traced(&mut world, ball);
    assert!((4..=40).contains(&moved), "{moved}");
}

/// The tiles are traced in which a mirror shows the ball, and few others.
#[test]
fn changed_mirror_image_is_traced_again() {
    let above = Light::at(DVec3::new(-8.0, 30.0, 5.0));
    let (mut world, ball) = balls(Material::mirror(), &[above]).unwrap();
    let [moved, still] = traced(&mut world, ball);
    assert!((1..=12).contains(&moved), "{moved}");
    assert_eq!(still, 0);

    let (mut world, ball) = balls(Material::matte(0.5, 0.6, 0.5), &[above]).unwrap();
    let [without, _] = traced(&mut world, ball);
    let silver = world.add_material(Material::mirror()).unwrap();
    let corners = [(0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (0.0, 0.0)];
    let corners = corners.map(|(x, z)| DVec3::new(3.0 + x, 0.1, 1.0 + z));
    world.add_polygon(&corners, silver).unwrap();
    let [with, still] = traced(&mut world, ball);
    assert!((without + 1..=without + 6).contains(&with), "{with}, {without} without");
    assert_eq!(still, 0);
}

/// With depth shading, only the ball's tiles are traced. But if the ball's distance sets the
/// range, all are.
#[test]
fn depth_shading_requires_fixed_range() {
    let (mut world, ball) = balls(Material::matte(0.5, 0.6, 0.5), &[]).unwrap();
    world.set_fade(Some(DepthShading { near: 5.0, far: 40.0 })).unwrap();
    let [moved, still] = traced(&mut world, ball);
    assert!((1..=6).contains(&moved), "{moved}");
    assert_eq!(still, 0);
    world.set_fade(None).unwrap();
    world.move_to(ball, DVec3::new(-9.0, 1.0, 0.0)).unwrap();
    assert_eq!(traced(&mut world, ball), [80, 0]);
}
