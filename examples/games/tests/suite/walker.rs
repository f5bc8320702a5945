//! A simulated player who walks to each goal by a path on the map.

use std::collections::{HashMap, VecDeque};

use cellray::game::{InputEvent, Key, MouseButton};
use games::station::Station;
use games::station::ground::Ground;
use glam::DVec2;
use levels::Plane;

/// The distance between the places of a path.
const GRID: f64 = 16.0;
/// How near a place must be to count as reached.
const REACHED: f64 = 12.0;
/// Radians for a pixel of mouse movement in the game, and the most pixels in a frame.
const TURN: f64 = 0.006;
const FASTEST: f64 = 30.0;
/// How far it turns while it walks, in radians.
const WALKS: f64 = 0.9;
/// How far it may be from its path.
const LOST: f64 = 64.0;
/// For how many frames it waits for a door or a lift.
const PATIENCE: u32 = 150;
/// How many places ahead it looks.
const AHEAD: usize = 2;
/// The kinds of things that lie somewhere to be taken.
const ITEMS: std::ops::RangeInclusive<u16> = 2001..=2049;

/// Walks by a path, and presses Space where it does not get on.
#[derive(Default)]
pub struct Walker {
    /// The goals, or those of the game if there are none.
    goals: Vec<DVec2>,
    /// The places to come, the next one last.
    path: Vec<DVec2>,
    goal: Option<DVec2>,
    last: DVec2,
    stood: u32,
    walks: bool,
    presses: bool,
    begun: bool,
}

/// The ground with its doors open: with lifts where they rest, and where they move to.
fn opened(ground: &Ground) -> [Ground; 2] {
    let mut open = [ground.clone(), ground.clone()];
    for line in &ground.map.lines {
        for ((sector, plane), to) in levels::moves(&ground.map, line) {
            let rest = plane.height(&ground.map.sectors[sector as usize]);
            open[0].set_height(sector, plane, if plane == Plane::Ceiling { to } else { rest });
            open[1].set_height(sector, plane, to);
        }
    }
    open
}

/// A place on the grid, and which of the two grounds somebody is on.
type Node = ([i32; 2], usize);

fn place_of(node: Node) -> DVec2 {
    DVec2::from(node.0.map(f64::from)) * GRID
}

/// The places on the shortest way to the reachable place that is nearest to a goal, the last one
/// first.
fn path(game: &Station, goal: DVec2) -> Vec<DVec2> {
    let grounds = opened(game.ground());
    let begin = ((game.place() / GRID).round().to_array().map(|at| at as i32), 0);
    let mut from: HashMap<Node, (Node, f64)> = HashMap::from([(begin, (begin, game.feet()))]);
    let mut queue = VecDeque::from([begin]);
    let mut nearest = (begin, f64::INFINITY);
    while let Some(node) = queue.pop_front() {
        let distance = place_of(node).distance(goal);
        if distance < nearest.1 {
            nearest = (node, distance);
        }
        if distance < GRID {
            break;
        }
        let ([x, y], which) = node;
        let feet = from[&node].1;
        let ground = &grounds[which];
        let steps = [[x + 1, y], [x - 1, y], [x, y + 1], [x, y - 1]].map(|to| (to, which));
        for next in steps {
            if let Ok(floor) = ground.stand(place_of(next), feet)
                && !from.contains_key(&next)
            {
                from.insert(next, (node, floor));
                queue.push_back(next);
            }
        }
        // Lifts come, and take along whoever is on them.
        let (other, next) = (&grounds[1 - which], ([x, y], 1 - which));
        let floors = |ground: &Ground| {
            let sector = ground.sector(place_of(node));
            sector.map_or(feet, |sector| ground.height(sector, Plane::Floor))
        };
        let is_lift = floors(other) != floors(ground);
        let moved = if is_lift { floors(other) } else { feet };
        if let Ok(floor) = other.stand(place_of(node), moved)
            && !from.contains_key(&next)
            && (is_lift || floor == feet)
        {
            from.insert(next, (node, floor));
            queue.push_back(next);
        }
    }
    let mut path = vec![goal];
    let mut node = nearest.0;
    while node != begin {
        path.push(place_of(node));
        node = from[&node].0;
    }
    path
}

impl Walker {
    /// A walker with goals of its own. It goes to one after the other, except those to which there
    /// is no way, and stays at the last.
    pub fn to(goals: Vec<DVec2>) -> Self {
        Self { goals, ..Self::default() }
    }

    /// A walker that visits what lies in a map: always what is nearest to the last place.
    pub fn tour(game: &Station) -> Self {
        let things = game.ground().map.things.iter();
        let mut left: Vec<DVec2> =
            things.filter(|thing| ITEMS.contains(&thing.kind)).map(|thing| thing.place).collect();
        let mut place = game.place();
        let mut goals = Vec::new();
        while !left.is_empty() {
            let nearness = |at: &usize| place.distance_squared(left[*at]);
            let next = (0..left.len()).min_by(|a, b| nearness(a).total_cmp(&nearness(b)));
            place = left.swap_remove(next.unwrap_or_default());
            goals.push(place);
        }
        Self::to(goals)
    }

    /// The events of the next frame.
    pub fn next(&mut self, game: &Station) -> Vec<InputEvent> {
        let place = game.place();
        let mut events = Vec::new();
        if !self.begun {
            self.begun = true;
            events.push(InputEvent::MouseButton { button: MouseButton::Left, down: true });
        }
        let is_there = |goal: &DVec2| goal.distance(place) < 2.0 * GRID;
        let is_done = self.stood > PATIENCE / 4 || self.goals.first().is_some_and(is_there);
        if self.goals.len() > 1 && is_done {
            self.goals.remove(0);
        }
        let goal = self.goals.first().copied().or_else(|| game.goals().left().next());
        self.stood = if place.distance(self.last) < 0.5 { self.stood + 1 } else { 0 };
        self.last = place;
        let is_lost = self.path.last().is_some_and(|next| next.distance(place) > LOST);
        if goal != self.goal || is_lost && self.path.len() > 1 || self.stood > PATIENCE {
            self.goal = goal;
            self.stood = 0;
            self.path = goal.map(|goal| path(game, goal)).unwrap_or_default();
            let nearest = self.path.get(1).copied().unwrap_or(place);
            if self.goals.len() > 1 && goal.is_some_and(|goal| goal.distance(nearest) > 2.0 * GRID)
            {
                self.goals.remove(0);
                events.extend(self.next(game));
                return events;
            }
        }
        // Corners are cut a little, so a place may be passed without being reached.
        let near = self.path.len().saturating_sub(AHEAD + 1)..self.path.len();
        let passed = near.into_iter().find(|at| self.path[*at].distance(place) < REACHED);
        if let Some(passed) = passed {
            self.path.truncate(passed.max(1));
        }
        let ahead = self.path.len().checked_sub(AHEAD).and_then(|at| self.path.get(at));
        let Some(&towards) = ahead.or(self.path.last()) else { return events };
        let way = towards - place;
        let wanted = libm::atan2(-way.x, way.y);
        let turn = libm::remainder(wanted - game.turn(), std::f64::consts::TAU);
        let pixels = (-turn / TURN).clamp(-FASTEST, FASTEST);
        events.push(InputEvent::MouseMotion { by: [pixels as f32, 0.0] });
        // Whoever walks on while turning far circles around the place.
        let walks = turn.abs() < WALKS;
        if walks != self.walks {
            self.walks = walks;
            events.push(InputEvent::Key { key: Key::W, down: walks });
        }
        let presses = self.stood > 3 && self.stood % 20 == 4;
        if presses != self.presses {
            self.presses = presses;
            events.push(InputEvent::Key { key: Key::Space, down: presses });
        }
        events
    }
}
