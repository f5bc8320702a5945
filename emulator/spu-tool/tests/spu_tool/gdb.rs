//! The debugger's server, with a client that speaks gdb's remote protocol.

use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use spu_debugger::client::{Client, from_hex};

use super::support::Bench;

/// gdb's numbers of signals.
const INTERRUPT: u8 = 2;
const ILLEGAL_INSTRUCTION: u8 = 4;
const TRAP: u8 = 5;

const PC: usize = 129;

/// A program that waits for its debugger, and the connection to it.
struct Session {
    spu: Child,
    client: Client,
}

impl Session {
    fn new(options: &[&str], program: &Path) -> Self {
        let mut spu = Command::new(env!("CARGO_BIN_EXE_spu"))
            .args(["run", "--gdb", "0"])
            .args(options)
            .arg(program)
            .current_dir(program.parent().unwrap())
            .stdin(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        let mut said = BufReader::new(spu.stderr.take().unwrap());
        said.read_line(&mut line).unwrap();
        let address = line.trim().rsplit(' ').next().unwrap();
        let client = Client::connect(address).unwrap();
        Self { spu, client }
    }

    fn ask(&mut self, packet: &str) -> String {
        self.client.ask(packet).unwrap()
    }

    /// Lets the program run by `packet`, and returns the signal with which it halts.
    fn halt(&mut self, packet: &str) -> u8 {
        self.client.send(packet).unwrap();
        self.halted()
    }

    fn halted(&mut self) -> u8 {
        let packet = self.client.receive().unwrap();
        assert!(packet.starts_with(['S', 'T']), "{packet}");
        u8::from_str_radix(&packet[1..3], 16).unwrap()
    }

    fn interrupt(&mut self) {
        self.client.send("c").unwrap();
        self.client.interrupt().unwrap();
        assert_eq!(self.halted(), INTERRUPT);
    }

    fn register(&mut self, number: usize) -> u32 {
        self.client.register(number).unwrap()
    }

    fn pc(&mut self) -> u32 {
        self.register(PC)
    }

    /// Kills the program, and checks that it ends with this status.
    fn kill(mut self) {
        self.client.send("k").unwrap();
        assert_eq!(self.end(), 125);
    }

    /// The exit status.
    fn end(mut self) -> i32 {
        drop(self.client);
        self.spu.wait().unwrap().code().unwrap()
    }
}

#[test]
fn breakpoints_watchpoints_and_registers() {
    let bench = Bench::new();
    let program = bench.instructions(
        "        il      $3,5
        il      $4,7
        a       $5,$3,$4
        stqa    $5,0x8000
        nop
        stop    0x2003",
    );
    let mut gdb = Session::new(&[], &program);
    assert_eq!(gdb.halt("?"), TRAP);
    let description = gdb.ask("qXfer:features:read:target.xml:0,200");
    assert!(description.contains("spu:256K"), "{description}");
    assert_eq!(gdb.register(1), 0x3fff0);
    assert_eq!(gdb.ask("Z0,8,4"), "OK");
    assert_eq!(gdb.halt("c"), TRAP);
    assert_eq!((gdb.pc(), gdb.register(3), gdb.register(4)), (8, 5, 7));
    // $3 becomes 0x105.
    let mut all = gdb.ask("g");
    all.replace_range(3 * 32..3 * 32 + 8, "00000105");
    assert_eq!(gdb.ask(&format!("G{all}")), "OK");
    assert_eq!(gdb.ask("z0,8,4"), "OK");
    assert_eq!(gdb.ask("Z2,8000,4"), "OK");
    let stop = gdb.ask("c");
    assert!(stop.contains("watch:8000"), "{stop}");
    assert_eq!(gdb.pc(), 16);
    assert_eq!(gdb.ask("m8000,4"), "0000010c");
    assert_eq!(gdb.ask("M8000,2:abcd"), "OK");
    assert_eq!(gdb.ask("m8000,4"), "abcd010c");
    assert!(gdb.ask("m3fffc,8").len() == 8, "only what there is");
    assert!(gdb.ask("m40000,4").starts_with('E'));
    assert_eq!(gdb.halt("s"), TRAP);
    assert_eq!(gdb.pc(), 20);
    assert_eq!(gdb.ask("c"), "W03");
    assert_eq!(gdb.end(), 3);
}

#[test]
fn a_transfer_is_stepped_over_and_the_clock_is_shown() {
    let bench = Bench::new();
    // Fetches its own first instructions, from the effective address of local store.
    let program = bench.instructions(
        "        ila     $10,0x9000
        wrch    $ch16,$10
        il      $11,0
        wrch    $ch17,$11
        rotqbyi $12,$6,4
        wrch    $ch18,$12
        il      $13,16
        wrch    $ch19,$13
        wrch    $ch20,$11
        il      $14,0x40
        wrch    $ch21,$14
        stop    0x2000",
    );
    let mut gdb = Session::new(&[], &program);
    assert_eq!(gdb.ask("Z0,28,4"), "OK");
    assert_eq!(gdb.halt("c"), TRAP);
    assert_eq!(gdb.ask("m9000,4"), "00000000");
    assert_eq!(gdb.halt("s"), TRAP);
    assert_eq!(gdb.pc(), 0x2c);
    assert_eq!(gdb.ask("m9000,10"), gdb.ask("m0,10"));
    let none = gdb.client.monitor("cycles").unwrap();
    assert!(none.contains("in simulated time"), "{none}");
    assert_eq!(gdb.ask("c"), "W00");
    assert_eq!(gdb.end(), 0);

    let mut gdb = Session::new(&["--timing=figures"], &program);
    let mut clocks = [0, 0].map(|_: u64| {
        assert_eq!(gdb.halt("s"), TRAP);
        let text = gdb.client.monitor("cycles").unwrap();
        let clock = text.strip_prefix("SPE 1: ").unwrap();
        clock.trim().parse::<u64>().unwrap()
    });
    clocks.sort_unstable();
    // An instruction takes its own cycles and nothing else.
    let step = clocks[1] - clocks[0];
    assert!((1..40).contains(&step), "{clocks:?}");
    gdb.kill();
}

#[test]
fn a_debugger_takes_no_simulated_time() {
    let bench = Bench::new();
    let program = bench.program("dma");
    let path = bench.path("figures");
    let option = format!("--timing={}", path.display());
    let options = [&option, "--main-memory", "4K@0x60000000", "--arg", "0x60000000:64"];
    bench.run(&options, &program, 0);
    let figures = bench.read("figures");
    let mut gdb = Session::new(&options, &program);
    for _ in 0..5 {
        assert_eq!(gdb.halt("s"), TRAP);
    }
    assert_eq!(gdb.ask("c"), "W00");
    assert_eq!(gdb.end(), 0);
    assert_eq!(bench.read("figures"), figures);
}

#[test]
fn a_loop_is_interrupted_and_a_fault_can_be_looked_at() {
    let bench = Bench::new();
    let endless = bench.instructions("        br      _start");
    let mut gdb = Session::new(&[], &endless);
    gdb.interrupt();
    gdb.kill();

    let invalid = bench.instructions("        il      $3,9\n        .long   0x00800000");
    let mut gdb = Session::new(&[], &invalid);
    assert_eq!(gdb.halt("c"), ILLEGAL_INSTRUCTION);
    assert_eq!(gdb.register(3), 9);
    assert_eq!(gdb.ask("c"), "X04");
    assert_eq!(gdb.end(), 121);
}

#[test]
fn a_program_that_sleeps_is_interrupted() {
    let bench = Bench::new();
    // It waits for a mail, or for a tag whose status it has not asked for.
    for (channel, options) in [(29, &[][..]), (24, &[]), (24, &["--timing=figures"])] {
        let program = bench.instructions(&format!("        nop\n        rdch    $3,$ch{channel}"));
        let mut gdb = Session::new(options, &program);
        assert_eq!(gdb.halt("s"), TRAP);
        // The first interrupt may come before the program has gone on.
        let mut what = String::new();
        while what != "SPE 1: waits in rdch" {
            gdb.interrupt();
            what = from_hex(&gdb.ask("qThreadExtraInfo,1"));
            assert!(what.starts_with("SPE 1"), "{what}");
        }
        assert_eq!(gdb.pc(), 4);
        // It is in the middle of an instruction.
        let all = gdb.ask("g");
        assert!(gdb.ask(&format!("G{all}")).starts_with('E'));
        gdb.interrupt();
        gdb.kill();
    }
}

/// The call is the PPE's, and may last for ever.
#[test]
fn a_program_in_a_library_call_is_interrupted() {
    let bench = Bench::new();
    let program = bench.program("sum");
    let mut gdb = Session::new(&[], &program);
    let mut what = String::new();
    while what != "SPE 1: waits in stop" {
        gdb.interrupt();
        what = from_hex(&gdb.ask("qThreadExtraInfo,1"));
        assert!(what.starts_with("SPE 1"), "{what}");
    }
    gdb.kill();
}

#[test]
fn reads_are_watched() {
    let bench = Bench::new();
    let program = bench.instructions(
        "        il      $3,5
        lqa     $4,0x8010
        lqa     $4,0x8000
        stqa    $3,0x8000
        il      $5,0
        stqa    $5,0x9000
        wrch    $ch17,$5
        ila     $6,0x8000
        wrch    $ch16,$6
        wrch    $ch18,$5
        il      $7,16
        wrch    $ch19,$7
        wrch    $ch20,$5
        il      $8,0x20
        wrch    $ch21,$8
        stop    0x2000",
    );
    // Both a load and a put.
    let mut gdb = Session::new(&["--main-memory", "4K@0"], &program);
    assert_eq!(gdb.ask("Z3,8004,4"), "OK");
    let stop = gdb.ask("c");
    assert!(stop.contains("rwatch:8004"), "{stop}");
    assert_eq!(gdb.pc(), 12);
    let stop = gdb.ask("c");
    assert!(stop.contains("rwatch:8004"), "{stop}");
    assert_eq!(gdb.pc(), 60);
    assert_eq!(gdb.ask("z3,8004,4"), "OK");
    assert_eq!(gdb.ask("c"), "W00");
    assert_eq!(gdb.end(), 0);
    // A store, too, even one that changes nothing.
    let mut gdb = Session::new(&["--main-memory", "4K@0"], &program);
    assert_eq!(gdb.ask("Z4,9000,10"), "OK");
    let stop = gdb.ask("c");
    assert!(stop.contains("awatch:9000"), "{stop}");
    assert_eq!(gdb.pc(), 24);
    gdb.kill();
}

#[test]
fn a_debugger_may_leave_and_another_may_come() {
    let bench = Bench::new();
    let endless = bench.instructions("        ai      $3,$3,1\n        br      _start");
    let mut gdb = Session::new(&[], &endless);
    assert_eq!(gdb.ask("Z0,4,4"), "OK");
    assert_eq!(gdb.halt("c"), TRAP);
    let address = gdb.client.address().unwrap();
    assert_eq!(gdb.ask("D"), "OK");
    gdb.client = Client::connect(&address).unwrap();
    assert_eq!(gdb.halt("?"), TRAP);
    // The breakpoint went with the debugger that set it.
    gdb.interrupt();
    gdb.kill();
}
