//! The layout and the bounding spheres of the BVHs.

use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::scene::block::primitive::Primitive;
use crate::scene::random::{across, magnitude, unit};

/// The points of an object that are farthest out.
fn points(form: &Primitive, random: &mut ChaCha8Rng) -> Vec<DVec3> {
    match *form {
        Primitive::Sphere { centre, radius } => {
            (0..20).map(|_| centre + radius * unit(random)).collect()
        }
        Primitive::Rectangle { corner, edges: [u, v], .. } => {
            vec![corner, corner + u, corner + v, corner + u + v]
        }
        Primitive::Triangle { vertices, .. } => vertices.to_vec(),
        Primitive::Cone { base, axis, height, radii, .. } => (0..20)
            .flat_map(|_| {
                let across = across(random, axis);
                [base + radii[0] * across, base + height * axis + radii[1] * across]
            })
            .collect(),
    }
}

/// A random object of any shape near a position.
pub fn any_object(random: &mut ChaCha8Rng, place: DVec3) -> String {
    let size = magnitude(random, -6.0, 2.0);
    let mut near = || place + unit(random) * size;
    let text = |[x, y, z]: [f64; 3]| format!("{x} {y} {z}");
    let [a, b, c] = [near(), near(), near()];
    let radius = size * random.random_range(0.01..1.0);
    let points = [a, b, c, a + c - b].map(|point| text(point.to_array()));
    let [pa, pb, pc, pd] = &points;
    match random.random_range(0..5) {
        0 => format!("s {pa} {radius}\n"),
        1 => format!("p 4\n{pa}\n{pb}\n{pc}\n{pd}\n"),
        2 => format!("p 3\n{pa}\n{pb}\n{pc}\n"),
        3 => format!("pp 3\n{pa} 0 0 1\n{pb} 0 0 1\n{pc} 0 1 0\n"),
        _ => format!("c\n{pa} {radius}\n{pb} {}\n", random.random_range(0.0..2.0) * size),
    }
}

#[test]
fn every_object_is_inside_all_volumes_above_it() {
    for volumes in [NodeVolumes::Spheres, NodeVolumes::Boxes] {
        objects_are_inside(volumes);
    }
}

fn objects_are_inside(volumes: NodeVolumes) {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    for count in (0..40).chain([63, 64, 65, 128, 129, 300, 500]) {
        let mut rest = String::new();
        let around = unit(&mut random) * magnitude(&mut random, -2.0, 20.0);
        let spread = magnitude(&mut random, 0.0, 6.0);
        for _ in 0..count {
            let place = around + unit(&mut random) * spread;
            rest += &any_object(&mut random, place);
        }
        let scene = scene(&rest);
        let mut block = of(&scene, RenderOptions { ray_depth: 1, volumes, ..Default::default() });
        let boxed = |kind: PrimitiveKind| {
            volumes == NodeVolumes::Boxes
                && kind != PrimitiveKind::Sphere
                && block.primitives[kind as usize].count() > 1
        };
        for kind in PrimitiveKind::ALL {
            let has_boxes = block.box_trees() >> kind as u32 & 1 != 0;
            // The largest of these scenes has no space for boxes.
            assert!(has_boxes == boxed(kind) || count == 500, "{count} {kind:?}");
        }
        let eye = around + unit(&mut random) * magnitude(&mut random, -3.0, 8.0);
        block.write_for(eye).expect("an eye in range");

        let mut met = 0;
        for kind in PrimitiveKind::ALL {
            let primitives = &block.primitives[kind as usize];
            let mut objects = primitives.objects().into_iter();
            let mut last = SCENE_ADDRESS;
            block.walk(kind, &mut |address, above| {
                assert!(address.get() > last, "objects lie in the order of the tree");
                last = address.get();
                let object = objects.next().expect("an object");
                assert_eq!(object.primitive.kind(), kind);
                for point in points(&object.primitive, &mut random) {
                    for volume in above {
                        assert!(volume.holds(point - eye), "{object:?}: {point} in {volume:?}");
                    }
                }
                met += 1;
            });
            assert!(objects.next().is_none());
            assert_eq!(primitives.count() as u32, primitives.record().objects.get());
        }
        assert_eq!(met, count);
    }
}

/// Moves, hides, adds and removes objects. The trees are refitted or rebuilt, and lose no object.
#[test]
fn edited_bvhs_bound_their_objects() {
    for volumes in [NodeVolumes::Spheres, NodeVolumes::Boxes] {
        changing_bvhs_hold_their_objects(volumes);
    }
}

fn changing_bvhs_hold_their_objects(volumes: NodeVolumes) {
    let mut random = ChaCha8Rng::seed_from_u64(3);
    let place = |random: &mut ChaCha8Rng| unit(random) * magnitude(random, -2.0, 5.0);
    let texts: String = (0..150)
        .map(|_| {
            let place = place(&mut random);
            any_object(&mut random, place)
        })
        .collect();
    let first = scene(&texts);
    let options = RenderOptions { ray_depth: 1, volumes, ..Default::default() };
    let shaders = ShaderEntries::new(Vec::new());
    let mut block = SceneBlock::with_spare_capacity(&first, options, &shaders).expect("a block");
    assert_eq!(block.box_trees() != 0, volumes == NodeVolumes::Boxes);
    let material = (0, &first.materials[0]);
    let mut there: Vec<bool> = vec![true; first.objects.len()];
    let (mut added, mut full) = (0, 0);
    for round in 0..60 {
        // Few objects move at first, then many.
        for _ in 0..1 + round {
            let place = place(&mut random);
            let other = scene(&any_object(&mut random, place));
            let shape = &other.objects[0].shape;
            let number = random.random_range(0..there.len());
            match random.random_range(0..8) {
                0 => {
                    block.hide_object(number);
                    there[number] = false;
                }
                1 => {
                    block.remove_object(number);
                    there[number] = false;
                }
                2 => match block.add_object(shape, material, &shaders).expect("in range") {
                    Some(number) => {
                        added += 1;
                        assert_eq!(number, there.len());
                        there.push(true);
                    }
                    None => {
                        // An object that did not fit still has a number, but needs a new block.
                        full += 1;
                        block.remove_object(there.len());
                        there.push(false);
                    }
                },
                // A primitive of another kind does not fit, and the object stays as it was.
                _ => {
                    let before = first.objects.get(number).map(|object| &object.shape);
                    let same = before.is_some_and(|before| {
                        std::mem::discriminant(before) == std::mem::discriminant(shape)
                    });
                    let is_whole =
                        matches!(shape, scenes::Shape::Sphere { .. } | scenes::Shape::Cone { .. });
                    if same && is_whole {
                        there[number] =
                            block.set_object(number, shape, material, &shaders).expect("in range");
                    }
                }
            }
        }
        let eye = if round % 3 == 0 { place(&mut random) } else { block.eye.unwrap_or_default() };
        block.write_for(eye).expect("an eye in range");
        let mut met = 0;
        for kind in PrimitiveKind::ALL {
            let primitives = &block.primitives[kind as usize];
            let mut objects = primitives.objects().into_iter();
            block.walk(kind, &mut |address, above| {
                let object = objects.next().expect("an object");
                let record: &layout::Object = block.at(address);
                assert_eq!(record.sides.get(), object.sides);
                for point in points(&object.primitive, &mut random) {
                    for volume in above {
                        assert!(volume.holds(point - eye), "{object:?}: {point} in {volume:?}");
                    }
                }
                met += 1;
            });
            assert!(objects.next().is_none());
        }
        assert_eq!(met, there.iter().filter(|there| **there).count(), "round {round}");
    }
    assert!(added > 20 && full > 0, "{added} {full}");
}

#[test]
fn levels_and_nodes_at_the_top() {
    // Objects, levels, and nodes at the top: at most 4 of these. All leaves are on one level. A
    // single object has no level.
    for (objects, levels, roots) in [
        (0, 1, 0),
        (1, 0, 1),
        (4, 1, 1),
        (5, 1, 2),
        (16, 1, 4),
        (17, 2, 2),
        (64, 2, 4),
        (65, 3, 2),
        (256, 3, 4),
        (257, 4, 2),
        (800, 4, 4),
    ] {
        let spheres: String = (0..objects).map(|x| format!("s {x} 0 -5 0.5\n")).collect();
        let block = block(&spheres);
        let tree = block.bvhs()[PrimitiveKind::Sphere as usize];
        let found = (tree.objects.get(), tree.levels.get(), tree.root_count.get());
        assert_eq!(found, (objects, levels, roots));
        assert_eq!(block.leaves(PrimitiveKind::Sphere).len(), objects as usize);
    }
}

#[test]
fn neighbours_share_a_node() {
    // A shuffled field of 16x16 spheres: nodes have squares of 2x2 and 4x4 spheres.
    let mut places: Vec<(i32, i32)> = (0..256).map(|index| (index % 16, index / 16)).collect();
    let mut random = ChaCha8Rng::seed_from_u64(3);
    for index in 1..places.len() {
        places.swap(index, random.random_range(0..=index));
    }
    let spheres: String = places.iter().map(|(x, y)| format!("s {x} {y} -5 0.25\n")).collect();
    let block = block(&spheres);
    let mut objects = 0;
    block.walk(PrimitiveKind::Sphere, &mut |_, above| {
        // From the top: a node of four times 2x2 spheres, one of 2x2 spheres, a sphere.
        let [.., Above::Sphere(_, four), Above::Sphere(_, one)] = above else {
            panic!("{above:?}");
        };
        let half_diagonal = |side: f64| (side - 1.0) / 2.0 * 2f64.sqrt() + 0.25;
        for (found, side) in [(four, 2.0), (one, 1.0)] {
            let radius = half_diagonal(side);
            assert!(*found < 1.02 * radius, "{found} for {radius}");
        }
        objects += 1;
    });
    assert_eq!(objects, 256);
}

fn volumes_of(rest: &str) -> u32 {
    block(rest).box_trees()
}

/// Long cylinders in a hall are far smaller than spheres around them, and their test takes long.
#[test]
fn boxes_are_chosen_if_faster() {
    let hall = "p 4\n-4 -4 0\n4 -4 0\n4 4 0\n-4 4 0\n";
    let columns: String = (0..8)
        .map(|number| {
            let (x, y) = (number % 4 * 2 - 3, number / 4 * 6 - 3);
            format!("c\n{x} {y} 0 0.3\n{x} {y} 8 0.3\n")
        })
        .collect();
    let cones = 1 << PrimitiveKind::Cone as u32;
    assert_eq!(volumes_of(&format!("{hall}{columns}")), cones);
    // The same columns in a wide field are hardly ever met.
    let field = "p 4\n-400 -400 0\n400 -400 0\n400 400 0\n-400 400 0\n";
    assert_eq!(volumes_of(&format!("{field}{columns}")), 0);
    // A single column has no node, and spheres are in spheres.
    assert_eq!(volumes_of(&format!("{hall}c\n0 0 0 0.3\n0 0 8 0.3\n")), 0);
    let spheres: String = (0..40).map(|x| format!("s {x} 0 -5 0.5\n")).collect();
    assert_eq!(volumes_of(&spheres), 0);
    assert_eq!(volumes_of(""), 0);
}

/// The choice agrees with what was measured: only of these scenes boxes make frames faster.
#[test]
fn boxes_are_chosen_for_scenes_that_gain() {
    let kinds = |kinds: &[PrimitiveKind]| kinds.iter().map(|&kind| 1 << kind as u32).sum::<u32>();
    for (name, trees) in [
        ("mirrors", kinds(&[PrimitiveKind::Rectangle, PrimitiveKind::Cone])),
        ("glass", kinds(&[PrimitiveKind::Rectangle, PrimitiveKind::Cone])),
        ("shapes", 0),
        ("still-life", 0),
        ("whitted16", 0),
        ("shadows", 0),
        ("shaders", 0),
        ("daylight", 0),
    ] {
        let path = format!("{}/scenes/{name}.nff", env!("CARGO_MANIFEST_DIR"));
        let scene = scenes::load(std::path::Path::new(&path)).expect("a scene");
        let found = SceneBlock::new(&scene, RenderOptions::default(), &|_| Some(0));
        assert_eq!(found.expect("a block").box_trees(), trees, "{name}");
    }
}

/// Boxes take no space that small batches need: then nodes are spheres.
#[test]
fn nodes_are_spheres_without_memory_for_box_code() {
    let mut has_been = [0; 2];
    for count in (40..=640).step_by(40) {
        let triangles: String =
            (0..count).map(|x| format!("p 3\n{x} 0 -5\n{x} 1 -5\n{x} 0 -6\n")).collect();
        let scene = scene(&triangles);
        let [plain, boxed] = [NodeVolumes::Spheres, NodeVolumes::Boxes].map(|volumes| {
            let options = RenderOptions { volumes, ..Default::default() };
            of(&scene, options)
        });
        let [few, many] = [&boxed, &plain].map(|block| block.batch().min(SMALL_BATCH));
        assert_eq!(few, many, "{count}");
        assert_eq!(plain.box_trees(), 0);
        has_been[usize::from(boxed.box_trees() != 0)] += 1;
        if boxed.box_trees() == 0 {
            assert_eq!(plain.bytes(), boxed.bytes(), "{count}");
        }
    }
    assert!(has_been[0] > 0 && has_been[1] > 0, "{has_been:?}");
}
