//! Pictures of random scenes against the reference.

use cellray::scene::{Look, Model};
use cellray::{Engine, Scene, Settings};
use image::RgbImage;
use oracle::whitted::{Options, Probe};
use rand::SeedableRng as _;
use rand_chacha::ChaCha8Rng;

use crate::random;
use crate::recorder::Recorder;

const SIDE: u32 = 16;

/// Steps of a channel that a pixel may be off.
const TOLERANCE: f64 = 2.0 / 255.0;

/// How far from a pixel's centre, in pixels, rays are looked for of which one sees what the SPUs
/// saw. The SPU's directions are off by some 1e-7, which a chain of mirrors and glass spreads.
const NEAR: f64 = 0.02;

/// Pixels that no ray near their centre explains.
fn unexplained(scene: &nff::Scene, picture: &RgbImage) -> Vec<(u32, u32)> {
    let probe = Probe::new(scene, SIDE, SIDE, &Options::default()).unwrap();
    let explains = |x: u32, y: u32, found: [u8; 3]| {
        let around = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|step| step * NEAR);
        let seen = around.iter().flat_map(|down| {
            around.map(|right| probe.colour(f64::from(x) + right, f64::from(y) + down))
        });
        let (low, high) = seen.fold(
            ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]),
            |(low, high), colour| {
                let channel = colour.to_array();
                (
                    std::array::from_fn(|at| low[at].min(channel[at])),
                    std::array::from_fn(|at| high[at].max(channel[at])),
                )
            },
        );
        (0..3).all(|at| {
            let found = f64::from(found[at]) / 255.0;
            let slack = TOLERANCE + 0.5 / 255.0;
            found >= low[at] - slack && found <= high[at] + slack
        })
    };
    picture
        .enumerate_pixels()
        .filter(|(x, y, pixel)| {
            let centre = probe.colour(f64::from(*x), f64::from(*y));
            let near = (0..3).all(|at| {
                (f64::from(pixel[at]) / 255.0 - centre[at]).abs() <= TOLERANCE + 0.5 / 255.0
            });
            !near && !explains(*x, *y, pixel.0)
        })
        .map(|(x, y, _)| (x, y))
        .collect()
}

#[test]
fn ten_thousand_random_scenes_are_as_the_reference_has_them() {
    let (framebuffer, shown) = Recorder::pair(SIDE, SIDE);
    let settings = Settings {
        spus: 1,
        ..Settings::default()
    };
    let mut engine = Engine::start(settings, framebuffer).unwrap();
    let (mut wrong_pixels, mut wrong_scenes) = (0, Vec::new());
    for seed in 0..10_000 {
        let scene = random::scene(&mut ChaCha8Rng::seed_from_u64(seed));
        let whitted =
            Scene::new(&scene, WHITTED).unwrap_or_else(|error| panic!("scene {seed}: {error}"));
        engine
            .render(&whitted, &mut |_| ())
            .unwrap_or_else(|error| panic!("scene {seed}: {error}"));
        let picture = shown.lock().unwrap().take().unwrap();
        let wrong = unexplained(&scene, &picture);
        if !wrong.is_empty() {
            wrong_pixels += wrong.len();
            wrong_scenes.push((seed, wrong));
        }
    }
    println!(
        "{wrong_pixels} wrong pixels in {} scenes",
        wrong_scenes.len()
    );
    for (seed, wrong) in wrong_scenes.iter().take(40) {
        println!("scene {seed}: {wrong:?}");
    }
    assert!(wrong_pixels == 0);
}
