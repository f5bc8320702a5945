//! What `render` and `fb` have in common: a scene, SPUs, a number of frames, statistics.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use cellray::framebuffer::{Framebuffer, Geometry};
use cellray::statistics::{FrameStatistics, Report};
use cellray::work::Split;
use cellray::{Engine, Scene, Settings};
use clap::Args;

use super::Outcome;
use super::progress::Progress;

/// Options of the SPUs and their report.
#[derive(Args)]
pub struct Options {
    /// Scene: an NFF file, or sphereflake:LEVEL
    pub scene: PathBuf,
    /// SPUs to use
    #[arg(long, default_value_t = 6, value_name = "N")]
    pub spus: u32,
    /// How the picture is split among the SPUs
    #[arg(long, value_enum, default_value_t)]
    pub split: Split,
    /// Write statistics as JSON to a file, or - for standard output
    #[arg(long, value_name = "S.json")]
    pub stats: Option<PathBuf>,
    /// Seconds that a frame may take before its SPUs count as lost
    #[arg(long, default_value_t = 600, value_name = "S")]
    pub timeout: u64,
}

/// Reads a scene and says what of it will not be drawn.
pub fn scene(path: &Path) -> Result<Scene, Box<dyn std::error::Error>> {
    let scene = Scene::from_nff(&nff::load(path)?)?;
    for what in scene.not_drawn() {
        eprintln!("cellray: note: {what}");
    }
    Ok(scene)
}

/// Traces frames until `enough` says so, then reports.
pub fn frames(
    options: &Options,
    scene: &Scene,
    framebuffer: Box<dyn Framebuffer>,
    mut enough: impl FnMut(usize) -> bool,
) -> Outcome {
    let Geometry { width, height } = framebuffer.geometry();
    let settings = Settings {
        spus: options.spus,
        split: options.split,
        timeout: Duration::from_secs(options.timeout),
        ..Settings::default()
    };
    let mut engine = Engine::start(settings, framebuffer)?;
    let mut frames: Vec<FrameStatistics> = Vec::new();
    let mut progress = Progress::start();
    let start = Instant::now();
    while !enough(frames.len()) {
        let number = frames.len() + 1;
        let mut show = |part: f64| progress.show(number, part);
        frames.push(engine.render(scene, &mut show)?);
    }
    progress.end();
    let report = Report::new(
        scene.file(),
        (width, height),
        &frames,
        start.elapsed().as_secs_f64(),
    );
    eprintln!(
        "cellray: {}x{}, {} frame(s) on {} SPUs in {:.2} s; by the SPUs' clock {:.2} frames/s",
        width, height, report.frames, report.spus, report.host_seconds, report.frames_per_second
    );
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
