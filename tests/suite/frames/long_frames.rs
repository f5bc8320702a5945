//! Frames that take longer than the 32 bits of the decrementer can count: 53.8 s on a console.
//!
//! The SPU program runs on an emulated SPE whose clock jumps at every read, so that a small frame
//! lasts minutes.

use std::sync::atomic::{AtomicU64, Ordering};

use protocol::layout::{Statistics, TILE_BLANK, UnitCost};
use spu_emulator::decrementer::Clock;
use spu_emulator::elf::Image;
use spu_emulator::machine::Machine;
use spu_emulator::memory::{Access, MainMemory as _, RegisteredMemory};
use spu_emulator::spe::{Config, Spe};
use spu_emulator::stop::Stop;

use crate::frames::descriptor::{Descriptor, SIZE};
use crate::prelude::*;

/// Addresses of the frame's records in main memory.
const FRAME: u64 = 0x1000_0000;
const SPHERES: u64 = 0x1100_0000;
const SCENE: u64 = 0x1200_0000;
const UNIT_COUNTER: u64 = 0x1300_0000;
const STATISTICS: u64 = 0x1400_0000;
const UNITS: u64 = 0x1500_0000;
const COSTS: u64 = 0x1600_0000;
const FRAMEBUFFER: u64 = 0x1700_0000;

/// The number of ticks of a 32-bit decrementer.
const PERIOD: u64 = 1 << 32;

/// How much the time advances at each read: 2.5 s. The driver reads it some fifteen times a
/// tile, and must not miss that 53.8 s have passed.
const LEAP: u64 = 3 << 26;

/// A clock that jumps at each read.
struct Leaping {
    now: AtomicU64,
}

impl Clock for Leaping {
    fn ticks(&self) -> u64 {
        self.now.fetch_add(LEAP, Ordering::Relaxed)
    }

    fn host_time(&self, _: u64) -> Duration {
        Duration::from_micros(100)
    }
}

/// One SPU's statistics of a frame, the cost of its first unit, and the total time.
fn traced(scene: &scenes::Scene) -> (Statistics, UnitCost, u64) {
    let Descriptor { mut frame, spheres, block, units, .. } = Descriptor::of(scene, 1);
    frame.spheres = SPHERES.into();
    frame.scene = SCENE.into();
    frame.unit_counter = UNIT_COUNTER.into();
    frame.statistics = STATISTICS.into();
    frame.units = UNITS.into();
    frame.costs = COSTS.into();
    frame.framebuffer = FRAMEBUFFER.into();

    let memory = Arc::new(RegisteredMemory::new());
    let costs = units.len();
    let picture = frame.stride.get() as usize * SIZE.1 as usize;
    for (address, bytes) in [
        (FRAME, frame.as_bytes().to_vec()),
        (SPHERES, spheres),
        (SCENE, block),
        (UNIT_COUNTER, vec![0; 128]),
        (STATISTICS, vec![0; size_of::<Statistics>()]),
        (UNITS, units),
        (COSTS, vec![0; costs]),
        (FRAMEBUFFER, vec![0; picture]),
    ] {
        let bytes = if bytes.is_empty() { vec![0] } else { bytes };
        memory.register(address, bytes, Access::ReadWrite).unwrap();
    }
    let clock = Arc::new(Leaping { now: AtomicU64::new(0) });
    let interconnect = Machine::with_clock(memory.clone(), clock.clone());
    let spe = Spe::new(&interconnect, Config::default());
    let image = Image::parse(Settings::default().program.image()).unwrap();
    image.load(spe.local_store(), 0);

    // The frame and then the end of the program: as many words as the mailbox holds.
    for word in [(FRAME >> 32) as u32, FRAME as u32, 0, 0] {
        assert!(spe.write_inbound(word, None));
    }
    let stopped = spe.run(image.entry());
    assert_eq!(stopped.reason, Stop::Signal(0x2000));
    assert_eq!(spe.read_outbound_interrupt(None), Some(0), "refused");

    let mut statistics = [0; size_of::<Statistics>()];
    memory.read(STATISTICS, &mut statistics).unwrap();
    let mut cost = [0; size_of::<UnitCost>()];
    memory.read(COSTS, &mut cost).unwrap();
    (
        Statistics::read_from_bytes(&statistics).unwrap(),
        UnitCost::read_from_bytes(&cost).unwrap(),
        clock.now.load(Ordering::Relaxed),
    )
}

fn phases(line: &Statistics) -> u64 {
    [line.ticks_fetch, line.ticks_cull, line.ticks_rays, line.ticks_isect, line.ticks_shade]
        .map(|ticks| ticks.get())
        .iter()
        .sum()
}

fn holds(scene: &scenes::Scene) {
    let (line, cost, total) = traced(scene);
    let [busy, dma_wait, idled] = [line.busy, line.dma_wait, line.idle].map(|ticks| ticks.get());
    assert!(busy > PERIOD, "the frame is too short for the test: {busy}");
    // The start of the program and the time after the last count are not included.
    let counted = busy + dma_wait + idled;
    assert!(counted <= total, "{counted} of {total} ticks");
    assert!(total - counted < 24 * LEAP, "{counted} of {total} ticks");
    let phases = phases(&line);
    assert!(phases <= busy + dma_wait, "{phases} of {busy} and {dma_wait}");
    assert!(4 * phases > busy, "{phases} of {busy} and {dma_wait}");

    let tiles = cost.count.get() as usize;
    for ticks in &cost.ticks[..tiles] {
        let ticks = ticks.get();
        assert!((1..TILE_BLANK).contains(&ticks), "{ticks:#x}");
    }
}

#[test]
fn ticks_of_depth_shading_are_counted_beyond_a_word() {
    holds(&nff_scene("paper13.nff"));
}

#[test]
fn ticks_of_whitteds_model_are_counted_beyond_a_word() {
    holds(&nff_scene("whitted16.nff"));
}
