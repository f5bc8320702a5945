//! Rows of main memory, of puts to one line, and of atomic commands.

use super::{ALL, LINE, Row, Stream, cycles, read};
use crate::order::{Benchmark, GET, Measured, Order, PUT};
use crate::spes::{ClockError, Mapped, Ppe, run};

/// Six busy SPUs lose a share to the console's own system: what they do takes 1.062 times as long.
const NET: &str = "a benchmark on six SPUs, divided by 1.062";

pub fn rows() -> Vec<Row> {
    let mut rows = vec![
        Row::new(
            "put-32",
            "put of 32 B to an own line, six SPUs, from the command until it is complete",
            "cycles",
            read(330.0, NET, 0.05),
            || stream(PUT, 32, 1, 3000).latency(ALL),
        ),
        Row::new(
            "put-16k-waited",
            "put of 16 KB, waited for, six SPUs: the time of a line of 128 B",
            "cycles",
            read(17.3, NET, 0.05),
            || Ok(line_cycles(in_memory(stream(PUT, 16384, 1, 100), ALL)?)),
        ),
    ];
    for (opcode, name, value) in [(GET, "get", 22.83 * 1.062), (PUT, "put", 22.13 * 1.062)] {
        for (size, depth) in [(256, 2), (256, 8), (2048, 2), (16384, 2), (16384, 8)] {
            rows.push(Row::new(
                format!("{name}-{size}-{depth}"),
                format!("{name} of {size} B, {depth} in flight, six SPUs"),
                "GB/s",
                read(value, NET, 0.05),
                move || in_memory(stream(opcode, size, depth, (1 << 20) / size), ALL),
            ));
        }
    }
    rows.extend(atomics());
    rows.extend(unpublished());
    rows
}

fn atomics() -> Vec<Row> {
    vec![
        Row::new(
            "put-one-line",
            "puts of 32 B by six SPUs to one line, not waited for",
            "cycles a put",
            read(200.0, NET, 0.05),
            || {
                let measured = run(ALL, Mapped::Nothing, Ppe::Waits, |place, _| Order {
                    opcode: PUT,
                    size: 32,
                    depth: 16,
                    ea: place.memory(0),
                    ..Order::new(Benchmark::Stream, 1000)
                })?;
                Ok(cycles(&measured) / (1000.0 * ALL as f64))
            },
        ),
        Row::new(
            "putlluc",
            "putlluc of six SPUs to one line",
            "cycles a command",
            read(193.0, NET, 0.05),
            || {
                let passes = 1000;
                let measured = on_one_line(ALL, Benchmark::Putlluc, passes)?;
                Ok(cycles(&measured) / f64::from(passes) / ALL as f64)
            },
        ),
        Row::new(
            "increment",
            "atomic increments by six SPUs: getllar and putllc until it succeeds",
            "cycles a success",
            read(562.0, NET, 0.05),
            || Ok(cycles(&on_one_line(ALL, Benchmark::Increments, 6000)?) / 6000.0),
        ),
        Row::new(
            "ping-pong",
            "two SPUs that increment a line in turn",
            "cycles a bounce",
            read(479.0, "a benchmark on two SPUs: 150 ns", 0.05),
            || Ok(cycles(&on_one_line(2, Benchmark::PingPong, 4000)?) / 4000.0),
        ),
        Row::new(
            "fairness",
            "atomic increments by six SPUs: the min share of an SPU, where 1 is a sixth",
            "share",
            None,
            || {
                let measured = on_one_line(ALL, Benchmark::Increments, 6000)?;
                let min = measured.iter().map(|spu| spu.done).min().unwrap_or(0);
                Ok(f64::from(min) * ALL as f64 / 6000.0)
            },
        ),
        Row::new(
            "increment-alone",
            "atomic increments by one SPU",
            "cycles a success",
            None,
            || Ok(cycles(&on_one_line(1, Benchmark::Increments, 3000)?) / 3000.0),
        ),
    ]
}

/// What nobody has published.
fn unpublished() -> Vec<Row> {
    let mut rows = Vec::new();
    for (opcode, name) in [(GET, "get"), (PUT, "put")] {
        for size in [16, 128, 1024, 4096, 16384] {
            rows.push(Row::new(
                format!("{name}-latency-{size}"),
                format!("{name} of {size} B by one SPU, from the command until it is complete"),
                "cycles",
                None,
                move || stream(opcode, size, 1, 2000).latency(1),
            ));
        }
        rows.push(Row::new(
            format!("{name}-alone"),
            format!("{name} of 16 KB by one SPU, 8 in flight"),
            "GB/s",
            None,
            move || in_memory(stream(opcode, 16384, 8, 200), 1),
        ));
    }
    for size in [8, 128] {
        rows.push(Row::new(
            format!("list-element-{size}"),
            format!("an element of {size} B of a get list, by one SPU"),
            "cycles",
            None,
            move || {
                let of =
                    |depth| super::alone(Order { size, depth, ..Order::new(Benchmark::List, 300) });
                Ok((of(256)? - of(128)?) / 128.0)
            },
        ));
    }
    rows
}

fn stream(opcode: u32, size: u32, depth: u32, passes: u32) -> Stream {
    Stream { opcode, size, depth, passes }
}

/// GB/s of SPEs that use each their own main memory.
fn in_memory(stream: Stream, spes: usize) -> Result<f64, ClockError> {
    stream.rate(spes, Mapped::Nothing, |place, number| Some(place.memory(number)))
}

/// Cycles of a line at a rate in GB/s.
fn line_cycles(rate: f64) -> f64 {
    LINE * crate::GIGAHERTZ / rate
}

/// All SPUs use the first line of main memory.
fn on_one_line(
    spes: usize,
    benchmark: Benchmark,
    passes: u32,
) -> Result<Vec<Measured>, ClockError> {
    run(spes, Mapped::Nothing, Ppe::Waits, |place, number| Order {
        ea: place.memory(0),
        number: number as u32,
        ..Order::new(benchmark, passes)
    })
}
