//! Whole frames: the same bytes however the work is split, and the f64 reference's picture.

use std::ffi::c_void;
use std::ptr::{self, NonNull};

use crate::recorder::{Recorder, nff_scene, render};
use cellray::framebuffer::{Framebuffer, FramebufferError, Geometry, PixelFormat, Target};
use cellray::work::Split;
use cellray::{Engine, Scene, Settings};

#[test]
fn one_to_six_spus_and_both_splits_give_the_same_bytes() {
    let scene = nff_scene("paper16.nff");
    // Widths that fill whole tiles, part of one, and no whole group of four pixels.
    for (width, height) in [(256, 64), (101, 57), (1, 1), (3, 200)] {
        let reference = render(&scene, width, height, 1, Split::Tiles);
        for spus in 1..=6 {
            for split in [Split::Tiles, Split::Slices] {
                let picture = render(&scene, width, height, spus, split);
                assert!(
                    picture == reference,
                    "{width}x{height}, {spus} SPUs, {split:?}"
                );
            }
        }
    }
}

#[test]
fn frames_that_follow_each_other_are_the_same() {
    let scene = Scene::from_nff(&nff_scene("paper13.nff")).unwrap();
    let (framebuffer, shown) = Recorder::pair(200, 100);
    let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
    let mut first = None;
    for _ in 0..5 {
        let statistics = engine.render(&scene, &mut |_| ()).unwrap();
        assert_eq!(statistics.eye_rays(), 20_000);
        let tests: u64 = statistics.spus.iter().map(|spu| spu.tests_made).sum();
        let packets: u64 = statistics.spus.iter().map(|spu| spu.packets).sum();
        assert_eq!(tests, packets * 16 * 13);
        let picture = shown.lock().unwrap().take().unwrap();
        assert!(*first.get_or_insert(picture.clone()) == picture);
    }
}

/// Compares with f64: every pixel within 1/255 away from silhouettes, and not over 0.05 % off at all.
fn like_the_reference(scene: &nff::Scene, width: u32, height: u32) {
    let rendered = render(scene, width, height, 6, Split::Tiles);
    let mut picture = oracle::Picture::black(width, height).unwrap();
    for (to, from) in picture.pixels_mut().iter_mut().zip(rendered.pixels()) {
        *to = from.0;
    }
    let reference = oracle::trace(scene, width, height).unwrap();
    let comparison = oracle::compare(&picture, &reference).unwrap();
    println!("{}: {comparison:?}", scene.name);
    assert_eq!(comparison.wrong_off_silhouette, 0);
    assert!(comparison.wrong_fraction <= 0.0005, "{comparison:?}");
}

#[test]
fn the_papers_scenes_are_like_the_reference() {
    like_the_reference(&nff_scene("paper16.nff"), 1280, 720);
    like_the_reference(&nff_scene("paper13.nff"), 640, 360);
}

#[test]
fn a_sphereflake_is_like_the_reference() {
    like_the_reference(&nff::sphereflake::generate(2).unwrap(), 512, 512);
}

#[test]
fn an_empty_scene_is_its_background() {
    let text =
        "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 64 64\nb 0.2 0.4 0.6\n";
    let scene = nff::parse(text.as_bytes(), "empty", &nff::Limits::default()).unwrap();
    let picture = render(&scene, 70, 20, 2, Split::Tiles);
    assert!(picture.pixels().all(|pixel| pixel.0 == [51, 102, 153]));
}

#[test]
fn hits_are_counted_within_the_picture_only() {
    // One sphere around the whole view: every ray hits, also of the lanes beyond the picture's edge.
    let text = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 10\nhither 1\nresolution 64 64\n\
                f 1 1 1 1 0 0 0 1\ns 0 0 0 5\n";
    let scene = nff::parse(text.as_bytes(), "near", &nff::Limits::default()).unwrap();
    for (width, height) in [(61, 37), (4, 4), (65, 17)] {
        let (framebuffer, _) = Recorder::pair(width, height);
        let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
        let statistics = engine
            .render(&Scene::from_nff(&scene).unwrap(), &mut |_| ())
            .unwrap();
        let hits: u64 = statistics.spus.iter().map(|spu| spu.eye_hits).sum();
        assert_eq!(hits, u64::from(width * height), "{width}x{height}");
    }
}

/// Memory around a multiple of 4 GB, where a tile's rows have no common high address word.
struct Straddling {
    base: NonNull<u8>,
    geometry: Geometry,
}

const BOUNDARY: usize = 0x22_0000_0000;
const STRIDE: u32 = 512;

// SAFETY: the mapping is this value's own.
unsafe impl Send for Straddling {}

impl Straddling {
    fn new(geometry: Geometry) -> Self {
        let length = STRIDE as usize * geometry.height as usize;
        let start = BOUNDARY - length / 2 / 4096 * 4096;
        // SAFETY: maps new anonymous memory; nothing that exists is replaced.
        let base = unsafe {
            libc::mmap(
                start as *mut c_void,
                length,
                libc::PROT_READ | libc::PROT_WRITE,
                libc::MAP_PRIVATE | libc::MAP_ANONYMOUS | libc::MAP_FIXED_NOREPLACE,
                -1,
                0,
            )
        };
        assert_eq!(base as usize, start, "the address is taken");
        Self {
            base: NonNull::new(base.cast()).unwrap(),
            geometry,
        }
    }

    fn bytes(&self) -> usize {
        STRIDE as usize * self.geometry.height as usize
    }
}

impl Drop for Straddling {
    fn drop(&mut self) {
        // SAFETY: the mapping is this value's own, and no SPU writes to it any more.
        unsafe { libc::munmap(self.base.as_ptr().cast(), self.bytes()) };
    }
}

impl Framebuffer for Straddling {
    fn geometry(&self) -> Geometry {
        self.geometry
    }

    fn target(&mut self) -> Target {
        Target {
            base: self.base,
            bytes: self.bytes(),
            stride: STRIDE,
            geometry: self.geometry,
            format: PixelFormat::ARGB,
        }
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        let bytes = ptr::slice_from_raw_parts(self.base.as_ptr(), self.bytes());
        // SAFETY: all SPUs have answered, so nobody writes to the mapping now.
        let bytes = unsafe { &*bytes };
        let expected = render(
            &nff_scene("paper16.nff"),
            self.geometry.width,
            self.geometry.height,
            1,
            Split::Tiles,
        );
        for (x, y, pixel) in expected.enumerate_pixels() {
            let offset = (y * STRIDE + x * 4) as usize;
            assert_eq!(bytes[offset + 1..offset + 4], pixel.0, "pixel {x}, {y}");
        }
        Ok(())
    }

    fn describe(&self) -> String {
        format!("memory around {BOUNDARY:#x}")
    }
}

#[test]
fn a_framebuffer_across_a_multiple_of_4_gb() {
    let geometry = Geometry {
        width: 120,
        height: 200,
    };
    let framebuffer = Box::new(Straddling::new(geometry));
    let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
    engine
        .render(
            &Scene::from_nff(&nff_scene("paper16.nff")).unwrap(),
            &mut |_| (),
        )
        .unwrap();
}
