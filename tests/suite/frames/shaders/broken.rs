//! Shaders that break the contract: the check names them, and the engine stays usable. Also
//! shaders that do not fit.

use std::process::Output;

use cellray::work::Refusal;

use super::program::{build, file, image, program};
use crate::prelude::*;

const SIZE: (u32, u32) = (96, 64);

/// A sphere in front of the background, so that packets at its edge have lanes of both. The light
/// makes it a scene of Whitted's model.
fn scene(shader: &str) -> String {
    format!(
        "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 30\nhither 1\nresolution 96 64\nb 0.1 0.2 0.3\n\
         l 4 5 9\nf 0.7 0.6 0.5 1 0 0 0 0\n{shader}\ns 0 0 0 1\n"
    )
}

fn parsed(shader: &str) -> Scene {
    let scene = scene(shader);
    let scene = scenes::parse(scene.as_bytes(), "sphere", &scenes::Limits::default()).unwrap();
    let render_options = RenderOptions { model: Model::Whitted, ..RenderOptions::default() };
    Scene::new(&scene, render_options, &program()).unwrap()
}

fn engine(check_shaders: bool) -> (Engine, Snapshot) {
    let (framebuffer, shown) = Recorder::pair(SIZE.0, SIZE.1);
    let settings = Settings {
        spus: 2,
        retain: false,
        check_shaders,
        program: program(),
        ..Settings::default()
    };
    (Engine::start(settings, framebuffer).unwrap(), shown)
}

fn refused(engine: &mut Engine, scene: &Scene) -> Refusal {
    match engine.render(scene, &mut |_| ()) {
        Err(EngineError::Refused { refusal, .. }) => refusal,
        Ok(_) => panic!("accepted"),
        Err(error) => panic!("{error}"),
    }
}

#[test]
fn broken_shader_is_named_and_the_next_frame_is_traced() {
    let good = parsed("#cellray shader rings 1 0 0 4");
    let (mut unchecked, shown) = engine(false);
    unchecked.render(&good, &mut |_| ()).unwrap();
    let expected = shown.lock().unwrap().take().unwrap();

    let (mut engine, shown) = engine(true);
    for (shader, broken) in [
        ("changes_90", "changed $90, which it must preserve"),
        ("overruns_stack", "wrote below its 1024 bytes of stack"),
        ("paints_all_lanes", "changed surfaces that it must not shade"),
    ] {
        let bad = parsed(&format!("#cellray shader {shader}"));
        let refusal = refused(&mut engine, &bad);
        assert_eq!(
            refusal.to_string(),
            format!("found that the shader {shader} breaks its contract: it {broken}")
        );
        assert!(shown.lock().unwrap().is_none(), "{shader}: a picture");
        engine.render(&good, &mut |_| ()).unwrap();
        let picture = shown.lock().unwrap().take().unwrap();
        assert!(picture == expected, "after {shader}");
    }
}

/// If a shader has changed the driver's state, the tracer's program refuses valid work. The error
/// then explains how to find the cause, unless the message names it already.
#[test]
fn error_without_check_names_check() {
    let bad = parsed("#cellray shader changes_93");
    for (check_shaders, parts) in [
        (false, ["refused the work units: tiles", "--check-shaders"]),
        (true, ["the shader changes_93", "it changed $93"]),
    ] {
        let (mut engine, _) = engine(check_shaders);
        let error = engine.render(&bad, &mut |_| ()).unwrap_err();
        let text = error.to_string();
        assert!(parts.iter().all(|part| text.contains(part)), "{text}");
        assert_eq!(text.contains("--check-shaders"), !check_shaders, "{text}");
    }
}

/// Pixels outside the sphere get the background's colour whatever the shader writes for their
/// lanes, so nobody would notice the fault without the check.
#[test]
fn wrong_lanes_are_not_found_without_the_check() {
    let (mut engine, shown) = engine(false);
    let bad = parsed("#cellray shader paints_all_lanes");
    engine.render(&bad, &mut |_| ()).unwrap();
    let picture = shown.lock().unwrap().take().unwrap();
    assert_eq!(picture.get_pixel(0, 0).0, [26, 51, 77]);
    let middle = picture.get_pixel(SIZE.0 / 2, SIZE.1 / 2).0;
    assert!(middle[0] > middle[1], "{middle:?}");
}

/// The numbers in a scene belong to the program that it was made with. Another program may have
/// fewer shaders.
#[test]
fn unknown_shader_number_is_refused() {
    let other = parsed("#cellray shader rings 1 0 0 4");
    let (framebuffer, _) = Recorder::pair(SIZE.0, SIZE.1);
    let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
    let number = program().shader("rings").unwrap();
    assert_eq!(
        refused(&mut engine, &other).to_string(),
        format!("has no shader {number}, which a material names")
    );
    let plain = parsed("");
    engine.render(&plain, &mut |_| ()).unwrap();
}

#[test]
fn too_large_shader_is_not_linked() {
    let folder = tempfile::tempdir().unwrap();
    let source = "        .include \"macros.inc\"\n        .include \"shader.inc\"\n\nshader large\n        \
                  bi      $lr\n        .skip   0x10000\nendshader large\n";
    fs::write(folder.path().join("large.s"), source).unwrap();
    let error = build(&[folder.path()], &folder.path().join("tracer.elf")).unwrap_err();
    let text = error.to_string();
    assert!(text.contains("code and fixed data are too large for the local store"), "{text}");
}

#[test]
fn too_long_name_is_not_assembled() {
    let folder = tempfile::tempdir().unwrap();
    let source = "        .include \"macros.inc\"\n        .include \"shader.inc\"\n\n\
                  shader seventeen_letters\n        bi      $lr\nendshader seventeen_letters\n";
    fs::write(folder.path().join("long.s"), source).unwrap();
    let error = build(&[folder.path()], &folder.path().join("tracer.elf")).unwrap_err();
    let text = error.to_string();
    assert!(
        text.contains("the name of a shader has at most 16 characters: seventeen_letters"),
        "{text}"
    );
}

/// Runs `cellray render` with these tests' program and a scene of one sphere.
fn cellray(shader: &str, options: &[&str]) -> (Output, Option<RgbImage>) {
    let folder = tempfile::tempdir().unwrap();
    let [scene_file, image_file, picture] =
        ["sphere.nff", "tracer.elf", "picture.png"].map(|name| folder.path().join(name));
    fs::write(&scene_file, scene(shader)).unwrap();
    fs::write(&image_file, image()).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_cellray"))
        .arg("render")
        .arg(scene_file)
        .arg("--program")
        .arg(image_file)
        .arg("--out")
        .arg(&picture)
        .args(options)
        .output()
        .unwrap();
    // The file has the names of the scene and of the program, too.
    let picture = image::open(picture).ok();
    (output, picture.map(image::DynamicImage::into_rgb8))
}

#[test]
fn command_line_checks_shaders_of_game() {
    let rings = "#cellray shader rings 1 0 0 4";
    let (output, plain) = cellray(rings, &[]);
    assert!(output.status.success(), "{output:?}");
    let (output, checked) = cellray(rings, &["--check-shaders"]);
    assert!(output.status.success(), "{output:?}");
    assert!(plain.is_some() && plain == checked);

    let (output, picture) = cellray("#cellray shader changes_90", &["--check-shaders"]);
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{error}");
    assert!(picture.is_none());
    assert!(error.contains("the shader changes_90 breaks its contract: it changed $90"), "{error}");
    let (output, _) = cellray("#cellray shader ringz", &[]);
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(error.contains("sphere.nff:10: the SPU program has no shader `ringz`"), "{error}");
}

#[test]
fn invalid_program_file_is_refused() {
    let run = |program: &str| {
        Command::new(env!("CARGO_BIN_EXE_cellray"))
            .args(["render", "scenes/paper1.nff", "--size", "8x8", "--program"])
            .arg(program)
            .current_dir(file(""))
            .output()
            .unwrap()
    };
    for (program, part) in [
        ("no/such.elf", "no/such.elf: "),
        ("scenes/paper1.nff", "not an SPU program: "),
        (env!("CARGO_BIN_EXE_cellray"), "not an SPU program: "),
    ] {
        let output = run(program);
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{program}: {error}");
        assert!(error.contains(part), "{program}: {error}");
    }
}
