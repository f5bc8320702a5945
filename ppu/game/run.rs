//! The frame loop: input, game, world, SPUs, picture, and again from the start.
//!
//! Owns the [`Session`] of a game. Each step takes events and a time and makes a frame. The caller
//! owns the display, the devices and the clock. Invariant: the game is called once a frame, in the
//! thread that steps the session, which then sleeps while the SPUs trace. The time and the events
//! that a game receives come from that step or from a recording, and from nowhere else.

mod clock;
mod error;
mod frames;
mod merge;
mod pictures;
mod recording;
mod source;

pub use clock::{Clock, FixedSteps, RealTime};
pub use error::SessionError;
pub use frames::{FrameRange, FrameRangeError};
pub use pictures::{Made, Pictures};
pub use recording::{Recording, RecordingError};
pub use source::{InputSource, NoInput};

use std::io::Write;
use std::ops::ControlFlow;
use std::time::Duration;

use image::RgbImage;

use self::recording::{FrameRecord, Header, Recorder};
use super::{Frame, Game, Input, InputEvent, PlacedLabel, Start, World};
use crate::engine::{Engine, EngineError, Settings};
use crate::framebuffer::{Framebuffer, Geometry};
use crate::report::{LoopTime, Report};
use crate::scene::Look;
use crate::spe::{Program, ProgramError};

/// A game, its world and the SPUs that trace it.
///
/// ```
/// use std::time::Duration;
///
/// use cellray::Settings;
/// use cellray::framebuffer::{Geometry, Memory};
/// use cellray::game::{
///     DVec3, Game, InputEvent, Key, Material, Frame, ObjectId, Session, Start, World,
///     WorldError,
/// };
///
/// /// A ball that rests until somebody presses the space bar.
/// struct Still(ObjectId);
///
/// impl Game for Still {
///     fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
///         let red = world.add_material(Material::matte(0.9, 0.2, 0.1))?;
///         self.0 = world.add_sphere(DVec3::ZERO, 1.0, red)?;
///         Ok(())
///     }
///     fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
///         match frame.input.key_pressed(Key::Space) {
///             true => world.move_to(self.0, DVec3::Y),
///             false => Ok(()),
///         }
///     }
/// }
///
/// let picture = Memory::new(Geometry::new(32, 16)?)?;
/// let still = Still(ObjectId::default());
/// let mut session = Session::start(still, Settings::default(), Box::new(picture))?;
/// let step = Duration::from_millis(40);
/// for _ in 0..3 {
///     session.step(step, &mut Vec::new(), &mut |_| ())?;
/// }
/// // A world that stands still is traced once.
/// assert_eq!(session.report().frames_traced, 1);
///
/// let before = session.picture();
/// let space = InputEvent::Key { key: Key::Space, down: true };
/// session.step(step, &mut vec![space], &mut |_| ())?;
/// assert!(session.picture() != before);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Session<G> {
    game: G,
    world: World,
    look: Option<Look>,
    engine: Engine,
    settings: Settings,
    /// The width and height in pixels that the game receives.
    size: (u32, u32),
    start: Option<Start>,
    seed: u64,
    recorder: Option<Recorder>,
    replay: Option<Recording>,
    input: Input,
    /// The current frame; its buffers are reused for the next.
    record: FrameRecord,
    /// Whether `record` was read from the recording that is played back, and is not yet stepped.
    is_read: bool,
    /// Buffer for the events that a source of input appends.
    events: Vec<InputEvent>,
    /// When the current frame began, if [`Session::wait`] was called for it.
    began: Option<LoopTime>,
    frame: u64,
    time: Duration,
    report: Report,
}

impl<G: Game> Session<G> {
    /// Starts the SPUs, with the game's own program if it has one. The game is set up at the first
    /// frame.
    ///
    /// # Errors
    /// - The game's own SPU program is not valid.
    /// - The engine does not start; see [`Engine::start`].
    pub fn start(
        game: G,
        mut settings: Settings,
        framebuffer: Box<dyn Framebuffer>,
    ) -> Result<Self, SessionError> {
        if let Some(program) = game.program()? {
            settings.program = program;
        }
        let geometry = framebuffer.geometry();
        let size = (geometry.width, geometry.height);
        // The engine also refuses a number of SPUs that exceeds the capacity of a report.
        let engine = Engine::start(settings, framebuffer)?;
        let report = Report::new(game.name(), size, settings.spus);
        Ok(Self {
            engine,
            game,
            world: World::new(),
            look: None,
            settings,
            size,
            start: None,
            seed: 0,
            recorder: None,
            replay: None,
            input: Input::default(),
            record: FrameRecord::default(),
            is_read: false,
            events: Vec::new(),
            began: None,
            frame: 0,
            time: Duration::ZERO,
            report,
        })
    }

    /// Sets the random seed, which is 0 otherwise.
    #[must_use]
    pub fn with_seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// Records the session from its first frame on.
    #[must_use]
    pub fn record_to(self, writer: Box<dyn Write>) -> Self {
        Self { recorder: Some(Recorder::new(writer)), ..self }
    }

    /// Plays a recording back. The game receives the recorded seed, sizes, times and events,
    /// whatever the steps' own are, and the session ends after the last recorded frame. The
    /// framebuffer may have another size; the game receives the recorded one.
    ///
    /// # Errors
    /// The recording is of another game.
    pub fn replaying(self, recording: Recording) -> Result<Self, SessionError> {
        let (recorded, name) = (recording.game(), self.game.name());
        if recorded != name {
            return Err(SessionError::OtherGame {
                recorded: recorded.to_owned(),
                game: name.to_owned(),
            });
        }
        Ok(Self { replay: Some(recording), ..self })
    }

    /// Runs with a clock and a source of input, and [finishes](Session::finish). Ends when the game
    /// is over, when the input or the recording ends, or after `frames` frames.
    ///
    /// # Errors
    /// As for [`Session::frame`] and [`Session::finish`].
    pub fn run(
        &mut self,
        frames: Option<u64>,
        clock: &mut dyn Clock,
        source: &mut dyn InputSource,
    ) -> Result<&Report, SessionError> {
        let mut left = frames;
        while left != Some(0) {
            if self.frame(clock, source)?.is_break() {
                break;
            }
            left = left.map(|left| left - 1);
        }
        self.finish()?;
        Ok(&self.report)
    }

    /// Writes the rest of the recording, if the session is recorded. Call it after the last frame:
    /// dropping the session writes the rest too, but reports no error. The session may go on
    /// afterwards.
    ///
    /// # Errors
    /// The recording can't be written.
    pub fn finish(&mut self) -> Result<(), SessionError> {
        match &mut self.recorder {
            Some(recorder) => Ok(recorder.finish(&self.world)?),
            None => Ok(()),
        }
    }

    /// Makes one frame with a clock and a source of input. [`ControlFlow::Break`] means that the
    /// session is over; then call [`Session::finish`].
    ///
    /// # Errors
    /// An input device fails, or any error of [`Session::step`].
    pub fn frame(
        &mut self,
        clock: &mut dyn Clock,
        source: &mut dyn InputSource,
    ) -> Result<ControlFlow<()>, SessionError> {
        let Some(step) = self.wait(clock)? else {
            return Ok(ControlFlow::Break(()));
        };
        let mut events = std::mem::take(&mut self.events);
        let polled = source.poll(&mut events).map_err(SessionError::Input)?;
        let flow = match polled {
            ControlFlow::Continue(()) => {
                self.step(step, &mut events, &mut |part| source.tracing(part))
            }
            over => Ok(over),
        };
        self.events = events;
        flow
    }

    /// Waits until it is time for the next frame, and returns the time since the last one. When a
    /// recording is played back, that time is the recorded one, and after its last frame the result
    /// is `None`.
    ///
    /// # Errors
    /// - The game's [`Game::set_up`] fails, if this is the first frame.
    /// - The recording can't be read or written.
    pub fn wait(&mut self, clock: &mut dyn Clock) -> Result<Option<Duration>, SessionError> {
        self.began = Some(LoopTime::now());
        self.set_up()?;
        if self.replay.is_none() {
            return Ok(Some(clock.tick()));
        }
        if !self.read_recorded()? {
            return Ok(None);
        }
        clock.pace(self.record.step());
        Ok(Some(self.record.step()))
    }

    /// Makes one frame: the game updates the world, which is then traced and shown.
    ///
    /// `step` is the time since the last frame. `events` are the events since then, and are taken
    /// out of the vector. `tracing` is called from time to time while the SPUs trace, with the part
    /// of the frame that is done, 0 to 1.
    ///
    /// [`ControlFlow::Break`] means that the session is over. If it is over because a recording has
    /// no more frames, this step made none.
    ///
    /// # Errors
    /// - The game fails, or its world can't be traced.
    /// - The engine fails; see [`Engine::render`].
    /// - A recording can't be read or written, or its world differs from this one.
    pub fn step(
        &mut self,
        step: Duration,
        events: &mut Vec<InputEvent>,
        tracing: &mut dyn FnMut(f64),
    ) -> Result<ControlFlow<()>, SessionError> {
        let began = self.began.take().unwrap_or_else(LoopTime::now);
        let flow = self.traced_step(step, events, tracing);
        self.report.add_time_since(began);
        flow
    }

    /// [`Session::step`] without a picture: the game is called, but nothing is traced or shown.
    /// With it a sequence of pictures can begin in the middle of a game.
    ///
    /// # Errors
    /// The game fails, or a recording can't be read or written, or its world differs from this one.
    pub fn skip_frame(
        &mut self,
        step: Duration,
        events: &mut Vec<InputEvent>,
    ) -> Result<ControlFlow<()>, SessionError> {
        self.began = None;
        Ok(match self.play(step, events)? {
            ControlFlow::Continue(()) => self.end_frame(),
            over => over,
        })
    }

    /// Sets how the world is looked at, from the next frame on. The game does not notice, and its
    /// [`RenderOptions`](crate::scene::RenderOptions) stay as they are; with `None` they count.
    pub fn set_look(&mut self, look: Option<Look>) {
        self.look = look;
    }

    fn traced_step(
        &mut self,
        step: Duration,
        events: &mut Vec<InputEvent>,
        tracing: &mut dyn FnMut(f64),
    ) -> Result<ControlFlow<()>, SessionError> {
        if self.play(step, events)?.is_break() {
            return Ok(ControlFlow::Break(()));
        }
        self.trace(tracing)?;
        Ok(self.end_frame())
    }

    /// Traces the last step's world again, which the game does not notice: after
    /// [`Session::show_on`], or if the frame was put off ([`Engine::limit_tiles`]).
    ///
    /// # Errors
    /// The world can't be traced, or the engine fails.
    pub fn redraw(&mut self, tracing: &mut dyn FnMut(f64)) -> Result<(), SessionError> {
        let began = LoopTime::now();
        let traced = self.trace(tracing);
        self.report.add_time_since(began);
        traced
    }

    fn trace(&mut self, tracing: &mut dyn FnMut(f64)) -> Result<(), SessionError> {
        // A game may put another world in place of this one.
        self.world.set_look(self.look);
        let scene = self.world.scene(&self.settings.program)?;
        let statistics = self.engine.render(scene, tracing)?;
        if !statistics.is_put_off {
            self.report.add(statistics);
        }
        Ok(())
    }

    fn end_frame(&mut self) -> ControlFlow<()> {
        self.frame += 1;
        if self.game.is_over() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Takes the frame's input and lets the game update the world.
    fn play(
        &mut self,
        step: Duration,
        events: &mut Vec<InputEvent>,
    ) -> Result<ControlFlow<()>, SessionError> {
        self.set_up()?;
        if self.replay.is_some() {
            events.clear();
            if !self.read_recorded()? {
                return Ok(ControlFlow::Break(()));
            }
            self.is_read = false;
        } else {
            self.begin_frame(step, events);
        }
        self.input.begin_frame();
        for event in &self.record.events {
            self.input.apply(event);
        }
        let step = self.record.step();
        self.time += step;
        let last = (self.frame > 0).then(|| self.engine.statistics());
        let frame = Frame {
            number: self.frame,
            time: self.time.as_secs_f64(),
            delta: step.as_secs_f64(),
            input: &self.input,
            size: self.record.size.unwrap_or(self.size),
            last,
        };
        self.game.update(&mut self.world, &frame)?;
        self.check_and_record()?;
        Ok(ControlFlow::Continue(()))
    }

    /// Lets the game set up its world, unless it has done so.
    fn set_up(&mut self) -> Result<(), SessionError> {
        if self.start.is_some() {
            return Ok(());
        }
        let replayed = self.replay.as_ref().map(Recording::start);
        let start = replayed.unwrap_or(Start { seed: self.seed, size: self.size });
        self.game.set_up(&mut self.world, &start)?;
        if let Some(recorder) = &mut self.recorder {
            recorder.begin(&Header::new(self.game.name(), start))?;
        }
        self.start = Some(start);
        Ok(())
    }

    /// Makes the recording's next frame the current one; `false` if it has no more.
    fn read_recorded(&mut self) -> Result<bool, SessionError> {
        if let Some(recording) = self.replay.as_mut().filter(|_| !self.is_read) {
            self.is_read = recording.next_frame(&mut self.record)?;
        }
        Ok(self.is_read)
    }

    /// Fills the current frame with the events since the last one.
    fn begin_frame(&mut self, step: Duration, events: &mut Vec<InputEvent>) {
        let record = &mut self.record;
        record.clear();
        record.events.append(events);
        // The input ignores numbers that aren't finite, and JSON can't represent them.
        record.events.retain(InputEvent::is_finite);
        merge::merge(&mut record.events);
        record.set_step(if self.frame == 0 { Duration::ZERO } else { step });
        record.size = Some(self.size);
    }

    /// Compares the world with the recorded one, and records the frame if the session is recorded.
    fn check_and_record(&mut self) -> Result<(), SessionError> {
        if let Some(expected) = self.record.world.filter(|_| self.replay.is_some())
            && self.world.checksum() != expected.0
        {
            return Err(SessionError::Diverged { frame: self.frame });
        }
        if let Some(recorder) = &mut self.recorder {
            recorder.frame(self.frame, &mut self.record, &self.world)?;
        }
        Ok(())
    }

    /// Shows the game on another framebuffer from now on, for example one of another size, which
    /// the game receives. Returns the previous framebuffer.
    ///
    /// # Errors
    /// As for [`Engine::show_on`]; the previous framebuffer then stays.
    pub fn show_on(
        &mut self,
        framebuffer: Box<dyn Framebuffer>,
    ) -> Result<Box<dyn Framebuffer>, EngineError> {
        let geometry = framebuffer.geometry();
        let before = self.engine.show_on(framebuffer)?;
        self.size = (geometry.width, geometry.height);
        Ok(before)
    }

    /// Passes the game another width and height than the framebuffer's, from the next frame on
    /// until the framebuffer is changed. It is the size of the player's display, in whose pixels
    /// the mouse moves, if the picture is traced at a lower resolution.
    pub fn set_input_size(&mut self, geometry: Geometry) {
        self.size = (geometry.width, geometry.height);
    }

    /// The frame that is shown, or `None` if the framebuffer can't be read back.
    #[must_use]
    pub fn picture(&self) -> Option<RgbImage> {
        self.engine.picture()
    }

    /// The number of the next frame, from 0.
    #[must_use]
    pub fn next_frame(&self) -> u64 {
        self.frame
    }

    /// The statistics of all frames so far.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// The game.
    #[must_use]
    pub fn game(&self) -> &G {
        &self.game
    }

    /// The world, for example for a camera that the player moves independently of the game.
    ///
    /// Changes that are made here are not recorded. A recording that is made meanwhile fails to
    /// play back, because its world then differs.
    pub fn world(&mut self) -> &mut World {
        &mut self.world
    }

    /// The game's labels that are in the last frame's picture.
    #[must_use]
    pub fn labels(&self) -> Vec<PlacedLabel> {
        let input_size = self.record.size.unwrap_or(self.size);
        let labels = self.game.labels().into_iter();
        let placed = labels.map(|label| label.placed(&self.world, input_size, self.size));
        placed.flatten().collect()
    }

    /// The input of the current frame.
    #[must_use]
    pub fn input(&self) -> &Input {
        &self.input
    }

    /// The SPUs and their framebuffer.
    pub fn engine(&mut self) -> &mut Engine {
        &mut self.engine
    }
}

impl<G: Game + ?Sized> Game for Box<G> {
    fn name(&self) -> &str {
        (**self).name()
    }

    fn program(&self) -> Result<Option<Program>, ProgramError> {
        (**self).program()
    }

    fn set_up(&mut self, world: &mut World, start: &Start) -> Result<(), super::WorldError> {
        (**self).set_up(world, start)
    }

    fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), super::WorldError> {
        (**self).update(world, frame)
    }

    fn controls(&self) -> &[&str] {
        (**self).controls()
    }

    fn status(&self) -> String {
        (**self).status()
    }

    fn labels(&self) -> Vec<super::Label> {
        (**self).labels()
    }

    fn is_over(&self) -> bool {
        (**self).is_over()
    }
}
