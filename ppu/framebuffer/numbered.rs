//! The names of numbered pictures.

use std::ffi::{OsStr, OsString};
use std::os::unix::ffi::{OsStrExt as _, OsStringExt as _};
use std::path::PathBuf;

use super::FramebufferError;
use super::picture_file::Format;

/// The most digits of a number: as many as the largest `u64` has.
const MAX_DIGITS: usize = 20;

/// A pattern of paths with a number: `%d` stands for the number, `%05d` for at least five digits.
/// What is around it may be any bytes that a file's name can have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NumberedPath {
    before: Vec<u8>,
    digits: usize,
    after: Vec<u8>,
}

impl NumberedPath {
    /// Parses a pattern with one place for the number, such as `f-%05d.png`. `%%` is a percent
    /// sign.
    ///
    /// # Errors
    /// The pattern has no place for the number, or several, or the extension of a format that
    /// pictures are not written in.
    pub fn new(pattern: impl AsRef<OsStr>) -> Result<Self, FramebufferError> {
        let pattern = pattern.as_ref();
        let path = Self::parse(pattern.as_bytes()).ok_or_else(|| {
            FramebufferError::MalformedNumbering { pattern: pattern.to_string_lossy().into_owned() }
        })?;
        Format::of(&path.of(0))?;
        Ok(path)
    }

    fn parse(pattern: &[u8]) -> Option<Self> {
        let mut text = Vec::new();
        let mut found = None;
        let mut rest = pattern;
        while let Some((&byte, after)) = rest.split_first() {
            rest = after;
            if byte != b'%' {
                text.push(byte);
            } else if let Some(after) = rest.strip_prefix(b"%") {
                text.push(b'%');
                rest = after;
            } else {
                let end = rest.iter().position(|&byte| byte == b'd')?;
                let digits = match str::from_utf8(&rest[..end]).ok()? {
                    "" => 1,
                    digits if is_width(digits) => digits.parse().ok()?,
                    _ => return None,
                };
                let before = std::mem::take(&mut text);
                if digits > MAX_DIGITS || found.replace((before, digits)).is_some() {
                    return None;
                }
                rest = &rest[end + 1..];
            }
        }
        let (before, digits) = found?;
        Some(Self { before, digits, after: text })
    }

    /// The path for a number.
    #[must_use]
    pub fn of(&self, number: u64) -> PathBuf {
        let Self { before, digits, after } = self;
        let number = format!("{number:0digits$}");
        let path = [before.as_slice(), number.as_bytes(), after].concat();
        OsString::from_vec(path).into()
    }
}

fn is_width(digits: &str) -> bool {
    digits.starts_with('0') && digits.bytes().all(|digit| digit.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pattern_has_one_number() {
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

    #[test]
    fn pattern_may_contain_invalid_utf8() {
        let pattern = OsStr::from_bytes(b"\xe4%03d\xff.png");
        let path = NumberedPath::new(pattern).expect("a pattern").of(7);
        assert_eq!(path.as_os_str().as_bytes(), b"\xe4007\xff.png");
    }

    #[test]
    fn unsupported_format_is_refused() {
        let error = NumberedPath::new("f-%d.gif").expect_err("a format");
        assert!(error.to_string().contains(".jpg"), "{error}");
    }
}
