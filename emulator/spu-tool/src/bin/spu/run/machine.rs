//! The machine of `spu run`: one SPE, main memory, and the code that handles the program's calls.

use std::fs;
use std::io::{self, BufRead, Write};
use std::ops::ControlFlow;
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;

use spu_debugger::console::Console;
use spu_debugger::{Attached, Debugger, signal_of};
use spu_emulator::elf::Image;
use spu_emulator::interp::{Observer as _, Quad, Spu};
use spu_emulator::local_store::{LocalStore, SIZE};
use spu_emulator::machine;
use spu_emulator::memory::{Access, MainMemory, RegisteredMemory};
use spu_emulator::ppe_call::{
    Arena, CALL_WORD, CallError, Class, Library, Process, SYSTEM_CALL, system_call_name,
    system_call_number,
};
use spu_emulator::profile::ProgramId;
use spu_emulator::simulated::{CYCLES_PER_SECOND, Method, Simulation, SimulationOptions, Timing};
use spu_emulator::spe::{Config, Halted, Spe};
use spu_emulator::stop::{Stop, Stopped};
use spu_isa::{Instruction, LIMIT_MASK};
use spu_reports::views::View;
use spu_reports::{Figures, ProfileFile};
use spu_scheduler::code::Code;

use super::arguments;
use super::bench::Bench;
use super::map::{HEAP_EA, IMAGE_EA, LOCAL_STORE_EA};
use super::options::Options;
use super::output::{json, write_file, write_text};
use super::sandbox;
use super::status::Status;
use crate::failure::Failure;
use spu_debugger::console::instruction_text;

/// Where libspe2 puts the zero back chain: the initial stack pointer.
const STACK_TOP: u32 = SIZE - 16;
const FIRST_ARGUMENT: u8 = 3;

/// How a run ended.
pub enum End {
    /// `stop 0x20xx`
    Exit(u8),
    /// The program did something invalid.
    Fault(Stopped),
    /// A library call without a handler, and its address.
    Call(CallError, u32),
    /// The instruction limit was reached at this address.
    Limit(u32),
    /// The debugger ended it at this address.
    Killed(u32),
    /// The program sleeps at this address, and nothing will wake it.
    Asleep(u32, &'static str),
    /// The user of `spu debug` ended it.
    Quit,
    /// The two ways of running it, or of counting its cycles, differ, and where.
    Differs(String, u32),
}

pub struct Machine {
    spe: Arc<Spe>,
    memory: Arc<RegisteredMemory>,
    bytes: Box<[u8]>,
    library: Library,
    at: u32,
    /// What the registers are before the first instruction.
    arguments: Option<Vec<Quad>>,
}

impl Machine {
    /// Creates a machine with the program loaded and everything set up that the options ask for.
    pub fn new(options: &Options, bytes: &[u8], image: &Image<'_>) -> Result<Self, Failure> {
        let memory = Arc::new(RegisteredMemory::new());
        let register = |what: &str, ea, bytes, access| {
            memory.register(ea, bytes, access).map_err(Failure::of(what))
        };
        register("the program's file", IMAGE_EA, bytes.to_vec(), Access::ReadOnly)?;
        let machine = match options.is_simulated() {
            false => machine::Machine::with_engine(memory.clone(), options.engine()),
            true => {
                let method = if options.check { Method::Checked } else { Method::Memoised };
                let simulation = SimulationOptions {
                    method,
                    engine: options.engine(),
                    profile: options.profile.is_some(),
                    races: true,
                    ..SimulationOptions::default()
                };
                let timing = match &options.machine {
                    Some(path) => Timing::read(path)?,
                    None => Timing::default(),
                };
                machine::Machine::simulated_with(memory.clone(), timing, simulation)
            }
        };
        if let Some(simulation) = machine.simulation() {
            warn_of_races(simulation, bytes);
        }
        let config = Config { policy: options.policy(), ..Config::default() };
        let spe = Spe::new(&machine, config);
        spe.profile_as(ProgramId::of(bytes));
        memory
            .register_local_store(LOCAL_STORE_EA, Arc::clone(spe.local_store()))
            .map_err(Failure::of("local store"))?;
        for region in &options.main_memory {
            let what = format!("--main-memory {}@{:#x}", region.size.0, region.ea);
            register(&what, region.ea, vec![0; region.size.0], Access::ReadWrite)?;
        }
        let heap = Arena::new(&memory, HEAP_EA, options.heap.0);
        let heap = heap.map_err(Failure::of(format_args!("--heap {}", options.heap.0)))?;
        image.load(spe.local_store(), IMAGE_EA);
        if let Some(toe) = image.toe() {
            spe.local_store().write(toe, &IMAGE_EA.to_be_bytes());
        }
        let arguments = arguments::prepare(options, &memory)?;
        let machine = Self {
            spe,
            memory,
            bytes: bytes.into(),
            library: Library::new(Box::new(Process), Box::new(heap)),
            at: image.entry(),
            arguments: Some(arguments),
        };
        machine.load_files(options)?;
        Ok(machine)
    }

    pub fn local_store(&self) -> &LocalStore {
        self.spe.local_store()
    }

    fn load_files(&self, options: &Options) -> Result<(), Failure> {
        for file in &options.load_ls {
            let bytes = fs::read(&file.path).map_err(Failure::file(&file.path))?;
            let end = file.address.saturating_add(bytes.len() as u64);
            if end > u64::from(SIZE) {
                return Err(Failure::new(format!(
                    "{}: {} bytes at {:#x} do not fit into local store",
                    file.path.display(),
                    bytes.len(),
                    file.address
                )));
            }
            self.local_store().write(file.address as u32, &bytes);
        }
        for file in &options.load_mem {
            let bytes = fs::read(&file.path).map_err(Failure::file(&file.path))?;
            let written = self.memory.write(file.address, &bytes);
            written.map_err(Failure::of(format_args!("--load-mem {}", file.path.display())))?;
        }
        Ok(())
    }

    /// Sets the registers as libspe2 does. The top of local store holds the zero back chain.
    fn prepare(&self, spu: &mut Spu, arguments: &[Quad]) {
        self.local_store().write(STACK_TOP, &[0; 16]);
        spu.set_register(1, Quad::scalar(STACK_TOP));
        spu.set_register(2, Quad::ZERO);
        spu.set_register(6, Quad::from_doublewords([LOCAL_STORE_EA, 0]));
        for (register, &value) in (FIRST_ARGUMENT..).zip(arguments) {
            spu.set_register(register, value);
        }
    }

    /// Runs until the program ends, or obeys a debugger, and handles library calls.
    pub fn run(&mut self, options: &Options, image: &Image<'_>) -> Result<End, Failure> {
        let spe = Arc::clone(&self.spe);
        let mut bench = Bench::new(options, image, &spe)?;
        let end = sandbox::within(options.root.as_deref(), || self.run_with(options, &mut bench))??;
        self.flush()?;
        bench.finish()?;
        Ok(end)
    }

    fn run_with(&mut self, options: &Options, bench: &mut Bench<'_>) -> Result<End, Failure> {
        if let Some(port) = options.gdb {
            return self.debug(port, bench);
        }
        let most = options.max_instructions.unwrap_or(u64::MAX);
        if most == 0 {
            self.start();
        }
        let end = self.run_limited(most, bench);
        Ok(end.unwrap_or(End::Limit(self.at)))
    }

    /// Runs at most `most` instructions, and handles library calls. Returns how the program
    /// ended, if it did.
    fn run_limited(&mut self, most: u64, bench: &mut Bench<'_>) -> Option<End> {
        let mut left = most;
        while left > 0 {
            let before = self.spe.with_spu(Spu::executed);
            let arguments = self.arguments.take();
            let stopped = self.spe.run_observed(self.at, left, bench, |spu| {
                if let Some(arguments) = &arguments {
                    self.prepare(spu, arguments);
                }
            });
            left -= self.spe.with_spu(Spu::executed) - before;
            if let Some(end) = self.after(stopped, bench) {
                return Some(end);
            }
        }
        None
    }

    /// Waits for a debugger on this port and runs the program under it.
    fn debug(&mut self, port: u16, bench: &mut Bench<'_>) -> Result<End, Failure> {
        let debugger = Debugger::new(|| ());
        let address = debugger.listen(port).map_err(Failure::of(format_args!("--gdb {port}")))?;
        messages::print!("spu: waiting for a debugger: target remote {address}");
        let thread = debugger.attach(&self.spe);
        let end = loop {
            let stopped = self.run_under(&thread, bench);
            if debugger.has_killed() {
                return Ok(End::Killed(self.at));
            }
            let end = self.after(stopped.clone(), bench);
            if let Some(stopped) = &stopped {
                thread.stopped(&self.spe, stopped, end.as_ref().and_then(End::signal));
            }
            if let Some(end) = end {
                break end;
            }
        };
        match (&end, end.signal()) {
            (End::Exit(status), _) => debugger.ended(spu_debugger::End::Exit(*status)),
            (_, Some(signal)) => debugger.ended(spu_debugger::End::Signal(signal)),
            (_, None) => {}
        }
        Ok(end)
    }

    /// Runs the program, and obeys the commands that a console reads.
    pub fn run_in_console<R: BufRead + Send, W: Write + Send>(
        &mut self,
        options: &Options,
        image: &Image<'_>,
        console: &mut Console<'_, R, W>,
    ) -> Result<End, Failure> {
        let spe = Arc::clone(&self.spe);
        let mut bench = Bench::new(options, image, &spe)?;
        let end =
            sandbox::within(options.root.as_deref(), || self.obey_console(console, &mut bench))?;
        self.flush()?;
        bench.finish()?;
        Ok(end)
    }

    fn obey_console<R: BufRead, W: Write>(
        &mut self,
        console: &mut Console<'_, R, W>,
        bench: &mut Bench<'_>,
    ) -> End {
        let spe = Arc::clone(&self.spe);
        let store = spe.local_store();
        loop {
            let arguments = self.arguments.take();
            let look = |spu: &mut Spu, halted: &Halted<'_>| {
                console.before_instruction(spu, store, halted)?;
                if let Some(instruction) = Instruction::decode(store.load_word(spu.pc())) {
                    bench.before_instruction(spu, instruction);
                }
                ControlFlow::Continue(())
            };
            let stopped = spe.run_halting(self.at, look, |spu| {
                if let Some(arguments) = &arguments {
                    self.prepare(spu, arguments);
                }
            });
            if console.has_quit() {
                return End::Quit;
            }
            let Some(end) = self.after(stopped, bench) else {
                // The program's output is printed before the console's next result. Output that
                // can't be written is reported at the end.
                let _ = self.library.flush();
                continue;
            };
            match (&end, end.fault()) {
                (End::Exit(status), _) => console.ended(*status),
                (_, Some((what, at, _))) => {
                    let look = |spu: &mut Spu, halted: &Halted<'_>| {
                        console.after_fault(spu, store, halted, &what);
                        ControlFlow::Break(())
                    };
                    spe.run_halting(at, look, |_| ());
                }
                (_, None) => {}
            }
            return end;
        }
    }

    /// Writes what the program has printed.
    fn flush(&mut self) -> Result<(), Failure> {
        let flushed = self.library.flush();
        let flushed = flushed.map_err(|errno| io::Error::from_raw_os_error(errno.0));
        messages::unless_closed(flushed).map_err(Failure::file(Path::new("standard output")))
    }

    /// Runs the program until it stops, and obeys the debugger before each instruction.
    fn run_under(&mut self, thread: &Attached, bench: &mut Bench<'_>) -> Option<Stopped> {
        let arguments = self.arguments.take();
        let look = |spu: &mut Spu, cycles| {
            thread.before_instruction(spu, cycles)?;
            let word = self.local_store().load_word(spu.pc());
            if let Some(instruction) = Instruction::decode(word) {
                bench.before_instruction(spu, instruction);
            }
            ControlFlow::Continue(())
        };
        let stopped = self.spe.run_stepwise(self.at, look, |spu| {
            if let Some(arguments) = &arguments {
                self.prepare(spu, arguments);
            }
        });
        self.at =
            stopped.as_ref().map_or_else(|| self.spe.with_spu(Spu::pc), |stopped| stopped.npc);
        stopped
    }

    /// The SPU has stopped, or can continue. Carries out a library call. Returns how the program
    /// ended, if it did.
    fn after(&mut self, stopped: Option<Stopped>, bench: &mut Bench<'_>) -> Option<End> {
        self.spe.with_spu(|spu| bench.stopped(spu));
        if let Some((at, difference)) = self.spe.difference() {
            return Some(End::Differs(difference, at));
        }
        let Some(stopped) = stopped else {
            self.at = self.spe.with_spu(Spu::pc);
            return None;
        };
        match stopped.reason {
            Stop::Signal(code @ 0x2000..=0x20ff) => return Some(End::Exit(code as u8)),
            Stop::Signal(code @ 0x2100..=0x21ff) => {
                if let Err(error) = self.call(code as u8, stopped.npc, bench) {
                    return Some(End::Call(error, stopped.pc));
                }
                self.at = stopped.npc.wrapping_add(CALL_WORD) & LIMIT_MASK;
            }
            Stop::Requested => return Some(End::Asleep(stopped.pc, bench.why_asleep())),
            _ => return Some(End::Fault(stopped)),
        }
        None
    }

    /// Gives the registers their first values, if no instruction has run.
    fn start(&mut self) {
        if let Some(arguments) = self.arguments.take() {
            const NO_INSTRUCTIONS: u64 = 0;
            let prepare = |spu: &mut Spu| self.prepare(spu, &arguments);
            self.spe.run_observed(self.at, NO_INSTRUCTIONS, &mut (), prepare);
        }
    }

    fn call(&mut self, number: u8, address: u32, bench: &mut Bench<'_>) -> Result<(), CallError> {
        let name = if number == SYSTEM_CALL {
            system_call_number(self.local_store(), address).and_then(system_call_name)
        } else {
            let opcode = (self.local_store().load_word(address) >> 24) as u8;
            Class::of(number).and_then(|class| class.function(opcode))
        };
        bench.called(name.unwrap_or("unknown"));
        let spe = Arc::clone(&self.spe);
        self.library.serve(number, spe.local_store().as_ref(), address)
    }

    /// Writes the profile to a file, or which functions the cycles went to.
    fn write_profile(&self, path: Option<&Path>, simulation: &Simulation) -> Result<(), Failure> {
        let spes = simulation.profile().unwrap_or_default();
        let profile = ProfileFile::new(CYCLES_PER_SECOND, &spes);
        let Some(path) = path else {
            let code = Code::parse(&self.bytes)?;
            let view = View::new(&code, &self.bytes, &profile)?;
            return write_text(None, &view.functions_text());
        };
        write_file(path, json(&profile).as_bytes())
    }

    /// Writes the output that the options ask for at the end.
    pub fn dump(&self, options: &Options) -> Result<(), Failure> {
        if let Some(path) = &options.dump_ls {
            let mut bytes = vec![0; SIZE as usize];
            self.local_store().read(0, &mut bytes);
            write_file(path, &bytes)?;
        }
        if let Some(path) = &options.dump_regs {
            let text = self.spe.with_spu(registers);
            write_text(path.as_deref(), &text)?;
        }
        if let (Some(path), Some(simulation)) = (&options.timing, self.spe.simulation()) {
            let mut figures = Figures::default();
            for spe in &simulation.report().spes {
                figures.add(spe);
            }
            let text = if options.json { json(&figures) } else { figures.table() };
            write_text(path.as_deref(), &text)?;
        }
        if let (Some(path), Some(simulation)) = (&options.profile, self.spe.simulation()) {
            self.write_profile(path.as_deref(), simulation)?;
        }
        for file in &options.dump_mem {
            let mut bytes = vec![0; file.size.0];
            let read = self.memory.read(file.ea, &mut bytes);
            read.map_err(Failure::of(format_args!("--dump-mem {}", file.path.display())))?;
            write_file(&file.path, &bytes)?;
        }
        Ok(())
    }
}

/// Warns of each race between the program and its own DMA commands.
fn warn_of_races(simulation: &Simulation, bytes: &[u8]) {
    let bytes: Box<[u8]> = bytes.into();
    simulation.on_race(move |race| {
        let image = Image::parse(&bytes);
        let code = Code::parse(&bytes);
        let place = |address| {
            let place = match &image {
                Ok(image) => image.place(address),
                Err(_) => format!("{address:#07x}"),
            };
            let sources = code.as_ref().map_or_else(|_| Vec::new(), Code::sources);
            match sources.iter().find(|(at, _)| *at == address) {
                Some((_, source)) => format!("{place} ({}:{})", source.file.display(), source.line),
                None => place,
            }
        };
        messages::print!("spu: warning: DMA race: {}", race.describe(place));
    });
}

/// The program counter, the FPSCR, and the four words of each register.
fn registers(spu: &Spu) -> String {
    let mut text = format!("pc    {:#07x}\n", spu.pc());
    for (number, quad) in spu.registers.iter().enumerate() {
        let [a, b, c, d] = quad.0;
        text += &format!("${number:<4} {a:08x} {b:08x} {c:08x} {d:08x}\n");
    }
    text
}

impl End {
    /// gdb's number of the signal with which the program ends, if it fails.
    fn signal(&self) -> Option<u8> {
        const SIGABRT: u8 = 6;
        const SIGSYS: u8 = 12;
        match self {
            Self::Fault(stopped) => Some(signal_of(&stopped.reason).unwrap_or(SIGABRT)),
            Self::Call(..) => Some(SIGSYS),
            Self::Limit(_) | Self::Asleep(..) | Self::Differs(..) => Some(SIGABRT),
            Self::Exit(_) | Self::Killed(_) | Self::Quit => None,
        }
    }

    /// The error, its address, and the exit status for it.
    fn fault(&self) -> Option<(String, u32, Status)> {
        Some(match self {
            Self::Exit(_) | Self::Quit => return None,
            Self::Fault(stopped) => {
                (stopped.to_string(), stopped.pc, Status::from(&stopped.reason))
            }
            Self::Call(error, at) => (error.to_string(), *at, Status::UnknownStop),
            Self::Limit(at) => ("instruction limit reached".into(), *at, Status::Limit),
            Self::Differs(difference, at) => (difference.clone(), *at, Status::Differs),
            Self::Killed(at) => ("killed by the debugger".into(), *at, Status::Limit),
            Self::Asleep(at, why) => (format!("sleeps for ever: {why}"), *at, Status::Limit),
        })
    }

    /// The exit status.
    pub fn status(&self) -> ExitCode {
        match (self, self.fault()) {
            (Self::Exit(code), _) => (*code).into(),
            (_, Some((_, _, status))) => status.into(),
            (_, None) => ExitCode::SUCCESS,
        }
    }

    /// Reports a fault on standard error and returns the exit status.
    pub fn report(&self, image: &Image<'_>, store: &LocalStore) -> ExitCode {
        let Some((message, at, status)) = self.fault() else {
            return self.status();
        };
        let instruction = instruction_text(store.load_word(at), at);
        let place = image.place(at);
        messages::print!("spu: {message}\n     at {place}: {instruction}");
        status.into()
    }
}
