//! Compares memoised timing with the definition, which goes instruction by instruction. For any
//! program, clock, account, waits and profile must be the same.

use std::sync::Mutex;

use crate::prelude::*;
use proptest::prelude::*;
use spu_emulator::engine::Engine;
use spu_emulator::machine::Machine;
use spu_emulator::profile::SpeProfile;
use spu_emulator::simulated::{Race, Report};
use spu_isa::feature;
use spu_isa::timing::Rules;

/// Main memory: quadwords of code for `GET`.
const MEMORY_EA: u64 = 0x10_0000;
/// The same quadwords in local store.
const CODE_QUADS: u32 = 0x8000;
/// The area that loads and stores of data access.
const DATA: u32 = 0x9000;
const QUADS: usize = 8;
/// The registers that hold addresses in the program. No instruction writes them.
const PLACES: u8 = 100;
const PLACE_COUNT: u8 = 8;
/// The registers in which instructions compute.
const REGISTERS: u8 = 12;
const STOPS: usize = 12;
const MOST: u64 = 1500;
/// So often the SPU comes to a place before it is compiled: these programs are short.
const HOT: u16 = 3;

fn word(op: Op, rt: u8, [ra, rb, rc]: [u8; 3], immediate: i32) -> u32 {
    Instruction::new(op, [rt, ra, rb, rc], immediate).encode()
}

/// A piece of a program. It is entered only at its start.
#[derive(Clone, Debug)]
enum Piece {
    Plain(Op, [u8; 4]),
    /// A load or a store of data.
    Data(Op, u8, u8),
    /// A branch to another piece.
    Branch(Op, u8, usize),
    /// A branch to the piece whose address is in a register, with feature bits.
    Indirect(Op, u8, u8, i32),
    /// A hint for the branch this many instructions ahead, to a piece or to the address in a
    /// register.
    Hint(u8, usize, bool),
    Read(u8, u8),
    Write(u8, u8),
    Count(u8, u8),
    /// A quadword that other pieces overwrite.
    Patch,
    /// Copies a quadword of code into a patch, with a store or with the MFC.
    Rewrite(usize, usize, bool),
    Stop,
    Invalid,
}

fn piece() -> impl Strategy<Value = Piece> {
    use Op::*;
    let register = || 0..REGISTERS;
    let registers = || prop::array::uniform4(register());
    let plain = vec![
        A, Ai, Fa, Fma, Fi, Dfa, Shufb, Shl, Mpy, Rotqby, Nop, Lnop, Sync, Dsync, Cflts, Orbi,
        Selb, Heq,
    ];
    let branches = vec![Br, Brz, Brnz, Brsl, Brhz, Brhnz];
    let indirect = vec![Bi, Biz, Binz, Bisl, Bisled];
    prop_oneof![
        24 => (prop::sample::select(plain), registers()).prop_map(|(op, r)| Piece::Plain(op, r)),
        4 => (prop::sample::select(vec![Lqa, Stqa]), register(), 0..16_u8)
            .prop_map(|(op, rt, at)| Piece::Data(op, rt, at)),
        5 => (prop::sample::select(branches), register(), any::<usize>())
            .prop_map(|(op, rt, to)| Piece::Branch(op, rt, to)),
        2 => (prop::sample::select(indirect), register(), 0..PLACE_COUNT, 0..3)
            .prop_map(|(op, rt, to, bits)| Piece::Indirect(op, rt, to, bits)),
        4 => (1..30_u8, any::<usize>(), any::<bool>())
            .prop_map(|(on, to, named)| Piece::Hint(on, to, named)),
        1 => (register(), prop::sample::select(vec![8, 11, 12, 13, 15]))
            .prop_map(|(rt, channel)| Piece::Read(rt, channel)),
        2 => (register(), prop::sample::select(vec![1, 1, 2, 7, 7, 16, 18, 22]))
            .prop_map(|(rt, channel)| Piece::Write(rt, channel)),
        1 => (register(), prop::sample::select(vec![0, 21, 24, 29]))
            .prop_map(|(rt, channel)| Piece::Count(rt, channel)),
        2 => Just(Piece::Patch),
        2 => (any::<usize>(), 0..QUADS, any::<bool>())
            .prop_map(|(to, from, dma)| Piece::Rewrite(to, from, dma)),
        1 => Just(Piece::Stop),
        1 => Just(Piece::Invalid),
    ]
}

impl Piece {
    /// Number of words, including those that pad it to a quadword's start.
    fn length(&self, at: usize) -> usize {
        match self {
            Self::Patch => (4 - at % 4) % 4 + 4,
            Self::Rewrite(_, _, false) => 2,
            Self::Rewrite(_, _, true) => 12 + 6,
            Self::Hint(_, _, true) => 2,
            _ => 1,
        }
    }

    /// Appends the piece's words. `starts` are the addresses of all pieces, `patches` those of the
    /// quadwords that are overwritten.
    fn write(&self, code: &mut Vec<u32>, starts: &[u32], patches: &[u32]) {
        let here = 4 * code.len() as u32;
        let start = |to: usize| starts[to % starts.len()];
        let distance = |to: usize| start(to) as i32 - here as i32;
        let load = |register, value| word(Op::Ila, register, [0; 3], value);
        match *self {
            Self::Plain(op, [rt, ra, rb, rc]) => code.push(word(op, rt, [ra, rb, rc], 1)),
            Self::Data(op, rt, at) => {
                let address = DATA + 16 * u32::from(at);
                code.push(word(op, rt, [0; 3], address as i32));
            }
            Self::Branch(op, rt, to) => code.push(word(op, rt, [0; 3], distance(to))),
            Self::Indirect(op, rt, to, bits) => {
                code.push(word(op, rt, [PLACES + to, 0, 0], bits));
            }
            Self::Hint(on, to, named) => {
                let (op, immediate) = if named { (Op::Hbr, 0) } else { (Op::Hbrr, distance(to)) };
                let hint = Instruction::new(op, [0, 50, 0, 0], immediate);
                let hint = Instruction { branch_distance: 4 * i16::from(on), ..hint };
                if named {
                    code.push(load(50, start(to) as i32));
                }
                code.push(hint.encode());
            }
            Self::Read(rt, channel) => code.push(word(Op::Rdch, rt, [channel, 0, 0], 0)),
            Self::Write(rt, channel) => code.push(word(Op::Wrch, rt, [channel, 0, 0], 0)),
            Self::Count(rt, channel) => code.push(word(Op::Rchcnt, rt, [channel, 0, 0], 0)),
            Self::Patch => {
                while !code.len().is_multiple_of(4) {
                    code.push(word(Op::Nop, 0, [0; 3], 0));
                }
                code.extend([word(Op::Ai, 1, [1, 0, 0], 1); 4]);
            }
            Self::Rewrite(to, from, dma) => {
                let to = patches.get(to % patches.len().max(1)).copied();
                let to = to.unwrap_or(DATA) as i32;
                let from = 16 * from as i32;
                if dma {
                    let ea = (MEMORY_EA as i32) + from;
                    // Parameters and command, then the wait for the tag.
                    let mut write = |channel, value: i32| {
                        let wide = [
                            word(Op::Ilhu, 60, [0; 3], value >> 16),
                            word(Op::Iohl, 60, [0; 3], value & 0xffff),
                        ];
                        let narrow = [load(60, value)];
                        let set: &[u32] = if channel == 18 { &wide } else { &narrow };
                        code.extend(set);
                        code.push(word(Op::Wrch, 60, [channel, 0, 0], 0));
                    };
                    write(16, to);
                    write(18, ea);
                    write(19, 16);
                    write(20, 3);
                    write(21, 0x40);
                    write(22, 8);
                    write(23, 2);
                    code.push(word(Op::Rdch, 61, [24, 0, 0], 0));
                    code.push(word(Op::Lnop, 0, [0; 3], 0));
                    code.push(word(Op::Nop, 0, [0; 3], 0));
                } else {
                    let source = CODE_QUADS as i32 + from;
                    code.push(word(Op::Lqa, 60, [0; 3], source));
                    code.push(word(Op::Stqa, 60, [0; 3], to));
                }
            }
            Self::Stop => code.push(word(Op::Stop, 0, [0; 3], 5)),
            Self::Invalid => code.push(0xffff_ffff),
        }
    }
}

/// The program, and the addresses of its pieces. The interrupt handler is at 0.
fn program(pieces: &[Piece]) -> (Vec<u32>, Vec<u32>) {
    let handler = [
        word(Op::Il, 62, [0; 3], 0x20),
        word(Op::Wrch, 62, [2, 0, 0], 0),
        word(Op::Ila, 62, [0; 3], 3),
        word(Op::Wrch, 62, [7, 0, 0], 0),
        word(Op::Iret, 0, [0; 3], feature::ENABLE),
        word(Op::Lnop, 0, [0; 3], 0),
    ];
    let (mut starts, mut patches) = (Vec::new(), Vec::new());
    let mut at = handler.len();
    for piece in pieces {
        starts.push(4 * at as u32);
        at += piece.length(at);
        if matches!(piece, Piece::Patch) {
            patches.push(4 * (at as u32 - 4));
        }
    }
    let mut code = handler.to_vec();
    for (piece, &start) in pieces.iter().zip(&starts) {
        assert_eq!(4 * code.len() as u32, start, "{piece:?}");
        piece.write(&mut code, &starts, &patches);
    }
    code.push(word(Op::Br, 0, [0; 3], starts[0] as i32 - 4 * code.len() as i32));
    (code, starts)
}

/// Everything that can be observed of a run.
#[derive(Debug, PartialEq)]
struct Seen {
    ends: Vec<(Option<Stop>, u32)>,
    registers: [Quad; 128],
    report: Report,
    profile: Vec<SpeProfile>,
    races: Vec<Race>,
}

/// The ways to run and count, each against the first.
const WAYS: [(Method, Engine); 5] = [
    (Method::ByInstruction, Engine::Interpreter),
    (Method::Memoised, Engine::Interpreter),
    (Method::Checked, Engine::Interpreter),
    (Method::Memoised, Engine::Compiler),
    (Method::Checked, Engine::Check),
];

fn run(
    (method, engine): (Method, Engine),
    rules: Rules,
    pieces: &[Piece],
    quads: &[[Piece; 4]],
    limits: &[u64],
) -> Seen {
    let (code, starts) = program(pieces);
    let bytes =
        |words: &[u32]| -> Vec<u8> { words.iter().flat_map(|word| word.to_be_bytes()).collect() };
    let mut quadwords = Vec::new();
    for piece in quads.iter().flatten() {
        piece.write(&mut quadwords, &starts, &[]);
    }
    let memory = Arc::new(RegisteredMemory::new());
    let access = Access::ReadWrite;
    memory.register(MEMORY_EA, bytes(&quadwords), access).unwrap();
    let timing = Timing { rules, ..Timing::default() };
    let options = SimulationOptions {
        profile: true,
        races: true,
        method,
        engine,
        ..SimulationOptions::default()
    };
    let machine = Machine::simulated_with(memory, timing, options);
    let races: Arc<Mutex<Vec<Race>>> = Arc::default();
    let found = Arc::clone(&races);
    let simulation = machine.simulation().unwrap();
    simulation.on_race(move |race| found.lock().unwrap().push(*race));
    machine.compile_after(HOT);
    let spe = Spe::new(&machine, Config::default());
    spe.local_store().write(0, &bytes(&code));
    spe.local_store().write(CODE_QUADS, &bytes(&quadwords));
    let prepare = |spu: &mut Spu| {
        for (register, at) in (PLACES..PLACES + PLACE_COUNT).zip(0_usize..) {
            let place = starts[at * 7 % starts.len()];
            spu.set_register(register, Quad::scalar(place));
        }
        for register in 0..REGISTERS {
            let value = 0x0103_0020_u32.rotate_left(u32::from(register) * 4);
            spu.set_register(register, Quad::splat(value));
        }
        // With this value, a write to channel 1 enables the decrementer's event, and a write to
        // channel 7 lets it occur soon.
        spu.set_register(3, Quad::splat(0x20));
    };
    let mut at = starts[0];
    let mut ends = Vec::new();
    for (number, &limit) in limits.iter().cycle().take(STOPS).enumerate() {
        let stopped = spe.run_observed(at, limit, &mut (), |spu| {
            if number == 0 {
                prepare(spu);
            }
        });
        let pc = spe.with_spu(Spu::pc);
        // After an instruction that can't be run, continue with another piece.
        at = match stopped {
            Some(_) if number % 2 == 1 => starts[number % starts.len()],
            Some(ref stopped) if stopped.npc == stopped.pc => starts[number % starts.len()],
            _ => pc,
        };
        ends.push((stopped.map(|stopped| stopped.reason), pc));
    }
    let races = races.lock().unwrap().clone();
    assert_eq!(spe.difference(), None, "{method:?} {engine:?}");
    Seen {
        ends,
        registers: spe.with_spu(|spu| spu.registers),
        report: simulation.report(),
        profile: simulation.profile().unwrap(),
        races,
    }
}

fn rules() -> impl Strategy<Value = Rules> {
    (prop::array::uniform3(any::<bool>()), 1_u64..14).prop_map(|(switches, channel_interval)| {
        Rules {
            hints: !(switches[0] && switches[1]),
            inline_prefetch: switches[0] && switches[2],
            false_targets: switches[1] && switches[2],
            channel_interval,
            ..Rules::default()
        }
    })
}

/// A quadword of code: pieces of one word that do not depend on their address.
fn quad() -> impl Strategy<Value = [Piece; 4]> {
    let short = piece().prop_filter("a word", |piece| {
        matches!(piece, Piece::Plain(..) | Piece::Data(..) | Piece::Read(..) | Piece::Indirect(..))
    });
    prop::array::uniform4(short)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(50))]

    #[test]
    fn any_program_takes_the_same_cycles_by_any_method(
        pieces in prop::collection::vec(piece(), 8..60),
        quads in prop::collection::vec(quad(), QUADS),
        limits in prop::collection::vec(prop_oneof![1_u64..20, Just(MOST)], 1..4),
        rules in rules(),
    ) {
        let by_instruction = run(WAYS[0], rules, &pieces, &quads, &limits);
        for way in &WAYS[1..] {
            let seen = run(*way, rules, &pieces, &quads, &limits);
            prop_assert_eq!(&seen, &by_instruction, "{:?}", way);
        }
    }
}

/// The code counts the immediate of an instruction in its own loop up from 0. So no two passes run
/// the same code, and there are more states and transitions than are kept.
#[test]
fn always_new_code_is_timed() {
    const ROUNDS: i32 = 20_000;
    let at = |address: i32, index: i32| address - 4 * index;
    let code = [
        word(Op::Ila, 10, [0; 3], ROUNDS),
        word(Op::Lqa, 11, [0; 3], 0x40),
        word(Op::Lnop, 0, [0; 3], 0),
        word(Op::Br, 0, [0; 3], at(0x20, 3)),
        0,
        0,
        0,
        0,
        // 0x20: the next quadword of code.
        word(Op::A, 11, [11, 12, 0], 0),
        word(Op::Stqa, 11, [0; 3], 0x40),
        word(Op::Ai, 10, [10, 0, 0], -1),
        word(Op::Brz, 10, [0; 3], at(0x60, 11)),
        word(Op::Br, 0, [0; 3], at(0x40, 12)),
        0,
        0,
        0,
        // 0x40
        word(Op::Il, 13, [0; 3], 0),
        word(Op::Ilh, 0, [0; 3], 0),
        word(Op::Il, 14, [0; 3], 0),
        word(Op::Br, 0, [0; 3], at(0x20, 19)),
        0,
        0,
        0,
        0,
        // 0x60
        word(Op::Stop, 0, [0; 3], 5),
    ];
    let seen = WAYS.map(|(method, engine)| {
        let memory = Arc::new(RegisteredMemory::new());
        let options =
            SimulationOptions { profile: true, method, engine, ..SimulationOptions::default() };
        let machine = Machine::simulated_with(memory, Timing::default(), options);
        let spe = Spe::new(&machine, Config::default());
        for (address, word) in (0..).step_by(4).zip(code) {
            spe.local_store().write(address, &word.to_be_bytes());
        }
        // Added to a quadword of code, this adds 1 to the first immediate.
        let step = Quad([1 << 7, 0, 0, 0]);
        let prepare = |spu: &mut Spu| spu.set_register(12, step);
        let stopped = spe.run_observed(0, 1 << 20, &mut (), prepare);
        assert_eq!(stopped.map(|stopped| stopped.reason), Some(Stop::Signal(5)));
        let simulation = machine.simulation().unwrap();
        let last = spe.with_spu(|spu| spu.register(13).preferred());
        (last, simulation.report(), simulation.profile())
    });
    assert!(seen[0].0 > 0);
    for (way, other) in WAYS.iter().zip(&seen) {
        assert_eq!(other, &seen[0], "{way:?}");
    }
}
