//! `scanf`: reads fields of an input into the guest's memory.
//!
//! At most one character is read beyond a field, because no more can be pushed back. With `l`, text
//! is UTF-8 and becomes wide characters of 32 bits.

use super::Errno;
use super::directive::{Format, Length};
use super::guest::Guest;
use super::scan_set::Set;
use super::va_list::VaList;
use super::wide::{self, CHARACTER};

pub(super) trait Input {
    /// The next byte, or `None` at the end.
    fn next(&mut self) -> Result<Option<u8>, Errno>;
    /// Pushes back the byte that was read last.
    fn give_back(&mut self, byte: u8);
}

pub(super) struct Text {
    pub bytes: Vec<u8>,
    pub at: usize,
}

impl Input for Text {
    fn next(&mut self) -> Result<Option<u8>, Errno> {
        let byte = self.bytes.get(self.at).copied();
        self.at += usize::from(byte.is_some());
        Ok(byte)
    }

    fn give_back(&mut self, _: u8) {
        self.at -= 1;
    }
}

/// Why scanning ended before the end of the format.
enum End {
    /// The input ended.
    Input,
    /// The input does not match the format.
    Mismatch,
    Failed(Errno),
}

impl From<Errno> for End {
    fn from(errno: Errno) -> Self {
        Self::Failed(errno)
    }
}

struct Scanner<'a> {
    guest: Guest<'a>,
    arguments: VaList<'a>,
    input: &'a mut dyn Input,
    consumed: u64,
    assigned: i32,
    converted: bool,
}

/// Returns the number of fields that were assigned, or -1 if the input ended before the first.
pub(super) fn scan<'a>(
    guest: Guest<'a>,
    format: &[u8],
    arguments: VaList<'a>,
    input: &'a mut dyn Input,
) -> Result<i32, Errno> {
    let mut scanner =
        Scanner { guest, arguments, input, consumed: 0, assigned: 0, converted: false };
    match scanner.run(&mut Format::new(format)) {
        Ok(()) | Err(End::Mismatch) => Ok(scanner.assigned),
        Err(End::Input) if scanner.converted => Ok(scanner.assigned),
        Err(End::Input) => Ok(-1),
        Err(End::Failed(errno)) => Err(errno),
    }
}

/// Whether a byte is white space in C, which has one character more than in Rust.
fn is_space(byte: u8) -> bool {
    byte.is_ascii_whitespace() || byte == 0x0b
}

impl Scanner<'_> {
    fn next(&mut self) -> Result<Option<u8>, Errno> {
        let byte = self.input.next()?;
        self.consumed += u64::from(byte.is_some());
        Ok(byte)
    }

    fn give_back(&mut self, byte: u8) {
        self.input.give_back(byte);
        self.consumed -= 1;
    }

    fn skip_space(&mut self) -> Result<(), Errno> {
        while let Some(byte) = self.next()? {
            if !is_space(byte) {
                self.give_back(byte);
                break;
            }
        }
        Ok(())
    }

    fn expect(&mut self, wanted: u8) -> Result<(), End> {
        match self.next()? {
            None => Err(End::Input),
            Some(byte) if byte == wanted => Ok(()),
            Some(byte) => {
                self.give_back(byte);
                Err(End::Mismatch)
            }
        }
    }

    fn run(&mut self, format: &mut Format<'_>) -> Result<(), End> {
        while let Some(byte) = format.next() {
            if is_space(byte) {
                self.skip_space()?;
            } else if byte == b'%' {
                self.directive(format)?;
            } else {
                self.expect(byte)?;
            }
        }
        Ok(())
    }

    fn directive(&mut self, format: &mut Format<'_>) -> Result<(), End> {
        let store = !format.take(b'*');
        let width = format.number().filter(|&width| width > 0);
        let (length, long) = format.length();
        let conversion = format.next().ok_or(End::Mismatch)?;
        if !matches!(conversion, b'c' | b'[' | b'n') {
            self.skip_space()?;
        }
        match conversion {
            b'%' => return self.expect(b'%'),
            b'n' => {
                if store {
                    let consumed = self.consumed;
                    self.store_integer(consumed, length);
                }
                return Ok(());
            }
            b'd' | b'u' => self.integer(10, width, length, store)?,
            b'i' => self.integer(0, width, length, store)?,
            b'o' => self.integer(8, width, length, store)?,
            b'x' | b'X' | b'p' => self.integer(16, width, length, store)?,
            b'a' | b'A' | b'e' | b'E' | b'f' | b'F' | b'g' | b'G' => {
                let value = self.double(width.unwrap_or(usize::MAX))?;
                if store {
                    let address = self.arguments.word();
                    if long || length == Length::LongDouble {
                        self.guest.write(address, &value.to_be_bytes());
                    } else {
                        self.guest.write(address, &(value as f32).to_be_bytes());
                    }
                }
            }
            b'c' if long => self.wide_characters(width.unwrap_or(1), store)?,
            b'c' => self.characters(width.unwrap_or(1), store)?,
            b's' => {
                let most = width.unwrap_or(usize::MAX);
                self.text(most, store, long, |character| {
                    !u8::try_from(character).is_ok_and(is_space)
                })?;
            }
            b'[' => {
                let set = Set::parse(format, long).ok_or(End::Mismatch)?;
                let most = width.unwrap_or(usize::MAX);
                self.text(most, store, long, |character| set.contains(character))?;
            }
            _ => return Err(End::Mismatch),
        }
        self.converted = true;
        self.assigned += i32::from(store);
        Ok(())
    }

    fn store_integer(&mut self, value: u64, length: Length) {
        let address = self.arguments.word();
        self.guest.write(address, &value.to_be_bytes()[8 - length.bytes()..]);
    }

    /// Reads bytes as long as `goes_on` accepts them. It receives the bytes read so far.
    fn token(
        &mut self,
        most: usize,
        mut goes_on: impl FnMut(&[u8], u8) -> bool,
    ) -> Result<Vec<u8>, End> {
        let mut token = Vec::new();
        while token.len() < most {
            let Some(byte) = self.next()? else {
                if token.is_empty() {
                    return Err(End::Input);
                }
                break;
            };
            if !goes_on(&token, byte) {
                self.give_back(byte);
                break;
            }
            token.push(byte);
        }
        Ok(token)
    }

    fn integer(
        &mut self,
        base: u32,
        width: Option<usize>,
        length: Length,
        store: bool,
    ) -> Result<(), End> {
        let token = self.token(width.unwrap_or(usize::MAX), |so_far, byte| {
            let digits = unsigned_part(so_far);
            match byte {
                b'+' | b'-' => so_far.is_empty(),
                b'x' | b'X' => digits == b"0" && matches!(base, 0 | 16),
                _ => (byte as char).is_digit(actual_base(base, digits)),
            }
        })?;
        let value = integer_value(&token, base).ok_or(End::Mismatch)?;
        if store {
            self.store_integer(value, length);
        }
        Ok(())
    }

    fn double(&mut self, most: usize) -> Result<f64, End> {
        let token = self.token(most, |so_far, byte| {
            let mut longer = so_far.to_vec();
            longer.push(byte);
            super::float_syntax::is_prefix(&longer)
        })?;
        super::float_syntax::value(&token).ok_or(End::Mismatch)
    }

    fn characters(&mut self, count: usize, store: bool) -> Result<(), End> {
        let mut address = if store { self.arguments.word() } else { 0 };
        for _ in 0..count {
            let byte = self.next()?.ok_or(End::Input)?;
            if store {
                self.guest.write(address, &[byte]);
                address = address.wrapping_add(1);
            }
        }
        Ok(())
    }

    /// The next character of UTF-8, or `None` at the end of the input.
    fn next_wide(&mut self) -> Result<Option<char>, End> {
        let mut bytes = Vec::with_capacity(wide::LONGEST);
        loop {
            let Some(byte) = self.next()? else {
                return match bytes.is_empty() {
                    true => Ok(None),
                    false => Err(End::Failed(wide::INVALID)),
                };
            };
            bytes.push(byte);
            if let Some(character) = wide::decode(&bytes)? {
                return Ok(Some(character));
            }
        }
    }

    fn wide_characters(&mut self, count: usize, store: bool) -> Result<(), End> {
        let mut address = if store { self.arguments.word() } else { 0 };
        for _ in 0..count {
            let character = self.next_wide()?.ok_or(End::Input)?;
            if store {
                self.guest.set_word(address, character.into());
                address = address.wrapping_add(CHARACTER);
            }
        }
        Ok(())
    }

    /// A field of the characters that `belongs` accepts.
    fn text(
        &mut self,
        most: usize,
        store: bool,
        long: bool,
        belongs: impl Fn(u32) -> bool,
    ) -> Result<(), End> {
        if !long {
            return self.string(most, store, |byte| belongs(byte.into()));
        }
        let mut characters = Vec::new();
        while characters.len() < most {
            let Some(character) = self.next_wide()? else {
                if characters.is_empty() {
                    return Err(End::Input);
                }
                break;
            };
            if !belongs(character.into()) {
                for &byte in character.to_string().as_bytes().iter().rev() {
                    self.give_back(byte);
                }
                break;
            }
            characters.push(u32::from(character));
        }
        if characters.is_empty() {
            return Err(End::Mismatch);
        }
        if store {
            characters.push(0);
            let address = self.arguments.word();
            self.guest.set_words(address, &characters);
        }
        Ok(())
    }

    fn string(
        &mut self,
        most: usize,
        store: bool,
        belongs: impl Fn(u8) -> bool,
    ) -> Result<(), End> {
        // Bytes that don't fit into local store are still consumed, as in C.
        let token = self.token(most, |_, byte| belongs(byte))?;
        if token.is_empty() {
            return Err(End::Mismatch);
        }
        if store {
            let address = self.arguments.word();
            self.guest.set_string(address, &token);
        }
        Ok(())
    }
}

fn unsigned_part(token: &[u8]) -> &[u8] {
    match token {
        [b'+' | b'-', rest @ ..] => rest,
        _ => token,
    }
}

/// The base of the digits. With `%i`, the number's first characters determine it.
fn actual_base(base: u32, digits: &[u8]) -> u32 {
    match (base, digits) {
        (0, [b'0', b'x' | b'X', ..]) => 16,
        (0, [b'0', ..]) => 8,
        (0, _) => 10,
        _ => base,
    }
}

/// The low 64 bits of the value. As with `strtoll`, a value that is too large becomes the largest.
fn integer_value(token: &[u8], base: u32) -> Option<u64> {
    let negative = token.first() == Some(&b'-');
    let digits = unsigned_part(token);
    let base = actual_base(base, digits);
    let digits = match digits {
        // This follows glibc. In C a bare `0x` would be a mismatch.
        [b'0', b'x' | b'X'] => b"0",
        [b'0', b'x' | b'X', rest @ ..] if base == 16 => rest,
        _ => digits,
    };
    if digits.is_empty() {
        return None;
    }
    let mut value: u64 = 0;
    for &digit in digits {
        let digit = (digit as char).to_digit(base)?;
        value = value
            .checked_mul(u64::from(base))
            .and_then(|value| value.checked_add(u64::from(digit)))
            .unwrap_or(u64::MAX);
    }
    Some(if negative { value.wrapping_neg() } else { value })
}
