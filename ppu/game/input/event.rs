//! Events of input devices.

use serde::{Deserialize, Serialize};

use super::names::{Axis, Button, Key, MouseButton};
use super::pad::{PadId, Sensors};

/// An event of an input device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum InputEvent {
    /// A key went down or up. A held key's automatic repetitions are not events.
    Key {
        /// The key.
        key: Key,
        /// Whether it is down now.
        down: bool,
    },
    /// The pointer moved within the picture.
    MouseMoved {
        /// The new position in pixels from the picture's top left.
        to: [f32; 2],
    },
    /// The pointer left the picture.
    MouseLeft,
    /// The mouse was moved, wherever the pointer is.
    MouseMotion {
        /// The motion to the right and down, in the device's own unit.
        by: [f32; 2],
    },
    /// A button of the mouse went down or up.
    MouseButton {
        /// The button.
        button: MouseButton,
        /// Whether it is down now.
        down: bool,
    },
    /// The wheel was turned.
    Wheel {
        /// The motion to the right and away from the player, in notches.
        by: [f32; 2],
    },
    /// The input focus was lost: nothing counts as held any more.
    FocusLost,
    /// A pad was plugged in, or was connected from the start.
    PadConnected {
        /// The pad's number.
        pad: PadId,
        /// The name that the pad reports.
        name: String,
    },
    /// A pad was unplugged.
    PadDisconnected {
        /// The pad's number.
        pad: PadId,
    },
    /// A button of a pad went down or up.
    PadButton {
        /// The pad's number.
        pad: PadId,
        /// The button.
        button: Button,
        /// Whether it is down now.
        down: bool,
    },
    /// An axis of a pad moved.
    PadAxis {
        /// The pad's number.
        pad: PadId,
        /// The axis.
        axis: Axis,
        /// The axis' new value, which is clamped to -1 to 1.
        value: f32,
    },
    /// A pad's sensors have new readings.
    PadSensors {
        /// The pad's number.
        pad: PadId,
        /// The new readings.
        sensors: Sensors,
    },
}

impl InputEvent {
    /// Whether all of the event's numbers are finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        match self {
            Self::MouseMoved { to: pair }
            | Self::MouseMotion { by: pair }
            | Self::Wheel { by: pair } => pair.iter().all(|value| value.is_finite()),
            Self::PadAxis { value, .. } => value.is_finite(),
            Self::PadSensors { sensors, .. } => sensors.is_finite(),
            _ => true,
        }
    }
}
