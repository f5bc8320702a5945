//! The SPUs, and the mail exchanged with them for each frame.

use std::sync::Arc;
use std::time::Duration;

use super::error::EngineError;
use super::records::Records;
use super::settings::Settings;
use super::silence::{Activity, Pause, Silence, Watchdog};
use super::unchecked::Unchecked;
use crate::spe::{Context, Ended, Event, Events, Instant, Running};
use crate::work::Refusal;
use protocol::layout::{FEATURE_WHITTED, Frame, MAX_SPUS};

/// How long to wait for an SPU that is made to stop. It stops with its next instruction, if it
/// executes one, but a busy host may take a while to get there.
const UNTIL_HALTED: Duration = Duration::from_secs(5);

struct Spu {
    context: Arc<Context>,
    running: Option<Running>,
}

/// SPUs that wait for frames. Dropping this ends their programs.
pub(super) struct Spus {
    // Dropped first, because it refers to the contexts.
    events: Events,
    spus: Vec<Spu>,
    pause: Pause,
}

impl Spus {
    /// Creates the SPE contexts, loads the program into each and starts it.
    pub fn start(settings: &Settings) -> Result<Self, EngineError> {
        let mut started = Self { events: Events::create()?, spus: Vec::new(), pause: Pause::new() };
        for number in 0..settings.spus {
            let context = Arc::new(Context::create()?);
            context.load(&settings.program)?;
            started.events.watch(&context, number)?;
            let running = Running::start(&context, number)?;
            started.spus.push(Spu { context, running: Some(running) });
        }
        Ok(started)
    }

    /// Mails `address` as the address of `frame`, and waits for the replies.
    pub fn exchange(
        &mut self,
        address: u64,
        frame: &Frame,
        records: &Records,
        settings: &Settings,
        progress: &mut dyn FnMut(f64),
    ) -> Result<(), EngineError> {
        if self.spus.iter().any(|spu| spu.running.is_none()) {
            return Err(EngineError::Lost);
        }
        for spu in &self.spus {
            spu.context.mail([(address >> 32) as u32, address as u32])?;
        }
        let is_whitted = frame.features.get() & FEATURE_WHITTED != 0;
        let unchecked = || Unchecked::of(settings, is_whitted);
        let mut watchdog = Watchdog::start(settings.timeout, Instant::now());
        let mut waiting = [false; MAX_SPUS as usize];
        waiting[..self.spus.len()].fill(true);
        let mut first_error = None;
        // All SPUs are waited for, even after an error, because they write to the frame's memory
        // until they reply.
        while let Some(slowest) = waiting.iter().position(|waiting| *waiting) {
            let began = Instant::now();
            let left = watchdog.left(began);
            if left.is_zero() {
                let silence = self.silence(slowest, settings, frame, records);
                let (spu, unchecked) = (slowest as u32, unchecked());
                return Err(EngineError::Silent { spu, silence, unchecked });
            }
            let Some((number, event)) = self.events.wait(self.pause.length(left))? else {
                self.pause.slept(began.elapsed());
                let (taken, finished) = records.units_done(frame);
                watchdog.observe(u64::from(taken) + u64::from(finished), Instant::now());
                progress(part(taken.max(finished), frame));
                continue;
            };
            watchdog.restart(Instant::now());
            let spu = &mut self.spus[number as usize];
            let error = match event {
                Event::Reply => {
                    let Some(reply) = spu.context.reply()? else {
                        continue;
                    };
                    // The names are looked up only after a refusal, because that allocates memory.
                    // An image without the table has no names.
                    let shaders = match reply {
                        0 => Vec::new(),
                        _ => settings.program.shaders().unwrap_or_default(),
                    };
                    Refusal::of(reply, frame, address, &shaders).map(|refusal| {
                        let unchecked = match refusal.names_shader() {
                            true => Unchecked::default(),
                            false => unchecked(),
                        };
                        EngineError::Refused { spu: number, refusal, unchecked }
                    })
                }
                Event::Stopped => {
                    spu.context.take_stop_record()?;
                    // The thread is about to end: libspe2 wrote the record just before.
                    let ended = spu.running.take().and_then(Running::ended);
                    ended.map(|ended| EngineError::Ended {
                        spu: number,
                        ended,
                        unchecked: unchecked(),
                    })
                }
            };
            waiting[number as usize] = false;
            first_error = first_error.or(error);
        }
        first_error.map_or(Ok(()), Err)
    }

    /// Finds out what an SPU that doesn't reply is doing. It is lost anyway, so it is stopped to
    /// learn where it is. So are the others: in simulated time, its stop shows only when they have
    /// got as far, and they may have much left to run.
    fn silence(
        &mut self,
        number: usize,
        settings: &Settings,
        frame: &Frame,
        records: &Records,
    ) -> Silence {
        let (taken, finished) = records.units_done(frame);
        let program = settings.program;
        let activity = if self.spus[number].context.has_unread_mail() {
            Activity::HasMail
        } else {
            for spu in &self.spus {
                spu.context.halt(&program);
            }
            match self.until_ended(number) {
                Some(ended) => {
                    let address = ended.npc.wrapping_sub(4);
                    let function = program.name_of(address);
                    Activity::Ran { address, function }
                }
                None => Activity::Waited,
            }
        };
        let units = frame.unit_count.get();
        Silence {
            waited: settings.timeout,
            // An SPU that finds no unit left has incremented the counter too.
            begun: taken.max(finished).min(units),
            units,
            activity,
        }
    }

    /// Waits a while for the end of an SPU's program. The other SPUs' replies are discarded.
    fn until_ended(&mut self, number: usize) -> Option<Ended> {
        let asked = Instant::now();
        while asked.elapsed() < UNTIL_HALTED {
            let event = self.events.wait(self.pause.length(UNTIL_HALTED)).ok()?;
            let Some((of, event)) = event else {
                continue;
            };
            let spu = &mut self.spus[of as usize];
            if event == Event::Reply {
                spu.context.reply().ok()?;
                continue;
            }
            spu.context.take_stop_record().ok()?;
            let ended = spu.running.take().and_then(Running::ended);
            if of as usize == number {
                return ended;
            }
        }
        None
    }

    /// Leaks the SPUs' threads and contexts until the process ends, because libspe2 has no call
    /// that stops an SPU.
    pub fn abandon(&mut self) {
        for spu in self.spus.drain(..) {
            std::mem::forget(spu);
        }
    }
}

impl Drop for Spus {
    fn drop(&mut self) {
        for spu in &mut self.spus {
            let Some(running) = spu.running.take() else {
                continue;
            };
            // Address 0 ends the program. If it can't be mailed, the program would never end.
            if spu.context.mail([0, 0]).is_ok() {
                let _ = running.ended();
            }
        }
    }
}

/// The part of a frame's units that `done` is, at most 1.
fn part(done: u32, frame: &Frame) -> f64 {
    (f64::from(done) / f64::from(frame.unit_count.get().max(1))).min(1.0)
}
