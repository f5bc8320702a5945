//! The scene of a game of billiards: the table, the painted balls, the cue, and the marker.
//!
//! Each shape has only one material and no texture. A ball's stripe is the part that two white
//! caps leave uncovered. The caps are spheres that are a little smaller than the ball and off its
//! centre, so that they protrude by less than a hair.

use cellray::game::{
    DVec3, Light, Material, MaterialId, ObjectId, Shader, Shape, World, WorldError,
};

use super::aim::Aim;
use super::balls::{BALLS, Ball, Balls, Place};
use super::rules::{EIGHT, Group, Rules};
use super::table::{CUSHION, CUSHIONS, HALF, HEIGHT, POCKETS, RADIUS, RAIL};
use crate::colour::hue;

/// The number of dots on the path of the cue ball.
const DOTS: usize = 7;
const MARKER: f64 = 0.026;
/// The lamps' positions along the table, and their height.
const LAMPS: [f64; 2] = [-0.62, 0.62];
const LAMP_HEIGHT: f64 = 1.35;
/// By how much caps protrude, in radii.
const PROTRUSION: f64 = 0.006;

/// The distances from the tip at which the parts of the cue meet, and its radius there.
const CUE: [(f64, f64); 5] =
    [(0.0, 0.0055), (0.012, 0.006), (0.04, 0.0062), (0.8, 0.0105), (1.42, 0.0145)];
/// The slope of the cue: its butt is held above the rail.
const CUE_RISE: f64 = 0.11;

/// The colours of the solids, and of the stripes in the same order.
const COLOURS: [[f64; 3]; 7] = [
    [0.95, 0.72, 0.08],
    [0.08, 0.2, 0.72],
    [0.82, 0.08, 0.07],
    [0.34, 0.12, 0.5],
    [0.93, 0.4, 0.06],
    [0.06, 0.42, 0.2],
    [0.48, 0.08, 0.12],
];

#[derive(Default)]
pub(super) struct Scene {
    /// Each ball with its two caps.
    balls: [[ObjectId; 3]; BALLS],
    cue: [ObjectId; CUE.len() - 1],
    dots: [ObjectId; DOTS],
    marker: ObjectId,
    marker_glow: MaterialId,
}

/// What the marker shows.
pub(super) enum Sign {
    Turn,
    Foul,
    /// The seconds since the game was won.
    Won(f64),
}

impl Scene {
    pub fn add(world: &mut World, balls: &Balls) -> Result<Self, WorldError> {
        world.set_background(DVec3::new(0.075, 0.06, 0.055))?;
        world.set_ambient(DVec3::splat(0.2))?;
        add_surroundings(world)?;
        add_bed(world)?;
        add_rails(world)?;
        add_pockets(world)?;
        let mut scene = Self::default();
        scene.add_balls(world, balls)?;
        scene.add_cue(world)?;
        Ok(scene)
    }

    fn add_balls(&mut self, world: &mut World, balls: &Balls) -> Result<(), WorldError> {
        let polished = |[red, green, blue]: [f64; 3]| Material {
            diffuse: 0.86,
            specular: 0.14,
            shine: 90.0,
            ..Material::matte(red, green, blue)
        };
        let ivory = world.add_material(polished([0.93, 0.9, 0.82]))?;
        let red = world.add_material(polished([0.75, 0.1, 0.08]))?;
        let black = world.add_material(polished([0.025, 0.025, 0.03]))?;
        let mut colours = [MaterialId::default(); COLOURS.len()];
        for (material, colour) in colours.iter_mut().zip(COLOURS) {
            *material = world.add_material(polished(colour))?;
        }
        for ball in &balls.0 {
            let number = ball.number;
            let (body, caps) = match number {
                0 => (ivory, red),
                EIGHT => (black, ivory),
                1..EIGHT => (colours[number - 1], ivory),
                _ => (colours[number - EIGHT - 1], ivory),
            };
            let shapes = shapes(ball);
            for (object, (shape, material)) in
                self.balls[number].iter_mut().zip(shapes.into_iter().zip([body, caps, caps]))
            {
                *object = world.add(shape, material)?;
            }
        }
        Ok(())
    }

    fn add_cue(&mut self, world: &mut World) -> Result<(), WorldError> {
        let wood = |red, green, blue| Material {
            specular: 0.08,
            shine: 30.0,
            ..Material::matte(red, green, blue)
        };
        let chalk = world.add_material(Material::matte(0.2, 0.4, 0.75))?;
        let ferrule = world.add_material(wood(0.92, 0.9, 0.84))?;
        let maple = world.add_material(wood(0.86, 0.66, 0.4))?;
        let butt = world.add_material(wood(0.2, 0.07, 0.05))?;
        for ((object, material), ends) in
            (self.cue.iter_mut().zip([chalk, ferrule, maple, butt])).zip(CUE.windows(2))
        {
            let place = |(along, _): (f64, f64)| DVec3::X * along;
            *object = world.add(part(ends, place), material)?;
        }
        let light = world.add_material(Material::flat(0.8, 0.86, 0.7))?;
        for dot in &mut self.dots {
            *dot = world.add_sphere(DVec3::ZERO, 0.0035, light)?;
        }
        self.marker_glow = world.add_material(Material::flat(1.0, 1.0, 1.0))?;
        self.marker = world.add_sphere(DVec3::ZERO, MARKER, self.marker_glow)?;
        Ok(())
    }

    /// Shows the balls in their present state, and the pocketed ones on the rails.
    pub fn show_balls(&self, world: &mut World, balls: &Balls) -> Result<(), WorldError> {
        for ball in &balls.0 {
            let seen = ball.place != Place::Gone || ball.number != 0;
            let shown = match ball.place {
                Place::Gone => on_the_rail(ball),
                _ => *ball,
            };
            for (object, shape) in self.balls[ball.number].into_iter().zip(shapes(&shown)) {
                world.reshape(object, shape)?;
                world.show(object, seen)?;
            }
        }
        Ok(())
    }

    /// Shows the cue at this distance behind the cue ball. With an aim, also shows the dots on the
    /// ball's path.
    pub fn show_cue(
        &self,
        world: &mut World,
        balls: &Balls,
        aim: &Aim,
        drawn: Option<f64>,
        dotted: bool,
    ) -> Result<(), WorldError> {
        let (ball, direction) = (balls.0[0].body.centre, aim.direction());
        let back = (DVec3::Y * CUE_RISE - direction).normalize();
        let tip = ball + DVec3::Y * (aim.height() * 0.5 * RADIUS)
            - direction * (RADIUS + drawn.unwrap_or(0.0));
        for (&object, ends) in self.cue.iter().zip(CUE.windows(2)) {
            world.reshape(object, part(ends, |(along, _)| tip + back * along))?;
            world.show(object, drawn.is_some())?;
        }
        let way = aim.free_way(balls);
        for (number, &dot) in self.dots.iter().enumerate() {
            let along = way * (number + 1) as f64 / DOTS as f64;
            world.move_to(dot, ball + direction * along)?;
            // A dot inside a ball is not shown.
            world.show(dot, dotted && along > RADIUS)?;
        }
        Ok(())
    }

    /// Shows whose turn it is, by the marker's colour and by its place on the rail of that
    /// player's balls.
    pub fn show_marker(
        &self,
        world: &mut World,
        rules: &Rules,
        sign: Sign,
    ) -> Result<(), WorldError> {
        let player = shown_player(rules);
        let colour = match sign {
            Sign::Turn => [DVec3::new(1.0, 0.85, 0.25), DVec3::new(0.3, 0.65, 1.0)][player],
            Sign::Foul => DVec3::new(1.0, 0.1, 0.05),
            Sign::Won(seconds) => hue(seconds, 0.0),
        };
        world.move_to(self.marker, marker_place(rules))?;
        world.recolour(self.marker_glow, colour)
    }
}

/// The player that the marker shows: the winner, or the one whose turn it is.
fn shown_player(rules: &Rules) -> usize {
    rules.winner().unwrap_or(rules.turn())
}

fn marker_place(rules: &Rules) -> DVec3 {
    let player = shown_player(rules);
    let rail = |half: f64| half + CUSHION + RAIL / 2.0;
    let y = HEIGHT + MARKER;
    match rules.group_of(player) {
        Some(Group::Full) => DVec3::new(-0.3, y, rail(HALF.1)),
        Some(Group::Striped) => DVec3::new(-0.3, y, -rail(HALF.1)),
        None => DVec3::new(rail(HALF.0), y, [-0.25, 0.25][player]),
    }
}

/// A part of the cue between two of its places.
fn part(ends: &[(f64, f64)], place: impl Fn((f64, f64)) -> DVec3) -> Shape {
    let (first, last) = (ends[0], ends[ends.len() - 1]);
    Shape::Cone { base: place(first), base_radius: first.1, apex: place(last), apex_radius: last.1 }
}

fn shapes(ball: &Ball) -> [Shape; 3] {
    let centre = ball.body.centre;
    // The edge of the caps: the cosine of the angle from their centres.
    let end = match Group::of(ball.number) {
        Some(Group::Striped) => 0.5,
        _ => 0.93,
    };
    let off = (PROTRUSION + PROTRUSION * PROTRUSION / 2.0) / (1.0 + PROTRUSION - end);
    let cap = |side: f64| Shape::Sphere {
        centre: centre + ball.axis * (side * off * RADIUS),
        radius: (1.0 + PROTRUSION - off) * RADIUS,
    };
    let radius = RADIUS;
    [Shape::Sphere { centre, radius }, cap(1.0), cap(-1.0)]
}

/// A pocketed ball in its place among its group.
fn on_the_rail(ball: &Ball) -> Ball {
    let (side, place) = match Group::of(ball.number) {
        Some(Group::Striped) => (-1.0, ball.number - EIGHT),
        _ => (1.0, ball.number),
    };
    let mut shown = *ball;
    shown.body.centre = DVec3::new(
        0.12 + place as f64 * 2.3 * RADIUS,
        HEIGHT + RADIUS,
        side * (HALF.1 + CUSHION + RAIL / 2.0),
    );
    shown
}

/// A horizontal rectangle that faces up.
fn level(low: (f64, f64), high: (f64, f64), y: f64) -> [DVec3; 4] {
    let p = |x, z| DVec3::new(x, y, z);
    [p(low.0, high.1), p(high.0, high.1), p(high.0, low.1), p(low.0, low.1)]
}

/// A vertical rectangle over a line. It is seen from the side from which the line goes to the
/// right.
fn upright([a, b]: [DVec3; 2], low: f64, high: f64) -> [DVec3; 4] {
    let at = |place: DVec3, y| DVec3::new(place.x, y, place.z);
    [at(a, low), at(b, low), at(b, high), at(a, high)]
}

fn add_fixed(world: &mut World, corners: &[DVec3], of: MaterialId) -> Result<(), WorldError> {
    let object = world.add_polygon(corners, of)?;
    world.fix(object)
}

fn add_surroundings(world: &mut World) -> Result<(), WorldError> {
    let floor = world.add_material(Material {
        shader: Shader::Checker { other: DVec3::new(0.17, 0.11, 0.08), size: 0.45 },
        ..Material::matte(0.26, 0.18, 0.13)
    })?;
    add_fixed(world, &level((-4.5, -3.6), (4.5, 3.6), -0.78), floor)?;
    let lamp = world.add_material(Material::flat(1.0, 0.96, 0.86))?;
    for x in LAMPS {
        // It is only visible from below, for example in reflections on balls.
        let mut corners = level((x - 0.3, -0.12), (x + 0.3, 0.12), LAMP_HEIGHT + 0.02);
        corners.reverse();
        add_fixed(world, &corners, lamp)?;
        let light = Light::at(DVec3::new(x, LAMP_HEIGHT, 0.0));
        world.add_light(light.coloured(0.6, 0.57, 0.52))?;
    }
    Ok(())
}

fn add_bed(world: &mut World) -> Result<(), WorldError> {
    let cloth = world
        .add_material(Material { shader: Shader::Lambert, ..Material::matte(0.07, 0.44, 0.33) })?;
    let cushions = world
        .add_material(Material { shader: Shader::Lambert, ..Material::matte(0.06, 0.38, 0.28) })?;
    let (x, z) = (HALF.0 + CUSHION, HALF.1 + CUSHION);
    add_fixed(world, &level((-x, -z), (x, z), 0.0), cloth)?;
    for cushion in CUSHIONS {
        for line in cushion.lines() {
            add_fixed(world, &upright(line, 0.0, HEIGHT), cushions)?;
        }
        let [a, b] = cushion.nose;
        let [behind_a, behind_b] = cushion.back;
        let top = [a, b, behind_b, behind_a].map(|place| place + DVec3::Y * HEIGHT);
        add_fixed(world, &top, cushions)?;
    }
    Ok(())
}

fn add_rails(world: &mut World) -> Result<(), WorldError> {
    let wood = world
        .add_material(Material { shader: Shader::Lambert, ..Material::matte(0.42, 0.18, 0.08) })?;
    let (x, z) = (HALF.0 + CUSHION, HALF.1 + CUSHION);
    let (far_x, far_z) = (x + RAIL, z + RAIL);
    for top in [
        level((-far_x, z), (far_x, far_z), HEIGHT),
        level((-far_x, -far_z), (far_x, -z), HEIGHT),
        level((-far_x, -z), (-x, z), HEIGHT),
        level((x, -z), (far_x, z), HEIGHT),
    ] {
        add_fixed(world, &top, wood)?;
    }
    let p = |x, z| DVec3::new(x, 0.0, z);
    let round = |x: f64, z: f64| [p(-x, z), p(x, z), p(x, -z), p(-x, -z)];
    let (outer, inner) = (round(far_x, far_z), round(x, z));
    for side in 0..4 {
        let next = (side + 1) % 4;
        add_fixed(world, &upright([outer[side], outer[next]], -0.2, HEIGHT), wood)?;
        add_fixed(world, &upright([inner[next], inner[side]], 0.0, HEIGHT), wood)?;
    }
    for (x, z) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
        let foot = DVec3::new(x * HALF.0, -0.78, z * HALF.1);
        let leg = world.add(
            Shape::Cone {
                base: foot,
                base_radius: 0.045,
                apex: foot + DVec3::Y * 0.6,
                apex_radius: 0.075,
            },
            wood,
        )?;
        world.fix(leg)?;
    }
    // Diamonds: three on each half of a long rail, and three on a short rail.
    let pearl = world.add_material(Material::matte(0.9, 0.88, 0.8))?;
    for step in [-3, -2, -1, 1, 2, 3] {
        let along = f64::from(step) * HALF.0 / 4.0;
        for z in [-z - RAIL / 2.0, z + RAIL / 2.0] {
            add_diamond(world, DVec3::new(along, HEIGHT, z), pearl)?;
        }
    }
    for step in [-1, 0, 1] {
        let along = f64::from(step) * HALF.1 / 2.0;
        for x in [-x - RAIL / 2.0, x + RAIL / 2.0] {
            add_diamond(world, DVec3::new(x, HEIGHT, along), pearl)?;
        }
    }
    Ok(())
}

/// Adds the visible part of a sphere that is sunk into the rail.
fn add_diamond(world: &mut World, place: DVec3, of: MaterialId) -> Result<(), WorldError> {
    let diamond = world.add_sphere(place - DVec3::Y * 0.0215, 0.023, of)?;
    world.fix(diamond)
}

fn add_pockets(world: &mut World) -> Result<(), WorldError> {
    let dark = world.add_material(Material::flat(0.006, 0.006, 0.007))?;
    for pocket in POCKETS {
        // A shallow bowl, because the bed has no hole.
        let bowl = world.add(
            Shape::Cone {
                base: pocket.centre + DVec3::Y * 0.004,
                base_radius: pocket.reach * 1.08,
                apex: pocket.centre + DVec3::Y * 0.001,
                apex_radius: 0.0,
            },
            dark,
        )?;
        world.fix(bowl)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{EIGHT, Rules, marker_place};
    use crate::billiards::rules::Shot;

    #[test]
    fn marker_is_beside_balls_of_its_player() {
        let mut rules = Rules::new(0);
        let mut gone = 0_u16;
        let mut judge = |rules: &mut Rules, touched: usize, pocketed: usize| {
            let mut shot = Shot::default();
            shot.touch(touched);
            shot.pocket(pocketed);
            gone |= 1 << pocketed;
            rules.judge(&shot, |number| gone >> number & 1 == 0);
        };
        judge(&mut rules, 1, 3);
        assert!(marker_place(&rules).x > 1.0);
        // The solids are placed in front, for player 0.
        judge(&mut rules, 1, 2);
        assert!(marker_place(&rules).z > 0.6);
        // The player who loses by the eight is still at the table. The winner is the other one,
        // whose balls are at the back.
        judge(&mut rules, 1, EIGHT);
        assert_eq!((rules.turn(), rules.winner()), (0, Some(1)));
        assert!(marker_place(&rules).z < -0.6);
    }
}
