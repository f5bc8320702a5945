//! `printf`: prints a format with the guest's arguments.
//!
//! The C library prints the numbers, as the console's does, which serves these calls there. A null
//! `%p` prints `(nil)`, and an unknown conversion is printed unchanged, as by glibc. Positional
//! arguments (`%1$d`) are not supported.

use std::ffi::CString;

use super::Errno;
use super::directive::{Count, Format, Length};
use super::guest::Guest;
use super::va_list::VaList;
use super::wide::{self, CHARACTER};

/// The largest number of bytes that one call may print. A width of two billion is an error, as it
/// is in C.
const MOST: usize = 16 << 20;
const TOO_LONG: Errno = Errno(libc::EOVERFLOW);

/// The flags, the width, which is negative if the text is at the left, and the precision, which is
/// negative if there is none.
struct Field {
    flags: String,
    width: i32,
    precision: i32,
}

#[derive(Clone, Copy)]
enum Number {
    Integer(u64),
    Double(f64),
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

    /// Prints text in a field.
    fn padded(&mut self, field: &Field, text: &[u8]) -> Result<(), Errno> {
        let width = field.width.unsigned_abs() as usize;
        let padding = vec![b' '; width.saturating_sub(text.len())];
        let left = field.width < 0 || field.flags.contains('-');
        let [first, second] = if left { [text, &padding] } else { [&padding, text] };
        self.put(first)?;
        self.put(second)
    }

    /// Prints a number in a field, as the C library does.
    fn number(&mut self, field: &Field, conversion: u8, number: Number) -> Result<(), Errno> {
        let Field { flags, width, precision } = field;
        let length = if matches!(number, Number::Integer(_)) { "ll" } else { "" };
        let format = format!("%{flags}*.*{length}{}", char::from(conversion));
        let format = CString::new(format).map_err(|_| Errno(libc::EINVAL))?;
        // SAFETY: the format takes two `int`s and an argument of this type. No more than `into`
        // holds is written.
        let print = |into: &mut [u8]| unsafe {
            let (at, size, format) = (into.as_mut_ptr().cast(), into.len(), format.as_ptr());
            match number {
                Number::Integer(value) => {
                    libc::snprintf(at, size, format, *width, *precision, value)
                }
                Number::Double(value) => {
                    libc::snprintf(at, size, format, *width, *precision, value)
                }
            }
        };
        let mut text = vec![0; 64];
        let needed = usize::try_from(print(&mut text)).map_err(|_| TOO_LONG)?;
        if needed >= text.len() {
            text.resize(needed + 1, 0);
            print(&mut text);
        }
        self.put(&text[..needed])
    }

    fn count(&mut self, format: &mut Format<'_>) -> Option<i32> {
        format.count().map(|count| match count {
            Count::Number(number) => i32::try_from(number).unwrap_or(i32::MAX),
            Count::Argument => self.arguments.word() as i32,
        })
    }

    fn directive(&mut self, format: &mut Format<'_>) -> Result<(), Errno> {
        let start = format.rest();
        let mut flags = String::new();
        while let Some(flag @ (b'-' | b'+' | b' ' | b'#' | b'0' | b'\'')) = format.peek() {
            // `'` requests grouping, but the C locale does not group digits.
            if flag != b'\'' {
                flags.push(flag.into());
            }
            format.next();
        }
        let width = self.count(format).unwrap_or(0);
        let precision = if format.take(b'.') { self.count(format).unwrap_or(0) } else { -1 };
        let (length, wide) = format.length();
        if width.unsigned_abs().max(precision.max(0) as u32) as usize > MOST {
            return Err(TOO_LONG);
        }
        let field = Field { flags, width, precision };
        let Some(conversion) = format.next() else {
            // The format ends within a conversion specification.
            return Err(Errno(libc::EINVAL));
        };
        match conversion {
            b'd' | b'i' => {
                let value = self.signed(length) as u64;
                self.number(&field, conversion, Number::Integer(value))
            }
            b'u' | b'o' | b'x' | b'X' => {
                let value = self.unsigned(length);
                self.number(&field, conversion, Number::Integer(value))
            }
            b'a' | b'A' | b'e' | b'E' | b'f' | b'F' | b'g' | b'G' => {
                let value = f64::from_bits(self.arguments.doubleword());
                self.number(&field, conversion, Number::Double(value))
            }
            b'c' => {
                let value = self.arguments.word();
                let text = if wide { wide::encode(value)? } else { vec![value as u8] };
                self.padded(&field, &text)
            }
            b's' => {
                let address = self.arguments.word();
                let most = u32::try_from(precision).unwrap_or(u32::MAX);
                let text = if wide {
                    self.wide_string(address, most as usize)?
                } else {
                    self.guest.string_of_at_most(address, most)
                };
                self.padded(&field, &text)
            }
            b'p' => {
                let value = self.arguments.word();
                let text = if value == 0 { "(nil)".to_owned() } else { format!("{value:#x}") };
                self.padded(&field, text.as_bytes())
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

    /// Converts 32-bit characters up to a 0 to UTF-8. Only whole characters are converted, of at
    /// most `most` bytes in total.
    fn wide_string(&self, address: u32, most: usize) -> Result<Vec<u8>, Errno> {
        let mut text = Vec::new();
        for n in 0..crate::local_store::SIZE / CHARACTER {
            let character = self.guest.word(address.wrapping_add(n * CHARACTER));
            if character == 0 {
                break;
            }
            let bytes = wide::encode(character)?;
            if text.len() + bytes.len() > most {
                break;
            }
            text.extend(bytes);
        }
        Ok(text)
    }
}
