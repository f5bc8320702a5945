//! How the player aims: direction, power, and height of the cue's tip.

use cellray::game::{Axis, Button, DVec3, Input, Key, MouseButton};

use super::balls::Balls;
use super::table::{HALF, RADIUS};

/// Radians by which the cue turns for a pixel of mouse movement, and for a second of keys and
/// sticks.
const TURN_A_PIXEL: f64 = 0.002;
const TURN_A_SECOND: f64 = 0.9;
/// The factor by which it turns more slowly while the player aims with care.
const CARE: f64 = 0.08;
/// Power for a pixel by which the mouse is drawn back, and for a second of keys and sticks.
const POWER_A_PIXEL: f64 = 0.004;
const POWER_A_SECOND: f64 = 0.7;
/// Height of the tip for a notch of the wheel, and for a second of keys and buttons.
const HEIGHT_A_NOTCH: f64 = 0.1;
const HEIGHT_A_SECOND: f64 = 1.0;
/// Below this power there is no shot: the mouse was drawn back and brought forward again.
const MIN_POWER: f64 = 0.03;
/// Speed of the cue ball at full power.
const FASTEST: f64 = 7.5;

/// How the player holds the cue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aim {
    turn: f64,
    power: f64,
    height: f64,
    /// While the mouse draws the cue back, the power from before that.
    before: Option<f64>,
}

impl Default for Aim {
    fn default() -> Self {
        Self { turn: 0.0, power: 0.5, height: 0.0, before: None }
    }
}

impl Aim {
    /// The horizontal direction of the cue, with length 1.
    #[must_use]
    pub fn direction(&self) -> DVec3 {
        let (sine, cosine) = libm::sincos(self.turn);
        DVec3::new(cosine, 0.0, sine)
    }

    /// The power as a share of full power, 0 to 1.
    #[must_use]
    pub fn power(&self) -> f64 {
        self.power
    }

    /// The height of the tip, -1 to 1.
    #[must_use]
    pub fn height(&self) -> f64 {
        self.height
    }

    /// The speed that the shot gives the cue ball.
    #[must_use]
    pub fn speed(&self) -> f64 {
        // Soft shots can be controlled more finely.
        FASTEST * self.power * (0.4 + 0.6 * self.power)
    }

    /// Points the cue from one place to another for a new turn. If the mouse is still drawing the
    /// cue back, that ends.
    pub fn point(&mut self, from: DVec3, to: DVec3) {
        self.let_go();
        self.turn = libm::atan2(to.z - from.z, to.x - from.x);
        self.height = 0.0;
    }

    /// Ends the mouse's draw without a shot. The power is again what it was before.
    fn let_go(&mut self) {
        self.power = self.before.take().unwrap_or(self.power);
    }

    /// Applies the player's input. Returns whether the player made the shot.
    pub fn steer(&mut self, input: &Input, seconds: f64) -> bool {
        let key = |less, more| f64::from(input.key_axis(less, more)) * seconds;
        let careful = input.key_held(Key::Shift) || input.mouse_held(MouseButton::Right);
        let mut turn = key(Key::Left, Key::Right) * TURN_A_SECOND;
        let mut power = key(Key::Down, Key::Up) * POWER_A_SECOND;
        let mut height = key(Key::S, Key::W) * HEIGHT_A_SECOND;
        let mut blow = input.key_pressed(Key::Space);
        let mut care = if careful { CARE } else { 1.0 };
        if let Some(pad) = input.pad() {
            if pad.held(Button::L2) {
                care = CARE;
            }
            let held = |button| f64::from(u8::from(pad.held(button))) * seconds;
            turn += pad.stick(Axis::LeftX) * TURN_A_SECOND * seconds;
            power += pad.stick(Axis::RightY) * POWER_A_SECOND * seconds;
            height += (held(Button::R1) - held(Button::L1)) * HEIGHT_A_SECOND;
            blow |= pad.pressed(Button::Cross);
        }
        let mouse = input.mouse();
        let [across, back] = mouse.motion.map(f64::from);
        height += f64::from(mouse.wheel[1]) * HEIGHT_A_NOTCH;
        if input.mouse_pressed(MouseButton::Left) {
            self.before = Some(self.power);
            self.power = 0.0;
        }
        if self.before.is_some() {
            power += back * POWER_A_PIXEL;
        } else {
            turn += across * TURN_A_PIXEL;
        }
        self.turn = libm::remainder(self.turn + turn * care, std::f64::consts::TAU);
        self.power = (self.power + power).clamp(0.0, 1.0);
        self.height = (self.height + height).clamp(-1.0, 1.0);
        // A player who switches to another window releases the button there without meaning to
        // shoot.
        if input.lost_focus() {
            self.let_go();
        }
        if input.mouse_released(MouseButton::Left) && self.before.is_some() {
            if self.power >= MIN_POWER {
                blow = true;
            } else {
                self.let_go();
            }
        }
        blow &= self.power >= MIN_POWER;
        if blow {
            // After any shot, releasing the button has no effect.
            self.before = None;
        }
        blow
    }

    /// How far the cue ball runs before it touches a ball or a cushion.
    #[must_use]
    pub fn free_way(&self, balls: &Balls) -> f64 {
        let (from, direction) = (balls.0[0].body.centre, self.direction());
        let cushion = |place: f64, way: f64, half: f64| {
            if way == 0.0 { f64::INFINITY } else { ((half - RADIUS).copysign(way) - place) / way }
        };
        let cushions =
            cushion(from.x, direction.x, HALF.0).min(cushion(from.z, direction.z, HALF.1));
        (1..balls.0.len())
            .filter(|&number| balls.on_bed(number))
            .filter_map(|number| {
                let between = balls.0[number].body.centre - from;
                let along = between.dot(direction);
                let off = between.length_squared() - along * along;
                let depth = 4.0 * RADIUS * RADIUS - off;
                (along > 0.0 && depth > 0.0).then(|| along - depth.sqrt())
            })
            .fold(cushions, f64::min)
            .max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Aim;
    use cellray::game::{DVec3, Input, InputEvent, Key, MouseButton};

    const PRESS: InputEvent = InputEvent::MouseButton { button: MouseButton::Left, down: true };
    const RELEASE: InputEvent = InputEvent::MouseButton { button: MouseButton::Left, down: false };

    fn motion(across: f32, back: f32) -> InputEvent {
        InputEvent::MouseMotion { by: [across, back] }
    }

    /// An aim and a player's input.
    #[derive(Default)]
    struct Played {
        aim: Aim,
        input: Input,
    }

    impl Played {
        /// Runs a frame, and returns whether it contained the shot.
        fn frame(&mut self, events: &[InputEvent]) -> bool {
            self.input.begin_frame();
            events.iter().for_each(|event| self.input.apply(event));
            self.aim.steer(&self.input, 0.1)
        }
    }

    #[test]
    fn mouse_drag_and_release_strike() {
        let mut played = Played::default();
        assert!(!played.frame(&[PRESS]));
        assert!(!played.frame(&[motion(50.0, 100.0)]));
        assert!(played.frame(&[RELEASE]));
        assert_eq!((played.aim.power(), played.aim.turn), (0.4, 0.0));

        // The cue is drawn back and brought forward again: there is no shot, and the power is what
        // it was.
        assert!(!played.frame(&[PRESS]));
        assert!(!played.frame(&[motion(0.0, 90.0)]));
        assert!(!played.frame(&[motion(0.0, -90.0)]));
        assert!(!played.frame(&[RELEASE]));
        assert_eq!(played.aim.power(), 0.4);
    }

    #[test]
    fn key_strike_ends_mouse_drag() {
        let mut played = Played::default();
        played.frame(&[PRESS, motion(0.0, 75.0)]);
        let (key, down) = (Key::Space, true);
        assert!(played.frame(&[InputEvent::Key { key, down }]));
        assert_eq!(played.aim.power(), 0.3);
        // In the next turn, the mouse turns the cue, and a release is no shot.
        played.aim.point(DVec3::ZERO, DVec3::X);
        assert!(!played.frame(&[motion(10.0, 100.0)]));
        assert_eq!(played.aim.power(), 0.3);
        assert_ne!(played.aim.turn, 0.0);
        assert!(!played.frame(&[RELEASE]));
    }

    #[test]
    fn new_game_has_cue_at_rest() {
        let mut played = Played::default();
        played.frame(&[PRESS, motion(0.0, 75.0)]);
        played.aim.point(DVec3::ZERO, DVec3::X);
        assert_eq!(played.aim.power(), 0.5);
        assert!(!played.frame(&[RELEASE]));
    }

    #[test]
    fn losing_the_focus_does_not_strike() {
        let mut played = Played::default();
        played.frame(&[PRESS, motion(0.0, 75.0)]);
        assert!(!played.frame(&[InputEvent::FocusLost]));
        assert_eq!(played.aim.power(), 0.5);
        assert!(!played.frame(&[RELEASE]));
        assert!(!played.frame(&[motion(0.0, 50.0)]));
        assert_eq!(played.aim.power(), 0.5);
    }
}
