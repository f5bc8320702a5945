//! Whether rays from the eye find a height field by cuts: vertical planes through the eye, along
//! which SPUs go over the ground once for all rays (`spu/main/whitted/cuts.s`).
//!
//! Cuts are lines of the picture that meet where rays go straight down, or up. In a tile they are
//! taken for parallel, and go up from row to row, so this place must be far away.

use glam::DVec3;
use protocol::layout::{MAX_CUT_FOURS, TILE_HEIGHT, TILE_WIDTH};
use scenes::Camera;
use zerocopy::big_endian::F32;

use crate::framebuffer::Geometry;
use crate::scene::Scene;
use crate::scene::block::SceneBlock;
use crate::scene::height::LEVEL_SQUARES;
use crate::scene::single::single;

/// By how many pixels at most cuts may miss a pixel at the edge of a tile.
const MISSED: f64 = 0.5;
/// How many pixels to the side a cut may be in the next row.
const MOST_ASIDE: f64 = 2.5;
/// How many squares the cuts that are followed together may be apart there.
const APART: f64 = 6.0;
/// The smallest cosine of the angle between a ray and the view's horizontal axis.
const LEAST_ALONG: f64 = 0.1;

/// The cuts of a frame, as it has them.
#[derive(Clone, Copy, Debug)]
pub struct Cuts {
    pub lat: [F32; 4],
    pub den: [F32; 4],
    pub num: [F32; 4],
    pub ahead: [F32; 4],
    pub fours: u32,
}

impl Cuts {
    /// Those of a frame, if it has ground below the eye and nothing else in main memory.
    pub fn of_frame(scene: &Scene, camera: &Camera, geometry: Geometry) -> Option<Self> {
        let mesh = scene.block().and_then(SceneBlock::mesh)?;
        let is_below = mesh.heights.is_some_and(|heights| heights.is_below);
        let may_cut = scene.render_options().cuts && mesh.is_ground && is_below;
        may_cut.then(|| Self::of(camera, geometry))?
    }

    /// Those of a camera, if all of its rays can be found by cuts.
    fn of(camera: &Camera, geometry: Geometry) -> Option<Self> {
        let [width, height] = [geometry.width, geometry.height].map(f64::from);
        let middle = camera.corner + camera.right * (width / 2.0) + camera.down * (height / 2.0);
        let ahead = middle.with_y(0.0).try_normalize()?;
        let aside = DVec3::new(-ahead.z, 0.0, ahead.x);
        let of = |axis: DVec3| [camera.corner, camera.right, camera.down].map(|it| it.dot(axis));
        let [lat, den, num] = [aside, ahead, DVec3::Y].map(of);
        let [tile_width, tile_height] = [TILE_WIDTH, TILE_HEIGHT].map(f64::from);
        let at = |[first, right, down]: [f64; 3], x: f64, y: f64| first + right * x + down * y;
        // The rate at which the tangent grows from column to column, and the pixels that a cut is
        // aside in the next row.
        let slant = |x: f64, y: f64| {
            let (across, along) = (at(lat, x, y), at(den, x, y));
            let tangent = across / along;
            let step = lat[1] - tangent * den[1];
            (step / along, -(lat[2] - tangent * den[2]) / step)
        };
        let mut widest = 0.0_f64;
        let mut way = 0.0;
        for x in [0.0, (width / tile_width).ceil() * tile_width] {
            for y in [0.0, (height / tile_height).ceil() * tile_height] {
                let ray = camera.corner + camera.right * x + camera.down * y;
                let (step, aside) = slant(x, y);
                let (_, beside) = slant(x + tile_width / 2.0, y);
                let is_straight = (beside - aside).abs() * tile_height / 2.0 <= MISSED
                    && aside.abs() <= MOST_ASIDE
                    && step * way >= 0.0
                    && at(den, x, y) >= LEAST_ALONG * ray.length();
                if !is_straight {
                    return None;
                }
                way = step;
                widest = widest.max(step.abs());
            }
        }
        let fours = (APART / (4.0 * LEVEL_SQUARES * widest)).floor();
        let four = |[a, b, c]: [f64; 3]| [a, b, c, 0.0].map(single);
        (fours >= 1.0).then(|| Self {
            lat: four(lat),
            den: four(den),
            num: four(num),
            ahead: [ahead.x, ahead.z, aside.x, aside.z].map(single),
            fours: (fours as u32).min(MAX_CUT_FOURS),
        })
    }
}
