//! Fits a picture to a display of another size: centred, as large as possible, with its
//! proportions.

/// The position of the picture on the display.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fit {
    left: u32,
    top: u32,
    width: u32,
    height: u32,
    picture: (u32, u32),
}

impl Fit {
    /// Fits a picture to a display; both sizes are width and height in pixels. If the proportions
    /// differ by less than a fiftieth, for example by rounding, the picture fills the display.
    #[must_use]
    pub fn new(picture: (u32, u32), display: (u32, u32)) -> Self {
        let ((pw, ph), (dw, dh)) = (picture, display);
        if [pw, ph, dw, dh].contains(&0) {
            return Self::default();
        }
        let scaled =
            |side: u32, by: u32, of: u32| (u64::from(side) * u64::from(by) / u64::from(of)) as u32;
        let nearly = |side: u32, whole: u32| {
            if whole - side <= whole / 50 { whole } else { side }
        };
        let (width, height) = if u64::from(dw) * u64::from(ph) <= u64::from(dh) * u64::from(pw) {
            (dw, nearly(scaled(dw, ph, pw).clamp(1, dh), dh))
        } else {
            (nearly(scaled(dh, pw, ph).clamp(1, dw), dw), dh)
        };
        Self { left: (dw - width) / 2, top: (dh - height) / 2, width, height, picture }
    }

    /// The same position for a picture of another size, which is stretched to fill it.
    #[must_use]
    pub fn filled_by(self, picture: (u32, u32)) -> Self {
        Self { picture, ..self }
    }

    /// The left column and the top row of the picture on the display.
    #[must_use]
    pub fn corner(&self) -> (u32, u32) {
        (self.left, self.top)
    }

    /// The picture's width and height on the display.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// The picture's width and height on the display, if it is larger there than its own.
    #[must_use]
    pub fn enlarged(&self) -> Option<(u32, u32)> {
        let (width, height) = self.picture;
        let is_larger = self.width >= width && self.height >= height;
        let is_other = (self.width, self.height) != self.picture;
        (is_larger && is_other).then_some((self.width, self.height))
    }

    /// The picture's column that a column of the display shows; `None` outside of the picture.
    #[must_use]
    pub fn column(&self, x: u32) -> Option<u32> {
        let x = x.checked_sub(self.left).filter(|&x| x < self.width)?;
        Some((u64::from(x) * u64::from(self.picture.0) / u64::from(self.width)) as u32)
    }

    /// The picture's row that a row of the display shows; `None` outside of the picture.
    #[must_use]
    pub fn row(&self, y: u32) -> Option<u32> {
        let y = y.checked_sub(self.top).filter(|&y| y < self.height)?;
        Some((u64::from(y) * u64::from(self.picture.1) / u64::from(self.height)) as u32)
    }

    /// The position in the picture of a position on the display; `None` outside of the picture.
    #[must_use]
    pub fn place(&self, x: f64, y: f64) -> Option<[f32; 2]> {
        let along = |at: f64, from: u32, length: u32, pixels: u32| {
            let part = (at - f64::from(from)) / f64::from(length);
            (0.0..1.0).contains(&part).then(|| (part * f64::from(pixels)) as f32)
        };
        let x = along(x, self.left, self.width, self.picture.0)?;
        let y = along(y, self.top, self.height, self.picture.1)?;
        Some([x, y])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fit_shows_exactly_the_picture() {
        for (picture, display) in [
            ((4, 4), (4, 4)),
            ((320, 180), (1280, 720)),
            ((320, 180), (500, 720)),
            ((100, 400), (640, 360)),
            ((1280, 720), (64, 36)),
            ((7, 5), (1, 1)),
        ] {
            let fit = Fit::new(picture, display);
            let columns: Vec<_> = (0..display.0).filter_map(|x| fit.column(x)).collect();
            let rows: Vec<_> = (0..display.1).filter_map(|y| fit.row(y)).collect();
            assert!(columns.is_sorted() && rows.is_sorted());
            assert_eq!((columns[0], rows[0]), (0, 0), "{picture:?} {display:?}");
            assert!(columns.iter().all(|&x| x < picture.0) && rows.iter().all(|&y| y < picture.1));
            assert!(columns.len() == display.0 as usize || rows.len() == display.1 as usize);
            if display.0 >= picture.0 && display.1 >= picture.1 {
                assert_eq!(
                    (columns.last(), rows.last()),
                    (Some(&(picture.0 - 1)), Some(&(picture.1 - 1)))
                );
            }
        }
    }

    #[test]
    fn proportions_are_kept_within_rounding() {
        let bars = Fit::new((100, 100), (300, 100));
        assert_eq!(
            (bars.column(99), bars.column(100), bars.column(199), bars.column(200)),
            (None, Some(0), Some(99), None)
        );
        assert_eq!(bars.place(150.0, 50.0), Some([50.0, 50.0]));
        assert_eq!(bars.place(99.0, 50.0), None);
        let whole = Fit::new((91, 52), (640, 360));
        assert!(whole.column(0).is_some() && whole.row(0).is_some() && whole.row(359) == Some(51));
    }

    #[test]
    fn coarse_picture_fills_same_area() {
        // 22 rows are not in proportion to 40 columns, but there are no bars.
        let fit = Fit::new((640, 360), (640, 360)).filled_by((40, 22));
        assert_eq!((fit.column(0), fit.column(639)), (Some(0), Some(39)));
        assert_eq!((fit.row(0), fit.row(359)), (Some(0), Some(21)));
        assert_eq!((fit.corner(), fit.enlarged()), ((0, 0), Some((640, 360))));
        let whole = fit.filled_by((640, 360));
        assert_eq!(whole.enlarged(), None);
        assert_eq!(whole.filled_by((1280, 720)).enlarged(), None);
    }

    #[test]
    fn empty_picture_has_no_area() {
        for (picture, display) in [((0, 0), (10, 10)), ((10, 10), (10, 0))] {
            let fit = Fit::new(picture, display);
            let found = (fit.column(0), fit.row(0), fit.place(1.0, 1.0));
            assert_eq!(found, (None, None, None));
        }
    }
}
