//! The purpose of the watertight kernel: rays from inside a closed mesh, aimed at its edges and
//! vertices, that leak with Möller and Trumbore's test.

use kernels::cases::meshes::Mesh;
use kernels::cases::whitted::isect::call;
use kernels::cases::whitted::isect::triangle::{TriangleObject, pairs_by};
use twins::sphere_ray;

use super::watertight::{KINDS, aimed};
use kernels::prelude::*;

/// The number of meshes of each kind.
const MESHES: u32 = 160;
/// The number of packets from inside each mesh.
const PACKETS: usize = 20;
/// The object of a ray that has hit nothing.
const NOTHING: u32 = 0;

/// The share of the rays that leaks from each kind of mesh.
const STATED: [f64; 4] = [0.1, 0.1, 0.1, 0.025];

/// The number of rays aimed at edges and vertices of meshes, and the number of those that leak.
#[derive(Debug, Default)]
struct Leaks {
    rays: u32,
    watertight: u32,
    moeller_trumbore: u32,
}

/// Returns how many of the packets' rays hit no triangle; all triangles are visible from both
/// sides.
fn leaks(bench: &mut Bench, kernel: &str, packets: &[RayPacket], faces: &[TriangleObject]) -> u32 {
    let mut packets = packets.to_vec();
    for face in faces {
        (packets, _) = pairs_by(bench, kernel, &packets, face, 0);
    }
    let rays = packets.iter().flat_map(call::rays);
    rays.filter(|ray| ray.object == NOTHING).count() as u32
}

fn count(random: &mut ChaCha8Rng, mesh: fn(&mut ChaCha8Rng) -> Mesh) -> Leaks {
    let mut bench = Bench::new();
    let mut found = Leaks::default();
    for _ in 0..MESHES {
        let mesh = mesh(random);
        let faces = mesh.triangles(random);
        let faces: Vec<TriangleObject> =
            faces.into_iter().map(|vertices| TriangleObject { vertices, both: true }).collect();
        let packets: Vec<RayPacket> = (0..PACKETS)
            .map(|_| {
                let rays = std::array::from_fn(|_| {
                    let aimed = aimed(&mesh, random);
                    sphere_ray::Ray {
                        origin: aimed.origin,
                        direction: aimed.direction,
                        t: FARTHEST,
                        object: NOTHING,
                    }
                });
                call::packet(&rays, random.random())
            })
            .collect();
        found.rays += 16 * PACKETS as u32;
        found.watertight += leaks(&mut bench, "isect_triangle_pairs_r16", &packets, &faces);
        found.moeller_trumbore +=
            leaks(&mut bench, "isect_triangle_mt_pairs_r16", &packets, &faces);
    }
    println!("{found:?}");
    found
}

/// As the kernel's header states, for any seed.
#[test]
fn moeller_trumbore_leaks_and_watertight_does_not() {
    let mut random = random();
    for (kind, stated) in KINDS.into_iter().zip(STATED) {
        let found = count(&mut random, kind);
        assert_eq!(found.watertight, 0, "{found:?}");
        let rate = f64::from(found.moeller_trumbore) / f64::from(found.rays);
        let likely = stated / 2.0..stated * 2.0;
        assert!(likely.contains(&rate), "{rate} instead of {stated}");
    }
}
