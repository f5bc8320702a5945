//! The command line of `spu run`.

use std::ffi::OsString;
use std::path::PathBuf;
use std::str::FromStr;
use std::time::Duration;

use clap::{ArgGroup, Args, ValueEnum};
use spu_emulator::engine::Engine;
use spu_emulator::mfc::Policy;

use super::{map, status};

const EXAMPLES: &str = "\
Examples:
  spu run hello.elf                      run; the exit status is the program's
  spu run --start elfspe tool.elf a b    a program with main(argc, argv) (linked with crt2.o)
  spu run --trace --max-instructions 100 loop.elf
  spu run --timing --json loop.elf       cycles, and warnings about DMA that nobody waits for
  spu run --profile loop.elf             which functions the cycles went to
  spu run --in-mbox commands.txt --out-mbox results.txt server.elf
  spu run --main-memory 1M@0x60000000 --load-mem scene.bin@0x60000000 --arg 0x60000000:64 \\
          --dump-mem picture.bin@0x60080000:64K tracer.elf

Numbers are decimal, or hexadecimal after 0x; sizes may end in K, M or G. Files of mailbox words
are text: numbers, comments after #.

Effective addresses:";

/// Run an SPU program
///
/// Library calls of the C run time (stop 0x2100, 0x2101, 0x2105: printf, files, memory in
/// effective address space) are handled. Files that the program opens are this computer's.
/// Standard output belongs to the program, so traces, statistics and registers go to standard
/// error unless a file is named.
#[derive(Args)]
#[command(after_help = after_help(), group(ArgGroup::new("report").multiple(true)), group(ArgGroup::new("simulated").multiple(true)))]
pub struct Options {
    /// SPU ELF executable
    pub program: PathBuf,
    /// Arguments for the program
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    pub arguments: Vec<OsString>,

    /// How the program receives its arguments
    #[arg(long, value_enum, default_value_t = Start::Spe, help_heading = "Start")]
    pub start: Start,
    /// Initial registers from $3 on, instead of arguments: a word in the preferred slot, or with
    /// :64 a doubleword
    #[arg(long = "arg", value_name = "VALUE[:64]", help_heading = "Start", conflicts_with_all = ["arguments", "start"])]
    pub registers: Vec<Register>,
    /// Load a file into local store before the start
    #[arg(long, value_name = "FILE@ADDRESS", help_heading = "Start")]
    pub load_ls: Vec<FileAt>,

    /// Add a region of main memory, filled with 0
    #[arg(long, value_name = "SIZE@EA", help_heading = "Main memory")]
    pub main_memory: Vec<Region>,
    /// Load a file into main memory before the start
    #[arg(long, value_name = "FILE@EA", help_heading = "Main memory")]
    pub load_mem: Vec<FileAt>,
    /// Write part of main memory to a file at the end
    #[arg(long, value_name = "FILE@EA:SIZE", help_heading = "Main memory")]
    pub dump_mem: Vec<FileOf>,
    /// Size of the heap for malloc_ea and mmap_ea
    #[arg(long, value_name = "SIZE", default_value = "16M", help_heading = "Main memory")]
    pub heap: Size,

    /// File with words for the inbound mailbox
    #[arg(long, value_name = "FILE", help_heading = "Mailboxes")]
    pub in_mbox: Option<PathBuf>,
    /// File that receives the words of the outbound mailbox
    #[arg(long, value_name = "FILE", help_heading = "Mailboxes")]
    pub out_mbox: Option<PathBuf>,
    /// File that receives the words of the outbound interrupt mailbox
    #[arg(long, value_name = "FILE", help_heading = "Mailboxes")]
    pub out_intr_mbox: Option<PathBuf>,

    /// What runs the instructions, with the same results. Where each instruction is watched, it is
    /// the interpreter
    #[arg(long, value_enum, default_value_t = EngineName::Compiler, help_heading = "Engine")]
    pub engine: EngineName,
    /// When DMA commands are carried out. at-last delays each one until the program waits for it,
    /// and takes the newest first, so that a missing wait, fence or barrier shows
    #[arg(long, value_enum, default_value_t = Mfc::AtOnce, conflicts_with = "simulated", help_heading = "Engine")]
    pub mfc: Mfc,
    /// Run the program compiled and interpreted, block by block, and fail at the first difference;
    /// in simulated time, count the cycles a second time, instruction by instruction
    #[arg(long, conflicts_with_all = ["engine", "trace", "stats"], help_heading = "Engine")]
    pub check: bool,

    /// Wait for a debugger on this port of the loopback interface and obey it: gdb's remote
    /// protocol. 0 takes any free port
    #[arg(
        long,
        value_name = "PORT",
        conflicts_with_all = ["max_instructions", "check"],
        help_heading = "Engine"
    )]
    pub gdb: Option<u16>,

    /// Give the program only the files below this folder, which it finds as /. Without privileges,
    /// this needs the kernel's user namespaces
    #[arg(long, value_name = "DIR", help_heading = "Limits")]
    pub root: Option<PathBuf>,
    /// Stop after this many instructions
    #[arg(long, value_name = "N", help_heading = "Limits")]
    pub max_instructions: Option<u64>,
    /// Stop a program that sleeps in a channel for longer than this
    #[arg(long, value_name = "SECONDS", default_value_t = 60, help_heading = "Limits")]
    pub patience: u64,

    /// Write each instruction: address, symbol, text, registers written
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true, help_heading = "Output")]
    pub trace: Option<Option<PathBuf>>,
    /// Count instructions by class and name, loads, stores, branches, DMA commands
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true, group = "report", help_heading = "Output")]
    pub stats: Option<Option<PathBuf>>,
    /// Run in simulated time, which the decrementer also counts, and report cycles, dual issue and
    /// stalls by cause. Warns where the program uses local store that a DMA command in flight reads
    /// or writes. Only for programs that use no mailboxes
    #[arg(long, conflicts_with_all = ["in_mbox", "out_mbox", "out_intr_mbox"], value_name = "FILE", num_args = 0..=1, require_equals = true, groups = ["report", "simulated"], help_heading = "Output")]
    pub timing: Option<Option<PathBuf>>,
    /// Run in simulated time, and show which functions the cycles went to; in a file, everything
    /// that `spu profile` shows. Only for programs that use no mailboxes
    #[arg(long, conflicts_with_all = ["in_mbox", "out_mbox", "out_intr_mbox"], value_name = "FILE", num_args = 0..=1, require_equals = true, group = "simulated", help_heading = "Output")]
    pub profile: Option<Option<PathBuf>>,
    /// Take latencies and rates from a file instead of the console's; see docs/timing.md
    #[arg(long, value_name = "FILE", requires = "simulated", help_heading = "Output")]
    pub machine: Option<PathBuf>,
    /// Write statistics and timing as JSON
    #[arg(long, requires = "report", help_heading = "Output")]
    pub json: bool,
    /// Write all registers at the end
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true, help_heading = "Output")]
    pub dump_regs: Option<Option<PathBuf>>,
    /// Write local store to a file at the end
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub dump_ls: Option<PathBuf>,
}

fn after_help() -> String {
    format!("{EXAMPLES}\n{}\n\n{}", map::MAP_HELP, status::help())
}

/// When DMA commands are carried out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Mfc {
    /// As soon as their order allows
    AtOnce,
    /// As late as possible
    AtLast,
}

/// What can run the instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum EngineName {
    Interpreter,
    Compiler,
}

impl Options {
    pub fn engine(&self) -> Engine {
        match self.engine {
            _ if self.check => Engine::Check,
            EngineName::Interpreter => Engine::Interpreter,
            EngineName::Compiler => Engine::Compiler,
        }
    }

    /// Whether the program runs in simulated time.
    pub fn is_simulated(&self) -> bool {
        self.timing.is_some() || self.profile.is_some()
    }

    pub fn policy(&self) -> Policy {
        match self.mfc {
            Mfc::AtOnce => Policy::AtOnce,
            Mfc::AtLast => Policy::AtLast,
        }
    }

    /// How long a program may sleep. A debugger can interrupt it.
    pub fn patience(&self) -> Duration {
        match self.gdb {
            Some(_) => Duration::MAX,
            None => Duration::from_secs(self.patience),
        }
    }
}

/// What the program finds in its registers and memory at the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Start {
    /// As libspe2 starts it: main(id, argp, envp); argp is the effective address of the arguments'
    /// addresses (64 bits each, a 0 after the last), envp is 0
    Spe,
    /// As elfspe starts it: $3 is the number of arguments and $4 describes a copy of them, which
    /// crt2.o moves to the top of local store for main(argc, argv); `argv[0]` is the program's
    /// path
    Elfspe,
}

/// Parses a number: decimal, or hexadecimal after `0x`.
pub fn number(text: &str) -> Result<u64, String> {
    let parsed = match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) => u64::from_str_radix(digits, 16),
        None => text.parse(),
    };
    parsed.map_err(|error| format!("`{text}` is no number: {error}"))
}

/// A size in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size(pub usize);

/// The largest size that an option accepts, because the emulator keeps the data in memory.
const MOST: u64 = 4 << 30;

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (digits, unit) = match text.as_bytes().last() {
            Some(b'K' | b'k') => (&text[..text.len() - 1], 1 << 10),
            Some(b'M' | b'm') => (&text[..text.len() - 1], 1 << 20),
            Some(b'G' | b'g') => (&text[..text.len() - 1], 1 << 30),
            _ => (text, 1),
        };
        let size = number(digits)?.checked_mul(unit).filter(|&size| size <= MOST);
        let size = size.and_then(|size| usize::try_from(size).ok());
        size.map(Self).ok_or(format!("`{text}` is more than 4G"))
    }
}

/// `SIZE@EA`
#[derive(Clone, Copy, Debug)]
pub struct Region {
    pub size: Size,
    pub ea: u64,
}

impl FromStr for Region {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (size, ea) = text.split_once('@').ok_or("expected SIZE@EA")?;
        Ok(Self { size: size.parse()?, ea: number(ea)? })
    }
}

/// `FILE@ADDRESS`
#[derive(Clone, Debug)]
pub struct FileAt {
    pub path: PathBuf,
    pub address: u64,
}

impl FromStr for FileAt {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        // A path may contain an `@`, but an address can't.
        let (path, address) = text.rsplit_once('@').ok_or("expected FILE@ADDRESS")?;
        Ok(Self { path: path.into(), address: number(address)? })
    }
}

/// `FILE@EA:SIZE`
#[derive(Clone, Debug)]
pub struct FileOf {
    pub path: PathBuf,
    pub ea: u64,
    pub size: Size,
}

impl FromStr for FileOf {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (path, piece) = text.rsplit_once('@').ok_or("expected FILE@EA:SIZE")?;
        let (ea, size) = piece.split_once(':').ok_or("expected FILE@EA:SIZE")?;
        Ok(Self { path: path.into(), ea: number(ea)?, size: size.parse()? })
    }
}

/// The initial value of a register.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Register {
    Word(u32),
    Doubleword(u64),
}

impl FromStr for Register {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if let Some(value) = text.strip_suffix(":64") {
            return number(value).map(Self::Doubleword);
        }
        let value = number(text)?;
        u32::try_from(value)
            .map(Self::Word)
            .map_err(|_| format!("`{text}` needs 64 bits: write {text}:64"))
    }
}
