//! Reads the parts of a statement. Offsets are those of the source, also in messages.

use crate::diagnostic::Fault;

/// The source with its comments replaced by spaces, and its statements: ranges of bytes between
/// line ends and semicolons.
pub(crate) fn statements(source: &str) -> Result<(String, Vec<(usize, usize)>), Fault> {
    let bytes = source.as_bytes();
    let mut clean = bytes.to_vec();
    let mut found = Vec::new();
    let (mut start, mut at) = (0, 0);
    while at < bytes.len() {
        let next = bytes.get(at + 1).copied();
        match bytes[at] {
            b'"' => at = end_of_string(bytes, at),
            b'\'' if next.is_some_and(|next| next != b'\n') => {
                at += if next == Some(b'\\') { 2 } else { 1 };
                at += usize::from(bytes.get(at + 1) == Some(&b'\''));
            }
            b'#' => at = blank(&mut clean, at, end_of_line(bytes, at)),
            b'/' if next == Some(b'/') => at = blank(&mut clean, at, end_of_line(bytes, at)),
            b'/' if next == Some(b'*') => {
                let Some(length) = source[at + 2..].find("*/") else {
                    return Err(Fault::new(at, "this comment has no end"));
                };
                at = blank(&mut clean, at, at + 2 + length + 2);
            }
            b'\n' | b';' => {
                found.push((start, at));
                start = at + 1;
            }
            _ => {}
        }
        at += 1;
    }
    found.push((start, bytes.len()));
    // A comment is replaced from its first to its last byte, so no character is split.
    let clean = String::from_utf8(clean).map_err(|_| Fault::new(0, "the source is not UTF-8"))?;
    Ok((clean, found))
}

/// The closing quote of the string that starts here, or the last byte of its line.
fn end_of_string(bytes: &[u8], start: usize) -> usize {
    let mut at = start + 1;
    while at < bytes.len() && bytes[at] != b'\n' {
        match bytes[at] {
            b'"' => return at,
            b'\\' if bytes.get(at + 1).is_some_and(|&next| next != b'\n') => at += 2,
            _ => at += 1,
        }
    }
    at - 1
}

fn end_of_line(bytes: &[u8], at: usize) -> usize {
    bytes[at..].iter().position(|&byte| byte == b'\n').map_or(bytes.len(), |length| at + length)
}

/// Replaces a comment, and returns its last byte. Line ends in it stay, for the line numbers.
fn blank(clean: &mut [u8], start: usize, end: usize) -> usize {
    for byte in &mut clean[start..end] {
        if *byte != b'\n' {
            *byte = b' ';
        }
    }
    end - 1
}

const fn starts_name(c: char) -> bool {
    c.is_ascii_alphabetic() || matches!(c, '_' | '.')
}

const fn continues_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '$')
}

/// What is left of a statement.
#[derive(Clone)]
pub(crate) struct Cursor<'a> {
    text: &'a str,
    pub at: usize,
    end: usize,
}

impl<'a> Cursor<'a> {
    pub(crate) const fn new(text: &'a str, at: usize, end: usize) -> Self {
        Self { text, at, end }
    }

    /// The rest of the statement, as it is.
    pub(crate) fn rest(&self) -> &'a str {
        &self.text[self.at..self.end]
    }

    pub(crate) fn skip_space(&mut self) {
        self.at = self.end - self.rest().trim_start().len();
    }

    /// The next character after white space.
    pub(crate) fn peek(&mut self) -> Option<char> {
        self.skip_space();
        self.rest().chars().next()
    }

    pub(crate) fn is_at_end(&mut self) -> bool {
        self.peek().is_none()
    }

    /// Passes over this text if it is next.
    pub(crate) fn take(&mut self, text: &str) -> bool {
        self.skip_space();
        let found = self.rest().starts_with(text);
        if found {
            self.at += text.len();
        }
        found
    }

    pub(crate) fn expect(&mut self, text: &str) -> Result<(), Fault> {
        if self.take(text) {
            return Ok(());
        }
        Err(self.unexpected(&format!("`{text}`")))
    }

    /// The statement must end here.
    pub(crate) fn finish(&mut self) -> Result<(), Fault> {
        if self.is_at_end() { Ok(()) } else { Err(self.unexpected("the statement's end")) }
    }

    /// An error: something else should be next.
    pub(crate) fn unexpected(&mut self, expected: &str) -> Fault {
        self.skip_space();
        let found = match self.rest().split_whitespace().next() {
            Some(found) => format!("`{found}`"),
            None => "the statement's end".to_owned(),
        };
        Fault::new(self.at, format!("{found} where {expected} should be"))
    }

    /// Passes over characters of this kind, and returns them.
    pub(crate) fn take_while(&mut self, is_part: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let length = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    /// A name of a symbol, an instruction or a directive.
    pub(crate) fn name(&mut self) -> Option<&'a str> {
        self.peek().filter(|&c| starts_name(c))?;
        Some(self.take_while(continues_name))
    }

    pub(crate) fn expect_name(&mut self) -> Result<&'a str, Fault> {
        self.name().ok_or_else(|| self.unexpected("a name"))
    }

    /// Letters, digits and points that belong to one number.
    pub(crate) fn digits(&mut self) -> &'a str {
        self.take_while(continues_name)
    }

    /// The character of a constant such as `'a`, `'a'` or `'\n`, after its quote.
    pub(crate) fn character(&mut self) -> Result<u8, Fault> {
        let at = self.at;
        let first = self.byte().filter(u8::is_ascii);
        let first = first.ok_or_else(|| Fault::new(at, "a quote without an ASCII character"))?;
        let value = if first == b'\\' { self.escape()? } else { first };
        if self.rest().starts_with('\'') {
            self.at += 1;
        }
        Ok(value)
    }

    /// The bytes of a string in quotes.
    pub(crate) fn string(&mut self) -> Result<Vec<u8>, Fault> {
        self.skip_space();
        let start = self.at;
        self.expect("\"")?;
        let mut bytes = Vec::new();
        loop {
            match self.byte() {
                None => return Err(Fault::new(start, "this string has no end")),
                Some(b'"') => return Ok(bytes),
                Some(b'\\') => bytes.push(self.escape()?),
                Some(byte) => bytes.push(byte),
            }
        }
    }

    fn byte(&mut self) -> Option<u8> {
        let byte = self.text.as_bytes()[..self.end].get(self.at).copied();
        self.at += usize::from(byte.is_some());
        byte
    }

    /// The byte of an escape sequence, after its backslash. Of numbers the low eight bits count.
    fn escape(&mut self) -> Result<u8, Fault> {
        let at = self.at - 1;
        let Some(letter) = self.byte() else {
            return Err(Fault::new(at, "a backslash without a character"));
        };
        Ok(match letter {
            b'b' => 8,
            b'f' => 12,
            b'n' => 10,
            b'r' => 13,
            b't' => 9,
            b'\\' | b'"' | b'\'' => letter,
            b'x' | b'X' => {
                let digits = self.hexadecimal_digits();
                digits
                    .chars()
                    .filter_map(|c| c.to_digit(16))
                    .fold(0, |n: u8, digit| n << 4 | digit as u8)
            }
            b'0'..=b'7' => {
                let mut value = letter - b'0';
                for _ in 0..2 {
                    let next = self.rest().chars().next().and_then(|c| c.to_digit(8));
                    let Some(digit) = next else { break };
                    self.at += 1;
                    value = value << 3 | digit as u8;
                }
                value
            }
            _ => return Err(Fault::new(at, "an unknown escape sequence")),
        })
    }

    fn hexadecimal_digits(&mut self) -> &'a str {
        self.take_while(|c| c.is_ascii_hexdigit())
    }
}
