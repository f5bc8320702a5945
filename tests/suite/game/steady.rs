//! Frames in which objects move allocate no memory.

use crate::prelude::*;
use cellray::game::{
    DVec3, FixedSteps, Frame, Game, LightId, Model, NoInput, RenderOptions, Session, Shader, Shape,
    Start,
};

/// Every object moves and changes its colour, and some appear and disappear.
struct Swarm {
    render_options: RenderOptions,
    objects: Vec<(ObjectId, DVec3)>,
    materials: Vec<MaterialId>,
    light: LightId,
}

impl Swarm {
    fn new(model: Model) -> Self {
        Self {
            render_options: RenderOptions { model, ..RenderOptions::default() },
            objects: Vec::new(),
            materials: Vec::new(),
            light: LightId::default(),
        }
    }
}

/// A closed path that takes three seconds.
fn way(time: f64, number: usize) -> DVec3 {
    let wave = |phase: f64| {
        let part = (time / 3.0 + phase).fract();
        4.0 * part * (1.0 - part)
    };
    let phase = number as f64 * 0.37;
    DVec3::new(wave(phase), wave(phase + 0.2), wave(phase + 0.5))
}

impl Game for Swarm {
    fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
        world.set_render_options(self.render_options);
        self.light = world.add_light(Light::at(DVec3::new(0.0, 20.0, 5.0)))?;
        for shader in
            [Shader::Phong, Shader::Lambert, Shader::Checker { other: DVec3::ONE, size: 0.5 }]
        {
            let material = Material { shader, ..Material::shiny(0.5, 0.5, 0.5) };
            self.materials.push(world.add_material(material)?);
        }
        for number in 0..60 {
            let place = DVec3::new(f64::from(number % 10) - 5.0, f64::from(number / 10) - 3.0, 0.0);
            let shape = match number % 4 {
                0 | 1 => Shape::Sphere { centre: place, radius: 0.3 },
                2 => Shape::Cone {
                    base: place,
                    base_radius: 0.3,
                    apex: place + DVec3::Y * 0.5,
                    apex_radius: 0.1,
                },
                _ => Shape::Polygon {
                    vertices: vec![
                        place,
                        place + DVec3::X * 0.5,
                        place + DVec3::new(0.5, 0.5, 0.1),
                        place + DVec3::new(0.0, 0.5, 0.1),
                    ][..if number % 8 == 3 { 3 } else { 4 }]
                        .to_vec(),
                },
            };
            let object = world.add(shape, self.materials[number as usize % 3])?;
            self.objects.push((object, place));
        }
        Ok(())
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        for (number, (object, place)) in self.objects.iter().enumerate() {
            world.move_to(*object, *place + way(frame.time, number))?;
            world.make_of(*object, self.materials[(number + frame.number as usize) % 3])?;
            world.show(*object, !(frame.number as usize + number).is_multiple_of(11))?;
        }
        for (number, material) in self.materials.iter().enumerate() {
            world.recolour(*material, way(frame.time, number) * 0.5)?;
        }
        let place = DVec3::new(0.0, 20.0, 5.0) + way(frame.time, 7);
        world.set_light(self.light, Light::at(place))?;
        if frame.number.is_multiple_of(5) {
            world.look_from(DVec3::Z * 12.0 + way(frame.time, 3), DVec3::ZERO)?;
        }
        Ok(())
    }
}

fn session(model: Model, width: u32) -> Session<Swarm> {
    let picture = Memory::new(Geometry::new(width, 48).unwrap()).unwrap();
    Session::start(Swarm::new(model), Settings::default(), Box::new(picture)).unwrap()
}

fn run(session: &mut Session<Swarm>, frames: u64) {
    let mut clock = FixedSteps(Duration::from_millis(25));
    session.run(Some(frames), &mut clock, &mut NoInput).unwrap();
}

fn steady_frames_take_no_memory(model: Model) {
    // Three small tiles, because the SPUs' time is irrelevant to the PPU's memory.
    let mut session = session(model, 16);
    // After one turn, everything has reached its maximum size.
    run(&mut session, 130);
    for frame in 0..40 {
        let asked = allocations::during(|| run(&mut session, 1));
        assert!(asked.is_empty(), "frame {frame}: {}", asked[0]);
    }
    let report = session.report();
    assert_eq!(report.frames, 170);
    assert!(report.frames_traced > 160);
}

#[test]
fn by_whitteds_model() {
    steady_frames_take_no_memory(Model::Whitted);
}

#[test]
fn by_depth_shading() {
    steady_frames_take_no_memory(Model::Depth);
}

/// The frame loop sleeps while SPUs trace, so it uses only a small part of the processor's time.
#[test]
fn frame_loop_sleeps() {
    let mut session = session(Model::Whitted, 64);
    run(&mut session, 30);
    let report = session.report();
    assert!(report.loop_seconds > 0.0);
    assert!(report.loop_seconds < 0.5 * report.host_seconds, "{report}");
    let text = report.to_string();
    assert!(text.lines().any(|line| line.starts_with("frame loop: ")), "{text}");
}
