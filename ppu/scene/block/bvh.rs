//! The bounding volume hierarchy (BVH) over the primitives of one kind; its volumes are spheres.
//!
//! The hierarchy is built in the scene's coordinates, and its nodes are written again for each
//! eye. When objects move, the bounding spheres above them are refitted. A BVH that has become bad
//! by refitting is rebuilt. Its buffers are reused.
//!
//! Invariant: every object is inside the bounding spheres of all nodes above it, even with the
//! rounding of the SPU's test. A newly built node bounds the objects below it, not its children's
//! spheres, so its sphere is smaller; a ray that misses it still misses the objects. A refitted
//! node bounds its children's spheres.

use glam::DVec3;
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::{F32, U32};

use super::bounding_sphere::{BoundingSphere, Hull, enclose, enclose_quickly};
use crate::scene::single::{single, up};
use protocol::layout::{self, FARTHEST, MAX_ROOTS, Node, SCENE_ADDRESS};

/// A bound of the rounding error in the SPU's test of a bounding sphere, relative to the distance
/// and the radius.
///
/// A dozen products and sums, each truncated by up to 2^-23 of numbers no larger than these, have
/// an error of at most 2^-19.4. The bound itself is rounded outwards.
const SLACK: f64 = 1.0 / (1 << 18) as f64;

/// The number of a node's children.
const LANES: usize = 4;

/// How much the sum of a BVH's radii may grow by refitting before the BVH is rebuilt.
const MOST_GROWTH: f64 = 1.5;

/// A larger sphere, to allow for the rounding of the SPU's test as seen from `eye`: the test
/// passes every ray that hits an object inside `sphere`.
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
    /// Each object's bounding sphere, by its index; any sphere for indices without an object.
    spheres: Vec<BoundingSphere>,
    /// The objects' indices, from left to right.
    order: Vec<usize>,
    /// For each level, from the lowest up, the bounding spheres of the nodes' children, four for
    /// each node. The children are objects at the lowest level, and nodes of the level below at
    /// the others. Levels beyond `height` are unused buffers.
    levels: Vec<Vec<BoundingSphere>>,
    height: usize,
    /// The sum of the radii above the lowest level, when the BVH was built.
    built_radii: f64,
    /// Buffer for the spheres to enclose.
    hull: Vec<BoundingSphere>,
    /// For each place of a level, whether something below it has moved.
    touched: Vec<bool>,
}

impl Bvh {
    /// Builds the BVH over all objects. Each is given by its hull, or is `None` if there is none
    /// with that index.
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

    /// Refits the bounding spheres above objects that have moved. The set of objects must be the
    /// same as when the BVH was built. Returns `false` if the BVH has become bad.
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
                if touched && let Some(around) = enclose_quickly(&below[children]) {
                    *sphere = around;
                }
                // The places to the right don't need the entry that is overwritten.
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

    /// Renumbers the objects by their places from left to right. All indices must have an object.
    pub fn renumber(&mut self) {
        self.spheres.clone_from(&self.levels[0]);
        for (place, index) in self.order.iter_mut().enumerate() {
            *index = place;
        }
    }

    /// The bounding sphere of an object.
    pub fn sphere(&self, index: usize) -> BoundingSphere {
        self.spheres[index]
    }

    /// The BVH's record in the frame. Its nodes begin at `address`.
    pub fn record(&self, address: u32) -> layout::Bvh {
        let top = self.levels.get(self.height.wrapping_sub(1));
        layout::Bvh {
            roots: address.into(),
            root_count: (top.map_or(0, |level| nodes(level.len())) as u32).into(),
            levels: (self.height as u32).into(),
            objects: (self.order.len() as u32).into(),
        }
    }

    /// Writes all nodes, relative to `eye`, the top level first. They begin at `address`; `object`
    /// returns an object's address by its index.
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

/// The size in bytes of all nodes over `objects` objects.
pub(super) fn size(objects: usize) -> usize {
    let mut children = objects;
    let mut all = nodes(children);
    while nodes(children) > MAX_ROOTS as usize {
        children = nodes(children);
        all += nodes(children);
    }
    all * size_of::<Node>()
}

/// The number of nodes for `children` children.
fn nodes(children: usize) -> usize {
    children.div_ceil(LANES)
}

fn node(eye: DVec3, spheres: &[BoundingSphere], child: impl Fn(usize) -> U32) -> Node {
    let mut node = Node {
        x: [F32::ZERO; LANES],
        y: [F32::ZERO; LANES],
        z: [F32::ZERO; LANES],
        radius: [F32::new(-f32::from_bits(FARTHEST)); LANES],
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

/// Sorts objects so that those of a node are near each other. The objects are recursively split
/// across their longest extent, and the left part fills whole nodes of as many levels as possible.
///
/// Tried: of all axes, both directions and all places where the left part fills whole nodes, the
/// split with the least surface area heuristic. Frames were 0 to 2 % faster and shapes.nff 5 %, for
/// six sorts at each step instead of one selection.
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
    // Comparing the indices too makes the split the same on every machine.
    order.select_nth_unstable_by(left, |a, b| {
        let place = |index: &usize| spheres[*index].centre[axis];
        place(a).total_cmp(&place(b)).then(a.cmp(b))
    });
    let (left, right) = order.split_at_mut(left);
    split(left, spheres);
    split(right, spheres);
}
