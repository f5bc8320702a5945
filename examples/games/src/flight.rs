//! A flight over mountains and lakes, through rings.
//!
//! The plane flies itself to the next ring until somebody steers. It can't crash: above ground and
//! water it climbs by itself, and at the edge of the range it turns back.
//!
//! | | keyboard and mouse | pad |
//! |---|---|---|
//! | roll to the left, to the right | left and right arrow, A D, mouse dragged | left stick |
//! | nose down, nose up | up and down arrow, W S, mouse dragged | left stick |
//! | faster, slower | page keys, wheel | R2, L2 |
//! | let it fly itself | Space | Cross |
//! | drop a rock, which makes a crater | B | Square |

use std::f64::consts::TAU;
use std::sync::Arc;

use cellray::game::{
    Axis, Button, DVec3, Entry, Frame, Game, HeightField, Input, Key, Light, Material, Model,
    MouseButton, ObjectId, RenderOptions, Shape, Sky, Start, View, World, WorldError,
};
use meshes::mountains;

use crate::rock::Rock;
use crate::steps::{STEP, Steps};

/// The game's name.
pub const NAME: &str = "flight";
/// The controls.
pub const CONTROLS: &[&str] = &[
    "left and right arrow, A D, mouse dragged, left stick: roll, which turns the plane",
    "up and down arrow, W S, mouse dragged, left stick: nose down, nose up",
    "page keys, wheel, R2 and L2: faster, slower",
    "Space, Cross: let it fly itself",
    "B, Square: drop a rock, which makes a crater",
];
/// The entry in the table of games.
pub const ENTRY: Entry = Entry {
    name: NAME,
    line: "a flight over mountains and lakes, through rings",
    new: || Box::new(Flight::default()),
    open: None,
};

/// The squares of the range along a side, of 10 m each.
const SQUARES: u32 = 768;
/// Rings of a round.
pub const RINGS: u32 = 12;
/// The spheres that a ring is made of.
const BEADS: usize = 14;
/// The radius of a ring and of its spheres.
const RING: f64 = 70.0;
const BEAD: f64 = 6.0;
/// The height of rings above the ground.
const RING_HEIGHT: f64 = 170.0;
/// Metres a second initially, at least and at most.
const SPEED: f64 = 130.0;
const SPEEDS: (f64, f64) = (60.0, 260.0);
/// The speed of sharp turns that the plane makes by itself, and the share of a change of speed that
/// a second makes. Faster ones would be wider than the way between rings.
const TURNING: f64 = 70.0;
const THROTTLE: f64 = 1.5;
/// The height above ground and water at which the plane climbs, and the minimum.
const LOWEST: f64 = 35.0;
const FLOOR: f64 = 12.0;
/// The largest angles of roll and pitch, and the shares of a change that a second makes.
const ROLL: f64 = 1.0;
const PITCH: f64 = 0.6;
const AGILITY: f64 = 2.5;
/// The part of the range, from its middle on, beyond which it turns back.
const INSIDE: f64 = 0.8;

/// The game.
pub struct Flight {
    ground: Option<HeightField>,
    /// The fuselage, both wings, the tailplane's halves, and the fin.
    parts: [ObjectId; 6],
    beads: [ObjectId; BEADS],
    rock: Rock,
    steps: Steps,
    place: DVec3,
    /// Angles in radians: from -z towards x, upwards, and to the right.
    heading: f64,
    pitch: f64,
    roll: f64,
    /// Metres a second, and those that the player wants.
    speed: f64,
    wanted: f64,
    /// Where the player holds the stick: to the right, and upwards.
    stick: [f64; 2],
    flies_itself: bool,
    /// The next ring, and the rings that were met.
    next: u32,
    met: u32,
}

impl Default for Flight {
    fn default() -> Self {
        Self {
            ground: None,
            parts: [ObjectId::default(); 6],
            beads: [ObjectId::default(); BEADS],
            rock: Rock::default(),
            steps: Steps::default(),
            place: DVec3::ZERO,
            heading: 0.0,
            pitch: 0.0,
            roll: 0.0,
            speed: SPEED,
            wanted: SPEED,
            stick: [0.0; 2],
            flies_itself: true,
            next: 0,
            met: 0,
        }
    }
}

impl Flight {
    /// Where the plane is.
    #[must_use]
    pub fn place(&self) -> DVec3 {
        self.place
    }

    /// The rings that it has flown through.
    #[must_use]
    pub fn met(&self) -> u32 {
        self.met
    }

    /// The height of what is below a place: of the ground, or of a lake.
    #[must_use]
    pub fn below(&self, place: DVec3) -> f64 {
        let ground = self.ground.as_ref().map_or(0.0, |ground| ground.ground(place));
        ground.max(mountains::LAKES)
    }

    /// The middle of a ring, and the direction through it: from the one before it to the one after.
    fn ring(&self, number: u32) -> (DVec3, DVec3) {
        let half = self.ground.as_ref().map_or(0.0, |ground| -ground.corner.x);
        let place = |number: u32| {
            let number = f64::from(number % RINGS);
            let (sine, cosine) = libm::sincos(TAU * number / f64::from(RINGS));
            // The way is a circle that wanders to the middle and away.
            let far = half * (0.55 + 0.08 * libm::sin(2.4 * number));
            DVec3::new(far * cosine, 0.0, far * sine)
        };
        let middle = place(number);
        let through = (place(number + 1) - place(number + RINGS - 1)).normalize_or_zero();
        (middle.with_y(self.below(middle) + RING_HEIGHT), through)
    }

    /// The plane's own axes: forward, up, and to the right.
    fn axes(&self) -> [DVec3; 3] {
        let (turn_sine, turn_cosine) = libm::sincos(self.heading);
        let (pitch_sine, pitch_cosine) = libm::sincos(self.pitch);
        let (roll_sine, roll_cosine) = libm::sincos(self.roll);
        let forward = DVec3::new(turn_sine * pitch_cosine, pitch_sine, -turn_cosine * pitch_cosine);
        let level = DVec3::new(turn_cosine, 0.0, turn_sine);
        let up = level.cross(forward);
        let right = level * roll_cosine - up * roll_sine;
        [forward, up * roll_cosine + level * roll_sine, right]
    }

    fn place_ring(&self, world: &mut World) -> Result<(), WorldError> {
        let (middle, through) = self.ring(self.next);
        let across = DVec3::Y.cross(through);
        for (number, &bead) in self.beads.iter().enumerate() {
            let (sine, cosine) = libm::sincos(TAU * number as f64 / BEADS as f64);
            world.move_to(bead, middle + RING * (cosine * across + sine * DVec3::Y))?;
        }
        Ok(())
    }

    /// The cones that the plane is made of.
    fn shapes(&self) -> [Shape; 6] {
        let [forward, up, right] = self.axes();
        let at = |ahead: f64, above: f64, aside: f64| {
            self.place + ahead * forward + above * up + aside * right
        };
        let cone = |base, base_radius, apex, apex_radius| Shape::Cone {
            base,
            base_radius,
            apex,
            apex_radius,
        };
        let wing = |way: f64| cone(at(1.0, 0.0, 0.0), 1.5, at(-3.0, 0.4, way * 11.0), 0.25);
        let tail = |way: f64| cone(at(-8.0, 0.5, 0.0), 0.7, at(-9.6, 0.7, way * 4.0), 0.15);
        [
            cone(at(-9.5, 0.5, 0.0), 0.4, at(7.5, 0.0, 0.0), 1.1),
            wing(-1.0),
            wing(1.0),
            tail(-1.0),
            tail(1.0),
            cone(at(-8.0, 0.5, 0.0), 0.7, at(-10.0, 4.2, 0.0), 0.15),
        ]
    }

    /// What the player does with the stick.
    fn steer(&mut self, input: &Input, seconds: f64) {
        let pad = input.pad();
        let axis = |axis| pad.map_or(0.0, |pad| pad.stick(axis));
        let key = |less, more| f64::from(input.key_axis(less, more));
        let mouse = input.mouse();
        let dragged = if input.mouse_held(MouseButton::Left) { mouse.motion } else { [0.0; 2] };
        let roll = key(Key::Left, Key::Right) + key(Key::A, Key::D) + axis(Axis::LeftX);
        let pitch = key(Key::Up, Key::Down) + key(Key::W, Key::S) + axis(Axis::LeftY);
        let steers = [roll + 0.05 * f64::from(dragged[0]), pitch + 0.05 * f64::from(dragged[1])];
        if steers != [0.0; 2] {
            self.flies_itself = false;
        }
        if input.key_pressed(Key::Space) || pad.is_some_and(|pad| pad.pressed(Button::Cross)) {
            self.flies_itself = true;
        }
        if input.key_pressed(Key::B) || pad.is_some_and(|pad| pad.pressed(Button::Square)) {
            let [forward, up, _] = self.axes();
            self.rock.drop(self.place - 4.0 * up, self.speed * forward);
        }
        self.stick = steers.map(|way| way.clamp(-1.0, 1.0));
        let faster = key(Key::PageDown, Key::PageUp) + axis(Axis::R2) - axis(Axis::L2);
        let change = 60.0 * faster * seconds + 15.0 * f64::from(mouse.wheel[1]);
        self.wanted = (self.wanted + change).clamp(SPEEDS.0, SPEEDS.1);
    }

    /// The stick of the plane that flies to a place by itself.
    fn towards(&self, goal: DVec3) -> [f64; 2] {
        let way = goal - self.place;
        let turn = libm::remainder(libm::atan2(way.x, -way.z) - self.heading, TAU);
        let across = libm::hypot(way.x, way.z);
        // The ground ahead counts, too.
        let [forward, ..] = self.axes();
        let ahead = (1..=4).map(|step| {
            let away = 120.0 * f64::from(step);
            let rise = self.below(self.place + away * forward) + 2.0 * LOWEST - self.place.y;
            libm::atan2(rise, away)
        });
        let climb = ahead.fold(libm::atan2(way.y, across), f64::max);
        [
            (2.0 * turn).clamp(-1.0, 1.0),
            ((climb / PITCH) - self.pitch / PITCH * 0.2).clamp(-1.0, 1.0),
        ]
    }

    fn step(&mut self) {
        let half = self.ground.as_ref().map_or(0.0, |ground| -ground.corner.x) * INSIDE;
        let is_outside = self.place.x.abs().max(self.place.z.abs()) > half;
        let goal = match (is_outside, self.flies_itself) {
            (true, _) => Some(DVec3::ZERO.with_y(self.place.y)),
            (false, true) => Some(self.ring(self.next).0),
            (false, false) => None,
        };
        let [roll, pitch] = goal.map_or(self.stick, |goal| self.towards(goal));
        let is_sharp = goal.is_some() && roll.abs() > 0.8;
        let speed = if is_sharp { self.wanted.min(TURNING) } else { self.wanted };
        self.speed += (speed - self.speed) * THROTTLE * STEP;
        let part = AGILITY * STEP;
        self.roll += (ROLL * roll - self.roll) * part;
        self.pitch += (PITCH * pitch - self.pitch) * part;
        // A plane turns by its roll.
        self.heading += 9.81 * libm::tan(self.roll) / self.speed * 2.5 * STEP;
        let [forward, ..] = self.axes();
        self.place += self.speed * STEP * forward;
        let lowest = self.below(self.place) + LOWEST;
        if self.place.y < lowest {
            self.place.y += (lowest - self.place.y) * 8.0 * STEP;
            self.pitch += (0.3 - self.pitch).max(0.0) * 4.0 * STEP;
            self.place.y = self.place.y.max(lowest - LOWEST + FLOOR);
        }
    }

    /// Whether the last step went through the next ring.
    fn has_met(&self, before: DVec3) -> bool {
        let (middle, through) = self.ring(self.next);
        let [old, new] = [before, self.place].map(|place| (place - middle).dot(through));
        old * new <= 0.0 && self.place.distance(middle) < RING
    }

    fn look(&self, world: &mut World) -> Result<(), WorldError> {
        let [forward, up, _] = self.axes();
        let eye = self.place - 42.0 * forward + 9.0 * DVec3::Y;
        let eye = eye.with_y(eye.y.max(self.below(eye) + 12.0));
        world.set_view(View {
            from: eye,
            at: self.place + 90.0 * forward,
            up: DVec3::Y + 0.35 * up,
            angle: 48.0,
            ..world.view().clone()
        })
    }
}

impl Game for Flight {
    fn name(&self) -> &str {
        NAME
    }

    fn controls(&self) -> &[&str] {
        CONTROLS
    }

    fn set_up(&mut self, world: &mut World, start: &Start) -> Result<(), WorldError> {
        world.set_name(NAME);
        world.set_render_options(RenderOptions {
            model: Model::Whitted,
            ray_depth: 2,
            ..RenderOptions::default()
        });
        world.set_background(DVec3::new(0.74, 0.83, 0.92))?;
        world.set_sky(Some(Sky::of_day(DVec3::Y)))?;
        world.set_fog(Some(mountains::HAZE))?;
        world.set_ambient(DVec3::new(0.16, 0.19, 0.24))?;
        world.add_light(Light::sun(DVec3::new(-0.8, 0.55, -0.25)).coloured(0.95, 0.88, 0.76))?;
        let ground = mountains::field(SQUARES);
        let white = world.add_material(Material::matte(1.0, 1.0, 1.0))?;
        world.add_terrain(Arc::new(ground.clone()), white)?;
        let lake = world.add_material((&mountains::lake()).into())?;
        let (low, high) = ground.bounds();
        let corners = [(low.x, low.z), (low.x, high.z), (high.x, high.z), (high.x, low.z)];
        let corners = corners.map(|(x, z)| DVec3::new(x, mountains::LAKES, z));
        world.add_polygon(&corners, lake)?;
        self.ground = Some(ground);

        let paint = world.add_material(Material::matte(0.92, 0.93, 0.95))?;
        let red = world.add_material(Material::matte(0.85, 0.16, 0.12))?;
        let glow = world.add_material(Material::flat(1.0, 0.72, 0.2))?;
        self.next = (start.seed % u64::from(RINGS)) as u32;
        let (before, through) = self.ring(self.next);
        self.next = (self.next + 1) % RINGS;
        self.place = before;
        self.heading = libm::atan2(through.x, -through.z);
        for (number, shape) in self.shapes().into_iter().enumerate() {
            let material = if number == 0 { paint } else { red };
            self.parts[number] = world.add(shape, material)?;
        }
        for bead in &mut self.beads {
            *bead = world.add_sphere(before, BEAD, glow)?;
        }
        self.rock = Rock::new(world)?;
        self.place_ring(world)?;
        self.look(world)
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        self.steer(frame.input, frame.delta);
        for _ in 0..self.steps.of(frame.delta) {
            let before = self.place;
            self.step();
            self.rock.step();
            if self.has_met(before) {
                self.met += 1;
                self.next = (self.next + 1) % RINGS;
                self.place_ring(world)?;
            }
        }
        for (&part, shape) in self.parts.iter().zip(self.shapes()) {
            world.reshape(part, shape)?;
        }
        if let Some(ground) = &mut self.ground {
            self.rock.show(world, ground)?;
        }
        self.look(world)
    }

    fn status(&self) -> String {
        let height = self.place.y - self.below(self.place);
        format!("{} rings, {:.0} km/h, {height:.0} m", self.met, 3.6 * self.speed)
    }
}
