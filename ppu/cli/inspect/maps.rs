//! Maps of what a frame traced, by tile and by pixel.
//!
//! The SPUs count rays and tests for a whole frame. So another engine traces the picture again, a
//! tile in each frame, after everything about the inspected frame was recorded.

use cellray_inspector::{PixelMap, TileMap};
use image::{Rgb, RgbImage};
use protocol::layout::{TILE_HEIGHT, TILE_WIDTH};

use crate::framebuffer::{Geometry, Memory};
use crate::scene::{RenderOptions, Samples};
use crate::spe::Program;
use crate::statistics::Rays;
use crate::{Engine, Scene, Settings};

type Failure = Box<dyn std::error::Error>;

/// What the SPUs count of each tile.
pub fn of_tiles(
    settings: Settings,
    scene: &Scene,
    geometry: Geometry,
) -> Result<Vec<TileMap>, Failure> {
    let settings = Settings { spus: 1, retain: true, ..settings };
    let mut engine = Engine::start(settings, Box::new(Memory::new(geometry)?))?;
    engine.limit_tiles(Some(1));
    let tiles = geometry.width.div_ceil(TILE_WIDTH) * geometry.height.div_ceil(TILE_HEIGHT);
    let none = || vec![0; tiles as usize];
    let mut maps = [
        TileMap {
            id: "bounces",
            name: "bounces",
            remark: "Reflected and refracted rays of each tile.",
            values: none(),
        },
        TileMap {
            id: "shadows",
            name: "shadow rays",
            remark: "Shadow rays of each tile.",
            values: none(),
        },
        TileMap {
            id: "tests",
            name: "tests",
            remark: "Tests of a ray of the tile with an object.",
            values: none(),
        },
        TileMap {
            id: "volumes",
            name: "node visits",
            remark: "Tests of bounding volumes of nodes and objects with frusta and packets' cones.",
            values: none(),
        },
    ];
    for _ in 0..tiles {
        let statistics = engine.render(scene, &mut |_| ())?;
        let tests = statistics.tests();
        let mut rays = Rays::default();
        for spu in &statistics.spus {
            rays += spu.rays;
        }
        let traced = engine.traced_units().ok_or("the SPUs were lost")?;
        let counts = [rays.reflected + rays.refracted, rays.shadow, tests.made, tests.cull];
        for tile in traced.units.iter().flatten() {
            for (map, count) in maps.iter_mut().zip(counts) {
                map.values[tile.number as usize] = count;
            }
        }
    }
    // A model that has no such rays has no map of them.
    let mut maps = Vec::from(maps);
    maps.retain(|map| map.values.iter().any(|&value| value > 0));
    Ok(maps)
}

/// How many samples each pixel has, of a picture with `samples` beyond the first rays; `None` if
/// they are unknown.
pub fn of_samples(
    settings: Settings,
    scene: &scenes::Scene,
    render_options: RenderOptions,
    (program, geometry): (&Program, Geometry),
    samples: u64,
) -> Result<Option<PixelMap>, Failure> {
    let count = render_options.samples as u8;
    if render_options.samples == Samples::One || render_options.contrast == 0 {
        return Ok(None);
    }
    let plain = RenderOptions { samples: Samples::One, ..render_options };
    let plain = Scene::new(scene, plain, program)?;
    let mut engine = Engine::start(settings, Box::new(Memory::new(geometry)?))?;
    engine.render(&plain, &mut |_| ())?;
    let picture = engine.picture().ok_or("the picture can't be read back")?;
    let values: Vec<u8> = (0..geometry.height)
        .flat_map(|y| (0..geometry.width).map(move |x| (x, y)))
        .map(|at| match differs(&picture, at, render_options.contrast) {
            true => count,
            false => 1,
        })
        .collect();
    let chosen = values.iter().filter(|&&value| value > 1).count() as u64;
    Ok((chosen * u64::from(count) == samples).then(|| PixelMap {
        id: "samples",
        name: "samples",
        remark: format!(
            "Samples of each pixel: {count} in the {chosen} pixels that differ from a neighbour in \
             their tile by {}/255 or more, 1 in all others.",
            render_options.contrast
        ),
        values,
        kinds: &[],
    }))
}

/// Whether a pixel differs from a neighbour in its tile, by the rule of `spu/main/refine.s`.
fn differs(picture: &RgbImage, (x, y): (u32, u32), contrast: u8) -> bool {
    let tile = |x: u32, y: u32| (x / TILE_WIDTH, y / TILE_HEIGHT);
    let here = *picture.get_pixel(x, y);
    let far = |other: &Rgb<u8>| {
        let mut channels = here.0.iter().zip(other.0);
        channels.any(|(a, b)| a.abs_diff(b) >= contrast)
    };
    let beside = [(x.wrapping_sub(1), y), (x + 1, y), (x, y.wrapping_sub(1)), (x, y + 1)];
    let mut beside =
        beside.into_iter().filter(|&(other_x, other_y)| tile(other_x, other_y) == tile(x, y));
    beside.any(|(x, y)| picture.get_pixel_checked(x, y).is_some_and(far))
}
