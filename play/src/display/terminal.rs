//! A terminal with colours, such as one over ssh: each character shows two pixels, one above the other.
//!
//! Known weakness: most terminals don't tell when a key is released; see [`keys`].

mod cells;
mod keys;
mod restore;

use std::io::{self, IsTerminal as _, Write as _};
use std::time::Instant;

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry};
use cellray::game::{InputEvent, MouseButton};
use crossterm::event::{self, Event, KeyCode, KeyModifiers, MouseEventKind};

use self::cells::{Colours, Grid};
use self::keys::Keys;
use self::restore::Taken;
use super::{Display, DisplayError, Fit, Happening};
use crate::canvas::{Picture, Shown};
use crate::overlay::Overlay;

/// Where the system tells no size.
const DEFAULT: (u16, u16) = (80, 24);
/// Most columns and rows: more is none that anyone sees.
const MOST: u16 = 1000;

/// The terminal of the program.
pub struct Terminal {
    shown: Shown,
    /// Columns and rows.
    cells: (u16, u16),
    fit: Fit,
    grid: Grid,
    keys: Keys,
    has_pictures: bool,
    // Dropped last: all else may still write there.
    _taken: Taken,
}

impl Terminal {
    /// Whether the program has one to show pictures on.
    #[must_use]
    pub fn is_possible() -> bool {
        io::stdout().is_terminal() && io::stdin().is_terminal()
    }

    /// Takes the terminal over for pictures.
    pub fn open() -> Result<Self, DisplayError> {
        Self::take(true)
    }

    /// Takes its keys alone: what is seen is elsewhere, and no key is to be echoed or kept for the shell.
    pub fn keys_only() -> Result<Self, DisplayError> {
        Self::take(false)
    }

    fn take(has_pictures: bool) -> Result<Self, DisplayError> {
        let none = |why: String| DisplayError::None {
            kind: "terminal",
            why,
        };
        let there = io::stdin().is_terminal() && (io::stdout().is_terminal() || !has_pictures);
        if !there {
            return Err(none("standard input or output is none".to_owned()));
        }
        let taken = Taken::take(has_pictures).map_err(|error| none(error.to_string()))?;
        Ok(Self {
            shown: Shown::default(),
            cells: size(),
            fit: Fit::default(),
            grid: Grid::new(Colours::of_environment()),
            keys: Keys::default(),
            has_pictures,
            _taken: taken,
        })
    }

    fn take_in(&mut self, event: Event, happenings: &mut Vec<Happening>) {
        if let Event::Key(key) = event
            && key.modifiers.contains(KeyModifiers::CONTROL)
        {
            // What a terminal itself makes of them where keys come line by line.
            match key.code {
                KeyCode::Char('c') => return happenings.push(Happening::Interrupted),
                KeyCode::Char('d') => return happenings.push(Happening::Closed),
                _ => {}
            }
        }
        let mut input = |event| happenings.push(Happening::Input(event));
        match event {
            Event::Key(key) => self.keys.take(key, Instant::now(), &mut input),
            Event::Mouse(mouse) => {
                // The middle of the character.
                let (x, y) = (
                    f64::from(mouse.column) + 0.5,
                    f64::from(mouse.row) * 2.0 + 1.0,
                );
                input(match self.fit.place(x, y) {
                    Some(to) => InputEvent::MouseMoved { to },
                    None => InputEvent::MouseLeft,
                });
                match mouse.kind {
                    MouseEventKind::Down(button) => input(InputEvent::MouseButton {
                        button: mouse_button(button),
                        down: true,
                    }),
                    MouseEventKind::Up(button) => input(InputEvent::MouseButton {
                        button: mouse_button(button),
                        down: false,
                    }),
                    MouseEventKind::ScrollUp => input(InputEvent::Wheel { by: [0.0, 1.0] }),
                    MouseEventKind::ScrollDown => input(InputEvent::Wheel { by: [0.0, -1.0] }),
                    MouseEventKind::ScrollLeft => input(InputEvent::Wheel { by: [-1.0, 0.0] }),
                    MouseEventKind::ScrollRight => input(InputEvent::Wheel { by: [1.0, 0.0] }),
                    MouseEventKind::Moved | MouseEventKind::Drag(_) => {}
                }
            }
            Event::FocusLost => input(InputEvent::FocusLost),
            Event::Resize(..) => {
                self.cells = size();
                happenings.push(Happening::Resized);
            }
            Event::FocusGained => {}
        }
    }
}

impl Display for Terminal {
    fn area(&self) -> Geometry {
        let (columns, rows) = self.cells;
        Geometry {
            width: u32::from(columns),
            height: 2 * u32::from(rows),
        }
    }

    fn scales(&self) -> bool {
        true
    }

    fn framebuffer(&mut self, size: Geometry) -> Result<Box<dyn Framebuffer>, FramebufferError> {
        Ok(Box::new(self.shown.canvas(size)?))
    }

    fn poll(&mut self, happenings: &mut Vec<Happening>) -> io::Result<()> {
        while event::poll(std::time::Duration::ZERO)? {
            let event = event::read()?;
            self.take_in(event, happenings);
        }
        self.keys.let_go(Instant::now(), &mut |event| {
            happenings.push(Happening::Input(event));
        });
        Ok(())
    }

    fn show(&mut self, overlay: Option<&Overlay>) -> io::Result<()> {
        if !self.has_pictures {
            return Ok(());
        }
        let Geometry { width, height } = self.area();
        let picture = self.shown.picture();
        self.fit = Fit::new((picture.width, picture.height), (width, height));
        let line = overlay.map(Overlay::line);
        let text = self
            .grid
            .draw(&picture, self.fit, self.cells, line.as_deref());
        let mut out = io::stdout().lock();
        out.write_all(text)?;
        out.flush()
    }

    fn picture(&self) -> Option<Picture> {
        self.has_pictures.then(|| self.shown.picture().clone())
    }
}

/// Columns and rows of the terminal.
fn size() -> (u16, u16) {
    let (columns, rows) = crossterm::terminal::size().unwrap_or(DEFAULT);
    if columns == 0 || rows == 0 {
        DEFAULT
    } else {
        (columns.min(MOST), rows.min(MOST))
    }
}

fn mouse_button(button: event::MouseButton) -> MouseButton {
    match button {
        event::MouseButton::Left => MouseButton::Left,
        event::MouseButton::Right => MouseButton::Right,
        event::MouseButton::Middle => MouseButton::Middle,
    }
}
