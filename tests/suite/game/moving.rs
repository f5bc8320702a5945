//! Spheres and cones in main memory that move: their blocks are made in the order of codes, by the
//! SPUs as by the PPU, and the pictures are those of trees that are built by the surface area
//! heuristic.

use std::env;

use cellray::scene::BuildBy;

use super::rebuild::{blocks, has_all};
use super::refit::{engine, picture};
use crate::prelude::*;

/// A world of objects, and their handles.
struct Moving {
    world: World,
    ids: Vec<ObjectId>,
    red: MaterialId,
    green: MaterialId,
}

impl Moving {
    /// A world of these shapes, whose tree is made in this way.
    fn of(shapes: &[Shape], build_by: Option<BuildBy>) -> Self {
        let mut world = World::new();
        world.set_background([0.3, 0.4, 0.6]).unwrap();
        world.look_from([1.0, 2.5, 7.0], DVec3::ZERO).unwrap();
        world.add_light(Light::at(DVec3::new(4.0, 6.0, 3.0))).unwrap();
        world.set_render_options(RenderOptions { build_by, ..RenderOptions::default() });
        let red = world.add_material(Material::matte(0.9, 0.2, 0.1)).unwrap();
        let green = world.add_material(Material::shiny(0.1, 0.7, 0.2)).unwrap();
        let of = |number: usize| if number.is_multiple_of(2) { red } else { green };
        let ids = shapes.iter().enumerate();
        let ids = ids.map(|(number, shape)| world.add(shape.clone(), of(number)).unwrap());
        let ids = ids.collect();
        Self { world, ids, red, green }
    }

    /// Gives all objects these shapes.
    fn become_these(&mut self, shapes: &[Shape]) {
        for (&id, shape) in self.ids.iter().zip(shapes) {
            self.world.reshape(id, shape.clone()).unwrap();
        }
    }

    fn scene(&mut self) -> &Scene {
        self.world.scene(&Program::tracer()).unwrap()
    }

    /// The picture of a new scene of the same world.
    fn fresh(&self, engine: &mut Engine) -> RgbImage {
        let options = RenderOptions::default();
        let fresh = Scene::new(&self.world.to_nff(), options, &Program::tracer()).unwrap();
        picture(engine, &fresh)
    }
}

const WAYS: [BuildBy; 3] = [BuildBy::PpuSurfaces, BuildBy::PpuCodes, BuildBy::SpuCodes];

/// Shapes all over a cube, in a picture.
fn shapes(spheres: usize, cones: usize, picture: u64) -> Vec<Shape> {
    let mut random = ChaCha8Rng::seed_from_u64(50 + picture);
    let mut point = |size: f64| DVec3::from([(); 3].map(|()| random.random_range(-size..size)));
    let mut shapes = Vec::new();
    for number in 0..spheres.max(cones) {
        let radius = 0.05 + 0.01 * (number % 7) as f64;
        if number < spheres {
            shapes.push(Shape::Sphere { centre: point(2.0), radius });
        }
        if number < cones {
            let (base, along) = (point(2.0), point(0.4));
            let (base_radius, apex_radius) = (radius, radius * (number % 3) as f64);
            shapes.push(Shape::Cone { base, base_radius, apex: base + along, apex_radius });
        }
    }
    shapes
}

#[test]
fn blocks_are_those_of_the_ppu() {
    let mut engines: Vec<Engine> = (1..=6).map(engine).collect();
    for (spheres, cones) in [(3000, 0), (0, 1500), (1200, 1100)] {
        let mut worlds = WAYS.map(|by| Moving::of(&shapes(spheres, cones, 0), Some(by)));
        for number in 0..3 {
            if number > 0 {
                let shapes = shapes(spheres, cones, number);
                worlds.iter_mut().for_each(|world| world.become_these(&shapes));
            }
            let at = format!("{spheres} spheres, {cones} cones, picture {number}");
            let [surfaces, ppu, spus] = worlds.each_mut().map(Moving::scene);
            let shown = picture(&mut engines[0], surfaces);
            assert!(picture(&mut engines[0], ppu) == shown, "{at}");
            for engine in &mut engines {
                assert!(picture(engine, spus) == shown, "{at}");
                assert!(has_all(&engine.made_blocks().unwrap(), blocks(ppu)), "{at}");
            }
        }
    }
}

/// The same test with transfers that are carried out as late as the SPUs allow.
#[test]
fn late_transfers_make_the_same_blocks() {
    let outcome = Command::new(env::current_exe().unwrap())
        .args(["game::moving::blocks_are_those_of_the_ppu"])
        .env("LIBSPE2_MFC", "at-last")
        .env_remove("LIBSPE2_TIMING")
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&outcome.stdout);
    assert!(outcome.status.success() && text.contains("1 passed"), "{text}");
}

/// Without a choice, SPUs make the blocks from the first movement on, until the world has been at
/// rest for long. Pictures are those of new scenes.
#[test]
fn spus_build_moving_objects() {
    let [mut engine, mut other] = [3, 2].map(engine);
    let mut moving = Moving::of(&shapes(1500, 0, 0), None);
    moving.world.set_render_options(RenderOptions { refit_pictures: 2, ..Default::default() });
    let mut by_spus = Vec::new();
    for number in 0..8 {
        let id = moving.ids[10 * number];
        match number {
            0 => {}
            1 => moving.become_these(&shapes(1500, 0, 1)),
            2 => moving.world.move_to(id, DVec3::ZERO).unwrap(),
            3 => moving.world.show(id, false).unwrap(),
            4 => moving.world.show(moving.ids[30], true).unwrap(),
            5 => moving.world.make_of(id, moving.red).unwrap(),
            6 => moving.world.remove(id).unwrap(),
            _ => moving.world.set_material(moving.green, Material::glass()).unwrap(),
        }
        let shown = picture(&mut engine, moving.scene());
        by_spus.push(engine.made_blocks().is_some());
        assert!(moving.fresh(&mut other) == shown, "{number}");
    }
    assert_eq!(by_spus, [false, true, true, true, true, true, true, true]);
    let mut pictures = 0..100_u32;
    pictures.find(|&number| {
        let eye = [1.0, 2.5, 7.0 + 0.01 * f64::from(number)];
        moving.world.look_from(eye, DVec3::ZERO).unwrap();
        picture(&mut engine, moving.scene());
        engine.made_blocks().is_none()
    });
    assert_eq!(pictures.next(), Some(9));
}

/// A material that all surfaces have, in a picture for which nothing has moved.
#[test]
fn another_colour_is_seen_everywhere() {
    let [mut engine, mut other] = [2, 1].map(engine);
    let mut moving = Moving::of(&shapes(1500, 0, 0), Some(BuildBy::SpuCodes));
    for blue in [0.1, 0.9] {
        moving.world.set_material(moving.red, Material::matte(0.1, 0.1, blue)).unwrap();
        let shown = picture(&mut engine, moving.scene());
        assert!(moving.fresh(&mut other) == shown, "{blue}");
    }
}

/// An object becomes one of another kind, or one in local store, and a polygon moves there.
#[test]
fn objects_of_other_kinds_need_a_new_scene() {
    let [mut engine, mut other] = [2, 1].map(engine);
    let mut all = shapes(1500, 0, 0);
    let square = [[-2.0, -1.0, -2.0], [-2.0, -1.0, 2.0], [2.0, -1.0, 2.0], [2.0, -1.0, -2.0]];
    all.push(Shape::Polygon { vertices: square.map(DVec3::from).to_vec() });
    let mut moving = Moving::of(&all, Some(BuildBy::SpuCodes));
    let cone =
        Shape::Cone { base: DVec3::ZERO, base_radius: 0.5, apex: DVec3::Y, apex_radius: 0.0 };
    let raised = square.map(|corner| DVec3::from(corner) + 0.5 * DVec3::Y);
    let changes = [
        (4, all[0].clone()),
        (1500, Shape::Polygon { vertices: raised.to_vec() }),
        (5, cone),
        (6, all[1500].clone()),
    ];
    picture(&mut engine, moving.scene());
    for (number, shape) in changes {
        moving.world.reshape(moving.ids[number], shape).unwrap();
        let shown = picture(&mut engine, moving.scene());
        assert!(engine.made_blocks().is_some(), "{number}");
        assert!(moving.fresh(&mut other) == shown, "{number}");
    }
    // All but one are hidden, and then that one, too.
    for range in [1..moving.ids.len(), 0..1] {
        for &id in &moving.ids[range] {
            moving.world.show(id, false).unwrap();
        }
        let shown = picture(&mut engine, moving.scene());
        assert!(moving.fresh(&mut other) == shown);
    }
}

/// All spheres at one point: the picture is that of the largest.
#[test]
fn all_codes_may_be_equal() {
    let [mut engine, mut other] = [3, 1].map(engine);
    let centre = DVec3::new(0.3, 0.2, 0.1);
    let radius = |number: usize| if number == 77 { 1.0 } else { 0.5 };
    let all = (0..3000).map(|number| Shape::Sphere { centre, radius: radius(number) });
    let mut moving = Moving::of(&all.collect::<Vec<_>>(), Some(BuildBy::SpuCodes));
    moving.ids.iter().for_each(|&id| moving.world.make_of(id, moving.red).unwrap());
    let shown = picture(&mut engine, moving.scene());
    assert!(engine.made_blocks().is_some());
    let sphere = Shape::Sphere { centre, radius: 1.0 };
    let mut one = Moving::of(&[sphere], None);
    assert!(picture(&mut other, one.scene()) == shown);
}

#[test]
fn coordinates_may_be_huge_or_tiny() {
    for scale in [2_f64.powi(58), 2_f64.powi(-50)] {
        let scaled = |shape: &Shape| match *shape {
            Shape::Sphere { centre, radius } => {
                Shape::Sphere { centre: centre * scale, radius: radius * scale }
            }
            Shape::Cone { base, base_radius, apex, apex_radius } => Shape::Cone {
                base: base * scale,
                base_radius: base_radius * scale,
                apex: apex * scale,
                apex_radius: apex_radius * scale,
            },
            _ => unreachable!("there are only spheres and cones"),
        };
        let shapes: Vec<_> = shapes(1100, 1100, 0).iter().map(scaled).collect();
        let mut engine = engine(2);
        let ways = [BuildBy::PpuCodes, BuildBy::SpuCodes];
        let mut worlds = ways.map(|by| Moving::of(&shapes, Some(by)));
        let [ppu, spus] = worlds.each_mut().map(Moving::scene);
        picture(&mut engine, spus);
        assert!(has_all(&engine.made_blocks().unwrap(), blocks(ppu)), "{scale}");
    }
}

/// Far from where the blocks have their origin, positions would lose precision.
#[test]
fn objects_may_move_away_together() {
    let [mut engine, mut other] = [2, 1].map(engine);
    let mut moving = Moving::of(&shapes(1500, 0, 0), Some(BuildBy::SpuCodes));
    picture(&mut engine, moving.scene());
    let away = DVec3::new(3e6, -2e6, 1e6);
    for id in moving.ids.clone() {
        let position = moving.world.position(id).unwrap();
        moving.world.move_to(id, position + away).unwrap();
    }
    moving.world.look_from(away + DVec3::new(1.0, 2.5, 7.0), away).unwrap();
    let shown = picture(&mut engine, moving.scene());
    assert!(moving.fresh(&mut other) == shown);
}
