//! A terminal with colours, possibly over ssh. Each character shows two pixels, one above the
//! other.
//!
//! Known weakness: most terminals don't report when a key is released; see [`keys`].

mod cells;
mod events;
mod keys;
mod restore;
mod texts;

use std::io::{self, IsTerminal as _, Write as _};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry, Memory};
use cellray::game::{InputEvent, MouseButton};
use crossterm::event::{self, Event, KeyCode, KeyModifiers, MouseEventKind};
use image::RgbImage;
use signal_hook::consts::SIGWINCH;
use signal_hook::flag;

pub use self::cells::{Colours, lines};

use self::cells::Grid;
use self::events::Events;
use self::keys::Keys;
use self::restore::TerminalGuard;
use self::texts::texts;
use super::{Display, DisplayError, DisplayEvent, Enlarged, Fit, Pointer};
use crate::overlay::Overlay;

/// Columns and rows if the system reports no size.
const DEFAULT: (u16, u16) = (80, 24);
/// The most columns and rows; no real terminal has more.
const MAX_CELLS: u16 = 1000;
/// The width and height of a character in pixels, for games that use the mouse's motion. Most
/// fonts are about this size.
const CHARACTER: [f32; 2] = [8.0, 16.0];

/// The terminal of the program.
pub struct Terminal {
    /// Columns and rows of the terminal.
    cells: (u16, u16),
    is_resized: Arc<AtomicBool>,
    /// The width and height in whose pixels the mouse's positions are.
    measure: (u32, u32),
    pointer: Pointer,
    grid: Grid,
    events: Events,
    keys: Keys,
    /// The column and row where the mouse was last.
    mouse: Option<(u16, u16)>,
    has_pictures: bool,
    /// Whether the terminal has hung up.
    is_gone: bool,
    // Dropped last, because the other fields may still write to the terminal.
    taken: TerminalGuard,
}

impl Terminal {
    /// Whether the program has a terminal that can show pictures.
    #[must_use]
    pub fn is_possible() -> bool {
        io::stdout().is_terminal() && io::stdin().is_terminal()
    }

    /// Takes over the terminal for pictures.
    ///
    /// # Errors
    /// Standard input or output isn't a terminal, or the terminal can't be changed.
    pub fn open() -> Result<Self, DisplayError> {
        Self::take(true)
    }

    /// Takes over only the terminal's keys, for a picture on another display. Keys are neither
    /// echoed nor left for the shell.
    ///
    /// # Errors
    /// As for [`Terminal::open`].
    pub fn keys_only() -> Result<Self, DisplayError> {
        Self::take(false)
    }

    fn take(has_pictures: bool) -> Result<Self, DisplayError> {
        let none = |why: String| DisplayError::None { kind: "terminal", why };
        let there = io::stdin().is_terminal() && (io::stdout().is_terminal() || !has_pictures);
        if !there {
            return Err(none("standard input or output is not a terminal".to_owned()));
        }
        let is_resized = Arc::new(AtomicBool::new(false));
        let opened = || {
            flag::register(SIGWINCH, Arc::clone(&is_resized))?;
            Ok((TerminalGuard::take(has_pictures)?, Events::read()?))
        };
        let (taken, events) = opened().map_err(|error: io::Error| none(error.to_string()))?;
        Ok(Self {
            cells: size(),
            is_resized,
            measure: (1, 1),
            pointer: Pointer::default(),
            grid: Grid::new(Colours::of_environment()),
            events,
            keys: Keys::default(),
            mouse: None,
            has_pictures,
            is_gone: false,
            taken,
        })
    }

    fn fit(&self) -> Fit {
        let Geometry { width, height } = self.area();
        Fit::new(self.measure, (width, height))
    }

    fn refit(&mut self) {
        self.pointer.refit(self.fit());
    }

    fn take_in(&mut self, event: Event, at: Instant, display_events: &mut Vec<DisplayEvent>) {
        if let Event::Key(key) = event
            && key.modifiers.contains(KeyModifiers::CONTROL)
        {
            // In raw mode the terminal doesn't turn these keys into signals.
            match key.code {
                KeyCode::Char('c') => return display_events.push(DisplayEvent::Interrupted),
                KeyCode::Char('d') => return display_events.push(DisplayEvent::Closed),
                _ => {}
            }
        }
        let mut input = |event| display_events.push(DisplayEvent::Input(event));
        match event {
            Event::Key(key) => self.keys.take(key, at, &mut input),
            Event::Mouse(mouse) => {
                // The centre of the character.
                let (x, y) = (f64::from(mouse.column) + 0.5, f64::from(mouse.row) * 2.0 + 1.0);
                input(self.pointer.moved(x, y));
                let at = (mouse.column, mouse.row);
                if let Some(by) = self.mouse.replace(at).and_then(|from| way(from, at)) {
                    input(InputEvent::MouseMotion { by });
                }
                match mouse.kind {
                    MouseEventKind::Down(button) => {
                        input(InputEvent::MouseButton { button: mouse_button(button), down: true })
                    }
                    MouseEventKind::Up(button) => {
                        input(InputEvent::MouseButton { button: mouse_button(button), down: false })
                    }
                    MouseEventKind::ScrollUp => input(InputEvent::Wheel { by: [0.0, 1.0] }),
                    MouseEventKind::ScrollDown => input(InputEvent::Wheel { by: [0.0, -1.0] }),
                    MouseEventKind::ScrollLeft => input(InputEvent::Wheel { by: [-1.0, 0.0] }),
                    MouseEventKind::ScrollRight => input(InputEvent::Wheel { by: [1.0, 0.0] }),
                    MouseEventKind::Moved | MouseEventKind::Drag(_) => {}
                }
            }
            Event::FocusLost => {
                self.keys.forget();
                self.mouse = None;
                input(InputEvent::FocusLost);
            }
            // A signal reports a new size too, even while the reader waits for the rest of an
            // event.
            Event::Resize(..) | Event::FocusGained => {}
        }
    }
}

impl Display for Terminal {
    fn area(&self) -> Geometry {
        let (columns, rows) = self.cells;
        Geometry { width: u32::from(columns), height: 2 * u32::from(rows) }
    }

    fn scales(&self) -> bool {
        true
    }

    fn measure_in(&mut self, size: Geometry) {
        self.measure = (size.width, size.height);
        self.refit();
    }

    fn framebuffer(&mut self, size: Geometry) -> Result<Box<dyn Framebuffer>, FramebufferError> {
        Ok(Box::new(Memory::new(size)?))
    }

    fn poll(&mut self, display_events: &mut Vec<DisplayEvent>) -> io::Result<()> {
        let is_back = self.taken.was_retaken();
        if self.is_resized.swap(false, Ordering::SeqCst) || is_back {
            // A terminal that was made smaller and larger again has lost its contents.
            self.grid.forget();
            self.cells = size();
            self.refit();
            display_events.push(DisplayEvent::Resized);
        }
        if is_back {
            self.take_in(Event::FocusLost, Instant::now(), display_events);
        }
        loop {
            match self.events.next() {
                Ok(Some((event, at))) => self.take_in(event, at, display_events),
                Ok(None) => break,
                Err(_) => {
                    self.is_gone = true;
                    break;
                }
            }
        }
        // If the picture is on another display, the session continues without keys.
        if self.is_gone && self.has_pictures {
            display_events.push(DisplayEvent::HungUp);
        }
        display_events.extend(self.pointer.again().map(DisplayEvent::Input));
        self.keys.release_silent(Instant::now(), &mut |event| {
            display_events.push(DisplayEvent::Input(event));
        });
        Ok(())
    }

    fn draws(&self) -> bool {
        self.has_pictures
    }

    fn show(&mut self, picture: &RgbImage, overlay: &Overlay) -> io::Result<()> {
        let fit = self.fit().filled_by(picture.dimensions());
        let enlarged = fit.enlarged().map(|size| Enlarged::new(picture, size).all());
        let picture = enlarged.as_ref().unwrap_or(picture);
        let fit = fit.filled_by(picture.dimensions());
        let texts = texts(overlay, self.cells, fit);
        let text = self.grid.draw(picture, fit, self.cells, &texts);
        let mut out = io::stdout().lock();
        match out.write_all(text).and_then(|()| out.flush()) {
            // The system's error for a terminal that has hung up.
            Err(error) if error.raw_os_error() == Some(libc::EIO) => {
                self.is_gone = true;
                Ok(())
            }
            written => written,
        }
    }
}

/// The terminal's columns and rows; those of a usual terminal if it doesn't report any, as over a
/// serial line.
pub fn size() -> (u16, u16) {
    let (columns, rows) = crossterm::terminal::size().unwrap_or(DEFAULT);
    if columns == 0 || rows == 0 { DEFAULT } else { (columns.min(MAX_CELLS), rows.min(MAX_CELLS)) }
}

/// The motion of the mouse from one character to another, in pixels; `None` if it did not move.
fn way(from: (u16, u16), to: (u16, u16)) -> Option<[f32; 2]> {
    let along = |from: u16, to: u16, pixels: f32| (f32::from(to) - f32::from(from)) * pixels;
    let [width, height] = CHARACTER;
    (from != to).then(|| [along(from.0, to.0, width), along(from.1, to.1, height)])
}

fn mouse_button(button: event::MouseButton) -> MouseButton {
    match button {
        event::MouseButton::Left => MouseButton::Left,
        event::MouseButton::Right => MouseButton::Right,
        event::MouseButton::Middle => MouseButton::Middle,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mouse_steps_on_characters_are_pixels() {
        assert_eq!(way((3, 4), (3, 4)), None);
        assert_eq!(way((3, 4), (5, 3)), Some([16.0, -16.0]));
        assert_eq!(way((u16::MAX, 0), (0, 0)), Some([-8.0 * 65535.0, 0.0]));
    }
}
