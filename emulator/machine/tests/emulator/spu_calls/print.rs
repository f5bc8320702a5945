use std::ffi::CString;

use proptest::prelude::*;

use super::support::{GuestProgram, Reply, Value};

fn print(format: &str, arguments: &[Value]) -> String {
    let mut guest = GuestProgram::new("");
    let format = guest.text(format);
    let reply = guest.variadic("vprintf", &[format], arguments);
    let output = guest.output();
    assert_eq!(reply, Reply::ok(output.len() as i32));
    output
}

/// The text that the host's C library prints. The argument must have the type that the format
/// requires.
macro_rules! c_print {
    ($format:expr, $($argument:expr),*) => {{
        let format = CString::new($format.as_str()).unwrap();
        let mut buffer = vec![0_u8; 4096];
        // SAFETY: the length is the buffer's, and the arguments match the
        // format.
        let length = unsafe {
            libc::snprintf(buffer.as_mut_ptr().cast(), buffer.len(), format.as_ptr(), $($argument),*)
        };
        String::from_utf8(buffer[..length as usize].to_vec()).unwrap()
    }};
}

/// Flags, width and precision, except combinations that C does not define.
fn field() -> impl Strategy<Value = String> {
    let precision = proptest::option::of(0..20_u32);
    ("[-+ 0]{0,3}", proptest::option::of(1..30_u32), precision).prop_map(
        |(flags, width, precision)| {
            let width = width.map_or(String::new(), |width| width.to_string());
            let precision = precision.map_or(String::new(), |digits| format!(".{digits}"));
            format!("{flags}{width}{precision}")
        },
    )
}

fn integer() -> impl Strategy<Value = u64> {
    prop_oneof![any::<u64>(), 0..20_u64, Just(0), Just(1 << 63), Just(u64::MAX), Just(1 << 31)]
}

fn double() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<f64>(),
        any::<u64>().prop_map(f64::from_bits),
        -1e6..1e6_f64,
        (-1000..1000_i32).prop_map(|n| f64::from(n) / 8.0),
        (0..400_i32).prop_map(|n| 10_f64.powi(n - 200)),
        (0..40_i32).prop_map(|n| 10_f64.powi(n - 20) * 9.999_995),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn integers_print_as_in_c(
        field in field(),
        conversion in prop::sample::select(vec!["d", "i", "u", "o", "x", "X", "#o", "#x", "#X"]),
        length in prop::sample::select(vec!["hh", "h", "", "l", "z", "t", "ll", "j"]),
        value in integer(),
    ) {
        let (alternate, letter) = conversion.split_at(conversion.len() - 1);
        let format = format!("<%{alternate}{field}{length}{letter}>");
        let long = matches!(length, "ll" | "j");
        let argument = if long { Value::Long(value) } else { Value::Word(value as u32) };
        // On the SPU these types have 32 bits.
        let host = format!("<%{alternate}{field}{}{letter}>", match length {
            "l" | "z" | "t" => "",
            other => other,
        });
        let expected = if long { c_print!(host, value) } else { c_print!(host, value as u32) };
        prop_assert_eq!(print(&format, &[argument]), expected, "{}", format);
    }

    /// Omits `%#g`, because glibc drops the zeros that C keeps if rounding carries into a new
    /// digit.
    #[test]
    fn doubles_print_as_in_c(
        field in field(),
        conversion in prop::sample::select(vec!["f", "F", "e", "E", "g", "G", "a", "A", "#f", "#e", "#a"]),
        value in double(),
    ) {
        let (alternate, letter) = conversion.split_at(conversion.len() - 1);
        let format = format!("<%{alternate}{field}{letter}>");
        prop_assert_eq!(
            print(&format, &[Value::Double(value)]),
            c_print!(format, value),
            "{} of {:e}", format, value
        );
    }

    #[test]
    fn any_format_ends(format in "[%a-zA-Z0-9*.# +\\-\\[\\]]{0,40}", word: u32) {
        let mut guest = GuestProgram::new("");
        let format = guest.text(format);
        let arguments: Vec<Value> = (0..72).map(|_| Value::Word(word)).collect();
        guest.variadic("vsnprintf", &[0x2_0000, 64, format], &arguments);
    }
}

#[test]
fn characters_and_strings() {
    let mut guest = GuestProgram::new("");
    let format = guest.text("%s|%8s|%-8s|%.2s|%c|%5c|%%|%p|%p|%k");
    let text = guest.text("moon");
    let word = Value::Word;
    let arguments = [
        word(text),
        word(text),
        word(text),
        word(text),
        word(0x141),
        word(66),
        word(0x1_2340),
        word(0),
    ];
    guest.variadic("vprintf", &[format], &arguments);
    assert_eq!(guest.output(), "moon|    moon|moon    |mo|A|    B|%|0x12340|(nil)|%k");
}

#[test]
fn widths_and_precisions_from_arguments() {
    let words = |words: &[u32]| words.iter().map(|&word| Value::Word(word)).collect::<Vec<_>>();
    assert_eq!(print("<%*d>", &words(&[5, 42])), "<   42>");
    assert_eq!(print("<%*d>", &words(&[-5_i32 as u32, 42])), "<42   >");
    assert_eq!(print("<%.*d>", &words(&[4, 42])), "<0042>");
    assert_eq!(print("<%0*.*d>", &words(&[6, -1_i32 as u32, 42])), "<000042>");
}

#[test]
fn the_count_so_far_is_stored_at_its_length() {
    let mut guest = GuestProgram::new("");
    let format = guest.text("12345%hhn%hn%n%lln");
    guest.store.write(0x8000, &[0xff; 64]);
    let at = [0x8000, 0x8010, 0x8020, 0x8030].map(Value::Word);
    guest.variadic("vprintf", &[format], &at);
    let stored = [0x8000, 0x8010, 0x8020, 0x8030].map(|at| guest.words::<2>(at));
    let rest = u32::MAX;
    let expected = [[0x05ff_ffff, rest], [0x0005_ffff, rest], [5, rest], [0, 5]];
    assert_eq!(stored, expected);
}

#[test]
fn arguments_beyond_the_registers_lie_behind_the_frame_header() {
    let format = "%d ".repeat(80);
    let arguments: Vec<Value> = (0..80).map(Value::Word).collect();
    let expected: String = (0..80).map(|n| format!("{n} ")).collect();
    assert_eq!(print(&format, &arguments), expected);
}

#[test]
fn strings_are_truncated_to_buffer() {
    let mut guest = GuestProgram::new("");
    let format = guest.text("number %d");
    guest.store.write(0x8000, &[0xee; 32]);
    let reply = guest.variadic("vsnprintf", &[0x8000, 8, format], &[Value::Word(123)]);
    assert_eq!(reply, Reply::ok(10));
    assert_eq!(guest.read_text(0x8000), "number ");
    assert_eq!(guest.words::<1>(0x8008), [0xeeee_eeee]);
    let reply = guest.variadic("vsnprintf", &[0x8010, 0, format], &[Value::Word(123)]);
    assert_eq!((reply, guest.words::<1>(0x8010)), (Reply::ok(10), [0xeeee_eeee]));
    let reply = guest.variadic("vsprintf", &[0x8000, format], &[Value::Word(123)]);
    assert_eq!(reply, Reply::ok(10));
    assert_eq!(guest.read_text(0x8000), "number 123");
}

#[test]
fn streams_other_than_standard_output() {
    let mut guest = GuestProgram::new("");
    let format = guest.text("to %x\n");
    guest.variadic("vfprintf", &[3, format], &[Value::Word(0xe)]);
    assert_eq!(guest.console(|console| console.error.clone()), b"to e\n");
    let closed = guest.variadic("vfprintf", &[9, format], &[Value::Word(1)]);
    assert_eq!(closed, Reply::failed(-1, libc::EBADF));
}

#[test]
fn an_endless_field_is_an_error() {
    let mut guest = GuestProgram::new("");
    for format in ["%2147483647d", "%.99999999999999999999d", "%16000000d%16000000d"] {
        let format = guest.text(format);
        let reply = guest.variadic("vprintf", &[format], &[Value::Word(1), Value::Word(2)]);
        assert_eq!(reply, Reply::failed(-1, libc::EOVERFLOW));
    }
    let reply = guest.call("puts", &[0x3_0000]);
    assert_eq!(reply, Reply::ok(1), "the library goes on");
}

/// The host's formatting has widths and precisions of 16 bits.
#[test]
fn large_precisions() {
    let zeros = "0".repeat(69_999);
    assert_eq!(print("%.70000d", &[Value::Word(7)]), format!("{zeros}7"));
    assert_eq!(print("%.70000f", &[Value::Double(0.0)]).len(), 70_002);
    assert_eq!(print("%70000x", &[Value::Word(7)]).len(), 70_000);
    assert_eq!(print("%.70000a", &[Value::Double(1.0)]).len(), 70_007);
}
