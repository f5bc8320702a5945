//! `mesh_list_hits_r16` and `mesh_flat_patches` compared with their twins.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::isect::shape::Shape as _;
use kernels::cases::whitted::isect::triangle::TriangleObject;
use kernels::cases::whitted::mesh::call;
use protocol::layout::{MESH_HIT, MESH_LEAF_PLACES};
use rand::Rng as _;
use twins::mesh_pairs::MeshBlock;

use super::COUNTS;

#[test]
fn hits_are_listed_as_by_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut patches = 0;
    for at in 0..400 {
        let packets: Vec<[u32; 16]> = (0..at % 9)
            .map(|_| {
                // Few triangles, so that rays share them; and objects that aren't part of the mesh.
                let few = random.random_range(1..9);
                std::array::from_fn(|_| match random.random_range(0..8) {
                    0 => random.random_range(0..2) << 7,
                    _ => MESH_HIT + random.random_range(0..few),
                })
            })
            .collect();
        let [found, expected] = call::hits_listed(&mut bench, &packets);
        assert_eq!(found, expected, "{packets:x?}");
        patches += found.1.len();
    }
    assert!(patches > 8000, "{patches}");
}

#[test]
fn patches_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut made, mut missing) = (0, 0);
    for at in 0..200 {
        for count in COUNTS {
            let leaves: Vec<_> = (0..3)
                .map(|leaf| {
                    let vertices = if at % 5 == 0 {
                        (0..24).map(|_| random.random()).collect()
                    } else {
                        let scale = 10_f64.powi(random.random_range(-3..4));
                        (0..8)
                            .flat_map(|_| TriangleObject::around(&mut random, scale).0.vertices)
                            .collect()
                    };
                    MeshBlock {
                        number: random.random_range(0..1 << 10) * MESH_LEAF_PLACES + leaf,
                        both: random.random(),
                        vertices,
                        faces: (0..100)
                            .map(|_| [(); 3].map(|()| random.random_range(0..24)))
                            .collect(),
                    }
                })
                .collect();
            let objects: Vec<u32> = (0..count)
                .map(|_| {
                    let leaf = &leaves[random.random_range(0..3)];
                    let hit = leaf.hit(random.random_range(0..100));
                    match random.random_range(0..8) {
                        0 => hit ^ random.random_range(1..1 << 16) << 7,
                        1 => hit & !MESH_HIT,
                        _ => hit,
                    }
                })
                .collect();
            let (lists, patches) =
                call::flat_patches(&mut bench, &objects, &leaves, random.random());
            let [found, expected] = lists;
            assert_eq!(found, expected, "{objects:x?}");
            missing += found.len();
            for [found, expected] in &patches {
                assert_eq!(found, expected, "{leaves:x?}");
            }
            made += patches.len();
        }
    }
    assert!(made > 6000 && missing > 1000, "{made}, {missing}");
}
