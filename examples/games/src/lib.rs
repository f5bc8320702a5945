//! Games for cellray. Each is a [`Game`](cellray::game::Game) of the library and knows no window:
//! `cellray-play` shows them.
//!
//! What they have in common: time in steps of one size ([`steps`]), balls that bounce off one
//! another ([`bodies`]), an eye that the player moves ([`camera`]). Invariant: a game's world
//! depends on its seed and what it is told of each frame alone, and is the same on every machine:
//! nothing but `+ - * /`, square roots and `libm`'s functions is worked out.

pub mod billiards;
pub mod bodies;
pub mod camera;
pub mod colour;
pub mod demo;
pub mod marbles;
pub mod orrery;
pub mod screensaver;
pub mod steps;

use cellray::game::Entry;

/// All games.
pub const GAMES: &[Entry] = &[
    billiards::ENTRY,
    marbles::ENTRY,
    orrery::ENTRY,
    screensaver::ENTRY,
];

/// The game of a name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Entry> {
    GAMES.iter().find(|game| game.name == name)
}
