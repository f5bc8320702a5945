//! The scenes of the Standard Procedural Databases against what is published of them, and against
//! their definitions.

use std::path::Path;

use glam::DVec3;
use scenes::spd::{Error, GENERATORS};
use scenes::{Object, Scene, Shape, area_vector};

fn scene(name: &str) -> Scene {
    scenes::load(Path::new(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn primitives(scene: &Scene) -> usize {
    let triangles = scene.mesh.as_ref().map_or(0, |mesh| mesh.triangles.len());
    scene.objects.len() + triangles
}

/// The vertices of the polygons.
fn polygons(scene: &Scene) -> impl Iterator<Item = &[DVec3]> {
    scene.objects.iter().filter_map(|object| match &object.shape {
        Shape::Polygon { vertices } => Some(vertices.as_slice()),
        _ => None,
    })
}

fn spheres(scene: &Scene) -> Vec<(DVec3, f64)> {
    let sphere = |object: &Object| match object.shape {
        Shape::Sphere { centre, radius } => Some((centre, radius)),
        _ => None,
    };
    scene.objects.iter().filter_map(sphere).collect()
}

/// The two ends of the cones, each with its radius.
fn cones(scene: &Scene) -> Vec<[(DVec3, f64); 2]> {
    let cone = |object: &Object| match object.shape {
        Shape::Cone { base, base_radius, apex, apex_radius } => {
            Some([(base, base_radius), (apex, apex_radius)])
        }
        _ => None,
    };
    scene.objects.iter().filter_map(cone).collect()
}

#[test]
fn default_sizes_have_published_numbers_of_primitives_and_lights() {
    for (name, count, lights) in [
        ("gears", 9345, 5),
        ("mount", 8196, 1),
        ("rings", 8401, 3),
        ("tree", 8191, 7),
        // A square of the board is two triangles here.
        ("teapot", 9264 + 144, 2),
        ("lattice", 2197 + 6084, 6),
        ("jacks", 9, 1),
        ("shells", 5761, 1),
        ("sombrero", 2 * 31 * 31, 1),
    ] {
        let scene = scene(name);
        assert_eq!(primitives(&scene), count, "{name}");
        assert_eq!(scene.lights.len(), lights, "{name}");
    }
}

#[test]
fn object_count_equals_prediction() {
    for generator in &GENERATORS {
        for size in 1..=5 {
            let scene = generator.generate(size).expect("a scene");
            let count = generator.object_count(size);
            assert_eq!(scene.name, format!("{}:{size}", generator.name));
            assert_eq!(primitives(&scene) as u128, count, "{}", scene.name);
        }
    }
}

#[test]
fn generated_line_numbers_equal_text() {
    for generator in &GENERATORS {
        let scene = generator.generate(2).expect("a scene");
        let text = scene.to_string();
        let read =
            scenes::parse(text.as_bytes(), "spd.nff", &scenes::Limits::default()).expect("NFF");
        let objects = |scene: &Scene| -> Vec<_> {
            let objects = scene.objects.iter();
            let material = |object: &Object| scene.materials[object.material as usize].clone();
            let each = |object: &Object| (object.line, object.shape.clone(), material(object));
            objects.map(each).collect()
        };
        if scene.mesh.is_some() {
            // Triangles have no lines.
            assert_eq!(read.objects.len(), primitives(&scene));
        } else {
            assert_eq!(objects(&read), objects(&scene), "{}", scene.name);
        }
        assert_eq!((&read.view, &read.lights), (&scene.view, &scene.lights));
        let lines =
            |scene: &Scene| -> Vec<u32> { scene.lights.iter().map(|light| light.line).collect() };
        assert_eq!(lines(&read), lines(&scene), "{}", scene.name);
        for material in &scene.materials {
            let line = text.lines().nth(material.line as usize - 1);
            let is_material = line.is_some_and(|line| line.starts_with("f "));
            assert!(is_material, "{}: {line:?}", scene.name);
        }
    }
}

#[test]
fn equal_materials_are_one() {
    for (name, count) in [
        ("mount:3", 2),
        ("rings:3", 7),
        ("tree:3", 2),
        ("teapot:2", 3),
        ("lattice:3", 4),
        ("jacks:2", 1),
    ] {
        assert_eq!(scene(name).materials.len(), count, "{name}");
    }
    let gears = scene("gears:4");
    for (index, material) in gears.materials.iter().enumerate() {
        assert!(!gears.materials[..index].contains(material));
    }
}

#[test]
fn wheels_are_closed_and_face_outwards() {
    let scene = scene("gears:2");
    let all: Vec<&[DVec3]> = polygons(&scene).collect();
    for wheel in all[1..].chunks(146) {
        let [top, sides @ .., bottom] = wheel else {
            panic!("{} polygons", wheel.len());
        };
        assert_eq!((top.len(), bottom.len()), (144, 144));
        assert!(area_vector(top).z > 0.0 && area_vector(bottom).z < 0.0);
        // The faces of a closed body add up to nothing.
        let sum: DVec3 = wheel.iter().map(|face| area_vector(face)).sum();
        assert!(sum.length() < 1e-12, "{sum}");
        for side in sides {
            let middle = top.iter().sum::<DVec3>() / 144.0;
            // The sides of a tooth are steep.
            let outwards = area_vector(side).dot(side[0] + side[2] - 2.0 * middle);
            assert!(outwards > 0.0, "{outwards}");
        }
    }
}

#[test]
fn four_spheres_touch_before_a_mountain_that_faces_up() {
    for size in [1, 4, 7] {
        let scene = scene(&format!("mount:{size}"));
        let spheres = spheres(&scene);
        for (index, (centre, radius)) in spheres.iter().enumerate() {
            for (other, _) in &spheres[..index] {
                assert!((centre.distance(*other) - 2.0 * radius).abs() < 1e-12);
            }
        }
        assert!(polygons(&scene).all(|triangle| area_vector(triangle).z > 0.0));
        let corners: Vec<&DVec3> = polygons(&scene)
            .flatten()
            .filter(|point| point.x.abs() == 1.0 && point.y.abs() == 1.0)
            .collect();
        assert!(corners.iter().all(|corner| corner.z == 0.0));
        assert_eq!(corners.len(), 6);
    }
}

#[test]
fn rings_are_regular_pentagons() {
    let scene = scene("rings:2");
    let (cones, spheres) = (cones(&scene), spheres(&scene));
    assert_eq!((cones.len(), spheres.len()), (150, 150));
    let side = 2.0 * libm::sin(std::f64::consts::PI / 5.0);
    for (ring, joints) in cones.chunks(5).zip(spheres.chunks(5)) {
        for (at, &[(base, radius), (apex, _)]) in ring.iter().enumerate() {
            assert_eq!((base, radius), joints[at]);
            assert!(apex.distance(joints[(at + 4) % 5].0) < 1e-12);
            assert!((base.distance(apex) * (1.0 + radius) - side).abs() < 1e-12);
        }
    }
}

#[test]
fn branches_start_at_ends_of_others() {
    let scene = scene("tree:4");
    let (cones, spheres) = (cones(&scene), spheres(&scene));
    assert_eq!(cones[0][0], (DVec3::ZERO, 0.15));
    for (index, &[base, apex]) in cones.iter().enumerate() {
        assert_eq!(spheres[index], apex);
        let is_carried = cones.iter().any(|&[_, (end, radius)]| {
            end.distance(base.0) < 1e-12 && (radius - base.1).abs() < 1e-12
        });
        assert!(index == 0 || is_carried, "{base:?}");
    }
}

#[test]
fn cylinders_of_a_lattice_end_inside_of_spheres() {
    let scene = scene("lattice:3");
    let spheres = spheres(&scene);
    for end in cones(&scene).into_iter().flatten() {
        let (point, radius) = end;
        let is_inside = |&(centre, size): &(DVec3, f64)| {
            point.distance_squared(centre) + radius * radius < size * size
        };
        assert_eq!(spheres.iter().filter(|sphere| is_inside(sphere)).count(), 1);
    }
}

#[test]
fn jacks_do_not_touch() {
    let scene = scene("jacks:3");
    let spheres = spheres(&scene);
    for (index, &(centre, radius)) in spheres.iter().enumerate() {
        for &(other, size) in &spheres[..index] {
            assert!(centre.distance(other) > radius + size);
        }
    }
}

#[test]
fn surface_of_teapot_is_smooth_and_faces_outwards() {
    let scene = scene("teapot");
    let mesh = scene.mesh.as_ref().expect("a mesh");
    assert!(mesh.two_sided);
    let mut smooth = 0;
    for triangle in 0..mesh.triangles.len() {
        let corners = mesh.corners(triangle).map(|corner| corner.as_dvec3());
        let area = area_vector(&corners);
        assert!(area.length() > 1e-6, "{corners:?}");
        let Some(normals) = mesh.corner_normals(triangle) else {
            // Of the board.
            assert!(area.z > 0.0 && corners.iter().all(|corner| corner.z == 0.0));
            continue;
        };
        smooth += 1;
        for normal in normals {
            let normal = normal.as_dvec3();
            assert!((normal.length() - 1.0).abs() < 1e-6);
            assert!(normal.dot(area) > 0.0, "{corners:?} {normals:?}");
        }
    }
    assert_eq!(smooth, 9120);
    // Where the body is widest, its normals point away from the axis.
    let body = mesh.positions.iter().zip(&mesh.normals);
    let widest = body.filter(|([x, y, z], _)| {
        (0.9..1.35).contains(z) && (x * x + y * y - 4.0).abs() < 0.1 && y.abs() > 0.5
    });
    let mut found = 0;
    for (place, normal) in widest {
        assert!(place[0] * normal[0] + place[1] * normal[1] > 1.5);
        found += 1;
    }
    assert!(found > 50, "{found}");
}

#[test]
fn sombrero_faces_up_and_is_highest_in_its_middle() {
    let scene = scene("sombrero");
    assert!(polygons(&scene).all(|triangle| area_vector(triangle).y > 0.0));
    let highest = polygons(&scene).flatten().max_by(|a, b| a.y.total_cmp(&b.y));
    let highest = highest.expect("points");
    assert_eq!(highest.y, -2.0);
    assert!(libm::hypot(highest.x, highest.z) < 0.2, "{highest}");
}

#[test]
fn loaded_by_name() {
    let sizes = |name: &str| scene(name).name;
    for generator in &GENERATORS {
        let default = format!("{}:{}", generator.name, generator.default);
        assert_eq!(sizes(generator.name), default);
        for size in ["", "0", "-1", "two", "1.5", "99999999999"] {
            let name = format!("{}:{size}", generator.name);
            let error = scenes::load(Path::new(&name)).expect_err("no size");
            assert!(matches!(error, scenes::Error::Spd(Error::Size { .. })), "{error}");
            let message = error.to_string();
            assert!(message.starts_with(generator.name), "{message}");
            assert!(message.ends_with("is not a whole number from 1"), "{message}");
        }
        // Also where a power of two overflows.
        for size in [125, 126, 127, 128, 1 << 16, u32::MAX] {
            if generator.object_count(size) > 4_000_000 {
                assert!(generator.generate(size).is_err(), "{}", generator.name);
            }
        }
        assert!(generator.object_count(u32::MAX) > 4_000_000);
    }
    for (name, message) in [
        (
            "gears:31",
            "gears of size 31 has 4349487 objects, more than 4000000; the largest size is 30",
        ),
        ("mount:8", "mount of size 8: SPD defines sizes up to 7"),
    ] {
        let error = scenes::load(Path::new(name)).expect_err("too many");
        assert_eq!(error.to_string(), message);
    }
    // Other names are files.
    let error = scenes::load(Path::new("./gears")).expect_err("no file");
    assert!(matches!(error, scenes::Error::Io { .. }), "{error}");
}
