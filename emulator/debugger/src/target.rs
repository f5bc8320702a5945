//! The SPEs as the remote protocol sees and changes them.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::sync::Arc;

use gdbstub::common::{Signal, Tid};
use gdbstub::target::ext::base::BaseOps;
use gdbstub::target::ext::base::multithread::{
    MultiThreadBase, MultiThreadResume, MultiThreadResumeOps, MultiThreadSchedulerLocking,
    MultiThreadSchedulerLockingOps, MultiThreadSingleStep, MultiThreadSingleStepOps,
};
use gdbstub::target::ext::breakpoints::{
    Breakpoints, BreakpointsOps, HwWatchpoint, HwWatchpointOps, SwBreakpoint, SwBreakpointOps,
    WatchKind,
};
use gdbstub::target::ext::monitor_cmd::{ConsoleOutput, MonitorCmd, MonitorCmdOps, outputln};
use gdbstub::target::ext::thread_extra_info::{ThreadExtraInfo, ThreadExtraInfoOps};
use gdbstub::target::{TargetError, TargetResult};
use spu_emulator::local_store::SIZE;
use spu_isa::Instruction;

use crate::Debugger;
use crate::accesses::Range;
use crate::registers::{Spu, SpuRegisters};
use crate::state::{Action, Phase, Thread, Watchpoint};

pub struct Target<'a> {
    debugger: &'a Arc<Debugger>,
    actions: BTreeMap<Tid, Action>,
    /// What threads do that no action names.
    others: Action,
}

impl<'a> Target<'a> {
    pub fn new(debugger: &'a Arc<Debugger>) -> Self {
        Self { debugger, actions: BTreeMap::new(), others: Action::Continue }
    }

    fn thread<T>(&self, tid: Tid, look: impl FnOnce(&Thread) -> T) -> TargetResult<T, Self> {
        let state = self.debugger.lock();
        let thread = state.threads.get(&tid);
        thread.map(look).ok_or(TargetError::NonFatal)
    }
}

impl gdbstub::target::Target for Target<'_> {
    type Arch = Spu;
    type Error = Infallible;

    fn base_ops(&mut self) -> BaseOps<'_, Spu, Infallible> {
        BaseOps::MultiThread(self)
    }

    fn support_breakpoints(&mut self) -> Option<BreakpointsOps<'_, Self>> {
        Some(self)
    }

    fn support_monitor_cmd(&mut self) -> Option<MonitorCmdOps<'_, Self>> {
        Some(self)
    }
}

impl MultiThreadBase for Target<'_> {
    fn read_registers(&mut self, registers: &mut SpuRegisters, tid: Tid) -> TargetResult<(), Self> {
        self.thread(tid, |thread| {
            registers.general = *thread.registers;
            registers.pc = thread.pc;
        })
    }

    fn write_registers(&mut self, registers: &SpuRegisters, tid: Tid) -> TargetResult<(), Self> {
        let mut state = self.debugger.lock();
        let set = state.set_registers(tid, &registers.general, registers.pc);
        set.then_some(()).ok_or(TargetError::NonFatal)
    }

    /// Addresses beyond local store are no memory of the SPU.
    fn read_addrs(&mut self, start: u32, data: &mut [u8], tid: Tid) -> TargetResult<usize, Self> {
        if start >= SIZE {
            return Err(TargetError::NonFatal);
        }
        let length = data.len().min((SIZE - start) as usize);
        self.thread(tid, |thread| {
            thread.local_store.read(start, &mut data[..length]);
            length
        })
    }

    fn write_addrs(&mut self, start: u32, data: &[u8], tid: Tid) -> TargetResult<(), Self> {
        if u64::from(start) + data.len() as u64 > u64::from(SIZE) {
            return Err(TargetError::NonFatal);
        }
        self.thread(tid, |_| ())?;
        self.debugger.lock().write(tid, start, data);
        Ok(())
    }

    fn list_active_threads(&mut self, is_active: &mut dyn FnMut(Tid)) -> Result<(), Infallible> {
        let numbers: Vec<_> = self.debugger.lock().threads.keys().copied().collect();
        numbers.into_iter().for_each(is_active);
        Ok(())
    }

    fn support_resume(&mut self) -> Option<MultiThreadResumeOps<'_, Self>> {
        Some(self)
    }

    fn support_thread_extra_info(&mut self) -> Option<ThreadExtraInfoOps<'_, Self>> {
        Some(self)
    }
}

impl ThreadExtraInfo for Target<'_> {
    fn thread_extra_info(&self, tid: Tid, buffer: &mut [u8]) -> Result<usize, Infallible> {
        let described = self.thread(tid, |thread| match thread.phase {
            Phase::Stopped => format!("SPE {tid}: not running"),
            Phase::Halted => format!("SPE {tid}"),
            Phase::Executing => {
                let word = thread.local_store.load_word(thread.pc);
                let name =
                    Instruction::decode(word).map_or_else(String::new, Instruction::mnemonic);
                format!("SPE {tid}: waits in {name}")
            }
        });
        let text = described.unwrap_or_default();
        let length = text.len().min(buffer.len());
        buffer[..length].copy_from_slice(&text.as_bytes()[..length]);
        Ok(length)
    }
}

impl MultiThreadResume for Target<'_> {
    fn resume(&mut self) -> Result<(), Infallible> {
        let (actions, others) = (&self.actions, self.others);
        self.debugger.change(|state| state.resume(actions, others));
        Ok(())
    }

    fn clear_resume_actions(&mut self) -> Result<(), Infallible> {
        self.actions.clear();
        self.others = Action::Continue;
        Ok(())
    }

    fn set_resume_action_continue(
        &mut self,
        tid: Tid,
        _: Option<Signal>,
    ) -> Result<(), Infallible> {
        self.actions.insert(tid, Action::Continue);
        Ok(())
    }

    fn support_single_step(&mut self) -> Option<MultiThreadSingleStepOps<'_, Self>> {
        Some(self)
    }

    fn support_scheduler_locking(&mut self) -> Option<MultiThreadSchedulerLockingOps<'_, Self>> {
        Some(self)
    }
}

impl MultiThreadSingleStep for Target<'_> {
    fn set_resume_action_step(&mut self, tid: Tid, _: Option<Signal>) -> Result<(), Infallible> {
        self.actions.insert(tid, Action::Step);
        Ok(())
    }
}

impl MultiThreadSchedulerLocking for Target<'_> {
    fn set_resume_action_scheduler_lock(&mut self) -> Result<(), Infallible> {
        self.others = Action::Stay;
        Ok(())
    }
}

impl Breakpoints for Target<'_> {
    fn support_sw_breakpoint(&mut self) -> Option<SwBreakpointOps<'_, Self>> {
        Some(self)
    }

    fn support_hw_watchpoint(&mut self) -> Option<HwWatchpointOps<'_, Self>> {
        Some(self)
    }
}

impl SwBreakpoint for Target<'_> {
    /// A breakpoint is one of all SPEs.
    fn add_sw_breakpoint(&mut self, address: u32, _: usize) -> TargetResult<bool, Self> {
        let inside = address < SIZE;
        if inside {
            self.debugger.lock().breakpoints.insert(address);
        }
        Ok(inside)
    }

    fn remove_sw_breakpoint(&mut self, address: u32, _: usize) -> TargetResult<bool, Self> {
        Ok(self.debugger.lock().breakpoints.remove(&address))
    }
}

fn watchpoint(start: u32, length: u32, kind: WatchKind) -> Watchpoint {
    let range = Range { start, length };
    Watchpoint { range, kind }
}

impl HwWatchpoint for Target<'_> {
    fn add_hw_watchpoint(
        &mut self,
        address: u32,
        length: u32,
        kind: WatchKind,
    ) -> TargetResult<bool, Self> {
        let inside = length > 0 && length <= SIZE && address < SIZE;
        if inside {
            let watchpoint = watchpoint(address, length, kind);
            self.debugger.lock().watch(watchpoint);
        }
        Ok(inside)
    }

    fn remove_hw_watchpoint(
        &mut self,
        address: u32,
        length: u32,
        kind: WatchKind,
    ) -> TargetResult<bool, Self> {
        let watchpoint = watchpoint(address, length, kind);
        Ok(self.debugger.lock().unwatch(watchpoint))
    }
}

impl MonitorCmd for Target<'_> {
    fn handle_monitor_cmd(
        &mut self,
        command: &[u8],
        mut out: ConsoleOutput<'_>,
    ) -> Result<(), Infallible> {
        if command != b"cycles" {
            outputln!(out, "monitor cycles: the SPEs' clocks, in simulated time");
            return Ok(());
        }
        let state = self.debugger.lock();
        for (number, thread) in &state.threads {
            match thread.cycles {
                Some(cycles) => outputln!(out, "SPE {number}: {cycles}"),
                None => outputln!(out, "SPE {number}: cycles are counted in simulated time"),
            }
        }
        Ok(())
    }
}
