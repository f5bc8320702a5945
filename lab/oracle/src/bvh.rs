//! A bounding volume hierarchy of boxes over the surfaces of a scene.
//!
//! Invariant: the result is the same as if every surface were tested. Of equally near surfaces the
//! first in file order is found.

use glam::DVec3;

use crate::ray::Ray;
use crate::shapes::Surface;

/// The most surfaces in a leaf.
const LEAF: usize = 4;

/// By how much boxes are enlarged, relative to distances from the ray's origin. By the rounding of
/// the tests a hit may be outside of its box; this is far above that error, about 1e-15.
const SLACK: f64 = 1e-12;

/// An axis-parallel box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bounds {
    pub low: DVec3,
    pub high: DVec3,
}

impl Bounds {
    /// The box around both.
    pub(crate) fn with(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The distance at which a ray enters the box, if it is below `limit`.
    fn entry(&self, ray: &Ray, limit: f64) -> Option<f64> {
        let (low, high) = (self.low - ray.origin, self.high - ray.origin);
        let slack =
            SLACK * (low.abs().max(high.abs()).max_element() + ray.origin.abs().max_element());
        let (low, high) = ((low - slack) * ray.inverse, (high + slack) * ray.inverse);
        let enter = low.min(high).max_element().max(0.0);
        let leave = low.max(high).min_element().min(limit);
        (enter <= leave).then_some(enter)
    }
}

/// A box and its content.
#[derive(Debug)]
struct Node {
    bounds: Bounds,
    content: Content,
}

#[derive(Debug)]
enum Content {
    /// Indices in [`Bvh::order`].
    Surfaces(std::ops::Range<usize>),
    /// Indices in [`Bvh::nodes`].
    Halves([usize; 2]),
}

#[derive(Debug)]
pub(crate) struct Bvh {
    surfaces: Vec<Surface>,
    /// The surfaces' indices in the order of the leaves.
    order: Vec<usize>,
    /// The nodes, with the root last; empty without surfaces.
    nodes: Vec<Node>,
}

impl Bvh {
    pub(crate) fn new(surfaces: Vec<Surface>) -> Self {
        let bounds: Vec<Bounds> = surfaces.iter().map(Surface::bounds).collect();
        let mut tree = Self { order: (0..surfaces.len()).collect(), nodes: Vec::new(), surfaces };
        if !bounds.is_empty() {
            tree.grow(&bounds, 0..bounds.len());
        }
        tree
    }

    pub(crate) fn surface(&self, index: usize) -> &Surface {
        &self.surfaces[index]
    }

    /// Adds the node for a range of the order, and returns its index.
    fn grow(&mut self, bounds: &[Bounds], range: std::ops::Range<usize>) -> usize {
        let around = |indices: &[usize], part: fn(Bounds) -> Bounds| {
            let boxes = indices.iter().map(|&index| part(bounds[index]));
            boxes.reduce(Bounds::with)
        };
        let indices = &mut self.order[range.clone()];
        let whole = around(indices, |it| it).unwrap_or(bounds[0]);
        let content = if indices.len() <= LEAF {
            Content::Surfaces(range)
        } else {
            let middles = around(indices, |it| {
                let middle = it.low.midpoint(it.high);
                Bounds { low: middle, high: middle }
            })
            .unwrap_or(whole);
            let axis = (middles.high - middles.low).max_position();
            let middle = |index: &usize| bounds[*index].low[axis] + bounds[*index].high[axis];
            let half = indices.len() / 2;
            indices.select_nth_unstable_by(half, |a, b| {
                middle(a).total_cmp(&middle(b)).then(a.cmp(b))
            });
            let split = range.start + half;
            let first = self.grow(bounds, range.start..split);
            let second = self.grow(bounds, split..range.end);
            Content::Halves([first, second])
        };
        self.nodes.push(Node { bounds: whole, content });
        self.nodes.len() - 1
    }

    /// The nearest surface that a ray hits, and its distance.
    pub(crate) fn nearest(&self, ray: &Ray) -> Option<(usize, f64)> {
        let mut best: Option<(usize, f64)> = None;
        self.visit(ray, f64::INFINITY, |index, limit| {
            // The next larger limit lets equally near surfaces pass, so that the first is chosen.
            let distance = self.surfaces[index].hit(ray, limit.next_up());
            if let Some(distance) = distance {
                let nearer = best.is_none_or(|(first, min)| distance < min || index < first);
                if nearer {
                    best = Some((index, distance));
                }
            }
            best.map_or(limit, |(_, distance)| distance)
        });
        best
    }

    /// Whether a ray hits any surface at a distance below `limit`.
    pub(crate) fn any(&self, ray: &Ray, limit: f64) -> bool {
        let mut met = false;
        self.visit(ray, limit, |index, limit| {
            met |= limit > 0.0 && self.surfaces[index].hit(ray, limit).is_some();
            // After a hit, nothing else is searched.
            if met { f64::NEG_INFINITY } else { limit }
        });
        met
    }

    /// Calls `test` with the surfaces whose boxes the ray enters below the limit. `test` returns
    /// the new limit.
    fn visit(&self, ray: &Ray, mut limit: f64, mut test: impl FnMut(usize, f64) -> f64) {
        let enter = |place: usize, limit: f64| {
            let entry = self.nodes[place].bounds.entry(ray, limit)?;
            Some((place, entry))
        };
        let root = self.nodes.len().checked_sub(1);
        let mut pending: Vec<(usize, f64)> = Vec::with_capacity(64);
        pending.extend(root.and_then(|root| enter(root, limit)));
        while let Some((place, entry)) = pending.pop() {
            if entry > limit {
                continue;
            }
            match &self.nodes[place].content {
                Content::Surfaces(range) => {
                    for &index in &self.order[range.clone()] {
                        limit = test(index, limit);
                    }
                }
                Content::Halves(halves) => {
                    let mut entered = halves.map(|half| enter(half, limit));
                    // The nearer half is pushed last, so that it is visited first.
                    entered.sort_by(|a, b| {
                        let key = |it: &Option<(usize, f64)>| it.map_or(f64::INFINITY, |it| it.1);
                        key(b).total_cmp(&key(a))
                    });
                    pending.extend(entered.into_iter().flatten());
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use crate::shapes::tests::random_shape;

    #[test]
    fn bvh_finds_hits_of_exhaustive_test() {
        let mut random = Random(7);
        let (mut met, mut hidden) = (0, 0);
        for count in [0, 1, 4, 5, 60, 700] {
            let mut surfaces = Vec::new();
            while surfaces.len() < count {
                let shape = random_shape(&mut random, 2.0 / libm::cbrt(count as f64));
                let transmits = random.next().is_multiple_of(3);
                let surface = Surface::new(&shape, transmits).expect("a surface");
                // Some surfaces occur twice, and the first of them must be found.
                surfaces.extend(vec![surface; 1 + usize::from(random.next().is_multiple_of(4))]);
            }
            let tree = Bvh::new(surfaces.clone());
            for round in 0..4000 {
                // One of three rays is in a coordinate plane, and one is parallel to an axis.
                let mut direction = random.direction();
                if round % 3 > 0 {
                    direction.x = 0.0;
                }
                if round % 3 > 1 {
                    direction.y = 0.0;
                }
                let ray = Ray::new(random.point() * 1.5, direction.normalize());
                let all = surfaces.iter().enumerate().filter_map(|(index, surface)| {
                    Some((index, surface.hit(&ray, f64::INFINITY)?))
                });
                let nearest = all.reduce(|a, b| if b.1 < a.1 { b } else { a });
                assert_eq!(tree.nearest(&ray), nearest, "{ray:?}");
                met += usize::from(nearest.is_some());
                let limit = random.real().abs();
                let any = nearest.is_some_and(|(_, distance)| distance < limit);
                assert_eq!(tree.any(&ray, limit), any, "{ray:?}");
                hidden += usize::from(any);
            }
        }
        assert!(met > 2000 && hidden > 1000, "{met} {hidden}");
    }
}
