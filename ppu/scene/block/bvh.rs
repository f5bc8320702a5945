//! The bounding volume hierarchy (BVH) over the primitives of one kind; its volumes are spheres, or
//! boxes along the axes.
//!
//! The hierarchy is built in the scene's coordinates, and its nodes are written again for each
//! eye. When objects move, the bounding spheres above them are refitted. A BVH that has become bad
//! by refitting is rebuilt. Its buffers are reused.
//!
//! Invariant: every object is inside the bounding spheres of all nodes above it, even with the
//! rounding of the SPU's test. A newly built node bounds the objects below it, not its children's
//! spheres, so its sphere is smaller; a ray that misses it still misses the objects. A refitted
//! node bounds its children's spheres.
//!
//! One tree over all shapes was tried: a packet of scattered rays then tests 16.0 nodes instead of
//! 16.6 in `still-life`, but 21.7 instead of 20.0 in `shapes`. One node at the top of a tree
//! instead of up to four makes `whitted16` faster by 1.2 % and all other scenes slower by 0.5 to
//! 4 %.

use glam::DVec3;
use zerocopy::big_endian::{F32, U32};
use zerocopy::{Immutable, IntoBytes};

use super::bounding_sphere::{BoundingSphere, Hull, enclose, enclose_quickly};
use super::bounds::Bounds;
use super::cost::{Extent, expected_cycles};
use super::primitive::PrimitiveKind;
use crate::scene::single::{single, singles, up};
use protocol::layout::{self, BoxNode, FARTHEST, MAX_ROOTS, Node, SCENE_ADDRESS};

/// A bound of the rounding error in the SPU's test of a bounding volume, relative to the distance
/// and the radius.
///
/// A dozen products and sums, each truncated by up to 2^-23 of numbers no larger than these, have
/// an error of at most 2^-19.4. The bound itself is rounded outwards.
const SLACK: f64 = 1.0 / (1 << 18) as f64;

/// The number of a node's children.
pub(crate) const LANES: usize = 4;

/// How much the sum of a BVH's radii may grow by refitting before the BVH is rebuilt.
const MAX_GROWTH: f64 = 1.5;

/// A larger sphere, to allow for the rounding of the SPU's test as seen from `eye`: the test
/// passes every ray that hits an object inside `sphere`.
fn widened(eye: DVec3, sphere: BoundingSphere) -> BoundingSphere {
    let distance = sphere.centre.distance(eye);
    BoundingSphere { radius: sphere.radius + SLACK * (distance + sphere.radius), ..sphere }
}

/// The volumes of a BVH's nodes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Volumes {
    #[default]
    Spheres,
    Boxes,
}

impl Volumes {
    /// The size in bytes of a node.
    fn node_size(self) -> usize {
        match self {
            Self::Spheres => size_of::<Node>(),
            Self::Boxes => size_of::<BoxNode>(),
        }
    }
}

/// A BVH, without local-store addresses.
#[derive(Clone, Debug, Default)]
pub(super) struct Bvh {
    volumes: Volumes,
    /// Each object's bounding sphere, by its index; any sphere for indices without an object.
    spheres: Vec<BoundingSphere>,
    /// The objects' indices, from left to right.
    order: Vec<usize>,
    /// For each level, from the lowest up, the bounding spheres of the nodes' children, four for
    /// each node. The children are objects at the lowest level, and nodes of the level below at
    /// the others. Levels beyond `height` are unused buffers. With boxes only the lowest level is
    /// kept.
    levels: Vec<Vec<BoundingSphere>>,
    /// The same with boxes.
    boxes: Vec<Vec<Bounds>>,
    height: usize,
    /// The sum of the sizes above the lowest level, when the BVH was built.
    built_sizes: f64,
    /// Buffer for the spheres to enclose.
    hull: Vec<BoundingSphere>,
    /// Buffer for the places to split at.
    areas: Vec<f64>,
    /// For each place of a level, whether something below it has moved.
    touched: Vec<bool>,
}

impl Bvh {
    pub fn new(volumes: Volumes) -> Self {
        Self { volumes, ..Self::default() }
    }

    /// Builds the BVH over all objects. Each is given by its hull, or is `None` if there is none
    /// with that index.
    pub fn build(&mut self, hulls: &[Option<Hull>]) {
        let Self { spheres, order, levels, boxes, hull, areas, .. } = self;
        spheres.clear();
        order.clear();
        for (index, hull) in hulls.iter().enumerate() {
            let sphere = hull.as_ref().and_then(|hull| enclose(hull.spheres()));
            order.extend(sphere.map(|_| index));
            spheres.push(sphere.unwrap_or(BoundingSphere::point(DVec3::ZERO)));
        }
        match self.volumes {
            Volumes::Spheres => split(order, spheres),
            Volumes::Boxes => split_by_area(order, hulls, areas),
        }

        begin(levels, 0);
        levels[0].extend(order.iter().map(|&index| spheres[index]));
        let mut top = 0;
        let mut children = order.len();
        let mut below = LANES;
        if self.volumes == Volumes::Boxes {
            begin(boxes, 0);
            boxes[0].extend(order.iter().map(|&index| bounds(hulls, index)));
        }
        while nodes(children) > MAX_ROOTS as usize {
            top += 1;
            children = nodes(children);
            match self.volumes {
                Volumes::Spheres => {
                    begin(levels, top);
                    for objects in order.chunks(below) {
                        hull.clear();
                        let hulls = objects.iter().filter_map(|&index| hulls[index].as_ref());
                        hull.extend(hulls.flat_map(Hull::spheres));
                        levels[top].extend(enclose(hull));
                    }
                }
                Volumes::Boxes => {
                    begin(boxes, top);
                    let (lower, upper) = boxes.split_at_mut(top);
                    upper[0].extend(lower[top - 1].chunks(LANES).map(around));
                }
            }
            below *= LANES;
        }
        self.height = top + 1;
        self.built_sizes = self.sizes();
    }

    /// Refits the bounding volumes above objects that have moved. The set of objects must be the
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
                if self.volumes == Volumes::Boxes {
                    self.boxes[0][place] = bounds(hulls, index);
                }
            }
        }
        let touched = &mut self.touched;
        for level in 1..self.height {
            match self.volumes {
                Volumes::Spheres => refit_level(&mut self.levels, level, touched, enclose_quickly),
                Volumes::Boxes => {
                    refit_level(&mut self.boxes, level, touched, |below| Some(around(below)));
                }
            }
        }
        self.sizes() <= MAX_GROWTH * self.built_sizes
    }

    /// The sum of the radii, or of the boxes' edges, above the lowest level.
    fn sizes(&self) -> f64 {
        let height = self.height;
        match self.volumes {
            Volumes::Spheres => {
                let above = self.levels[..height].iter().skip(1).flatten();
                above.map(|sphere| sphere.radius).sum()
            }
            Volumes::Boxes => {
                let above = self.boxes[..height].iter().skip(1).flatten();
                above.map(|bounds| bounds.size().element_sum()).sum()
            }
        }
    }

    /// The expected cycles of a packet's tests with the tree of objects of a kind, within a scene
    /// of this size.
    pub fn expected_cycles(&self, kind: PrimitiveKind, scene: &Bounds) -> f64 {
        let levels: Vec<Vec<Extent>> = (0..self.height)
            .map(|level| match self.volumes {
                Volumes::Spheres => self.levels[level].iter().map(Extent::of_sphere).collect(),
                Volumes::Boxes => self.boxes[level].iter().map(Extent::of_box).collect(),
            })
            .collect();
        expected_cycles(kind, self.volumes, &levels, scene)
    }

    /// The volumes of its nodes.
    pub fn volumes(&self) -> Volumes {
        self.volumes
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
        let mut roots = self.order.len();
        for _ in 0..self.height {
            roots = nodes(roots);
        }
        layout::Bvh {
            roots: address.into(),
            root_count: (roots as u32).into(),
            levels: (self.height as u32).into(),
            objects: (self.order.len() as u32).into(),
        }
    }

    /// Writes all nodes, relative to `eye`, the top level first. They begin at `address`; `object`
    /// returns an object's address by its index.
    pub fn write(&self, eye: DVec3, address: u32, object: impl Fn(usize) -> U32, bytes: &mut [u8]) {
        let Self { levels, height, .. } = self;
        match self.volumes {
            Volumes::Spheres => {
                self.write_nodes(&levels[..*height], address, object, bytes, |spheres, child| {
                    node(eye, spheres, child)
                });
            }
            Volumes::Boxes => {
                let levels = &self.boxes[..*height];
                self.write_nodes(levels, address, object, bytes, |boxes, child| {
                    box_node(eye, boxes, child)
                });
            }
        }
    }

    fn write_nodes<Volume, Record: IntoBytes + Immutable>(
        &self,
        levels: &[Vec<Volume>],
        address: u32,
        object: impl Fn(usize) -> U32,
        bytes: &mut [u8],
        node: impl Fn(&[Volume], &dyn Fn(usize) -> U32) -> Record,
    ) {
        let size = size_of::<Record>();
        let mut records = bytes.chunks_exact_mut(size);
        let mut next = address;
        for (number, level) in levels.iter().enumerate().rev() {
            next += (nodes(level.len()) * size) as u32;
            for (first, volumes) in (0..).step_by(LANES).zip(level.chunks(LANES)) {
                let child = |lane: usize| match number {
                    0 => object(self.order[first + lane]),
                    _ => U32::new(next + ((first + lane) * size) as u32),
                };
                if let Some(record) = records.next() {
                    record.copy_from_slice(node(volumes, &child).as_bytes());
                }
            }
        }
    }
}

/// Empties a level's buffer.
fn begin<Volume>(levels: &mut Vec<Vec<Volume>>, level: usize) {
    if levels.len() == level {
        levels.push(Vec::new());
    }
    levels[level].clear();
}

/// Refits the volumes of a level where something below has moved, and marks these places.
fn refit_level<Volume>(
    levels: &mut [Vec<Volume>],
    level: usize,
    touched: &mut [bool],
    around: impl Fn(&[Volume]) -> Option<Volume>,
) {
    let (below, level) = levels.split_at_mut(level);
    let below = &below[below.len() - 1];
    for (place, volume) in level[0].iter_mut().enumerate() {
        let children = place * LANES..below.len().min((place + 1) * LANES);
        let is_touched = touched[children.clone()].contains(&true);
        if is_touched && let Some(around) = around(&below[children]) {
            *volume = around;
        }
        // The places to the right don't need the entry that is overwritten.
        touched[place] = is_touched;
    }
}

/// The box around some boxes.
fn around(boxes: &[Bounds]) -> Bounds {
    boxes.iter().copied().fold(Bounds::NOTHING, Bounds::with)
}

/// The box around an object.
fn bounds(hulls: &[Option<Hull>], index: usize) -> Bounds {
    hulls[index].as_ref().map_or(Bounds::NOTHING, Hull::bounds)
}

/// The size in bytes of all nodes over `objects` objects.
pub(super) fn size(objects: usize, volumes: Volumes) -> usize {
    let mut children = objects;
    let mut all = nodes(children);
    while nodes(children) > MAX_ROOTS as usize {
        children = nodes(children);
        all += nodes(children);
    }
    all * volumes.node_size()
}

/// The number of nodes for `children` children.
fn nodes(children: usize) -> usize {
    children.div_ceil(LANES)
}

/// Nodes of spheres without objects: places that rays may cross.
pub(crate) fn change_nodes(
    eye: DVec3,
    spheres: &[BoundingSphere],
) -> impl Iterator<Item = Node> + '_ {
    spheres.chunks(LANES).map(move |four| node(eye, four, &|_| SCENE_ADDRESS.into()))
}

fn node(eye: DVec3, spheres: &[BoundingSphere], child: &dyn Fn(usize) -> U32) -> Node {
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

fn box_node(eye: DVec3, boxes: &[Bounds], child: &dyn Fn(usize) -> U32) -> BoxNode {
    let none = F32::new(-f32::from_bits(FARTHEST));
    let mut node = BoxNode {
        x: [F32::ZERO; LANES],
        y: [F32::ZERO; LANES],
        z: [F32::ZERO; LANES],
        half_x: [none; LANES],
        half_y: [none; LANES],
        half_z: [none; LANES],
        child: [SCENE_ADDRESS.into(); LANES],
    };
    for (lane, bounds) in boxes.iter().enumerate() {
        let centre = bounds.low.midpoint(bounds.high) - eye;
        let half = 0.5 * bounds.size();
        let half = half + SLACK * (centre.length() + half.length());
        [node.x[lane], node.y[lane], node.z[lane]] = singles(centre);
        node.half_x[lane] = up(half.x);
        node.half_y[lane] = up(half.y);
        node.half_z[lane] = up(half.z);
        node.child[lane] = child(lane);
    }
    node
}

/// Sorts objects so that those of a node are near each other, by their boxes: of all axes and all
/// places where one of the parts fills whole nodes, the objects are recursively split where the sum
/// of the parts' surface areas, each times its objects, is smallest. The part that fills whole
/// nodes becomes the left one. `areas` is a buffer.
fn split_by_area(order: &mut [usize], hulls: &[Option<Hull>], areas: &mut Vec<f64>) {
    let count = order.len();
    if count <= LANES {
        order.sort_unstable();
        return;
    }
    let mut whole = LANES;
    while whole * LANES < count {
        whole *= LANES;
    }
    // Comparing the indices too makes the split the same on every machine.
    let sort = |order: &mut [usize], axis: usize| {
        order.sort_unstable_by(|&a, &b| {
            let place = |index: usize| {
                let bounds = bounds(hulls, index);
                bounds.low[axis] + bounds.high[axis]
            };
            place(a).total_cmp(&place(b)).then(a.cmp(&b))
        });
    };
    let mut best = (f64::INFINITY, 0, whole, false);
    for axis in 0..3 {
        sort(order, axis);
        areas.clear();
        areas.resize(count, 0.0);
        let mut right = Bounds::NOTHING;
        for place in (1..count).rev() {
            right = right.with(bounds(hulls, order[place]));
            areas[place] = right.half_area();
        }
        let mut left = Bounds::NOTHING;
        for place in 1..count {
            left = left.with(bounds(hulls, order[place - 1]));
            let is_reversed = !place.is_multiple_of(whole);
            if is_reversed && !(count - place).is_multiple_of(whole) {
                continue;
            }
            let cost = left.half_area() * place as f64 + areas[place] * (count - place) as f64;
            if cost < best.0 {
                best = (cost, axis, place, is_reversed);
            }
        }
    }
    let (_, axis, mut place, is_reversed) = best;
    sort(order, axis);
    if is_reversed {
        order.reverse();
        place = count - place;
    }
    let (left, right) = order.split_at_mut(place);
    split_by_area(left, hulls, areas);
    split_by_area(right, hulls, areas);
}

/// Sorts objects so that those of a node are near each other. The objects are recursively split
/// across their longest extent, and the left part fills whole nodes of as many levels as possible.
///
/// Tried: of all axes, both directions and all places where the left part fills whole nodes, the
/// split with the best surface area heuristic. Frames were 0 to 2 % faster and shapes.nff 5 %, for
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
    let high = order.iter().map(centre).fold(DVec3::NEG_INFINITY, DVec3::max);
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
