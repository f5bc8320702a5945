//! Cameras that a player moves: one that circles a point, and one that walks.
//!
//! Invariant: they use only `+ - * /` and `libm`'s functions, so that a recorded session plays back
//! on every machine.

use glam::DVec3;

use super::{Axis, Button, Input, Key, MouseButton, World, WorldError};

/// Radians by which a camera turns for a pixel of mouse movement.
const A_PIXEL: f64 = 0.006;
/// Radians a second for keys and sticks.
const A_SECOND: f64 = 1.4;
/// Change of the distance's logarithm for a notch of the wheel, and for a second of keys.
const A_NOTCH: f64 = 0.12;
const ZOOM_A_SECOND: f64 = 1.2;
/// How many times as fast a camera walks with Shift.
const RUN: f64 = 2.5;
/// How far up and down one can look, in radians: 85 degrees, because straight up has no right.
const STEEPEST: f64 = 85.0 / 180.0 * std::f64::consts::PI;

/// A camera on a sphere around the point that it looks at; y is up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitCamera {
    /// Radians about the vertical axis. 0 is the direction of z.
    pub turn: f64,
    /// Radians above the horizon.
    pub rise: f64,
    /// The distance from the point.
    pub distance: f64,
    /// The minimum and the maximum distance.
    pub distances: (f64, f64),
    /// The minimum and the maximum rise.
    pub rises: (f64, f64),
}

impl OrbitCamera {
    /// A camera at a distance, which may become a tenth of that and ten times as much.
    #[must_use]
    pub fn at_distance(distance: f64) -> Self {
        Self {
            turn: 0.0,
            rise: 0.3,
            distance,
            distances: (distance / 10.0, distance * 10.0),
            rises: (-STEEPEST, STEEPEST),
        }
    }

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
            turn += pad.stick(Axis::RightX) * A_SECOND * seconds;
            rise -= pad.stick(Axis::RightY) * A_SECOND * seconds;
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
        at + direction(self.turn, self.rise) * self.distance
    }

    /// Puts the world's eye to the camera's place, and turns it to this point.
    ///
    /// # Errors
    /// As for [`World::look_from`].
    #[track_caller]
    pub fn look_at(&self, world: &mut World, at: impl Into<DVec3>) -> Result<(), WorldError> {
        let at = at.into();
        world.look_from(self.from(at), at)
    }
}

/// A camera that walks on level ground and looks around; y is up.
///
/// ```
/// use cellray::prelude::*;
///
/// struct Visit {
///     camera: WalkCamera,
/// }
///
/// impl Game for Visit {
///     fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
///         let stone = world.add_material(Material::matte(0.6, 0.6, 0.6))?;
///         world.add_plane([0.0, 0.0, 0.0], [0.0, 1.0, 0.0], 100.0, stone)?;
///         Ok(())
///     }
///     fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
///         self.camera.steer(frame.input, frame.delta);
///         self.camera.look(world)
///     }
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WalkCamera {
    /// Where the eye is.
    pub from: DVec3,
    /// Radians about the vertical axis, to the left. 0 looks along -z.
    pub turn: f64,
    /// Radians above the horizon.
    pub rise: f64,
    /// How far it walks in a second.
    pub speed: f64,
}

impl WalkCamera {
    /// A camera that stands here, looks along -z, and walks at this speed.
    #[must_use]
    pub fn new(from: impl Into<DVec3>, speed: f64) -> Self {
        Self { from: from.into(), turn: 0.0, rise: 0.0, speed }
    }

    /// Applies the player's input. W, S, A, D and the left stick walk, with Shift or L1 faster. The
    /// arrows, dragging the mouse and the right stick look around. Returns the step that is walked,
    /// which a game may shorten by setting [`from`](Self::from) where a wall is.
    pub fn steer(&mut self, input: &Input, seconds: f64) -> DVec3 {
        let mut right = f64::from(input.key_axis(Key::A, Key::D));
        let mut ahead = f64::from(input.key_axis(Key::S, Key::W));
        let mut turn = f64::from(input.key_axis(Key::Right, Key::Left)) * A_SECOND * seconds;
        let mut rise = f64::from(input.key_axis(Key::Down, Key::Up)) * A_SECOND * seconds;
        let mut runs = input.key_held(Key::Shift);
        if input.mouse_held(MouseButton::Left) {
            let [x, y] = input.mouse().motion.map(f64::from);
            turn -= x * A_PIXEL;
            rise -= y * A_PIXEL;
        }
        if let Some(pad) = input.pad() {
            right += pad.stick(Axis::LeftX);
            ahead -= pad.stick(Axis::LeftY);
            turn -= pad.stick(Axis::RightX) * A_SECOND * seconds;
            rise -= pad.stick(Axis::RightY) * A_SECOND * seconds;
            runs |= pad.held(Button::L1);
        }
        self.turn = libm::remainder(self.turn + turn, std::f64::consts::TAU);
        self.rise = (self.rise + rise).clamp(-STEEPEST, STEEPEST);
        let (sine, cosine) = libm::sincos(self.turn);
        let way = DVec3::new(right * cosine - ahead * sine, 0.0, -right * sine - ahead * cosine);
        // Whoever walks ahead and to the right at once isn't faster.
        let way = way / way.length().max(1.0);
        let step = way * (self.speed * seconds * if runs { RUN } else { 1.0 });
        self.from += step;
        step
    }

    /// The direction in which it looks, of length 1.
    #[must_use]
    pub fn direction(&self) -> DVec3 {
        let away = direction(self.turn, self.rise);
        DVec3::new(-away.x, away.y, -away.z)
    }

    /// Puts the world's eye to the camera's place, and turns it to where the camera looks.
    ///
    /// # Errors
    /// As for [`World::look_from`].
    #[track_caller]
    pub fn look(&self, world: &mut World) -> Result<(), WorldError> {
        world.look_from(self.from, self.from + self.direction())
    }
}

/// The direction of z, turned about the vertical axis, then raised.
fn direction(turn: f64, rise: f64) -> DVec3 {
    let (turn_sine, turn_cosine) = libm::sincos(turn);
    let (rise_sine, rise_cosine) = libm::sincos(rise);
    DVec3::new(turn_sine * rise_cosine, rise_sine, turn_cosine * rise_cosine)
}

#[cfg(test)]
mod tests {
    use super::{OrbitCamera, WalkCamera};
    use crate::game::{Axis, Button, DVec3, Input, InputEvent, Key, MouseButton, PadId};

    const ORBIT: OrbitCamera = OrbitCamera {
        turn: 0.0,
        rise: 0.3,
        distance: 5.0,
        distances: (2.0, 9.0),
        rises: (0.1, 1.5),
    };

    #[test]
    fn orbit_stays_within_bounds_for_any_mouse_input() {
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
    fn orbit_rests_without_input() {
        assert!(!ORBIT.clone().steer(&Input::default(), 1.0));
        // Wrapping an angle to the range of a turn does not count as movement either.
        let mut orbit = OrbitCamera { turn: 4.0, ..ORBIT };
        assert!(!orbit.steer(&Input::default(), 1.0));
        assert!((orbit.turn - (4.0 - std::f64::consts::TAU)).abs() < 1e-12);
    }

    #[test]
    fn key_held_at_bound_counts_as_input() {
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
    fn orbit_distance_follows_keys() {
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

    fn held(keys: &[Key]) -> Input {
        let mut input = Input::default();
        for &key in keys {
            input.apply(&InputEvent::Key { key, down: true });
        }
        input
    }

    #[test]
    fn walk_follows_view_direction() {
        let mut camera = WalkCamera::new([1.0, 1.7, 2.0], 3.0);
        let step = camera.steer(&held(&[Key::W]), 0.5);
        assert_eq!(step, DVec3::new(0.0, 0.0, -1.5));
        assert_eq!(camera.from, DVec3::new(1.0, 1.7, 0.5));
        // A quarter of a turn to the left, and up: walking keeps the height.
        camera.turn = std::f64::consts::FRAC_PI_2;
        camera.rise = 1.0;
        let step = camera.steer(&held(&[Key::W]), 0.5);
        assert!(step.distance(DVec3::new(-1.5, 0.0, 0.0)) < 1e-12, "{step}");
        let step = camera.steer(&held(&[Key::D]), 0.5);
        assert!(step.distance(DVec3::new(0.0, 0.0, -1.5)) < 1e-12, "{step}");
        let both = camera.steer(&held(&[Key::W, Key::D]), 0.5);
        assert!((both.length() - 1.5).abs() < 1e-12);
        let fast = camera.steer(&held(&[Key::W, Key::Shift]), 0.5);
        assert!((fast.length() - 3.75).abs() < 1e-12);
    }

    #[test]
    fn view_pitch_stays_below_vertical() {
        let mut camera = WalkCamera::new(DVec3::ZERO, 1.0);
        assert_eq!(camera.direction(), DVec3::new(0.0, 0.0, -1.0));
        camera.steer(&held(&[Key::Left]), 0.5);
        assert!(camera.direction().x < -0.6);
        let pad = PadId(0);
        let mut input = Input::default();
        input.apply(&InputEvent::PadConnected { pad, name: "a pad".into() });
        let (axis, value) = (Axis::RightY, -1.0);
        input.apply(&InputEvent::PadAxis { pad, axis, value });
        for _ in 0..9 {
            camera.steer(&input, 1.0);
        }
        let up = camera.direction();
        assert!(up.y > 0.99 && libm::hypot(up.x, up.z) > 0.08, "{up}");
        assert!((up.length() - 1.0).abs() < 1e-12);
    }
}
