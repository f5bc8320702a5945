//! Finds the lamps whose light reaches all of a triangle, because nothing is in the shaft between
//! both (Haines and Wallace 1991), and those whose light reaches no place of it, because all of the
//! shaft is blocked.
//!
//! Rays meet only the fronts of triangles that are seen from one side. Such a triangle has no part
//! in the shadows of a lamp that is in front of it.

use glam::DVec3;
use scenes::{Mesh, Visibility};

/// A shaft that something reaches into by less is free: rays start farther off their surfaces.
/// Blockers that leave a gap of less between them touch.
const TOUCHING: f64 = 1.0 / 4096.0;
/// Most parts of a triangle between the shadows on it. One with more is not wholly dark.
const PARTS: usize = 48;
/// Blockers of a leaf of a tree.
const FEW: usize = 4;
/// Lamps whose numbers are equal modulo this share a bit.
const BITS: usize = 16;

/// A lamp.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    /// Its place.
    pub place: DVec3,
    /// How far its light reaches.
    pub range: f64,
}

#[derive(Clone, Copy, Debug)]
struct Blocker {
    corners: [DVec3; 3],
    normal: DVec3,
    both_sides: bool,
    /// Whether it is always there.
    is_fixed: bool,
}

/// What may be between surfaces and lamps.
#[derive(Clone, Debug, Default)]
pub struct Blockers {
    triangles: Vec<Blocker>,
    boxes: Vec<Box3>,
}

impl Blockers {
    /// Adds the triangles of a mesh. `is_clear` is whether a material transmits light.
    pub fn add_mesh(&mut self, mesh: &Mesh, is_clear: impl Fn(u32) -> bool) {
        for (triangle, &material) in mesh.materials.iter().enumerate() {
            self.add(mesh.places(triangle), mesh.two_sided || is_clear(material), true);
        }
    }

    /// Adds a polygon that does not move, and is seen from its front.
    pub fn add_polygon(&mut self, corners: &[DVec3]) {
        for pair in corners[1..].windows(2) {
            self.add([corners[0], pair[0], pair[1]], false, true);
        }
    }

    fn add(&mut self, corners: [DVec3; 3], both_sides: bool, is_fixed: bool) {
        if let Some(normal) = normal(corners) {
            self.triangles.push(Blocker { corners, normal, both_sides, is_fixed });
        }
    }

    /// Adds a box in which something may move.
    pub fn add_box(&mut self, low: DVec3, high: DVec3) {
        for [a, b, c, d] in scenes::cuboid(low, high) {
            self.add([a, b, c], true, false);
            self.add([a, c, d], true, false);
        }
        self.boxes.push(Box3 { low, high });
    }

    /// Finds what may be in the way of each lamp's light.
    #[must_use]
    pub fn around(&self, lamps: &[Lamp]) -> Shafts {
        let lamps = lamps.iter().map(|&lamp| {
            let near = self.triangles.iter().filter(|it| {
                let is_behind = it.normal.dot(lamp.place - it.corners[0]) < 0.0;
                let is_near = Box3::of(&it.corners).distance(lamp.place) < lamp.range;
                is_near && (it.both_sides || is_behind)
            });
            let is_inside = self.boxes.iter().any(|it| it.distance(lamp.place) == 0.0);
            (lamp, Tree::new(near.copied().collect()), is_inside)
        });
        Shafts(lamps.collect())
    }
}

/// Lamps, each with what may be in the way of its light, and whether something may move there.
pub struct Shafts(Vec<(Lamp, Tree, bool)>);

impl Shafts {
    /// For each triangle of a mesh, which lamps reach it, if they are the first lights of a scene.
    /// Nothing is known of triangles that are seen from both sides, as those of a material are that
    /// transmits light, for which `is_clear` is true.
    #[must_use]
    pub fn visibility(&self, mesh: &Mesh, is_clear: impl Fn(u32) -> bool) -> Vec<Visibility> {
        let all = (0..self.0.len()).fold(0, |all, number| all | 1 << (number % BITS));
        let of = |triangle: usize| {
            let corners = mesh.places(triangle);
            let both_sides = mesh.two_sided || is_clear(mesh.materials[triangle]);
            let Some(normal) = normal(corners).filter(|_| !both_sides) else {
                return Visibility::default();
            };
            let mut known = Visibility { lit: all, dark: all };
            for (number, (lamp, tree, is_inside)) in self.0.iter().enumerate() {
                let bit = 1 << (number % BITS);
                let height = normal.dot(lamp.place - corners[0]);
                if height <= 0.0 || height >= lamp.range || (known.lit | known.dark) & bit == 0 {
                    continue;
                }
                let Some(shaft) = Shaft::new(corners, normal, *lamp) else { continue };
                let inside: Vec<&Blocker> = tree.reaching_into(&shaft).collect();
                if *is_inside || !inside.is_empty() {
                    known.lit &= !bit;
                }
                if known.dark & bit != 0 && !shaft.is_blocked(&inside) {
                    known.dark &= !bit;
                }
            }
            // Where no lamp of a number reaches a triangle, both are set.
            known.dark &= !known.lit;
            known
        };
        (0..mesh.triangles.len()).map(of).collect()
    }
}

fn normal([a, b, c]: [DVec3; 3]) -> Option<DVec3> {
    (b - a).cross(c - a).try_normalize()
}

#[derive(Clone, Copy, Debug)]
struct Box3 {
    low: DVec3,
    high: DVec3,
}

impl Box3 {
    fn of(points: &[DVec3]) -> Self {
        let (low, high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let around = |it: Self, point: &DVec3| it.with(Self { low: *point, high: *point });
        points.iter().fold(Self { low, high }, around)
    }

    fn with(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    fn distance(self, point: DVec3) -> f64 {
        point.distance(point.clamp(self.low, self.high))
    }

    fn meets(self, other: Self) -> bool {
        self.low.cmplt(other.high).all() && other.low.cmplt(self.high).all()
    }
}

/// All between a polygon and a lamp.
struct Shaft {
    polygon: Vec<DVec3>,
    lamp: DVec3,
    bounds: Box3,
    /// Its planes: their unit normals, which point inwards, and distances.
    planes: Vec<(DVec3, f64)>,
}

impl Shaft {
    /// The shaft from a triangle's part in the cube around the lamp's range, if there is any.
    fn new(corners: [DVec3; 3], normal: DVec3, Lamp { place, range }: Lamp) -> Option<Self> {
        let mut polygon = corners.to_vec();
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            for way in [axis, -axis] {
                [polygon, _] = divided(&polygon, |point| way.dot(point - place) + range);
            }
        }
        if polygon.len() < 3 {
            return None;
        }
        let middle = polygon.iter().sum::<DVec3>() / polygon.len() as f64;
        let mut planes = vec![(normal, normal.dot(corners[0]))];
        for (at, &point) in polygon.iter().enumerate() {
            let next = polygon[(at + 1) % polygon.len()];
            if let Some(side) = (next - point).cross(place - point).try_normalize() {
                let side = side * (side.dot(middle - point)).signum();
                planes.push((side, side.dot(point)));
            }
        }
        let bounds = Box3::of(&polygon).with(Box3 { low: place, high: place });
        Some(Self { polygon, lamp: place, bounds, planes })
    }

    /// Whether a box may reach into it.
    fn may_meet(&self, it: Box3) -> bool {
        self.bounds.meets(it)
            && self.planes.iter().all(|&(normal, distance)| {
                let farthest = DVec3::select(normal.cmpgt(DVec3::ZERO), it.high, it.low);
                normal.dot(farthest) - distance > TOUCHING
            })
    }

    /// Whether these triangles together block it: nothing of its polygon is left when their shadows
    /// are cut out.
    fn is_blocked(&self, blockers: &[&Blocker]) -> bool {
        let mut lit = vec![self.polygon.clone()];
        let (ground, distance) = self.planes[0];
        for blocker in blockers.iter().filter(|it| it.is_fixed) {
            // What is below the polygon's plane casts no shadow on it.
            let [part, _] = divided(&blocker.corners, |point| ground.dot(point) - distance);
            if part.len() < 3 {
                continue;
            }
            let middle = part.iter().sum::<DVec3>() / part.len() as f64;
            let sides: Vec<DVec3> = (0..part.len())
                .filter_map(|at| {
                    let [one, other] = [at, (at + 1) % part.len()].map(|it| part[it] - self.lamp);
                    let side = one.cross(other).try_normalize()?;
                    Some(side * side.dot(middle - self.lamp).signum())
                })
                .collect();
            let mut left = Vec::new();
            for mut piece in lit {
                let inside = |side: &DVec3, point: DVec3| side.dot(point - self.lamp);
                let is_beside =
                    |side: &DVec3| piece.iter().all(|point| inside(side, *point) <= TOUCHING);
                if sides.iter().any(is_beside) {
                    left.push(piece);
                    continue;
                }
                for side in &sides {
                    let [within, outside] = divided(&piece, |point| inside(side, point));
                    if outside.iter().any(|point| inside(side, *point) < -TOUCHING) {
                        left.push(outside);
                    }
                    piece = within;
                }
            }
            lit = left;
            if lit.is_empty() || lit.len() > PARTS {
                break;
            }
        }
        lit.is_empty()
    }

    /// Whether a triangle reaches into it: no plane is between them.
    fn is_met_by(&self, Blocker { corners, normal, .. }: &Blocker) -> bool {
        if self.planes.iter().any(|(normal, distance)| {
            corners.iter().all(|corner| normal.dot(*corner) - distance <= TOUCHING)
        }) {
            return false;
        }
        let along = |axis: DVec3, points: &[DVec3]| {
            let places = points.iter().map(|point| axis.dot(*point));
            places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], it| {
                [low.min(it), high.max(it)]
            })
        };
        let is_between = |axis: DVec3| {
            let [low, high] = along(axis, corners);
            let [from, to] = along(axis, &self.polygon);
            let lamp = axis.dot(self.lamp);
            high <= from.min(lamp) + TOUCHING || low >= to.max(lamp) - TOUCHING
        };
        if is_between(*normal) {
            return false;
        }
        let [a, b, c] = *corners;
        let edges = [b - a, c - b, a - c];
        let sides = (0..self.polygon.len()).flat_map(|at| {
            let (here, next) = (self.polygon[at], self.polygon[(at + 1) % self.polygon.len()]);
            [next - here, self.lamp - here]
        });
        !sides.flat_map(|side| edges.map(|edge| side.cross(edge))).any(|axis| {
            let length = axis.length();
            length > TOUCHING && is_between(axis / length)
        })
    }
}

/// The parts of a convex polygon on both sides of a plane: where the depth is above 0, and the
/// rest.
fn divided(polygon: &[DVec3], depth: impl Fn(DVec3) -> f64) -> [Vec<DVec3>; 2] {
    let mut parts = [Vec::new(), Vec::new()];
    for (at, &point) in polygon.iter().enumerate() {
        let next = polygon[(at + 1) % polygon.len()];
        let (here, there) = (depth(point), depth(next));
        parts[usize::from(here <= 0.0)].push(point);
        if (here <= 0.0) != (there <= 0.0) {
            let crossing = point.lerp(next, here / (here - there));
            parts.iter_mut().for_each(|part| part.push(crossing));
        }
    }
    parts
}

/// A tree of boxes around blockers.
struct Tree {
    blockers: Vec<Blocker>,
    nodes: Vec<Node>,
}

struct Node {
    bounds: Box3,
    /// The blockers below it.
    first: usize,
    end: usize,
    /// The number of the node after all below it.
    after: usize,
}

impl Tree {
    fn new(blockers: Vec<Blocker>) -> Self {
        let mut tree = Self { blockers, nodes: Vec::new() };
        tree.grow(0, tree.blockers.len());
        tree
    }

    fn grow(&mut self, first: usize, end: usize) {
        let own = &mut self.blockers[first..end];
        let boxes = own.iter().map(|it| Box3::of(&it.corners));
        let Some(bounds) = boxes.reduce(Box3::with) else { return };
        let number = self.nodes.len();
        self.nodes.push(Node { bounds, first, end, after: 0 });
        if end - first > FEW {
            let size = bounds.high - bounds.low;
            let axis = (0..3).max_by(|a, b| size[*a].total_cmp(&size[*b])).unwrap_or(0);
            let middle = |it: &Blocker| it.corners.iter().map(|it| it[axis]).sum::<f64>();
            own.select_nth_unstable_by((end - first) / 2, |a, b| middle(a).total_cmp(&middle(b)));
            let half = first.midpoint(end);
            self.grow(first, half);
            self.grow(half, end);
        }
        self.nodes[number].after = self.nodes.len();
    }

    /// The blockers that reach into a shaft.
    fn reaching_into(&self, shaft: &Shaft) -> impl Iterator<Item = &Blocker> {
        let mut at = 0;
        let leaves = std::iter::from_fn(move || {
            loop {
                let node = self.nodes.get(at)?;
                let may_meet = shaft.may_meet(node.bounds);
                at = if may_meet { at + 1 } else { node.after };
                if may_meet && at == node.after {
                    return Some(&self.blockers[node.first..node.end]);
                }
            }
        });
        leaves.flatten().filter(|it| shaft.is_met_by(it))
    }
}
