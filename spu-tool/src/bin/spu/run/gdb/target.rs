//! The program as the debugger sees and changes it.

use std::collections::BTreeSet;
use std::convert::Infallible;

use gdbstub::common::Signal;
use gdbstub::target::ext::base::BaseOps;
use gdbstub::target::ext::base::singlethread::{
    SingleThreadBase, SingleThreadResume, SingleThreadResumeOps, SingleThreadSingleStep,
    SingleThreadSingleStepOps,
};
use gdbstub::target::ext::breakpoints::{
    Breakpoints, BreakpointsOps, HwWatchpoint, HwWatchpointOps, SwBreakpoint, SwBreakpointOps,
    WatchKind,
};
use gdbstub::target::ext::monitor_cmd::{ConsoleOutput, MonitorCmd, MonitorCmdOps, outputln};
use gdbstub::target::{Target, TargetError, TargetResult};
use spu_emulator::local_store::SIZE;

use super::super::bench::Bench;
use super::super::machine::{End, Machine};
use super::registers::{Spu, SpuRegisters};

/// Why the program halts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Halt {
    Stepped,
    Breakpoint,
    /// Watched bytes at this address have changed.
    Changed(u32),
    /// The program has done something that ends it.
    Failing,
    Ended,
}

struct Watched {
    address: u32,
    bytes: Vec<u8>,
}

pub struct Debugger<'a, 'b> {
    pub machine: &'a mut Machine,
    bench: &'a mut Bench<'b>,
    breakpoints: BTreeSet<u32>,
    watched: Vec<Watched>,
    stepping: bool,
    /// How the program ended.
    pub end: Option<End>,
}

impl<'a, 'b> Debugger<'a, 'b> {
    pub fn new(machine: &'a mut Machine, bench: &'a mut Bench<'b>) -> Self {
        Self {
            machine,
            bench,
            breakpoints: BTreeSet::new(),
            watched: Vec::new(),
            stepping: false,
            end: None,
        }
    }

    /// Runs one instruction. A library call is carried out as part of it.
    pub fn step(&mut self) -> Option<Halt> {
        if self.end.is_some() {
            return Some(Halt::Ended);
        }
        if let Some(end) = self.machine.advance(1, self.bench) {
            let failing = !matches!(end, End::Exit(_));
            self.end = Some(end);
            return Some(if failing { Halt::Failing } else { Halt::Ended });
        }
        if let Some(address) = self.changed() {
            return Some(Halt::Changed(address));
        }
        if self.breakpoints.contains(&self.machine.at()) {
            return Some(Halt::Breakpoint);
        }
        self.stepping.then_some(Halt::Stepped)
    }

    fn bytes(&self, address: u32, length: usize) -> Vec<u8> {
        let mut bytes = vec![0; length];
        self.machine.local_store().read(address, &mut bytes);
        bytes
    }

    fn changed(&mut self) -> Option<u32> {
        let mut changed = None;
        for n in 0..self.watched.len() {
            let Watched { address, bytes } = &self.watched[n];
            let now = self.bytes(*address, bytes.len());
            if now != *bytes {
                changed = changed.or(Some(*address));
                self.watched[n].bytes = now;
            }
        }
        changed
    }
}

impl Target for Debugger<'_, '_> {
    type Arch = Spu;
    type Error = Infallible;

    fn base_ops(&mut self) -> BaseOps<'_, Spu, Infallible> {
        BaseOps::SingleThread(self)
    }

    fn support_breakpoints(&mut self) -> Option<BreakpointsOps<'_, Self>> {
        Some(self)
    }

    fn support_monitor_cmd(&mut self) -> Option<MonitorCmdOps<'_, Self>> {
        Some(self)
    }
}

impl SingleThreadBase for Debugger<'_, '_> {
    fn read_registers(&mut self, registers: &mut SpuRegisters) -> TargetResult<(), Self> {
        registers.general = self.machine.registers();
        registers.pc = self.machine.at();
        Ok(())
    }

    fn write_registers(&mut self, registers: &SpuRegisters) -> TargetResult<(), Self> {
        self.machine.set_registers(&registers.general, registers.pc);
        Ok(())
    }

    /// Addresses beyond local store are no memory of the SPU.
    fn read_addrs(&mut self, start: u32, data: &mut [u8]) -> TargetResult<usize, Self> {
        if start >= SIZE {
            return Err(TargetError::NonFatal);
        }
        let length = data.len().min((SIZE - start) as usize);
        self.machine.local_store().read(start, &mut data[..length]);
        Ok(length)
    }

    fn write_addrs(&mut self, start: u32, data: &[u8]) -> TargetResult<(), Self> {
        if u64::from(start) + data.len() as u64 > u64::from(SIZE) {
            return Err(TargetError::NonFatal);
        }
        self.machine.local_store().write(start, data);
        // What the user changes is not what he watches for.
        self.changed();
        Ok(())
    }

    fn support_resume(&mut self) -> Option<SingleThreadResumeOps<'_, Self>> {
        Some(self)
    }
}

impl SingleThreadResume for Debugger<'_, '_> {
    fn resume(&mut self, _: Option<Signal>) -> Result<(), Infallible> {
        self.stepping = false;
        Ok(())
    }

    fn support_single_step(&mut self) -> Option<SingleThreadSingleStepOps<'_, Self>> {
        Some(self)
    }
}

impl SingleThreadSingleStep for Debugger<'_, '_> {
    fn step(&mut self, _: Option<Signal>) -> Result<(), Infallible> {
        self.stepping = true;
        Ok(())
    }
}

impl Breakpoints for Debugger<'_, '_> {
    fn support_sw_breakpoint(&mut self) -> Option<SwBreakpointOps<'_, Self>> {
        Some(self)
    }

    fn support_hw_watchpoint(&mut self) -> Option<HwWatchpointOps<'_, Self>> {
        Some(self)
    }
}

impl SwBreakpoint for Debugger<'_, '_> {
    fn add_sw_breakpoint(&mut self, address: u32, _: usize) -> TargetResult<bool, Self> {
        self.breakpoints.insert(address);
        Ok(address < SIZE)
    }

    fn remove_sw_breakpoint(&mut self, address: u32, _: usize) -> TargetResult<bool, Self> {
        Ok(self.breakpoints.remove(&address))
    }
}

impl HwWatchpoint for Debugger<'_, '_> {
    /// Only writes are watched.
    fn add_hw_watchpoint(
        &mut self,
        address: u32,
        length: u32,
        kind: WatchKind,
    ) -> TargetResult<bool, Self> {
        if kind != WatchKind::Write || length == 0 || length > SIZE || address >= SIZE {
            return Ok(false);
        }
        let bytes = self.bytes(address, length as usize);
        self.watched.push(Watched { address, bytes });
        Ok(true)
    }

    fn remove_hw_watchpoint(
        &mut self,
        address: u32,
        length: u32,
        _: WatchKind,
    ) -> TargetResult<bool, Self> {
        let same = |watched: &Watched| {
            watched.address == address && watched.bytes.len() == length as usize
        };
        let found = self.watched.iter().position(same);
        found.map(|at| self.watched.remove(at));
        Ok(found.is_some())
    }
}

impl MonitorCmd for Debugger<'_, '_> {
    fn handle_monitor_cmd(
        &mut self,
        command: &[u8],
        mut out: ConsoleOutput<'_>,
    ) -> Result<(), Infallible> {
        match (command, self.machine.cycles()) {
            (b"cycles", Some(cycles)) => outputln!(out, "{cycles}"),
            (b"cycles", None) => outputln!(out, "cycles are counted with --timing"),
            _ => outputln!(out, "monitor cycles: the clock, in simulated time"),
        }
        Ok(())
    }
}
