//! Run time against error, and numerical stability, of the ways to intersect rays.
//!
//! Owns what is true of a ray and an object for the very singles that a kernel is given (`truth`)
//! and how far kernels are from it. Knows nothing of how a kernel computes. Invariant: a figure is
//! measured by the run that prints it, and but for the host's clock it is the same on every host.

pub mod document;
mod families;
mod figures;
pub mod file;
mod generator;
mod metrics;
mod origin;
pub mod output;
mod parallel;
mod pareto;
pub mod pictures;
pub mod plots;
mod roots;
pub mod run;
mod space;
mod spheres;
pub mod stability;
mod subject;
mod triangles;
mod truth;
