//! Marbles on a mirror that the player tilts.
//!
//! The golden marble is the player's. When it touches a gem, the player wins the gem, which
//! appears again elsewhere. Each gem lights a bead on the rim. When all beads are lit, they go
//! out, and the gems are worth the next round.
//!
//! | | keyboard and mouse | pad |
//! |---|---|---|
//! | tilt | arrows, mouse dragged with the right button | left stick; SIXAXIS: the pad itself, while L1 is held |
//! | turn the eye | A D W S, mouse dragged | right stick |
//! | nearer, farther | page keys, wheel | R2, L2 |

use cellray::game::{
    Axis, Button, DVec3, Entry, Frame, Game, Input, Key, Light, Material, MaterialId, Model,
    MouseButton, ObjectId, OrbitCamera, RenderOptions, Shader, Sky, Start, View, World, WorldError,
};
use rand::{Rng as _, SeedableRng as _};
use rand_xoshiro::Xoshiro256PlusPlus;

use crate::bodies::{Body, meet, pairs};
use crate::colour::hue;
use crate::steps::{STEP, Steps};

/// The game's name.
pub const NAME: &str = "marbles";
/// The controls.
pub const CONTROLS: &[&str] = &[
    "arrows, mouse dragged with the right button, left stick, the pad itself with L1: tilt",
    "A D W S, mouse dragged, right stick: turn the eye",
    "page keys, wheel, R2 and L2: nearer, farther",
];
/// The entry in the table of games.
pub const ENTRY: Entry = Entry {
    name: NAME,
    line: "marbles on a mirror that the player tilts",
    new: || Box::new(Marbles::default()),
    open: None,
};

const COUNT: usize = 11;
const GEMS: usize = 3;
const BEADS: usize = 8;
/// Half the tray's size, across and deep.
const TRAY: (f64, f64) = (3.4, 2.3);
const RIM: f64 = 0.3;
const RIM_HEIGHT: f64 = 0.26;
const GEM: f64 = 0.11;
/// The acceleration of a rolling ball along the steepest direction at a tilt of 1.
const PULL: f64 = 9.81 * 5.0 / 7.0;
const TILT: f64 = 0.22;
/// The share of the way to the player's tilt by which the tray moves in a step.
const FOLLOWS: f64 = 0.012;
/// The share of its speed that a rolling marble loses in a second.
const ROLLING: f64 = 0.16;
/// Tilt for a pixel of mouse movement.
const A_PIXEL: f64 = 0.002;

/// The game.
pub struct Marbles {
    bodies: [Body; COUNT],
    marbles: [ObjectId; COUNT],
    gems: [(DVec3, ObjectId); GEMS],
    beads: [MaterialId; BEADS],
    won: usize,
    /// The tilt of the tray to the right and towards the player, and the tilt that it is
    /// approaching.
    tilt: DVec3,
    goal: DVec3,
    orbit: OrbitCamera,
    steps: Steps,
    chance: Xoshiro256PlusPlus,
}

impl Default for Marbles {
    fn default() -> Self {
        Self {
            bodies: [Body::new(DVec3::ZERO, 1.0); COUNT],
            marbles: [ObjectId::default(); COUNT],
            gems: [(DVec3::ZERO, ObjectId::default()); GEMS],
            beads: [MaterialId::default(); BEADS],
            won: 0,
            tilt: DVec3::ZERO,
            goal: DVec3::ZERO,
            orbit: OrbitCamera {
                turn: 0.25,
                rise: 0.55,
                distance: 8.4,
                distances: (4.0, 14.0),
                rises: (0.15, 1.45),
            },
            steps: Steps::default(),
            chance: Xoshiro256PlusPlus::seed_from_u64(0),
        }
    }
}

impl Marbles {
    /// The marbles. The first is the player's.
    #[must_use]
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The number of gems won since the game began.
    #[must_use]
    pub fn won(&self) -> usize {
        self.won
    }

    /// Half the tray's size, across and deep.
    #[must_use]
    pub fn tray(&self) -> (f64, f64) {
        TRAY
    }

    fn place_marbles(&mut self) {
        for (number, body) in self.bodies.iter_mut().enumerate() {
            // Rows of four, with the player's marble in front.
            let (across, deep) = (number % 4, number / 4);
            let radius = if number == 0 { 0.34 } else { self.chance.random_range(0.22..0.4) };
            let mut within = || self.chance.random_range(-0.2..0.2);
            let place = DVec3::new(
                (across as f64 - 1.5) * 1.5 + within(),
                radius,
                (1.0 - deep as f64) * 1.3 + within(),
            );
            *body = Body::new(place, radius);
        }
    }

    /// A place for a gem without a marble.
    fn free_place(&mut self) -> DVec3 {
        let (x, z) = (TRAY.0 - 0.4, TRAY.1 - 0.4);
        let mut place = DVec3::ZERO;
        // All marbles together cover a small part of the tray, so one or two tries are enough.
        for _ in 0..16 {
            place =
                DVec3::new(self.chance.random_range(-x..x), GEM, self.chance.random_range(-z..z));
            let clear = |body: &Body| body.centre.distance(place) > body.radius + 3.0 * GEM;
            if self.bodies.iter().all(clear) {
                break;
            }
        }
        place
    }

    fn add_tray(world: &mut World) -> Result<(), WorldError> {
        let mirror = world.add_material(Material {
            diffuse: 0.22,
            specular: 0.66,
            shine: 120.0,
            shader: Shader::Checker { other: DVec3::new(0.1, 0.13, 0.2), size: TRAY.0 / 6.0 },
            ..Material::matte(0.62, 0.66, 0.74)
        })?;
        let wood = world.add_material(Material {
            specular: 0.06,
            shine: 12.0,
            ..Material::matte(0.46, 0.24, 0.11)
        })?;
        let (x, z, h) = (TRAY.0, TRAY.1, RIM_HEIGHT);
        let (far_x, far_z) = (x + RIM, z + RIM);
        let p = DVec3::new;
        let low = -0.12;
        let fixed = [
            (mirror, [p(-x, 0., z), p(x, 0., z), p(x, 0., -z), p(-x, 0., -z)]),
            // The tops of the rim. The long ones include the corners.
            (wood, [p(-far_x, h, far_z), p(far_x, h, far_z), p(far_x, h, z), p(-far_x, h, z)]),
            (wood, [p(-far_x, h, -z), p(far_x, h, -z), p(far_x, h, -far_z), p(-far_x, h, -far_z)]),
            (wood, [p(-far_x, h, z), p(-x, h, z), p(-x, h, -z), p(-far_x, h, -z)]),
            (wood, [p(x, h, z), p(far_x, h, z), p(far_x, h, -z), p(x, h, -z)]),
            // The rim's inner sides.
            (wood, [p(-x, 0., -z), p(x, 0., -z), p(x, h, -z), p(-x, h, -z)]),
            (wood, [p(x, 0., z), p(-x, 0., z), p(-x, h, z), p(x, h, z)]),
            (wood, [p(-x, 0., z), p(-x, 0., -z), p(-x, h, -z), p(-x, h, z)]),
            (wood, [p(x, 0., -z), p(x, 0., z), p(x, h, z), p(x, h, -z)]),
            // The rim's outer sides.
            (
                wood,
                [
                    p(-far_x, low, far_z),
                    p(far_x, low, far_z),
                    p(far_x, h, far_z),
                    p(-far_x, h, far_z),
                ],
            ),
            (
                wood,
                [
                    p(far_x, low, -far_z),
                    p(-far_x, low, -far_z),
                    p(-far_x, h, -far_z),
                    p(far_x, h, -far_z),
                ],
            ),
            (
                wood,
                [
                    p(-far_x, low, -far_z),
                    p(-far_x, low, far_z),
                    p(-far_x, h, far_z),
                    p(-far_x, h, -far_z),
                ],
            ),
            (
                wood,
                [
                    p(far_x, low, far_z),
                    p(far_x, low, -far_z),
                    p(far_x, h, -far_z),
                    p(far_x, h, far_z),
                ],
            ),
        ];
        for (material, corners) in fixed {
            let side = world.add_polygon(&corners, material)?;
            world.fix(side)?;
        }
        Ok(())
    }

    fn add_marbles(&mut self, world: &mut World) -> Result<(), WorldError> {
        for number in 0..COUNT {
            let material = match number {
                0 => Material {
                    diffuse: 0.55,
                    specular: 0.45,
                    shine: 60.0,
                    ..Material::matte(1.0, 0.74, 0.22)
                },
                3 | 8 => Material { refraction_index: 1.3, ..Material::glass() },
                _ => Material {
                    diffuse: 0.78,
                    specular: 0.22,
                    shine: 60.0,
                    ..Material::matte(1.0, 1.0, 1.0)
                },
            };
            let coloured = !matches!(number, 0 | 3 | 8);
            let material = world.add_material(material)?;
            if coloured {
                world.recolour(material, hue(number as f64 * 0.382, 0.12))?;
            }
            let Body { centre, radius, .. } = self.bodies[number];
            self.marbles[number] = world.add_sphere(centre, radius, material)?;
        }
        Ok(())
    }

    fn add_gems_and_beads(&mut self, world: &mut World) -> Result<(), WorldError> {
        let glow = world.add_material(Material::flat(0.35, 1.0, 0.62))?;
        for number in 0..GEMS {
            let place = self.free_place();
            self.gems[number] = (place, world.add_sphere(place, GEM, glow)?);
        }
        for number in 0..BEADS {
            let across = (number as f64 + 0.5) / BEADS as f64 * 2.0 - 1.0;
            let centre = DVec3::new(across * TRAY.0 * 0.8, RIM_HEIGHT, -TRAY.1 - RIM / 2.0);
            self.beads[number] = world.add_material(Material::flat(0.1, 0.1, 0.1))?;
            let bead = world.add_sphere(centre, 0.09, self.beads[number])?;
            world.fix(bead)?;
        }
        Ok(())
    }

    /// Reads the tilt from the player's input.
    fn steer(&mut self, input: &Input) {
        let mut goal = DVec3::new(
            f64::from(input.key_axis(Key::Left, Key::Right)),
            0.0,
            f64::from(input.key_axis(Key::Up, Key::Down)),
        );
        if let Some(pad) = input.pad() {
            goal.x += pad.stick(Axis::LeftX);
            goal.z += pad.stick(Axis::LeftY);
            if let Some(sensors) = pad.sensors().filter(|_| pad.held(Button::L1)) {
                // When the pad's right side is down, the reaction to gravity points to its left.
                goal.x -= f64::from(sensors.acceleration[0]) * 2.0;
                goal.z -= f64::from(sensors.acceleration[2]) * 2.0;
            }
        }
        let mut goal = goal * TILT;
        if input.mouse_held(MouseButton::Right) {
            let [x, y] = input.mouse().motion.map(f64::from);
            // This drag continues from where the last one ended.
            goal += self.seen_from_the_eye(self.goal) + DVec3::new(x, 0.0, y) * A_PIXEL;
        }
        // The direction is relative to the eye, which may be anywhere around the tray.
        let (sine, cosine) = libm::sincos(self.orbit.turn);
        let goal = goal.clamp(DVec3::splat(-TILT), DVec3::splat(TILT));
        self.goal =
            DVec3::new(goal.x * cosine + goal.z * sine, 0.0, goal.z * cosine - goal.x * sine);
    }

    /// A tilt relative to the eye: to the right and towards it.
    fn seen_from_the_eye(&self, tilt: DVec3) -> DVec3 {
        let (sine, cosine) = libm::sincos(self.orbit.turn);
        DVec3::new(tilt.x * cosine - tilt.z * sine, 0.0, tilt.x * sine + tilt.z * cosine)
    }

    fn roll(&mut self) {
        self.tilt += (self.goal - self.tilt) * FOLLOWS;
        let slower = ROLLING * STEP;
        for body in &mut self.bodies {
            body.velocity += self.tilt * (PULL * STEP);
            let speed = body.velocity.length();
            body.velocity =
                if speed > slower { body.velocity * (1.0 - slower / speed) } else { DVec3::ZERO };
            body.centre += body.velocity * STEP;
        }
        pairs(&mut self.bodies, |a, b| {
            meet(a, b, 0.88);
        });
        for body in &mut self.bodies {
            // The centres of unequal marbles are at different heights, so separating them would
            // lift the larger one.
            body.centre.y = body.radius;
            body.velocity.y = 0.0;
            let height = DVec3::Y * 3.0;
            let half = DVec3::new(TRAY.0, 0.0, TRAY.1);
            body.keep_within(-half - height, half + height, 0.7);
        }
    }

    fn win_gems(&mut self, world: &mut World) -> Result<(), WorldError> {
        for number in 0..GEMS {
            let (place, gem) = self.gems[number];
            let player = &self.bodies[0];
            if player.centre.distance(place) > player.radius + GEM {
                continue;
            }
            let bead = self.won % BEADS;
            self.won += 1;
            if bead == 0 {
                for &bead in &self.beads {
                    world.recolour(bead, DVec3::splat(0.1))?;
                }
            }
            let round = (self.won - 1) / BEADS;
            world.recolour(self.beads[bead], hue(0.14 + 0.21 * round as f64, 0.0))?;
            self.gems[number].0 = self.free_place();
            world.move_to(gem, self.gems[number].0)?;
        }
        Ok(())
    }

    /// The eye follows the tray, so that the picture tilts with it.
    fn look(&self, world: &mut World) -> Result<(), WorldError> {
        let at = DVec3::new(0.0, -0.15, 0.1);
        let hangs = self.seen_from_the_eye(self.tilt);
        let mut orbit = self.orbit;
        orbit.rise = (orbit.rise + 0.6 * hangs.z).clamp(0.1, 1.5);
        let (sine, cosine) = libm::sincos(orbit.turn);
        let right = DVec3::new(cosine, 0.0, -sine);
        world.set_view(View {
            from: orbit.from(at),
            at,
            up: DVec3::Y - right * (0.6 * hangs.x),
            ..world.view().clone()
        })
    }
}

impl Game for Marbles {
    fn name(&self) -> &str {
        NAME
    }

    fn controls(&self) -> &[&str] {
        CONTROLS
    }

    fn status(&self) -> String {
        let (round, lit) = (self.won / BEADS + 1, self.won % BEADS);
        format!("Gems: {}\nRound {round}: {lit} of {BEADS}", self.won)
    }

    fn set_up(&mut self, world: &mut World, start: &Start) -> Result<(), WorldError> {
        self.chance = Xoshiro256PlusPlus::seed_from_u64(start.seed);
        self.place_marbles();
        world.set_name(NAME);
        world.set_render_options(RenderOptions {
            model: Model::Whitted,
            ray_depth: 4,
            ..RenderOptions::default()
        });
        world.set_background(DVec3::new(0.46, 0.59, 0.74))?;
        world.set_sky(Some(Sky { zenith: DVec3::new(0.07, 0.15, 0.38), up: DVec3::Y }))?;
        world.set_ambient(DVec3::splat(0.11))?;
        world.add_light(Light::at(DVec3::new(-4.0, 7.0, 3.0)).coloured(0.66, 0.62, 0.55))?;
        world.add_light(Light::at(DVec3::new(5.0, 5.0, -2.0)).coloured(0.3, 0.34, 0.42))?;
        Self::add_tray(world)?;
        self.add_marbles(world)?;
        self.add_gems_and_beads(world)?;
        self.look(world)
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        self.orbit.steer(frame.input, frame.delta);
        self.steer(frame.input);
        for _ in 0..self.steps.of(frame.delta) {
            self.roll();
            self.win_gems(world)?;
        }
        for (body, &marble) in self.bodies.iter().zip(&self.marbles) {
            world.move_to(marble, body.centre)?;
        }
        self.look(world)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gems_and_rounds_are_counted() {
        let status = |won| {
            let marbles = Marbles { won, ..Marbles::default() };
            marbles.status()
        };
        assert_eq!(status(0), "Gems: 0\nRound 1: 0 of 8");
        assert_eq!(status(13), "Gems: 13\nRound 2: 5 of 8");
    }
}
