//! Measures the formulations of triangles on their scene families.

use std::cmp::Ordering;

use kernels::Bench;
use kernels::cases::whitted::isect::call;
use protocol::formulation::TriangleFormulation;
use protocol::layout::RayPacket;
use serde::{Deserialize, Serialize};
use spu_emulator::float::single::to_f64;
use twins::triangle_pairs::TriangleObject;

use crate::families::triangles::{FAMILIES, Shot};
use crate::figures::{Figures, Hit, Truth, compare, sensitivity};
use crate::parallel;
use crate::space::{cross, length, sub, two_sided, unit};
use crate::truth::triangle::{Meeting, Triangle};
use crate::truth::{Line, spacing};

/// The figures of a kernel on a family.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TriangleRow {
    /// The formulation.
    pub formulation: String,
    /// The family.
    pub family: String,
    /// The figures.
    #[serde(flatten)]
    pub figures: Figures,
}

/// Measures formulations on all families, with this many shots of each.
///
/// # Panics
///
/// Panics if a kernel breaks the rules for kernels or does not exist.
pub fn measure(formulations: &[&TriangleFormulation], seed: u64, shots: usize) -> Vec<TriangleRow> {
    let rows = parallel::map(FAMILIES, Bench::new, |bench, family| {
        let shots = family.shots(seed, shots);
        let truths: Vec<Truth> = shots.iter().flat_map(truths).collect();
        let row = |formulation: &&TriangleFormulation| {
            let found = shots.iter().flat_map(|shot| hits(bench, formulation.kernel, shot));
            let (figures, _) = compare(false, found, truths.iter());
            TriangleRow {
                formulation: formulation.name.to_owned(),
                family: family.name.to_owned(),
                figures,
            }
        };
        formulations.iter().map(row).collect::<Vec<_>>()
    });
    rows.into_iter().flatten().collect()
}

/// The exact results for a shot's rays.
fn truths(shot: &Shot) -> Vec<Truth> {
    let triangles: Vec<Triangle> = shot.triangles.iter().copied().map(Triangle::new).collect();
    let truth = |line: Line| {
        let hits = triangles.iter().filter_map(|triangle| {
            let meeting = triangle.meeting(&line)?;
            let counts = meeting.side() >= Ordering::Equal && meeting.distance > 0.0;
            counts.then_some((triangle, meeting))
        });
        let nearest = hits.min_by(|(_, a), (_, b)| a.distance.total_cmp(&b.distance));
        let vertices = triangles.iter().flat_map(|triangle| triangle.vertices());
        let distances = vertices.map(|vertex| length(sub(vertex, line.origin)));
        Truth {
            line,
            hit: nearest.map(|(triangle, meeting)| Hit {
                distance: meeting.distance,
                point: line.point(meeting.distance),
                condition: Some(condition(triangle, &line, &meeting)),
                normal: None,
            }),
            scene: distances.fold(0.0, f64::max),
        }
    };
    shot.lines().map(truth).collect()
}

/// By how many ulps half an ulp in each input moves a hit's distance. The inputs are the vertices,
/// weighted as at the hit, and the origin.
fn condition(triangle: &Triangle, line: &Line, meeting: &Meeting) -> f64 {
    let [a, b, c] = triangle.vertices();
    let normal = unit(cross(sub(b, a), sub(c, a)));
    let places = |axis: usize| {
        let vertices = [a, b, c].into_iter().zip(meeting.weights);
        let moved = vertices.map(|(vertex, weight)| weight.abs() * spacing(vertex[axis]));
        moved.sum::<f64>() + spacing(line.origin[axis])
    };
    sensitivity(line, 1.0, (meeting.distance, normal), places, 0.0)
}

/// The kernel's result for each ray of a shot: the distance of its nearest hit.
fn hits(bench: &mut Bench, kernel: &str, shot: &Shot) -> Vec<Option<f64>> {
    bench.reset();
    let packets = shot.packets.iter().map(|rays| call::packet(rays, 0));
    let packets: Vec<RayPacket> = packets.collect();
    let objects: Vec<TriangleObject> = shot.triangles.iter().copied().map(two_sided).collect();
    let list: Vec<[usize; 2]> = (0..objects.len())
        .flat_map(|object| (0..packets.len()).map(move |packet| [object, packet]))
        .collect();
    let placed = call::place(bench, &packets, &objects, &list, 0);
    bench.call(kernel, &[placed.candidates, list.len() as u32]);
    let after: Vec<RayPacket> = bench.read_all(placed.packets);
    let rays = after.iter().flat_map(call::rays);
    rays.map(|ray| (ray.object != 0).then(|| to_f64(ray.t))).collect()
}

#[cfg(test)]
mod tests {
    use protocol::formulation::TRIANGLES;

    use super::*;

    #[test]
    fn watertight_formulation_keeps_bound_without_leaks() {
        let watertight: Vec<_> =
            TRIANGLES.iter().filter(|formulation| formulation.name == "watertight").collect();
        let rows = measure(&watertight, 1, 4);
        assert_eq!(rows.len(), FAMILIES.len());
        for row in &rows {
            let of = &row.figures;
            let worst = of.distance_ulps.unwrap().max;
            let most = 8.0 + 4.0 * of.condition.unwrap().max;
            assert!(worst > 0.0 && worst < most, "{row:?}");
            if row.family == "shared edge" {
                assert_eq!((of.hits, of.wrong_misses), (of.rays, 0));
            }
        }
    }
}
