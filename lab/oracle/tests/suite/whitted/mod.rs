//! Whitted's model against what can be worked out by hand, and against published counts.

mod analytic;
mod counts;
mod faults;
mod light;
mod meshes;
mod shaders;

use oracle::whitted::{Counts, Options, trace};
use scenes::Scene;

/// A scene seen from `from` towards `at` at an angle so small that the picture is one ray's.
fn scene(from: [f64; 3], at: [f64; 3], rest: &str) -> Scene {
    wide(from, at, 1e-6, rest)
}

/// A scene seen at an angle.
fn wide(from: [f64; 3], at: [f64; 3], angle: f64, rest: &str) -> Scene {
    let triple = |[x, y, z]: [f64; 3]| format!("{x} {y} {z}");
    let up = if from[0] == at[0] && from[1] == at[1] { "0 1 0" } else { "0 0 1" };
    let text = format!(
        "v\nfrom {}\nat {}\nup {up}\nangle {angle}\nhither 0\nresolution 1 1\n{rest}",
        triple(from),
        triple(at)
    );
    scenes::parse(text.as_bytes(), "t.nff", &scenes::Limits::default()).expect("a scene")
}

/// The colour that the line of sight sees, and its rays.
fn look(scene: &Scene, options: &Options) -> ([u8; 3], Counts) {
    let (reference, counts) = trace(scene, 1, 1, options).expect("a picture");
    (reference.picture.pixels()[0], counts)
}

/// The same with the default options.
fn colour(scene: &Scene) -> [u8; 3] {
    look(scene, &Options::default()).0
}
