//! `cellray render`: traces a scene into a PNG file, or into a sequence of them.

use std::io::IsTerminal as _;
use std::os::unix::ffi::OsStrExt as _;
use std::path::{Path, PathBuf};

use cellray::framebuffer::{
    Corners, Framebuffer, FramebufferError, Geometry, Memory, NumberedPath, PictureFile,
};
use cellray::game::{FrameRange, Pictures, Turntable, View};
use cellray::scene::mesh::gathered;
use cellray::watch::Watch;
use clap::Args;

use super::{Outcome, inspect, run, sequence};

/// Trace a scene into a PNG file, or into a sequence of them.
#[derive(Args)]
pub struct Arguments {
    #[command(flatten)]
    options: run::Options,
    /// Width and height in pixels [default: the scene's own]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    size: Option<Geometry>,
    /// Picture to write, a .png, a .jpg, or - for a PNG on standard output; without it the frames
    /// are traced and only measured. If the name has a place for the frame's number, as f-%05d.png,
    /// every frame becomes a picture; pictures that exist are kept
    #[arg(long, value_name = "F.png")]
    out: Option<PathBuf>,
    /// Frames: N for the first N, traced only once unless --retrace is given; or A..B for numbered
    /// pictures from A to B - 1
    #[arg(
        long,
        default_value = "1",
        value_name = "A..B",
        allow_hyphen_values = true
    )]
    frames: FrameRange,
    /// Frames in which the eye goes once around its target, in numbered pictures
    #[arg(long, default_value_t = 250, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..))]
    turn: u32,
    /// Trace primary rays through the corners of the pixels and average each pixel's four, as the
    /// Standard Procedural Databases do
    #[arg(long)]
    corners: bool,
    /// Render again whenever the scene, the SPU program or a shader's source changes, until Ctrl-C
    #[arg(long, requires = "out")]
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

    /// Refuses what would mix something into a picture on standard output.
    fn check_output(&self) -> Result<(), &'static str> {
        if self.options.stats.as_deref() == Some(Path::new("-")) {
            return Err("--out - and --stats - can't both have standard output");
        }
        if self.watch || (self.frames.first, self.frames.end) != (0, 1) {
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
        let program = self.options.program()?;
        let scene = run::load(&self.options)?;
        let render_options = self.options.render_options(&scene, false);
        // Notes on what can't be drawn come before the first frame.
        run::scene(&self.options, &scene, render_options, &program)?;
        let size = self.geometry(&scene.view)?;
        let scene = gathered(&scene).into_owned();
        let turntable = Turntable::new(scene, render_options, self.turn);
        let pictures = Pictures::new(paths);
        sequence::run(
            &self.options,
            program,
            turntable,
            &pictures,
            self.frames,
            size,
        )
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
            talk::say!("cellray: error: {error}");
        }
        talk::say!("cellray: waiting for a change");
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
    if arguments.frames.first != 0 {
        return Err(
            "--frames A..B with A above 0 needs numbered pictures, as in --out 'f-%05d.png'".into(),
        );
    }
    let options = &arguments.options;
    let program = options.program()?;
    let scene = run::load(options)?;
    let render_options = options.render_options(&scene, arguments.corners);
    let scene = run::scene(options, &scene, render_options, &program)?;
    let geometry = arguments.geometry(scene.view())?;
    let framebuffer: Box<dyn Framebuffer> = match &arguments.out {
        out if arguments.corners => Box::new(Corners::new(out.as_deref(), geometry)?),
        Some(path) => Box::new(PictureFile::new(path, geometry)?),
        None => Box::new(Memory::new(geometry)?),
    };
    let enough = |traced| traced as u64 >= arguments.frames.end;
    run::frames(options, program, &scene, framebuffer, enough)
}

/// Traces one frame, and writes the page about it.
fn inspected(arguments: &Arguments, page: &Path) -> Outcome {
    if arguments.numbered()?.is_some() || (arguments.frames.first, arguments.frames.end) != (0, 1) {
        return Err("--inspect shows one frame: leave out --frames and the number in --out".into());
    }
    let recording = inspect::record()?;
    let options = &arguments.options;
    let source = run::load(options)?;
    let render_options = options.render_options(&source, false);
    let scene = run::scene(options, &source, render_options, &options.program()?)?;
    let geometry = arguments.geometry(scene.view())?;
    let out = arguments.out.as_deref();
    let scenes = (&scene, &source);
    inspect::frame(options, &recording, scenes, geometry, out, page)
}
