//! What `render` and `fb` have in common: a scene, SPUs, a number of frames, statistics.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::Duration;

use cellray::framebuffer::{Framebuffer, Geometry};
use cellray::scene::RenderOptions;
use cellray::spe::Program;
use cellray::work::Skip;
use cellray::{Engine, LoopTime, Report, Scene, Settings};
use clap::Args;
use clap::builder::PossibleValuesParser;
use protocol::formulation::{self, Formulations, SPHERES, TRIANGLES};

use super::Outcome;
use super::choices::{Model, Quality, Split};
use super::progress::Progress;

/// Options of the SPUs and their report.
#[derive(Args)]
pub struct Options {
    /// Scene: an NFF file, or sphereflake:LEVEL, or tetra:LEVEL
    pub scene: PathBuf,
    /// SPUs to use
    #[arg(
        long,
        default_value_t = 6,
        value_name = "N",
        allow_negative_numbers = true
    )]
    pub spus: u32,
    /// How the picture is split among the SPUs
    #[arg(long, value_enum, default_value_t)]
    pub split: Split,
    /// Test every ray with every object, and trace every frame as a whole
    #[arg(long)]
    pub no_skip: bool,
    /// How the scene looks: by Whitted's model it has lights, shadows, mirrors, glass and all
    /// shapes
    #[arg(long, value_enum, default_value_t)]
    pub model: Model,
    /// Most rays in a chain of mirrors and glass, the eye's counted, 1 to 16
    #[arg(long, default_value_t = 5, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=16))]
    pub ray_depth: u32,
    /// Glass reflects as Schlick's approximation has it, beyond its Ks
    #[arg(long)]
    pub fresnel: bool,
    /// Send rays that add nothing to the picture where the Standard Procedural Databases count
    /// them, as glass of Ks 0 reflects nothing
    #[arg(long)]
    pub spd_rays: bool,
    /// Objects throw no shadows
    #[arg(long)]
    pub no_shadows: bool,
    /// How much run time is given for how little error
    #[arg(long, value_enum, default_value_t)]
    pub quality: Quality,
    /// How rays are intersected with spheres, instead of as the quality has it; docs/accuracy.md
    #[arg(long, value_name = "FORMULATION", value_parser = PossibleValuesParser::new(SPHERES.iter().map(|sphere| sphere.name)))]
    pub sphere: Option<String>,
    /// How rays are intersected with triangles, likewise
    #[arg(long, value_name = "FORMULATION", value_parser = PossibleValuesParser::new(TRIANGLES.iter().map(|triangle| triangle.name)))]
    pub triangle: Option<String>,
    /// SPU program to trace with, such as a game's that has shaders of its own [default: the
    /// built-in one]
    #[arg(long, value_name = "F.elf", conflicts_with_all = ["quality", "sphere", "triangle"])]
    pub program: Option<PathBuf>,
    /// Shader in SPU assembly to link into the SPU program; needs an SPU assembler
    #[arg(long = "shader", value_name = "F.s", conflicts_with_all = ["program", "quality", "sphere", "triangle"])]
    pub shaders: Vec<PathBuf>,
    /// Check at every call of a shader that it keeps to the rules
    #[arg(long)]
    pub check_shaders: bool,
    /// Trace every frame as a whole, even where it already shows
    #[arg(long)]
    pub retrace: bool,
    /// Write statistics as JSON to a file, or - for standard output
    #[arg(long, value_name = "S.json")]
    pub stats: Option<PathBuf>,
    /// Seconds in which no SPU takes work, finishes any or answers, before all count as lost
    #[arg(long, default_value_t = 600, value_name = "S", allow_negative_numbers = true, value_parser = clap::value_parser!(u64).range(1..=86_400))]
    pub timeout: u64,
}

impl Options {
    /// How the scene is to look.
    pub fn render_options(&self) -> RenderOptions {
        RenderOptions {
            model: self.model.into(),
            ray_depth: self.ray_depth,
            fresnel: self.fresnel,
            spd_rays: self.spd_rays,
            shadows: !self.no_shadows,
            corners: false,
        }
    }

    /// The files that a picture is made of.
    pub fn files(&self) -> impl Iterator<Item = PathBuf> {
        let files = [&self.scene].into_iter().chain(&self.program);
        files.chain(&self.shaders).cloned()
    }

    /// How the engine is to work.
    pub fn settings(&self, program: Program) -> Settings {
        Settings {
            spus: self.spus,
            split: self.split.into(),
            skip: if self.no_skip {
                Skip::Nothing
            } else {
                Skip::Misses
            },
            retain: !self.retrace,
            check_shaders: self.check_shaders,
            timeout: Duration::from_secs(self.timeout),
            program,
        }
    }

    /// What the SPUs are to run.
    pub fn program(&self) -> Result<Program, Box<dyn std::error::Error>> {
        if let Some(file) = &self.program {
            return Ok(Program::from_file(file)?);
        }
        if !self.shaders.is_empty() {
            let image = spu_build::tracer_with(&self.shaders)?;
            return Ok(Program::from_image(&image)?);
        }
        let mut formulations = cellray::Quality::from(self.quality).formulations();
        if let Some(sphere) = self.sphere.as_deref().and_then(formulation::sphere) {
            formulations = Formulations::of(sphere, formulations.triangle);
        }
        if let Some(triangle) = self.triangle.as_deref().and_then(formulation::triangle) {
            formulations.triangle = triangle;
        }
        Ok(Program::of(&formulations)?)
    }
}

/// Makes a scene ready, and says what of it will not be drawn, or not as asked for.
pub fn scene(
    options: &Options,
    scene: &nff::Scene,
    render_options: RenderOptions,
    program: &Program,
) -> Result<Scene, Box<dyn std::error::Error>> {
    let scene = Scene::new(scene, render_options, program)?;
    for what in scene.not_drawn() {
        eprintln!("cellray: note: {what}");
    }
    if let Some(asked) = &options.sphere {
        let used = scene.sphere_formulation(&program.formulations()?).name;
        if used != asked {
            eprintln!("cellray: note: {asked} has no kernel for this scene's rays; {used} is used");
        }
    }
    Ok(scene)
}

/// Traces frames until `enough` says so, then reports.
pub fn frames(
    options: &Options,
    program: Program,
    scene: &Scene,
    framebuffer: Box<dyn Framebuffer>,
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
    tell(options, report)
}

/// Says what frames have taken, and writes it where it is wanted.
pub fn tell(options: &Options, mut report: Report) -> Outcome {
    report.add_memory();
    for line in report.to_string().lines() {
        eprintln!("cellray: {line}");
    }
    match &options.stats {
        Some(path) => write_stats(path, &report),
        None => Ok(()),
    }
}

fn write_stats(path: &Path, report: &Report) -> Outcome {
    let mut text = serde_json::to_string_pretty(report)?;
    text.push('\n');
    let result = if path == Path::new("-") {
        std::io::stdout().write_all(text.as_bytes())
    } else {
        fs::write(path, text)
    };
    Ok(result.map_err(|error| format!("statistics {}: {error}", path.display()))?)
}
