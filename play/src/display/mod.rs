//! Where a game is seen, and where keys and mouse are read.
//!
//! Owns what a display is to the frame loop. Invariants: what a display changed on the system is
//! put back when it is dropped; the mouse is told in pixels of the picture, whatever its size on
//! the display.

mod fit;
mod nowhere;
mod pointer;
mod screen;
mod terminal;
#[cfg_attr(target_arch = "powerpc64", path = "no_window.rs")]
mod window;

pub use fit::Fit;
pub use nowhere::Nowhere;
pub use pointer::Pointer;
pub use screen::Screen;
pub use terminal::{Colours, Terminal, lines};
pub use window::Window;

use std::io;

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry};
use cellray::game::InputEvent;
use image::RgbImage;

use crate::overlay::Overlay;

/// Something that came from a display.
#[derive(Clone, Debug, PartialEq)]
pub enum DisplayEvent {
    /// Input.
    Input(InputEvent),
    /// The display is of another size.
    Resized,
    /// The player has closed it.
    Closed,
    /// The player has asked for an end as by SIGINT.
    Interrupted,
    /// The terminal that it is on is gone.
    HungUp,
}

/// A display.
pub trait Display {
    /// Pixels that there are to fill.
    fn area(&self) -> Geometry;

    /// Whether pictures of another size than the area's are shown too.
    fn scales(&self) -> bool;

    /// What the SPUs are to write to, for pictures of this size.
    fn framebuffer(&mut self, size: Geometry) -> Result<Box<dyn Framebuffer>, FramebufferError>;

    /// Appends what has happened since the last call; does not wait.
    fn poll(&mut self, display_events: &mut Vec<DisplayEvent>) -> io::Result<()>;

    /// Whether frames are to be brought there by [`Display::show`]. Elsewhere the SPUs write to
    /// what is seen.
    fn draws(&self) -> bool;

    /// Brings a frame before the player's eyes.
    fn show(&mut self, picture: &RgbImage, overlay: Option<&Overlay>) -> io::Result<()>;
}

/// Why a display can't be had.
#[derive(Debug, thiserror::Error)]
pub enum DisplayError {
    /// There is none of that kind.
    #[error("no {kind}: {why}")]
    None {
        /// Which.
        kind: &'static str,
        /// Why.
        why: String,
    },
    /// The framebuffer refuses.
    #[error(transparent)]
    Framebuffer(#[from] FramebufferError),
}
