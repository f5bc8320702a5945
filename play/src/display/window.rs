//! A window on a desktop.
//!
//! Invariant: every key and button of the window becomes an event, in order, however long a frame
//! takes, because the window's events are also read while a frame is traced.

mod keys;

use std::io;
use std::num::NonZeroU32;
use std::panic::{self, AssertUnwindSafe};
use std::rc::Rc;
use std::time::Duration;

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry, Memory, PixelFormat};
use cellray::game::{InputEvent, MouseButton};
use image::RgbImage;
use winit::application::ApplicationHandler;
use winit::dpi::PhysicalSize;
use winit::event::{DeviceEvent, DeviceId, ElementState, MouseScrollDelta, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop};
use winit::keyboard::PhysicalKey;
use winit::platform::pump_events::{EventLoopExtPumpEvents as _, PumpStatus};
use winit::window::{Fullscreen, Window as Winit, WindowId};

use self::keys::HeldElsewhere;
use super::text::paint::{Canvas, Painter};
use super::{Display, DisplayError, DisplayEvent, Enlarged, Fit, Pointer};
use crate::overlay::Overlay;

/// The pixels of a touchpad's scrolling that count as one notch of a wheel.
const PIXELS_A_NOTCH: f64 = 40.0;
/// The minimum width and height in pixels; smaller windows show nothing useful.
const MIN_SIDE: u32 = 64;

/// The channels of a window's words, which have red, green and blue in their lowest bytes.
const FORMAT: PixelFormat = if cfg!(target_endian = "big") {
    PixelFormat::ARGB
} else {
    PixelFormat { red_shift: 8, green_shift: 16, blue_shift: 24 }
};

type Surface = softbuffer::Surface<Rc<Winit>, Rc<Winit>>;

pub struct Window {
    events: EventLoop<()>,
    state: State,
    painter: Painter,
}

/// The state that the window's events change.
struct State {
    title: String,
    wanted: PhysicalSize<u32>,
    /// `None` until the system has made the window.
    open: Option<(Rc<Winit>, Surface)>,
    failed: Option<String>,
    area: PhysicalSize<u32>,
    /// The width and height in whose pixels the mouse's positions are.
    measure: (u32, u32),
    pointer: Pointer,
    keys: HeldElsewhere,
    display_events: Vec<DisplayEvent>,
}

impl Window {
    /// Whether there is a display server.
    #[must_use]
    pub fn is_possible() -> bool {
        is_wayland() || is_set("DISPLAY")
    }

    /// Opens a window with a title and an initial size.
    ///
    /// # Errors
    /// There is no display server, it refuses, or a library is missing.
    pub fn open(title: &str, size: Geometry) -> Result<Self, DisplayError> {
        let none = |why: &str| DisplayError::None { kind: "window", why: why.to_owned() };
        let refused = |why: &str| {
            let server = server(|variable| std::env::var(variable).ok());
            none(&format!(
                "{server}: {}; --display terminal needs no display server",
                without_place(why)
            ))
        };
        let has_xkb = || xkbcommon_dl::xkbcommon_option().is_some();
        let has_xkb_of_x11 = || xkbcommon_dl::x11::xkbcommon_x11_option().is_some();
        if let Some(library) = missing_library(!is_wayland(), has_xkb, has_xkb_of_x11) {
            return Err(none(&format!("{library} is not installed")));
        }
        if std::env::var("WAYLAND_SOCKET").is_ok_and(|number| !is_open_file(&number)) {
            return Err(refused("there is no open file with this number"));
        }
        let events = catch_panics(|| EventLoop::new().map_err(|error| error.to_string()));
        let mut events = events.map_err(|why| refused(&why))?;
        events.set_control_flow(ControlFlow::Poll);
        let wanted = PhysicalSize::new(size.width, size.height);
        let mut state = State {
            title: title.to_owned(),
            wanted,
            open: None,
            failed: None,
            area: wanted,
            measure: wanted.into(),
            pointer: Pointer::default(),
            keys: HeldElsewhere::default(),
            display_events: Vec::new(),
        };
        // The window is made when the first events are handled.
        let patience = Some(Duration::from_secs(5));
        let status = catch_panics(|| Ok(events.pump_app_events(patience, &mut state)));
        let status = status.map_err(|why| refused(&why))?;
        if let Some(why) = state.failed.take() {
            return Err(refused(&why));
        }
        if state.open.is_none() || matches!(status, PumpStatus::Exit(_)) {
            return Err(refused("the display server has not made a window"));
        }
        Ok(Self { events, state, painter: Painter::default() })
    }
}

impl State {
    fn open(&mut self, system: &ActiveEventLoop) -> Result<(), Box<dyn std::error::Error>> {
        let attributes = Winit::default_attributes()
            .with_title(self.title.as_str())
            .with_inner_size(self.wanted)
            .with_min_inner_size(PhysicalSize::new(MIN_SIDE, MIN_SIDE));
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

    fn refit(&mut self) {
        let area = (self.area.width, self.area.height);
        self.pointer.refit(Fit::new(self.measure, area));
    }

    fn input(&mut self, event: InputEvent) {
        self.display_events.push(DisplayEvent::Input(event));
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
                self.display_events.push(DisplayEvent::Closed);
            }
            // A hidden window may have no size.
            WindowEvent::Resized(size)
                if size.width > 0 && size.height > 0 && size != self.area =>
            {
                self.area = size;
                self.refit();
                self.display_events.push(DisplayEvent::Resized);
            }
            WindowEvent::Focused(false) => self.input(InputEvent::FocusLost),
            WindowEvent::KeyboardInput { event, is_synthetic, .. } => {
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
        Geometry { width: side(self.state.area.width), height: side(self.state.area.height) }
    }

    fn scales(&self) -> bool {
        true
    }

    fn measure_in(&mut self, size: Geometry) {
        self.state.measure = (size.width, size.height);
        self.state.refit();
    }

    fn framebuffer(&mut self, size: Geometry) -> Result<Box<dyn Framebuffer>, FramebufferError> {
        Ok(Box::new(Memory::new(size)?))
    }

    fn poll(&mut self, display_events: &mut Vec<DisplayEvent>) -> io::Result<()> {
        let pumped = self.events.pump_app_events(Some(Duration::ZERO), &mut self.state);
        display_events.append(&mut self.state.display_events);
        display_events.extend(self.state.pointer.again().map(DisplayEvent::Input));
        if let PumpStatus::Exit(_) = pumped {
            display_events.push(DisplayEvent::Closed);
        }
        Ok(())
    }

    fn draws(&self) -> bool {
        true
    }

    fn show(&mut self, picture: &RgbImage, overlay: &Overlay) -> io::Result<()> {
        let State { open, area, measure, .. } = &mut self.state;
        let fit = Fit::new(*measure, (area.width, area.height)).filled_by(picture.dimensions());
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
        paint(picture, fit, &mut buffer, area.width as usize);
        let mut canvas = Canvas {
            words: &mut buffer,
            stride: area.width as usize,
            area: (area.width as usize, area.height as usize),
            format: FORMAT,
        };
        let [corner, size] = [fit.corner(), fit.size()].map(|(x, y)| (x as usize, y as usize));
        self.painter.paint(overlay, (corner, size), &mut canvas);
        window.pre_present_notify();
        buffer.present().map_err(failed)
    }

    fn change_full_screen(&mut self) {
        if let Some((window, _)) = &self.state.open {
            let is_full = window.fullscreen().is_some();
            window.set_fullscreen((!is_full).then_some(Fullscreen::Borderless(None)));
        }
    }
}

fn is_set(variable: &str) -> bool {
    std::env::var_os(variable).is_some_and(|value| !value.is_empty())
}

/// Whether Wayland is used, which has precedence over X11.
fn is_wayland() -> bool {
    is_set("WAYLAND_DISPLAY") || is_set("WAYLAND_SOCKET")
}

/// The display server's name: the environment variable that selects it, with its value.
fn server(value: impl Fn(&str) -> Option<String>) -> String {
    let named = ["WAYLAND_SOCKET", "WAYLAND_DISPLAY", "DISPLAY"].into_iter().find_map(|variable| {
        let value = value(variable).filter(|value| !value.is_empty())?;
        Some(format!("{variable}={value}"))
    });
    named.unwrap_or_else(|| "no display server is named by DISPLAY or WAYLAND_DISPLAY".to_owned())
}

/// Whether this is the number of an open file. The library would take any number for a connection,
/// and closing one that isn't open would end the program.
fn is_open_file(number: &str) -> bool {
    // SAFETY: F_GETFD only reads flags, for any number.
    let is_open = |number| unsafe { libc::fcntl(number, libc::F_GETFD) } != -1;
    number.is_empty() || number.parse().is_ok_and(is_open)
}

/// winit's message, without the place in its source code.
fn without_place(words: &str) -> &str {
    let place_and_words =
        words.strip_prefix("os error at ").and_then(|rest| rest.split_once(".rs:"));
    place_and_words.and_then(|(_, rest)| rest.split_once(": ")).map_or(words, |(_, words)| words)
}

/// Converts panics to errors: winit panics if a server lacks a feature that it needs.
fn catch_panics<T>(work: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| ()));
    let outcome = panic::catch_unwind(AssertUnwindSafe(work));
    panic::set_hook(hook);
    outcome.unwrap_or_else(|panic| {
        let words = panic.downcast_ref::<String>().map(String::as_str);
        let words = words.or_else(|| panic.downcast_ref::<&str>().copied());
        Err(words.unwrap_or("it lacks something").to_owned())
    })
}

/// The name of a missing library. winit loads these for the keyboard after it has connected to a
/// display server, and panics without them.
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

/// Paints the picture at its position on the display, enlarged smoothly if it is smaller there.
fn paint(picture: &RgbImage, fit: Fit, pixels: &mut [u32], width: usize) {
    let word = |[red, green, blue]: [u8; 3]| u32::from_be_bytes([0, red, green, blue]);
    let (left, top) = fit.corner();
    if let Some(size) = fit.enlarged() {
        let mut enlarged = Enlarged::new(picture, size);
        for (y, row) in (0..).zip(pixels.chunks_exact_mut(width)) {
            let shown = u32::checked_sub(y, top).map_or(&[][..], |y| enlarged.row(y));
            row.fill(0);
            for (pixel, &colour) in row.iter_mut().skip(left as usize).zip(shown) {
                *pixel = word(colour);
            }
        }
        return;
    }
    let colours = picture.as_chunks::<3>().0;
    let columns: Vec<_> = (0..width as u32).map(|x| fit.column(x)).collect();
    for (y, row) in (0..).zip(pixels.chunks_exact_mut(width)) {
        let source = fit.row(y).map(|y| {
            let across = picture.width() as usize;
            &colours[y as usize * across..][..across]
        });
        for (pixel, column) in row.iter_mut().zip(&columns) {
            let shown = source.zip(*column).map(|(row, x)| row[x as usize]);
            *pixel = word(shown.unwrap_or_default());
        }
    }
}

/// Converts softbuffer's error, which can't be sent between threads, to an I/O error.
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
    fn missing_keyboard_libraries_are_an_error() {
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
    fn display_server_is_named_by_its_variable() {
        let of = |pairs: &[(&str, &str)]| {
            server(|variable| {
                let mut found = pairs.iter().filter(|(name, _)| *name == variable);
                found.next().map(|(_, value)| (*value).to_owned())
            })
        };
        assert_eq!(of(&[("DISPLAY", ":7")]), "DISPLAY=:7");
        let wayland = of(&[("DISPLAY", ":7"), ("WAYLAND_DISPLAY", "wayland-1")]);
        assert_eq!(wayland, "WAYLAND_DISPLAY=wayland-1");
        let socket = of(&[("WAYLAND_SOCKET", "4"), ("WAYLAND_DISPLAY", "wayland-1")]);
        assert_eq!(socket, "WAYLAND_SOCKET=4");
        assert!(of(&[("DISPLAY", "")]).starts_with("no display server"));
    }

    #[test]
    fn inherited_connection_must_be_an_open_file() {
        assert!(is_open_file("0") || is_open_file("1"));
        assert!(!is_open_file("4242") && !is_open_file("none") && !is_open_file("-1"));
    }

    #[test]
    fn source_positions_are_removed_from_errors() {
        let place =
            "os error at /home/she/.cargo/registry/src/i-1/winit-0.30.13/src/a/mod.rs:765: ";
        let words = "Could not find: a compositor";
        assert_eq!(without_place(&format!("{place}{words}")), words);
        assert_eq!(without_place(words), words);
        assert_eq!(without_place("os error at the server"), "os error at the server");
    }

    #[test]
    fn panics_of_dependencies_are_errors() {
        let lacks = catch_panics::<()>(|| panic!("{} lacks it", "the server"));
        assert_eq!(lacks, Err("the server lacks it".to_owned()));
        let lacks = catch_panics::<()>(|| panic!("it lacks that"));
        assert_eq!(lacks, Err("it lacks that".to_owned()));
        assert_eq!(catch_panics(|| Ok(1)), Ok(1));
    }

    #[test]
    fn picture_is_painted_smoothly_with_bars_beside_it() {
        let picture = RgbImage::from_vec(2, 1, vec![0, 40, 80, 100, 140, 180]).expect("two pixels");
        let mut pixels = [7; 24];
        paint(&picture, Fit::new((2, 1), (4, 6)), &mut pixels, 4);
        // Red is 5.6, 24.1, 75.9 and 94.4 but for the rounding of the weights, and the other
        // channels are 40 and 80 brighter.
        let shown = [0x0005_2D55, 0x0018_4068, 0x004C_749C, 0x005F_87AF];
        for (y, row) in pixels.chunks_exact(4).enumerate() {
            assert_eq!(row, if (2..4).contains(&y) { shown } else { [0; 4] });
        }
        // Bars at the sides.
        let mut pixels = [7; 6];
        paint(&picture, Fit::new((2, 1), (6, 1)), &mut pixels, 6);
        assert_eq!(pixels, [0, 0, 0x0000_2850, 0x0064_8CB4, 0, 0]);
    }
}
