//! A camera on a sphere around the point that it looks at, which the player turns.

use cellray::game::{Axis, Button, DVec3, Input, Key, MouseButton};

/// Radians by which it turns for a pixel of mouse movement.
const A_PIXEL: f64 = 0.006;
/// Radians a second for keys and sticks.
const A_SECOND: f64 = 1.4;
/// Change of the distance's logarithm for a notch of the wheel, and for a second of keys.
const A_NOTCH: f64 = 0.12;
const ZOOM_A_SECOND: f64 = 1.2;
/// The largest value of a stick at rest.
const DEAD: f64 = 0.15;

/// The eye's position relative to the point that it looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// Radians about the vertical axis. 0 is the direction of z.
    pub turn: f64,
    /// Radians above the horizon.
    pub rise: f64,
    /// The distance from the point.
    pub distance: f64,
    /// The least and the greatest distance.
    pub distances: (f64, f64),
    /// The least and the greatest rise.
    pub rises: (f64, f64),
}

impl Orbit {
    /// Applies the player's input: dragging the mouse, the wheel, A, D, W, S, page keys, the right
    /// stick, and on a pad R2 for nearer and L2 for farther. Returns whether there is any input,
    /// even if a bound stops the movement.
    pub fn steer(&mut self, input: &Input, seconds: f64) -> bool {
        let mouse = input.mouse();
        let mut turn = f64::from(input.key_axis(Key::A, Key::D)) * A_SECOND * seconds;
        let mut rise = f64::from(input.key_axis(Key::S, Key::W)) * A_SECOND * seconds;
        let mut zoom = f64::from(input.key_axis(Key::PageUp, Key::PageDown));
        if input.mouse_held(MouseButton::Left) {
            turn -= f64::from(mouse.motion[0]) * A_PIXEL;
            rise += f64::from(mouse.motion[1]) * A_PIXEL;
        }
        if let Some(pad) = input.pad() {
            turn += stick(pad.axis(Axis::RightX)) * A_SECOND * seconds;
            rise -= stick(pad.axis(Axis::RightY)) * A_SECOND * seconds;
            zoom += f64::from(u8::from(pad.held(Button::L2)))
                - f64::from(u8::from(pad.held(Button::R2)));
        }
        let zoom = zoom * ZOOM_A_SECOND * seconds - f64::from(mouse.wheel[1]) * A_NOTCH;
        self.turn = libm::remainder(self.turn + turn, std::f64::consts::TAU);
        self.rise = (self.rise + rise).clamp(self.rises.0, self.rises.1);
        // The value is limited first, because the wheel of a recording may have any value.
        self.distance = (self.distance * libm::exp(zoom.clamp(-9.0, 9.0)))
            .clamp(self.distances.0, self.distances.1);
        turn != 0.0 || rise != 0.0 || zoom != 0.0
    }

    /// The eye's position when it looks at this point.
    #[must_use]
    pub fn from(&self, at: DVec3) -> DVec3 {
        let (turn_sine, turn_cosine) = libm::sincos(self.turn);
        let (rise_sine, rise_cosine) = libm::sincos(self.rise);
        let away = DVec3::new(
            turn_sine * rise_cosine,
            rise_sine,
            turn_cosine * rise_cosine,
        );
        at + away * self.distance
    }
}

/// The value of a stick, -1 to 1, where values at rest become 0.
#[must_use]
pub fn stick(value: f32) -> f64 {
    let value = f64::from(value);
    if value.abs() < DEAD { 0.0 } else { value }
}

/// Below this distance, the eye counts as arrived, because the difference is invisible.
const ARRIVED: f64 = 1e-5;

/// Moves this part of the way. A position that has arrived stays exactly the same however long the
/// frames are. Otherwise a picture without movement would be traced again and again.
#[must_use]
pub fn follow(from: DVec3, to: DVec3, part: f64) -> DVec3 {
    let way = to - from;
    if way.length_squared() < ARRIVED * ARRIVED {
        to
    } else {
        from + way * part
    }
}

#[cfg(test)]
mod tests {
    use super::{Orbit, follow};
    use cellray::game::{Button, DVec3, Input, InputEvent, Key, MouseButton, PadId};

    const ORBIT: Orbit = Orbit {
        turn: 0.0,
        rise: 0.3,
        distance: 5.0,
        distances: (2.0, 9.0),
        rises: (0.1, 1.5),
    };

    #[test]
    fn who_has_arrived_stays_whatever_the_frames_take() {
        let (mut eye, to) = (DVec3::new(0.3, -7.1, 2.9), DVec3::new(0.1, 0.7, 1.3));
        for frame in 0..400 {
            eye = follow(eye, to, 0.05 + 0.001 * f64::from(frame % 97));
        }
        assert_eq!(eye, to);
        for part in [0.0, 0.013, 0.3, 0.9999, 1.0] {
            assert_eq!(follow(eye, to, part), to);
        }
    }

    #[test]
    fn it_stays_within_its_bounds_whatever_the_mouse_says() {
        let mut orbit = ORBIT;
        let mut input = Input::default();
        let button = MouseButton::Left;
        input.apply(&InputEvent::MouseButton { button, down: true });
        for by in [[1e30, 1e30], [-1e30, f32::MAX], [3.0, -1e30]] {
            input.begin_frame();
            input.apply(&InputEvent::MouseMotion { by });
            input.apply(&InputEvent::Wheel { by });
            assert!(orbit.steer(&input, 0.1));
            assert!((0.1..=1.5).contains(&orbit.rise));
            assert!((2.0..=9.0).contains(&orbit.distance));
            let from = orbit.from(DVec3::ONE);
            assert!((from.distance(DVec3::ONE) - orbit.distance).abs() < 1e-12);
        }
    }

    #[test]
    fn it_rests_without_a_player() {
        assert!(!ORBIT.clone().steer(&Input::default(), 1.0));
        // Wrapping an angle to the range of a turn does not count as movement either.
        let mut orbit = Orbit { turn: 4.0, ..ORBIT };
        assert!(!orbit.steer(&Input::default(), 1.0));
        assert!((orbit.turn - (4.0 - std::f64::consts::TAU)).abs() < 1e-12);
    }

    #[test]
    fn a_key_held_at_a_bound_is_a_player() {
        let mut orbit = ORBIT;
        let mut input = Input::default();
        let key = Key::W;
        input.apply(&InputEvent::Key { key, down: true });
        for _ in 0..3 {
            assert!(orbit.steer(&input, 5.0));
            assert_eq!(orbit.rise, ORBIT.rises.1);
        }
    }

    #[test]
    fn it_comes_nearer_and_goes_farther_as_is_written() {
        let pad = PadId(0);
        let name = "a pad".to_owned();
        let after = |event: InputEvent| {
            let mut input = Input::default();
            let name = name.clone();
            input.apply(&InputEvent::PadConnected { pad, name });
            input.apply(&event);
            let mut orbit = ORBIT;
            orbit.steer(&input, 0.1);
            orbit.distance
        };
        let down = true;
        let key = |key| InputEvent::Key { key, down };
        let button = |button| InputEvent::PadButton { pad, button, down };
        let wheel = |notch| InputEvent::Wheel { by: [0.0, notch] };
        for nearer in [key(Key::PageUp), button(Button::R2), wheel(1.0)] {
            assert!(after(nearer) < ORBIT.distance);
        }
        for farther in [key(Key::PageDown), button(Button::L2), wheel(-1.0)] {
            assert!(after(farther) > ORBIT.distance);
        }
    }
}
