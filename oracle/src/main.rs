//! The command line of the reference: renders scenes and compares pictures with them.
//!
//! Data goes to stdout, talk to stderr.

use std::io::{self, Write};
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use nff::Scene;
use nff::depth::not_drawn;
use oracle::{Comparison, DIFFERENCE_SCALE, Picture};

const EXAMPLES: &str = "Examples:
  oracle render scenes/paper16.nff --size 1280x720 --out paper16.png
  oracle render sphereflake:2 --out flake.png
  oracle compare frame.png scenes/paper16.nff
  oracle compare frame.png sphereflake:2 --json --diff difference.png

SCENE is an NFF file, or sphereflake:LEVEL for a generated one (level 2 has 91 spheres).";

/// Renders scenes in double precision and measures how far pictures are from that.
#[derive(Parser)]
#[command(version, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    /// Compares a picture of a scene with the reference.
    ///
    /// A pixel is wrong if a channel is off by more than 1/255. It is on a silhouette if a
    /// neighbour shows another sphere or its ray passes a sphere's edge within 1e-5 of the radius.
    #[command(after_help = EXAMPLES)]
    Compare {
        /// The picture, a PNG; the reference is rendered at its size
        picture: PathBuf,
        /// The scene it shows
        scene: PathBuf,
        /// Prints the errors as JSON
        #[arg(long)]
        json: bool,
        #[arg(long, value_name = "PNG", help = difference_help())]
        diff: Option<PathBuf>,
    },
    /// Renders a scene.
    #[command(after_help = EXAMPLES)]
    Render {
        /// The scene
        scene: PathBuf,
        /// Size of the picture in pixels; the scene's own if not given
        #[arg(long, value_name = "WxH", value_parser = size)]
        size: Option<(u32, u32)>,
        /// Where to write the picture
        #[arg(long, value_name = "PNG")]
        out: PathBuf,
    },
}

fn main() -> ExitCode {
    let done = match Cli::parse().verb {
        Verb::Compare {
            picture,
            scene,
            json,
            diff,
        } => compare(&picture, &scene, json, diff.as_deref()),
        Verb::Render { scene, size, out } => render(&scene, size, &out),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("oracle: {error}");
            ExitCode::FAILURE
        }
    }
}

type Done = Result<(), Box<dyn std::error::Error>>;

fn compare(picture: &Path, scene: &Path, json: bool, diff: Option<&Path>) -> Done {
    let picture = Picture::read_png(picture)?;
    let scene = load(scene)?;
    let reference = oracle::trace(&scene, picture.width(), picture.height())?;
    let result = oracle::compare(&picture, &reference)?;
    if let Some(diff) = diff {
        oracle::difference(&picture, &reference.picture)?.write_png(diff)?;
        eprintln!(
            "{}: the difference, {DIFFERENCE_SCALE} times amplified",
            diff.display()
        );
    }
    let mut text = if json {
        serde_json::to_string(&result)?
    } else {
        report(&result, &picture)
    };
    text.push('\n');
    io::stdout().write_all(text.as_bytes())?;
    Ok(())
}

fn report(result: &Comparison, picture: &Picture) -> String {
    let Comparison {
        wrong_pixels,
        wrong_off_silhouette,
        max_error,
        mean_error,
        ..
    } = result;
    let (pixels, percent) = (picture.pixels().len(), result.wrong_fraction * 100.0);
    let off_silhouette = result.max_error_off_silhouette;
    format!(
        "wrong pixels   {wrong_pixels} of {pixels} ({percent:.4} %), {wrong_off_silhouette} off silhouettes\n\
         largest error  {max_error}/255, {off_silhouette}/255 off silhouettes\n\
         mean error     {mean_error:.4}/255"
    )
}

fn render(scene: &Path, size: Option<(u32, u32)>, out: &Path) -> Done {
    let scene = load(scene)?;
    let (width, height) = size.unwrap_or(scene.view.resolution);
    let reference = oracle::trace(&scene, width, height)?;
    reference.picture.write_png(out)?;
    let covered = reference.covered * 100.0;
    eprintln!(
        "{}: {width}x{height}, spheres cover {covered:.1} %",
        out.display()
    );
    Ok(())
}

/// Loads a scene and tells what of it is not drawn.
fn load(scene: &Path) -> Result<Scene, nff::Error> {
    let scene = nff::load(scene)?;
    for left_out in not_drawn(&scene) {
        eprintln!("{left_out}");
    }
    Ok(scene)
}

/// What `--diff` does.
fn difference_help() -> String {
    format!("Writes the absolute difference, {DIFFERENCE_SCALE} times amplified")
}

/// A size such as 1280x720.
fn size(text: &str) -> Result<(u32, u32), String> {
    let side = |side: &str| side.parse::<NonZero<u32>>().ok().map(NonZero::get);
    text.split_once('x')
        .and_then(|(width, height)| Some((side(width)?, side(height)?)))
        .ok_or_else(|| "a size is written as WIDTHxHEIGHT, such as 1280x720".to_owned())
}
