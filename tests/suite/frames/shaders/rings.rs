//! The rings of the example, compared with their formula, and their picture with and without the
//! check.

use super::program::{file, program};
use crate::prelude::*;

fn render(scene: &Scene, (width, height): (u32, u32), check_shaders: bool) -> RgbImage {
    let (framebuffer, shown) = Recorder::pair(width, height);
    let settings = Settings { check_shaders, program: program(), ..Settings::default() };
    let mut engine = Engine::start(settings, framebuffer).unwrap();
    engine.render(scene, &mut |_| ()).unwrap();
    let picture = shown.lock().unwrap().take();
    picture.expect("the frame was presented")
}

/// A ground with only ambient light, so that it shows its own colour.
const GROUND: &str = "\
v
from 31.3 4 -12.2
at 30 0 -14
up 0 1 0
angle 45
hither 1
resolution 128 96
#cellray ambient 1 1 1
f 0.9 0.5 0.2 1 0 0 0 0
#cellray shader rings 0.1 0.3 0.7 0.8
p 4
90 0 -90
-90 0 -90
-90 0 90
90 0 90
";

#[test]
fn rings_equal_formula() {
    let nff = scenes::parse(GROUND.as_bytes(), "ground", &scenes::Limits::default()).unwrap();
    let render_options = RenderOptions { model: Model::Whitted, ..RenderOptions::default() };
    let scene = Scene::new(&nff, render_options, &program()).unwrap();
    let size = nff.view.resolution;
    let picture = render(&scene, size, true);
    let camera = scene.camera(size.0, size.1).unwrap();
    let (own, other) = (DVec3::new(0.9, 0.5, 0.2), DVec3::new(0.1, 0.3, 0.7));
    let (mut dark, mut bright) = (0, 0);
    for (x, y, pixel) in picture.enumerate_pixels() {
        let direction = camera.corner + f64::from(x) * camera.right + f64::from(y) * camera.down;
        let point = camera.eye - direction * (camera.eye.y / direction.y);
        let part = (2.0 * (libm::hypot(point.x, point.z) * 0.8).fract() - 1.0).powi(2);
        dark += u32::from(part > 0.9);
        bright += u32::from(part < 0.1);
        let colour = own + part * (other - own);
        for (channel, found) in pixel.0.into_iter().enumerate() {
            let off = (f64::from(found) / 255.0 - colour[channel]).abs();
            assert!(off <= 1.0 / 255.0, "pixel {x}, {y}: {pixel:?}, {colour}");
        }
    }
    assert!(dark > 300 && bright > 3000, "{dark} {bright}");
}

#[test]
fn shader_check_changes_no_byte() {
    let scene = scenes::load(&file("examples/shader/still_life.nff")).unwrap();
    let scene = Scene::new(&scene, RenderOptions::default(), &program()).unwrap();
    let size = (160, 120);
    assert!(render(&scene, size, false) == render(&scene, size, true));
}
