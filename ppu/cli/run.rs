//! The steps of `render` and `fb`: prepare a scene, trace its frames, and report the run.

use std::fs;
use std::path::Path;

use clap::ValueEnum as _;

use super::Outcome;
use super::options::Options;
use super::progress::Progress;
use crate::choices::SceneChoices;
use crate::framebuffer::{Framebuffer, Geometry, Labels};
use crate::scene::offset_note;
use crate::spe::Program;
use crate::{Engine, LoopTime, Report, Scene};

type Failure = Box<dyn std::error::Error>;

/// A scene that is ready to be traced.
pub struct Prepared {
    pub program: Program,
    /// The description that the scene was built from.
    pub source: scenes::Scene,
    pub scene: Scene,
    /// The animation of the scene's mesh.
    pub animation: Option<meshes::Animation>,
    /// The view that the scene has by itself.
    pub own_view: scenes::View,
    /// The settings that a picture's file carries.
    pub labels: Labels,
}

impl Prepared {
    /// Another scene, prepared with the same options.
    pub fn of_same_options(&self, options: &Options, path: &Path) -> Result<Scene, Failure> {
        let mut source = meshes::load(path)?.scene;
        options.camera.place(&mut source.view);
        Ok(Scene::new(&source, options.render_options(&source, false), &self.program)?)
    }
}

/// Loads a scene, prepares it for the SPU program that the options select, and prints notes about
/// shapes that will not be drawn, or not as requested. With `corners`, primary rays go through the
/// corners of pixels.
pub fn prepare(options: &Options, corners: bool) -> Result<Prepared, Failure> {
    let program = options.program()?;
    let SceneChoices { scene, animation, .. } = &options.scene;
    let loaded = meshes::load_animated(scene, animation.as_deref())?;
    let meshes::Loaded { scene: mut source, animation, notes, .. } = loaded;
    for note in notes {
        messages::print!("cellray: note: {note}");
    }
    let own_view = source.view.clone();
    options.camera.place(&mut source.view);
    let render_options = options.render_options(&source, corners);
    let scene = Scene::new(&source, render_options, &program)?;
    if let Some(note) = offset_note(&source, render_options) {
        messages::print!("cellray: note: {note}");
    }
    for what in scene.not_drawn() {
        messages::print!("cellray: note: {what}");
    }
    note_formulations(options, &scene, &program)?;
    let labels = options.labels(&scene, &own_view);
    Ok(Prepared { program, source, scene, animation, own_view, labels })
}

/// Prints notes about formulations that replace others, or that have no kernel for this scene.
fn note_formulations(options: &Options, scene: &Scene, program: &Program) -> Outcome {
    let replacing = [("sphere", &options.sphere), ("triangle", &options.triangle)];
    for (shape, formulation) in replacing {
        let quality = options.quality.and_then(|quality| quality.to_possible_value());
        if let (Some(quality), Some(formulation)) = (quality, formulation) {
            let quality = quality.get_name();
            messages::print!(
                "cellray: note: {shape}s are intersected by --{shape} {formulation}, which replaces the formulation \
                 of --quality {quality}"
            );
        }
    }
    if let Some(requested) = &options.sphere {
        let used = scene.sphere_formulation(&program.formulations()?).name;
        if used != requested {
            messages::print!(
                "cellray: note: {requested} has no kernel for this scene's rays; {used} is used instead"
            );
        }
    }
    Ok(())
}

/// Traces frames until `enough` returns true for their number, then reports. `what` names
/// their destination.
pub fn frames(
    options: &Options,
    prepared: &Prepared,
    (framebuffer, what): (Box<dyn Framebuffer>, &str),
    enough: impl FnMut(usize) -> bool,
) -> Outcome {
    let (_, report) = traced(options, prepared, framebuffer, &[], enough)?;
    report_run(options, what, report)
}

/// Traces frames until `enough` returns true for their number. The engine still has the last one.
/// Frames of the scenes `before` precede them, and are not reported.
pub fn traced(
    options: &Options,
    Prepared { program, scene, .. }: &Prepared,
    framebuffer: Box<dyn Framebuffer>,
    before: &[&Scene],
    mut enough: impl FnMut(usize) -> bool,
) -> Result<(Engine, Report), Failure> {
    let Geometry { width, height } = framebuffer.geometry();
    let mut engine = Engine::start(options.settings(*program), framebuffer)?;
    let formulations = program.formulations().ok();
    let mut report =
        Report::new(scene.file(), (width, height), options.spus).intersected(scene, formulations);
    for scene in before {
        engine.render(scene, &mut |_| ())?;
    }
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
    Ok((engine, report))
}

/// Prints a line on the run, and the statistics if they are requested, and writes them to the
/// file of `--stats`.
pub fn report_run(options: &Options, what: &str, mut report: Report) -> Outcome {
    report.add_memory();
    messages::print!("cellray: {what}: {}", report.summary());
    if options.verbose {
        for line in report.to_string().lines().skip(1) {
            messages::print!("cellray: {line}");
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
        return Ok(messages::write_data(text)?);
    }
    Ok(fs::write(path, text).map_err(|error| format!("statistics {}: {error}", path.display()))?)
}
