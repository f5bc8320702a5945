//! All tests of the games: one program, as linking several takes longer.

mod headless;
mod orrery;
mod physics;
mod played;
