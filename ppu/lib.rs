//! cellray: an interactive ray tracer for the Cell Broadband Engine under PS3 Linux.
//!
//! This is the PPU's part. A [`Scene`] is handed, frame by frame, to an [`Engine`], whose SPUs trace
//! it and write finished rows straight into a [`framebuffer`]. What answers below the libspe2 calls
//! in [`spe`], a console's SPEs or emulated ones, this crate does not know.

pub mod engine;
pub mod formulation;
pub mod framebuffer;
pub mod game;
pub mod quality;
mod report;
pub mod scene;
mod shared;
pub mod spe;
pub mod statistics;
pub mod work;

pub use engine::{Engine, EngineError, Settings};
pub use quality::Quality;
pub use report::Report;
pub use scene::{Scene, SceneError};
pub use shared::SharedMemory;
