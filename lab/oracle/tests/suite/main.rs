//! All tests of the reference from outside: one program, as linking several takes longer.

mod command_line;
mod scenes;
mod whitted;
