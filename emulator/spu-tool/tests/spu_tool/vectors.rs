//! `spu vectors`: its files, what every engine makes of them, and what wrong engines make of them.

use std::array::from_fn;
use std::fs;
use std::sync::Arc;

use randomness::rounds;
use spu_emulator::compiled::{Runner, Translations};
use spu_emulator::engine::Engine;
use spu_emulator::float::{convert, double, estimate, single};
use spu_emulator::interp::{Quad, Spu};
use spu_emulator::local_store::{LocalStore, SIZE};
use spu_emulator::machine::Machine;
use spu_emulator::memory::RegisteredMemory;
use spu_emulator::simulated::{Method, SimulationOptions, Timing};
use spu_emulator::spe::{Config, Spe};
use spu_emulator::stop::{Stop, Stopped};
use spu_isa::{Instruction, Machine as Has, Op, Row};
use spu_tool::vectors::{
    Cycles, FormatError, SRR0, State, Truth, Unit, Value, Vector, binary_header, from_binary,
    stop_code, to_binary,
};

use super::support::{Bench, assert_golden};

/// The bit of the event of an inbound mailbox.
const INBOUND_DATA: u32 = 0x10;

/// Writes vectors, and reads the binary file of each instruction.
fn written(bench: &Bench, arguments: &[&str]) -> Vec<(&'static Row, Vec<Vector>)> {
    let outcome = bench.spu(&[&["vectors", "--out", "v"], arguments].concat());
    assert_eq!(outcome.status, 0, "{}", outcome.error);
    let rows = Op::rows().iter().filter_map(|row| {
        let path = bench.path(&format!("v/{}.bin", row.mnemonic));
        let bytes = path.exists().then(|| fs::read(path).unwrap())?;
        Some((row, from_binary(&bytes).unwrap()))
    });
    rows.collect()
}

fn for_every_engine() -> Vec<(&'static Row, Vec<Vector>)> {
    let count = rounds(8).to_string();
    let all = written(&Bench::new(), &["--count", &count]);
    assert_eq!(all.len(), 199);
    all
}

#[test]
fn a_seed_always_gives_the_same_bytes_in_both_forms() {
    let [all, one, other] = from_fn(|_| Bench::new());
    let vectors = written(&all, &["--count", "20", "--seed", "5"]);
    written(&one, &["--count", "20", "--seed", "5", "--instruction", "shufb"]);
    written(&other, &["--count", "20", "--seed", "6", "--instruction", "shufb"]);
    for file in ["v/shufb.bin", "v/shufb.jsonl"] {
        let read = |bench: &Bench| fs::read(bench.path(file)).unwrap();
        assert_eq!(read(&all), read(&one), "{file}");
        assert_ne!(read(&all), read(&other), "{file}");
    }
    assert_eq!(fs::read_dir(one.path("v")).unwrap().count(), 2);
    for (row, vectors) in vectors {
        let lines = all.read(&format!("v/{}.jsonl", row.mnemonic));
        let lines = lines.lines().map(|line| serde_json::from_str::<Vector>(line).unwrap());
        let mut lines: Vec<_> = lines.collect();
        for (number, line) in lines.iter_mut().enumerate() {
            let name = std::mem::take(&mut line.name);
            assert!(name.starts_with(&format!("{number} {}", row.mnemonic)), "{name}");
        }
        assert_eq!(lines, vectors, "{}", row.mnemonic);
    }
}

/// The vectors come from the interpreter, so they change with it. Checksums of an earlier version
/// name the instructions whose results, flags or cycles are different now.
#[test]
fn the_vectors_are_those_of_earlier_versions() {
    let bench = Bench::new();
    let written = written(&bench, &["--count", "200"]);
    let lines = written.iter().map(|(row, _)| {
        let bytes = fs::read(bench.path(&format!("v/{}.bin", row.mnemonic))).unwrap();
        format!("{} {:08x}\n", row.mnemonic, crc32fast::hash(&bytes))
    });
    assert_golden("vectors.crc32", &lines.collect::<String>());
}

#[test]
fn wrong_arguments_and_files_are_explained() {
    let bench = Bench::new();
    let no_folder = bench.write("file", "").join("v");
    let no_folder = no_folder.to_str().unwrap();
    for (arguments, part) in [
        (&["--out", "v", "--instruction", "fmadd"][..], "no instruction of the SPU has this name"),
        (&["--out", "v", "--count", "0"], "0 is not in 1..="),
        (&["--out", no_folder], "Not a directory"),
        (&[], "--out <DIR>"),
    ] {
        let outcome = bench.spu(&[&["vectors"], arguments].concat());
        assert_eq!(outcome.status, 127, "{}", outcome.error);
        assert!(outcome.error.contains(part), "{}", outcome.error);
    }
    let (_, vectors) = written(&bench, &["--count", "2", "--instruction", "fa"]).remove(0);
    let good: Vec<u8> = [binary_header(2), to_binary(&vectors[0]), to_binary(&vectors[1])].concat();
    assert_eq!(from_binary(&good), Ok(vectors));
    let with = |change: &dyn Fn(&mut Vec<u8>)| {
        let mut bytes = good.clone();
        change(&mut bytes);
        from_binary(&bytes).unwrap_err()
    };
    assert_eq!(with(&|bytes| bytes[0] = b'T'), FormatError::Magic);
    assert_eq!(with(&|bytes| bytes.truncate(10)), FormatError::Magic);
    assert_eq!(with(&|bytes| bytes.truncate(bytes.len() - 1)), FormatError::Truncated(1));
    assert_eq!(with(&|bytes| bytes.push(0)), FormatError::Longer(1));
    let truth = FormatError::Field { vector: 0, field: "truth", value: 9 };
    assert_eq!(with(&|bytes| bytes[36] = 9), truth);
    let place = FormatError::Field { vector: 0, field: "the place of a record", value: 0x180 };
    assert_eq!(with(&|bytes| bytes[42] = 1), place);
    let error = serde_json::from_str::<Value>("\"12\"").unwrap_err().to_string();
    assert!(error.contains("\"12\" is not 32 hexadecimal digits"), "{error}");
}

/// Code that an engine runs before the instruction, in a quadword that the vector does not use,
/// and registers for it.
struct Entry {
    at: u32,
    code: Quad,
    registers: Vec<(u8, Quad)>,
}

impl Entry {
    /// Code that branches to the vector's instruction. The words before the branch use registers
    /// with these values.
    fn new(vector: &Vector, before: &[(Op, u8, u32)]) -> Self {
        let used = |at: u32| {
            let mut ram = vector.initial.ram.iter();
            ram.any(|&(address, _)| address == at) || vector.after.pc & !15 == at
        };
        let at = (0..SIZE).step_by(16).find(|&at| !used(at)).unwrap();
        let mut free = (0..128).filter(|&number| vector.initial.register(number).is_none());
        let registers: Vec<_> =
            before.iter().map(|&(.., value)| (free.next().unwrap(), Quad::splat(value))).collect();
        let operations = before.iter().zip(&registers).map(|(&(op, channel, _), &(rt, _))| {
            Instruction::new(op, [rt, channel, 0, 0], 0).encode()
        });
        let branch = Instruction::new(Op::Bra, [0; 4], vector.initial.pc as i32).encode();
        let mut code = operations.chain([branch]);
        let code = Quad(from_fn(|_| code.next().unwrap_or(0)));
        Self { at, code, registers }
    }

    fn load(&self, spu: &mut Spu) {
        for &(number, value) in &self.registers {
            spu.set_register(number, value);
        }
        spu.set_pc(self.at);
    }
}

/// What every register has that a vector does not mention.
fn junk() -> [Quad; 128] {
    from_fn(|number| Quad::splat(0xdead_be00 | number as u32))
}

/// Compares all registers and local store, and the rest of the state, with those that the vector
/// demands. An engine that runs on stops at the word 0 after the instruction.
fn compare(
    vector: &Vector,
    (spu, local_store, unit): (&Spu, &LocalStore, &Unit),
    stopped: Option<&Stopped>,
    entry: Option<&Entry>,
) -> Result<(), String> {
    let i = vector.initial.instruction();
    let mut found = vector.after.of(spu, local_store, unit);
    let mut stop = None;
    match stopped {
        Some(stopped) if stopped.pc == vector.initial.pc => {
            stop = Some(stop_code(&stopped.reason).ok_or_else(|| stopped.to_string())?);
            found.pc = stopped.npc;
        }
        Some(stopped) if stopped.reason == Stop::Signal(0) => found.pc = stopped.pc,
        Some(stopped) => return Err(format!("{i:?}: {stopped}")),
        None => {}
    }
    if (&found, stop) != (&vector.after, vector.stop) {
        return Err(format!("{i:?}: {found:x?}, stop {stop:?}, not {vector:x?}"));
    }
    let mut registers = junk();
    let mut memory = vec![0; SIZE as usize];
    let own = entry.iter().flat_map(|entry| &entry.registers).copied();
    let changed = vector.after.regs.iter().map(|&(number, Value(value))| (number, value));
    for (number, value) in own.chain(changed) {
        registers[usize::from(number)] = value;
    }
    let own = entry.map(|entry| (entry.at, entry.code));
    let changed = vector.after.ram.iter().map(|&(address, Value(value))| (address, value));
    for (address, value) in changed.chain(own) {
        memory[address as usize..][..16].copy_from_slice(&value.bytes());
    }
    let mut now = vec![0; SIZE as usize];
    local_store.read(0, &mut now);
    match (spu.registers == registers, now == memory) {
        (true, true) => Ok(()),
        (same, _) => Err(format!("{i:?}: another {}", if same { "quadword" } else { "register" })),
    }
}

fn clear(vector: &Vector, local_store: &LocalStore, entry: &Entry) {
    for address in vector.initial.ram.iter().map(|&(address, _)| address).chain([entry.at]) {
        local_store.store_quadword(address, [0; 4]);
    }
}

/// Each part of the state after an instruction is compared: a vector with one other bit fails.
#[test]
fn a_wrong_bit_anywhere_is_found() {
    let bench = Bench::new();
    let (_, vectors) = written(&bench, &["--count", "1", "--instruction", "stqd"]).remove(0);
    let flip = |value: &mut Value| value.0.0[3] ^= 1;
    let changes: [&dyn Fn(&mut Vector); 8] = [
        &|vector| vector.after.pc ^= 4,
        &|vector| vector.after.regs.iter_mut().for_each(|(_, value)| flip(value)),
        &|vector| flip(&mut vector.after.fpscr),
        &|vector| vector.after.srr0 ^= 4,
        &|vector| vector.after.interrupts ^= true,
        &|vector| flip(&mut vector.after.ram[1].1),
        &|vector| vector.stop = Some(1),
        // A register that the rest of the vector does not mention.
        &|vector| vector.initial.regs.push((127, Value::default())),
    ];
    assert_eq!(vectors[0].initial.register(127), None);
    assert_eq!(interpret(&mut Spu::new(), &vectors[0]), Ok(()));
    for (number, change) in changes.iter().enumerate() {
        let mut vector = vectors[0].clone();
        change(&mut vector);
        assert!(interpret(&mut Spu::new(), &vector).is_err(), "change {number}");
    }
}

/// Runs one instruction with the interpreter.
fn interpret(spu: &mut Spu, vector: &Vector) -> Result<(), String> {
    let local_store = LocalStore::new();
    spu.registers = junk();
    let mut unit = vector.initial.load(spu, &local_store);
    let stopped = spu.step(&local_store, &mut unit);
    compare(vector, (spu, &local_store, &unit), stopped.as_ref(), None)
}

#[test]
fn the_interpreter_passes_all_vectors() {
    for (row, vectors) in for_every_engine() {
        let mut spu = match row.machine {
            Has::Every => Spu::new(),
            Has::DoubleExtension => Spu::with_double_extension(),
        };
        for vector in &vectors {
            assert_eq!(vector.initial.instruction().map(|i| i.op), Some(row.op));
            interpret(&mut spu, vector).unwrap();
        }
    }
}

/// Runs each vector twice, so that the second run enters the unit that the first has had compiled.
/// Returns the share of instructions that ran compiled.
fn compiled_share(check: bool) -> f64 {
    let (mut compiled, mut all) = (0, 0);
    for (row, vectors) in for_every_engine() {
        if row.machine == Has::DoubleExtension {
            continue;
        }
        let translations = Translations::new(check, false).expect("the hosts of the tests have it");
        translations.compile_after(1);
        if check {
            translations.optimize_at_once();
        }
        let mut runner = Runner::new(&translations);
        let (mut spu, local_store) = (Spu::new(), LocalStore::new());
        for vector in &vectors {
            let entry = Entry::new(vector, &[]);
            for _ in 0..2 {
                spu.registers = junk();
                let mut unit = vector.initial.load(&mut spu, &local_store);
                local_store.store_quadword(entry.at, entry.code.0);
                entry.load(&mut spu);
                let stopped = runner.run(&mut spu, &local_store, &mut unit, u64::MAX);
                assert_eq!(translations.difference(), None, "{}", row.mnemonic);
                compare(vector, (&spu, &local_store, &unit), stopped.as_ref(), Some(&entry))
                    .unwrap();
                clear(vector, &local_store, &entry);
            }
        }
        compiled += runner.compiled();
        all += vectors.len();
    }
    println!("{compiled} of {all} instructions ran compiled");
    compiled as f64 / all as f64
}

#[test]
fn compiled_code_passes_all_vectors() {
    let share = compiled_share(false);
    assert!(share > 0.6, "only {share} of the instructions ran compiled");
}

#[test]
fn check_mode_passes_all_vectors() {
    let share = compiled_share(true);
    assert!(share > 0.6, "only {share} of the instructions ran compiled");
}

/// In simulated time, with real channels, and with both checks: of compiled code and of cycles.
#[test]
fn check_mode_in_simulated_time_passes_all_vectors() {
    let options = SimulationOptions {
        method: Method::Checked,
        engine: Engine::Check,
        ..SimulationOptions::default()
    };
    for (row, vectors) in for_every_engine() {
        if row.machine == Has::DoubleExtension {
            continue;
        }
        let memory = Arc::new(RegisteredMemory::new());
        let machine = Machine::simulated_with(memory, Timing::default(), options);
        machine.compile_after(1);
        let spe = Spe::new(&machine, Config::default());
        // An event, which counts while the mask has it.
        assert!(spe.write_inbound(0, None));
        for vector in &vectors {
            let mask = if vector.initial.event { INBOUND_DATA } else { 0 };
            let before = [(Op::Wrch, 1, mask), (Op::Wrch, SRR0[0], vector.initial.srr0)];
            let entry = Entry::new(vector, &before);
            for _ in 0..2 {
                spe.local_store().store_quadword(entry.at, entry.code.0);
                let stopped = spe.run_prepared(entry.at, |spu| {
                    spu.registers = junk();
                    vector.initial.load(spu, spe.local_store());
                    entry.load(spu);
                });
                assert_eq!(spe.difference(), None, "{}", row.mnemonic);
                spe.with_spu(|spu| {
                    let state = (spu, &**spe.local_store(), &vector.after.unit());
                    compare(vector, state, Some(&stopped), Some(&entry)).unwrap();
                });
                clear(vector, spe.local_store(), &entry);
                assert_channels(&spe, &vector.after);
            }
        }
    }
}

/// Compares SRR0 and the count of channel 0, and lowers the count.
fn assert_channels(spe: &Spe, after: &State) {
    let code = [(Op::Rchcnt, 0), (Op::Rdch, SRR0[1]), (Op::Rdch, 0)].into_iter().zip(1..);
    let code = code.map(|((op, ra), rt)| Instruction::new(op, [rt, ra, 0, 0], 0).encode());
    let words = if after.event { 3 } else { 2 };
    let mut code = code.take(words);
    let code = from_fn(|_| code.next().unwrap_or(0));
    spe.local_store().store_quadword(0, code);
    assert_eq!(spe.run_prepared(0, |_| ()).reason, Stop::Signal(0));
    spe.local_store().store_quadword(0, [0; 4]);
    let [count, srr0] = [1, 2].map(|number| spe.with_spu(|spu| spu.register(number).preferred()));
    assert_eq!((srr0, count), (after.srr0, u32::from(after.event)));
}

/// The number of vectors, and of those that distinguish the instruction from `model`.
fn caught(op: Op, model: impl Fn(Instruction, [[u32; 4]; 3]) -> [u32; 4]) -> (usize, usize) {
    let bench = Bench::new();
    let count = rounds(1000).to_string();
    let arguments = ["--count", &count, "--instruction", op.row().mnemonic];
    let (_, vectors) = written(&bench, &arguments).remove(0);
    let wrong = vectors.iter().filter(|vector| {
        let i = vector.initial.instruction().unwrap();
        let of = |number| vector.initial.register(number).unwrap_or(Quad::ZERO).0;
        Some(Quad(model(i, [i.ra, i.rb, i.rc].map(of)))) != vector.after.register(i.rt)
    });
    (wrong.count(), vectors.len())
}

/// Products and sums rounded to the nearest where IEEE has the operands and the result.
fn rounded_fma(a: u32, b: u32, c: u32) -> u32 {
    let ordinary = |x: u32| (1..255).contains(&(x >> 23 & 255));
    let sum = f32::from_bits(a).mul_add(f32::from_bits(b), f32::from_bits(c)).to_bits();
    if [a, b, c, sum].into_iter().all(ordinary) { sum } else { single::fma(a, b, c) }
}

/// `shufb` whose selectors in `wrong` take the byte before.
fn shuffled([a, b, c]: [[u32; 4]; 3], wrong: u8) -> [u32; 4] {
    let bytes = [Quad(a).bytes(), Quad(b).bytes()].concat();
    Quad::from_bytes(Quad(c).bytes().map(|selector| match selector {
        0x80..=0xbf => 0x00,
        0xc0..=0xdf => 0xff,
        0xe0..=0xff => 0x80,
        _ if selector & 0x1f == wrong => bytes[usize::from(wrong) - 1],
        _ => bytes[usize::from(selector & 0x1f)],
    }))
    .0
}

/// `cflts` where too large numbers become the smallest, as x86's conversion makes them.
fn x86_cflts(x: u32, scale: i32) -> u32 {
    match convert::cflts(x, scale) {
        0x7fff_ffff => 0x8000_0000,
        word => word,
    }
}

/// `fesd` as a host converts: denormals are numbers, and NaNs keep their bits.
fn host_fesd(x: u32) -> u64 {
    f64::from(f32::from_bits(x)).to_bits()
}

/// Right copies of instructions pass all vectors, deliberately wrong ones do not.
#[test]
fn wrong_copies_of_instructions_are_caught() {
    const NO_BYTE: u8 = 0xff;
    let lanes = |f: fn(u32, u32, u32) -> u32| {
        move |_, [a, b, c]: [[u32; 4]; 3]| from_fn(|n| f(a[n], b[n], c[n]))
    };
    let rotated =
        |more| move |_, [a, b, _]: [[u32; 4]; 3]| from_fn(|n| a[n].rotate_left((b[n] & 31) + more));
    let converted = |f: fn(u32, i32) -> u32| {
        move |i: Instruction, [a, ..]: [[u32; 4]; 3]| a.map(|x| f(x, i.immediate))
    };
    let estimated =
        |mask: u32| move |_, [a, ..]: [[u32; 4]; 3]| a.map(|x| estimate::frest(x) & mask);
    let extended = |f: fn(u32) -> u64| {
        move |_, [a, ..]: [[u32; 4]; 3]| Quad::from_doublewords([f(a[0]), f(a[2])]).0
    };
    for (name, right, wrong) in [
        (
            "fma without truncation",
            caught(Op::Fma, lanes(single::fma)),
            caught(Op::Fma, lanes(rounded_fma)),
        ),
        (
            "shufb with one wrong selector",
            caught(Op::Shufb, |_, operands| shuffled(operands, NO_BYTE)),
            caught(Op::Shufb, |_, operands| shuffled(operands, 0x13)),
        ),
        ("rot by one too many", caught(Op::Rot, rotated(0)), caught(Op::Rot, rotated(1))),
        (
            "frest without its step",
            caught(Op::Frest, estimated(!0)),
            caught(Op::Frest, estimated(!0x3ff)),
        ),
        (
            "fesd of the host",
            caught(Op::Fesd, extended(|x| double::fesd(x).0)),
            caught(Op::Fesd, extended(host_fesd)),
        ),
        (
            "cflts that saturates as x86 does",
            caught(Op::Cflts, converted(convert::cflts)),
            caught(Op::Cflts, converted(x86_cflts)),
        ),
    ] {
        let (differ, all) = wrong;
        println!("{name}: {differ} of {all} vectors differ");
        assert_eq!(right.0, 0, "{name}: the right copy");
        assert!(differ > all / 100, "{name}: only {differ} of {all} vectors differ");
    }
}

/// Cycles that `docs/timing.md` states, as figures of the manual or of a console.
#[test]
fn cycles_are_those_of_the_timing_model() {
    for (row, vectors) in written(&Bench::new(), &["--count", "40"]) {
        for vector in vectors {
            let expected = match row.mnemonic {
                "fma" | "fa" | "lqd" | "lqx" => (6, 1),
                "shufb" | "rot" | "cntb" => (4, 1),
                "a" | "selb" | "ceq" => (2, 1),
                "mpy" | "cflts" | "fi" => (7, 1),
                "stqd" | "nop" | "lnop" | "hbrr" => (1, 1),
                "dfma" | "fesd" => (13, 8),
                "dfceq" => (2, 1),
                "brz" | "bi" if vector.after.pc != following(&vector) => (19, 19),
                "brz" => (1, 1),
                _ => continue,
            };
            let Cycles { alone, pair, truth } = vector.cycles;
            assert_eq!((alone, pair), expected, "{}", row.mnemonic);
            assert_eq!(truth == Truth::Console, alone == 19, "{}", row.mnemonic);
        }
    }
}

fn following(vector: &Vector) -> u32 {
    (vector.initial.pc + 4) % SIZE
}

/// The corners that `docs/emulator.md` calls open or fair are marked, and nothing else is.
#[test]
fn every_vector_names_its_source() {
    let uncertain = [
        "bi", "bisl", "iret", "bisled", "biz", "binz", "bihz", "bihnz", "frest", "frsqest", "fi",
        "fesd", "frds", "cflts", "cfltu", "fa", "fs", "fma", "fms", "fnms",
    ];
    for (row, vectors) in written(&Bench::new(), &["--count", "400"]) {
        let sure = vectors.iter().filter(|vector| vector.truth == Truth::Architecture).count();
        let is_uncertain = uncertain.contains(&row.mnemonic);
        assert_eq!(sure < 400, is_uncertain, "{}: {sure} of 400", row.mnemonic);
        if row.mnemonic == "fi" {
            let open = vectors.iter().filter(|vector| vector.truth == Truth::Open).count();
            assert!((100..350).contains(&open), "{open}");
        }
    }
}
