//! Golden pictures: scenes traced by each image of the SPU program, and the hashes of the pixels.

use std::fmt::Write as _;
use std::path::Path;
use std::time::Duration;

use cellray::framebuffer::{Framebuffer, Geometry, Memory};
use cellray::scene::RenderOptions;
use cellray::spe::Program;
use cellray::{Engine, Scene, Settings};
use protocol::formulation::Formulations;

use crate::Failure;

/// The scenes whose pictures are compared, with depth shading and with Whitted's model.
pub const SCENES: [&str; 2] = ["paper16", "whitted16"];
const SIZE: Geometry = Geometry { width: 160, height: 90 };

/// A scene file of the bundle.
///
/// # Errors
/// It can't be read.
pub fn load(folder: &Path, scene: &str) -> Result<scenes::Scene, Failure> {
    Ok(meshes::load(&folder.join("scenes").join(scene))?.scene)
}

/// An engine that waits at most `timeout` for an SPU.
///
/// # Errors
/// The engine does not start.
pub fn engine(
    program: Program,
    timeout: Duration,
    framebuffer: Box<dyn Framebuffer>,
) -> Result<Engine, Failure> {
    let spus = cellray::spe::usable_spes()?.clamp(1, Settings::default().spus);
    let settings = Settings { spus, timeout, program, ..Settings::default() };
    Ok(Engine::start(settings, framebuffer)?)
}

/// The line of a golden picture: scene, image, hash.
///
/// # Errors
/// The scene can't be read or traced.
pub fn line(
    folder: &Path,
    scene: &str,
    of: &Formulations,
    timeout: Duration,
) -> Result<String, Failure> {
    let source = load(folder, &format!("{scene}.nff"))?;
    let program = Program::of(of)?;
    let mut engine = engine(program, timeout, Box::new(Memory::new(SIZE)?))?;
    engine.render(&Scene::new(&source, RenderOptions::default(), &program)?, &mut |_| ())?;
    let picture = engine.picture().ok_or("the picture can't be read back")?;
    let hash = crc32fast::hash(picture.as_raw());
    Ok(format!("picture {scene} by {}: {hash:08x}", of.names().join("+")))
}

/// All lines.
///
/// # Errors
/// A scene can't be read or traced.
pub fn golden(folder: &Path) -> Result<String, Failure> {
    let mut text = String::new();
    for scene in SCENES {
        for of in Formulations::shipped() {
            writeln!(text, "{}", line(folder, scene, &of, Settings::default().timeout)?)?;
        }
    }
    Ok(text)
}
