//! The inspector's page about a frame.

use std::io::Cursor;

use cellray::engine::TracedTile;
use cellray::spe::Program;
use cellray_inspector::{Inspection, Tile, Unit, page};
use image::ImageFormat;
use protocol::layout::{TILE_HEIGHT, TILE_WIDTH};
use spu_emulator::simulated::{CYCLES_PER_SECOND, SimulationOptions};
use spu_reports::{ProfileFile, TimelineFile};

use crate::Reply;
use crate::orbit::Orbit;
use crate::tracer::{Failure, Tracer};

impl Tracer {
    pub fn inspect(&mut self, orbit: Orbit) -> Result<Reply, Failure> {
        let options =
            SimulationOptions { profile: true, timeline: true, ..SimulationOptions::default() };
        let timed = self.timed(orbit, options)?;
        let simulation = timed.machine.simulation().ok_or("no simulated time")?;
        let timeline = simulation.timeline().ok_or("no timeline was recorded")?;
        let profile = simulation.profile().ok_or("no profile was recorded")?;
        let tile = |tile: &TracedTile| Tile { number: tile.number, ticks: tile.ticks };
        let units = timed.units.units.iter();
        let units = units.map(|tiles| Unit { tiles: tiles.iter().map(tile).collect() });
        let mut png = Vec::new();
        timed.picture.write_to(&mut Cursor::new(&mut png), ImageFormat::Png)?;
        let page = page(&Inspection {
            scene: self.scene().file(),
            picture: &png,
            size: (self.geometry().width, self.geometry().height),
            tile_size: (TILE_WIDTH, TILE_HEIGHT),
            units: &units.collect::<Vec<_>>(),
            costs: (timed.units.costs, timed.units.distance),
            tile_maps: &[],
            pixel_maps: &[],
            earlier_frames: 0,
            statistics: &[],
            program: Program::tracer().image(),
            timeline: &serde_json::to_vec(&TimelineFile::new(CYCLES_PER_SECOND, &timeline))?,
            profile: &serde_json::to_vec(&ProfileFile::new(CYCLES_PER_SECOND, &profile))?,
        })?;
        Ok(Reply::Inspected { page })
    }
}
