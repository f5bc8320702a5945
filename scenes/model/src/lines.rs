//! Reads the lines of a file that have words, within limits. A comment that is a directive has
//! words. A line ends with a line feed, a carriage return or both. A byte-order mark is skipped.
//!
//! Invariant: memory never holds more than one line and one buffer of the reader.

use std::io::{self, BufRead};

use crate::Fault;

/// The first word of a directive. Other programs take the line for a comment.
pub(crate) const DIRECTIVE: &str = "#cellray";

/// The byte-order mark, with which some programs begin UTF-8 text.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Limits of a scene's size, so that no file can take all memory or time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Limits {
    /// The most objects, the most lights, and the most materials.
    pub objects: usize,
    /// The most vertices of all polygons and patches together.
    pub vertices: usize,
    /// The most bytes in a line, without its end.
    pub line_bytes: usize,
    /// The most lines, including empty ones and comments.
    pub lines: u32,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            objects: 4_000_000,
            vertices: 16_000_000,
            line_bytes: 1024 * 1024,
            lines: 64_000_000,
        }
    }
}

/// A reader's lines, one at a time.
pub(crate) struct Lines<R> {
    reader: R,
    /// The current line, without its comment.
    bytes: Vec<u8>,
    /// Its number, from 1; 0 before the first.
    number: u32,
    /// Whether a following line feed belongs to the current line.
    after_return: bool,
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
            after_return: false,
            max_bytes: limits.line_bytes,
            max_lines: limits.lines,
        }
    }

    /// The number of the current line, from 1.
    pub(crate) fn number(&self) -> u32 {
        self.number
    }

    /// Reads the next line that has words; false at the end of the file.
    pub(crate) fn advance(&mut self) -> Result<bool, LineError> {
        while self.read()? {
            if self.bytes.iter().any(|byte| !byte.is_ascii_whitespace()) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The current line, without its comment. Comments need not be valid text.
    pub(crate) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Reads the next line into `bytes`; false at the end of the file.
    fn read(&mut self) -> Result<bool, LineError> {
        self.bytes.clear();
        loop {
            let buffer = match self.reader.fill_buf() {
                Ok(buffer) => buffer,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                Err(error) => return Err(LineError::Io(error)),
            };
            if std::mem::take(&mut self.after_return) && buffer.first() == Some(&b'\n') {
                self.reader.consume(1);
                continue;
            }
            if self.bytes.is_empty() && !buffer.is_empty() && self.number == self.max_lines {
                let limit = self.max_lines as usize;
                return Err(LineError::Fault(Fault::TooMany { what: "lines", limit }));
            }
            let is_end = |&byte: &u8| byte == b'\n' || byte == b'\r';
            let end = buffer.iter().position(is_end);
            let part = &buffer[..end.unwrap_or(buffer.len())];
            if part.len() > self.max_bytes - self.bytes.len() {
                self.number += 1;
                return Err(LineError::Fault(Fault::LongLine(self.max_bytes)));
            }
            self.bytes.extend_from_slice(part);
            self.after_return = end.is_some_and(|end| buffer[end] == b'\r');
            let (at_end, used) = (buffer.is_empty(), part.len() + usize::from(end.is_some()));
            self.reader.consume(used);
            if end.is_some() || at_end {
                let any = end.is_some() || !self.bytes.is_empty();
                self.number += u32::from(any);
                self.trim();
                return Ok(any);
            }
        }
    }

    /// Removes a byte-order mark and the comment.
    fn trim(&mut self) {
        if self.number == 1 && self.bytes.starts_with(BYTE_ORDER_MARK) {
            self.bytes.drain(..BYTE_ORDER_MARK.len());
        }
        let text = self.bytes.trim_ascii_start();
        let start = self.bytes.len() - text.len();
        let is_directive = text
            .strip_prefix(DIRECTIVE.as_bytes())
            .is_some_and(|rest| rest.first().is_none_or(u8::is_ascii_whitespace));
        let from = if is_directive { start + 1 } else { 0 };
        let comment = self.bytes[from..].iter().position(|&byte| byte == b'#');
        if let Some(at) = comment {
            self.bytes.truncate(from + at);
        }
    }
}
