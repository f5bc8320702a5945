//! The program `oracle` from outside.

use std::fs;
use std::process::{Command, Output};

use oracle::{Picture, Settings};
use serde_json::Value;
use tempfile::TempDir;

/// The code and the output of `oracle`.
struct Said {
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

/// Runs `oracle` with these words in `folder`.
fn oracle(folder: &TempDir, words: &str) -> Said {
    let mut command = Command::new(env!("CARGO_BIN_EXE_oracle"));
    command.args(words.split_whitespace()).current_dir(folder.path());
    let Output { status, stdout, stderr } = command.output().expect("oracle runs");
    let [stdout, stderr] = [stdout, stderr].map(|text| String::from_utf8(text).expect("UTF-8"));
    Said { code: status.code(), stdout, stderr }
}

/// As [`oracle`], which must succeed.
fn succeeds(folder: &TempDir, words: &str) -> Said {
    let said = oracle(folder, words);
    assert_eq!(said.code, Some(0), "{words}: {}", said.stderr);
    said
}

/// As [`oracle`], which must fail with this code and this message.
fn fails(folder: &TempDir, words: &str, code: i32, message: &str) -> Said {
    let said = oracle(folder, words);
    assert_eq!(said.code, Some(code), "{words}");
    assert!(said.stderr.contains(message), "{words}: {}", said.stderr);
    said
}

fn json(said: &Said) -> Value {
    serde_json::from_str(&said.stdout).expect("JSON")
}

fn empty_folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

/// Changes a picture and its settings.
fn change(folder: &TempDir, name: &str, change: impl FnOnce(&mut Picture, &mut Settings)) {
    let file = folder.path().join(name);
    let mut settings = Settings::of_png(&file).expect("settings");
    let mut picture = Picture::read_png(&file).expect("a PNG");
    change(&mut picture, &mut settings);
    picture.write_png_with(&file, &settings).expect("written");
}

/// A folder with a picture of the sphereflake, one byte of which is wrong by 5. Its metadata holds
/// the settings.
fn folder() -> TempDir {
    let folder = empty_folder();
    let words = "render sphereflake:1 --size 64x48 --model depth --antialias 1 --out a.png";
    assert!(succeeds(&folder, words).stdout.is_empty());
    change(&folder, "a.png", |picture, _| {
        assert_eq!((picture.width(), picture.height()), (64, 48));
        // The upper left corner shows the background, far from every sphere.
        assert_eq!(picture.pixels()[0], [20, 92, 192]);
        picture.pixels_mut()[0][2] -= 5;
    });
    folder
}

#[test]
fn a_comparison_as_json_has_exactly_its_fields() {
    let folder = folder();
    let said = succeeds(&folder, "compare a.png sphereflake:1 --json --diff d.png");
    for line in [
        "d.png: the difference, 16 times amplified",
        "sphereflake:1:13: polygons are not drawn by depth shading (1 in this file)",
    ] {
        assert!(said.stderr.contains(line), "{}", said.stderr);
    }
    let expected = serde_json::json!({
        "wrong_pixels": 1,
        "wrong_fraction": 1.0 / 3072.0,
        "wrong_off_silhouette": 1,
        "max_error": 5,
        "max_error_off_silhouette": 5,
        "mean_error": 5.0 / 9216.0,
    });
    assert_eq!(json(&said), expected);
    let difference = Picture::read_png(&folder.path().join("d.png")).expect("a PNG");
    assert_eq!(difference.pixels()[0], [0, 0, 80]);
    assert!(difference.pixels()[1..].iter().all(|pixel| *pixel == [0; 3]));
}

#[test]
fn a_comparison_as_text() {
    let folder = folder();
    assert_eq!(
        succeeds(&folder, "compare a.png sphereflake:1").stdout,
        "wrong pixels   1 of 3072 (0.0326 %), 1 off silhouettes\n\
         largest error  5/255, 5/255 off silhouettes\n\
         mean error     0.0005/255\n"
    );
}

#[test]
fn errors_name_their_file_and_exit_1() {
    let folder = folder();
    fs::write(folder.path().join("bad.nff"), "v\nfrom 0 0 x\n").expect("written");
    fs::write(folder.path().join("bad.png"), "no PNG").expect("written");
    let grey = image::GrayImage::new(4, 4);
    grey.save(folder.path().join("grey.png")).expect("written");
    for (words, message) in [
        ("compare missing.png sphereflake:1", "missing.png: "),
        ("compare bad.png sphereflake:1", "bad.png: "),
        ("compare grey.png sphereflake:1", "grey.png: the PNG has pixels of the kind L8"),
        ("compare a.png bad.nff", "bad.nff:2: from z `x` is not a number"),
        ("compare a.png missing.nff", "missing.nff: "),
        ("compare a.png sphereflake:1 --diff no/d.png", "no/d.png: "),
        ("render sphereflake:9 --out b.png", "435848050 spheres"),
        ("render tetra:12 --out b.png", "67108864 polygons"),
    ] {
        let said = fails(&folder, words, 1, message);
        assert!(said.stdout.is_empty() && said.stderr.contains("oracle: "), "{words}");
    }
}

#[test]
fn invalid_sizes_are_usage_errors() {
    let folder = empty_folder();
    let form = "a size is written as WIDTHxHEIGHT";
    let limit = "each side must be 1 to 8192";
    for (size, message) in [
        ("64", form),
        ("64x", form),
        ("64x-1", form),
        ("-5x10", form),
        ("64x48x3", form),
        ("0x48", limit),
        ("8193x1", limit),
        ("16384x16384", limit),
        ("99999999999x1", limit),
    ] {
        let words = format!("render sphereflake:1 --size {size} --out b.png");
        let said = fails(&folder, &words, 2, message);
        assert!(said.stderr.contains("--size <WxH>"), "{}", said.stderr);
    }
}

#[test]
fn the_help_has_examples() {
    let help = succeeds(&empty_folder(), "--help").stdout;
    assert!(help.contains("oracle compare frame.png scenes/paper16.nff"));
}

#[test]
fn whitted_render_counts_rays_and_compares() {
    let folder = empty_folder();
    let words = "render sphereflake:1 --model whitted --ray-depth 3 --size 64x48 --out w.png --stats \
                 --corners";
    let said = succeeds(&folder, words);
    // Everything is drawn, so the only output is the picture's name, its share and its settings.
    assert_eq!(
        said.stderr,
        "w.png: 64x48, objects cover 100.0 %; made with --antialias 1 --colour linear --corners --model \
         whitted --ray-depth 3\n"
    );
    let found = json(&said);
    let count = |name: &str| found[name].as_u64().expect("a count");
    assert_eq!(count("eye"), 65 * 49);
    assert_eq!(count("eye_hit"), count("eye"));
    assert_eq!(
        count("eye") + count("reflected") + count("refracted"),
        count("hit") + count("background")
    );
    assert!(count("shadow") > count("hit"));

    let compare = |options: &str| {
        let said = succeeds(&folder, &format!("compare w.png --json {options}"));
        json(&said)["wrong_pixels"].as_u64().expect("a count")
    };
    assert_eq!(compare(""), 0);
    assert_eq!(compare("sphereflake:1"), 0);
    assert!(compare("--corners=false") > 100);
    assert!(compare("--ray-depth 1") > 100);
}

#[test]
fn options_without_effect_on_depth_shading_are_usage_errors() {
    let folder = empty_folder();
    let base = "render sphereflake:1 --out b.png --model depth";
    for option in ["--stats", "--no-shadows", "--fresnel", "--spd-rays", "--ray-depth 3"] {
        let name = option.split(' ').next().unwrap_or(option);
        fails(&folder, &format!("{base} {option}"), 2, &format!("{name} needs --model whitted"));
    }
    for depth in ["0", "17", "-1", "x"] {
        fails(&folder, &format!("{base} --ray-depth {depth}"), 2, "--ray-depth <N>");
    }
}

#[test]
fn settings_are_printed_with_their_sources() {
    let folder = folder();
    let stderr = succeeds(&folder, "compare a.png --colour srgb --angle 40").stderr;
    for line in [
        concat!(
            "oracle: a.png by oracle ",
            env!("CARGO_PKG_VERSION"),
            ", 64x48, is compared with sphereflake:1 in double precision\n"
        ),
        "oracle: settings of the picture: --antialias 1 --model depth\n",
        "oracle: settings of the command line: --angle 40 --colour srgb\n",
    ] {
        assert!(stderr.contains(line), "no {line:?} in {stderr}");
    }
    assert!(!stderr.contains("assumed"), "{stderr}");
    // Another scene than the picture's is a mistake more often than not.
    let stderr = succeeds(&folder, "compare a.png sphereflake:2").stderr;
    assert!(stderr.contains("note: the picture is of sphereflake:1"), "{stderr}");

    // Without settings, the defaults of `cellray render` are assumed.
    let file = folder.path().join("a.png");
    Picture::read_png(&file).expect("a PNG").write_png(&file).expect("written");
    let stderr = succeeds(&folder, "compare a.png sphereflake:1 --ray-depth 3").stderr;
    for line in [
        "oracle: a.png, 64x48, is compared with",
        "oracle: settings of the command line: --ray-depth 3\n",
        "oracle: assumed: --antialias 4 --colour srgb --contrast 32 --model whitted\n",
        "oracle: the reference has 4 samples in ",
    ] {
        assert!(stderr.contains(line), "no {line:?} in {stderr}");
    }
    assert!(!stderr.contains("settings of the picture"), "{stderr}");
    fails(&folder, "compare a.png", 1, "a.png has no description of its scene");
}

#[test]
fn every_setting_is_read_from_the_picture_again() {
    let folder = empty_folder();
    let options = "--from=3,-2,1 --look-at=0,0,0.25 --up=0,1,1 --angle=30 --model=whitted \
                   --ray-depth=2 --fresnel --spd-rays --no-shadows --antialias=16 --contrast=8 \
                   --colour=srgb --roll-off --corners";
    succeeds(&folder, &format!("render sphereflake:1 --size 40x30 --out s.png {options}"));
    let settings = Settings::of_png(&folder.path().join("s.png")).expect("settings");
    let mut expected: Vec<_> =
        options.split_whitespace().map(|option| option.replace('=', " ")).collect();
    expected.sort();
    assert_eq!(settings.followed(), expected);
    succeeds(&folder, "compare s.png --max-wrong 0");
    // Each of them matters.
    let others = "--from=3,-2,2 --look-at=0,0,0 --up=0,0,1 --angle=31 --model=depth --ray-depth=1 \
                  --no-shadows=false --antialias=4 --contrast=200 --colour=linear --corners=false";
    for other in others.split_whitespace() {
        let words = format!("compare s.png --max-wrong 0 {other}");
        fails(&folder, &words, 1, "more than --max-wrong 0");
    }
}

#[test]
fn animations_have_the_time_of_the_picture() {
    let folder = empty_folder();
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/reef.glb");
    let options = "--animation=swell --time=1.5 --antialias=1";
    succeeds(&folder, &format!("render {scene} --size 40x30 --out s.png {options}"));
    succeeds(&folder, "compare s.png --max-wrong 0");
    fails(&folder, "compare s.png --max-wrong 0 --time=0", 1, "more than --max-wrong 0");
    fails(&folder, "compare s.png --animation=none", 1, "no animation for --time");
    fails(&folder, "compare s.png --animation 7", 1, "no animation `7`; it has `swell`");
    fails(&folder, "render sphereflake:1 --time 1 --out t.png", 1, "no animation for --time");
}

#[test]
fn the_share_of_wrong_pixels_that_is_allowed() {
    let folder = folder();
    for (most, code) in [("0.0003", 1), ("0.0004", 0), ("0", 1), ("1", 0)] {
        let said = oracle(&folder, &format!("compare a.png --max-wrong {most}"));
        assert_eq!(said.code, Some(code), "{most}: {}", said.stderr);
    }
    for share in ["-0.1", "1.5", "5%", "nan"] {
        let words = format!("compare a.png --max-wrong {share}");
        fails(&folder, &words, 2, "a number from 0 to 1");
    }
}

#[test]
fn unknown_settings_are_reported() {
    let folder = folder();
    change(&folder, "a.png", |_, settings| {
        settings.set("fog", "thick\u{1b}");
        settings.set("quality", "fast");
    });
    let stderr = succeeds(&folder, "compare a.png").stderr;
    // Text from a file must not control a terminal.
    assert!(stderr.contains("unknown here: --fog thick\\u{1b}\n"), "{stderr}");
    assert!(stderr.contains("of no use to the reference: --quality fast\n"), "{stderr}");
    change(&folder, "a.png", |_, settings| settings.set("contrast", "much"));
    let message =
        "a.png: its setting contrast is \"much\", which is not a whole number from 0 to 255";
    fails(&folder, "compare a.png", 1, message);
}

#[test]
fn a_reference_has_nothing_to_explain_and_a_wrong_pixel_no_explanation() {
    let folder = empty_folder();
    succeeds(&folder, "render sphereflake:1 --size 64x48 --antialias 1 --out a.png");
    let explained = || json(&succeeds(&folder, "explain a.png --json"));
    assert_eq!(explained()["wrong_pixels"], serde_json::json!([]));
    change(&folder, "a.png", |picture, _| picture.pixels_mut()[64 * 2 + 5][1] ^= 0x40);
    let found = explained();
    let pixels = found["wrong_pixels"].as_array().expect("an array");
    assert_eq!(pixels.len(), 1);
    let pixel = &pixels[0];
    assert_eq!((&pixel["x"], &pixel["y"]), (&5.into(), &2.into()));
    assert!(pixel["ulps"].is_null(), "{pixel}");
    // The pixel shows one surface, and its ray is far from every edge.
    assert!(pixel["condition"].as_f64().expect("a number") < oracle::WELL_CONDITIONED, "{pixel}");
}

/// The edge of a square passes through the middle of the picture. There the picture has the colour
/// from the other side of the edge.
#[test]
fn wrong_pixel_on_an_edge_is_ill_conditioned() {
    let folder = empty_folder();
    let scene = "v\nfrom 0 -10 0\nat 0.3 0 0\nup 0 0 1\nangle 40\nhither 0\nresolution 65 65\n\
                 b 0 0 1\nl 0.3 -10 5\nf 1 0 0 1 0 0 0 1\n\
                 p 4\n0.3 0 -1\n2.3 0 -1\n2.3 0 1\n0.3 0 1\n";
    fs::write(folder.path().join("edge.nff"), scene).expect("written");
    succeeds(&folder, "render edge.nff --antialias 1 --out a.png");
    change(&folder, "a.png", |picture, _| {
        let [left, middle, right] = [31, 32, 33].map(|x| picture.pixels()[65 * 32 + x]);
        picture.pixels_mut()[65 * 32 + 32] = if middle == left { right } else { left };
    });
    let said = succeeds(&folder, "explain a.png").stdout;
    for line in ["wrong pixels   1", "within  1 ulp  1", "condition from 1000000  1"] {
        assert!(said.lines().any(|found| found == line), "{said}");
    }
}

#[test]
fn samples_can_not_be_explained() {
    let folder = empty_folder();
    succeeds(&folder, "render sphereflake:1 --size 64x48 --antialias 4 --out a.png");
    fails(&folder, "explain a.png", 1, "--antialias 1");
}

#[test]
fn truncated_rays_are_wrong_in_more_pixels_than_the_scene() {
    let words = "floor sphereflake:4 --size 256x256 --antialias 1 --json";
    let found = json(&succeeds(&empty_folder(), words));
    let wrong = |name: &str| found[name]["wrong_pixels"].as_u64().expect("a number");
    assert!(wrong("truncated") > wrong("scene") && wrong("nearest") > 0, "{found}");
}
