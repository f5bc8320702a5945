//! Random programs of every instruction.

use std::fmt::Write as _;

use randomness::{Random, rounds};
use spu_isa::{Format, Op, Operand};

use crate::binutils::Bench;

const REFERENCES: [&str; 8] = ["ext", "local", "global", "function", "1b", "1f", "constants", "."];

/// An operand, in one of its forms. The GNU assembler only warns of some numbers; they are not
/// used, because warnings are errors here.
fn operand(op: Op, operand: Operand, random: &mut Random) -> String {
    let register = |random: &mut Random| match random.below(8) {
        0 => ["$lr", "$sp", "$fp", "$rp"][random.below(4) as usize].to_owned(),
        1 => "$named".to_owned(),
        2 => format!("$named+{}", random.below(100)),
        _ => format!("${}", random.below(128)),
    };
    let (minimum, maximum) = match operand {
        Operand::Rt | Operand::Ra | Operand::Rb | Operand::Rc => return register(random),
        Operand::Channel => return format!("$ch{}", random.below(128)),
        Operand::Special => return format!("$sp{}", random.below(128)),
        Operand::Immediate7 => match op {
            Op::Shli => (0, 63),
            Op::Shlhi | Op::Shlqbyi => (0, 31),
            Op::Rotmi | Op::Rotmai => (-63, 0),
            Op::Rothmi | Op::Rotmahi | Op::Rotqmbyi => (-31, 0),
            _ => (-1000, 1000),
        },
        Operand::Signed10 if op.row().mnemonic.ends_with("bi") => (-128, 255),
        Operand::Signed10 => (-512, 511),
        Operand::Signed16 => (-0x8000, 0x7fff),
        Operand::Unsigned16 => (-0x8000, 0xffff),
        Operand::Unsigned18 => (0, 0x3_ffff),
        Operand::Displacement7 => (-1000, 1000),
        Operand::Displacement14 => (-0x2000, 0x1fff),
        Operand::Absolute => (-0x2_0000, 0x3_ffff),
        Operand::Relative => (-0x4_0000, 0x3_ffff),
        Operand::HintedBranch => (-1024, 1020),
        Operand::Scale => (0, 127),
        Operand::Code => (0, 0x3fff),
    };
    let number = minimum + random.below((maximum - minimum + 1) as u64) as i64;
    let symbol = REFERENCES[random.below(REFERENCES.len() as u64) as usize];
    let takes_symbols = !matches!(operand, Operand::Scale | Operand::Code | Operand::HintedBranch);
    let text = match random.below(6) {
        0 if takes_symbols && symbol != "." => symbol.to_owned(),
        1 if takes_symbols && symbol != "." => format!("{symbol}+{}", random.below(64)),
        2 if operand == Operand::HintedBranch => "1f".to_owned(),
        2 if operand == Operand::Unsigned16 => format!("{symbol}@h"),
        3 if operand == Operand::Unsigned16 => format!("{symbol}@l"),
        3 => format!("{}+{}", number - 3, 3),
        4 if number >= 0 => format!("{number:#x}"),
        5 => format!("({number})"),
        _ => number.to_string(),
    };
    match operand {
        Operand::Displacement7 | Operand::Displacement14 => format!("{text}({})", register(random)),
        _ => text,
    }
}

/// An instruction in a random form.
fn instruction(op: Op, random: &mut Random) -> String {
    let row = op.row();
    let letters = match row.format {
        Format::Flagged if op == Op::Sync => ["", "c", ""][random.below(3) as usize],
        Format::Flagged => ["", "d", "e"][random.below(3) as usize],
        _ => "",
    };
    let operands: Vec<String> =
        row.operands.iter().map(|&kind| operand(op, kind, random)).collect();
    format!("{}{letters} {}", row.mnemonic, operands.join(","))
}

#[test]
fn random_programs_are_the_same() {
    let bench = Bench::new();
    let mut random = Random::new("programs of every instruction");
    for round in 0..rounds(20) {
        let mut source = String::from(
            "        .set named,20\n        .global global\n        .text\n1:\nlocal:\n",
        );
        let middle = random.below(199);
        for (index, row) in Op::rows().iter().enumerate() {
            if index as u64 == middle {
                source += "global:\n        .type function,@function\nfunction:\n1:\n";
            }
            if random.below(20) == 0 {
                let _ = writeln!(source, "        .align {}", random.below(4) + 2);
            }
            let _ = writeln!(source, "        {}", instruction(row.op, &mut random));
            if random.below(8) == 0 {
                source += "1:\n";
            }
        }
        source += "1:\n        .section .rodata\nconstants: .long local, global, 1b, . - local\n";
        let source = source.replace(". - local", ".-constants");
        bench.compare(&format!("round {round}"), &source);
    }
}
