//! Tests of the table itself: counts, encodings, round trips, register sets.

use spu_isa::{Class, Format, Instruction, Machine, Op, Operand, Pipe, Target};

/// Provenance: words from the GNU assembler.
#[test]
fn known_encodings_decode_to_their_text() {
    let known = [
        (0x3400_4083, "lqd\t$3,16($1)"),
        (0x24f4_00d0, "stqd\t$80,-768($1)"),
        (0x4080_0083, "il\t$3,1"),
        (0x1801_4203, "a\t$3,$4,$5"),
        (0xe12b_6b72, "fma\t$9,$86,$45,$114"),
        (0xb020_c104, "shufb\t$1,$2,$3,$4"),
        (0x3ec1_0203, "cwd\t$3,4($4)"),
        (0x0f3e_0203, "rotmi\t$3,$4,-8"),
        (0x76a6_c203, "csflt\t$3,$4,0"),
        (0x762b_4203, "cflts\t$3,$4,0"),
        (0x43ff_ff83, "ila\t$3,262143\t# 3ffff"),
        (0x3524_0100, "bisle\t$0,$2"),
        (0x2508_0203, "bizd\t$3,$4"),
        (0x21a0_0a84, "wrch\t$ch21,$4"),
        (0x01a0_0c03, "rdch\t$3,$ch24"),
        (0x2180_0184, "mtspr\t$sp3,$4"),
        (0x0000_2001, "stop"),
        (0x2801_4203, "stopd\t$3,$4,$5"),
        (0x7b01_0180, "heq\t$0,$3,$4"),
    ];
    for (word, text) in known {
        assert_eq!(spu_isa::disassemble(word, 0).to_string(), text, "{word:08x}");
        assert_eq!(Instruction::decode(word).unwrap().encode(), word, "{text}");
    }
}

/// Provenance: the architecture's 199 opcodes, with the extension.
#[test]
fn the_table_has_every_instruction() {
    assert_eq!(Op::rows().len(), 199);
    let assigned = (0..2048u32).filter(|top| Op::of_word(top << 21).is_some()).count();
    assert_eq!(assigned, 1264);
    let extension = Op::rows().iter().filter(|row| row.machine == Machine::DoubleExtension);
    assert_eq!(extension.count(), 5);
    for (index, row) in Op::rows().iter().enumerate() {
        assert_eq!(row.op as usize, index);
        assert_eq!(Op::of_mnemonic(row.mnemonic), Some(row.op));
        assert_eq!(row.op.row().mnemonic, row.mnemonic);
    }
    assert_eq!(Op::of_mnemonic("lr"), None);
}

/// The bits that a format ignores.
fn reserved(format: Format) -> u32 {
    match format {
        Format::Flagged => 0x0003_c000,
        Format::Hint => 0x0003_007f & !0x0000_c07f,
        Format::Stop => 0x001f_c000,
        _ => 0,
    }
}

#[test]
fn decoding_and_encoding_are_inverse() {
    for n in 0..2048u32 * 256 {
        let word = (n % 2048) << 21 | n.wrapping_mul(0x9e37_79b9) >> 11;
        let Some(instruction) = Instruction::decode(word) else {
            continue;
        };
        let row = instruction.op.row();
        assert_eq!(
            instruction.encode(),
            word & !reserved(row.format),
            "{} {word:08x}",
            row.mnemonic
        );
        assert_eq!(Instruction::decode(instruction.encode()), Some(instruction));
        assert_eq!(
            word >> 21 & !((1 << (11 - row.format.opcode_bits())) - 1),
            u32::from(row.opcode)
        );
    }
}

/// Writing an instruction by its operands loses nothing: everything in a format except registers
/// is an operand, or letters of the mnemonic.
#[test]
fn every_constant_is_an_operand() {
    for row in Op::rows() {
        let registers = [Operand::Rt, Operand::Ra, Operand::Rb, Operand::Rc];
        let others = row.operands.iter().filter(|operand| !registers.contains(operand));
        let constants = match row.format {
            Format::Rr | Format::Rrr | Format::Flagged => 0,
            Format::HintAbsolute | Format::HintRelative => 2,
            _ => 1,
        };
        let numbered = matches!(row.operands, [Operand::Rt, other] | [other, Operand::Rt]
            if [Operand::Channel, Operand::Special].contains(other));
        assert_eq!(others.count(), constants + usize::from(numbered), "{}", row.mnemonic);
    }
}

/// Provenance: the list of accumulators and false targets in GCC's scheduler and the architecture.
#[test]
fn register_sets_follow_the_operands() {
    let decode = |word| Instruction::decode(word).unwrap();
    let members = |set: spu_isa::RegisterSet| set.iter().collect::<Vec<_>>();
    let shufb = decode(0xb020_c104);
    assert_eq!(members(shufb.reads()), [2, 3, 4]);
    assert_eq!(members(shufb.writes()), [1]);
    let stqd = decode(0x24f4_00d0);
    assert_eq!(members(stqd.reads()), [1, 80]);
    assert!(stqd.writes().is_empty());
    let heq = decode(0x7b01_0187);
    assert_eq!(members(heq.reads()), [3, 4]);
    assert!(heq.writes().is_empty());
    assert_eq!(members(heq.false_target()), [7]);

    let named = |mnemonics: &str| -> Vec<Op> {
        let mut ops: Vec<Op> = mnemonics
            .split_whitespace()
            .map(|mnemonic| Op::of_mnemonic(mnemonic).unwrap())
            .collect();
        ops.sort();
        ops
    };
    let reads_own_target = Op::rows()
        .iter()
        .filter(|row| row.target == Target::Rt && row.reads.contains(&spu_isa::Field::Rt));
    assert_eq!(
        reads_own_target.map(|row| row.op).collect::<Vec<_>>(),
        named("iohl addx sfx cgx bgx mpyhha mpyhhau dfma dfms dfnma dfnms")
    );
    let false_targets = Op::rows().iter().filter(|row| row.target == Target::False);
    assert_eq!(
        false_targets.map(|row| row.op).collect::<Vec<_>>(),
        named("nop fscrwr heq heqi hgt hgti hlgt hlgti")
    );
    let three_sources = Op::rows().iter().filter(|row| row.format == Format::Rrr);
    assert_eq!(
        three_sources.map(|row| row.op).collect::<Vec<_>>(),
        named("selb shufb mpya fma fms fnms")
    );
}

#[test]
fn classes_name_pipe_and_latency() {
    let class = |mnemonic| Op::of_mnemonic(mnemonic).unwrap().row().class;
    assert_eq!(class("fa"), Class::Fp6);
    assert_eq!(class("orx"), Class::Shuf);
    assert_eq!((class("shl").pipe(), class("shl").latency()), (Pipe::Even, 4));
    assert_eq!((class("lqd").pipe(), class("lqd").latency()), (Pipe::Odd, 6));
    assert_eq!((class("dfma").pipe(), class("dfma").latency()), (Pipe::Even, 13));
    assert_eq!((class("br").pipe(), class("br").latency()), (Pipe::Odd, 4));
}
