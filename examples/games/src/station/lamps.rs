//! The lamps of a level. Each has a range, so those far away cost nothing.

use std::collections::BTreeSet;

use cellray::game::{DVec3, Light, LightId, World, WorldError};

use super::ground::Ground;
use super::things::{self, Decorations};

/// How far a lamp's light reaches.
const RANGE: f64 = 352.0;
/// The brightness of a lamp, as a share of its colour.
const BRIGHTNESS: f64 = 0.9;

/// The lamps.
#[derive(Default)]
pub struct Lamps {
    /// All lamps: first those that shine. They are as many as the lights.
    lamps: Vec<(DVec3, Light)>,
    lights: Vec<LightId>,
}

impl Lamps {
    /// Adds the lamps and the decorations of a map.
    /// The level shows those of some kinds already.
    pub fn add(
        ground: &Ground,
        shown: &BTreeSet<u16>,
        world: &mut World,
    ) -> Result<Self, WorldError> {
        let mut lamps = Vec::new();
        let mut decorations = Decorations::default();
        for thing in &ground.map.things {
            let Some(kind) = things::decoration(thing.kind) else { continue };
            let Some(sector) = ground.sector(thing.place) else { continue };
            let floor = ground.height(sector, levels::Plane::Floor);
            let foot = Ground::in_space(thing.place, floor);
            if !shown.contains(&thing.kind) {
                decorations.add(foot, kind);
            }
            let top = foot + kind.light_above();
            if let Some(colour) = kind.light {
                let [red, green, blue] = colour.map(|channel| BRIGHTNESS * channel);
                lamps.push((top, Light::at(top).within(RANGE).coloured(red, green, blue)));
            }
        }
        decorations.finish(world)?;
        let shining = lamps.iter().take(World::MAX_LIGHTS);
        let lights = shining.map(|&(_, light)| world.add_light(light));
        let lights = lights.collect::<Result<Vec<_>, _>>()?;
        world.set_default_light(false);
        if lights.is_empty() {
            // A world without a light would be traced with depth shading.
            world.add_light(Light::sun(DVec3::Y).coloured(0.0, 0.0, 0.0))?;
        }
        Ok(Self { lamps, lights })
    }

    /// Lets those lamps shine that are nearest to the eye, if a world can't have all of them.
    pub fn shine(&mut self, eye: DVec3, world: &mut World) -> Result<(), WorldError> {
        if self.lamps.len() > self.lights.len() {
            let nearer = |(place, _): &(DVec3, Light), (other, _): &(DVec3, Light)| {
                place.distance_squared(eye).total_cmp(&other.distance_squared(eye))
            };
            self.lamps.select_nth_unstable_by(self.lights.len(), nearer);
            for (&id, &(_, light)) in self.lights.iter().zip(&self.lamps) {
                world.set_light(id, light)?;
            }
        }
        Ok(())
    }
}
