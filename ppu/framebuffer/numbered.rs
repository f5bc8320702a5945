//! The names of numbered pictures.

use std::path::PathBuf;

use super::FramebufferError;

/// The most digits of a number: as many as the largest `u64` has.
const MOST_DIGITS: usize = 20;

/// A pattern of paths with a number: `%d` stands for the number, `%05d` for at least five digits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NumberedPath {
    before: String,
    digits: usize,
    after: String,
}

impl NumberedPath {
    /// Parses a pattern with one place for the number, such as `f-%05d.png`. `%%` is a percent
    /// sign.
    ///
    /// # Errors
    /// The pattern has no place for the number, or several.
    pub fn new(pattern: &str) -> Result<Self, FramebufferError> {
        let malformed = || FramebufferError::MalformedNumbering {
            pattern: pattern.to_owned(),
        };
        let mut parts = vec![String::new()];
        let mut found = None;
        let mut rest = pattern;
        while let Some((text, behind)) = rest.split_once('%') {
            parts.last_mut().ok_or_else(malformed)?.push_str(text);
            if let Some(behind) = behind.strip_prefix('%') {
                parts.last_mut().ok_or_else(malformed)?.push('%');
                rest = behind;
                continue;
            }
            let (digits, behind) = behind.split_once('d').ok_or_else(malformed)?;
            let is_width = digits.starts_with('0') && digits.bytes().all(|c| c.is_ascii_digit());
            let digits = match digits {
                "" => 1,
                digits if is_width => digits.parse().map_err(|_| malformed())?,
                _ => return Err(malformed()),
            };
            if digits > MOST_DIGITS || found.replace(digits).is_some() {
                return Err(malformed());
            }
            parts.push(String::new());
            rest = behind;
        }
        parts.last_mut().ok_or_else(malformed)?.push_str(rest);
        match (found, <[String; 2]>::try_from(parts)) {
            (Some(digits), Ok([before, after])) => Ok(Self {
                before,
                digits,
                after,
            }),
            _ => Err(malformed()),
        }
    }

    /// The path for a number.
    #[must_use]
    pub fn of(&self, number: u64) -> PathBuf {
        let Self {
            before,
            digits,
            after,
        } = self;
        PathBuf::from(format!("{before}{number:0digits$}{after}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pattern_has_one_number() {
        let path =
            |pattern: &str, number| NumberedPath::new(pattern).expect("a pattern").of(number);
        for (pattern, number, expected) in [
            ("f-%05d.png", 42, "f-00042.png"),
            ("f-%05d.png", 123_456, "f-123456.png"),
            ("%d", 7, "7"),
            ("a/%03d/50%%.png", 7, "a/007/50%.png"),
        ] {
            assert_eq!(path(pattern, number), PathBuf::from(expected));
        }
        for pattern in [
            "",
            "f.png",
            "%",
            "%d%d",
            "%5d",
            "%x",
            "%0xd",
            "%-3d",
            "%021d",
            "%%d",
            "%0999999999999999999999d",
        ] {
            let error = NumberedPath::new(pattern).expect_err(pattern);
            assert!(error.to_string().contains("%05d"), "{error}");
        }
    }
}
