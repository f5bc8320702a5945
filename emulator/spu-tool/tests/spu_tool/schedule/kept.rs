//! Nothing of the plain code is lost: every instruction with every operand is in the schedule or
//! is refused, and a schedule whose text means something else is an error.

use std::collections::BTreeMap;
use std::fs;

use spu_isa::{Class, Format, Instruction, Op, Operand, feature};
use spu_scheduler::code::Code;
use spu_scheduler::{Kind, ScheduleError};

use super::support::{Workshop, stderr};

const START: &str = "        .include \"kernel.inc\"\n";

/// How often each instruction of the function `f` occurs in an object of the folder, without
/// padding. Only channels and special-purpose registers are included among the registers.
fn instructions(shop: &Workshop, object: &str) -> BTreeMap<String, usize> {
    let code = Code::parse(&fs::read(shop.path(object)).unwrap()).unwrap();
    let mut functions = code.functions().iter();
    let function = functions.find(|function| function.name == "f").unwrap();
    let mut found = BTreeMap::new();
    for (_, word) in code.words(function.start, function.end) {
        let i = Instruction::decode(word).unwrap();
        let row = i.op.row();
        if matches!(row.class, Class::Nop | Class::Lnop | Class::Hb) {
            continue;
        }
        let names_number =
            |operand: &Operand| matches!(operand, Operand::Channel | Operand::Special);
        let number = row.operands.iter().any(names_number).then_some(i.ra);
        let key = format!("{} {number:?} {}", row.mnemonic, i.immediate);
        *found.entry(key).or_insert(0) += 1;
    }
    found
}

/// An assembly line for an instruction with a constant.
fn line(op: Op, constant: i32) -> String {
    let row = op.row();
    let i = Instruction::new(op, [0; 4], constant);
    let operands = row.operands.iter().map(|operand| match operand {
        Operand::Rt => "$3".to_owned(),
        Operand::Ra => "$4".to_owned(),
        Operand::Rb => "$5".to_owned(),
        Operand::Rc => "$6".to_owned(),
        Operand::Channel => "$ch29".to_owned(),
        Operand::Special => "$sp9".to_owned(),
        Operand::Displacement7 | Operand::Displacement14 => format!("{constant}($4)"),
        Operand::Relative => "outside".to_owned(),
        _ => constant.to_string(),
    });
    let operands: Vec<String> = operands.collect();
    format!("        {} {}\n", i.mnemonic(), operands.join(","))
}

/// Constants of an instruction that the assembler accepts without a warning: the smallest, the
/// largest and some between.
fn constants(op: Op) -> &'static [i32] {
    const DISABLE: i32 = feature::DISABLE;
    const ENABLE: i32 = feature::ENABLE;
    let row = op.row();
    match row.format {
        Format::Flagged if op == Op::Sync => return &[0, feature::CHANNEL_OR_PREFETCH],
        Format::Flagged => return &[0, DISABLE, ENABLE],
        _ => {}
    }
    let byte = row.mnemonic.ends_with("bi") && row.format == Format::Ri10;
    let last = row.operands.last();
    match last.unwrap_or(&Operand::Rt) {
        Operand::Immediate7 => match op {
            Op::Rotmi | Op::Rotmai => &[-63, -32, 0],
            Op::Rothmi | Op::Rotmahi | Op::Rotqmbyi => &[-31, -5, 0],
            Op::Shli => &[0, 5, 63],
            _ => &[0, 5, 31],
        },
        Operand::Displacement7 => &[-64, 5, 63],
        Operand::Signed10 if byte => &[-128, -1, 0, 127, 255],
        Operand::Signed10 => &[-512, -1, 0, 17, 511],
        Operand::Signed16 => &[-32768, -1, 0, 1023, 1024, 32767],
        Operand::Unsigned16 => &[0, 0x7fff, 0xffff],
        Operand::Unsigned18 => &[0, 1024, 0x3ffff],
        Operand::Displacement14 => &[-8192, -16, 0, 16, 8176],
        Operand::Absolute => &[0, 4, 0x1fffc, 0x20000, 0x3fffc],
        Operand::Scale => &[0, 20, 127],
        Operand::Code => &[0, 1, 0x2000, 0x3fff],
        _ => &[0],
    }
}

#[test]
fn every_instruction_comes_out_with_its_operands() {
    let mut source = format!("{START}function f\n");
    let rows =
        Op::rows().iter().filter(|row| !matches!(row.class, Class::Nop | Class::Lnop | Class::Hb));
    for row in rows {
        for &constant in constants(row.op) {
            source.push_str(&line(row.op, constant));
        }
    }
    source.push_str("        bi $lr\nendfunction f\n");
    let shop = Workshop::new(&source);
    shop.schedule();
    let (plain, scheduled) = (instructions(&shop, "plain.o"), instructions(&shop, "scheduled.o"));
    assert!(plain.len() > 400, "{}", plain.len());
    assert_eq!(scheduled, plain);
}

#[test]
fn a_loop_has_its_instructions_once_a_stage_and_in_its_short_form() {
    let source = format!(
        "{START}#   Out     $20
function f
pass:
        ai $8,$8,-1
        lqd $9,0($3)
        fm $9,$9,$9
        fm $9,$9,$9
        fm $9,$9,$9
        fm $9,$9,$9
        fm $9,$9,$9
        stqd $9,0($4)
        ai $3,$3,16
        ai $4,$4,32
        brnz $8,pass
        bi $lr
endfunction f
"
    );
    let shop = Workshop::new(&source);
    let message = shop.schedule();
    assert!(message.contains("copies 0, passes 1"), "{message}");
    let stages = message.split("stages ").nth(1).unwrap_or_else(|| panic!("{message}"));
    let stages: usize = stages.split(',').next().unwrap().parse().unwrap();
    assert!(stages > 1, "{message}");
    let mut expected = instructions(&shop, "plain.o");
    for (key, count) in &mut expected {
        // The branch ends the kernel and the short form. A return follows the drain and the short
        // form.
        *count *= if key.starts_with('b') { 2 } else { stages + 1 };
    }
    let mut found = instructions(&shop, "scheduled.o");
    // Only the test of the trip count is left.
    assert_eq!(found.remove(&format!("clgti None {}", stages - 1)), Some(1));
    let branches = |counts: &mut BTreeMap<String, usize>| {
        counts.extract_if(.., |key, _| key.starts_with("br")).map(|(_, count)| count).sum::<usize>()
    };
    assert_eq!(branches(&mut found), branches(&mut expected) + 1);
    assert_eq!(found, expected);
}

#[test]
fn the_longest_mnemonics_stand_apart_from_their_operands() {
    let shop = Workshop::new(&format!(
        "{START}function f
        rotqbybi $3,$4,$5
        shlqbybi $3,$3,$5
        rotqmbybi $3,$3,$5
        rotqmbyi $3,$3,-3
        bi $lr
endfunction f
"
    ));
    shop.schedule();
    let text = fs::read_to_string(shop.path("scheduled.s")).unwrap();
    for line in
        ["        rotqbybi $", "        shlqbybi $", "        rotqmbybi $", "        rotqmbyi $"]
    {
        assert!(text.contains(line), "{text}");
    }
}

#[test]
fn words_without_a_notation_are_refused() {
    for word in [
        0x0014_2000_u32, // stop, reserved bits set
        0x354c_0280,     // iret that disables and enables interrupts
        0x3510_0000,     // bi with the c bit of sync
        0x01a1_4183,     // rdch with a second register
        0x7300_0289,     // fscrrd with a source
        0x0064_0000,     // dsync with a register
        0x0048_0000,     // sync that disables interrupts
        0x7600_0203,     // cflts by 2^173
    ] {
        let source = format!(
            "{START}.macro odd
        .long {word:#x}
.endm
function f
        il $3,1
        odd
        bi $lr
endfunction f
"
        );
        let shop = Workshop::new(&source);
        shop.assemble("plain.s", "plain.o");
        let output = shop.spu_schedule(&["plain.o", "plain.s"]);
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(127), "{word:08x}: {message}");
        let refused = format!("spu: plain.s:6: the word {word:#010x} can't be written");
        assert!(message.starts_with(&refused), "{message}");
    }
}

/// A program with one example of each: constants, a symbol, a stop, a branch, a loop.
const BODY: &str = "function f
        il      $3,table
        lqa     $4,table+16
        ai      $5,$4,5
        brz     $5,skip
        rdch    $6,$ch29
        a       $7,$5,$6
        a       $9,$6,$5
skip:   stop    0x2000
        bi      $lr
endfunction f
        .data
        .align  4
table:  .space  32
";

/// The library's error if the assembler receives another text than the scheduler's.
fn schedule_changed(change: impl Fn(&str) -> String) -> Result<(), ScheduleError> {
    let shop = Workshop::new(&format!("{START}{BODY}"));
    shop.assemble("plain.s", "plain.o");
    let object = fs::read(shop.path("plain.o")).unwrap();
    let source = fs::read_to_string(shop.path("plain.s")).unwrap();
    let scheduled = spu_scheduler::schedule(&object, Kind::Kernel, "plain.s", &source, |text| {
        fs::write(shop.path("scheduled.s"), change(text))?;
        shop.assemble("scheduled.s", "scheduled.o");
        fs::read(shop.path("scheduled.o"))
    });
    scheduled.map(|_| ())
}

#[test]
fn a_text_that_says_something_else_is_an_error() {
    schedule_changed(str::to_owned).unwrap();
    for (from, to) in [
        ("stop    0x2000", "stop    0x2001"),
        ("stop    0x2000", "stop"),
        ("stop    0x2000", "stopd   $0,$0,$0"),
        (",table ", ",table+16 "),
        (",table+16 ", ",table "),
        (",5 ", ",6 "),
        ("$ch29", "$ch28"),
        ("brz     ", "brnz    "),
        ("bi      $lr", "bid     $lr"),
        ("skip:\n", "        lnop\n        lnop\nskip:\n"),
        ("skip:\n", "        ai      $9,$9,1\n        lnop\nskip:\n"),
        ("        a       $7,", "        a       $8,"),
        (",skip ", ",f "),
    ] {
        let changed = schedule_changed(|text| {
            assert!(text.contains(from), "{from}: {text}");
            text.replacen(from, to, 1)
        });
        let message = changed.expect_err(from).to_string();
        assert!(
            message.starts_with("plain.s:") && message.contains("fault of the scheduler"),
            "{message}"
        );
    }
    let without_lines = |word: &str| {
        schedule_changed(|text| {
            let kept = text.lines().filter(|line| !line.contains(word));
            kept.map(|line| format!("{line}\n")).collect()
        })
    };
    for word in ["rdch", "a       $9"] {
        let message = without_lines(word).unwrap_err().to_string();
        assert!(message.contains("fault of the scheduler"), "{message}");
    }
}

#[test]
fn assembler_messages_are_reported() {
    let shop = Workshop::new(&format!("{START}{BODY}"));
    shop.assemble("plain.s", "plain.o");
    let object = fs::read(shop.path("plain.o")).unwrap();
    let refused =
        spu_scheduler::schedule(&object, Kind::Kernel, "plain.s", BODY, |_| Err("not today"));
    let message = refused.map(|_| ()).unwrap_err().to_string();
    assert_eq!(message, "the schedule does not assemble: not today");
    // Without the folder of the included files.
    let output = shop.spu(&["schedule", "plain.o", "plain.s"]);
    assert_eq!(output.status.code(), Some(127));
    assert!(stderr(&output).contains("the schedule does not assemble: "), "{}", stderr(&output));
    assert!(output.stdout.is_empty());
}
