//! How finely a picture is traced, by how long its frames take.
//!
//! Invariants: the divisor is from 1 to [`COARSEST`]; it never becomes smaller within [`REST`]
//! frames of another change; a change is foreseen not to be taken back at the same load.

use std::time::Duration;

/// Largest divisor of the display's width and height.
pub const COARSEST: u32 = 8;
/// A frame that takes longer makes the picture coarser.
const TOO_LONG: f64 = 1.0 / 20.0;
/// A finer picture has to be foreseen to take less: well under [`TOO_LONG`].
const SHORT: f64 = 1.0 / 30.0;
/// A picture that stands still may take so long to be made finer: it is traced once.
const STILL: f64 = 0.4;
/// Frames without anything to trace, after which it counts as standing still.
const STILL_FRAMES: u32 = 15;
/// Frames between a change and one that makes the picture finer.
const REST: u32 = 8;
/// Part that a frame has in the mean.
const WEIGHT: f64 = 0.25;

/// Chooses the divisor.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    divisor: u32,
    /// Mean seconds of a traced frame at this divisor.
    seconds: Option<f64>,
    /// Frames since the last change.
    rested: u32,
    /// Frames since something was traced.
    still: u32,
}

impl Pace {
    /// Begins in the middle, so that the first frame is not the slowest of all.
    #[must_use]
    pub fn new() -> Self {
        Self {
            divisor: COARSEST / 2,
            seconds: None,
            rested: 0,
            still: 0,
        }
    }

    /// By what the display's width and height are divided.
    #[must_use]
    pub fn divisor(&self) -> u32 {
        self.divisor
    }

    /// Takes the time of a frame, `None` where nothing was traced; whether the divisor is another
    /// now.
    pub fn frame(&mut self, took: Option<Duration>) -> bool {
        self.rested += 1;
        match took {
            Some(took) => {
                let took = took.as_secs_f64();
                let mean = |mean: f64| mean + WEIGHT * (took - mean);
                self.seconds = Some(self.seconds.map_or(took, mean));
                // The first frame after a change is traced because of it, if for nothing else.
                if self.rested > 1 {
                    self.still = 0;
                }
            }
            None => self.still += 1,
        }
        let Some(seconds) = self.seconds else {
            return false;
        };
        let next = self.next(seconds);
        let changes = next != self.divisor;
        if changes {
            self.seconds = Some(foreseen(seconds, self.divisor, next));
            self.divisor = next;
            self.rested = 0;
        }
        changes
    }

    fn next(&self, seconds: f64) -> u32 {
        let allowed = if self.still >= STILL_FRAMES {
            STILL
        } else {
            SHORT
        };
        let finer = self.divisor.saturating_sub(1).max(1);
        if self.still == 0 && self.rested > 1 && seconds > TOO_LONG {
            // At once as coarse as it needs to be.
            (self.divisor + 1..COARSEST)
                .find(|&coarser| foreseen(seconds, self.divisor, coarser) < TOO_LONG)
                .unwrap_or(COARSEST)
        } else if self.rested >= REST && foreseen(seconds, self.divisor, finer) < allowed {
            finer
        } else {
            self.divisor
        }
    }
}

impl Default for Pace {
    fn default() -> Self {
        Self::new()
    }
}

/// Seconds at another divisor: rays are what takes time.
fn foreseen(seconds: f64, from: u32, to: u32) -> f64 {
    seconds * (f64::from(from) / f64::from(to)).powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Frames that take `full` seconds undivided, and the divisors after each.
    fn run(pace: &mut Pace, full: f64, frames: u32) -> Vec<u32> {
        (0..frames)
            .map(|_| {
                let seconds = full / f64::from(pace.divisor()).powi(2);
                pace.frame(Some(Duration::from_secs_f64(seconds)));
                pace.divisor()
            })
            .collect()
    }

    #[test]
    fn a_steady_load_comes_to_rest_and_is_fluid() {
        for full in [0.001, 0.02, 0.05, 0.1, 0.4, 1.0, 2.5, 40.0] {
            let mut pace = Pace::new();
            let settled = run(&mut pace, full, 200)[100..].to_vec();
            assert!(
                settled.windows(2).all(|pair| pair[0] == pair[1]),
                "{full}: {settled:?}"
            );
            let seconds = full / f64::from(settled[0]).powi(2);
            assert!(
                seconds <= TOO_LONG || settled[0] == COARSEST,
                "{full}: {seconds}"
            );
        }
    }

    #[test]
    fn a_light_load_is_not_divided_and_a_heavy_one_is_at_once() {
        let mut pace = Pace::new();
        assert_eq!(run(&mut pace, 0.01, 100).last(), Some(&1));
        let divisors = run(&mut pace, 1.0, REST + 1);
        assert!(divisors.last() > Some(&3), "{divisors:?}");
    }

    #[test]
    fn what_stands_still_becomes_finer() {
        let mut pace = Pace::new();
        let moving = *run(&mut pace, 1.5, 100).last().expect("frames");
        let mut finest = moving;
        for _ in 0..400 {
            // Each change is traced once, then nothing is.
            let took = pace
                .frame(None)
                .then(|| 1.5 / f64::from(pace.divisor()).powi(2));
            if let Some(seconds) = took {
                pace.frame(Some(Duration::from_secs_f64(seconds)));
            }
            finest = finest.min(pace.divisor());
        }
        assert!(finest < moving, "{moving} to {finest}");
        assert!(1.5 / f64::from(finest).powi(2) <= STILL);
        assert_eq!(pace.divisor(), finest);

        // What begins to move then is coarse again at the second slow frame.
        assert_eq!(run(&mut pace, 1.5, 3).last(), Some(&moving));
    }
}
