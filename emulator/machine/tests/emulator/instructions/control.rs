//! Behaviour of several instructions together: interrupts, channels, stops, limits, changed code,
//! flags.
//!
//! Provenance: manual, unless a test states another.

use super::machine::{Script, instruction, put};
use crate::prelude::*;
use spu_emulator::interp::Observer;
use spu_emulator::mfc::DmaError;
use spu_isa::{Machine, feature};

fn program(at: u32, code: &[Instruction]) -> (Spu, LocalStore, Script) {
    let local_store = LocalStore::new();
    for (address, &instruction) in (at..).step_by(4).zip(code) {
        put(&local_store, address, instruction);
    }
    let mut spu = Spu::new();
    spu.set_pc(at);
    (spu, local_store, Script::default())
}

fn on(op: Op, rt: u8, ra: u8, immediate: i32) -> Instruction {
    Instruction { rt, ra, ..instruction(op, immediate) }
}

fn dma_error() -> Stop {
    Stop::Dma(DmaError::InvalidCommand { what: "test", command: 0xff })
}

#[test]
fn channels_move_the_preferred_word() {
    let code = [
        on(Op::Rdch, 3, 29, 0),
        on(Op::Rchcnt, 4, 30, 0),
        on(Op::Wrch, 5, 28, 0),
        instruction(Op::Stop, 1),
    ];
    let (mut spu, local_store, mut channels) = program(0x100, &code);
    channels.reads.push_back(Ok(0x1234_5678));
    channels.count = 0x11e;
    spu.registers = [Quad::splat(0xdead_beef); 128];
    spu.set_register(5, Quad([0xcafe_f00d, 1, 2, 3]));
    assert_eq!(spu.run(&local_store, &mut channels).reason, Stop::Signal(1));
    assert_eq!(spu.register(3), Quad::scalar(0x1234_5678));
    assert_eq!(spu.register(4), Quad::scalar(0x11e));
    assert_eq!(channels.written, [(28, 0xcafe_f00d)]);
    assert_eq!(spu.executed(), 4);
}

#[test]
fn a_channel_stop_says_what_is_run_next() {
    let run = |op, reads: Option<Stop>, writes: Option<Stop>| {
        let (mut spu, local_store, mut channels) = program(0x100, &[on(op, 3, 21, 0)]);
        channels.reads.extend(reads.map(Err));
        channels.write_results.extend(writes.map(Err));
        let stopped = spu.run(&local_store, &mut channels);
        assert_eq!(spu.pc(), stopped.npc);
        (stopped, spu.executed())
    };
    let invalid = Stop::InvalidChannel(21, ChannelAccess::Read);
    let stopped = |reason, pc, npc| Stopped { reason, pc, npc };
    assert_eq!(run(Op::Rdch, None, None), (stopped(invalid, 0x100, 0x100), 0));
    assert_eq!(
        run(Op::Rdch, Some(Stop::Requested), None),
        (stopped(Stop::Requested, 0x100, 0x100), 0)
    );
    assert_eq!(
        run(Op::Wrch, None, Some(Stop::Requested)),
        (stopped(Stop::Requested, 0x100, 0x100), 0)
    );
    assert_eq!(run(Op::Wrch, None, Some(dma_error())), (stopped(dma_error(), 0x104, 0x104), 1));
}

#[test]
fn an_interrupt_is_taken_returned_from_and_not_nested() {
    let code = [
        on(Op::Bi, 0, 4, feature::ENABLE),
        instruction(Op::Stop, 0xbad),
        on(Op::Ai, 6, 6, 1),
        instruction(Op::Stop, 2),
    ];
    let (mut spu, local_store, mut channels) = program(0x200, &code);
    spu.set_register(4, Quad::splat(0x208));
    put(&local_store, 0, on(Op::Ai, 7, 7, 1));
    put(&local_store, 4, on(Op::Iret, 0, 0, feature::ENABLE));

    channels.event = true;
    assert!(!spu.interrupts_enabled());
    assert_eq!(spu.step(&local_store, &mut channels), None);
    assert!(spu.interrupts_enabled());
    assert_eq!((spu.pc(), channels.interrupts_told.clone()), (0x208, vec![true]));

    assert_eq!(spu.step(&local_store, &mut channels), None, "the handler's first instruction");
    assert_eq!((spu.pc(), channels.srr0), (4, 0x208));
    assert!(!spu.interrupts_enabled());
    assert_eq!(spu.register(7), Quad::splat(1));
    channels.event = false;
    let stopped = spu.run(&local_store, &mut channels);
    assert_eq!((stopped.reason, stopped.pc, stopped.npc), (Stop::Signal(2), 0x20c, 0x210));
    assert_eq!(spu.register(6), Quad::splat(1));
    assert_eq!(channels.interrupts_told, [true, false, true]);
}

#[test]
fn feature_bits_work_only_when_the_branch_is_taken() {
    for (condition, enabled) in [(0, false), (1, true)] {
        let (mut spu, local_store, mut channels) =
            program(0, &[on(Op::Biz, 3, 4, feature::DISABLE)]);
        spu.set_interrupts_enabled(true, &mut channels);
        spu.set_register(3, Quad::scalar(condition));
        assert_eq!(spu.step(&local_store, &mut channels), None);
        assert_eq!(spu.interrupts_enabled(), enabled);
    }
    let (mut spu, local_store, mut channels) = program(0, &[on(Op::Bisled, 3, 4, feature::ENABLE)]);
    assert_eq!(spu.step(&local_store, &mut channels), None);
    assert!(!spu.interrupts_enabled());
}

#[test]
fn iret_goes_to_srr0_without_its_low_bits() {
    let (mut spu, local_store, mut channels) = program(0x40, &[on(Op::Iret, 0, 0, 0)]);
    channels.srr0 = 0x0004_1237;
    assert_eq!(spu.step(&local_store, &mut channels), None);
    assert_eq!(spu.pc(), 0x1234);
}

#[test]
fn store_over_cached_code_runs_the_new_code() {
    // The store replaces the quadword of `ai $6,$6,1` with that of `ai $6,$6,100`.
    let mut code = vec![on(Op::Stqa, 8, 0, 0x1010), on(Op::Brz, 9, 0, 12)];
    code.extend([instruction(Op::Lnop, 0); 2]);
    code.extend([
        on(Op::Ai, 6, 6, 1),
        on(Op::Ai, 9, 9, 1),
        on(Op::Brnz, 6, 0, -8),
        instruction(Op::Stop, 0),
    ]);
    let (mut spu, local_store, mut channels) = program(0x1000, &code);
    let new = [
        on(Op::Ai, 6, 6, 100).encode(),
        on(Op::Ai, 9, 9, 1).encode(),
        on(Op::Brz, 127, 0, 4).encode(),
        on(Op::Stop, 0, 0, 7).encode(),
    ];
    spu.set_pc(0x1010);
    assert_eq!(spu.step(&local_store, &mut channels), None);
    assert_eq!(spu.register(6), Quad::splat(1), "the old code, now in the cache");
    spu.set_pc(0x1000);
    spu.set_register(8, Quad(new));
    spu.set_register(9, Quad::ZERO);
    assert_eq!(spu.run(&local_store, &mut channels).reason, Stop::Signal(7));
    assert_eq!(spu.register(6), Quad::splat(101));

    // Write from outside, as DMA does.
    local_store.write(0x101c, &on(Op::Stop, 0, 0, 8).encode().to_be_bytes());
    spu.set_pc(0x1010);
    assert_eq!(spu.run(&local_store, &mut channels).reason, Stop::Signal(8));
}

#[test]
fn unassigned_opcodes_stop_and_are_not_counted() {
    let word = 0xff_u32 << 21 | 5;
    let free = (0..2048u32).filter(|top| Op::of_word(top << 21).is_none());
    assert_eq!(free.clone().count(), 784);
    for top in free {
        let local_store = LocalStore::new();
        let word = top << 21 | word & 0x1f_ffff;
        local_store.write(0x20, &word.to_be_bytes());
        let mut spu = Spu::new();
        spu.set_pc(0x20);
        let stopped = spu.run(&local_store, &mut Script::default());
        assert_eq!(
            stopped,
            Stopped { reason: Stop::InvalidInstruction(word), pc: 0x20, npc: 0x20 }
        );
        assert_eq!(spu.executed(), 0);
    }
}

#[test]
fn the_cell_has_no_double_extension() {
    let extension = Op::rows().iter().filter(|row| row.machine == Machine::DoubleExtension);
    for row in extension {
        let code = instruction(row.op, 0);
        let (mut spu, local_store, mut channels) = program(0, &[code]);
        let stopped = spu.step(&local_store, &mut channels).unwrap();
        assert_eq!(stopped.reason, Stop::InvalidInstruction(code.encode()), "{}", row.mnemonic);
        let mut spu = Spu::with_double_extension();
        assert_eq!(spu.step(&local_store, &mut channels), None, "{}", row.mnemonic);
    }
}

#[test]
fn loops_end_by_request_and_by_limit() {
    let (mut spu, local_store, mut channels) = program(0x80, &[on(Op::Br, 0, 0, 0)]);
    assert_eq!(spu.run_limited(&local_store, &mut channels, 1000), None);
    assert_eq!(spu.executed(), 1000);
    channels.stop_requested = true;
    let requested = |pc| Stopped { reason: Stop::Requested, pc, npc: pc };
    assert_eq!(spu.run(&local_store, &mut channels), requested(0x80));
    assert_eq!(spu.executed(), 1001);

    // Code without any branch: local store full of no-operations, which runs round and round.
    let local_store = LocalStore::new();
    for address in (0..0x40000).step_by(4) {
        put(&local_store, address, instruction(Op::Lnop, 0));
    }
    let mut spu = Spu::new();
    assert_eq!(spu.run(&local_store, &mut channels), requested(0));
    assert_eq!(spu.executed(), 0x10000);
}

#[test]
fn an_observer_sees_each_instruction_before_it_runs() {
    #[derive(Default)]
    struct Trace(Vec<(u32, Op, u32)>);
    impl Observer for Trace {
        fn before_instruction(&mut self, spu: &Spu, instruction: Instruction) {
            self.0.push((spu.pc(), instruction.op, spu.register(3).preferred()));
        }
    }
    let code =
        [on(Op::Il, 3, 0, 7), on(Op::Br, 0, 0, 8), on(Op::Il, 3, 0, 8), instruction(Op::Stop, 3)];
    let (mut spu, local_store, mut channels) = program(0x300, &code);
    let mut trace = Trace::default();
    let stopped = spu.run_observed(&local_store, &mut channels, 100, &mut trace).unwrap();
    assert_eq!(stopped.reason, Stop::Signal(3));
    assert_eq!(trace.0, [(0x300, Op::Il, 0), (0x304, Op::Br, 7), (0x30c, Op::Stop, 7)]);
}

/// Provenance: model, from the flags' definitions.
#[test]
fn flags_reach_the_status_register_and_stay() {
    let flags_after = |i: Instruction, a: Quad, b: Quad| {
        let code = [i, on(Op::Fa, 10, 11, 0), on(Op::Fscrrd, 12, 0, 0), instruction(Op::Stop, 0)];
        let (mut spu, local_store, mut channels) = program(0, &code);
        spu.set_register(4, a);
        spu.set_register(5, b);
        let stopped = spu.run(&local_store, &mut channels);
        assert_eq!(stopped.reason, Stop::Signal(0));
        spu.register(12).0
    };
    let one = 0x3f80_0000;
    let mixed = Quad([0x7fff_ffff, 0x0080_0000, one, 0x7f80_0000]);
    // Overflow and underflow; exponent 255; nothing.
    let halves = Quad([0x7f00_0000, 0x3f00_0000, one, one]);
    let fm = instruction(Op::Fm, 0);
    assert_eq!(flags_after(fm, mixed, halves), [0x5, 0x3, 0x0, 0x1]);
    let zeros = Quad([0, one, 0x8000_0001, one]);
    for op in [Op::Frest, Op::Frsqest] {
        assert_eq!(flags_after(instruction(op, 0), zeros, Quad::ZERO), [0, 0, 0, 0xa00]);
    }
    let invalid = Quad::from_doublewords([0x7ff0_0000_0000_0000, 0x3ff0_0000_0000_0000]);
    let zero_and_tiny = Quad::from_doublewords([0, 0x3c00_0000_0000_0000]);
    assert_eq!(flags_after(instruction(Op::Dfm, 0), invalid, zero_and_tiny), [0, 0x400, 0, 0]);
    assert_eq!(flags_after(instruction(Op::Dfa, 0), invalid, zero_and_tiny), [0, 0, 0x800, 0]);
    let write = instruction(Op::Fscrwr, 0);
    assert_eq!(
        flags_after(write, Quad::splat(u32::MAX), Quad::ZERO),
        [0xf07, 0x3f07, 0x3f07, 0xf07]
    );
}

#[test]
fn each_double_slice_rounds_in_its_own_mode() {
    let code = [instruction(Op::Fscrwr, 0), on(Op::Dfa, 3, 8, 0)];
    let (mut spu, local_store, mut channels) = program(0, &code);
    let one = 0x3ff0_0000_0000_0000;
    spu.set_register(4, Quad::scalar(0b10_01 << 8));
    spu.set_register(8, Quad::from_doublewords([one; 2]));
    spu.set_register(5, Quad::from_doublewords([0x3c00_0000_0000_0000; 2]));
    assert_eq!(spu.run_limited(&local_store, &mut channels, 2), None);
    assert_eq!(spu.register(3).doublewords(), [one + 1, one], "up, toward zero");
}
