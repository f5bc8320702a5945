//! The displays, which show a game and read keys and mouse.
//!
//! Owns the interface between displays and the frame loop. Invariants: a display's changes of the
//! system are undone when it is dropped. Positions of the mouse are in pixels of the size that the
//! game uses, whatever the resolution of the picture and its size on the display.

mod fit;
mod none;
mod pointer;
mod scale;
mod screen;
mod terminal;
mod text;
#[cfg_attr(any(target_arch = "powerpc64", not(feature = "window")), path = "no_window.rs")]
mod window;

pub use fit::Fit;
pub use none::NoDisplay;
pub use pointer::Pointer;
pub use scale::Enlarged;
pub use screen::Screen;
pub use terminal::{Colours, Terminal, lines, size as terminal_size};
pub use window::Window;

use std::io;

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry};
use cellray::game::InputEvent;
use image::RgbImage;

use crate::overlay::Overlay;

#[derive(Clone, Debug, PartialEq)]
pub enum DisplayEvent {
    Input(InputEvent),
    Resized,
    /// The player has closed the display.
    Closed,
    /// The player has typed Ctrl-C.
    Interrupted,
    /// The display's terminal has hung up.
    HungUp,
}

pub trait Display {
    /// The display's size in pixels.
    fn area(&self) -> Geometry;

    /// Whether the display also shows pictures of another size than its own.
    fn scales(&self) -> bool;

    /// Sets the size in whose pixels the mouse's positions are. The picture has its proportions.
    fn measure_in(&mut self, size: Geometry);

    /// The framebuffer that the SPUs write to, for pictures of this size.
    ///
    /// # Errors
    /// The framebuffer can't be made.
    fn framebuffer(&mut self, size: Geometry) -> Result<Box<dyn Framebuffer>, FramebufferError>;

    /// Appends the events since the last call. Does not wait.
    ///
    /// # Errors
    /// The display fails.
    fn poll(&mut self, display_events: &mut Vec<DisplayEvent>) -> io::Result<()>;

    /// Whether frames must be drawn with [`Display::show`]. If not, the SPUs write directly to the
    /// visible framebuffer.
    fn draws(&self) -> bool;

    /// Draws a frame and the overlay. A picture that is smaller than the display is enlarged
    /// smoothly.
    ///
    /// # Errors
    /// The display fails.
    fn show(&mut self, picture: &RgbImage, overlay: &Overlay) -> io::Result<()>;

    /// Sets the overlay of the next frames, on a display that the SPUs write to.
    fn print(&mut self, _overlay: &Overlay) {}

    /// Fills the screen, or no longer. Only windows can.
    fn change_full_screen(&mut self) {}
}

/// Why a display can't be opened.
#[derive(Debug, thiserror::Error)]
pub enum DisplayError {
    /// There is no display of this kind.
    #[error("no {kind}: {why}")]
    None {
        /// The kind of display that was requested.
        kind: &'static str,
        why: String,
    },
    /// The framebuffer failed.
    #[error(transparent)]
    Framebuffer(#[from] FramebufferError),
}
