//! Nothing leaks: every ray from inside a closed mesh meets it, also those aimed at its edges and vertices.

use crate::generator::Generator;
use kernels::Bench;
use kernels::cases::whitted::isect::call;
use kernels::cases::whitted::isect::shape::Shape as _;
use kernels::cases::whitted::isect::triangle::TriangleObject;
use kernels::flat_records::Point;
use twins::FARTHEST;
use twins::ball::Ray;

use super::mesh::{self, Maker};
use crate::stability::family::{Family, NoCaseError, Tally};
use crate::stability::statement::Bound;

/// Packets that are traced in a mesh.
const PACKETS: usize = 16;
/// Meshes of a round.
const MESHES: u32 = 4;
/// Words of a ray, and of a triangle.
const RAY: usize = 6;
const TRIANGLE: usize = 9;

/// Rays to the edges of meshes of one kind.
struct Watertight {
    name: &'static str,
    maker: Maker,
}

/// The kinds of meshes.
pub fn families() -> impl Iterator<Item = Box<dyn Family>> {
    let kinds: [(&str, Maker); 4] = [
        ("mesh-lumpy", mesh::lumpy),
        ("mesh-thin", mesh::thin),
        ("mesh-far-out", mesh::far_out),
        ("mesh-lattice", mesh::lattice),
    ];
    let families = kinds.into_iter();
    families.map(|(name, maker)| Box::new(Watertight { name, maker }) as Box<dyn Family>)
}

/// Whether each ray meets any of the triangles.
fn met(bench: &mut Bench, triangles: &[TriangleObject], rays: &[[Point; 2]]) -> Vec<bool> {
    let packets: Vec<_> = rays
        .chunks(16)
        .map(|rays| {
            let lane = |lane: usize| {
                let [origin, direction] = rays[lane.min(rays.len() - 1)];
                Ray {
                    origin,
                    direction,
                    t: FARTHEST,
                    object: 0,
                }
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

impl Family for Watertight {
    fn name(&self) -> &'static str {
        self.name
    }

    fn subject(&self) -> &str {
        TriangleObject::KERNEL
    }

    fn unit(&self) -> &'static str {
        "leaks"
    }

    fn bound(&self) -> Bound {
        Bound::none("both sides of an edge have the same bits")
    }

    fn rounds(&self) -> u32 {
        250
    }

    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        for _ in 0..MESHES {
            let mesh = (self.maker)(random);
            let triangles = mesh.triangles(random).into_iter();
            let triangles: Vec<TriangleObject> = triangles
                .map(|vertices| TriangleObject {
                    vertices,
                    both: true,
                })
                .collect();
            let rays: Vec<[Point; 2]> = (0..16 * PACKETS).map(|_| mesh.aimed(random)).collect();
            for (ray, met) in rays.iter().zip(met(bench, &triangles, &rays)) {
                tally.verdict(met, || words(&triangles, ray));
            }
        }
    }

    fn replay(
        &self,
        bench: &mut Bench,
        words: &[u32],
        tally: &mut Tally,
    ) -> Result<(), NoCaseError> {
        let points: Vec<Point> = words.as_chunks().0.to_vec();
        if points.len() < 5 || words.len() % TRIANGLE != RAY {
            return Err(NoCaseError {
                found: words.len(),
                needed: RAY + words.len().div_ceil(TRIANGLE) * TRIANGLE,
            });
        }
        let triangles: Vec<TriangleObject> = points[2..]
            .as_chunks()
            .0
            .iter()
            .map(|vertices| TriangleObject {
                vertices: *vertices,
                both: true,
            })
            .collect();
        let met = met(bench, &triangles, &[[points[0], points[1]]]);
        tally.verdict(met[0], || words.to_vec());
        Ok(())
    }
}
