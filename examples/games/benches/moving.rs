//! Games in which objects move: frames a second in simulated time where only those subtiles are
//! traced that the moved objects can change, and where all are. Six SPUs at 1280x720. Both pictures
//! of each frame are compared byte for byte. Where the camera moves, everything is traced.
//!
//!     cargo bench -p games --bench moving -- [--plot FILE.svg] [recorded] [GAME...]
//!
//! The plot has the pixels that are traced and those that change in each frame of the recorded
//! game.

#![expect(clippy::print_stdout, reason = "a benchmark has nothing to lose but its output")]

mod simulated;

use std::error::Error;
use std::path::Path;

use cellray::framebuffer::{Geometry, Memory};
use cellray::game::{FixedSteps, NoInput, Recording, Session, World};
use cellray::{Engine, Settings};
use games::billiards::Billiards;
use games::demo::DEMOS;
use image::RgbImage;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};
use protocol::layout::{SUBTILE_HEIGHT, SUBTILE_WIDTH};
use scenes::Camera;

const SIZE: (u32, u32) = (1280, 720);
/// Frames of a demonstration.
const FRAMES: u64 = 24;
/// Frames of the recorded game of billiards in which something changes, from its beginning on.
const RECORDED: u64 = 60;
/// Ticks a second of the decrementer.
const TIMEBASE: f64 = 79_800_000.0;

/// Width and height of the plot in pixels.
const PLOT: (u32, u32) = (960, 400);
const FONT: &str = "sans-serif";
/// Colours that colour-blind readers can distinguish (Okabe and Ito).
const TRACED: RGBColor = RGBColor(0, 114, 178);
const CHANGED: RGBColor = RGBColor(213, 94, 0);
const MOVING: RGBColor = RGBColor(235, 235, 235);

type Outcome<T> = Result<T, Box<dyn Error>>;

/// Two tracers that render the same frames: one retains what has not changed, the other traces
/// every frame.
struct Pair {
    retaining: Engine,
    complete: Engine,
    shown: Option<(Camera, RgbImage)>,
    frames: Vec<Frame>,
}

/// A frame in which something has changed.
struct Frame {
    /// Whether the camera has not.
    rests: bool,
    /// Ticks of the tracer that retains, and of the other one.
    ticks: [u64; 2],
    /// Pixels that the first one traced.
    traced: u64,
    /// Pixels of the subtiles in which the picture differs from the one before.
    changed: u64,
}

/// The number of pixels in subtiles in which two pictures differ.
fn changed(one: &RgbImage, other: &RgbImage) -> u64 {
    let across = SIZE.0 / SUBTILE_WIDTH;
    let mut subtiles = vec![false; (across * SIZE.1 / SUBTILE_HEIGHT) as usize];
    for (x, y, pixel) in one.enumerate_pixels() {
        let subtile = y / SUBTILE_HEIGHT * across + x / SUBTILE_WIDTH;
        subtiles[subtile as usize] |= pixel != other.get_pixel(x, y);
    }
    let subtiles = subtiles.iter().filter(|changed| **changed).count();
    subtiles as u64 * u64::from(SUBTILE_WIDTH * SUBTILE_HEIGHT)
}

impl Pair {
    fn start() -> Outcome<Self> {
        let start = |retain| -> Outcome<Engine> {
            let picture = Memory::new(Geometry::new(SIZE.0, SIZE.1)?)?;
            Ok(Engine::start(Settings { retain, ..Settings::default() }, Box::new(picture))?)
        };
        let (retaining, complete) = (start(true)?, start(false)?);
        Ok(Self { retaining, complete, shown: None, frames: Vec::new() })
    }

    fn render(&mut self, world: &mut World) -> Outcome<()> {
        let scene = world.scene(&Settings::default().program)?;
        let camera = scene.camera(SIZE.0, SIZE.1)?;
        let retained = self.retaining.render(scene, &mut |_| {})?;
        let (traced, ticks) = (retained.primary_rays(), retained.ticks());
        let whole = self.complete.render(scene, &mut |_| {})?.ticks();
        let picture = self.complete.picture().ok_or("the frame can't be read back")?;
        if self.retaining.picture().as_ref() != Some(&picture) {
            return Err("a retained frame differs from the complete one".into());
        }
        if let Some((from, shown)) = &self.shown {
            let changed = changed(shown, &picture);
            if changed > 0 {
                let rests = *from == camera;
                self.frames.push(Frame { rests, ticks: [ticks, whole], traced, changed });
            }
        }
        self.shown = Some((camera, picture));
        Ok(())
    }

    fn row(&self, name: &str) -> String {
        let at_rest: Vec<&Frame> = self.frames.iter().filter(|frame| frame.rests).collect();
        let rate = |frames: &mut dyn ExactSizeIterator<Item = u64>| {
            frames.len() as f64 * TIMEBASE / frames.sum::<u64>().max(1) as f64
        };
        let share = |of: fn(&Frame) -> u64| {
            let pixels = at_rest.iter().map(|frame| of(frame)).sum::<u64>() as f64;
            100.0 * pixels / (at_rest.len().max(1) as f64 * f64::from(SIZE.0 * SIZE.1))
        };
        let slowest = self.frames.iter().map(|f| f.ticks[0] as f64 / f.ticks[1] as f64);
        format!(
            "| {name} | {} of {} | {:.0} | {:.0} | {:.0} | {:.2} | {:.1} % | {:.1} % |",
            at_rest.len(),
            self.frames.len(),
            rate(&mut self.frames.iter().map(|frame| frame.ticks[1])),
            rate(&mut self.frames.iter().map(|frame| frame.ticks[0])),
            rate(&mut at_rest.iter().map(|frame| frame.ticks[0])),
            slowest.fold(0.0, f64::max),
            share(|frame| frame.changed),
            share(|frame| frame.traced),
        )
    }
}

/// Plots the pixels that are traced and those that change, frame by frame.
fn plot(frames: &[Frame], path: &Path) -> Outcome<()> {
    register_font(FONT, FontStyle::Normal, dejavu::sans::regular()).map_err(|_| "no font")?;
    let root = SVGBackend::new(path, PLOT).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .caption("Recorded game of billiards: subtiles traced, and subtiles changed", (FONT, 18))
        .margin(10)
        .x_label_area_size(40)
        .y_label_area_size(50)
        .build_cartesian_2d(0..frames.len(), 0.0..100.0)?;
    let moving = frames.iter().enumerate().filter(|(_, frame)| !frame.rests);
    chart.draw_series(moving.map(|(number, _)| {
        Rectangle::new([(number, 0.0), (number + 1, 100.0)], MOVING.filled())
    }))?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .x_desc("frame (grey: the camera moves, and everything is traced)")
        .y_desc("% of all pixels")
        .label_style((FONT, 14))
        .draw()?;
    for (name, colour) in [("traced", TRACED), ("changed", CHANGED)] {
        let steps = frames.iter().enumerate().flat_map(|(number, frame)| {
            let pixels = if colour == TRACED { frame.traced } else { frame.changed };
            let share = 100.0 * pixels as f64 / f64::from(SIZE.0 * SIZE.1);
            [(number, share), (number + 1, share)]
        });
        chart
            .draw_series(LineSeries::new(steps, colour.stroke_width(2)))?
            .label(name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 20, y)], colour.stroke_width(2)));
    }
    chart
        .configure_series_labels()
        .background_style(WHITE)
        .border_style(MOVING)
        .label_font((FONT, 14))
        .draw()?;
    root.present()?;
    Ok(())
}

fn main() -> Outcome<()> {
    simulated::restart()?;
    let mut named: Vec<String> = std::env::args().skip(1).filter(|it| it != "--bench").collect();
    let plot_path = match named.iter().position(|name| name == "--plot") {
        Some(at) => named.drain(at..named.len().min(at + 2)).nth(1),
        None => None,
    };
    let wanted = |name: &str| named.is_empty() || named.iter().any(|other| other == name);
    println!(
        "| game | camera rests in frames | complete, frames/s | retained, frames/s | retained, camera at rest | slowest frame, of complete | pixels of changed subtiles | pixels traced |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    if wanted("recorded") {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/played/billiards.jsonl");
        let small = Memory::new(Geometry::new(16, 8)?)?;
        let settings = Settings { spus: 1, ..Settings::default() };
        let session = Session::start(Billiards::default(), settings, Box::new(small))?;
        let mut session = session.replaying(Recording::open(&path)?)?;
        let mut pair = Pair::start()?;
        let mut clock = FixedSteps(std::time::Duration::ZERO);
        while (pair.frames.len() as u64) < RECORDED {
            if session.frame(&mut clock, &mut NoInput)?.is_break() {
                break;
            }
            pair.render(session.world())?;
        }
        println!("{}", pair.row("billiards, recorded"));
        if let Some(path) = plot_path {
            // Cargo runs it in the package's folder.
            let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
            plot(&pair.frames, &root.join(path))?;
        }
    }
    for demo in DEMOS.iter().filter(|demo| wanted(demo.name)) {
        let mut pair = Pair::start()?;
        demo.play(SIZE, FRAMES, |world| pair.render(world))?;
        println!("{}", pair.row(demo.name));
    }
    Ok(())
}
