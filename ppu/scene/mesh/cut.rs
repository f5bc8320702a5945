//! Cuts the tree above the leaf blocks into inner blocks.
//!
//! An inner block has up to 18 nodes in up to three levels, and so up to 52 children. Each level is
//! complete: all children of a block's lowest nodes are blocks, all others are nodes.

use std::ops::Deref;

use protocol::layout::{Boxes, MESH_BLOCK, MESH_LEVELS, MeshHeader};

use super::leaf::WIDTH;
use super::tree::Node;

/// The most nodes of an inner block.
pub(super) const NODES: usize =
    (MESH_BLOCK as usize - size_of::<MeshHeader>()) / size_of::<Boxes>();
/// The most nodes of the third level.
const THIRD: usize = NODES - 1 - WIDTH;
/// Children of the largest block.
const MAX_CHILDREN: usize = WIDTH * THIRD;
/// If not all leaves are children of one block, each child gets about as many: more would not fit
/// a block of its own, and fewer would leave it empty.
const SHARE: usize = 32;

const _: () = assert!(MESH_LEVELS == 3);

/// Up to as many nodes of the tree as a node of a block has children. No memory is allocated for
/// them: some hundreds are made for a picture of moving spheres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Items {
    all: [usize; WIDTH],
    count: usize,
}

impl Items {
    fn of(item: usize) -> Self {
        Self { all: [item; WIDTH], count: 1 }
    }
}

impl Deref for Items {
    type Target = [usize];

    fn deref(&self) -> &[usize] {
        &self.all[..self.count]
    }
}

/// The nodes of an inner block level by level, for a node of the tree that is not a leaf; and the
/// number of levels. A node has these children: at the lowest level the roots of blocks, above it
/// the nodes that follow, in their order.
pub(super) fn cut(tree: &[Node], root: usize) -> (Vec<Items>, usize) {
    let share = if tree[root].leaves <= MAX_CHILDREN { 1 } else { SHARE };
    let is_done = |items: &[Items]| items.iter().all(|it| are_done(tree, it, share));
    let first = spread(tree, root, share);
    let mut nodes = Vec::with_capacity(NODES);
    nodes.push(first);
    if is_done(&nodes) {
        return (nodes, 1);
    }
    nodes.extend(first.iter().map(|&item| spread(tree, item, share)));
    if is_done(&nodes[1..]) {
        return (nodes, 2);
    }
    nodes.truncate(1);
    nodes.extend(first.iter().map(|&item| Items::of(item)));
    limit(tree, &mut nodes[1..], share);
    for at in 1..nodes.len() {
        let items = nodes[at];
        nodes.extend(items.iter().map(|&item| spread(tree, item, share)));
    }
    (nodes, 3)
}

/// Whether no item has more than `share` leaves.
fn are_done(tree: &[Node], items: &[usize], share: usize) -> bool {
    items.iter().all(|&item| tree[item].leaves <= share)
}

/// Replaces the node with the most leaves by its halves until there are [`WIDTH`] nodes, or none
/// with more than `share` leaves.
fn spread(tree: &[Node], item: usize, share: usize) -> Items {
    let mut items = Items::of(item);
    while items.len() < WIDTH {
        let largest = (0..items.len()).max_by_key(|&at| tree[items[at]].leaves);
        if !largest.is_some_and(|at| divide(tree, &mut items, at, share)) {
            break;
        }
    }
    items
}

/// Replaces a node by its halves, unless it has `share` leaves or fewer.
fn divide(tree: &[Node], items: &mut Items, at: usize, share: usize) -> bool {
    match tree[items[at]].halves {
        Some([first, second]) if tree[items[at]].leaves > share => {
            items.all.copy_within(at + 1..WIDTH - 1, at + 2);
            items.all[at] = first;
            items.all[at + 1] = second;
            items.count += 1;
            true
        }
        _ => false,
    }
}

/// As [`spread`] for each of the first level's nodes, but with no more than [`THIRD`] nodes in all:
/// those with the most leaves are divided first.
fn limit(tree: &[Node], groups: &mut [Items], share: usize) {
    let mut count = groups.len();
    while count < THIRD {
        let open = groups.iter().enumerate().filter(|(_, it)| it.len() < WIDTH);
        let items = open.flat_map(|(group, it)| (0..it.len()).map(move |at| (group, at)));
        let largest = items.max_by_key(|&(group, at)| tree[groups[group][at]].leaves);
        let Some((group, at)) = largest else { break };
        if !divide(tree, &mut groups[group], at, share) {
            break;
        }
        count += 1;
    }
}
