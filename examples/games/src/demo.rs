//! The input of a player before the pictures of `docs/play.md` are taken and before frames are
//! measured.

use cellray::game::{Entry, Frame, Input, InputEvent, Key, Start, World, WorldError};

use crate::{billiards, flight, marbles, orrery, screensaver, waves};

/// Frames a second in a demonstration.
const RATE: u32 = 30;

/// A typical moment of a game.
#[derive(Clone, Copy)]
pub struct Demo {
    /// The demonstration's name.
    pub name: &'static str,
    /// The game.
    pub game: &'static Entry,
    /// The keys that are held, each from one frame to another.
    pub keys: &'static [(Key, u64, u64)],
    /// The number of the frame.
    pub frame: u64,
}

/// All demonstrations.
pub const DEMOS: &[Demo] = &[
    Demo {
        name: "billiards",
        game: &billiards::ENTRY,
        keys: &[(Key::Up, 1, 12), (Key::Space, 20, 22)],
        frame: 66,
    },
    Demo {
        name: "billiards-aim",
        game: &billiards::ENTRY,
        keys: &[(Key::Up, 1, 12), (Key::Space, 20, 22), (Key::Left, 470, 512)],
        frame: 540,
    },
    Demo {
        name: "marbles",
        game: &marbles::ENTRY,
        keys: &[(Key::Right, 5, 24), (Key::Down, 14, 40), (Key::Left, 34, 60)],
        frame: 62,
    },
    Demo { name: "flight", game: &flight::ENTRY, keys: &[(Key::B, 200, 202)], frame: 420 },
    Demo { name: "orrery", game: &orrery::ENTRY, keys: &[], frame: 240 },
    Demo { name: "orrery-saturn", game: &orrery::ENTRY, keys: &[(Key::Digit6, 2, 4)], frame: 260 },
    Demo { name: "screensaver", game: &screensaver::ENTRY, keys: &[], frame: 130 },
    Demo {
        name: "screensaver-lights",
        game: &screensaver::ENTRY,
        keys: &[(Key::Space, 2, 4)],
        frame: 130,
    },
    Demo {
        name: "waves",
        game: &waves::ENTRY,
        keys: &[(Key::Right, 5, 40), (Key::Up, 20, 60), (Key::Space, 70, 71)],
        frame: 100,
    },
];

impl Demo {
    /// Plays from the first frame to the moment, and calls `show` with the game's world for as many
    /// frames from there on, at least 1.
    pub fn play<E: From<WorldError>>(
        &self,
        size: (u32, u32),
        frames: u64,
        mut show: impl FnMut(&mut World) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut game = (self.game.new)();
        let mut world = World::new();
        let mut input = Input::default();
        game.set_up(&mut world, &Start { seed: 0, size })?;
        for frame in 0..self.frame + frames.max(1) {
            input.begin_frame();
            for &(key, from, to) in self.keys {
                if frame == from || frame == to {
                    let down = frame == from;
                    input.apply(&InputEvent::Key { key, down });
                }
            }
            let step = if frame == 0 { 0.0 } else { 1.0 / f64::from(RATE) };
            let frame = Frame {
                number: frame,
                time: frame as f64 / f64::from(RATE),
                delta: step,
                input: &input,
                size,
                last: None,
            };
            game.update(&mut world, &frame)?;
            if frame.number >= self.frame {
                show(&mut world)?;
            }
        }
        Ok(())
    }
}

/// The demonstration with this name.
#[must_use]
pub fn demo(name: &str) -> Option<&'static Demo> {
    DEMOS.iter().find(|demo| demo.name == name)
}
