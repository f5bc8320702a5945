//! A ball that bounces over a row of others, rendered as numbered pictures.
//!
//!     cargo run --release --example bounce -- FOLDER [FRAMES | A..B]
//!
//! It shows how a game is made: the world is set up once, and then changed once a frame.

use std::error::Error;
use std::path::PathBuf;
use std::time::Duration;

use cellray::Settings;
use cellray::framebuffer::{Geometry, Memory, NumberedPath};
use cellray::game::{
    DVec3, DepthShading, FixedSteps, Frame, FrameRange, Game, Material, NoInput, ObjectId,
    Pictures, Session, Start, World, WorldError,
};

const RADIUS: f64 = 0.6;
/// Seconds of a jump.
const JUMP: f64 = 0.5;

#[derive(Default)]
struct Bounce {
    ball: ObjectId,
}

impl Game for Bounce {
    fn name(&self) -> &str {
        "bounce"
    }

    fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
        world.look_from(DVec3::new(0.0, 2.0, 12.0), DVec3::new(0.0, 0.8, 0.0))?;
        world.set_background(DVec3::new(0.05, 0.07, 0.14))?;
        // The ball has a material of its own, so that tiles without it do not change.
        world.set_fade(Some(DepthShading { near: 10.0, far: 17.0 }))?;
        let orange = world.add_material(Material::matte(0.96, 0.4, 0.25))?;
        let blue = world.add_material(Material::matte(0.4, 0.6, 0.9))?;
        self.ball = world.add_sphere(DVec3::ZERO, RADIUS, orange)?;
        for place in -4..=4 {
            let centre = DVec3::new(f64::from(place), -RADIUS, -1.5);
            let still = world.add_sphere(centre, RADIUS, blue)?;
            world.fix(still)?;
        }
        Ok(())
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        // Four jumps from left to right, each of them a parabola.
        let across = frame.time / (4.0 * JUMP) % 1.0;
        let jump = frame.time / JUMP % 1.0;
        let height = RADIUS + 6.0 * jump * (1.0 - jump);
        world.move_to(self.ball, DVec3::new(across * 8.0 - 4.0, height, 0.0))
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1);
    let folder = PathBuf::from(arguments.next().ok_or("usage: bounce FOLDER [FRAMES | A..B]")?);
    let frames: FrameRange = match arguments.next() {
        Some(text) => text.to_string_lossy().parse()?,
        None => FrameRange { first: 0, end: 24 },
    };
    std::fs::create_dir_all(&folder)?;
    let pattern = folder.join("bounce-%03d.png");
    let paths = NumberedPath::new(pattern)?;
    let pictures = Pictures::new(paths);
    let picture = Box::new(Memory::new(Geometry::new(640, 360)?)?);
    let mut session = Session::start(Bounce::default(), Settings::default(), picture)?;
    let mut clock = FixedSteps(Duration::from_secs(1) / 12);
    pictures.write(&mut session, frames, &mut clock, &mut NoInput)?;
    messages::print!("{}", session.report());
    Ok(())
}
