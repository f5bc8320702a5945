//! `LIBSPE2_GDB`: two SPEs of one process as a debugger's threads. This is a separate program
//! without the test harness, because it runs itself again as a program on libspe2 with an
//! environment of its own.

#![allow(clippy::print_stdout, reason = "a test has nothing to lose but its output")]

use std::ffi::CString;
use std::io::{self, BufRead as _, BufReader, Write as _};
use std::os::unix::ffi::OsStrExt as _;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::ptr;
use std::thread;

use spe2::context::spe_context_create;
use spe2::image::{spe_image_open, spe_program_load};
use spe2::mailbox::spe_in_mbox_write;
use spe2::run::spe_context_run;
use spe2::types::{SPE_DEFAULT_ENTRY, SPE_MBOX_ALL_BLOCKING, SpeContext};
use spu_build::for_tests::build_source;
use spu_debugger::client::{Client, from_hex};

const SPES: usize = 2;
const PC: usize = 129;

/// gdb's numbers of signals.
const INTERRUPT: &str = "T02";
const TRAP: &str = "T05";

/// Adds its argument and 1, fetches its own first 16 bytes by DMA, then waits for a mail.
const PROGRAM: &str = "
        .text
        .global _start
_start: rotqbyi $3,$4,4
kernel: ai      $3,$3,1
        stqa    $3,0x8000
        ila     $10,0x9000
        wrch    $ch16,$10
        il      $11,0
        wrch    $ch17,$6
        rotqbyi $12,$6,4
        wrch    $ch18,$12
        il      $13,16
        wrch    $ch19,$13
        wrch    $ch20,$11
        il      $14,0x40
fetch:  wrch    $ch21,$14
        il      $15,1
        wrch    $ch22,$15
        il      $15,2
        wrch    $ch23,$15
        rdch    $16,$ch24
mail:   rdch    $17,$ch29
        stop    0x2005
";
/// Addresses of the program's labels.
const KERNEL: u32 = 4;
const FETCH: u32 = 4 * 13;
const MAIL: u32 = 4 * 19;

#[derive(Clone, Copy)]
struct Shared(*mut SpeContext);

// SAFETY: any thread may use a libspe2 context.
unsafe impl Send for Shared {}

fn run(context: Shared, argument: usize) {
    let mut entry = SPE_DEFAULT_ENTRY;
    let argument = ptr::without_provenance_mut(argument);
    // SAFETY: the context lives to the end of the process, and `entry` can be written.
    let result = unsafe {
        let (none, info) = (ptr::null_mut(), ptr::null_mut());
        spe_context_run(context.0, &raw mut entry, 0, argument, none, info)
    };
    assert_eq!(result, 0, "{}", io::Error::last_os_error());
}

/// The program on libspe2: two SPEs, which get a mail each when a line comes on standard input.
fn program(image: &str) {
    let name = CString::new(image).unwrap();
    // SAFETY: the name is a C string; everything below receives what was just created.
    unsafe {
        let image = spe_image_open(name.as_ptr());
        assert!(!image.is_null(), "{}", io::Error::last_os_error());
        let contexts = [(); SPES].map(|()| {
            let context = Shared(spe_context_create(0, ptr::null_mut()));
            assert!(!context.0.is_null(), "{}", io::Error::last_os_error());
            assert_eq!(spe_program_load(context.0, image), 0);
            context
        });
        let runs = contexts.map(|context| {
            let argument = if context.0 == contexts[0].0 { 100 } else { 200 };
            thread::spawn(move || {
                let context = context;
                run(context, argument);
            })
        });
        io::stdin().read_line(&mut String::new()).unwrap();
        for context in contexts {
            let mut word = 0;
            let written = spe_in_mbox_write(context.0, &raw mut word, 1, SPE_MBOX_ALL_BLOCKING);
            assert_eq!(written, 1);
        }
        for run in runs {
            run.join().unwrap();
        }
    }
}

/// The program, and the debugger's connection to it.
struct Session {
    program: Child,
    client: Client,
}

impl Session {
    fn new(image: &Path, timing: &str) -> Self {
        let mut program = Command::new(std::env::current_exe().unwrap())
            .arg("run")
            .arg(image)
            .env("LIBSPE2_GDB", "0")
            .env("LIBSPE2_TIMING", timing)
            .stdin(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        let mut said = BufReader::new(program.stderr.take().unwrap());
        said.read_line(&mut line).unwrap();
        assert!(line.starts_with("libspe2: waiting for a debugger: target remote 127.0.0.1:"));
        let address = line.trim().rsplit(' ').next().unwrap();
        let client = Client::connect(address).unwrap();
        Self { program, client }
    }

    fn ask(&mut self, packet: &str) -> String {
        self.client.ask(packet).unwrap()
    }

    /// Lets the program run by `packet`. Returns the stop's packet and its thread.
    fn halt(&mut self, packet: &str, signal: &str) -> (String, usize) {
        self.client.send(packet).unwrap();
        self.halted(signal)
    }

    fn halted(&mut self, signal: &str) -> (String, usize) {
        let stop = self.client.receive().unwrap();
        assert!(stop.starts_with(signal), "{stop}");
        let thread = stop.split("thread:").nth(1).unwrap();
        let thread = thread.split(';').next().unwrap();
        let number = usize::from_str_radix(thread, 16).unwrap();
        (stop, number)
    }

    fn register(&mut self, thread: usize, number: usize) -> u32 {
        assert_eq!(self.ask(&format!("Hg{thread:x}")), "OK");
        self.client.register(number).unwrap()
    }

    fn pc(&mut self, thread: usize) -> u32 {
        self.register(thread, PC)
    }

    /// Lets both threads halt for this reason and at this address. The first one stays there.
    fn both_halt(&mut self, reason: &str, address: u32) {
        let (stop, first) = self.halt("vCont;c", TRAP);
        assert!(stop.contains(reason), "{stop}");
        let other = SPES + 1 - first;
        let (stop, second) = self.halt(&format!("vCont;c:{other}"), TRAP);
        assert!(stop.contains(reason), "{stop}");
        assert_eq!(second, other);
        assert_eq!([1, 2].map(|thread| self.pc(thread)), [address; SPES]);
    }

    fn both_break_at(&mut self, address: u32) {
        assert_eq!(self.ask(&format!("Z0,{address:x},4")), "OK");
        self.both_halt("swbreak", address);
        assert_eq!(self.ask(&format!("z0,{address:x},4")), "OK");
    }
}

/// Breaks at the kernel in both SPEs, reads their registers, watches a store, steps over a DMA,
/// interrupts both while they sleep, and lets them end.
fn two_spes(image: &Path, timing: &str) {
    let mut gdb = Session::new(image, timing);
    gdb.halt("?", TRAP);
    assert_eq!(gdb.ask("qfThreadInfo"), "m01,02");
    gdb.both_break_at(KERNEL);
    assert_eq!([1, 2].map(|thread| gdb.register(thread, 3)), [100, 200]);

    // One steps, and the other stays.
    let (_, thread) = gdb.halt("vCont;s:2", TRAP);
    assert_eq!(thread, 2);
    assert_eq!([1, 2].map(|thread| gdb.pc(thread)), [KERNEL, KERNEL + 4]);
    assert_eq!([1, 2].map(|thread| gdb.register(thread, 3)), [100, 201]);

    // Each stores to its own local store.
    assert_eq!(gdb.ask("Z2,8000,4"), "OK");
    gdb.both_halt("watch:8000", KERNEL + 8);
    let stored = [1, 2].map(|thread| {
        gdb.pc(thread);
        gdb.ask("m8000,4")
    });
    assert_eq!(stored, ["00000065", "000000c9"]);
    assert_eq!(gdb.ask("z2,8000,4"), "OK");

    gdb.both_break_at(FETCH);
    let clocks = gdb.client.monitor("cycles").unwrap();
    let counted = clocks.lines().filter(|line| {
        let clock = line.split(": ").nth(1).unwrap();
        clock.parse::<u64>().is_ok_and(|clock| clock > 0)
    });
    assert_eq!(clocks.lines().count(), SPES, "{clocks}");
    assert_eq!(counted.count(), if timing == "1" { SPES } else { 0 });
    assert_eq!(gdb.pc(1), FETCH);
    assert_eq!(gdb.ask("m9000,4"), "00000000");
    let (_, thread) = gdb.halt("vCont;s:1;c", TRAP);
    assert_eq!((thread, gdb.pc(1)), (1, FETCH + 4));
    assert_eq!(gdb.ask("m9000,10"), gdb.ask("m0,10"));

    // Both sleep, and an interrupt shows where. It may come before they do.
    let asleep = |gdb: &mut Session, thread: usize| {
        let what = from_hex(&gdb.ask(&format!("qThreadExtraInfo,{thread}")));
        what == format!("SPE {thread}: waits in rdch")
    };
    while ![1, 2].iter().all(|&thread| asleep(&mut gdb, thread)) {
        gdb.client.send("vCont;c").unwrap();
        gdb.client.interrupt().unwrap();
        gdb.halted(INTERRUPT);
    }
    assert_eq!([1, 2].map(|thread| gdb.pc(thread)), [MAIL, MAIL]);
    gdb.client.send("vCont;c").unwrap();
    gdb.program.stdin.take().unwrap().write_all(b"\n").unwrap();
    assert!(gdb.client.receive().is_err(), "the connection ends");
    assert!(gdb.program.wait().unwrap().success());
}

/// The debugger's command `kill` ends the process.
fn a_process_is_killed(image: &Path) {
    let mut gdb = Session::new(image, "0");
    gdb.halt("?", TRAP);
    gdb.client.send("k").unwrap();
    let status = gdb.program.wait().unwrap();
    let signal = std::os::unix::process::ExitStatusExt::signal(&status);
    assert_eq!(signal, Some(libc::SIGKILL));
}

/// A debugger that leaves lets the process run.
fn a_debugger_leaves(image: &Path) {
    let mut gdb = Session::new(image, "0");
    gdb.both_break_at(KERNEL);
    assert_eq!(gdb.ask("D"), "OK");
    gdb.program.stdin.take().unwrap().write_all(b"\n").unwrap();
    assert!(gdb.program.wait().unwrap().success());
}

/// Creating a context in this environment fails with a message that names the variable.
fn refused(environment: &[(&str, &str)], message: &str) {
    let output = Command::new(std::env::current_exe().unwrap())
        .arg("create")
        .envs(environment.iter().copied())
        .output()
        .unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(stderr.starts_with("libspe2: "), "{stderr}");
    assert!(stderr.contains(message), "{stderr}");
    assert!(output.status.success(), "{stderr}");
}

fn main() {
    let arguments: Vec<_> = std::env::args_os().collect();
    match arguments.get(1).and_then(|mode| mode.to_str()) {
        Some("run") => return program(std::str::from_utf8(arguments[2].as_bytes()).unwrap()),
        Some("create") => {
            // SAFETY: a context needs no gang.
            let context = unsafe { spe_context_create(0, ptr::null_mut()) };
            assert!(context.is_null());
            return;
        }
        _ => {}
    }
    let folder = tempfile::tempdir().unwrap();
    let image = build_source(PROGRAM, "program", folder.path(), &[]);
    two_spes(&image, "0");
    two_spes(&image, "1");
    a_process_is_killed(&image);
    a_debugger_leaves(&image);
    refused(&[("LIBSPE2_GDB", "x")], "LIBSPE2_GDB is a port");
    refused(&[("LIBSPE2_GDB", "65536")], "LIBSPE2_GDB is a port");
    let both = [("LIBSPE2_GDB", "0"), ("LIBSPE2_BACKEND", "spufs")];
    refused(&both, "LIBSPE2_GDB");
    let taken = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    refused(&[("LIBSPE2_GDB", &port)], "LIBSPE2_GDB=");
    println!("debugger: ok");
}
