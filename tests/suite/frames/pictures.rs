//! Whole frames have the same bytes however the work is split, and match the picture of the f64
//! reference.

use std::ffi::c_void;
use std::ptr::{self, NonNull};

use crate::frames::random::{random_scene, vector};
use crate::prelude::*;
use cellray::framebuffer::{FramebufferError, PixelFormat, Target};
use protocol::layout::{DEPTH_CODE, DEPTH_CODE_CAPACITY};

fn one_spu() -> Settings {
    Settings { spus: 1, ..Settings::default() }
}

#[test]
fn picture_is_independent_of_spus_split_and_costs() {
    let scene = nff_scene("paper16.nff");
    // Widths of whole tiles, of part of a tile, and one that is no multiple of four pixels.
    for (width, height) in [(256, 64), (101, 57), (1, 1), (3, 200), (700, 33)] {
        let reference = render(&scene, width, height, one_spu());
        for spus in 1..=6 {
            for split in [Split::Units, Split::Slices] {
                let settings = Settings { spus, split, retain: false, ..Settings::default() };
                let (framebuffer, shown) = Recorder::pair(width, height);
                let mut engine = Engine::start(settings, framebuffer).unwrap();
                let scene = Scene::from_nff(&scene).unwrap();
                // The units of the first frame are cut without known costs, and those of later
                // frames by costs.
                for frame in 1..=3 {
                    engine.render(&scene, &mut |_| ()).unwrap();
                    assert!(
                        shown.lock().unwrap().take().unwrap() == reference,
                        "{width}x{height}, {spus} SPUs, {split:?}, frame {frame}"
                    );
                }
            }
        }
    }
}

#[test]
fn every_packet_is_accounted_for_with_every_sphere() {
    let nff = nff_scene("paper13.nff");
    let mut view_of_some = nff.clone();
    // With a narrow view, most of the spheres are outside the picture.
    view_of_some.view.angle = 5.0;
    for (nff, skip) in [
        (&nff, Skip::Misses),
        (&nff, Skip::Nothing),
        (&view_of_some, Skip::Misses),
        (&view_of_some, Skip::Nothing),
    ] {
        let scene = Scene::from_nff(nff).unwrap();
        let (framebuffer, shown) = Recorder::pair(200, 100);
        let settings = Settings { skip, retain: false, ..Settings::default() };
        let mut engine = Engine::start(settings, framebuffer).unwrap();
        let mut first = None;
        for _ in 0..3 {
            let statistics = engine.render(&scene, &mut |_| ()).unwrap();
            assert_eq!(statistics.primary_rays(), 20_000);
            let packets: u64 = statistics.spus.iter().map(|spu| spu.packets).sum();
            assert_eq!(packets, 50 * 25);
            let tiles: u64 = statistics.spus.iter().map(|spu| spu.tiles).sum();
            assert_eq!(tiles, 4 * 7);
            let tests = statistics.tests();
            assert_eq!(tests.made + tests.skipped + tests.unseen, packets * 16 * 13);
            assert!(tests.hidden <= tests.skipped);
            assert!(tests.intersections_computed <= tests.made, "{tests:?}");
            if skip == Skip::Nothing {
                assert_eq!((tests.skipped, tests.unseen, tests.cull), (0, 0, 0));
            } else {
                assert!(tests.made < packets * 16 * 13 / 5, "{tests:?}");
                assert_eq!(tests.unseen > 0, nff.view.angle == 5.0);
            }
            let picture = shown.lock().unwrap().take().unwrap();
            assert!(*first.get_or_insert(picture.clone()) == picture);
        }
    }
}

#[test]
fn skipped_tests_are_of_spheres_far_from_all_rays() {
    for name in ["paper1.nff", "paper13.nff", "spheres64.nff"] {
        let scene = Scene::from_nff(&nff_scene(name)).unwrap();
        let [skipping, without] = [Skip::Misses, Skip::Nothing].map(|skip| {
            let settings = Settings { skip, ..Settings::default() };
            let (framebuffer, _) = Recorder::pair(320, 180);
            let mut engine = Engine::start(settings, framebuffer).unwrap();
            engine.render(&scene, &mut |_| ()).unwrap().tests()
        });
        // The test with a packet's own rays is closer than the one with its cone.
        let near = skipping.made + skipping.hidden;
        assert!(without.intersections_computed <= near, "{name}: {skipping:?} {without:?}");
        assert!(without.intersections_computed > near / 2, "{name}: {skipping:?} {without:?}");
    }
}

const SCENES: [&str; 8] = [
    "paper1.nff",
    "paper13.nff",
    "paper16.nff",
    "cluster.nff",
    "spheres64.nff",
    "spheres256.nff",
    "empty.nff",
    "fullscreen.nff",
];

/// Renders with and without skipping. The bytes must be equal.
fn skipping_changes_nothing(scene: &scenes::Scene, width: u32, height: u32) -> RgbImage {
    let skipping = render(scene, width, height, Settings::default());
    let settings = Settings { skip: Skip::Nothing, ..Settings::default() };
    let without = render(scene, width, height, settings);
    assert!(skipping == without, "{scene:?} at {width}x{height}");
    skipping
}

#[test]
fn skipping_changes_no_scene() {
    for name in SCENES {
        for (width, height) in [(320, 180), (101, 57)] {
            skipping_changes_nothing(&nff_scene(name), width, height);
        }
    }
    skipping_changes_nothing(&scenes::sphereflake::generate(2).unwrap(), 160, 120);
}

#[test]
fn skipping_changes_no_random_scene() {
    let mut random = ChaCha8Rng::seed_from_u64(31);
    let mut shown = 0;
    let rounds = randomness::rounds(50);
    for number in 0..rounds {
        let count = random.random_range(1..60);
        let mut scene = random_scene(&mut random, count);
        let view = &mut scene.view;
        // From outside and from among the spheres, with a narrow view and with a very wide
        // picture.
        view.from = vector(&mut random, if number % 2 == 0 { 12.0 } else { 3.0 });
        view.at = vector(&mut random, 2.0);
        let widest = libm::exp2(random.random_range(2.0..7.4f64));
        view.angle = random.random_range(1.0..widest);
        let picture = skipping_changes_nothing(&scene, 70, 40);
        let first = *picture.get_pixel(0, 0);
        shown += u32::from(picture.pixels().any(|pixel| *pixel != first));
    }
    assert!(shown > rounds / 2, "{shown} of {rounds} pictures show anything");
}

/// Compares with f64: every pixel is within 1/255 away from silhouettes, and at most 0.05 % of all
/// pixels are off.
fn like_the_reference(scene: &scenes::Scene, width: u32, height: u32) {
    let rendered = render(scene, width, height, Settings::default());
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
fn scenes_equal_reference_within_tolerance() {
    for name in SCENES {
        let (width, height) = match name {
            "paper16.nff" => (1280, 720),
            _ => (640, 360),
        };
        like_the_reference(&nff_scene(name), width, height);
    }
}

#[test]
fn sphereflake_equals_reference_within_tolerance() {
    let mut scene = scenes::sphereflake::generate(2).unwrap();
    // With depth shading, as for all scenes without lights.
    scene.lights.clear();
    like_the_reference(&scene, 512, 512);
}

/// The code for depth shading comes back after a scene that has taken its place in local store.
#[test]
fn depth_shading_follows_a_large_scene_of_whitteds_model() {
    let nff = nff_scene("paper16.nff");
    let expected = render(&nff, 64, 32, one_spu());
    let shaded = Scene::from_nff(&nff).unwrap();
    let large = Scene::from_nff(&scenes::sphereflake::generate(3).unwrap()).unwrap();
    let end = SCENE_ADDRESS + large.block().unwrap().bytes().len() as u32;
    assert!(end >= DEPTH_CODE + DEPTH_CODE_CAPACITY, "the scene ends at {end:#x}");
    let (framebuffer, shown) = Recorder::pair(64, 32);
    let settings = Settings { retain: false, ..one_spu() };
    let mut engine = Engine::start(settings, framebuffer).unwrap();
    for (number, scene) in [&shaded, &large, &shaded, &shaded].into_iter().enumerate() {
        engine.render(scene, &mut |_| ()).unwrap();
        let picture = shown.lock().unwrap().take().unwrap();
        assert!((picture == expected) == (number != 1), "frame {number}");
    }
}

#[test]
fn empty_scene_shows_background() {
    let scene = nff_scene("empty.nff");
    let expected = scenes::depth::bytes(scene.background);
    for spus in [1, 2, 6] {
        let settings = Settings { spus, ..Settings::default() };
        let picture = render(&scene, 70, 20, settings);
        assert!(picture.pixels().all(|pixel| pixel.0 == expected));
    }
}

#[test]
fn hits_are_counted_within_the_picture_only() {
    // One sphere encloses the eye, so every ray hits, including those of lanes outside the
    // picture.
    let text = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 10\nhither 1\nresolution 64 64\n\
                f 1 1 1 1 0 0 0 1\ns 0 0 0 5\n";
    let scene = scenes::parse(text.as_bytes(), "near", &scenes::Limits::default()).unwrap();
    for (width, height) in [(61, 37), (4, 4), (65, 17)] {
        let (framebuffer, _) = Recorder::pair(width, height);
        let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
        let statistics = engine.render(&Scene::from_nff(&scene).unwrap(), &mut |_| ()).unwrap();
        let hits: u64 = statistics.spus.iter().map(|spu| spu.rays.eye_hit).sum();
        assert_eq!(hits, u64::from(width * height), "{width}x{height}");
    }
}

/// Memory around a multiple of 4 GB, where the rows of a tile have different high address words.
struct Straddling {
    base: NonNull<u8>,
    geometry: Geometry,
}

const BOUNDARY: usize = 0x22_0000_0000;
const STRIDE: u32 = 512;

// SAFETY: the mapping belongs to this value.
unsafe impl Send for Straddling {}

impl Straddling {
    fn new(geometry: Geometry) -> Self {
        let length = STRIDE as usize * geometry.height as usize;
        let start = BOUNDARY - length / 2 / 4096 * 4096;
        // SAFETY: this maps new anonymous memory and replaces no existing mapping.
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
        Self { base: NonNull::new(base.cast()).unwrap(), geometry }
    }

    fn bytes(&self) -> usize {
        STRIDE as usize * self.geometry.height as usize
    }
}

impl Drop for Straddling {
    fn drop(&mut self) {
        // SAFETY: the mapping belongs to this value, and no SPU writes to it any more.
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
        // SAFETY: all SPUs have replied, so nothing writes to the mapping now.
        let bytes = unsafe { &*bytes };
        let expected =
            render(&nff_scene("paper16.nff"), self.geometry.width, self.geometry.height, one_spu());
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
fn framebuffer_may_cross_multiple_of_4_gb() {
    let geometry = Geometry { width: 120, height: 200 };
    let framebuffer = Box::new(Straddling::new(geometry));
    let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
    engine.render(&Scene::from_nff(&nff_scene("paper16.nff")).unwrap(), &mut |_| ()).unwrap();
}
