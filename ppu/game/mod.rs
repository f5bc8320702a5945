//! The user layer: a [`Game`] is called once a frame and changes its [`World`], which the engine
//! then traces.
//!
//! Owns everything that a game sees: the world, the input, the frame. It depends neither on windows
//! nor on devices: the program that shows a game gives its [`Session`] a framebuffer and the
//! [`InputEvent`]s. Invariant: except for [`Frame::last`], everything that a game sees depends only
//! on the frames' times, sizes and inputs, so a recorded session plays back bit for bit.

mod camera;
mod input;
mod label;
mod random;
mod run;
mod turntable;
mod world;

use std::error::Error;
use std::path::Path;

pub use glam::{DAffine3, DVec3};
pub use scenes::depth::DepthShading;
pub use scenes::{
    Fog, HeightField, HeightRegion, HeightSample, LightKind, Mesh, Shader, Shape, Sky, Texture,
    View, Wrap,
};

pub use camera::{OrbitCamera, WalkCamera};
pub use input::{Axis, Button, Input, InputEvent, Key, Mouse, MouseButton, Pad, PadId, Sensors};
pub use label::{Anchor, Label, PlacedLabel, Side};
pub use random::Random;
pub use run::{
    Clock, FixedSteps, FrameRange, FrameRangeError, InputSource, Made, NoInput, Pictures, RealTime,
    Recording, RecordingError, Session, SessionError,
};
pub use turntable::Turntable;
pub use world::{
    Light, LightId, Material, MaterialId, MeshId, ObjectId, Pick, Target, World, WorldError,
    WorldErrorKind,
};

pub use crate::scene::{Model, RenderOptions};
use crate::spe::{Program, ProgramError};
use crate::statistics::FrameStatistics;

/// A program that changes a [`World`] once a frame: a game, an animation, a viewer.
pub trait Game {
    /// The game's name, as recordings and statistics have it.
    fn name(&self) -> &str {
        "game"
    }

    /// The game's own SPU program, with its shaders; `None` selects the one in the settings.
    ///
    /// # Errors
    /// The program that the game brings is not a valid SPU program.
    fn program(&self) -> Result<Option<Program>, ProgramError> {
        Ok(None)
    }

    /// Puts the first objects, lights and materials into the world. Called once.
    ///
    /// # Errors
    /// Any [`WorldError`] from a change of the world; it ends the session.
    fn set_up(&mut self, world: &mut World, start: &Start) -> Result<(), WorldError>;

    /// Changes the world for the coming frame. Called once a frame.
    ///
    /// # Errors
    /// Any [`WorldError`] from a change of the world; it ends the session.
    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError>;

    /// The controls, each in a line of its own, as `keys: what they do`. The program that shows the
    /// game lists them as help.
    fn controls(&self) -> &[&str] {
        &[]
    }

    /// The status text that a display shows beside the picture, such as the score and whose turn it
    /// is: short lines of text, or nothing. It is drawn on the display only, never into the picture
    /// that the SPUs trace, so pictures and recordings are the same with or without it.
    fn status(&self) -> String {
        String::new()
    }

    /// Text over the picture, at places of the picture or of the world: names, hints, numbers.
    /// Asked after each frame. As [`Game::status`], it is drawn on the display only. Labels that
    /// come first are more important: where two would cover each other, the later one is left out.
    fn labels(&self) -> Vec<Label> {
        Vec::new()
    }

    /// Whether the game is over. Asked after each frame; if it is, that frame was the last.
    fn is_over(&self) -> bool {
        false
    }
}

/// A row in a table of games: how to list a game, and how to create it.
#[derive(Clone, Copy)]
pub struct Entry {
    /// The game's name on a command line, equal to its [`Game::name`].
    pub name: &'static str,
    /// A description of one line.
    pub line: &'static str,
    /// Creates the game.
    pub new: fn() -> Box<dyn Game>,
    /// Creates the game with a level of a WAD file, by the level's name or the file's first one;
    /// `None` if the game has no such levels.
    pub open: Option<OpenLevel>,
}

/// Creates a game with a level of a file. An error names the file.
pub type OpenLevel = fn(&Path, Option<&str>) -> Result<Box<dyn Game>, Box<dyn Error + Send + Sync>>;

/// The information that a game receives before its first frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Start {
    /// The random seed. A game that takes all its random numbers from it plays back as recorded.
    /// [`Start::random`] is a source of them.
    pub seed: u64,
    /// The picture's width and height in pixels.
    pub size: (u32, u32),
}

impl Start {
    /// Random numbers that are other ones in each session, and the same when it is played back.
    #[must_use]
    pub fn random(&self) -> Random {
        Random::new(self.seed)
    }
}

/// The information that a game receives for a frame.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// Number of the frame, from 0.
    pub number: u64,
    /// Seconds from the first frame to this one.
    pub time: f64,
    /// Seconds from the last frame to this one; 0 in the first.
    pub delta: f64,
    /// The state of keys, mouse and pads.
    pub input: &'a Input,
    /// The picture's width and height in pixels.
    pub size: (u32, u32),
    /// The SPUs' statistics of the last frame; `None` in the first. They differ from run to run:
    /// show them, but don't let the game depend on them.
    pub last: Option<&'a FrameStatistics>,
}
