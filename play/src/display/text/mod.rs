//! Text over a picture.
//!
//! Owns where each part of the overlay is placed, and how it is drawn in pixels. Invariant: text is
//! drawn on the display, and the picture that the SPUs have traced is never changed by it.

mod font;
mod layout;
pub mod paint;
mod printed;

pub use layout::{Grid, Placed, place, place_labels, words};
pub use printed::Printed;
