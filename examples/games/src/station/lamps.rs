//! The lamps of a level, of which the nearest shine.
//!
//! The brightness of a light does not fall with distance, so lamps far from the eye must be out. A
//! lamp has the more light the nearer it is than the first one that is out. It therefore goes out
//! gradually while another one takes its place.

use cellray::game::{DVec3, Light, LightId, World, WorldError};

use super::ground::Ground;
use super::things::{self, Decorations};

/// The number of lamps that shine.
const SHINING: usize = 3;
/// The distance from which on a lamp is out.
const RANGE: f64 = 700.0;
/// The most brightness of a lamp, as a share of its colour.
const BRIGHTNESS: f64 = 0.8;
/// A lamp has this brightness if it is nearer than one that is out by this share of the range.
const NEARER: f64 = 0.25;

/// The lamps.
#[derive(Default)]
pub struct Lamps {
    lamps: Vec<(DVec3, DVec3)>,
    lights: Vec<LightId>,
}

impl Lamps {
    /// Adds the lamps and the decorations of a map.
    pub fn add(ground: &Ground, world: &mut World) -> Result<Self, WorldError> {
        let mut lamps = Vec::new();
        let mut decorations = Decorations::default();
        for thing in &ground.map.things {
            let Some(kind) = things::decoration(thing.kind) else { continue };
            let Some(sector) = ground.sector(thing.place) else { continue };
            let floor = ground.height(sector, levels::Plane::Floor);
            let top = decorations.add(Ground::in_space(thing.place, floor), kind);
            if let Some(colour) = kind.light {
                lamps.push((top, DVec3::from(colour)));
            }
        }
        decorations.finish(world)?;
        let count = lamps.len().min(SHINING);
        let dark = || Light::at(DVec3::ZERO).coloured(0.0, 0.0, 0.0);
        let lights = (0..count).map(|_| world.add_light(dark()));
        let lights = lights.collect::<Result<Vec<_>, _>>()?;
        world.set_default_light(false);
        if lights.is_empty() {
            // A world without a light would be traced with depth shading.
            world.add_light(Light::sun(DVec3::Y).coloured(0.0, 0.0, 0.0))?;
        }
        Ok(Self { lamps, lights })
    }

    /// Lets those lamps shine that are nearest to the eye.
    pub fn shine(&self, eye: DVec3, world: &mut World) -> Result<(), WorldError> {
        let nearness = |place: DVec3| (1.0 - place.distance(eye) / RANGE).max(0.0);
        // The nearest ones in order, and the first one that is out.
        let mut nearest = [(0.0, 0); SHINING + 1];
        for (number, &(place, _)) in self.lamps.iter().enumerate() {
            let near = nearness(place);
            let at = nearest.iter().position(|(other, _)| near > *other);
            if let Some(at) = at {
                nearest[at..].rotate_right(1);
                nearest[at] = (near, number);
            }
        }
        let (out, _) = nearest[SHINING];
        for (&light, &(near, number)) in self.lights.iter().zip(&nearest) {
            let (place, colour) = self.lamps[number];
            let [red, green, blue] =
                (colour * (BRIGHTNESS * ((near - out) / NEARER).min(1.0))).to_array();
            world.set_light(light, Light::at(place).coloured(red, green, blue))?;
        }
        Ok(())
    }
}
