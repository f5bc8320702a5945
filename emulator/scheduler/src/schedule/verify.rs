//! Compares a schedule with the plain code, so that no instruction is lost.
//!
//! Each function is checked in two steps. First, the words that the scheduler laid out must be
//! those of the plain code, each as often as copies of loops need it, plus what a schedule adds.
//! Second, the words that the assembler makes of the text must be those that were laid out.
//! Registers and branch targets differ from the plain code's, and so may displacements, by whole
//! steps of an address that the loop advances. Whether values and jumps are right is not checked
//! here.

use std::collections::BTreeMap;

use super::error::Unschedulable;
use super::function::{Function, Node, Reference};
use super::object::{Fault, FunctionCode, Placed, Plain, is_no_operation};
use super::source::Lines;
use super::text::Word;
use spu_isa::{Class, Instruction, Op, disassemble};

/// Compares the words of a function with its plain code.
pub(super) fn instructions(
    plain: &FunctionCode,
    function: &Function,
    words: &[Word],
) -> Result<(), Fault> {
    let mut found: BTreeMap<u32, usize> = BTreeMap::new();
    for Word { node, .. } in words {
        let foreign = || (node.line, Unschedulable::Foreign(shown(node.i)));
        let Some(origin) = node.origin else {
            if is_addition(node) {
                continue;
            }
            return Err(foreign());
        };
        let place = origin.checked_sub(plain.start).map(|offset| offset / 4);
        let original = place.and_then(|place| plain.placed.get(place as usize));
        if !original.is_some_and(|placed| is_alike(placed, node)) {
            return Err(foreign());
        }
        *found.entry(origin).or_insert(0) += 1;
    }
    let plain = plain.placed.iter();
    for placed in plain.filter(|placed| !is_no_operation(placed.i)) {
        let Placed { address, i, line, .. } = placed;
        let expected = function.copies.get(address).copied().unwrap_or(1);
        let found = found.get(address).copied().unwrap_or(0);
        if found != expected {
            let instruction = shown(*i);
            return Err((*line, Unschedulable::Miscounted { instruction, expected, found }));
        }
    }
    Ok(())
}

/// An instruction for a message. The word shows what the disassembler's text leaves out.
fn shown(i: Instruction) -> String {
    let word = i.encode();
    let text = disassemble(word, 0).to_string().replace('\t', " ");
    format!("{text} ({word:#010x})")
}

/// Whether the node is an addition of the scheduler: padding, a hint, a copy of a value, or code
/// at the entry of a pipelined loop or at the exit of its short form.
fn is_addition(node: &Node) -> bool {
    match node.i.op {
        Op::Ori | Op::Shlqbyi => node.i.immediate == 0,
        Op::Clgti | Op::Brz | Op::Br => true,
        _ => is_no_operation(node.i) || node.class() == Class::Hb,
    }
}

/// Whether both are the same except for registers, the blocks that branches go to, and the steps
/// that a displacement makes up for.
fn is_alike(plain: &Placed, node: &Node) -> bool {
    let moved = node.moved.is_some_and(|moved| moved.allows(node.i.immediate));
    let bare = |i: Instruction, reference: &Option<Reference>| {
        let mut i = i.without_registers();
        if moved || matches!(reference, Some(Reference::Block(_))) {
            i.immediate = 0;
        }
        i.branch_distance = 0;
        i.encode()
    };
    let same_target = match (&plain.reference, &node.reference) {
        (Some(Reference::Block(_)), Some(Reference::Block(_))) => true,
        (plain, scheduled) => plain == scheduled,
    };
    same_target && bare(plain.i, &plain.reference) == bare(node.i, &node.reference)
}

/// Compares the words that the assembler made of a function's text with the intended ones.
/// `object` is the assembler's whole output.
pub(super) fn text(
    lines: &Lines,
    words: &[Word],
    made: Option<&FunctionCode>,
    object: &Plain<'_>,
) -> Result<(), Fault> {
    let (start, placed) = made.map_or((0, &[][..]), |made| (made.start, &made.placed));
    let mut line = lines.first as u64 + 1;
    for (at, word) in words.iter().enumerate() {
        line = line.max(word.node.line);
        let found = placed.get(at);
        if !found.is_some_and(|found| is_meant(word, found, start, object)) {
            let found = found.map_or_else(|| "nothing".to_owned(), |found| shown(found.i));
            let meant = shown(word.node.i);
            return Err((line, Unschedulable::Miswritten { meant, found }));
        }
    }
    let mut after = placed.iter().skip(words.len());
    match after.find(|placed| !is_no_operation(placed.i)) {
        Some(more) => Err((line, Unschedulable::Foreign(shown(more.i)))),
        None => Ok(()),
    }
}

/// Whether a word is the intended one, in a function that starts at `start`.
fn is_meant(
    Word { node, address, .. }: &Word,
    found: &Placed,
    start: u32,
    object: &Plain<'_>,
) -> bool {
    // The assembler's own directive with the same name drops the register.
    if is_no_operation(node.i) {
        return found.i.op == node.i.op;
    }
    let mut meant = node.i;
    let same_target = match &node.reference {
        None | Some(Reference::Hint { target: None, .. }) => found.reference.is_none(),
        Some(Reference::Block(_) | Reference::Hint { .. }) => {
            let from = if matches!(node.i.op, Op::Bra | Op::Ila) { 0 } else { *address };
            let target = start.wrapping_add(from).wrapping_add_signed(node.i.immediate);
            meant.immediate = found.i.immediate;
            found.reference == Some(Reference::Block(target as usize))
        }
        Some(Reference::Symbol(symbol)) => {
            meant.immediate = found.i.immediate;
            let place = object.place_of(&symbol.name);
            let place = place.map(|(place, offset)| (place, offset + symbol.addend));
            matches!(&found.reference, Some(Reference::Symbol(found))
                if found.part == symbol.part && Some((found.place.clone(), found.offset)) == place)
        }
    };
    same_target && meant.encode() == found.word
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::Slot;
    use crate::schedule::Kind;
    use spu_isa::Pipe;

    const WORDS: [u32; 4] = [
        0x4080_0083, // il $3,1
        0x1c01_4184, // ai $4,$3,5
        0x0000_2000, // stop 0x2000
        0x3500_0000, // bi $0
    ];

    fn plain() -> FunctionCode {
        let placed = (8..).step_by(4).zip(WORDS).map(|(address, word)| Placed {
            address,
            word,
            i: Instruction::decode(word).unwrap(),
            reference: None,
            line: u64::from(address / 4),
        });
        FunctionCode { name: "f".into(), start: 8, end: 24, placed: placed.collect() }
    }

    fn function() -> Function {
        Function {
            name: "f".into(),
            kind: Kind::Kernel,
            blocks: Vec::new(),
            results: 0,
            copies: BTreeMap::new(),
        }
    }

    fn word(node: Node) -> Word {
        let (cycle, pipe) = (0, Pipe::Even);
        Word { node, address: 0, slot: Slot { cycle, pipe }, labels: Vec::new() }
    }

    fn added(code: u32) -> Word {
        word(Node::added(Instruction::decode(code).unwrap(), None, ""))
    }

    /// The plain code's words in another order and with another source register.
    fn scheduled() -> Vec<Word> {
        let words = plain().placed.into_iter().rev().map(|placed| {
            let mut word = added(placed.word);
            word.node.origin = Some(placed.address);
            if placed.i.op == Op::Ai {
                word.node.i.ra = 9;
            }
            word
        });
        words.collect()
    }

    fn fault(change: impl FnOnce(&mut Vec<Word>)) -> String {
        let mut words = scheduled();
        change(&mut words);
        let (_, what) = instructions(&plain(), &function(), &words).unwrap_err();
        what.to_string()
    }

    #[test]
    fn a_schedule_has_the_plain_instructions_and_what_it_needs() {
        let mut words = scheduled();
        // lnop, nop, hbr, and a copy by ori.
        words.extend([0x0020_0000, 0x4020_007f, 0x3580_0000, 0x0400_0183].map(added));
        instructions(&plain(), &function(), &words).unwrap();
    }

    #[test]
    fn lost_or_duplicated_instructions_are_counted() {
        let lost = fault(|words| drop(words.pop()));
        assert!(lost.contains("the schedule has `il $3,1 (0x40800083)` 0 times, not 1"), "{lost}");
        let doubled = fault(|words| words.extend(scheduled().pop()));
        assert!(doubled.contains("2 times, not 1"), "{doubled}");
        let mut function = function();
        function.copies.insert(16, 3);
        let (line, what) = instructions(&plain(), &function, &scheduled()).unwrap_err();
        assert_eq!(line, 4);
        assert!(what.to_string().contains("1 times, not 3"), "{what}");
    }

    #[test]
    fn changed_or_foreign_instructions_are_named() {
        // The stop's code, the addend, and an addition that no schedule makes.
        let changed = fault(|words| words[1].node.i.immediate = 0);
        assert!(changed.contains("`stop (0x00000000)`"), "{changed}");
        let changed = fault(|words| words[2].node.i.immediate = 6);
        assert!(changed.contains("is not in the plain code"), "{changed}");
        let foreign = fault(|words| words.push(added(0x1c01_4184)));
        assert!(foreign.contains("`ai $4,$3,5 (0x1c014184)`"), "{foreign}");
    }
}
