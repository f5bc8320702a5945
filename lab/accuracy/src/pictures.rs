//! Whole pictures of every scene by each program that `cellray` carries: simulated time against the
//! picture's error.
//!
//! Weakness: Whitted's reference uses the host library's power function, so its last bits depend
//! on the host.

use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::{Mutex, PoisonError};

use cellray::scene::{Colour, RenderOptions, Samples};
use cellray::spe::Program;
use oracle::whitted::{self, Rounding};
use oracle::{Model, Picture, Pixels, Reference, ULPS, WELL_CONDITIONED};
use protocol::formulation::Formulations;
use serde::{Deserialize, Serialize};
use spu_emulator::simulated::CYCLES_PER_SECOND;

use crate::output::Document;
use crate::parallel;
use crate::run::Extent;
use crate::traced::trace;

/// A picture and its errors.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PictureRow {
    /// The scene.
    pub scene: String,
    /// The program.
    pub program: String,
    /// The width in pixels.
    pub width: u32,
    /// The height in pixels.
    pub height: u32,
    /// Cycles of simulated time for a frame.
    pub cycles: f64,
    /// The number of pixels with an error of more than 1/255 in some channel.
    pub wrong_pixels: u64,
    /// The number of pixels that are wrong if only the scene and the rays' records are rounded.
    pub floor: u64,
    /// The root of the mean square error of all channels, in 1/255.
    pub rmse: f64,
    /// The largest error of a channel, in 1/255.
    pub max_error: u8,
    /// Of a sample of the wrong pixels, the number for each backward error ([`ULPS`]), and then of
    /// those with a larger one. Depth shading has none.
    pub by_ulps: [u64; ULPS.len() + 1],
    /// Of the same sample, the number with a condition number below [`WELL_CONDITIONED`].
    pub well_conditioned: u64,
}

/// A picture with several samples a pixel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AntialiasedRow {
    /// The scene.
    pub scene: String,
    /// The width in pixels.
    pub width: u32,
    /// The height in pixels.
    pub height: u32,
    /// The number of pixels with an error of more than 1/255 in some channel, against the reference
    /// with the same samples.
    pub wrong_pixels: u64,
}

/// The name of the program that `cellray` takes without options.
pub const STANDARD: &str = "default";

/// The wrong pixels of a picture that are explained at most.
const EXPLAINED: usize = 500;

/// The generated scenes.
const GENERATED: [&str; 13] = [
    "gears",
    "jacks",
    "lattice",
    "mount",
    "rings",
    "shells",
    "sombrero",
    "sphereflake:4",
    "sphereflake:6",
    "teapot",
    "terrain:6",
    "tetra:6",
    "tree",
];

/// The scenes with sixteen samples where the contrast is high.
const ANTIALIASED: [&str; 2] = ["whitted16", "still-life"];
/// The contrast above which pixels of these have all samples.
pub const ANTIALIASED_CONTRAST: u8 = 16;

/// Why there is no picture: an error of the scene, an SPU program, the engine or the reference.
pub type PictureError = Box<dyn Error + Send + Sync>;

/// Makes libspe2 run in simulated time, in which frames a second are counted.
///
/// # Safety
///
/// No other thread may be running yet.
pub unsafe fn simulate_time() {
    // SAFETY: the caller ensures that no other thread reads the environment now.
    unsafe { std::env::set_var("LIBSPE2_TIMING", "1") };
}

/// The programs, from the paper's to the most exact.
pub fn programs() -> [(&'static str, Formulations); 4] {
    [
        ("paper", Formulations::paper()),
        ("fast", Formulations::fast()),
        (STANDARD, Formulations::standard()),
        ("exact", Formulations::exact()),
    ]
}

/// The repository's folder of scenes.
const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes");

/// The names of all scenes: the repository's, and the generated ones.
fn names() -> Result<Vec<String>, PictureError> {
    let failed = |error| format!("{FOLDER}: {error}");
    let mut names = Vec::new();
    for entry in fs::read_dir(FOLDER).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let ending = path.extension().unwrap_or_default();
        let name = if ending == "nff" { path.file_stem() } else { path.file_name() };
        if ending == "nff" || ending == "glb" {
            names.push(name.unwrap_or_default().to_string_lossy().into_owned());
        }
    }
    names.sort_unstable();
    names.extend(GENERATED.map(str::to_owned));
    Ok(names)
}

/// A scene of which pictures are traced.
pub(crate) struct Subject {
    /// Its name.
    pub name: String,
    pub scene: scenes::Scene,
}

impl Subject {
    /// A scene of the repository, or a generated one.
    pub fn load(name: &str) -> Result<Self, PictureError> {
        let file = if name.ends_with(".glb") { name.to_owned() } else { format!("{name}.nff") };
        let file = Path::new(FOLDER).join(file);
        let place = if file.exists() { &file } else { Path::new(name) };
        Ok(Self { name: name.to_owned(), scene: meshes::load(place)?.scene })
    }

    /// Whether it is traced by depth shading.
    pub fn is_by_depth(&self) -> bool {
        self.scene.lights.is_empty()
    }

    fn model(&self, pixels: Pixels) -> Model {
        if self.is_by_depth() {
            Model::Depth(pixels)
        } else {
            Model::Whitted(whitted::Options { pixels, ..whitted::Options::default() })
        }
    }
}

/// Traces these scenes with these programs; without names, all.
///
/// Each picture is traced by a process of its own: the emulator runs the first program of a process
/// several times as fast as later ones.
///
/// # Errors
///
/// Fails if a scene or a size can't be traced, or if an SPU fails.
pub fn measure_all(
    scenes: &[String],
    chosen: &[String],
    extent: Extent,
    progress: impl FnMut(&str) + Send,
) -> Result<Vec<PictureRow>, PictureError> {
    let scenes = if scenes.is_empty() { names()? } else { scenes.to_vec() };
    let all = programs().map(|(name, _)| name.to_owned());
    let chosen = if chosen.is_empty() { &all } else { chosen };
    let pairs: Vec<(&String, &String)> = scenes
        .iter()
        .flat_map(|scene| chosen.iter().map(move |program| (scene, program)))
        .collect();
    let program = std::env::current_exe()?;
    let progress = Mutex::new(progress);
    let row = |(): &mut (), (scene, by): &(&String, &String)| -> Result<_, PictureError> {
        progress.lock().unwrap_or_else(PoisonError::into_inner)(&format!("{scene} by {by}"));
        let mut command = Command::new(&program);
        command.args(["accuracy", "--pictures", "--no-host-time", "--json", "-"]);
        command.args(["--scenes", scene, "--programs", by]);
        command.args((extent == Extent::Full).then_some("--full"));
        let done = command.output()?;
        if !done.status.success() {
            let said = String::from_utf8_lossy(&done.stderr);
            return Err(format!("{scene} by {by}: {}", said.trim()).into());
        }
        Ok(serde_json::from_slice::<Document>(&done.stdout)?.results.pictures)
    };
    let rows = parallel::map(&pairs, || (), row);
    Ok(rows.into_iter().collect::<Result<Vec<_>, _>>()?.concat())
}

/// Rejects unknown programs, and scenes that can't be loaded.
///
/// # Errors
///
/// Names the first of them.
pub fn check(scenes: &[String], programs: &[String]) -> Result<(), PictureError> {
    for program in programs {
        formulations(program)?;
    }
    for scene in scenes {
        Subject::load(scene)?;
    }
    Ok(())
}

/// What the program of this name is built of.
fn formulations(program: &str) -> Result<Formulations, PictureError> {
    let named = programs().into_iter().find(|(name, _)| *name == program);
    named.map(|(_, formulations)| formulations).ok_or_else(|| {
        let known = programs().map(|(name, _)| name).join(", ");
        format!("there is no program {program}; the programs are {known}").into()
    })
}

/// Traces a scene with a program.
///
/// # Errors
///
/// As for [`measure_all`].
pub fn measure(scene: &str, program: &str, size: (u32, u32)) -> Result<PictureRow, PictureError> {
    let formulations = formulations(program)?;
    let subject = Subject::load(scene)?;
    let model = subject.model(Pixels::PLAIN);
    let (reference, _) = model.trace(&subject.scene, size)?;
    let built = Program::of(&formulations)?;
    let traced = trace(scene, &subject.scene, RenderOptions::default(), size, built)?;
    let compared = oracle::compare(&traced.picture, &reference)?;
    let mut row = PictureRow {
        scene: scene.to_owned(),
        program: program.to_owned(),
        width: size.0,
        height: size.1,
        cycles: CYCLES_PER_SECOND as f64 / traced.frames_per_second,
        wrong_pixels: compared.wrong_pixels,
        floor: floor(&subject, model, &reference)?,
        rmse: rmse(&traced.picture, &reference.picture),
        max_error: compared.max_error,
        by_ulps: [0; ULPS.len() + 1],
        well_conditioned: 0,
    };
    if let Model::Whitted(options) = &model {
        let scene = &subject.scene;
        let found = oracle::explain(&traced.picture, &reference, scene, options, EXPLAINED)?;
        row.by_ulps = found.by_ulps();
        row.well_conditioned = found.conditioned(0.0, WELL_CONDITIONED);
    }
    Ok(row)
}

/// The wrong pixels and the floor of a scene's picture by the program that `cellray` takes without
/// options.
pub(crate) fn errors(subject: &Subject, size: (u32, u32)) -> Result<(u64, u64), PictureError> {
    let model = subject.model(Pixels::PLAIN);
    let (reference, _) = model.trace(&subject.scene, size)?;
    let options = RenderOptions::default();
    let traced = trace(&subject.name, &subject.scene, options, size, Program::tracer())?;
    let wrong_pixels = oracle::compare(&traced.picture, &reference)?.wrong_pixels;
    Ok((wrong_pixels, floor(subject, model, &reference)?))
}

/// The number of pixels that are wrong if only the scene and each ray's record lose what singles
/// have no place for. With depth shading, rays have no records.
pub(crate) fn floor(
    subject: &Subject,
    model: Model,
    reference: &Reference,
) -> Result<u64, PictureError> {
    let rounded = match model {
        Model::Whitted(options) => {
            Model::Whitted(whitted::Options { rounding: Rounding::Truncated, ..options })
        }
        depth @ Model::Depth(_) => depth,
    };
    let size = (reference.picture.width(), reference.picture.height());
    let (found, _) = rounded.trace(&oracle::rounded_to_singles(&subject.scene), size)?;
    Ok(oracle::compare(&found.picture, reference)?.wrong_pixels)
}

/// Traces pictures with sixteen samples in pixels of a high contrast, in sRGB as `cellray render`
/// does.
///
/// # Errors
///
/// As for [`measure`].
pub fn antialiased(size: (u32, u32)) -> Result<Vec<AntialiasedRow>, PictureError> {
    let row = |name: &str| {
        let subject = Subject::load(name)?;
        let model = subject.model(Pixels {
            samples: oracle::Samples::Sixteen,
            contrast: ANTIALIASED_CONTRAST,
            colour: oracle::Colour::Srgb,
            ..Pixels::PLAIN
        });
        let options = RenderOptions {
            samples: Samples::Sixteen,
            contrast: ANTIALIASED_CONTRAST,
            colour: Colour::Srgb,
            ..RenderOptions::default()
        };
        let (reference, _) = model.trace(&subject.scene, size)?;
        let traced = trace(name, &subject.scene, options, size, Program::tracer())?;
        let wrong_pixels = oracle::compare(&traced.picture, &reference)?.wrong_pixels;
        Ok(AntialiasedRow { scene: name.to_owned(), width: size.0, height: size.1, wrong_pixels })
    };
    ANTIALIASED.into_iter().map(row).collect()
}

/// The root of the mean square error of all channels, in 1/255.
fn rmse(picture: &Picture, reference: &Picture) -> f64 {
    let pairs = picture.pixels().iter().zip(reference.pixels());
    let channels = pairs.flat_map(|(found, expected)| found.iter().zip(expected));
    // The values are integers, so the sum is exact.
    let sum: u64 =
        channels.map(|(found, expected)| u64::from(found.abs_diff(*expected)).pow(2)).sum();
    (sum as f64 / (3 * picture.pixels().len()) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rms_error_includes_all_channels() {
        let black = Picture::black(2, 2).unwrap();
        let mut picture = black.clone();
        picture.pixels_mut()[3] = [3, 0, 0];
        picture.pixels_mut()[1] = [0, 0, 255];
        let expected = ((9.0 + 65025.0) / 12.0_f64).sqrt();
        assert_eq!(rmse(&picture, &black), expected);
        assert_eq!(rmse(&black, &black), 0.0);
    }

    #[test]
    fn every_scene_has_a_name_and_errors_are_counted() {
        let names = names().unwrap();
        for name in ["whitted16", "far", "chess.glb", "sphereflake:4"] {
            assert!(names.iter().any(|known| known == name), "{name}: {names:?}");
        }
        for name in ["paper16", "sphereflake:2"] {
            let row = measure(name, STANDARD, (160, 120)).unwrap();
            assert!(row.wrong_pixels <= 160 * 120 / 50, "{row:?}");
            assert!(row.cycles > 1e5, "{row:?}");
            let explained = row.by_ulps.iter().sum::<u64>();
            let is_whitted = row.scene != "paper16";
            assert_eq!(explained, if is_whitted { row.wrong_pixels } else { 0 }, "{row:?}");
        }
    }
}
