//! The user layer: a [`Game`] is called once a frame and changes its [`World`]; the engine traces it.
//!
//! Owns what a game sees: the world, the input, the moment. Knows no window and no device: those who show a game
//! ([`run`]) bring a framebuffer and a source of [`Input`]. Invariant: what a game sees in a frame depends on
//! the frames' times and inputs alone, so that a recorded session is played back bit for bit.

mod input;
mod run;
mod world;

pub use input::{Axis, Button, Input, InputEvent, Key, MouseButton, Pad, PadId};
pub use run::{Clock, InputSource, NoInput, Session, SessionError, run};
pub use world::{LightId, MaterialId, ObjectId, World, WorldError};

use crate::statistics::FrameStatistics;

/// Something to play or to watch.
pub trait Game {
    /// Puts the first objects, lights and materials into the world. Called once.
    fn set_up(&mut self, world: &mut World);

    /// Changes the world for the frame that comes next. Called once a frame.
    fn frame(&mut self, world: &mut World, moment: &Moment<'_>);

    /// Whether the game is over: after the frame at hand no other comes.
    fn is_over(&self) -> bool {
        false
    }
}

/// What a game is told of a frame.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// Number of the frame, from 0.
    pub frame: u64,
    /// Seconds from the first frame to this one.
    pub time: f64,
    /// Seconds from the last frame to this one; 0 in the first.
    pub step: f64,
    /// What the player does.
    pub input: &'a Input,
    /// Pixels across and down.
    pub size: (u32, u32),
    /// What the SPUs said of the last frame; nothing in the first.
    pub last: Option<&'a FrameStatistics>,
}
