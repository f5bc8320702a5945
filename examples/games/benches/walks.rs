//! Recorded walks in levels: frames a second in simulated time, of six SPUs at 1280x720, and their
//! rays. A frame is measured every three seconds of the walk.
//!
//!     cargo bench -p games --bench walks -- [WALK...]

#![expect(clippy::print_stdout, reason = "a benchmark has nothing to lose but its output")]

mod simulated;

use std::error::Error;
use std::path::Path;
use std::time::Duration;

use cellray::framebuffer::{Geometry, Memory};
use cellray::game::{FixedSteps, NoInput, Recording, Session};
use cellray::statistics::Rays;
use cellray::{Engine, Settings};
use games::station::Station;

const SIZE: (u32, u32) = (1280, 720);
const FREEDOOM: &str = "/usr/share/games/doom/freedoom1.wad";
/// Frames from one that is measured to the next.
const EVERY: usize = 60;
/// Ticks a second of the decrementer, and an SPU's cycles in one.
const TIMEBASE: f64 = 79_800_000.0;
const CYCLES: f64 = 40.0;

type Outcome<T> = Result<T, Box<dyn Error>>;

/// Measures a walk. Returns its row of the table.
fn row(name: &str, file: &str, game: Station) -> Outcome<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/played").join(file);
    let small = Memory::new(Geometry::new(16, 8)?)?;
    let settings = Settings { spus: 1, ..Settings::default() };
    let session = Session::start(game, settings, Box::new(small))?;
    let mut session = session.replaying(Recording::open(&path)?)?;
    let mut clock = FixedSteps(Duration::ZERO);
    let picture = Memory::new(Geometry::new(SIZE.0, SIZE.1)?)?;
    let settings = Settings { retain: false, ..Settings::default() };
    let mut engine = Engine::start(settings, Box::new(picture))?;
    let (mut ticks, mut triangles, mut rays, mut shadow) = (Vec::new(), 0, 0, 0);
    for number in 0.. {
        if session.frame(&mut clock, &mut NoInput)?.is_break() {
            break;
        }
        if number % EVERY == 0 {
            let scene = session.world().scene(&settings.program)?;
            let statistics = engine.render(scene, &mut |_| {})?;
            ticks.push(statistics.ticks());
            for Rays { eye, reflected, refracted, shadow: more, .. } in
                statistics.spus.iter().map(|spu| spu.rays)
            {
                rays += eye + reflected + refracted + more;
                shadow += more;
            }
            let mesh = session.world().to_nff().mesh;
            triangles = mesh.map_or(0, |mesh| mesh.triangles.len());
        }
    }
    let sum: u64 = ticks.iter().sum();
    let slowest = ticks.iter().max().copied().unwrap_or(1);
    let pixels = (ticks.len() as u32 * SIZE.0 * SIZE.1) as f64;
    let spus = f64::from(Settings::default().spus);
    Ok(format!(
        "| {name} | {triangles} | {} | {:.1} | {:.1} | {:.2} | {:.2} | {:.0} |",
        ticks.len(),
        ticks.len() as f64 * TIMEBASE / sum as f64,
        TIMEBASE / slowest as f64,
        rays as f64 / pixels,
        shadow as f64 / pixels,
        spus * CYCLES * sum as f64 / rays as f64,
    ))
}

fn main() -> Outcome<()> {
    simulated::restart()?;
    println!(
        "| walk | triangles | frames measured | mean, frames/s | slowest frame, frames/s | rays a \
         pixel | of these to lamps | cycles a ray |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let named: Vec<String> = std::env::args().skip(1).filter(|name| name != "--bench").collect();
    let wanted = |name: &str| named.is_empty() || named.iter().any(|other| other == name);
    if wanted("station") {
        println!("{}", row("the game's own level", "station.jsonl", Station::default())?);
    }
    if wanted("e1m1") {
        let e1m1 = Station::open(Path::new(FREEDOOM), Some("E1M1"));
        let e1m1 = e1m1.map_err(|error| format!("{error}; ci/setup installs Freedoom"))?;
        println!("{}", row("Freedoom's E1M1", "e1m1.jsonl", e1m1)?);
    }
    Ok(())
}
