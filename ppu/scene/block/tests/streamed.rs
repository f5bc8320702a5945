//! Scenes with a mesh: what is in local store, and what in main memory.

use protocol::layout::{EYE_CODE, MATERIAL_STRIDE, MESH_BLOCK, MESH_MAX_SLOTS, SIDES_BOTH};
use scenes::Mesh;
use zerocopy::FromBytes as _;

use super::*;

/// A square of 2 by `rows` triangles across the z axis, with two materials.
fn square(rows: u32) -> Scene {
    let mut scene = scene("f 1 0 0 1 0.5 9 0 1\n");
    let mut mesh = Mesh { two_sided: true, ..Mesh::default() };
    for row in 0..=rows {
        let y = row as f32 / rows as f32;
        mesh.positions.extend([[-1.0, y, -5.0], [1.0, y, -5.0]]);
    }
    for row in 0..rows {
        let [a, b, c, d] = [0, 1, 2, 3].map(|corner| 2 * row + corner);
        mesh.triangles.extend([[a, b, d], [a, d, c]]);
        mesh.materials.extend([row % 2, 1]);
    }
    scene.mesh = Some(Arc::new(mesh));
    scene
}

#[test]
fn small_mesh_is_in_local_store() {
    let scene = square(10);
    let block = of(&scene, RenderOptions::default());
    assert!(block.mesh().is_none());
    let leaves = block.leaves(PrimitiveKind::Triangle);
    assert_eq!(leaves.len(), 20);
    for address in leaves {
        let object: &layout::Object = block.at(address);
        assert_eq!(object.sides.get(), SIDES_BOTH);
    }
}

#[test]
fn large_mesh_is_in_main_memory() {
    let scene = square(2000);
    for ray_depth in [1, 2, 5] {
        let options = RenderOptions { ray_depth, ..RenderOptions::default() };
        let block = of(&scene, options);
        let mesh = block.mesh().unwrap();
        assert_eq!(mesh.blocks.statistics().triangles, 4000);
        assert_eq!(mesh.material_count, 2);
        for (number, &material) in (0..).zip(mesh.blocks.materials()) {
            let size = size_of::<layout::Material>() as u32;
            let record: &layout::Material = block.at(U32::new(mesh.materials + number * size));
            let colour = scene.materials[material as usize].colour;
            assert_eq!(record.colour, singles(colour));
        }
        let waiting = queue_bytes(block.batch(), block.ray_depth()) as u32;
        let used = SCENE_ADDRESS + block.bytes().len() as u32 + waiting;
        assert!(mesh.cache >= used && mesh.cache.is_multiple_of(128));
        assert_eq!(mesh.cache + mesh.slots * MESH_BLOCK, EYE_CODE);
        assert!(mesh.slots >= 8, "{}", mesh.slots);
        assert!(mesh.slots == MESH_MAX_SLOTS || mesh.cache - used < MESH_BLOCK);
    }
}

#[test]
fn eye_moves_in_mesh_coordinates() {
    let mut block = of(&square(2000), RenderOptions::default());
    block.write_for(DVec3::new(1.0, 2.0, 3.0)).unwrap();
    let eye = block.mesh().unwrap().eye.map(F32::get);
    assert_eq!(eye, [1.0, 2.0, 3.0, 0.0]);
}

#[test]
fn streamed_spheres_are_relative_to_a_near_eye() {
    let mut scene = scenes::sphereflake::generate(4).unwrap();
    for (from, relative) in
        [([2.1, 1.3, 1.7], [0.0; 3]), ([210.0, 130.0, 170.0], [210.0, 130.0, 170.0])]
    {
        scene.view.from = DVec3::from_array(from);
        let mut block = of(&scene, RenderOptions::default());
        block.write_for(scene.view.from).unwrap();
        let [eye @ .., _] = block.mesh().unwrap().eye.map(F32::get);
        assert_eq!(eye, relative);
    }
}

#[test]
fn unconvertible_mesh_names_its_file() {
    let mut scene = square(2000);
    let mut mesh = Mesh::clone(scene.mesh.as_deref().unwrap());
    mesh.positions[5] = [1e30; 3];
    scene.mesh = Some(Arc::new(mesh));
    let error = SceneBlock::new(&scene, RenderOptions::default(), &entry).unwrap_err();
    let message = error.to_string();
    assert!(message.starts_with("t.nff: vertex 5 is at [1e30"), "{message}");
}

#[test]
fn mesh_reduces_capacity_for_objects() {
    let mut scene = square(2000);
    let sphere = |number: u32| scenes::Object {
        line: number,
        material: 0,
        shape: scenes::Shape::Sphere {
            centre: DVec3::new(f64::from(number), 0.0, -9.0),
            radius: 0.5,
        },
    };
    scene.objects.extend((0..700).map(sphere));
    let builder = Builder::new(&scene, RenderOptions::default(), &entry);
    let error = builder.in_main_memory(InMainMemory::default()).unwrap_err();
    assert!(matches!(error, BlockError::TooLarge { .. }), "{error}");
    scene.mesh = None;
    assert!(SceneBlock::new(&scene, RenderOptions::default(), &entry).is_ok());
}

/// A scene of spheres, each after a fill of its own, of which `kinds` differ.
fn fills(spheres: u32, kinds: u32) -> Scene {
    let mut rest = String::new();
    for number in 0..spheres {
        let kind = f64::from(number % kinds) / f64::from(kinds);
        rest += &format!("f {kind} 0.5 0.5 1 0 0 0 0\ns {number} 0 -9 0.4\n");
    }
    scene(&rest)
}

fn unchanging(scene: &Scene) -> SceneBlock {
    SceneBlock::new(scene, RenderOptions::default(), &entry).expect("a block")
}

#[test]
fn equal_materials_have_one_record() {
    let block = unchanging(&fills(500, 7));
    assert!(block.mesh().is_none());
    let materials = block.leaves(PrimitiveKind::Sphere).into_iter();
    let materials = materials.map(|address| block.at::<layout::Object>(address).material.get());
    let different: HashSet<u32> = materials.collect();
    assert_eq!(different.len(), 7);
    let single = unchanging(&fills(500, 1));
    let more = 6 * size_of::<layout::Material>();
    assert!(block.bytes().len() - single.bytes().len() <= more + 128);

    let block = unchanging(&fills(8281, 4));
    let mesh = block.mesh().expect("spheres in main memory");
    assert_eq!(mesh.material_count, 4);
    assert!(mesh.table.is_none());
}

/// Spheres of this number of materials, and 120 triangles, which stay in local store.
fn spheres_and_triangles(materials: u32) -> Scene {
    let mut scene = fills(1200, materials);
    let triangle = |number: u32| scenes::Object {
        line: number,
        material: 0,
        shape: scenes::Shape::Polygon {
            vertices: [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]
                .map(|[x, y]| DVec3::new(x, y, -9.0 - f64::from(number)))
                .to_vec(),
        },
    };
    scene.objects.extend((0..120).map(triangle));
    scene
}

#[test]
fn many_materials_are_in_main_memory() {
    // 200 take more than local store has beside triangles there and spheres in main memory.
    for kinds in [200, 1200] {
        let scene = spheres_and_triangles(kinds);
        let block = unchanging(&scene);
        let mesh = block.mesh().expect("spheres in main memory");
        let table = mesh.table.expect("materials in main memory");
        assert_eq!(table.count(), kinds.next_multiple_of(256));
        assert_eq!(mesh.material_count, table.count());
        assert_eq!(mesh.blocks.materials().len(), kinds as usize);
        let records = table.bytes().chunks(MATERIAL_STRIDE as usize);
        for (record, &material) in records.zip(mesh.blocks.materials()) {
            let (record, _) = layout::Material::read_from_prefix(record).unwrap();
            let colour = scene.materials[material as usize].colour;
            assert_eq!(record.colour, singles(colour));
        }
    }
}

#[test]
fn materials_leave_space_for_whole_batches() {
    let mut tables = Vec::new();
    for kinds in (10..=200).step_by(10) {
        let block = unchanging(&spheres_and_triangles(kinds));
        assert_eq!(block.batch(), SMALL_BATCH, "{kinds} materials");
        tables.push(block.mesh().expect("spheres in main memory").table.is_some());
    }
    assert!(tables.is_sorted() && tables.contains(&false) && tables.contains(&true));
}

#[test]
fn few_materials_stay_in_local_store() {
    let block = unchanging(&fills(1200, 50));
    let mesh = block.mesh().expect("spheres in main memory");
    assert!(mesh.table.is_none());
    assert_eq!(mesh.material_count, 50);
}

#[test]
fn materials_of_movable_objects_have_separate_records() {
    let shaders = ShaderEntries::new(Vec::new());
    let scene = fills(40, 2);
    let options = RenderOptions::default();
    let mut block = SceneBlock::with_spare_capacity(&scene, options, &shaders).expect("a block");
    let changed = scenes::Material { colour: DVec3::ONE, ..scene.materials[3].clone() };
    assert!(block.set_material(3, &changed, &shaders).expect("a record"));
    let white = |block: &SceneBlock| {
        let objects = block.leaves(PrimitiveKind::Sphere).into_iter();
        let materials = objects.map(|address| block.at::<layout::Object>(address).material);
        let is_white = |&address: &U32| {
            let material: &layout::Material = block.at(address);
            material.colour == singles(DVec3::ONE)
        };
        materials.filter(is_white).count()
    };
    assert_eq!(white(&block), 1);
    // Without space for all of them, equal ones are shared, and a change needs a new block.
    let scene = fills(1300, 3);
    let mut block = SceneBlock::with_spare_capacity(&scene, options, &shaders).expect("a block");
    assert!(block.mesh().is_some_and(|mesh| mesh.table.is_none()));
    assert!(!block.set_material(3, &changed, &shaders).expect("a record"));
}

#[test]
fn material_in_main_memory_is_changed_in_place() {
    let shaders = ShaderEntries::new(Vec::new());
    let scene = fills(1300, 1300);
    let mut block =
        SceneBlock::with_spare_capacity(&scene, RenderOptions::default(), &shaders).unwrap();
    let numbers = block.mesh().unwrap().blocks.materials().to_vec();
    let number = numbers.iter().position(|&it| it == 700).unwrap();
    let read = |block: &SceneBlock| block.mesh().unwrap().table.unwrap().bytes().to_vec();
    let before = read(&block);
    let changed = scenes::Material { colour: DVec3::ONE, ..scene.materials[700].clone() };
    assert!(block.set_material(700, &changed, &shaders).unwrap());
    let after = read(&block);
    let stride = MATERIAL_STRIDE as usize;
    for (index, (old, new)) in before.chunks(stride).zip(after.chunks(stride)).enumerate() {
        assert_eq!(old != new, index == number);
    }
}

/// A scene with these numbers of spheres, cones and triangles.
fn crowd(spheres: u32, cones: u32, triangles: u32) -> Scene {
    let mut text = String::from("l 0 99 0\n");
    for number in 0..spheres {
        text += &format!("s {number} 0 -9 0.5\n");
    }
    for number in 0..cones {
        text += &format!("c {number} 2 -9 0.4 {number} 3 -9 0.1\n");
    }
    for number in 0..triangles {
        text += &format!("p 3\n{number} 4 -9\n{} 4 -9\n{number} 5 -8\n", number + 1);
    }
    scene(&text)
}

/// How many spheres, cones and triangles are in main memory, and the same of local store.
fn places(scene: &Scene) -> [[usize; 3]; 2] {
    let options = RenderOptions::default();
    let block = SceneBlock::new(scene, options, &entry).expect("a block");
    let statistics = block.mesh().map(|mesh| mesh.blocks.statistics());
    let statistics = statistics.unwrap_or_default();
    let here = [PrimitiveKind::Sphere, PrimitiveKind::Cone, PrimitiveKind::Triangle];
    let here = here.map(|kind| block.primitives[kind as usize].count());
    [[statistics.spheres, statistics.cones, statistics.triangles], here]
}

#[test]
fn only_kinds_beyond_local_store_go_to_main_memory() {
    // A scene that just fits stays in local store.
    assert_eq!(places(&crowd(400, 300, 0)), [[0; 3], [400, 300, 0]]);
    assert_eq!(places(&crowd(0, 900, 0)), [[0; 3], [0, 900, 0]]);
    // One kind goes if that is enough.
    assert_eq!(places(&crowd(1500, 20, 10)), [[1500, 0, 0], [0, 20, 10]]);
    assert_eq!(places(&crowd(20, 1500, 10)), [[0, 1500, 0], [20, 0, 10]]);
    assert_eq!(places(&crowd(0, 1000, 0)), [[0, 1000, 0], [0; 3]]);
    // Otherwise both do.
    assert_eq!(places(&crowd(1500, 1500, 10)), [[1500, 1500, 0], [0, 0, 10]]);
    assert_eq!(places(&crowd(700, 500, 0)), [[700, 500, 0], [0; 3]]);
}

/// Polygons that fit into local store alone, but not beside the code for meshes.
#[test]
fn gathered_polygons_free_no_memory_for_other_shapes() {
    let crowd = crowd(1500, 1500, 400);
    let options = RenderOptions::default();
    let error = SceneBlock::new(&crowd, options, &entry).unwrap_err();
    assert!(error.is_out_of_memory(), "{error}");
    let all = crate::scene::mesh::gathered_all(&crowd).expect("polygons");
    assert_eq!(places(&all), [[1500, 1500, 400], [0; 3]]);
    let whole = crate::Scene::from_nff(&crowd).expect("a scene");
    let statistics = whole.block().and_then(SceneBlock::mesh).expect("a mesh");
    assert_eq!(statistics.blocks.statistics().objects(), 3400);
}

#[test]
fn out_of_range_cone_in_main_memory_is_refused() {
    let mut scene = crowd(0, 1500, 0);
    let scenes::Shape::Cone { apex_radius, .. } = &mut scene.objects[1400].shape else {
        panic!("a cone");
    };
    *apex_radius = 1e30;
    let options = RenderOptions::default();
    let error = SceneBlock::new(&scene, options, &entry).unwrap_err();
    let message = error.to_string();
    let line = scene.objects[1400].line;
    assert!(
        message.starts_with(&format!("t.nff:{line}: apex radius 1e30 is out of range")),
        "{message}"
    );
}
