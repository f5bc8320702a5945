//! `printf`: prints a format with the guest's arguments.
//!
//! It follows glibc, which serves these calls on the console. A null `%p` prints `(nil)`, and an
//! unknown conversion is printed unchanged. Positional arguments (`%1$d`) are not supported.

use super::Errno;
use super::directive::{Count, Format, Length};
use super::guest::Guest;
use super::number::{self, Style};
use super::va_list::VaList;
use super::wide::{self, CHARACTER};

/// The largest number of bytes that one call may print. A width of two billion is an error, as it
/// is in C.
const MOST: usize = 16 << 20;
const TOO_LONG: Errno = Errno(libc::EOVERFLOW);

#[derive(Clone, Copy, Default)]
struct Flags {
    left: bool,
    plus: bool,
    space: bool,
    alternate: bool,
    zeros: bool,
}

impl Flags {
    fn parse(format: &mut Format<'_>) -> Self {
        let mut flags = Self::default();
        while let Some(byte) = format.peek() {
            match byte {
                b'-' => flags.left = true,
                b'+' => flags.plus = true,
                b' ' => flags.space = true,
                b'#' => flags.alternate = true,
                b'0' => flags.zeros = true,
                // The flag requests grouping, but the C locale does not group digits.
                b'\'' => {}
                _ => break,
            }
            format.next();
        }
        flags
    }

    fn sign(self, negative: bool) -> &'static str {
        match self {
            _ if negative => "-",
            Self { plus: true, .. } => "+",
            Self { space: true, .. } => " ",
            _ => "",
        }
    }
}

struct Printer<'a> {
    guest: Guest<'a>,
    arguments: VaList<'a>,
    text: Vec<u8>,
}

/// The bytes that `format` prints with these arguments.
pub(super) fn print(
    guest: Guest<'_>,
    format: &[u8],
    arguments: VaList<'_>,
) -> Result<Vec<u8>, Errno> {
    let mut printer = Printer { guest, arguments, text: Vec::new() };
    let mut format = Format::new(format);
    while let Some(byte) = format.next() {
        if byte == b'%' {
            printer.directive(&mut format)?;
        } else {
            printer.put(&[byte])?;
        }
    }
    Ok(printer.text)
}

impl Printer<'_> {
    fn put(&mut self, bytes: &[u8]) -> Result<(), Errno> {
        if self.text.len() + bytes.len() > MOST {
            return Err(TOO_LONG);
        }
        self.text.extend_from_slice(bytes);
        Ok(())
    }

    fn fill(&mut self, byte: u8, count: usize) -> Result<(), Errno> {
        if self.text.len().saturating_add(count) > MOST {
            return Err(TOO_LONG);
        }
        self.text.resize(self.text.len() + count, byte);
        Ok(())
    }

    /// Prints `prefix` (sign, `0x`) and `body` in a field. Zeros go between the two.
    fn field(
        &mut self,
        flags: Flags,
        width: usize,
        prefix: &[u8],
        body: &[u8],
    ) -> Result<(), Errno> {
        let padding = width.saturating_sub(prefix.len() + body.len());
        if !flags.left && !flags.zeros {
            self.fill(b' ', padding)?;
        }
        self.put(prefix)?;
        if !flags.left && flags.zeros {
            self.fill(b'0', padding)?;
        }
        self.put(body)?;
        if flags.left {
            self.fill(b' ', padding)?;
        }
        Ok(())
    }

    fn directive(&mut self, format: &mut Format<'_>) -> Result<(), Errno> {
        let start = format.rest();
        let mut flags = Flags::parse(format);
        let width = match format.count() {
            None => 0,
            Some(Count::Number(width)) => width,
            Some(Count::Argument) => {
                let width = self.arguments.word() as i32;
                flags.left |= width < 0;
                width.unsigned_abs() as usize
            }
        };
        let precision = if format.take(b'.') {
            match format.count() {
                None => Some(0),
                Some(Count::Number(precision)) => Some(precision),
                // A negative precision counts as none.
                Some(Count::Argument) => usize::try_from(self.arguments.word() as i32).ok(),
            }
        } else {
            None
        };
        let (length, wide) = format.length();
        if width > MOST || precision.is_some_and(|precision| precision > MOST) {
            return Err(TOO_LONG);
        }
        let Some(conversion) = format.next() else {
            // The format ends within a conversion specification.
            return Err(Errno(libc::EINVAL));
        };
        match conversion {
            b'd' | b'i' => {
                let value = self.signed(length);
                let sign = flags.sign(value < 0);
                let digits = value.unsigned_abs().to_string();
                self.integer(flags, width, precision, sign, &digits, value == 0)
            }
            b'u' | b'o' | b'x' | b'X' => {
                let value = self.unsigned(length);
                self.unsigned_field(flags, width, precision, conversion, value)
            }
            b'c' => {
                let value = self.arguments.word();
                flags.zeros = false;
                if wide {
                    let text = wide::encode(value)?;
                    self.field(flags, width, &[], &text)
                } else {
                    self.field(flags, width, &[], &[value as u8])
                }
            }
            b's' => {
                let address = self.arguments.word();
                let text = if wide {
                    self.wide_string(address, precision)?
                } else {
                    let most = precision.map_or(u32::MAX, |most| most as u32);
                    self.guest.string_of_at_most(address, most)
                };
                flags.zeros = false;
                self.field(flags, width, &[], &text)
            }
            b'p' => {
                let value = self.arguments.word();
                flags.zeros = false;
                let text = if value == 0 { "(nil)".to_owned() } else { format!("{value:#x}") };
                self.field(flags, width, &[], text.as_bytes())
            }
            b'a' | b'A' | b'e' | b'E' | b'f' | b'F' | b'g' | b'G' => {
                let value = f64::from_bits(self.arguments.doubleword());
                self.double(flags, width, precision, conversion, value)
            }
            b'n' => {
                let address = self.arguments.word();
                let count = (self.text.len() as u64).to_be_bytes();
                self.guest.write(address, &count[8 - length.bytes()..]);
                Ok(())
            }
            b'%' => self.put(b"%"),
            _ => {
                let written = start.len() - format.rest().len();
                self.put(b"%")?;
                self.put(&start[..written])
            }
        }
    }

    fn signed(&mut self, length: Length) -> i64 {
        match length {
            Length::Char => i64::from(self.arguments.word() as i8),
            Length::Short => i64::from(self.arguments.word() as i16),
            Length::Word => i64::from(self.arguments.word() as i32),
            Length::Long | Length::LongDouble => self.arguments.doubleword() as i64,
        }
    }

    fn unsigned(&mut self, length: Length) -> u64 {
        match length {
            Length::Char => u64::from(self.arguments.word() as u8),
            Length::Short => u64::from(self.arguments.word() as u16),
            Length::Word => u64::from(self.arguments.word()),
            Length::Long | Length::LongDouble => self.arguments.doubleword(),
        }
    }

    fn integer(
        &mut self,
        mut flags: Flags,
        width: usize,
        precision: Option<usize>,
        prefix: &str,
        digits: &str,
        is_zero: bool,
    ) -> Result<(), Errno> {
        // The precision is the minimum number of digits. With precision 0, the value 0 prints
        // nothing.
        let body = match precision {
            Some(0) if is_zero => String::new(),
            Some(precision) => {
                let zeros = precision.saturating_sub(digits.len());
                "0".repeat(zeros) + digits
            }
            None => digits.to_owned(),
        };
        flags.zeros &= precision.is_none();
        self.field(flags, width, prefix.as_bytes(), body.as_bytes())
    }

    fn unsigned_field(
        &mut self,
        flags: Flags,
        width: usize,
        precision: Option<usize>,
        conversion: u8,
        value: u64,
    ) -> Result<(), Errno> {
        let is_zero = value == 0;
        let (prefix, mut digits) = match conversion {
            b'o' => ("", format!("{value:o}")),
            b'x' => ("0x", format!("{value:x}")),
            b'X' => ("0X", format!("{value:X}")),
            _ => ("", value.to_string()),
        };
        // The alternate form of `o` begins with a 0, so add one unless there already is one.
        if conversion == b'o' && flags.alternate {
            if is_zero {
                let precision = precision.map(|digits| digits.max(1));
                return self.integer(flags, width, precision, "", &digits, is_zero);
            }
            if precision.is_none_or(|precision| precision <= digits.len()) {
                digits.insert(0, '0');
            }
        }
        let prefix = if flags.alternate && !is_zero { prefix } else { "" };
        self.integer(flags, width, precision, prefix, &digits, is_zero)
    }

    fn double(
        &mut self,
        mut flags: Flags,
        width: usize,
        precision: Option<usize>,
        conversion: u8,
        value: f64,
    ) -> Result<(), Errno> {
        let style = Style { upper: conversion.is_ascii_uppercase(), alternate: flags.alternate };
        let lower = conversion.to_ascii_lowercase();
        let text = number::text(value.abs(), lower, precision, style);
        flags.zeros &= value.is_finite();
        let sign = flags.sign(value.is_sign_negative());
        // Zeros go after the `0x` too.
        let (base, digits) =
            if lower == b'a' && value.is_finite() { text.split_at(2) } else { ("", text.as_str()) };
        let prefix = format!("{sign}{base}");
        self.field(flags, width, prefix.as_bytes(), digits.as_bytes())
    }

    /// Converts 32-bit characters up to a 0 to UTF-8. Only whole characters are converted, of at
    /// most `precision` bytes in total.
    fn wide_string(&self, address: u32, precision: Option<usize>) -> Result<Vec<u8>, Errno> {
        let mut text = Vec::new();
        for n in 0..crate::local_store::SIZE / CHARACTER {
            let character = self.guest.word(address.wrapping_add(n * CHARACTER));
            if character == 0 {
                break;
            }
            let bytes = wide::encode(character)?;
            if precision.is_some_and(|most| text.len() + bytes.len() > most) {
                break;
            }
            text.extend(bytes);
        }
        Ok(text)
    }
}
