//! Run time against error, and numerical stability, of the ways to intersect rays.
//!
//! This crate computes the exact result for a ray and an object from the same singles that a
//! kernel gets (`truth`), and the kernels' errors. It does not depend on how a kernel computes.
//! Invariant: every printed figure is measured by the run that prints it, and except for the
//! host's clock it is the same on every host.

pub mod antialiasing;
pub mod document;
mod families;
mod figures;
pub mod file;
mod generator;
pub mod mesh_cache;
mod metrics;
mod origin;
pub mod output;
mod parallel;
mod pareto;
pub mod pictures;
pub mod plots;
mod roots;
pub mod run;
pub mod search;
mod space;
mod spheres;
pub mod stability;
mod subject;
mod totals;
mod traced;
mod triangles;
mod truth;
