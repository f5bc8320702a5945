//! What the player does: keys, mouse and pads, from frame to frame.
//!
//! Owns the state that [`InputEvent`]s add up to. Knows no device: who reads one makes the events.
//! Invariants: the state depends on the events alone; every number in it is finite, axes are from
//! -1 to 1.

mod event;
mod names;
mod pad;

pub use event::InputEvent;
pub use names::{Axis, Button, Key, MouseButton};
pub use pad::{Pad, PadId, Sensors};

use names::Switches;

/// The mouse.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mouse {
    /// Where it points, in pixels from the picture's top left; nothing while it is elsewhere.
    pub position: Option<[f32; 2]>,
    /// How far it was moved since the last frame, to the right and down, in its own unit: pixels
    /// for most.
    pub motion: [f32; 2],
    /// By how many notches the wheel was turned since the last frame, to the right and away from
    /// the player.
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
    /// Begins a frame: what was pressed, released and moved in the last one is forgotten; what is
    /// held stays.
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

    /// Takes an event of the frame at hand. One of a pad that is not there is passed over.
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
            InputEvent::FocusLost => self.let_go(),
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

    /// Whether keys began to go elsewhere in this frame: what counts as released by that, the
    /// player did not let go.
    #[must_use]
    pub fn lost_focus(&self) -> bool {
        self.lost_focus
    }

    /// Whether a key is down, or was within the frame.
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

    /// Where the mouse is and what it did.
    #[must_use]
    pub fn mouse(&self) -> Mouse {
        self.mouse
    }

    /// Whether a button of the mouse is down, or was within the frame.
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

    /// The pads that are there, in order of their numbers.
    #[must_use]
    pub fn pads(&self) -> &[Pad] {
        &self.pads
    }

    /// The pad of the first player, if there is one.
    #[must_use]
    pub fn pad(&self) -> Option<&Pad> {
        self.pads.first()
    }

    /// -1, 0 or 1 by which of two keys is held: the one for less, the one for more.
    #[must_use]
    pub fn key_axis(&self, less: Key, more: Key) -> f32 {
        f32::from(i8::from(self.key_held(more)) - i8::from(self.key_held(less)))
    }

    fn with_pad(&mut self, id: PadId, change: impl FnOnce(&mut Pad)) {
        if let Some(pad) = self.pads.iter_mut().find(|pad| pad.id() == id) {
            change(pad);
        }
    }

    /// Everything held counts as released: nobody will hear of it when it is.
    fn let_go(&mut self) {
        self.lost_focus = true;
        self.keys.let_go();
        self.buttons.let_go();
        self.pads.iter_mut().for_each(Pad::let_go);
    }
}

/// Adds what is finite, so that the sum is.
fn add(sum: &mut [f32; 2], by: [f32; 2]) {
    for (sum, by) in sum.iter_mut().zip(by) {
        let moved = *sum + by;
        if moved.is_finite() {
            *sum = moved;
        }
    }
}
