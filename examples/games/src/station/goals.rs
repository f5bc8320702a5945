//! What is to be found in a level, and its exit.

use cellray::game::{DAffine3, DVec3, Label, Material, MeshId, ObjectId, Side, World, WorldError};
use glam::DVec2;
use levels::{Action, Thing, special};

use super::ground::{Ground, RADIUS};

/// The kind of our own level's crystals. No thing of Doom has this number.
pub const CRYSTAL: u16 = 9001;
/// The height at which things float, and their radius.
const FLOATS: f64 = 24.0;
const SIZE: f64 = 8.0;
/// Units in what labels call a metre: a walker of 56 units is as tall as a person.
const METRE: f64 = 32.0;

/// The kinds of things to find: their numbers, name and colour.
const KINDS: [([u16; 2], &str, [f64; 3]); 4] = [
    ([CRYSTAL, CRYSTAL], "crystal", [0.4, 1.0, 0.9]),
    ([5, 40], "blue key", [0.3, 0.5, 1.0]),
    ([6, 39], "yellow key", [1.0, 0.9, 0.2]),
    ([13, 38], "red key", [1.0, 0.25, 0.2]),
];

/// What shows a goal: a mesh of the level, or a sphere where that has none.
enum Shown {
    Mesh(MeshId),
    Sphere(ObjectId),
}

struct Goal {
    kind: usize,
    place: DVec2,
    sector: u32,
    /// The height of the floor in the map, at which its mesh is.
    built: f64,
    /// The floor's height now.
    floor: f64,
    shown: Shown,
    is_found: bool,
}

/// The goals of a level.
#[derive(Default)]
pub struct Goals {
    goals: Vec<Goal>,
    /// The middles of the lines through which one leaves.
    exits: Vec<DVec3>,
}

impl Goals {
    /// Adds the things to find of a map, and looks for its exits.
    /// `meshes` show some of the things already.
    pub fn add(
        ground: &Ground,
        meshes: &[(u32, MeshId)],
        world: &mut World,
    ) -> Result<Self, WorldError> {
        let mut goals = Vec::new();
        for (number, thing) in (0..).zip(&ground.map.things) {
            let kind = KINDS.iter().position(|(numbers, ..)| numbers.contains(&thing.kind));
            let (Some(kind), Some(sector)) = (kind, ground.sector(thing.place)) else { continue };
            let floor = ground.height(sector, levels::Plane::Floor);
            let shown = if let Some((_, mesh)) = meshes.iter().find(|(shows, _)| *shows == number) {
                Shown::Mesh(*mesh)
            } else {
                let [red, green, blue] = KINDS[kind].2;
                let material = world.add_material(Material {
                    emission: DVec3::new(red, green, blue) * 0.5,
                    ..Material::shiny(red, green, blue)
                })?;
                let centre = Ground::in_space(thing.place, floor + FLOATS);
                Shown::Sphere(world.add_sphere(centre, SIZE, material)?)
            };
            let place = thing.place;
            let goal = Goal { kind, place, sector, built: floor, floor, shown, is_found: false };
            goals.push(goal);
        }
        let is_exit = |number| special(number).is_some_and(|it| it.action == Action::Exit);
        let exits = ground.map.lines.iter().filter(|line| is_exit(line.special));
        let middle = |line: &levels::Line| {
            let [from, to] = ground.map.places(line);
            let floor = ground.height(line.front.sector, levels::Plane::Floor);
            Ground::in_space(from.midpoint(to), floor + FLOATS)
        };
        Ok(Self { goals, exits: exits.map(middle).collect() })
    }

    /// The box in which the sphere is that shows a thing, whose floor moves as far as this; `None`
    /// if it is nothing to find.
    pub fn sphere_box(thing: &Thing, [low, high]: [f64; 2]) -> Option<[DVec3; 2]> {
        let is_goal = KINDS.iter().any(|(numbers, ..)| numbers.contains(&thing.kind));
        let at =
            |floor, radius| Ground::in_space(thing.place, floor + FLOATS) + DVec3::splat(radius);
        is_goal.then(|| [at(low, -SIZE), at(high, SIZE)])
    }

    /// Puts what lies on floors that have moved to where these are now.
    pub fn place(&mut self, ground: &Ground, world: &mut World) -> Result<(), WorldError> {
        for goal in self.goals.iter_mut().filter(|goal| !goal.is_found) {
            let floor = ground.height(goal.sector, levels::Plane::Floor);
            if std::mem::replace(&mut goal.floor, floor) == floor {
                continue;
            }
            match goal.shown {
                Shown::Mesh(mesh) => {
                    let up = DVec3::Y * (floor - goal.built);
                    world.place_mesh(mesh, DAffine3::from_translation(up))?;
                }
                Shown::Sphere(sphere) => {
                    world.move_to(sphere, Ground::in_space(goal.place, floor + FLOATS))?;
                }
            }
        }
        Ok(())
    }

    /// Takes what the walker touches. Returns what it has found.
    pub fn take(
        &mut self,
        place: DVec2,
        feet: f64,
        world: &mut World,
    ) -> Result<Option<&'static str>, WorldError> {
        let touched = self.goals.iter_mut().find(|goal| {
            let is_near = goal.place.distance(place) < RADIUS + SIZE + 8.0;
            !goal.is_found && is_near && (goal.floor - feet).abs() < 2.0 * FLOATS
        });
        let Some(goal) = touched else { return Ok(None) };
        goal.is_found = true;
        match goal.shown {
            Shown::Mesh(mesh) => world.remove_mesh(mesh)?,
            Shown::Sphere(sphere) => world.remove(sphere)?,
        }
        Ok(Some(match KINDS[goal.kind].1 {
            "crystal" => "You have found a crystal.",
            _ => "You have found a key.",
        }))
    }

    /// Whether a thing of one of these numbers was found.
    #[must_use]
    pub fn has_any(&self, numbers: &[u16; 2]) -> bool {
        self.goals.iter().any(|goal| goal.is_found && KINDS[goal.kind].0 == *numbers)
    }

    /// Whether everything was found.
    #[must_use]
    pub fn all_found(&self) -> bool {
        self.goals.iter().all(|goal| goal.is_found)
    }

    /// The places of what was not found yet, and then of the exits.
    pub fn left(&self) -> impl Iterator<Item = DVec2> {
        let goals = self.goals.iter().filter(|goal| !goal.is_found).map(|goal| goal.place);
        goals.chain(self.exits.iter().map(|exit| DVec2::new(exit.x, -exit.z)))
    }

    /// The status: how many of the things are found.
    #[must_use]
    pub fn status(&self) -> String {
        let found = self.goals.iter().filter(|goal| goal.is_found).count();
        match self.goals.len() {
            0 => "find the exit".to_owned(),
            all if found == all => "all found; go to the exit".to_owned(),
            all => format!("{found} of {all} found"),
        }
    }

    /// The names of what is to be found, where it is, and how far from a place.
    pub fn labels(&self, from: DVec2) -> impl Iterator<Item = Label> {
        let label = move |text: &str, point: DVec3, [red, green, blue]: [f64; 3]| {
            let distance = DVec2::new(point.x, -point.z).distance(from) / METRE;
            Label::at_point(format!("{text} {distance:.0} m"), point)
                .beside(Side::Above)
                .coloured(red, green, blue)
        };
        let goals = self.goals.iter().filter(|goal| !goal.is_found).map(move |goal| {
            let (_, name, colour) = KINDS[goal.kind];
            label(name, Ground::in_space(goal.place, goal.floor + FLOATS + SIZE), colour)
        });
        let is_open = self.all_found();
        let exits = self.exits.iter().map(move |&exit| {
            let colour = if is_open { [0.5, 1.0, 0.5] } else { [0.6, 0.6, 0.6] };
            label("exit", exit, colour)
        });
        goals.chain(exits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::station::plan;
    use cellray::game::Random;
    use levels::Plan;

    #[test]
    fn goals_lie_on_floors_that_move() {
        let map = plan::map(&mut Random::new(0));
        let plan = Plan::of(&map);
        let mut ground = Ground::new(map, plan);
        let mut world = World::new();
        let mut goals = Goals::add(&ground, &[], &mut world).unwrap();
        let height = |goals: &Goals| goals.labels(DVec2::ZERO).next().unwrap();
        let before = height(&goals);
        let Goal { sector, built, place, .. } = goals.goals[0];
        ground.set_height(sector, levels::Plane::Floor, built + 100.0);
        goals.place(&ground, &mut world).unwrap();
        assert_ne!(height(&goals), before);
        let Shown::Sphere(sphere) = goals.goals[0].shown else { unreachable!("no mesh is given") };
        assert_eq!(
            world.position(sphere).unwrap(),
            Ground::in_space(place, built + 100.0 + FLOATS)
        );
        // It is taken where it is now.
        assert_eq!(goals.take(place, built, &mut world).unwrap(), None);
        assert!(goals.take(place, built + 100.0, &mut world).unwrap().is_some());
        goals.place(&ground, &mut world).unwrap();
    }
}
