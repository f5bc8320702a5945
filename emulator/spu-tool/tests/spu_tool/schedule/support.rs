//! Assembles, schedules, links and runs test programs.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use spu_build::Tools;
use spu_emulator::channel::Channels;
use spu_emulator::elf::Image;
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::local_store::{LocalStore, SIZE};
use spu_emulator::stop::Stop;
use spu_scheduler::code::Code;

/// Code and constants are below this address, and the data of the tests is above it.
pub const DATA: u32 = 0x2_0000;
/// No program of these tests runs for more instructions.
const LIMIT: u64 = 1_000_000;

/// A folder with a plain source.
pub struct Workshop {
    folder: tempfile::TempDir,
}

impl Workshop {
    pub fn new(source: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("plain.s"), source).unwrap();
        Self { folder }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Assembles a source in the folder in the way that `spu schedule` needs.
    pub fn assemble(&self, source: &str, object: &str) {
        let (source, object) = (self.path(source), self.path(object));
        let made = tools().assemble(&[kernels()], &[], &object, &source);
        made.unwrap_or_else(|error| panic!("{error}"));
    }

    pub fn spu(&self, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_spu"))
            .args(arguments)
            .current_dir(self.folder.path())
            .output()
            .unwrap()
    }

    /// Runs `spu schedule` with these arguments and with the folder of included files.
    pub fn spu_schedule(&self, arguments: &[&str]) -> Output {
        let kernels = kernels();
        let include = kernels.to_str().unwrap();
        self.spu(&[&["schedule", "-I", include], arguments].concat())
    }

    /// Schedules the source, checks the notes, and returns the messages about its loops.
    pub fn schedule(&self) -> String {
        self.assemble("plain.s", "plain.o");
        let output = self.spu_schedule(&["-v", "plain.o", "plain.s", "-o", "scheduled.s"]);
        let messages = stderr(&output);
        assert_eq!(output.status.code(), Some(0), "{messages}");
        self.assemble("scheduled.s", "scheduled.o");
        let check = self.spu(&["time", "--check", "scheduled.o", "scheduled.s"]);
        assert_eq!(
            check.status.code(),
            Some(0),
            "{}{}",
            String::from_utf8_lossy(&check.stdout),
            stderr(&check)
        );
        messages
    }

    /// Schedules the source as a driver. Returns the lines of the plain source in the order of the
    /// code. They are those in the line table, and the code has its size.
    pub fn schedule_driver(&self) -> Vec<u64> {
        self.assemble("plain.s", "plain.o");
        let output = self.spu_schedule(&["--driver", "plain.o", "plain.s", "-o", "scheduled.s"]);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        self.assemble("scheduled.s", "scheduled.o");
        let code = |object| Code::parse(&fs::read(self.path(object)).unwrap()).unwrap();
        let (plain, scheduled) = (code("plain.o"), code("scheduled.o"));
        assert_eq!(plain.words(0, SIZE).len(), scheduled.words(0, SIZE).len());
        let lines = scheduled.sources();
        assert!(lines.iter().all(|(_, at)| at.file.ends_with("plain.s")));
        lines.iter().map(|(_, at)| at.line).collect()
    }

    /// Links a program from one source and a caller of `functions`.
    pub fn link(&self, source: &str, functions: &[String]) -> Program {
        let sources = self.path(&format!("{source}.sources"));
        fs::create_dir_all(&sources).unwrap();
        fs::copy(self.path(source), sources.join("code.s")).unwrap();
        let mut caller = String::from("        .global _start\n_start:\n");
        for function in functions {
            caller += &format!("        .global call_{function}\ncall_{function}:\n");
            caller += &format!("        brsl $lr,{function}\n        stop 0x2000\n");
        }
        fs::write(sources.join("caller.s"), caller).unwrap();
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../linker/spu.ld");
        let image = spu_build::Image::from_folder(&sources, &script).unwrap();
        let program = sources.join("program");
        spu_build::for_tests::build(&image.include(&kernels()), &program);
        Program(fs::read(program).unwrap())
    }
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

pub fn kernels() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/schedule-kernels")
}

pub fn tools() -> Tools {
    Tools::find().unwrap_or_else(|error| panic!("{error}"))
}

/// Channels that accept every value and record it.
#[derive(Default)]
struct Written(Vec<(u8, u32)>);

impl Channels for Written {
    fn read(&mut self, channel: u8) -> Result<u32, Stop> {
        Ok(u32::from(channel))
    }
    fn write(&mut self, channel: u8, value: u32) -> Result<(), Stop> {
        self.0.push((channel, value));
        Ok(())
    }
    fn count(&mut self, _: u8) -> Result<u32, Stop> {
        Ok(1)
    }
}

/// The input of a function: registers, and quadwords of memory.
#[derive(Clone, Default)]
pub struct Input {
    pub registers: Vec<(u8, [u32; 4])>,
    pub memory: Vec<(u32, [u32; 4])>,
}

/// The state that a function leaves.
#[derive(PartialEq)]
pub struct Left {
    pub registers: Vec<Quad>,
    pub memory: Vec<u8>,
    channels: Vec<(u8, u32)>,
}

/// A linked program.
pub struct Program(Vec<u8>);

impl Program {
    pub fn call(&self, function: &str, input: &Input) -> Left {
        let image = Image::parse(&self.0).unwrap();
        assert!(image.symbol("_end").unwrap() < DATA);
        let store = LocalStore::new();
        image.load(&store, 0);
        for &(address, quadword) in &input.memory {
            store.store_quadword(address, quadword);
        }
        let mut spu = Spu::new();
        for &(register, value) in &input.registers {
            spu.set_register(register, Quad(value));
        }
        spu.set_pc(image.symbol(&format!("call_{function}")).unwrap());
        let mut channels = Written::default();
        let stopped = spu.run_limited(&store, &mut channels, LIMIT);
        let stopped = stopped.unwrap_or_else(|| panic!("{function} does not return"));
        assert!(matches!(stopped.reason, Stop::Signal(0x2000)), "{function}: {stopped:?}");
        let mut memory = vec![0; (SIZE - DATA) as usize];
        store.read(DATA, &mut memory);
        Left { registers: spu.registers.to_vec(), memory, channels: channels.0 }
    }
}

/// Compares the results of a function's two forms. Of the registers, only `live` and those that a
/// callee saves are compared.
pub fn compare(plain: &Left, scheduled: &Left, live: &[u8], what: &str) {
    for register in (0..128u8).filter(|r| *r == 1 || *r >= 80 || live.contains(r)) {
        let (plain, scheduled) =
            (plain.registers[usize::from(register)], scheduled.registers[usize::from(register)]);
        assert!(plain == scheduled, "{what}: ${register} is {scheduled:x?}, not {plain:x?}");
    }
    let differs = plain.memory.iter().zip(&scheduled.memory).position(|(a, b)| a != b);
    if let Some(at) = differs {
        panic!("{what}: memory at {:#x} differs", DATA as usize + at);
    }
    assert!(plain.channels == scheduled.channels, "{what}: channels");
}
