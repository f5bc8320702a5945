//! What happened to an input device.

use serde::{Deserialize, Serialize};

use super::names::{Axis, Button, Key, MouseButton};
use super::pad::{PadId, Sensors};

/// Something that happened to an input device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum InputEvent {
    /// A key went down or up. Repetitions of a key that is held are none.
    Key {
        /// Which.
        key: Key,
        /// Whether it is down now.
        down: bool,
    },
    /// The mouse points there.
    MouseMoved {
        /// Pixels from the picture's left and top.
        to: [f32; 2],
    },
    /// The mouse points out of the picture.
    MouseLeft,
    /// The mouse was moved, wherever it points.
    MouseMotion {
        /// To the right and down.
        by: [f32; 2],
    },
    /// A button of the mouse went down or up.
    MouseButton {
        /// Which.
        button: MouseButton,
        /// Whether it is down now.
        down: bool,
    },
    /// The wheel was turned.
    Wheel {
        /// To the right and away from the player, in notches.
        by: [f32; 2],
    },
    /// Keys go elsewhere from now on: nothing counts as held.
    FocusLost,
    /// A pad was plugged in, or was there from the start.
    PadConnected {
        /// Its number.
        pad: PadId,
        /// What it calls itself.
        name: String,
    },
    /// A pad was unplugged.
    PadDisconnected {
        /// Its number.
        pad: PadId,
    },
    /// A button of a pad went down or up.
    PadButton {
        /// Which pad.
        pad: PadId,
        /// Which button.
        button: Button,
        /// Whether it is down now.
        down: bool,
    },
    /// An axis of a pad moved.
    PadAxis {
        /// Which pad.
        pad: PadId,
        /// Which axis.
        axis: Axis,
        /// Where it is now, -1 to 1; what is beyond is brought there.
        value: f32,
    },
    /// A pad was tilted.
    PadSensors {
        /// Which pad.
        pad: PadId,
        /// What its sensors say now.
        sensors: Sensors,
    },
}

impl InputEvent {
    /// Whether all that it says are numbers.
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
