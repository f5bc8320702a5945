//! The engine starts the SPUs once, and mails every frame to them.

mod build;
mod error;
mod records;
mod settings;
mod silence;
mod sort;
mod spus;
mod traced;
mod unchecked;

use image::RgbImage;
use zerocopy::FromZeros as _;

pub use self::error::EngineError;
use self::records::Records;
pub use self::settings::Settings;
pub use self::silence::{Activity, Silence};
use self::spus::Spus;
pub use self::traced::{TracedTile, TracedUnits};
pub use self::unchecked::Unchecked;
use crate::framebuffer::Framebuffer;
use crate::scene::Scene;
use crate::spe::{Program, ProgramError};
use crate::statistics::FrameStatistics;
use crate::work::{self, Order, Plan, Policy, Size, Skip};
use protocol::formulation::EyeRecord;
use protocol::layout::{Frame, MAX_SPUS, Statistics, UnitCost};

/// The form of spheres that a program expects: their centres, if it doesn't name its formulations.
fn eye_record(program: &Program) -> Result<EyeRecord, ProgramError> {
    match program.formulations() {
        Ok(formulations) => Ok(formulations.eye.record),
        Err(ProgramError::NoFormulations) => Ok(EyeRecord::Centre),
        Err(error) => Err(error),
    }
}

/// SPUs that wait for frames, and the framebuffer that they write to.
pub struct Engine {
    // Dropped first: they may still write to the records.
    spus: Spus,
    /// `None` after an SPU was lost, because it may still write there.
    records: Option<Records>,
    settings: Settings,
    record: EyeRecord,
    number: u32,
    plan: Plan,
    /// The largest number of tiles of a frame, if it is limited.
    most_tiles: Option<u32>,
    /// The SPUs' replies to the last frame, in their format; `statistics` has them in the
    /// caller's.
    lines: Vec<Statistics>,
    costs: Vec<UnitCost>,
    statistics: FrameStatistics,
}

impl Engine {
    /// Creates the SPE contexts, loads the program into each and starts it on a thread of its own.
    ///
    /// # Errors
    /// - The number of SPUs is 0, or above [`MAX_SPUS`].
    /// - The program's table of formulations is damaged.
    /// - libspe2 or the system fails.
    pub fn start(
        settings: Settings,
        framebuffer: Box<dyn Framebuffer>,
    ) -> Result<Self, EngineError> {
        if !(1..=MAX_SPUS).contains(&settings.spus) {
            return Err(EngineError::SpuCount(settings.spus));
        }
        let record = eye_record(&settings.program)?;
        Ok(Self {
            spus: Spus::start(&settings)?,
            records: Some(Records::new(framebuffer, &settings.program)),
            settings,
            record,
            number: 0,
            plan: Plan::default(),
            most_tiles: None,
            lines: vec![Statistics::new_zeroed(); settings.spus as usize],
            costs: Vec::new(),
            statistics: FrameStatistics::default(),
        })
    }

    /// The framebuffer; `None` after an SPU was lost, because it may still write there.
    ///
    /// The next frame is traced completely, because the caller may draw.
    pub fn framebuffer(&mut self) -> Option<&mut dyn Framebuffer> {
        // The caller may draw there.
        self.plan.forget_pages();
        Some(self.records.as_mut()?.framebuffer.as_mut())
    }

    /// The frame that the framebuffer shows, or `None` if it can't be read back.
    #[must_use]
    pub fn picture(&self) -> Option<RgbImage> {
        self.records.as_ref()?.framebuffer.picture()
    }

    /// The blocks of the last frame's mesh that the SPUs have refitted or built; `None` if they
    /// have not.
    #[must_use]
    pub fn made_blocks(&self) -> Option<Vec<u8>> {
        self.records.as_ref()?.made_blocks()
    }

    /// Shows frames on another framebuffer from now on, and returns the previous one.
    ///
    /// # Errors
    /// The SPUs were lost by an earlier error.
    pub fn show_on(
        &mut self,
        framebuffer: Box<dyn Framebuffer>,
    ) -> Result<Box<dyn Framebuffer>, EngineError> {
        let records = self.records.as_mut().ok_or(EngineError::Lost)?;
        self.plan.forget_pages();
        Ok(records.show_on(framebuffer))
    }

    /// From now on each frame traces at most this many tiles, or all again with `None`. A picture
    /// is then made by several frames: the framebuffer keeps what it shows in the tiles that are
    /// left, and the next frames trace them. They are taken from all over the picture, so frames
    /// with the same number of tiles take about the same time.
    ///
    /// If anything moves that the framebuffer shows, the frame is put off: nothing is traced. The
    /// picture is begun anew by the next frame. Has no effect where tiles are not retained.
    pub fn limit_tiles(&mut self, most: Option<u32>) {
        self.most_tiles = most;
    }

    /// The SPUs' statistics of the last frame.
    #[must_use]
    pub fn statistics(&self) -> &FrameStatistics {
        &self.statistics
    }

    /// Traces a frame into the framebuffer and presents it. Tiles that the framebuffer already
    /// shows are not traced again. `progress` is called from time to time with the part of the
    /// frame that is done, 0 to 1.
    ///
    /// # Errors
    /// - The camera can't be made for the framebuffer's size.
    /// - An SPU refuses the frame, ends, or doesn't reply; see [`EngineError`].
    /// - The framebuffer can't present the frame.
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
        let Settings { spus, split, skip, .. } = self.settings;
        let keeps = keeps && skip != Skip::Nothing;
        let policy = Policy {
            spus,
            split,
            skip,
            record: self.record,
            keeps,
            retain: self.settings.retain && keeps,
            most_tiles: self.most_tiles,
        };
        self.plan.make(scene, &camera, &target, policy);
        let size = self.plan.size();
        let mut refit = 0;
        if size.pixels == 0 {
            self.lines.fill(Statistics::new_zeroed());
        } else {
            self.number = self.number.wrapping_add(1);
            while let Some(frame) = self
                .records
                .as_mut()
                .and_then(|records| records.make_mesh(scene, self.number, spus))
            {
                // SAFETY: its addresses are those of records, of blocks and of vertices that
                // `records` keeps as long as the SPUs run, and the counts match them.
                unsafe { self.exchange_frame(&frame, &mut |_| ())? };
                let times = self.lines.iter().map(|line| line.busy.get() + line.dma_wait.get());
                refit += times.max().unwrap_or(0);
                self.records.as_mut().ok_or(EngineError::Lost)?.mesh_is_made(scene);
            }
            let records = self.records.as_mut().ok_or(EngineError::Lost)?;
            records.write(scene, &self.plan, &mut self.costs);
            let frame = work::describe(&Order {
                scene,
                camera: &camera,
                target: &target,
                addresses: records.addresses(),
                sphere_count: self.plan.spheres().records().len() as u32,
                units: self.plan.units(),
                cuts: self.plan.cuts(),
                change_count: self.plan.changes().len() as u32,
                number: self.number,
                spus,
                split,
                skip,
                check_shaders: self.settings.check_shaders,
            });
            // SAFETY: all addresses are those of records that the engine keeps as long as its SPUs
            // run; the target is the framebuffer's; and the sizes and counts match them.
            unsafe { self.exchange_frame(&frame, progress)? };
        }
        self.statistics.read(&self.lines, size);
        self.statistics.refit = refit;
        let traced = self.statistics.primary_rays() + self.statistics.pixels_kept();
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
        records.read_costs(&mut self.costs);
        self.plan.done(geometry, &self.costs);
        records.framebuffer.present()?;
        Ok(())
    }

    /// Sends a frame's record unchanged, and waits for every SPU's reply. Afterwards the contents
    /// of the framebuffer count as unknown.
    ///
    /// # Errors
    /// An SPU refuses the frame, ends, or doesn't reply.
    ///
    /// # Safety
    ///
    /// The SPUs write to the addresses in the record. They must be those of memory that nothing
    /// else uses until this returns; after [`EngineError::Silent`], nothing else may use it ever
    /// again.
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

    /// Does what [`Engine::submit`] does, up to reading the SPUs' statistics lines.
    ///
    /// # Safety
    ///
    /// As for [`Engine::submit`].
    unsafe fn exchange_frame(
        &mut self,
        frame: &Frame,
        progress: &mut dyn FnMut(f64),
    ) -> Result<(), EngineError> {
        let records = self.records.as_mut().ok_or(EngineError::Lost)?;
        self.lines.fill(Statistics::new_zeroed());
        let address = records.write_frame(frame, &self.lines);
        self.mail_watched(address, frame, progress)?;
        let records = self.records.as_ref().ok_or(EngineError::Lost)?;
        records.read_statistics(&mut self.lines);
        Ok(())
    }

    /// Mails `address` to every SPU as the address of `frame`, and waits for the replies.
    ///
    /// # Errors
    /// An SPU refuses the frame, ends, or doesn't reply.
    ///
    /// # Safety
    ///
    /// As for [`Engine::submit`]. In addition, `address` must be that of `frame`, or one that the
    /// SPUs refuse.
    pub unsafe fn mail(
        &mut self,
        address: u64,
        frame: &Frame,
        progress: &mut dyn FnMut(f64),
    ) -> Result<(), EngineError> {
        self.plan.forget_pages();
        self.mail_watched(address, frame, progress)
    }

    /// Mails an address to every SPU and waits for the replies. Abandons the SPUs if they are
    /// lost.
    fn mail_watched(
        &mut self,
        address: u64,
        frame: &Frame,
        progress: &mut dyn FnMut(f64),
    ) -> Result<(), EngineError> {
        let records = self.records.as_ref().ok_or(EngineError::Lost)?;
        let spus = &mut self.spus;
        let outcome = spus.exchange(address, frame, records, &self.settings, progress);
        // After libspe2 has failed, the state of the SPUs is unknown.
        if let Err(EngineError::Silent { .. } | EngineError::Spe(_)) = outcome {
            self.abandon();
        }
        outcome
    }

    /// Abandons the SPUs, and leaks all memory that they may still write to. The screen is
    /// restored now, because the framebuffer that would restore it later is leaked too.
    fn abandon(&mut self) {
        #[cfg(unix)]
        crate::framebuffer::restore_screen();
        std::mem::forget(self.records.take());
        self.spus.abandon();
    }
}
