//! The scene viewer: a game in which only the eye moves.
//!
//! Invariant: the eye stays on a sphere around its target, and never passes its poles. Rotations
//! use rational functions instead of sines, so that a recorded session is the same on every
//! machine.

use cellray::game::{
    Axis, Button, DVec3, Frame, Game, Key, Mouse, MouseButton, Start, View, World, WorldError,
};
use cellray::scene::RenderOptions;

/// The beginning of a viewer's name as a game, before the scene's name.
pub const VIEW: &str = "view ";
/// Rotation of the eye by a key or a stick, in radians a second.
const TURN: f64 = 1.5;
/// Rotation by a drag across the whole picture, in radians.
const DRAG: f64 = std::f64::consts::PI;
/// Rotation in radians for each unit of a mouse without a pointer position.
const UNIT: f64 = 0.005;
/// Change of the distance by one notch of the wheel, relative to the distance.
const NOTCH: f64 = 0.1;
/// Change of the distance by a key in a second, relative to the distance.
const ZOOM: f64 = 1.0;
/// The largest cosine of the angle between the line of sight and the pole.
const STEEPEST: f64 = 0.995;
/// The factor by which the distance may become larger or smaller.
const FARTHEST: f64 = 100.0;

/// The controls.
const CONTROLS: &[&str] = &[
    "arrows, a drag, left stick: turn the camera",
    "wheel, page keys, right stick: nearer, farther",
    "Home, Start: back to the scene's view",
];

/// A viewer of one scene.
pub struct Viewer {
    name: String,
    scene: nff::Scene,
    render_options: RenderOptions,
    orbit: Orbit,
    /// The last position of the mouse, relative to the picture's sides, because the picture's size
    /// may change from frame to frame.
    pointer: Option<[f64; 2]>,
}

impl Viewer {
    /// A viewer of this scene.
    #[must_use]
    pub fn new(scene: nff::Scene, render_options: RenderOptions) -> Self {
        Self {
            name: format!("{VIEW}{}", file_name(&scene.name)),
            orbit: Orbit::of(&scene.view),
            scene,
            render_options,
            pointer: None,
        }
    }

    /// The same scene, seen from this view instead of its own.
    #[must_use]
    pub fn seen_from(mut self, view: &View) -> Self {
        self.orbit = Orbit {
            first_distance: self.orbit.first_distance,
            ..Orbit::of(view)
        };
        self
    }

    /// The drag of the mouse to the right and up, in radians.
    fn drag(&mut self, mouse: Mouse, size: (u32, u32)) -> [f64; 2] {
        let part = |at: f32, side: u32| f64::from(at) / f64::from(side.max(1));
        let now = mouse.position;
        let now = now.map(|[x, y]| [part(x, size.0), part(y, size.1)]);
        let before = std::mem::replace(&mut self.pointer, now);
        match (before, now) {
            (Some(before), Some(now)) => [0, 1].map(|axis| DRAG * (now[axis] - before[axis])),
            (None, None) => mouse.motion.map(|by| UNIT * f64::from(by)),
            _ => [0.0; 2],
        }
    }
}

impl Game for Viewer {
    fn name(&self) -> &str {
        &self.name
    }

    fn controls(&self) -> &[&str] {
        CONTROLS
    }

    fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
        *world = World::from_nff(&self.scene, self.render_options)?;
        Ok(())
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        let Frame {
            input, delta, size, ..
        } = *frame;
        if input.key_pressed(Key::Home) || input.pad().is_some_and(|pad| pad.pressed(Button::Start))
        {
            self.orbit = Orbit::of(&self.scene.view);
        }
        let drag = self.drag(input.mouse(), size);
        let held = input.mouse_held(MouseButton::Left);
        let [across, along] = if held { drag } else { [0.0; 2] };
        let key = |less, more| f64::from(input.key_axis(less, more));
        let stick = |axis| input.pad().map_or(0.0, |pad| f64::from(pad.axis(axis)));
        let turn = TURN * delta;
        // The scene follows the mouse; the eye follows keys and sticks.
        let right = turn * (key(Key::Left, Key::Right) + stick(Axis::LeftX)) - across;
        let up = turn * (key(Key::Down, Key::Up) - stick(Axis::LeftY)) + along;
        self.orbit.turn(right, up);
        let nearer = f64::from(input.mouse().wheel[1]) * NOTCH
            + (key(Key::PageDown, Key::PageUp) - stick(Axis::RightY)) * ZOOM * delta;
        self.orbit.approach(nearer);
        world.look_from(self.orbit.eye(), self.orbit.at)
    }
}

/// The file's name without its folders, so that a recording can be played back with the scene at
/// another path. The world's checksum tells whether the content is the same.
fn file_name(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or_default()
}

/// An eye that orbits a point.
#[derive(Clone, Copy, Debug)]
struct Orbit {
    at: DVec3,
    /// The direction of the pole.
    up: DVec3,
    /// The direction from the target to the eye, of length 1.
    towards: DVec3,
    distance: f64,
    first_distance: f64,
}

impl Orbit {
    fn of(view: &View) -> Self {
        let away = view.from - view.at;
        let distance = away.length();
        Self {
            at: view.at,
            up: view.up.normalize(),
            towards: away / distance,
            distance,
            first_distance: distance,
        }
    }

    fn eye(&self) -> DVec3 {
        self.at + self.towards * self.distance
    }

    /// Moves the eye to its right and up, by approximate angles in radians.
    fn turn(&mut self, right: f64, up: f64) {
        if right != 0.0 {
            self.towards = rotate(self.towards, self.up, right).normalize();
        }
        let side = self.up.cross(self.towards);
        if up != 0.0 && side.length_squared() > 0.0 {
            let raised = rotate(self.towards, side.normalize(), -up).normalize();
            let height = raised.dot(self.up);
            // A view that starts steeper than allowed may become less steep.
            let is_steeper = height.abs() > self.towards.dot(self.up).abs();
            let has_passed = raised.dot(self.towards.reject_from_normalized(self.up)) <= 0.0;
            if !(is_steeper && height.abs() > STEEPEST || has_passed) {
                self.towards = raised;
            }
        }
    }

    /// Moves the eye nearer by about `part` of its distance.
    fn approach(&mut self, part: f64) {
        let distance = if part >= 0.0 {
            self.distance / (1.0 + part)
        } else {
            self.distance * (1.0 - part)
        };
        let (least, most) = (
            self.first_distance / FARTHEST,
            self.first_distance * FARTHEST,
        );
        self.distance = distance.clamp(least, most);
    }
}

/// Rotates a vector about an axis of length 1 by `2 atan(angle / 2)`, which is about the angle
/// itself if that is small.
fn rotate(vector: DVec3, axis: DVec3, angle: f64) -> DVec3 {
    let half = angle / 2.0;
    let scale = 1.0 / (1.0 + half * half);
    let (cosine, sine) = ((1.0 - half * half) * scale, 2.0 * half * scale);
    vector * cosine + axis.cross(vector) * sine + axis * axis.dot(vector) * (1.0 - cosine)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cellray::game::{Input, InputEvent};

    fn scene() -> nff::Scene {
        let text = "v\nfrom 0 -10 0\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 64 36\n\
                    l 5 -5 5\nf 1 1 1 1 0 0 0 0\ns 0 0 0 1\n";
        nff::parse(text.as_bytes(), "a scene", &nff::Limits::default()).expect("a scene")
    }

    struct Player {
        viewer: Viewer,
        world: World,
        input: Input,
        frame: u64,
        size: (u32, u32),
    }

    impl Player {
        fn new() -> Self {
            let (mut viewer, mut world) =
                (Viewer::new(scene(), RenderOptions::default()), World::new());
            let start = Start {
                seed: 0,
                size: (64, 36),
            };
            viewer.set_up(&mut world, &start).expect("a world");
            Self {
                viewer,
                world,
                input: Input::default(),
                frame: 0,
                size: (64, 36),
            }
        }

        /// Runs frames with these events in the first one. Returns the eye's position at the end.
        fn play(&mut self, events: &[InputEvent], frames: u64) -> DVec3 {
            for number in 0..frames {
                self.input.begin_frame();
                if number == 0 {
                    events.iter().for_each(|event| self.input.apply(event));
                }
                let frame = Frame {
                    number: self.frame,
                    time: 0.0,
                    delta: 0.05,
                    input: &self.input,
                    size: self.size,
                    last: None,
                };
                self.viewer
                    .update(&mut self.world, &frame)
                    .expect("a frame");
                self.frame += 1;
            }
            self.world.view().from
        }
    }

    fn key(key: Key, down: bool) -> InputEvent {
        InputEvent::Key { key, down }
    }

    #[test]
    fn keys_turn_the_eye_about_the_scene() {
        let mut player = Player::new();
        let begin = player.play(&[], 1);
        assert_eq!(begin, DVec3::new(0.0, -10.0, 0.0));
        let right = player.play(&[key(Key::Right, true)], 10);
        assert!(right.x > 5.0 && right.y < 0.0 && right.z == 0.0, "{right}");
        assert!((right.length() - 10.0).abs() < 1e-9);
        let up = player.play(&[key(Key::Right, false), key(Key::Up, true)], 5);
        assert!(up.z > 2.0 && (up.length() - 10.0).abs() < 1e-9, "{up}");
        let home = player.play(&[key(Key::Up, false), key(Key::Home, true)], 1);
        assert_eq!(home, begin);
    }

    #[test]
    fn the_eye_never_passes_a_pole() {
        for (held, sign) in [(Key::Up, 1.0), (Key::Down, -1.0)] {
            let mut player = Player::new();
            let eye = player.play(&[key(held, true)], 500);
            assert!(
                eye.z * sign > 9.5 && eye.z * sign < 10.0 && eye.y < 0.0,
                "{eye}"
            );
        }
        // A drag across many pictures doesn't either.
        let mut orbit = Orbit::of(&scene().view);
        for up in [9.0, -50.0, 3.2, 1e6] {
            orbit.turn(0.0, up);
            assert!(orbit.eye().y < 0.0, "{}", orbit.eye());
        }
    }

    #[test]
    fn a_drag_goes_on_where_the_picture_becomes_coarser() {
        let mut player = Player::new();
        let at = |x: f32, y: f32| InputEvent::MouseMoved { to: [x, y] };
        let left = InputEvent::MouseButton {
            button: MouseButton::Left,
            down: true,
        };
        player.play(&[at(10.0, 10.0), left], 1);
        let before = player.play(&[at(40.0, 10.0)], 1);
        player.size = (16, 9);
        assert_eq!(player.play(&[at(10.0, 2.5)], 1), before);
        let dragged = player.play(&[at(11.0, 2.5)], 1);
        player.size = (64, 36);
        assert_eq!(player.play(&[at(44.0, 10.0)], 1), dragged);
        assert!(dragged.x < before.x - 0.1, "{before} {dragged}");
    }

    #[test]
    fn a_scene_has_one_name_by_all_its_paths() {
        for path in ["x.nff", "./x.nff", "/there/../x.nff"] {
            let scene = nff::Scene {
                name: path.into(),
                ..scene()
            };
            assert_eq!(
                Viewer::new(scene, RenderOptions::default()).name(),
                "view x.nff"
            );
        }
    }

    #[test]
    fn the_scene_follows_the_mouse_and_the_wheel_brings_it_near() {
        let mut player = Player::new();
        let at = |x: f32, y: f32| InputEvent::MouseMoved { to: [x, y] };
        let left = |down| InputEvent::MouseButton {
            button: MouseButton::Left,
            down,
        };
        let begin = player.play(&[at(10.0, 10.0)], 1);
        assert_eq!(player.play(&[at(20.0, 10.0)], 1), begin);
        let dragged = player.play(&[left(true), at(30.0, 10.0)], 1);
        assert!(dragged.x < -1.0, "{dragged}");
        let near = player.play(&[left(false), InputEvent::Wheel { by: [0.0, 2.0] }], 1);
        assert!((near.length() - 10.0 / 1.2).abs() < 1e-9);
        let far = player.play(&[InputEvent::Wheel { by: [0.0, -1e9] }], 1);
        assert!((far.length() - 1000.0).abs() < 1e-6);
    }
}
