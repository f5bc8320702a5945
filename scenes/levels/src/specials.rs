//! What the specials of lines do: doors, lifts, floors that move, stairs, teleporters and exits.
//!
//! Left out are crushers, ceilings and doors that close, donuts, scrolling walls, lights that
//! change, and what only monsters or shots set off.

use std::collections::BTreeMap;

use crate::{Line, Map, Plane};

/// How a special is set off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trigger {
    /// By somebody in front of the line who uses it.
    Use,
    /// By somebody who walks across the line.
    Walk,
}

/// The special of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Special {
    /// How it is set off.
    pub trigger: Trigger,
    /// Whether that may happen more than once.
    pub again: bool,
    /// The key that it needs: the numbers of the kinds of things that are that key.
    pub key: Option<[u16; 2]>,
    /// What it does.
    pub action: Action,
}

/// What a special does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    /// Opens doors: ceilings that are at their floors. Those that don't stay open close again.
    Door {
        /// Whether it stays open.
        stays: bool,
        /// Whether the sector on the line's back is the door, instead of those with the line's tag.
        at_back: bool,
    },
    /// Lowers floors to the lowest one beside them, and raises them again.
    Lift,
    /// Moves floors.
    Floor(Target),
    /// Raises floors one after another, each by this much above the one before.
    Stairs(f64),
    /// Takes whoever walks there to another place.
    Teleport,
    /// Ends the level.
    Exit,
}

/// To where a floor moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// The lowest floor beside it.
    Lowest,
    /// The highest floor beside it.
    Highest,
    /// The next higher floor beside it.
    Next,
    /// The lowest ceiling beside it.
    Ceiling,
}

const BLUE: Option<[u16; 2]> = Some([5, 40]);
const YELLOW: Option<[u16; 2]> = Some([6, 39]);
const RED: Option<[u16; 2]> = Some([13, 38]);

/// The special of this number, as a line has it; `None` if it is left out.
#[must_use]
pub fn special(number: u16) -> Option<Special> {
    use Target::{Ceiling, Highest, Lowest, Next};
    use Trigger::{Use, Walk};
    let door = |stays| Action::Door { stays, at_back: false };
    let at_back = |stays| Action::Door { stays, at_back: true };
    let (trigger, again, key, action) = match number {
        1 | 117 => (Use, true, None, at_back(false)),
        26 => (Use, true, BLUE, at_back(false)),
        27 => (Use, true, YELLOW, at_back(false)),
        28 => (Use, true, RED, at_back(false)),
        31 | 118 => (Use, false, None, at_back(true)),
        32 => (Use, false, BLUE, at_back(true)),
        33 => (Use, false, RED, at_back(true)),
        34 => (Use, false, YELLOW, at_back(true)),
        2 | 109 => (Walk, false, None, door(true)),
        4 | 108 => (Walk, false, None, door(false)),
        86 | 106 => (Walk, true, None, door(true)),
        90 | 105 => (Walk, true, None, door(false)),
        103 | 112 => (Use, false, None, door(true)),
        29 | 111 => (Use, false, None, door(false)),
        61 | 115 => (Use, true, None, door(true)),
        63 | 114 => (Use, true, None, door(false)),
        133 => (Use, false, BLUE, door(true)),
        135 => (Use, false, RED, door(true)),
        137 => (Use, false, YELLOW, door(true)),
        99 => (Use, true, BLUE, door(true)),
        134 => (Use, true, RED, door(true)),
        136 => (Use, true, YELLOW, door(true)),
        10 | 121 => (Walk, false, None, Action::Lift),
        88 | 120 => (Walk, true, None, Action::Lift),
        21 | 122 => (Use, false, None, Action::Lift),
        62 | 123 => (Use, true, None, Action::Lift),
        38 | 37 => (Walk, false, None, Action::Floor(Lowest)),
        82 | 84 => (Walk, true, None, Action::Floor(Lowest)),
        23 => (Use, false, None, Action::Floor(Lowest)),
        60 => (Use, true, None, Action::Floor(Lowest)),
        19 | 36 => (Walk, false, None, Action::Floor(Highest)),
        83 | 98 => (Walk, true, None, Action::Floor(Highest)),
        71 | 102 => (Use, false, None, Action::Floor(Highest)),
        45 | 70 => (Use, true, None, Action::Floor(Highest)),
        22 | 119 | 130 => (Walk, false, None, Action::Floor(Next)),
        95 | 128 | 129 => (Walk, true, None, Action::Floor(Next)),
        18 | 20 | 131 => (Use, false, None, Action::Floor(Next)),
        68 | 69 | 132 => (Use, true, None, Action::Floor(Next)),
        5 => (Walk, false, None, Action::Floor(Ceiling)),
        91 => (Walk, true, None, Action::Floor(Ceiling)),
        101 => (Use, false, None, Action::Floor(Ceiling)),
        64 => (Use, true, None, Action::Floor(Ceiling)),
        8 => (Walk, false, None, Action::Stairs(8.0)),
        100 => (Walk, false, None, Action::Stairs(16.0)),
        7 => (Use, false, None, Action::Stairs(8.0)),
        127 => (Use, false, None, Action::Stairs(16.0)),
        39 => (Walk, false, None, Action::Teleport),
        97 => (Walk, true, None, Action::Teleport),
        52 | 124 => (Walk, false, None, Action::Exit),
        11 | 51 => (Use, false, None, Action::Exit),
        _ => return None,
    };
    Some(Special { trigger, again, key, action })
}

/// The heights to which a line's special moves floors or ceilings, by the map's own heights.
#[must_use]
pub fn moves(map: &Map, line: &Line) -> Vec<((u32, Plane), f64)> {
    let Some(Special { action, .. }) = special(line.special) else {
        return Vec::new();
    };
    let tagged = || {
        let sectors = (0..).zip(&map.sectors);
        sectors.filter(|(_, sector)| sector.tag == line.tag).map(|(number, _)| number)
    };
    let sector = |number: u32| &map.sectors[number as usize];
    let lowest_ceiling = |number| {
        let ceilings = map.neighbours(number).map(|other| sector(other).ceiling);
        ceilings.min_by(f64::total_cmp).unwrap_or(sector(number).ceiling)
    };
    let door = |number| {
        // Four units of a door stay in sight, and one that is open stays as high as it is.
        let open = (lowest_ceiling(number) - 4.0).max(sector(number).ceiling);
        ((number, Plane::Ceiling), open)
    };
    let floor = |number, target| {
        let floors = || map.neighbours(number).map(|other| sector(other).floor);
        let own = sector(number).floor;
        let to = match target {
            Target::Lowest => floors().min_by(f64::total_cmp).map(|floor| floor.min(own)),
            Target::Highest => floors().max_by(f64::total_cmp),
            Target::Next => floors().filter(|floor| *floor > own).min_by(f64::total_cmp),
            Target::Ceiling => Some(lowest_ceiling(number).min(sector(number).ceiling)),
        };
        ((number, Plane::Floor), to.unwrap_or(own))
    };
    match action {
        Action::Door { at_back: true, .. } => {
            line.back.iter().map(|side| door(side.sector)).collect()
        }
        Action::Door { .. } => tagged().map(door).collect(),
        Action::Lift => tagged().map(|number| floor(number, Target::Lowest)).collect(),
        Action::Floor(target) => tagged().map(|number| floor(number, target)).collect(),
        Action::Stairs(step) => tagged().flat_map(|first| stairs(map, first, step)).collect(),
        Action::Teleport | Action::Exit => Vec::new(),
    }
}

/// The steps of stairs: each is on the back of a line of the one before, and has the same picture.
fn stairs(map: &Map, first: u32, step: f64) -> Vec<((u32, Plane), f64)> {
    let mut height = map.sectors[first as usize].floor + step;
    let mut steps = vec![((first, Plane::Floor), height)];
    let picture = map.sectors[first as usize].floor_flat;
    let mut last = first;
    loop {
        let next = map.lines.iter().find_map(|line| {
            let back = line.back.as_ref()?.sector;
            let is_next = line.front.sector == last
                && map.sectors[back as usize].floor_flat == picture
                && !steps.iter().any(|((sector, _), _)| *sector == back);
            is_next.then_some(back)
        });
        let Some(next) = next else { return steps };
        height += step;
        steps.push(((next, Plane::Floor), height));
        last = next;
    }
}

/// The lowest and the highest place of every floor and ceiling that some line moves.
#[must_use]
pub fn ranges(map: &Map) -> BTreeMap<(u32, Plane), [f64; 2]> {
    let mut ranges = BTreeMap::new();
    for (plane, to) in map.lines.iter().flat_map(|line| moves(map, line)) {
        let rest = plane.1.height(&map.sectors[plane.0 as usize]);
        let [low, high] = ranges.entry(plane).or_insert([rest; 2]);
        *low = to.min(*low);
        *high = to.max(*high);
    }
    ranges.retain(|_, [low, high]| low < high);
    ranges
}
