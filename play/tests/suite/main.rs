//! All tests of the player from outside: one program, as linking several takes longer.

mod input;
mod sessions;
