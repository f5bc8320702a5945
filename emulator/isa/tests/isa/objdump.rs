//! Compares the disassembler and the encoder with the GNU tools for the SPU.
//!
//! Provenance: binutils 2.40, run during the test. Without the tools these tests fail, because
//! nothing else shows that our words are the assembler's.

use spu_isa::{Format, Instruction, Op, Operand, disassemble, feature};
use std::env;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The tool named by `variable`, or one of `names` in PATH, or the one that ci/setup installed.
fn tool(variable: &str, names: [&str; 2]) -> PathBuf {
    if let Some(path) = env::var_os(variable) {
        return path.into();
    }
    let cache = env::var_os("XDG_CACHE_HOME")
        .map(PathBuf::from)
        .or_else(|| env::var_os("HOME").map(|home| Path::new(&home).join(".cache")));
    let set_up = cache.map(|cache| cache.join("cellray/spu-binutils/bin"));
    let in_path = env::var_os("PATH").unwrap_or_default();
    let folders: Vec<PathBuf> = env::split_paths(&in_path).chain(set_up).collect();
    folders
        .iter()
        .flat_map(|folder| names.map(|name| folder.join(name)))
        .find(|path| path.is_file())
        .unwrap_or_else(|| panic!("{} not found: run ci/setup, or set {variable}", names[0]))
}

fn run(command: &mut Command) -> String {
    let output = command.output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?} failed:\n{errors}");
    String::from_utf8(output.stdout).unwrap()
}

/// The words and texts that the GNU tools produce from a source.
fn assemble_and_dump(source: &str) -> Vec<(u32, String)> {
    let folder = tempfile::tempdir().unwrap();
    let (input, object) = (folder.path().join("rows.s"), folder.path().join("rows.o"));
    fs::write(&input, source).unwrap();
    let assembler = tool("SPU_AS", ["spu-elf-as", "spu-as"]);
    run(Command::new(assembler).arg(&input).arg("-o").arg(&object));
    let dumper = tool("SPU_OBJDUMP", ["spu-elf-objdump", "spu-objdump"]);
    let dump = run(Command::new(dumper).args(["-d", "-z"]).arg(&object));
    dump.lines().filter_map(parse_line).collect()
}

/// `  10:<tab>34 00 40 83 <tab>lqd<tab>$3,16($1)`
fn parse_line(line: &str) -> Option<(u32, String)> {
    let (_, rest) = line.split_once(":\t")?;
    let (bytes, text) = rest.split_once('\t')?;
    let word = u32::from_str_radix(&bytes.replace(' ', ""), 16).ok()?;
    Some((word, text.to_owned()))
}

/// Constants at both ends of the range that the assembler accepts for an operand, and one between.
fn constants(row_operands: &[Operand]) -> &'static [i32] {
    let mut constants: &[i32] = &[0];
    for operand in row_operands {
        constants = match operand {
            // Every kind of seven-bit operand accepts these.
            Operand::Immediate7 => &[0, 5, 31],
            Operand::Displacement7 => &[-64, 5, 63],
            Operand::Signed10 => &[-512, -1, 0, 17, 511],
            Operand::Signed16 => &[-32768, -1, 16, 17, 32767],
            Operand::Unsigned16 => &[0, 16, 17, 0x7fff],
            Operand::Unsigned18 => &[0, 17, 0x3ffff],
            Operand::Displacement14 => &[-8192, -16, 16, 32, 8176],
            Operand::Absolute => &[0, 4, 0x1fffc, 0x20000, 0x3fffc],
            Operand::Relative => &[0, -4, -0x20000, 0x1fffc],
            Operand::Scale => &[0, 20, 127],
            Operand::Code => &[0, 0x2001, 0x3fff],
            _ => continue,
        };
    }
    constants
}

/// Instances of every row, whose operands are all distinct.
fn instances() -> Vec<Instruction> {
    let mut all = Vec::new();
    for row in Op::rows() {
        let has = |operand| row.operands.contains(&operand);
        let register = |operand, number| if has(operand) { number } else { 0 };
        let in_ra = [
            Operand::Ra,
            Operand::Channel,
            Operand::Special,
            Operand::Displacement7,
            Operand::Displacement14,
        ];
        // The assembler ignores the operand of nop.
        let rt = if row.op == Op::Nop { 0 } else { register(Operand::Rt, 3) };
        let ra = if in_ra.into_iter().any(has) { 70 } else { 0 };
        let [rb, rc] = [register(Operand::Rb, 101), register(Operand::Rc, 127)];
        let base = Instruction::new(row.op, [rt, ra, rb, rc], 0);
        match row.format {
            Format::Hint => {
                for branch_distance in [-1024, -4, 4, 1020] {
                    all.push(Instruction { branch_distance, ..base });
                }
                let immediate = feature::CHANNEL_OR_PREFETCH;
                all.push(Instruction { ra: 0, immediate, ..base });
            }
            Format::Flagged if row.op == Op::Sync => {
                for immediate in [0, feature::CHANNEL_OR_PREFETCH] {
                    all.push(Instruction { immediate, ..base });
                }
            }
            Format::Flagged => {
                for immediate in [0, feature::DISABLE, feature::ENABLE] {
                    all.push(Instruction { immediate, ..base });
                }
            }
            Format::HintAbsolute | Format::HintRelative => {
                for &immediate in constants(row.operands) {
                    for branch_distance in [-1024, 4, 1020] {
                        all.push(Instruction { branch_distance, immediate, ..base });
                    }
                }
            }
            _ => {
                for &immediate in constants(row.operands) {
                    all.push(Instruction { immediate, ..base });
                }
            }
        }
    }
    all
}

/// The instruction in the assembler's syntax. A number as relative address is the distance itself.
fn source_line(i: Instruction) -> String {
    let row = i.op.row();
    let letters = match (row.format, i.immediate) {
        (Format::Flagged, feature::DISABLE) => "d",
        (Format::Flagged, feature::ENABLE) => "e",
        (Format::Flagged, feature::CHANNEL_OR_PREFETCH) => "c",
        (Format::Hint, feature::CHANNEL_OR_PREFETCH) => return "hbrp".to_owned(),
        _ => "",
    };
    let mut line = format!("{}{letters}", row.mnemonic);
    let operands = row.operands.iter().map(|operand| match operand {
        Operand::Rt => format!("${}", i.rt),
        Operand::Ra => format!("${}", i.ra),
        Operand::Rb => format!("${}", i.rb),
        Operand::Rc => format!("${}", i.rc),
        Operand::Channel => format!("$ch{}", i.ra),
        Operand::Special => format!("$sp{}", i.ra),
        Operand::Displacement7 | Operand::Displacement14 => format!("{}(${})", i.immediate, i.ra),
        Operand::HintedBranch => i.branch_distance.to_string(),
        _ => i.immediate.to_string(),
    });
    for (operand, separator) in operands.zip(std::iter::once(" ").chain(std::iter::repeat(","))) {
        line = line + separator + &operand;
    }
    if i.op == Op::Nop { row.mnemonic.to_owned() } else { line }
}

#[test]
fn every_row_is_assembled_and_dumped_as_by_the_gnu_tools() {
    let instances = instances();
    let mut source = String::from("\t.text\n");
    for &instance in &instances {
        writeln!(source, "\t{}", source_line(instance)).unwrap();
    }
    let dumped = assemble_and_dump(&source);
    assert_eq!(dumped.len(), instances.len());
    for ((pc, instance), (word, text)) in (0..).step_by(4).zip(&instances).zip(&dumped) {
        let line = source_line(*instance);
        assert_eq!(
            instance.encode(),
            *word,
            "{line}: ours {:08x}, theirs {word:08x}",
            instance.encode()
        );
        assert_eq!(Instruction::decode(*word), Some(*instance), "{line}");
        assert_eq!(disassemble(*word, pc).to_string(), *text, "{line}");
    }
}

#[test]
fn any_word_is_dumped_as_by_objdump() {
    // Every value of the first eleven bits. The other bits count up by an odd stride.
    let words: Vec<u32> =
        (0..2048u32 * 16).map(|n| (n % 2048) << 21 | n.wrapping_mul(0x9e37_79b9) >> 11).collect();
    let mut source = String::from("\t.text\n");
    for word in &words {
        writeln!(source, "\t.long {word:#010x}").unwrap();
    }
    let dumped = assemble_and_dump(&source);
    assert_eq!(dumped.len(), words.len());
    for ((pc, word), (dumped_word, text)) in (0..).step_by(4).zip(&words).zip(&dumped) {
        assert_eq!(word, dumped_word);
        assert_eq!(disassemble(*word, pc).to_string(), *text, "word {word:08x} at {pc:x}");
    }
}
