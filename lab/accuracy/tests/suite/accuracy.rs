//! Tests the command line of the benchmark of accuracy.

use std::fs;
use std::path::Path;

use ::accuracy::output::Document;

fn bench(arguments: &[&str]) -> std::process::Output {
    super::bench("accuracy", arguments)
}

fn failure(arguments: &[&str]) -> String {
    let output = bench(arguments);
    assert!(!output.status.success(), "{arguments:?}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    String::from_utf8(output.stderr).unwrap()
}

#[test]
fn invalid_arguments_are_reported() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("file");
    fs::write(&file, "").unwrap();
    let (file, below) = (file.to_str().unwrap(), file.join("below"));
    let below = below.to_str().unwrap();
    for (arguments, named) in [
        (&["--seed", "minus one"][..], "minus one"),
        (&["--seed", "-1"], "'-1' for '--seed <N>'"),
        (&["--only", "paper,slow", "--json", "-"], "slow"),
        (&["--out", below], below),
        (&["--out", file], file),
        (&["--quick", "--full"], "--full"),
        (&["--json", "-", "--write", "accuracy.md"], "--write"),
        (&["--pictures", "--scenes", "no-such-scene", "--json", "-"], "no-such-scene"),
        (&["--pictures", "--scenes", "far", "--programs", "slow", "--json", "-"], "slow"),
    ] {
        let message = failure(arguments);
        assert!(message.contains(named), "{arguments:?}: {message}");
    }
    assert!(failure(&["--only", "slow", "--json", "-"]).contains("perpendicular"));
}

#[test]
fn json_without_host_is_reproducible() {
    let arguments = ["--quick", "--no-host-time", "--only", "perpendicular,paper", "--json", "-"];
    let [first, second] = [(); 2].map(|()| bench(&arguments));
    assert!(first.status.success());
    assert_eq!(first.stdout, second.stdout);
    let document: Document = serde_json::from_slice(&first.stdout).unwrap();
    assert!(document.origin.is_none());
    assert!(document.results.kernels.iter().all(|kernel| kernel.host_ns_a_ray.is_none()));
    assert_eq!(document.results.kernels.len(), 4);
}

#[test]
fn picture_of_one_scene_has_its_plot_and_table() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name).to_str().unwrap().to_owned();
    let (out, document) = (at("out"), at("accuracy.md"));
    let arguments = ["--pictures", "--scenes", "mirror-ball", "--programs", "default,fast"];
    let output = bench(&[&arguments[..], &["--out", &out, "--write", &document]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = fs::read_to_string(&document).unwrap();
    assert!(text.contains("| mirror-ball |"), "{text}");
    assert!(text.contains("](accuracy-pictures.svg)"), "{text}");
    assert!(fs::read_to_string(at("accuracy-pictures.svg")).unwrap().contains("floor"));
    let csv = fs::read_to_string(Path::new(&out).join("pictures.csv")).unwrap();
    assert_eq!(csv.lines().count(), 3, "{csv}");
}

#[test]
fn folder_output_has_all_files_and_plots() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name).to_str().unwrap().to_owned();
    let (out, document) = (at("out"), at("accuracy.md"));
    let arguments = ["--quick", "--seed", "5", "--out", &out, "--write", &document];
    let output = bench(&arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for name in ["results.json", "kernels.csv", "spheres.csv", "triangles.csv"] {
        let file = Path::new(&out).join(name);
        assert!(fs::metadata(&file).unwrap().len() > 100, "{name}");
    }
    let text = fs::read_to_string(&document).unwrap();
    assert!(text.contains("Seed: 5."));
    let pictures = text.lines().filter_map(|line| line.strip_prefix("![")?.split_once("]("));
    let names: Vec<&str> = pictures.map(|(_, name)| name.trim_end_matches(')')).collect();
    assert!(names.len() >= 4, "{names:?}");
    for name in names {
        let svg = fs::read_to_string(at(name)).unwrap();
        assert!(svg.contains("perpendicular") && svg.contains("</svg>"), "{name}");
        let png = name.replace("accuracy-", "").replace(".svg", ".png");
        let png = oracle::Picture::read_png(&Path::new(&out).join(png));
        let png = png.unwrap();
        assert!(png.pixels().iter().any(|pixel| *pixel != [255; 3]), "{name}");
    }
}
