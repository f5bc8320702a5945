//! All tests of the games. They are one program, because linking several takes longer.

mod driven;
mod flight;
mod headless;
mod maps;
mod orrery;
mod physics;
mod places;
mod played;
mod station;
mod walker;
