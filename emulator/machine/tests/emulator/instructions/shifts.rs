//! Compares every shift and rotate, for all counts, with a bit-by-bit definition.
//!
//! Provenance: manual, the masks and directions in the architecture's definitions.

use super::machine::{Script, instruction, put};
use crate::prelude::*;
use spu_isa::Format;

#[derive(Clone, Copy)]
enum Kind {
    Left,
    Rotate,
    Right,
    RightSigned,
}

/// Register form, immediate form (if there is one), lane width, kind, and a function from the
/// count to the distance in bits.
type Row = (Op, Option<Op>, usize, Kind, fn(i64) -> i64);

const ROWS: [Row; 17] = [
    (Op::Shl, Some(Op::Shli), 32, Kind::Left, |n| n & 63),
    (Op::Shlh, Some(Op::Shlhi), 16, Kind::Left, |n| n & 31),
    (Op::Rot, Some(Op::Roti), 32, Kind::Rotate, |n| n & 31),
    (Op::Roth, Some(Op::Rothi), 16, Kind::Rotate, |n| n & 15),
    (Op::Rotm, Some(Op::Rotmi), 32, Kind::Right, |n| -n & 63),
    (Op::Rothm, Some(Op::Rothmi), 16, Kind::Right, |n| -n & 31),
    (Op::Rotma, Some(Op::Rotmai), 32, Kind::RightSigned, |n| -n & 63),
    (Op::Rotmah, Some(Op::Rotmahi), 16, Kind::RightSigned, |n| -n & 31),
    (Op::Shlqbi, Some(Op::Shlqbii), 128, Kind::Left, |n| n & 7),
    (Op::Shlqby, Some(Op::Shlqbyi), 128, Kind::Left, |n| (n & 31) * 8),
    (Op::Shlqbybi, None, 128, Kind::Left, |n| (n >> 3 & 31) * 8),
    (Op::Rotqbi, Some(Op::Rotqbii), 128, Kind::Rotate, |n| n & 7),
    (Op::Rotqby, Some(Op::Rotqbyi), 128, Kind::Rotate, |n| (n & 15) * 8),
    (Op::Rotqbybi, None, 128, Kind::Rotate, |n| (n >> 3 & 15) * 8),
    (Op::Rotqmbi, Some(Op::Rotqmbii), 128, Kind::Right, |n| -n & 7),
    (Op::Rotqmby, Some(Op::Rotqmbyi), 128, Kind::Right, |n| (-n & 31) * 8),
    (Op::Rotqmbybi, None, 128, Kind::Right, |n| (-(n >> 3) & 31) * 8),
];

fn bits(quad: Quad) -> Vec<bool> {
    (0..128).map(|bit| quad.0[bit / 32] >> (31 - bit % 32) & 1 == 1).collect()
}

fn moved(lane: &[bool], kind: Kind, distance: i64) -> Vec<bool> {
    let width = lane.len() as i64;
    let at = |position: i64| (0..width).contains(&position).then(|| lane[position as usize]);
    (0..width)
        .map(|bit| match kind {
            Kind::Left => at(bit + distance).unwrap_or(false),
            Kind::Rotate => lane[((bit + distance) % width) as usize],
            Kind::Right => at(bit - distance).unwrap_or(false),
            Kind::RightSigned => at(bit - distance).unwrap_or(lane[0]),
        })
        .collect()
}

/// The count for each lane: in words and halfwords the lane's own count in rb, in quadwords rb's
/// preferred word.
fn check(
    op: Op,
    width: usize,
    kind: Kind,
    distance: fn(i64) -> i64,
    value: Quad,
    counts: Quad,
    immediate: i32,
) {
    let local_store = LocalStore::new();
    put(&local_store, 0, instruction(op, immediate));
    let mut spu = Spu::new();
    spu.set_register(4, value);
    spu.set_register(5, counts);
    assert_eq!(spu.step(&local_store, &mut Script::default()), None);
    let immediate_form = op.row().format == Format::Ri7;
    let source = bits(value);
    let expected: Vec<bool> = source
        .chunks(width)
        .enumerate()
        .flat_map(|(lane, chunk)| {
            let count = match width {
                _ if immediate_form => immediate.into(),
                16 => counts.halfwords()[lane] as i16 as i64,
                32 => counts.0[lane] as i32 as i64,
                _ => counts.0[0] as i32 as i64,
            };
            moved(chunk, kind, distance(count))
        })
        .collect();
    assert_eq!(
        bits(spu.register(3)),
        expected,
        "{op:?} of {value:08x?} by {counts:08x?}, {immediate}"
    );
}

#[test]
fn every_count_in_both_forms() {
    let values = [
        Quad([0x8000_0001, 0x7fff_8001, 0x0123_4567, 0xf0e1_d2c3]),
        Quad([0x1234_8765, 0x8001_7ffe, 0xffff_ffff, 0x0000_0001]),
    ];
    for (register_form, immediate_form, width, kind, distance) in ROWS {
        for value in values {
            for count in -130..130i32 {
                let near = |add: i32| count.wrapping_add(add) as u32;
                let words = Quad([near(0), near(31), near(64), near(-65)]);
                let halfword = |n: i32| count.wrapping_add(n * 9) as u16;
                let halfwords = Quad::from_halfwords(std::array::from_fn(|n| halfword(n as i32)));
                let counts = if width == 16 { halfwords } else { words };
                check(register_form, width, kind, distance, value, counts, 0);
            }
            for immediate in -64..64 {
                if let Some(op) = immediate_form {
                    check(op, width, kind, distance, value, Quad::splat(0x55), immediate);
                }
            }
        }
    }
}
