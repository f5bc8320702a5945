//! Reads the maps of Doom's WAD files and makes textured meshes of them for Whitted's model.
//!
//! Owns the WAD format, maps and their pictures, the triangles of a map's plan, and what the
//! specials of its lines do. Walking in a level is a game's concern. Invariant: whatever a file
//! has, reading it ends with a level whose indices exist and whose numbers are finite, or with an
//! error that names the file, the lump and the value.
//!
//! Lengths are in Doom's unit. A map's x and y are a level's x and -z, and y is up.

mod build;
mod error;
mod graphics;
mod holes;
mod map;
mod plan;
mod shafts;
mod specials;
mod sprites;
mod surfaces;
mod wad;
mod walls;

pub use build::{Level, Part, Plane};
pub use error::{Error, Fault};
pub use graphics::{Graphics, Picture, Pictures};
pub use map::{Line, Map, Sector, Side, Thing, flags};
pub use plan::{Plan, Region};
pub use shafts::{Blockers, Lamp, Shafts};
pub use specials::{Action, Special, Target, Trigger, moves, ranges, special};
pub use sprites::Sprite;
pub use surfaces::{SKY, Surface};
pub use wad::{Name, Wad};
