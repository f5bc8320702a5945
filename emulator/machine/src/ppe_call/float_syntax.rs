//! The syntax of floating-point numbers in C, for `scanf`.

use std::ffi::CString;
use std::ptr;

/// How far a number has been read.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Start,
    Signed,
    /// A single 0, after which an `x` may follow.
    Zero,
    Whole {
        hex: bool,
        digits: bool,
    },
    Fraction {
        hex: bool,
        digits: bool,
    },
    Exponent,
    ExponentSigned,
    ExponentDigits,
    /// In one of the words, after this many letters of it.
    Infinity(usize),
    Nan(usize),
}

const INFINITY: &[u8] = b"infinity";
const NAN: &[u8] = b"nan";
/// Number of letters of the short form of infinity.
const INF: usize = 3;

impl State {
    fn after(self, byte: u8) -> Option<Self> {
        let lower = byte.to_ascii_lowercase();
        let digit = |hex: bool| {
            if hex { byte.is_ascii_hexdigit() } else { byte.is_ascii_digit() }
        };
        let exponent = |hex: bool| lower == if hex { b'p' } else { b'e' };
        Some(match self {
            Self::Start if matches!(byte, b'+' | b'-') => Self::Signed,
            Self::Start | Self::Signed => match lower {
                b'0' => Self::Zero,
                b'1'..=b'9' => Self::Whole { hex: false, digits: true },
                b'.' => Self::Fraction { hex: false, digits: false },
                b'i' => Self::Infinity(1),
                b'n' => Self::Nan(1),
                _ => return None,
            },
            Self::Zero if lower == b'x' => Self::Whole { hex: true, digits: false },
            Self::Zero => {
                let whole = Self::Whole { hex: false, digits: true };
                return whole.after(byte);
            }
            Self::Whole { hex, .. } if digit(hex) => Self::Whole { hex, digits: true },
            Self::Whole { hex, digits } if byte == b'.' => Self::Fraction { hex, digits },
            Self::Fraction { hex, .. } if digit(hex) => Self::Fraction { hex, digits: true },
            Self::Whole { hex, digits: true } | Self::Fraction { hex, digits: true }
                if exponent(hex) =>
            {
                Self::Exponent
            }
            Self::Exponent if matches!(byte, b'+' | b'-') => Self::ExponentSigned,
            Self::Exponent | Self::ExponentSigned | Self::ExponentDigits
                if byte.is_ascii_digit() =>
            {
                Self::ExponentDigits
            }
            Self::Infinity(n) if INFINITY.get(n) == Some(&lower) => Self::Infinity(n + 1),
            Self::Nan(n) if NAN.get(n) == Some(&lower) => Self::Nan(n + 1),
            _ => return None,
        })
    }

    fn is_whole_number(self) -> bool {
        match self {
            Self::Zero | Self::ExponentDigits => true,
            Self::Whole { digits, .. } | Self::Fraction { digits, .. } => digits,
            Self::Infinity(n) => n == INF || n == INFINITY.len(),
            Self::Nan(n) => n == NAN.len(),
            _ => false,
        }
    }
}

fn state(text: &[u8]) -> Option<State> {
    text.iter().try_fold(State::Start, |state, &byte| state.after(byte))
}

/// Whether a number can start with `text`.
pub(super) fn is_prefix(text: &[u8]) -> bool {
    state(text).is_some()
}

/// The value of `text`, if it is a complete number.
pub(super) fn value(text: &[u8]) -> Option<f64> {
    state(text).filter(|state| state.is_whole_number())?;
    let text = CString::new(text).ok()?;
    // SAFETY: the text ends in 0, and nobody asks where its number ends.
    Some(unsafe { libc::strtod(text.as_ptr(), ptr::null_mut()) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_recognised() {
        for (text, expected) in [
            ("1", 1.0),
            ("-1.5e3", -1500.0),
            (".25", 0.25),
            ("7.", 7.0),
            ("+0x1.8p1", 3.0),
            ("0x.8", 0.5),
            ("0x10", 16.0),
            ("0x1p-1074", 5e-324),
            ("0x1p-1075", 0.0),
            ("0x1.8p-1075", 5e-324),
            ("0x1.fffffffffffffp1023", f64::MAX),
            ("0x1.fffffffffffff8p1023", f64::INFINITY),
            ("0x1.00000000000008p0", 1.0),
            ("0x1.000000000000080001p0", 1.0 + f64::EPSILON),
            ("0x123456789abcdef012345", 1.375_488_932_539_311_4e24),
            ("0x1p99999999999999999999", f64::INFINITY),
            ("0x1p-99999999999999999999", 0.0),
            ("-infinity", f64::NEG_INFINITY),
            ("INF", f64::INFINITY),
            ("1e400", f64::INFINITY),
        ] {
            assert_eq!(value(text.as_bytes()), Some(expected), "{text}");
        }
        assert!(value(b"nan").is_some_and(f64::is_nan));
        for text in ["", "-", ".", "1e", "1e+", "0x", "0x.", "infi", "na"] {
            assert_eq!(value(text.as_bytes()), None, "{text}");
            assert!(is_prefix(text.as_bytes()), "{text}");
        }
        for text in ["x", "1.2.", "1ee", "0xg", "--1", ".e1", "infx", "0x1.8e+1"] {
            assert!(!is_prefix(text.as_bytes()), "{text}");
        }
    }
}
