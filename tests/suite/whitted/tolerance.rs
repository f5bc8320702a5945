//! Compares pictures of random scenes with the reference.
//!
//! One class of pixels is wrong: those where a vast surface meets another. Rays start slightly
//! above a surface, by 2^-20 of its size and distance, and therefore miss anything nearer than
//! that.

use std::env;
use std::thread;

use cellray::statistics::Rays;
use oracle::whitted::{Probe, Rounding};

use crate::prelude::*;
use crate::whitted::frame::{WHITTED, options};
use crate::whitted::random::{self, Drawn};

const SIDE: u32 = 16;

/// The number of scenes, unless `CELLRAY_SCENES` sets another.
const SCENES: u64 = 2500;

/// The tolerance of a channel in addition to the rounding to a byte.
const TOLERANCE: f64 = 2.0 / 255.0;

/// If a scene has a vast surface, one in this many pixels may be wrong.
const PIXELS_A_LEAK: u64 = 200_000;

/// The distance from a pixel's centre, in pixels, within which a ray must see what the SPUs saw.
/// The SPUs' directions are off by some 1e-7, which a chain of mirrors and glass magnifies.
const NEAR: f64 = 0.02;

/// The units in the last place by which rays may be moved to explain a pixel, and the number of
/// tries.
const ULPS: u32 = 64;
const TRIES: u64 = 100;

/// Whether this colour explains the SPUs' pixel.
fn is_near(pixel: [u8; 3], colour: DVec3) -> bool {
    let off = |at: usize| (f64::from(pixel[at]) / 255.0 - colour[at]).abs();
    (0..3).all(|at| off(at) <= TOLERANCE + 0.5 / 255.0)
}

/// The colours of `lines` by `lines` rays around a pixel's centre.
fn around(probe: &Probe<'_>, (x, y): (u32, u32), lines: u32) -> impl Iterator<Item = DVec3> {
    let step = move |number: u32| NEAR * (2.0 * f64::from(number) / f64::from(lines - 1) - 1.0);
    (0..lines * lines).map(move |number| {
        let (right, down) = (step(number % lines), step(number / lines));
        probe.colour(f64::from(x) + right, f64::from(y) + down)
    })
}

/// The pixels that no ray near their centres explains, and no rays moved by a few units in the last
/// place.
fn unexplained(
    scene: &scenes::Scene,
    render_options: RenderOptions,
    picture: &RgbImage,
) -> Vec<(u32, u32)> {
    let probe = Probe::new(scene, SIDE, SIDE, &options(render_options)).unwrap();
    let is_explained = |at: (u32, u32), pixel: [u8; 3]| {
        let centre = probe.colour(f64::from(at.0), f64::from(at.1));
        is_near(pixel, centre)
            || [5, 41]
                .into_iter()
                .any(|lines| around(&probe, at, lines).any(|colour| is_near(pixel, colour)))
    };
    let pixels = picture.enumerate_pixels();
    let mut left: Vec<_> =
        pixels.filter(|(x, y, pixel)| !is_explained((*x, *y), pixel.0)).collect();
    let scene = oracle::rounded_to_singles(scene);
    let mut probe = Probe::new(&scene, SIDE, SIDE, &options(render_options)).unwrap();
    for seed in 0..TRIES {
        probe.set_rounding(Rounding::Perturbed { ulps: ULPS, seed });
        left.retain(|(x, y, pixel)| !is_near(pixel.0, probe.colour((*x).into(), (*y).into())));
    }
    left.into_iter().map(|(x, y, _)| (x, y)).collect()
}

/// A scene with wrong pixels.
struct Wrong {
    seed: u64,
    /// Whether the scene contains anything vast.
    vast: bool,
    pixels: Vec<(u32, u32)>,
}

/// The result for some scenes.
#[derive(Default)]
struct Outcome {
    rays: Rays,
    wrong: Vec<Wrong>,
}

/// Traces the scenes of these seeds.
fn outcome(seeds: impl Iterator<Item = u64>) -> Outcome {
    let (framebuffer, shown) = Recorder::pair(SIDE, SIDE);
    let settings = Settings { spus: 1, ..Settings::default() };
    let mut engine = Engine::start(settings, framebuffer).unwrap();
    let mut outcome = Outcome::default();
    for seed in seeds {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let Drawn { scene, vast } = random::scene(&mut random);
        let render_options = RenderOptions {
            ray_depth: random.random_range(1..=8),
            fresnel: random.random_bool(0.5),
            ..WHITTED
        };
        let made = Scene::new(&scene, render_options, &Program::tracer());
        let made = made.unwrap_or_else(|error| panic!("scene {seed}: {error}"));
        let statistics = engine
            .render(&made, &mut |_| ())
            .unwrap_or_else(|error| panic!("scene {seed}: {error}"));
        outcome.rays += statistics.spus[0].rays;
        let picture = shown.lock().unwrap().take().unwrap();
        let pixels = unexplained(&scene, render_options, &picture);
        if !pixels.is_empty() {
            outcome.wrong.push(Wrong { seed, vast, pixels });
        }
    }
    outcome
}

#[test]
fn random_scenes_equal_reference() {
    let scenes = match env::var("CELLRAY_SCENES") {
        Ok(number) => number.parse().expect("CELLRAY_SCENES must be a number of scenes"),
        Err(_) => SCENES,
    };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let outcomes: Vec<Outcome> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads as u64)
            .map(|first| scope.spawn(move || outcome((first..scenes).step_by(threads))))
            .collect();
        let joined = workers.into_iter().map(|worker| worker.join().unwrap());
        joined.collect()
    });
    let (mut rays, mut wrong) = (Rays::default(), Vec::new());
    for outcome in outcomes {
        rays += outcome.rays;
        wrong.extend(outcome.wrong);
    }
    wrong.sort_by_key(|scene| scene.seed);
    let pixels: usize = wrong.iter().map(|scene| scene.pixels.len()).sum();
    println!("{rays:?}");
    println!("{pixels} wrong pixels in {} of {scenes} scenes", wrong.len());
    for Wrong { seed, vast, pixels } in &wrong {
        println!("scene {seed}, vast {vast}: {pixels:?}");
    }
    assert!(wrong.iter().all(|scene| scene.vast));
    assert!(pixels as u64 <= rays.eye / PIXELS_A_LEAK);
    // The scenes must contain something of everything.
    assert!(rays.eye_hit > rays.eye / 4, "{rays:?}");
    for seen in [rays.reflected, rays.refracted, rays.shadow] {
        assert!(seen > rays.eye / 8, "{rays:?}");
    }
}
