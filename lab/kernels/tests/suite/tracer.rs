//! The tracer's program with any formulation, shipped or not. All draw the same picture except for
//! their errors.

use std::path::Path;

use cellray::framebuffer::{Geometry, PictureFile};
use cellray::scene::RenderOptions;
use cellray::spe::Program;
use cellray::{Engine, Scene, Settings};
use image::RgbImage;
use kernels::set;
use protocol::formulation::{Formulations, SPHERES, TRIANGLES};

const SIZE: (u32, u32) = (96, 54);

fn picture(scene: &str, formulations: Formulations) -> RgbImage {
    let image = set::tracer(formulations).unwrap();
    let program = Program::from_image(&image).unwrap();
    assert_eq!(program.formulations().unwrap(), formulations);
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let scene = scenes::load(&root.join(scene)).unwrap();
    let scene = Scene::new(&scene, RenderOptions::default(), &program).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("p.png");
    let framebuffer = PictureFile::new(&file, Geometry::new(SIZE.0, SIZE.1).unwrap()).unwrap();
    let settings = Settings { program, ..Settings::default() };
    let mut engine = Engine::start(settings, Box::new(framebuffer)).unwrap();
    engine.render(&scene, &mut |_| ()).unwrap();
    image::open(file).unwrap().into_rgb8()
}

/// Compares with the standard formulations' picture. At most `share` of the pixels may differ by
/// more than two steps of a channel.
fn alike(scene: &str, formulations: Formulations, expected: &RgbImage, share: f64) {
    let found = picture(scene, formulations);
    let far = |(a, b): (&image::Rgb<u8>, &image::Rgb<u8>)| {
        (0..3).any(|channel| a.0[channel].abs_diff(b.0[channel]) > 2)
    };
    let different = found.pixels().zip(expected.pixels());
    let different = different.filter(|pair| far(*pair)).count() as f64;
    let pixels = f64::from(SIZE.0 * SIZE.1);
    assert!(different <= share * pixels, "{scene} by {}: {different} pixels", formulations.name());
}

#[test]
fn every_formulation_draws_the_same_picture_but_for_its_error() {
    let standard = Formulations::standard();
    for scene in ["paper16.nff", "whitted16.nff"] {
        let expected = picture(scene, standard);
        for sphere in SPHERES {
            // A twentieth of the pixels, because the bare estimate has only 7 good bits.
            let formulations = Formulations::of(sphere, standard.triangle);
            alike(scene, formulations, &expected, 0.05);
        }
    }
    let scene = "still-life.nff";
    let expected = picture(scene, standard);
    for triangle in TRIANGLES {
        let formulations = Formulations { triangle, ..standard };
        alike(scene, formulations, &expected, 0.005);
    }
}
