//! The view of a profile as JSON. Addresses and words are numbers.

use serde_json::{Map, Value, json};

use super::figures::{FunctionFigures, LineFigures};
use super::view::View;
use spu_emulator::profile::Tally;
use spu_isa::disassemble;
use spu_scheduler::code::Function;

pub(super) fn document(view: &View<'_>, function: Option<&FunctionFigures>) -> String {
    let functions = match function {
        Some(figures) => vec![with_instructions(view, figures)],
        None => view.functions().iter().map(function_value).collect(),
    };
    let lines = view.lines(function.map(|figures| &figures.function));
    let document = json!({
        "cycles_per_second": view.cycles_per_second,
        "total": tally_value(&view.total()),
        "functions": functions,
        "lines": lines.iter().map(line_value).collect::<Value>(),
    });
    format!("{document:#}\n")
}

fn tally_value(tally: &Tally) -> Value {
    let stalls = tally.stalls.by_cost().into_iter();
    let stalls: Map<_, _> =
        stalls.map(|(cause, cycles)| (cause.to_string(), cycles.into())).collect();
    json!({
        "cycles": tally.cycles(),
        "issued": tally.issued,
        "joined": tally.joined,
        "stalls": stalls,
    })
}

fn function_value(figures: &FunctionFigures) -> Value {
    json!({
        "name": figures.function.name,
        "start": figures.function.start,
        "end": figures.function.end,
        "calls": figures.calls,
        "total": tally_value(&figures.tally),
    })
}

fn with_instructions(view: &View<'_>, figures: &FunctionFigures) -> Value {
    let mut value = function_value(figures);
    value["instructions"] = instructions(view, &figures.function);
    value
}

fn instructions(view: &View<'_>, function: &Function) -> Value {
    let rows = view.instructions(function).into_iter();
    rows.map(|(address, word, tally)| {
        json!({
            "address": address,
            "word": word,
            "text": disassemble(word, address).to_string(),
            "total": tally_value(&tally),
        })
    })
    .collect()
}

fn line_value(line: &LineFigures) -> Value {
    json!({
        "file": line.source.file.to_string_lossy(),
        "line": line.source.line,
        "function": line.function,
        "total": tally_value(&line.tally),
    })
}
