//! A rock that falls on ground, and the crater that it makes.

use cellray::game::{
    DVec3, HeightField, HeightRegion, HeightSample, Material, ObjectId, World, WorldError,
};

use crate::steps::STEP;

/// Its radius in metres, and its acceleration.
const SIZE: f64 = 2.0;
const GRAVITY: f64 = 9.81;
/// A crater's radius and depth, and how high its rim is and how far it reaches, in radii.
const RADIUS: f64 = 90.0;
const DEPTH: f64 = 40.0;
const RIM: f64 = 14.0;
const REACH: f64 = 1.6;
/// The colour of the ground in it.
const EARTH: [u8; 3] = [96, 78, 62];

/// A rock, which is visible while it falls.
#[derive(Default)]
pub struct Rock {
    ball: ObjectId,
    place: DVec3,
    velocity: DVec3,
    falls: bool,
}

impl Rock {
    pub fn new(world: &mut World) -> Result<Self, WorldError> {
        let stone = world.add_material(Material::matte(0.6, 0.54, 0.48))?;
        let ball = world.add_sphere(DVec3::ZERO, SIZE, stone)?;
        world.show(ball, false)?;
        Ok(Self { ball, ..Self::default() })
    }

    /// Lets it fall, unless it does already.
    pub fn drop(&mut self, place: DVec3, velocity: DVec3) {
        if !self.falls {
            *self = Self { place, velocity, falls: true, ..*self };
        }
    }

    /// Moves it by a step, if it falls.
    pub fn step(&mut self) {
        if self.falls {
            self.velocity.y -= GRAVITY * STEP;
            self.place += self.velocity * STEP;
        }
    }

    /// Puts it where it is now. If that is in the ground, there is a crater instead.
    pub fn show(&mut self, world: &mut World, ground: &mut HeightField) -> Result<(), WorldError> {
        if self.falls && self.place.y <= ground.ground(self.place) {
            self.falls = false;
            let (region, change) = crater(ground, self.place);
            ground.shape(&region, &change);
            world.shape_terrain(&region, &change)?;
        }
        world.move_to(self.ball, self.place)?;
        world.show(self.ball, self.falls)
    }
}

/// The samples of a crater around a place, and how each of them changes.
fn crater(
    ground: &HeightField,
    place: DVec3,
) -> (HeightRegion, impl Fn([u32; 2], HeightSample) -> HeightSample + use<>) {
    let middle = (place - ground.corner) / ground.step();
    let (radius, unit) = (RADIUS / ground.step(), ground.unit());
    let change = move |[column, row]: [u32; 2], HeightSample { height, colour }| {
        let away = libm::hypot(f64::from(column) - middle.x, f64::from(row) - middle.z) / radius;
        let rim = (1.0 - (away - 1.0).abs() / (REACH - 1.0)).max(0.0);
        let rise = RIM * rim * rim - DEPTH * (1.0 - away * away).max(0.0);
        let raised = (f64::from(height) + rise / unit).round();
        let burnt = (2.0 * (REACH - away)).clamp(0.0, 1.0);
        let mixed = |own: u8, earth: u8| {
            (f64::from(own) + burnt * (f64::from(earth) - f64::from(own))).round() as u8
        };
        HeightSample {
            height: raised.clamp(0.0, f64::from(u16::MAX)) as u16,
            colour: [0, 1, 2].map(|part| mixed(colour[part], EARTH[part])),
        }
    };
    (ground.around(place, REACH * RADIUS), change)
}
