//! The options that `render` and `fb` share, and what the library gets for them.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, ValueEnum as _};
use protocol::formulation::{self, Formulations, SPHERES, TRIANGLES};
use protocol::layout::{MESH_MAX_SLOTS, MESH_MIN_SLOTS};

use super::camera::Camera;
use crate::choices::{LookChoices, ProgramChoices, SceneChoices, whole};
use crate::framebuffer::Labels;
use crate::scene::{Colour, RenderOptions, Samples};
use crate::spe::Program;
use crate::work::{Skip, Split};
use crate::{Quality, Scene, Settings};

/// Options for the scene, the SPUs and the statistics.
#[derive(Args)]
pub struct Options {
    #[command(flatten)]
    pub scene: SceneChoices,
    #[command(flatten)]
    pub camera: Camera,
    #[command(flatten)]
    look: LookChoices,
    /// Trade run time for accuracy
    #[arg(long, help_heading = "Quality", value_enum, conflicts_with_all = ["program", "shaders"])]
    pub quality: Option<Quality>,
    /// Formulation of the ray-sphere test, instead of the quality's; see docs/accuracy.md
    #[arg(long, help_heading = "Quality", hide_short_help = true, value_name = "FORMULATION", conflicts_with_all = ["program", "shaders"], value_parser = PossibleValuesParser::new(SPHERES.iter().map(|sphere| sphere.name)))]
    pub sphere: Option<String>,
    /// Formulation of the ray-triangle test, instead of the quality's; see docs/accuracy.md
    #[arg(long, help_heading = "Quality", hide_short_help = true, value_name = "FORMULATION", conflicts_with_all = ["program", "shaders"], value_parser = PossibleValuesParser::new(TRIANGLES.iter().map(|triangle| triangle.name)))]
    pub triangle: Option<String>,
    /// Trace all rays that the Standard Procedural Databases count
    ///
    /// Even those that add nothing to the picture, such as reflected rays of glass with Ks 0.
    #[arg(long, help_heading = "Quality", hide_short_help = true)]
    pub spd_rays: bool,
    /// Number of SPUs
    #[arg(
        long,
        help_heading = "SPUs",
        default_value_t = 6,
        value_name = "N",
        allow_negative_numbers = true,
        value_parser = whole::<u32>(0..=u64::from(u32::MAX))
    )]
    pub spus: u32,
    /// Distribution of the picture among the SPUs
    #[arg(long, help_heading = "SPUs", hide_short_help = true, value_enum, default_value_t)]
    pub split: Split,
    /// Disable culling: test every ray with every object, and trace every frame completely
    #[arg(long, help_heading = "SPUs", hide_short_help = true)]
    pub no_skip: bool,
    /// Trace every frame completely, even tiles that have not changed
    #[arg(long, help_heading = "SPUs", hide_short_help = true)]
    pub retrace: bool,
    /// Maximum number of a mesh's blocks that an SPU caches, for measurements
    #[arg(
        long,
        default_value_t = MESH_MAX_SLOTS,
        value_name = "N",
        hide = true,
        value_parser = whole::<u32>(u64::from(MESH_MIN_SLOTS)..=u64::from(MESH_MAX_SLOTS))
    )]
    pub mesh_cache: u32,
    #[command(flatten)]
    program: ProgramChoices,
    /// Print statistics: rays, tests, tiles, time of each SPU
    #[arg(long, short, help_heading = "Output")]
    pub verbose: bool,
    /// JSON file of statistics to write, or - for standard output
    #[arg(long, help_heading = "Output", value_name = "S.json")]
    pub stats: Option<PathBuf>,
}

impl Options {
    /// The model and its settings. With `corners`, primary rays go through the corners of pixels.
    pub fn render_options(&self, scene: &scenes::Scene, corners: bool) -> RenderOptions {
        let options = RenderOptions {
            spd_rays: self.spd_rays,
            corners,
            mesh_cache: self.mesh_cache,
            ..self.scene.render_options()
        };
        // Corners are the databases' own antialiasing, whose mean is taken of bytes.
        let look = match corners {
            true => self.look.look(Samples::One, Some(Colour::Linear)),
            false => self.look.look(Samples::Four, None),
        };
        look.of(options, scene.lights.len())
    }

    /// The settings that a picture's file carries: the options of `cellray render` that determine
    /// the picture, including those that are not given. `own_view` is the scene's own view.
    pub fn labels(&self, scene: &Scene, own_view: &scenes::View) -> Labels {
        let mut labels = Labels::default();
        labels.set("scene", self.scene.scene.display());
        labels.set_view(scene.view(), own_view);
        if let Some(animation) = &self.scene.animation {
            labels.set("animation", animation);
        }
        let is_whitted = scene.block().is_some();
        labels.set("model", if is_whitted { "whitted" } else { "depth" });
        let RenderOptions {
            ray_depth,
            fresnel,
            spd_rays,
            shadows,
            samples,
            contrast,
            colour,
            roll_off,
            corners,
            ..
        } = scene.render_options();
        labels.set("antialias", samples as u32);
        if samples != Samples::One {
            labels.set("contrast", contrast);
        }
        labels.set(
            "colour",
            match colour {
                Colour::Linear => "linear",
                Colour::Srgb => "srgb",
            },
        );
        if is_whitted {
            labels.set("ray-depth", ray_depth);
        }
        for (option, is_on) in [
            ("fresnel", is_whitted && fresnel),
            ("spd-rays", is_whitted && spd_rays),
            ("no-shadows", is_whitted && !shadows),
            ("roll-off", roll_off),
            ("corners", corners),
        ] {
            if is_on {
                labels.set(option, true);
            }
        }
        if let Some(program) = &self.program.program {
            labels.set("program", program.display());
        } else if !self.program.shaders.is_empty() {
            let names = self.program.shaders.iter().map(|shader| shader.display().to_string());
            labels.set("shader", names.collect::<Vec<_>>().join(" "));
        } else {
            let quality = self.quality.unwrap_or_default().to_possible_value();
            labels.set("quality", quality.as_ref().map_or("", PossibleValue::get_name));
            for (option, formulation) in [("sphere", &self.sphere), ("triangle", &self.triangle)] {
                if let Some(formulation) = formulation {
                    labels.set(option, formulation);
                }
            }
        }
        labels
    }

    /// The files that a picture is made of.
    pub fn files(&self) -> impl Iterator<Item = PathBuf> {
        std::iter::once(self.scene.scene.clone()).chain(self.program.files())
    }

    /// The engine's settings.
    pub fn settings(&self, program: Program) -> Settings {
        Settings {
            spus: self.spus,
            split: self.split,
            skip: if self.no_skip { Skip::Nothing } else { Skip::Misses },
            retain: !self.retrace,
            check_shaders: self.program.check_shaders,
            timeout: self.program.timeout(),
            program,
        }
    }

    /// The SPU program, as the options select it.
    pub fn program(&self) -> Result<Program, Box<dyn std::error::Error>> {
        if let Some(program) = self.program.program()? {
            return Ok(program);
        }
        let mut formulations = self.quality.unwrap_or_default().formulations();
        if let Some(sphere) = self.sphere.as_deref().and_then(formulation::sphere) {
            formulations = Formulations::of(sphere, formulations.triangle);
        }
        if let Some(triangle) = self.triangle.as_deref().and_then(formulation::triangle) {
            formulations.triangle = triangle;
        }
        Ok(Program::of(&formulations)?)
    }
}
