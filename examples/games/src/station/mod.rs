//! A level to walk in: a small station of our own, or a map of a WAD file.
//!
//! In the station, three crystals lie at places that differ from game to game, and the way out is
//! open for whoever has them. In a map of Doom the keys take their place.
//!
//! | | keyboard and mouse | pad |
//! |---|---|---|
//! | walk | W A S D | left stick |
//! | look | arrows, mouse dragged | right stick |
//! | run | Shift | L1 |
//! | open, switch | Space, Enter, right button | cross |
//! | show the map | Tab | triangle |

mod art;
mod automap;
mod goals;
pub mod ground;
mod lamps;
mod movers;
mod plan;
mod portals;
mod things;

use std::error::Error;
use std::path::Path;
use std::sync::Arc;

use cellray::game::{
    Button, DAffine3, DVec3, Entry, Frame, Game, Input, Key, Label, Material, MeshId, MouseButton,
    RenderOptions, Side, Start, View, WalkCamera, World, WorldError,
};
use glam::DVec2;
use levels::{Action, Blockers, Graphics, Level, Map, Name, Plan, Special, Trigger, Wad, special};

use crate::camera::follow;
use crate::steps::{STEP, Steps};
use automap::Automap;
use goals::Goals;
use ground::Ground;
use lamps::Lamps;
use movers::Movers;
use portals::Portal;
use things::Decorations;

/// The game's name.
pub const NAME: &str = "station";
/// The controls.
pub const CONTROLS: &[&str] = &[
    "W A S D, left stick: walk; with Shift or L1: run",
    "arrows, mouse dragged, right stick: look around",
    "Space, Enter, right button, cross: open a door, call a lift, press a switch",
    "Tab, triangle: show or hide the map of what was seen so far",
];
/// The entry in the table of games.
pub const ENTRY: Entry = Entry {
    name: NAME,
    line: "a level to walk in: find three crystals and the exit, or walk in a map of Doom",
    new: || Box::new(Station::default()),
    open: Some(|wad, map| Ok(Box::new(Station::open(wad, map)?))),
};

/// The height of the eye above the feet, and units walked in a second.
const EYE: f64 = 41.0;
const SPEED: f64 = 240.0;
/// The share of the way to its height that the eye moves in a step, after a stair.
const RISES: f64 = 0.03;
/// How far away something can be used.
const REACH: f64 = 64.0;
/// The angle of the view from top to bottom, in degrees.
const ANGLE: f64 = 56.0;
/// The light of sectors, beside that of lamps: in our own level, and in one of Doom, whose pictures
/// are darker.
const AMBIENT: [f64; 2] = [0.85, 1.4];
/// Seconds for which a message is shown.
const MESSAGE: f64 = 3.0;
/// The kinds of things at which players begin, and where teleporters end.
const BEGINNINGS: [u16; 2] = [1, 11];
const TELEPORTED: u16 = 14;

/// The game.
#[derive(Default)]
pub struct Station {
    /// The level of a file; without one, the game's own is made.
    opened: Option<(Map, Plan, Level)>,
    is_own: bool,
    ground: Ground,
    movers: Movers,
    lamps: Lamps,
    portals: Vec<Portal>,
    goals: Goals,
    automap: Automap,
    /// For each line, whether its special has been set off for the last time.
    spent: Vec<bool>,
    place: DVec2,
    feet: f64,
    eye: f64,
    camera: Option<WalkCamera>,
    steps: Steps,
    size: (u32, u32),
    message: (&'static str, f64),
    has_ended: bool,
    is_over: bool,
}

impl Station {
    /// The game with a map of a WAD file; without a name, its first one.
    ///
    /// # Errors
    /// The file or the map can't be read, or nobody can begin in it.
    pub fn open(wad: &Path, map: Option<&str>) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let file = Wad::open(wad)?;
        let first = || file.maps().first().copied().unwrap_or_else(|| Name::new("E1M1"));
        let name = map.map_or_else(first, Name::new);
        let map = Map::read(&file, name)?;
        let plan = Plan::of(&map);
        let level = Level::build(&map, &plan, &Graphics::read(&file)?)?;
        if !map.things.iter().any(|thing| BEGINNINGS.contains(&thing.kind)) {
            let file = wad.display();
            return Err(format!("{file}: lump {name} THINGS: there is no place to begin").into());
        }
        Ok(Self { opened: Some((map, plan, level)), ..Self::default() })
    }

    /// Where the walker is on the map.
    #[must_use]
    pub fn place(&self) -> DVec2 {
        self.place
    }

    /// The height of its feet.
    #[must_use]
    pub fn feet(&self) -> f64 {
        self.feet
    }

    /// The direction in which it looks, as radians to the left of north.
    #[must_use]
    pub fn turn(&self) -> f64 {
        self.camera.map_or(0.0, |camera| camera.turn)
    }

    /// The ground that it walks on.
    #[must_use]
    pub fn ground(&self) -> &Ground {
        &self.ground
    }

    /// What remains to be found, and the exit.
    #[must_use]
    pub fn goals(&self) -> &Goals {
        &self.goals
    }

    /// The map of what was seen.
    #[must_use]
    pub fn automap(&self) -> &Automap {
        &self.automap
    }

    /// Whether the exit was reached.
    #[must_use]
    pub fn has_ended(&self) -> bool {
        self.has_ended
    }

    /// Finds the lamps of which it is known whether they reach a surface, so that its shadow rays
    /// need not be traced.
    fn find_visibility(&self, level: &mut Level, decorations: &Decorations) {
        let lamps = self.lamps.fixed();
        if lamps.is_empty() {
            return;
        }
        let ranges = levels::ranges(&self.ground.map);
        let travel = |plane: (u32, levels::Plane)| {
            let rest = self.ground.height(plane.0, plane.1);
            ranges.get(&plane).copied().unwrap_or([rest; 2]).map(|height| height - rest)
        };
        let below = |thing: &levels::Thing| {
            self.ground.sector(thing.place).map(|sector| (sector, levels::Plane::Floor))
        };
        let clear: Vec<bool> = (level.materials.iter().zip(&level.surfaces))
            .map(|(material, surface)| {
                self.is_own && art::finished(material.into(), *surface).transmittance > 0.0
            })
            .collect();
        let is_clear = |material: u32| clear[material as usize];
        let mut blockers = Blockers::default();
        blockers.add_mesh(&decorations.mesh, |_| false);
        self.portals.iter().for_each(|portal| blockers.add_polygon(&portal.corners));
        for part in &level.parts {
            let lies_on =
                part.thing.and_then(|thing| below(&self.ground.map.things[thing as usize]));
            if part.is_fixed() {
                blockers.add_mesh(&part.mesh, is_clear);
            } else if let Some((low, high)) = part.mesh.bounds() {
                let [down, up] = part.moves_with.or(lies_on).map_or([0.0; 2], travel);
                blockers.add_box(low + DVec3::Y * down, high + DVec3::Y * up);
            }
        }
        for thing in &self.ground.map.things {
            if let Some(plane) = below(thing)
                && let floor = self.ground.height(plane.0, plane.1)
                && let Some([low, high]) =
                    Goals::sphere_box(thing, travel(plane).map(|by| floor + by))
            {
                blockers.add_box(low, high);
            }
        }
        let shafts = blockers.around(&lamps);
        for part in level.parts.iter_mut().filter(|part| part.is_fixed()) {
            part.mesh.visibility = shafts.visibility(&part.mesh, is_clear);
        }
    }

    /// Adds the meshes of a level. Returns those that show a thing of the map which can be taken.
    fn add_level(
        &mut self,
        world: &mut World,
        level: Level,
    ) -> Result<Vec<(u32, MeshId)>, WorldError> {
        let mut things = Vec::new();
        let mut materials = Vec::new();
        for (material, surface) in level.materials.iter().zip(&level.surfaces) {
            let material = Material::from(material);
            let material = if self.is_own { art::finished(material, *surface) } else { material };
            materials.push(world.add_material(material)?);
        }
        for part in level.parts {
            // Floors that nothing but a sky is above, for example, have no triangles.
            let has_triangles = !part.mesh.triangles.is_empty();
            let mesh = has_triangles
                .then(|| world.add_mesh(Arc::new(part.mesh), &materials, DAffine3::IDENTITY))
                .transpose()?;
            things.extend(part.thing.zip(mesh));
            if let Some(plane) = part.moves_with {
                self.movers.add(&self.ground, plane, mesh);
            }
        }
        Ok(things)
    }

    /// Puts the walker somewhere, looking in a direction of the map in degrees from east.
    fn put(&mut self, place: DVec2, degrees: f64) {
        if let Some(sector) = self.ground.sector(place) {
            self.place = place;
            self.feet = self.ground.height(sector, levels::Plane::Floor);
            self.eye = self.feet + EYE;
            let from = Ground::in_space(place, self.eye);
            let turn = (degrees - 90.0).to_radians();
            self.camera = Some(WalkCamera { turn, ..WalkCamera::new(from, SPEED) });
        }
    }

    /// Makes a step of the walker. Returns its next one: the same, but turned if it has walked
    /// through a portal.
    fn step(&mut self, stride: DVec2) -> DVec2 {
        if !self.movers.rest() {
            self.feet = self.movers.step(&mut self.ground, STEP, self.place, self.feet);
        }
        let Some((place, floor)) = self.ground.walk(self.place, self.feet, stride) else {
            return stride;
        };
        let step = [self.place, place];
        (self.place, self.feet) = (place, floor);
        let is_crossed =
            |portal: &&Portal| self.ground.crossed(step).any(|(line, _)| portal.is_in(line));
        if let Some(portal) = self.portals.iter().find(is_crossed)
            && let beyond = portal.beyond(place)
            && let Ok(feet) = self.ground.stand(beyond, floor + portal.rise)
        {
            (self.place, self.feet) = (beyond, feet);
            self.eye += portal.rise;
            if let Some(camera) = &mut self.camera {
                camera.turn += portals::TURN;
            }
            return -stride;
        }
        let crossed = self.ground.crossed(step).find(|(line, _)| {
            let number = self.ground.map.lines[*line as usize].special;
            special(number).is_some_and(|special| special.trigger == Trigger::Walk)
        });
        if let Some((line, is_from_front)) = crossed {
            self.set_off(line, is_from_front);
        }
        stride
    }

    /// The line before the walker that it could use.
    fn usable(&self) -> Option<(u32, Special)> {
        let (sine, cosine) = libm::sincos(self.turn());
        let ahead = DVec2::new(-sine, cosine) * REACH;
        let line = self.ground.reached(self.place, self.place + ahead)?;
        let found = special(self.ground.map.lines[line as usize].special)?;
        let is_usable = found.trigger == Trigger::Use && !self.spent[line as usize];
        is_usable.then_some((line, found))
    }

    /// Does what the special of a line does.
    fn set_off(&mut self, line: u32, is_from_front: bool) {
        let spent = self.spent[line as usize];
        let tag = self.ground.map.lines[line as usize].tag;
        let number = self.ground.map.lines[line as usize].special;
        let Some(special) = special(number).filter(|_| !spent) else {
            return;
        };
        if special.key.is_some_and(|kinds| !self.goals.has_any(&kinds)) {
            self.message = ("You need a key of the door's colour.", MESSAGE);
            return;
        }
        match special.action {
            Action::Exit if self.is_own && !self.goals.all_found() => {
                self.message = ("The exit opens for whoever has all crystals.", MESSAGE);
                return;
            }
            Action::Exit => {
                self.has_ended = true;
                self.message = ("You have found the way out.", MESSAGE);
            }
            Action::Teleport if is_from_front => {
                let ends = self.ground.map.things.iter().find(|thing| {
                    let sector = self.ground.sector(thing.place);
                    let tagged = sector.map(|it| self.ground.map.sectors[it as usize].tag);
                    thing.kind == TELEPORTED && tagged == Some(tag)
                });
                let Some(&end) = ends else { return };
                let sector = self.ground.sector(end.place).unwrap_or_default();
                let floor = self.ground.height(sector, levels::Plane::Floor);
                // Where something has moved, there may be no place for the walker.
                if self.ground.stand(end.place, floor).is_ok() {
                    self.put(end.place, end.angle);
                }
            }
            Action::Teleport => return,
            _ if !self.movers.start(&self.ground, line) => return,
            _ => {}
        }
        self.spent[line as usize] = !special.again;
    }

    fn uses(input: &Input) -> bool {
        input.key_pressed(Key::Space)
            || input.key_pressed(Key::Enter)
            || input.mouse_pressed(MouseButton::Right)
            || input.pad().is_some_and(|pad| pad.pressed(Button::Cross))
    }

    /// What can be done here, if anything.
    fn hint(&self) -> &'static str {
        match self.usable() {
            Some((_, Special { action: Action::Door { .. }, .. })) => "Space: open the door",
            Some((_, Special { action: Action::Lift, .. })) => "Space: call the lift",
            Some((_, Special { action: Action::Exit, .. })) => "Space: leave through the exit",
            Some(_) => "Space: press the switch",
            None => "",
        }
    }
}

impl Game for Station {
    fn name(&self) -> &str {
        NAME
    }

    fn set_up(&mut self, world: &mut World, start: &Start) -> Result<(), WorldError> {
        world.set_name(NAME);
        self.is_own = self.opened.is_none();
        let (map, plan, mut level) = match self.opened.take() {
            Some(opened) => opened,
            None => {
                let map = plan::map(&mut start.random());
                let plan = Plan::of(&map);
                let level = Level::build(&map, &plan, &art::Drawn).map_err(WorldError::game)?;
                (map, plan, level)
            }
        };
        self.spent = vec![false; map.lines.len()];
        self.ground = Ground::new(map, plan);
        self.automap = Automap::of(&self.ground);
        let (lamps, decorations) = Lamps::of(&self.ground, &level.with_sprites);
        self.lamps = lamps;
        if self.is_own {
            self.portals = Portal::all(&self.ground);
        }
        self.find_visibility(&mut level, &decorations);
        let things = self.add_level(world, level)?;
        decorations.finish(world)?;
        self.lamps.add(world)?;
        self.portals.iter().try_for_each(|portal| portal.add(world))?;
        self.goals = Goals::add(&self.ground, &things, world)?;
        let begins = |kind: &u16| self.ground.map.things.iter().find(|thing| thing.kind == *kind);
        if let Some(&begin) = BEGINNINGS.iter().find_map(begins) {
            self.put(begin.place, begin.angle);
        }
        // Doors and lifts move by little. Their tree stays good enough, and a new one takes seconds
        // in a level with many textures, which are cut again for it.
        let refit_pictures = u32::MAX;
        let options = RenderOptions { ray_depth: 3, refit_pictures, ..RenderOptions::default() };
        world.set_render_options(options);
        world.set_ambient(DVec3::splat(AMBIENT[usize::from(!self.is_own)]))?;
        world.set_background(DVec3::ZERO)?;
        let view = View { angle: ANGLE, ..world.view().clone() };
        world.set_view(view)
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
        self.size = frame.size;
        let count = self.steps.of(frame.delta);
        let seconds = f64::from(count) * STEP;
        let was_at_rest = self.movers.rest();
        if let Some(camera) = &mut self.camera {
            let stride = camera.steer(frame.input, seconds) / f64::from(count.max(1));
            let mut stride = DVec2::new(stride.x, -stride.z);
            if Self::uses(frame.input)
                && let Some((line, _)) = self.usable()
            {
                self.set_off(line, true);
            }
            for _ in 0..count {
                stride = self.step(stride);
            }
        }
        self.automap.look(&self.ground, self.place);
        let pad = frame.input.pad();
        if frame.input.key_pressed(Key::Tab) || pad.is_some_and(|pad| pad.pressed(Button::Triangle))
        {
            self.automap.is_open = !self.automap.is_open;
        }
        if !was_at_rest || !self.movers.rest() {
            self.movers.place(&self.ground, world)?;
            self.goals.place(&self.ground, world)?;
        }
        if let Some(found) = self.goals.take(self.place, self.feet, world)? {
            self.message = (found, MESSAGE);
        }
        self.message.1 -= seconds;
        self.is_over = self.has_ended && self.message.1 <= 0.0;
        let goal = DVec3::Y * (self.feet + EYE);
        for _ in 0..count {
            self.eye = follow(DVec3::Y * self.eye, goal, RISES).y;
        }
        self.lamps.shine(Ground::in_space(self.place, self.eye), world)?;
        if let Some(camera) = &mut self.camera {
            camera.from = Ground::in_space(self.place, self.eye);
            camera.look(world)?;
        }
        Ok(())
    }

    fn controls(&self) -> &[&str] {
        CONTROLS
    }

    fn status(&self) -> String {
        let status = self.goals.status();
        match self.automap.is_open {
            true => {
                let map = self.automap.text(&self.ground, self.place, self.turn());
                format!("{status}\n{map}")
            }
            false => status,
        }
    }

    fn labels(&self) -> Vec<Label> {
        let (width, height) = (self.size.0 as f32, self.size.1 as f32);
        let below = |text: &str, part: f32| {
            Label::at_pixel(text, [width / 2.0, height * part]).beside(Side::Over)
        };
        let text = if self.message.1 > 0.0 { self.message.0 } else { self.hint() };
        let mut labels = Vec::new();
        if !text.is_empty() {
            labels.push(below(text, 0.8).coloured(1.0, 0.9, 0.5));
        }
        labels.extend(self.goals.labels(self.place));
        labels
    }

    fn is_over(&self) -> bool {
        self.is_over
    }
}
