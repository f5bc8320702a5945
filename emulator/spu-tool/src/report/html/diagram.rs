//! A diagram: a table of instructions, with the picture of their cycles in one tall cell.
//!
//! A long schedule is cut into parts of [`SPAN`] cycles, so that no diagram is wider than a screen
//! and each stands beside its instructions.

use std::collections::HashMap;

use maud::{Markup, PreEscaped, html};
use spu_isa::timing::{Cause, Issue, Line};
use spu_isa::{Pipe, disassemble};
use spu_scheduler::code::Code;

use super::picture::{self, Entry, Frame, Link, NUMBERED};

/// The maximum number of cycles in which the instructions of one part issue.
const SPAN: u64 = 48;

/// How long a pass of a loop takes.
pub(super) struct Extent {
    /// The minimum number of cycles of a pass.
    pub bound: u64,
    /// The mean number of cycles of a pass.
    pub cycles: f64,
    /// Whether all passes are alike.
    pub repeats: bool,
}

enum Row<'a> {
    Label(&'a str),
    Instruction(&'a Line),
}

/// The diagrams of a schedule. `id` starts the names of its rows, to which links lead.
pub(super) fn diagram(code: &Code, id: &str, lines: &[Line], extent: Option<Extent>) -> Markup {
    let mut parts: Vec<&[Line]> = Vec::new();
    let mut rest = lines;
    while !rest.is_empty() {
        let base = first_cycle(rest);
        let issues_here =
            |line: &Line| line.issued.is_none_or(|(_, issue)| issue.cycle < base + SPAN);
        // An instruction that waits for longer than a part stands in one of its own.
        let end = rest.iter().position(|line| !issues_here(line));
        let (part, after) = rest.split_at(end.unwrap_or(rest.len()).max(1));
        parts.push(part);
        rest = after;
    }
    let last = parts.len().saturating_sub(1);
    html! {
        @for (at, part) in parts.iter().enumerate() {
            (self::part(code, id, part, extent.as_ref(), at == last))
        }
    }
}

fn issues(lines: &[Line]) -> impl DoubleEndedIterator<Item = &Issue> {
    lines.iter().filter_map(|line| line.issued.as_ref().map(|(_, issue)| issue))
}

/// The first cycle that a part shows: that of its first instruction's wait, or one a little before
/// at which a line of the grid stands.
fn first_cycle(lines: &[Line]) -> u64 {
    let begin = |issue: &Issue| issue.cycle.saturating_sub(issue.waited_cycles);
    issues(lines).next().map_or(0, begin) / NUMBERED * NUMBERED
}

fn part(code: &Code, id: &str, lines: &[Line], extent: Option<&Extent>, last: bool) -> Markup {
    let mut rows = Vec::new();
    for line in lines {
        rows.extend(code.label(line.address).map(Row::Label));
        rows.push(Row::Instruction(line));
    }
    let base = first_cycle(lines);
    let pass_end = extent.filter(|extent| last && extent.repeats);
    let pass_end = pass_end.map(|extent| extent.cycles.round() as u64);
    let end = issues(lines).map(|issue| issue.ready_cycle.max(issue.cycle + 1));
    let end = end.chain(pass_end).max().unwrap_or(0).max(base + 1);
    let frame = Frame { base, columns: end - base, rows: rows.len() };
    let mut picture = String::new();
    picture::open(&mut picture, &frame);
    picture::entries(&mut picture, &frame, &entries(&rows));
    if let Some(extent) = extent {
        picture::bound(&mut picture, &frame, extent.bound);
    }
    // The cycles of a pass after its last instruction are the miss of its branch.
    let after = issues(lines).next_back().zip(pass_end);
    let missed = after.map(|(issue, end)| (issue.cycle + 1, end.saturating_sub(issue.cycle + 1)));
    let missed = missed.filter(|&(_, cycles)| cycles > 0);
    if let Some((from, cycles)) = missed {
        picture::miss(&mut picture, &frame, from, cycles);
    }
    picture.push_str("</svg>");
    let mut head = String::new();
    picture::head(&mut head, &frame, issues(lines));

    html! {
        table.pipeline {
            thead { tr {
                th { "address" } th { "pipe" } th { "cycle" } th { "instruction" }
                th.cycles { (PreEscaped(head)) }
                th { "waits" }
            } }
            tbody {
                @for (at, row) in rows.iter().enumerate() {
                    @match row {
                        Row::Label(label) => tr.label {
                            td colspan="4" { (label) ":" }
                            @if at == 0 { (cell(&picture, rows.len())) }
                            td {}
                        },
                        Row::Instruction(line) => tr id={ (id) "-" (format!("{:05x}", line.address)) } {
                            (columns(line, joined(&rows, at)))
                            @if at == 0 { (cell(&picture, rows.len())) }
                            td.why {
                                (reason(id, line))
                                @if at + 1 == rows.len() && let Some((_, cycles)) = missed {
                                    " then " (cycles) " branch miss"
                                }
                            }
                        },
                    }
                }
            }
        }
    }
}

fn cell(picture: &str, rows: usize) -> Markup {
    html! { td.cycles rowspan=(rows) { (PreEscaped(picture)) } }
}

/// Whether the instruction of a row issues together with its neighbour.
fn joined(rows: &[Row], at: usize) -> bool {
    let second = |row: &Row| match row {
        Row::Instruction(line) => line.issued.is_some_and(|(_, issue)| issue.dual),
        Row::Label(_) => false,
    };
    let after = rows[at + 1..].iter().find(|row| matches!(row, Row::Instruction(_)));
    second(&rows[at]) || after.is_some_and(second)
}

fn columns(line: &Line, joined: bool) -> Markup {
    let instruction = disassemble(line.word, line.address).to_string();
    let instruction = instruction.replacen('\t', " ", 1).replace('\t', " ");
    html! {
        td { (format!("{:05x}", line.address)) }
        @if let Some((_, issue)) = &line.issued {
            @match issue.pipe {
                Pipe::Even => td.even { "even" },
                Pipe::Odd => td.odd { "odd" },
            }
            td.n { (issue.cycle) @if joined { b { " D" } } @else if issue.missed_dual { " d" } @else { "  " } }
        } @else {
            td {} td {}
        }
        td { (instruction) }
    }
}

/// The cause of the instruction's wait, with a link to its source.
fn reason(id: &str, line: &Line) -> Markup {
    let Some((cause, issue)) =
        line.issued.as_ref().and_then(|(_, issue)| issue.waited.map(|cause| (cause, issue)))
    else {
        return html! {};
    };
    html! {
        @if issue.waited_cycles == 0 { "pair lost: " } @else { (issue.waited_cycles) " " }
        @match (cause, issue.waited_register) {
            (Cause::Operand(_), Some(register)) => {
                "for $" (register)
                @if let Some(producer) = line.producer {
                    " from " a href={ "#" (id) "-" (format!("{producer:05x}")) } { (format!("{producer:05x}")) }
                    @if producer >= line.address { " of the pass before" }
                }
            },
            (cause, _) => (cause),
        }
    }
}

fn entries<'a>(rows: &'a [Row]) -> Vec<Entry<'a>> {
    let mut at_row = HashMap::new();
    let mut entries = Vec::new();
    for (row, what) in rows.iter().enumerate() {
        let Row::Instruction(line) = what else {
            continue;
        };
        if let Some((_, issue)) = &line.issued {
            let waits = matches!(issue.waited, Some(Cause::Operand(_)));
            let link =
                line.producer.filter(|_| waits).map(|producer| match at_row.get(&producer) {
                    Some(&from) => Link::Row(from),
                    None => Link::Above,
                });
            entries.push(Entry { row, issue, link });
        }
        at_row.insert(line.address, row);
    }
    entries
}
