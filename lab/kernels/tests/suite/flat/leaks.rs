//! What the watertight kernel is for: rays from inside a closed mesh, aimed at its edges and
//! vertices, that get out where each triangle is met Möller and Trumbore's way.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::isect::call;
use kernels::cases::whitted::isect::triangle::{TriangleObject, pairs_by};
use kernels::vector::{in_cube, magnitude};
use protocol::layout::RayPacket;
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use twins::FARTHEST;
use twins::sphere_ray;

use super::watertight::Mesh;

/// Meshes of a kind.
const MESHES: u32 = 80;
/// Packets from inside each.
const PACKETS: usize = 40;
/// The object of a ray that has hit nothing.
const NOTHING: u32 = 0;

/// How a mesh is made, and which part of its rays leaks.
type Kind = (fn(&mut ChaCha8Rng) -> Mesh, f64);

/// So many of the rays that are aimed at edges and vertices of meshes leave them.
#[derive(Debug, Default)]
struct Leaks {
    rays: u32,
    watertight: u32,
    moeller_trumbore: u32,
}

/// Rays of the packets that hit none of the triangles, which are seen from both sides.
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
        let faces: Vec<TriangleObject> = faces
            .into_iter()
            .map(|vertices| TriangleObject {
                vertices,
                both: true,
            })
            .collect();
        let packets: Vec<RayPacket> = (0..PACKETS)
            .map(|_| {
                let rays = std::array::from_fn(|_| {
                    let aimed = mesh.aimed(random);
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

/// As the kernel's header states it, for whatever seed.
#[test]
fn moeller_and_trumbore_leak_where_the_watertight_kernel_does_not() {
    let mut random = random();
    let kinds: [Kind; 4] = [
        (
            |random| {
                let size = magnitude(1e-3..1e3, random);
                let place = in_cube(10.0 * size, random);
                Mesh::new(place, size, [1.0; 3], random)
            },
            0.1,
        ),
        // Thin in one direction or two.
        (
            |random| {
                let widths = std::array::from_fn(|_| magnitude(1e-4..1.0, random));
                Mesh::new([0.0; 3], 1.0, widths, random)
            },
            0.1,
        ),
        // Far out.
        (
            |random| {
                let size = magnitude(1.0..1e3, random);
                Mesh::new([148_376.0, 1234.0, -223_423.0], size, [1.0; 3], random)
            },
            0.1,
        ),
        (Mesh::on_lattice, 0.025),
    ];
    for (kind, stated) in kinds {
        let found = count(&mut random, kind);
        assert_eq!(found.watertight, 0, "{found:?}");
        let rate = f64::from(found.moeller_trumbore) / f64::from(found.rays);
        let likely = stated / 2.0..stated * 2.0;
        assert!(likely.contains(&rate), "{rate} instead of {stated}");
    }
}
