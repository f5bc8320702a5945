//! Where the cycles went: functions of the SPU program, and their source lines.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

use maud::{Markup, html};
use spu_reports::ProfileFile;
use spu_reports::views::{FunctionFigures, LineFigures, View};
use spu_scheduler::code::{Code, Source};

use crate::timelines::grouped;
use crate::{InspectError, Inspection};

/// The number of source lines that are shown of a function, the most expensive ones.
const LINES: usize = 12;
/// A function's stalls that are named, the largest ones.
const STALLS: usize = 3;

/// The part of the page with the functions.
pub(crate) fn section(inspection: &Inspection) -> Result<Markup, InspectError> {
    let code = Code::parse(inspection.program)?;
    let profile = ProfileFile::parse(inspection.profile)?;
    let view = View::new(&code, inspection.program, &profile)?;
    let whole = view.total().cycles();
    let functions = view.functions();
    let most = functions.first().map_or(1, |first| first.tally.cycles());
    let mut sources = Sources::default();
    let has_lines = !view.lines(None).is_empty();
    Ok(html! {
        section {
            h2 { "Where the cycles went" }
            p {
                (grouped(whole)) " cycles of all SPUs together, waits for a frame included. "
                @if inspection.earlier_frames > 0 {
                    "They include those of the frames before, of which there were "
                    (inspection.earlier_frames) ". "
                }
                "A function's "
                "cycles are its own, without those of functions that it calls. "
                @if has_lines { "A click on a function shows its most expensive source lines." }
                @else { "The SPU program has no line table, so there are no source lines; one that an "
                    "SPU assembler has built here has." }
            }
            div.row.head {
                span { "function" } span {} span.n { "cycles" } span.n { "share" } span.n { "calls" }
                span.n { "cycles a call" } span.n { "dual" } span { "stalls, in per cent of its cycles" }
            }
            @for figures in &functions {
                @let lines = view.lines(Some(&figures.function));
                @if lines.is_empty() {
                    div.row { (row(figures, whole, most)) }
                } @else {
                    details {
                        summary.row { (row(figures, whole, most)) }
                        table.lines { @for line in lines.iter().take(LINES) {
                            (source_line(line, figures.tally.cycles(), &mut sources))
                        } }
                    }
                }
            }
        }
    })
}

fn share(part: u64, whole: u64) -> f64 {
    100.0 * part as f64 / whole.max(1) as f64
}

fn row(figures: &FunctionFigures, whole: u64, most: u64) -> Markup {
    let cycles = figures.tally.cycles();
    let stalls = figures.tally.stalls.by_cost().into_iter().take(STALLS);
    let stalls = stalls
        .filter(|(_, lost)| share(*lost, cycles) >= 1.0)
        .map(|(cause, lost)| format!("{:.0} {cause}", share(lost, cycles)))
        .collect::<Vec<_>>();
    html! {
        span.name { (figures.function.name) }
        span { span.bar style={ "width:" (format!("{:.1}", share(cycles, most))) "%" } {} }
        span.n { (grouped(cycles)) }
        span.n { (format!("{:.1} %", share(cycles, whole))) }
        span.n { (grouped(figures.calls)) }
        span.n { @if let Some(each) = figures.cycles_a_call() { (format!("{each:.0}")) } }
        span.n { (format!("{:.0} %", 100.0 * figures.tally.dual_share())) }
        span { (stalls.join(", ")) }
    }
}

fn source_line(line: &LineFigures, whole: u64, sources: &mut Sources) -> Markup {
    let cycles = line.tally.cycles();
    let name = line.source.file.file_name().map_or_else(
        || line.source.file.display().to_string(),
        |name| name.to_string_lossy().into_owned(),
    );
    html! {
        tr {
            td.n { (grouped(cycles)) }
            td.n { (format!("{:.1} %", share(cycles, whole))) }
            td { (name) ":" (line.source.line) }
            td { code { (sources.line(&line.source)) } }
            td { @if let Some((cause, lost)) = line.tally.largest_stall() { (grouped(lost)) " " (cause) } }
        }
    }
}

/// The texts of the source files that can be read here.
#[derive(Default)]
struct Sources(HashMap<PathBuf, Vec<String>>);

impl Sources {
    fn line(&mut self, source: &Source) -> String {
        let read = |path: &Path| {
            let text = fs::read_to_string(path).unwrap_or_default();
            text.lines().map(str::to_owned).collect()
        };
        let lines = self.0.entry(source.file.clone()).or_insert_with(|| read(&source.file));
        let at = usize::try_from(source.line).ok().and_then(|line| line.checked_sub(1));
        let line = at.and_then(|at| lines.get(at)).map_or("", String::as_str);
        line.split_whitespace().collect::<Vec<_>>().join(" ")
    }
}
