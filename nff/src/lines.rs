//! The lines of a file that have words, read within limits. A comment that is a directive has words.
//!
//! Invariant: never more than one line and one buffer of the reader in memory.

use std::io::{self, BufRead};

use crate::Fault;

/// The first word of a directive: to other programs it begins a comment.
pub(crate) const DIRECTIVE: &str = "#cellray";

/// How much a scene may hold, so that no file can take all memory or time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Limits {
    /// Most objects; likewise most lights and most materials.
    pub objects: usize,
    /// Most vertices of all polygons and patches together.
    pub vertices: usize,
    /// Most bytes in a line, its end not counted.
    pub line_bytes: usize,
    /// Most lines, empty ones and comments included.
    pub lines: u32,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            objects: 4_000_000,
            vertices: 16_000_000,
            line_bytes: 64 * 1024,
            lines: 64_000_000,
        }
    }
}

/// A reader's lines, one at a time.
pub(crate) struct Lines<R> {
    reader: R,
    /// The line at hand.
    bytes: Vec<u8>,
    /// Its number, from 1; 0 before the first.
    number: u32,
    max_bytes: usize,
    max_lines: u32,
}

/// Why there is no next line.
pub(crate) enum LineError {
    Io(io::Error),
    Fault(Fault),
}

impl<R: BufRead> Lines<R> {
    pub(crate) fn new(reader: R, limits: &Limits) -> Self {
        Self {
            reader,
            bytes: Vec::new(),
            number: 0,
            max_bytes: limits.line_bytes,
            max_lines: limits.lines,
        }
    }

    /// Number of the line that [`Self::advance`] gave last, from 1.
    pub(crate) fn number(&self) -> u32 {
        self.number
    }

    /// The next line that has words, without its comment; nothing at the end of the file.
    pub(crate) fn advance(&mut self) -> Result<Option<&str>, LineError> {
        let start = loop {
            if !self.read()? {
                return Ok(None);
            }
            let text = self.text()?;
            if let Some(start) = text.find(|c: char| !c.is_ascii_whitespace()) {
                break start;
            }
        };
        Ok(Some(&self.text()?[start..]))
    }

    /// The line at hand, without its comment.
    fn text(&self) -> Result<&str, LineError> {
        let text = str::from_utf8(&self.bytes)
            .map_err(|error| LineError::Fault(Fault::NotText(error.valid_up_to() + 1)))?;
        let start = text.len() - text.trim_ascii_start().len();
        let directive = text[start..]
            .strip_prefix(DIRECTIVE)
            .is_some_and(|rest| !rest.starts_with(|c: char| !c.is_ascii_whitespace()));
        let from = if directive { start + 1 } else { 0 };
        let end = text[from..].find('#').map_or(text.len(), |at| from + at);
        Ok(&text[..end])
    }

    /// Brings the next line into `bytes`; false at the end of the file.
    fn read(&mut self) -> Result<bool, LineError> {
        self.bytes.clear();
        loop {
            let buffer = match self.reader.fill_buf() {
                Ok(buffer) => buffer,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                Err(error) => return Err(LineError::Io(error)),
            };
            if self.bytes.is_empty() && !buffer.is_empty() && self.number == self.max_lines {
                let limit = self.max_lines as usize;
                return Err(LineError::Fault(Fault::TooMany {
                    what: "lines",
                    limit,
                }));
            }
            let end = buffer.iter().position(|&byte| byte == b'\n');
            let part = &buffer[..end.unwrap_or(buffer.len())];
            if part.len() > self.max_bytes - self.bytes.len() {
                self.number += 1;
                return Err(LineError::Fault(Fault::LongLine(self.max_bytes)));
            }
            self.bytes.extend_from_slice(part);
            let (at_end, used) = (buffer.is_empty(), part.len() + usize::from(end.is_some()));
            self.reader.consume(used);
            if end.is_some() || at_end {
                let any = end.is_some() || !self.bytes.is_empty();
                self.number += u32::from(any);
                return Ok(any);
            }
        }
    }
}
