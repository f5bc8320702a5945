//! The tree of bounding spheres over the objects of one shape.
//!
//! What is where in the tree is settled once, in the scene's own coordinates; what depends on the eye
//! is written anew for each.
//!
//! Invariant: every object is inside the spheres of all nodes that it is below, the rounding of the
//! SPU's test included. A node's sphere holds the objects below it, not the spheres between: so it is
//! smaller, and a ray that misses it misses the objects all the same.

use glam::DVec3;
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::{F32, U32};

use super::ball::{Ball, enclose};
use super::objects::single;
use crate::work::layout::{MAX_ROOTS, Node, SCENE_ADDRESS, Tree};
use crate::work::spheres::up;

/// Rounding of the SPU's test of a sphere with a bound, in parts of the distance and the radius.
///
/// A dozen products and sums, each truncated by up to 2^-23 of numbers no larger than these, make
/// 2^-19.4; the bound itself is rounded outwards.
const SLACK: f64 = 1.0 / (1 << 18) as f64;

/// Children of a node.
const LANES: usize = 4;

/// A tree without addresses.
#[derive(Clone, Debug)]
pub(super) struct Topology {
    /// The objects' indices, from left to right.
    order: Vec<usize>,
    /// From the lowest level up, what each child of a node is within: an object, then a node of the
    /// level below, four of which follow one another in a node.
    levels: Vec<Vec<Ball>>,
}

impl Topology {
    /// A tree over objects, each given by balls that it is within if they are.
    pub fn new(hulls: &[Vec<Ball>]) -> Self {
        let balls: Vec<Ball> = hulls.iter().filter_map(|hull| enclose(hull)).collect();
        let mut order: Vec<usize> = (0..balls.len()).collect();
        split(&mut order, &balls);

        let mut levels = vec![order.iter().map(|&index| balls[index]).collect::<Vec<_>>()];
        let mut below = LANES;
        let mut hull = Vec::new();
        while levels[levels.len() - 1].len().div_ceil(LANES) > MAX_ROOTS as usize {
            let around = |objects: &[usize]| {
                hull.clear();
                hull.extend(objects.iter().flat_map(|&index| &hulls[index]));
                enclose(&hull)
            };
            levels.push(order.chunks(below).filter_map(around).collect());
            below *= LANES;
        }
        Self { order, levels }
    }

    /// The objects' indices in the order of the tree.
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// Bytes of all nodes.
    pub fn size(&self) -> usize {
        let nodes: usize = self.levels.iter().map(|level| nodes(level)).sum();
        nodes * size_of::<Node>()
    }

    /// What the frame says of the tree, whose nodes begin at `address`.
    pub fn record(&self, address: u32) -> Tree {
        Tree {
            roots: address.into(),
            root_count: (self.levels.last().map_or(0, |level| nodes(level)) as u32).into(),
            levels: (self.levels.len() as u32).into(),
            objects: (self.order.len() as u32).into(),
        }
    }

    /// Writes all nodes as seen from `eye`. They begin at `address`, the top first; `objects` has the
    /// addresses of the objects in the order of the tree.
    pub fn write(&self, eye: DVec3, address: u32, objects: &[U32], bytes: &mut [u8]) {
        let mut records = bytes.chunks_exact_mut(size_of::<Node>());
        let mut next = address;
        for (number, level) in self.levels.iter().enumerate().rev() {
            next += (nodes(level) * size_of::<Node>()) as u32;
            for (first, balls) in (0..).step_by(LANES).zip(level.chunks(LANES)) {
                let child = |lane: usize| match number {
                    0 => objects[first + lane],
                    _ => U32::new(next + ((first + lane) * size_of::<Node>()) as u32),
                };
                if let Some(record) = records.next() {
                    record.copy_from_slice(node(eye, balls, child).as_bytes());
                }
            }
        }
    }
}

/// Nodes that hold so many children.
fn nodes(children: &[Ball]) -> usize {
    children.len().div_ceil(LANES)
}

fn node(eye: DVec3, balls: &[Ball], child: impl Fn(usize) -> U32) -> Node {
    let mut node = Node {
        x: [F32::ZERO; LANES],
        y: [F32::ZERO; LANES],
        z: [F32::ZERO; LANES],
        radius: [F32::new(-f32::MAX); LANES],
        child: [SCENE_ADDRESS.into(); LANES],
    };
    for (lane, ball) in balls.iter().enumerate() {
        let centre = ball.centre - eye;
        node.x[lane] = single(centre.x);
        node.y[lane] = single(centre.y);
        node.z[lane] = single(centre.z);
        node.radius[lane] = up(ball.radius + SLACK * (centre.length() + ball.radius));
        node.child[lane] = child(lane);
    }
    node
}

/// Sorts objects so that those of a node are near each other: halved again and again across their
/// longest extent, the left half filling nodes of all levels as far as it can.
fn split(order: &mut [usize], balls: &[Ball]) {
    let count = order.len();
    if count <= LANES {
        order.sort_unstable();
        return;
    }
    let mut whole = LANES;
    while whole * LANES < count {
        whole *= LANES;
    }
    let left = whole * count.div_ceil(whole).div_ceil(2);
    let centre = |&index: &usize| balls[index].centre;
    let low = order.iter().map(centre).fold(DVec3::INFINITY, DVec3::min);
    let high = order
        .iter()
        .map(centre)
        .fold(DVec3::NEG_INFINITY, DVec3::max);
    let axis = (high - low).max_position();
    // The index makes the halves the same on every machine.
    order.select_nth_unstable_by(left, |a, b| {
        let place = |index: &usize| balls[*index].centre[axis];
        place(a).total_cmp(&place(b)).then(a.cmp(b))
    });
    let (left, right) = order.split_at_mut(left);
    split(left, balls);
    split(right, balls);
}
