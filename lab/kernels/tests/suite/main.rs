//! All tests of the kernels. They are one program, because linking many takes longer than running
//! them.

#![allow(clippy::print_stdout, reason = "the harness shows it with a failed test")]

mod assembler;
mod bounce;
mod catalogue;
mod command_line;
mod document;
mod equality;
mod eye;
mod flat;
mod harness;
mod images;
mod math;
mod measured;
mod mesh;
mod pairs;
mod rays;
mod schedule;
mod shaders;
mod sphere_ray;
mod spheres;
mod surfaces;
mod tracer;
