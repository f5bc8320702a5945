//! Renders a picture with an SPU program that has a shader of this crate's own in it.
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

const SCENE: &str = "\
v
from 2 3 5
at 0 0 0
up 0 1 0
angle 40
hither 1
resolution 512 512
l 4 6 5
b 0.1 0.1 0.2
f 0.8 0.5 0.2 1 0 0 0 0
s 0 0 0 1.2
f 0.4 0.2 0.1 1 0 0 0 0
s 1.6 -0.6 0.5 0.5
";

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os().nth(1).map(PathBuf::from);
    let path = path.ok_or("usage: shader-example PICTURE.png")?;
    let program = Program::from_image(IMAGE)?;
    let settings = Settings {
        program,
        ..Settings::default()
    };
    let picture = Png::new(&path, Geometry::new(512, 512)?)?;
    let mut engine = Engine::start(settings, Box::new(picture))?;
    let scene = nff::parse(SCENE.as_bytes(), "rings", &nff::Limits::default())?;
    let scene = Scene::new(&scene, Look::default(), &program)?;
    engine.render(&scene, &mut |_| ())?;
    Ok(())
}
