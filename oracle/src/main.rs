//! The command line of the reference: renders scenes and compares pictures with them.
//!
//! Data goes to standard output, messages go to standard error.

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
  oracle render gears --model whitted --corners --spd-rays --stats --out gears.png

SCENE is an NFF file, a mesh (.obj, .ply, .glb), or sphereflake:LEVEL, tetra:LEVEL or terrain:LEVEL
for a generated one (sphereflake:2 has 91 spheres, tetra:3 has 256 polygons), or gears, mount, rings,
teapot, tree, lattice, jacks, shells or sombrero, with :SIZE if it is not to have SPD's (gears:2).";

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
    /// neighbour shows another sphere, or if its ray passes a sphere's edge within 1e-5 of the
    /// radius; with --model whitted, if a neighbour's rays hit other objects or see other lights.
    #[command(after_help = EXAMPLES)]
    Compare {
        /// PNG picture to compare; the reference is rendered at its size
        picture: PathBuf,
        /// Scene of the picture
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
        /// Size of the picture in pixels [default: the scene's own]
        #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = size)]
        size: Option<(u32, u32)>,
        /// File to write the picture to, or - for standard output
        #[arg(long, value_name = "PNG")]
        out: PathBuf,
        /// Prints the numbers of rays as JSON (whitted)
        #[arg(long)]
        stats: bool,
        #[command(flatten)]
        model: Model,
    },
    /// Write man pages and shell completions.
    #[command(hide = true)]
    Pages(pages::Arguments),
}

/// The options of the model.
#[derive(Args)]
struct Model {
    /// Model to render with
    #[arg(long = "model", value_enum, default_value_t = Name::Depth)]
    name: Name,
    /// Longest chain of rays, including the primary ray [default: 5] (whitted)
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = ray_depth())]
    ray_depth: Option<u32>,
    /// Lets glass reflect by Schlick's approximation (whitted)
    #[arg(long)]
    fresnel: bool,
    /// Traces all rays that SPD counts, even those that add nothing to the picture (whitted)
    #[arg(long)]
    spd_rays: bool,
    /// Traces primary rays through the corners of pixels and averages four, as SPD does (whitted)
    #[arg(long)]
    corners: bool,
    /// What the channels of the scene's colours and of pixels say about light [default: linear]
    /// (whitted)
    #[arg(long, value_enum)]
    colour: Option<Colour>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Colour {
    /// They are proportional to it
    Linear,
    /// They have sRGB's values
    Srgb,
}

impl From<Colour> for whitted::Colour {
    fn from(colour: Colour) -> Self {
        match colour {
            Colour::Linear => Self::Linear,
            Colour::Srgb => Self::Srgb,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Name {
    /// The paper's depth shading, in which nearer spheres are brighter; only spheres
    Depth,
    /// Whitted's model: lights, shadows, mirrors, glass, and all shapes
    Whitted,
}

impl Model {
    /// Refuses options that depth shading doesn't have. `stats` is an option of the command.
    fn check(&self, stats: bool) {
        let given = [
            (self.ray_depth.is_some(), "--ray-depth"),
            (self.fresnel, "--fresnel"),
            (self.spd_rays, "--spd-rays"),
            (self.corners, "--corners"),
            (self.colour.is_some(), "--colour"),
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

    /// Renders a scene, and prints the parts that the model leaves out.
    fn trace(&self, scene: &Scene, (width, height): (u32, u32)) -> Result<Traced, oracle::Error> {
        match self.name {
            Name::Depth => {
                for left_out in not_drawn(scene) {
                    talk::say!("{left_out}");
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
                    colour: self.colour.map_or(whitted::Colour::Linear, Into::into),
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

/// A rendered scene.
struct Traced {
    reference: Reference,
    /// The numbers of rays, if the model counts them.
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
            talk::say!("oracle: {error}");
            ExitCode::FAILURE
        }
    }
}

type Done = Result<(), Box<dyn std::error::Error>>;

fn compare(picture: &Path, scene: &Path, model: &Model, json: bool, diff: Option<&Path>) -> Done {
    if diff == Some(Path::new("-")) {
        return Err("--diff -: standard output has the errors; name a file".into());
    }
    let picture = Picture::read_png(picture)?;
    let scene = load(scene)?;
    let size = (picture.width(), picture.height());
    let reference = model.trace(&scene, size)?.reference;
    let result = oracle::compare(&picture, &reference)?;
    if let Some(diff) = diff {
        oracle::difference(&picture, &reference.picture)?.write_png(diff)?;
        talk::say!(
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
    Ok(talk::print(text)?)
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
    if stats && out == Path::new("-") {
        return Err("--out - and --stats can't both have standard output".into());
    }
    let scene = load(scene)?;
    let (width, height) = size.unwrap_or(scene.view.resolution);
    let Traced { reference, counts } = model.trace(&scene, (width, height))?;
    reference.picture.write_png(out)?;
    let covered = reference.covered * 100.0;
    let what = match model.name {
        Name::Depth => "spheres",
        Name::Whitted => "objects",
    };
    talk::say!(
        "{}: {width}x{height}, {what} cover {covered:.1} %",
        out.display()
    );
    if let Some(counts) = counts.filter(|_| stats) {
        let mut text = serde_json::to_string(&counts)?;
        text.push('\n');
        talk::print(text)?;
    }
    Ok(())
}

/// Loads a scene, and prints what was left out of it.
fn load(name: &Path) -> Result<Scene, meshes::Error> {
    let loaded = meshes::load(name)?;
    for note in loaded.notes {
        talk::say!("{note}");
    }
    Ok(loaded.scene)
}

/// The help of `--diff`.
fn difference_help() -> String {
    format!("Writes the absolute difference, {DIFFERENCE_SCALE} times amplified")
}

/// Parses a ray depth.
fn ray_depth() -> clap::builder::RangedI64ValueParser<u32> {
    clap::value_parser!(u32).range(1..=i64::from(whitted::MAX_DEPTH))
}

/// Parses a size such as 1280x720.
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
