//! Every entity of the format, read, and read back from what is written.

use crate::common::{parsed, scene_text};
use glam::DVec3;
use scenes::{LightKind, Shape, View};

const EVERYTHING: &str = "# a comment first
b 0.1 0.2 0.3 # and one after it
v
from 1e3 .5 +1
at 0 0 0

up 0 0 -1
# between the lines of an entity
angle 45.5
hither 0.01
resolution 640 480
l 4 3 2
l 1 -4 4 0.5 0.25 1
f 1 0.75 0.33 0.8 0.2 100000 0 1
s 0 0 0 0.5
s 1 2 3 -4
c
0 0 0 1
0 0 5. 0
p 3
0 0 0
1 0 0
0 1 0
f 0 0 0 0 0 0 0.5 1.5
pp 4
0 0 0  0 0 1
1 0 0  0 0 1
1 1 0  0 0 1
0 1 0  0 0 2
";

#[test]
fn every_entity_is_read() {
    let scene = parsed(EVERYTHING);
    let view = View {
        from: DVec3::new(1000.0, 0.5, 1.0),
        at: DVec3::ZERO,
        up: DVec3::new(0.0, 0.0, -1.0),
        angle: 45.5,
        hither: 0.01,
        resolution: (640, 480),
    };
    assert_eq!(scene.view, view);
    assert_eq!(scene.background, DVec3::new(0.1, 0.2, 0.3));
    assert_eq!(scene.lights.len(), 2);
    assert_eq!((scene.lights[0].line, scene.lights[0].colour), (12, None));
    let position = DVec3::new(1.0, -4.0, 4.0);
    assert_eq!(scene.lights[1].kind, LightKind::Point { position, range: f64::INFINITY });
    assert_eq!(scene.lights[1].colour, Some(DVec3::new(0.5, 0.25, 1.0)));

    let floor = &scene.materials[0];
    assert_eq!((floor.line, floor.colour), (14, DVec3::new(1.0, 0.75, 0.33)));
    assert_eq!((floor.diffuse, floor.specular, floor.shine), (0.8, 0.2, 100_000.0));
    assert_eq!((floor.transmittance, floor.refraction_index), (0.0, 1.0));
    let glass = &scene.materials[1];
    assert_eq!((glass.line, glass.transmittance, glass.refraction_index), (24, 0.5, 1.5));

    let placed: Vec<_> = scene.objects.iter().map(|it| (it.line, it.material)).collect();
    assert_eq!(placed, [(15, 0), (16, 0), (17, 0), (20, 0), (25, 1)]);
    assert_eq!(scene.objects[0].shape, Shape::Sphere { centre: DVec3::ZERO, radius: 0.5 });
    assert_eq!(
        scene.objects[1].shape,
        Shape::Sphere { centre: DVec3::new(1.0, 2.0, 3.0), radius: -4.0 }
    );
    assert_eq!(
        scene.objects[2].shape,
        Shape::Cone {
            base: DVec3::ZERO,
            base_radius: 1.0,
            apex: DVec3::new(0.0, 0.0, 5.0),
            apex_radius: 0.0
        }
    );
    assert_eq!(
        scene.objects[3].shape,
        Shape::Polygon { vertices: vec![DVec3::ZERO, DVec3::X, DVec3::Y] }
    );
    assert_eq!(
        scene.objects[4].shape,
        Shape::Patch {
            vertices: vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y],
            normals: vec![DVec3::Z, DVec3::Z, DVec3::Z, DVec3::Z * 2.0],
        }
    );
}

#[test]
fn written_scene_reads_back_equal() {
    let scene = parsed(EVERYTHING);
    let text = scene.to_string();
    assert_eq!(parsed(&text), scene);
    assert_eq!(parsed(&text).to_string(), text);
}

#[test]
fn line_ends_do_not_matter() {
    let dos = EVERYTHING.replace('\n', "\r\n");
    assert_eq!(parsed(&dos), parsed(EVERYTHING));
    assert_eq!(parsed(&dos).objects[4].line, 25);
    assert_eq!(parsed(EVERYTHING.trim_end()), parsed(EVERYTHING));
}

#[test]
fn background_is_black_if_absent() {
    assert_eq!(parsed(&scene_text("")).background, DVec3::ZERO);
}

#[test]
fn material_out_of_order_is_rewritten() {
    let mut scene = parsed(&scene_text("s 0 0 0 1\nf 0 1 0 1 0 0 0 1\ns 1 0 0 1\ns 2 0 0 1\n"));
    scene.objects[2].material = 0;
    let back = parsed(&scene.to_string());
    let colour = |index: usize| back.materials[back.objects[index].material as usize].colour;
    assert_eq!([colour(0), colour(1), colour(2)], [DVec3::ONE, DVec3::Y, DVec3::ONE]);
}
