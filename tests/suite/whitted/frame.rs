//! Frames of Whitted's model, and their difference from the reference.

use crate::prelude::*;
use cellray::scene::{NodeVolumes, Samples};
use cellray::statistics::{FrameStatistics, GENERATIONS, Generation, Rays};
use oracle::whitted::{Options, trace};
use oracle::{Comparison, Picture, Pixels};
use protocol::layout::MESH_MAX_SLOTS;

/// Whitted's model, with or without lights.
pub const WHITTED: RenderOptions = RenderOptions {
    model: Model::Whitted,
    ray_depth: 5,
    fresnel: false,
    spd_rays: false,
    shadows: true,
    samples: Samples::One,
    contrast: 0,
    colour: Colour::Linear,
    roll_off: false,
    corners: false,
    mesh_cache: MESH_MAX_SLOTS,
    refit_pictures: 50,
    refit_by: None,
    build_by: None,
    volumes: NodeVolumes::Best,
    cuts: true,
    shades: true,
};

pub struct Frame {
    pub picture: RgbImage,
    pub statistics: FrameStatistics,
}

impl Frame {
    /// Traces a scene.
    pub fn of(
        scene: &scenes::Scene,
        render_options: RenderOptions,
        size: (u32, u32),
        settings: Settings,
    ) -> Self {
        let (framebuffer, shown) = Recorder::pair(size.0, size.1);
        let mut engine = Engine::start(settings, framebuffer).unwrap();
        let scene = Scene::new(scene, render_options, &Program::tracer()).unwrap();
        let statistics = engine.render(&scene, &mut |_| ()).unwrap().clone();
        let picture = shown.lock().unwrap().take();
        Self { picture: picture.expect("the frame was presented"), statistics }
    }

    pub fn rays(&self) -> Rays {
        let mut sum = Rays::default();
        for spu in &self.statistics.spus {
            sum += spu.rays;
        }
        sum
    }

    pub fn generations(&self) -> [Generation; GENERATIONS] {
        let mut sums = [Generation::default(); GENERATIONS];
        for spu in &self.statistics.spus {
            for (sum, generation) in sums.iter_mut().zip(spu.generations) {
                *sum += generation;
            }
        }
        sums
    }
}

/// The reference's options that correspond to these, with one sample a pixel.
pub fn options(render_options: RenderOptions) -> Options {
    Options {
        depth: render_options.ray_depth,
        fresnel: render_options.fresnel,
        spd_rays: render_options.spd_rays,
        rounding: oracle::whitted::Rounding::Double,
        shadows: render_options.shadows,
        pixels: Pixels {
            colour: match render_options.colour {
                Colour::Linear => oracle::Colour::Linear,
                Colour::Srgb => oracle::Colour::Srgb,
            },
            corners: render_options.corners,
            ..Pixels::PLAIN
        },
    }
}

/// A picture in the format of the comparison.
pub fn picture(image: &RgbImage) -> Picture {
    let mut picture = Picture::black(image.width(), image.height()).unwrap();
    for (to, from) in picture.pixels_mut().iter_mut().zip(image.pixels()) {
        *to = from.0;
    }
    picture
}

/// Traces a scene on SPUs and with the reference.
pub fn compared(
    scene: &scenes::Scene,
    render_options: RenderOptions,
    size: (u32, u32),
) -> Comparison {
    let frame = Frame::of(scene, render_options, size, Settings::default());
    let (reference, _) = trace(scene, size.0, size.1, &options(render_options)).unwrap();
    oracle::compare(&picture(&frame.picture), &reference).unwrap()
}
