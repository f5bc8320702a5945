//! Cuts the tree above the leaf blocks into inner blocks.
//!
//! An inner block has up to 18 nodes in up to three levels, and so up to 52 children. Each level is
//! complete: all children of a block's lowest nodes are blocks, all others are nodes.

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

/// The nodes of an inner block below each other: the root's children, or the nodes at the next
/// level, or the tree's nodes that become blocks.
#[derive(Debug)]
pub(super) enum Branch {
    /// A node of the block, and what is below it.
    Node(Vec<Branch>),
    /// A node of the tree: the root of a block.
    Block(usize),
}

/// The root's children, for the block of a node of the tree that is not a leaf; and the number of
/// levels.
pub(super) fn cut(tree: &[Node], root: usize) -> (Vec<Branch>, usize) {
    let share = if tree[root].leaves <= MAX_CHILDREN { 1 } else { SHARE };
    let first = spread(tree, vec![root], WIDTH, share);
    let blocks = |items: Vec<usize>| items.into_iter().map(Branch::Block).collect::<Vec<_>>();
    let is_done = |items: &[usize]| items.iter().all(|&item| tree[item].leaves <= share);
    if is_done(&first) {
        return (blocks(first), 1);
    }
    let second: Vec<Vec<usize>> =
        first.iter().map(|&item| spread(tree, vec![item], WIDTH, share)).collect();
    if second.iter().all(|items| is_done(items)) {
        let nodes = second.into_iter().map(|items| Branch::Node(blocks(items)));
        return (nodes.collect(), 2);
    }
    let second = limited(tree, &first, share);
    let nodes = second.into_iter().map(|items| {
        let below = items
            .into_iter()
            .map(|item| Branch::Node(blocks(spread(tree, vec![item], WIDTH, share))));
        Branch::Node(below.collect())
    });
    (nodes.collect(), 3)
}

/// Replaces the node with the most leaves by its halves until there are `count` nodes, or none with
/// more than `share` leaves.
fn spread(tree: &[Node], mut items: Vec<usize>, count: usize, share: usize) -> Vec<usize> {
    while items.len() < count {
        let largest = (0..items.len()).max_by_key(|&at| tree[items[at]].leaves);
        if !largest.is_some_and(|at| divide(tree, &mut items, at, share)) {
            break;
        }
    }
    items
}

/// Replaces a node by its halves, unless it has `share` leaves or fewer.
fn divide(tree: &[Node], items: &mut Vec<usize>, at: usize, share: usize) -> bool {
    match tree[items[at]].halves {
        Some([first, second]) if tree[items[at]].leaves > share => {
            items[at] = first;
            items.insert(at + 1, second);
            true
        }
        _ => false,
    }
}

/// As [`spread`] for each of the first level's nodes, but with no more than [`THIRD`] nodes in all:
/// those with the most leaves are divided first.
fn limited(tree: &[Node], first: &[usize], share: usize) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = first.iter().map(|&item| vec![item]).collect();
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
    groups
}
