//! The syntax of floating-point numbers in C, for `scanf`.

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
    let text = std::str::from_utf8(text).ok()?.to_ascii_lowercase();
    let (negative, magnitude) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(&text)),
    };
    let value = match magnitude.strip_prefix("0x") {
        Some(digits) => hexadecimal(digits),
        None => magnitude.parse().ok()?,
    };
    Some(if negative { -value } else { value })
}

/// The value of a hexadecimal number. Digits beyond those that fit only determine whether there is
/// a remainder.
fn hexadecimal(text: &str) -> f64 {
    let (digits, exponent) = text.split_once('p').unwrap_or((text, "0"));
    // An exponent that does not fit is too large for any number of digits that fits.
    let limit = if exponent.starts_with('-') { -(1 << 20) } else { 1 << 20 };
    let mut exponent: i64 = exponent.parse().unwrap_or(limit).clamp(-(1 << 20), 1 << 20);
    let mut mantissa: u64 = 0;
    let mut after_point = false;
    for byte in digits.bytes() {
        if byte == b'.' {
            after_point = true;
            continue;
        }
        let digit = u64::from((byte as char).to_digit(16).unwrap_or(0));
        if mantissa >> 58 == 0 {
            mantissa = mantissa << 4 | digit;
            exponent -= if after_point { 4 } else { 0 };
        } else {
            mantissa |= u64::from(digit != 0);
            exponent += if after_point { 0 } else { 4 };
        }
    }
    scale(mantissa, exponent)
}

/// `mantissa * 2^exponent`, rounded once, with ties to even.
fn scale(mantissa: u64, exponent: i64) -> f64 {
    if mantissa == 0 {
        return 0.0;
    }
    let shift = i64::from(mantissa.leading_zeros());
    let mantissa = mantissa << shift;
    // The value is mantissa / 2^63 * 2^top.
    let top = exponent - shift + 63;
    if top > 1023 {
        return f64::INFINITY;
    }
    // A normal number keeps 53 bits, a subnormal one as many as remain.
    let kept = (top + 1075).clamp(0, 53);
    if kept == 0 && top < -1075 {
        return 0.0;
    }
    let dropped = (64 - kept) as u32;
    let whole = u128::from(mantissa);
    let mut rounded = whole >> dropped;
    let rest = whole & ((1 << dropped) - 1);
    let half = 1_u128 << (dropped - 1);
    if rest > half || (rest == half && rounded & 1 == 1) {
        rounded += 1;
    }
    // The implicit bit adds one to the exponent field, and so does a carry.
    let field = (top + 1022).max(0) as u64;
    if top >= -1022 {
        f64::from_bits((field << 52) + rounded as u64)
    } else {
        f64::from_bits(rounded as u64)
    }
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
