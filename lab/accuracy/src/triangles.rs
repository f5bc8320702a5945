//! The formulations of triangles on their scene families.

use std::cmp::Ordering;

use kernels::Bench;
use kernels::cases::whitted::isect::call;
use protocol::formulation::TriangleFormulation;
use protocol::layout::RayPacket;
use serde::{Deserialize, Serialize};
use spu_emulator::float::single::to_f64;
use twins::triangle::Triangle;
use twins::triangle_pairs::TriangleObject;

use crate::families::space::{along, cross, dot, largest, less, unit};
use crate::families::triangles::{FAMILIES, Family, Shot};
use crate::metrics::Summary;
use crate::parallel;
use crate::spheres::WELL_CONDITIONED;
use crate::truth::triangle::{self, Meeting};
use crate::truth::{Line, spacing};

/// A kernel on a family.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TriangleRow {
    /// The formulation.
    pub formulation: String,
    /// The family.
    pub family: String,
    /// Ulps of the distance that half an ulp in each of the numbers given moves.
    pub condition: Option<Summary>,
    /// Whether that is little in the mean.
    pub well_conditioned: bool,
    /// Rays.
    pub rays: usize,
    /// Of these, those that hit by exact arithmetic.
    pub hits: usize,
    /// Rays that the kernel lets hit, and exact arithmetic does not.
    pub wrong_hits: usize,
    /// Rays that exact arithmetic lets hit, and the kernel does not: where two share an edge, that neither
    /// stops, which is a leak.
    pub wrong_misses: usize,
    /// Error of the distance in ulps.
    pub distance_ulps: Option<Summary>,
    /// The same in parts of the scene: of its farthest point's distance.
    pub distance_relative: Option<Summary>,
    /// Error of the hit's point, at its worst coordinate, in ulps of the largest from the origin.
    pub point_ulps: Option<Summary>,
    /// The same in parts of the scene.
    pub point_relative: Option<Summary>,
}

/// What is so of a ray.
struct Truth {
    line: Line,
    /// Distance of the nearest hit.
    hit: Option<f64>,
    /// How far the farthest vertex is.
    scene: f64,
}

/// Measures formulations on all families, so many shots of each.
///
/// # Panics
///
/// If a kernel does not behave as kernels have to, or there is no such kernel.
#[must_use]
pub fn measure(formulations: &[&TriangleFormulation], seed: u64, shots: usize) -> Vec<TriangleRow> {
    let rows = parallel::map(FAMILIES, Bench::new, |bench, family| {
        let shots = family.shots(seed, shots);
        let mut conditions = Vec::new();
        let truths: Vec<Vec<Truth>> = shots
            .iter()
            .map(|shot| truths(shot, &mut conditions))
            .collect();
        let condition = Summary::of(conditions);
        let row = |formulation: &&TriangleFormulation| {
            of_family(bench, formulation, family, &shots, &truths, condition)
        };
        formulations.iter().map(row).collect::<Vec<_>>()
    });
    rows.into_iter().flatten().collect()
}

fn truths(shot: &Shot, conditions: &mut Vec<f64>) -> Vec<Truth> {
    let triangles: Vec<triangle::Triangle> = shot
        .triangles
        .iter()
        .map(|vertices| triangle::Triangle::new(*vertices))
        .collect();
    let truth = |line: Line| {
        let hits = triangles.iter().filter_map(|triangle| {
            let meeting = triangle.meeting(&line)?;
            let counts = meeting.side() >= Ordering::Equal && meeting.distance > 0.0;
            counts.then_some((triangle, meeting))
        });
        let nearest = hits.min_by(|(_, a), (_, b)| a.distance.total_cmp(&b.distance));
        if let Some((triangle, meeting)) = &nearest {
            conditions.push(sensitivity(triangle, &line, meeting));
        }
        let vertices = triangles.iter().flat_map(|triangle| triangle.vertices());
        let scene = vertices
            .map(|vertex| dot(less(vertex, line.origin), less(vertex, line.origin)).sqrt())
            .fold(0.0, f64::max);
        let hit = nearest.map(|(_, meeting)| meeting.distance);
        Truth { line, hit, scene }
    };
    let rays = shot.packets.iter().flatten();
    rays.map(|ray| Line::new(ray.origin, ray.direction))
        .map(truth)
        .collect()
}

/// Ulps of a hit's distance that half an ulp in each of the numbers given moves, all at their worst.
///
/// The plane through a + .. + c, weighted, has n.(o + t d - p) = 0.
fn sensitivity(triangle: &triangle::Triangle, line: &Line, meeting: &Meeting) -> f64 {
    let [a, b, c] = triangle.vertices();
    let normal = unit(cross(less(b, a), less(c, a)));
    let ahead = unit(line.direction);
    let slant = dot(normal, ahead);
    let turned = along(normal, -slant, ahead);
    let moved: f64 = (0..3)
        .map(|axis| {
            let vertices = [a, b, c].into_iter().zip(meeting.weights);
            let of_vertices = vertices.map(|(vertex, weight)| weight.abs() * spacing(vertex[axis]));
            let places = of_vertices.sum::<f64>() + spacing(line.origin[axis]);
            let turn = spacing(line.direction[axis]);
            normal[axis].abs() * places + meeting.distance * turned[axis].abs() * turn
        })
        .sum();
    moved / 2.0 / slant.abs() / spacing(meeting.distance)
}

fn of_family(
    bench: &mut Bench,
    formulation: &TriangleFormulation,
    family: &Family,
    shots: &[Shot],
    truths: &[Vec<Truth>],
    condition: Option<Summary>,
) -> TriangleRow {
    let (mut hits, mut wrong_hits, mut wrong_misses) = (0, 0, 0);
    let [mut distance_ulps, mut distance_relative] = [Vec::new(), Vec::new()];
    let [mut point_ulps, mut point_relative] = [Vec::new(), Vec::new()];
    for (shot, truths) in shots.iter().zip(truths) {
        for (found, truth) in self::hits(bench, formulation.kernel, shot)
            .into_iter()
            .zip(truths)
        {
            hits += usize::from(truth.hit.is_some());
            match (found, truth.hit) {
                (Some(t), Some(exact)) => {
                    let off = (t - exact).abs();
                    distance_ulps.push(off / spacing(exact));
                    distance_relative.push(off / truth.scene);
                    let point = along(truth.line.origin, t, truth.line.direction);
                    let right = truth.line.point(exact);
                    let off = largest(less(point, right));
                    point_ulps.push(off / spacing(largest(less(right, truth.line.origin))));
                    point_relative.push(off / truth.scene);
                }
                (Some(_), None) => wrong_hits += 1,
                (None, Some(_)) => wrong_misses += 1,
                (None, None) => {}
            }
        }
    }
    TriangleRow {
        formulation: formulation.name.to_owned(),
        family: family.name.to_owned(),
        condition,
        well_conditioned: condition.is_some_and(|condition| condition.mean <= WELL_CONDITIONED),
        rays: truths.iter().map(Vec::len).sum(),
        hits,
        wrong_hits,
        wrong_misses,
        distance_ulps: Summary::of(distance_ulps),
        distance_relative: Summary::of(distance_relative),
        point_ulps: Summary::of(point_ulps),
        point_relative: Summary::of(point_relative),
    }
}

/// What a kernel says of each ray of a shot: the distance of its nearest hit.
fn hits(bench: &mut Bench, kernel: &str, shot: &Shot) -> Vec<Option<f64>> {
    bench.reset();
    let packets: Vec<RayPacket> = shot
        .packets
        .iter()
        .map(|rays| call::packet(rays, 0))
        .collect();
    let object = |vertices: &Triangle| TriangleObject {
        vertices: *vertices,
        both: true,
    };
    let objects: Vec<TriangleObject> = shot.triangles.iter().map(object).collect();
    let list: Vec<[usize; 2]> = (0..objects.len())
        .flat_map(|object| (0..packets.len()).map(move |packet| [object, packet]))
        .collect();
    let placed = call::place(bench, &packets, &objects, &list, 0);
    bench.call(kernel, &[placed.candidates, list.len() as u32]);
    let after: Vec<RayPacket> = bench.read_all(placed.packets);
    let rays = after.iter().flat_map(call::rays);
    rays.map(|ray| (ray.object != 0).then(|| to_f64(ray.t)))
        .collect()
}

#[cfg(test)]
mod tests {
    use protocol::formulation::TRIANGLES;

    use super::*;

    #[test]
    fn the_watertight_formulation_does_not_leak_and_is_right_to_some_ulps() {
        let watertight: Vec<_> = TRIANGLES
            .iter()
            .filter(|formulation| formulation.name == "watertight")
            .collect();
        let rows = measure(&watertight, 1, 4);
        assert_eq!(rows.len(), FAMILIES.len());
        for row in &rows {
            let worst = row.distance_ulps.unwrap().max;
            assert!(
                worst > 0.0 && worst < 8.0 + 4.0 * row.condition.unwrap().max,
                "{row:?}"
            );
            if row.family == "shared edge" {
                assert_eq!((row.hits, row.wrong_misses), (row.rays, 0));
            }
        }
    }
}
