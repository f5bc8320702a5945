//! The speed of each game in simulated time, in frames a second: six SPUs at 1280x720, at the
//! moments that the demonstrations show.
//!
//!     cargo bench -p games --bench frames [-- NAME ...]

#![expect(clippy::print_stdout, reason = "a benchmark has nothing to lose but its output")]

mod simulated;

use std::error::Error;

use cellray::framebuffer::{Geometry, Memory};
use cellray::{Engine, Report, Settings};
use games::demo::DEMOS;

const SIZE: (u32, u32) = (1280, 720);

fn main() -> Result<(), Box<dyn Error>> {
    simulated::restart()?;
    println!("| game | frames/s | million rays: eye, reflected, refracted, shadow | objects |");
    println!("|---|---|---|---|");
    let settings = Settings { retain: false, ..Settings::default() };
    let names: Vec<String> = std::env::args().skip(1).filter(|it| !it.starts_with('-')).collect();
    for demo in
        DEMOS.iter().filter(|demo| names.is_empty() || names.iter().any(|it| it == demo.name))
    {
        let mut report = Report::new(demo.name, SIZE, settings.spus);
        let picture = Memory::new(Geometry::new(SIZE.0, SIZE.1)?)?;
        let mut engine = Engine::start(settings, Box::new(picture))?;
        let mut objects = 0;
        demo.play(SIZE, 1, |world| -> Result<(), Box<dyn Error>> {
            objects = world.object_count();
            let scene = world.scene(&settings.program)?;
            report.add(engine.render(scene, &mut |_| {})?);
            Ok(())
        })?;
        let million = |rays: u64| rays as f64 / 1e6;
        println!(
            "| {} | {:.1} | {:.2}, {:.2}, {:.2}, {:.2} | {objects} |",
            demo.name,
            report.frames_per_second,
            million(report.rays.eye),
            million(report.rays.reflected),
            million(report.rays.refracted),
            million(report.rays.shadow),
        );
    }
    Ok(())
}
