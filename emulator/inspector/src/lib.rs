//! The page of `cellray render --inspect`: where the time of one frame went.
//!
//! The page has the picture with maps over its tiles, the SPUs' timelines, the cycles by function
//! and source line, and what was skipped. It needs neither a network nor scripts: the maps are
//! switched by radio buttons and CSS. All that it needs from the tracer is in an
//! [`Inspection`].

mod frame;
mod kernels;
mod maps;
mod page;
#[cfg(unix)]
mod recording;
mod timelines;

#[cfg(unix)]
pub use recording::{Recording, RecordingError};

use spu_reports::ProfileError;
use spu_reports::views::ViewError;
use spu_scheduler::code::CodeError;
use thiserror::Error;

/// The data of a frame.
pub struct Inspection<'a> {
    /// The scene's name.
    pub scene: &'a str,
    /// The picture, as the bytes of a PNG file.
    pub picture: &'a [u8],
    /// Width and height of the picture in pixels.
    pub size: (u32, u32),
    /// Width and height of a tile in pixels; tiles at the right and lower edge may be smaller.
    pub tile_size: (u32, u32),
    /// The work units that SPUs traced, in the order of their numbers.
    pub units: &'a [Unit],
    /// The effective address to which an SPU sends the costs of the first unit, and the distance
    /// to the next unit's. It shows which SPU traced a unit, and when.
    pub costs: (u64, u64),
    /// More maps of the tiles.
    pub tile_maps: &'a [TileMap],
    /// Maps of the pixels.
    pub pixel_maps: &'a [PixelMap],
    /// The number of frames that the same SPUs traced before. Timeline and profile have them too.
    pub earlier_frames: usize,
    /// The statistics of the frame: a name, a figure, and what it means.
    pub statistics: &'a [Statistic],
    /// The SPU program's ELF file.
    pub program: &'a [u8],
    /// The timeline of the run, in the format of [`spu_reports::TimelineFile`].
    pub timeline: &'a [u8],
    /// The profile of the run, in the format of [`spu_reports::ProfileFile`].
    pub profile: &'a [u8],
}

/// A work unit that was traced.
pub struct Unit {
    /// Its tiles, in the order in which they were traced.
    pub tiles: Vec<Tile>,
}

/// A tile that was traced.
pub struct Tile {
    /// Its number, line by line from the top left.
    pub number: u32,
    /// The ticks of the decrementer that it took.
    pub ticks: u32,
}

/// A figure for each tile.
pub struct TileMap {
    /// A word that no other map has.
    pub id: &'static str,
    /// The map's name.
    pub name: &'static str,
    /// The meaning of the figures.
    pub remark: &'static str,
    /// The figures by the tiles' numbers.
    pub values: Vec<u64>,
}

/// A figure for each pixel.
pub struct PixelMap {
    /// A word that no other map has.
    pub id: &'static str,
    /// The map's name.
    pub name: &'static str,
    /// The meaning of the figures.
    pub remark: String,
    /// The figures, row by row.
    pub values: Vec<u8>,
    /// The meanings of the figures 0, 1 and so on, if they are no numbers.
    pub kinds: &'static [&'static str],
}

/// One figure of the frame.
pub struct Statistic {
    /// The group that it belongs to.
    pub group: &'static str,
    /// Its name.
    pub name: &'static str,
    /// The figure.
    pub value: String,
    /// Its meaning.
    pub meaning: &'static str,
}

/// Why there is no page.
#[derive(Debug, Error)]
pub enum InspectError {
    /// A map of the pixels can't be made a picture.
    #[error("map: {0}")]
    Map(#[from] image::ImageError),
    /// The timeline is no file of this format.
    #[error("timeline: {0}")]
    Timeline(serde_json::Error),
    /// The profile is no file of this format.
    #[error("profile: {0}")]
    Profile(#[from] ProfileError),
    /// The SPU program is no program.
    #[error("SPU program: {0}")]
    Program(#[from] CodeError),
    /// The profile is of another program.
    #[error("profile: {0}")]
    View(#[from] ViewError),
    /// The timeline does not show which SPU traced a unit.
    #[error("timeline: no SPE has sent the costs of work unit {0}")]
    Unit(usize),
}

/// The page.
///
/// # Errors
/// The timeline or the profile is damaged, or not of this frame.
pub fn page(inspection: &Inspection) -> Result<String, InspectError> {
    page::page(inspection)
}
