//! Scenes of any size, including scenes far from the origin, have no acne on surfaces and no leaks
//! between them.

use crate::prelude::*;
use crate::whitted::frame::{WHITTED, compared};
use crate::whitted::placed::place;

/// How far a scene is moved, in multiples of its own size.
const FAR: f64 = 1e4;

/// The maximum share of wrong pixels, including those on silhouettes.
const WRONG: f64 = 0.001;

/// The size of a scene: twice the distance from the eye to the middle of the picture.
fn size(scene: &scenes::Scene) -> f64 {
    2.0 * scene.view.from.distance(scene.view.at)
}

#[test]
fn picture_is_independent_of_scene_scale_and_position() {
    let mut failures = Vec::new();
    for name in ["shapes.nff", "glass.nff"] {
        let original = nff_scene(name);
        let away = FAR * size(&original) * DVec3::new(0.6, -0.64, 0.48);
        for scale in [1e-4, 1.0, 1e6] {
            for shift in [DVec3::ZERO, away] {
                let mut scene = original.clone();
                place(&mut scene, shift, scale);
                let result = compared(&scene, WHITTED, (160, 90));
                println!("{name}, {scale:e} times, moved by {shift}: {result:?}");
                if result.max_error_off_silhouette > 2 || result.wrong_fraction > WRONG {
                    failures.push((name, scale, shift, result));
                }
            }
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}
