//! The sphereflake against its definition and against positions of the published balls.nff.

use std::path::Path;

use glam::DVec3;
use scenes::{Error, Scene, Shape, sphereflake};

fn spheres(scene: &Scene) -> Vec<(DVec3, f64)> {
    let sphere = |object: &scenes::Object| match object.shape {
        Shape::Sphere { centre, radius } => Some((centre, radius)),
        _ => None,
    };
    scene.objects.iter().filter_map(sphere).collect()
}

#[test]
fn counts() {
    for (level, count) in [(0, 1), (1, 10), (2, 91), (3, 820), (4, 7381)] {
        let scene = sphereflake::generate(level).expect("a scene");
        assert_eq!(spheres(&scene).len(), count);
        assert_eq!(scene.objects.len(), count + 1);
        assert_eq!(sphereflake::sphere_count(level), count as u128);
        assert_eq!(scene.lights.len(), 3);
    }
}

#[test]
fn spheres_have_published_positions() {
    // Line by line as balls.nff 3.x gives them for the first spheres of level 4 that have no
    // smaller one before them, to six digits; the radius shows the generation.
    let published = [
        (0.0, 0.0, 0.0, 0.5),
        (0.272166, 0.272166, 0.544331, 0.166667),
        (0.420314, 0.420314, 0.618405, 0.0555556),
        (0.470715, 0.470715, 0.598245, 0.0185185),
        (0.481689, 0.481689, 0.57904, 0.00617284),
        (0.475329, 0.45787, 0.577669, 0.00617284),
        (0.461844, 0.304709, 0.43322, 0.0555556),
        (0.492085, 0.33495, 0.372739, 0.0185185),
        (0.519922, 0.310678, 0.485065, 0.00617284),
        (0.230635, 0.38777, 0.729516, 0.0555556),
        (0.269659, 0.433868, 0.779001, 0.00617284),
    ];
    let generated = spheres(&sphereflake::generate(4).expect("a scene"));
    for (x, y, z, radius) in published {
        let near = |sphere: &&(DVec3, f64)| {
            sphere.0.distance(DVec3::new(x, y, z)) < 2e-6 && (sphere.1 - radius).abs() < 1e-6
        };
        assert_eq!(generated.iter().filter(near).count(), 1, "s {x} {y} {z} {radius}");
    }
}

#[test]
fn children_touch_their_parent_and_keep_apart() {
    let generated = spheres(&sphereflake::generate(3).expect("a scene"));
    // Depth first: a parent of n descendants is followed by nine families of n / 9.
    let mut families = vec![(0, 820)];
    let mut pairs = 0;
    while let Some((parent, size)) = families.pop() {
        let (centre, radius) = generated[parent];
        let child_size = (size - 1) / 9;
        if child_size == 0 {
            continue;
        }
        let children: Vec<usize> = (0..9).map(|child| parent + 1 + child * child_size).collect();
        for (index, &child) in children.iter().enumerate() {
            let (child_centre, child_radius) = generated[child];
            assert!((child_radius / radius - 1.0 / 3.0).abs() < 1e-12);
            let gap = centre.distance(child_centre) - radius - child_radius;
            assert!(gap.abs() < 1e-12, "gap {gap}");
            for &other in &children[..index] {
                // 60 degrees apart at 4/3 of the radius, so at least 4/3 between the centres.
                let between = child_centre.distance(generated[other].0) / radius;
                assert!(between > 4.0 / 3.0 - 1e-9, "{between}");
            }
            families.push((child, child_size));
            pairs += 1;
        }
    }
    assert_eq!(pairs, 819);
}

#[test]
fn generated_line_numbers_equal_text() {
    let scene = sphereflake::generate(1).expect("a scene");
    let text = scene.to_string();
    let read =
        scenes::parse(text.as_bytes(), "balls.nff", &scenes::Limits::default()).expect("NFF");
    assert_eq!(read, scene);
    let lines = |scene: &Scene| {
        let lights = scene.lights.iter().map(|light| light.line);
        let materials = scene.materials.iter().map(|material| material.line);
        let objects = scene.objects.iter().map(|object| object.line);
        lights.chain(materials).chain(objects).collect::<Vec<_>>()
    };
    assert_eq!(lines(&read), lines(&scene));
}

#[test]
fn levels_over_limit_report_their_count() {
    let message = |level| sphereflake::generate(level).expect_err("too many").to_string();
    assert_eq!(
        message(7),
        "a sphereflake of level 7 has 5380840 spheres and a polygon, more than 4000000 objects; the largest level is 6"
    );
    for level in [40, 1000, u32::MAX] {
        assert!(message(level).contains("spheres and a polygon"));
    }
}

#[test]
fn loaded_by_name() {
    let scene = scenes::load(Path::new("sphereflake:2")).expect("a scene");
    assert_eq!((scene.name.as_str(), scene.objects.len()), ("sphereflake:2", 92));
    for name in ["sphereflake:", "sphereflake:-1", "sphereflake:two", "sphereflake:99999999999"] {
        let error = scenes::load(Path::new(name)).expect_err("no level");
        assert!(matches!(error, Error::Sphereflake(sphereflake::Error::Level(_))), "{error}");
    }
    assert!(matches!(scenes::load(Path::new("missing.nff")), Err(Error::Io { .. })));
}
