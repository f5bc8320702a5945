//! `cellray render`: traces a scene into a PNG file, or into a sequence of them.

use std::ffi::OsString;
use std::io::IsTerminal as _;
use std::os::unix::ffi::OsStrExt as _;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use cellray::choices::whole;
use cellray::framebuffer::{
    Corners, Framebuffer, FramebufferError, Geometry, Labels, Memory, NumberedPath, PictureFile,
};
use cellray::game::{FrameRange, FrameRangeError, Pictures, Turntable, View};
use cellray::scene::mesh::gathered;
use cellray::watch::Watch;
use clap::Args;

use super::options::Options;
use super::{Outcome, inspect, run, sequence};

/// The value of `--out` with which no picture is written.
const NONE: &str = "none";

/// The value of `--frames`.
#[derive(Clone, Copy, Debug)]
struct Frames {
    range: FrameRange,
    /// Whether it was written `A..B`, which asks for numbered pictures.
    are_numbered: bool,
}

impl FromStr for Frames {
    type Err = FrameRangeError;

    fn from_str(text: &str) -> Result<Self, FrameRangeError> {
        Ok(Self { range: text.parse()?, are_numbered: text.contains("..") })
    }
}

impl Frames {
    /// Whether it is one frame, and not numbered.
    fn is_one(self) -> bool {
        (self.range.first, self.range.end) == (0, 1) && !self.are_numbered
    }
}

/// Trace a scene into a PNG file, or into a sequence of them.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    options: Options,
    /// Width and height in pixels [default: the scene's own]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    size: Option<Geometry>,
    /// Picture to write, a .png, a .jpg, or - for a PNG on standard output; with none, the frames
    /// are traced and only measured. If the name has a place for the frame's number, as f-%05d.png,
    /// every frame becomes a picture; pictures that exist are kept [default: SCENE.png in this
    /// folder; with --inspect, none]
    #[arg(long, value_name = "F.png")]
    out: Option<PathBuf>,
    /// Frames: N for the first N, traced only once unless --retrace is given; or A..B for numbered
    /// pictures from A to B - 1
    #[arg(long, default_value = "1", value_name = "A..B", allow_hyphen_values = true)]
    frames: Frames,
    /// Frames in which the eye goes once around its target, in numbered pictures
    #[arg(long, default_value_t = 250, value_name = "N", allow_negative_numbers = true, value_parser = whole::<u32>(1..=u64::from(u32::MAX)))]
    turn: u32,
    /// Trace primary rays through the corners of the pixels and average each pixel's four, as the
    /// Standard Procedural Databases do
    #[arg(long)]
    corners: bool,
    /// Render again whenever the scene, the SPU program or a shader's source changes, until Ctrl-C
    #[arg(long)]
    watch: bool,
    /// Trace one frame in simulated time, and write a page to this file that shows where its time
    /// went: maps of the tiles, the SPUs' timelines, cycles by function and source line
    #[arg(long, value_name = "PAGE", conflicts_with_all = ["corners", "watch"])]
    inspect: Option<PathBuf>,
}

impl Arguments {
    /// The pictures' size: the given one, otherwise the scene's.
    fn geometry(&self, view: &View) -> Result<Geometry, FramebufferError> {
        match (self.size, view.resolution) {
            (Some(size), _) => Ok(size),
            (None, (width, height)) => Geometry::new(width, height),
        }
    }

    /// The names of numbered pictures, if `--out` asks for them.
    fn numbered(&self) -> Result<Option<NumberedPath>, FramebufferError> {
        let has_place = |out: &&PathBuf| out.as_os_str().as_bytes().contains(&b'%');
        let pattern = self.out.as_ref().filter(has_place);
        pattern.map(NumberedPath::new).transpose()
    }

    /// The name without its extension that a picture of the scene has by default.
    fn stem(&self) -> OsString {
        let scene = &self.options.scene.scene;
        // A generated scene's name may have a colon, which other systems' files can't have.
        match scene.to_str().filter(|_| !scene.is_file()) {
            Some(name) => name.replace([':', '/'], "-").into(),
            None => scene.file_stem().unwrap_or_default().to_owned(),
        }
    }

    /// Where one picture goes; `None` if it is not written.
    fn picture(&self) -> Result<Option<PathBuf>, String> {
        if let Some(out) = &self.out {
            return Ok((out != Path::new(NONE)).then(|| out.clone()));
        }
        if self.inspect.is_some() {
            return Ok(None);
        }
        let mut name = self.stem();
        name.push(".png");
        let path = PathBuf::from(name);
        if path.exists() && !Labels::are_in(&path) {
            let name = path.display();
            return Err(format!(
                "{name} exists, and is no picture by cellray: say --out {name} to replace it, --out \
                 and another name to keep it, or --out none to write no picture"
            ));
        }
        Ok(Some(path))
    }

    /// Refuses numbered frames whose pictures have no place for a number in their names.
    fn check_numbers(&self) -> Result<(), String> {
        let FrameRange { first, end } = self.frames.range;
        if !self.frames.are_numbered {
            return Ok(());
        }
        let mut pattern = match &self.out {
            Some(out) if out != Path::new(NONE) && out != Path::new("-") => {
                out.with_extension("").into_os_string()
            }
            _ => self.stem(),
        };
        let extension = self.out.as_ref().and_then(|out| out.extension());
        pattern.push("-%05d.");
        pattern.push(extension.unwrap_or("png".as_ref()));
        Err(format!(
            "--frames {first}..{end} makes numbered pictures, whose name needs a place for the number: \
             --out '{}'; --frames {} traces that many frames and writes the last",
            pattern.display(),
            end - first
        ))
    }

    /// Refuses what would mix something into a picture on standard output.
    fn check_output(&self) -> Result<(), &'static str> {
        if self.options.stats.as_deref() == Some(Path::new("-")) {
            return Err("--out - and --stats - can't both have standard output");
        }
        if self.watch || !self.frames.is_one() {
            return Err("--out - writes one picture: leave out --watch and --frames");
        }
        if std::io::stdout().is_terminal() {
            return Err("--out -: standard output is a terminal; redirect it to a file or a pipe");
        }
        Ok(())
    }

    /// Writes every frame as a picture while the eye goes around the scene.
    fn sequence(&self, paths: NumberedPath) -> Outcome {
        if self.corners {
            return Err("--corners can't be used with numbered pictures".into());
        }
        // Notes on what can't be drawn come before the first frame.
        let prepared = run::prepare(&self.options, false)?;
        let run::Prepared { program, source, scene, own_view, labels } = prepared;
        let size = self.geometry(scene.view())?;
        let turntable =
            Turntable::new(gathered(&source).into_owned(), scene.render_options(), self.turn);
        let pictures = Pictures::new(paths).labelled(labels, own_view);
        sequence::run(&self.options, program, turntable, &pictures, self.frames.range, size)
    }
}

pub fn run(arguments: &Arguments) -> Outcome {
    if arguments.out.as_deref() == Some(Path::new("-")) {
        arguments.check_output()?;
    }
    if !arguments.watch {
        return once(arguments);
    }
    if arguments.numbered()?.is_some() {
        return Err("--watch renders one picture, not numbered ones".into());
    }
    let mut watch = Watch::new(arguments.options.files());
    loop {
        if let Err(error) = once(arguments) {
            messages::print!("cellray: error: {error}");
        }
        messages::print!("cellray: waiting for a change");
        watch.wait();
    }
}

fn once(arguments: &Arguments) -> Outcome {
    if let Some(page) = &arguments.inspect {
        return inspected(arguments, page);
    }
    if let Some(paths) = arguments.numbered()? {
        return arguments.sequence(paths);
    }
    arguments.check_numbers()?;
    let picture = arguments.picture()?;
    let prepared = run::prepare(&arguments.options, arguments.corners)?;
    let geometry = arguments.geometry(prepared.scene.view())?;
    let what = match &picture {
        None => "no picture".to_owned(),
        Some(path) if path == Path::new("-") => "picture on standard output".to_owned(),
        Some(path) if path.is_file() => format!("{}, replaced", path.display()),
        Some(path) => path.display().to_string(),
    };
    let framebuffer: Box<dyn Framebuffer> = match picture.as_deref() {
        out if arguments.corners => {
            Box::new(Corners::new(out, geometry)?.labelled(prepared.labels.clone()))
        }
        Some(path) => Box::new(PictureFile::new(path, geometry)?.labelled(prepared.labels.clone())),
        None => Box::new(Memory::new(geometry)?),
    };
    let enough = |traced| traced as u64 >= arguments.frames.range.end;
    run::frames(&arguments.options, &prepared, (framebuffer, &what), enough)
}

/// Traces one frame, and writes the page about it.
fn inspected(arguments: &Arguments, page: &Path) -> Outcome {
    if arguments.numbered()?.is_some() || !arguments.frames.is_one() {
        return Err("--inspect shows one frame: leave out --frames and the number in --out".into());
    }
    let recording = inspect::record()?;
    let prepared = run::prepare(&arguments.options, false)?;
    let geometry = arguments.geometry(prepared.scene.view())?;
    let picture = arguments.picture()?;
    inspect::frame(&arguments.options, &recording, &prepared, geometry, picture.as_deref(), page)
}
