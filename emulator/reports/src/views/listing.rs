//! The view of a profile as text: the tables of functions and lines, and the annotated listing of
//! a function.

use std::collections::{BTreeMap, HashMap};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use super::figures::FunctionFigures;
use super::view::View;
use spu_emulator::profile::Tally;
use spu_isa::disassemble;
use spu_scheduler::code::{Function, Source};

type Read<'r> = &'r mut dyn FnMut(&Path) -> Option<String>;

/// The texts of those source files that can be read.
struct Sources<'r> {
    read: Read<'r>,
    files: HashMap<PathBuf, Vec<String>>,
}

impl<'r> Sources<'r> {
    fn new(read: Read<'r>) -> Self {
        Self { read, files: HashMap::new() }
    }

    /// `folder/file.s:12  the line`, with each run of blanks reduced to one.
    fn describe(&mut self, source: &Source) -> String {
        let mut ends = source.file.iter().rev();
        let name: PathBuf = match (ends.next(), ends.next()) {
            (Some(name), Some(folder)) => [folder, name].iter().collect(),
            _ => source.file.clone(),
        };
        let place = format!("{}:{}", name.display(), source.line);
        match self.line(source) {
            Some(line) => format!("{place:<28} {line}"),
            None => place,
        }
    }

    fn line(&mut self, source: &Source) -> Option<String> {
        if !self.files.contains_key(&source.file) {
            let text = (self.read)(&source.file).unwrap_or_default();
            let lines = text.lines().map(str::to_owned).collect();
            self.files.insert(source.file.clone(), lines);
        }
        let at = usize::try_from(source.line).ok()?.checked_sub(1)?;
        let line = self.files[&source.file].get(at)?;
        Some(line.split_whitespace().collect::<Vec<_>>().join(" "))
    }
}

fn share(part: u64, whole: u64) -> f64 {
    100.0 * part as f64 / whole.max(1) as f64
}

/// Stalls as shares of `whole`, the largest first, and at most `most` of them.
fn stalls(tally: &Tally, whole: u64, most: usize) -> String {
    let stalls = tally.stalls.by_cost().into_iter().take(most);
    let texts = stalls.map(|(cause, cycles)| format!("{:.0} % {cause}", share(cycles, whole)));
    texts.collect::<Vec<_>>().join(", ")
}

fn summary(text: &mut String, what: &str, tally: &Tally) {
    // Writing to a string can't fail.
    let _ = writeln!(
        text,
        "{what}: {} cycles, {} instructions, {:.1} % of the issuing cycles dual, {} stalled",
        tally.cycles(),
        tally.issued,
        100.0 * tally.dual_share(),
        tally.stalls.total()
    );
}

pub(super) fn functions(view: &View<'_>) -> String {
    let total = view.total();
    let mut text = String::new();
    summary(&mut text, "all", &total);
    let _ = writeln!(
        text,
        "{:>12} {:>6} {:>10} {:>11} {:>6} {:>8}  {:<24} function",
        "cycles", "share", "calls", "cycles/call", "dual", "stalled", "largest stall"
    );
    for figures in view.functions() {
        let tally = &figures.tally;
        let cycles = tally.cycles();
        let each = figures.cycles_a_call();
        let _ = writeln!(
            text,
            "{cycles:>12} {:>5.1}% {:>10} {:>11} {:>5.1}% {:>7.1}%  {:<24} {}",
            share(cycles, total.cycles()),
            figures.calls,
            each.map_or("-".into(), |each| format!("{each:.1}")),
            100.0 * tally.dual_share(),
            share(tally.stalls.total(), cycles),
            stalls(tally, cycles, 1),
            figures.function.name
        );
    }
    text
}

pub(super) fn function(view: &View<'_>, figures: &FunctionFigures, read: Read<'_>) -> String {
    let mut sources = Sources::new(read);
    let lines: BTreeMap<_, _> = view.code.sources().into_iter().collect();
    let whole = figures.tally.cycles();
    let mut text = String::new();
    summary(&mut text, &figures.function.name, &figures.tally);
    if let Some(each) = figures.cycles_a_call() {
        let _ = writeln!(text, "{} calls, {each:.1} cycles each", figures.calls);
    }
    let _ = writeln!(
        text,
        "{:>12} {:>6} {:>10} {:>7} {:>4}  {:<5}  {:<32} {:<44} source",
        "cycles", "share", "count", "each", "dual", "at", "instruction", "stalls"
    );
    for (address, word, tally) in view.instructions(&figures.function) {
        if let Some(label) = view.code.label(address) {
            let _ = writeln!(text, "{label}:");
        }
        let cycles = tally.cycles();
        let figures = if tally.issued == 0 && cycles == 0 {
            " ".repeat(43)
        } else {
            format!(
                "{cycles:>12} {:>5.1}% {:>10} {:>7.2} {:>4}",
                share(cycles, whole),
                tally.issued,
                cycles as f64 / tally.issued.max(1) as f64,
                match share(tally.joined, tally.issued) {
                    0.0 => String::new(),
                    joined => format!("{joined:.0}%"),
                }
            )
        };
        let instruction = disassemble(word, address).to_string();
        let instruction = instruction.split("\t#").next().unwrap_or_default();
        let row = format!(
            "{figures}  {address:05x}  {:<32} {:<44} {}",
            instruction.replace('\t', " "),
            stalls(&tally, cycles, 2),
            lines.get(&address).map_or(String::new(), |source| sources.describe(source)),
        );
        text.push_str(row.trim_end());
        text.push('\n');
    }
    text
}

pub(super) fn lines(view: &View<'_>, function: Option<&Function>, read: Read<'_>) -> String {
    let mut sources = Sources::new(read);
    let total = view.total().cycles();
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{:>12} {:>6} {:>10} {:<44} {:<24} source",
        "cycles", "share", "issued", "stalls", "function"
    );
    for line in view.lines(function) {
        let cycles = line.tally.cycles();
        let row = format!(
            "{cycles:>12} {:>5.1}% {:>10} {:<44} {:<24} {}",
            share(cycles, total),
            line.tally.issued,
            stalls(&line.tally, cycles, 2),
            line.function.as_deref().unwrap_or_default(),
            sources.describe(&line.source)
        );
        text.push_str(row.trim_end());
        text.push('\n');
    }
    text
}
