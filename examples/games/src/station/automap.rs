//! The map on the screen: the lines that the walker has seen so far, and an arrow where it is.
//!
//! A display shows it as lines of text, a character for two by four dots. North is above.

use glam::{DVec2, IVec2};
use levels::Line;

use super::ground::Ground;

/// Characters across and down, and dots of each.
const SIZE: IVec2 = IVec2::new(44, 22);
const DOTS: IVec2 = IVec2::new(2, 4);
/// Units of the level from one dot to the next.
const SCALE: f64 = 16.0;
/// How far lines are seen.
const SEEN: f64 = 1536.0;
/// The lines that are looked for in a frame: all of a level in a few seconds.
const AT_ONCE: usize = 24;
/// A character without dots, and the bit of each dot, row by row.
const BRAILLE: u32 = 0x2800;
const BITS: [[u32; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
/// The walker, by its direction: from north on to the right.
const ARROWS: [char; 8] = ['↑', '↗', '→', '↘', '↓', '↙', '←', '↖'];

/// The map.
#[derive(Default)]
pub struct Automap {
    /// Whether it is shown.
    pub is_open: bool,
    /// For each line of the level, whether the walker has seen it.
    seen: Vec<bool>,
    /// The line that is looked for next.
    next: usize,
}

impl Automap {
    /// The map of a level of which nothing was seen yet.
    #[must_use]
    pub fn of(ground: &Ground) -> Self {
        Self { seen: vec![false; ground.map.lines.len()], ..Self::default() }
    }

    /// Looks for some of the lines from a place.
    pub fn look(&mut self, ground: &Ground, place: DVec2) {
        for _ in 0..AT_ONCE.min(self.seen.len()) {
            self.next = (self.next + 1) % self.seen.len();
            if !self.seen[self.next] {
                let [from, to] = ground.map.places(&ground.map.lines[self.next]);
                // A little in front of the line on this side, which itself is not in the way.
                let middle = from.midpoint(to);
                let before = middle.move_towards(place, 1.0);
                let is_near = middle.distance(place) < SEEN;
                self.seen[self.next] = is_near && ground.sees(place, before);
            }
        }
    }

    /// How many lines were seen.
    #[must_use]
    pub fn seen(&self) -> usize {
        self.seen.iter().filter(|seen| **seen).count()
    }

    /// The map around a place, as lines of text.
    #[must_use]
    pub fn text(&self, ground: &Ground, place: DVec2, turn: f64) -> String {
        let dots = SIZE * DOTS;
        let mut cells = vec![0; (SIZE.x * SIZE.y) as usize];
        let on_map = |at: DVec2| DVec2::new(at.x - place.x, place.y - at.y) / SCALE;
        let divides = |line: &Line| {
            let heights = |sector: u32| {
                use levels::Plane::{Ceiling, Floor};
                [ground.height(sector, Floor), ground.height(sector, Ceiling)]
            };
            line.back.as_ref().is_none_or(|back| heights(back.sector) != heights(line.front.sector))
        };
        let seen = ground.map.lines.iter().zip(&self.seen).filter(|(_, seen)| **seen);
        for (line, _) in seen.filter(|(line, _)| divides(line)) {
            let [from, to] = ground.map.places(line).map(on_map);
            let steps = from.distance(to).ceil().max(1.0);
            for step in 0..=steps as u32 {
                let at = from.lerp(to, f64::from(step) / steps).floor().as_ivec2() + dots / 2;
                if at.cmpge(IVec2::ZERO).all() && at.cmplt(dots).all() {
                    let (cell, dot) = (at / DOTS, at % DOTS);
                    cells[(cell.y * SIZE.x + cell.x) as usize] |=
                        BITS[dot.y as usize][dot.x as usize];
                }
            }
        }
        let eighth = (-turn * 4.0 / std::f64::consts::PI).round() as i64;
        let walker = SIZE.y / 2 * SIZE.x + SIZE.x / 2;
        let letter = |(number, &dots): (i32, &u32)| match number == walker {
            true => ARROWS[eighth.rem_euclid(8) as usize],
            false => char::from_u32(BRAILLE + dots).unwrap_or(' '),
        };
        let letters: Vec<char> = (0..).zip(&cells).map(letter).collect();
        let rows = letters.chunks(SIZE.x as usize).map(|row| row.iter().collect::<String>());
        rows.collect::<Vec<_>>().join("\n")
    }
}
