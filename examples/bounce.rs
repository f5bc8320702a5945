//! A ball that bounces over a row of others, as numbered pictures.
//!
//!     cargo run --release --example bounce -- FOLDER [FRAMES]
//!
//! A game will do what this does: change the scene, have a frame traced, again.

use std::error::Error;
use std::path::PathBuf;

use cellray::framebuffer::{Geometry, Png};
use cellray::{Engine, Scene, Settings};
use glam::DVec3;
use nff::{Material, Object, Shader, Shape, View};

const RADIUS: f64 = 0.6;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1);
    let folder = PathBuf::from(arguments.next().ok_or("usage: bounce FOLDER [FRAMES]")?);
    let frames: u32 = match arguments.next() {
        Some(text) => text
            .to_string_lossy()
            .parse()
            .map_err(|error| format!("FRAMES: {error}"))?,
        None => 24,
    };
    std::fs::create_dir_all(&folder)?;
    for frame in 0..frames {
        let path = folder.join(format!("bounce-{frame:03}.png"));
        let picture = Png::new(&path, Geometry::new(640, 360)?)?;
        let mut engine = Engine::start(Settings::default(), Box::new(picture))?;
        let scene = Scene::from_nff(&scene(f64::from(frame) / f64::from(frames)))?;
        engine.render(&scene, &mut |_| ())?;
    }
    Ok(())
}

/// The scene at a moment of the bounce, 0 to 1.
fn scene(moment: f64) -> nff::Scene {
    // Four jumps from left to right, each a parabola.
    let jump = moment * 4.0 % 1.0;
    let ball = DVec3::new(moment * 8.0 - 4.0, RADIUS + 6.0 * jump * (1.0 - jump), 0.0);
    let row = (-4..=4).map(|place| DVec3::new(f64::from(place), -RADIUS, -1.5));
    let material = |red, green, blue| Material {
        line: 0,
        colour: DVec3::new(red, green, blue),
        diffuse: 1.0,
        specular: 0.0,
        shine: 0.0,
        transmittance: 0.0,
        refraction_index: 1.0,
        shader: Shader::Phong,
    };
    let sphere = |centre, material| Object {
        line: 0,
        material,
        shape: Shape::Sphere {
            centre,
            radius: RADIUS,
        },
    };
    nff::Scene {
        name: "bounce".into(),
        view: View {
            from: DVec3::new(0.0, 2.0, 12.0),
            at: DVec3::new(0.0, 0.8, 0.0),
            up: DVec3::Y,
            angle: 30.0,
            hither: 0.01,
            resolution: (640, 360),
        },
        background: DVec3::new(0.05, 0.07, 0.14),
        ambient: DVec3::ZERO,
        lights: Vec::new(),
        materials: vec![material(0.96, 0.4, 0.25), material(0.4, 0.6, 0.9)],
        objects: std::iter::once(sphere(ball, 0))
            .chain(row.map(|place| sphere(place, 1)))
            .collect(),
    }
}
