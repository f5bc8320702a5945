//! Chooses how coarsely a picture is traced, by the time that its frames take.
//!
//! Invariants: the divisor is from 1 to [`COARSEST`]. It never becomes smaller within [`REST`]
//! frames after another change. A change is only made if it is not expected to be reverted at the
//! same load.

use std::time::Duration;

/// The largest divisor of the display's width and height.
pub const COARSEST: u32 = 8;
/// Frames that take longer than this, in seconds, make the picture coarser.
const TOO_LONG: f64 = 1.0 / 20.0;
/// A picture becomes finer if it is expected to take less than this, in seconds: well below
/// [`TOO_LONG`].
const SHORT: f64 = 1.0 / 30.0;
/// A picture that stands still is traced only once, so a finer one may take this long, in seconds.
const STILL: f64 = 0.4;
/// The number of frames without anything to trace after which a picture counts as standing still.
const STILL_FRAMES: u32 = 15;
/// The least number of frames between a change and one that makes the picture finer.
const REST: u32 = 8;
/// The weight of a frame in the running average.
const WEIGHT: f64 = 0.25;

/// Chooses the divisor of the display's width and height.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    divisor: u32,
    /// The average time of a traced frame at this divisor, in seconds.
    seconds: Option<f64>,
    /// The number of frames since the last change.
    rested: u32,
    /// The number of frames since something was traced.
    still: u32,
}

impl Pace {
    /// Starts with a medium divisor, so that the first frame isn't the slowest of all.
    #[must_use]
    pub fn new() -> Self {
        Self {
            divisor: COARSEST / 2,
            seconds: None,
            rested: 0,
            still: 0,
        }
    }

    /// The current divisor of the display's width and height.
    #[must_use]
    pub fn divisor(&self) -> u32 {
        self.divisor
    }

    /// Records the time of a frame, or `None` if nothing was traced. Returns whether the divisor
    /// has changed.
    pub fn frame(&mut self, took: Option<Duration>) -> bool {
        self.rested += 1;
        match took {
            Some(took) => {
                let took = took.as_secs_f64();
                let mean = |mean: f64| mean + WEIGHT * (took - mean);
                self.seconds = Some(self.seconds.map_or(took, mean));
                // The first frame after a change is always traced, because of the change.
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
            self.seconds = Some(expected(seconds, self.divisor, next));
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
            // As coarse as necessary in a single step.
            (self.divisor + 1..COARSEST)
                .find(|&coarser| expected(seconds, self.divisor, coarser) < TOO_LONG)
                .unwrap_or(COARSEST)
        } else if self.rested >= REST && expected(seconds, self.divisor, finer) < allowed {
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

/// The expected time at another divisor, in seconds. It is proportional to the number of rays.
fn expected(seconds: f64, from: u32, to: u32) -> f64 {
    seconds * (f64::from(from) / f64::from(to)).powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Simulates frames that take `full` seconds at divisor 1. Returns the divisor after each.
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
            // After each change one frame is traced, and then nothing.
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

        // When the picture moves again, it becomes coarse at the second slow frame.
        assert_eq!(run(&mut pace, 1.5, 3).last(), Some(&moving));
    }
}
