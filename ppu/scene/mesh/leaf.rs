//! The order of a leaf block's pieces: runs of a few, in groups of four runs, one group a node.

use super::sweep::sweep;
use super::tree::{Bounds, Piece, around};

/// Children of a node.
pub(super) const WIDTH: usize = 4;

/// The lengths of the runs of each group, of at most `most` pieces; the pieces are sorted so that
/// they follow each other. Pieces for one node make a single group.
pub(super) fn runs(pieces: &mut [Piece], most: usize) -> Vec<Vec<usize>> {
    if pieces.len() <= WIDTH {
        return vec![group(pieces, most)];
    }
    let mut groups = Vec::with_capacity(WIDTH);
    parts(pieces, WIDTH, WIDTH * most, &mut |pieces| {
        groups.push(group(pieces, most));
    });
    groups
}

/// Divides a group's pieces into runs of at most `most`.
fn group(pieces: &mut [Piece], most: usize) -> Vec<usize> {
    let mut runs = Vec::with_capacity(WIDTH);
    parts(pieces, WIDTH, most, &mut |run| runs.push(run.len()));
    runs
}

/// Halves pieces until there are `count` parts, a power of two, and calls `found` with each. No
/// part has more than `most` pieces.
fn parts(pieces: &mut [Piece], count: usize, most: usize, found: &mut dyn FnMut(&mut [Piece])) {
    if count == 1 || pieces.len() == 1 {
        return found(pieces);
    }
    let at = halve(pieces, most * count / 2);
    let (first, second) = pieces.split_at_mut(at);
    parts(first, count / 2, most, found);
    parts(second, count / 2, most, found);
}

/// Sorts at least two pieces so that dividing them at the returned index has the minimum cost, with
/// at most `most` on either side.
fn halve(pieces: &mut [Piece], most: usize) -> usize {
    let length = pieces.len();
    let legal = length.saturating_sub(most).max(1)..=most.min(length - 1);
    sweep(pieces, &|index| legal.contains(&index).then_some([index, length - index]))
}

/// The box around the pieces of a run that begins at `first`.
pub(super) fn run_bounds(pieces: &[Piece], first: usize, length: usize) -> Bounds {
    around(&pieces[first..first + length])
}
