//! Tables with the meaning of pads' and keyboards' codes.
//!
//! The SIXAXIS has two numberings, depending on the age of its driver. Other pads follow one of
//! these, the numbering of xpad, or that of generic joysticks. All keyboards and mice use the same
//! codes.

use cellray::game::{Axis, Button, Key, MouseButton};
use evdev::{AbsoluteAxisCode as Abs, KeyCode as Code};

use super::capabilities::Capabilities;

/// The meaning of a kind of pad's codes.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// The buttons.
    pub buttons: &'static [(Code, Button)],
    /// The sticks, and the analog triggers.
    pub axes: &'static [(Abs, Axis)],
}

/// The pad's layout, if the device is one.
#[must_use]
pub fn of_pad(device: &Capabilities) -> Option<Layout> {
    let has = |code: Code| device.keys.has(code.0);
    let axis = |axis: Abs| device.absolute.has(axis.0);
    if has(Code::BTN_SOUTH) {
        let lower = device.name.to_ascii_lowercase();
        // xpad gives all its pads these axes, and triggers that aren't buttons, whatever their
        // names.
        let is_like_xpad =
            axis(Abs::ABS_HAT0X) && axis(Abs::ABS_RX) && axis(Abs::ABS_Z) && !has(Code::BTN_TL2);
        let is_xpad = lower.contains("x-box") || lower.contains("xbox") || is_like_xpad;
        // This includes pads without a driver for Bluetooth.
        let has_stick_on_z = !axis(Abs::ABS_RX) && axis(Abs::ABS_Z) && axis(Abs::ABS_RZ);
        Some(Layout {
            buttons: if is_xpad { XPAD } else { FROM_SOUTH },
            axes: if has_stick_on_z { STICKS_ON_Z } else { STICKS_AND_TRIGGERS },
        })
    } else if has(Code::BTN_TRIGGER)
        && has(Code::BTN_TRIGGER_HAPPY1)
        && has(Code::BTN_DEAD)
        && device.name.contains("PLAYSTATION(R)3")
    {
        Some(Layout { buttons: OLD_SIXAXIS, axes: OLD_STICKS })
    } else if has(Code::BTN_TRIGGER) && axis(Abs::ABS_X) && axis(Abs::ABS_Y) {
        Some(Layout { buttons: JOYSTICK, axes: STICKS_ON_Z })
    } else {
        None
    }
}

/// The old driver also has other axes, which have no meaning.
const OLD_STICKS: &[(Abs, Axis)] = &[
    (Abs::ABS_X, Axis::LeftX),
    (Abs::ABS_Y, Axis::LeftY),
    (Abs::ABS_Z, Axis::RightX),
    (Abs::ABS_RZ, Axis::RightY),
];

/// hid-sony since Linux 4.13, and all drivers that name buttons by their places.
const FROM_SOUTH: &[(Code, Button)] = &[
    (Code::BTN_SOUTH, Button::Cross),
    (Code::BTN_EAST, Button::Circle),
    (Code::BTN_NORTH, Button::Triangle),
    (Code::BTN_WEST, Button::Square),
    (Code::BTN_TL, Button::L1),
    (Code::BTN_TR, Button::R1),
    (Code::BTN_TL2, Button::L2),
    (Code::BTN_TR2, Button::R2),
    (Code::BTN_SELECT, Button::Select),
    (Code::BTN_START, Button::Start),
    (Code::BTN_MODE, Button::Ps),
    (Code::BTN_THUMBL, Button::L3),
    (Code::BTN_THUMBR, Button::R3),
    (Code::BTN_DPAD_UP, Button::Up),
    (Code::BTN_DPAD_DOWN, Button::Down),
    (Code::BTN_DPAD_LEFT, Button::Left),
    (Code::BTN_DPAD_RIGHT, Button::Right),
];

const STICKS_AND_TRIGGERS: &[(Abs, Axis)] = &[
    (Abs::ABS_X, Axis::LeftX),
    (Abs::ABS_Y, Axis::LeftY),
    (Abs::ABS_RX, Axis::RightX),
    (Abs::ABS_RY, Axis::RightY),
    (Abs::ABS_Z, Axis::L2),
    (Abs::ABS_RZ, Axis::R2),
];

const STICKS_ON_Z: &[(Abs, Axis)] = &[
    (Abs::ABS_X, Axis::LeftX),
    (Abs::ABS_Y, Axis::LeftY),
    (Abs::ABS_Z, Axis::RightX),
    (Abs::ABS_RZ, Axis::RightY),
    (Abs::ABS_BRAKE, Axis::L2),
    (Abs::ABS_GAS, Axis::R2),
];

/// hid-sony up to Linux 4.12, which numbers the buttons in the order of the pad's report.
const OLD_SIXAXIS: &[(Code, Button)] = &[
    (Code::BTN_TRIGGER, Button::Select),
    (Code::BTN_THUMB, Button::L3),
    (Code::BTN_THUMB2, Button::R3),
    (Code::BTN_TOP, Button::Start),
    (Code::BTN_TOP2, Button::Up),
    (Code::BTN_PINKIE, Button::Right),
    (Code::BTN_BASE, Button::Down),
    (Code::BTN_BASE2, Button::Left),
    (Code::BTN_BASE3, Button::L2),
    (Code::BTN_BASE4, Button::R2),
    (Code::BTN_BASE5, Button::L1),
    (Code::BTN_BASE6, Button::R1),
    (Code(0x12c), Button::Triangle),
    (Code(0x12d), Button::Circle),
    (Code(0x12e), Button::Cross),
    (Code::BTN_DEAD, Button::Square),
    (Code::BTN_TRIGGER_HAPPY1, Button::Ps),
];

/// xpad, whose X and Y have each other's codes.
const XPAD: &[(Code, Button)] = &[
    (Code::BTN_SOUTH, Button::Cross),
    (Code::BTN_EAST, Button::Circle),
    (Code::BTN_NORTH, Button::Square),
    (Code::BTN_WEST, Button::Triangle),
    (Code::BTN_TL, Button::L1),
    (Code::BTN_TR, Button::R1),
    (Code::BTN_SELECT, Button::Select),
    (Code::BTN_START, Button::Start),
    (Code::BTN_MODE, Button::Ps),
    (Code::BTN_THUMBL, Button::L3),
    (Code::BTN_THUMBR, Button::R3),
    (Code::BTN_TRIGGER_HAPPY1, Button::Left),
    (Code::BTN_TRIGGER_HAPPY2, Button::Right),
    (Code::BTN_TRIGGER_HAPPY3, Button::Up),
    (Code::BTN_TRIGGER_HAPPY4, Button::Down),
];

/// A pad without its own driver. The numbering is the one that is printed on most such pads.
const JOYSTICK: &[(Code, Button)] = &[
    (Code::BTN_TRIGGER, Button::Square),
    (Code::BTN_THUMB, Button::Cross),
    (Code::BTN_THUMB2, Button::Circle),
    (Code::BTN_TOP, Button::Triangle),
    (Code::BTN_TOP2, Button::L1),
    (Code::BTN_PINKIE, Button::R1),
    (Code::BTN_BASE, Button::L2),
    (Code::BTN_BASE2, Button::R2),
    (Code::BTN_BASE3, Button::Select),
    (Code::BTN_BASE4, Button::Start),
    (Code::BTN_BASE5, Button::L3),
    (Code::BTN_BASE6, Button::R3),
];

/// Directional pads that are reported as axes: the axis, and the buttons at its two ends.
pub static HATS: [(Abs, Button, Button); 2] =
    [(Abs::ABS_HAT0X, Button::Left, Button::Right), (Abs::ABS_HAT0Y, Button::Up, Button::Down)];

/// The buttons of mice.
pub static MOUSE: [(Code, MouseButton); 7] = [
    (Code::BTN_LEFT, MouseButton::Left),
    (Code::BTN_RIGHT, MouseButton::Right),
    (Code::BTN_MIDDLE, MouseButton::Middle),
    (Code::BTN_SIDE, MouseButton::Back),
    (Code::BTN_BACK, MouseButton::Back),
    (Code::BTN_EXTRA, MouseButton::Forward),
    (Code::BTN_FORWARD, MouseButton::Forward),
];

/// The keys of keyboards.
pub static KEYS: [(Code, Key); 84] = [
    (Code::KEY_A, Key::A),
    (Code::KEY_B, Key::B),
    (Code::KEY_C, Key::C),
    (Code::KEY_D, Key::D),
    (Code::KEY_E, Key::E),
    (Code::KEY_F, Key::F),
    (Code::KEY_G, Key::G),
    (Code::KEY_H, Key::H),
    (Code::KEY_I, Key::I),
    (Code::KEY_J, Key::J),
    (Code::KEY_K, Key::K),
    (Code::KEY_L, Key::L),
    (Code::KEY_M, Key::M),
    (Code::KEY_N, Key::N),
    (Code::KEY_O, Key::O),
    (Code::KEY_P, Key::P),
    (Code::KEY_Q, Key::Q),
    (Code::KEY_R, Key::R),
    (Code::KEY_S, Key::S),
    (Code::KEY_T, Key::T),
    (Code::KEY_U, Key::U),
    (Code::KEY_V, Key::V),
    (Code::KEY_W, Key::W),
    (Code::KEY_X, Key::X),
    (Code::KEY_Y, Key::Y),
    (Code::KEY_Z, Key::Z),
    (Code::KEY_0, Key::Digit0),
    (Code::KEY_1, Key::Digit1),
    (Code::KEY_2, Key::Digit2),
    (Code::KEY_3, Key::Digit3),
    (Code::KEY_4, Key::Digit4),
    (Code::KEY_5, Key::Digit5),
    (Code::KEY_6, Key::Digit6),
    (Code::KEY_7, Key::Digit7),
    (Code::KEY_8, Key::Digit8),
    (Code::KEY_9, Key::Digit9),
    (Code::KEY_GRAVE, Key::Backquote),
    (Code::KEY_MINUS, Key::Minus),
    (Code::KEY_EQUAL, Key::Equal),
    (Code::KEY_LEFTBRACE, Key::BracketLeft),
    (Code::KEY_RIGHTBRACE, Key::BracketRight),
    (Code::KEY_BACKSLASH, Key::Backslash),
    (Code::KEY_SEMICOLON, Key::Semicolon),
    (Code::KEY_APOSTROPHE, Key::Quote),
    (Code::KEY_COMMA, Key::Comma),
    (Code::KEY_DOT, Key::Period),
    (Code::KEY_SLASH, Key::Slash),
    (Code::KEY_SPACE, Key::Space),
    (Code::KEY_ENTER, Key::Enter),
    (Code::KEY_KPENTER, Key::Enter),
    (Code::KEY_TAB, Key::Tab),
    (Code::KEY_BACKSPACE, Key::Backspace),
    (Code::KEY_ESC, Key::Escape),
    (Code::KEY_UP, Key::Up),
    (Code::KEY_DOWN, Key::Down),
    (Code::KEY_LEFT, Key::Left),
    (Code::KEY_RIGHT, Key::Right),
    (Code::KEY_INSERT, Key::Insert),
    (Code::KEY_DELETE, Key::Delete),
    (Code::KEY_HOME, Key::Home),
    (Code::KEY_END, Key::End),
    (Code::KEY_PAGEUP, Key::PageUp),
    (Code::KEY_PAGEDOWN, Key::PageDown),
    (Code::KEY_LEFTSHIFT, Key::Shift),
    (Code::KEY_RIGHTSHIFT, Key::Shift),
    (Code::KEY_LEFTCTRL, Key::Control),
    (Code::KEY_RIGHTCTRL, Key::Control),
    (Code::KEY_LEFTALT, Key::Alt),
    (Code::KEY_RIGHTALT, Key::Alt),
    (Code::KEY_F1, Key::F1),
    (Code::KEY_F2, Key::F2),
    (Code::KEY_F3, Key::F3),
    (Code::KEY_F4, Key::F4),
    (Code::KEY_F5, Key::F5),
    (Code::KEY_F6, Key::F6),
    (Code::KEY_F7, Key::F7),
    (Code::KEY_F8, Key::F8),
    (Code::KEY_F9, Key::F9),
    (Code::KEY_F10, Key::F10),
    (Code::KEY_F11, Key::F11),
    (Code::KEY_F12, Key::F12),
    (Code::KEY_KPPLUS, Key::Equal),
    (Code::KEY_KPMINUS, Key::Minus),
    (Code::KEY_102ND, Key::Backslash),
];
