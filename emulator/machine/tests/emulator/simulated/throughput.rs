//! The throughput of six SPEs compared with one.

use crate::prelude::*;
use spu_emulator::memory::LINE;
use spu_emulator::simulated::{MemoryFigures, Tenths};

/// The bytes that main memory can move in a cycle if a line takes this time.
fn bytes_a_cycle(line: Tenths) -> f64 {
    (LINE as u64 * Tenths::PER_CYCLE) as f64 / line.0 as f64
}

/// Shares 256 pieces of work by an atomic counter.
const COMPUTE: &str = "
        cwd     $14,0($13)
again:  command GETLLAR, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        lqa     $15,0x10000
        ai      $16,$15,1
        shufb   $16,$16,$15,$14
        stqa    $16,0x10000
        command PUTLLC, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        brnz    $12,again
        clgti   $17,$15,255
        brnz    $17,over
        ila     $20,2000
work:   fa      $21,$21,$22
        ai      $20,$20,-1
        brnz    $20,work
        br      again
over:   stop    0x2000
";

#[test]
fn computing_is_six_times_as_fast_on_six_spes() {
    let clock = |spes| {
        let spes = Machine::simulated().run_all(spes, COMPUTE);
        // The times count from the first instruction.
        spes.iter().map(|spe| spe.clock - spe.stopped).max().unwrap()
    };
    let (one, six) = (clock(1), clock(6));
    let speedup = one as f64 / six as f64;
    // 256 pieces take 43 rounds of six.
    assert!(speedup > 5.8 && speedup <= 6.0, "{speedup}");
}

/// 66 transfers of 16 KB under two alternating tags. The program waits for each one before it uses
/// the buffer again.
const STREAM: &str = "
        ila     $5,32
        shli    $6,$4,14
        a       $6,$6,$3
        command \\direction, 0x10000, $6, 16384, 1
        command \\direction, 0x14000, $6, 16384, 2
again:  wait_tags 2
        command \\direction, 0x10000, $6, 16384, 1
        wait_tags 4
        command \\direction, 0x14000, $6, 16384, 2
        ai      $5,$5,-1
        brnz    $5,again
        wait_tags 6
        stop    0x2000
";
const STREAMED: u64 = 66 * 16384;

/// The bytes per cycle of all SPEs together.
fn rate(spes: u32, direction: &str) -> f64 {
    let spes = Machine::simulated().run_all(spes, &STREAM.replace("\\direction", direction));
    let cycles = spes.iter().map(|spe| spe.clock - spe.stopped).max().unwrap();
    for spe in &spes {
        let commands = &spe.commands;
        assert_eq!(commands.bytes_in + commands.bytes_out, STREAMED);
        assert!(spe.waits.tag * 10 > spe.account.cycles() * 9);
    }
    (STREAMED * spes.len() as u64) as f64 / cycles as f64
}

#[test]
fn memory_gives_its_bandwidth_and_no_more() {
    let MemoryFigures { get_line, put_line, .. } = MemoryFigures::CONSOLE;
    for (direction, line) in [("GET", get_line), ("PUT", put_line)] {
        let most = bytes_a_cycle(line);
        let (one, two, six) = (rate(1, direction), rate(2, direction), rate(6, direction));
        // A single SPE is limited by its outstanding lines.
        assert!(one < 0.9 * most && one > 0.7 * most, "{one}");
        for all in [two, six] {
            assert!(all <= most, "{all}");
            assert!(all > 0.95 * most, "{all}");
        }
    }
}

#[test]
fn small_transfers_are_bound_by_latency() {
    let source = "
        ila     $5,100
again:  command GET, 0x10000, $3, 128, 1
        wait_tags 2
        ai      $5,$5,-1
        brnz    $5,again
        stop    0x2000
";
    let one = Machine::simulated().run_all(1, source);
    let six = Machine::simulated().run_all(6, source);
    let cycles = one[0].account.cycles();
    assert!(cycles > 100 * 309 && cycles < 100 * 400, "{cycles}");
    for spe in &six {
        // 6 lines in 300 cycles do not delay each other.
        assert!(spe.account.cycles() < cycles + cycles / 10);
    }
}
