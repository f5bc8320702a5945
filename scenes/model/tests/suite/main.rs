//! The crate from outside, in one program.

mod common;
mod depth;
mod directives;
mod entities;
mod faults;
mod forms;
mod properties;
mod spd;
mod sphereflake;
mod tetra;
mod triangles;
mod view;
