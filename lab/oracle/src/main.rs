//! The command line of the reference: renders scenes and compares pictures with them.
//!
//! Data goes to standard output, messages go to standard error.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

use clap::error::ErrorKind;
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use oracle::{
    Comparison, DIFFERENCE_SCALE, Explanation, Model, Picture, Reference, Samples, Settings, ULPS,
    WELL_CONDITIONED, whitted,
};
use scenes::depth::not_drawn;
use scenes::{Scene, ViewError, check_size};

const EXAMPLES: &str = "Examples:
  oracle compare whitted16.png
  oracle compare frame.png scenes/paper16.nff --max-wrong 0.001
  oracle explain frame.png
  oracle floor sphereflake:4 --size 640x640
  oracle compare frame.png sphereflake:2 --json --diff difference.png
  oracle render scenes/paper16.nff --size 1280x720 --out paper16.png
  oracle render gears --corners --spd-rays --stats --out gears.png

SCENE is an NFF file, a mesh (.obj, .ply, .glb), or sphereflake:LEVEL, tetra:LEVEL or terrain:LEVEL
for a generated one (sphereflake:2 has 91 spheres, tetra:3 has 256 polygons), or gears, mount, rings,
teapot, tree, lattice, jacks, shells or sombrero, with :SIZE if it is not to have SPD's (gears:2).

A picture by cellray carries the settings that it was made with. They apply, unless an option
overrides them. All other settings have the defaults of cellray render.";

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
        /// Scene of the picture [default: the one that it names]
        scene: Option<PathBuf>,
        /// Prints the errors as JSON
        #[arg(long)]
        json: bool,
        #[arg(long, value_name = "PNG", help = difference_help())]
        diff: Option<PathBuf>,
        /// Exits with 1 if more than this share of the pixels is wrong, 0 to 1
        #[arg(long, value_name = "FRACTION", allow_hyphen_values = true, value_parser = share)]
        max_wrong: Option<f64>,
        #[command(flatten)]
        options: Options,
    },
    /// Finds for each wrong pixel how far the numbers of rays must be off for it to be right.
    ///
    /// The wrong pixels are traced again with the coordinates of each ray moved by random units in
    /// the last place of a single: at most 1, then 2, and so on to 64, with 24 tries each. Prints
    /// how many pixels each number of units explains. The picture must have one sample a pixel.
    ///
    /// Also prints the condition numbers of the wrong pixels in the exact scene: by how much a
    /// channel changes, relative to white, for each radian by which the ray from the eye is turned.
    /// It is turned by 8 units to 64 sides. Below the bound, no channel moves by 1/255.
    #[command(after_help = EXAMPLES)]
    Explain {
        /// PNG picture to explain
        picture: PathBuf,
        /// Scene of the picture [default: the one that it names]
        scene: Option<PathBuf>,
        /// Prints the explanation as JSON
        #[arg(long)]
        json: bool,
        #[command(flatten)]
        options: Options,
    },
    /// Compares a scene with itself in single precision: what no tracer with singles can avoid.
    ///
    /// The objects and the lights are rounded to singles relative to the eye, as SPUs get them, and
    /// both scenes are traced in double precision. With Whitted's model, the point, the direction
    /// and the normal of each ray are then rounded, too: to the nearest singles, and truncated as
    /// by the SPU's arithmetic. A pixel is wrong as for compare.
    #[command(after_help = EXAMPLES)]
    Floor {
        /// The scene
        scene: PathBuf,
        /// Size of the pictures in pixels [default: the scene's own]
        #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = size)]
        size: Option<(u32, u32)>,
        /// Prints the errors as JSON
        #[arg(long)]
        json: bool,
        #[command(flatten)]
        options: Options,
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
        options: Options,
    },
    /// Write man pages and shell completions.
    #[command(hide = true)]
    Pages(messages::manual::Arguments),
}

/// How the picture is made: the options of `cellray render` that determine it. A flag can be turned
/// off where the picture has it on: --fresnel=false.
#[derive(Args)]
struct Options {
    /// Animation of a glTF file, by its name or its number from 0 on, or none [default: the first]
    #[arg(long, value_name = "ANIMATION")]
    animation: Option<String>,
    /// Time of the animation in seconds [default: 0]
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true)]
    time: Option<f64>,
    /// Model to render with [default: whitted if the scene has lights, otherwise depth]
    #[arg(long, value_enum)]
    model: Option<Name>,
    /// Position of the eye [default: the scene's own]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = point)]
    from: Option<String>,
    /// Point that the eye looks at [default: the scene's own]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = point)]
    look_at: Option<String>,
    /// Direction that is up in the picture [default: the scene's own]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = point)]
    up: Option<String>,
    /// Degrees between the top and the bottom of the picture [default: the scene's own]
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true)]
    angle: Option<f64>,
    /// Samples of a pixel that differs from a neighbour: 1, 4 or 16 [default: 4; 1 with --corners]
    #[arg(long, value_name = "N", value_parser = ["1", "4", "16"])]
    antialias: Option<String>,
    /// How much such a pixel differs in a channel at least, in 1/255; 0: antialias every pixel
    /// [default: 32]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    contrast: Option<u8>,
    /// Colour space of scene and picture [default: srgb; linear with depth shading and with
    /// --corners]
    #[arg(long, value_enum)]
    colour: Option<Colour>,
    /// Limits light that is nearly white or brighter without a step
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    roll_off: Option<bool>,
    /// Traces primary rays through the corners of pixels and averages four, as SPD does
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    corners: Option<bool>,
    /// Longest chain of rays, including the primary ray [default: 5] (whitted)
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = ray_depth())]
    ray_depth: Option<u32>,
    /// Lets glass reflect by Schlick's approximation (whitted)
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    fresnel: Option<bool>,
    /// Traces all rays that SPD counts, even those that add nothing to the picture (whitted)
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    spd_rays: Option<bool>,
    /// Traces no shadows (whitted)
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    no_shadows: Option<bool>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Colour {
    /// They are proportional to it
    Linear,
    /// They have sRGB's values
    Srgb,
}

#[derive(Clone, Copy, ValueEnum)]
enum Name {
    /// The paper's depth shading, in which nearer spheres are brighter; only spheres
    Depth,
    /// Whitted's model: lights, shadows, mirrors, glass, and all shapes
    Whitted,
}

impl Options {
    /// Those that are given.
    fn settings(&self) -> Settings {
        let word = |value: &dyn Fn() -> Option<clap::builder::PossibleValue>| {
            value().map(|value| value.get_name().to_owned())
        };
        let flag = |flag: Option<bool>| flag.map(|flag| flag.to_string());
        let given = [
            ("animation", self.animation.clone()),
            ("time", self.time.map(|time| time.to_string())),
            ("model", word(&|| self.model?.to_possible_value())),
            ("from", self.from.clone()),
            ("look-at", self.look_at.clone()),
            ("up", self.up.clone()),
            ("angle", self.angle.map(|angle| angle.to_string())),
            ("antialias", self.antialias.clone()),
            ("contrast", self.contrast.map(|contrast| contrast.to_string())),
            ("colour", word(&|| self.colour?.to_possible_value())),
            ("roll-off", flag(self.roll_off)),
            ("corners", flag(self.corners)),
            ("ray-depth", self.ray_depth.map(|depth| depth.to_string())),
            ("fresnel", flag(self.fresnel)),
            ("spd-rays", flag(self.spd_rays)),
            ("no-shadows", flag(self.no_shadows)),
        ];
        let mut settings = Settings::default();
        for (name, value) in given {
            if let Some(value) = value {
                settings.set(name, value);
            }
        }
        settings
    }

    /// Refuses options that depth shading doesn't have. `stats` is an option of the command.
    fn check(&self, model: &Model, stats: bool) {
        let given = [
            (self.ray_depth.is_some(), "--ray-depth"),
            (self.fresnel.is_some(), "--fresnel"),
            (self.spd_rays.is_some(), "--spd-rays"),
            (self.no_shadows.is_some(), "--no-shadows"),
            (stats, "--stats"),
        ];
        let stray = given.into_iter().find(|&(given, _)| given);
        if let (Model::Depth(_), Some((_, option))) = (model, stray) {
            let message = format!("{option} needs --model whitted");
            Cli::command().error(ErrorKind::ArgumentConflict, message).exit();
        }
    }
}

fn main() -> ExitCode {
    let done = match Cli::parse().verb {
        Verb::Compare { picture, scene, json, diff, max_wrong, options } => {
            let compared = compare(&picture, scene.as_deref(), &options, json, diff.as_deref());
            compared.and_then(|result| check_share(&result, max_wrong))
        }
        Verb::Explain { picture, scene, json, options } => {
            explain(&picture, scene.as_deref(), &options, json)
        }
        Verb::Floor { scene, size, json, options } => floor(&scene, &options, size, json),
        Verb::Render { scene, size, out, stats, options } => {
            render(&scene, &options, size, &out, stats)
        }
        Verb::Pages(arguments) => {
            messages::manual::write(Cli::command(), &arguments).map_err(Into::into)
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            messages::print!("oracle: {error}");
            ExitCode::FAILURE
        }
    }
}

type Done<T = ()> = Result<T, Box<dyn std::error::Error>>;

/// A picture, its scene as the picture shows it, and the settings that it was made with.
struct Shown {
    picture: Picture,
    scene: Scene,
    model: Model,
    reference: Reference,
}

/// Reads a picture, prints which settings apply, and traces the reference.
fn shown(path: &Path, scene: Option<&Path>, options: &Options) -> Done<Shown> {
    let picture = Picture::read_png(path)?;
    let said = Settings::of_png(path)?;
    let name = match (scene, said.scene()) {
        (Some(scene), _) => scene,
        (None, Some(scene)) => Path::new(scene),
        (None, None) => {
            let shown = path.display();
            return Err(
                format!("{shown} has no description of its scene: name the scene, too").into()
            );
        }
    };
    let given = options.settings();
    let known = given.over(&said);
    let mut scene = load(name, &known, path)?;
    let assumed = known.assumed(&scene);
    let settings = known.over(&assumed);
    settings.place(&mut scene.view, path)?;
    let model = settings.model(path)?;
    options.check(&model, false);

    let size = (picture.width(), picture.height());
    // Text from a file must not control the terminal.
    let by = said
        .software()
        .map_or(String::new(), |software| format!(" by {}", software.escape_debug()));
    messages::print!(
        "oracle: {}{by}, {}x{}, is compared with {} in double precision",
        path.display(),
        size.0,
        size.1,
        name.display()
    );
    if let Some(other) = said.scene().filter(|&other| Path::new(other) != name) {
        messages::print!("oracle: note: the picture is of {}", other.escape_debug());
    }
    for (who, options) in [
        ("settings of the picture", said.without(&given).followed()),
        ("settings of the command line", given.followed()),
        ("assumed", assumed.followed()),
        ("of no use to the reference", said.of_kernels()),
        ("note: ignored, since unknown here", said.unknown()),
    ] {
        if !options.is_empty() {
            messages::print!("oracle: {who}: {}", options.join(" "));
        }
    }

    report_left_out(&model, &scene);
    let (reference, _) = model.trace(&scene, size)?;
    Ok(Shown { picture, scene, model, reference })
}

fn compare(
    path: &Path,
    scene: Option<&Path>,
    options: &Options,
    json: bool,
    diff: Option<&Path>,
) -> Done<Comparison> {
    if diff == Some(Path::new("-")) {
        return Err("--diff -: standard output has the errors; name a file".into());
    }
    let Shown { picture, model, reference, .. } = shown(path, scene, options)?;
    let pixels = model.pixels();
    let count = match pixels.samples {
        Samples::One => 1,
        Samples::Four => 4,
        Samples::Sixteen => 16,
    };
    if count > 1 {
        messages::print!(
            "oracle: the reference has {count} samples in {} pixels, where its own pixels of one sample \
             differ",
            reference.refined
        );
    }
    let result = oracle::compare(&picture, &reference)?;
    if let Some(diff) = diff {
        oracle::difference(&picture, &reference.picture)?.write_png(diff)?;
        messages::print!("{}: the difference, {DIFFERENCE_SCALE} times amplified", diff.display());
    }
    print_comparison(&result, &picture, json)?;
    Ok(result)
}

/// Prints which errors of rays explain a picture's wrong pixels.
fn explain(path: &Path, scene: Option<&Path>, options: &Options, json: bool) -> Done {
    let Shown { picture, scene, model, reference } = shown(path, scene, options)?;
    let Model::Whitted(options) = &model else {
        return Err("only pictures in Whitted's model can be explained".into());
    };
    let result = oracle::explain(&picture, &reference, &scene, options, usize::MAX)?;
    let mut text = if json { serde_json::to_string(&result)? } else { explanation(&result) };
    text.push('\n');
    messages::write_data(text)?;
    Ok(())
}

/// The distributions of backward errors and of condition numbers.
fn explanation(result: &Explanation) -> String {
    let wrong = result.wrong_pixels.len();
    let mut text = format!("wrong pixels   {wrong}\n");
    let by_ulps = result.by_ulps();
    for (ulps, pixels) in ULPS.iter().zip(by_ulps) {
        text += &format!("within {ulps:2} ulp  {pixels}\n");
    }
    text += &format!("beyond         {}\n", by_ulps[ULPS.len()]);
    let mut low = 0.0;
    for high in [1e2, 1e3, WELL_CONDITIONED, 1e5, 1e6, f64::INFINITY] {
        let pixels = result.conditioned(low, high);
        text += &format!("condition from {low:7.0}  {pixels}\n");
        low = high;
    }
    let well = result.conditioned(0.0, WELL_CONDITIONED);
    let share = 100.0 * well as f64 / wrong.max(1) as f64;
    text + &format!("well-conditioned, below {WELL_CONDITIONED:.0}: {well} ({share:.2} %)")
}

/// Prints the errors of the scene that has its numbers, and those of its rays, rounded to singles.
fn floor(name: &Path, options: &Options, size: Option<(u32, u32)>, json: bool) -> Done {
    let given = options.settings();
    let mut scene = load(name, &given, name)?;
    let settings = given.over(&given.assumed(&scene));
    settings.place(&mut scene.view, name)?;
    let model = settings.model(name)?;
    options.check(&model, false);
    report_left_out(&model, &scene);
    let size = size.unwrap_or(scene.view.resolution);
    let (reference, _) = model.trace(&scene, size)?;
    let scene = oracle::rounded_to_singles(&scene);
    let mut models = vec![("scene", model)];
    if let Model::Whitted(options) = model {
        for (name, rounding) in
            [("nearest", whitted::Rounding::Nearest), ("truncated", whitted::Rounding::Truncated)]
        {
            models.push((name, Model::Whitted(whitted::Options { rounding, ..options })));
        }
    }
    let mut floors = Vec::new();
    for (name, model) in models {
        let (rounded, _) = model.trace(&scene, size)?;
        floors.push((name, oracle::compare(&rounded.picture, &reference)?));
    }
    let text = if json {
        serde_json::to_string(&floors.into_iter().collect::<BTreeMap<_, _>>())? + "\n"
    } else {
        let pixels = reference.picture.pixels().len();
        let line = |(name, result): (&str, Comparison)| {
            let what = match name {
                "scene" => "the scene rounded to singles",
                "nearest" => "and each ray, to the nearest",
                _ => "and each ray, truncated",
            };
            let (wrong, share) = (result.wrong_pixels, 100.0 * result.wrong_fraction);
            format!("{what:28}  {wrong} of {pixels} pixels wrong ({share:.4} %)\n")
        };
        floors.into_iter().map(line).collect()
    };
    messages::write_data(text)?;
    Ok(())
}

/// Prints the errors of a picture, as text or JSON.
fn print_comparison(result: &Comparison, picture: &Picture, json: bool) -> Done {
    let mut text = if json { serde_json::to_string(result)? } else { report(result, picture) };
    text.push('\n');
    messages::write_data(text)?;
    Ok(())
}

/// Fails if more than a share of a picture's pixels is wrong.
fn check_share(result: &Comparison, most: Option<f64>) -> Done {
    let wrong = result.wrong_fraction;
    match most.filter(|&most| wrong > most) {
        Some(most) => {
            Err(format!("{wrong} of the pixels are wrong, more than --max-wrong {most}").into())
        }
        None => Ok(()),
    }
}

/// Prints the parts of a scene that a model leaves out.
fn report_left_out(model: &Model, scene: &Scene) {
    if let Model::Depth(_) = model {
        for left_out in not_drawn(scene) {
            messages::print!("{left_out}");
        }
    }
}

fn report(result: &Comparison, picture: &Picture) -> String {
    let Comparison { wrong_pixels, wrong_off_silhouette, max_error, mean_error, .. } = result;
    let (pixels, percent) = (picture.pixels().len(), result.wrong_fraction * 100.0);
    let off_silhouette = result.max_error_off_silhouette;
    format!(
        "wrong pixels   {wrong_pixels} of {pixels} ({percent:.4} %), {wrong_off_silhouette} off silhouettes\n\
         largest error  {max_error}/255, {off_silhouette}/255 off silhouettes\n\
         mean error     {mean_error:.4}/255"
    )
}

fn render(
    name: &Path,
    options: &Options,
    size: Option<(u32, u32)>,
    out: &Path,
    stats: bool,
) -> Done {
    if stats && out == Path::new("-") {
        return Err("--out - and --stats can't both have standard output".into());
    }
    let given = options.settings();
    let mut scene = load(name, &given, name)?;
    let mut settings = given.over(&given.assumed(&scene));
    settings.place(&mut scene.view, out)?;
    let model = settings.model(out)?;
    options.check(&model, stats);
    let (width, height) = size.unwrap_or(scene.view.resolution);
    report_left_out(&model, &scene);
    let (reference, counts) = model.trace(&scene, (width, height))?;
    settings.set_scene(&name.to_string_lossy(), concat!("oracle ", env!("CARGO_PKG_VERSION")));
    reference.picture.write_png_with(out, &settings)?;
    let covered = reference.covered * 100.0;
    let what = match model {
        Model::Depth(_) => "spheres",
        Model::Whitted(_) => "objects",
    };
    messages::print!(
        "{}: {width}x{height}, {what} cover {covered:.1} %; made with {}",
        out.display(),
        settings.followed().join(" ")
    );
    if let Some(counts) = counts.filter(|_| stats) {
        let mut text = serde_json::to_string(&counts)?;
        text.push('\n');
        messages::write_data(text)?;
    }
    Ok(())
}

/// Loads a scene as it is at the time of the settings, and prints what was left out of it. `path`
/// is the file that the settings are of.
fn load(name: &Path, settings: &Settings, path: &Path) -> Done<Scene> {
    let mut loaded = meshes::load_animated(name, settings.animation())?;
    for note in loaded.notes {
        messages::print!("{note}");
    }
    if let Some(time) = settings.time(path)? {
        let (Some(animation), Some(mesh)) = (&mut loaded.animation, &mut loaded.scene.mesh) else {
            return Err(format!("{} has no animation for --time", name.display()).into());
        };
        let (positions, normals) = animation.at(time);
        let mesh = Arc::make_mut(mesh);
        mesh.positions.copy_from_slice(positions);
        mesh.normals.copy_from_slice(normals);
    }
    Ok(loaded.scene)
}

fn difference_help() -> String {
    format!("Writes the absolute difference, {DIFFERENCE_SCALE} times amplified")
}

/// Checks that a text is a point or a direction, such as 1,2.5,-3.
fn point(text: &str) -> Result<String, String> {
    let is_number = |word: &str| word.trim().parse().is_ok_and(f64::is_finite);
    if text.split(',').count() == 3 && text.split(',').all(is_number) {
        Ok(text.to_owned())
    } else {
        Err("three finite numbers with commas between, such as 1,2.5,-3".into())
    }
}

/// Parses a share, from 0 to 1.
fn share(text: &str) -> Result<f64, String> {
    let share = text.parse().ok().filter(|share| (0.0..=1.0).contains(share));
    share.ok_or_else(|| "a share of all pixels is a number from 0 to 1, such as 0.001".into())
}

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
    let size = (width.parse().map_err(too_large)?, height.parse().map_err(too_large)?);
    check_size(size.0, size.1).map_err(|error| error.to_string())?;
    Ok(size)
}
