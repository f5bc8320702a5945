//! Input devices of Linux: pads, keyboards and mice under `/dev/input`.
//!
//! Owns what a device's codes mean and which pad is which player's. Knows no window. Invariants:
//! events come in the order in which each device told them; a device that vanishes is an event and
//! a message, never an error; when the kernel has dropped events, the device is asked how it is
//! now: nothing is held for ever.

mod capabilities;
mod console;
mod device;
mod foreground;
mod hotplug;
mod layout;
mod mapping;

pub use capabilities::{Capabilities, Codes};
pub use console::is_of_console;
pub use device::{Device, Devices, Range, RawEvent, SystemDevices};
pub use foreground::{Foreground, SystemForeground};
pub use hotplug::{DeviceSet, InputDevices};
pub use mapping::{Kind, Mapping};
