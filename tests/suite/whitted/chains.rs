//! Rays that can't change their pixel are not sent. No pixel changes by more than one step because
//! of that.

use oracle::whitted::trace;

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED, options, picture};

const SIZE: (u32, u32) = (40, 40);

#[test]
fn nested_glass_sends_fewer_rays_for_the_same_picture() {
    let scene = scenes::load(Path::new("scenes/nested-glass.nff")).unwrap();
    let [fewest, all] =
        [false, true].map(|spd_rays| RenderOptions { ray_depth: 11, spd_rays, ..WHITTED });
    let [found, every] = [fewest, all]
        .map(|render_options| Frame::of(&scene, render_options, SIZE, Settings::default()));
    let (sent, sendable) = (found.rays(), every.rays());
    println!("{sent:?} of {sendable:?}");
    assert_eq!(sent.eye_hit, sendable.eye_hit);
    assert!(5 * (sent.reflected + sent.refracted) < 4 * (sendable.reflected + sendable.refracted));

    let pairs = found.picture.pixels().zip(every.picture.pixels());
    let mut darker = 0;
    for (found, every) in pairs.flat_map(|(a, b)| a.0.into_iter().zip(b.0)) {
        assert!(found <= every, "a ray that was left out made light");
        assert!(every - found <= 1, "{found} and {every}");
        darker += usize::from(found != every);
    }
    assert!(darker < 300, "{darker} channels");

    let (reference, counts) = trace(&scene, SIZE.0, SIZE.1, &options(fewest)).unwrap();
    let near = |found: u64, expected: u64| 100 * found.abs_diff(expected) <= expected;
    assert!(near(sent.reflected, counts.reflected), "{counts:?}");
    assert!(near(sent.refracted, counts.refracted), "{counts:?}");
    let compared = oracle::compare(&picture(&found.picture), &reference).unwrap();
    assert!(compared.max_error_off_silhouette <= 2, "{compared:?}");
}

#[test]
fn unreached_depth_changes_no_byte() {
    let mut scene = scenes::load(Path::new("scenes/whitted16.nff")).unwrap();
    for material in &mut scene.materials {
        (material.specular, material.transmittance) = (0.0, 0.0);
    }
    let frames = [1, 16].map(|ray_depth| {
        let render_options = RenderOptions { ray_depth, ..WHITTED };
        Frame::of(&scene, render_options, (160, 90), Settings::default())
    });
    assert!(frames[0].picture == frames[1].picture);
    assert_eq!(frames[0].rays(), frames[1].rays());
}
