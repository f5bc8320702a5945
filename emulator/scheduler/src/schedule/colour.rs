//! Register allocation for the overlapping passes of a loop.
//!
//! A value occupies its register from the instruction that makes it to the last that reads it. This
//! range wraps around at the end of the kernel. If the kernel contains several passes, a value has
//! a register in each. Values that one pass hands to the next, or that are live after the loop,
//! keep the register of the source in all, and no other value uses that register.

use super::displacement::Movable;
use super::function::{Node, POOL, Registers, bit};
use super::values::{Source, Values};
use spu_isa::{Field, Pipe};

/// The nodes with registers, for each pass that the kernel contains, and the number of registers,
/// or `None` if there are too few. `movable` are the accesses that read their address where it is
/// in any pass, and `live` the registers that are live at the start of the loop or after it.
pub(super) fn colour(
    nodes: &[Node],
    movable: &[Option<Movable>],
    times: &[i64],
    interval: i64,
    live: Registers,
    passes: usize,
) -> Option<(Vec<Vec<Node>>, u32)> {
    let mut values = Values::of(nodes);
    for (reads, movable) in values.reads.iter_mut().zip(movable) {
        let base = reads.iter_mut().find(|(field, _)| *field == Field::Ra);
        if let (Some(Movable { register, .. }), Some((_, base))) = (movable, base) {
            *base = Source::Entry(*register);
        }
    }
    let place = |at: usize| 2 * times[at] + i64::from(nodes[at].pipe() == Pipe::Odd);
    let pass = 2 * interval as usize;
    let round = pass * passes;
    let mut until: Vec<i64> = (0..nodes.len()).map(|at| place(at) + 1).collect();
    for (reader, reads) in values.reads.iter().enumerate() {
        for &(_, source) in reads {
            let (from, later) = match source {
                Source::Node(from) => (from, 0),
                Source::Entry(register) => match values.last[usize::from(register)] {
                    Some(from) => (from, 1),
                    None => continue,
                },
            };
            until[from] = until[from].max(place(reader) + later * pass as i64);
        }
    }
    let mut taken: Vec<Vec<bool>> = vec![vec![false; round]; 128];
    let plain: Vec<u8> = nodes.iter().map(|node| node.i.rt).collect();
    let mut registers = vec![plain; passes];
    let start = |at: usize, number: usize| place(at) + (number * pass) as i64;
    let mut order: Vec<(usize, usize)> = (0..nodes.len())
        .filter(|&at| nodes[at].writes().is_some() && !values.hands_on(nodes, at, live))
        .flat_map(|at| (0..passes).map(move |number| (at, number)))
        .collect();
    order.sort_by_key(|&(at, number)| (start(at, number).rem_euclid(round as i64), at));
    for (at, number) in order {
        let own = nodes[at].i.rt;
        // From after the instruction up to the last reader of its value.
        let first = start(at, number) + 1;
        let end = until[at] + (number * pass) as i64;
        let span: Vec<usize> =
            (first..=end).map(|place| place.rem_euclid(round as i64) as usize).collect();
        let free = |register: &u8| {
            let rows = &taken[usize::from(*register)];
            live & bit(*register) == 0 && span.iter().all(|&row| !rows[row])
        };
        let own = Some(own).filter(|own| POOL.contains(own));
        let chosen = own.into_iter().chain(POOL).find(free)?;
        for row in span {
            taken[usize::from(chosen)][row] = true;
        }
        registers[number][at] = chosen;
    }
    let mut coloured = vec![nodes.to_vec(); passes];
    let mut used: Registers = 0;
    for (number, nodes) in coloured.iter_mut().enumerate() {
        let before = (number + passes - 1) % passes;
        for (at, node) in nodes.iter_mut().enumerate() {
            for &(field, source) in &values.reads[at] {
                match source {
                    Source::Node(from) => node.set_register(field, registers[number][from]),
                    Source::Entry(register) => {
                        if let Some(from) = values.last[usize::from(register)] {
                            node.set_register(field, registers[before][from]);
                        }
                    }
                }
            }
            if node.writes().is_some() {
                node.i.rt = registers[number][at];
            }
            used |= node.writes().map_or(0, bit);
            used |= node.reads().fold(0, |set, (_, register)| set | bit(register));
        }
    }
    Some((coloured, used.count_ones()))
}
