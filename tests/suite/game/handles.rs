//! Handles, and the errors of a world.

use cellray::game::{DVec3, Fog, LightId, LightKind, Model, RenderOptions, Shader, Shape, View};
use protocol::layout::{MAX_LIGHTS, MAX_SPHERES};

use super::kind;
use crate::prelude::*;

/// The view takes seven lines.
const VIEW: &str = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 32 24\n";

/// Checks why something is refused.
macro_rules! assert_refused {
    ($result:expr, $kind:ident $detail:tt $(, $more:tt)?) => {
        assert!(matches!(kind(&$result), Some(WorldErrorKind::$kind $detail)) $(, $more)?)
    };
    ($result:expr, $kind:ident $(, $more:tt)?) => {
        assert!(matches!(kind(&$result), Some(WorldErrorKind::$kind)) $(, $more)?)
    };
}

fn red(world: &mut World) -> MaterialId {
    world.add_material(Material::matte(1.0, 0.0, 0.0)).unwrap()
}

#[test]
fn removed_handle_is_never_reused() {
    let mut world = World::new();
    let red = red(&mut world);
    let mut removed = Vec::new();
    for _ in 0..100 {
        let object = world.add_sphere(DVec3::ZERO, 1.0, red).unwrap();
        assert!(!removed.contains(&object));
        world.remove(object).unwrap();
        removed.push(object);
    }
    let kept = world.add_sphere(DVec3::ONE, 1.0, red).unwrap();
    for object in removed.into_iter().chain([ObjectId::default()]) {
        for refused in [
            world.move_to(object, DVec3::ONE),
            world.make_of(object, red),
            world.show(object, false),
            world.fix(object),
            world.free(object),
            world.remove(object),
            world.position(object).map(drop),
            world.shape(object).map(drop),
            world.material_of(object).map(drop),
            world.is_visible(object).map(drop),
        ] {
            assert_refused!(refused, NoObject);
        }
    }
    assert_eq!(world.object_count(), 1);
    assert_eq!(world.position(kept).unwrap(), DVec3::ONE);
    assert!(world.is_visible(kept).unwrap());
}

#[test]
fn material_in_use_is_kept() {
    let mut world = World::new();
    let (red, blue) = (red(&mut world), red(&mut world));
    let ball = world.add_sphere(DVec3::ZERO, 1.0, red).unwrap();
    let error = world.remove_material(red).unwrap_err();
    assert!(matches!(error.kind(), WorldErrorKind::MaterialInUse { users: 1 }));
    world.make_of(ball, blue).unwrap();
    world.make_of(ball, blue).unwrap();
    world.remove_material(red).unwrap();
    assert!(world.remove_material(blue).is_err());
    world.remove(ball).unwrap();
    world.remove_material(blue).unwrap();
    for gone in [red, blue, MaterialId::default()] {
        let shape = Shape::Sphere { centre: DVec3::ZERO, radius: 1.0 };
        for refused in [
            world.material(gone).map(drop),
            world.recolour(gone, DVec3::ONE),
            world.set_material(gone, Material::glass()),
            world.remove_material(gone),
            world.add(shape, gone).map(drop),
        ] {
            assert_refused!(refused, NoMaterial);
        }
    }
    assert_eq!(world.object_count(), 0);
}

#[test]
fn removed_light_is_refused() {
    let mut world = World::new();
    let light = world.add_light(Light::at(DVec3::ONE)).unwrap();
    assert_eq!(world.light(light).unwrap(), Light::at(DVec3::ONE));
    world.remove_light(light).unwrap();
    world.add_light(Light::at(DVec3::ZERO)).unwrap();
    for gone in [light, LightId::default()] {
        assert_refused!(world.light(gone), NoLight);
        let moved = world.set_light(gone, Light::at(DVec3::ZERO));
        assert_refused!(moved, NoLight);
        assert_refused!(world.remove_light(gone), NoLight);
    }
    assert_eq!(world.lights().count(), 1);
}

#[test]
fn fixed_object_is_kept_until_freed() {
    let mut world = World::new();
    let red = red(&mut world);
    let ball = world.add_sphere(DVec3::ZERO, 1.0, red).unwrap();
    world.fix(ball).unwrap();
    assert!(world.is_fixed(ball).unwrap());
    let shape = world.shape(ball).unwrap().clone();
    assert_refused!(world.move_to(ball, DVec3::ONE), Fixed);
    assert_refused!(world.reshape(ball, shape), Fixed);
    world.show(ball, false).unwrap();
    world.free(ball).unwrap();
    world.move_to(ball, DVec3::ONE).unwrap();
    assert_eq!(world.position(ball).unwrap(), DVec3::ONE);
}

#[test]
fn moved_object_keeps_its_shape() {
    let mut world = World::new();
    let red = red(&mut world);
    let cone =
        Shape::Cone { base: DVec3::ZERO, base_radius: 1.0, apex: DVec3::Y, apex_radius: 0.5 };
    let vertices = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
    let patch = Shape::Patch { vertices: vertices.clone(), normals: vec![DVec3::Z; 3] };
    for shape in [cone, Shape::Polygon { vertices }, patch] {
        let object = world.add(shape, red).unwrap();
        world.move_to(object, DVec3::splat(2.0)).unwrap();
        assert_eq!(world.position(object).unwrap(), DVec3::splat(2.0));
        match world.shape(object).unwrap() {
            Shape::Cone { apex, .. } => assert_eq!(*apex, DVec3::new(2.0, 3.0, 2.0)),
            Shape::Polygon { vertices } | Shape::Patch { vertices, .. } => {
                assert_eq!(vertices[1], DVec3::new(3.0, 2.0, 2.0));
            }
            Shape::Sphere { .. } => unreachable!("no sphere was added"),
        }
    }
}

#[test]
fn numbers_out_of_range_are_refused_and_change_nothing() {
    let mut world = World::new();
    let red = red(&mut world);
    let ball = world.add_sphere(DVec3::ZERO, 1.0, red).unwrap();
    let before = world.checksum();
    for bad in [f64::NAN, f64::INFINITY, 1e30, -1e30] {
        let place = DVec3::new(0.0, bad, 0.0);
        let glass = Material { refraction_index: bad, ..Material::glass() };
        let odd = Material { shader: Shader::Depth { far: bad, near: 0.0 }, ..Material::glass() };
        for refused in [
            world.move_to(ball, place),
            world.recolour(red, place),
            world.set_background(place),
            world.set_ambient(place),
            world.set_fog(Some(Fog { colour: place, density: 0.1 })),
            world.set_fog(Some(Fog { colour: DVec3::ONE, density: bad })),
            world.look_from(place, DVec3::ZERO),
            world.add_light(Light::at(place)).map(drop),
            world.add_light(Light::at(DVec3::ONE).coloured(bad, 0.0, 0.0)).map(drop),
            world.add_light(Light::at(DVec3::ONE).within(-bad.abs().min(1e9))).map(drop),
            world.add_sphere(place, 1.0, red).map(drop),
            world.add_sphere(DVec3::ZERO, bad, red).map(drop),
            world.set_material(red, glass),
            world.set_material(red, odd),
        ] {
            assert_refused!(refused, OutOfRange { .. }, "{bad}");
        }
    }
    let no_direction =
        Light { kind: LightKind::Directional { to_light: DVec3::ZERO }, colour: None };
    assert_refused!(world.add_light(no_direction), NoDirection);
    let flat = [DVec3::ZERO, DVec3::X];
    assert_refused!(world.add_polygon(&flat, red), NoSurface(_));
    assert_refused!(world.look_from(DVec3::ONE, DVec3::ONE), View(_));
    let view = View { angle: 180.0, ..world.view().clone() };
    assert_refused!(world.set_view(view), View(_));
    assert_refused!(world.add_sphere(DVec3::ZERO, 0.0, red), OutOfRange { .. });
    assert_eq!(world.checksum(), before);
}

#[test]
fn error_names_line_that_called() {
    let mut world = World::new();
    let line = line!() + 1;
    let error = world.fix(ObjectId::default()).unwrap_err();
    assert_eq!((error.place().file(), error.place().line()), (file!(), line));
    // Also where one method of the world calls another.
    let none = MaterialId::default();
    let line = line!() + 1;
    let error = world.add_sphere(DVec3::ZERO, 1.0, none).unwrap_err();
    assert_eq!((error.place().file(), error.place().line()), (file!(), line));
    assert!(format!("{error:?}").contains(file!()), "{error:?}");
    assert!(!error.to_string().contains(file!()), "{error}");
}

#[test]
fn box_and_plane_have_given_positions() {
    let mut world = World::new();
    let red = red(&mut world);
    let sides = world.add_box([2.0, 3.0, 1.0], [-2.0, 1.0, -1.0], red).unwrap();
    let ground = world.add_plane(DVec3::ZERO, DVec3::Y * 3.0, 20.0, red).unwrap();
    let tilted = world.add_plane([0.0, 0.0, -50.0], [1.0, 1.0, 1.0], 2.0, red).unwrap();
    assert_eq!(world.object_count(), 8);
    let met = |from: DVec3, towards: DVec3| {
        let pick = world.cast_ray(from, towards).unwrap();
        (pick.target.object().unwrap(), pick.point)
    };
    for (number, outwards) in
        [-DVec3::X, DVec3::X, -DVec3::Y, DVec3::Y, -DVec3::Z, DVec3::Z].into_iter().enumerate()
    {
        let middle = DVec3::new(0.0, 2.0, 0.0);
        let (side, point) = met(middle + outwards * 1.9 * DVec3::new(2.0, 0.7, 2.0), -outwards);
        assert_eq!(side, sides[number]);
        assert_eq!(point, middle + outwards * DVec3::new(2.0, 1.0, 1.0));
    }
    assert_eq!(met(DVec3::new(9.5, 5.0, -9.5), -DVec3::Y), (ground, DVec3::new(9.5, 0.0, -9.5)));
    assert_eq!(met(DVec3::new(0.0, 0.0, -40.0), DVec3::new(0.0, 0.0, -1.0)).0, tilted);
    assert_refused!(world.add_box(DVec3::ZERO, DVec3::new(1.0, 0.0, 1.0), red), NoSurface(_));
    assert_refused!(world.add_plane(DVec3::ZERO, DVec3::ZERO, 1.0, red), NoSurface(_));
}

/// A world that does not fit fails to render, and renders again once it fits.
#[test]
fn objects_over_capacity_are_refused_until_removed() {
    let program = Program::tracer();
    let mut world = World::new();
    // With Whitted's model, spheres would be streamed.
    world.set_render_options(RenderOptions { model: Model::Depth, ..RenderOptions::default() });
    let red = red(&mut world);
    let objects: Vec<_> = (0..=MAX_SPHERES)
        .map(|x| {
            let centre = DVec3::X * f64::from(x);
            world.add_sphere(centre, 0.5, red).unwrap()
        })
        .collect();
    for _ in 0..2 {
        let error = world.scene(&program).unwrap_err();
        assert!(matches!(error.kind(), WorldErrorKind::Scene(_)), "{error}");
    }
    for object in &objects[100..] {
        world.remove(*object).unwrap();
    }
    world.scene(&program).unwrap();
    world.move_to(objects[0], DVec3::ONE).unwrap();
    world.scene(&program).unwrap();
}

/// The same with Whitted's model, whose objects are streamed if they are too many.
#[test]
fn lights_over_capacity_are_refused_until_removed() {
    let program = Program::tracer();
    let mut world = World::new();
    let red = red(&mut world);
    let sphere = world.add_sphere(DVec3::ZERO, 0.5, red).unwrap();
    let lights: Vec<_> = (0..=MAX_LIGHTS)
        .map(|x| {
            let at = DVec3::new(f64::from(x), 9.0, 9.0);
            world.add_light(Light::at(at)).unwrap()
        })
        .collect();
    for _ in 0..2 {
        let error = world.scene(&program).unwrap_err();
        assert!(error.to_string().contains("more than 64 lights"), "{error}");
    }
    for light in &lights[10..] {
        world.remove_light(*light).unwrap();
    }
    world.scene(&program).unwrap();
    world.move_to(sphere, DVec3::ONE).unwrap();
    world.scene(&program).unwrap();
}

#[test]
fn unknown_shader_is_named() {
    let program = Program::tracer();
    let mut world = World::new();
    let red = red(&mut world);
    world.add_light(Light::at(DVec3::ONE)).unwrap();
    world.add_sphere(DVec3::ZERO, 1.0, red).unwrap();
    world.scene(&program).unwrap();
    let plaid = Material {
        shader: Shader::Own { name: "plaid".into(), parameters: [0.0; 4] },
        ..Material::matte(1.0, 0.0, 0.0)
    };
    world.set_material(red, plaid).unwrap();
    for _ in 0..2 {
        let error = world.scene(&program).unwrap_err();
        assert!(error.to_string().contains("plaid"), "{error}");
    }
    world.set_material(red, Material::matte(1.0, 0.0, 0.0)).unwrap();
    world.scene(&program).unwrap();
}

#[test]
fn restored_scene_is_equal() {
    for name in ["whitted16.nff", "shapes.nff", "paper16.nff"] {
        let scene = nff_scene(name);
        let world = World::from_nff(&scene, RenderOptions::default()).unwrap();
        assert!(world.to_nff() == scene, "{name}");
        assert_eq!(world.name(), scene.name);
        let [before, after] =
            [&scene, &world.to_nff()].map(|scene| render(scene, 32, 16, Settings::default()));
        assert!(before == after, "{name}");
    }
}

#[test]
fn errors_name_the_line_of_an_object_from_a_file() {
    let parse = |text: &str| {
        let text = format!("{VIEW}{text}");
        scenes::parse(text.as_bytes(), "dir/s.nff", &scenes::Limits::default()).unwrap()
    };
    let world = |text: &str| World::from_nff(&parse(text), RenderOptions::default());
    let refused = |text: &str| world(text).err().expect("an error").to_string();
    let text = refused("\nf 1 1 1 1 0 0 0 0\ns 0 0 0 1\n\n\ns 0 0 0 1e30\n");
    assert!(text.starts_with("dir/s.nff:13: radius 1e30 is out"), "{text}");
    let text = refused("l 0 0 1e30\nf 1 1 1 1 0 0 0 0\ns 0 0 0 1\n");
    assert!(text.starts_with("dir/s.nff:8: "), "{text}");

    let text = "l 0 9 9\n\n\nf 1 1 1 1 0 0 0 0\n#cellray shader wood\ns 0 0 0 1\n";
    let mut world = world(text).unwrap();
    let error = match world.scene(&Program::tracer()) {
        Ok(_) => panic!("a shader that there is not"),
        Err(error) => error,
    };
    let error = error.to_string();
    assert!(error.starts_with("dir/s.nff:11: "), "{error}");
}
