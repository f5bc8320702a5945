//! The listing, in the style of IBM's static analyser.
//!
//! Each row shows the issue cycle; the pipe (0 even, 1 odd); `D` for a pair that issued together,
//! or `d` for the second of a pair that would have if it had been ready; the cycles in flight as
//! their last digits, in the column of the cycle modulo 50, after a dash for each cycle of
//! waiting; the address and the instruction; and what it waited for.

use std::fmt::Write as _;

use spu_isa::timing::{Account, HintDistance, Issue, Line, Loop, Schedule, Verdict};
use spu_isa::{Pipe, disassemble};
use spu_scheduler::code::Code;

use super::function::{FunctionReport, waits};

const COLUMNS: usize = 50;

/// Appends the part for one function.
pub(super) fn function(text: &mut String, code: &Code, report: &FunctionReport) {
    let function = &report.function;
    // Writing to a string can't fail.
    let _ = writeln!(
        text,
        "{}  {:05x}-{:05x}, {} words",
        function.name,
        function.start,
        function.end,
        report.schedule.lines.len()
    );
    rows(text, code, &report.schedule.lines);
    text.push_str(&summary(&report.schedule));
    for hint in &report.hints {
        describe_hint(text, hint);
    }
    for found in &report.loops {
        describe_loop(text, code, found);
    }
    text.push('\n');
}

fn summary(schedule: &Schedule) -> String {
    let Some(account) = &schedule.account else {
        return "  no total: not every word is an instruction\n".into();
    };
    format!("  {} cycles straight on: {}\n", account.cycles(), tally(account))
}

/// The instructions, pairs and stalls of an account.
pub(super) fn tally(account: &Account) -> String {
    let mut text = format!(
        "{} instructions, {} dual ({:.0} % of the issuing cycles), {} stalled",
        account.instructions(),
        account.dual(),
        100.0 * account.dual_share(),
        account.stalled()
    );
    if account.stalled() > 0 {
        let _ = write!(text, " ({})", waits(account));
    }
    text
}

fn describe_hint(text: &mut String, hint: &HintDistance) {
    let verdict = match hint.verdict {
        Verdict::Free => "free".into(),
        Verdict::Waits(cycles) => format!("waits {cycles} cycles"),
        Verdict::NotSeen => "too near to be seen".into(),
        Verdict::Replaced(by) => format!("replaced by {by:05x}"),
    };
    let _ = writeln!(
        text,
        "  hint {:05x} for branch {:05x}, {} instructions between, {} cycles: {verdict}",
        hint.address, hint.branch, hint.instructions, hint.cycles
    );
}

fn describe_loop(text: &mut String, code: &Code, found: &Loop) {
    let name = code.label(found.start).unwrap_or("loop");
    let _ = writeln!(
        text,
        "  loop {name}  {:05x}-{:05x}, {} words",
        found.start, found.branch, found.instructions
    );
    let Some(steady) = &found.steady else {
        text.push_str("    not analysed: too long, not all instructions, or never the same\n");
        return;
    };
    let cycles = steady.cycles_a_pass();
    let _ = writeln!(text, "    {} cycles a pass, bound {}", number(cycles), found.bound());
    let _ = write!(text, "    bounds: even {}, odd {}, recurrence ", found.even, found.odd);
    match &found.recurrence {
        None => text.push_str("none"),
        Some(recurrence) => {
            let each = recurrence.cycles as f64 / recurrence.passes as f64;
            let registers = recurrence.registers.iter().map(|r| format!("${r}"));
            let registers = registers.collect::<Vec<_>>().join(" ");
            let _ = write!(text, "{} ({registers})", number(each));
        }
    }
    let _ = writeln!(text, "; critical path {}", found.critical_path);
    let period = match steady.passes {
        1 => "a pass".into(),
        passes => format!("{passes} passes"),
    };
    let _ = writeln!(text, "    {period}: {}", tally(&steady.account));
    rows(text, code, &steady.lines);
}

/// Formats whole numbers without a fraction.
pub(super) fn number(value: f64) -> String {
    if value.fract() == 0.0 { format!("{value:.0}") } else { format!("{value:.2}") }
}

fn rows(text: &mut String, code: &Code, lines: &[Line]) {
    for (at, line) in lines.iter().enumerate() {
        if let Some(label) = code.label(line.address) {
            let _ = writeln!(text, "{label}:");
        }
        // `D` marks both instructions of a pair, but only the second shows that they are a pair.
        let next = lines.get(at + 1).and_then(|next| next.issued);
        let leads = next.is_some_and(|(_, issue)| issue.dual);
        text.push_str(row(line, leads).trim_end());
        text.push('\n');
    }
}

fn row(line: &Line, leads: bool) -> String {
    let instruction = disassemble(line.word, line.address).to_string();
    let instruction = instruction.replacen('\t', " ", 1).replace('\t', " ");
    let Some((_, issue)) = line.issued else {
        return format!("{:11}{:COLUMNS$} {:05x}  {instruction}", "", "", line.address);
    };
    let pair = if leads || issue.dual {
        'D'
    } else if issue.missed_dual {
        'd'
    } else {
        ' '
    };
    let pipe = match issue.pipe {
        Pipe::Even => 0,
        Pipe::Odd => 1,
    };
    format!(
        "{:06} {pipe}{pair}  {} {:05x}  {instruction:<32}{}",
        issue.cycle,
        picture(&issue),
        line.address,
        reason(line, &issue)
    )
}

fn picture(issue: &Issue) -> String {
    let mut columns = [' '; COLUMNS];
    let in_flight = (issue.ready_cycle - issue.cycle).max(1);
    let free_columns = (COLUMNS as u64).saturating_sub(in_flight);
    let waiting = issue.waited_cycles.min(free_columns).min(issue.cycle);
    for cycle in issue.cycle - waiting..issue.cycle {
        columns[cycle as usize % COLUMNS] = '-';
    }
    for cycle in issue.cycle..issue.cycle + in_flight {
        let digit = char::from(b'0' + (cycle % 10) as u8);
        columns[cycle as usize % COLUMNS] = digit;
    }
    columns.iter().collect()
}

fn reason(line: &Line, issue: &Issue) -> String {
    let Some(cause) = issue.waited else {
        return String::new();
    };
    let mut text = match issue.waited_cycles {
        0 => format!("; pair lost: {cause}"),
        cycles => format!("; {cycles} {cause}"),
    };
    if let Some(register) = issue.waited_register {
        let _ = write!(text, " ${register}");
    }
    if let Some(producer) = line.producer {
        let _ = write!(text, " from {producer:05x}");
    }
    text
}
