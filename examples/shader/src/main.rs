//! Renders a still life with an SPU program that contains this crate's own shader.
//!
//!     cargo run --release -p shader-example -- PICTURE.png [WIDTHxHEIGHT]

use std::error::Error;
use std::path::PathBuf;

use cellray::framebuffer::{Geometry, PictureFile};
use cellray::scene::RenderOptions;
use cellray::spe::Program;
use cellray::{Engine, Scene, Settings};

/// The tracer's program with `shaders/rings.s`, built by `build.rs`.
const IMAGE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/tracer.elf"));

const SCENE: &[u8] = include_bytes!("../still_life.nff");

const USAGE: &str = "usage: shader-example PICTURE.png [WIDTHxHEIGHT]";

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1);
    let path = arguments.next().map(PathBuf::from).ok_or(USAGE)?;
    let size = arguments.next();
    let program = Program::from_image(IMAGE)?;
    let scene = scenes::parse(SCENE, "still_life.nff", &scenes::Limits::default())?;
    let scene = Scene::new(&scene, RenderOptions::default(), &program)?;
    let settings = Settings { program, ..Settings::default() };
    let geometry = match size {
        Some(text) => text.to_string_lossy().parse()?,
        None => {
            let (width, height) = scene.view().resolution;
            Geometry::new(width, height)?
        }
    };
    let picture = PictureFile::new(&path, geometry)?;
    let mut engine = Engine::start(settings, Box::new(picture))?;
    engine.render(&scene, &mut |_| ())?;
    Ok(())
}
