//! Frames of a scene with their times: the eye goes around, and an animation plays.

use std::time::Duration;

use signal_hook::low_level::emulate_default_handler;

use super::Outcome;
use super::options::Options;
use super::run::{self, Prepared};
use crate::framebuffer::{Framebuffer, Geometry, Interrupted, Memory};
use crate::game::{
    FixedSteps, Frame, FrameRange, Game, Pictures, Session, Start, Turntable, World, WorldError,
};
use crate::scene::mesh::gathered;
use crate::spe::Program;

/// A frame depends only on its number, so the session's own time doesn't matter.
const CLOCK: FixedSteps = FixedSteps(Duration::ZERO);

/// A scene as a game.
pub struct Film {
    turntable: Turntable,
    animation: Option<meshes::Animation>,
    /// Frames per second of the animation.
    rate: u32,
}

impl Film {
    /// A film of a scene, whose animation it takes. The eye goes around in `turn` frames.
    pub fn new(prepared: &mut Prepared, turn: u32, rate: u32) -> Self {
        let animation = prepared.animation.take();
        let scene = gathered(&prepared.source).into_owned();
        let turntable = Turntable::new(scene, prepared.scene.render_options(), turn);
        Self { turntable, animation, rate }
    }
}

impl Game for Film {
    fn name(&self) -> &str {
        self.turntable.name()
    }

    fn set_up(&mut self, world: &mut World, start: &Start) -> Result<(), WorldError> {
        self.turntable.set_up(world, start)
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        let mesh = world.meshes().next();
        if let (Some(animation), Some(mesh)) = (&mut self.animation, mesh) {
            let (positions, normals) = animation.at(frame.number as f64 / f64::from(self.rate));
            world.shape_mesh(mesh, positions, normals)?;
        }
        self.turntable.update(world, frame)
    }
}

/// Writes the pictures of a range of frames, except those that exist.
pub fn pictures(
    options: &Options,
    program: Program,
    film: Film,
    pictures: &Pictures,
    frames: FrameRange,
    size: Geometry,
) -> Outcome {
    let mut interrupted = Interrupted::install()?;
    let picture = Box::new(Memory::new(size)?);
    let mut session = Session::start(film, options.settings(program), picture)?;
    let made = pictures.write(&mut session, frames, &mut { CLOCK }, &mut interrupted)?;
    let what = format!("{} picture(s) written, {} existed already", made.written, made.kept);
    ended(options, &what, session, &interrupted)
}

/// Traces the first `frames` frames. The framebuffer keeps the last one.
pub fn last(
    options: &Options,
    program: Program,
    film: Film,
    frames: u64,
    (framebuffer, what): (Box<dyn Framebuffer>, &str),
) -> Outcome {
    let mut interrupted = Interrupted::install()?;
    let mut session = Session::start(film, options.settings(program), framebuffer)?;
    session.run(Some(frames), &mut { CLOCK }, &mut interrupted)?;
    ended(options, what, session, &interrupted)
}

fn ended(
    options: &Options,
    what: &str,
    session: Session<Film>,
    interrupted: &Interrupted,
) -> Outcome {
    run::report_run(options, what, session.report().clone())?;
    if let Some(signal) = interrupted.signal() {
        messages::print!("cellray: ended by signal {signal}");
        emulate_default_handler(signal)?;
    }
    Ok(())
}
