//! Where a display's mouse points in a picture whose size changes.
//!
//! Invariant: the last place that was told is one in pixels of the picture at hand; where another
//! picture lies under a mouse that rests, its place is told again.

use cellray::game::InputEvent;

use super::Fit;

/// A mouse over a picture.
#[derive(Debug, Default)]
pub struct Pointer {
    fit: Fit,
    /// The place on the display.
    at: Option<(f64, f64)>,
    /// The picture is another since the place was told.
    is_stale: bool,
}

impl Pointer {
    /// Where the picture lies.
    #[must_use]
    pub fn fit(&self) -> Fit {
        self.fit
    }

    /// The picture lies there from now on.
    pub fn refit(&mut self, fit: Fit) {
        if fit != self.fit {
            self.fit = fit;
            self.is_stale = self.at.is_some();
        }
    }

    /// The mouse is at this place of the display now.
    pub fn moved(&mut self, x: f64, y: f64) -> InputEvent {
        self.is_stale = false;
        self.at = Some((x, y));
        self.place(x, y)
    }

    /// The mouse has left the display. A terminal does not tell.
    #[cfg(any(test, not(target_arch = "powerpc64")))]
    pub fn left(&mut self) -> InputEvent {
        self.is_stale = false;
        self.at = None;
        InputEvent::MouseLeft
    }

    /// What is to be told again.
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
    fn a_mouse_that_rests_is_told_of_again_in_the_next_pictures_pixels() {
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
        // What the mouse does itself is told in the picture's pixels already.
        pointer.refit(of(480, 270));
        assert_eq!(pointer.moved(960.0 / 4.0, 0.0), at(120.0, 0.0));
        assert_eq!(pointer.again(), None);
        assert_eq!(pointer.left(), InputEvent::MouseLeft);
        pointer.refit(of(960, 540));
        assert_eq!(pointer.again(), None);
    }
}
