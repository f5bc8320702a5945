//! Spheres and cones in blocks in the order of codes: each in one leaf, in a box that holds it.

use protocol::layout::{
    BuildBounds, Cone, MESH_BLOCK, MESH_CONES, MESH_INNER, MESH_SPHERES, MeshHeader, Object,
};
use zerocopy::big_endian::F32;
use zerocopy::{FromBytes as _, FromZeros as _};

use super::super::{MeshBlocks, MeshObject, NumberWidth, Numbers};
use super::cones::cones;
use super::spheres::spheres;
use super::valid::Parts;

#[test]
fn every_object_is_in_one_leaf() {
    for (spheres_count, cones_count) in [(1, 0), (0, 1), (16, 17), (3000, 0), (500, 2000)] {
        let spheres = spheres(spheres_count, 1).into_iter().map(MeshObject::Sphere);
        let cones = cones(cones_count, 2).into_iter().map(MeshObject::Cone);
        let objects: Vec<_> = spheres.chain(cones).enumerate().collect();
        let numbers = Numbers { firsts: &[0, 1], minimum: NumberWidth::Byte };
        let (mut blocks, sorted, _) = MeshBlocks::objects_to_sort(&objects, 2, numbers).unwrap();
        blocks.make_sorted(&scenes::Mesh::default(), &sorted);
        let kinds = [MESH_SPHERES, MESH_CONES];
        let mut found = [Vec::new(), Vec::new()];
        for number in 0..blocks.count() {
            let parts = Parts::of(&blocks, number);
            let kind = kinds.iter().position(|&kind| parts.header.kind.get() == kind);
            let Some(kind) = kind else { continue };
            let block = &blocks.bytes()[number as usize * MESH_BLOCK as usize..];
            for (bounds, offset) in parts.objects() {
                let (object, _) = Object::read_from_prefix(&block[offset as usize..]).unwrap();
                let centre = object.centre.map(F32::get);
                let same = objects.iter().find(|(_, it)| match it {
                    MeshObject::Sphere(sphere) => kind == 0 && sphere.centre == centre.into(),
                    MeshObject::Cone(cone) => kind == 1 && cone.base == centre.into(),
                });
                let (number, same) = same.unwrap();
                let (exact, spare) = match same {
                    MeshObject::Sphere(sphere) => (sphere.bounds(), 0.0),
                    MeshObject::Cone(cone) => {
                        let (record, _) =
                            Cone::read_from_prefix(&block[offset as usize..]).unwrap();
                        assert_eq!(record.height.get(), cone.height);
                        let apex = cone.radius + cone.growth * cone.height;
                        (cone.bounds(), 0.07 * cone.radius.max(apex))
                    }
                };
                for beyond in [exact.low - bounds.low, bounds.high - exact.high] {
                    assert!(beyond.min_element() > -4e-7, "{same:?}: {bounds:?}");
                    assert!(beyond.max_element() < spare + 4e-7, "{same:?}: {bounds:?}");
                }
                found[kind].push(*number);
            }
        }
        found.iter_mut().for_each(|it| it.sort_unstable());
        let all = (0..objects.len()).collect::<Vec<_>>();
        assert_eq!(found.concat(), all);
    }
}

/// Each chunk has its first object in one place and some more in another, so that a range gets all
/// of these.
#[test]
fn no_range_has_too_many_blocks() {
    for count in [25_000, 30_000, 100_000_u32] {
        let objects: Vec<_> =
            spheres(count, 1).into_iter().map(MeshObject::Sphere).enumerate().collect();
        let numbers = Numbers { firsts: &[0, 1], minimum: NumberWidth::Byte };
        let (_, sorted, _) = MeshBlocks::objects_to_sort(&objects, 2, numbers).unwrap();
        let chunk = sorted.chunks()[0].triangles.get();
        for crowd in 1..32 {
            let (units, _) = sorted.ranges(|at| match at % chunk {
                0 => 0,
                place if place <= crowd => 1,
                place => place,
            });
            let most = units.iter().map(|unit| unit.count.get()).max().unwrap();
            assert!(most <= 255, "{count} spheres, {crowd} in a crowd: {most} blocks");
            let all: u32 = units.iter().map(|unit| unit.triangles.get()).sum();
            assert_eq!(all, count);
        }
    }
}

/// The boxes are those of a program of SPUs, which may write none, or any numbers.
#[test]
fn any_boxes_are_joined() {
    let spheres = spheres(3000, 1).into_iter().map(MeshObject::Sphere);
    let objects: Vec<_> = spheres.enumerate().collect();
    let numbers = Numbers { firsts: &[0, 1], minimum: NumberWidth::Byte };
    let (blocks, sorted, _) = MeshBlocks::objects_to_sort(&objects, 2, numbers).unwrap();
    let unmade = BuildBounds { unused: 1.into(), ..BuildBounds::new_zeroed() };
    let made = |low: f32, high: f32| BuildBounds {
        low: [F32::new(low); 3],
        high: [F32::new(high); 3],
        ..BuildBounds::new_zeroed()
    };
    let infinity = f32::INFINITY;
    let all =
        [unmade, made(0.0, 0.0), made(f32::NAN, 1.0), made(1.0, -1.0), made(-infinity, infinity)];
    for (case, bounds) in all.iter().enumerate() {
        let mut stored = Vec::new();
        sorted.join_made(&vec![*bounds; blocks.count() as usize], |number, block| {
            let (header, _) = MeshHeader::ref_from_prefix(block).unwrap();
            assert_eq!(header.kind.get(), MESH_INNER);
            stored.push(number);
        });
        let expected = if case == 0 { 1 } else { stored.len().max(2) };
        assert_eq!(stored, (0..expected).collect::<Vec<_>>(), "{case}");
    }
}
