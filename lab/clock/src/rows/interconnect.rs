//! Rows of transfers between local stores.

use super::{ALL, Row, Stream, cycles, read};
use crate::order::{Benchmark, GET, Measured, Order};
use crate::spes::{ClockError, Mapped, Ppe, run};

const STREAM: Stream = Stream { opcode: GET, size: 16384, depth: 4, passes: 60 };

pub fn rows() -> Vec<Row> {
    let mut rows = vec![
        Row::new(
            "store-one",
            "one SPU reads another one's local store",
            "GB/s",
            read(23.58, "a benchmark: 22.97 to 23.60 over 30 pairs", 0.05),
            || flows(2, |number| (number == 0).then_some(1)),
        ),
        Row::new(
            "store-five",
            "five SPUs read one local store",
            "GB/s",
            read(23.72, "a benchmark", 0.05),
            || flows(ALL, |number| (number != 0).then_some(0)),
        ),
        Row::new(
            "store-pairs",
            "three pairs of SPUs read each other's local stores",
            "GB/s",
            read(114.7, "a benchmark", 0.05),
            || flows(ALL, |number| Some(number ^ 1)),
        ),
    ];
    for other in 1..ALL {
        rows.push(Row::new(
            format!("store-latency-{other}"),
            format!("get of 128 B by SPU 0 from the local store of SPU {other}, until complete"),
            "cycles",
            None,
            move || latency(other),
        ));
        rows.push(Row::new(
            format!("store-rate-{other}"),
            format!("SPU 0 reads the local store of SPU {other}"),
            "GB/s",
            None,
            move || flows(ALL, |number| (number == 0).then_some(other)),
        ));
        rows.push(Row::new(
            format!("store-both-{other}"),
            format!("SPUs 0 and {other} read each other's local stores"),
            "GB/s",
            None,
            move || {
                flows(ALL, |number| match number {
                    0 => Some(other),
                    _ => (number == other).then_some(0),
                })
            },
        ));
        rows.push(Row::new(
            format!("signal-{other}"),
            format!("a signal of SPU 0 to SPU {other} by sndsig, and one back"),
            "cycles",
            None,
            move || signals(other),
        ));
    }
    rows
}

/// GB/s of SPUs that read the local store of which the function has the number, if any.
fn flows(spes: usize, from: impl Fn(usize) -> Option<usize>) -> Result<f64, ClockError> {
    STREAM.rate(spes, Mapped::Stores, |place, number| from(number).map(|other| place.store(other)))
}

/// Cycles from a command of SPU 0 until 128 bytes of another local store have arrived.
fn latency(other: usize) -> Result<f64, ClockError> {
    let stream = Stream { size: 128, depth: 1, passes: 1000, ..STREAM };
    let of = |benchmark| {
        let measured = run(ALL, Mapped::Stores, Ppe::Waits, |place, number| {
            if number == 0 {
                Order { benchmark, mask: 0, ..stream.order(place.store(other)) }
            } else {
                Order::new(Benchmark::HintedLoop, 1)
            }
        })?;
        let first: &[Measured] = &measured[..1];
        Ok::<f64, ClockError>(cycles(first) / f64::from(stream.passes))
    };
    Ok(of(Benchmark::Stream)? - of(Benchmark::StreamWithoutCommand)?)
}

/// Cycles of a signal of SPU 0 to another one, and of its reply.
fn signals(other: usize) -> Result<f64, ClockError> {
    let passes = 1000;
    let measured = run(ALL, Mapped::Signals, Ppe::Waits, |place, number| {
        let partner = match number {
            0 => other,
            _ if number == other => 0,
            _ => return Order::new(Benchmark::HintedLoop, 1),
        };
        Order {
            ea: place.signal(partner),
            number: number as u32,
            ..Order::new(Benchmark::SignalsOfSpes, passes)
        }
    })?;
    Ok(cycles(&measured[..1]) / f64::from(passes))
}
