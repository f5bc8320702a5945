//! The observers of the program's run: mailboxes, trace, statistics, and a watchdog for programs
//! that sleep for ever.

use std::sync::Arc;

use spu_emulator::elf::Image;
use spu_emulator::interp::{Observer, Spu};
use spu_emulator::spe::Spe;
use spu_isa::{Instruction, Op};

use super::mailboxes::Mailboxes;
use super::options::Options;
use super::sleep::Watchdog;
use super::statistics::Statistics;
use super::trace::Trace;
use crate::failure::Failure;

pub struct Bench<'a> {
    spe: &'a Spe,
    mailboxes: Mailboxes,
    watchdog: Watchdog,
    trace: Option<Trace<'a>>,
    statistics: Option<Statistics>,
}

impl<'a> Bench<'a> {
    pub fn new(
        options: &Options,
        image: &'a Image<'a>,
        spe: &'a Arc<Spe>,
    ) -> Result<Self, Failure> {
        let mut mailboxes = Mailboxes::open(options)?;
        mailboxes.exchange(spe);
        let trace = options.trace.as_ref().map(|path| Trace::open(path.as_deref(), image));
        let statistics = options.stats.as_ref();
        Ok(Self {
            spe,
            mailboxes,
            watchdog: Watchdog::start(spe, options.patience())?,
            trace: trace.transpose()?,
            statistics: statistics.map(|path| Statistics::new(path.clone(), options.json)),
        })
    }

    /// Called when the SPU has stopped, so that the effects of its last instruction are visible.
    pub fn stopped(&mut self, spu: &Spu) {
        self.watchdog.awake();
        if let Some(trace) = &mut self.trace {
            trace.finish_line(spu);
        }
        if let Some(statistics) = &mut self.statistics {
            statistics.stopped(spu);
        }
    }

    /// Called before a library call is carried out.
    pub fn called(&mut self, function: &str) {
        if let Some(trace) = &mut self.trace {
            trace.called(function);
        }
        if let Some(statistics) = &mut self.statistics {
            statistics.called(function);
        }
    }

    pub fn why_asleep(&self) -> &'static str {
        let stuck = self.mailboxes.stuck();
        stuck.unwrap_or("it waits in a channel, and nobody woke it")
    }

    /// Writes the remaining output.
    pub fn finish(mut self) -> Result<(), Failure> {
        self.mailboxes.exchange(self.spe);
        self.mailboxes.finish()?;
        if let Some(trace) = self.trace {
            trace.finish()?;
        }
        if let Some(statistics) = self.statistics {
            statistics.write(self.spe.with_spu(Spu::executed))?;
        }
        Ok(())
    }
}

impl Observer for Bench<'_> {
    fn wants_all(&self) -> bool {
        self.statistics.is_some() || self.trace.is_some()
    }

    fn after_compiled(&mut self) {
        self.watchdog.awake();
    }

    #[inline]
    fn before_instruction(&mut self, spu: &Spu, instruction: Instruction) {
        self.watchdog.awake();
        if matches!(instruction.op, Op::Rdch | Op::Wrch | Op::Rchcnt) {
            self.mailboxes.before_channel(self.spe, instruction);
            self.watchdog.perhaps_asleep();
        }
        if let Some(statistics) = &mut self.statistics {
            statistics.count(spu, instruction, self.spe.local_store());
        }
        if let Some(trace) = &mut self.trace {
            trace.finish_line(spu);
            trace.begin_line(spu, instruction);
        }
    }
}
