//! Traces a frame into memory, as `cellray` would trace it to a screen.

use cellray::framebuffer::{Geometry, Memory};
use cellray::scene::RenderOptions;
use cellray::spe::Program;
use cellray::{Engine, Report, Scene, Settings};
use oracle::Picture;

use crate::pictures::PictureError;

/// What the SPUs made of a scene.
pub(crate) struct Traced {
    /// The picture.
    pub picture: Picture,
    /// Frames a second in simulated time.
    pub frames_per_second: f64,
    /// The number of primary rays.
    pub primary_rays: u64,
}

/// Traces a scene twice. The first frame determines the costs of its parts, and only the second
/// one counts.
pub(crate) fn trace(
    name: &str,
    scene: &scenes::Scene,
    options: RenderOptions,
    (width, height): (u32, u32),
    program: Program,
) -> Result<Traced, PictureError> {
    let settings = Settings { retain: false, program, ..Settings::default() };
    let scene = Scene::new(scene, options, &program)?;
    let framebuffer = Memory::new(Geometry::new(width, height)?)?;
    let mut report = Report::new(name, (width, height), settings.spus);
    let mut engine = Engine::start(settings, Box::new(framebuffer))?;
    engine.render(&scene, &mut |_| ())?;
    let statistics = engine.render(&scene, &mut |_| ())?;
    let primary_rays = statistics.spus.iter().map(|spu| spu.rays.eye).sum();
    report.add(statistics);
    let mut picture = Picture::black(width, height)?;
    let shown = engine.picture().ok_or("the frame can't be read back")?;
    for (to, from) in picture.pixels_mut().iter_mut().zip(shown.pixels()) {
        *to = from.0;
    }
    Ok(Traced { picture, frames_per_second: report.frames_per_second, primary_rays })
}
