//! The frame loop alone, without a display: it plays on from a demonstration's moment, or plays a
//! scene's animation, or traces a scene's frame anew again and again, or moves 10,000 spheres.
//! `ci/ppe` counts the instructions that the PPE executes, with an SPU program that only replies.
//! With `LIBSPE2_TIMING=1` it prints the SPUs' frames a second.
//!
//!     cargo run --release -p games --example frame_loop -- NAME|SCENE|spheres FRAMES [PROGRAM.elf]

use std::error::Error;
use std::path::Path;

use cellray::framebuffer::{Geometry, Memory};
use cellray::game::{DVec3, Light, Material, World};
use cellray::scene::RenderOptions;
use cellray::spe::Program;
use cellray::{Engine, Report, Settings};
use games::demo::demo;

const SIZE: (u32, u32) = (1280, 720);
/// Spheres of a side of the cube that they fill at first: 10,000 in all.
const SPHERES: [u32; 3] = [25, 20, 20];

fn main() -> Result<(), Box<dyn Error>> {
    let usage = "usage: frame_loop NAME|SCENE|spheres FRAMES [PROGRAM.elf]";
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().ok_or(usage)?;
    let frames: u64 = arguments.next().ok_or(usage)?.parse()?;
    let file = Path::new(&name);
    let is_file = file.extension().is_some();
    let settings = Settings { retain: !is_file, ..Settings::default() };
    let picture = Memory::new(Geometry::new(SIZE.0, SIZE.1)?)?;
    let started = match arguments.next() {
        Some(file) => Settings { program: Program::from_file(Path::new(&file))?, ..settings },
        None => settings,
    };
    let mut engine = Engine::start(started, Box::new(picture))?;
    let mut report = Report::new(&name, SIZE, started.spus);
    let mut show = |world: &mut World| -> Result<(), Box<dyn Error>> {
        report.add(engine.render(world.scene(&settings.program)?, &mut |_| {})?);
        Ok(())
    };
    if is_file {
        let mut loaded = meshes::load(file)?;
        let mut world = World::from_nff(&loaded.scene, RenderOptions::default())?;
        for frame in 0..frames {
            let mesh = world.meshes().next();
            if let (Some(animation), Some(mesh)) = (&mut loaded.animation, mesh) {
                let (positions, normals) = animation.at(frame as f64 / 60.0);
                world.shape_mesh(mesh, positions, normals)?;
            }
            show(&mut world)?;
        }
    } else if name == "spheres" {
        move_spheres(frames, show)?;
    } else {
        let demo = demo(&name).ok_or_else(|| format!("no demonstration is called {name}"))?;
        demo.play(SIZE, frames, show)?;
    }
    messages::write_data(format!("{:.2}\n", report.frames_per_second))?;
    Ok(())
}

/// Spheres that move straight on, each in a direction of its own.
fn move_spheres(
    frames: u64,
    mut show: impl FnMut(&mut World) -> Result<(), Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    let mut world = World::new();
    world.look_from([0.0, 5.0, 11.0], DVec3::ZERO)?;
    world.add_light(Light::at(DVec3::new(6.0, 9.0, 7.0)))?;
    let red = world.add_material(Material::matte(0.9, 0.3, 0.2))?;
    let mut spheres = Vec::new();
    for number in 0..SPHERES.iter().product() {
        let [across, down, _] = SPHERES;
        let cell = [number % across, number / across % down, number / across / down];
        let place = 0.24 * DVec3::from_array(cell.map(f64::from)) - DVec3::splat(2.8);
        let (sine, cosine) = libm::sincos(f64::from(number));
        let step = 0.01 * DVec3::new(sine, cosine, -sine);
        spheres.push((world.add_sphere(place, 0.1, red)?, place, step));
    }
    for _ in 0..frames {
        for (sphere, place, step) in &mut spheres {
            *place += *step;
            world.move_to(*sphere, *place)?;
        }
        show(&mut world)?;
    }
    Ok(())
}
