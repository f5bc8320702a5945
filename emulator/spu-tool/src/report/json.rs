//! The report as JSON. Addresses and words are numbers; pipes are `even` and `odd`.

use serde::Serialize;
use serde_json::{Map, Value, json};
use spu_isa::timing::{Account, HintDistance, Issue, Line, Loop, Verdict};
use spu_isa::{Pipe, disassemble};
use spu_scheduler::code::Code;

use super::function::FunctionReport;

/// The cause of an instruction's delay.
#[derive(Serialize)]
struct Wait {
    cause: String,
    cycles: u64,
    register: Option<u8>,
    producer: Option<u32>,
}

/// How an instruction issued.
#[derive(Serialize)]
struct Issued {
    cycle: u64,
    ready: u64,
    pipe: &'static str,
    dual: bool,
    missed_dual: bool,
    waited: Option<Wait>,
}

/// A word of code.
#[derive(Serialize)]
struct Row<'a> {
    address: u32,
    word: u32,
    #[serde(skip_serializing_if = "Option::is_none")]
    label: Option<&'a str>,
    text: String,
    issued: Option<Issued>,
}

pub(super) fn document(code: &Code, functions: &[FunctionReport]) -> String {
    let functions: Vec<Value> = functions
        .iter()
        .map(|report| {
            json!({
                "name": report.function.name,
                "start": report.function.start,
                "end": report.function.end,
                "total": report.schedule.account.as_ref().map(tally),
                "instructions": rows(code, &report.schedule.lines),
                "hints": report.hints.iter().map(hint).collect::<Value>(),
                "loops": report.loops.iter().map(|found| loop_value(code, found)).collect::<Value>(),
            })
        })
        .collect();
    format!("{:#}\n", json!({ "functions": functions }))
}

fn rows<'a>(code: &'a Code, lines: &[Line]) -> Vec<Row<'a>> {
    let row = |line: &Line| Row {
        address: line.address,
        word: line.word,
        label: code.label(line.address),
        text: disassemble(line.word, line.address).to_string(),
        issued: line.issued.map(|(_, issue)| issued(line, &issue)),
    };
    lines.iter().map(row).collect()
}

fn issued(line: &Line, issue: &Issue) -> Issued {
    Issued {
        cycle: issue.cycle,
        ready: issue.ready_cycle,
        pipe: match issue.pipe {
            Pipe::Even => "even",
            Pipe::Odd => "odd",
        },
        dual: issue.dual,
        missed_dual: issue.missed_dual,
        waited: issue.waited.map(|cause| Wait {
            cause: cause.to_string(),
            cycles: issue.waited_cycles,
            register: issue.waited_register,
            producer: line.producer,
        }),
    }
}

fn tally(account: &Account) -> Value {
    let waits = account.waits();
    let stalls: Map<String, Value> =
        waits.iter().map(|(cause, cycles)| (cause.to_string(), (*cycles).into())).collect();
    json!({
        "cycles": account.cycles(),
        "instructions": account.instructions(),
        "single_cycles": account.single(),
        "dual_cycles": account.dual(),
        "stalls": stalls,
    })
}

fn hint(hint: &HintDistance) -> Value {
    let (verdict, waits) = match hint.verdict {
        Verdict::Free => ("free", 0),
        Verdict::Waits(cycles) => ("waits", cycles),
        Verdict::NotSeen => ("not seen", 0),
        Verdict::Replaced(_) => ("replaced", 0),
    };
    json!({
        "address": hint.address,
        "branch": hint.branch,
        "instructions": hint.instructions,
        "cycles": hint.cycles,
        "verdict": verdict,
        "waits": waits,
    })
}

fn loop_value(code: &Code, found: &Loop) -> Value {
    let recurrence = found.recurrence.as_ref().map(|recurrence| {
        json!({
            "cycles": recurrence.cycles,
            "passes": recurrence.passes,
            "registers": recurrence.registers,
        })
    });
    let steady = found.steady.as_ref().map(|steady| {
        json!({
            "passes": steady.passes,
            "cycles_a_pass": steady.cycles_a_pass(),
            "total": tally(&steady.account),
            "instructions": rows(code, &steady.lines),
        })
    });
    json!({
        "start": found.start,
        "branch": found.branch,
        "steady": steady,
        "bound": found.bound(),
        "even": found.even,
        "odd": found.odd,
        "critical_path": found.critical_path,
        "recurrence": recurrence,
    })
}
