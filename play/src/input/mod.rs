//! Input devices of Linux: pads, keyboards and mice under `/dev/input`.
//!
//! Owns what a device's codes mean and which pad is which player's. Knows no window. Invariants: events come in
//! the order in which each device told them; a device that vanishes is an event and a message, never an error;
//! when the kernel has dropped events, everything counts as released rather than held for ever.

mod capabilities;
mod device;
mod foreground;
mod hotplug;
mod layout;
mod mapping;

pub use capabilities::{Capabilities, Codes};
pub use device::{Device, Devices, Range, RawEvent, SystemDevices};
pub use foreground::{Foreground, SystemForeground};
pub use hotplug::{Hub, Wanted};
pub use mapping::{Kind, Mapping};
