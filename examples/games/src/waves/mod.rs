//! Water that swings, and mirrors what floats on it.
//!
//! The golden ball is the player's. All balls push the water aside, and are pushed by it and by one
//! another. Drops fall on the water now and then, and when the player wants one.
//!
//! | | keyboard and mouse | pad |
//! |---|---|---|
//! | push the golden ball | arrows, mouse dragged with the right button | left stick |
//! | a drop | Space | Cross |
//! | a coarser grid, a finer one | 1, 2, 3 | Square, Triangle |
//! | turn the eye | A D W S, mouse dragged | right stick |
//! | nearer, farther | page keys, wheel | R2, L2 |

mod water;

use std::sync::Arc;

use cellray::game::{
    Axis, Button, DAffine3, DVec3, Entry, Frame, Game, Input, Key, Light, Material, MaterialId,
    Mesh, MeshId, Model, MouseButton, ObjectId, OrbitCamera, RenderOptions, Sky, Start, World,
    WorldError,
};
use rand::{Rng as _, SeedableRng as _};
use rand_xoshiro::Xoshiro256PlusPlus;

use self::water::{SIDE, STEP, Water};
use crate::bodies::{Body, meet, pairs};
use crate::colour::hue;
use crate::steps::{self, Steps};

/// The game's name.
pub const NAME: &str = "waves";
/// The controls.
pub const CONTROLS: &[&str] = &[
    "arrows, mouse dragged with the right button, left stick: push the golden ball",
    "Space, Cross: a drop",
    "1, 2, 3, Square, Triangle: a coarser grid, a finer one",
    "A D W S, mouse dragged, right stick: turn the eye",
    "page keys, wheel, R2 and L2: nearer, farther",
];
/// The entry in the table of games.
pub const ENTRY: Entry = Entry {
    name: NAME,
    line: "water that mirrors what floats on it",
    new: || Box::new(Waves::default()),
    open: None,
};

/// Squares along a side of the grids, from the coarsest on.
const GRIDS: [usize; 3] = [64, 128, 256];
const COUNT: usize = 7;
/// Steps of [`steps::STEP`] in one of the water.
const STRIDE: u32 = 8;
const GRAVITY: f64 = 9.81;
/// The share of a ball's volume that is in the water when it floats.
const DENSITY: f64 = 0.45;
/// The share of a ball's speed that the water takes in a second, if it is all in the water.
const DRAG: f64 = 2.2;
/// How much of the water that a ball pushes aside appears around it.
const ASIDE: f64 = 0.35;
/// The acceleration of the golden ball.
const PUSH: f64 = 3.0;
/// Push for a pixel of mouse movement.
const A_PIXEL: f64 = 0.02;
/// Half the side of the pool, up to its walls, and their width and height.
const HALF: f64 = 0.5 * SIDE;
const WALL: f64 = 0.35;
const WALL_HEIGHT: f64 = 0.5;
const DEPTH: f64 = 0.9;
const DROP: f64 = 0.45;
/// Steps of the water between two drops that fall by themselves, at most.
const PAUSE: u32 = 150;

/// The game.
pub struct Waves {
    water: Water,
    mesh: MeshId,
    surface: MaterialId,
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    bodies: [Body; COUNT],
    /// How deep each ball was in the water.
    sunk: [f64; COUNT],
    balls: [ObjectId; COUNT],
    /// The acceleration of the golden ball.
    push: DVec3,
    /// Steps until the next drop.
    pause: u32,
    orbit: OrbitCamera,
    steps: Steps,
    /// Steps since the water's last one.
    passed: u32,
    chance: Xoshiro256PlusPlus,
}

impl Default for Waves {
    fn default() -> Self {
        Self {
            water: Water::new(GRIDS[1]),
            mesh: MeshId::default(),
            surface: MaterialId::default(),
            positions: Vec::new(),
            normals: Vec::new(),
            bodies: [Body::new(DVec3::ZERO, 1.0); COUNT],
            sunk: [0.0; COUNT],
            balls: [ObjectId::default(); COUNT],
            push: DVec3::ZERO,
            pause: 0,
            orbit: OrbitCamera {
                turn: 0.6,
                rise: 0.4,
                distance: 8.4,
                distances: (5.0, 16.0),
                rises: (0.16, 1.4),
            },
            steps: Steps::default(),
            passed: 0,
            chance: Xoshiro256PlusPlus::seed_from_u64(0),
        }
    }
}

/// The triangles of a grid of squares.
fn triangles(count: usize) -> Vec<[u32; 3]> {
    let count = count as u32;
    let side = count + 1;
    let corners = (0..count).flat_map(|row| (0..count).map(move |column| row * side + column));
    corners.flat_map(|at| [[at, at + side, at + 1], [at + 1, at + side, at + side + 1]]).collect()
}

impl Waves {
    /// The balls. The first is the player's.
    #[must_use]
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The distance of the walls from the middle.
    #[must_use]
    pub fn wall(&self) -> f64 {
        HALF
    }

    /// The height of the water at a point.
    #[must_use]
    pub fn height(&self, x: f64, z: f64) -> f64 {
        self.water.height(x, z)
    }

    /// Replaces the water by water at rest on another grid.
    fn fill(&mut self, world: &mut World, count: usize) -> Result<(), WorldError> {
        self.water = Water::new(count);
        let points = (count + 1) * (count + 1);
        self.positions = vec![[0.0; 3]; points];
        self.normals = vec![[0.0; 3]; points];
        self.water.shape(&mut self.positions, &mut self.normals);
        let triangles = triangles(count);
        let mesh = Mesh {
            positions: self.positions.clone(),
            normals: self.normals.clone(),
            materials: vec![0; triangles.len()],
            triangles,
            ..Mesh::default()
        };
        if world.mesh_place(self.mesh).is_ok() {
            world.remove_mesh(self.mesh)?;
        }
        self.mesh = world.add_mesh(Arc::new(mesh), &[self.surface], DAffine3::IDENTITY)?;
        Ok(())
    }

    fn add_pool(world: &mut World) -> Result<(), WorldError> {
        let stone = world.add_material(Material {
            specular: 0.04,
            shine: 10.0,
            ..Material::matte(0.72, 0.66, 0.56)
        })?;
        let (near, far) = (HALF, HALF + WALL);
        let (low, high) = (-DEPTH, WALL_HEIGHT);
        // The inner side, the top and the outer side of one wall: half its width, height and
        // distance at both edges. The other walls are turned copies.
        let wall = [
            [[near, low, near], [near, high, near]],
            [[near, high, near], [far, high, far]],
            [[far, high, far], [far, low, far]],
        ];
        for turn in [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]] {
            let [cosine, sine] = turn;
            for [[x, y, z], [far_x, far_y, far_z]] in wall {
                let corners =
                    [[-x, y, z], [x, y, z], [far_x, far_y, far_z], [-far_x, far_y, far_z]];
                let corners = corners
                    .map(|[x, y, z]| DVec3::new(x * cosine - z * sine, y, -z * cosine - x * sine));
                let polygon = world.add_polygon(&corners, stone)?;
                world.fix(polygon)?;
            }
        }
        Ok(())
    }

    fn add_balls(&mut self, world: &mut World) -> Result<(), WorldError> {
        for number in 0..COUNT {
            let radius = if number == 0 { 0.42 } else { self.chance.random_range(0.26..0.5) };
            // Around the golden ball, which is in the middle.
            let (sine, cosine) = libm::sincos(number as f64 * 1.05);
            let away = if number == 0 { 0.0 } else { self.chance.random_range(1.5..3.1) };
            let centre = DVec3::new(away * cosine, 0.1, away * sine);
            self.bodies[number] = Body::new(centre, radius);
            self.sunk[number] = 0.0;
            let material = world.add_material(match number {
                0 => Material {
                    diffuse: 0.55,
                    specular: 0.45,
                    shine: 60.0,
                    ..Material::matte(1.0, 0.74, 0.22)
                },
                4 => Material { refraction_index: 1.3, ..Material::glass() },
                _ => Material {
                    diffuse: 0.86,
                    specular: 0.14,
                    shine: 50.0,
                    ..Material::matte(1.0, 1.0, 1.0)
                },
            })?;
            if !matches!(number, 0 | 4) {
                world.recolour(material, hue(number as f64 * 0.382, 0.1))?;
            }
            self.balls[number] = world.add_sphere(centre, radius, material)?;
        }
        Ok(())
    }

    /// Reads the push from the player's input.
    fn steer(&mut self, input: &Input) {
        let mut push = DVec3::new(
            f64::from(input.key_axis(Key::Left, Key::Right)),
            0.0,
            f64::from(input.key_axis(Key::Up, Key::Down)),
        );
        if let Some(pad) = input.pad() {
            push.x += pad.stick(Axis::LeftX);
            push.z += pad.stick(Axis::LeftY);
        }
        if input.mouse_held(MouseButton::Right) {
            let [x, y] = input.mouse().motion.map(f64::from);
            push += DVec3::new(x, 0.0, y) * (A_PIXEL / STEP);
        }
        // The direction is relative to the eye.
        let (sine, cosine) = libm::sincos(self.orbit.turn);
        let push = push.clamp(DVec3::splat(-1.0), DVec3::splat(1.0)) * PUSH;
        self.push =
            DVec3::new(push.x * cosine + push.z * sine, 0.0, push.z * cosine - push.x * sine);
    }

    fn drop(&mut self) {
        let place = HALF - DROP;
        let [x, z] = [(); 2].map(|()| self.chance.random_range(-place..place));
        self.water.raise(x, z, DROP, -0.34);
        self.pause = self.chance.random_range(PAUSE / 3..PAUSE);
    }

    /// A step of the water and the balls.
    fn swing(&mut self) {
        if self.pause == 0 {
            self.drop();
        }
        self.pause -= 1;
        self.water.step();
        for (number, body) in self.bodies.iter_mut().enumerate() {
            let DVec3 { x, y, z } = body.centre;
            let radius = body.radius;
            // What the ball itself has pushed up or down is around it and not under it.
            let away = 1.3 * radius;
            let [left, right] = [x - away, x + away].map(|x| self.water.height(x, z));
            let [back, front] = [z - away, z + away].map(|z| self.water.height(x, z));
            let level = 0.25 * ((left + right) + (back + front));
            let sunk = ((level - y + radius) / (2.0 * radius)).clamp(0.0, 1.0);
            // The share of the volume below a plane.
            let wet = sunk * sunk * (3.0 - 2.0 * sunk);
            let slope = DVec3::new(right - left, 0.0, front - back) / (2.0 * away);
            let mut pull = DVec3::Y * (GRAVITY * (wet / DENSITY - 1.0)) - slope * (GRAVITY * wet);
            if number == 0 {
                pull += self.push * wet.min(DENSITY) / DENSITY;
            }
            body.velocity += pull * STEP;
            body.velocity *= 1.0 - DRAG * wet * STEP;
            body.centre += body.velocity * STEP;
            let depth = 2.0 * radius * sunk;
            // The water that it leaves, and the water that it enters.
            self.water.raise(x, z, radius, -ASIDE * self.sunk[number]);
            self.water.raise(body.centre.x, body.centre.z, radius, ASIDE * depth);
            self.sunk[number] = depth;
        }
        pairs(&mut self.bodies, |a, b| {
            meet(a, b, 0.6);
        });
        let (half, high) = (DVec3::new(HALF, DEPTH, HALF), DVec3::Y * 10.0);
        for body in &mut self.bodies {
            body.keep_within(-half, half + high, 0.5);
        }
    }
}

impl Game for Waves {
    fn name(&self) -> &str {
        NAME
    }

    fn controls(&self) -> &[&str] {
        CONTROLS
    }

    fn status(&self) -> String {
        let count = self.water.count();
        format!("{count}x{count} squares")
    }

    fn set_up(&mut self, world: &mut World, start: &Start) -> Result<(), WorldError> {
        self.chance = Xoshiro256PlusPlus::seed_from_u64(start.seed);
        world.set_name(NAME);
        world.set_render_options(RenderOptions {
            model: Model::Whitted,
            ray_depth: 4,
            // Waves hardly move across, so the tree stays as good as a new one.
            refit_pictures: u32::MAX,
            ..RenderOptions::default()
        });
        world.set_background(DVec3::new(0.62, 0.72, 0.82))?;
        world.set_sky(Some(Sky { zenith: DVec3::new(0.1, 0.24, 0.52), up: DVec3::Y }))?;
        world.set_ambient(DVec3::splat(0.2))?;
        world.add_light(Light::at(DVec3::new(-6.0, 9.0, 4.0)).coloured(0.8, 0.76, 0.68))?;
        world.add_light(Light::at(DVec3::new(7.0, 6.0, -3.0)).coloured(0.3, 0.34, 0.42))?;
        self.surface = world.add_material(Material {
            diffuse: 0.3,
            specular: 0.62,
            shine: 150.0,
            ..Material::matte(0.06, 0.24, 0.34)
        })?;
        Self::add_pool(world)?;
        self.add_balls(world)?;
        self.fill(world, self.water.count())?;
        world.look_from(self.orbit.from(DVec3::ZERO), DVec3::ZERO)
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        self.orbit.steer(frame.input, frame.delta);
        self.steer(frame.input);
        let pad = |button| frame.input.pad().is_some_and(|pad| pad.pressed(button));
        if frame.input.key_pressed(Key::Space) || pad(Button::Cross) {
            self.drop();
        }
        let current = GRIDS.iter().position(|&grid| grid == self.water.count()).unwrap_or_default();
        let wanted = match frame.input {
            input if input.key_pressed(Key::Digit1) => 0,
            input if input.key_pressed(Key::Digit2) => 1,
            input if input.key_pressed(Key::Digit3) => 2,
            _ if pad(Button::Square) => current.saturating_sub(1),
            _ if pad(Button::Triangle) => (current + 1).min(GRIDS.len() - 1),
            _ => current,
        };
        if wanted != current {
            self.fill(world, GRIDS[wanted])?;
        }
        self.passed += self.steps.of(frame.delta);
        let has_moved = self.passed >= STRIDE;
        while self.passed >= STRIDE {
            self.passed -= STRIDE;
            self.swing();
        }
        if has_moved {
            for (body, &ball) in self.bodies.iter().zip(&self.balls) {
                world.move_to(ball, body.centre)?;
            }
            self.water.shape(&mut self.positions, &mut self.normals);
            world.shape_mesh(self.mesh, &self.positions, &self.normals)?;
        }
        world.look_from(self.orbit.from(DVec3::ZERO), DVec3::ZERO)
    }
}

const _: () = assert!(steps::STEP * STRIDE as f64 == STEP);
