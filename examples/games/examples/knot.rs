//! Three places of one mesh, a torus knot of 23,040 triangles, that turn on a mirror: numbered
//! pictures, and how long the PPU takes for the new places.
//!
//!     cargo run --release --example knot -- FOLDER WIDTHxHEIGHT FRAMES

use std::error::Error;
use std::f64::consts::TAU;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use cellray::framebuffer::{Geometry, PictureFile};
use cellray::game::{
    DAffine3, DVec3, Light, Material, Mesh, MeshId, RenderOptions, Shader, World, WorldError,
};
use cellray::{Engine, Settings};

/// Points along the knot, and around it.
const ALONG: u32 = 480;
const AROUND: u32 = 24;
/// The radius of the knot's rope.
const ROPE: f64 = 0.3;
/// Turns of a knot in a picture.
const SPEED: f64 = 1.0 / 120.0;

fn main() -> Result<(), Box<dyn Error>> {
    let usage = "usage: knot FOLDER WIDTHxHEIGHT FRAMES";
    let mut arguments = std::env::args().skip(1);
    let mut next = || arguments.next().ok_or(usage);
    let (folder, size, frames) = (PathBuf::from(next()?), next()?, next()?);
    let (width, height) = size.split_once('x').ok_or(usage)?;
    let geometry = Geometry::new(width.parse()?, height.parse()?)?;
    let frames: u32 = frames.parse()?;
    std::fs::create_dir_all(&folder)?;

    let (mut world, knots) = world()?;
    let settings = Settings::default();
    for frame in 0..frames {
        for (number, &knot) in (0..).zip(&knots) {
            world.place_mesh(knot, place(number, f64::from(frame) * SPEED))?;
        }
        let began = Instant::now();
        let scene = world.scene(&settings.program)?;
        let took = began.elapsed().as_secs_f64() * 1e3;
        let path = folder.join(format!("knot-{frame:03}.png"));
        let mut engine = Engine::start(settings, Box::new(PictureFile::new(&path, geometry)?))?;
        engine.render(scene, &mut |_| {})?;
        messages::print!("{}: {took:.1} ms for the scene", path.display());
    }
    Ok(())
}

fn world() -> Result<(World, Vec<MeshId>), WorldError> {
    let mut world = World::new();
    world.set_render_options(RenderOptions { ray_depth: 4, ..RenderOptions::default() });
    world.look_from([0.0, 3.4, 9.6], [0.0, 0.1, 0.0])?;
    world.set_background([0.24, 0.36, 0.55])?;
    world.set_ambient(DVec3::splat(0.12))?;
    world.add_light(Light::at(DVec3::new(6.0, 9.0, 7.0)))?;
    world.add_light(Light::at(DVec3::new(-8.0, 6.0, 2.0)))?;
    let mirror = world.add_material(Material {
        colour: DVec3::new(0.62, 0.58, 0.52),
        specular: 0.3,
        shader: Shader::Checker { other: DVec3::new(0.25, 0.22, 0.2), size: 1.0 },
        ..Material::matte(0.5, 0.5, 0.5)
    })?;
    let floor = [[-12, 9], [12, 9], [12, -12], [-12, -12]];
    let floor = floor.map(|[x, z]| DVec3::new(f64::from(x), -1.601, f64::from(z)));
    world.add_polygon(&floor, mirror)?;

    let knot = Arc::new(knot());
    let colours = [[0.95, 0.62, 0.18], [0.16, 0.5, 0.85], [0.85, 0.2, 0.25]];
    let mut knots = Vec::new();
    for (number, colour) in (0..).zip(colours) {
        let lacquer = world.add_material(Material {
            colour: DVec3::from_array(colour),
            specular: 0.22,
            shine: 60.0,
            ..Material::matte(0.5, 0.5, 0.5)
        })?;
        knots.push(world.add_mesh(knot.clone(), &[lacquer], place(number, 0.0))?);
    }
    Ok((world, knots))
}

/// The place of a knot after this number of turns. `libm`'s sines are the same on every machine.
fn place(number: u32, turns: f64) -> DAffine3 {
    let (middle, size, lean) = match number {
        0 => (DVec3::ZERO, 1.0, 0.35),
        1 => (DVec3::new(-3.3, -0.5, -0.8), 0.65, -0.5),
        _ => (DVec3::new(3.2, -0.6, -0.3), 0.6, 1.2),
    };
    let (sine, cosine) = libm::sincos(TAU * turns * (1.0 + f64::from(number)));
    let turned = DAffine3::from_cols(
        DVec3::new(cosine, 0.0, -sine),
        DVec3::Y,
        DVec3::new(sine, 0.0, cosine),
        DVec3::ZERO,
    );
    let (sine, cosine) = libm::sincos(lean);
    let leaning = DAffine3::from_cols(
        size * DVec3::X,
        size * DVec3::new(0.0, cosine, sine),
        size * DVec3::new(0.0, -sine, cosine),
        middle,
    );
    leaning * turned
}

/// A trefoil around the y axis, with smooth normals.
fn knot() -> Mesh {
    let middle = |along: u32| {
        let (sine, cosine) = libm::sincos(TAU * f64::from(along) / f64::from(ALONG));
        let (two, three) = (2.0 * cosine * cosine - 1.0, 3.0 - 4.0 * sine * sine);
        DVec3::new(sine + 4.0 * sine * cosine, -0.9 * sine * three, cosine - 2.0 * two) * 0.5
    };
    let mut mesh = Mesh::default();
    for along in 0..ALONG {
        let ahead = (middle(along + 1) - middle(along + ALONG - 1)).normalize();
        let side = ahead.cross(DVec3::Y).normalize();
        let up = side.cross(ahead);
        for around in 0..AROUND {
            let (sine, cosine) = libm::sincos(TAU * f64::from(around) / f64::from(AROUND));
            let normal = cosine * side + sine * up;
            let position = middle(along) + ROPE * normal;
            mesh.positions.push(position.as_vec3().to_array());
            mesh.normals.push(normal.as_vec3().to_array());
        }
    }
    for along in 0..ALONG {
        for around in 0..AROUND {
            let at = |along: u32, around: u32| along % ALONG * AROUND + around % AROUND;
            let (a, b) = (at(along, around), at(along, around + 1));
            let (c, d) = (at(along + 1, around), at(along + 1, around + 1));
            mesh.triangles.extend([[a, d, b], [a, c, d]]);
            mesh.materials.extend([0, 0]);
        }
    }
    mesh
}
