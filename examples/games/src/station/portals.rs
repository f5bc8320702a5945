//! The portals of our own level: whoever walks into one comes out of the other.

use std::f64::consts::PI;

use cellray::game::{DVec3, Material, Shader, World, WorldError};
use glam::DVec2;
use levels::Plane;

use super::ground::Ground;
use super::plan::{PORTALS, Point};

/// A portal: half a turn and a move.
pub struct Portal {
    /// The line in which it is.
    line: u32,
    /// A place before it and the one beyond it add up to this.
    sum: DVec2,
    /// How much higher it is beyond.
    pub rise: f64,
    /// Its corners, counter-clockwise as seen from in front.
    pub corners: [DVec3; 4],
}

/// By how much whoever walks into one turns, in radians.
pub const TURN: f64 = PI;

impl Portal {
    /// All portals.
    pub fn all(ground: &Ground) -> Vec<Self> {
        let place = |[x, y]: Point| DVec2::new(f64::from(x), f64::from(y));
        let lines = PORTALS.map(|ends| ends.map(place));
        let rests = lines.map(|[left, right]| {
            let middle = (left + right) / 2.0;
            let sector = ground.sector(middle).unwrap_or_default();
            let heights = [Plane::Floor, Plane::Ceiling].map(|it| ground.height(sector, it));
            (middle, heights)
        });
        let mut portals = Vec::new();
        for (from, to) in [(0, 1), (1, 0)] {
            let ((middle, [floor, ceiling]), (other, [beyond, _])) = (rests[from], rests[to]);
            let [left, right] = lines[from];
            let corners = [(left, floor), (right, floor), (right, ceiling), (left, ceiling)];
            let corners = corners.map(|(end, height)| Ground::in_space(end, height));
            let is_there = |ends: [DVec2; 2]| ends == [left, right] || ends == [right, left];
            let mut all = (0..).zip(&ground.map.lines);
            let line = all.find(|(_, line)| is_there(ground.map.places(line)));
            let (sum, rise) = (middle + other, beyond - floor);
            portals.extend(line.map(|(line, _)| Self { line, sum, rise, corners }));
        }
        portals
    }

    /// Adds it to the world.
    pub fn add(&self, world: &mut World) -> Result<(), WorldError> {
        let by = Ground::in_space(self.sum, self.rise);
        let shader = Shader::Portal { by, turn: TURN.to_degrees() };
        let material = world.add_material(Material { shader, ..Material::matte(1.0, 1.0, 1.0) })?;
        world.add_polygon(&self.corners, material)?;
        Ok(())
    }

    /// The place beyond it of one at it.
    pub fn beyond(&self, place: DVec2) -> DVec2 {
        self.sum - place
    }

    /// Whether it is in a line.
    pub fn is_in(&self, line: u32) -> bool {
        self.line == line
    }
}
