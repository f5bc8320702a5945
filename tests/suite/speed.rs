//! Frame times in simulated time: six SPUs at 3.192 GHz, 1280x720. They are deterministic, so a
//! change that makes a frame slower than promised fails here on any machine.

use std::collections::BTreeMap;
use std::sync::{Mutex, OnceLock};

use crate::prelude::*;
use serde_json::Value;

/// The statistics of some frames of a scene in simulated time. Several tests use the same ones,
/// which are traced only once because they are always equal.
fn simulated(scene: &str, options: &[&str]) -> Value {
    static TRACED: Mutex<BTreeMap<String, Arc<OnceLock<Value>>>> = Mutex::new(BTreeMap::new());
    let what = format!("{scene} {options:?}");
    let kept = Arc::clone(TRACED.lock().unwrap().entry(what).or_default());
    kept.get_or_init(|| traced(scene, options)).clone()
}

fn traced(scene: &str, options: &[&str]) -> Value {
    let output = Command::new(env!("CARGO_BIN_EXE_cellray"))
        .args(["render", scene, "--size", "1280x720"])
        .args(["--out", "none", "--stats", "-"])
        .args(["--antialias", "1", "--colour", "linear"])
        .args(options)
        .env("LIBSPE2_TIMING", "1")
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    println!("{scene} {options:?}: {errors}");
    serde_json::from_slice(&output.stdout).unwrap()
}

fn number(statistics: &Value, name: &str) -> f64 {
    statistics[name].as_f64().unwrap_or_else(|| panic!("no {name} in {statistics}"))
}

/// Every ray is tested against every sphere: ten times the paper's 52 and 64 frames a second.
#[test]
fn brute_force() {
    for (scene, frames_per_second) in [
        ("scenes/paper16.nff", 670.0),
        ("scenes/paper13.nff", 670.0),
        ("scenes/fullscreen.nff", 900.0),
    ] {
        let found = simulated(scene, &["--no-skip"]);
        let found = number(&found, "frames_per_second");
        assert!(found >= frames_per_second, "{scene}: {found}");
    }
}

/// Everything that can be skipped is skipped, with known costs of the tiles.
#[test]
fn all_culling() {
    let scenes = BTreeMap::from([
        ("scenes/paper1.nff", 3900.0),
        ("scenes/paper13.nff", 1900.0),
        ("scenes/paper16.nff", 1900.0),
        ("scenes/spheres64.nff", 1900.0),
        ("scenes/spheres256.nff", 1500.0),
        ("scenes/fullscreen.nff", 1100.0),
    ]);
    for (scene, frames_per_second) in scenes {
        let found = simulated(scene, &["--retrace", "--frames", "6"]);
        let rate = number(&found, "frames_per_second");
        assert!(rate >= frames_per_second, "{scene}: {rate}");
    }
}

/// Lights, shadows, mirrors and glass to depth 5.
#[test]
fn whitteds_model() {
    let found = simulated("scenes/whitted16.nff", &["--retrace", "--frames", "2"]);
    let rate = number(&found, "frames_per_second");
    assert!(rate >= 60.0, "{rate}");
    let busy = number(&found, "busy_share");
    assert!(busy >= 0.97, "{busy}");
}

/// SPUs hardly wait for each other or for their transfers.
#[test]
fn spus_are_busy() {
    let even = simulated("scenes/paper16.nff", &["--retrace", "--frames", "6"]);
    assert!(number(&even, "busy_share") >= 0.97, "{even}");
    assert!(number(&even, "dma_wait_share") <= 0.02, "{even}");
    let uneven = simulated("scenes/cluster.nff", &["--retrace", "--frames", "100"]);
    assert!(number(&uneven, "busy_share") >= 0.95, "{uneven}");
    let slices = ["--retrace", "--frames", "6", "--split", "slices"];
    let slices = simulated("scenes/cluster.nff", &slices);
    assert!(number(&slices, "busy_share") < 0.7, "the scene is uneven: {slices}");
}

#[test]
fn six_spus_are_six_times_as_fast() {
    for options in [&["--retrace", "--frames", "6"][..], &["--no-skip"]] {
        let rate = |options: &[&str]| {
            let found = simulated("scenes/paper16.nff", options);
            number(&found, "frames_per_second")
        };
        let (six, one) = (rate(options), rate(&[options, &["--spus", "1"]].concat()));
        assert!(six >= 5.8 * one, "{options:?}: {six} and {one}");
    }
}
