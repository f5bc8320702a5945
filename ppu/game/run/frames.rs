//! Ranges of frames, written `A..B` for the frames from A to B − 1, or `N` for the first N.

use std::str::FromStr;

/// A range of frames, which is never empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameRange {
    /// The number of the first frame.
    pub first: u64,
    /// The number after the last frame's.
    pub end: u64,
}

/// Why a text is not a range of frames.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FrameRangeError {
    /// The text is neither `A..B` nor a number.
    #[error("{0:?} is not a range of frames: expected A..B, as in 0..250, or a number of frames")]
    Malformed(String),
    /// The end is not above the first frame.
    #[error("{0:?} has no frames: the first must be below the end")]
    Empty(String),
}

impl FromStr for FrameRange {
    type Err = FrameRangeError;

    fn from_str(text: &str) -> Result<Self, FrameRangeError> {
        let malformed = || FrameRangeError::Malformed(text.to_owned());
        let number = |digits: &str| {
            let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
            is_number.then(|| digits.parse::<u64>().ok()).flatten().ok_or_else(malformed)
        };
        let (first, end) = match text.split_once("..") {
            Some((first, end)) => (number(first)?, number(end)?),
            None => (0, number(text)?),
        };
        if first < end {
            Ok(Self { first, end })
        } else {
            Err(FrameRangeError::Empty(text.to_owned()))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_read_strictly() {
        let range = |first, end| Ok(FrameRange { first, end });
        assert_eq!("0..250".parse(), range(0, 250));
        assert_eq!("17..18".parse(), range(17, 18));
        assert_eq!("3".parse(), range(0, 3));
        for text in [
            "",
            "..",
            "1..",
            "..2",
            "-1..2",
            "1...2",
            "1..=2",
            "a..b",
            "+1..2",
            "99999999999999999999",
        ] {
            let error = text.parse::<FrameRange>();
            assert_eq!(error, Err(FrameRangeError::Malformed(text.into())));
        }
        for text in ["0", "3..3", "4..3"] {
            let error = text.parse::<FrameRange>();
            assert_eq!(error, Err(FrameRangeError::Empty(text.into())));
        }
    }
}
