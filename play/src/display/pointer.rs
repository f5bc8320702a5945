//! The position of a display's mouse in a picture whose size may change.
//!
//! Invariant: the last reported position is in pixels of the current picture. If the picture
//! changes under a resting mouse, the position is reported again.

use cellray::game::InputEvent;

use super::Fit;

/// A mouse over a picture.
#[derive(Debug, Default)]
pub struct Pointer {
    fit: Fit,
    /// The position on the display.
    at: Option<(f64, f64)>,
    /// Whether the picture has changed since the position was reported.
    is_stale: bool,
}

impl Pointer {
    /// Changes the position of the picture.
    pub fn refit(&mut self, fit: Fit) {
        if fit != self.fit {
            self.fit = fit;
            self.is_stale = self.at.is_some();
        }
    }

    /// Moves the mouse to a position on the display.
    pub fn moved(&mut self, x: f64, y: f64) -> InputEvent {
        self.is_stale = false;
        self.at = Some((x, y));
        self.place(x, y)
    }

    /// Records that the mouse has left the display. Terminals don't report this.
    #[cfg(any(test, all(feature = "window", not(target_arch = "powerpc64"))))]
    pub fn left(&mut self) -> InputEvent {
        self.is_stale = false;
        self.at = None;
        InputEvent::MouseLeft
    }

    /// The event that reports the position again, if that is necessary.
    pub fn again(&mut self) -> Option<InputEvent> {
        let is_stale = std::mem::take(&mut self.is_stale);
        let (x, y) = self.at.filter(|_| is_stale)?;
        Some(self.place(x, y))
    }

    fn place(&self, x: f64, y: f64) -> InputEvent {
        match self.fit.place(x, y) {
            Some(to) => InputEvent::MouseMoved { to },
            None => InputEvent::MouseLeft,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn resting_mouse_is_rescaled_for_next_picture() {
        let mut pointer = Pointer::default();
        let of = |width, height| Fit::new((width, height), (960, 540));
        pointer.refit(of(960, 540));
        assert_eq!(pointer.again(), None);
        let at = |x, y| InputEvent::MouseMoved { to: [x, y] };
        assert_eq!(pointer.moved(480.0, 90.0), at(480.0, 90.0));
        pointer.refit(of(960, 540));
        assert_eq!(pointer.again(), None);
        pointer.refit(of(240, 135));
        assert_eq!(pointer.again(), Some(at(120.0, 22.5)));
        assert_eq!(pointer.again(), None);
        // A move of the mouse is already reported in the new picture's pixels.
        pointer.refit(of(480, 270));
        assert_eq!(pointer.moved(960.0 / 4.0, 0.0), at(120.0, 0.0));
        assert_eq!(pointer.again(), None);
        assert_eq!(pointer.left(), InputEvent::MouseLeft);
        pointer.refit(of(960, 540));
        assert_eq!(pointer.again(), None);
    }
}
