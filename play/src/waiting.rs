//! The notice that a picture takes long.

use std::time::{Duration, Instant};

/// How long the player waits for a picture before the notice appears.
const PATIENCE: Duration = Duration::from_secs(1);

/// The time since the display was last drawn.
#[derive(Debug)]
pub struct Waiting(Instant);

impl Waiting {
    /// Starts at a time at which the display is drawn.
    #[must_use]
    pub fn new(now: Instant) -> Self {
        Self(now)
    }

    pub fn is_over(&mut self, now: Instant) {
        self.0 = now;
    }

    /// The text to draw now, once for each second without a picture. `part` is the part of the
    /// picture that is done, 0 to 1.
    pub fn text(&mut self, now: Instant, part: f64) -> Option<String> {
        if now.saturating_duration_since(self.0) < PATIENCE {
            return None;
        }
        self.0 = now;
        Some(format!("tracing ... {:.0} %", 100.0 * part))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_second_without_picture_is_reported() {
        let began = Instant::now();
        let after = |milliseconds| began + Duration::from_millis(milliseconds);
        let mut waiting = Waiting::new(began);
        assert_eq!(waiting.text(after(900), 0.1), None);
        assert_eq!(waiting.text(after(1000), 0.125).as_deref(), Some("tracing ... 12 %"));
        assert_eq!(waiting.text(after(1900), 0.2), None);
        assert_eq!(waiting.text(after(2100), 0.25).as_deref(), Some("tracing ... 25 %"));
        waiting.is_over(after(2200));
        assert_eq!(waiting.text(after(3100), 0.3), None);
        assert!(waiting.text(after(3200), 0.3).is_some());
    }
}
