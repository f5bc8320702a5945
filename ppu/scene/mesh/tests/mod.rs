//! The blocks of meshes, right in every field, and traced in `f64`.

mod cones;
mod meshes;
mod moving;
mod refit;
mod refusals;
mod spheres;
mod structure;
mod traced;
mod valid;
