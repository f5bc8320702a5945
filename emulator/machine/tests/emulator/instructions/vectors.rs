//! Runs the interpreter on `vectors.spu`: for every instruction of the table, the result and
//! everything that it must leave unchanged.

use super::machine::{Script, instruction, put};
use crate::prelude::*;
use spu_emulator::interp::Observer;
use spu_isa::{Field, Operand, Target};
use std::collections::{BTreeSet, HashMap};

const VECTORS: &str = include_str!("vectors.spu");
const JUNK: u32 = 0xdead_beef;

struct Vector<'a> {
    line: &'a str,
    op: Op,
    keys: HashMap<&'a str, &'a str>,
    result: Option<Quad>,
}

impl Vector<'_> {
    fn number(&self, key: &str) -> Option<u32> {
        let text = self.keys.get(key)?;
        Some(u32::from_str_radix(text, 16).unwrap_or_else(|e| panic!("{}: {e}", self.line)))
    }

    fn immediate(&self) -> i32 {
        let text = self.keys.get("i").copied().unwrap_or("0");
        let parsed = match text.strip_prefix("0x") {
            Some(hex) => i32::from_str_radix(hex, 16),
            None => text.parse(),
        };
        parsed.unwrap_or_else(|e| panic!("{}: {e}", self.line))
    }
}

fn quad(text: &str) -> Quad {
    let word = |text| u32::from_str_radix(text, 16).unwrap_or_else(|e| panic!("{text}: {e}"));
    match text {
        "A" => return Quad::from_bytes(std::array::from_fn(|n| n as u8)),
        "B" => return Quad::from_bytes(std::array::from_fn(|n| 0x10 + n as u8)),
        _ => {}
    }
    if let Some(preferred) = text.strip_prefix("w:") {
        return Quad([word(preferred), JUNK, JUNK, JUNK]);
    }
    let words: Vec<u32> = text.split(',').map(word).collect();
    match words[..] {
        [word] => Quad::splat(word),
        [a, b, c, d] => Quad([a, b, c, d]),
        _ => panic!("{text} is neither one word nor four"),
    }
}

fn vectors() -> impl Iterator<Item = Vector<'static>> {
    let lines = VECTORS.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
    lines.map(|line| {
        let (left, result) = match line.split_once(" = ") {
            Some((left, result)) => (left, Some(quad(result))),
            None => (line, None),
        };
        let mut words = left.split_whitespace();
        let mnemonic = words.next().unwrap();
        let op = Op::of_mnemonic(mnemonic).unwrap_or_else(|| panic!("{line}: no such instruction"));
        let keys = words.map(|word| word.split_once('=').unwrap_or((word, ""))).collect();
        Vector { line, op, keys, result }
    })
}

/// Records which instructions ran.
#[derive(Default)]
struct Coverage(BTreeSet<Op>);

impl Observer for Coverage {
    fn before_instruction(&mut self, _: &Spu, instruction: Instruction) {
        self.0.insert(instruction.op);
    }
}

/// Runs a vector, with its values in the registers that `i` names.
fn check(vector: &Vector, i: Instruction, coverage: &mut Coverage) {
    let line = vector.line;
    let pc = vector.number("pc").unwrap_or(0x1000);
    let local_store = LocalStore::new();
    for address in (0..0x40000).step_by(16) {
        local_store.store_quadword(address, [address, !address, JUNK, address ^ JUNK]);
    }
    put(&local_store, pc, i);

    let mut spu = Spu::with_double_extension();
    for number in 0..128 {
        spu.set_register(number, Quad::splat(JUNK ^ u32::from(number)));
    }
    for (key, number) in [("t", i.rt), ("a", i.ra), ("b", i.rb), ("c", i.rc)] {
        if let Some(text) = vector.keys.get(key) {
            spu.set_register(number, quad(text));
        }
    }
    spu.set_pc(pc);
    let before = spu.registers;

    let mut expected = before;
    let mut expected_memory: Vec<[u32; 4]> =
        (0..0x40000).step_by(16).map(|address| local_store.load_quadword(address)).collect();
    if let Some(result) = vector.result {
        expected[usize::from(i.rt)] = result;
    }
    if let Some(address) = vector.number("loads") {
        expected[usize::from(i.rt)] = Quad(local_store.load_quadword(address));
    }
    if let Some(address) = vector.number("stores") {
        expected_memory[address as usize / 16] = before[usize::from(i.rt)].0;
    }
    let next = (pc + 4) & 0x3ffff;
    let to = vector.number("to").unwrap_or(next);
    let stop = match vector.number("stop") {
        Some(code) => Some(Stop::Signal(code as u16)),
        None => vector.keys.contains_key("halt").then_some(Stop::Halt),
    };

    let mut channels = Script {
        event: vector.keys.contains_key("event"),
        reads: vector.number("reads").map(Ok).into_iter().collect(),
        count: vector.number("count").unwrap_or(0),
        srr0: vector.number("srr0").unwrap_or(0),
        ..Script::default()
    };
    let written: Vec<(u8, u32)> =
        vector.number("writes").map(|value| (i.ra, value)).into_iter().collect();
    let stopped = spu.run_observed(&local_store, &mut channels, 1, coverage);

    for (number, (got, wanted)) in spu.registers.iter().zip(&expected).enumerate() {
        assert!(got == wanted, "{line}: ${number} is {:08x?}, expected {:08x?}", got.0, wanted.0);
    }
    assert_eq!(spu.pc(), to, "{line}: went to {:05x}", spu.pc());
    assert_eq!(spu.executed(), 1, "{line}");
    assert_eq!(channels.written, written, "{line}");
    assert_eq!(stopped.as_ref().map(|stopped| &stopped.reason), stop.as_ref(), "{line}");
    if let Some(stopped) = stopped {
        assert_eq!((stopped.pc, stopped.npc), (pc, next), "{line}");
    }
    for (quadword, wanted) in expected_memory.iter().enumerate() {
        let got = local_store.load_quadword(quadword as u32 * 16);
        assert!(got == *wanted, "{line}: local store at {:05x}", quadword * 16);
    }
}

fn has(op: Op, operand: Operand) -> bool {
    op.row().operands.contains(&operand)
}

#[test]
fn vectors_hold() {
    let mut coverage = Coverage::default();
    for vector in vectors() {
        check(&vector, instruction(vector.op, vector.immediate()), &mut coverage);
    }
}

/// Sources are read before the target is written.
#[test]
fn vectors_hold_when_the_target_is_a_source() {
    let mut coverage = Coverage::default();
    let mut checked = 0;
    for vector in vectors() {
        let row = vector.op.row();
        if row.target != Target::Rt || row.reads.contains(&Field::Rt) {
            continue;
        }
        let i = instruction(vector.op, vector.immediate());
        for (operand, number) in [(Operand::Ra, i.ra), (Operand::Rb, i.rb), (Operand::Rc, i.rc)] {
            if has(vector.op, operand) {
                check(&vector, Instruction { rt: number, ..i }, &mut coverage);
                checked += 1;
            }
        }
    }
    assert!(checked > 150, "{checked}");
}

#[test]
fn every_row_of_the_table_is_run() {
    let mut coverage = Coverage::default();
    for vector in vectors() {
        check(&vector, instruction(vector.op, vector.immediate()), &mut coverage);
    }
    let missing: Vec<&str> = Op::rows()
        .iter()
        .filter(|row| !coverage.0.contains(&row.op))
        .map(|row| row.mnemonic)
        .collect();
    assert!(missing.is_empty(), "without a vector: {missing:?}");
}
