//! A window on a desktop.
//!
//! Invariants: every key and button of the window becomes an event, in order, however long a frame takes: the
//! window's events are taken in while a frame is traced, too.

mod draw;
mod keys;

use std::io;
use std::num::NonZeroU32;
use std::rc::Rc;
use std::time::Duration;

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry};
use cellray::game::{InputEvent, MouseButton};
use winit::application::ApplicationHandler;
use winit::dpi::PhysicalSize;
use winit::event::{DeviceEvent, DeviceId, ElementState, MouseScrollDelta, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop};
use winit::keyboard::PhysicalKey;
use winit::platform::pump_events::{EventLoopExtPumpEvents as _, PumpStatus};
use winit::window::{Window as Winit, WindowId};

use self::keys::HeldElsewhere;
use super::{Display, DisplayError, Fit, Happening, Pointer};
use crate::canvas::{Picture, Shown};
use crate::overlay::Overlay;

/// What a touchpad scrolls for one notch of a wheel, in pixels.
const PIXELS_A_NOTCH: f64 = 40.0;
/// Least width and height: less shows nothing.
const LEAST: u32 = 64;

type Surface = softbuffer::Surface<Rc<Winit>, Rc<Winit>>;

/// A window.
pub struct Window {
    events: EventLoop<()>,
    state: State,
    shown: Shown,
}

/// What the window's events are handed to.
struct State {
    title: String,
    wanted: PhysicalSize<u32>,
    /// Once the system has made it.
    open: Option<(Rc<Winit>, Surface)>,
    failed: Option<String>,
    area: PhysicalSize<u32>,
    pointer: Pointer,
    keys: HeldElsewhere,
    happenings: Vec<Happening>,
}

impl Window {
    /// Whether there is a display server.
    #[must_use]
    pub fn is_possible() -> bool {
        is_wayland() || is_set("DISPLAY")
    }

    /// Opens one.
    pub fn open(title: &str, size: Geometry) -> Result<Self, DisplayError> {
        let none = |why: String| DisplayError::None {
            kind: "window",
            why,
        };
        let has_xkb = || xkbcommon_dl::xkbcommon_option().is_some();
        let has_xkb_of_x11 = || xkbcommon_dl::x11::xkbcommon_x11_option().is_some();
        if let Some(library) = missing_library(!is_wayland(), has_xkb, has_xkb_of_x11) {
            return Err(none(format!("{library} is not installed")));
        }
        let mut events = EventLoop::new().map_err(|error| none(error.to_string()))?;
        events.set_control_flow(ControlFlow::Poll);
        let wanted = PhysicalSize::new(size.width, size.height);
        let mut state = State {
            title: title.to_owned(),
            wanted,
            open: None,
            failed: None,
            area: wanted,
            pointer: Pointer::default(),
            keys: HeldElsewhere::default(),
            happenings: Vec::new(),
        };
        // The first events are those that make the window.
        let status = events.pump_app_events(Some(Duration::from_secs(5)), &mut state);
        if let Some(why) = state.failed.take() {
            return Err(none(why));
        }
        if state.open.is_none() || matches!(status, PumpStatus::Exit(_)) {
            return Err(none("the display server has made none".to_owned()));
        }
        Ok(Self {
            events,
            state,
            shown: Shown::default(),
        })
    }
}

impl State {
    fn open(&mut self, system: &ActiveEventLoop) -> Result<(), Box<dyn std::error::Error>> {
        let attributes = Winit::default_attributes()
            .with_title(self.title.as_str())
            .with_inner_size(self.wanted)
            .with_min_inner_size(PhysicalSize::new(LEAST, LEAST));
        let window = Rc::new(system.create_window(attributes)?);
        let context = softbuffer::Context::new(Rc::clone(&window))?;
        let surface = Surface::new(&context, Rc::clone(&window))?;
        let size = window.inner_size();
        if size.width > 0 && size.height > 0 {
            self.area = size;
        }
        self.open = Some((window, surface));
        Ok(())
    }

    fn refit(&mut self, picture: (u32, u32)) {
        let area = (self.area.width, self.area.height);
        self.pointer.refit(Fit::new(picture, area));
    }

    fn input(&mut self, event: InputEvent) {
        self.happenings.push(Happening::Input(event));
    }
}

impl ApplicationHandler for State {
    fn resumed(&mut self, system: &ActiveEventLoop) {
        if self.open.is_none()
            && let Err(error) = self.open(system)
        {
            self.failed = Some(error.to_string());
        }
    }

    fn window_event(&mut self, _: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested | WindowEvent::Destroyed => {
                self.happenings.push(Happening::Closed);
            }
            // One that is hidden may have no size.
            WindowEvent::Resized(size)
                if size.width > 0 && size.height > 0 && size != self.area =>
            {
                self.area = size;
                self.happenings.push(Happening::Resized);
            }
            WindowEvent::Focused(false) => self.input(InputEvent::FocusLost),
            WindowEvent::KeyboardInput {
                event,
                is_synthetic,
                ..
            } => {
                let down = event.state == ElementState::Pressed;
                if let PhysicalKey::Code(code) = event.physical_key
                    && let Some(key) = keys::key(code)
                    && self.keys.is_news(key, down, event.repeat, is_synthetic)
                {
                    self.input(InputEvent::Key { key, down });
                }
            }
            WindowEvent::CursorMoved { position, .. } => {
                let event = self.pointer.moved(position.x, position.y);
                self.input(event);
            }
            WindowEvent::CursorLeft { .. } => {
                let event = self.pointer.left();
                self.input(event);
            }
            WindowEvent::MouseInput { state, button, .. } => {
                if let Some(button) = mouse_button(button) {
                    let down = state == ElementState::Pressed;
                    self.input(InputEvent::MouseButton { button, down });
                }
            }
            WindowEvent::MouseWheel { delta, .. } => {
                let by = match delta {
                    MouseScrollDelta::LineDelta(x, y) => [x, y],
                    MouseScrollDelta::PixelDelta(by) => {
                        [by.x, by.y].map(|by| (by / PIXELS_A_NOTCH) as f32)
                    }
                };
                self.input(InputEvent::Wheel { by });
            }
            _ => {}
        }
    }

    fn device_event(&mut self, _: &ActiveEventLoop, _: DeviceId, event: DeviceEvent) {
        if let DeviceEvent::MouseMotion { delta: (x, y) } = event {
            let by = [x as f32, y as f32];
            self.input(InputEvent::MouseMotion { by });
        }
    }
}

impl Display for Window {
    fn area(&self) -> Geometry {
        let side = |side: u32| side.clamp(1, Geometry::MAX_SIDE);
        Geometry {
            width: side(self.state.area.width),
            height: side(self.state.area.height),
        }
    }

    fn scales(&self) -> bool {
        true
    }

    fn framebuffer(&mut self, size: Geometry) -> Result<Box<dyn Framebuffer>, FramebufferError> {
        self.state.refit((size.width, size.height));
        Ok(Box::new(self.shown.canvas(size)?))
    }

    fn poll(&mut self, happenings: &mut Vec<Happening>) -> io::Result<()> {
        let pumped = self
            .events
            .pump_app_events(Some(Duration::ZERO), &mut self.state);
        happenings.append(&mut self.state.happenings);
        happenings.extend(self.state.pointer.again().map(Happening::Input));
        if let PumpStatus::Exit(_) = pumped {
            happenings.push(Happening::Closed);
        }
        Ok(())
    }

    fn show(&mut self, overlay: Option<&Overlay>) -> io::Result<()> {
        let picture = self.shown.picture();
        self.state.refit((picture.width, picture.height));
        let fit = self.state.pointer.fit();
        let State { open, area, .. } = &mut self.state;
        let Some((window, surface)) = open else {
            return Ok(());
        };
        let (Some(width), Some(height)) =
            (NonZeroU32::new(area.width), NonZeroU32::new(area.height))
        else {
            return Ok(());
        };
        surface.resize(width, height).map_err(failed)?;
        let mut buffer = surface.buffer_mut().map_err(failed)?;
        paint(&picture, fit, &mut buffer, area.width as usize);
        if let Some(overlay) = overlay {
            draw::draw(overlay, &mut buffer, area.width as usize);
        }
        window.pre_present_notify();
        buffer.present().map_err(failed)
    }

    fn picture(&self) -> Option<Picture> {
        Some(self.shown.picture().clone())
    }
}

fn is_set(variable: &str) -> bool {
    std::env::var_os(variable).is_some_and(|value| !value.is_empty())
}

/// Whether windows are of Wayland: it goes before X11.
fn is_wayland() -> bool {
    is_set("WAYLAND_DISPLAY") || is_set("WAYLAND_SOCKET")
}

/// A library that winit loads for the keyboard once it has a display server, and panics without.
fn missing_library(
    is_x11: bool,
    has_xkb: impl Fn() -> bool,
    has_xkb_of_x11: impl Fn() -> bool,
) -> Option<&'static str> {
    if !has_xkb() {
        Some("libxkbcommon.so.0")
    } else if is_x11 && !has_xkb_of_x11() {
        Some("libxkbcommon-x11.so.0")
    } else {
        None
    }
}

/// Paints the picture, each pixel as the one of the picture that lies there.
fn paint(picture: &Picture, fit: Fit, pixels: &mut [u32], width: usize) {
    let columns: Vec<_> = (0..width as u32).map(|x| fit.column(x)).collect();
    for (y, row) in (0..).zip(pixels.chunks_exact_mut(width)) {
        let source = fit.row(y).map(|y| {
            let start = y as usize * picture.width as usize;
            &picture.pixels[start..start + picture.width as usize]
        });
        for (pixel, column) in row.iter_mut().zip(&columns) {
            let shown = source.zip(*column).map(|(row, x)| row[x as usize]);
            let [red, green, blue] = shown.unwrap_or_default();
            *pixel = u32::from_be_bytes([0, red, green, blue]);
        }
    }
}

/// Its own error can't be handed between threads, as one of the system's can.
fn failed(error: softbuffer::SoftBufferError) -> io::Error {
    io::Error::other(error.to_string())
}

fn mouse_button(button: winit::event::MouseButton) -> Option<MouseButton> {
    use winit::event::MouseButton as Winit;
    match button {
        Winit::Left => Some(MouseButton::Left),
        Winit::Right => Some(MouseButton::Right),
        Winit::Middle => Some(MouseButton::Middle),
        Winit::Back => Some(MouseButton::Back),
        Winit::Forward => Some(MouseButton::Forward),
        Winit::Other(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_desktop_without_the_libraries_of_keyboards_is_told_of() {
        let (there, missing) = (|| true, || false);
        assert_eq!(missing_library(true, there, there), None);
        assert_eq!(missing_library(false, there, missing), None);
        let x11 = missing_library(true, there, missing);
        assert_eq!(x11, Some("libxkbcommon-x11.so.0"));
        for is_x11 in [true, false] {
            let both = missing_library(is_x11, missing, missing);
            assert_eq!(both, Some("libxkbcommon.so.0"));
        }
    }

    #[test]
    fn a_picture_is_painted_large_with_bars_beside_it() {
        let picture = Picture {
            width: 2,
            height: 1,
            pixels: vec![[1, 2, 3], [4, 5, 6]],
        };
        let mut pixels = [7; 24];
        paint(&picture, Fit::new((2, 1), (4, 6)), &mut pixels, 4);
        let (left, right) = (0x0001_0203, 0x0004_0506);
        for (y, row) in pixels.chunks_exact(4).enumerate() {
            let shown = [left, left, right, right];
            assert_eq!(row, if (2..4).contains(&y) { shown } else { [0; 4] });
        }
    }
}
