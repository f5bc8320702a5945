//! The cheapest division of pieces in the order of their middles along an axis.

use super::tree::{Bounds, Piece};

/// Sorts at least two pieces so that dividing them at the returned index has the minimum cost.
/// `weights` has for an index what the parts before and after it weigh, or `None` if it may not be
/// chosen; it must allow at least one index.
pub(super) fn sweep(pieces: &mut [Piece], weights: &dyn Fn(usize) -> Option<[usize; 2]>) -> usize {
    let length = pieces.len();
    let mut best = (f64::INFINITY, length / 2);
    let mut order: Vec<u64> = Vec::new();
    let mut sorted = Vec::with_capacity(length);
    let mut after = vec![0.0; length];
    for axis in 0..3 {
        // Equal middles keep their order, so the result doesn't depend on the way of sorting.
        let numbered = pieces.iter().zip(0_u64..);
        sorted.clear();
        sorted.extend(
            numbered.map(|(piece, index)| u64::from(ordered(piece.middle()[axis])) << 32 | index),
        );
        sorted.sort_unstable();
        let bounds = |key: u64| pieces[(key & 0xffff_ffff) as usize].bounds;
        let mut around = Bounds::EMPTY;
        for index in (1..length).rev() {
            around = around.with(bounds(sorted[index]));
            after[index] = around.area();
        }
        around = Bounds::EMPTY;
        for index in 1..length {
            around = around.with(bounds(sorted[index - 1]));
            let Some([first, second]) = weights(index) else {
                continue;
            };
            let cost = around.area() * first as f64 + after[index] * second as f64;
            if cost < best.0 || order.is_empty() {
                best = (cost, index);
                order.clone_from(&sorted);
            }
        }
    }
    let old = pieces.to_vec();
    for (piece, key) in pieces.iter_mut().zip(order) {
        *piece = old[(key & 0xffff_ffff) as usize];
    }
    best.1
}

/// A number whose order among unsigned ones is that of `value` among singles.
fn ordered(value: f32) -> u32 {
    let bits = value.to_bits();
    if bits >> 31 == 0 { bits | 1 << 31 } else { !bits }
}
