//! A scheduler for SPU assembly: it turns plain code into the same code for both pipes.
//!
//! It takes an object and the source that it was assembled from. It writes the source again with
//! each function scheduled: blocks by list scheduling, counted loops by software pipelining. The
//! output has the notes that `spu time --check` compares with the model. `docs/spu-programming.md`
//! lists the scheduler's assumptions about memory and registers. It uses the instruction table and
//! the pipeline model, but not the meaning of the code. Invariant: the same input produces the same
//! bytes.

mod allocate;
mod colour;
mod copies;
mod dependence;
mod displacement;
mod error;
mod function;
mod layout;
mod list;
mod memory;
mod modulo;
mod names;
mod object;
mod pipelined;
mod random;
mod source;
mod text;
mod values;
mod verify;
mod words;

use std::collections::BTreeMap;
use std::error::Error;

pub use error::{ScheduleError, Unschedulable};
use names::Names;
use object::Plain;
pub use pipelined::{Figures, LoopReport, Outcome};
use source::Source;

/// What a source promises, and so what its schedule may change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Leaf functions: pointers to different records never overlap, no function calls another, and
    /// what a caller reads is known. The schedule has other registers, pipelined loops, hints and
    /// padding of its own.
    Kernel,
    /// Functions that call others, share registers with them, follow any pointers and have their
    /// own hints. Only the order within blocks changes, so the code keeps its size. Objects with
    /// different names, and the stack, are taken not to overlap.
    Driver,
}

/// A scheduled source.
#[derive(Clone, Debug)]
pub struct Scheduled {
    /// The new source text.
    pub text: String,
    /// The result for each of its loops.
    pub loops: Vec<LoopReport>,
}

/// Schedules all functions of a source. `object` is the assembler's output for it, made with `-g`
/// and without `--strip-local-absolute`. `kind` limits what may change. `path` names the source in
/// messages and in the line table. `assemble` turns a text into an object in the same way. The
/// object of the schedule is compared with the plain one, so that a lost instruction or operand is
/// an error.
pub fn schedule<E: Into<Box<dyn Error + Send + Sync>>>(
    object: &[u8],
    kind: Kind,
    path: &str,
    source: &str,
    assemble: impl FnOnce(&str) -> Result<Vec<u8>, E>,
) -> Result<Scheduled, ScheduleError> {
    let at = |(line, what): (u64, Unschedulable)| ScheduleError::At {
        file: path.to_owned(),
        line,
        what,
    };
    let plain = Plain::parse(object)?;
    if !plain.comes_from(path) {
        return Err(ScheduleError::NotInTable(path.to_owned()));
    }
    let source = Source::new(source);
    let functions = source.functions().map_err(at)?;
    let numbers = plain.numbers();
    let given = match kind {
        Kind::Kernel => source.register_names(&functions, &numbers),
        // Its lines are those of the source, which has the names.
        Kind::Driver => Vec::new(),
    };
    let mut names = Names::new(given, plain.names());
    let mut loops = Vec::new();
    let mut bodies = Vec::new();
    let mut used = BTreeMap::new();
    let mut written = Vec::new();
    for lines in &functions {
        let Some(function_code) = plain.function_code(&lines.name, kind, path).map_err(at)? else {
            continue;
        };
        let mut function = plain.function(&function_code, kind).map_err(at)?;
        source.check(lines).map_err(at)?;
        // Without an `Out` line, every register may be a result.
        function.results = source.results(lines).unwrap_or(!0);
        for block in &mut function.blocks {
            for node in &mut block.nodes {
                let comment = source.comment(node.line);
                node.may_alias = node.is_store() && comment.contains("may alias");
                if node.ends_block() {
                    node.one_pass = comment.contains("one pass");
                    node.min_passes = min_passes(comment).unwrap_or(node.min_passes);
                }
            }
        }
        function.fuse();
        if kind == Kind::Kernel {
            loops.extend(pipelined::pipeline(&mut function));
            function.fuse();
        }
        let (words, body) = words::lay_out(&mut function, &mut names, &source, path);
        verify::instructions(&function_code, &function, &words).map_err(at)?;
        if let Some(line) = source.uses(lines).filter(|_| kind == Kind::Kernel) {
            *used.entry(line).or_insert(0) |= words::written(&words);
        }
        let inside = (lines.first as u64 + 1, lines.end as u64 + 1);
        bodies.push((lines, names.take_made(inside), body));
        written.push((lines, words));
    }
    if bodies.is_empty() {
        return Err(ScheduleError::NoFunction);
    }
    let mut text = String::new();
    let mut copied = 0;
    for (lines, made, body) in bodies {
        source.copy(copied..lines.first + 1, path, &used, &mut text);
        text.push_str(&text::names(&made));
        text.push_str(&body);
        if kind == Kind::Driver {
            text.push_str(&text::line(lines.end as u64 + 1, path));
        }
        copied = lines.end;
    }
    source.copy(copied..source.lines.len(), path, &used, &mut text);
    let made = assemble(&text).map_err(|error| ScheduleError::Assembler(error.into()))?;
    let made = Plain::parse(&made)?;
    for (lines, words) in written {
        let function_code = made.function_code(&lines.name, kind, path).map_err(at)?;
        verify::text(lines, &words, function_code.as_ref(), &made).map_err(at)?;
    }
    Ok(Scheduled { text, loops })
}

/// The number in "at least N passes".
fn min_passes(comment: &str) -> Option<u32> {
    let (before, _) = comment.split_once(" passes")?;
    before.rsplit_once("at least ")?.1.parse().ok()
}
