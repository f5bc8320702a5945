//! Pixels in sRGB, and light that rolls off.

use cellray::scene::Samples;
use oracle::DepthProbe;
use oracle::whitted::Probe;

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED, options};
use crate::whitted::textures::dark_scene;
use twins::sample_rays::sample;

const SIZE: (u32, u32) = (165, 90);

/// sRGB's value of linear light.
fn encoded(light: f64) -> f64 {
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * libm::pow(light, 1.0 / 2.4) - 0.055 }
}

/// Light that is limited.
fn rolled_off(light: f64) -> f64 {
    if light <= 0.75 { light } else { 1.0 - 0.0625 / (light - 0.5) }
}

/// The byte that a pixel's channel should be.
fn byte(options: RenderOptions, light: f64) -> u8 {
    let light = if options.roll_off { rolled_off(light) } else { light };
    let value = match options.colour {
        Colour::Linear => light,
        Colour::Srgb => encoded(light),
    };
    (255.0 * value.clamp(0.0, 1.0) + 0.5) as u8
}

/// What the reference sees through a point of the picture.
type Light<'a> = Box<dyn Fn(f64, f64) -> DVec3 + 'a>;

/// Compares pictures with what the reference sees of the scene's colours in this sense.
fn check<'a>(scene: &scenes::Scene, model: Model, reference: &dyn Fn(RenderOptions) -> Light<'a>) {
    for (colour, roll_off, samples) in [
        (Colour::Srgb, false, Samples::One),
        (Colour::Linear, true, Samples::One),
        (Colour::Srgb, true, Samples::One),
        (Colour::Srgb, true, Samples::Four),
    ] {
        let options = RenderOptions { model, samples, contrast: 0, colour, roll_off, ..WHITTED };
        let light = reference(options);
        let side = (samples as u32).isqrt();
        let frame = Frame::of(scene, options, SIZE, Settings::default());
        let places = (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| (x, y)));
        let is_off = |&(x, y): &(u32, u32)| {
            let cells = (0..side).flat_map(|row| (0..side).map(move |column| [column, row]));
            let seen = cells.map(|cell| {
                let [dx, dy] = sample(side, cell);
                light(f64::from(x) + dx, f64::from(y) + dy)
            });
            let mean = seen.sum::<DVec3>() / f64::from(side * side);
            let expected = mean.to_array().map(|channel| byte(options, channel));
            let found = frame.picture.get_pixel(x, y).0;
            found.iter().zip(expected).any(|(a, b)| a.abs_diff(b) > 1)
        };
        let off = places.filter(is_off).count();
        println!("{}: {colour:?}, {roll_off}, {samples:?}: {off} pixels off", scene.name);
        assert!(500 * off <= (SIZE.0 * SIZE.1) as usize);
    }
}

#[test]
fn by_whitteds_model() {
    let scenes = ["whitted16.nff", "daylight.nff"].map(nff_scene);
    for scene in scenes.into_iter().chain([dark_scene()]) {
        check(&scene, Model::Whitted, &|render_options| {
            let probe = Probe::new(&scene, SIZE.0, SIZE.1, &options(render_options)).unwrap();
            Box::new(move |x, y| probe.light(x, y))
        });
    }
}

#[test]
fn by_depth_shading() {
    let scene = nff_scene("paper16.nff");
    // With a contrast of 0, tiles that show nothing have no samples, and need none.
    check(&scene, Model::Depth, &|render_options| {
        let meaning = options(render_options).pixels.colour;
        let mut scene = scene.clone();
        scene.background = meaning.light(scene.background);
        for material in &mut scene.materials {
            material.colour = meaning.light(material.colour);
        }
        let probe = DepthProbe::new(&scene, SIZE.0, SIZE.1).unwrap();
        Box::new(move |x, y| probe.colour(x, y))
    });
}
