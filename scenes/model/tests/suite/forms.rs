//! The forms that a file may have: NFF is read word by word.

use std::path::Path;

use crate::common::{scene_text, try_parse};
use scenes::{Scene, Shape};

fn scene(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/scenes");
    scenes::read(&folder.join(name)).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn all_forms_of_a_file_are_the_same_scene() {
    let plain = scene("plain.nff");
    let cones = plain.objects.iter();
    let cones = cones.filter(|object| matches!(object.shape, Shape::Cone { .. }));
    assert_eq!((cones.count(), plain.objects.len()), (2, 5));
    for name in [
        "one_line.nff",
        "many_lines.nff",
        "byte_order_mark.nff",
        "byte_order_mark_directive.nff",
        "carriage_returns.nff",
        "both_line_ends.nff",
        "latin1.nff",
    ] {
        assert_eq!(scene(name), plain, "{name}");
    }
}

#[test]
fn lines_are_counted_for_all_line_ends() {
    let lines = |name: &str| -> Vec<u32> {
        let scene = scene(name);
        let objects = scene.objects.iter().map(|object| object.line);
        let lights = scene.lights.iter().map(|light| light.line);
        let materials = scene.materials.iter().map(|material| material.line);
        objects.chain(lights).chain(materials).collect()
    };
    let plain = lines("plain.nff");
    assert_eq!(plain, [15, 18, 21, 22, 28, 10, 11, 13, 27]);
    for name in ["carriage_returns.nff", "both_line_ends.nff", "latin1.nff"] {
        assert_eq!(lines(name), plain, "{name}");
    }
    assert_eq!(lines("one_line.nff"), [8, 9, 10, 10, 12, 4, 4, 6, 11]);
}

#[test]
fn faults_name_line_for_all_line_ends() {
    for end in ["\n", "\r", "\r\n"] {
        let text = scene_text("s 0 0 0 1\ns 0 0 zero 1\n").replace('\n', end);
        for text in [text.clone(), format!("\u{feff}{text}")] {
            let error = try_parse(text.as_bytes()).expect_err("a fault").to_string();
            assert_eq!(error, "t.nff:10: centre z `zero` is not a number", "{end:?}");
        }
    }
}

#[test]
fn byte_order_mark_in_middle_is_fault() {
    let text = scene_text("\u{feff}s 0 0 0 1\n");
    let error = try_parse(text.as_bytes()).expect_err("a fault").to_string();
    assert_eq!(error, "t.nff:9: unknown entity `\\u{feff}s` (known: v b l f s c p pp)");
}
