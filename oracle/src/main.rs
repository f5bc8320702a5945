//! The command line of the reference: renders scenes and compares pictures with them.
//!
//! Data goes to stdout, talk to stderr.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use nff::depth::not_drawn;
use nff::{Scene, ViewError, check_size};
use oracle::whitted::{self, Counts};
use oracle::{Comparison, DIFFERENCE_SCALE, Picture, Reference};

const EXAMPLES: &str = "Examples:
  oracle render scenes/paper16.nff --size 1280x720 --out paper16.png
  oracle render sphereflake:2 --out flake.png
  oracle compare frame.png scenes/paper16.nff
  oracle compare frame.png sphereflake:2 --json --diff difference.png
  oracle render scenes/whitted16.nff --model whitted --out whitted16.png
  oracle render sphereflake:4 --model whitted --corners --stats --out balls.png

SCENE is an NFF file, or sphereflake:LEVEL or tetra:LEVEL for a generated one (sphereflake:2 has 91
spheres, tetra:3 has 256 polygons).";

/// Renders scenes in double precision and measures how far pictures are from that.
#[derive(Parser)]
#[command(name = "oracle", version, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    /// Compares a picture of a scene with the reference.
    ///
    /// A pixel is wrong if a channel is off by more than 1/255. It is on a silhouette if a
    /// neighbour shows another sphere or its ray passes a sphere's edge within 1e-5 of the radius;
    /// with --model whitted if a neighbour's rays meet other objects or see other lights.
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
        #[command(flatten)]
        model: Model,
    },
    /// Renders a scene.
    #[command(after_help = EXAMPLES)]
    Render {
        /// The scene
        scene: PathBuf,
        /// Size of the picture in pixels; the scene's own if not given
        #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = size)]
        size: Option<(u32, u32)>,
        /// Where to write the picture
        #[arg(long, value_name = "PNG")]
        out: PathBuf,
        /// Prints how many rays there were as JSON (whitted)
        #[arg(long)]
        stats: bool,
        #[command(flatten)]
        model: Model,
    },
    /// Write man pages and shell completions.
    #[command(hide = true)]
    Pages(pages::Arguments),
}

/// How a scene is to look.
#[derive(Args)]
struct Model {
    /// What gives the pixels their colours
    #[arg(long = "model", value_enum, default_value_t = Name::Depth)]
    name: Name,
    /// Most rays in a chain, the primary ray counted; 5 if not given (whitted)
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = ray_depth())]
    ray_depth: Option<u32>,
    /// Lets glass reflect more the flatter it is looked at, by Schlick (whitted)
    #[arg(long)]
    fresnel: bool,
    /// Sends rays that add nothing to the picture where SPD counts them (whitted)
    #[arg(long)]
    spd_rays: bool,
    /// Sends primary rays through the corners of pixels and averages four, as SPD asks for
    /// (whitted)
    #[arg(long)]
    corners: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Name {
    /// The nearer, the brighter: the paper's; spheres only
    Depth,
    /// Lights, shadows, mirrors and glass, all shapes
    Whitted,
}

impl Model {
    /// Refuses what depth shading has no use for; `stats` is the option that is not the model's
    /// own.
    fn check(&self, stats: bool) {
        let given = [
            (self.ray_depth.is_some(), "--ray-depth"),
            (self.fresnel, "--fresnel"),
            (self.spd_rays, "--spd-rays"),
            (self.corners, "--corners"),
            (stats, "--stats"),
        ];
        let stray = given.into_iter().find(|&(given, _)| given);
        if let (Name::Depth, Some((_, option))) = (self.name, stray) {
            let message = format!("{option} needs --model whitted");
            Cli::command()
                .error(ErrorKind::ArgumentConflict, message)
                .exit();
        }
    }

    /// Renders a scene, and tells what of it the model leaves out.
    fn trace(&self, scene: &Scene, (width, height): (u32, u32)) -> Result<Traced, oracle::Error> {
        match self.name {
            Name::Depth => {
                for left_out in not_drawn(scene) {
                    eprintln!("{left_out}");
                }
                let reference = oracle::trace(scene, width, height)?;
                Ok(Traced {
                    reference,
                    counts: None,
                })
            }
            Name::Whitted => {
                let options = whitted::Options {
                    depth: self.ray_depth.unwrap_or(whitted::Options::default().depth),
                    fresnel: self.fresnel,
                    spd_rays: self.spd_rays,
                    corners: self.corners,
                };
                let (reference, counts) = whitted::trace(scene, width, height, &options)?;
                Ok(Traced {
                    reference,
                    counts: Some(counts),
                })
            }
        }
    }
}

/// A scene as rendered.
struct Traced {
    reference: Reference,
    /// The rays, where the model counts them.
    counts: Option<Counts>,
}

fn main() -> ExitCode {
    let done = match Cli::parse().verb {
        Verb::Compare {
            picture,
            scene,
            json,
            diff,
            model,
        } => {
            model.check(false);
            compare(&picture, &scene, &model, json, diff.as_deref())
        }
        Verb::Render {
            scene,
            size,
            out,
            stats,
            model,
        } => {
            model.check(stats);
            render(&scene, &model, size, &out, stats)
        }
        Verb::Pages(arguments) => pages::write(Cli::command(), &arguments).map_err(Into::into),
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

fn compare(picture: &Path, scene: &Path, model: &Model, json: bool, diff: Option<&Path>) -> Done {
    let picture = Picture::read_png(picture)?;
    let scene = nff::load(scene)?;
    let size = (picture.width(), picture.height());
    let reference = model.trace(&scene, size)?.reference;
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

fn render(scene: &Path, model: &Model, size: Option<(u32, u32)>, out: &Path, stats: bool) -> Done {
    let scene = nff::load(scene)?;
    let (width, height) = size.unwrap_or(scene.view.resolution);
    let Traced { reference, counts } = model.trace(&scene, (width, height))?;
    reference.picture.write_png(out)?;
    let covered = reference.covered * 100.0;
    let what = match model.name {
        Name::Depth => "spheres",
        Name::Whitted => "objects",
    };
    eprintln!(
        "{}: {width}x{height}, {what} cover {covered:.1} %",
        out.display()
    );
    if let Some(counts) = counts.filter(|_| stats) {
        let mut text = serde_json::to_string(&counts)?;
        text.push('\n');
        io::stdout().write_all(text.as_bytes())?;
    }
    Ok(())
}

/// What `--diff` does.
fn difference_help() -> String {
    format!("Writes the absolute difference, {DIFFERENCE_SCALE} times amplified")
}

/// The ray depths there are.
fn ray_depth() -> clap::builder::RangedI64ValueParser<u32> {
    clap::value_parser!(u32).range(1..=i64::from(whitted::MAX_DEPTH))
}

/// A size such as 1280x720.
fn size(text: &str) -> Result<(u32, u32), String> {
    let is_number =
        |side: &&str| !side.is_empty() && side.bytes().all(|byte| byte.is_ascii_digit());
    let (width, height) = text
        .split_once('x')
        .filter(|(width, height)| is_number(width) && is_number(height))
        .ok_or("a size is written as WIDTHxHEIGHT, such as 1280x720")?;
    let too_large = |_| ViewError::Size(text.to_owned()).to_string();
    let size = (
        width.parse().map_err(too_large)?,
        height.parse().map_err(too_large)?,
    );
    check_size(size.0, size.1).map_err(|error| error.to_string())?;
    Ok(size)
}
