//! Antialiasing: which pixels are traced again, what they show, and that nothing depends on who
//! traces them.

use cellray::scene::{CONTRAST, Samples};
use image::Rgb;
use oracle::DepthProbe;
use oracle::whitted::Probe;
use twins::sample_rays::sample;

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED, options};

const SIZE: (u32, u32) = (293, 158);
const MIN_CONTRAST: u8 = 16;
const TILE: (u32, u32) = (64, 16);

fn antialiased(samples: Samples, contrast: u8) -> RenderOptions {
    RenderOptions { samples, contrast, ..WHITTED }
}

/// Whether a channel of two pixels differs by at threshold `threshold`.
fn differ(a: Rgb<u8>, b: Rgb<u8>, threshold: u8) -> bool {
    a.0.iter().zip(b.0).any(|(a, b)| a.abs_diff(b) >= threshold)
}

/// The pixels of a picture with one ray each that differ from a neighbour in their tile.
fn differing(picture: &RgbImage, threshold: u8) -> Vec<(u32, u32)> {
    differing_in(picture, threshold, TILE)
}

/// The same for tiles of another size.
fn differing_in(picture: &RgbImage, threshold: u8, size: (u32, u32)) -> Vec<(u32, u32)> {
    let tile = |(x, y): (u32, u32)| (x / size.0, y / size.1);
    let (width, height) = picture.dimensions();
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let beside = |(x, y): (u32, u32)| {
        let moved = [(0, 1), (2, 1), (1, 0), (1, 2)].map(|(dx, dy)| (x + dx, y + dy));
        let within = moved.into_iter().filter(|&(x, y)| x > 0 && y > 0);
        let unmoved = within.map(|(x, y)| (x - 1, y - 1));
        unmoved.filter(move |&(x, y)| x < width && y < height)
    };
    places
        .filter(|&at| {
            beside(at).filter(|&other| tile(other) == tile(at)).any(|other| {
                let [here, there] = [at, other].map(|(x, y)| *picture.get_pixel(x, y));
                differ(here, there, threshold)
            })
        })
        .collect()
}

/// What the reference sees through a point of the picture.
type Light<'a> = dyn Fn(f64, f64) -> DVec3 + 'a;

/// The pixel that the reference makes of the same samples.
fn expected(light: &Light, (x, y): (u32, u32), side: u32) -> [u8; 3] {
    let cells = (0..side).flat_map(|row| (0..side).map(move |column| (column, row)));
    let sum = cells.fold(DVec3::ZERO, |sum, (column, row)| {
        let [dx, dy] = sample(side, [column, row]);
        sum + light(f64::from(x) + dx, f64::from(y) + dy)
    });
    let mean = (sum / f64::from(side * side)).clamp(DVec3::ZERO, DVec3::ONE);
    (255.0 * mean + 0.5).to_array().map(|channel| channel as u8)
}

/// How many of these pixels are off by more than 1/255.
fn off(picture: &RgbImage, pixels: &[(u32, u32)], light: &Light, side: u32) -> usize {
    let wrong = |&&(x, y): &&(u32, u32)| {
        let expected = Rgb(expected(light, (x, y), side));
        differ(*picture.get_pixel(x, y), expected, 2)
    };
    pixels.iter().filter(wrong).count()
}

/// Compares pictures of a scene with several samples a pixel with one that has one sample, and
/// with the reference.
fn samples_are_those_of_the_reference(scene: &scenes::Scene, one: RenderOptions, light: &Light) {
    let all: Vec<_> = (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| (x, y))).collect();
    let plain = Frame::of(scene, one, SIZE, Settings::default());
    let chosen = differing(&plain.picture, MIN_CONTRAST);
    assert!(chosen.len() > all.len() / 100 && chosen.len() < all.len() / 2);
    for samples in [Samples::Four, Samples::Sixteen] {
        let count = samples as usize;
        let side = count.isqrt() as u32;
        let of_contrast = |contrast| {
            let options = RenderOptions { samples, contrast, ..one };
            Frame::of(scene, options, SIZE, Settings::default())
        };
        let smooth = of_contrast(MIN_CONTRAST);
        let rays = smooth.rays();
        assert_eq!(rays.samples, (count * chosen.len()) as u64);
        assert_eq!(rays.eye - rays.samples, all.len() as u64);
        assert!(rays.eye_hit <= rays.eye);
        // All other pixels are as they were.
        let mut others = smooth.picture.clone();
        for &(x, y) in &chosen {
            others.put_pixel(x, y, *plain.picture.get_pixel(x, y));
        }
        assert!(others == plain.picture);

        let everywhere = of_contrast(0);
        if one.model == Model::Whitted {
            assert_eq!(everywhere.rays().eye, (count * all.len()) as u64);
        }
        assert_eq!(everywhere.statistics.primary_rays(), all.len() as u64);
        let differs = |&&(x, y): &&(u32, u32)| {
            let [a, b] = [&smooth, &everywhere].map(|frame| *frame.picture.get_pixel(x, y));
            differ(a, b, 2)
        };
        assert_eq!(chosen.iter().filter(differs).count(), 0);

        let off = off(&smooth.picture, &chosen, light, side);
        println!(
            "{}, {count} samples: {} of {} pixels, {off} off",
            scene.name,
            chosen.len(),
            all.len()
        );
        // At this size, many pixels are on edges, where rays may decide otherwise.
        assert!(50 * off <= chosen.len());
    }
}

fn by_whitted(name: &str) {
    let scene = nff_scene(name);
    let probe = Probe::new(&scene, SIZE.0, SIZE.1, &options(WHITTED)).unwrap();
    samples_are_those_of_the_reference(&scene, WHITTED, &|x, y| probe.light(x, y));
}

#[test]
fn spheres() {
    by_whitted("whitted16.nff");
}

#[test]
fn all_shapes() {
    by_whitted("shapes.nff");
}

#[test]
fn full_size_picture_equals_reference() {
    let (width, height) = (1280, 720);
    let scene = nff_scene("whitted16.nff");
    let probe = Probe::new(&scene, width, height, &options(WHITTED)).unwrap();
    let [plain, smooth] = [Samples::One, Samples::Four].map(|samples| {
        let options = antialiased(samples, CONTRAST);
        Frame::of(&scene, options, (width, height), Settings::default()).picture
    });
    let chosen = differing(&plain, CONTRAST);
    let all: Vec<_> = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).collect();
    let light: &Light = &|x, y| probe.light(x, y);
    let off_at_centres = off(&plain, &all, light, 1) - off(&plain, &chosen, light, 1);
    let off = off(&smooth, &chosen, light, 2) + off_at_centres;
    println!("{off} of {} pixels off", all.len());
    assert!(1000 * off <= all.len());
    // Edges that run exactly between tiles keep their steps.
    let kept = differing_in(&plain, CONTRAST, (width, height)).len() - chosen.len();
    println!("{kept} pixels differ only from neighbours in other tiles");
    assert!(25 * kept <= chosen.len());
}

/// How far from a sample its ray may have decided what it hits, in pixels.
const NEAR: f64 = 1.0 / 16.0;

/// Whether a pixel is, to 1/255, a mean of what the reference sees near its samples.
fn is_explained(found: Rgb<u8>, light: &Light, (x, y): (u32, u32), side: u32) -> bool {
    let cells = (0..side).flat_map(|row| (0..side).map(move |column| [column, row]));
    let around = [-1.0, 0.0, 1.0].into_iter();
    let around = around.flat_map(|dx| [-1.0, 0.0, 1.0].map(|dy| (NEAR * dx, NEAR * dy)));
    let (mut min, mut max) = (DVec3::ZERO, DVec3::ZERO);
    for cell in cells {
        let [dx, dy] = sample(side, cell);
        let (x, y) = (f64::from(x) + dx, f64::from(y) + dy);
        let seen = around.clone().map(|(dx, dy)| light(x + dx, y + dy));
        let seen: Vec<_> = seen.collect();
        min += seen.iter().copied().reduce(DVec3::min).unwrap();
        max += seen.iter().copied().reduce(DVec3::max).unwrap();
    }
    let count = f64::from(side * side);
    let byte = |sum: DVec3| 255.0 * (sum / count).clamp(DVec3::ZERO, DVec3::ONE);
    let found = DVec3::from(found.0.map(f64::from));
    let [min, max] = [byte(min) - 1.5, byte(max) + 1.5];
    found.cmpge(min).all() && found.cmple(max).all()
}

/// With 16 samples a pixel, 16 rays may decide otherwise than the reference at an edge, and each of
/// them moves the pixel by a sixteenth of the edge.
#[test]
fn sixteen_samples_differ_only_near_edges() {
    let (width, height) = (640, 360);
    let scene = nff_scene("whitted16.nff");
    let probe = Probe::new(&scene, width, height, &options(WHITTED)).unwrap();
    let light: &Light = &|x, y| probe.light(x, y);
    let frame = |samples| {
        let options = antialiased(samples, MIN_CONTRAST);
        Frame::of(&scene, options, (width, height), Settings::default()).picture
    };
    let (plain, smooth) = (frame(Samples::One), frame(Samples::Sixteen));
    let chosen = differing(&plain, MIN_CONTRAST);
    let wrong: Vec<_> = chosen.iter().filter(|&&at| off(&smooth, &[at], light, 4) > 0).collect();
    // What one ray of a pixel decides otherwise, of all pixels.
    let all: Vec<_> = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).collect();
    let one = off(&plain, &all, light, 1);
    println!("{} of {} pixels off, {one} with one sample", wrong.len(), all.len());
    let is_unexplained =
        |&&&(x, y): &&&(u32, u32)| !is_explained(*smooth.get_pixel(x, y), light, (x, y), 4);
    let unexplained = wrong.iter().filter(is_unexplained).count();
    assert!(unexplained <= 1, "{unexplained}");
    assert!(wrong.len() < 16 * one);
}

#[test]
fn depth_shading() {
    let scene = nff_scene("paper16.nff");
    let probe = DepthProbe::new(&scene, SIZE.0, SIZE.1).unwrap();
    let one = RenderOptions { model: Model::Depth, ..WHITTED };
    samples_are_those_of_the_reference(&scene, one, &|x, y| probe.colour(x, y));
}

#[test]
fn picture_is_independent_of_spus_and_work_units() {
    let scene = nff_scene("whitted16.nff");
    let frame = |spus, split, skip| {
        let settings = Settings { spus, split, skip, ..Settings::default() };
        Frame::of(&scene, antialiased(Samples::Sixteen, MIN_CONTRAST), SIZE, settings)
    };
    let one = frame(1, Split::Units, Skip::Misses);
    for spus in 2..=6 {
        let other = frame(spus, Split::Units, Skip::Misses);
        assert!(other.picture == one.picture, "{spus} SPUs");
        assert_eq!(other.rays(), one.rays(), "{spus} SPUs");
    }
    for (split, skip) in [(Split::Slices, Skip::Misses), (Split::Units, Skip::Nothing)] {
        assert!(frame(6, split, skip).picture == one.picture);
    }
}

#[test]
fn depth_shading_is_independent_of_spus_and_work_units() {
    let scene = nff_scene("paper16.nff");
    let frame = |spus, skip| {
        let settings = Settings { spus, skip, ..Settings::default() };
        let options =
            RenderOptions { model: Model::Depth, ..antialiased(Samples::Four, MIN_CONTRAST) };
        Frame::of(&scene, options, SIZE, settings)
    };
    let one = frame(1, Skip::Misses);
    for (spus, skip) in [(6, Skip::Misses), (3, Skip::Nothing)] {
        let other = frame(spus, skip);
        assert!(other.picture == one.picture, "{spus} SPUs");
        assert_eq!(other.rays().samples, one.rays().samples);
    }
}

#[test]
fn empty_picture_has_no_edges() {
    let empty = nff_scene("empty.nff");
    let picture = |samples| Frame::of(&empty, antialiased(samples, 1), SIZE, Settings::default());
    let smooth = picture(Samples::Four);
    assert_eq!(smooth.rays().samples, 0);
    assert!(smooth.picture == picture(Samples::One).picture);
}

#[test]
fn later_frame_equals_first_frame() {
    let scene = nff_scene("whitted16.nff");
    let program = Program::tracer();
    let (framebuffer, shown) = Recorder::pair(SIZE.0, SIZE.1);
    let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
    use Samples::{Four, One, Sixteen};
    for (samples, threshold) in [(One, 1), (Four, MIN_CONTRAST), (Sixteen, 64), (One, 0), (Four, 0)]
    {
        let prepared = Scene::new(&scene, antialiased(samples, threshold), &program).unwrap();
        engine.render(&prepared, &mut |_| ()).unwrap();
        let picture = shown.lock().unwrap().take().unwrap();
        let first = Frame::of(&scene, antialiased(samples, threshold), SIZE, Settings::default());
        assert!(picture == first.picture, "{samples:?} {threshold}");
    }
}
