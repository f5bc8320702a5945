//! The frame in time: which SPU traced which tile, from when to when, what it waited for and what
//! it moved.
//!
//! An SPU sends the costs of a unit's tiles when it has traced the last of them. The tiles follow
//! one another without a gap, so their times follow from that moment and from the costs. They are
//! right to a tick of the decrementer for each tile, and to the time of the code between the last
//! tile and the command.

use spu_emulator::simulated::CYCLES_PER_TICK;
use spu_reports::{SleepEntry, SpeTimeline, TimelineFile, TransferEntry};

use crate::{InspectError, Inspection};

/// A tile, and when an SPU traced it.
pub(crate) struct TracedTile {
    pub number: u32,
    pub spu: usize,
    /// The first cycle, counted from the start of the frame.
    pub start: u64,
    /// The cycle after the last.
    pub end: u64,
    /// Cycles in which the SPU slept while it traced the tile.
    pub slept: u64,
    /// Bytes that its MFC brought from main memory meanwhile.
    pub fetched: u64,
}

impl TracedTile {
    pub fn cycles(&self) -> u64 {
        self.end - self.start
    }
}

/// What one SPU did. Cycles count from the start of the frame.
pub(crate) struct Spu {
    pub sleeps: Vec<SleepEntry>,
    pub transfers: Vec<TransferEntry>,
    pub tiles: Vec<TracedTile>,
}

/// A frame in simulated time.
pub(crate) struct FrameTimes {
    pub spus: Vec<Spu>,
    /// The cycles from the first SPU's first command to the last SPU's last one.
    pub cycles: u64,
    pub cycles_per_second: u64,
}

impl FrameTimes {
    pub fn new(inspection: &Inspection) -> Result<Self, InspectError> {
        let file: TimelineFile =
            serde_json::from_slice(inspection.timeline).map_err(InspectError::Timeline)?;
        let mut spes = file.spes;
        spes.iter_mut().for_each(keep_last_frame);
        let transfers = || spes.iter().flat_map(|spe| &spe.transfers);
        let start = transfers().map(|transfer| transfer.start).min();
        let start = start.unwrap_or(0);
        let end = transfers().map(|transfer| transfer.end).max();
        let mut spus: Vec<Spu> = spes.iter().map(|spe| Spu::new(spe, start)).collect();
        let (first, distance) = inspection.costs;
        for (number, unit) in inspection.units.iter().enumerate() {
            let address = first + number as u64 * distance;
            let sent = |transfer: &TransferEntry| transfer.kind == "put" && transfer.ea == address;
            let by = spus.iter().enumerate().find_map(|(spu, did)| {
                let sent = did.transfers.iter().find(|transfer| sent(transfer))?;
                Some((spu, sent.start))
            });
            let (spu, mut end) = by.ok_or(InspectError::Unit(number))?;
            for tile in unit.tiles.iter().rev() {
                let cycles = u64::from(tile.ticks) * CYCLES_PER_TICK;
                let start = end.saturating_sub(cycles);
                let traced = spus[spu].traced(tile.number, spu, start, end);
                spus[spu].tiles.push(traced);
                end = start;
            }
        }
        for spu in &mut spus {
            spu.tiles.sort_by_key(|tile| tile.start);
        }
        Ok(Self {
            spus,
            cycles: end.unwrap_or(0).saturating_sub(start).max(1),
            cycles_per_second: file.cycles_per_second,
        })
    }

    /// All tiles of all SPUs.
    pub fn tiles(&self) -> impl Iterator<Item = &TracedTile> {
        self.spus.iter().flat_map(|spu| &spu.tiles)
    }
}

/// Removes the transfers of earlier frames. Each frame begins with the transfer of its record,
/// which is at the same address for all.
fn keep_last_frame(spe: &mut SpeTimeline) {
    let begins = |transfer: &TransferEntry| (transfer.kind.clone(), transfer.ea);
    if let Some(first) = spe.transfers.first().map(begins) {
        let last = spe.transfers.iter().rposition(|transfer| begins(transfer) == first);
        spe.transfers.drain(..last.unwrap_or(0));
    }
}

/// The part of the time from `start` to `end` that lies in `from..to`.
pub(crate) fn overlap((start, end): (u64, u64), (from, to): (u64, u64)) -> u64 {
    end.min(to).saturating_sub(start.max(from))
}

impl Spu {
    fn new(spe: &SpeTimeline, origin: u64) -> Self {
        let sleeps = spe.sleeps.iter().map(|sleep| SleepEntry {
            start: sleep.start.saturating_sub(origin),
            end: sleep.end.saturating_sub(origin),
            cause: sleep.cause.clone(),
        });
        let transfers = spe.transfers.iter().map(|transfer| TransferEntry {
            start: transfer.start.saturating_sub(origin),
            end: transfer.end.saturating_sub(origin),
            ..transfer.clone()
        });
        Self {
            sleeps: sleeps.filter(|sleep| sleep.end > sleep.start).collect(),
            transfers: transfers.collect(),
            tiles: Vec::new(),
        }
    }

    fn traced(&self, number: u32, spu: usize, start: u64, end: u64) -> TracedTile {
        let slept = self.sleeps.iter();
        let slept = slept.map(|sleep| overlap((sleep.start, sleep.end), (start, end)));
        let gets = self.transfers.iter();
        let gets = gets.filter(|get| get.kind == "get" && (start..end).contains(&get.start));
        TracedTile {
            number,
            spu,
            start,
            end,
            slept: slept.sum(),
            fetched: gets.map(|get| get.bytes).sum(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Tile, Unit};

    const TIMELINE: &str = r#"{"cycles_per_second":3192000000,"spes":[
        {"sleeps":[{"start":0,"end":90,"cause":"mailbox"},{"start":1150,"end":1170,"cause":"tag"}],
         "transfers":[{"start":10,"end":20,"kind":"get","ea":64,"bytes":128},
                      {"start":30,"end":60,"kind":"put","ea":4096,"bytes":128},
                      {"start":100,"end":400,"kind":"get","ea":64,"bytes":128},
                      {"start":1160,"end":1300,"kind":"get","ea":256,"bytes":256},
                      {"start":1300,"end":1500,"kind":"put","ea":4096,"bytes":128}]},
        {"sleeps":[],
         "transfers":[{"start":900,"end":1100,"kind":"put","ea":4224,"bytes":128}]}]}"#;

    fn inspection(units: &[Unit]) -> Inspection<'_> {
        Inspection {
            scene: "s",
            picture: &[],
            size: (192, 16),
            tile_size: (64, 16),
            units,
            costs: (4096, 128),
            tile_maps: &[],
            pixel_maps: &[],
            earlier_frames: 0,
            statistics: &[],
            program: &[],
            timeline: TIMELINE.as_bytes(),
            profile: &[],
        }
    }

    fn units(count: usize) -> Vec<Unit> {
        let tile = |number, ticks| Tile { number, ticks };
        let mut units =
            vec![Unit { tiles: vec![tile(2, 10), tile(0, 5)] }, Unit { tiles: vec![tile(1, 20)] }];
        units.resize_with(count, || Unit { tiles: Vec::new() });
        units
    }

    #[test]
    fn the_tiles_of_a_unit_end_when_its_costs_are_sent() {
        let units = units(2);
        let times = FrameTimes::new(&inspection(&units)).unwrap();
        // After an earlier frame, it begins in cycle 100, and ends in cycle 1500.
        assert_eq!(times.cycles, 1400);
        let found = times.tiles().map(|tile| (tile.number, tile.spu, tile.start, tile.end));
        let expected = [(2, 0, 600, 1000), (0, 0, 1000, 1200), (1, 1, 0, 800)];
        assert_eq!(found.collect::<Vec<_>>(), expected);
        let tile = times.tiles().nth(1).unwrap();
        assert_eq!((tile.slept, tile.fetched), (20, 256));
    }

    #[test]
    fn a_unit_that_no_spu_has_sent_is_an_error() {
        let units = units(3);
        let error = FrameTimes::new(&inspection(&units)).err().unwrap();
        assert!(error.to_string().contains("work unit 2"), "{error}");
    }
}
