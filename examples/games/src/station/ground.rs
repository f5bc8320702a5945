//! Where one can stand and walk in a level.
//!
//! A walker is a disc on the map that is so high. Invariant: it is only ever put to places at which
//! it fits, between a floor and a ceiling of every sector that it touches. It moves by less than
//! its radius at a time, so it can't pass a line without touching it.

use cellray::game::DVec3;
use glam::DVec2;
use levels::{Line, Map, Plan, Plane, flags};

/// Half the width of a walker.
pub const RADIUS: f64 = 16.0;
/// The height of a walker.
pub const TALL: f64 = 56.0;
/// The highest step that it takes.
pub const STEP_UP: f64 = 24.0;
/// What remains between a walker and a wall, so that rounding does not count as touching.
const GAP: f64 = 1e-3;
/// The width of the squares by which lines and regions are found.
const SQUARE: f64 = 128.0;

/// A level's lines and heights.
#[derive(Clone, Default)]
pub struct Ground {
    /// The map.
    pub map: Map,
    plan: Plan,
    /// The height of the floor and of the ceiling of each sector, as they are now.
    heights: Vec<[f64; 2]>,
    /// The number of the first square across and down, and how many there are.
    first: [i64; 2],
    count: [i64; 2],
    /// The numbers of the lines and of the regions in each square.
    lines: Vec<Vec<u32>>,
    regions: Vec<Vec<u32>>,
}

/// The nearest point of a segment.
fn nearest([from, to]: [DVec2; 2], place: DVec2) -> DVec2 {
    let way = to - from;
    let share = (place - from).dot(way) / way.length_squared();
    from + way * share.clamp(0.0, 1.0)
}

/// The part of a segment from one place to another at which it crosses a line; `None` if it does
/// not.
fn crossing([from, to]: [DVec2; 2], [start, end]: [DVec2; 2]) -> Option<f64> {
    let (way, line) = (to - from, end - start);
    let across = way.perp_dot(line);
    if across == 0.0 {
        return None;
    }
    let part = (start - from).perp_dot(line) / across;
    let along = (start - from).perp_dot(way) / across;
    let is_within = |share: f64| (0.0..=1.0).contains(&share);
    (is_within(part) && is_within(along)).then_some(part)
}

impl Ground {
    /// The ground of a map.
    #[must_use]
    pub fn new(map: Map, plan: Plan) -> Self {
        let number = |place: DVec2| [place.x, place.y].map(|at| (at / SQUARE).floor() as i64);
        let places = map.lines.iter().flat_map(|line| map.places(line));
        let bounds = places.fold(None, |bounds: Option<(DVec2, DVec2)>, place| {
            let (low, high) = bounds.unwrap_or((place, place));
            Some((low.min(place), high.max(place)))
        });
        let (low, high) = bounds.unwrap_or_default();
        let (first, last) = (number(low), number(high));
        let count = [0, 1].map(|axis| last[axis] - first[axis] + 1);
        let squares = (count[0] * count[1]) as usize;
        let heights = map.sectors.iter().map(|sector| [sector.floor, sector.ceiling]).collect();
        let nothing = || vec![Vec::new(); squares];
        let mut ground =
            Self { heights, first, count, lines: nothing(), regions: nothing(), map, plan };
        for (index, line) in (0..).zip(&ground.map.lines) {
            let [from, to] = ground.map.places(line);
            let reach = DVec2::splat(RADIUS);
            let box_of = [number(from.min(to) - reach), number(from.max(to) + reach)];
            ground.squares(box_of).for_each(|square| ground.lines[square].push(index));
        }
        for (index, region) in (0..).zip(&ground.plan.regions) {
            let [a, b, c] = region.corners;
            let box_of = [number(a.min(b).min(c)), number(a.max(b).max(c))];
            ground.squares(box_of).for_each(|square| ground.regions[square].push(index));
        }
        ground
    }

    /// The squares from one to another, as far as there are any.
    fn squares(&self, [low, high]: [[i64; 2]; 2]) -> impl Iterator<Item = usize> + use<> {
        let (first, count) = (self.first, self.count);
        let range = move |axis: usize| {
            let from = (low[axis] - first[axis]).max(0);
            from..(high[axis] - first[axis] + 1).min(count[axis])
        };
        range(1).flat_map(move |row| range(0).map(move |column| (row * count[0] + column) as usize))
    }

    /// What a table has for the square of a place.
    fn near<'a>(&self, table: &'a [Vec<u32>], place: DVec2) -> &'a [u32] {
        let square = [place.x, place.y].map(|at| (at / SQUARE).floor() as i64);
        let mut found = self.squares([square, square]);
        found.next().map(|square| table[square].as_slice()).unwrap_or_default()
    }

    /// The lines that may be within a walker's radius of a place.
    fn lines_near(&self, place: DVec2) -> impl Iterator<Item = (u32, &Line)> {
        let numbers = self.near(&self.lines, place).iter();
        numbers.map(|&number| (number, &self.map.lines[number as usize]))
    }

    /// The sector at a place; `None` outside of the level.
    #[must_use]
    pub fn sector(&self, place: DVec2) -> Option<u32> {
        let regions = self.near(&self.regions, place).iter();
        let mut regions = regions.map(|&number| &self.plan.regions[number as usize]);
        regions.find(|region| region.holds(place)).map(|region| region.sector)
    }

    /// The height of a sector's floor or ceiling.
    #[must_use]
    pub fn height(&self, sector: u32, plane: Plane) -> f64 {
        self.heights[sector as usize][plane as usize]
    }

    /// Moves a sector's floor or ceiling.
    pub fn set_height(&mut self, sector: u32, plane: Plane, height: f64) {
        self.heights[sector as usize][plane as usize] = height;
    }

    /// The floor and the ceiling of the opening of a line; `None` if it is closed for walkers.
    fn opening(&self, line: &Line) -> Option<[f64; 2]> {
        let back = line.back.as_ref().filter(|_| line.flags & flags::BLOCKS == 0)?;
        let [one, two] = [line.front.sector, back.sector].map(|it| self.heights[it as usize]);
        Some([one[0].max(two[0]), one[1].min(two[1])])
    }

    /// The floor on which a walker with its feet at this height stands at a place.
    ///
    /// # Errors
    /// It does not fit there. The error is the step away from what is most in the way, or 0 if it
    /// is outside of the level.
    pub fn stand(&self, place: DVec2, feet: f64) -> Result<f64, DVec2> {
        let sector = self.sector(place).ok_or(DVec2::ZERO)?;
        let [mut floor, mut ceiling] = self.heights[sector as usize];
        let mut in_the_way: Option<(f64, DVec2)> = None;
        for (_, line) in self.lines_near(place) {
            let ends = self.map.places(line);
            let away = place - nearest(ends, place);
            let distance = away.length();
            if distance >= RADIUS {
                continue;
            }
            let fits = self.opening(line).is_some_and(|[low, high]| {
                let (lowest, highest) = (floor.max(low), ceiling.min(high));
                let fits = lowest - feet <= STEP_UP && highest - lowest >= TALL;
                if fits {
                    (floor, ceiling) = (lowest, highest);
                }
                fits
            });
            if !fits && in_the_way.is_none_or(|(known, _)| distance < known) {
                let direction = match distance > 0.0 {
                    true => away / distance,
                    false => (ends[1] - ends[0]).perp().normalize(),
                };
                in_the_way = Some((distance, direction * (RADIUS - distance + GAP)));
            }
        }
        match in_the_way {
            Some((_, away)) => Err(away),
            None if floor - feet > STEP_UP || ceiling - floor < TALL => Err(DVec2::ZERO),
            None => Ok(floor),
        }
    }

    /// Where a walker comes by a step, of less than its radius, and the floor there. It slides
    /// along what is in the way.
    #[must_use]
    pub fn walk(&self, from: DVec2, feet: f64, step: DVec2) -> Option<(DVec2, f64)> {
        if step == DVec2::ZERO {
            return None;
        }
        let mut place = from + step;
        // One wall turns the step aside, and others in a corner.
        for _ in 0..4 {
            match self.stand(place, feet) {
                Ok(floor) => return Some((place, floor)),
                Err(away) => place += away,
            }
            if place.distance(from) > step.length() + 2.0 * GAP {
                return None;
            }
        }
        None
    }

    /// The lines that a step crosses, with whether it begins in front of them.
    pub fn crossed(&self, step: [DVec2; 2]) -> impl Iterator<Item = (u32, bool)> {
        let lines = self.lines_near(step[1]);
        lines.filter_map(move |(number, line)| {
            let [start, end] = self.map.places(line);
            let side = |place: DVec2| (end - start).perp_dot(place - start) < 0.0;
            let crosses = side(step[0]) != side(step[1]) && crossing(step, [start, end]).is_some();
            crosses.then(|| (number, side(step[0])))
        })
    }

    /// Whether no wall and no closed door is between two places, however high.
    #[must_use]
    pub fn sees(&self, from: DVec2, to: DVec2) -> bool {
        let mut lines = self.map.lines.iter();
        !lines.any(|line| {
            let is_in_the_way = match &line.back {
                None => true,
                Some(back) => {
                    let [one, two] =
                        [line.front.sector, back.sector].map(|it| self.heights[it as usize]);
                    one[1].min(two[1]) <= one[0].max(two[0])
                }
            };
            is_in_the_way && crossing([from, to], self.map.places(line)).is_some()
        })
    }

    /// The first line with a special, or without an opening, that somebody reaches from its front.
    #[must_use]
    pub fn reached(&self, from: DVec2, to: DVec2) -> Option<u32> {
        let cuts = (0..).zip(&self.map.lines).filter_map(|(number, line)| {
            let ends = self.map.places(line);
            let part = crossing([from, to], ends)?;
            let is_in_front = (ends[1] - ends[0]).perp_dot(from - ends[0]) < 0.0;
            let is_closed = self.opening(line).is_none_or(|[low, high]| high <= low);
            let acts = line.special != 0 && is_in_front;
            (acts || is_closed).then_some((part, number, acts))
        });
        let first = cuts.min_by(|one, other| one.0.total_cmp(&other.0));
        first.filter(|(.., acts)| *acts).map(|(_, number, _)| number)
    }

    /// A place of the map at a height.
    #[must_use]
    pub fn in_space(place: DVec2, height: f64) -> DVec3 {
        DVec3::new(place.x, height, -place.y)
    }
}
