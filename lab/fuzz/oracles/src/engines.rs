//! Runs a program on both engines, the interpreter and compiled code, and compares them.
//!
//! The input is a sequence of choices. They make a small program that branches, loops, calls,
//! overwrites its own code, receives new code through its channels, enables interrupts and
//! computes with special floating-point numbers. Both engines run it in the same pieces. After
//! each piece, all state that a program can see must be the same.

use spu_emulator::channel::Channels;
use spu_emulator::compiled::{Runner, Translations};
use spu_emulator::float::fpscr::Fpscr;
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::local_store::{LocalStore, SIZE};
use spu_emulator::stop::{ChannelAccess, Stop};
use spu_isa::{Instruction, Op};

/// The number of words of code, from address 0.
const CODE_WORDS: u32 = 96;
/// The number of entries after which code is compiled.
const COMPILE_THRESHOLD: u16 = 2;
/// The number of instructions after which a program ends, over all pieces.
const INSTRUCTIONS: u64 = 6_000;

/// Words at the edges of numbers, counts and controls.
const EDGES: [u32; 24] = [
    0,
    1,
    2,
    31,
    32,
    0x80,
    0xffff,
    0x0001_0203,
    0x1011_1213,
    0x007f_ffff,
    0x0080_0000,
    0x0080_0001,
    0x3f80_0000,
    0x4f00_0000,
    0x7e80_0000,
    0x7f00_0000,
    0x7f7f_ffff,
    0x7f80_0000,
    0x7fff_ffff,
    0x8000_0000,
    0x8080_0000,
    0xbf80_0000,
    0xff7f_ffff,
    0xffff_ffff,
];

/// Reads choices from an input. After its end, the choices follow from the earlier ones.
struct Choices<'a> {
    rest: std::slice::Iter<'a, u8>,
    state: u32,
}

impl Choices<'_> {
    fn byte(&mut self) -> u32 {
        let byte = self.rest.next().map_or(0, |&byte| u32::from(byte));
        // A linear congruential generator. Its upper bits are used.
        self.state = (self.state ^ byte).wrapping_mul(0x915f_77f5).wrapping_add(0x3c6e_f35f);
        byte ^ self.state >> 24
    }

    fn below(&mut self, limit: u32) -> u32 {
        (self.byte() << 8 | self.byte()) % limit
    }

    fn word(&mut self) -> u32 {
        (0..4).fold(0, |word, _| word << 8 | self.byte())
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len() as u32) as usize]
    }

    /// One of few registers, so that instructions depend on each other.
    fn register(&mut self) -> u8 {
        2 + self.below(10) as u8
    }

    fn number(&mut self) -> u32 {
        match self.below(4) {
            0 => self.word(),
            1 => self.below(CODE_WORDS) * 4,
            2 => (100 + self.below(54)) << 23 | self.word() & 0x807f_ffff,
            _ => self.of(&EDGES),
        }
    }

    fn code(&mut self) -> u32 {
        const BRANCHES: [Op; 8] =
            [Op::Br, Op::Brz, Op::Brnz, Op::Brhz, Op::Brhnz, Op::Brsl, Op::Brnz, Op::Brz];
        const INDIRECT: [Op; 8] =
            [Op::Bi, Op::Bisl, Op::Biz, Op::Binz, Op::Bihz, Op::Bihnz, Op::Iret, Op::Bisled];
        const MEMORY: [Op; 8] =
            [Op::Lqd, Op::Stqd, Op::Lqx, Op::Stqx, Op::Lqa, Op::Stqa, Op::Lqr, Op::Stqr];
        const FLOATS: [Op; 17] = [
            Op::Fa,
            Op::Fs,
            Op::Fm,
            Op::Fma,
            Op::Fms,
            Op::Fnms,
            Op::Frest,
            Op::Frsqest,
            Op::Fi,
            Op::Fcgt,
            Op::Fcmeq,
            Op::Fscrrd,
            Op::Selb,
            Op::Dfa,
            Op::Dfma,
            Op::Fesd,
            Op::Frds,
        ];
        let rows = Op::rows();
        let op = match self.below(16) {
            0..=2 => self.of(&BRANCHES),
            3 => self.of(&INDIRECT),
            4..=5 => self.of(&MEMORY),
            6..=9 => self.of(&FLOATS),
            10 => self.of(&[Op::Wrch, Op::Rdch, Op::Ai, Op::Stqr]),
            11 if self.below(8) == 0 => return self.word(),
            _ => rows[self.below(rows.len() as u32) as usize].op,
        };
        let rest = self.word() & 0x1f_ffff;
        let Some(mut i) = Instruction::decode(u32::from(op.row().opcode) << 21 | rest) else {
            return 0;
        };
        if i.op != op {
            i.op = op;
        }
        (i.rt, i.ra, i.rb, i.rc) =
            (self.register(), self.register(), self.register(), self.register());
        match op {
            Op::Wrch | Op::Rdch => i.ra = self.below(3) as u8,
            Op::Br | Op::Brz | Op::Brnz | Op::Brhz | Op::Brhnz | Op::Brsl => {
                i.immediate = (self.below(24) as i32 - 14) * 4;
            }
            Op::Lqd | Op::Stqd => i.immediate = self.below(16) as i32 * 16,
            Op::Lqa | Op::Stqa => i.immediate = self.below(CODE_WORDS * 8) as i32,
            Op::Lqr | Op::Stqr => i.immediate = self.below(CODE_WORDS * 2) as i32,
            _ => {}
        }
        i.encode()
    }
}

/// Channels for the test. A write to channel 0 replaces a word of code; the value written chooses
/// the word. Channel 1 reads the number of writes. Every seventh query finds an interrupt.
#[derive(Clone)]
struct TestChannels<'a> {
    local_store: &'a LocalStore,
    written: u32,
    looks: u32,
    srr0: u32,
}

impl Channels for TestChannels<'_> {
    fn read(&mut self, channel: u8) -> Result<u32, Stop> {
        match channel {
            1 => Ok(self.written),
            _ => Err(Stop::InvalidChannel(channel, ChannelAccess::Read)),
        }
    }

    fn write(&mut self, channel: u8, value: u32) -> Result<(), Stop> {
        self.written = self.written.wrapping_add(1);
        if channel == 0 {
            let mut choices = Choices { rest: [].iter(), state: value % 16 };
            let code = choices.code().to_be_bytes();
            let address = choices.below(CODE_WORDS) * 4;
            self.local_store.write(address, &code);
        }
        Ok(())
    }

    fn count(&mut self, _: u8) -> Result<u32, Stop> {
        Ok(self.written & 1)
    }

    fn external_condition(&mut self) -> bool {
        self.looks += 1;
        self.looks.is_multiple_of(7)
    }

    fn srr0(&self) -> u32 {
        self.srr0
    }

    fn set_srr0(&mut self, address: u32) {
        self.srr0 = address;
    }
}

/// One engine's SPU with the program.
struct Side<'a> {
    spu: Spu,
    channels: TestChannels<'a>,
}

impl<'a> Side<'a> {
    fn new(input: &[u8], local_store: &'a LocalStore) -> Self {
        let mut choices = Choices { rest: input.iter(), state: 0 };
        for word in 0..CODE_WORDS {
            local_store.write(4 * word, &choices.code().to_be_bytes());
        }
        for word in 0..64 {
            local_store.write(0x1000 + 4 * word, &choices.number().to_be_bytes());
        }
        let mut spu = Spu::new();
        for register in 0..12 {
            let kind = choices.below(2);
            let one = choices.number();
            let lane = |_| if kind == 0 { one } else { choices.number() };
            spu.set_register(register, Quad(std::array::from_fn(lane)));
        }
        spu.fpscr = Fpscr::from_words([choices.number(), 0, choices.number(), 0]);
        let channels = TestChannels { local_store, written: 0, looks: 0, srr0: 0 };
        Self { spu, channels }
    }
}

fn bytes(local_store: &LocalStore) -> Vec<u8> {
    let mut bytes = vec![0; SIZE as usize];
    local_store.read(0, &mut bytes);
    bytes
}

/// Runs the program that the input chooses. Returns how many instructions ran, and how many of
/// them in compiled code.
///
/// # Panics
///
/// If the engines differ.
pub fn engines(input: &[u8]) -> (u64, u64) {
    let Some(translations) = Translations::new(false, false) else {
        return (0, 0);
    };
    let stores = [LocalStore::new(), LocalStore::new()];
    let [mut interpreted, mut compiled] = [0, 1].map(|n| Side::new(input, &stores[n]));
    translations.compile_after(COMPILE_THRESHOLD);
    if input.len().is_multiple_of(2) {
        translations.optimize_at_once();
    }
    let mut runner = Runner::new(&translations);
    let mut pieces = 0u32;
    while interpreted.spu.executed() < INSTRUCTIONS && pieces < 64 {
        let limit = 1 + u64::from(pieces.wrapping_mul(0x9e37_79b9) >> 22);
        let one = {
            let Side { spu, channels } = &mut interpreted;
            spu.run_limited(&stores[0], channels, limit)
        };
        let other = {
            let Side { spu, channels } = &mut compiled;
            runner.run(spu, &stores[1], channels, limit)
        };
        assert_eq!(one, other, "piece {pieces} of {limit}");
        let (a, b) = (&interpreted.spu, &compiled.spu);
        assert_eq!(a.executed(), b.executed(), "piece {pieces}");
        assert_eq!(a.pc(), b.pc(), "piece {pieces}");
        assert_eq!(a.interrupts_enabled(), b.interrupts_enabled(), "piece {pieces}");
        assert_eq!(a.fpscr.words(), b.fpscr.words(), "FPSCR, piece {pieces}");
        for register in 0..128 {
            let (a, b) = (a.register(register), b.register(register));
            assert_eq!(a, b, "${register}, piece {pieces}");
        }
        assert!(bytes(&stores[0]) == bytes(&stores[1]), "local store, piece {pieces}");
        if one.is_some() {
            // Continue at the next instruction, or at the start again.
            for side in [&mut interpreted, &mut compiled] {
                let next = if pieces.is_multiple_of(2) { side.spu.pc() + 4 } else { 0 };
                side.spu.set_pc(next % (4 * CODE_WORDS));
            }
        }
        pieces += 1;
    }
    (interpreted.spu.executed(), runner.compiled())
}
