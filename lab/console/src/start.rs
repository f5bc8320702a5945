//! `./start`: what is missing, the command that mends it, and then a moving picture.

use std::ffi::CString;
use std::fs;
use std::os::unix::ffi::OsStrExt as _;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Duration;

use cellray::Scene;
use cellray::framebuffer::{self, Device, Interrupted, Raster};
use cellray::scene::RenderOptions;
use cellray::spe::Program;
use clap::Args;

use crate::Failure;
use crate::pictures::{engine, load};
use crate::report::program_folder;

/// Memory that a scene and two frames need.
const MEMORY_KIB: u64 = 48 << 10;
/// The SPEs of a console.
const SPES: usize = 6;

/// Find out what is missing, and show a moving picture until a key is pressed
#[derive(Args)]
pub struct Arguments {
    /// Mend what is missing, as root
    #[arg(long)]
    fix: bool,
    /// Only find out what is missing
    #[arg(long)]
    check: bool,
    /// Where the system's files are
    #[arg(long, default_value = "/", value_name = "FOLDER", hide = true)]
    root: PathBuf,
    /// End after this many frames
    #[arg(long, value_name = "N")]
    frames: Option<u32>,
    /// The folder with `scenes` [default: the program's]
    #[arg(long, value_name = "FOLDER")]
    folder: Option<PathBuf>,
}

/// What is missing.
#[derive(Debug)]
struct Trouble {
    what: String,
    /// The command that mends it, or else what the owner can do.
    mend: Mend,
    /// Whether the picture can't be shown without it.
    stops: bool,
}

#[derive(Debug)]
enum Mend {
    Command(&'static str),
    Advice(&'static str),
}

type Found = Result<String, Trouble>;

fn trouble(what: impl Into<String>, mend: Mend, stops: bool) -> Found {
    Err(Trouble { what: what.into(), mend, stops })
}

/// The system, whose files are below a folder.
struct System(PathBuf);

impl System {
    fn path(&self, path: &str) -> PathBuf {
        self.0.join(path)
    }

    fn read(&self, path: &str) -> String {
        fs::read_to_string(self.path(path)).unwrap_or_default()
    }

    /// Whether this process has rights of `access` to a file.
    fn may(&self, rights: i32, path: &str) -> bool {
        let path = self.path(path);
        CString::new(path.as_os_str().as_bytes()).is_ok_and(|path| {
            // SAFETY: the path is a C string.
            unsafe { libc::access(path.as_ptr(), rights) == 0 }
        })
    }

    /// Whether this process may read and write a file.
    fn may_use(&self, path: &str) -> bool {
        self.may(libc::R_OK | libc::W_OK, path)
    }

    /// Entries of a folder whose names are this and a number.
    fn numbered(&self, folder: &str, prefix: &str) -> Vec<String> {
        let entries = fs::read_dir(self.path(folder)).into_iter().flatten().flatten();
        let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
        let is_numbered = |name: &String| {
            name.strip_prefix(prefix).is_some_and(|number| number.parse::<u32>().is_ok())
        };
        names.filter(is_numbered).collect()
    }

    fn file_system(&self) -> Found {
        let known = self.read("proc/filesystems");
        if known.lines().any(|line| line.split_whitespace().last() == Some("spufs")) {
            return Ok("the kernel has spufs".into());
        }
        trouble("the kernel has no spufs yet", Mend::Command("modprobe spufs"), true)
    }

    fn mount(&self) -> Found {
        let mounts = self.read("proc/self/mounts");
        let is_spufs = |line: &str| {
            let fields: Vec<&str> = line.split(' ').collect();
            fields.get(1) == Some(&"/spu") && fields.get(2) == Some(&"spufs")
        };
        if mounts.lines().any(is_spufs) {
            return Ok("spufs is mounted on /spu".into());
        }
        let mount = "mkdir -p /spu && mount -t spufs -o mode=0777 none /spu";
        trouble("spufs is not mounted on /spu", Mend::Command(mount), true)
    }

    fn rights(&self) -> Found {
        // The kernel asks for no other right where it creates a context.
        if self.may(libc::X_OK, "spu") {
            return Ok("you may use the SPUs".into());
        }
        let remount = Mend::Command("chmod 0777 /spu");
        trouble("you may not enter /spu", remount, true)
    }

    fn spes(&self) -> Found {
        match self.numbered("sys/devices/system/spu", "spu").len() {
            0 => trouble(
                "the kernel reports no SPEs",
                Mend::Advice("see `dmesg | grep spu`; it needs CONFIG_SPU_BASE"),
                true,
            ),
            count if count < SPES => trouble(
                format!("{count} SPEs instead of {SPES}: fewer frames a second"),
                Mend::Advice("another program, or the boot loader's option, may hold the others"),
                false,
            ),
            count => Ok(format!("{count} SPEs")),
        }
    }

    fn screen(&self) -> Found {
        if !self.path("dev/fb0").exists() {
            let load = Mend::Advice("the kernel needs CONFIG_FB_PS3; see `dmesg | grep ps3fb`");
            return trouble("there is no /dev/fb0", load, true);
        }
        if !self.may_use("dev/fb0") {
            let mend = Mend::Command("chmod a+rw /dev/fb0");
            return trouble("you may not use /dev/fb0", mend, true);
        }
        Ok("you may use /dev/fb0".into())
    }

    /// Depth, frames and mode of the framebuffer.
    fn frames(&self) -> Found {
        let line = match Device::inspect(&self.path("dev/fb0")) {
            Ok(line) => line,
            Err(error) => {
                let advice = "only 32 bits a pixel can be shown: boot with video=ps3fb:mode:131";
                return trouble(error.to_string(), Mend::Advice(advice), true);
            }
        };
        if line.contains("memory for 1 frame") {
            let advice = "boot with ps3fb=18M for two frames; with one, the picture may tear";
            return trouble(line, Mend::Advice(advice), false);
        }
        Ok(line)
    }

    fn input(&self) -> Found {
        let devices = self.numbered("dev/input", "event");
        let usable = devices.iter().filter(|name| self.may_use(&format!("dev/input/{name}")));
        match (devices.len(), usable.count()) {
            (0, _) => trouble(
                "there is no /dev/input/event*: games get keys by the terminal only",
                Mend::Command("modprobe evdev"),
                false,
            ),
            (all, usable) if usable < all => trouble(
                format!("you may use {usable} of {all} devices in /dev/input"),
                Mend::Command("chmod a+rw /dev/input/event*"),
                false,
            ),
            (all, _) => Ok(format!("you may use {all} input devices")),
        }
    }

    fn memory(&self) -> Found {
        let text = self.read("proc/meminfo");
        let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"));
        let free = line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok());
        match free {
            Some(free) if free < MEMORY_KIB => trouble(
                format!("{} MiB of memory are free", free >> 10),
                Mend::Advice("end other programs, or add swap"),
                false,
            ),
            Some(free) => Ok(format!("{} MiB of memory are free", free >> 10)),
            None => trouble(
                "the kernel reports no number of free memory",
                Mend::Advice("mount /proc"),
                false,
            ),
        }
    }
}

/// What is looked for, in an order in which one can be mended after the other.
const CHECKS: [fn(&System) -> Found; 8] = [
    System::file_system,
    System::mount,
    System::rights,
    System::spes,
    System::screen,
    System::frames,
    System::input,
    System::memory,
];

/// Checks, mends if asked to, and shows the picture.
///
/// # Errors
/// The picture can't be shown.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let system = System(arguments.root.clone());
    let mut stopped = false;
    for check in CHECKS {
        match mended(&system, check, arguments.fix) {
            Ok(what) => messages::print!("ok       {what}"),
            Err(trouble) => {
                stopped |= trouble.stops;
                let word = if trouble.stops { "MISSING " } else { "note    " };
                messages::print!("{word} {}", trouble.what);
                match trouble.mend {
                    Mend::Command(command) => messages::print!("         as root: {command}"),
                    Mend::Advice(advice) => messages::print!("         {advice}"),
                }
            }
        }
    }
    if stopped {
        messages::print!("cellray: `./start --fix` as root does what has a command above");
        return Ok(ExitCode::FAILURE);
    }
    if !arguments.check {
        let folder = arguments.folder.clone().unwrap_or_else(program_folder);
        show(&system.path("dev/fb0"), &folder, arguments.frames)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// The result of a check, after its command if it should be mended.
fn mended(system: &System, check: fn(&System) -> Found, fix: bool) -> Found {
    let found = check(system);
    let Err(Trouble { what, mend: Mend::Command(command), .. }) = &found else {
        return found;
    };
    if !fix {
        return found;
    }
    messages::print!("fix      {what}: {command}");
    match Command::new("sh").args(["-c", command]).status() {
        Ok(status) if status.success() => {}
        Ok(status) => messages::print!("         it failed: {status}"),
        Err(error) => messages::print!("         sh: {error}"),
    }
    check(system)
}

/// Shows 16 spheres, once around in 12 seconds, until a key is pressed.
fn show(device: &Path, folder: &Path, frames: Option<u32>) -> Result<(), Failure> {
    let interrupted = Interrupted::install()?;
    let mut source = load(folder, "paper16.nff")?;
    let full = framebuffer::Options { raster: Some(Raster::Full), ..Default::default() };
    // Another driver, or a mode that needs more memory, keeps its own mode.
    let screen = framebuffer::open_with(device, full)
        .or_else(|_| framebuffer::open_with(device, framebuffer::Options::default()))?;
    messages::print!("cellray: {}", screen.describe());
    let program = Program::tracer();
    let mut engine = engine(program, Duration::from_secs(60), screen)?;
    let keys = Keys::listen();
    let from = source.view.from - source.view.at;
    let mut traced = 0;
    while frames.is_none_or(|frames| traced < frames)
        && interrupted.signal().is_none()
        && !keys.pressed()
    {
        let angle = f64::from(traced) * std::f64::consts::TAU / (12.0 * 60.0);
        source.view.from = source.view.at + crate::report::turned(from, source.view.up, angle);
        engine.render(&Scene::new(&source, RenderOptions::default(), &program)?, &mut |_| ())?;
        traced += 1;
    }
    drop(engine);
    messages::print!("cellray: {traced} frames shown; now `./report` measures this console");
    Ok(())
}

/// The keyboard of the terminal, which passes each key on at once.
struct Keys(Option<libc::termios>);

impl Keys {
    fn listen() -> Self {
        // SAFETY: all-zero termios is a valid value of its integers.
        let mut before: libc::termios = unsafe { std::mem::zeroed() };
        // SAFETY: before is valid for writing.
        if unsafe { libc::tcgetattr(libc::STDIN_FILENO, &raw mut before) } != 0 {
            return Self(None);
        }
        let mut at_once = before;
        at_once.c_lflag &= !(libc::ICANON | libc::ECHO);
        // SAFETY: at_once is valid for reading.
        unsafe { libc::tcsetattr(libc::STDIN_FILENO, libc::TCSANOW, &raw const at_once) };
        Self(Some(before))
    }

    /// Whether a key was pressed. Without a terminal there are no keys.
    fn pressed(&self) -> bool {
        let mut ready = libc::pollfd { fd: libc::STDIN_FILENO, events: libc::POLLIN, revents: 0 };
        // SAFETY: ready is one entry.
        self.0.is_some() && unsafe { libc::poll(&raw mut ready, 1, 0) } > 0
    }
}

impl Drop for Keys {
    fn drop(&mut self) {
        if let Some(before) = &self.0 {
            // The shell must not get the key.
            // SAFETY: before is valid for reading.
            unsafe { libc::tcsetattr(libc::STDIN_FILENO, libc::TCSAFLUSH, before) };
        }
    }
}
