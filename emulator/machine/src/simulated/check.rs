//! The check of memoised timing: it runs the timing by instruction in parallel and compares the
//! two.

use std::fmt;

use super::figures::SimulationOptions;
use crate::interp::Spu;
use crate::profile::{Profile, ProgramProfile, Recording};
use crate::timer::{Timer, TimerState};
use spu_isa::Instruction;
use spu_isa::timing::{Cause, Pipeline, Rules};

/// The first place on one SPE where memoised timing differs from timing by instruction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Address of the block. For a difference between profiles, address of the instruction.
    pub address: u32,
    /// The result of memoised timing.
    pub memoised: String,
    /// The result of timing by instruction.
    pub by_instruction: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { address, memoised, by_instruction } = self;
        write!(
            f,
            "memoised timing differs at {address:#07x}: {memoised}, by instruction {by_instruction}"
        )
    }
}

/// The timing by instruction. It stops comparing at the first difference.
#[derive(Debug)]
pub(super) struct Check {
    timer: Timer,
    recording: Option<Recording>,
    /// The address of the block that was compared last.
    address: u32,
    difference: Option<Difference>,
}

impl Check {
    pub fn new(rules: Rules, options: SimulationOptions) -> Self {
        Self {
            timer: Timer::new(Pipeline::new(rules)),
            recording: options.profile.then(Recording::default),
            address: 0,
            difference: None,
        }
    }

    pub fn difference(&self) -> Option<&Difference> {
        self.difference.as_ref()
    }

    fn differ(&mut self, address: u32, memoised: String, by_instruction: String) {
        if memoised != by_instruction {
            self.difference.get_or_insert(Difference { address, memoised, by_instruction });
        }
    }

    /// The instruction at the program counter issues.
    pub fn issue(&mut self, spu: &Spu, instruction: Instruction) {
        match &mut self.recording {
            Some(recording) => self.timer.record(spu, instruction, recording),
            None => self.timer.record(spu, instruction, &mut ()),
        }
    }

    /// The instruction at `pc` issues, which is not a hint by register.
    pub fn issue_at(&mut self, pc: u32, instruction: Instruction) {
        match &mut self.recording {
            Some(recording) => self.timer.issue(pc, instruction, recording),
            None => self.timer.issue(pc, instruction, &mut ()),
        }
    }

    /// The hint that issued last has this target.
    pub fn hint_target(&mut self, target: u32) {
        self.timer.pipeline.hint_target(target);
    }

    /// The SPU sleeps for `slept` cycles in the channel instruction that issued last.
    pub fn sleep(&mut self, slept: u64, cause: Cause) {
        let until = self.timer.pipeline.clock() + slept;
        self.timer.pipeline.stall_until(until, cause);
        if let Some(recording) = &mut self.recording {
            recording.charge_last(&self.timer.pipeline);
        }
    }

    /// The SPU has stopped.
    pub fn stop(&mut self) {
        if let Some(recording) = &mut self.recording {
            recording.stopped();
        }
    }

    /// Compares the clock and the state after the block at `address`.
    pub fn compare_state(&mut self, address: u32, clock: u64, state: Option<TimerState>) {
        self.address = address;
        let (own_clock, own_state) = (self.timer.pipeline.clock(), self.timer.state());
        if clock != own_clock {
            self.differ(address, cycle(clock), cycle(own_clock));
        } else if state != own_state {
            self.differ(address, format!("{state:?}"), format!("{own_state:?}"));
        }
    }

    /// Compares the account, cause by cause.
    pub fn compare_account(&mut self, timer: &Timer) {
        let (account, own) = (timer.pipeline.account(), self.timer.pipeline.account());
        if account != own {
            let (memoised, own) = (format!("{account:?}"), format!("{own:?}"));
            self.differ(self.address, memoised, own);
        }
    }

    /// Compares what was added to the profile since the last time.
    pub fn compare_profile(&mut self, recording: &Recording) {
        let Some(mut own) = self.recording.take() else {
            return;
        };
        let sorted = |recording: &Recording| ProgramProfile::new(None, recording.profile());
        let (memoised, by_instruction) = (sorted(recording), sorted(&own));
        let both = memoised.instructions.iter().zip(&by_instruction.instructions);
        if let Some((one, other)) = both.into_iter().find(|(one, other)| one != other) {
            self.differ(one.address, format!("{one:?}"), format!("{other:?}"));
        }
        let entries = |profile: &ProgramProfile| format!("{} entries", profile.instructions.len());
        self.differ(self.address, entries(&memoised), entries(&by_instruction));
        own.hand_over(&mut Profile::default());
        self.recording = Some(own);
    }
}

fn cycle(clock: u64) -> String {
    format!("cycle {clock}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulated::Method;
    use spu_isa::Op;

    fn check() -> (Check, Spu, Instruction) {
        let options = SimulationOptions {
            profile: true,
            method: Method::Checked,
            ..SimulationOptions::default()
        };
        let Some(nop) = Instruction::decode(0x4020_0000) else {
            panic!("a nop is an instruction");
        };
        assert_eq!(nop.op, Op::Nop);
        (Check::new(Rules::default(), options), Spu::new(), nop)
    }

    /// The difference that is reported if the memoised side has issued `issued` times, and the
    /// check twice.
    fn difference(issued: u32, differs: impl Fn(&mut Check, &Timer, &Recording)) -> String {
        let (mut check, mut spu, nop) = check();
        let (mut timer, mut recording) = (Timer::default(), Recording::default());
        for at in 0..2 {
            spu.set_pc(4 * at);
            check.issue(&spu, nop);
            if at < issued {
                timer.record(&spu, nop, &mut recording);
            }
        }
        differs(&mut check, &timer, &recording);
        check.difference().map(Difference::to_string).unwrap_or_default()
    }

    #[test]
    fn the_first_difference_is_told() {
        let clock = |check: &mut Check, timer: &Timer, _: &Recording| {
            check.compare_state(0x40, timer.pipeline.clock(), timer.state());
            check.compare_state(0x80, 9, None);
        };
        assert_eq!(
            difference(1, clock),
            "memoised timing differs at 0x00040: cycle 1, by instruction cycle 2"
        );
        let state = |check: &mut Check, timer: &Timer, _: &Recording| {
            check.compare_state(0x40, 2, timer.state());
        };
        assert!(difference(1, state).contains("0x00040: Some(TimerState"));
        let account = |check: &mut Check, timer: &Timer, _: &Recording| {
            check.compare_account(timer);
        };
        assert!(difference(1, account).contains("Account { single: 1"));
        let profile = |check: &mut Check, _: &Timer, recording: &Recording| {
            check.compare_profile(recording);
        };
        assert!(difference(1, profile).contains("1 entries, by instruction 2 entries"));
    }

    #[test]
    fn equal_runs_report_no_difference() {
        let all = |check: &mut Check, timer: &Timer, recording: &Recording| {
            check.compare_state(0x40, timer.pipeline.clock(), timer.state());
            check.compare_account(timer);
            check.compare_profile(recording);
        };
        assert_eq!(difference(2, all), "");
    }
}
