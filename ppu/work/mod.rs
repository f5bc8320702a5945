//! Work units: what the PPU tells the SPUs of a frame, and what they answer.

#[cfg(test)]
mod arithmetic;
mod describe;
mod pages;
mod plan;
mod policy;
mod projection;
mod refusal;
mod shadow;
mod snapshot;
mod spheres;
mod tiles;
mod units;

pub use describe::{Addresses, Order, describe};
pub(crate) use plan::{Plan, Size};
pub(crate) use policy::Policy;
pub use policy::{Skip, Split};
pub use projection::{Projection, Rectangle};
pub use refusal::Refusal;
pub use spheres::EyeSpheres;
pub use tiles::{tile_count, tile_pixels};
pub use units::Units;

// What SPUs fetch of a scene is part of a work unit, though the scene keeps it.
pub use crate::scene::{BlockError, BlockOptions, SceneBlock};
