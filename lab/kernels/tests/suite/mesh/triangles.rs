//! `isect_mesh_pairs_r16` compared with its twin, and with the kernel for resident triangles.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::isect;
use kernels::cases::whitted::isect::shape::Shape as _;
use kernels::cases::whitted::isect::triangle::TriangleObject;
use kernels::cases::whitted::mesh::call;
use kernels::description::any_bits;
use protocol::layout::{MESH_FACES, MESH_RUN, RayPacket};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use twins::mesh_pairs::MeshBlock;
use twins::sphere_ray::Ray;
use zerocopy::IntoBytes as _;

use super::COUNTS;

/// Checks the packets after a call, all their bytes.
fn check(
    bench: &mut Bench,
    packets: &[[Ray; 16]],
    block: &MeshBlock,
    runs: &call::Runs,
    anything: u32,
) -> Vec<[Ray; 16]> {
    let found = call::isect_runs(bench, packets, block, runs, anything);
    let mut expected = packets.to_vec();
    for (run, packet) in runs {
        for ray in &mut expected[*packet] {
            *ray = block.isect_run(*ray, run.clone());
        }
    }
    let records: Vec<RayPacket> =
        expected.iter().map(|rays| isect::call::packet(rays, anything)).collect();
    for (found, (expected, rays)) in found.iter().zip(records.iter().zip(&expected)) {
        assert_eq!(found.as_bytes(), expected.as_bytes(), "{runs:?} {rays:x?} {block:x?}");
    }
    expected
}

fn runs(
    count: usize,
    packets: usize,
    faces: usize,
    random: &mut ChaCha8Rng,
) -> Vec<(std::ops::Range<usize>, usize)> {
    let run = |_| {
        let first = random.random_range(0..faces);
        let length = random.random_range(1..=MESH_RUN as usize);
        (first..(first + length).min(faces), random.random_range(0..packets))
    };
    (0..count).map(run).collect()
}

#[test]
fn runs_equal_the_twin_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut rays, mut hits) = (0, 0);
    for _ in 0..20 {
        for count in COUNTS {
            let around: Vec<_> = (0..8).map(|_| TriangleObject::around(&mut random, 1.0)).collect();
            let vertices: Vec<_> = around.iter().flat_map(|(of, _)| of.vertices).collect();
            let mut faces: Vec<[u8; 3]> =
                (0..8).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
            faces.extend((0..20).map(|_| [(); 3].map(|()| random.random_range(0..24))));
            let block = MeshBlock {
                number: random.random_range(0..1 << 24),
                both: random.random(),
                vertices,
                faces,
            };
            let packets: Vec<_> = around.iter().map(|(_, rays)| *rays).collect();
            let runs = runs(count, packets.len(), block.faces.len(), &mut random);
            let after = check(&mut bench, &packets, &block, &runs, random.random());
            rays += 16 * after.len();
            hits += after.iter().flatten().filter(|ray| ray.object >> 31 != 0).count();
        }
    }
    assert!(hits > rays / 20 && hits < rays * 9 / 10, "{hits} of {rays}");
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..300 {
        let block = MeshBlock {
            number: random.random_range(0..1 << 24),
            both: random.random(),
            vertices: (0..40).map(|_| random.random()).collect(),
            faces: (0..MESH_FACES).map(|_| [(); 3].map(|()| random.random_range(0..40))).collect(),
        };
        let packets: Vec<[Ray; 16]> = (0..4).map(|_| any_bits(&mut random)).collect();
        let runs = runs(7, packets.len(), block.faces.len(), &mut random);
        check(&mut bench, &packets, &block, &runs, random.random());
    }
}

/// Watertight means the same bits as those of the kernel for resident triangles, whose meshes
/// `flat::leaks` tests.
#[test]
fn a_triangle_is_hit_where_a_resident_one_is() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut hits = 0;
    for _ in 0..500 {
        let (object, rays) = TriangleObject::around(&mut random, 1.0);
        let block = MeshBlock {
            number: 3,
            both: object.both,
            vertices: object.vertices.to_vec(),
            faces: vec![[0, 1, 2]],
        };
        let found = check(&mut bench, &[rays], &block, &[(0..1, 0)], 0);
        let packet = [isect::call::packet(&rays, 0)];
        let (resident, addresses) =
            isect::call::pairs(&mut bench, &packet, &[object], &[[0, 0]], 0);
        for (ray, resident) in found[0].iter().zip(isect::call::rays(&resident[0])) {
            let is_hit = ray.object == block.hit(0);
            assert_eq!(is_hit, resident.object == addresses[0]);
            assert_eq!(ray.t, resident.t);
            hits += usize::from(is_hit);
        }
    }
    assert!(hits > 1000, "{hits}");
}
