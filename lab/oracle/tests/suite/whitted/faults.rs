//! Scenes that can't be traced are refused with a reason; unusual ones are traced.

use oracle::Error;
use oracle::whitted::{MAX_DEPTH, Options, trace};

use super::{colour, scene};

const FROM: [f64; 3] = [0.0, 0.0, 10.0];

fn error(rest: &str, options: &Options) -> Error {
    trace(&scene(FROM, [0.0; 3], rest), 1, 1, options).expect_err("no picture")
}

#[test]
fn errors_name_the_line() {
    let options = Options::default();
    let glass = error("f 1 1 1 0 0 1 0.5 0\ns 0 0 0 1\n", &options);
    assert_eq!(
        glass.to_string(),
        "t.nff:8: an index of refraction of 0 refracts nothing (T is above 0)"
    );
    let own = "f 1 1 1 0 0 1 0 1\n#cellray shader rings 1\ns 0 0 0 1\n";
    assert_eq!(
        error(own, &options).to_string(),
        "t.nff:8: the reference has no shader `rings`, which is a game's own"
    );
    let mut patch = "f 1 1 1 1 0 1 0 1\npp 513\n".to_owned();
    for vertex in 0..513 {
        let angle = f64::from(vertex) * 0.01;
        patch += &format!("{} {} 0 0 0 1\n", libm::cos(angle), libm::sin(angle));
    }
    assert_eq!(
        error(&patch, &options).to_string(),
        "t.nff:9: a patch of 513 vertices, more than 512"
    );
    for depth in [0, MAX_DEPTH + 1, u32::MAX] {
        let found = error("", &Options { depth, ..options });
        assert!(matches!(found, Error::Depth(_)), "{found}");
    }
    let empty = scene(FROM, [0.0; 3], "");
    assert!(matches!(trace(&empty, 0, 1, &options), Err(Error::Size(_))));
}

#[test]
fn odd_scenes_are_traced() {
    // Without objects or lights; polygons without area; a light on a surface and at the eye;
    // numbers at the ends of what the format takes.
    let shown = |rest: &str| colour(&scene(FROM, [0.0; 3], rest));
    assert_eq!(shown("b 1 0 0\n"), [255, 0, 0]);
    let flat = "f 1 1 1 1 0 1 0 1\np 3\n0 0 0\n1 0 0\n2 0 0\npp 3\n1 1 1 0 0 1\n1 1 1 0 0 1\n1 1 1 0 0 1\n";
    assert_eq!(shown(&format!("b 1 0 0\n{flat}")), [255, 0, 0]);
    assert_eq!(shown("f 1 1 1 1 0 1 0 1\ns 0 0 0 1\n"), [0; 3]);
    assert_eq!(shown("l 0 0 1 1 1 1\nf 1 1 1 1 0 1 0 1\ns 0 0 0 1\n"), [0; 3]);
    assert_eq!(shown("l 0 0 10 1 1 1\nf 1 1 1 1 0 1 0 1\ns 0 0 0 1\n"), [255; 3]);
    let huge = "l 0 0 20 1e150 1e150 1e150\nf 1e150 1 1 1e150 1e150 1e150 1e150 1e150\n\
        s 0 0 0 1e150\ns 1e150 0 0 1\nc\n0 0 0 1e150\n1e150 0 0 0\np 3\n1e150 0 0\n0 1e150 0\n0 0 -1e150\n\
        s 0 0 0 1e-150\nc\n0 0 0 1e-150\n0 0 1e-150 1\n";
    let (reference, counts) =
        trace(&scene(FROM, [0.0; 3], huge), 9, 9, &Options::default()).expect("a picture");
    assert_eq!(reference.silhouette.len(), 81);
    assert_eq!(counts.eye, 81);
}

#[test]
fn missing_normals_are_the_surfaces_own() {
    let square = |normal: &str| {
        let corner = |x: i32, y: i32| format!("{x} {y} 0 {normal}\n");
        let corners = corner(-1, -1) + &corner(1, -1) + &corner(1, 1) + &corner(-1, 1);
        let rest = format!("l 0 0 9 1 1 1\nf 1 1 1 1 0 1 0 1\npp 4\n{corners}");
        colour(&scene(FROM, [0.0; 3], &rest))
    };
    assert_eq!(square("0 0 1"), [255; 3]);
    assert_eq!(square("0 0 0"), [255; 3]);
    assert_eq!(square("0 0 -1"), [255; 3], "away from the eye");
}
