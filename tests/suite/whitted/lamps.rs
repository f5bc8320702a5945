//! Lights with a range.

use std::fmt::Write as _;

use oracle::whitted::trace;
use scenes::Scene;

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED, compared, options};

const SIZE: (u32, u32) = (320, 180);

/// A floor with balls, half of them with highlights, and a lamp over each four of them. Some of the
/// picture is background.
fn hall(range: f64) -> Scene {
    let mut text = String::from(
        "v\nfrom 0 -14 5\nat 0 0 0\nup 0 0 1\nangle 40\nhither 0.01\nresolution 320 180\n\
         b 0.1 0.1 0.2\n#cellray ambient 0.1 0.1 0.1\n",
    );
    for at in 0..36 {
        let (x, y) = (4 * (at % 6) - 10, 4 * (at / 6) - 10);
        writeln!(text, "#cellray lamp {x} {y} 2 {range} 0.9 0.{at:02} 0.5").unwrap();
    }
    text += "f 0.9 0.9 0.9 0.9 0 1 0 1\np 4\n12 -12 0\n12 12 0\n-12 12 0\n-12 -12 0\n";
    for at in 0..144 {
        let (x, y) = (2 * (at % 12) - 11, 2 * (at / 12) - 11);
        let shine = if at % 2 == 0 { 0.3 } else { 0.0 };
        writeln!(text, "f 0.8 0.6 0.4 0.8 {shine} 20 0 1\ns {x} {y} 0.5 0.5").unwrap();
    }
    let name = format!("lamps that reach {range}");
    scenes::parse(text.as_bytes(), &name, &scenes::Limits::default()).unwrap()
}

#[test]
fn lamps_equal_reference() {
    for range in [2.5, 5.0, 50.0] {
        let result = compared(&hall(range), WHITTED, SIZE);
        assert!(result.max_error_off_silhouette <= 2, "{range}: {result:?}");
        assert!(result.wrong_fraction <= 0.0015, "{range}: {result:?}");
    }
}

/// Shadow rays are only sent within the range, as the reference counts them, and lamps that reach
/// no point of a batch take nearly no time.
#[test]
fn lamps_cost_nothing_where_they_do_not_reach() {
    let [near, far] = [3.0, 50.0].map(|range| {
        let scene = hall(range);
        let frame = Frame::of(&scene, WHITTED, SIZE, Settings::default());
        let (_, counts) = trace(&scene, SIZE.0, SIZE.1, &options(WHITTED)).unwrap();
        let found = frame.rays().shadow;
        let off = found.abs_diff(counts.shadow) as f64 / counts.shadow as f64;
        assert!(off <= 0.001, "{range}: {found} shadow rays, and {}", counts.shadow);
        found
    });
    assert!(12 * near < far, "{near} and {far} shadow rays");
}
