//! What is to be found in a level, and its exit.

use cellray::game::{DVec3, Label, Material, MeshId, ObjectId, Side, World, WorldError};
use glam::DVec2;
use levels::{Action, special};

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
            goals.push(Goal { kind, place: thing.place, floor, shown, is_found: false });
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
