//! The walls of a line: above and below the opening to the other side, and in it.

use glam::DVec2;

use crate::build::{Builder, PlaneId};
use crate::surfaces::Surface;
use crate::{Error, Line, Name, Pictures, Plane, SKY, Side, flags};

/// By how much lighter walls along y are, and darker those along x, as in Doom: corners are seen
/// although no light has a direction.
const CONTRAST: f64 = 16.0;

/// A wall between two heights, and how its picture is put there.
#[derive(Clone, Copy)]
pub(crate) struct Wall {
    /// Its ends on the map: whoever sees it has the first one to the left.
    pub ends: [DVec2; 2],
    pub bottom: f64,
    pub top: f64,
    pub surface: Surface,
    /// The row of the picture that is at its top, and the column that is at its left.
    pub texel: DVec2,
    pub light: f64,
    /// The floor or ceiling that it moves with.
    pub moves_with: Option<PlaneId>,
    /// The thing that it is a part of, if that can be taken away.
    pub thing: Option<u32>,
}

impl<P: Pictures> Builder<'_, P> {
    /// Adds the walls of a line.
    pub fn add_line(&mut self, line: &Line, pieces: &[DVec2]) -> Result<(), Error> {
        let along: Vec<[DVec2; 2]> = pieces.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        let Some(back) = &line.back else {
            return self.add_solid(line, &along);
        };
        self.add_side(line, &line.front, back, &along)?;
        let turned: Vec<[DVec2; 2]> = along.iter().rev().map(|&[from, to]| [to, from]).collect();
        self.add_side(line, back, &line.front, &turned)
    }

    /// A wall from the floor to the ceiling.
    fn add_solid(&mut self, line: &Line, along: &[[DVec2; 2]]) -> Result<(), Error> {
        let side = &line.front;
        let sector = side.sector;
        let Some(surface) = wall(side.middle) else { return Ok(()) };
        let height = self.surfaces.shown(surface)?.size.y;
        let (floor, ceiling) = (self.rest(sector, Plane::Floor), self.rest(sector, Plane::Ceiling));
        // Where floors or ceilings move, the wall goes on.
        let [bottom, _] = self.range(sector, Plane::Floor);
        let [_, top] = self.range(sector, Plane::Ceiling);
        let row = match line.flags & flags::LOWER_UNPEGGED != 0 {
            true => height - (top - floor),
            false => ceiling - top,
        };
        self.add_wall(side, along, [bottom, top], surface, row, None)
    }

    /// The walls of one side of a line that has two.
    fn add_side(
        &mut self,
        line: &Line,
        side: &Side,
        other: &Side,
        along: &[[DVec2; 2]],
    ) -> Result<(), Error> {
        let (own, far) = (side.sector, other.sector);
        if own == far {
            return self.add_middle(line, side, other, along);
        }
        let is_sky = |builder: &Self, sector: u32| {
            builder.map.sectors[sector as usize].ceiling_flat == Name::new(SKY)
        };
        let [_, top] = self.range(own, Plane::Ceiling);
        let edge = self.rest(far, Plane::Ceiling);
        if top > edge {
            let surface = match is_sky(self, own) && is_sky(self, far) {
                true => Some(Surface::Sky),
                false => wall(side.upper),
            };
            if let Some(surface) = surface {
                let row = match line.flags & flags::UPPER_UNPEGGED != 0 {
                    true => self.rest(own, Plane::Ceiling) - top,
                    false => self.surfaces.shown(surface)?.size.y - (top - edge),
                };
                let moving = self.moving((far, Plane::Ceiling));
                self.add_wall(side, along, [edge, top], surface, row, moving)?;
            }
        }
        let [bottom, _] = self.range(own, Plane::Floor);
        let [lowest, highest] = self.range(far, Plane::Floor);
        let edge = self.rest(far, Plane::Floor);
        let moving = self.moving((far, Plane::Floor));
        // A floor that rises shows more of the wall below it.
        let bottom = if moving.is_some() { bottom.min(lowest) - (highest - edge) } else { bottom };
        if edge > bottom
            && let Some(surface) = wall(side.lower)
        {
            let row = match line.flags & flags::LOWER_UNPEGGED != 0 {
                true => self.rest(own, Plane::Ceiling) - edge,
                false => 0.0,
            };
            self.add_wall(side, along, [bottom, edge], surface, row, moving)?;
        }
        self.add_middle(line, side, other, along)
    }

    /// What hangs or stands in the opening.
    fn add_middle(
        &mut self,
        line: &Line,
        side: &Side,
        other: &Side,
        along: &[[DVec2; 2]],
    ) -> Result<(), Error> {
        let Some(surface) = wall(side.middle) else { return Ok(()) };
        let shown = self.surfaces.shown(surface)?;
        let both = |builder: &Self, plane| {
            [side.sector, other.sector].map(|sector| builder.rest(sector, plane))
        };
        let [one, two] = both(self, Plane::Floor);
        let floor = one.max(two);
        let [one, two] = both(self, Plane::Ceiling);
        let ceiling = one.min(two);
        let top = match line.flags & flags::LOWER_UNPEGGED != 0 {
            true => floor + shown.size.y,
            false => ceiling,
        } + side.offset.y;
        let (low, high) = ((top - shown.size.y).max(floor), top.min(ceiling));
        if low < high {
            // The offset is in the place already.
            let row = top - high - side.offset.y;
            let walls = self.walls(side, along, [low, high], surface, row, None);
            match self.surfaces.holes(surface) {
                None => walls.iter().try_for_each(|wall| self.add_quad(wall))?,
                Some(Some(rectangles)) => {
                    let parts = walls.iter().flat_map(|wall| wall.parts(&rectangles, shown.size.x));
                    let parts: Vec<Wall> = parts.take(self.spare_parts + 1).collect();
                    match self.spare_parts.checked_sub(parts.len()) {
                        Some(left) => self.spare_parts = left,
                        None => {
                            self.left_out += 1;
                            return Ok(());
                        }
                    }
                    parts.iter().try_for_each(|part| self.add_quad(part))?;
                }
                Some(None) => self.left_out += 1,
            }
        }
        Ok(())
    }

    fn add_wall(
        &mut self,
        side: &Side,
        along: &[[DVec2; 2]],
        [bottom, top]: [f64; 2],
        surface: Surface,
        row: f64,
        moves_with: Option<PlaneId>,
    ) -> Result<(), Error> {
        let walls = self.walls(side, along, [bottom, top], surface, row, moves_with);
        walls.iter().try_for_each(|wall| self.add_quad(wall))
    }

    fn walls(
        &self,
        side: &Side,
        along: &[[DVec2; 2]],
        [bottom, top]: [f64; 2],
        surface: Surface,
        row: f64,
        moves_with: Option<PlaneId>,
    ) -> Vec<Wall> {
        let mut column = side.offset.x;
        let wall = |&ends: &[DVec2; 2]| {
            let way = ends[1] - ends[0];
            let contrast = match (way.x == 0.0, way.y == 0.0) {
                (true, _) => CONTRAST,
                (_, true) => -CONTRAST,
                _ => 0.0,
            };
            let light = self.map.sectors[side.sector as usize].light + contrast;
            let texel = DVec2::new(column, row + side.offset.y);
            column += way.length();
            Wall { ends, bottom, top, surface, texel, light, moves_with, thing: None }
        };
        along.iter().map(wall).collect()
    }
}

/// A wall's surface, unless it has none.
fn wall(name: Name) -> Option<Surface> {
    (!name.is_nothing()).then_some(Surface::Wall(name))
}
