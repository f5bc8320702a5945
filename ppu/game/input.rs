//! The state of keys, mouse and pads, from frame to frame.
//!
//! Owns the state that results from [`InputEvent`]s. It is independent of devices: the code that
//! reads a device makes the events. Invariants: the state depends only on the events; every number
//! in it is finite, and axes are from -1 to 1.

mod event;
mod names;
mod pad;

pub use event::InputEvent;
pub use names::{Axis, Button, Key, MouseButton};
pub use pad::{Pad, PadId, Sensors};

use names::Switches;

/// The state of the mouse.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mouse {
    /// The pointer's position in pixels from the picture's top left; `None` while it is outside of
    /// the picture.
    pub position: Option<[f32; 2]>,
    /// The mouse's motion since the last frame, to the right and down, in the device's own unit,
    /// which usually is pixels.
    pub motion: [f32; 2],
    /// The wheel's motion since the last frame in notches, to the right and away from the player.
    pub wheel: [f32; 2],
}

/// The state of all input in a frame.
///
/// ```
/// use cellray::game::{Input, InputEvent, Key};
///
/// let mut input = Input::default();
/// input.begin_frame();
/// input.apply(&InputEvent::Key { key: Key::Space, down: true });
/// assert!(input.key_pressed(Key::Space) && input.key_held(Key::Space));
///
/// input.begin_frame();
/// assert!(!input.key_pressed(Key::Space) && input.key_held(Key::Space));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Input {
    keys: Switches<Key>,
    buttons: Switches<MouseButton>,
    mouse: Mouse,
    pads: Vec<Pad>,
    lost_focus: bool,
}

impl Input {
    /// Begins a frame: forgets what was pressed, released and moved in the last one. Keys and
    /// buttons that are held stay held.
    pub fn begin_frame(&mut self) {
        self.keys.begin_frame();
        self.buttons.begin_frame();
        self.mouse.motion = [0.0; 2];
        self.mouse.wheel = [0.0; 2];
        self.lost_focus = false;
        for pad in &mut self.pads {
            pad.begin_frame();
        }
    }

    /// Applies an event of the current frame. An event of a pad that isn't connected is ignored.
    pub fn apply(&mut self, event: &InputEvent) {
        match event {
            InputEvent::Key { key, down } => self.keys.set(*key, *down),
            InputEvent::MouseMoved { to } => {
                let is_finite = to.iter().all(|value| value.is_finite());
                self.mouse.position = is_finite.then_some(*to);
            }
            InputEvent::MouseLeft => self.mouse.position = None,
            InputEvent::MouseMotion { by } => add(&mut self.mouse.motion, *by),
            InputEvent::Wheel { by } => add(&mut self.mouse.wheel, *by),
            InputEvent::MouseButton { button, down } => self.buttons.set(*button, *down),
            InputEvent::FocusLost => self.lose_focus(),
            InputEvent::PadConnected { pad, name } => {
                self.pads.retain(|known| known.id() != *pad);
                self.pads.push(Pad::new(*pad, name));
                self.pads.sort_unstable_by_key(Pad::id);
            }
            InputEvent::PadDisconnected { pad } => self.pads.retain(|known| known.id() != *pad),
            InputEvent::PadButton { pad, button, down } => {
                self.with_pad(*pad, |pad| pad.set_button(*button, *down));
            }
            InputEvent::PadAxis { pad, axis, value } => {
                self.with_pad(*pad, |pad| pad.set_axis(*axis, *value));
            }
            InputEvent::PadSensors { pad, sensors } => {
                self.with_pad(*pad, |pad| pad.set_sensors(*sensors));
            }
        }
    }

    /// Whether the input focus was lost in this frame. Keys and buttons then count as released
    /// although the player may still hold them.
    #[must_use]
    pub fn lost_focus(&self) -> bool {
        self.lost_focus
    }

    /// Whether a key is down, or was down within this frame.
    #[must_use]
    pub fn key_held(&self, key: Key) -> bool {
        self.keys.held(key)
    }

    /// Whether a key went down in this frame.
    #[must_use]
    pub fn key_pressed(&self, key: Key) -> bool {
        self.keys.pressed(key)
    }

    /// Whether a key went up in this frame.
    #[must_use]
    pub fn key_released(&self, key: Key) -> bool {
        self.keys.released(key)
    }

    /// The state of the mouse.
    #[must_use]
    pub fn mouse(&self) -> Mouse {
        self.mouse
    }

    /// Whether a button of the mouse is down, or was down within this frame.
    #[must_use]
    pub fn mouse_held(&self, button: MouseButton) -> bool {
        self.buttons.held(button)
    }

    /// Whether a button of the mouse went down in this frame.
    #[must_use]
    pub fn mouse_pressed(&self, button: MouseButton) -> bool {
        self.buttons.pressed(button)
    }

    /// Whether a button of the mouse went up in this frame.
    #[must_use]
    pub fn mouse_released(&self, button: MouseButton) -> bool {
        self.buttons.released(button)
    }

    /// The connected pads, in the order of their numbers.
    #[must_use]
    pub fn pads(&self) -> &[Pad] {
        &self.pads
    }

    /// The connected pad with the lowest number.
    #[must_use]
    pub fn pad(&self) -> Option<&Pad> {
        self.pads.first()
    }

    /// A pair of keys as an axis: -1 if only `less` is held, 1 if only `more` is, otherwise 0.
    #[must_use]
    pub fn key_axis(&self, less: Key, more: Key) -> f32 {
        f32::from(i8::from(self.key_held(more)) - i8::from(self.key_held(less)))
    }

    fn with_pad(&mut self, id: PadId, change: impl FnOnce(&mut Pad)) {
        if let Some(pad) = self.pads.iter_mut().find(|pad| pad.id() == id) {
            change(pad);
        }
    }

    /// Counts everything that is held as released, because without the focus no event will come
    /// when it is.
    fn lose_focus(&mut self) {
        self.lost_focus = true;
        self.keys.release_all();
        self.buttons.release_all();
        self.pads.iter_mut().for_each(Pad::release_all);
    }
}

/// Adds the components for which the sum stays finite.
fn add(sum: &mut [f32; 2], by: [f32; 2]) {
    for (sum, by) in sum.iter_mut().zip(by) {
        let moved = *sum + by;
        if moved.is_finite() {
            *sum = moved;
        }
    }
}
