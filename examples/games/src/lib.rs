//! Games for cellray. Each is a [`Game`](cellray::game::Game) of the library that does not depend
//! on a window. `cellray-play` shows them.
//!
//! They share time in steps of one size ([`steps`]), balls that bounce off one another
//! ([`bodies`]), and an eye that the player moves ([`camera`]). Invariant: a game's world depends
//! only on its seed and on the input of each frame, and is the same on every machine, because only
//! `+ - * /`, square roots and `libm`'s functions are used.

pub mod billiards;
pub mod bodies;
pub mod camera;
pub mod colour;
pub mod demo;
pub mod flight;
pub mod marbles;
pub mod orrery;
mod rock;
pub mod screensaver;
pub mod station;
pub mod steps;
pub mod waves;

use cellray::game::Entry;

/// All games.
pub const GAMES: &[Entry] = &[
    billiards::ENTRY,
    flight::ENTRY,
    marbles::ENTRY,
    orrery::ENTRY,
    screensaver::ENTRY,
    station::ENTRY,
    waves::ENTRY,
];

/// The game with this name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Entry> {
    GAMES.iter().find(|game| game.name == name)
}
