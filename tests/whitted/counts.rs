//! The conditions of the Standard Procedural Databases: rays through the corners of 512x512 pixels, and
//! how many there are of each kind.

use std::path::Path;

use cellray::Settings;
use cellray::scene::Look;
use image::{Rgb, RgbImage};
use oracle::whitted::{Counts, trace};

use crate::frame::{Frame, WHITTED, options, picture};

/// Pixels of a side.
const SIDE: u32 = 512;

/// How far a count may be off, in parts of it.
const OFF: f64 = 0.001;

/// Greatest share of pixels that are off, those on silhouettes among them.
const WRONG: f64 = 0.0015;

/// Each pixel the mean of its four corners.
fn averaged(corners: &RgbImage) -> RgbImage {
    RgbImage::from_fn(corners.width() - 1, corners.height() - 1, |x, y| {
        let around = [(0, 0), (1, 0), (0, 1), (1, 1)]
            .map(|(right, down)| corners.get_pixel(x + right, y + down));
        Rgb(std::array::from_fn(|at| {
            let sum: u32 = around.iter().map(|pixel| u32::from(pixel[at])).sum();
            ((sum + 2) / 4) as u8
        }))
    })
}

fn corner_rays_are_counted_as_by_the_reference(name: &str) {
    let scene = nff::load(Path::new(name)).unwrap();
    let look = Look {
        corners: true,
        ..WHITTED
    };
    let frame = Frame::of(&scene, look, (SIDE + 1, SIDE + 1), Settings::default());
    let (reference, counts) = trace(&scene, SIDE, SIDE, &options(look)).unwrap();

    let found = frame.rays();
    println!("{name}: {found:?}, {counts:?}");
    assert_eq!(found.eye, counts.eye);
    let Counts {
        eye_hit,
        reflected,
        refracted,
        shadow,
        hit,
        ..
    } = counts;
    for (what, found, expected) in [
        ("eye_hit", found.eye_hit, eye_hit),
        ("reflected", found.reflected, reflected),
        ("refracted", found.refracted, refracted),
        ("shadow", found.shadow, shadow),
        ("hit", found.hit, hit),
    ] {
        let off = found.abs_diff(expected) as f64;
        assert!(
            off <= OFF * expected as f64,
            "{name}: {what} {found}, the reference has {expected}"
        );
    }

    let result = oracle::compare(&picture(&averaged(&frame.picture)), &reference).unwrap();
    println!("{name}: {result:?}");
    assert!(result.max_error_off_silhouette <= 2, "{result:?}");
    assert!(result.wrong_fraction <= WRONG, "{result:?}");
}

#[test]
fn balls() {
    corner_rays_are_counted_as_by_the_reference("sphereflake:2");
}

#[test]
fn tetra() {
    corner_rays_are_counted_as_by_the_reference("tetra:3");
}
