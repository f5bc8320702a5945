//! Register allocation for the overlapping passes of a loop.
//!
//! A value occupies its register from the instruction that makes it to the last that reads it.
//! This range wraps around at the end of the interval. Values that one pass hands to the next, or
//! that are live after the loop, keep the register of the source, and no other value uses that
//! register.

use super::function::{Node, POOL, Registers, bit};
use super::values::{Source, Values};
use spu_isa::Pipe;

/// The nodes with registers, and the number of registers, or `None` if there are too few. `live`
/// are the registers that are live at the start of the loop or after it.
pub(super) fn colour(
    nodes: &[Node],
    times: &[i64],
    interval: i64,
    live: Registers,
) -> Option<(Vec<Node>, u32)> {
    let values = Values::of(nodes);
    let place = |at: usize| 2 * times[at] + i64::from(nodes[at].pipe() == Pipe::Odd);
    let round = 2 * interval as usize;
    let mut until: Vec<i64> = (0..nodes.len()).map(|at| place(at) + 1).collect();
    for (reader, reads) in values.reads.iter().enumerate() {
        for &(_, source) in reads {
            let (from, passes) = match source {
                Source::Node(from) => (from, 0),
                Source::Entry(register) => match values.last[usize::from(register)] {
                    Some(from) => (from, 1),
                    None => continue,
                },
            };
            until[from] = until[from].max(place(reader) + passes * round as i64);
        }
    }
    let stays = |at: usize| {
        nodes[at].writes().is_some_and(|register| {
            let slot = usize::from(register);
            register < 128 && live & bit(register) != 0 && values.last[slot] == Some(at)
        })
    };
    let mut taken: Vec<Vec<bool>> = vec![vec![false; round]; 128];
    let mut registers: Vec<u8> = nodes.iter().map(|node| node.i.rt).collect();
    let mut order: Vec<usize> = (0..nodes.len())
        .filter(|&at| nodes[at].writes().is_some() && !stays(at))
        .collect();
    order.sort_by_key(|&at| (place(at).rem_euclid(round as i64), at));
    for at in order {
        let own = nodes[at].i.rt;
        // From after the instruction up to the last reader of its value.
        let first = place(at) + 1;
        let span: Vec<usize> = (first..=until[at])
            .map(|place| place.rem_euclid(round as i64) as usize)
            .collect();
        let free = |register: &u8| {
            let rows = &taken[usize::from(*register)];
            live & bit(*register) == 0 && span.iter().all(|&row| !rows[row])
        };
        let own = Some(own).filter(|own| POOL.contains(own));
        let chosen = own.into_iter().chain(POOL).find(free)?;
        for row in span {
            taken[usize::from(chosen)][row] = true;
        }
        registers[at] = chosen;
    }
    let mut coloured = nodes.to_vec();
    let mut used: Registers = 0;
    for (at, node) in coloured.iter_mut().enumerate() {
        for &(field, source) in &values.reads[at] {
            match source {
                Source::Node(from) => node.set_register(field, registers[from]),
                Source::Entry(register) => {
                    if let Some(from) = values.last[usize::from(register)] {
                        node.set_register(field, registers[from]);
                    }
                }
            }
        }
        if node.writes().is_some() {
            node.i.rt = registers[at];
        }
        used |= node.writes().map_or(0, bit);
        used |= node
            .reads()
            .fold(0, |set, (_, register)| set | bit(register));
    }
    Some((coloured, used.count_ones()))
}
