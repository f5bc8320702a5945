//! The command line from outside: its output, and its messages about bad input.

mod beside;
mod default_output;
mod formulations;
mod inspect;
mod meshes;
mod newcomer;
mod outputs;
mod sequence;
mod settings;
mod silence;
mod slips;
mod support;
mod whitted;

use std::fs::File;

use crate::prelude::*;
use support::{VIEW, bad, bad_scene, good, text};

#[test]
fn picture_is_rendered_with_statistics() {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("p.png");
    let stats = folder.path().join("s.json");
    good(&[
        "render",
        "scenes/paper16.nff",
        "--size",
        "160x90",
        "--spus",
        "3",
        "--frames",
        "2",
        "--split",
        "slices",
        "--retrace",
        "--antialias",
        "1",
        "--out",
        picture.to_str().unwrap(),
        "--stats",
        stats.to_str().unwrap(),
    ]);
    let picture = image::open(picture).unwrap();
    assert_eq!((picture.width(), picture.height()), (160, 90));
    let stats: serde_json::Value = serde_json::from_slice(&fs::read(stats).unwrap()).unwrap();
    assert_eq!(stats["width"], 160);
    assert_eq!(stats["height"], 90);
    assert_eq!(stats["spus"], 3);
    assert_eq!(stats["frames"], 2);
    assert_eq!(stats["rays"]["eye"], 2 * 160 * 90);
    assert!(stats["rays"]["eye_hit"].as_u64().unwrap() > 160 * 90 / 2);
    for kind in ["reflected", "refracted", "shadow"] {
        assert_eq!(stats["rays"][kind], 0);
    }
    assert_eq!(stats["frames_traced"], 2);
    // Whole packets are counted: the bottom row of packets is half within the picture.
    let tests = |kind: &str| stats["tests"][kind].as_u64().unwrap();
    assert_eq!(tests("made") + tests("skipped") + tests("unseen"), 2 * 160 * 92 * 16);
    assert!(tests("made") < 2 * 160 * 92 * 4);
    assert!(
        tests("intersections_computed") <= tests("made") && tests("hidden") <= tests("skipped")
    );
    assert!(tests("cull") > 0);
    let tiles = |kind: &str| stats["tiles"][kind].as_u64().unwrap();
    assert_eq!(tiles("traced") + tiles("filled"), 2 * 3 * 6);
    assert_eq!(tiles("retained"), 0);
    assert_eq!(
        stats["packets"]["traced"].as_u64().unwrap() + stats["packets"]["filled"].as_u64().unwrap(),
        2 * 40 * 23
    );
    for share in ["busy_share", "dma_wait_share"] {
        assert!((0.0..=1.0).contains(&stats[share].as_f64().unwrap()));
    }
    assert!(stats["scene"].as_str().unwrap().contains("paper16"));
    assert!(stats["host_seconds"].as_f64().unwrap() > 0.0);
    assert!(stats["frames_per_second"].as_f64().unwrap() > 0.0);
    let spus = stats["spu"].as_array().unwrap();
    assert_eq!(spus.len(), 3);
    assert_eq!(spus.iter().map(|spu| spu["tiles"].as_u64().unwrap()).sum::<u64>(), 2 * 3 * 6);
    for spu in spus {
        assert!(spu["busy"].as_f64().unwrap() > 0.0);
        assert!(spu["packets"].as_u64().unwrap() > 0);
        let number = |name: &str| spu[name].as_f64().unwrap();
        let percent = number("busy_percent") + number("dma_wait_percent") + number("idle_percent");
        assert!((percent - 100.0).abs() < 1e-6);
        let phases = spu["phases"].as_object().unwrap();
        let phases: f64 = phases.values().map(|phase| phase.as_f64().unwrap()).sum();
        assert!(phases > 0.0 && phases <= number("busy") * (1.0 + 1e-9));
    }
}

#[test]
fn still_frame_is_traced_once_by_default() {
    let run = |option: &[&str]| -> (serde_json::Value, String) {
        let arguments = [
            "render",
            "scenes/cluster.nff",
            "--size",
            "160x90",
            "--frames",
            "4",
            "--antialias",
            "1",
            "--out",
            "none",
            "--stats",
            "-",
        ];
        let (out, err) = good(&[&arguments[..], option].concat());
        (serde_json::from_str(&out).unwrap(), err)
    };
    let (stats, err) = run(&[]);
    assert_eq!((&stats["frames"], &stats["frames_traced"]), (&4.into(), &1.into()));
    assert_eq!(stats["rays"]["eye"], 160 * 90);
    assert_eq!(stats["tiles"]["retained"], 3 * 3 * 6);
    assert!(err.contains("4 frame(s), 1 traced"), "{err}");
    for option in ["--retrace", "--no-skip"] {
        let (stats, err) = run(&[option]);
        assert_eq!(stats["frames_traced"], 4, "{option}");
        assert_eq!(stats["rays"]["eye"], 4 * 160 * 90, "{option}");
        assert_eq!(stats["tiles"]["retained"], 0, "{option}");
        assert!(err.contains("4 frame(s), 4 traced"), "{option}: {err}");
    }
    let (stats, _) = run(&["--no-skip"]);
    assert_eq!(stats["tests"]["made"], 4 * 160 * 92 * 40);
    assert_eq!(stats["tests"]["skipped"], 0);
}

#[test]
fn skipping_changes_no_byte_of_a_picture() {
    let folder = tempfile::tempdir().unwrap();
    let [skipping, without] = [None, Some("--no-skip")].map(|option| {
        let picture = folder.path().join("p.png");
        let arguments = ["render", "sphereflake:2", "--size", "200x150", "--out"];
        let picture_name = [picture.to_str().unwrap()];
        good(&[&arguments[..], &picture_name, option.as_slice()].concat());
        fs::read(picture).unwrap()
    });
    assert!(skipping == without);
}

/// Transfers that complete as late as possible, and in the wrong order where that is allowed,
/// change nothing: the SPU program waits for everything that it needs.
#[test]
fn late_transfers_give_same_picture() {
    let folder = tempfile::tempdir().unwrap();
    // Spheres in local store; triangles, spheres and tiles of textures that are fetched when
    // needed.
    for scene in ["sphereflake:3", "terrain:5", "sphereflake:4", "scenes/chess.glb"] {
        let [at_once, at_last] = ["at-once", "at-last"].map(|policy| {
            let path = folder.path().join(policy);
            let arguments = ["render", scene, "--size", "132x100", "--frames", "3", "--out"];
            let output = Command::new(env!("CARGO_BIN_EXE_cellray"))
                .args(arguments)
                .arg(&path)
                .env("LIBSPE2_MFC", policy)
                .current_dir(env!("CARGO_MANIFEST_DIR"))
                .output()
                .unwrap();
            let messages = text(&output.stderr);
            assert!(output.status.success(), "{scene}, {policy}: {messages}");
            fs::read(path).unwrap()
        });
        assert!(at_once == at_last, "{scene}");
    }
}

/// In simulated time the statistics are the console's, and two runs have identical statistics.
#[test]
fn simulated_time_is_repeatable() {
    let folder = tempfile::tempdir().unwrap();
    let [first, second] = ["first", "second"].map(|name| {
        let report = folder.path().join(name);
        let output = Command::new(env!("CARGO_BIN_EXE_cellray"))
            .args([
                "render",
                "scenes/paper16.nff",
                "--size",
                "320x180",
                "--antialias",
                "1",
                "--out",
                "none",
                "--stats",
                "-",
            ])
            .envs([("LIBSPE2_TIMING", "1".as_ref()), ("LIBSPE2_REPORT", report.as_os_str())])
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", text(&output.stderr));
        let stats: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        (stats["frames_per_second"].clone(), stats["spu"].clone(), fs::read(report).unwrap())
    });
    assert_eq!(first.0, second.0);
    assert_eq!(first.1, second.1);
    assert!(first.2 == second.2, "the reports differ");
    // This is a sixteenth of a frame that takes half a millisecond.
    let frames_per_second = first.0.as_f64().unwrap();
    assert!((10_000.0..50_000.0).contains(&frames_per_second), "{frames_per_second}");
}

#[test]
fn statistics_on_standard_output_are_pure_json() {
    let (out, _) =
        good(&["render", "scenes/paper13.nff", "--size", "8x8", "--out", "none", "--stats", "-"]);
    serde_json::from_str::<serde_json::Value>(&out).unwrap();
}

#[test]
fn file_replaces_framebuffer() {
    let folder = tempfile::tempdir().unwrap();
    let device = folder.path().join("fb0");
    let picture = folder.path().join("p.png");
    good(&["fb", "scenes/paper16.nff", "--size", "101x57", "--device", device.to_str().unwrap()]);
    good(&["render", "scenes/paper16.nff", "--size", "101x57", "--out", picture.to_str().unwrap()]);
    let bytes = fs::read(device).unwrap();
    let picture = image::open(picture).unwrap().into_rgb8();
    let stride = bytes.len() / 57;
    for (x, y, pixel) in picture.enumerate_pixels() {
        let offset = y as usize * stride + x as usize * 4;
        assert_eq!(bytes[offset..offset + 4], [0, pixel[0], pixel[1], pixel[2]], "pixel {x}, {y}");
    }
}

#[test]
fn framebuffer_of_other_geometry_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let device = folder.path().join("fb0");
    let device = device.to_str().unwrap();
    good(&["fb", "scenes/paper16.nff", "--size", "64x32", "--device", device]);
    let before = fs::read(device).unwrap();
    bad(&["fb", "scenes/paper16.nff", "--size", "64x48", "--device", device], &[device, "64x48"]);
    assert_eq!(fs::read(device).unwrap(), before);
    bad(
        &["fb", "scenes/paper16.nff", "--device", "/nonexistent/fb0", "--size", "4x4"],
        &["/nonexistent"],
    );
    bad(
        &["fb", "scenes/paper16.nff", "--device", "/dev/null"],
        &["/dev/null", "FBIOGET_VSCREENINFO"],
    );
}

#[test]
fn bad_scenes_are_errors() {
    bad_scene("", &["bad.nff"]);
    bad_scene("v\nfrom 0 0 9\nat 0 0", &["bad.nff", "3"]);
    bad_scene(&format!("{VIEW}s 0 0 0 NaN\n"), &["bad.nff:9", "NaN"]);
    bad_scene(&format!("{VIEW}s 0 0 0 1e999\n"), &["bad.nff:9", "1e999"]);
    bad_scene(&format!("{VIEW}s 1e30 0 0 1\n"), &["bad.nff", "sphere 1"]);
    bad_scene(&format!("{VIEW}s 0 0 0 1e-30\n"), &["bad.nff", "radius of sphere 1", "2^-62"]);
    bad_scene(&format!("{VIEW}p 4000000000\n0 0 0\n"), &["bad.nff:9"]);
    bad_scene(&format!("{VIEW}q 1 2\n"), &["bad.nff:9", "q"]);
    let many = "s 0 0 0 1\n".repeat(2049);
    bad_scene(&format!("{VIEW}{many}"), &["2049 spheres", "the maximum is 1024"]);
    bad(&["render", "no/such/scene.nff"], &["no/such/scene.nff"]);
    bad(&["render", "sphereflake:99"], &["99"]);
    bad(&["render", "tetra:99"], &["tetra of level 99"]);
    bad_scene(&format!("{VIEW}#cellray fog\n"), &["bad.nff:9", "fog"]);
}

/// A file of 17 GB that needs no space on the disk: a sparse file is all zero bytes, whatever its
/// first line is.
#[test]
fn scene_of_17_gigabytes_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("huge.nff");
    let huge = |start: &[u8]| {
        fs::write(&path, start).unwrap();
        let file = File::options().write(true).open(&path).unwrap();
        file.set_len(17 << 30).unwrap();
    };
    huge(b"");
    let name = path.to_str().unwrap();
    bad(&["render", name], &["huge.nff: this is a binary file"]);
    huge(&[b'#'; 5000]);
    bad(&["render", name], &["huge.nff:1: the line is longer than"]);
    bad(&["render", "sphereflake:9"], &["435848050"]);
}

#[test]
fn bad_arguments_are_errors() {
    let scene = "scenes/paper16.nff";
    for size in ["0x10", "9000x10", "99999999999x10"] {
        let message = format!("a picture of {size} pixels: each side must be 1 to 8192");
        bad(&["render", scene, "--size", size], &["--size <WxH>", &message]);
    }
    bad(&["render", scene, "--size", "big"], &["big"]);
    for verb in ["render", "fb"] {
        for (option, value) in [
            ("--size <WxH>", "-5x10"),
            ("--spus <N>", "-1"),
            ("--ray-depth <N>", "-2"),
            ("--timeout <S>", "-3"),
            ("--frames <", "-4"),
        ] {
            let name = option.split(' ').next().unwrap();
            let parts = [&format!("'{value}' for '{option}")[..]];
            bad(&[verb, scene, name, value], &parts);
        }
    }
    bad(&["render", scene, "--frames", "-4..2"], &["'-4..2' for '--frames <A..B>'"]);
    bad(&["render", scene, "--turn", "-1"], &["'-1' for '--turn <N>'"]);
    bad(&["fb", scene, "--buffers", "-1"], &["'-1' for '--buffers <N>'"]);
    bad(&["sphereflake", "-1"], &["'-1' for '<LEVEL>'"]);
    bad(&["render", scene, "--size", "8x8", "--spus", "0"], &["0 SPUs", "1 to 16"]);
    bad(&["render", scene, "--size", "8x8", "--spus", "17"], &["17 SPUs"]);
    bad(&["render", scene, "--split", "half"], &["half", "units", "slices"]);
    bad(&["render", scene, "--frames", "0"], &["0"]);
    bad(&["render", scene, "--ray-depth", "0"], &["0", "1 to 16"]);
    bad(&["render", scene, "--ray-depth", "17"], &["17", "1 to 16"]);
    bad(&["render", scene, "--model", "gouraud"], &["gouraud", "depth", "whitted"]);
    bad(&["fb", scene, "--corners"], &["--corners"]);
    bad(&["render", scene, "--size", "8x8", "--out", "/nonexistent/p.png"], &["/nonexistent"]);
    bad(
        &["render", scene, "--size", "8x8", "--out", "none", "--stats", "/nonexistent/s.json"],
        &["/nonexistent/s.json"],
    );
}

#[test]
fn info_names_the_library_and_its_spes() {
    let (out, _) = good(&["info", "--device", "/nonexistent"]);
    let program = Path::new(env!("CARGO_BIN_EXE_cellray")).file_name().unwrap();
    assert!(out.contains(program.to_str().unwrap()), "{out}");
    assert!(out.contains("SPEs         6"), "{out}");
    let formulations = "with --sphere also by interpolated, double, paper\n";
    assert!(out.contains(formulations), "{out}");
    assert!(out.contains("kernels -- image --sphere NAME"), "{out}");
    assert!(out.contains("/nonexistent"), "{out}");
}

#[test]
fn help_has_examples() {
    let (out, _) = good(&["--help"]);
    assert!(out.contains("cellray render scenes/paper16.nff"), "{out}");
}

#[test]
fn sphereflake_is_written_as_scene() {
    let (out, _) = good(&["sphereflake", "2"]);
    let scene = scenes::parse(out.as_bytes(), "balls", &scenes::Limits::default()).unwrap();
    assert_eq!(scene, scenes::sphereflake::generate(2).unwrap());
}
