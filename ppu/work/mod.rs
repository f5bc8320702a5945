//! Work units: the records that the PPU sends to the SPUs for a frame, and the SPUs' replies.

#[cfg(test)]
mod arithmetic;
mod cuts;
mod describe;
mod pages;
mod plan;
mod policy;
mod projection;
mod refusal;
mod snapshot;
mod spheres;
mod tiles;
mod units;

pub use describe::{Addresses, Order, describe};
pub(crate) use pages::MAX_PAGES;
pub(crate) use plan::{Plan, Size};
pub(crate) use policy::Policy;
pub use policy::{Skip, Split};
pub use projection::{Projection, Rectangle};
pub use refusal::Refusal;
pub use spheres::EyeSpheres;
pub use tiles::{tile_count, tile_pixels};
pub use units::Units;

// The block belongs to the scene, but SPUs fetch it as a part of the frame.
pub use crate::scene::{BlockError, SceneBlock};
