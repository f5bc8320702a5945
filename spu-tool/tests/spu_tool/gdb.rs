//! The debugger's server, with a client that speaks gdb's remote protocol.

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use super::support::Bench;

/// gdb's numbers of signals.
const INTERRUPT: u8 = 2;
const ILLEGAL_INSTRUCTION: u8 = 4;
const TRAP: u8 = 5;

/// A program that waits for its debugger, and the connection to it.
struct Session {
    spu: Child,
    stream: TcpStream,
}

impl Session {
    fn new(options: &[&str], program: &Path) -> Self {
        let mut spu = Command::new(env!("CARGO_BIN_EXE_spu"))
            .args(["run", "--gdb", "0"])
            .args(options)
            .arg(program)
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        let mut said = BufReader::new(spu.stderr.take().unwrap());
        said.read_line(&mut line).unwrap();
        let address = line.trim().rsplit(' ').next().unwrap();
        let stream = TcpStream::connect(address).unwrap();
        let patience = Some(Duration::from_secs(60));
        stream.set_read_timeout(patience).unwrap();
        Self { spu, stream }
    }

    fn send(&mut self, packet: &str) {
        let sum = packet.bytes().fold(0_u8, u8::wrapping_add);
        write!(self.stream, "${packet}#{sum:02x}").unwrap();
    }

    fn byte(&mut self) -> u8 {
        let mut byte = [0];
        self.stream.read_exact(&mut byte).unwrap();
        byte[0]
    }

    /// The next packet, which is acknowledged. A character before `*` is repeated as often as the
    /// character behind it says.
    fn receive(&mut self) -> String {
        const NO_TIMES: u8 = 29;
        while self.byte() != b'$' {}
        let mut packet = String::new();
        loop {
            match self.byte() {
                b'#' => break,
                b'*' => {
                    let last = packet.chars().next_back().unwrap();
                    let times = self.byte() - NO_TIMES;
                    packet.extend(std::iter::repeat_n(last, times.into()));
                }
                byte => packet.push(byte as char),
            }
        }
        let _sum = [self.byte(), self.byte()];
        self.stream.write_all(b"+").unwrap();
        packet
    }

    /// Lets the program run by `packet`, and returns the signal with which it halts.
    fn halt(&mut self, packet: &str) -> u8 {
        self.send(packet);
        self.halted()
    }

    fn halted(&mut self) -> u8 {
        let packet = self.receive();
        assert!(packet.starts_with(['S', 'T']), "{packet}");
        u8::from_str_radix(&packet[1..3], 16).unwrap()
    }

    fn ask(&mut self, packet: &str) -> String {
        self.send(packet);
        self.receive()
    }

    /// The first word of a register, or the program counter as register 129.
    fn register(&mut self, number: usize) -> u32 {
        let all = self.ask("g");
        let at = if number < 128 {
            number * 32
        } else {
            128 * 32 + 8
        };
        u32::from_str_radix(&all[at..at + 8], 16).unwrap()
    }

    fn pc(&mut self) -> u32 {
        self.register(129)
    }

    /// The exit status.
    fn end(mut self) -> i32 {
        drop(self.stream);
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
    gdb.send("qRcmd,6379636c6573");
    assert!(gdb.receive().starts_with('O'));
    assert_eq!(gdb.receive(), "OK");
    assert_eq!(gdb.ask("c"), "W00");
    assert_eq!(gdb.end(), 0);

    let mut gdb = Session::new(&["--timing=figures"], &program);
    assert_eq!(gdb.halt("s"), TRAP);
    gdb.send("qRcmd,6379636c6573");
    let cycles = gdb.receive();
    // `O`, digits of the clock and a line end, in hexadecimal.
    assert!(cycles.starts_with("O3"), "{cycles}");
    assert_eq!(gdb.receive(), "OK");
    gdb.send("k");
    assert_eq!(gdb.end(), 125);
}

#[test]
fn a_loop_is_interrupted_and_a_fault_can_be_looked_at() {
    let bench = Bench::new();
    let endless = bench.instructions("        br      _start");
    let mut gdb = Session::new(&[], &endless);
    gdb.send("c");
    gdb.stream.write_all(&[3]).unwrap();
    assert_eq!(gdb.halted(), INTERRUPT);
    gdb.send("k");
    assert_eq!(gdb.end(), 125);

    let invalid = bench.instructions("        il      $3,9\n        .long   0x00800000");
    let mut gdb = Session::new(&[], &invalid);
    assert_eq!(gdb.halt("c"), ILLEGAL_INSTRUCTION);
    assert_eq!(gdb.register(3), 9);
    assert_eq!(gdb.ask("c"), "X04");
    assert_eq!(gdb.end(), 121);
}
