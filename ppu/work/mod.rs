//! Work units: what the PPU tells the SPUs of a frame, and what they answer.

mod describe;
pub mod layout;
mod refusal;

pub use describe::{Addresses, Split, describe, slices, tile_count};
pub use refusal::Refusal;
