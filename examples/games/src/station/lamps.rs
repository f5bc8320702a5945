//! The lamps of a level. Each has a range, so those far away cost nothing.

use std::collections::BTreeSet;

use cellray::game::{DVec3, Light, LightId, World, WorldError};
use levels::Lamp;

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
    /// The lamps of a map, and its decorations but for kinds that the level shows already.
    pub fn of(ground: &Ground, shown: &BTreeSet<u16>) -> (Self, Decorations) {
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
        (Self { lamps, lights: Vec::new() }, decorations)
    }

    /// The lamps in the order of their lights' numbers; none if these change as the walker moves.
    pub fn fixed(&self) -> Vec<Lamp> {
        let lamps = self.lamps.iter().map(|&(place, _)| Lamp { place, range: RANGE });
        let are_fixed = self.lamps.len() <= World::MAX_LIGHTS;
        lamps.filter(|_| are_fixed).collect()
    }

    /// Adds them to the world, in which there is no other light.
    pub fn add(&mut self, world: &mut World) -> Result<(), WorldError> {
        let shining = self.lamps.iter().take(World::MAX_LIGHTS);
        let lights = shining.map(|&(_, light)| world.add_light(light));
        self.lights = lights.collect::<Result<Vec<_>, _>>()?;
        world.set_default_light(false);
        if self.lights.is_empty() {
            // A world without a light would be traced with depth shading.
            world.add_light(Light::sun(DVec3::Y).coloured(0.0, 0.0, 0.0))?;
        }
        Ok(())
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
