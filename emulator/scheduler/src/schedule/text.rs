//! Writes the schedule as assembly, in the project's columns and with notes.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::function::{BlockId, Node, Reference};
use super::names::Names;
use super::source::Source;
use crate::check::Slot;
use spu_isa::{Field, Op, Operand};

/// Columns, counted from 0.
const MNEMONIC: usize = 8;
/// Width of all mnemonics except the longest.
const MNEMONIC_WIDTH: usize = 7;
const NOTES: usize = 56;
const WIDTH: usize = 100;
/// Instructions of an earlier pass are indented further by this much.
const INDENT: usize = 4;
/// Constants from this value on are written in hexadecimal.
const LARGE: i32 = 1024;

pub(super) struct Word {
    pub node: Node,
    pub address: u32,
    /// The cycle and pipe in which the model issues it.
    pub slot: Slot,
    /// The labels before it.
    pub labels: Vec<String>,
}

/// Lines that give registers their names, with as many names in a line as fit.
pub(super) fn names(made: &[(String, u8)]) -> String {
    let mut text = String::new();
    let mut column = WIDTH;
    for (name, number) in made {
        let given = format!(".set {name},{number}");
        if column + "; ".len() + given.len() < WIDTH {
            text.push_str("; ");
            column += "; ".len() + given.len();
        } else {
            if !text.is_empty() {
                text.push('\n');
            }
            text.push_str(&" ".repeat(MNEMONIC));
            column = MNEMONIC + given.len();
        }
        text.push_str(&given);
    }
    if !text.is_empty() {
        text.push('\n');
    }
    text
}

/// A line after which the assembler counts lines from this one of another file.
pub(super) fn line(number: u64, path: &str) -> String {
    format!("# {number} \"{path}\"\n")
}

/// The words' lines. With `plain_path` they have no notes, and the assembler's line table names the
/// lines of the plain source.
pub(super) fn write(
    words: &[Word],
    labels: &BTreeMap<BlockId, String>,
    branches: &BTreeMap<BlockId, String>,
    names: &mut Names<'_>,
    source: &Source<'_>,
    plain_path: Option<&str>,
) -> String {
    let mut text = String::new();
    for word in words {
        for label in &word.labels {
            // Writing to a string can't fail.
            let _ = writeln!(text, "{label}:");
        }
        if let Some(path) = plain_path {
            text.push_str(&self::line(word.node.line, path));
        }
        let indent = if word.node.stage > 0 { INDENT } else { 0 };
        let mut line = format!("{:1$}", "", MNEMONIC + indent);
        let operands = operands(&word.node, labels, branches, names);
        let mnemonic = word.node.i.mnemonic();
        let _ = write!(line, "{mnemonic:<MNEMONIC_WIDTH$} {operands}");
        let line = line.trim_end();
        if plain_path.is_some() {
            let _ = writeln!(text, "{line}");
            continue;
        }
        let own = match source.comment(word.node.line) {
            "" => word.node.reason,
            comment => comment,
        };
        let note = format!("{line:<NOTES$} # {}", word.slot).replacen("  #", " #", 1);
        let width = WIDTH.saturating_sub(note.len() + 1);
        let mut kept = String::new();
        for part in own.split_whitespace() {
            if kept.len() + part.len() + usize::from(!kept.is_empty()) > width {
                break;
            }
            if !kept.is_empty() {
                kept.push(' ');
            }
            kept.push_str(part);
        }
        let _ = writeln!(text, "{}", format!("{note} {kept}").trim_end());
    }
    text
}

fn operands(
    node: &Node,
    labels: &BTreeMap<BlockId, String>,
    branches: &BTreeMap<BlockId, String>,
    names: &mut Names<'_>,
) -> String {
    let i = node.i;
    let mut register =
        |field: Field| names.register(i.register(field), node.plain.register(field), node.line);
    let label = |id: &BlockId| labels.get(id).cloned().unwrap_or_default();
    let named = match &node.reference {
        Some(Reference::Block(id)) => Some(label(id)),
        Some(Reference::Symbol(symbol)) => Some(symbol.text()),
        Some(Reference::Hint { target, .. }) => target.as_ref().map(label),
        None => None,
    };
    let constant = |masked: i32| match &named {
        Some(named) => named.clone(),
        None if masked >= LARGE => format!("{masked:#x}"),
        None => masked.to_string(),
    };
    let operands = i.op.row().operands.iter().map(|operand| match operand {
        Operand::Rt => register(Field::Rt),
        Operand::Ra => register(Field::Ra),
        Operand::Rb => register(Field::Rb),
        Operand::Rc => register(Field::Rc),
        Operand::Channel => format!("$ch{}", i.ra),
        Operand::Special => format!("$sp{}", i.ra),
        Operand::Unsigned16 => constant(i.immediate & 0xffff),
        Operand::Displacement7 | Operand::Displacement14 => {
            let base = register(Field::Ra);
            format!("{}({base})", constant(i.immediate))
        }
        Operand::HintedBranch => match (&node.reference, &node.hinted) {
            (Some(Reference::Hint { branch, .. }), _) => {
                branches.get(branch).cloned().unwrap_or_default()
            }
            (_, Some(branch)) => label(branch),
            _ => String::new(),
        },
        _ => constant(i.immediate),
    });
    let mut operands: Vec<String> = operands.collect();
    if i.op == Op::Nop {
        operands = vec![format!("${}", i.rt)];
    }
    operands.join(",")
}
