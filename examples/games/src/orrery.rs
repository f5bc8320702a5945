//! The sun, its planets, moons and rings.
//!
//! Periods, eccentricities and inclinations are the real ones. Sizes and distances are compressed
//! until everything fits into one picture of 16:9 and nothing passes through anything else: it is
//! an orrery, not a map. Initially, a second is six days.
//!
//! | | keyboard and mouse | pad |
//! |---|---|---|
//! | the next body, the one before | right and left arrow, 0 to 8 | R1, L1 |
//! | time faster, slower | up and down arrow | up and down |
//! | stop time, let it go on | Space | Cross |
//! | hide the names, show them | N | Triangle |
//! | turn the eye | A D W S, mouse dragged | right stick |
//! | nearer, farther | page keys, wheel | R2, L2 |

mod bodies;

use std::f64::consts::TAU;

use cellray::game::{
    Button, DVec3, Entry, Frame, Game, Input, Key, Label, Light, Material, Model, ObjectId,
    OrbitCamera, RenderOptions, Shader, Side, Start, World, WorldError,
};
use rand::{Rng as _, SeedableRng as _};
use rand_xoshiro::Xoshiro256PlusPlus;

use self::bodies::{MOONS, Moon, PLANETS, Planet, RINGS, Ring, SUN_RADIUS};
use crate::steps::{STEP, Steps};

/// The game's name.
pub const NAME: &str = "orrery";
/// The controls.
pub const CONTROLS: &[&str] = &[
    "left and right arrow, 0 to 8, L1 and R1: the body to follow",
    "up and down arrow, up and down on the pad: time faster, slower",
    "Space, Cross: stop time, let it go on",
    "N, Triangle: hide the names, show them",
    "A D W S, mouse dragged, right stick: turn the eye",
    "page keys, wheel, R2 and L2: nearer, farther",
];
/// The entry in the table of games.
pub const ENTRY: Entry = Entry {
    name: NAME,
    line: "the sun, its planets, moons and rings",
    new: || Box::new(Orrery::default()),
    open: None,
};

const STARS: usize = 300;
/// The distance of the stars.
const SKY: f64 = 140.0;
/// The eye's distance from the sun, and its height, when it follows the sun. Neptune's orbit just
/// fits into the picture.
const OVERVIEW: f64 = 42.0;
const OVERVIEW_RISE: f64 = 0.34;
/// The minimum and the maximum distance of the eye from the body that it follows, and the
/// minimum from the sun.
const DISTANCES: (f64, f64) = (1.2, 60.0);
const SUN_DISTANCE: f64 = 2.0;
/// The minimum distance from the surface of the sun or a planet.
const CLEARANCE: f64 = 0.02;
/// Days a second initially and at most.
const SPEED: f64 = 6.0;
const SPEEDS: (f64, f64) = (0.25, 400.0);
/// How fast the eye follows a body, as the approximate share of the remaining distance for each
/// second.
const FOLLOWS: f64 = 4.0;
/// What remains of the way when the eye counts as arrived, relative to its distance from the body;
/// and of its turn, in radians. This is less than a pixel. An eye that only came ever nearer would
/// keep the picture from its rest, and from its full resolution, for many seconds.
const ARRIVED: f64 = 5e-4;

/// Radians from the sun's direction to the direction from which a planet looks best, with a part
/// of it dark.
const ASIDE: f64 = 0.75;

const DIGITS: [Key; 9] = [
    Key::Digit0,
    Key::Digit1,
    Key::Digit2,
    Key::Digit3,
    Key::Digit4,
    Key::Digit5,
    Key::Digit6,
    Key::Digit7,
    Key::Digit8,
];

/// The game.
pub struct Orrery {
    planets: [ObjectId; PLANETS.len()],
    moons: [ObjectId; MOONS.len()],
    /// For every stone: its ring, its number in the ring, and its object.
    stones: Vec<(&'static Ring, u32, ObjectId)>,
    places: [DVec3; PLANETS.len()],
    steps: Steps,
    days: f64,
    speed: f64,
    stopped: bool,
    /// The body that the eye follows. 0 is the sun.
    followed: usize,
    /// The point that it looks at, which moves towards that body.
    at: DVec3,
    eye: DVec3,
    /// Whether the bodies have their names beside them.
    has_names: bool,
    orbit: OrbitCamera,
    /// The wanted distance from the body.
    distance: f64,
    /// Radians that the eye still turns, until it sees the day side of the body.
    swing: f64,
}

impl Default for Orrery {
    fn default() -> Self {
        Self {
            planets: [ObjectId::default(); PLANETS.len()],
            moons: [ObjectId::default(); MOONS.len()],
            stones: Vec::new(),
            places: [DVec3::ZERO; PLANETS.len()],
            steps: Steps::default(),
            days: 0.0,
            speed: SPEED,
            stopped: false,
            followed: 0,
            at: DVec3::ZERO,
            eye: DVec3::ZERO,
            has_names: true,
            orbit: OrbitCamera {
                turn: 0.5,
                rise: OVERVIEW_RISE,
                distance: OVERVIEW,
                distances: DISTANCES,
                rises: (-1.4, 1.4),
            },
            distance: OVERVIEW,
            swing: 0.0,
        }
    }
}

impl Orrery {
    /// The days since the beginning.
    #[must_use]
    pub fn days(&self) -> f64 {
        self.days
    }

    /// The positions of the planets, from the sun outwards.
    #[must_use]
    pub fn places(&self) -> &[DVec3] {
        &self.places
    }

    /// The number of the planet that the eye follows, from 1. 0 is the sun.
    #[must_use]
    pub fn followed(&self) -> usize {
        self.followed
    }

    fn add_sky(world: &mut World, seed: u64) -> Result<(), WorldError> {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        let materials = [
            world.add_material(Material::flat(1.0, 0.95, 0.85))?,
            world.add_material(Material::flat(0.62, 0.68, 0.8))?,
            world.add_material(Material::flat(0.42, 0.4, 0.4))?,
        ];
        for star in 0..STARS {
            let direction = loop {
                let mut part = || rng.random_range(-1.0..1.0);
                let place = DVec3::new(part(), part(), part());
                if (0.1..=1.0).contains(&place.length_squared()) {
                    break place / place.length();
                }
            };
            let radius = rng.random_range(0.16..0.36);
            let material = materials[star % materials.len()];
            let star = world.add_sphere(direction * SKY, radius, material)?;
            world.fix(star)?;
        }
        Ok(())
    }

    fn add_sun(world: &mut World) -> Result<(), WorldError> {
        let glow = world.add_material(Material::flat(1.0, 0.84, 0.36))?;
        // With a negative radius, only the inside of the sphere is visible to light, so its own
        // surface casts no shadow on anything outside. An eye outside sees its far side, which has
        // the same outline.
        let sun = world.add_sphere(DVec3::ZERO, -SUN_RADIUS, glow)?;
        world.fix(sun)?;
        world.add_light(Light::at(DVec3::ZERO).coloured(1.0, 0.96, 0.88))?;
        Ok(())
    }

    fn add_bodies(&mut self, world: &mut World) -> Result<(), WorldError> {
        let stuff = |[red, green, blue]: [f64; 3], shine: f64| Material {
            diffuse: 1.0,
            specular: shine,
            shine: 14.0,
            shader: if shine > 0.0 { Shader::Phong } else { Shader::Lambert },
            ..Material::matte(red, green, blue)
        };
        for (number, planet) in PLANETS.iter().enumerate() {
            let material = world.add_material(stuff(planet.colour, planet.shine))?;
            self.planets[number] = world.add_sphere(DVec3::ZERO, planet.radius, material)?;
        }
        let rock = world.add_material(stuff([0.72, 0.7, 0.66], 0.0))?;
        for (number, moon) in MOONS.iter().enumerate() {
            self.moons[number] = world.add_sphere(DVec3::ZERO, moon.radius, rock)?;
        }
        self.stones.clear();
        for ring in RINGS {
            let material = world.add_material(stuff(ring.colour, 0.0))?;
            for stone in 0..ring.stones {
                let object = world.add_sphere(DVec3::ZERO, ring.stone, material)?;
                self.stones.push((ring, stone, object));
            }
        }
        Ok(())
    }

    fn place_bodies(&mut self, world: &mut World) -> Result<(), WorldError> {
        for (number, planet) in PLANETS.iter().enumerate() {
            self.places[number] = planet.place(self.days);
            world.move_to(self.planets[number], self.places[number])?;
        }
        for (moon, &object) in MOONS.iter().zip(&self.moons) {
            world.move_to(object, self.places[moon.planet] + moon.place(self.days))?;
        }
        for &(ring, stone, object) in &self.stones {
            let centre = ring.planet.map_or(DVec3::ZERO, |planet| self.places[planet]);
            world.move_to(object, centre + ring.place(stone, self.days))?;
        }
        Ok(())
    }

    fn choose(&mut self, input: &Input) {
        let (key, pad) = (|key| input.key_pressed(key), input.pad());
        let button = |button| pad.is_some_and(|pad| pad.pressed(button));
        let bodies = PLANETS.len() + 1;
        let before = self.followed;
        if key(Key::Right) || button(Button::R1) {
            self.followed = (self.followed + 1) % bodies;
        }
        if key(Key::Left) || button(Button::L1) {
            self.followed = (self.followed + bodies - 1) % bodies;
        }
        if let Some(digit) = DIGITS.iter().position(|&digit| key(digit)) {
            self.followed = digit;
        }
        if self.followed != before {
            self.distance = OVERVIEW;
            self.swing = 0.0;
            if let Some(planet) = self.followed.checked_sub(1) {
                self.distance = PLANETS[planet].radius * 6.5 + 0.6;
                let to_sun = -self.places[planet];
                let day = libm::atan2(to_sun.x, to_sun.z) + ASIDE;
                self.swing = libm::remainder(day - self.orbit.turn, TAU);
            }
        }
        if key(Key::Up) || button(Button::Up) {
            self.speed = (self.speed * 2.0).min(SPEEDS.1);
        }
        if key(Key::Down) || button(Button::Down) {
            self.speed = (self.speed / 2.0).max(SPEEDS.0);
        }
        if key(Key::Space) || button(Button::Cross) {
            self.stopped = !self.stopped;
        }
        if key(Key::N) || button(Button::Triangle) {
            self.has_names = !self.has_names;
        }
    }

    fn look(&mut self, world: &mut World, input: &Input, seconds: f64) -> Result<(), WorldError> {
        let goal = self.followed.checked_sub(1).map_or(DVec3::ZERO, |planet| self.places[planet]);
        let part = seconds * FOLLOWS / (1.0 + seconds * FOLLOWS);
        let near = ARRIVED * self.orbit.distance;
        self.at = match self.at.distance(goal) < near {
            true => goal,
            false => self.at + (goal - self.at) * part,
        };
        let swing = match self.swing.abs() < ARRIVED {
            true => self.swing,
            false => self.swing * part,
        };
        self.orbit.turn += swing;
        self.swing -= swing;
        let before = self.orbit.distance;
        let nearest = match self.followed {
            0 => SUN_DISTANCE,
            _ => DISTANCES.0,
        };
        // If the eye followed a planet before, it starts nearer. Then it moves away gradually and
        // does not jump.
        self.orbit.distances.0 = nearest.min(before);
        self.orbit.steer(input, seconds);
        // The player's changes of the distance also apply to the distance that is approached.
        self.distance = (self.distance * self.orbit.distance / before).clamp(nearest, DISTANCES.1);
        let way = self.distance - self.orbit.distance;
        self.orbit.distance = match way.abs() < near {
            true => self.distance,
            false => self.orbit.distance + way * part,
        };
        self.eye = self.clear(self.orbit.from(self.at));
        world.look_from(self.eye, self.at)
    }

    /// The name of a body below it, unless another body hides it.
    fn name(&self, name: &str, centre: DVec3, radius: f64, colour: DVec3) -> Option<Label> {
        let suns = std::iter::once((DVec3::ZERO, SUN_RADIUS));
        let radii = PLANETS.iter().map(|planet| planet.radius);
        let mut others = suns.chain(self.places.iter().copied().zip(radii));
        let way = centre - self.eye;
        let is_hidden = others.any(|(other, radius)| {
            let along = (other - self.eye).dot(way) / way.length_squared();
            // A body does not hide itself, nor what is before it.
            let is_between = along > 0.0 && along < 1.0 - 1e-9;
            is_between && other.distance(self.eye + way * along) < radius
        });
        let back = (self.eye - self.at).normalize();
        let up = back.cross(DVec3::Y.cross(back)).normalize();
        let DVec3 { x, y, z } = DVec3::splat(0.45) + 0.55 * colour;
        (!is_hidden).then(|| {
            let below = Label::at_point(name, centre - up * radius);
            below.beside(Side::Below).coloured(x, y, z)
        })
    }

    /// The position nearest to a given one that is outside the sun and all planets. The followed
    /// body may be beyond or before the point that the eye looks at, and the eye passes other
    /// bodies on its way from one to the next.
    fn clear(&self, eye: DVec3) -> DVec3 {
        let radii = PLANETS.iter().map(|planet| planet.radius);
        let planets = self.places.iter().copied().zip(radii);
        std::iter::once((DVec3::ZERO, SUN_RADIUS)).chain(planets).fold(
            eye,
            |eye, (centre, radius)| {
                let (away, nearest) = (eye - centre, radius + CLEARANCE);
                let distance = away.length();
                if distance >= nearest {
                    eye
                } else if distance > 0.0 {
                    centre + away * (nearest / distance)
                } else {
                    centre + DVec3::Z * nearest
                }
            },
        )
    }
}

impl Game for Orrery {
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
            ray_depth: 1,
            ..RenderOptions::default()
        });
        world.set_background(DVec3::new(0.008, 0.009, 0.022))?;
        world.set_ambient(DVec3::new(0.014, 0.015, 0.02))?;
        Self::add_sky(world, start.seed)?;
        Self::add_sun(world)?;
        self.add_bodies(world)?;
        self.place_bodies(world)?;
        self.eye = self.orbit.from(self.at);
        world.look_from(self.eye, self.at)
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        self.choose(frame.input);
        for _ in 0..self.steps.of(frame.delta) {
            if !self.stopped {
                self.days += self.speed * STEP;
            }
        }
        self.place_bodies(world)?;
        self.look(world, frame.input, frame.delta)
    }

    /// The planets' names, and those of the followed planet's moons. The followed planet's is the
    /// most important.
    fn labels(&self) -> Vec<Label> {
        if !self.has_names {
            return Vec::new();
        }
        let followed = self.followed.checked_sub(1);
        let planet = |number: usize| {
            let Planet { name, radius, colour, .. } = PLANETS[number];
            self.name(name, self.places[number], radius, colour.into())
        };
        let others = (0..PLANETS.len()).filter(|number| Some(*number) != followed);
        let planets = followed.into_iter().chain(others).filter_map(planet);
        let moons = MOONS.iter().filter(|moon| Some(moon.planet) == followed);
        let moons = moons.filter_map(|moon| {
            let place = self.places[moon.planet] + moon.place(self.days);
            self.name(moon.name, place, moon.radius, DVec3::ONE)
        });
        planets.chain(moons).collect()
    }
}

impl Planet {
    /// The position on the ellipse, with the sun in one focus.
    fn place(&self, days: f64) -> DVec3 {
        let mean = TAU * (days / self.period + self.start);
        // Kepler's equation by Newton's method. For these eccentricities, three iterations are
        // exact.
        let mut anomaly = mean;
        for _ in 0..3 {
            let (sine, cosine) = libm::sincos(anomaly);
            let off = anomaly - self.eccentricity * sine - mean;
            anomaly -= off / (1.0 - self.eccentricity * cosine);
        }
        let (sine, cosine) = libm::sincos(anomaly);
        let across = (1.0 - self.eccentricity * self.eccentricity).sqrt();
        let along = DVec3::new(cosine - self.eccentricity, 0.0, -sine * across) * self.distance;
        let (tilt_sine, tilt_cosine) = libm::sincos(self.inclination.to_radians());
        DVec3::new(along.x, along.z * tilt_sine, along.z * tilt_cosine)
    }
}

impl Moon {
    /// The position relative to its planet.
    fn place(&self, days: f64) -> DVec3 {
        let (sine, cosine) = libm::sincos(TAU * (days / self.period + self.start));
        DVec3::new(cosine, 0.15 * sine, -sine) * self.distance
    }
}

impl Ring {
    /// The position of a stone relative to the centre of the ring.
    fn place(&self, stone: u32, days: f64) -> DVec3 {
        let turn = f64::from(stone) / f64::from(self.stones);
        let (sine, cosine) = libm::sincos(TAU * (turn + days / self.period));
        // The ring is not perfectly regular: every stone has a path of its own, different from
        // those of its neighbours.
        let own = (f64::from(stone) * 0.618_034).fract() * 2.0 - 1.0;
        let radius = self.distance + self.width * own;
        let (tilt_sine, tilt_cosine) = libm::sincos(self.tilt.to_radians());
        DVec3::new(cosine * radius, sine * radius * tilt_sine, -sine * radius * tilt_cosine)
    }
}

#[cfg(test)]
mod tests {
    use super::{MOONS, PLANETS, RINGS, Ring, SUN_RADIUS};
    use cellray::game::DVec3;

    #[test]
    fn planets_stay_on_their_ellipses() {
        for planet in PLANETS {
            let (long, eccentricity) = (planet.distance, planet.eccentricity);
            let (mut nearest, mut farthest) = (f64::INFINITY, 0.0_f64);
            for step in 0..1000 {
                let day = planet.period * f64::from(step) / 1000.0;
                let from_sun = planet.place(day).length();
                nearest = nearest.min(from_sun);
                farthest = farthest.max(from_sun);
            }
            assert!((nearest / (long * (1.0 - eccentricity)) - 1.0).abs() < 1e-4);
            assert!((farthest / (long * (1.0 + eccentricity)) - 1.0).abs() < 1e-4);
            let after = planet.place(planet.period);
            assert!(planet.place(0.0).distance(after) < 1e-9 * long);
        }
    }

    #[test]
    fn equal_areas_are_swept_in_equal_times() {
        let mercury = &PLANETS[0];
        let day = mercury.period / 2000.0;
        let swept = |step: f64| {
            let (from, to) = (mercury.place(step * day), mercury.place((step + 1.0) * day));
            from.cross(to).length()
        };
        let first = swept(0.0);
        for step in 1..2000 {
            assert!((swept(f64::from(step)) / first - 1.0).abs() < 1e-4);
        }
    }

    /// The range of distances that a body occupies, from its nearest to its farthest points.
    fn shell(places: impl Iterator<Item = DVec3>, radius: f64) -> (f64, f64) {
        let (nearest, farthest) =
            places.map(DVec3::length).fold((f64::INFINITY, 0.0_f64), |(nearest, farthest), off| {
                (nearest.min(off), farthest.max(off))
            });
        (nearest - radius, farthest + radius)
    }

    fn ring_shell(ring: &Ring) -> (f64, f64) {
        let shell = shell((0..ring.stones).map(|stone| ring.place(stone, 3.0)), ring.stone);
        let stray = ring.width + ring.stone + 1e-12;
        assert!(ring.distance - shell.0 <= stray && shell.1 - ring.distance <= stray);
        (ring.distance - stray, ring.distance + stray)
    }

    /// The bodies around a planet have shells of their own, of which the planet's is the first.
    /// Returns the end of the last one.
    fn reach(number: usize) -> f64 {
        let turns = (0..1000).map(|step| f64::from(step) / 1000.0);
        let moons = MOONS.iter().filter(|moon| moon.planet == number);
        let rings = RINGS.iter().filter(|ring| ring.planet == Some(number));
        let mut shells: Vec<_> = moons
            .map(|moon| {
                let places = turns.clone().map(|turn| moon.place(turn * moon.period));
                shell(places, moon.radius)
            })
            .chain(rings.map(ring_shell))
            .chain([(0.0, PLANETS[number].radius)])
            .collect();
        are_apart(&mut shells)
    }

    /// Sorts the shells and checks that none overlaps the next. Returns the end of the farthest.
    fn are_apart(shells: &mut [(f64, f64)]) -> f64 {
        shells.sort_by(|a, b| a.0.total_cmp(&b.0));
        for two in shells.windows(2) {
            assert!(two[0].1 < two[1].0, "{two:?}");
        }
        shells[shells.len() - 1].1
    }

    #[test]
    fn orbits_of_bodies_do_not_cross() {
        let systems = PLANETS.iter().enumerate().map(|(number, planet)| {
            let stray = planet.distance * planet.eccentricity + reach(number);
            (planet.distance - stray, planet.distance + stray)
        });
        let rings = RINGS.iter().filter(|ring| ring.planet.is_none());
        let mut shells: Vec<_> =
            systems.chain(rings.map(ring_shell)).chain([(0.0, SUN_RADIUS)]).collect();
        are_apart(&mut shells);
        assert_eq!(shells.len(), PLANETS.len() + 2);
    }
}
