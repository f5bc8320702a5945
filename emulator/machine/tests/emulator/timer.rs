//! The timer with the interpreter: it times exactly the instructions that run, and does not change
//! what they do.
//!
//! Provenance: `model`, derived by hand in a comment at each figure.

use crate::prelude::*;
use spu_emulator::channel::Channels;
use spu_emulator::timer::Timer;
use spu_isa::timing::Cause;

/// Channels that never block.
#[derive(Default)]
struct Open {
    /// The number of queries of the external condition before it holds.
    quiet: Option<u32>,
}

impl Channels for Open {
    fn read(&mut self, _: u8) -> Result<u32, Stop> {
        Ok(7)
    }
    fn write(&mut self, _: u8, _: u32) -> Result<(), Stop> {
        Ok(())
    }
    fn count(&mut self, _: u8) -> Result<u32, Stop> {
        Ok(1)
    }
    fn external_condition(&mut self) -> bool {
        match &mut self.quiet {
            Some(0) => true,
            Some(looks) => {
                *looks -= 1;
                false
            }
            None => false,
        }
    }
}

fn i(op: Op, rt: u8, ra: u8, immediate: i32) -> Instruction {
    Instruction::new(op, [rt, ra, 0, 0], immediate)
}

fn run(code: &[Instruction], spu: &mut Spu, channels: &mut Open) -> (Timer, Stopped) {
    let local_store = LocalStore::new();
    for (address, instruction) in (0u32..).step_by(4).zip(code) {
        local_store.write(address, &instruction.encode().to_be_bytes());
    }
    let mut timer = Timer::default();
    let stopped =
        spu.run_observed(&local_store, channels, 10_000, &mut timer).expect("the program stops");
    (timer, stopped)
}

/// Runs `passes` passes of a loop of nine nops, `ai` and `brnz`.
fn counted(passes: i32, hint: Option<Instruction>) -> (Timer, u64) {
    let nop = i(Op::Nop, 127, 0, 0);
    let mut code = vec![i(Op::Il, 3, 0, passes), i(Op::Il, 4, 0, 0x10)];
    code.push(hint.unwrap_or(nop));
    code.push(nop);
    // The loop starts at 0x10. Its branch is at 0x10 + 40 = 0x38.
    code.extend([nop; 8]);
    code.push(i(Op::Ai, 3, 3, -1));
    code.push(nop);
    code.push(i(Op::Brnz, 3, 0, -0x28));
    code.push(i(Op::Stop, 0, 0, 0));
    let mut spu = Spu::new();
    let (timer, stopped) = run(&code, &mut spu, &mut Open::default());
    assert_eq!((stopped.reason, stopped.pc), (Stop::Signal(0), 0x3c));
    (timer, spu.executed())
}

#[test]
fn each_taken_branch_misses_without_a_hint() {
    let (timer, executed) = counted(10, None);
    let account = timer.pipeline.account();
    assert_eq!(executed, 4 + 10 * 11 + 1);
    assert_eq!(account.instructions(), executed);
    // Nine of ten branches are taken. In a pass, the eight nops come first, then ai at 8, nop at 9
    // and brnz at 10, when ai's result is ready.
    assert_eq!(account.waited(Cause::BranchMiss), 9 * 18);
    assert_eq!(timer.pipeline.clock(), 4 + 10 * 11 + 9 * 18 + 1);
}

#[test]
fn a_hint_saves_all_but_the_last_pass() {
    let relative = Instruction { branch_distance: 0x38 - 8, ..i(Op::Hbrr, 0, 0, 8) };
    // For an hbr, the timer reads the target from the register, which must be set before: il at 1.
    let register = Instruction { branch_distance: 0x38 - 8, ..i(Op::Hbr, 0, 4, 0) };
    // The hint issues at 2 (hbr: at 3, after waiting for il) and works at 18 (19). The first brnz
    // would issue at 4 + 10 = 14 (15), so it waits 4 cycles. Leaving the loop is a miss.
    for (hint, late) in [(relative, 0), (register, 1)] {
        let (timer, executed) = counted(10, Some(hint));
        let account = timer.pipeline.account();
        assert_eq!(account.waited(Cause::HintWait), 4);
        assert_eq!(account.waited(Cause::BranchMiss), 18);
        assert_eq!(timer.pipeline.clock(), executed + 4 + 18 + late);
    }
}

#[test]
fn a_hint_whose_register_is_wrong_misses_always() {
    // $5 is 0, not 0x10: the hint is wrong when the branch is taken, and also when it is not taken
    // at the end.
    let wrong = Instruction { branch_distance: 0x38 - 8, ..i(Op::Hbr, 0, 5, 0) };
    let (timer, _) = counted(10, Some(wrong));
    assert_eq!(timer.pipeline.account().waited(Cause::BranchMiss), 10 * 18);
}

#[test]
fn an_interrupt_is_a_miss() {
    // `bie $3` enables interrupts and branches to 0x10. The interrupt goes to 0.
    let nop = i(Op::Nop, 127, 0, 0);
    let stop = i(Op::Stop, 0, 0, 5);
    let code = [stop, nop, i(Op::Bi, 0, 3, 1), nop, nop, nop, nop];
    // Interrupted at once: bi at 0, 18 to reach the handler, stop. After two nops: bi, 18, nops,
    // 18, stop.
    for (looks, cycles) in [(0, 1 + 18 + 1), (2, 1 + 18 + 2 + 18 + 1)] {
        let mut spu = Spu::new();
        spu.set_register(3, Quad::splat(0x10));
        spu.set_pc(8);
        let mut channels = Open { quiet: Some(looks) };
        let (timer, stopped) = run(&code, &mut spu, &mut channels);
        assert_eq!((stopped.reason, stopped.pc), (Stop::Signal(5), 0));
        assert_eq!(timer.pipeline.clock(), cycles);
    }
}

#[test]
fn timing_changes_nothing() {
    let code =
        [i(Op::Il, 3, 0, 5), i(Op::Rdch, 4, 29, 0), i(Op::Ai, 3, 4, 3), i(Op::Stop, 0, 0, 1)];
    let (mut plain, mut timed) = (Spu::new(), Spu::new());
    run(&code, &mut timed, &mut Open::default());
    let local_store = LocalStore::new();
    for (address, instruction) in (0u32..).step_by(4).zip(&code) {
        local_store.write(address, &instruction.encode().to_be_bytes());
    }
    plain.run(&local_store, &mut Open::default());
    assert_eq!(plain.registers, timed.registers);
    assert_eq!(plain.executed(), timed.executed());
}

#[test]
fn a_channel_instruction_that_is_run_again_issues_once() {
    use spu_emulator::interp::Observer;
    let mut spu = Spu::new();
    let mut timer = Timer::default();
    let read = i(Op::Rdch, 4, 29, 0);
    for _ in 0..3 {
        timer.before_instruction(&spu, read);
    }
    timer.pipeline.stall_until(50, Cause::Channel);
    spu.set_pc(4);
    timer.before_instruction(&spu, i(Op::Ai, 3, 4, 1));
    let account = timer.pipeline.account();
    assert_eq!(account.instructions(), 2);
    // As if it had issued at 49: its reader issues at 55.
    assert_eq!(timer.pipeline.clock(), 56);
    assert_eq!(account.waited(Cause::BranchMiss), 0);
}
