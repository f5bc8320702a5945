//! The map of our own level.
//!
//! ```text
//!          court
//!            |  window
//!   begin: hall - corridor - pool - lift - gallery - exit
//! ```
//!
//! A niche of the hall and one beside the pool are joined by portals.

use cellray::game::Random;
use glam::DVec2;
use levels::{Line, Map, Name, SKY, Sector, Side, Thing, flags};

use super::goals::CRYSTAL;

/// The places of which three have a crystal.
const CRYSTALS: [[i32; 2]; 6] =
    [[448, 320], [432, 656], [144, 448], [976, 192], [1400, 96], [1120, 336]];
/// The lines, from left to right for whoever is in front of them, at which one goes from one niche
/// to the other. There is space for a walker beyond them.
pub const PORTALS: [[Point; 2]; 2] = [[[240, -24], [144, -24]], [[1024, -24], [928, -24]]];
/// The number of crystals.
const COUNT: usize = 3;

pub type Point = [i32; 2];

/// The walls of a map, as they are drawn.
#[derive(Default)]
struct Draft {
    map: Map,
    points: Vec<Point>,
}

/// A rectangle's corners, clockwise on the map: its inside is to the right of its sides.
fn box_of([left, bottom, right, top]: [i32; 4]) -> [Point; 4] {
    [[left, bottom], [left, top], [right, top], [right, bottom]]
}

impl Draft {
    fn point(&mut self, point: Point) -> u32 {
        let known = self.points.iter().position(|other| *other == point);
        known.unwrap_or_else(|| {
            self.points.push(point);
            let [x, y] = point.map(f64::from);
            self.map.vertices.push(DVec2::new(x, y));
            self.points.len() - 1
        }) as u32
    }

    /// Adds a sector within outlines, of which those around holes go the other way. Where an
    /// outline has a side of a sector that is known already, one can walk through.
    fn sector(&mut self, heights: [i32; 2], flats: [&str; 2], light: f64, outlines: &[&[Point]]) {
        let sector = self.map.sectors.len() as u32;
        let [floor, ceiling] = heights.map(f64::from);
        let [floor_flat, ceiling_flat] = flats.map(Name::new);
        let plain = Sector { floor, ceiling, floor_flat, ceiling_flat, light, special: 0, tag: 0 };
        self.map.sectors.push(plain);
        let nothing = Name::new("-");
        for outline in outlines {
            for at in 0..outline.len() {
                let ends = [outline[at], outline[(at + 1) % outline.len()]];
                let ends = ends.map(|point| self.point(point));
                let side = Side {
                    sector,
                    offset: DVec2::ZERO,
                    upper: nothing,
                    lower: nothing,
                    middle: nothing,
                };
                let turned = [ends[1], ends[0]];
                match self.map.lines.iter_mut().find(|line| line.ends == turned) {
                    Some(line) => {
                        line.back = Some(side);
                        line.flags = 0;
                    }
                    None => self.map.lines.push(Line {
                        ends,
                        flags: flags::BLOCKS,
                        special: 0,
                        tag: 0,
                        front: side,
                        back: None,
                    }),
                }
            }
        }
    }

    /// Gives all walls that a sector sees a picture.
    fn paint(&mut self, sector: usize, picture: &str) {
        let picture = Name::new(picture);
        for line in &mut self.map.lines {
            let is_solid = line.back.is_none();
            for side in std::iter::once(&mut line.front).chain(&mut line.back) {
                if side.sector as usize == sector {
                    (side.upper, side.lower) = (picture, picture);
                    if is_solid {
                        side.middle = picture;
                    }
                }
            }
        }
    }

    /// Makes a sector a door, which is seen and opened from both sides.
    fn door(&mut self, sector: u32) {
        for line in &mut self.map.lines {
            let Some(back) = &mut line.back else {
                if line.front.sector == sector {
                    line.flags |= flags::LOWER_UNPEGGED;
                }
                continue;
            };
            if line.front.sector == sector {
                std::mem::swap(&mut line.front, back);
                line.ends.reverse();
            }
            if back.sector == sector {
                line.special = 1;
                line.front.upper = Name::new("DOOR");
            }
        }
    }

    /// Changes the line from one point to another.
    fn line(&mut self, from: Point, to: Point, change: impl FnOnce(&mut Line)) {
        let ends = [from, to].map(|point| self.point(point));
        self.map.lines.iter_mut().find(|line| line.ends == ends).map(change);
    }

    fn thing(&mut self, [x, y]: Point, kind: u16) {
        let place = DVec2::new(f64::from(x), f64::from(y));
        self.map.things.push(Thing { place, angle: 45.0, kind });
    }
}

/// The map, with the crystals at places by chance.
#[must_use]
pub fn map(chance: &mut Random) -> Map {
    let mut draft = Draft::default();
    let tiles = ["TILES", "PLATES"];
    let door = box_of([512, 144, 528, 240]);
    let court_door = box_of([208, 384, 304, 400]);
    let exit_door = box_of([1520, 144, 1536, 240]);
    let mut pillar = box_of([224, 160, 288, 224]);
    let pool = box_of([880, 96, 1072, 288]);
    let mut pool_edge = pool;
    pillar.reverse();
    pool_edge.reverse();
    let hall = [
        [0, 0],
        [0, 384],
        [208, 384],
        [304, 384],
        [336, 384],
        [432, 384],
        [512, 384],
        [512, 240],
        [512, 144],
        [512, 0],
        [240, 0],
        [144, 0],
    ];
    let court = [
        [96, 400],
        [96, 720],
        [352, 720],
        [352, 592],
        [400, 592],
        [464, 592],
        [464, 400],
        [432, 400],
        [336, 400],
        [304, 400],
        [208, 400],
    ];
    let basin = [
        [784, 0],
        [784, 144],
        [784, 240],
        [784, 384],
        [1168, 384],
        [1168, 240],
        [1168, 144],
        [1168, 0],
        [1024, 0],
        [928, 0],
    ];
    let gallery = [
        [1264, 48],
        [1264, 144],
        [1264, 240],
        [1264, 336],
        [1520, 336],
        [1520, 240],
        [1520, 144],
        [1520, 48],
    ];
    draft.sector([0, 160], tiles, 176.0, &[&hall, &pillar]);
    draft.sector([0, 0], tiles, 160.0, &[&court_door]);
    draft.sector([40, 112], tiles, 176.0, &[&box_of([336, 384, 432, 400])]);
    draft.sector([0, 176], ["GRASS", SKY], 232.0, &[&court]);
    draft.sector([16, 176], ["TILES", SKY], 232.0, &[&box_of([352, 592, 400, 720])]);
    draft.sector([32, 176], ["TILES", SKY], 232.0, &[&box_of([400, 592, 464, 720])]);
    draft.sector([0, 0], tiles, 144.0, &[&door]);
    draft.sector([0, 112], tiles, 128.0, &[&box_of([528, 144, 784, 240])]);
    draft.sector([0, 224], tiles, 160.0, &[&basin, &pool_edge]);
    draft.sector([-8, 224], ["WATER", "PLATES"], 192.0, &[&pool]);
    draft.sector([96, 224], ["STEEL", "PLATES"], 176.0, &[&box_of([1168, 144, 1264, 240])]);
    draft.sector([96, 224], tiles, 192.0, &[&gallery]);
    draft.sector([96, 96], tiles, 160.0, &[&exit_door]);
    draft.sector([96, 192], tiles, 208.0, &[&box_of([1536, 144, 1632, 240])]);
    draft.sector([0, 112], tiles, 144.0, &[&box_of([144, -24, 240, 0])]);
    draft.sector([0, 112], tiles, 144.0, &[&box_of([144, -88, 240, -24])]);
    draft.sector([0, 112], tiles, 144.0, &[&box_of([928, -24, 1024, 0])]);
    draft.sector([0, 112], tiles, 144.0, &[&box_of([928, -88, 1024, -24])]);
    let walls = [
        "BRICK", "STEEL", "STEEL", "STONE", "STONE", "STONE", "STEEL", "PANEL", "BRICK", "STEEL",
        "STEEL", "PANEL", "STEEL", "PANEL", "STEEL", "STEEL", "STEEL", "STEEL",
    ];
    (0..).zip(walls).for_each(|(sector, picture)| draft.paint(sector, picture));

    draft.door(1);
    draft.door(6);
    draft.door(12);
    draft.line([336, 384], [432, 384], |line| {
        line.front.middle = Name::new("GLASS");
        line.flags |= flags::BLOCKS;
    });
    let lift = |line: &mut Line, special| (line.special, line.tag) = (special, 2);
    draft.map.sectors[10].tag = 2;
    draft.line([1168, 240], [1168, 144], |line| {
        lift(line, 62);
        line.front.lower = Name::new("DOOR");
    });
    draft.line([1264, 240], [1264, 144], |line| lift(line, 88));
    draft.line([1264, 336], [1520, 336], |line| line.front.middle = Name::new("MIRROR"));
    draft.line([1632, 240], [1632, 144], |line| {
        line.special = 11;
        line.front.middle = Name::new("EXIT");
    });

    draft.thing([96, 96], 1);
    let lamps = [
        ([96, 320], 2028),
        ([448, 48], 55),
        ([128, 688], 56),
        ([640, 168], 57),
        ([832, 336], 86),
        ([1120, 48], 55),
        ([1300, 80], 2028),
        ([1480, 300], 57),
        ([1600, 168], 56),
    ];
    lamps.iter().for_each(|&(place, kind)| draft.thing(place, kind));
    let mut places = CRYSTALS;
    chance.shuffle(&mut places);
    places[..COUNT].iter().for_each(|&place| draft.thing(place, CRYSTAL));
    draft.map
}
