//! The figures of simulated time that are shown. Every report uses the same.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde::Serialize;

use spu_emulator::simulated::SpeReport;

/// The use of the cycles of one SPE, or of several SPEs together.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Figures {
    /// Cycles in which the SPE ran: the sum of `single_issue`, `dual_issue` and `stalls`.
    pub cycles: u64,
    /// Instructions issued.
    pub instructions: u64,
    /// Cycles in which one instruction issued.
    pub single_issue: u64,
    /// Cycles in which two instructions issued.
    pub dual_issue: u64,
    /// Share of the issuing cycles in which two instructions issued.
    pub dual_issue_rate: f64,
    /// Cycles in which no instruction issued, by cause.
    pub stalls: BTreeMap<String, u64>,
    /// Cycles in which it did not sleep in a channel.
    pub busy: u64,
    /// Cycles in which it slept in a channel.
    pub blocked: u64,
    /// The same cycles by the event that it waited for.
    pub blocked_by: BTreeMap<&'static str, u64>,
    /// MFC commands that went through the queue.
    pub dma_commands: u64,
    /// Atomic MFC commands.
    pub atomic_commands: u64,
    /// Bytes that queued commands moved into local store.
    pub bytes_in: u64,
    /// Bytes that queued commands moved out of local store.
    pub bytes_out: u64,
}

impl Figures {
    /// Adds the figures of an SPE.
    pub fn add(&mut self, spe: &SpeReport) {
        let account = &spe.account;
        self.cycles += account.cycles();
        self.instructions += account.instructions();
        self.single_issue += account.single();
        self.dual_issue += account.dual();
        let issuing = self.single_issue + self.dual_issue;
        self.dual_issue_rate = self.dual_issue as f64 / issuing.max(1) as f64;
        for (cause, cycles) in account.waits() {
            *self.stalls.entry(cause.to_string()).or_default() += cycles;
        }
        self.busy += spe.busy();
        self.blocked += spe.waits.total();
        let waits = &spe.waits;
        for (name, cycles) in [
            ("mailbox", waits.mailbox),
            ("signal", waits.signal),
            ("event", waits.event),
            ("tag", waits.tag),
            ("list", waits.list),
            ("atomic", waits.atomic),
            ("queue", waits.queue),
        ] {
            *self.blocked_by.entry(name).or_default() += cycles;
        }
        self.dma_commands += spe.commands.queued;
        self.atomic_commands += spe.commands.atomic;
        self.bytes_in += spe.commands.bytes_in;
        self.bytes_out += spe.commands.bytes_out;
    }

    /// A table for people with one figure a line. Stalls include their share of all cycles.
    #[must_use]
    pub fn table(&self) -> String {
        let mut text = String::new();
        let mut line = |name: &str, value: String| {
            let _ = writeln!(text, "{name:28}{value:>14}");
        };
        line("cycles", self.cycles.to_string());
        line("instructions", self.instructions.to_string());
        line("single issue", self.single_issue.to_string());
        line("dual issue", self.dual_issue.to_string());
        line("dual-issue rate", format!("{:.1} %", self.dual_issue_rate * 100.0));
        let mut stalls: Vec<_> = self.stalls.iter().collect();
        stalls.sort_by_key(|(_, cycles)| std::cmp::Reverse(**cycles));
        for (cause, &cycles) in stalls {
            let share = cycles as f64 / self.cycles.max(1) as f64 * 100.0;
            line(cause, format!("{cycles} {share:5.1} %"));
        }
        line("blocked in channels", self.blocked.to_string());
        line("MFC commands", (self.dma_commands + self.atomic_commands).to_string());
        line("  bytes", (self.bytes_in + self.bytes_out).to_string());
        text
    }
}
