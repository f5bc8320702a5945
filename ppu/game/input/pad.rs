//! The state of one pad.

use serde::{Deserialize, Serialize};

use super::names::{Axis, Button, Name as _, Switches};

/// The largest value of a stick at rest.
const DEAD: f64 = 0.15;

/// The number of a pad, which is also its player's: 0 for the first. The source of the events
/// assigns the lowest free number, so the pad of a player who plugs it in again keeps its number.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
pub struct PadId(pub u32);

/// The readings of a pad's sensors, such as a SIXAXIS'.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sensors {
    /// Acceleration to the right, up and towards the player, in g: 0, 1, 0 for a pad at rest.
    pub acceleration: [f32; 3],
    /// Turn to the left about the vertical axis, in degrees a second.
    pub turn: f32,
}

impl Sensors {
    pub(crate) fn is_finite(&self) -> bool {
        let mut numbers = self.acceleration.iter().chain([&self.turn]);
        numbers.all(|number| number.is_finite())
    }
}

/// The state of a connected pad.
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

    /// The pad's number.
    #[must_use]
    pub fn id(&self) -> PadId {
        self.id
    }

    /// The name that the pad reports.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether a button is down, or was down within this frame.
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

    /// An axis' value, -1 to 1.
    #[must_use]
    pub fn axis(&self, axis: Axis) -> f32 {
        self.axes[axis.number() as usize]
    }

    /// An axis' value, where that of a stick at rest is 0.
    #[must_use]
    pub fn stick(&self, axis: Axis) -> f64 {
        let value = f64::from(self.axis(axis));
        if value.abs() < DEAD { 0.0 } else { value }
    }

    /// The sensors' last readings, or `None` if there were none yet.
    #[must_use]
    pub fn sensors(&self) -> Option<Sensors> {
        self.sensors
    }

    pub(super) fn begin_frame(&mut self) {
        self.buttons.begin_frame();
    }

    pub(super) fn release_all(&mut self) {
        self.buttons.release_all();
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
