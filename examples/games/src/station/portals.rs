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
}

/// By how much whoever walks into one turns, in radians.
pub const TURN: f64 = PI;

impl Portal {
    /// Adds all to the world.
    pub fn add(ground: &Ground, world: &mut World) -> Result<Vec<Self>, WorldError> {
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
            let (sum, rise) = (middle + other, beyond - floor);
            let shader =
                Shader::Portal { by: Ground::in_space(sum, rise), turn: TURN.to_degrees() };
            let material =
                world.add_material(Material { shader, ..Material::matte(1.0, 1.0, 1.0) })?;
            let [left, right] = lines[from];
            let corners: [DVec3; 4] = [
                Ground::in_space(left, floor),
                Ground::in_space(right, floor),
                Ground::in_space(right, ceiling),
                Ground::in_space(left, ceiling),
            ];
            world.add_polygon(&corners, material)?;
            let is_there = |ends: [DVec2; 2]| ends == [left, right] || ends == [right, left];
            let mut all = (0..).zip(&ground.map.lines);
            let line = all.find(|(_, line)| is_there(ground.map.places(line)));
            portals.extend(line.map(|(line, _)| Self { line, sum, rise }));
        }
        Ok(portals)
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
