//! Things that stand in a level, as pictures with holes.
//!
//! A picture stands on two planes that cross each other, with both of their sides. One that turned
//! to the eye would move the mesh in each frame, so that its tree would have to be refitted and no
//! tile could be kept; and mirrors and shadows would show a plane that faces somebody else.

use glam::DVec2;

use crate::build::{Builder, Plane};
use crate::holes::squares;
use crate::surfaces::Surface;
use crate::walls::Wall;
use crate::{Error, Name, Picture, Pictures, Plan, Thing};

/// A picture of a thing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sprite {
    /// The picture.
    pub picture: Picture,
    /// The column at which the thing's place is.
    pub left: i16,
    /// How many rows are above its foot.
    pub top: i16,
}

/// What somebody takes to open doors.
const KEYS: [u16; 6] = [5, 6, 13, 38, 39, 40];
/// The light of what shines by itself.
const BRIGHT: f64 = 255.0;

/// The numbers of kinds of things, the first four letters of their pictures, and whether they
/// shine.
const KINDS: [(u16, &str, bool); 60] = [
    (2028, "COLU", true),
    (85, "TLMP", true),
    (86, "TLP2", true),
    (34, "CAND", true),
    (35, "CBRA", true),
    (70, "FCAN", true),
    (44, "TBLU", true),
    (45, "TGRN", true),
    (46, "TRED", true),
    (55, "SMBT", true),
    (56, "SMGT", true),
    (57, "SMRT", true),
    (2035, "BAR1", false),
    (48, "ELEC", false),
    (30, "COL1", false),
    (31, "COL2", false),
    (32, "COL3", false),
    (33, "COL4", false),
    (36, "COL5", false),
    (37, "COL6", false),
    (41, "CEYE", false),
    (43, "TRE1", false),
    (47, "SMIT", false),
    (54, "TRE2", false),
    (5, "BKEY", true),
    (40, "BSKU", true),
    (6, "YKEY", true),
    (39, "YSKU", true),
    (13, "RKEY", true),
    (38, "RSKU", true),
    (2001, "SHOT", false),
    (82, "SGN2", false),
    (2002, "MGUN", false),
    (2003, "LAUN", false),
    (2004, "PLAS", false),
    (2005, "CSAW", false),
    (2006, "BFUG", false),
    (2007, "CLIP", false),
    (2048, "AMMO", false),
    (2008, "SHEL", false),
    (2049, "SBOX", false),
    (2010, "ROCK", false),
    (2046, "BROK", false),
    (2047, "CELL", false),
    (17, "CELP", false),
    (8, "BPAK", false),
    (2011, "STIM", false),
    (2012, "MEDI", false),
    (2013, "SOUL", true),
    (83, "MEGA", true),
    (2014, "BON1", false),
    (2015, "BON2", false),
    (2018, "ARM1", false),
    (2019, "ARM2", false),
    (2022, "PINV", true),
    (2023, "PSTR", true),
    (2024, "PINS", true),
    (2025, "SUIT", false),
    (2026, "PMAP", true),
    (2045, "PVIS", true),
];

impl<P: Pictures> Builder<'_, P> {
    /// Adds the pictures of all things that have one.
    pub fn add_sprites(&mut self, things: &[Thing], plan: &Plan) -> Result<(), Error> {
        for (number, thing) in (0..).zip(things) {
            let kind = KINDS.iter().find(|(kind, ..)| *kind == thing.kind);
            let region = plan.regions.iter().find(|region| region.holds(thing.place));
            let (Some(&(_, letters, shines)), Some(region)) = (kind, region) else { continue };
            let name = Name::new(&format!("{letters}A0"));
            let Some(sprite) = self.surfaces.sprite(name)? else { continue };
            let surface = Surface::Sprite(name);
            self.surfaces.shown(surface)?;
            self.with_sprites.insert(thing.kind);
            let floor = self.rest(region.sector, Plane::Floor);
            let Picture { width, .. } = sprite.picture;
            let height = sprite.picture.height() as f64;
            let left = f64::from(sprite.left);
            let rectangles = squares(&sprite.picture);
            // Pictures that reach below their foot would be in the floor.
            let top = floor + f64::from(sprite.top).max(height);
            let light = match shines {
                true => BRIGHT,
                false => self.map.sectors[region.sector as usize].light,
            };
            // What is taken does not move as well: nobody would have its mesh to move any more.
            let is_taken = KEYS.contains(&thing.kind);
            let moving = self.moving((region.sector, Plane::Floor));
            let (taken, moves_with) = (is_taken.then_some(number), moving.filter(|_| !is_taken));
            for way in [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y] {
                let wall = Wall {
                    ends: [-left, width as f64 - left].map(|along| thing.place + way * along),
                    bottom: top - height,
                    top,
                    surface,
                    texel: DVec2::ZERO,
                    light,
                    moves_with,
                    thing: taken,
                };
                wall.parts(&rectangles, width as f64).try_for_each(|part| self.add_quad(&part))?;
            }
        }
        Ok(())
    }
}
