//! How long the PPU takes to prepare a scene: its trees, or its blocks if it does not fit the local
//! store. Prints the shortest of several times in milliseconds. For a file it prints the shortest
//! times of loading and of preparing it, and then the most memory that the program had, in MB.
//! `ci/ppe` also counts the instructions.
//!
//!     cargo run --release --example builds -- spheres|triangles COUNT TIMES
//!     cargo run --release --example builds -- file FILE TIMES

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use cellray::Scene;
use cellray::scene::RenderOptions;
use cellray::spe::Program;
use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;

const VIEW: &str = "v\nfrom 0 -30 0\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 512 512\n\
                    l 50 -50 50\nf 1 1 1 1 0 0 0 0\n";

fn main() -> Result<(), Box<dyn Error>> {
    let usage = "usage: builds spheres|triangles COUNT TIMES, or builds file FILE TIMES";
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [shape, count, times] = &arguments[..] else {
        return Err(usage.into());
    };
    let times: u32 = times.parse()?;
    let program = Program::tracer();
    let prepare = |scene: &scenes::Scene| Scene::new(scene, RenderOptions::default(), &program);
    if shape == "file" {
        let mut loaded = None;
        let load = || meshes::load(Path::new(count)).map(|it| loaded = Some(it.scene));
        let loading = shortest(times, load)?;
        let scene = loaded.ok_or(usage)?;
        let preparing = shortest(times, || prepare(&scene))?;
        let memory = most_memory()?;
        messages::write_data(format!("{loading:.2} {preparing:.2} {memory:.1}\n"))?;
    } else {
        let scene = objects(shape, count.parse()?).ok_or(usage)?;
        messages::write_data(format!("{:.2}\n", shortest(times, || prepare(&scene))?))?;
    }
    Ok(())
}

/// The most memory that this program had, in MB.
fn most_memory() -> Result<f64, Box<dyn Error>> {
    let status = std::fs::read_to_string("/proc/self/status")?;
    let line = status.lines().find_map(|it| it.strip_prefix("VmHWM:"));
    let words = line.ok_or("/proc/self/status has no VmHWM")?;
    let kilobytes: f64 = words.trim().trim_end_matches(" kB").parse()?;
    Ok(kilobytes / 1024.0)
}

/// The shortest time that something takes, in milliseconds.
fn shortest<T, E>(times: u32, mut done: impl FnMut() -> Result<T, E>) -> Result<f64, E> {
    let mut shortest = f64::INFINITY;
    for _ in 0..times {
        let began = Instant::now();
        let made = done()?;
        shortest = shortest.min(began.elapsed().as_secs_f64());
        drop(made);
    }
    Ok(1e3 * shortest)
}

/// A scene of small objects that are spread evenly in a cube.
fn objects(shape: &str, count: usize) -> Option<scenes::Scene> {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let size = 4.0 / libm::cbrt(count as f64);
    let mut text = VIEW.to_owned();
    for _ in 0..count {
        let mut point = |around: f64| [0; 3].map(|_| random.random_range(-around..around));
        let [x, y, z] = point(10.0);
        match shape {
            "spheres" => text += &format!("s {x} {y} {z} {}\n", size / 2.0),
            "triangles" => {
                text += "p 3\n";
                for _ in 0..3 {
                    let [dx, dy, dz] = point(size);
                    text += &format!("{} {} {}\n", x + dx, y + dy, z + dz);
                }
            }
            _ => return None,
        }
    }
    scenes::parse(text.as_bytes(), "spread", &scenes::Limits::default()).ok()
}
