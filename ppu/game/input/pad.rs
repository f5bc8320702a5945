//! The state of one pad.

use serde::{Deserialize, Serialize};

use super::names::{Axis, Button, Name as _, Switches};

/// Number of a pad, the player's: 0 for the first. Who makes the events gives the lowest that is
/// free, so a pad that is plugged in again is its player's again.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
pub struct PadId(pub u32);

/// What the sensors of a pad say, such as a SIXAXIS'.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sensors {
    /// Acceleration to the right, up and towards the player, in g: 0, 1, 0 where it lies still.
    pub acceleration: [f32; 3],
    /// Turn to the left about the upright axis, in degrees a second.
    pub turn: f32,
}

impl Sensors {
    /// Whether all that they say are numbers.
    pub(crate) fn is_finite(&self) -> bool {
        let mut numbers = self.acceleration.iter().chain([&self.turn]);
        numbers.all(|number| number.is_finite())
    }
}

/// A pad.
#[derive(Clone, Debug, PartialEq)]
pub struct Pad {
    id: PadId,
    name: String,
    buttons: Switches<Button>,
    axes: [f32; Axis::ALL.len()],
    sensors: Option<Sensors>,
}

impl Pad {
    pub(super) fn new(id: PadId, name: &str) -> Self {
        Self {
            id,
            name: name.to_owned(),
            buttons: Switches::default(),
            axes: [0.0; Axis::ALL.len()],
            sensors: None,
        }
    }

    /// Its number.
    #[must_use]
    pub fn id(&self) -> PadId {
        self.id
    }

    /// What it calls itself.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether a button is down, or was within the frame.
    #[must_use]
    pub fn held(&self, button: Button) -> bool {
        self.buttons.held(button)
    }

    /// Whether a button went down in this frame.
    #[must_use]
    pub fn pressed(&self, button: Button) -> bool {
        self.buttons.pressed(button)
    }

    /// Whether a button went up in this frame.
    #[must_use]
    pub fn released(&self, button: Button) -> bool {
        self.buttons.released(button)
    }

    /// Where an axis is, -1 to 1.
    #[must_use]
    pub fn axis(&self, axis: Axis) -> f32 {
        self.axes[axis.number() as usize]
    }

    /// What its sensors say, if it has some.
    #[must_use]
    pub fn sensors(&self) -> Option<Sensors> {
        self.sensors
    }

    pub(super) fn begin_frame(&mut self) {
        self.buttons.begin_frame();
    }

    pub(super) fn let_go(&mut self) {
        self.buttons.let_go();
        self.axes = [0.0; Axis::ALL.len()];
    }

    pub(super) fn set_button(&mut self, button: Button, down: bool) {
        self.buttons.set(button, down);
    }

    pub(super) fn set_axis(&mut self, axis: Axis, value: f32) {
        if value.is_finite() {
            self.axes[axis.number() as usize] = value.clamp(-1.0, 1.0);
        }
    }

    pub(super) fn set_sensors(&mut self, sensors: Sensors) {
        if sensors.is_finite() {
            self.sensors = Some(sensors);
        }
    }
}
