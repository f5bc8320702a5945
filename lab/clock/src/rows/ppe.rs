//! Rows of what SPU and PPE exchange through libspe2. Another system's figure (11.6 us for a
//! mailbox and back by an event queue) is not comparable.

use super::{Row, cycles};
use crate::GIGAHERTZ;
use crate::order::{Benchmark, Order};
use crate::spes::{ClockError, Mapped, Ppe, run};

pub fn rows() -> Vec<Row> {
    let row = |name: &str, what: &str, benchmark, ppe| {
        let what = format!("a word to the PPE by the interrupt mailbox, and back {what}");
        Row::new(name, what, "us", None, move || round_trip(benchmark, ppe))
    };
    vec![
        row("mail", "by the inbound mailbox", Benchmark::Mail, Ppe::Mails),
        row("signal", "as a signal", Benchmark::Signals, Ppe::Signals),
    ]
}

/// Microseconds of a word to the PPE, which polls, and of its reply.
fn round_trip(benchmark: Benchmark, ppe: Ppe) -> Result<f64, ClockError> {
    let passes = 300;
    let measured = run(1, Mapped::Nothing, ppe, |_, _| Order::new(benchmark, passes))?;
    Ok(cycles(&measured) / f64::from(passes) / GIGAHERTZ / 1000.0)
}
