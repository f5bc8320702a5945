//! Every cone in exactly one leaf, in a box that holds it and is no larger than needed, alone or
//! beside spheres and a mesh.

use glam::{DVec3, Vec3};
use protocol::layout::{
    Cone, MESH_BLOCK, MESH_CONES, MESH_SPHERES, Object, SIDES_BOTH, SIDES_EXIT,
};
use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use zerocopy::FromBytes as _;

use super::super::{MeshBlocks, MeshCone, MeshObjects, MeshSphere};
use super::meshes::{materials, soup};
use super::valid::Parts;

/// Cones of all forms: cylinders, those with an apex, and those along an axis.
pub(super) fn cones(count: u32, seed: u64) -> Vec<MeshCone> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    (0..count)
        .map(|number| {
            let mut vector = || DVec3::from_array([0; 3].map(|_| random.random_range(-1.0..1.0)));
            let base = vector();
            let axis = match number % 5 {
                0 => DVec3::AXES[number as usize % 3],
                _ => vector().normalize(),
            };
            let height = random.random_range(0.01..0.5);
            let radius = random.random_range(0.0..0.2);
            let apex = match number % 4 {
                0 => 0.0,
                1 => radius,
                _ => random.random_range(0.0..0.2),
            };
            MeshCone {
                base: base.as_vec3(),
                axis: axis.as_vec3(),
                height: height as f32,
                radius: radius as f32,
                growth: ((apex - radius) / height) as f32,
                hollow: number % 7 == 0,
                sides: if number % 3 == 0 { SIDES_EXIT } else { SIDES_BOTH },
                material: number % 2,
            }
        })
        .collect()
}

/// The cones of a block's records.
fn of_block(blocks: &MeshBlocks, number: u32) -> Vec<MeshCone> {
    let block = &blocks.bytes()[number as usize * MESH_BLOCK as usize..];
    let boxes = Parts::of(blocks, number).objects();
    let found = boxes.iter().map(|&(bounds, offset)| {
        let (record, _) = Cone::read_from_prefix(&block[offset as usize..]).unwrap();
        let (object, _) = Object::read_from_prefix(&block[offset as usize..]).unwrap();
        let cone = MeshCone {
            base: object.centre.map(|number| number.get()).into(),
            axis: object.axis.map(|number| number.get()).into(),
            height: record.height.get(),
            radius: record.radius.get(),
            growth: record.growth.get(),
            hollow: object.gain.get() < 0.0,
            sides: object.sides.get(),
            material: blocks.materials()[object.material.get() as usize],
        };
        assert_eq!(bounds, cone.bounds());
        let apex = cone.radius + cone.growth * cone.height;
        let extent = cone.height + cone.radius.max(apex);
        assert!((object.leave.get() - extent).abs() < 1e-6, "{cone:?}");
        cone
    });
    found.collect()
}

fn key(cone: &MeshCone) -> [u32; 4] {
    let [x, y, z] = cone.base.to_array().map(f32::to_bits);
    [x, y, z, cone.height.to_bits()]
}

#[test]
fn every_cone_is_in_one_leaf() {
    for (count, spheres, triangles) in
        [(1, 0, 0), (4, 0, 0), (5, 0, 0), (17, 1, 0), (3000, 0, 0), (700, 900, 500)]
    {
        let objects = MeshObjects {
            cones: cones(count, u64::from(count)),
            spheres: (0..spheres)
                .map(|number| MeshSphere {
                    centre: Vec3::splat(number as f32),
                    radius: 0.5,
                    sides: 0,
                    material: 0,
                })
                .collect(),
        };
        let mesh = match triangles {
            0 => scenes::Mesh::default(),
            _ => soup(triangles, 0.1, 1),
        };
        let blocks = MeshBlocks::new(&mesh, &objects, &materials()).unwrap();
        let statistics = blocks.statistics();
        assert_eq!(statistics.cones, count as usize);
        assert_eq!(statistics.spheres, spheres as usize);
        assert_eq!(statistics.triangles, triangles as usize);
        assert!(statistics.expected_cones > 0.0);
        let kind = |number: &u32| Parts::of(&blocks, *number).header.kind.get();
        let of_kind = |wanted| (0..blocks.count()).filter(move |number| kind(number) == wanted);
        let in_spheres: usize =
            of_kind(MESH_SPHERES).map(|number| Parts::of(&blocks, number).objects().len()).sum();
        assert_eq!(in_spheres, spheres as usize);
        let mut found: Vec<_> =
            of_kind(MESH_CONES).flat_map(|number| of_block(&blocks, number)).collect();
        let mut wanted = objects.cones;
        found.sort_by_key(key);
        wanted.sort_by_key(key);
        assert_eq!(found, wanted);
    }
}

/// The box holds both rims, and each of its sides is met by one of them.
#[test]
fn cone_boxes_bound_their_rims() {
    for cone in cones(500, 3) {
        let bounds = cone.bounds();
        let (low, high) = (bounds.low.as_dvec3(), bounds.high.as_dvec3());
        let axis = cone.axis.as_dvec3().normalize();
        let across = axis.any_orthonormal_vector();
        let other = axis.cross(across);
        let [radius, growth, height] = [cone.radius, cone.growth, cone.height].map(f64::from);
        let mut most = [DVec3::INFINITY; 2];
        for (height, radius) in [(0.0, radius), (height, (radius + growth * height).max(0.0))] {
            for step in 0..3600 {
                let angle = f64::from(step) / 3600.0 * std::f64::consts::TAU;
                let (sin, cos) = (libm::sin(angle), libm::cos(angle));
                let point =
                    cone.base.as_dvec3() + axis * height + (across * cos + other * sin) * radius;
                most[0] = most[0].min(point - low);
                most[1] = most[1].min(high - point);
            }
        }
        for off in most {
            // The axis of the record is a unit vector but for its rounding.
            assert!(off.min_element() > -1e-7, "{cone:?}: {most:?}");
            assert!(off.max_element() < 1e-6, "{cone:?}: {most:?}");
        }
    }
}
