//! Time in steps of one size, so that movements do not depend on the length of frames.

/// Seconds of a step.
pub const STEP: f64 = 1.0 / 480.0;

/// The most seconds that a frame can take. If frames take longer, a game runs more slowly instead
/// of jumping.
const LONGEST: f64 = 0.25;

/// Splits the time of frames into steps. The rest of one frame goes to the next.
#[derive(Clone, Debug, Default)]
pub struct Steps {
    left: f64,
}

impl Steps {
    /// The number of steps in a frame that comes this many seconds after the last one.
    pub fn of(&mut self, seconds: f64) -> u32 {
        // `clamp` is not used, because a frame time of NaN would then lose the rest of earlier
        // frames.
        if seconds > 0.0 {
            self.left += seconds.min(LONGEST);
        }
        let steps = (self.left / STEP).floor();
        self.left = (self.left - steps * STEP).max(0.0);
        steps as u32
    }
}

#[cfg(test)]
mod tests {
    use super::{LONGEST, STEP, Steps};

    #[test]
    fn remaining_time_is_kept_for_the_next_frame() {
        let mut steps = Steps::default();
        let taken: u32 = (0..600).map(|_| steps.of(1.0 / 60.0)).sum();
        assert!(taken.abs_diff(4800) <= 1, "{taken}");
    }

    #[test]
    fn long_frame_time_is_limited() {
        let mut steps = Steps::default();
        assert_eq!(steps.of(1e9), (LONGEST / STEP) as u32);
        assert_eq!(steps.of(-1.0), 0);
    }

    #[test]
    fn steps_continue_after_frame_without_time() {
        let mut steps = Steps::default();
        assert_eq!(steps.of(2.5 * STEP), 2);
        assert_eq!(steps.of(f64::NAN), 0);
        assert_eq!(steps.of(0.75 * STEP), 1);
        assert_eq!(steps.of(f64::NAN), 0);
        assert_eq!(steps.of(1.0 * STEP), 1);
    }
}
