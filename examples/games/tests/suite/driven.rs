//! Games that are played without pictures.

use cellray::game::{Frame, Game, Input, InputEvent, Key, Start, World};

/// A picture of this width and height must contain everything.
pub const SIZE: (u32, u32) = (1280, 720);
/// A game, its world, and its input.
pub struct Played<G> {
    pub game: G,
    pub world: World,
    input: Input,
    frame: u64,
}

impl<G: Game + Default> Played<G> {
    pub fn new() -> Self {
        let (mut game, mut world) = (G::default(), World::new());
        let start = Start { seed: 0, size: SIZE };
        game.set_up(&mut world, &start).unwrap();
        Self { game, world, input: Input::default(), frame: 0 }
    }

    pub fn frame(&mut self, step: f64, keys: &[(Key, bool)]) {
        self.input.begin_frame();
        for &(key, down) in keys {
            self.input.apply(&InputEvent::Key { key, down });
        }
        let frame = Frame {
            number: self.frame,
            time: self.frame as f64 * step,
            delta: step,
            input: &self.input,
            size: SIZE,
            last: None,
        };
        self.game.update(&mut self.world, &frame).unwrap();
        self.frame += 1;
    }

    /// Presses a key and releases it at once.
    pub fn press(&mut self, key: Key) {
        self.frame(0.0, &[(key, true), (key, false)]);
    }
}
