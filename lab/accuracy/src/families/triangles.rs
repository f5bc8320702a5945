//! Scene families of triangles: named generators of one or two triangles and the rays that are
//! sent to them.

use crate::generator::{Generator, generator};
use rand::Rng as _;
use twins::sphere_ray::Ray;
use twins::triangle::Triangle;

use super::PACKETS;
use crate::space::{across, add_scaled, direction, dot, fresh, in_cube, point, sub, unit};
use crate::truth::{Line, Vector};

/// The smallest cosine of the angle between a ray and the normal.
const SLANT: f64 = 0.3;

/// A family of triangles.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// The family's name.
    pub name: &'static str,
    /// A description of its contents.
    pub doc: &'static str,
    /// The height of a triangle as a share of its longest edge.
    height: f64,
    /// The smallest and the largest distance of the rays' origins, in longest edges.
    reach: [f64; 2],
    /// Whether there are two triangles with a common edge, and only rays to that edge.
    pub shared_edge: bool,
}

/// Triangles and the rays sent to them.
#[derive(Clone, Debug)]
pub struct Shot {
    /// One triangle, or two that share an edge.
    pub triangles: Vec<Triangle>,
    /// The rays.
    pub packets: Vec<[Ray; 16]>,
}

/// The family from which the others are derived.
const WELL_SHAPED: Family = Family {
    name: "well-shaped",
    doc: "half as high as their longest edge is long, 2 to 8 edges away, rays to the triangle and around it",
    height: 0.5,
    reach: [2.0, 8.0],
    shared_edge: false,
};

/// All families of triangles.
pub const FAMILIES: &[Family] = &[
    WELL_SHAPED,
    Family {
        name: "needle",
        doc: "a thousandth as high as their longest edge is long, 2 to 8 edges away",
        height: 1e-3,
        ..WELL_SHAPED
    },
    Family {
        name: "far",
        doc: "as well-shaped, 1000 to 4000 edges away",
        reach: [1e3, 4e3],
        ..WELL_SHAPED
    },
    Family {
        name: "shared edge",
        doc: "two well-shaped triangles with a common edge, 2 to 8 edges away, rays to that edge",
        shared_edge: true,
        ..WELL_SHAPED
    },
];

impl Shot {
    /// The rays as exact numbers.
    pub fn lines(&self) -> impl Iterator<Item = Line> {
        super::lines(&self.packets)
    }
}

impl Family {
    /// This many shots with [`PACKETS`] packets each.
    pub fn shots(&self, seed: u64, shots: usize) -> Vec<Shot> {
        let mut random = generator(seed, &[self.name], 0);
        (0..shots).map(|_| self.shot(&mut random)).collect()
    }

    fn shot(&self, random: &mut Generator) -> Shot {
        let edge = random.random_range(0.5..2.0);
        let normal = direction(random);
        let [along_edge, upwards] = across(normal);
        let a = in_cube(2.0 * edge, random);
        let b = add_scaled(a, edge, along_edge);
        let mut top = |side: f64| {
            let foot = add_scaled(a, edge * random.random_range(0.2..0.8), along_edge);
            add_scaled(foot, side * self.height * edge, upwards)
        };
        let (c, d) = (top(1.0), top(-1.0));
        let ray = |random: &mut Generator| {
            let from = self.origin(a, edge, normal, random);
            let target = if self.shared_edge {
                add_scaled(a, edge * random.random_range(0.1..0.9), along_edge)
            } else {
                let [u, v] = [(); 2].map(|()| random.random_range(-0.2..0.8));
                add_scaled(add_scaled(a, u, sub(b, a)), v, sub(c, a))
            };
            fresh(point(from), point(unit(sub(target, from))))
        };
        let packet = |_| std::array::from_fn(|_| ray(random));
        let packets = (0..PACKETS).map(packet).collect();
        let [a, b, c, d] = [a, b, c, d].map(point);
        let mut triangles = vec![[a, b, c]];
        if self.shared_edge {
            triangles.push([b, a, d]);
        }
        Shot { triangles, packets }
    }

    /// A ray's origin, rounded to singles, on either side of the plane and not too flat above it.
    fn origin(&self, corner: Vector, edge: f64, normal: Vector, random: &mut Generator) -> Vector {
        let [near, far] = self.reach;
        let away = loop {
            let away = direction(random);
            if dot(away, normal).abs() > SLANT {
                break away;
            }
        };
        let origin = add_scaled(corner, edge * random.random_range(near..far), away);
        origin.map(|component| f64::from(component as f32))
    }
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use super::*;
    use crate::truth::triangle;

    #[test]
    fn families_match_their_descriptions() {
        for family in FAMILIES {
            let (mut within, mut rays) = (0, 0);
            for shot in family.shots(1, 6) {
                let triangles = shot.triangles.iter().copied();
                let exact: Vec<_> = triangles.map(triangle::Triangle::new).collect();
                assert_eq!(exact.len(), if family.shared_edge { 2 } else { 1 });
                let [a, b, c] = exact[0].vertices();
                let longest = dot(sub(b, a), sub(b, a)).sqrt();
                let foot =
                    add_scaled(a, dot(sub(c, a), sub(b, a)) / (longest * longest), sub(b, a));
                let height = dot(sub(c, foot), sub(c, foot)).sqrt() / longest;
                assert!((height / family.height - 1.0).abs() < 1e-2, "{height}");
                for line in shot.lines() {
                    let reach = dot(sub(line.origin, a), sub(line.origin, a)).sqrt() / longest;
                    let [near, far] = family.reach;
                    assert!((near * 0.99..far * 1.01).contains(&reach), "{reach}");
                    let hits = exact.iter().filter_map(|triangle| triangle.meeting(&line));
                    within += usize::from(hits.clone().any(|hit| hit.side() >= Ordering::Equal));
                    rays += 1;
                }
            }
            if family.shared_edge {
                // No ray leaves the two triangles through the common edge.
                assert_eq!(within, rays);
            } else {
                assert!((rays / 8..rays).contains(&within), "{}: {within}", family.name);
            }
        }
    }
}
