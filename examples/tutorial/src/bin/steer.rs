//! A ball on a mirror that keys or a pad steer. It takes the colours of the pearls that it
//! touches.

use cellray::game::{
    Axis, Button, DVec3, Frame, Game, Input, Key, Light, Material, MaterialId, ObjectId, Shader,
    Start, World, WorldError,
};

/// Radius of the ball, and of a pearl.
const BALL: f64 = 1.0;
const PEARL: f64 = 0.5;
/// Half the length of the mirror's side.
const EDGE: f64 = 5.0;
/// The maximum speed that the player can give the ball, and its change of speed in a second.
const SPEED: f64 = 7.0;
const GRIP: f64 = 12.0;
/// The speed at which the ball leaves the ground, and its loss of speed in a second.
const JUMP: f64 = 8.0;
const GRAVITY: f64 = 20.0;

#[derive(Default)]
struct Steer {
    ball: ObjectId,
    paint: MaterialId,
    pearls: Vec<ObjectId>,
    velocity: DVec3,
}

impl Game for Steer {
    fn name(&self) -> &str {
        "steer"
    }

    fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
        world.look_from(DVec3::new(0.0, 5.2, 11.2), DVec3::new(0.0, 0.2, 0.4))?;
        world.set_background(DVec3::new(0.16, 0.2, 0.34))?;
        world.set_ambient(DVec3::splat(0.25))?;
        world.add_light(Light::at(DVec3::new(-7.0, 12.0, 8.0)).coloured(1.0, 0.92, 0.8))?;
        self.paint = world.add_material(Material::shiny(0.9, 0.9, 0.9))?;
        self.ball = world.add_sphere(DVec3::Y * BALL, BALL, self.paint)?;
        add_floor(world)?;
        self.add_pearls(world)
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        let from = world.position(self.ball)?;
        let to = self.roll(from, frame.input, frame.delta.min(0.1));
        world.move_to(self.ball, to)?;
        self.take_pearl(world, to)
    }

    fn is_over(&self) -> bool {
        self.pearls.is_empty()
    }
}

fn add_floor(world: &mut World) -> Result<(), WorldError> {
    let mirror = world.add_material(Material {
        diffuse: 0.5,
        specular: 0.5,
        shine: 60.0,
        shader: Shader::Checker { other: DVec3::new(0.1, 0.12, 0.25), size: 1.25 },
        ..Material::matte(0.8, 0.72, 0.6)
    })?;
    let corners = [(-EDGE, EDGE), (EDGE, EDGE), (EDGE, -EDGE), (-EDGE, -EDGE)];
    let floor = world.add_polygon(&corners.map(|(x, z)| DVec3::new(x, 0.0, z)), mirror)?;
    world.fix(floor)
}

impl Steer {
    fn add_pearls(&mut self, world: &mut World) -> Result<(), WorldError> {
        for (place, [red, green, blue]) in [
            ((-3.8, 2.2), [0.95, 0.25, 0.2]),
            ((-3.2, -3.0), [0.95, 0.75, 0.2]),
            ((1.2, -4.2), [0.3, 0.75, 0.35]),
            ((4.0, -1.6), [0.2, 0.6, 0.95]),
            ((2.8, 3.2), [0.75, 0.35, 0.9]),
        ] {
            let colour = world.add_material(Material::shiny(red, green, blue))?;
            let centre = DVec3::new(place.0, PEARL, place.1);
            let pearl = world.add_sphere(centre, PEARL, colour)?;
            world.fix(pearl)?;
            self.pearls.push(pearl);
        }
        Ok(())
    }

    /// The position of the ball after `step` seconds.
    fn roll(&mut self, from: DVec3, input: &Input, step: f64) -> DVec3 {
        let pad = input.pad();
        let stick = |axis| pad.map_or(0.0, |pad| pad.axis(axis));
        let right = input.key_axis(Key::Left, Key::Right) + stick(Axis::LeftX);
        let near = input.key_axis(Key::Up, Key::Down) + stick(Axis::LeftY);
        let wanted = DVec3::new(right.into(), 0.0, near.into()) * SPEED;
        let wanted = wanted.with_y(self.velocity.y);
        self.velocity = self.velocity.move_towards(wanted, GRIP * step);
        self.velocity.y -= GRAVITY * step;
        let jumps =
            input.key_pressed(Key::Space) || pad.is_some_and(|pad| pad.pressed(Button::Cross));
        if jumps && from.y <= BALL {
            self.velocity.y = JUMP;
        }
        let to = from + self.velocity * step;
        let most = EDGE - BALL;
        let kept = to.clamp(DVec3::new(-most, BALL, -most), DVec3::new(most, f64::MAX, most));
        // An obstacle takes the ball's speed in that direction.
        self.velocity *= DVec3::select(kept.cmpeq(to), DVec3::ONE, DVec3::ZERO);
        kept
    }

    /// Takes the pearl that the ball touches, if any, and its colour.
    fn take_pearl(&mut self, world: &mut World, ball: DVec3) -> Result<(), WorldError> {
        let touches = |&pearl: &ObjectId| {
            let pearl = world.position(pearl);
            pearl.is_ok_and(|pearl| pearl.distance(ball) < BALL + PEARL)
        };
        if let Some(number) = self.pearls.iter().position(touches) {
            let pearl = self.pearls.swap_remove(number);
            let colour = world.material(world.material_of(pearl)?)?.colour;
            world.recolour(self.paint, colour)?;
            world.remove(pearl)?;
        }
        Ok(())
    }
}

fn main() -> std::process::ExitCode {
    cellray_play::main_of::<Steer>()
}
