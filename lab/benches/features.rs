//! The cost of each feature of Whitted's model: simulated frames a second of the benchmark scene
//! with features removed one by one, and how far the pictures are from the f64 reference.
//!
//!     cargo bench --bench features [-- SCENE.nff [WxH]]

#![expect(clippy::print_stdout, reason = "a benchmark has nothing to lose but its output")]

use std::path::Path;
use std::process::Command;

use oracle::Picture;
use oracle::whitted::{self, Options};
use scenes::{Scene, Shader, Shape};
use serde_json::Value;

const SCENE: &str = "scenes/whitted16.nff";
const SIZE: &str = "1280x720";
/// The tiles' costs are not measured yet in the first frame.
const FRAMES: &str = "2";

/// A feature to do without.
struct Without {
    name: &'static str,
    change: fn(&mut Scene),
    options: &'static [&'static str],
    /// Most rays in a chain, as the options have it.
    depth: u32,
    /// Whether the reference can do without it, too.
    compared: bool,
}

const EVERYTHING: Without =
    Without { name: "everything", change: |_| (), options: &[], depth: 5, compared: true };

fn features() -> Vec<Without> {
    vec![
        EVERYTHING,
        Without { name: "no shadows", options: &["--no-shadows"], compared: false, ..EVERYTHING },
        Without { name: "one light", change: |scene| scene.lights.truncate(1), ..EVERYTHING },
        Without { name: "no highlights", change: lambert, ..EVERYTHING },
        Without {
            name: "no glass: T = 0",
            change: |scene| {
                for material in &mut scene.materials {
                    material.transmittance = 0.0;
                }
            },
            ..EVERYTHING
        },
        Without {
            name: "no mirrors, no polish: Ks = 0",
            change: |scene| {
                for material in &mut scene.materials {
                    material.specular = 0.0;
                }
            },
            ..EVERYTHING
        },
        Without {
            name: "no ground",
            change: |scene| {
                scene.objects.retain(|object| !matches!(object.shape, Shape::Polygon { .. }));
            },
            ..EVERYTHING
        },
        Without { name: "rays to depth 3", options: &["--ray-depth", "3"], depth: 3, ..EVERYTHING },
        Without { name: "rays to depth 2", options: &["--ray-depth", "2"], depth: 2, ..EVERYTHING },
        Without {
            name: "primary rays only: depth 1",
            options: &["--ray-depth", "1"],
            depth: 1,
            ..EVERYTHING
        },
        Without {
            name: "primary rays, one light, no shadows, no highlights",
            change: |scene| {
                scene.lights.truncate(1);
                lambert(scene);
            },
            options: &["--ray-depth", "1", "--no-shadows"],
            depth: 1,
            compared: false,
        },
        Without {
            name: "depth shading of the spheres",
            options: &["--model", "depth"],
            compared: false,
            ..EVERYTHING
        },
    ]
}

/// Mirrors stay, lights no longer show in surfaces.
fn lambert(scene: &mut Scene) {
    for material in &mut scene.materials {
        material.shader = Shader::Lambert;
    }
}

/// Renders frames of a scene in simulated time into a picture; gives the statistics.
fn render(scene: &Path, size: &str, picture: &Path, options: &[&str]) -> Value {
    let output = Command::new(env!("CARGO_BIN_EXE_cellray"))
        .args(["render", "--antialias", "1", "--colour", "linear"])
        .arg(scene)
        .args(["--size", size, "--frames", FRAMES, "--retrace", "--stats", "-"])
        .arg("--out")
        .arg(picture)
        .args(options)
        .env("LIBSPE2_TIMING", "1")
        .output()
        .expect("cellray runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("statistics are JSON")
}

fn main() {
    let arguments: Vec<String> =
        std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let file = arguments.first().map_or(SCENE, String::as_str);
    let size = arguments.get(1).map_or(SIZE, String::as_str);
    let folder = tempfile::tempdir().expect("a temporary folder");
    let whole = scenes::load(Path::new(file)).unwrap_or_else(|error| panic!("{error}"));
    println!("{file}, {size}, six SPUs, simulated\n");
    println!(
        "| without | frames/s | ms a frame | million rays: eye, reflected, refracted, shadow | pixels off by over 1/255 | off silhouettes |"
    );
    println!("|---|---|---|---|---|---|");
    for feature in features() {
        let mut scene = whole.clone();
        (feature.change)(&mut scene);
        let path = folder.path().join("scene.nff");
        std::fs::write(&path, scene.to_string()).expect("a scene is written");
        let picture = folder.path().join("picture.png");
        let statistics = render(&path, size, &picture, feature.options);
        let rate = statistics["frames_per_second"].as_f64().expect("a rate");
        let frames = statistics["frames"].as_f64().expect("frames");
        let rays = ["eye", "reflected", "refracted", "shadow"].map(|kind| {
            let rays = statistics["rays"][kind].as_f64().expect("rays") / frames;
            format!("{:.2}", rays / 1e6)
        });
        let (off, beside) = if feature.compared {
            errors(&scene, &picture, feature.depth)
        } else {
            ("".into(), "".into())
        };
        println!(
            "| {} | {rate:.1} | {:.2} | {} | {off} | {beside} |",
            feature.name,
            1000.0 / rate,
            rays.join(", ")
        );
    }
}

/// Pixels of a picture that are off, of all and of those that lie on no silhouette.
fn errors(scene: &Scene, picture: &Path, depth: u32) -> (String, String) {
    let picture = Picture::read_png(picture).expect("a picture");
    let options = Options { depth, ..Options::default() };
    let (reference, _) =
        whitted::trace(scene, picture.width(), picture.height(), &options).expect("a reference");
    let found = oracle::compare(&picture, &reference).expect("pictures of one size");
    (format!("{:.4} %", 100.0 * found.wrong_fraction), found.wrong_off_silhouette.to_string())
}
