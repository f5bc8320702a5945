//! The bounding volume hierarchy (BVH) over the primitives of one kind; its volumes are spheres.
//!
//! The hierarchy is built in the scene's own coordinates. What depends on the eye is written again
//! for each eye. When objects move, the bounding spheres above them are refitted; a BVH that has
//! become bad by refitting is built anew. Its buffers are reused.
//!
//! Invariant: every object is inside the bounding spheres of all nodes above it, even by the SPU's
//! rounded test. A node that was built bounds the objects below it, not the spheres between, so it
//! is smaller, and a ray that misses it misses the objects all the same. A node that was refitted
//! bounds its children's spheres.

use glam::DVec3;
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::{F32, U32};

use super::bounding_sphere::{BoundingSphere, Hull, enclose};
use crate::scene::single::{single, up};
use protocol::layout::{self, MAX_ROOTS, Node, SCENE_ADDRESS};

/// Rounding of the SPU's test of a sphere with a bound, in parts of the distance and the radius.
///
/// A dozen products and sums, each truncated by up to 2^-23 of numbers no larger than these, make
/// 2^-19.4; the bound itself is rounded outwards.
const SLACK: f64 = 1.0 / (1 << 18) as f64;

/// Children of a node.
const LANES: usize = 4;

/// How much the sum of a BVH's radii may grow by refitting before it is built anew.
const MOST_GROWTH: f64 = 1.5;

/// A sphere around another, such that the SPU finds no ray to miss it that meets an object in the
/// other, as seen from `eye`.
pub(crate) fn widened(eye: DVec3, sphere: BoundingSphere) -> BoundingSphere {
    let distance = sphere.centre.distance(eye);
    BoundingSphere {
        radius: sphere.radius + SLACK * (distance + sphere.radius),
        ..sphere
    }
}

/// A BVH, without local-store addresses.
#[derive(Clone, Debug, Default)]
pub(super) struct Bvh {
    /// What each object is within, by its index; of those that are not there, anything.
    spheres: Vec<BoundingSphere>,
    /// The objects' indices, from left to right.
    order: Vec<usize>,
    /// From the lowest level up, what each child of a node is within: an object, then a node of
    /// the level below, four of which follow one another in a node. Levels beyond `height` are of
    /// other trees.
    levels: Vec<Vec<BoundingSphere>>,
    height: usize,
    /// Sum of the radii above the lowest level, when it was built.
    built_radii: f64,
    /// Spheres around which one is looked for.
    hull: Vec<BoundingSphere>,
    /// The places of a level below which something has moved.
    touched: Vec<bool>,
}

impl Bvh {
    /// Builds the BVH over the objects that are there, each given by spheres whose hull it is
    /// within.
    pub fn build(&mut self, hulls: &[Option<Hull>]) {
        let Self {
            spheres,
            order,
            levels,
            hull,
            ..
        } = self;
        spheres.clear();
        order.clear();
        for (index, hull) in hulls.iter().enumerate() {
            let sphere = hull.as_ref().and_then(|hull| enclose(hull.spheres()));
            order.extend(sphere.map(|_| index));
            spheres.push(sphere.unwrap_or(BoundingSphere::point(DVec3::ZERO)));
        }
        split(order, spheres);

        let begin = |levels: &mut Vec<Vec<BoundingSphere>>, level: usize| {
            if levels.len() == level {
                levels.push(Vec::new());
            }
            levels[level].clear();
        };
        begin(levels, 0);
        levels[0].extend(order.iter().map(|&index| spheres[index]));
        let mut top = 0;
        let mut below = LANES;
        while nodes(levels[top].len()) > MAX_ROOTS as usize {
            top += 1;
            begin(levels, top);
            for objects in order.chunks(below) {
                hull.clear();
                let hulls = objects.iter().filter_map(|&index| hulls[index].as_ref());
                hull.extend(hulls.flat_map(Hull::spheres));
                levels[top].extend(enclose(hull));
            }
            below *= LANES;
        }
        self.height = top + 1;
        self.built_radii = self.radii();
    }

    /// Fits the spheres above objects that have moved, and are those that there were; `false` if
    /// the tree has become bad.
    pub fn refit(&mut self, moved: impl Fn(usize) -> bool, hulls: &[Option<Hull>]) -> bool {
        self.touched.clear();
        for (place, &index) in self.order.iter().enumerate() {
            let sphere = hulls[index]
                .as_ref()
                .filter(|_| moved(index))
                .and_then(|hull| enclose(hull.spheres()));
            self.touched.push(sphere.is_some());
            if let Some(sphere) = sphere {
                self.spheres[index] = sphere;
                self.levels[0][place] = sphere;
            }
        }
        for level in 1..self.height {
            let (below, level) = self.levels.split_at_mut(level);
            let below = &below[below.len() - 1];
            for (place, sphere) in level[0].iter_mut().enumerate() {
                let children = place * LANES..below.len().min((place + 1) * LANES);
                let touched = self.touched[children.clone()].contains(&true);
                if touched && let Some(around) = enclose(&below[children]) {
                    *sphere = around;
                }
                // No place to the right needs what is overwritten.
                self.touched[place] = touched;
            }
        }
        self.radii() <= MOST_GROWTH * self.built_radii
    }

    fn radii(&self) -> f64 {
        let above = self.levels[..self.height].iter().skip(1).flatten();
        above.map(|sphere| sphere.radius).sum()
    }

    /// The objects' indices in the order of the tree.
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// Counts the objects, all of which have to be there, by their places from left to right from
    /// now on.
    pub fn renumber(&mut self) {
        self.spheres.clone_from(&self.levels[0]);
        for (place, index) in self.order.iter_mut().enumerate() {
            *index = place;
        }
    }

    /// What an object that is there is within.
    pub fn sphere(&self, index: usize) -> BoundingSphere {
        self.spheres[index]
    }

    /// What the frame says of the tree, whose nodes begin at `address`.
    pub fn record(&self, address: u32) -> layout::Bvh {
        let top = self.levels.get(self.height.wrapping_sub(1));
        layout::Bvh {
            roots: address.into(),
            root_count: (top.map_or(0, |level| nodes(level.len())) as u32).into(),
            levels: (self.height as u32).into(),
            objects: (self.order.len() as u32).into(),
        }
    }

    /// Writes all nodes as seen from `eye`. They begin at `address`, the top first; `object` has
    /// the addresses of the objects by their indices.
    pub fn write(&self, eye: DVec3, address: u32, object: impl Fn(usize) -> U32, bytes: &mut [u8]) {
        let mut records = bytes.chunks_exact_mut(size_of::<Node>());
        let mut next = address;
        for (number, level) in self.levels[..self.height].iter().enumerate().rev() {
            next += (nodes(level.len()) * size_of::<Node>()) as u32;
            for (first, spheres) in (0..).step_by(LANES).zip(level.chunks(LANES)) {
                let child = |lane: usize| match number {
                    0 => object(self.order[first + lane]),
                    _ => U32::new(next + ((first + lane) * size_of::<Node>()) as u32),
                };
                if let Some(record) = records.next() {
                    record.copy_from_slice(node(eye, spheres, child).as_bytes());
                }
            }
        }
    }
}

/// Bytes of all nodes of a tree over so many objects.
pub(super) fn size(objects: usize) -> usize {
    let mut children = objects;
    let mut all = nodes(children);
    while nodes(children) > MAX_ROOTS as usize {
        children = nodes(children);
        all += nodes(children);
    }
    all * size_of::<Node>()
}

/// Nodes that hold so many children.
fn nodes(children: usize) -> usize {
    children.div_ceil(LANES)
}

fn node(eye: DVec3, spheres: &[BoundingSphere], child: impl Fn(usize) -> U32) -> Node {
    let mut node = Node {
        x: [F32::ZERO; LANES],
        y: [F32::ZERO; LANES],
        z: [F32::ZERO; LANES],
        radius: [F32::new(-f32::MAX); LANES],
        child: [SCENE_ADDRESS.into(); LANES],
    };
    for (lane, sphere) in spheres.iter().enumerate() {
        let centre = sphere.centre - eye;
        node.x[lane] = single(centre.x);
        node.y[lane] = single(centre.y);
        node.z[lane] = single(centre.z);
        node.radius[lane] = up(widened(eye, *sphere).radius);
        node.child[lane] = child(lane);
    }
    node
}

/// Sorts objects so that those of a node are near each other: halved again and again across their
/// longest extent, the left half filling nodes of all levels as far as it can.
fn split(order: &mut [usize], spheres: &[BoundingSphere]) {
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
    let centre = |&index: &usize| spheres[index].centre;
    let low = order.iter().map(centre).fold(DVec3::INFINITY, DVec3::min);
    let high = order
        .iter()
        .map(centre)
        .fold(DVec3::NEG_INFINITY, DVec3::max);
    let axis = (high - low).max_position();
    // The index makes the halves the same on every machine.
    order.select_nth_unstable_by(left, |a, b| {
        let place = |index: &usize| spheres[*index].centre[axis];
        place(a).total_cmp(&place(b)).then(a.cmp(b))
    });
    let (left, right) = order.split_at_mut(left);
    split(left, spheres);
    split(right, spheres);
}
