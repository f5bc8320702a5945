//! The scene viewer: a game in which the eye moves, and with it the light of a mesh whose file has
//! none. The animation of a mesh plays in the frames' time.
//! Invariant: the eye stays on a sphere around its target, and never passes its poles. However long
//! a frame takes, it turns by a limited angle, and a key that was only tapped turns it by the same
//! angle everywhere. Rotations use rational functions instead of sines, so that a recorded session
//! is the same on every machine.

use cellray::game::{
    Axis, Button, DVec3, Frame, Game, Input, Key, Light, LightId, LightKind, Mouse, MouseButton,
    Shape, Start, View, World, WorldError,
};
use cellray::scene::RenderOptions;
use meshes::{Animation, Loaded};

/// The beginning of a viewer's name as a game, before the scene's name.
pub const VIEW: &str = "view ";
/// Rotation of the eye by a key or a stick, in radians a second: a quarter of a turn.
const TURN: f64 = std::f64::consts::FRAC_PI_2;
/// The longest time in seconds that counts for a frame. With it, who sees a frame a second still
/// turns by only an eighth of [`TURN`] from one to the next, and can steer.
const LONGEST: f64 = 0.125;
/// A key that goes down counts at once as held for this time in seconds: a tap turns by 3 degrees.
const TAP: f64 = 1.0 / 30.0;
/// The time in seconds after which a key that is still down counts as held and no longer as tapped.
/// Taps last a tenth of a second, and 0.15 s where a terminal doesn't report releases.
const PATIENCE: f64 = 0.2;
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

const CONTROLS: &[&str] = &[
    "arrows, a drag, left stick: turn the camera",
    "wheel, page keys, right stick: nearer, farther",
    "Home, Start: back to the scene's view",
];

pub struct Viewer {
    name: String,
    scene: scenes::Scene,
    render_options: RenderOptions,
    /// Whether the scene's light comes with the eye.
    has_headlight: bool,
    headlight: Option<Headlight>,
    /// The animation of the scene's mesh.
    animation: Option<Animation>,
    /// Where the player looks from at the beginning, if not by the scene's view.
    begins: Option<View>,
    /// The scene's own view.
    home: Orbit,
    orbit: Orbit,
    keys: HeldKeys,
    /// The last position of the mouse, relative to the picture's sides, because the picture's size
    /// may change from frame to frame.
    pointer: Option<[f64; 2]>,
}

impl Viewer {
    /// A viewer of this scene. If `has_headlight`, the scene's first light comes with the eye.
    #[must_use]
    pub fn new(scene: scenes::Scene, render_options: RenderOptions, has_headlight: bool) -> Self {
        let home = Orbit::of(&scene.view);
        Self {
            name: format!("{VIEW}{}", file_name(&scene.name)),
            home,
            orbit: home,
            scene,
            render_options,
            has_headlight,
            headlight: None,
            animation: None,
            begins: None,
            keys: HeldKeys::default(),
            pointer: None,
        }
    }

    /// A viewer of a scene's file. A light that the file lacks comes with the eye.
    #[must_use]
    pub fn of(loaded: Loaded, render_options: RenderOptions) -> Self {
        let viewer = Self::new(loaded.scene, render_options, loaded.added_light);
        Self { animation: loaded.animation, ..viewer }
    }

    /// The same scene, seen from this view instead of its own.
    #[must_use]
    pub fn seen_from(self, view: &View) -> Self {
        Self { begins: Some(view.clone()), ..self }
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
        self.home = Orbit::of(&aimed(&self.scene, world));
        self.orbit = match &self.begins {
            Some(view) => Orbit { first_distance: self.home.first_distance, ..Orbit::of(view) },
            None => self.home,
        };
        let light = world.lights().next().filter(|_| self.has_headlight);
        self.headlight = match light {
            Some(id) => Headlight::of(id, world.light(id)?, &self.home),
            None => None,
        };
        Ok(())
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        let Frame { input, delta, size, .. } = *frame;
        if input.key_pressed(Key::Home) || input.pad().is_some_and(|pad| pad.pressed(Button::Start))
        {
            self.orbit = self.home;
        }
        let drag = self.drag(input.mouse(), size);
        let held = input.mouse_held(MouseButton::Left);
        let [across, along] = if held { drag } else { [0.0; 2] };
        let mut key = |key| self.keys.seconds(input, key, delta);
        let [left, right, down, up] = [Key::Left, Key::Right, Key::Down, Key::Up].map(&mut key);
        let [farther, nearer] = [Key::PageDown, Key::PageUp].map(&mut key);
        let stick = |axis| {
            let value = input.pad().map_or(0.0, |pad| f64::from(pad.axis(axis)));
            value * delta.min(LONGEST)
        };
        // The scene follows the mouse; the eye follows keys and sticks.
        let right = TURN * (right - left + stick(Axis::LeftX)) - across;
        let up = TURN * (up - down - stick(Axis::LeftY)) + along;
        self.orbit.turn(right, up);
        let nearer = f64::from(input.mouse().wheel[1]) * NOTCH
            + (nearer - farther - stick(Axis::RightY)) * ZOOM;
        self.orbit.approach(nearer);
        let mesh = world.meshes().next();
        if let (Some(animation), Some(mesh)) = (&mut self.animation, mesh) {
            let (positions, normals) = animation.at(frame.time);
            world.shape_mesh(mesh, positions, normals)?;
        }
        if let Some(headlight) = &self.headlight {
            world.set_light(headlight.id, headlight.seen_from(&self.orbit))?;
        }
        world.look_from(self.orbit.eye(), self.orbit.at)
    }
}

/// The scene's view, with a point to turn around in the middle of the picture. It is the point that
/// the file names if that is in the scene and not before what one sees there, such as the centre of
/// a sphere. Otherwise it is what one sees in the middle, and if that is nothing, the point on the
/// line of sight that is nearest to the middle of the scene.
fn aimed(scene: &scenes::Scene, world: &World) -> View {
    let view = &scene.view;
    let sight = view.at - view.from;
    let named = sight.length();
    let hit = world.cast_ray(view.from, sight).map(|hit| hit.distance);
    let (low, high) = bounds(scene);
    let is_within = low.cmple(view.at).all() && view.at.cmple(high).all();
    let distance = match hit {
        Some(hit) if !is_within || named < hit => hit,
        None if !is_within => {
            let depth = (low.midpoint(high) - view.from).dot(sight) / named;
            if depth > 0.0 { depth } else { named }
        }
        _ => named,
    };
    let aimed = View { at: view.from + sight * (distance / named), ..view.clone() };
    // A distance that is very small or not finite shows nothing.
    match aimed.camera(2, 2) {
        Ok(_) => aimed,
        Err(_) => view.clone(),
    }
}

/// The lower and upper corner of a box around the scene's corners and spheres.
fn bounds(scene: &scenes::Scene) -> (DVec3, DVec3) {
    let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let of = |places: &[DVec3], radius: f64| {
        let places = places.iter();
        places.fold(nothing, |(low, high), &place| {
            (low.min(place - radius), high.max(place + radius))
        })
    };
    let objects = scene.objects.iter().map(|object| match &object.shape {
        Shape::Sphere { centre, radius } => of(&[*centre], radius.abs()),
        Shape::Cone { base, apex, .. } => of(&[*base, *apex], 0.0),
        Shape::Polygon { vertices } | Shape::Patch { vertices, .. } => of(vertices, 0.0),
    });
    let mesh = scene.mesh.as_ref().and_then(|mesh| mesh.bounds());
    objects.chain(mesh).fold(nothing, |all, one| (all.0.min(one.0), all.1.max(one.1)))
}

/// A light that keeps its direction as seen from the eye.
struct Headlight {
    id: LightId,
    colour: Option<DVec3>,
    /// The light's direction to the right of the eye, up, and backwards.
    direction: [f64; 3],
}

impl Headlight {
    /// A light of a scene that is seen from here; `None` if it has a place of its own.
    fn of(id: LightId, light: Light, orbit: &Orbit) -> Option<Self> {
        let LightKind::Directional { to_light } = light.kind else {
            return None;
        };
        Some(Self {
            id,
            colour: light.colour,
            direction: orbit.axes().map(|axis| axis.dot(to_light)),
        })
    }

    fn seen_from(&self, orbit: &Orbit) -> Light {
        let [right, up, back] = orbit.axes();
        let [to_right, to_up, to_back] = self.direction;
        Light {
            kind: LightKind::Directional {
                to_light: right * to_right + up * to_up + back * to_back,
            },
            colour: self.colour,
        }
    }
}

/// How long the keys that turn the eye have been down.
#[derive(Default)]
struct HeldKeys(Vec<(Key, f64)>);

impl HeldKeys {
    /// The seconds for which a key counts as held in this frame, which took `delta`. A tap counts
    /// for [`TAP`] in the frame that reports it, and no longer, however long the frames are.
    fn seconds(&mut self, input: &Input, key: Key, delta: f64) -> f64 {
        let known = self.0.iter().position(|(held, _)| *held == key);
        if input.key_pressed(key) {
            match known {
                Some(known) => self.0[known].1 = 0.0,
                None => self.0.push((key, 0.0)),
            }
            return TAP;
        }
        let Some(known) = known else {
            return 0.0;
        };
        if !input.key_held(key) || input.key_released(key) {
            self.0.swap_remove(known);
            return 0.0;
        }
        let held = &mut self.0[known].1;
        *held += delta;
        (*held - PATIENCE).min(delta).clamp(0.0, LONGEST)
    }
}

/// The file's name without its folders, so that a recording can be played back with the scene at
/// another path. The world's checksum shows whether the content is the same.
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

    /// The directions to the right of the eye, up in its picture, and back.
    fn axes(&self) -> [DVec3; 3] {
        let right = self.up.cross(self.towards).normalize();
        [right, self.towards.cross(right), self.towards]
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
        let distance =
            if part >= 0.0 { self.distance / (1.0 + part) } else { self.distance * (1.0 - part) };
        let (min, max) = (self.first_distance / FARTHEST, self.first_distance * FARTHEST);
        self.distance = distance.clamp(min, max);
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

    fn scene() -> scenes::Scene {
        let text = "v\nfrom 0 -10 0\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 64 36\n\
                    l 5 -5 5\nf 1 1 1 1 0 0 0 0\ns 0 0 0 1\n";
        scenes::parse(text.as_bytes(), "a scene", &scenes::Limits::default()).expect("a scene")
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
            Self::of(scene(), false)
        }

        fn of(scene: scenes::Scene, has_headlight: bool) -> Self {
            let viewer = Viewer::new(scene, RenderOptions::default(), has_headlight);
            let (mut viewer, mut world) = (viewer, World::new());
            let start = Start { seed: 0, size: (64, 36) };
            viewer.set_up(&mut world, &start).expect("a world");
            Self { viewer, world, input: Input::default(), frame: 0, size: (64, 36) }
        }

        /// Runs frames with these events in the first one. Returns the eye's position at the end.
        fn play(&mut self, events: &[InputEvent], frames: u64) -> DVec3 {
            self.play_slowly(events, frames, 0.05)
        }

        /// The same, with frames of `delta` seconds.
        fn play_slowly(&mut self, events: &[InputEvent], frames: u64, delta: f64) -> DVec3 {
            for number in 0..frames {
                self.input.begin_frame();
                if number == 0 {
                    events.iter().for_each(|event| self.input.apply(event));
                }
                let frame = Frame {
                    number: self.frame,
                    time: 0.0,
                    delta,
                    input: &self.input,
                    size: self.size,
                    last: None,
                };
                self.viewer.update(&mut self.world, &frame).expect("a frame");
                self.frame += 1;
            }
            self.world.view().from
        }
    }

    fn key(key: Key, down: bool) -> InputEvent {
        InputEvent::Key { key, down }
    }

    #[test]
    fn keys_orbit_eye_around_scene() {
        let mut player = Player::new();
        let begin = player.play(&[], 1);
        assert_eq!(begin, DVec3::new(0.0, -10.0, 0.0));
        let right = player.play(&[key(Key::Right, true)], 14);
        assert!(right.x > 5.0 && right.y < 0.0 && right.z == 0.0, "{right}");
        assert!((right.length() - 10.0).abs() < 1e-9);
        let up = player.play(&[key(Key::Right, false), key(Key::Up, true)], 9);
        assert!(up.z > 2.0 && (up.length() - 10.0).abs() < 1e-9, "{up}");
        let home = player.play(&[key(Key::Up, false), key(Key::Home, true)], 1);
        assert_eq!(home, begin);
    }

    /// The angle between two directions from the origin in degrees, if it is small: the chord's.
    fn degrees(a: DVec3, b: DVec3) -> f64 {
        a.normalize().distance(b.normalize()).to_degrees()
    }

    #[test]
    fn tap_turns_by_one_step_at_any_frame_rate() {
        let tapped = [key(Key::Right, true), key(Key::Right, false)];
        for delta in [1.0 / 240.0, 1.0 / 60.0, 0.05, 0.19, 1.0, 30.0] {
            // Both events in one frame, or the release only in the next.
            let mut player = Player::new();
            let begin = player.play_slowly(&[], 1, delta);
            player.play_slowly(&tapped, 1, delta);
            let one = degrees(begin, player.play_slowly(&[], 5, delta));
            player.play_slowly(&tapped[..1], 1, delta);
            let two = degrees(begin, player.play_slowly(&tapped[1..], 5, delta));
            assert!((one - 3.0).abs() < 0.01, "{delta}: {one}");
            assert!((two - 6.0).abs() < 0.02, "{delta}: {two}");
        }
    }

    #[test]
    fn held_key_turns_at_stated_speed_in_limited_steps() {
        let speed = TURN.to_degrees();
        for delta in [1.0 / 240.0, 1.0 / 60.0, 0.05, 0.1, 1.0, 30.0] {
            let mut player = Player::new();
            player.play_slowly(&[key(Key::Right, true)], 1, delta);
            let waits = (PATIENCE / delta) as u64 + 1;
            let mut before = player.play_slowly(&[], waits, delta);
            for _ in 0..4 {
                let now = player.play_slowly(&[], 1, delta);
                let turned = degrees(before, now);
                let expected = speed * delta.min(LONGEST);
                assert!((turned - expected).abs() < 0.1, "{delta}: {turned}");
                assert!(turned < 12.0, "{delta}: {turned}");
                before = now;
            }
        }
    }

    /// The scene, seen along a line from the eye.
    fn seen(from: DVec3, at: DVec3) -> scenes::Scene {
        let mut scene = scene();
        scene.view = View { from, at, ..scene.view };
        scene
    }

    #[test]
    fn eye_orbits_object_in_picture_centre() {
        let eye = DVec3::new(0.0, -10.0, 0.0);
        for (name, from, at, target) in [
            ("the file's point, in the ball", eye, DVec3::ZERO, DVec3::ZERO),
            ("a point close to the eye", eye, eye + DVec3::Y, DVec3::new(0.0, -1.0, 0.0)),
            (
                "a point behind the ball",
                eye,
                DVec3::new(0.0, 500.0, 0.0),
                DVec3::new(0.0, -1.0, 0.0),
            ),
            // The ray passes the ball at the side.
            ("nothing", eye + 3.0 * DVec3::X, eye + 3.0 * DVec3::X + DVec3::Y, 3.0 * DVec3::X),
            ("nothing ahead", eye, eye - 7.0 * DVec3::Y, eye - 7.0 * DVec3::Y),
        ] {
            let mut player = Player::of(seen(from, at), false);
            let begin = player.play(&[], 1);
            assert!(begin.distance(from) < 1e-9, "{name}: {begin}");
            for held in [Key::Right, Key::Up, Key::Left] {
                player.play(&[key(held, true)], 20);
                player.play(&[key(held, false)], 1);
                let view = player.world.view();
                assert!(view.at.distance(target) < 1e-9, "{name}: {}", view.at);
                let pixel = player.world.project(target, (65, 37)).expect("ahead");
                let off = [pixel[0] - 32.0, pixel[1] - 18.0];
                assert!(off.iter().all(|off| off.abs() < 1e-3), "{name}: {pixel:?}");
                let distance = view.from.distance(target);
                assert!((distance - from.distance(target)).abs() < 1e-9, "{name}");
            }
        }
    }

    #[test]
    fn only_headlight_moves_with_eye() {
        let lit = |has_headlight: bool| {
            let mut scene = scene();
            scene.lights[0].kind = LightKind::Directional { to_light: DVec3::new(-1.0, -2.0, 2.0) };
            Player::of(scene, has_headlight)
        };
        // Where the light is, as the eye has it: to the right, up and back.
        let from_the_eye = |player: &Player| {
            let id = player.world.lights().next().expect("a light");
            let LightKind::Directional { to_light } = player.world.light(id).unwrap().kind else {
                panic!("it has become another light");
            };
            player.viewer.orbit.axes().map(|axis| axis.dot(to_light))
        };
        let far = |a: [f64; 3], b: [f64; 3]| DVec3::from(a).distance(DVec3::from(b));
        for has_headlight in [true, false] {
            let mut player = lit(has_headlight);
            player.play(&[], 1);
            let begin = from_the_eye(&player);
            assert!(far(begin, [-1.0, 2.0, 2.0]) < 1e-9, "{begin:?}");
            player.play(&[key(Key::Right, true), key(Key::Up, true)], 20);
            let moved = far(begin, from_the_eye(&player));
            assert_eq!(moved < 1e-9, has_headlight, "{moved}");
        }
        // A light with a place in the scene stays there.
        let mut player = Player::of(scene(), true);
        player.play(&[key(Key::Right, true)], 20);
        let id = player.world.lights().next().expect("a light");
        let place = LightKind::Point { position: DVec3::new(5.0, -5.0, 5.0), range: f64::INFINITY };
        assert_eq!(player.world.light(id).unwrap().kind, place);
    }

    #[test]
    fn animation_plays_in_the_time_of_frames() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/reef.glb");
        let loaded = meshes::load(file.as_ref()).expect("a scene");
        let mut animation = loaded.animation.clone().expect("an animation");
        let mut viewer = Viewer::of(loaded, RenderOptions::default());
        let mut world = World::new();
        viewer.set_up(&mut world, &Start { seed: 0, size: (64, 36) }).expect("a world");
        let input = Input::default();
        for time in [0.0, 1.25, 5.5] {
            let size = (64, 36);
            let frame = Frame { number: 0, time, delta: 0.0, input: &input, size, last: None };
            viewer.update(&mut world, &frame).expect("a frame");
            let mesh = world.to_nff().mesh.expect("a mesh");
            assert_eq!((&mesh.positions[..], &mesh.normals[..]), animation.at(time), "{time}");
        }
    }

    #[test]
    fn eye_stops_before_poles() {
        for (held, sign) in [(Key::Up, 1.0), (Key::Down, -1.0)] {
            let mut player = Player::new();
            let eye = player.play(&[key(held, true)], 500);
            assert!(eye.z * sign > 9.5 && eye.z * sign < 10.0 && eye.y < 0.0, "{eye}");
        }
        // A drag across many pictures doesn't either.
        let mut orbit = Orbit::of(&scene().view);
        for up in [9.0, -50.0, 3.2, 1e6] {
            orbit.turn(0.0, up);
            assert!(orbit.eye().y < 0.0, "{}", orbit.eye());
        }
    }

    #[test]
    fn drag_continues_after_resolution_change() {
        let mut player = Player::new();
        let at = |x: f32, y: f32| InputEvent::MouseMoved { to: [x, y] };
        let left = InputEvent::MouseButton { button: MouseButton::Left, down: true };
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
    fn scene_name_is_independent_of_path() {
        for path in ["x.nff", "./x.nff", "/there/../x.nff"] {
            let scene = scenes::Scene { name: path.into(), ..scene() };
            assert_eq!(Viewer::new(scene, RenderOptions::default(), false).name(), "view x.nff");
        }
    }

    #[test]
    fn drag_turns_scene_and_wheel_zooms() {
        let mut player = Player::new();
        let at = |x: f32, y: f32| InputEvent::MouseMoved { to: [x, y] };
        let left = |down| InputEvent::MouseButton { button: MouseButton::Left, down };
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
