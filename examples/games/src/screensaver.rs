//! Sixteen spheres that bounce in a room for ever.
//!
//! The first model is the paper's depth shading, with only the spheres in the dark. A key switches
//! to Whitted's model, with a room and light. Without a player, the eye moves around, and the
//! colours go through their circle. No two minutes are the same, and the movement never ends,
//! because the spheres lose no energy.
//!
//! | | keyboard and mouse | pad |
//! |---|---|---|
//! | the other model | Space | Cross |
//! | turn the eye | A D W S, mouse dragged | right stick |
//! | nearer, farther | page keys, wheel | R2, L2 |

use cellray::game::{
    Button, DVec3, DepthShading, Entry, Frame, Game, Key, Light, Material, MaterialId, Model,
    ObjectId, OrbitCamera, RenderOptions, Shader, Start, World, WorldError,
};
use rand::{Rng as _, SeedableRng as _};
use rand_xoshiro::Xoshiro256PlusPlus;

use crate::bodies::{Body, meet, pairs};
use crate::colour::hue;
use crate::steps::{STEP, Steps};

/// The game's name.
pub const NAME: &str = "screensaver";
/// The controls.
pub const CONTROLS: &[&str] = &[
    "Space, Cross: the paper's depth shading, or lights and shadows",
    "A D W S, mouse dragged, right stick: turn the eye",
    "page keys, wheel, R2 and L2: nearer, farther",
];
/// The entry in the table of games.
pub const ENTRY: Entry = Entry {
    name: NAME,
    line: "sixteen spheres that bounce in a room, for ever",
    new: || Box::new(Screensaver::default()),
    open: None,
};

const COUNT: usize = 16;
/// The distances of the walls from the origin, along the axes.
const HALF_SIZE: DVec3 = DVec3::new(4.4, 2.6, 3.2);
/// Seconds in which the colours go through their circle.
const ROUND: f64 = 100.0;
/// Seconds after the player's last input until the eye moves by itself again.
const PATIENCE: f64 = 5.0;
const RAY_DEPTH: u32 = 3;

/// The game.
pub struct Screensaver {
    bodies: [Body; COUNT],
    spheres: [ObjectId; COUNT],
    materials: [MaterialId; COUNT],
    orbit: OrbitCamera,
    steps: Steps,
    /// Seconds since the player last moved the eye.
    alone: f64,
    whitted: bool,
}

impl Default for Screensaver {
    fn default() -> Self {
        Self {
            bodies: [Body::new(DVec3::ZERO, 1.0); COUNT],
            spheres: [ObjectId::default(); COUNT],
            materials: [MaterialId::default(); COUNT],
            orbit: OrbitCamera {
                turn: 0.35,
                rise: 0.2,
                distance: 10.2,
                distances: (7.0, 18.0),
                rises: (-0.2, 1.2),
            },
            steps: Steps::default(),
            alone: PATIENCE,
            whitted: false,
        }
    }
}

impl Screensaver {
    /// The spheres.
    #[must_use]
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The distances of the walls from the origin, along the axes.
    #[must_use]
    pub fn half_size(&self) -> DVec3 {
        HALF_SIZE
    }

    fn render_options(&self) -> RenderOptions {
        RenderOptions {
            model: if self.whitted { Model::Whitted } else { Model::Depth },
            ray_depth: RAY_DEPTH,
            ..RenderOptions::default()
        }
    }

    fn place_spheres(&mut self, seed: u64) {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        // Cells of four by two by two, so that no spheres overlap at the start.
        let cell = DVec3::new(HALF_SIZE.x / 2.0, HALF_SIZE.y, HALF_SIZE.z);
        for (number, body) in self.bodies.iter_mut().enumerate() {
            let place = DVec3::new(
                (number % 4) as f64 - 1.5,
                (number / 4 % 2) as f64 - 0.5,
                (number / 8) as f64 - 0.5,
            );
            let mut within = || rng.random_range(-0.15..0.15);
            let centre = place * cell + DVec3::new(within(), within(), within());
            *body = Body::new(centre, rng.random_range(0.5..0.88));
            let mut speed = || rng.random_range(-1.3..1.3);
            body.velocity = DVec3::new(speed(), speed(), speed());
        }
    }

    fn add_walls(world: &mut World) -> Result<(), WorldError> {
        let floor = world.add_material(Material {
            shader: Shader::Checker { other: DVec3::new(0.2, 0.23, 0.3), size: HALF_SIZE.x / 4.0 },
            specular: 0.18,
            shine: 30.0,
            ..Material::matte(0.75, 0.74, 0.7)
        })?;
        let wall = world.add_material(Material {
            shader: Shader::Lambert,
            ..Material::matte(0.5, 0.56, 0.66)
        })?;
        let DVec3 { x, y, z } = HALF_SIZE;
        let corner = |i: f64, j: f64, k: f64| DVec3::new(i * x, j * y, k * z);
        // The walls face inwards, so that they are invisible from outside.
        for (material, corners) in [
            (floor, [[-1., -1., 1.], [1., -1., 1.], [1., -1., -1.], [-1., -1., -1.]]),
            (wall, [[-1., -1., -1.], [1., -1., -1.], [1., 1., -1.], [-1., 1., -1.]]),
            (wall, [[1., -1., 1.], [-1., -1., 1.], [-1., 1., 1.], [1., 1., 1.]]),
            (wall, [[-1., -1., 1.], [-1., -1., -1.], [-1., 1., -1.], [-1., 1., 1.]]),
            (wall, [[1., -1., -1.], [1., -1., 1.], [1., 1., 1.], [1., 1., -1.]]),
        ] {
            let side = world.add_polygon(&corners.map(|[i, j, k]| corner(i, j, k)), material)?;
            world.fix(side)?;
        }
        Ok(())
    }

    /// Moves the eye by itself: around, up and down, nearer and farther, with periods that have no
    /// common multiple.
    fn wander(&mut self, time: f64, seconds: f64) {
        let slowly = seconds / (seconds + 3.0);
        let rise = 0.26 + 0.24 * libm::sin(time * 0.113);
        let distance = 10.2 + 1.1 * libm::sin(time * 0.071);
        self.orbit.turn += 0.09 * seconds;
        self.orbit.rise += (rise - self.orbit.rise) * slowly;
        self.orbit.distance += (distance - self.orbit.distance) * slowly;
    }

    fn show(&self, world: &mut World, time: f64) -> Result<(), WorldError> {
        for (body, &sphere) in self.bodies.iter().zip(&self.spheres) {
            world.move_to(sphere, body.centre)?;
        }
        // The part of the colour circle that the spheres share grows and shrinks.
        let spread = 0.55 + 0.45 * libm::sin(time * 0.047 + 1.0);
        for (number, &material) in self.materials.iter().enumerate() {
            let turn = time / ROUND + spread * number as f64 / COUNT as f64;
            world.recolour(material, hue(turn, 0.25))?;
        }
        world.set_fade(Some(DepthShading {
            near: self.orbit.distance - 4.0,
            far: self.orbit.distance + 7.5,
        }))?;
        world.look_from(self.orbit.from(DVec3::ZERO), DVec3::ZERO)
    }
}

impl Game for Screensaver {
    fn name(&self) -> &str {
        NAME
    }

    fn controls(&self) -> &[&str] {
        CONTROLS
    }

    fn set_up(&mut self, world: &mut World, start: &Start) -> Result<(), WorldError> {
        self.place_spheres(start.seed);
        world.set_name(NAME);
        world.set_render_options(self.render_options());
        world.set_background(DVec3::new(0.012, 0.014, 0.03))?;
        world.set_ambient(DVec3::splat(0.07))?;
        world.add_light(Light::at(DVec3::new(-2.2, 2.4, 1.4)).coloured(0.72, 0.67, 0.6))?;
        world.add_light(Light::at(DVec3::new(3.4, 2.2, 2.2)).coloured(0.36, 0.43, 0.55))?;
        Self::add_walls(world)?;
        for number in 0..COUNT {
            self.materials[number] = world.add_material(Material {
                diffuse: 0.72,
                specular: 0.28,
                shine: 40.0,
                ..Material::matte(1.0, 1.0, 1.0)
            })?;
            let Body { centre, radius, .. } = self.bodies[number];
            self.spheres[number] = world.add_sphere(centre, radius, self.materials[number])?;
        }
        self.show(world, 0.0)
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        let input = frame.input;
        if input.key_pressed(Key::Space)
            || input.pad().is_some_and(|pad| pad.pressed(Button::Cross))
        {
            self.whitted = !self.whitted;
            world.set_render_options(self.render_options());
        }
        if self.orbit.steer(input, frame.delta) {
            self.alone = 0.0;
        } else {
            self.alone += frame.delta;
        }
        if self.alone >= PATIENCE {
            self.wander(frame.time, frame.delta);
        }
        for _ in 0..self.steps.of(frame.delta) {
            for body in &mut self.bodies {
                body.centre += body.velocity * STEP;
            }
            pairs(&mut self.bodies, |a, b| {
                meet(a, b, 1.0);
            });
            for body in &mut self.bodies {
                body.keep_within(-HALF_SIZE, HALF_SIZE, 1.0);
            }
        }
        self.show(world, frame.time)
    }
}
