//! `cellray render`: renders a scene to a picture, or to a sequence of pictures.

use std::ffi::OsString;
use std::io::IsTerminal as _;
use std::os::unix::ffi::OsStrExt as _;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::Args;

use super::options::Options;
use super::sequence::{self, Film};
use super::{Outcome, inspect, run};
use crate::choices::whole;
use crate::framebuffer::{
    Corners, Framebuffer, FramebufferError, Geometry, Labels, Memory, NumberedPath, PictureFile,
};
use crate::game::{FrameRange, FrameRangeError, Pictures, View};
use crate::watch::Watch;

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

/// Render a scene to a picture, or to a sequence of pictures.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    options: Options,
    /// Width and height in pixels [default: the scene's]
    #[arg(long, help_heading = "Output", value_name = "WxH", allow_hyphen_values = true)]
    size: Option<Geometry>,
    /// Picture to write: a .png or .jpg file, - or none [default: SCENE.png]
    ///
    /// With - a PNG is written to standard output. With none, frames are traced and measured, but
    /// not written. If the name has a number, as in f-%05d.png, every frame is written to a file of
    /// that number, and files that exist are kept. The default is SCENE.png in the current folder;
    /// with --inspect, none.
    #[arg(long, help_heading = "Output", value_name = "F.png")]
    out: Option<PathBuf>,
    /// Number of frames, or a range A..B for numbered pictures
    ///
    /// The range ends with frame B - 1. Without a range all frames of a scene without an animation
    /// are equal, so that only the first is traced unless --retrace is given.
    #[arg(
        long,
        help_heading = "Output",
        default_value = "1",
        value_name = "A..B",
        allow_hyphen_values = true
    )]
    frames: Frames,
    /// Frames per revolution of the eye in numbered pictures [default: 250]
    ///
    /// With 0, as by default in a scene with an animation, the eye stands still.
    #[arg(long, help_heading = "Output", value_name = "N", allow_negative_numbers = true)]
    #[arg(value_parser = whole::<u32>(0..=u64::from(u32::MAX)))]
    turn: Option<u32>,
    /// Frames per second of an animation
    #[arg(long, help_heading = "Output", default_value_t = 25, value_name = "N")]
    #[arg(allow_negative_numbers = true, value_parser = whole::<u32>(1..=1000))]
    fps: u32,
    /// Sample the corners of the pixels, as the Standard Procedural Databases do
    ///
    /// A pixel is the mean of its four corners.
    #[arg(long, help_heading = "Quality", hide_short_help = true)]
    corners: bool,
    /// Render again whenever a file changes, until Ctrl-C
    ///
    /// Files are the scene, the SPU program and the sources of shaders.
    #[arg(long, help_heading = "Output")]
    watch: bool,
    /// HTML page to write on the time that a frame takes
    ///
    /// One frame is traced in simulated time. The page has maps of the tiles, the timelines of the
    /// SPUs, and cycles by function and by source line.
    #[arg(long, help_heading = "Output", value_name = "PAGE", conflicts_with_all = ["corners", "watch"])]
    inspect: Option<PathBuf>,
    /// Scene of the frame before the inspected one
    ///
    /// The page then has a map of the pixels that were kept of it, and of the reasons for which
    /// others were traced.
    #[arg(long, help_heading = "Output", value_name = "SCENE", requires = "inspect")]
    before: Option<PathBuf>,
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
                "{name} exists, and was not written by cellray: use --out {name} to replace it, --out \
                 with another name to keep it, or --out none to write no picture"
            ));
        }
        Ok(Some(path))
    }

    /// Refuses a range of frames if the pictures' name has no number.
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
            "--frames {first}..{end} writes numbered pictures, so the name needs a number: --out '{}'; \
             --frames {} traces that many frames and writes only the last",
            pattern.display(),
            end - first
        ))
    }

    /// Refuses options that would write something else to standard output beside the picture.
    fn check_output(&self) -> Result<(), &'static str> {
        if self.options.stats.as_deref() == Some(Path::new("-")) {
            return Err("--out - and --stats - can't both use standard output");
        }
        if self.watch || !self.frames.is_one() {
            return Err("--out - writes one picture: remove --watch and --frames");
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
        // Notes on shapes that can't be drawn are printed before the first frame.
        let mut prepared = run::prepare(&self.options, false)?;
        let size = self.geometry(prepared.scene.view())?;
        let plays = prepared.animation.is_some();
        let turn = self.turn.unwrap_or(if plays { 0 } else { 250 });
        let film = Film::new(&mut prepared, turn, self.fps);
        let run::Prepared { program, own_view, labels, .. } = prepared;
        let mut pictures = Pictures::new(paths).labelled(labels, own_view);
        if plays {
            pictures = pictures.animated(self.fps);
        }
        sequence::pictures(&self.options, program, film, &pictures, self.frames.range, size)
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
    let mut prepared = run::prepare(&arguments.options, arguments.corners)?;
    let geometry = arguments.geometry(prepared.scene.view())?;
    let plays = prepared.animation.is_some() && !arguments.frames.is_one() && !arguments.corners;
    let film = plays.then(|| {
        let last = arguments.frames.range.end.saturating_sub(1);
        prepared.labels.set("time", last as f64 / f64::from(arguments.fps));
        Film::new(&mut prepared, 0, arguments.fps)
    });
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
    if let Some(film) = film {
        let frames = arguments.frames.range.end;
        let (options, program) = (&arguments.options, prepared.program);
        return sequence::last(options, program, film, frames, (framebuffer, &what));
    }
    let enough = |traced| traced as u64 >= arguments.frames.range.end;
    run::frames(&arguments.options, &prepared, (framebuffer, &what), enough)
}

/// Traces one frame, and writes the page about it.
fn inspected(arguments: &Arguments, page: &Path) -> Outcome {
    if arguments.numbered()?.is_some() || !arguments.frames.is_one() {
        return Err("--inspect traces one frame: remove --frames and the number in --out".into());
    }
    let recording = inspect::record()?;
    let prepared = run::prepare(&arguments.options, false)?;
    let geometry = arguments.geometry(prepared.scene.view())?;
    let picture = arguments.picture()?;
    let before = arguments.before.as_deref();
    let before =
        before.map(|path| prepared.of_same_options(&arguments.options, path)).transpose()?;
    let (before, picture) = (before.as_ref(), picture.as_deref());
    inspect::frame(&arguments.options, &recording, &prepared, before, geometry, picture, page)
}
