//! Work units: what the PPU tells the SPUs of a frame, and what they answer.

#[cfg(test)]
mod arithmetic;
mod describe;
mod lens;
mod pages;
mod plan;
mod refusal;
mod spheres;
mod tiles;
mod units;
mod whitted;

pub use describe::{Addresses, Order, Skip, Split, describe};
pub use lens::{Lens, Rectangle};
pub(crate) use plan::{Plan, Policy, Size};
pub use refusal::Refusal;
pub use spheres::EyeSpheres;
pub use tiles::{tile_count, tile_pixels};
pub use units::Units;
pub use whitted::{BlockError, BlockOptions, SceneBlock};
pub(crate) use whitted::{ShaderEntries, Shown};
