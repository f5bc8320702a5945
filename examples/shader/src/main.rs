//! Renders a still life with an SPU program that has a shader of this crate's own in it.
//!
//!     cargo run --release -p shader-example -- PICTURE.png

use std::error::Error;
use std::path::PathBuf;

use cellray::framebuffer::{Geometry, Png};
use cellray::scene::Look;
use cellray::spe::Program;
use cellray::{Engine, Scene, Settings};

/// The tracer's program with `shaders/rings.s`, as `build.rs` has made it.
const IMAGE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/tracer.elf"));

const SCENE: &[u8] = include_bytes!("../still_life.nff");

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os().nth(1).map(PathBuf::from);
    let path = path.ok_or("usage: shader-example PICTURE.png")?;
    let program = Program::from_image(IMAGE)?;
    let scene = nff::parse(SCENE, "still_life.nff", &nff::Limits::default())?;
    let scene = Scene::new(&scene, Look::default(), &program)?;
    let settings = Settings {
        program,
        ..Settings::default()
    };
    let (width, height) = scene.view().resolution;
    let picture = Png::new(&path, Geometry::new(width, height)?)?;
    let mut engine = Engine::start(settings, Box::new(picture))?;
    engine.render(&scene, &mut |_| ())?;
    Ok(())
}
