//! Input devices of Linux: pads, keyboards and mice under `/dev/input`.
//!
//! Owns the meaning of devices' codes, and the assignment of pads to players. Has no part in
//! windows. Invariants: events keep each device's order. A device that vanishes causes an event
//! and a message, never an error. When the kernel has dropped events, the device's current state
//! is read, so that nothing is held forever.

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
