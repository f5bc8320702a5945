//! Compares a picture with the reference.

use serde::Serialize;

use crate::{Error, Picture, Reference};

/// The factor of errors in a difference picture: 1/255 is visible, 16/255 is white.
pub const DIFFERENCE_SCALE: u8 = 16;

/// The largest error of a right pixel's channel, in 1/255: one rounding to a byte.
const TOLERANCE: u8 = 1;

/// The errors of a picture. Errors of channels are in 1/255.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Comparison {
    /// The number of pixels with a channel that is off by more than 1.
    pub wrong_pixels: u64,
    /// Their share of all pixels, from 0 to 1.
    pub wrong_fraction: f64,
    /// The number of wrong pixels that are not on a silhouette.
    pub wrong_off_silhouette: u64,
    /// The largest error of a channel.
    pub max_error: u8,
    /// The largest error of a channel of pixels that are not on a silhouette.
    pub max_error_off_silhouette: u8,
    /// The mean error over all channels of all pixels.
    pub mean_error: f64,
}

/// Compares a picture with the reference.
///
/// # Errors
/// The pictures have different sizes.
pub fn compare(picture: &Picture, reference: &Reference) -> Result<Comparison, Error> {
    check_sizes(picture, &reference.picture)?;
    let mut result = Comparison {
        wrong_pixels: 0,
        wrong_fraction: 0.0,
        wrong_off_silhouette: 0,
        max_error: 0,
        max_error_off_silhouette: 0,
        mean_error: 0.0,
    };
    let mut sum = 0u64;
    let pairs = picture.pixels().iter().zip(reference.picture.pixels());
    for ((found, expected), &on_silhouette) in pairs.zip(&reference.silhouette) {
        let errors = errors(found, expected);
        let largest = errors.into_iter().fold(0, u8::max);
        let wrong = u64::from(largest > TOLERANCE);
        sum += errors.into_iter().map(u64::from).sum::<u64>();
        result.wrong_pixels += wrong;
        result.max_error = result.max_error.max(largest);
        if !on_silhouette {
            result.wrong_off_silhouette += wrong;
            result.max_error_off_silhouette = result.max_error_off_silhouette.max(largest);
        }
    }
    let pixels = picture.pixels().len() as f64;
    result.wrong_fraction = result.wrong_pixels as f64 / pixels;
    result.mean_error = sum as f64 / (3.0 * pixels);
    Ok(result)
}

/// The absolute difference of two pictures, times [`DIFFERENCE_SCALE`].
///
/// # Errors
/// The pictures have different sizes.
pub fn difference(picture: &Picture, reference: &Picture) -> Result<Picture, Error> {
    check_sizes(picture, reference)?;
    let mut result = Picture::black(picture.width(), picture.height())?;
    let pairs = picture.pixels().iter().zip(reference.pixels());
    for (pixel, (found, expected)) in result.pixels_mut().iter_mut().zip(pairs) {
        *pixel = errors(found, expected).map(|error| error.saturating_mul(DIFFERENCE_SCALE));
    }
    Ok(result)
}

/// The numbers of the pixels that are wrong, row by row.
pub(crate) fn wrong_pixels(picture: &Picture, reference: &Picture) -> Result<Vec<usize>, Error> {
    check_sizes(picture, reference)?;
    let pairs = picture.pixels().iter().zip(reference.pixels()).enumerate();
    let wrong = pairs.filter(|(_, (found, expected))| is_wrong(found, expected));
    Ok(wrong.map(|(pixel, _)| pixel).collect())
}

/// Whether a channel is off by more than one rounding.
pub(crate) fn is_wrong(found: &[u8; 3], expected: &[u8; 3]) -> bool {
    errors(found, expected).into_iter().any(|error| error > TOLERANCE)
}

fn errors(found: &[u8; 3], expected: &[u8; 3]) -> [u8; 3] {
    std::array::from_fn(|channel| found[channel].abs_diff(expected[channel]))
}

fn check_sizes(picture: &Picture, reference: &Picture) -> Result<(), Error> {
    let size = |picture: &Picture| (picture.width(), picture.height());
    let (picture, reference) = (size(picture), size(reference));
    if picture == reference { Ok(()) } else { Err(Error::Sizes { picture, reference }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A black reference of five pixels, with the last two on a silhouette, and a picture to
    /// compare.
    fn pictures(pixels: [[u8; 3]; 5]) -> (Picture, Reference) {
        let black = Picture::black(5, 1).expect("a picture");
        let mut picture = black.clone();
        picture.pixels_mut().copy_from_slice(&pixels);
        let silhouette = vec![false, false, false, true, true];
        (picture, Reference { picture: black, silhouette, covered: 0.0, refined: 0 })
    }

    #[test]
    fn errors_are_counted_on_and_off_silhouettes() {
        let (picture, reference) =
            pictures([[0, 0, 0], [1, 1, 1], [0, 2, 0], [0, 0, 200], [0, 0, 1]]);
        let expected = Comparison {
            wrong_pixels: 2,
            wrong_fraction: 0.4,
            wrong_off_silhouette: 1,
            max_error: 200,
            max_error_off_silhouette: 2,
            mean_error: 206.0 / 15.0,
        };
        assert_eq!(compare(&picture, &reference).expect("one size"), expected);
    }

    #[test]
    fn equal_pictures_have_no_error() {
        let (picture, reference) = pictures([[0; 3]; 5]);
        let result = compare(&picture, &reference).expect("one size");
        assert_eq!((result.wrong_pixels, result.max_error, result.mean_error), (0, 0, 0.0));
    }

    #[test]
    fn a_difference_is_amplified_and_saturates() {
        let (picture, reference) = pictures([[0, 1, 15], [16, 255, 2], [0; 3], [0; 3], [0; 3]]);
        let result = difference(&reference.picture, &picture).expect("one size");
        assert_eq!(result.pixels()[..2], [[0, 16, 240], [255, 255, 32]]);
    }

    #[test]
    fn sizes_must_agree() {
        let (_, reference) = pictures([[0; 3]; 5]);
        let other = Picture::black(1, 5).expect("a picture");
        let message = "the picture has 1x5 pixels, the reference 5x1";
        assert_eq!(compare(&other, &reference).expect_err("sizes").to_string(), message);
        assert!(difference(&other, &reference.picture).is_err());
    }
}
