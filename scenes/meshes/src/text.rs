//! Lines and words of text files, whose bytes may be of any encoding.

use std::borrow::Cow;

/// The marks at the beginning of a text that isn't UTF-8, with the names of the encodings.
const OTHER_MARKS: [(&[u8], &str); 4] = [
    (&[0xff, 0xfe, 0, 0], "UTF-32"),
    (&[0, 0, 0xfe, 0xff], "UTF-32"),
    (&[0xff, 0xfe], "UTF-16"),
    (&[0xfe, 0xff], "UTF-16"),
];

/// The text after a byte-order mark, or the name of its encoding if the words can't be read.
pub(crate) fn without_mark(bytes: &[u8]) -> Result<&[u8], &'static str> {
    for (mark, name) in OTHER_MARKS {
        if bytes.starts_with(mark) {
            return Err(name);
        }
    }
    Ok(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes))
}

/// Lines that end with LF, CR or both. A line that ends with a backslash goes on in the next one.
pub(crate) struct Lines<'a> {
    rest: Option<&'a [u8]>,
    number: usize,
}

impl<'a> Lines<'a> {
    pub fn new(text: &'a [u8]) -> Self {
        let rest = Some(text);
        Self { rest, number: 0 }
    }

    fn physical(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest?;
        self.number += 1;
        let Some(end) = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')) else {
            self.rest = None;
            return Some(rest);
        };
        let length = if rest[end..].starts_with(b"\r\n") { 2 } else { 1 };
        self.rest = Some(&rest[end + length..]);
        Some(&rest[..end])
    }
}

/// The part before a backslash that joins a line with the next one. The last byte of a character
/// of GBK or Shift-JIS, and the end of a Windows folder's name, look the same, so the backslash
/// must come after a blank or a number.
fn continued(line: &[u8]) -> Option<&[u8]> {
    let before = line.trim_ascii_end().strip_suffix(b"\\")?;
    let is_comment = line.trim_ascii_start().starts_with(b"#");
    let last = before.last().copied().unwrap_or(b' ');
    let may_end =
        last.is_ascii_whitespace() || last.is_ascii_digit() || matches!(last, b'.' | b'/');
    (!is_comment && may_end).then_some(before)
}

impl<'a> Iterator for Lines<'a> {
    /// The number of a line's beginning, from 1, and its text.
    type Item = (usize, Cow<'a, [u8]>);

    fn next(&mut self) -> Option<Self::Item> {
        let line = self.physical()?;
        let number = self.number;
        let Some(mut part) = continued(line) else {
            return Some((number, Cow::Borrowed(line)));
        };
        let mut whole = Vec::new();
        loop {
            whole.extend_from_slice(part);
            whole.push(b' ');
            let Some(line) = self.physical() else {
                break;
            };
            match continued(line) {
                Some(next) => part = next,
                None => {
                    whole.extend_from_slice(line);
                    break;
                }
            }
        }
        Some((number, Cow::Owned(whole)))
    }
}

/// The words between blanks.
pub(crate) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

/// The first word, and the text after the blanks that follow it.
pub(crate) fn first_word(line: &[u8]) -> (&[u8], &[u8]) {
    let line = line.trim_ascii();
    let end = line.iter().position(u8::is_ascii_whitespace);
    let (word, rest) = line.split_at(end.unwrap_or(line.len()));
    (word, rest.trim_ascii_start())
}

/// The part before a comment.
pub(crate) fn without_comment(line: &[u8]) -> &[u8] {
    line.split(|&byte| byte == b'#').next().unwrap_or_default()
}

/// A number; `None` if the word is none, or is not finite.
pub(crate) fn number(word: &[u8]) -> Option<f64> {
    any_number(word).filter(|number| number.is_finite())
}

/// A number, which may be NaN or infinite.
pub(crate) fn any_number(word: &[u8]) -> Option<f64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// A word or a name, shortened and quoted for a message.
pub(crate) fn shown(word: &[u8]) -> scenes::Excerpt {
    scenes::Excerpt::of(&String::from_utf8_lossy(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &[u8]) -> Vec<(usize, Vec<u8>)> {
        Lines::new(text).map(|(number, line)| (number, line.into_owned())).collect()
    }

    #[test]
    fn lines_end_with_any_of_three_ends() {
        let expected = [(1, b"a".to_vec()), (2, b"b".to_vec()), (3, Vec::new())];
        for text in ["a\nb\n", "a\rb\r", "a\r\nb\r\n"] {
            assert_eq!(lines(text.as_bytes()), expected, "{text:?}");
        }
    }

    #[test]
    fn continued_line_has_number_of_first_line() {
        let found = lines(b"f 1 2 \\\r\n 3\\\n4\nv");
        let expected = [(1, b"f 1 2   3 4".to_vec()), (4, b"v".to_vec())];
        assert_eq!(found, expected);
    }

    #[test]
    fn backslashes_in_comments_and_names_do_not_continue() {
        for text in [&b"# C:\\\nv"[..], b"map_Kd C:\\maps\\\nv", b"usemtl \x90\\\nv"] {
            assert_eq!(lines(text).len(), 2, "{}", String::from_utf8_lossy(text));
        }
    }

    #[test]
    fn byte_order_marks_select_encoding() {
        assert_eq!(without_mark(b"\xef\xbb\xbfv"), Ok(&b"v"[..]));
        assert_eq!(without_mark(b"\xff\xfev\0"), Err("UTF-16"));
        assert_eq!(without_mark(b"\xff\xfe\0\0v"), Err("UTF-32"));
    }
}
