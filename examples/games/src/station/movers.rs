//! Doors, lifts and floors that move.

use cellray::game::{DAffine3, DVec3, MeshId, World, WorldError};
use glam::DVec2;
use levels::{Action, Plane, special};

use super::ground::Ground;

/// Units a second.
const DOOR: f64 = 70.0;
const LIFT: f64 = 140.0;
const FLOOR: f64 = 35.0;
/// The seconds for which a door stays open, and a lift down.
const OPEN: f64 = 4.3;
const DOWN: f64 = 3.0;

/// A floor or ceiling that moves.
pub struct Mover {
    plane: (u32, Plane),
    /// Its height in the map, at which its mesh is.
    built: f64,
    mesh: Option<MeshId>,
    motion: Motion,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Motion {
    Rests,
    /// On its way to a height, and the seconds after which it returns to another one.
    Goes {
        to: f64,
        speed: f64,
        back: Option<(f64, f64)>,
    },
    Waits {
        seconds: f64,
        to: f64,
        speed: f64,
    },
}

/// All that moves in a level.
#[derive(Default)]
pub struct Movers(Vec<Mover>);

impl Movers {
    /// Adds a floor or ceiling with the mesh that moves with it.
    pub fn add(&mut self, ground: &Ground, plane: (u32, Plane), mesh: Option<MeshId>) {
        let built = ground.height(plane.0, plane.1);
        self.0.push(Mover { plane, built, mesh, motion: Motion::Rests });
    }

    /// Whether nothing moves or will move by itself.
    #[must_use]
    pub fn rest(&self) -> bool {
        self.0.iter().all(|mover| mover.motion == Motion::Rests)
    }

    /// Starts what the special of a line moves. Returns whether it moves anything.
    pub fn start(&mut self, ground: &Ground, line: u32) -> bool {
        let line = &ground.map.lines[line as usize];
        let Some(special) = special(line.special) else {
            return false;
        };
        let mut starts = false;
        for (plane, to) in levels::moves(&ground.map, line) {
            let Some(mover) = self.0.iter_mut().find(|mover| mover.plane == plane) else {
                continue;
            };
            let motion = match special.action {
                Action::Door { stays, .. } => {
                    let back = (!stays).then_some((mover.built, OPEN));
                    Motion::Goes { to, speed: DOOR, back }
                }
                Action::Lift => Motion::Goes { to, speed: LIFT, back: Some((mover.built, DOWN)) },
                _ => Motion::Goes { to, speed: FLOOR, back: None },
            };
            // A lift that is on its way goes on.
            if special.action != Action::Lift || mover.motion == Motion::Rests {
                mover.motion = motion;
                starts = true;
            }
        }
        starts
    }

    /// Moves everything for some seconds. What would squeeze the walker stays where it is, and a
    /// door opens again. Returns the walker's feet.
    pub fn step(&mut self, ground: &mut Ground, seconds: f64, place: DVec2, feet: f64) -> f64 {
        let mut feet = feet;
        for mover in &mut self.0 {
            let (sector, plane) = mover.plane;
            match mover.motion {
                Motion::Rests => {}
                Motion::Waits { seconds: left, to, speed } if left > seconds => {
                    mover.motion = Motion::Waits { seconds: left - seconds, to, speed };
                }
                Motion::Waits { to, speed, .. } => {
                    mover.motion = Motion::Goes { to, speed, back: None };
                }
                Motion::Goes { to, speed, back } => {
                    let from = ground.height(sector, plane);
                    let way = (to - from).clamp(-speed * seconds, speed * seconds);
                    ground.set_height(sector, plane, from + way);
                    match ground.stand(place, feet) {
                        Ok(floor) => feet = floor,
                        Err(_) => {
                            ground.set_height(sector, plane, from);
                            if plane == Plane::Ceiling && way < 0.0 {
                                mover.motion = Motion::Waits { seconds: OPEN, to, speed };
                            }
                            continue;
                        }
                    }
                    if from + way == to {
                        mover.motion = match back {
                            Some((to, seconds)) => Motion::Waits { seconds, to, speed },
                            None => Motion::Rests,
                        };
                    }
                }
            }
        }
        feet
    }

    /// Puts the meshes to where they are now.
    pub fn place(&self, ground: &Ground, world: &mut World) -> Result<(), WorldError> {
        for mover in &self.0 {
            if let Some(mesh) = mover.mesh {
                let up = ground.height(mover.plane.0, mover.plane.1) - mover.built;
                world.place_mesh(mesh, DAffine3::from_translation(DVec3::Y * up))?;
            }
        }
        Ok(())
    }
}
