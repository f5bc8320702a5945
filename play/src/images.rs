//! Frames as numbered pictures: those that are wanted and not there yet.
//!
//! Invariants: a frame's picture depends on the game, its seed, the recording, the size and the frame's number
//! alone, not on which of them one run makes; a picture is whole as soon as it has its name.

use std::io;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use cellray::framebuffer::{
    Framebuffer, FramebufferError, Geometry, Interrupted, Memory, NumberedPath, Target, write_png,
};
use cellray::game::{FixedSteps, Game, InputEvent, InputSource, Session, SessionReport};

use crate::arguments::Options;
use crate::error::PlayError;
use crate::frames::FrameRange;
use crate::front::Ending;
use crate::recording;

/// What became of the pictures.
#[derive(Debug)]
pub struct Pictures {
    /// Written.
    pub written: u64,
    /// There already.
    pub kept: u64,
    /// Why it ended.
    pub ending: Ending,
    /// What the frames took.
    pub report: SessionReport,
}

/// Writes the pictures of a range of frames.
pub fn write(
    game: Box<dyn Game>,
    seed: u64,
    options: &Options,
    range: FrameRange,
    paths: &NumberedPath,
    size: Geometry,
) -> Result<Pictures, PlayError> {
    let interrupted = Interrupted::install().map_err(PlayError::Signals)?;
    let number = Arc::new(AtomicU64::new(0));
    let framebuffer = Numbered {
        memory: Memory::new(size)?,
        paths: paths.clone(),
        number: Arc::clone(&number),
    };
    let session = Session::start(game, options.settings()?, Box::new(framebuffer))?
        .with_seed(seed)
        .with_clock(Box::new(FixedSteps(options.step())));
    let replay = options.replay.as_deref();
    let session = recording::connect(session, options.record.as_deref(), replay)?;
    // All of them share one state, and it is asked once more at the end.
    let until = Interrupted::install().map_err(PlayError::Signals)?;
    let mut session = session.with_input(Box::new(UntilSignal(until)));
    let (mut written, mut kept) = (0, 0);
    for frame in 0..range.end {
        number.store(frame, Ordering::SeqCst);
        let is_wanted = frame >= range.first;
        let is_there = is_wanted && paths.of(frame).is_file();
        let before = session.report().frames.frames;
        let flow = if is_wanted && !is_there {
            session.frame()?
        } else {
            session.pass_over()?
        };
        kept += u64::from(is_there);
        written += u64::from(session.report().frames.frames - before);
        if flow.is_break() {
            break;
        }
    }
    let ending = interrupted.signal().map_or(Ending::Over, Ending::Signal);
    Ok(Pictures {
        written,
        kept,
        ending,
        report: session.report().clone(),
    })
}

/// A framebuffer whose frames become pictures of the numbers that they have in the game.
struct Numbered {
    memory: Memory,
    paths: NumberedPath,
    number: Arc<AtomicU64>,
}

impl Framebuffer for Numbered {
    fn geometry(&self) -> Geometry {
        self.memory.geometry()
    }

    fn target(&mut self) -> Target {
        self.memory.target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        let path = self.paths.of(self.number.load(Ordering::SeqCst));
        write_png(&path, &self.memory.rgb())
    }

    fn keeps_contents(&self) -> bool {
        self.memory.keeps_contents()
    }

    fn describe(&self) -> String {
        format!("PNG pictures, {}", self.geometry())
    }
}

/// No input, up to a signal.
struct UntilSignal(Interrupted);

impl InputSource for UntilSignal {
    fn poll(&mut self, _events: &mut Vec<InputEvent>) -> io::Result<ControlFlow<()>> {
        Ok(match self.0.signal() {
            Some(_) => ControlFlow::Break(()),
            None => ControlFlow::Continue(()),
        })
    }
}
