//! The SPUs: started once, mailed every frame.

mod silence;
mod unchecked;

use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use image::RgbImage;
use zerocopy::{FromZeros as _, IntoBytes as _};

pub use self::silence::{Doing, Silence};
use self::silence::{Pause, Watch, part};
pub use self::unchecked::Unchecked;
use crate::framebuffer::{self, Framebuffer, FramebufferError};
use crate::scene::{Scene, SceneError};
use crate::shared::SharedMemory;
use crate::spe::{Context, Ended, Event, Events, Program, ProgramError, SpeError};
use crate::statistics::FrameStatistics;
use crate::work::{self, Addresses, Order, Plan, Policy, Refusal, Size, Skip, Split};
use protocol::formulation::EyeRecord;
use protocol::layout::{
    FEATURE_WHITTED, Frame, MAX_SPHERES, MAX_SPUS, SCENE_ROOM, Sphere, Statistics, UnitCost,
    UnitCounter, WorkUnit,
};

/// Why no frame came.
#[derive(Debug, thiserror::Error)]
pub enum EngineError {
    /// A number of SPUs that the work unit has no room for.
    #[error("{0} SPUs: must be 1 to {MAX_SPUS}")]
    SpuCount(u32),
    /// An SPU program came to an end; no further frame can be traced.
    #[error("SPU {spu} {ended}{unchecked}")]
    Ended {
        /// Number of the SPU.
        spu: u32,
        /// How.
        ended: Ended,
        /// What may be behind it.
        unchecked: Unchecked,
    },
    /// An SPU did not accept the frame.
    #[error("SPU {spu} {refusal}{unchecked}")]
    Refused {
        /// Number of the SPU.
        spu: u32,
        /// What was wrong.
        refusal: Refusal,
        /// What may be behind it.
        unchecked: Unchecked,
    },
    /// An SPU did not answer, and none did anything.
    #[error("SPU {spu} {silence}{unchecked}")]
    Silent {
        /// Number of the first such SPU.
        spu: u32,
        /// What is known of it.
        silence: Silence,
        /// What may be behind it.
        unchecked: Unchecked,
    },
    /// The SPUs' statistics do not add up to the whole picture.
    #[error("the SPUs traced {traced} of {wanted} rays: the picture is not whole{unchecked}")]
    Incomplete {
        /// Rays in the statistics.
        traced: u64,
        /// Pixels of the tiles that were to be traced.
        wanted: u64,
        /// What may be behind it.
        unchecked: Unchecked,
    },
    /// An earlier error has left no SPUs to work with.
    #[error("the SPUs were lost by an earlier error")]
    Lost,
    /// The scene does not suit.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The framebuffer does not show it.
    #[error(transparent)]
    Framebuffer(#[from] FramebufferError),
    /// libspe2 failed.
    #[error(transparent)]
    Spe(#[from] SpeError),
    /// The SPU program is not known well enough.
    #[error(transparent)]
    Program(#[from] ProgramError),
}

/// How an [`Engine`] works.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// SPUs to use.
    pub spus: u32,
    /// How the frame is split among them.
    pub split: Split,
    /// What the SPUs need not test.
    pub skip: Skip,
    /// Whether what the framebuffer already shows is kept and only what has changed is traced. With
    /// [`Skip::Nothing`] every frame is traced as a whole.
    pub retain: bool,
    /// Whether the SPUs check, at each call of a shader, that it keeps what it must.
    pub check_shaders: bool,
    /// How long none of a frame's SPUs may take a work unit, finish one or answer, before they
    /// count as lost.
    pub timeout: Duration,
    /// What they run.
    pub program: Program,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            spus: 6,
            split: Split::default(),
            skip: Skip::default(),
            retain: true,
            check_shaders: false,
            timeout: Duration::from_secs(600),
            program: Program::tracer(),
        }
    }
}

/// How a program takes spheres; one that does not name its formulations takes them as they are.
fn eye_record(program: &Program) -> Result<EyeRecord, ProgramError> {
    match program.formulations() {
        Ok(formulations) => Ok(formulations.eye.record),
        Err(ProgramError::NoFormulations) => Ok(EyeRecord::Centre),
        Err(error) => Err(error),
    }
}

struct Spu {
    context: Arc<Context>,
    thread: Option<JoinHandle<Ended>>,
}

/// What the SPUs reach by address: it must outlive them.
struct Records {
    frame: SharedMemory,
    spheres: SharedMemory,
    scene: SharedMemory,
    unit_counter: SharedMemory,
    statistics: SharedMemory,
    /// Room for as many units as there may be.
    units: SharedMemory,
    costs: SharedMemory,
    framebuffer: Box<dyn Framebuffer>,
}

/// SPUs that wait for frames, and the framebuffer that they write to.
pub struct Engine {
    // Dropped first: it knows the contexts.
    events: Events,
    spus: Vec<Spu>,
    /// `None` once an SPU was lost that may still write there.
    records: Option<Records>,
    settings: Settings,
    record: EyeRecord,
    number: u32,
    pause: Pause,
    plan: Plan,
    /// The SPUs' answers to the last frame, as they lay in memory and as they are given out.
    lines: Vec<Statistics>,
    costs: Vec<UnitCost>,
    statistics: FrameStatistics,
}

impl Engine {
    /// Creates the SPE contexts, loads the program into each and starts it on a thread of its own.
    pub fn start(
        settings: Settings,
        framebuffer: Box<dyn Framebuffer>,
    ) -> Result<Self, EngineError> {
        if !(1..=MAX_SPUS).contains(&settings.spus) {
            return Err(EngineError::SpuCount(settings.spus));
        }
        let most_units = most_units(framebuffer.as_ref());
        let mut engine = Self {
            events: Events::create()?,
            spus: Vec::new(),
            records: Some(Records {
                frame: SharedMemory::new(size_of::<Frame>()),
                spheres: SharedMemory::new(MAX_SPHERES as usize * size_of::<Sphere>()),
                scene: SharedMemory::new(SCENE_ROOM as usize),
                unit_counter: SharedMemory::new(size_of::<UnitCounter>()),
                statistics: SharedMemory::new(MAX_SPUS as usize * size_of::<Statistics>()),
                units: SharedMemory::new(most_units * size_of::<WorkUnit>()),
                costs: SharedMemory::new(most_units * size_of::<UnitCost>()),
                framebuffer,
            }),
            settings,
            record: eye_record(&settings.program)?,
            number: 0,
            pause: Pause::new(),
            plan: Plan::default(),
            lines: vec![Statistics::new_zeroed(); settings.spus as usize],
            costs: Vec::new(),
            statistics: FrameStatistics::default(),
        };
        for number in 0..settings.spus {
            let context = Arc::new(Context::create()?);
            context.load(&settings.program)?;
            engine.events.watch(&context, number)?;
            let runner = Arc::clone(&context);
            let thread = thread::Builder::new()
                .name(format!("spu{number}"))
                .spawn(move || runner.run(number as usize))
                .map_err(|source| SpeError {
                    call: "thread for spe_context_run",
                    source,
                })?;
            engine.spus.push(Spu {
                context,
                thread: Some(thread),
            });
        }
        Ok(engine)
    }

    /// The framebuffer; `None` once an SPU was lost that may still write there.
    pub fn framebuffer(&mut self) -> Option<&mut dyn Framebuffer> {
        // Who asks may draw there.
        self.plan.forget_pages();
        Some(self.records.as_mut()?.framebuffer.as_mut())
    }

    /// The frame that the framebuffer shows, where it can be read back.
    #[must_use]
    pub fn picture(&self) -> Option<RgbImage> {
        self.records.as_ref()?.framebuffer.picture()
    }

    /// Shows frames elsewhere from now on; gives the framebuffer that they were shown on.
    pub fn show_on(
        &mut self,
        framebuffer: Box<dyn Framebuffer>,
    ) -> Result<Box<dyn Framebuffer>, EngineError> {
        let records = self.records.as_mut().ok_or(EngineError::Lost)?;
        self.plan.forget_pages();
        let most_units = most_units(framebuffer.as_ref());
        records.units = SharedMemory::new(most_units * size_of::<WorkUnit>());
        records.costs = SharedMemory::new(most_units * size_of::<UnitCost>());
        Ok(std::mem::replace(&mut records.framebuffer, framebuffer))
    }

    /// What the SPUs said of the last frame.
    #[must_use]
    pub fn statistics(&self) -> &FrameStatistics {
        &self.statistics
    }

    /// Traces a frame into the framebuffer and presents it; what the framebuffer already shows is not
    /// traced again. `progress` is told from time to time which part of the frame is done, 0 to 1.
    pub fn render(
        &mut self,
        scene: &Scene,
        progress: &mut dyn FnMut(f64),
    ) -> Result<&FrameStatistics, EngineError> {
        if let Err(error) = self.trace(scene, progress) {
            self.plan.forget_pages();
            return Err(error);
        }
        Ok(&self.statistics)
    }

    fn trace(&mut self, scene: &Scene, progress: &mut dyn FnMut(f64)) -> Result<(), EngineError> {
        let records = self.records.as_mut().ok_or(EngineError::Lost)?;
        let keeps = records.framebuffer.keeps_contents();
        let target = records.framebuffer.target();
        let geometry = target.geometry;
        let camera = scene.camera(geometry.width, geometry.height)?;
        let Settings {
            spus, split, skip, ..
        } = self.settings;
        let keeps = keeps && skip != Skip::Nothing;
        let policy = Policy {
            spus,
            split,
            skip,
            record: self.record,
            keeps,
            retain: self.settings.retain && keeps,
        };
        self.plan.make(scene, &camera, &target, policy);
        let size = self.plan.size();
        if size.pixels == 0 {
            self.lines.fill(Statistics::new_zeroed());
        } else {
            records.spheres.write(0, self.plan.spheres().bytes());
            if let Some(block) = scene.block() {
                records.scene.write(0, block.bytes());
            }
            records.units.write(0, self.plan.units().bytes());
            // What a unit took is not 0: it shows which ones are finished.
            self.costs
                .resize(self.plan.units().lines().len(), UnitCost::new_zeroed());
            self.costs.fill(UnitCost::new_zeroed());
            records.costs.write(0, self.costs.as_bytes());
            self.number = self.number.wrapping_add(1);
            let frame = work::describe(&Order {
                scene,
                camera: &camera,
                target: &target,
                addresses: Addresses {
                    spheres: records.spheres.address(),
                    scene: records.scene.address(),
                    unit_counter: records.unit_counter.address(),
                    statistics: records.statistics.address(),
                    units: records.units.address(),
                    costs: records.costs.address(),
                },
                sphere_count: self.plan.spheres().records().len() as u32,
                units: self.plan.units(),
                number: self.number,
                spus,
                split,
                skip,
                check_shaders: self.settings.check_shaders,
            });
            // SAFETY: all addresses are those of records that the engine keeps as long as its SPUs
            // run, the target is the framebuffer's own, and sizes and counts are theirs.
            unsafe { self.exchange_frame(&frame, progress)? };
        }
        self.statistics.read(&self.lines, size);
        let traced = self.statistics.eye_rays();
        if traced != size.pixels {
            return Err(EngineError::Incomplete {
                traced,
                wanted: size.pixels,
                unchecked: Unchecked::of(&self.settings, scene.block().is_some()),
            });
        }
        let records = self.records.as_mut().ok_or(EngineError::Lost)?;
        let units = self.plan.units().lines().len();
        self.costs.resize(units, UnitCost::new_zeroed());
        records.costs.read(0, self.costs.as_mut_bytes());
        self.plan.done(geometry, &self.costs);
        records.framebuffer.present()?;
        Ok(())
    }

    /// Sends a descriptor as it is and waits for every SPU's answer. What the framebuffer shows counts
    /// as unknown from then on.
    ///
    /// # Safety
    ///
    /// The SPUs write where the descriptor says: its addresses must be those of memory that nothing
    /// else uses until this returns; after [`EngineError::Silent`], ever.
    pub unsafe fn submit(
        &mut self,
        frame: &Frame,
        progress: &mut dyn FnMut(f64),
    ) -> Result<&FrameStatistics, EngineError> {
        self.plan.forget_pages();
        // SAFETY: the caller's promise.
        unsafe { self.exchange_frame(frame, progress)? };
        self.statistics.read(&self.lines, Size::default());
        Ok(&self.statistics)
    }

    /// [`Engine::submit`], up to the SPUs' statistics lines.
    ///
    /// # Safety
    ///
    /// As there.
    unsafe fn exchange_frame(
        &mut self,
        frame: &Frame,
        progress: &mut dyn FnMut(f64),
    ) -> Result<(), EngineError> {
        let records = self.records.as_mut().ok_or(EngineError::Lost)?;
        self.lines.fill(Statistics::new_zeroed());
        records.frame.write(0, frame.as_bytes());
        records
            .unit_counter
            .write(0, UnitCounter::new_zeroed().as_bytes());
        records.statistics.write(0, self.lines.as_bytes());
        let address = records.frame.address();
        self.mail_watched(address, frame, progress)?;
        let records = self.records.as_ref().ok_or(EngineError::Lost)?;
        records.statistics.read(0, self.lines.as_mut_bytes());
        Ok(())
    }

    /// Mails an address to every SPU as that of `frame`, and waits for the answers.
    ///
    /// # Safety
    ///
    /// As [`Engine::submit`]; and `address` may be one that the SPUs refuse, or that of `frame`.
    pub unsafe fn mail(
        &mut self,
        address: u64,
        frame: &Frame,
        progress: &mut dyn FnMut(f64),
    ) -> Result<(), EngineError> {
        self.plan.forget_pages();
        self.mail_watched(address, frame, progress)
    }

    /// Mails an address to every SPU and waits for the answers; gives the SPUs up if they are lost.
    fn mail_watched(
        &mut self,
        address: u64,
        frame: &Frame,
        progress: &mut dyn FnMut(f64),
    ) -> Result<(), EngineError> {
        let outcome = self.exchange(address, frame, progress);
        // Where libspe2 fails, nobody knows what the SPUs are doing.
        if let Err(EngineError::Silent { .. } | EngineError::Spe(_)) = outcome {
            self.abandon();
        }
        outcome
    }

    /// The mails of a frame, and the answers to them.
    fn exchange(
        &mut self,
        address: u64,
        frame: &Frame,
        progress: &mut dyn FnMut(f64),
    ) -> Result<(), EngineError> {
        if self.records.is_none() || self.spus.iter().any(|spu| spu.thread.is_none()) {
            return Err(EngineError::Lost);
        }
        for spu in &self.spus {
            spu.context.mail([(address >> 32) as u32, address as u32])?;
        }
        let settings = self.settings;
        let is_whitted = frame.features.get() & FEATURE_WHITTED != 0;
        let unchecked = || Unchecked::of(&settings, is_whitted);
        let mut watch = Watch::start(self.settings.timeout);
        let mut waiting = [false; MAX_SPUS as usize];
        waiting[..self.spus.len()].fill(true);
        let mut first_error = None;
        // All SPUs are waited for, also after an error: they write to the frame's memory until then.
        while let Some(slowest) = waiting.iter().position(|waiting| *waiting) {
            let left = watch.left();
            if left.is_zero() {
                let silence = self.silence(slowest, frame);
                let (spu, unchecked) = (slowest as u32, unchecked());
                return Err(EngineError::Silent {
                    spu,
                    silence,
                    unchecked,
                });
            }
            let began = Instant::now();
            let Some((number, event)) = self.events.wait(self.pause.length(left))? else {
                self.pause.slept(began.elapsed());
                let (taken, finished) = self.units_done(frame);
                watch.saw(u64::from(taken) + u64::from(finished));
                progress(part(taken.max(finished), frame));
                continue;
            };
            watch.heard();
            let spu = &mut self.spus[number as usize];
            let error = match event {
                Event::Answer => {
                    let Some(answer) = spu.context.answer()? else {
                        continue;
                    };
                    // Looked up for what was refused alone: it takes memory. An image without the table
                    // has no names either.
                    let shaders = match answer {
                        0 => Vec::new(),
                        _ => self.settings.program.shaders().unwrap_or_default(),
                    };
                    Refusal::of(answer, frame, address, &shaders).map(|refusal| {
                        let unchecked = match refusal.names_shader() {
                            true => Unchecked::default(),
                            false => unchecked(),
                        };
                        EngineError::Refused {
                            spu: number,
                            refusal,
                            unchecked,
                        }
                    })
                }
                Event::Stopped => {
                    spu.context.take_stop_record()?;
                    // The thread is on its way out: libspe2 wrote the record just before.
                    let ended = spu.thread.take().and_then(|thread| thread.join().ok());
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

    /// Gives up the SPUs. libspe2 has no call that stops one: its thread, its context
    /// and all memory that it may still write to are left to the end of the process. The screen is
    /// given back now: whoever would do it is left, too.
    fn abandon(&mut self) {
        framebuffer::put_back();
        std::mem::forget(self.records.take());
        for spu in self.spus.drain(..) {
            std::mem::forget(spu);
        }
    }
}

/// Most units that a picture there is cut into: of one tile each.
fn most_units(framebuffer: &dyn Framebuffer) -> usize {
    work::tile_count(framebuffer.geometry()) as usize
}

impl Drop for Engine {
    fn drop(&mut self) {
        for spu in &mut self.spus {
            let Some(thread) = spu.thread.take() else {
                continue;
            };
            // Address 0 ends the program. If it can't be mailed, waiting would be for ever.
            if spu.context.mail([0, 0]).is_ok() {
                let _ = thread.join();
            }
        }
    }
}
