//! From a scene, a camera and a framebuffer to a frame descriptor.

use nff::Camera;
use zerocopy::FromZeros as _;
use zerocopy::big_endian::{F32, U32};

use super::layout::{
    FEATURE_SPHERES, Frame, MAGIC, MAX_SPUS, SPLIT_SLICES, SPLIT_TILES, TILE_HEIGHT, TILE_WIDTH,
    VERSION,
};
use crate::framebuffer::{Geometry, Target};
use crate::scene::{Scene, singles};

/// How a frame is split among SPUs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Split {
    /// Each SPU takes the next tile when it has finished one.
    #[default]
    Tiles,
    /// Each SPU has its own consecutive part of the picture, as in the paper.
    Slices,
}

/// Where the frame's records lie in main memory.
#[derive(Clone, Copy, Debug)]
pub struct Addresses {
    /// Sphere records.
    pub spheres: u64,
    /// Tile counter.
    pub tile_counter: u64,
    /// Statistics records.
    pub statistics: u64,
}

/// Tiles in a picture.
#[must_use]
pub fn tile_count(geometry: Geometry) -> u32 {
    geometry.width.div_ceil(TILE_WIDTH) * geometry.height.div_ceil(TILE_HEIGHT)
}

/// First tile of each of `spus` equal slices; all further entries are the end of the last.
#[must_use]
pub fn slices(tiles: u32, spus: u32) -> [U32; MAX_SPUS as usize + 1] {
    std::array::from_fn(|number| {
        let first = u64::from(tiles) * number as u64 / u64::from(spus.max(1));
        U32::new(first.min(u64::from(tiles)) as u32)
    })
}

/// The descriptor of a frame.
#[must_use]
pub fn describe(
    scene: &Scene,
    camera: &Camera,
    target: &Target,
    addresses: Addresses,
    number: u32,
    spus: u32,
    split: Split,
) -> Frame {
    let mut frame = Frame::new_zeroed();
    frame.magic = MAGIC.into();
    frame.version = VERSION.into();
    frame.size = (size_of::<Frame>() as u32).into();
    frame.features = if scene.sphere_count() > 0 {
        FEATURE_SPHERES
    } else {
        0
    }
    .into();
    frame.number = number.into();
    frame.spus = spus.into();
    frame.split = match split {
        Split::Tiles => SPLIT_TILES,
        Split::Slices => SPLIT_SLICES,
    }
    .into();
    frame.width = target.geometry.width.into();
    frame.height = target.geometry.height.into();
    frame.stride = target.stride.into();
    frame.framebuffer = (target.base.as_ptr().expose_provenance() as u64).into();
    frame.spheres = addresses.spheres.into();
    frame.tile_counter = addresses.tile_counter.into();
    frame.statistics = addresses.statistics.into();
    frame.sphere_count = scene.sphere_count().into();
    frame.red_shift = target.format.red_shift.into();
    frame.green_shift = target.format.green_shift.into();
    frame.blue_shift = target.format.blue_shift.into();

    let depth = scene.depth();
    let range = (depth.far - depth.near) as f32;
    // A range of no width is bright everywhere: the brightness is clamped to 1.
    let (far, scale) = if range > 0.0 {
        (depth.far as f32, range.recip())
    } else {
        (f32::MAX, 1.0)
    };
    frame.depth_far = far.into();
    frame.depth_scale = scale.into();

    frame.eye = quadword(singles(camera.eye));
    frame.corner = quadword(singles(camera.corner));
    frame.right = quadword(singles(camera.right));
    frame.down = quadword(singles(camera.down));
    frame.background = quadword(singles(scene.background()));
    frame.slices = slices(tile_count(target.geometry), spus);
    frame
}

fn quadword([x, y, z]: [F32; 3]) -> [F32; 4] {
    [x, y, z, F32::ZERO]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slices_cover_every_tile_once_and_differ_by_one_at_most() {
        for tiles in [0, 1, 5, 6, 7, 900, 65536] {
            for spus in 1..=MAX_SPUS {
                let slices = slices(tiles, spus);
                assert_eq!(slices[0].get(), 0);
                let sizes: Vec<u32> = (0..spus as usize)
                    .map(|number| slices[number + 1].get() - slices[number].get())
                    .collect();
                assert_eq!(
                    sizes.iter().sum::<u32>(),
                    tiles,
                    "{tiles} tiles, {spus} SPUs"
                );
                assert!(sizes.iter().all(|size| size.abs_diff(tiles / spus) <= 1));
                assert!(slices[spus as usize..].iter().all(|end| end.get() == tiles));
            }
        }
    }
}
