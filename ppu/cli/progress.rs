//! How far a long frame is, on standard error; short ones pass in silence.

use std::io::{IsTerminal as _, Write as _};
use std::time::{Duration, Instant};

/// Work shorter than this is not reported on.
const PATIENCE: Duration = Duration::from_secs(2);
/// Between two lines where the output is no terminal.
const LINE_EVERY: Duration = Duration::from_secs(10);

/// Progress of a run.
pub struct Progress {
    start: Instant,
    shown: Option<Instant>,
    terminal: bool,
}

impl Progress {
    /// Begins to count time.
    pub fn start() -> Self {
        Self {
            start: Instant::now(),
            shown: None,
            terminal: std::io::stderr().is_terminal(),
        }
    }

    /// Says that `part` of a frame, 0 to 1, is done.
    pub fn show(&mut self, frame: usize, part: f64) {
        let pause = if self.terminal {
            Duration::ZERO
        } else {
            LINE_EVERY
        };
        if self.start.elapsed() < PATIENCE || self.shown.is_some_and(|last| last.elapsed() < pause)
        {
            return;
        }
        self.shown = Some(Instant::now());
        let text = format!("cellray: frame {frame}: {:.0} %", part * 100.0);
        if self.terminal {
            eprint!("\r{text}  ");
            // Progress that can't be shown is no reason to stop.
            let _ = std::io::stderr().flush();
        } else {
            eprintln!("{text}");
        }
    }

    /// Leaves the line.
    pub fn end(&mut self) {
        if self.terminal && self.shown.is_some() {
            eprintln!();
        }
    }
}
