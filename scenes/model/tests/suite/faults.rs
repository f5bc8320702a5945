//! Every fault by its whole message: file, line, field and value.

use std::io::{self, Read};

use crate::common::{scene_text, try_parse};
use scenes::{Error, Limits};

/// The message that `bytes` are refused with.
fn refusal(bytes: &[u8]) -> String {
    match try_parse(bytes) {
        Ok(scene) => panic!("accepted as {scene}"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn lines_after_the_view_and_a_material() {
    let cases = [
        ("x 1 2", "9: unknown entity `x` (known: v b l f s c p pp)"),
        ("s 0 0 0", "9: the file ends inside the sphere that starts on line 9: radius is missing"),
        (
            "s 0 0 0\ns 0 0 0 1",
            "10: radius of the sphere that starts on line 9 is missing: found `s` instead",
        ),
        ("s 0 0 0 1 2", "9: sphere is followed by `2`, which does not belong there"),
        ("s 0 0 0 1 x", "9: sphere is followed by `x`, which does not belong there"),
        ("s 0 0 0 1\n-2", "10: sphere is followed by `-2`, which does not belong there"),
        ("s 0 zero 0 1", "9: centre y `zero` is not a number"),
        ("s 0 0 0 0x10", "9: radius `0x10` is not a number"),
        ("s NaN 0 0 1", "9: centre x `NaN` is not a finite number"),
        ("s 0 0 -inf 1", "9: centre z `-inf` is not a finite number"),
        ("s 0 0 0 1e400", "9: radius `1e400` is not a finite number"),
        ("s 0 0 0 1e151", "9: radius 1e151 is larger than 1e150"),
        ("s 0 0 0 0", "9: radius is 0"),
        ("s 0 0 0 -0", "9: radius is 0"),
        ("s 0 0 0 1e-999", "9: radius is 0"),
        (
            "b 1 1",
            "9: the file ends inside the background that starts on line 9: background blue is missing",
        ),
        ("b 1 1 1 1", "9: background is followed by `1`, which does not belong there"),
        ("b 1 -0.5 1", "9: background green -0.5 is negative"),
        ("b 0 0 0\nb 1 1 1", "10: a second background (b); the first is on line 9"),
        (
            "l 1 2\nf 1 1 1 1 0 0 0 1",
            "10: light z of the light that starts on line 9 is missing: found `f` instead",
        ),
        (
            "l 1 2 3 1 l 1 2 3",
            "9: light green of the light that starts on line 9 is missing: found `l` instead",
        ),
        (
            "l 1 2 3\n1",
            "10: the file ends inside the light that starts on line 9: light green is missing",
        ),
        ("l 1 2 3 x", "9: light red `x` is not a number"),
        ("l 1 2 3 1 1 1 1", "9: light is followed by `1`, which does not belong there"),
        (
            "f 1 1 1 1 0 0 0",
            "9: the file ends inside the material that starts on line 9: index of refraction is missing",
        ),
        ("f 1 1 1 -1 0 0 0 1", "9: Kd -1 is negative"),
        ("f 1 1 1 1 0 0 0 1 9", "9: material is followed by `9`, which does not belong there"),
        ("c 1\n0 0 0 1\n0 1 1 1", "11: cone is followed by `1`, which does not belong there"),
        (
            "c\n0 0 0\n0 0 1 1\ns 0 0 0 1",
            "12: apex radius of the cone that starts on line 9 is missing: found `s` instead",
        ),
        ("c\n0 0 0 1\n0 0 1 1 1", "11: cone is followed by `1`, which does not belong there"),
        ("c\n0 0 0 0\n0 0 1 0", "11: each of base radius and apex radius is 0"),
        ("c\n0 0 0 1\n0 0 1 -1", "11: base radius 1 and apex radius -1 have different signs"),
        ("c 0 0 0 1 0 0 0 1", "9: the cone's base and apex are the same point"),
        (
            "c\n0 0 0 1\n",
            "10: the file ends inside the cone that starts on line 9: apex x is missing",
        ),
        (
            "p",
            "9: the file ends inside the polygon that starts on line 9: number of vertices is missing",
        ),
        ("p 2\n0 0 0\n1 0 0", "9: polygon with 2 vertices, fewer than 3"),
        ("pp 0", "9: patch with 0 vertices, fewer than 3"),
        ("p -3", "9: number of vertices `-3` is not a whole number from 0"),
        ("p 3.5", "9: number of vertices `3.5` is not a whole number from 0"),
        ("p 4000000000", "9: number of vertices `4000000000` is more than 16000000"),
        (
            "p 99999999999999999999",
            "9: number of vertices `99999999999999999999` is more than 16000000",
        ),
        ("p 3 3", "9: the file ends inside the polygon that starts on line 9: vertex y is missing"),
        (
            "p 3\n0 0 0\n1 0 0\n",
            "11: the file ends inside the polygon that starts on line 9: vertex x is missing",
        ),
        (
            "p 3\n0 0 0\n1 0\n0 1 0\nf 1 1 1 1 0 0 0 1",
            "13: vertex z of the polygon that starts on line 9 is missing: found `f` instead",
        ),
        (
            "p 3\n0 0 0\n1 0 0 5\n0 1 0",
            "12: polygon is followed by `0`, which does not belong there",
        ),
        (
            "p 3\n0 0 0\n1 0 0\ns 0 0 0 1",
            "12: vertex x of the polygon that starts on line 9 is missing: found `s` instead",
        ),
        (
            "pp 3\n0 0 0 0 0\n",
            "10: the file ends inside the patch that starts on line 9: normal z is missing",
        ),
        ("v\nfrom 1 1 1", "9: a second view (v); the first is on line 1"),
    ];
    for (line, message) in cases {
        assert_eq!(refusal(scene_text(line).as_bytes()), format!("t.nff:{message}"), "{line}");
    }
}

#[test]
fn views() {
    let cases = [
        ("", "", "1: the file has no view (v)"),
        ("v", "v 1", "1: the view's `from` is expected here, not `1`"),
        (
            "from 0 -10 0",
            "from 0 -10",
            "3: from z of the view that starts on line 1 is missing: found `at` instead",
        ),
        ("from 0 -10 0", "at 0 -10 0", "2: the view's `from` is expected here, not `at`"),
        ("at 0 0 0", "at 0 -10 0", "3: from and at are the same point, [0, -10, 0]"),
        ("up 0 0 1", "up 0 0 0", "4: up [0, 0, 0] is zero or parallel to the line of sight"),
        ("up 0 0 1", "up 0 -3 0", "4: up [0, -3, 0] is zero or parallel to the line of sight"),
        ("angle 45", "angle 0", "5: angle 0 is not between 0 and 180 degrees"),
        ("angle 45", "angle 180", "5: angle 180 is not between 0 and 180 degrees"),
        ("angle 45", "angle -45", "5: angle -45 is not between 0 and 180 degrees"),
        ("hither 0", "hither -1", "6: hither -1 is negative"),
        (
            "resolution 64 48",
            "resolution 64",
            "8: resolution height of the view that starts on line 1 is missing: found `f` instead",
        ),
        (
            "resolution 64 48",
            "resolution 0 48",
            "7: a picture of 0x48 pixels: each side must be 1 to 8192",
        ),
        (
            "resolution 64 48",
            "resolution 64 20000",
            "7: a picture of 64x20000 pixels: each side must be 1 to 8192",
        ),
        (
            "resolution 64 48",
            "resolution -1 48",
            "7: resolution width `-1` is not a whole number from 0",
        ),
        (
            "resolution 64 48",
            "resolution 64 48 2",
            "7: view is followed by `2`, which does not belong there",
        ),
        (
            "resolution 64 48",
            "resolution 64 99999999999",
            "7: resolution height `99999999999` is more than 8192",
        ),
    ];
    for (right, wrong, message) in cases {
        let text =
            if right.is_empty() { String::new() } else { scene_text("").replacen(right, wrong, 1) };
        assert_eq!(refusal(text.as_bytes()), format!("t.nff:{message}"), "{wrong}");
    }
    let whole = scene_text("");
    let next = ["from", "at", "up", "angle", "hither", "resolution"];
    for (lines, next) in (1..7).zip(next) {
        let cut: String = whole.split_inclusive('\n').take(lines).collect();
        let message = format!(
            "t.nff:{lines}: the file ends inside the view that starts on line 1: {next} is missing"
        );
        assert_eq!(refusal(cut.as_bytes()), message);
    }
}

#[test]
fn objects_before_what_they_need() {
    assert_eq!(refusal(b"f 1 1 1 1 0 0 0 1\ns 0 0 0 1"), "t.nff:2: sphere before the view (v)");
    assert_eq!(refusal(b"\n\np 3"), "t.nff:3: polygon before the view (v)");
    let bare = scene_text("pp 3").replace("f 1 1 1 1 0 0 0 1", "# no material");
    assert_eq!(refusal(bare.as_bytes()), "t.nff:9: patch before the first material (f)");
}

#[test]
fn invalid_utf8_is_refused() {
    assert_eq!(refusal(b"# ok\nv \xff"), "t.nff:2: byte 3 of the line is not UTF-8 text");
    assert_eq!(refusal(b"b 0 0 0\n \tb\xc3(\n"), "t.nff:2: byte 4 of the line is not UTF-8 text");
    assert_eq!(
        refusal(b"\x1b[31m"),
        "t.nff:1: unknown entity `\\u{1b}[31m` (known: v b l f s c p pp)"
    );
    let long = "é".repeat(1000);
    let message =
        format!("t.nff:1: unknown entity `{}…` (known: v b l f s c p pp)", "é".repeat(40));
    assert_eq!(refusal(long.as_bytes()), message);
}

/// A reader that repeats `pattern` `left` bytes long, and counts what was taken of it.
struct Endless<'a> {
    head: &'a [u8],
    pattern: &'a [u8],
    left: u64,
}

impl Read for Endless<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if !self.head.is_empty() {
            return self.head.read(buffer);
        }
        let len = buffer.len().min(self.pattern.len());
        buffer[..len].copy_from_slice(&self.pattern[..len]);
        assert_eq!(len, self.pattern.len(), "the tests' patterns fit the buffer");
        self.left = self.left.checked_sub(len as u64).expect("read on beyond the limit");
        Ok(len)
    }
}

#[test]
fn endless_files_stop_at_the_limits() {
    let limits = Limits { objects: 10, vertices: 20, line_bytes: 100, lines: 1000 };
    let head = scene_text("");
    let cases: [(&str, &[u8], &str); 8] = [
        ("", b"\0\0\0\0", "9: the line is longer than 100 bytes"),
        ("", b"\n", "1000: more than 1000 lines"),
        ("", b"#\n", "1000: more than 1000 lines"),
        ("", b"s 0 0 0 1\n", "19: more than 10 objects"),
        ("", b"f 1 1 1 1 0 0 0 1\n", "18: more than 10 materials"),
        ("", b"l 0 0 0\n", "19: more than 10 lights"),
        ("", b"p 3\n0 0 0\n1 0 0\n0 1 0\n", "33: more than 20 vertices"),
        ("p 20\n", b"0 0 0\n", "30: polygon is followed by `0`, which does not belong there"),
    ];
    for (start, pattern, message) in cases {
        let head = head.clone() + start;
        let reader = Endless { head: head.as_bytes(), pattern, left: 32 * 1024 };
        let reader = io::BufReader::with_capacity(64, reader);
        let error = scenes::parse(reader, "t.nff", &limits).expect_err("endless");
        assert_eq!(error.to_string(), format!("t.nff:{message}"));
    }
}

#[test]
fn limits_are_inclusive() {
    let limits = Limits { objects: 2, vertices: 3, line_bytes: 17, lines: 13 };
    let text = scene_text("s 0 0 0 1\np 3\n0 0 0\n1 0 0\n0 1 0\n");
    assert_eq!(text.lines().map(str::len).max(), Some(17));
    let scene = scenes::parse(text.as_bytes(), "t.nff", &limits).expect("at the limits");
    assert_eq!(scene.objects.len(), 2);
    for tight in [
        Limits { objects: 1, ..limits.clone() },
        Limits { vertices: 2, ..limits.clone() },
        Limits { line_bytes: 16, ..limits.clone() },
        Limits { lines: 12, ..limits.clone() },
    ] {
        scenes::parse(text.as_bytes(), "t.nff", &tight).expect_err("one too many");
    }
}

#[test]
fn unreadable_files_are_errors() {
    let folder = tempfile::tempdir().expect("a folder");
    let missing = folder.path().join("missing.nff");
    for path in [missing.as_path(), folder.path()] {
        let error = scenes::read(path).expect_err("not a file");
        assert!(matches!(error, Error::Io { .. }), "{error:?}");
        assert!(error.to_string().starts_with(&path.display().to_string()), "{error}");
    }
}

#[test]
fn sparse_file_of_17_gigabytes_is_refused_at_its_first_line() {
    let file = tempfile::NamedTempFile::new().expect("a file");
    file.as_file().set_len(17 << 30).expect("a sparse file");
    let error = scenes::read(file.path()).expect_err("one endless line");
    let message = format!("{}:1: the line is longer than 1048576 bytes", file.path().display());
    assert_eq!(error.to_string(), message);
}
