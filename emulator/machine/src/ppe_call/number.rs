//! Doubles as text, as C's `%f %e %g %a` print them.
//!
//! Decimal digits are exact for every precision, as the standard library's conversion is, with
//! ties rounded to even. The text has no sign: the caller adds it with the padding.

/// Whether a conversion uses capital letters, and whether it always prints a decimal point (the
/// `#` flag).
#[derive(Clone, Copy, Debug)]
pub(super) struct Style {
    pub upper: bool,
    pub alternate: bool,
}

/// A double has at most this many digits after the point. All further digits are 0.
const FRACTION_DIGITS: usize = 1074;
/// Number of digits if no precision is given.
const DEFAULT_PRECISION: usize = 6;
const MANTISSA_DIGITS: usize = 13;
const MANTISSA_BITS: u32 = 52;
const EXPONENT_BIAS: i32 = 1023;

/// The text of a magnitude for conversion `f`, `e`, `g` or `a` (in lower case).
pub(super) fn text(value: f64, conversion: u8, precision: Option<usize>, style: Style) -> String {
    let text = if value.is_nan() {
        "nan".to_owned()
    } else if value.is_infinite() {
        "inf".to_owned()
    } else {
        let digits = precision.unwrap_or(DEFAULT_PRECISION);
        match conversion {
            b'f' => fixed(value, digits, style.alternate),
            b'e' => scientific(value, digits, style.alternate),
            b'g' => shorter(value, digits.max(1), style.alternate),
            _ => hexadecimal(value, precision, style.alternate),
        }
    };
    if style.upper { text.to_ascii_uppercase() } else { text }
}

fn zeros(text: &mut String, count: usize) {
    text.extend(std::iter::repeat_n('0', count));
}

fn fixed(value: f64, precision: usize, point: bool) -> String {
    let exact = precision.min(FRACTION_DIGITS);
    let mut text = format!("{value:.exact$}");
    if point && precision == 0 {
        text.push('.');
    }
    zeros(&mut text, precision - exact);
    text
}

/// Digits `d.ddd`, with `precision` of them after the point, and the power of ten.
fn decimal(value: f64, precision: usize) -> (String, i32) {
    let exact = precision.min(FRACTION_DIGITS);
    let text = format!("{value:.exact$e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mut digits = digits.to_owned();
    zeros(&mut digits, precision - exact);
    (digits, exponent.parse().unwrap_or(0))
}

fn with_exponent(mut digits: String, exponent: i32, point: bool) -> String {
    if point && !digits.contains('.') {
        digits.push('.');
    }
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{digits}e{sign}{:02}", exponent.unsigned_abs())
}

fn scientific(value: f64, precision: usize, point: bool) -> String {
    let (digits, exponent) = decimal(value, precision);
    with_exponent(digits, exponent, point)
}

fn without_trailing_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// `%g`: the exponent that `%e` would print decides between the two forms.
fn shorter(value: f64, precision: usize, keep_zeros: bool) -> String {
    let (digits, exponent) = decimal(value, precision - 1);
    let fits = i64::from(exponent) < precision as i64;
    if fits && exponent >= -4 {
        let after_point = (precision as i64 - 1 - i64::from(exponent)) as usize;
        let text = fixed(value, after_point, keep_zeros);
        return if keep_zeros { text } else { without_trailing_zeros(&text).to_owned() };
    }
    if keep_zeros {
        return with_exponent(digits, exponent, true);
    }
    with_exponent(without_trailing_zeros(&digits).to_owned(), exponent, false)
}

fn hexadecimal(value: f64, precision: Option<usize>, point: bool) -> String {
    let bits = value.to_bits();
    let mut fraction = bits & ((1 << MANTISSA_BITS) - 1);
    let biased = (bits >> MANTISSA_BITS & 0x7ff) as i32;
    let (mut leading, exponent) = match (biased, fraction) {
        (0, 0) => (0, 0),
        (0, _) => (0, 1 - EXPONENT_BIAS),
        _ => (1, biased - EXPONENT_BIAS),
    };
    let digits = match precision {
        Some(kept) if kept < MANTISSA_DIGITS => {
            let dropped = (MANTISSA_DIGITS - kept) * 4;
            let whole = leading << MANTISSA_BITS | fraction;
            let (unit, half) = (1 << dropped, 1_u64 << (dropped - 1));
            let mut rounded = whole >> dropped;
            let rest = whole & (unit - 1);
            if rest > half || (rest == half && rounded & 1 == 1) {
                rounded += 1;
            }
            leading = rounded >> (kept * 4);
            fraction = rounded & ((1 << (kept * 4)) - 1);
            if kept == 0 { String::new() } else { format!("{fraction:0kept$x}") }
        }
        Some(wanted) => {
            let mut text = format!("{fraction:0MANTISSA_DIGITS$x}");
            zeros(&mut text, wanted - MANTISSA_DIGITS);
            text
        }
        None => {
            let text = format!("{fraction:0MANTISSA_DIGITS$x}");
            text.trim_end_matches('0').to_owned()
        }
    };
    let point = if point || !digits.is_empty() { "." } else { "" };
    format!("0x{leading:x}{point}{digits}p{exponent:+}")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Provenance: typed by hand from the output of C's printf (glibc 2.36).
    #[test]
    fn doubles_print_as_in_c() {
        let plain = Style { upper: false, alternate: false };
        let cases: &[(f64, u8, Option<usize>, &str)] = &[
            (0.5, b'f', Some(0), "0"),
            (1.5, b'f', Some(0), "2"),
            (2.5, b'f', Some(0), "2"),
            (0.125, b'f', Some(2), "0.12"),
            (0.375, b'f', Some(2), "0.38"),
            (1e22, b'f', None, "10000000000000000000000.000000"),
            (0.1, b'f', Some(20), "0.10000000000000000555"),
            (12345.678, b'e', None, "1.234568e+04"),
            (0.0, b'e', Some(1), "0.0e+00"),
            (1e-310, b'e', Some(3), "1.000e-310"),
            (9.5, b'e', Some(0), "1e+01"),
            (8.5, b'e', Some(0), "8e+00"),
            (100_000.0, b'g', None, "100000"),
            (1_000_000.0, b'g', None, "1e+06"),
            (0.0001, b'g', None, "0.0001"),
            (0.000_01, b'g', None, "1e-05"),
            (123.456, b'g', Some(0), "1e+02"),
            (999_999.5, b'g', None, "1e+06"),
            (0.0, b'g', None, "0"),
            (1.0, b'a', None, "0x1p+0"),
            (3.5, b'a', None, "0x1.cp+1"),
            (1.9999, b'a', Some(0), "0x2p+0"),
            (1.5, b'a', Some(0), "0x2p+0"),
            (0.1, b'a', Some(3), "0x1.99ap-4"),
            (5e-324, b'a', None, "0x0.0000000000001p-1022"),
            (1.0, b'a', Some(15), "0x1.000000000000000p+0"),
        ];
        for &(value, conversion, precision, expected) in cases {
            let found = text(value, conversion, precision, plain);
            assert_eq!(found, expected, "{value:e} %{}", conversion as char);
        }
        let alternate = Style { upper: true, alternate: true };
        assert_eq!(text(1.0, b'g', None, alternate), "1.00000");
        assert_eq!(text(1e10, b'g', Some(1), alternate), "1.E+10");
        assert_eq!(text(2.0, b'f', Some(0), alternate), "2.");
        assert_eq!(text(f64::NAN, b'f', None, alternate), "NAN");
        assert_eq!(text(2.0, b'f', Some(1080), plain).len(), 1082);
    }
}
