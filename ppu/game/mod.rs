//! The user layer: a [`Game`] is called once a frame and changes its [`World`]; the engine traces
//! it.
//!
//! Owns what a game sees: the world, the input, the frame. Knows no window and no device: those
//! who show a game bring a framebuffer and a source of [`Input`] to its [`Session`]. Invariant:
//! what a game sees in a frame depends on the frames' times, sizes and inputs alone, but for
//! [`Frame::last`], so that a recorded session is played back bit for bit.

mod input;
mod run;
mod turntable;
mod world;

pub use glam::DVec3;
pub use nff::depth::DepthShading;
pub use nff::{LightKind, Shader, Shape, View};

pub use input::{Axis, Button, Input, InputEvent, Key, Mouse, MouseButton, Pad, PadId, Sensors};
pub use run::{
    Clock, FixedSteps, FrameRange, FrameRangeError, InputSource, Made, NoInput, Pictures, RealTime,
    Recording, RecordingError, Session, SessionError,
};
pub use turntable::Turntable;
pub use world::{Light, LightId, Material, MaterialId, ObjectId, World, WorldError};

pub use crate::scene::{Model, RenderOptions};
use crate::spe::{Program, ProgramError};
use crate::statistics::FrameStatistics;

/// Something to play or to watch.
pub trait Game {
    /// What it is called, in recordings and statistics.
    fn name(&self) -> &str {
        "game"
    }

    /// The SPU program that it is traced by, if that is one of its own, with its shaders.
    fn program(&self) -> Result<Option<Program>, ProgramError> {
        Ok(None)
    }

    /// Puts the first objects, lights and materials into the world. Called once.
    fn set_up(&mut self, world: &mut World, start: &Start) -> Result<(), WorldError>;

    /// Changes the world for the frame that comes next. Called once a frame.
    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError>;

    /// Whether the game is over: after the frame at hand no other comes.
    fn is_over(&self) -> bool {
        false
    }
}

/// A game in a table of those that can be started.
#[derive(Clone, Copy)]
pub struct Entry {
    /// What it is called on a command line, as [`Game::name`] has it.
    pub name: &'static str,
    /// What it is, in a line.
    pub line: &'static str,
    /// What the player can do, a line each.
    pub controls: &'static [&'static str],
    /// Makes it.
    pub new: fn() -> Box<dyn Game>,
}

/// What a game is told before its first frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Start {
    /// Number that all of a game's chance is to come from: a recorded session has it again.
    pub seed: u64,
    /// Pixels across and down.
    pub size: (u32, u32),
}

/// What a game is told of a frame.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// Number of the frame, from 0.
    pub number: u64,
    /// Seconds from the first frame to this one.
    pub time: f64,
    /// Seconds from the last frame to this one; 0 in the first.
    pub delta: f64,
    /// What the player does.
    pub input: &'a Input,
    /// Pixels across and down.
    pub size: (u32, u32),
    /// What the SPUs said of the last frame; nothing in the first. It is another from run to run:
    /// to be shown, not to be played by.
    pub last: Option<&'a FrameStatistics>,
}
