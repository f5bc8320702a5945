//! Enlarges a picture smoothly: bilinear interpolation between the centres of its pixels.

use image::RgbImage;

/// One in the fixed-point arithmetic of the weights.
const ONE: u32 = 256;

/// The two pixels that a pixel of the larger picture is between, and the weight of the second.
#[derive(Clone, Copy)]
struct Between {
    first: u32,
    second: u32,
    weight: u32,
}

/// The pixels of one side with `from` pixels for each of the `to` pixels of the larger one.
fn places(from: u32, to: u32) -> Vec<Between> {
    let last = u64::from(from.max(1) - 1) * u64::from(ONE);
    (0..to)
        .map(|at| {
            // The centre of the pixel, from the centre of the first one, in steps of 1/ONE.
            let centre = (2 * u64::from(at) + 1) * u64::from(from) * u64::from(ONE);
            let place = (centre / (2 * u64::from(to))).saturating_sub(u64::from(ONE / 2));
            let place = place.min(last) as u32;
            let first = place / ONE;
            Between {
                first,
                second: (first + 1).min(from.max(1) - 1),
                weight: place % ONE,
            }
        })
        .collect()
}

/// The picture in another size, which should not be smaller.
#[must_use]
pub fn enlarge(picture: &RgbImage, (width, height): (u32, u32)) -> RgbImage {
    let (columns, rows) = (
        places(picture.width(), width),
        places(picture.height(), height),
    );
    let pixel = |x: u32, y: u32| picture.get_pixel(x, y).0.map(u32::from);
    RgbImage::from_fn(width, height, |x, y| {
        let (column, row) = (columns[x as usize], rows[y as usize]);
        let across = |y: u32| {
            let (one, other) = (pixel(column.first, y), pixel(column.second, y));
            [0, 1, 2].map(|n| one[n] * (ONE - column.weight) + other[n] * column.weight)
        };
        let (one, other) = (across(row.first), across(row.second));
        image::Rgb([0, 1, 2].map(|n| {
            let sum = one[n] * (ONE - row.weight) + other[n] * row.weight;
            ((sum + ONE * ONE / 2) / (ONE * ONE)) as u8
        }))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_between_two_pixels_is_between_their_colours() {
        let picture = RgbImage::from_raw(2, 1, vec![0, 100, 255, 200, 100, 55]).expect("2 pixels");
        let large = enlarge(&picture, (8, 3));
        let red: Vec<_> = (0..8).map(|x| large.get_pixel(x, 1).0[0]).collect();
        assert!(red.is_sorted(), "{red:?}");
        assert_eq!((red[0], red[7]), (0, 200));
        assert!((75..125).contains(&red[3]) && red[3] < red[4], "{red:?}");
        assert!(large.pixels().all(|pixel| pixel.0[1] == 100));
    }

    #[test]
    fn the_same_size_is_the_same_picture() {
        let picture = RgbImage::from_fn(7, 5, |x, y| image::Rgb([x as u8 * 30, y as u8 * 50, 9]));
        assert_eq!(enlarge(&picture, (7, 5)), picture);
    }
}
