//! Every sphere in exactly one leaf, in a box of its size, beside a mesh or alone.

use glam::Vec3;
use protocol::layout::{MESH_BLOCK, MESH_SPHERES, Object, SIDES_EXIT};
use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use zerocopy::FromBytes as _;

use super::super::{MeshBlocks, MeshObjects, MeshSphere};
use super::meshes::{materials, soup};
use super::valid::Parts;

pub(super) fn spheres(count: u32, seed: u64) -> Vec<MeshSphere> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    (0..count)
        .map(|number| MeshSphere {
            centre: Vec3::from_array(std::array::from_fn(|_| random.random_range(-1.0..1.0))),
            radius: random.random_range(-0.1..0.1),
            sides: if number % 3 == 0 { SIDES_EXIT } else { 0 },
            material: number % 2,
        })
        .collect()
}

/// The spheres of a block's records, in the order of their boxes.
fn of_block(blocks: &MeshBlocks, number: u32) -> Vec<MeshSphere> {
    let boxes = Parts::of(blocks, number).objects();
    let block = &blocks.bytes()[number as usize * MESH_BLOCK as usize..];
    let found = boxes.iter().map(|&(bounds, offset)| {
        let (object, _) = Object::read_from_prefix(&block[offset as usize..]).unwrap();
        let sphere = MeshSphere {
            centre: object.centre.map(|number| number.get()).into(),
            radius: object.offset.get(),
            sides: object.sides.get(),
            material: blocks.materials()[object.material.get() as usize],
        };
        assert_eq!(bounds, sphere.bounds());
        assert_eq!(object.gain.get(), sphere.radius.signum());
        sphere
    });
    found.collect()
}

#[test]
fn every_sphere_is_in_one_leaf() {
    for (count, triangles) in [(1, 0), (4, 0), (5, 0), (17, 0), (3000, 0), (700, 500)] {
        let spheres = spheres(count, u64::from(count));
        let mesh = match triangles {
            0 => scenes::Mesh::default(),
            _ => soup(triangles, 0.1, 1),
        };
        let objects = MeshObjects { spheres: spheres.clone(), ..MeshObjects::default() };
        let blocks = MeshBlocks::new(&mesh, &objects, &materials()).unwrap();
        let statistics = blocks.statistics();
        assert_eq!(statistics.spheres, count as usize);
        assert_eq!(statistics.triangles, triangles as usize);
        let kind = |number: &u32| Parts::of(&blocks, *number).header.kind.get();
        let leaves = (0..blocks.count()).filter(|number| kind(number) == MESH_SPHERES);
        let mut found: Vec<_> = leaves.flat_map(|number| of_block(&blocks, number)).collect();
        let key = |sphere: &MeshSphere| {
            let [x, y, z] = sphere.centre.to_array().map(f32::to_bits);
            [x, y, z, sphere.radius.to_bits(), sphere.sides, sphere.material]
        };
        let mut wanted = spheres.clone();
        found.sort_by_key(key);
        wanted.sort_by_key(key);
        assert_eq!(found, wanted);
    }
}
