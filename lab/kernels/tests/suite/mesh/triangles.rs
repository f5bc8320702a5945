//! `isect_mesh_pairs_r16` compared with the kernel for resident triangles.

use kernels::cases::whitted::isect;
use kernels::cases::whitted::isect::shape::Shape as _;
use kernels::cases::whitted::isect::triangle::TriangleObject;
use kernels::cases::whitted::mesh::triangles::IsectRuns;
use kernels::prelude::*;
use twins::mesh_pairs::MeshBlock;

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
        let hit = block.hit(0);
        let (packets, runs) = (vec![rays], vec![(0..1, 0)]);
        let found = IsectRuns { packets, block, runs, anything: 0 }.check(&mut bench);
        let packet = [isect::call::packet(&rays, 0)];
        let (resident, addresses) =
            isect::call::pairs(&mut bench, &packet, &[object], &[[0, 0]], 0);
        for (ray, resident) in found[0].iter().zip(isect::call::rays(&resident[0])) {
            let is_hit = ray.object == hit;
            assert_eq!(is_hit, resident.object == addresses[0]);
            assert_eq!(ray.t, resident.t);
            hits += usize::from(is_hit);
        }
    }
    assert!(hits > 1000, "{hits}");
}
