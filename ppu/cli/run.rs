//! The common part of `render` and `fb`: a scene, SPUs, a number of frames, statistics.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use cellray::choices::{Antialias, Colour, Model, Quality, Split};
use cellray::framebuffer::{Framebuffer, Geometry, Labels};
use cellray::scene::{self, CONTRAST, Look, RenderOptions, Samples, offset_note};
use cellray::spe::Program;
use cellray::work::Skip;
use cellray::{Engine, LoopTime, Report, Scene, Settings};
use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, ValueEnum as _};
use protocol::formulation::{self, Formulations, SPHERES, TRIANGLES};
use protocol::layout::{MESH_LEAST_SLOTS, MESH_MOST_SLOTS};

use super::camera::Camera;
use super::progress::Progress;
use super::{Outcome, whole};

/// Options for the scene, the SPUs and the statistics.
#[derive(Args)]
pub struct Options {
    /// Scene: an NFF file, a mesh (.obj, .ply or .glb), or a generated one: sphereflake:LEVEL,
    /// tetra:LEVEL, terrain:LEVEL, or gears, mount, rings, teapot, tree, lattice, jacks, shells or
    /// sombrero, with :SIZE if it is not to have SPD's
    pub scene: PathBuf,
    #[command(flatten)]
    camera: Camera,
    /// SPUs to use
    #[arg(
        long,
        default_value_t = 6,
        value_name = "N",
        allow_negative_numbers = true,
        value_parser = whole::<u32>(0..=u64::from(u32::MAX))
    )]
    pub spus: u32,
    /// How the picture is split among the SPUs
    #[arg(long, value_enum, default_value_t)]
    pub split: Split,
    /// Test every ray with every object, and trace every frame completely
    #[arg(long)]
    pub no_skip: bool,
    /// Model that the scene is rendered with
    #[arg(long, value_enum, default_value_t)]
    pub model: Model,
    /// Longest chain of reflected and refracted rays, including the primary ray, 1 to 16
    #[arg(long, default_value_t = 5, value_name = "N", allow_negative_numbers = true, value_parser = whole::<u32>(1..=16))]
    pub ray_depth: u32,
    /// Let glass reflect by Schlick's approximation, in addition to its Ks
    #[arg(long)]
    pub fresnel: bool,
    /// Trace the same rays as the Standard Procedural Databases count, even those that add nothing
    /// to the picture, such as reflected rays of glass with Ks 0
    #[arg(long)]
    pub spd_rays: bool,
    /// Trace no shadows
    #[arg(long)]
    pub no_shadows: bool,
    /// Trace this many samples of a pixel that differs from a neighbour [default: 4; 1 with
    /// --corners]
    #[arg(long, value_enum, value_name = "N")]
    pub antialias: Option<Antialias>,
    /// How much such a pixel differs in a channel at least, in 1/255; 0: antialias every pixel
    #[arg(
        long,
        default_value_t = CONTRAST,
        value_name = "N",
        allow_negative_numbers = true,
        value_parser = whole::<u8>(0..=255)
    )]
    pub contrast: u8,
    /// What the channels of the scene's colours and of pixels say about light [default: srgb;
    /// linear by depth shading, whose shades are distances, and with --corners]
    #[arg(long, value_enum)]
    pub colour: Option<Colour>,
    /// Limit light that is nearly white or brighter without a step
    #[arg(long)]
    pub roll_off: bool,
    /// Most blocks of a mesh that an SPU caches, for measurements
    #[arg(long, default_value_t = MESH_MOST_SLOTS, value_name = "N", hide = true, value_parser = whole::<u32>(u64::from(MESH_LEAST_SLOTS)..=u64::from(MESH_MOST_SLOTS)))]
    pub mesh_cache: u32,
    /// Trade run time for accuracy [default: default]
    #[arg(long, value_enum)]
    pub quality: Option<Quality>,
    /// Formulation for spheres, instead of the quality's; see docs/accuracy.md
    #[arg(long, value_name = "FORMULATION", value_parser = PossibleValuesParser::new(SPHERES.iter().map(|sphere| sphere.name)))]
    pub sphere: Option<String>,
    /// Formulation for triangles, instead of the quality's; see docs/accuracy.md
    #[arg(long, value_name = "FORMULATION", value_parser = PossibleValuesParser::new(TRIANGLES.iter().map(|triangle| triangle.name)))]
    pub triangle: Option<String>,
    /// SPU program to trace with, such as one with a game's own shaders [default: the built-in
    /// one]
    #[arg(long, value_name = "F.elf", conflicts_with_all = ["quality", "sphere", "triangle"])]
    pub program: Option<PathBuf>,
    /// Shader in SPU assembly to link into the SPU program; needs an SPU assembler
    #[arg(long = "shader", value_name = "F.s", conflicts_with_all = ["program", "quality", "sphere", "triangle"])]
    pub shaders: Vec<PathBuf>,
    /// Check at every call of a shader that it keeps the rules for shaders
    #[arg(long)]
    pub check_shaders: bool,
    /// Trace every frame completely, even tiles that have not changed
    #[arg(long)]
    pub retrace: bool,
    /// Print statistics: rays, tests, tiles, what each SPU did
    #[arg(long, short)]
    pub verbose: bool,
    /// Write statistics as JSON to a file, or to standard output with -
    #[arg(long, value_name = "S.json")]
    pub stats: Option<PathBuf>,
    /// Seconds after which SPUs count as lost if none takes work, finishes any or answers
    #[arg(long, default_value_t = 600, value_name = "S", allow_negative_numbers = true, value_parser = whole::<u64>(1..=86_400))]
    pub timeout: u64,
}

impl Options {
    /// The model and its settings. With `corners`, primary rays go through the corners of pixels.
    pub fn render_options(&self, scene: &scenes::Scene, corners: bool) -> RenderOptions {
        let options = RenderOptions {
            model: self.model.into(),
            ray_depth: self.ray_depth,
            fresnel: self.fresnel,
            spd_rays: self.spd_rays,
            shadows: !self.no_shadows,
            corners,
            mesh_cache: self.mesh_cache,
            ..RenderOptions::default()
        };
        // Corners are the databases' own antialiasing, whose mean is taken of bytes.
        let samples = self.antialias.map(Into::into);
        let colour = self.colour.map(Into::into);
        let look = Look {
            samples: samples.unwrap_or(if corners { Samples::One } else { Samples::Four }),
            contrast: self.contrast,
            colour: colour.or(corners.then_some(scene::Colour::Linear)),
            roll_off: self.roll_off,
        };
        look.of(options, scene.lights.len())
    }

    /// What a picture's file says of how it was made of a scene that had this view: the options of
    /// `cellray render` that determine it, including those that are not given.
    pub fn labels(&self, scene: &Scene, own_view: &scenes::View) -> Labels {
        let mut labels = Labels::default();
        labels.set("scene", self.scene.display());
        labels.set_view(scene.view(), own_view);
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
                scene::Colour::Linear => "linear",
                scene::Colour::Srgb => "srgb",
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
        if let Some(program) = &self.program {
            labels.set("program", program.display());
        } else if !self.shaders.is_empty() {
            let names = self.shaders.iter().map(|shader| shader.display().to_string());
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
        let files = [&self.scene].into_iter().chain(&self.program);
        files.chain(&self.shaders).cloned()
    }

    /// The engine's settings.
    pub fn settings(&self, program: Program) -> Settings {
        Settings {
            spus: self.spus,
            split: self.split.into(),
            skip: if self.no_skip { Skip::Nothing } else { Skip::Misses },
            retain: !self.retrace,
            check_shaders: self.check_shaders,
            timeout: Duration::from_secs(self.timeout),
            program,
        }
    }

    /// The SPU program, as the options select it.
    pub fn program(&self) -> Result<Program, Box<dyn std::error::Error>> {
        if let Some(file) = &self.program {
            return Ok(Program::from_file(file)?);
        }
        if !self.shaders.is_empty() {
            let image = spu_build::tracer_with(&self.shaders)?;
            return Ok(Program::from_image(&image)?);
        }
        let mut formulations =
            cellray::Quality::from(self.quality.unwrap_or_default()).formulations();
        if let Some(sphere) = self.sphere.as_deref().and_then(formulation::sphere) {
            formulations = Formulations::of(sphere, formulations.triangle);
        }
        if let Some(triangle) = self.triangle.as_deref().and_then(formulation::triangle) {
            formulations.triangle = triangle;
        }
        Ok(Program::of(&formulations)?)
    }
}

/// A scene, and the view that it has by itself.
pub struct Loaded {
    pub scene: scenes::Scene,
    pub own_view: scenes::View,
}

/// Loads the scene, and prints notes about what was left out of it.
pub fn load(options: &Options) -> Result<Loaded, meshes::Error> {
    let meshes::Loaded { mut scene, notes, .. } = meshes::load(&options.scene)?;
    for note in notes {
        talk::say!("cellray: note: {note}");
    }
    let own_view = scene.view.clone();
    options.camera.place(&mut scene.view);
    Ok(Loaded { scene, own_view })
}

/// Prepares a scene, and prints notes about objects that will not be drawn, or not as requested.
pub fn scene(
    options: &Options,
    source: &scenes::Scene,
    render_options: RenderOptions,
    program: &Program,
) -> Result<Scene, Box<dyn std::error::Error>> {
    let scene = Scene::new(source, render_options, program)?;
    if let Some(note) = offset_note(source, render_options) {
        talk::say!("cellray: note: {note}");
    }
    for what in scene.not_drawn() {
        talk::say!("cellray: note: {what}");
    }
    let replacing = [("sphere", &options.sphere), ("triangle", &options.triangle)];
    for (shape, formulation) in replacing {
        let quality = options.quality.and_then(|quality| quality.to_possible_value());
        if let (Some(quality), Some(formulation)) = (quality, formulation) {
            let quality = quality.get_name();
            talk::say!(
                "cellray: note: {shape}s are intersected by --{shape} {formulation}, and not as --quality \
                 {quality} would have it"
            );
        }
    }
    if let Some(requested) = &options.sphere {
        let used = scene.sphere_formulation(&program.formulations()?).name;
        if used != requested {
            talk::say!(
                "cellray: note: {requested} has no kernel for this scene's rays; {used} is used instead"
            );
        }
    }
    Ok(scene)
}

/// Traces frames until `enough` returns true for their number, then reports. `what` is what they
/// are shown on.
pub fn frames(
    options: &Options,
    program: Program,
    scene: &Scene,
    (framebuffer, what): (Box<dyn Framebuffer>, &str),
    mut enough: impl FnMut(usize) -> bool,
) -> Outcome {
    let Geometry { width, height } = framebuffer.geometry();
    let mut engine = Engine::start(options.settings(program), framebuffer)?;
    let formulations = program.formulations().ok();
    let mut report =
        Report::new(scene.file(), (width, height), options.spus).intersected(scene, formulations);
    let mut progress = Progress::start();
    while !enough(report.frames as usize) {
        let number = report.frames as usize + 1;
        let mut show = |part: f64| progress.show(number, part);
        let began = LoopTime::now();
        let statistics = engine.render(scene, &mut show)?;
        report.add(statistics);
        report.add_time_since(began);
    }
    progress.end();
    tell(options, what, report)
}

/// Prints a line on what was made, and the statistics if they are asked for, and writes them to the
/// file of `--stats`.
pub fn tell(options: &Options, what: &str, mut report: Report) -> Outcome {
    report.add_memory();
    talk::say!("cellray: {what}: {}", report.summary());
    if options.verbose {
        for line in report.to_string().lines().skip(1) {
            talk::say!("cellray: {line}");
        }
    }
    match &options.stats {
        Some(path) => write_stats(path, &report),
        None => Ok(()),
    }
}

fn write_stats(path: &Path, report: &Report) -> Outcome {
    let mut text = serde_json::to_string_pretty(report)?;
    text.push('\n');
    if path == Path::new("-") {
        return Ok(talk::print(text)?);
    }
    Ok(fs::write(path, text).map_err(|error| format!("statistics {}: {error}", path.display()))?)
}
