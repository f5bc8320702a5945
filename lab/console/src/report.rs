//! `./report`: what a console does, as one text file.

use std::fs::{self, File};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use cellray::framebuffer::{self, Device, Framebuffer, Geometry, Memory};
use cellray::game::{DVec3, FixedSteps, NoInput, Recording, Session};
use cellray::scene::RenderOptions;
use cellray::spe::{Program, library_path, usable_spes};
use cellray::{Scene, Settings};
use clap::Args;
use clock::results::Machine;
use protocol::formulation::Formulations;

use crate::corners::on_each;
use crate::pictures::{self, engine, load};
use crate::{Failure, step};

/// How the first line of a report begins.
pub const TITLE: &str = "cellray report 1";
/// How its last line begins.
pub const CHECKSUM: &str = "checksum ";

/// How the line about emulated SPUs begins.
pub const EMULATED: &str = "spufs not mounted";

/// The scenes whose frames are counted.
const SCENES: [&str; 10] = [
    "paper1.nff",
    "paper13.nff",
    "paper16.nff",
    "spheres64.nff",
    "spheres256.nff",
    "daylight.nff",
    "whitted16.nff",
    "still-life.nff",
    "shadows.nff",
    "chess.glb",
];
const RECORDING: &str = "recordings/billiards.jsonl";
/// A game whose bodies move without input.
const UNPLAYED: &str = "orrery";

/// Measure this machine, and write a report without personal data
///
/// Each step has a line and a time limit of its own, and none that fails ends the report.
#[derive(Args)]
pub struct Arguments {
    /// The file to write
    #[arg(long, default_value = "report.txt", value_name = "FILE")]
    out: PathBuf,
    /// The folder with `scenes` and `recordings` [default: the program's]
    #[arg(long, value_name = "FOLDER")]
    folder: Option<PathBuf>,
    /// Run only steps whose names begin so; may be repeated
    #[arg(long, value_name = "STEP")]
    only: Vec<String>,
    /// Multiply the time limits, for slow emulators
    #[arg(long, default_value_t = 1, value_name = "N")]
    patience: u32,
    /// The framebuffer
    #[arg(long, default_value = "/dev/fb0", value_name = "PATH")]
    device: PathBuf,
    /// Seconds of each measurement of frames
    #[arg(long, default_value_t = 2, value_name = "N")]
    seconds: u64,
    /// The size of frames that are not shown
    #[arg(long, default_value = "1280x720", value_name = "WxH")]
    size: Geometry,
}

/// The report while it is written.
struct Report<'a> {
    arguments: &'a Arguments,
    folder: PathBuf,
    text: String,
    file: Option<File>,
    failed: u32,
}

/// Runs all steps.
///
/// # Errors
/// The report can't be printed.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let folder = arguments.folder.clone().unwrap_or_else(program_folder);
    let mut report = Report { arguments, folder, text: String::new(), file: None, failed: 0 };
    match File::create(&arguments.out) {
        Ok(file) => report.file = Some(file),
        Err(error) => report.only_printed(&error),
    }
    report.line(&format!("{TITLE}, cellray {}", env!("CARGO_PKG_VERSION")));
    report.all();
    let failed = report.failed;
    report.line(&format!("steps that failed: {failed}"));
    let sum = crc32fast::hash(report.text.as_bytes());
    report.line(&format!("{CHECKSUM}{sum:08x}"));
    if let Some(Err(error)) = report.file.as_ref().map(File::sync_all) {
        report.only_printed(&error);
    }
    let out = arguments.out.display();
    match report.file {
        Some(_) => messages::print!("cellray: {out}: send it as docs/ps3.md describes"),
        None => messages::print!("cellray: the report is only above: please copy it"),
    }
    Ok(if failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The folder of the bundle, in which this program is.
#[must_use]
pub fn program_folder() -> PathBuf {
    let program = std::env::current_exe().ok();
    program.as_deref().and_then(Path::parent).map_or_else(|| ".".into(), Path::to_path_buf)
}

impl Report<'_> {
    fn only_printed(&mut self, error: &std::io::Error) {
        self.file = None;
        let out = self.arguments.out.display();
        messages::print!("cellray: {out}: {error}: the report is only printed");
    }

    /// Prints a line and writes it, so that the file has it even if the machine stops.
    fn line(&mut self, line: &str) {
        let line = format!("{line}\n");
        self.text.push_str(&line);
        // A closed output is no reason to end what the file still gets.
        let _ = messages::write_data(&line);
        if let Some(Err(error)) = self.file.as_mut().map(|file| file.write_all(line.as_bytes())) {
            self.only_printed(&error);
        }
    }

    fn step(&mut self, name: &str, limit: u64, body: impl FnOnce() -> Result<(), Failure>) {
        let only = &self.arguments.only;
        if !only.is_empty() && !only.iter().any(|begin| name.starts_with(begin.as_str())) {
            return;
        }
        let limit = Duration::from_secs(limit) * self.arguments.patience;
        let passed = step::run(name, limit, body, &mut |line| self.line(line));
        self.failed += u32::from(!passed);
    }

    fn all(&mut self) {
        let arguments = self.arguments;
        let folder = self.folder.clone();
        let device = arguments.device.as_path();
        // Shorter than a step's limit, so that a hung SPU is named.
        let timeout = Duration::from_secs(5) * arguments.patience;
        self.step("kernel", 2, kernel);
        self.step("memory", 2, memory);
        self.step("libspe2", 5, spes);
        self.step("framebuffer", 5, || {
            line(&format!("framebuffer {}", Device::inspect(device)?));
            Ok(())
        });
        self.step("SPUs", 10, || corners(timeout));
        for row in clock::rows::all() {
            self.step(&format!("clock {}", row.name), 10, || {
                let measured = row.measure()?;
                line(&format!("clock {} {} {}", row.name, measured.value, row.unit));
                Ok(())
            });
        }
        let golden = fs::read_to_string(folder.join("golden.txt")).unwrap_or_default();
        for scene in pictures::SCENES {
            for (number, of) in Formulations::shipped().iter().enumerate() {
                self.step(&format!("picture {scene} {number}"), 10, || {
                    let picture = pictures::line(&folder, scene, of, timeout)?;
                    line(&picture);
                    match golden.lines().any(|known| known == picture) {
                        true => Ok(()),
                        false => Err("the picture is not among golden.txt".into()),
                    }
                });
            }
        }
        // Memory has no vertical blank.
        let ways: &[bool] = if device.exists() { &[true, false] } else { &[false] };
        for &vsync in ways {
            let how = match (device.exists(), vsync) {
                (false, _) => "in memory",
                (true, true) => "vsync",
                (true, false) => "no vsync",
            };
            for scene in SCENES {
                let name = format!("frames {scene}, {how}");
                self.step(&name, 10, || {
                    let screen = screen(arguments, vsync)?;
                    let size = screen.geometry();
                    let mut engine = engine(Program::tracer(), timeout, screen)?;
                    let mut views = Turning::new(load(&folder, scene)?);
                    measure(&format!("{name}, {size}"), arguments.seconds, || {
                        engine.render(&views.next()?, &mut |_| ())?;
                        Ok(true)
                    })
                });
            }
            for played in [true, false] {
                let game = if played { "billiards" } else { UNPLAYED };
                let name = format!("frames of {game}, {how}");
                self.step(&name, 10, || {
                    play(&name, arguments, &folder, game, (played, vsync), timeout)
                });
            }
        }
    }
}

/// A scene whose eye turns by a quarter of a degree a frame, so that each frame is traced.
pub struct Turning {
    source: scenes::Scene,
    from: DVec3,
    angle: f64,
}

impl Turning {
    /// Begins at the scene's own eye.
    #[must_use]
    pub fn new(source: scenes::Scene) -> Self {
        Self { from: source.view.from - source.view.at, source, angle: 0.0 }
    }

    /// The next frame.
    ///
    /// # Errors
    /// The scene can't be shown.
    #[expect(clippy::should_implement_trait, reason = "it has no end")]
    pub fn next(&mut self) -> Result<Scene, Failure> {
        self.angle += 0.25_f64.to_radians();
        let view = &mut self.source.view;
        view.from = view.at + turned(self.from, view.up, self.angle);
        Ok(Scene::new(&self.source, RenderOptions::default(), &Program::tracer())?)
    }
}

/// A vector turned about an axis.
#[must_use]
pub fn turned(vector: DVec3, axis: DVec3, angle: f64) -> DVec3 {
    let axis = axis.normalize();
    let (sine, cosine) = libm::sincos(angle);
    vector * cosine + axis.cross(vector) * sine + axis * (axis.dot(vector) * (1.0 - cosine))
}

/// A line of the step that this process is.
fn line(text: &str) {
    messages::print!("{text}");
}

/// The lines of a file of the kernel that begin with one of these words.
fn lines_of(path: &str, words: &[&str]) -> Result<(), Failure> {
    let text = fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
    for found in text.lines().filter(|line| words.iter().any(|word| line.starts_with(word))) {
        line(&found.split_whitespace().collect::<Vec<_>>().join(" "));
    }
    Ok(())
}

/// Kernel, processor and distribution. `/proc/version` is left out, because it names a person.
fn kernel() -> Result<(), Failure> {
    for file in ["ostype", "osrelease", "version"] {
        if let Ok(text) = fs::read_to_string(format!("/proc/sys/kernel/{file}")) {
            line(&format!("{file} {}", text.trim()));
        }
    }
    for processor in Machine::here().processor {
        line(&processor);
    }
    for (path, words) in
        [("/etc/os-release", ["NAME=", "VERSION="]), ("/proc/cpuinfo", ["clock", "timebase"])]
    {
        // A system need not have the files, and a PC's have other lines.
        if let Err(error) = lines_of(path, &words) {
            line(&error.to_string());
        }
    }
    Ok(())
}

fn memory() -> Result<(), Failure> {
    // SAFETY: sysconf takes no pointers.
    line(&format!("page size {}", unsafe { libc::sysconf(libc::_SC_PAGESIZE) }));
    lines_of("/proc/meminfo", &["MemTotal", "MemAvailable", "HugePages_Total"])
}

fn spes() -> Result<(), Failure> {
    let library = library_path();
    // Its folder may have a person's name.
    let name = library.as_deref().and_then(Path::file_name);
    line(&match name {
        Some(name) => format!("libspe2 {}", name.display()),
        None => "libspe2 linked in".to_owned(),
    });
    let mounts = fs::read_to_string("/proc/self/mounts").unwrap_or_default();
    match mounts.lines().find(|line| line.split(' ').nth(2) == Some("spufs")) {
        Some(mount) => line(&format!("spufs mounted: {mount}")),
        None => line(&format!("{EMULATED}: this project's libspe2 emulates SPUs")),
    }
    line(&format!("SPEs {}", usable_spes()?));
    Ok(())
}

/// Each SPU's results: those of the first, and the SPUs that differ, fail or hang.
fn corners(limit: Duration) -> Result<(), Failure> {
    let results = on_each(usable_spes()?.clamp(1, Settings::default().spus), limit);
    let first = results.iter().find_map(|result| result.as_ref().ok());
    for corner in first.into_iter().flatten() {
        line(&format!("corner {corner}"));
    }
    let mut wrong = 0;
    for (number, result) in results.iter().enumerate() {
        let fault = match result {
            Err(error) => error.clone(),
            Ok(_) if Some(result.as_ref()) == first.map(Ok) => continue,
            Ok(_) => format!("SPU {number} has other results than the first"),
        };
        line(&fault);
        wrong += 1;
    }
    if wrong > 0 { Err(format!("{wrong} SPUs of {}", results.len()).into()) } else { Ok(()) }
}

/// The console's screen, or memory if there is none.
fn screen(arguments: &Arguments, vsync: bool) -> Result<Box<dyn Framebuffer>, Failure> {
    if !arguments.device.exists() {
        return Ok(Box::new(Memory::new(arguments.size)?));
    }
    let options = framebuffer::Options { vsync, ..framebuffer::Options::default() };
    Ok(framebuffer::open_with(&arguments.device, options)?)
}

/// Makes frames for some seconds, until there are no more, and prints their number.
fn measure(
    name: &str,
    seconds: u64,
    mut frame: impl FnMut() -> Result<bool, Failure>,
) -> Result<(), Failure> {
    // The first frame loads programs and makes trees.
    frame()?;
    let (began, idle) = (Instant::now(), idle_time());
    let mut frames = 0;
    while began.elapsed() < Duration::from_secs(seconds) && frame()? {
        frames += 1;
    }
    let rate = f64::from(frames) / began.elapsed().as_secs_f64();
    let idle = match (idle, idle_time()) {
        (Some((idle, all)), Some((idle_then, all_then))) if all_then > all => {
            let share = 100.0 * (idle_then - idle) as f64 / (all_then - all) as f64;
            format!("{share:.0} % of the PPE idle")
        }
        _ => "the PPE's idle time not known".to_owned(),
    };
    line(&format!("{name}: {rate:.2} frames/s, {frames} frames, {idle}"));
    Ok(())
}

/// Ticks that the processor was idle, and all ticks.
fn idle_time() -> Option<(u64, u64)> {
    let text = fs::read_to_string("/proc/stat").ok()?;
    let fields = text.lines().next()?.split_whitespace().skip(1);
    let ticks: Vec<u64> = fields.map_while(|field| field.parse().ok()).collect();
    Some((*ticks.get(3)?, ticks.iter().take(8).sum()))
}

fn play(
    name: &str,
    arguments: &Arguments,
    folder: &Path,
    game: &str,
    (played, vsync): (bool, bool),
    timeout: Duration,
) -> Result<(), Failure> {
    let entry = games::find(game).ok_or("there is no such game")?;
    let spus = usable_spes()?.clamp(1, Settings::default().spus);
    let settings = Settings { spus, timeout, ..Settings::default() };
    let screen = screen(arguments, vsync)?;
    let name = format!("{name}, {}", screen.geometry());
    let mut session = Session::start((entry.new)(), settings, screen)?;
    if played {
        session = session.replaying(Recording::open(&folder.join(RECORDING))?)?;
    }
    let step = Duration::from_nanos(16_666_667);
    // The clock never waits; the screen does.
    let mut clock = FixedSteps(step);
    measure(&name, arguments.seconds, || {
        let flow = session.frame(&mut clock, &mut NoInput)?;
        Ok(flow.is_continue())
    })
}
