//! The crate from outside, in one program.

mod common;
mod depth;
mod entities;
mod faults;
mod properties;
mod sphereflake;
mod triangles;
mod view;
