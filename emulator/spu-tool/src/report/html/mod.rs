//! The report as one HTML page: a row for each instruction, a column for each cycle.
//!
//! The page needs no network and no script. Functions are folded unless there is only one, so that
//! a browser lays out only what its reader opens. Text from the file is escaped by `maud`.

mod diagram;
mod picture;

use maud::{DOCTYPE, Markup, PreEscaped, html};
use spu_isa::timing::{Account, HintDistance, Loop, Verdict};
use spu_scheduler::code::Code;

use super::function::FunctionReport;
use super::listing::{number, tally};
use diagram::{Extent, diagram};

const STYLE: &str = include_str!("style.css");

/// The whole page. `title` names the file that was analysed.
pub(super) fn page(code: &Code, title: &str, functions: &[FunctionReport]) -> String {
    let open = functions.len() == 1;
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { "Pipelines: " (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { "Pipelines: " code { (title) } }
                (legend())
                @if !open { (index(functions)) }
                @for (number, report) in functions.iter().enumerate() {
                    (function(code, number, report, open))
                }
            }
        }
    };
    page.into_string()
}

fn legend() -> Markup {
    html! {
        p.legend {
            "A row is an instruction, a column a cycle. "
            span.key.even {} " issues on the even pipe, " span.key.odd {} " on the odd pipe, "
            span.key.pair {} " both in one cycle. "
            span.key.flight {} " The result is not ready yet. "
            span.key.wait {} " Nothing issues, because this instruction waits; "
            span.key.lost {} " it only loses its partner. "
            span.key.link {} " leads from the instruction whose result it waits for, dashed if that "
            "one is further up or in the pass before. The strip above each diagram shows which "
            "cycles each pipe uses."
        }
        p.legend {
            "Straight code is timed with no branch taken and all registers ready at the start; "
            "loops in their steady state, with branches and hints."
        }
    }
}

/// The table of all functions, with links to them.
fn index(functions: &[FunctionReport]) -> Markup {
    html! {
        table.index {
            thead { tr {
                th { "function" } th { "address" } th { "instructions" } th { "cycles" }
                th { "dual" } th { "stalled" } th { "loops: cycles a pass / bound" }
            } }
            tbody {
                @for (at, report) in functions.iter().enumerate() {
                    tr {
                        td { a href={ "#f" (at) } { (report.function.name) } }
                        td { (format!("{:05x}", report.function.start)) }
                        td.n { (report.schedule.lines.len()) }
                        @if let Some(account) = &report.schedule.account {
                            td.n { (account.cycles()) }
                            td.n { (percent(account)) }
                            td.n { (account.stalled()) }
                        } @else {
                            td colspan="3" { "not every word is an instruction" }
                        }
                        td { @for (at, found) in report.loops.iter().enumerate() {
                            @if at > 0 { ", " }
                            (speed(found))
                        } }
                    }
                }
            }
        }
    }
}

fn speed(found: &Loop) -> String {
    let Some(steady) = &found.steady else {
        return "not analysed".into();
    };
    format!("{} / {}", number(steady.cycles_a_pass()), found.bound())
}

fn percent(account: &Account) -> String {
    format!("{:.0} %", 100.0 * account.dual_share())
}

fn function(code: &Code, at: usize, report: &FunctionReport, open: bool) -> Markup {
    let function = &report.function;
    let words = report.schedule.lines.len();
    html! {
        details id={ "f" (at) } open[open] {
            summary {
                h2 { (function.name) }
                " " (format!("{:05x}-{:05x}, {words} words", function.start, function.end))
                @for found in &report.loops { ", loop " (speed(found)) }
            }
            @for (inner, found) in report.loops.iter().enumerate() {
                (loop_part(code, &format!("f{at}l{inner}"), found))
            }
            h3 { "Straight on" }
            p { (total(report.schedule.account.as_ref())) }
            @if !report.hints.is_empty() {
                ul { @for hint in &report.hints { li { (hint_text(at, hint)) } } }
            }
            (diagram(code, &format!("f{at}"), &report.schedule.lines, None))
        }
    }
}

fn total(account: Option<&Account>) -> String {
    let Some(account) = account else {
        return "There is no total, because not every word is an instruction.".into();
    };
    format!("{} cycles: {}.", account.cycles(), tally(account))
}

fn hint_text(at: usize, hint: &HintDistance) -> Markup {
    let link = |address: u32| {
        html! { a href={ "#f" (at) "-" (format!("{address:05x}")) } { (format!("{address:05x}")) } }
    };
    html! {
        "The hint " (link(hint.address)) " for the branch " (link(hint.branch)) " has "
        (hint.instructions) " instructions and " (hint.cycles) " cycles between: "
        @match hint.verdict {
            Verdict::Free => "the branch costs nothing.",
            Verdict::Waits(cycles) => { "the branch waits " (cycles) " cycles." },
            Verdict::NotSeen => "too near to be seen.",
            Verdict::Replaced(by) => { "it is replaced by " (link(by)) "." },
        }
    }
}

fn loop_part(code: &Code, id: &str, found: &Loop) -> Markup {
    let name = code.label(found.start).unwrap_or("without a name");
    html! {
        h3 id=(id) {
            "Loop " (name) " " span.place { (format!("{:05x}-{:05x}", found.start, found.branch)) }
        }
        @if let Some(steady) = &found.steady {
            @let cycles = steady.cycles_a_pass();
            p {
                strong { (number(cycles)) " cycles a pass, bound " (found.bound()) } ". "
                (limits(found))
            }
            (bars(found, cycles))
            p {
                @if steady.passes > 1 { "The schedule repeats after " (steady.passes) " passes. " }
                (total(Some(&steady.account)))
            }
            (diagram(code, id, &steady.lines, Some(Extent {
                bound: found.bound(),
                cycles,
                repeats: steady.passes == 1,
            })))
        } @else {
            p { "Not analysed: too long, not all instructions, or never the same." }
        }
    }
}

/// The causes of the bound.
fn limits(found: &Loop) -> String {
    let recurrence = found.recurrence.as_ref().map_or(0, |r| r.ceiling());
    let limits = [
        (found.even, "the even pipe"),
        (found.odd, "the odd pipe"),
        (recurrence, "the chain from pass to pass"),
    ];
    let names = limits.iter().filter(|(cycles, _)| *cycles == found.bound()).map(|(_, name)| *name);
    format!("The bound is {}.", names.collect::<Vec<_>>().join(" and "))
}

/// The bounds as bars, on the scale of the cycles that a pass takes.
fn bars(found: &Loop, cycles: f64) -> Markup {
    let chain = found.recurrence.as_ref().map(|recurrence| {
        let registers = recurrence.registers.iter().map(|r| format!("${r}"));
        let each = recurrence.cycles as f64 / recurrence.passes as f64;
        (each, registers.collect::<Vec<_>>().join(" "))
    });
    let mut rows = vec![
        ("a pass takes", cycles, String::new(), "pass"),
        ("even pipe", found.even as f64, String::new(), "even"),
        ("odd pipe", found.odd as f64, String::new(), "odd"),
    ];
    if let Some((each, registers)) = chain {
        rows.push(("chain from pass to pass", each, registers, "chain"));
    }
    let widest = rows.iter().map(|row| row.1).fold(1.0, f64::max);
    html! {
        table.bars {
            @for (name, value, remark, class) in rows {
                tr {
                    th { (name) }
                    td.n { (number(value)) }
                    td { span.bar.(class) style={ "width:" (format!("{:.0}", 240.0 * value / widest)) "px" } {} " " (remark) }
                }
            }
            tr {
                th { "longest chain in one pass" }
                td.n { (found.critical_path) }
                td { "no bound, since passes overlap" }
            }
        }
    }
}
