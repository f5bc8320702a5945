//! Pictures of places in levels, compared with the reference.

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use cellray::framebuffer::{Geometry, Memory};
use cellray::game::{FixedSteps, NoInput, Recording};
use cellray::scene::{Colour, Model, RenderOptions};
use cellray::spe::Program;
use cellray::{Engine, Scene, Settings};
use games::station::Station;
use oracle::whitted::{Options, Rounding, trace};
use oracle::{Comparison, Picture, Pixels};
use scenes::Shader;

use crate::played::{kept, session};
use crate::station::freedoom;

const SIZE: (u32, u32) = (320, 180);
const DEPTH: u32 = 3;
/// The frames of a walk from one place to the next, and the places.
const APART: usize = 100;
const PLACES: usize = 5;

/// The picture of SPUs.
fn traced(scene: &scenes::Scene) -> Picture {
    let options = RenderOptions {
        model: Model::Whitted,
        ray_depth: DEPTH,
        colour: Colour::Linear,
        ..RenderOptions::default()
    };
    let framebuffer = Memory::new(Geometry::new(SIZE.0, SIZE.1).unwrap()).unwrap();
    let mut engine = Engine::start(Settings::default(), Box::new(framebuffer)).unwrap();
    let traced = Scene::new(scene, options, &Program::tracer()).unwrap();
    engine.render(&traced, &mut |_| ()).unwrap();
    let found = engine.picture().expect("a frame in memory");
    let mut picture = Picture::black(SIZE.0, SIZE.1).unwrap();
    for (to, from) in picture.pixels_mut().iter_mut().zip(found.pixels()) {
        *to = from.0;
    }
    picture
}

/// A picture of SPUs, and how it differs from the reference's.
fn compared(mut scene: scenes::Scene) -> Comparison {
    // The reference has no shaders of games, so the sky has one colour here.
    for material in &mut scene.materials {
        if matches!(material.shader, Shader::Own { .. }) {
            material.shader = Shader::Flat;
        }
    }
    let picture = traced(&scene);
    // What is known of the lamps' light changes nothing.
    let mut unknown = scene.clone();
    if let Some(mesh) = &mut unknown.mesh {
        let mesh = Arc::make_mut(mesh);
        assert!(mesh.visibility.iter().any(|known| known.lit != 0 && known.dark != 0));
        mesh.visibility.clear();
    }
    assert!(traced(&unknown) == picture);
    let options = Options {
        depth: DEPTH,
        fresnel: false,
        spd_rays: false,
        rounding: Rounding::Double,
        shadows: true,
        pixels: Pixels { colour: oracle::Colour::Linear, ..Pixels::PLAIN },
    };
    let (reference, _) = trace(&scene, SIZE.0, SIZE.1, &options).unwrap();
    oracle::compare(&picture, &reference).unwrap()
}

#[test]
fn places_of_walks_equal_reference() {
    let e1m1 = || Station::open(&freedoom("freedoom1.wad"), Some("E1M1")).unwrap();
    let own: (&str, fn() -> Station) = ("station.jsonl", Station::default);
    for (walk, game) in [own, ("e1m1.jsonl", e1m1)] {
        let recording = Recording::open(Path::new(&kept(walk))).unwrap();
        let mut session = session(game()).replaying(recording).unwrap();
        let mut clock = FixedSteps(Duration::ZERO);
        for frame in 0..APART * PLACES {
            assert!(session.frame(&mut clock, &mut NoInput).unwrap().is_continue(), "{walk}");
            if frame % APART == 0 {
                let result = compared(session.world().to_nff());
                println!("{walk}, frame {frame}: {result:?}");
                assert!(result.wrong_fraction <= 0.001, "{walk}, frame {frame}: {result:?}");
            }
        }
    }
}
