//! Enlarges a picture smoothly: bilinear interpolation between the centres of its pixels.

use image::RgbImage;

/// One in the fixed-point arithmetic of the weights.
const ONE: u32 = 256;
/// The lowest bits of the three lanes of 16 bits that a colour is computed in.
const LANES: u64 = 0x0001_0001_0001;

/// The two pixels that a pixel of the larger picture is between, and the weight of the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Between {
    first: usize,
    second: usize,
    weight: u32,
}

impl Between {
    /// The colour between two, of which this has the weight.
    fn blend(self, first: u64, second: u64) -> u64 {
        let (one, other) = (u64::from(ONE - self.weight), u64::from(self.weight));
        // A lane is at most 255 * 256 + 128, so it doesn't reach into the next.
        let sum = first * one + second * other + LANES * u64::from(ONE / 2);
        (sum >> 8) & (LANES * 0xFF)
    }
}

/// The pixels of one side with `from` pixels for each of the `to` pixels of the larger one.
fn places(from: u32, to: u32) -> Vec<Between> {
    let last = from.max(1) - 1;
    (0..to)
        .map(|at| {
            // The centre of the pixel, from the centre of the first one, in steps of 1/ONE.
            let centre = (2 * u64::from(at) + 1) * u64::from(from) * u64::from(ONE);
            let place = (centre / (2 * u64::from(to))).saturating_sub(u64::from(ONE / 2));
            let place = place.min(u64::from(last * ONE)) as u32;
            let first = place / ONE;
            Between {
                first: first as usize,
                second: (first + 1).min(last) as usize,
                weight: place % ONE,
            }
        })
        .collect()
}

/// A picture in another size, which should not be smaller.
pub struct Enlarged<'a> {
    picture: &'a RgbImage,
    columns: Vec<Between>,
    rows: Vec<Between>,
    /// The picture's rows for the last row of this, blended, and one pixel of padding.
    blended: Vec<u64>,
    row: Vec<[u8; 3]>,
}

impl<'a> Enlarged<'a> {
    /// The picture in this width and height.
    #[must_use]
    pub fn new(picture: &'a RgbImage, (width, height): (u32, u32)) -> Self {
        Self {
            picture,
            columns: places(picture.width(), width),
            rows: places(picture.height(), height),
            blended: Vec::new(),
            row: Vec::new(),
        }
    }

    /// A row from the top; empty below the picture.
    pub fn row(&mut self, y: u32) -> &[[u8; 3]] {
        self.row.clear();
        let Some(&between) = self.rows.get(y as usize) else {
            return &self.row;
        };
        let across = self.picture.width() as usize;
        let pixels = self.picture.as_chunks::<3>().0;
        let [first, second] =
            [between.first, between.second].map(|y| pixels[y * across..][..across].iter());
        let lanes = |[red, green, blue]: [u8; 3]| {
            u64::from(red) << 32 | u64::from(green) << 16 | u64::from(blue)
        };
        let both = first.zip(second);
        self.blended.clear();
        self.blended
            .extend(both.map(|(&one, &other)| between.blend(lanes(one), lanes(other))));
        let blended = &self.blended;
        self.row.extend(self.columns.iter().map(|column| {
            let colour = column.blend(blended[column.first], blended[column.second]);
            [colour >> 32, colour >> 16, colour].map(|lane| lane as u8)
        }));
        &self.row
    }

    /// All of it.
    #[must_use]
    pub fn all(mut self) -> RgbImage {
        let mut all = RgbImage::new(self.columns.len() as u32, self.rows.len() as u32);
        for (y, row) in (0..).zip(all.rows_mut()) {
            for (pixel, shown) in row.zip(self.row(y)) {
                pixel.0 = *shown;
            }
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_between_two_pixels_is_between_their_colours() {
        let picture = RgbImage::from_raw(2, 1, vec![0, 100, 255, 200, 100, 55]).expect("2 pixels");
        let large = Enlarged::new(&picture, (8, 3)).all();
        let red: Vec<_> = (0..8).map(|x| large.get_pixel(x, 1).0[0]).collect();
        assert_eq!(red, [0, 0, 25, 75, 125, 175, 200, 200]);
        assert!(large.pixels().all(|pixel| pixel.0[1] == 100));
        assert!(large.pixels().all(|pixel| pixel.0[0] + pixel.0[2] == 255));
    }

    #[test]
    fn rows_are_blended_as_columns_are() {
        let grey = |x: u32, y: u32| image::Rgb([(x * 80) as u8, (y * 80) as u8, 255]);
        let large = Enlarged::new(&RgbImage::from_fn(3, 3, grey), (30, 30)).all();
        for (x, y, pixel) in large.enumerate_pixels() {
            let turned = large.get_pixel(y, x).0;
            assert_eq!(pixel.0, [turned[1], turned[0], 255]);
        }
    }

    #[test]
    fn the_same_size_is_the_same_picture() {
        let picture = RgbImage::from_fn(7, 5, |x, y| image::Rgb([x as u8 * 30, y as u8 * 50, 9]));
        assert_eq!(Enlarged::new(&picture, (7, 5)).all(), picture);
    }

    #[test]
    fn below_the_picture_is_nothing() {
        let picture = RgbImage::new(2, 2);
        let mut large = Enlarged::new(&picture, (4, 4));
        assert_eq!((large.row(3).len(), large.row(4).len()), (4, 0));
    }
}
