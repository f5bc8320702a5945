//! The tetrahedra against what is published of them.

use std::path::Path;

use glam::DVec3;
use scenes::{Error, Scene, Shape, area_vector, tetra};

fn polygons(scene: &Scene) -> Vec<&[DVec3]> {
    fn vertices(object: &scenes::Object) -> &[DVec3] {
        match &object.shape {
            Shape::Polygon { vertices } => vertices.as_slice(),
            other => panic!("{other:?}"),
        }
    }
    scene.objects.iter().map(vertices).collect()
}

#[test]
fn counts() {
    for (level, count) in [(0, 4), (1, 16), (3, 256), (5, 4096)] {
        let scene = tetra::generate(level).expect("a scene");
        assert_eq!(polygons(&scene).len(), count);
        assert_eq!(tetra::polygon_count(level), count as u128);
        assert_eq!((scene.lights.len(), scene.materials.len()), (1, 1));
    }
}

#[test]
fn four_faces_that_look_outwards_make_a_regular_tetrahedron() {
    for level in 0..4 {
        let scene = tetra::generate(level).expect("a scene");
        let half = 0.5f64.powi(level as i32);
        for faces in polygons(&scene).chunks(4) {
            let sum: DVec3 = faces.iter().copied().flatten().sum();
            let middle = sum / 12.0;
            for face in faces {
                assert_eq!(face.len(), 3);
                let normal = area_vector(face);
                assert!(normal.dot(face[0] - middle) > 0.0);
                let edge = face[0].distance(face[1]);
                assert!((edge / half - 8f64.sqrt()).abs() < 1e-12);
                assert!((normal.length() / (edge * edge) - 0.75f64.sqrt()).abs() < 1e-12);
                assert!(face.iter().all(|vertex| vertex.abs().max_element() <= 1.0));
            }
        }
    }
}

#[test]
fn generated_line_numbers_equal_text() {
    let scene = tetra::generate(2).expect("a scene");
    let text = scene.to_string();
    let read =
        scenes::parse(text.as_bytes(), "tetra.nff", &scenes::Limits::default()).expect("NFF");
    assert_eq!(read, scene);
    let lines = |scene: &Scene| {
        let objects = scene.objects.iter().map(|object| object.line);
        let lines = [scene.lights[0].line, scene.materials[0].line];
        lines.into_iter().chain(objects).collect::<Vec<_>>()
    };
    assert_eq!(lines(&read), lines(&scene));
}

#[test]
fn loaded_by_name() {
    let scene = scenes::load(Path::new("tetra:1")).expect("a scene");
    assert_eq!((scene.name.as_str(), scene.objects.len()), ("tetra:1", 16));
    for name in ["tetra:", "tetra:-1", "tetra:two", "tetra:99999999999"] {
        let error = scenes::load(Path::new(name)).expect_err("no level");
        assert!(matches!(error, Error::Tetra(tetra::Error::Level(_))), "{error}");
    }
    let error = scenes::load(Path::new("tetra:10")).expect_err("too many");
    assert_eq!(
        error.to_string(),
        "tetra of level 10 has 4194304 polygons, more than 4000000 objects; the largest level is 9"
    );
    for level in [62, 63, 64, 1000, u32::MAX] {
        assert!(tetra::generate(level).is_err());
    }
}
