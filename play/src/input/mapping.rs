//! Converts a device's events to a game's events, by the tables of its kind.

use std::collections::BTreeMap;
use std::io;

use cellray::game::{Axis, Button, InputEvent, PadId, Sensors};
use evdev::{AbsoluteAxisCode as Abs, EventType, KeyCode as Code, RelativeAxisCode as Rel};

use super::capabilities::{Capabilities, Codes};
use super::device::{Device, Range, RawEvent};
use super::layout::{self, HATS, KEYS, Layout, MOUSE};

/// A SIXAXIS' units in one g, if its driver doesn't report them.
const SIXAXIS_UNITS_A_G: f32 = 113.0;
/// The end of the name of a pad's sensors, which are a separate device.
const SENSORS: &str = " Motion Sensors";
/// EV_SYN's code for dropped events.
const SYN_DROPPED: u16 = 3;

/// The kind of a device.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// A pad.
    Pad(Layout),
    /// The sensors of a pad.
    Sensors,
    /// A keyboard, a mouse, or both.
    Desk,
}

impl Kind {
    /// The kind of the device, or `None` if games can't use it.
    #[must_use]
    pub fn of(device: &Capabilities) -> Option<Self> {
        let acceleration = [Abs::ABS_X, Abs::ABS_Y, Abs::ABS_Z];
        let is_mouse = device.relative.has(Rel::REL_X.0) && device.relative.has(Rel::REL_Y.0);
        if device.name.ends_with(SENSORS) {
            let has_all = acceleration.iter().all(|axis| device.absolute.has(axis.0));
            has_all.then_some(Self::Sensors)
        } else if let Some(layout) = layout::of_pad(device) {
            Some(Self::Pad(layout))
        } else if is_mouse && device.keys.has(Code::BTN_LEFT.0)
            || device.keys.has(Code::KEY_SPACE.0) && device.keys.has(Code::KEY_A.0)
        {
            Some(Self::Desk)
        } else {
            None
        }
    }
}

/// The name of the pad that the sensors with this name belong to.
#[must_use]
pub fn pad_of_sensors(name: &str) -> &str {
    name.strip_suffix(SENSORS).unwrap_or(name)
}

/// The meaning of one device's codes, and its last reports.
#[derive(Debug)]
pub struct Mapping {
    kind: Kind,
    /// The number of the pad that the device is, or that its sensors belong to.
    pad: Option<PadId>,
    ranges: BTreeMap<u16, Range>,
    /// The device's keys and buttons.
    keys: Codes,
    /// The keys and buttons that are down, according to its events.
    held: Codes,
    sensors: Sensors,
    /// Whether the sensors have changed since the last report.
    sensed: bool,
    motion: [f32; 2],
    wheel: [f32; 2],
    /// Whether the kernel has dropped events, so that all are ignored until the next report.
    dropped: bool,
    /// Whether events were dropped and the state must be read from the device.
    is_stale: bool,
}

impl Mapping {
    /// A mapping for a device of this kind, with these keys, and with the ranges of its axes.
    #[must_use]
    pub fn new(kind: Kind, pad: Option<PadId>, keys: Codes, ranges: BTreeMap<u16, Range>) -> Self {
        Self {
            kind,
            pad,
            ranges,
            keys,
            held: Codes::default(),
            sensors: Sensors { acceleration: [0.0, 1.0, 0.0], turn: 0.0 },
            sensed: false,
            motion: [0.0; 2],
            wheel: [0.0; 2],
            dropped: false,
            is_stale: false,
        }
    }

    /// The kind of the device.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The number of the pad that the device is, or that its sensors belong to.
    #[must_use]
    pub fn pad(&self) -> Option<PadId> {
        self.pad
    }

    /// Whether the device has a keyboard's keys.
    #[must_use]
    pub fn is_keyboard(&self) -> bool {
        matches!(self.kind, Kind::Desk) && self.keys.has(Code::KEY_A.0)
    }

    /// Appends the initial positions of the sticks, because devices report only changes.
    pub fn begin(&self, events: &mut Vec<InputEvent>) {
        for (&code, range) in &self.ranges {
            self.axis(code, range.value, events);
        }
    }

    /// After the kernel has dropped events, reads the device's state and appends the changes.
    ///
    /// # Errors
    /// The device is gone.
    pub fn catch_up(
        &mut self,
        device: &dyn Device,
        events: &mut Vec<InputEvent>,
    ) -> io::Result<()> {
        if !std::mem::take(&mut self.is_stale) {
            return Ok(());
        }
        let now = device.held()?;
        let changed = |code: &u16| now.has(*code) != self.held.has(*code);
        let changed: Vec<_> = self.keys.iter().filter(changed).collect();
        for code in changed {
            self.key(Code(code), i32::from(now.has(code)), events);
        }
        for (&axis, range) in &mut self.ranges {
            *range = device.range(axis)?;
        }
        self.begin(events);
        if matches!(self.kind, Kind::Sensors) {
            let axes: Vec<_> =
                self.ranges.iter().map(|(&axis, range)| (axis, range.value)).collect();
            for (axis, value) in axes {
                self.sense(Abs(axis), value);
            }
            self.report(events);
        }
        Ok(())
    }

    /// Converts an event, if it has a meaning.
    pub fn translate(&mut self, event: RawEvent, events: &mut Vec<InputEvent>) {
        let RawEvent { kind, code, value } = event;
        match EventType(kind) {
            EventType::SYNCHRONIZATION if code == SYN_DROPPED => self.dropped = true,
            EventType::SYNCHRONIZATION => self.report(events),
            // Until the next report, events are unreliable.
            _ if self.dropped => {}
            EventType::KEY => self.key(Code(code), value, events),
            EventType::ABSOLUTE => match self.kind {
                Kind::Sensors => self.sense(Abs(code), value),
                Kind::Pad(_) => self.axis(code, value, events),
                Kind::Desk => {}
            },
            EventType::RELATIVE => match Rel(code) {
                Rel::REL_X => self.motion[0] += value as f32,
                Rel::REL_Y => self.motion[1] += value as f32,
                Rel::REL_HWHEEL => self.wheel[0] += value as f32,
                Rel::REL_WHEEL => self.wheel[1] += value as f32,
                _ => {}
            },
            _ => {}
        }
    }

    fn report(&mut self, events: &mut Vec<InputEvent>) {
        self.is_stale |= std::mem::take(&mut self.dropped);
        let by = std::mem::take(&mut self.motion);
        if by != [0.0; 2] {
            events.push(InputEvent::MouseMotion { by });
        }
        let by = std::mem::take(&mut self.wheel);
        if by != [0.0; 2] {
            events.push(InputEvent::Wheel { by });
        }
        if let (true, Some(pad)) = (std::mem::take(&mut self.sensed), self.pad) {
            let sensors = self.sensors;
            events.push(InputEvent::PadSensors { pad, sensors });
        }
    }

    fn key(&mut self, code: Code, value: i32, events: &mut Vec<InputEvent>) {
        // 2 is the repetition of a held key.
        let down = match value {
            0 => false,
            1 => true,
            _ => return,
        };
        self.held.set(code.0, down);
        if let (Kind::Pad(layout), Some(pad)) = (self.kind, self.pad) {
            if let Some(&(_, button)) = layout.buttons.iter().find(|(known, _)| *known == code) {
                events.push(InputEvent::PadButton { pad, button, down });
            }
        } else if let Some(&(_, key)) = KEYS.iter().find(|(known, _)| *known == code) {
            events.push(InputEvent::Key { key, down });
        } else if let Some(&(_, button)) = MOUSE.iter().find(|(known, _)| *known == code) {
            events.push(InputEvent::MouseButton { button, down });
        }
    }

    fn axis(&self, code: u16, value: i32, events: &mut Vec<InputEvent>) {
        let (Kind::Pad(layout), Some(pad)) = (self.kind, self.pad) else {
            return;
        };
        if let Some(&(_, less, more)) = HATS.iter().find(|(hat, _, _)| hat.0 == code) {
            for (button, down) in [(less, value < 0), (more, value > 0)] {
                events.push(InputEvent::PadButton { pad, button, down });
            }
            return;
        }
        let known = layout.axes.iter().find(|(axis, _)| axis.0 == code);
        if let (Some(&(_, axis)), Some(range)) = (known, self.ranges.get(&code)) {
            let value = match axis {
                Axis::L2 | Axis::R2 => range.part(value),
                _ => range.deflection(value),
            };
            events.push(InputEvent::PadAxis { pad, axis, value });
            // Triggers that aren't buttons count as pressed from the middle on.
            let trigger = match axis {
                Axis::L2 => (Button::L2, Code::BTN_TL2),
                Axis::R2 => (Button::R2, Code::BTN_TR2),
                _ => return,
            };
            let (button, code) = trigger;
            let is_button = layout.buttons.iter().any(|(known, _)| *known == code);
            if !(is_button && self.keys.has(code.0)) {
                let down = value > 0.5;
                events.push(InputEvent::PadButton { pad, button, down });
            }
        }
    }

    fn sense(&mut self, axis: Abs, value: i32) {
        let resolution = self.ranges.get(&axis.0).map_or(0, |range| range.resolution);
        let units = if resolution > 0 { resolution as f32 } else { SIXAXIS_UNITS_A_G };
        let value = value as f32 / units;
        match axis {
            Abs::ABS_X => self.sensors.acceleration[0] = value,
            Abs::ABS_Y => self.sensors.acceleration[1] = value,
            Abs::ABS_Z => self.sensors.acceleration[2] = value,
            Abs::ABS_RY => self.sensors.turn = value,
            _ => return,
        }
        self.sensed = true;
    }
}

impl Range {
    /// Converts a value to the range from 0 (minimum) to 1 (maximum).
    fn part(self, value: i32) -> f32 {
        let length = f64::from(self.max) - f64::from(self.min);
        if length <= 0.0 {
            return 0.0;
        }
        let part = (f64::from(value) - f64::from(self.min)) / length;
        part.clamp(0.0, 1.0) as f32
    }

    /// Converts a value to -1 to 1, with 0 around the middle.
    fn deflection(self, value: i32) -> f32 {
        let (min, max) = (f64::from(self.min), f64::from(self.max));
        let (middle, half) = ((min + max) / 2.0, (max - min) / 2.0);
        let flat = f64::from(self.flat).max(0.0);
        if half <= flat {
            return 0.0;
        }
        let away = f64::from(value) - middle;
        let beyond = (away.abs() - flat).max(0.0) / (half - flat);
        (beyond.min(1.0) * away.signum()) as f32
    }
}
