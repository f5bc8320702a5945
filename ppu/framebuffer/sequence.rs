//! Frames as a sequence of numbered PNG pictures.
//!
//! Invariant: a picture's name depends on its number alone, and each is whole as soon as it is there.

use std::path::{Path, PathBuf};

use super::{Framebuffer, FramebufferError, Geometry, Memory, Target, write_png};

/// Most digits of a number: as many as the largest has.
const MOST_DIGITS: usize = 20;

/// Paths that differ in a number: `%d` stands for it, `%05d` for five digits of it at least.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NumberedPath {
    before: String,
    digits: usize,
    after: String,
}

impl NumberedPath {
    /// Reads a pattern such as `f-%05d.png`, with the number's place once; `%%` is a percent sign.
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

    /// The path of a number.
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

/// A framebuffer of which every presented frame becomes a picture of its own.
pub struct Sequence {
    paths: NumberedPath,
    next: u64,
    memory: Memory,
}

impl Sequence {
    /// Prepares frames of `geometry`, the first of which has the number `first`; nothing is written before it.
    pub fn new(
        paths: NumberedPath,
        first: u64,
        geometry: Geometry,
    ) -> Result<Self, FramebufferError> {
        Ok(Self {
            paths,
            next: first,
            memory: Memory::new(geometry)?,
        })
    }

    /// The path of the picture that comes next.
    #[must_use]
    pub fn next_path(&self) -> PathBuf {
        self.paths.of(self.next)
    }

    /// Whether the picture that comes next is there already, from an earlier run.
    #[must_use]
    pub fn has_next(&self) -> bool {
        Path::is_file(&self.next_path())
    }

    /// Passes over the picture that comes next.
    pub fn skip(&mut self) {
        self.next += 1;
    }
}

impl Framebuffer for Sequence {
    fn geometry(&self) -> Geometry {
        self.memory.geometry()
    }

    fn target(&mut self) -> Target {
        self.memory.target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        write_png(&self.next_path(), &self.memory.rgb())?;
        self.next += 1;
        Ok(())
    }

    fn keeps_contents(&self) -> bool {
        self.memory.keeps_contents()
    }

    fn describe(&self) -> String {
        format!(
            "PNG pictures from {} on, {}",
            self.next_path().display(),
            self.geometry()
        )
    }
}

#[cfg(test)]
mod tests {
    use super::super::pattern;
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

    #[test]
    fn every_frame_is_a_picture() {
        let folder = tempfile::tempdir().expect("a folder");
        let pattern = folder.path().join("f-%02d.png");
        let paths = NumberedPath::new(pattern.to_str().expect("text")).expect("a pattern");
        let size = Geometry {
            width: 37,
            height: 9,
        };
        let mut sequence = Sequence::new(paths, 9, size).expect("memory");
        for seed in 0..2 {
            assert!(!sequence.has_next());
            pattern::paint(sequence.target(), seed);
            sequence.present().expect("a picture");
        }
        for (seed, name) in [(0, "f-09.png"), (1, "f-10.png")] {
            let picture = image::open(folder.path().join(name)).expect(name);
            pattern::assert_shows(&picture.into_rgb8(), seed);
        }
    }
}
