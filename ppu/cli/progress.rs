//! Shows the progress of long frames on standard error.

use std::io::IsTerminal as _;
use std::time::{Duration, Instant};

/// No progress is shown for frames that take less time than this.
const PATIENCE: Duration = Duration::from_secs(2);
/// Time between two lines if standard error isn't a terminal.
const LINE_EVERY: Duration = Duration::from_secs(10);

/// Progress of a run.
pub struct Progress {
    start: Instant,
    shown: Option<Instant>,
    terminal: bool,
}

impl Progress {
    /// Starts the clock.
    pub fn start() -> Self {
        Self { start: Instant::now(), shown: None, terminal: std::io::stderr().is_terminal() }
    }

    /// Shows that `part` of a frame, 0 to 1, is done.
    pub fn show(&mut self, frame: usize, part: f64) {
        let pause = if self.terminal { Duration::ZERO } else { LINE_EVERY };
        if self.start.elapsed() < PATIENCE || self.shown.is_some_and(|last| last.elapsed() < pause)
        {
            return;
        }
        self.shown = Some(Instant::now());
        let text = format!("cellray: frame {frame}: {:.0} %", part * 100.0);
        if self.terminal {
            messages::progress(&format!("\r{text}  "));
        } else {
            messages::print!("{text}");
        }
    }

    /// Ends the progress line.
    pub fn end(&mut self) {
        if self.terminal && self.shown.is_some() {
            messages::progress("\n");
        }
    }
}
