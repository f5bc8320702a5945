//! Nothing leaks: every ray from inside a closed mesh hits it, including rays aimed at its edges
//! and vertices.

use super::mesh::{self, Maker};
use crate::stability::prelude::*;

/// The number of packets traced in a mesh.
const PACKETS: usize = 16;
/// The number of meshes in a round.
const MESHES: u32 = 4;
/// The number of words of a ray, and of a triangle.
const RAY: usize = 6;
const TRIANGLE: usize = 9;

/// Rays to the edges of one kind of meshes.
struct Watertight(Maker);

/// A family for each kind of mesh.
pub fn families() -> [Family; 4] {
    let kinds: [(_, Maker); 4] = [
        ("mesh-lumpy", mesh::lumpy),
        ("mesh-thin", mesh::thin),
        ("mesh-far-out", mesh::far_out),
        ("mesh-lattice", mesh::lattice),
    ];
    kinds.map(|(name, maker)| Family {
        name,
        subject: TriangleObject::KERNEL.to_owned(),
        unit: "leaks",
        bound: Bound::none("both sides of an edge have the same bits"),
        rounds: 250,
        cases: Box::new(Watertight(maker)),
    })
}

/// Whether each ray hits any of the triangles.
fn met(bench: &mut Bench, triangles: &[TriangleObject], rays: &[[Point; 2]]) -> Vec<bool> {
    let packets: Vec<_> = rays
        .chunks(16)
        .map(|rays| {
            let lane = |lane: usize| {
                let [origin, direction] = rays[lane.min(rays.len() - 1)];
                fresh(origin, direction)
            };
            call::packet(&std::array::from_fn(lane), 0)
        })
        .collect();
    let list: Vec<[usize; 2]> = (0..packets.len())
        .flat_map(|packet| (0..triangles.len()).map(move |triangle| [triangle, packet]))
        .collect();
    let (packets, _) = call::pairs(bench, &packets, triangles, &list, 0);
    let found = packets.iter().flat_map(call::rays);
    found.take(rays.len()).map(|ray| ray.object != 0).collect()
}

fn words(triangles: &[TriangleObject], ray: &[Point; 2]) -> Vec<u32> {
    let vertices = triangles.iter().flat_map(|triangle| triangle.vertices);
    ray.iter().copied().chain(vertices).flatten().collect()
}

impl Cases for Watertight {
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        for _ in 0..MESHES {
            let mesh = (self.0)(random);
            let triangles = mesh.triangles(random).into_iter();
            let triangles: Vec<TriangleObject> = triangles.map(two_sided).collect();
            let rays: Vec<[Point; 2]> = (0..16 * PACKETS).map(|_| mesh.aimed(random)).collect();
            for (ray, met) in rays.iter().zip(met(bench, &triangles, &rays)) {
                tally.verdict(met, || words(&triangles, ray));
            }
        }
    }

    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed {
        // A ray and as many triangles as the mesh had, which is at least one.
        let triangles = words.len().saturating_sub(RAY).div_ceil(TRIANGLE);
        need(RAY + triangles.max(1) * TRIANGLE, words)?;
        let (points, _) = words.as_chunks();
        let (vertices, _) = points[2..].as_chunks();
        let triangles: Vec<TriangleObject> = vertices.iter().copied().map(two_sided).collect();
        let met = met(bench, &triangles, &[[points[0], points[1]]]);
        tally.verdict(met[0], || words.to_vec());
        Ok(())
    }
}
