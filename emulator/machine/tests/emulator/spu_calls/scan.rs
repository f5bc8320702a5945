use std::ffi::CString;

use proptest::prelude::*;

use super::support::{GuestProgram, Reply, Value};

/// The addresses of results, a line apart.
const RESULTS: u32 = 0x8000;

fn scan(guest: &mut GuestProgram, text: &str, format: &str) -> i32 {
    let (text, format) = (guest.text(text), guest.text(format));
    let results: Vec<Value> = (0..8).map(|n| Value::Word(RESULTS + 128 * n)).collect();
    let reply = guest.variadic("vsscanf", &[text, format], &results);
    assert_eq!(reply.errno, 0);
    reply.value
}

fn word(guest: &GuestProgram, n: u32) -> u32 {
    guest.words::<1>(RESULTS + 128 * n)[0]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Provenance: the host's sscanf.
    #[test]
    fn integers_are_scanned_as_in_c(
        text in "[ ]{0,2}[-+]?(0x[0-9a-fA-F]{1,9}|[0-9]{1,12}|[0-9]{0,4}[ g-w]{0,2}[0-9]{0,3})",
        width in proptest::option::of(3..9_u32),
        conversion in prop::sample::select(vec!["d", "u", "i", "o", "x"]),
        length in prop::sample::select(vec!["hh", "h", "", "ll"]),
    ) {
        let width = width.map_or(String::new(), |width| width.to_string());
        let format = format!("%{width}{length}{conversion}%n");
        let (c_text, c_format) = (CString::new(text.as_str()).unwrap(), CString::new(format.as_str()).unwrap());
        let (mut value, mut consumed) = (0_u64, 0_i32);
        // SAFETY: both strings end in 0, and both results are large enough for the longest type.
        let expected = unsafe {
            libc::sscanf(c_text.as_ptr(), c_format.as_ptr(), &raw mut value, &raw mut consumed)
        };
        let mut guest = GuestProgram::new("");
        prop_assert_eq!(scan(&mut guest, &text, &format), expected, "{:?} {}", text, format);
        if expected == 1 {
            let bytes = match length { "hh" => 1, "h" => 2, "ll" => 8, _ => 4 };
            let mut found = [0; 8];
            guest.store.read(RESULTS, &mut found[8 - bytes..]);
            let mask = u64::MAX >> (64 - 8 * bytes);
            let value = if cfg!(target_endian = "big") { value >> (64 - 8 * bytes) } else { value & mask };
            prop_assert_eq!(u64::from_be_bytes(found), value, "{:?} {}", text, format);
            prop_assert_eq!(word(&guest, 1) as i32, consumed);
        }
    }

    #[test]
    fn doubles_are_scanned_as_they_were_printed(bits: u64) {
        let value = f64::from_bits(bits);
        prop_assume!(!value.is_nan());
        for text in [format!("{value:e}"), format!("{value}")] {
            let mut guest = GuestProgram::new("");
            prop_assert_eq!(scan(&mut guest, &text, "%lf"), 1);
            let [high, low] = guest.words(RESULTS);
            prop_assert_eq!(u64::from(high) << 32 | u64::from(low), bits, "{}", text);
        }
    }

    #[test]
    fn any_format_and_input_end(text in "\\PC{0,30}", format in "[%a-z0-9*\\[\\]^ -]{0,30}") {
        let mut guest = GuestProgram::new("");
        scan(&mut guest, &text, &format);
    }
}

/// Provenance: the host's sscanf, with a locale of UTF-8.
#[test]
fn wide_characters_take_four_bytes_each() {
    let mut guest = GuestProgram::new("");
    let format = "%lc%2lc %ls %3l[a-zß-ü]%n";
    assert_eq!(scan(&mut guest, "äbc grüße üxßA", format), 4);
    let text = |guest: &GuestProgram, n: u32, length: usize| -> String {
        let words: [u32; 8] = guest.words(RESULTS + 128 * n);
        let characters = words[..length].iter();
        characters.map(|&word| char::from_u32(word).unwrap()).collect()
    };
    assert_eq!(text(&guest, 0, 1), "ä");
    assert_eq!(text(&guest, 1, 2), "bc");
    assert_eq!(text(&guest, 2, 6), "grüße\0");
    assert_eq!(text(&guest, 3, 4), "üxß\0");
    assert_eq!(word(&guest, 4), "äbc grüße üxß".len() as u32);
    // The character beyond the field is still there, with all its bytes.
    assert_eq!(scan(&mut guest, "abé", "%l[^é]%lc"), 2);
    assert_eq!(text(&guest, 0, 3), "ab\0");
    assert_eq!(text(&guest, 1, 1), "é");
    let (input, format) = (guest.text(b"\xff"), guest.text("%lc"));
    let reply = guest.variadic("vsscanf", &[input, format], &[Value::Word(RESULTS)]);
    assert_eq!(reply, Reply::failed(-1, libc::EILSEQ));
}

#[test]
fn fields_of_every_kind() {
    let mut guest = GuestProgram::new("");
    let format = "%d,%x %f %4s%c %[a-cx-]z%*d%n %i";
    let fields = scan(&mut guest, " -17,1F 2.5 moonl abc-xz99 0x10", format);
    assert_eq!(fields, 7, "a suppressed field and %n don't count");
    assert_eq!(word(&guest, 0) as i32, -17);
    assert_eq!(word(&guest, 1), 0x1f);
    assert_eq!(word(&guest, 2), 2.5_f32.to_bits());
    assert_eq!(guest.read_text(RESULTS + 128 * 3), "moon");
    assert_eq!(word(&guest, 4) >> 24, u32::from(b'l'));
    assert_eq!(guest.read_text(RESULTS + 128 * 5), "abc-x");
    assert_eq!(word(&guest, 6), 26);
    assert_eq!(word(&guest, 7), 0x10);
}

#[test]
fn scan_stops_at_end_or_mismatch() {
    let mut guest = GuestProgram::new("");
    assert_eq!(scan(&mut guest, "", "%d"), -1, "the input ended");
    assert_eq!(scan(&mut guest, "   ", " %c"), -1);
    assert_eq!(scan(&mut guest, "x", "%d"), 0, "something else");
    assert_eq!(scan(&mut guest, "7", "%d %d"), 1);
    assert_eq!(scan(&mut guest, "7 x", "%d y%d"), 1);
    assert_eq!(scan(&mut guest, "100%5", "%d%%%d"), 2);
    assert_eq!(scan(&mut guest, "abc", "%[^a]"), 0);
    assert_eq!(scan(&mut guest, "]ab", "%[]a]%c"), 2);
    assert_eq!(scan(&mut guest, "1.5e", "%f"), 0, "no number");
    assert_eq!(scan(&mut guest, "abc", "%q"), 0);
    assert_eq!(scan(&mut guest, "abc", "%[a"), 0, "a set without an end");
}

#[test]
fn a_scan_leaves_the_rest_of_the_stream() {
    let mut guest = GuestProgram::new("12 34x");
    let format = guest.text("%d%d");
    let results = [Value::Word(RESULTS), Value::Word(RESULTS + 128)];
    assert_eq!(guest.variadic("vscanf", &[format], &results), Reply::ok(2));
    assert_eq!([word(&guest, 0), word(&guest, 1)], [12, 34]);
    assert_eq!(guest.call("getchar", &[]), Reply::ok(i32::from(b'x')));
    assert_eq!(guest.variadic("vfscanf", &[1, format], &results), Reply::ok(-1));
    let closed = guest.variadic("vfscanf", &[7, format], &results);
    assert_eq!(closed, Reply::failed(-1, libc::EBADF));
}
