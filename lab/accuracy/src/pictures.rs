//! Whole pictures with each formulation of spheres: frames a second in simulated time against the
//! picture's error.
//!
//! Weakness: Whitted's reference uses the host library's power function, so its last bits depend
//! on the host.

use std::error::Error;
use std::sync::{Arc, Mutex, PoisonError};

use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry, Memory, Target};
use cellray::scene::{Model, RenderOptions};
use cellray::spe::Program;
use cellray::{Engine, Report, Scene, Settings};
use image::RgbImage;
use kernels::set;
use oracle::{Picture, Reference, whitted};
use protocol::formulation::{Formulations, SPHERES, SphereFormulation};
use serde::{Deserialize, Serialize};

use crate::families::Form;

/// The picture of a formulation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PictureRow {
    /// The formulation.
    pub formulation: String,
    /// The scene.
    pub scene: String,
    /// The width in pixels.
    pub width: u32,
    /// The height in pixels.
    pub height: u32,
    /// Frames a second in simulated time.
    pub frames_per_second: f64,
    /// The root of the mean square error of all channels, in 1/255.
    pub rmse: f64,
    /// The largest error of a channel, in 1/255.
    pub max_error: u8,
    /// The same for pixels that are not on a silhouette.
    pub max_error_off_silhouette: u8,
    /// The number of pixels with an error of more than 1 in some channel.
    pub wrong_pixels: u64,
    /// The number of those that are not on a silhouette.
    pub wrong_off_silhouette: u64,
}

/// A scene of which pictures are traced.
#[derive(Clone, Copy, Debug)]
pub struct Subject {
    /// The scene's name.
    pub name: &'static str,
    /// Its description.
    pub doc: &'static str,
    text: &'static str,
    model: Model,
}

/// The scenes.
pub const SCENES: &[Subject] = &[
    Subject {
        name: "paper16",
        doc: "depth shading, 16 spheres 5 to 27 radii away",
        text: include_str!("../../../scenes/paper16.nff"),
        model: Model::Depth,
    },
    Subject {
        name: "far",
        doc: "depth shading, the same spheres through a telephoto lens, 1862 to 9102 radii away",
        text: include_str!("../../../scenes/far.nff"),
        model: Model::Depth,
    },
    Subject {
        name: "whitted16",
        doc: "Whitted's model, 16 spheres on a ground",
        text: include_str!("../../../scenes/whitted16.nff"),
        model: Model::Whitted,
    },
    Subject {
        name: "far-whitted",
        doc: "Whitted's model, the same scene through a telephoto lens, 4096 away",
        text: include_str!("../../../scenes/far-whitted.nff"),
        model: Model::Whitted,
    },
];

/// The sizes of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// With depth shading.
    pub depth: (u32, u32),
    /// With Whitted's model.
    pub whitted: (u32, u32),
}

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

/// The name of the standard formulations' row, if they are more than one formulation.
pub const STANDARD: &str = "default";

impl Subject {
    /// The form of rays for which the scene needs a formulation.
    fn form(&self) -> Form {
        match self.model {
            Model::Depth => Form::Eye,
            Model::Scene | Model::Whitted => Form::General,
        }
    }

    /// The formulations with which it is traced: each that has a kernel for its rays, by name, and
    /// the standard ones if secondary rays use another formulation than primary rays.
    fn formulations(&self) -> Vec<(&'static str, Formulations)> {
        let standard = Formulations::standard();
        let has_kernel =
            |formulation: &&SphereFormulation| self.form().kernel(formulation).is_some();
        let alone = SPHERES.iter().filter(has_kernel).map(|formulation| {
            let formulations = Formulations::of(formulation, standard.triangle);
            (formulation.name, formulations)
        });
        let mixed = self.form() == Form::General && standard.seen != standard.bounced;
        alone.chain(mixed.then_some((STANDARD, standard))).collect()
    }

    fn size(&self, sizes: &Sizes) -> (u32, u32) {
        match self.form() {
            Form::Eye => sizes.depth,
            Form::General => sizes.whitted,
        }
    }

    /// Whether it is traced by depth shading.
    pub(crate) fn is_by_depth(&self) -> bool {
        self.form() == Form::Eye
    }

    /// The scene itself.
    pub(crate) fn scene(&self) -> Result<scenes::Scene, scenes::Error> {
        scenes::parse(self.text.as_bytes(), self.name, &scenes::Limits::default())
    }

    pub(crate) fn render_options(&self) -> RenderOptions {
        RenderOptions { model: self.model, ..RenderOptions::default() }
    }

    fn reference(
        &self,
        scene: &scenes::Scene,
        size: (u32, u32),
    ) -> Result<Reference, oracle::Error> {
        match self.form() {
            Form::Eye => oracle::trace(scene, size.0, size.1),
            Form::General => {
                let options = whitted::Options::default();
                Ok(whitted::trace(scene, size.0, size.1, &options)?.0)
            }
        }
    }
}

/// Traces every scene with each of the chosen formulations.
///
/// # Errors
///
/// Fails if a scene or a size can't be traced, or if an SPU fails.
pub fn measure(
    chosen: impl Fn(&str) -> bool,
    sizes: &Sizes,
    mut progress: impl FnMut(&str),
) -> Result<Vec<PictureRow>, PictureError> {
    let mut rows = Vec::new();
    for subject in SCENES {
        let scene = subject.scene()?;
        let size = subject.size(sizes);
        let mut reference = None;
        for (name, formulations) in subject.formulations() {
            if !chosen(name) {
                continue;
            }
            progress(&format!("{} by {name}", subject.name));
            let program = program(formulations)?;
            let reference = match &mut reference {
                Some(reference) => reference,
                none => none.insert(subject.reference(&scene, size)?),
            };
            let options = subject.render_options();
            let traced = trace(subject.name, &scene, options, size, program)?;
            let compared = oracle::compare(&traced.picture, reference)?;
            rows.push(PictureRow {
                formulation: name.to_owned(),
                scene: subject.name.to_owned(),
                width: size.0,
                height: size.1,
                frames_per_second: traced.frames_per_second,
                rmse: rmse(&traced.picture, &reference.picture),
                max_error: compared.max_error,
                max_error_off_silhouette: compared.max_error_off_silhouette,
                wrong_pixels: compared.wrong_pixels,
                wrong_off_silhouette: compared.wrong_off_silhouette,
            });
        }
    }
    Ok(rows)
}

/// What the SPUs made of a scene.
pub(crate) struct Traced {
    /// The picture.
    pub picture: Picture,
    /// Frames a second in simulated time.
    pub frames_per_second: f64,
    /// The number of primary rays.
    pub primary_rays: u64,
}

/// Traces a scene twice. The first frame determines the costs of its parts, and only the second
/// one counts.
pub(crate) fn trace(
    name: &str,
    scene: &scenes::Scene,
    options: RenderOptions,
    (width, height): (u32, u32),
    program: Program,
) -> Result<Traced, PictureError> {
    let settings = Settings { retain: false, program, ..Settings::default() };
    let scene = Scene::new(scene, options, &program)?;
    let shown = Shown::default();
    let framebuffer =
        Kept { memory: Memory::new(Geometry::new(width, height)?)?, shown: Arc::clone(&shown) };
    let mut report = Report::new(name, (width, height), settings.spus);
    let mut engine = Engine::start(settings, Box::new(framebuffer))?;
    engine.render(&scene, &mut |_| ())?;
    let statistics = engine.render(&scene, &mut |_| ())?;
    let primary_rays = statistics.spus.iter().map(|spu| spu.rays.eye).sum();
    report.add(statistics);
    let mut picture = Picture::black(width, height)?;
    let shown = shown.lock().unwrap_or_else(PoisonError::into_inner);
    for (to, from) in picture.pixels_mut().iter_mut().zip(shown.pixels()) {
        *to = from.0;
    }
    Ok(Traced { picture, frames_per_second: report.frames_per_second, primary_rays })
}

/// The SPU program with these formulations: one of `cellray`'s own, or else one that is built now.
fn program(formulations: Formulations) -> Result<Program, PictureError> {
    match Program::of(&formulations) {
        Ok(program) => Ok(program),
        Err(_) => Ok(Program::from_image(&set::tracer(formulations)?)?),
    }
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

type Shown = Arc<Mutex<RgbImage>>;

/// A framebuffer whose last frame can be read from outside the engine.
struct Kept {
    memory: Memory,
    shown: Shown,
}

impl Framebuffer for Kept {
    fn geometry(&self) -> Geometry {
        self.memory.geometry()
    }

    fn target(&mut self) -> Target {
        self.memory.target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        *self.shown.lock().unwrap_or_else(PoisonError::into_inner) = self.memory.rgb();
        Ok(())
    }

    fn keeps_contents(&self) -> bool {
        self.memory.keeps_contents()
    }

    fn describe(&self) -> String {
        self.memory.describe()
    }
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
    fn default_formulation_matches_reference_in_all_scenes() {
        let sizes = Sizes { depth: (160, 90), whitted: (64, 36) };
        let standard = Formulations::standard();
        let default = |name: &str| name == standard.eye.name || name == STANDARD;
        let rows = measure(default, &sizes, |_| ()).unwrap();
        assert_eq!(rows.len(), SCENES.len());
        for row in &rows {
            let pixels = u64::from(row.width * row.height);
            assert!(row.wrong_pixels <= pixels / 50, "{row:?}");
            assert!(row.rmse < 8.0, "{row:?}");
        }
    }
}
