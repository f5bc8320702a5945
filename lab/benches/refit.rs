//! What it costs to refit the blocks of meshes that have moved instead of building new ones:
//! frames in simulated time, and the host's time for the scene. What SPUs take to refit them and
//! to build new ones. The host's time for scenes of objects that move, and frames of spheres.
//!
//!     cargo bench --bench refit [-- meshes|spus|limit|objects|spheres]

#![expect(clippy::print_stdout, reason = "a benchmark has nothing to lose but its output")]

use std::error::Error;
use std::f64::consts::TAU;
use std::process::Command;
use std::sync::Arc;
use std::time::Instant;

use cellray::framebuffer::{Geometry, Memory};
use cellray::game::{DAffine3, DVec3, Light, Material, Mesh, MeshId, ObjectId, World, WorldError};
use cellray::scene::{BuildBy, RefitBy, RenderOptions, SceneBlock};
use cellray::{Engine, Report, Settings};

const TIMING: &str = "LIBSPE2_TIMING";
const SIZE: (u32, u32) = (640, 360);
const LARGE: (u32, u32) = (1280, 720);
/// Ticks a second of the decrementer, and an SPU's cycles in one.
const TIMEBASE: f64 = 79_800_000.0;
const CYCLES_A_TICK: f64 = 40.0;
const SPUS: u32 = 6;

struct Motion {
    name: &'static str,
    count: u32,
    mesh: fn() -> Mesh,
    /// The place of a mesh in a picture.
    place: fn(number: u32, picture: u32) -> DAffine3,
    pictures: &'static [u32],
}

const MOTIONS: [Motion; 2] = [
    Motion {
        name: "8 rings on orbits through each other",
        count: 8,
        mesh: || ring(96, 32, 0.3),
        place: on_an_orbit,
        pictures: &[1, 2, 4, 6, 8, 12, 16, 24, 32, 48],
    },
    Motion {
        name: "125 small rings that scatter",
        count: 125,
        mesh: || ring(20, 10, 0.3),
        place: scattered,
        pictures: &[1, 2, 4, 8, 16, 32, 64],
    },
];

fn main() -> Result<(), Box<dyn Error>> {
    if std::env::var_os(TIMING).is_none() {
        // The library reads the variable when a program starts.
        let status = Command::new(std::env::current_exe()?)
            .args(std::env::args().skip(1))
            .env(TIMING, "1")
            .status()?;
        std::process::exit(status.code().unwrap_or(1));
    }
    let wanted = |name: &str| {
        let mut names = std::env::args()
            .filter(|it| ["meshes", "spus", "limit", "objects", "spheres"].contains(&it.as_str()));
        names.next().is_none_or(|first| first == name)
    };
    if wanted("meshes") {
        meshes()?;
    }
    if wanted("spus") {
        spus()?;
    }
    if wanted("limit") {
        limit()?;
    }
    if wanted("objects") {
        objects()?;
    }
    if wanted("spheres") {
        spheres()?;
    }
    Ok(())
}

fn meshes() -> Result<(), Box<dyn Error>> {
    println!(
        "| picture | tests of rays, times as many | refitted: ms a frame | ms of the host | \
         new tree: ms a frame | ms of the host |"
    );
    println!("|---|---|---|---|---|---|");
    for motion in MOTIONS {
        println!("| **{}** | | | | | |", motion.name);
        let mesh = Arc::new((motion.mesh)());
        let (mut world, meshes) = motion.world(&mesh, 0)?;
        let mut refits = Vec::new();
        for picture in 0..=*motion.pictures.last().unwrap_or(&0) {
            for (number, &id) in (0..).zip(&meshes) {
                world.place_mesh(id, (motion.place)(number, picture))?;
            }
            refits.push(host(&mut world)?);
            if motion.pictures.contains(&picture) {
                let [wear, refitted] = traced(&mut world, SIZE)?;
                let (mut built, _) = motion.world(&mesh, picture)?;
                let mut build = host(&mut built)?;
                for _ in 1..5 {
                    build = build.min(host(&mut motion.world(&mesh, picture)?.0)?);
                }
                let [_, new] = traced(&mut built, SIZE)?;
                let refit = refits.drain(..).fold(f64::INFINITY, f64::min);
                println!(
                    "| {picture} | {wear:.2} | {refitted:.2} | {refit:.1} | {new:.2} | {build:.0} |"
                );
            }
        }
    }
    Ok(())
}

impl Motion {
    fn world(&self, mesh: &Arc<Mesh>, picture: u32) -> Result<(World, Vec<MeshId>), WorldError> {
        let mut world = World::new();
        world.set_render_options(RenderOptions {
            refit_pictures: u32::MAX,
            refit_by: Some(RefitBy::Ppu),
            ..RenderOptions::default()
        });
        world.look_from([0.0, 5.0, 11.0], [0.0; 3])?;
        world.add_light(Light::at(DVec3::new(6.0, 9.0, 7.0)))?;
        let red = world.add_material(Material::matte(0.9, 0.3, 0.2))?;
        let add = |number| world.add_mesh(mesh.clone(), &[red], (self.place)(number, picture));
        let meshes = (0..self.count).map(add).collect::<Result<_, _>>()?;
        Ok((world, meshes))
    }
}

/// Rings and squares that turn: the time of six SPUs to refit them, and to build them anew; and
/// frames with that tree and with the PPU's.
fn spus() -> Result<(), Box<dyn Error>> {
    println!(
        "| mesh | triangles | leaf blocks | six SPUs refit them, ms | cycles of an SPU a triangle | \
         they build them, ms | cycles of an SPU a triangle | a frame with the PPU's tree, ms | \
         with the SPUs' tree, ms |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let rings = [(40, 25), (100, 50), (250, 200), (500, 400)];
    let rings = rings.map(|(along, around)| ("ring", ring(along, around, 0.3)));
    let squares = [64, 128, 256].map(|side| ("square", square(side)));
    for (name, mesh) in rings.into_iter().chain(squares) {
        let mesh = Arc::new(mesh);
        let world = |build_by| world_of(&mesh, RefitBy::Spus, build_by);
        let [mut refitted, mut built] = [world(BuildBy::PpuSurfaces)?, world(BuildBy::SpuCodes)?];
        let program = Settings::default().program;
        let leaves = refitted.scene(&program)?.block().and_then(SceneBlock::mesh);
        let leaves = leaves.ok_or("the scene has no mesh")?.blocks.statistics().leaves;
        let [_, frame] = traced(&mut refitted, SIZE)?;
        let id = refitted.meshes().next().ok_or("the world has no mesh")?;
        refitted.place_mesh(id, turned(0.01))?;
        let triangles = mesh.triangles.len();
        let cost = |world: &mut World| -> Result<String, Box<dyn Error>> {
            let ticks = made(world)? as f64;
            let cycles = ticks * CYCLES_A_TICK * f64::from(SPUS) / triangles as f64;
            Ok(format!("{:.3} | {cycles:.0}", 1e3 * ticks / TIMEBASE))
        };
        let (refit, build) = (cost(&mut refitted)?, cost(&mut built)?);
        let [_, frame_of_built] = traced(&mut built, SIZE)?;
        println!(
            "| {name} | {triangles} | {leaves} | {refit} | {build} | {frame:.2} | \
             {frame_of_built:.2} |"
        );
    }
    Ok(())
}

/// Frames of a ring that turns: after the PPU has refitted it, which finds the places that stay as
/// they are, and after SPUs have.
fn limit() -> Result<(), Box<dyn Error>> {
    println!(
        "| vertices | a frame after the PPU has refitted them, ms | six SPUs refit them, ms | \
         a frame with that, ms |"
    );
    println!("|---|---|---|---|");
    for (along, around) in [(20, 15), (30, 20), (40, 25), (60, 40), (100, 50), (250, 100)] {
        let mesh = Arc::new(ring(along, around, 0.3));
        print!("| {} |", mesh.positions.len());
        for by in [RefitBy::Ppu, RefitBy::Spus] {
            let mut world = world_of(&mesh, by, BuildBy::PpuSurfaces)?;
            let settings = Settings { spus: SPUS, ..Settings::default() };
            let picture = Memory::new(Geometry::new(SIZE.0, SIZE.1)?)?;
            let mut engine = Engine::start(settings, Box::new(picture))?;
            let id = world.meshes().next().ok_or("the world has no mesh")?;
            let mut report = Report::new("refit", SIZE, SPUS);
            let mut refit = 0;
            for number in 0..9 {
                world.place_mesh(id, turned(0.01 * f64::from(number)))?;
                let scene = world.scene(&Settings::default().program)?;
                let traced = engine.render(scene, &mut |_| {})?;
                // The tiles' costs are not measured yet in the first frames.
                if number >= 2 {
                    refit += traced.refit;
                    report.add(traced);
                }
            }
            if by == RefitBy::Spus {
                let ticks = refit as f64 / f64::from(report.frames);
                print!(" {:.3} |", 1e3 * ticks / TIMEBASE);
            }
            print!(" {:.2} |", 1e3 / report.frames_per_second);
        }
        println!();
    }
    Ok(())
}

/// A world with a mesh, refitted and built in these ways.
fn world_of(mesh: &Arc<Mesh>, refit_by: RefitBy, build_by: BuildBy) -> Result<World, WorldError> {
    let mut world = World::new();
    let (refit_by, build_by) = (Some(refit_by), Some(build_by));
    world.set_render_options(RenderOptions { refit_by, build_by, ..Default::default() });
    world.look_from([0.0, 5.0, 11.0], [0.0; 3])?;
    world.add_light(Light::at(DVec3::new(6.0, 9.0, 7.0)))?;
    let red = world.add_material(Material::matte(0.9, 0.3, 0.2))?;
    world.add_mesh(mesh.clone(), &[red], DAffine3::IDENTITY)?;
    Ok(world)
}

/// Ticks that six SPUs take to refit or build a world's mesh.
fn made(world: &mut World) -> Result<u64, Box<dyn Error>> {
    let settings = Settings { spus: SPUS, ..Settings::default() };
    let scene = world.scene(&settings.program)?;
    let mut engine = Engine::start(settings, Box::new(Memory::new(Geometry::new(16, 8)?)?))?;
    Ok(engine.render(scene, &mut |_| {})?.refit)
}

/// A flat square with smooth normals, of as many squares along each side.
fn square(side: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let along = |number: u32| 4.0 * (number as f32 / side as f32 - 0.5);
    for (row, column) in (0..=side).flat_map(|row| (0..=side).map(move |column| (row, column))) {
        mesh.positions.push([along(column), 0.0, along(row)]);
        mesh.normals.push([0.0, 1.0, 0.0]);
        if row < side && column < side {
            let at = row * (side + 1) + column;
            let below = at + side + 1;
            mesh.triangles.extend([[at, below, at + 1], [at + 1, below, below + 1]]);
            mesh.materials.extend([0, 0]);
        }
    }
    mesh
}

/// How many times the tests of rays the tree costs that it cost when it was built, and milliseconds
/// of a frame in simulated time.
fn traced(world: &mut World, size: (u32, u32)) -> Result<[f64; 2], Box<dyn Error>> {
    let settings = Settings { retain: false, ..Settings::default() };
    let scene = world.scene(&settings.program)?;
    let wear = scene.block().and_then(SceneBlock::wear).unwrap_or(1.0);
    let picture = Memory::new(Geometry::new(size.0, size.1)?)?;
    let mut engine = Engine::start(settings, Box::new(picture))?;
    // The tiles' costs are not measured yet in the first frame.
    engine.render(scene, &mut |_| {})?;
    let mut report = Report::new("refit", size, settings.spus);
    report.add(engine.render(scene, &mut |_| {})?);
    Ok([wear, 1e3 / report.frames_per_second])
}

/// Milliseconds of the host for a world's scene.
fn host(world: &mut World) -> Result<f64, WorldError> {
    let began = Instant::now();
    world.scene(&Settings::default().program)?;
    Ok(1e3 * began.elapsed().as_secs_f64())
}

/// The median time of the host for scenes of objects that all move a little for each picture.
fn objects() -> Result<(), Box<dyn Error>> {
    println!("| objects that move | ms of the host | with a new tree by the PPU |");
    println!("|---|---|---|");
    for (count, name) in [
        (500, "triangles"),
        (700, "triangles"),
        (2000, "triangles"),
        (800, "spheres"),
        (1200, "spheres"),
        (4000, "spheres"),
        (10_000, "spheres"),
    ] {
        print!("| {count} {name} |");
        for by in [None, Some(BuildBy::PpuSurfaces)] {
            let mut swarm = Swarm::new(count, name, by)?;
            let mut times = Vec::new();
            for _ in 0..33 {
                swarm.go_on()?;
                times.push(host(&mut swarm.world)?);
            }
            // The first scenes are not changes.
            let mut times = times.split_off(2);
            times.sort_by(f64::total_cmp);
            print!(" {:.2} |", times[times.len() / 2]);
        }
        println!();
    }
    Ok(())
}

/// Frames of spheres that all move, with shadows, and what the SPUs take of them to build the
/// spheres' blocks; and frames after the PPU has built a tree.
fn spheres() -> Result<(), Box<dyn Error>> {
    println!(
        "| spheres that move | six SPUs build their blocks, ms | cycles of an SPU a sphere | \
         a frame with that, ms | frames/s | a frame with the PPU's tree, ms |"
    );
    println!("|---|---|---|---|---|---|");
    for count in [1000, 10_000] {
        let mut by_spus = Swarm::new(count, "spheres", None)?;
        let settings = Settings { spus: SPUS, ..Settings::default() };
        let picture = Memory::new(Geometry::new(LARGE.0, LARGE.1)?)?;
        let mut engine = Engine::start(settings, Box::new(picture))?;
        let mut report = Report::new("refit", LARGE, SPUS);
        let mut built = 0;
        for picture in 0..4 {
            by_spus.go_on()?;
            let scene = by_spus.world.scene(&Settings::default().program)?;
            let traced = engine.render(scene, &mut |_| {})?;
            // The first tree is the PPU's, and the tiles' costs are not measured yet.
            if picture >= 2 {
                built += traced.refit;
                report.add(traced);
            }
        }
        let ticks = built as f64 / f64::from(report.frames);
        let cycles = ticks * CYCLES_A_TICK * f64::from(SPUS) / f64::from(count);
        let of_build = match built {
            0 => "in local store | -".to_owned(),
            _ => format!("{:.3} | {cycles:.0}", 1e3 * ticks / TIMEBASE),
        };
        let frame = 1e3 / report.frames_per_second;
        let mut by_ppu = Swarm::new(count, "spheres", Some(BuildBy::PpuSurfaces))?;
        by_ppu.go_on()?;
        let [_, of_ppu] = traced(&mut by_ppu.world, LARGE)?;
        println!(
            "| {count} | {of_build} | {frame:.1} | {:.1} | {of_ppu:.1} |",
            report.frames_per_second,
        );
    }
    Ok(())
}

/// A world of objects that move a little for each picture.
struct Swarm {
    world: World,
    ids: Vec<ObjectId>,
    picture: u32,
}

impl Swarm {
    fn new(count: u32, name: &str, build_by: Option<BuildBy>) -> Result<Self, WorldError> {
        let mut world = World::new();
        world.set_render_options(RenderOptions { build_by, ..RenderOptions::default() });
        world.look_from([0.0, 5.0, 11.0], [0.0; 3])?;
        world.add_light(Light::at(DVec3::new(6.0, 9.0, 7.0)))?;
        let red = world.add_material(Material::matte(0.9, 0.3, 0.2))?;
        let add = |number| {
            let middle = in_a_swarm(number, 0, count);
            if name == "spheres" {
                return world.add_sphere(middle, 0.1, red);
            }
            let corners = [DVec3::X, DVec3::Y, DVec3::Z];
            world.add_polygon(&corners.map(|corner| middle + 0.2 * corner), red)
        };
        let ids = (0..count).map(add).collect::<Result<_, _>>()?;
        Ok(Self { world, ids, picture: 0 })
    }

    fn go_on(&mut self) -> Result<(), WorldError> {
        self.picture += 1;
        for (number, &id) in (0..).zip(&self.ids) {
            let place = in_a_swarm(number, self.picture, self.ids.len() as u32);
            self.world.move_to(id, place)?;
        }
        Ok(())
    }
}

/// The place of an object in a picture.
fn in_a_swarm(number: u32, picture: u32, count: u32) -> DVec3 {
    let side = libm::ceil(libm::cbrt(f64::from(count))) as u32;
    let cell = [number % side, number / side % side, number / side / side];
    let (sine, cosine) = libm::sincos(f64::from(number) + 0.1 * f64::from(picture));
    let cell = DVec3::from_array(cell.map(f64::from)) / f64::from(side);
    6.0 * (cell - DVec3::splat(0.5)) + 0.1 * DVec3::new(sine, cosine, -sine)
}

fn turned(turns: f64) -> DAffine3 {
    // `libm`'s sines are the same on every machine.
    let (sine, cosine) = libm::sincos(TAU * turns);
    let x = DVec3::new(cosine, 0.0, -sine);
    let z = DVec3::new(sine, 0.0, cosine);
    DAffine3::from_cols(x, DVec3::Y, z, DVec3::ZERO)
}

/// Neighbours have different speeds. The slowest take 96 pictures.
fn on_an_orbit(number: u32, picture: u32) -> DAffine3 {
    let turns = f64::from(number) / 8.0 + f64::from(picture * (1 + number % 3)) / 96.0;
    let radius = 2.0 + 0.25 * f64::from(number % 4);
    turned(turns) * DAffine3::from_translation(DVec3::new(radius, 0.0, 0.0)) * turned(3.0 * turns)
}

/// From a place in a grid, each in a direction of its own.
fn scattered(number: u32, picture: u32) -> DAffine3 {
    let cell = [number % 5, number / 5 % 5, number / 25];
    let place = DVec3::from_array(cell.map(f64::from)) - DVec3::splat(2.0);
    // Steps around the sphere by the golden ratio are in no order with those through the grid.
    let height = 1.0 - 2.0 * f64::from(number * 37 % 125) / 124.0;
    let (sine, cosine) = libm::sincos(TAU * 0.618_033_988_749_895 * f64::from(number));
    let around = libm::sqrt(1.0 - height * height);
    let direction = DVec3::new(around * cosine, height, around * sine);
    let moved = 0.9 * place + 0.05 * f64::from(picture) * direction;
    let turns = f64::from(number) / 7.0 + f64::from(picture) / 50.0;
    DAffine3::from_translation(moved) * turned(turns) * DAffine3::from_scale(DVec3::splat(0.3))
}

/// An upright ring of radius 1 with smooth normals.
fn ring(along: u32, around: u32, thickness: f64) -> Mesh {
    let mut mesh = Mesh::default();
    let turn = |part: u32, of: u32| libm::sincos(TAU * f64::from(part) / f64::from(of));
    for (first, second) in (0..along).flat_map(|first| (0..around).map(move |it| (first, it))) {
        let ((y, x), (z, out)) = (turn(first, along), turn(second, around));
        let normal = DVec3::new(x * out, y * out, z);
        let point = DVec3::new(x, y, 0.0) + thickness * normal;
        mesh.positions.push(point.as_vec3().to_array());
        mesh.normals.push(normal.as_vec3().to_array());
        let at = |first: u32, second: u32| first % along * around + second % around;
        let (a, b) = (at(first, second), at(first + 1, second));
        let (c, d) = (at(first, second + 1), at(first + 1, second + 1));
        mesh.triangles.extend([[a, b, d], [a, d, c]]);
        mesh.materials.extend([0, 0]);
    }
    mesh
}
