//! Frames of which only the changed part is traced. Their bytes must equal those of a fully traced
//! frame.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use scenes::Object;

use crate::frames::random::{random_scene, sphere, vector};
use crate::prelude::*;
use cellray::framebuffer::{FramebufferError, Target};
use cellray::statistics::FrameStatistics;

#[test]
fn unchanged_frame_is_shown_and_not_traced() {
    let scene = Scene::from_nff(&nff_scene("paper16.nff")).unwrap();
    let (framebuffer, shown) = Recorder::pair(200, 100);
    let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
    let first = engine.render(&scene, &mut |_| ()).unwrap();
    assert_eq!((first.primary_rays(), first.tiles_retained), (20_000, 0));
    let picture = shown.lock().unwrap().take().unwrap();
    for _ in 0..3 {
        let statistics = engine.render(&scene, &mut |_| ()).unwrap();
        assert_eq!((statistics.primary_rays(), statistics.tiles_retained), (0, 28));
        assert_eq!(statistics.tests(), Default::default());
        assert_eq!(statistics.ticks(), 0);
        assert!(!statistics.is_traced());
        assert!(shown.lock().unwrap().take().unwrap() == picture);
    }
}

type Change = fn(&mut scenes::Scene);

/// With Whitted's model too, a change is traced wherever it is visible.
#[test]
fn whitted_pixels_are_traced_again_where_changed() {
    let whitted = nff_scene("whitted16.nff");
    let changes: [(&str, Change); 12] = [
        ("a colour", |scene| scene.materials[7].colour.x = 0.1),
        ("a share", |scene| scene.materials[3].diffuse = 0.5),
        ("a shader", |scene| scene.materials[4].shader = scenes::Shader::Flat),
        ("a light's place", |scene| {
            scene.lights[1].kind = scenes::LightKind::Point {
                position: DVec3::new(30.0, -30.0, 24.0),
                range: f64::INFINITY,
            }
        }),
        ("a light's colour", |scene| scene.lights[0].colour = Some(DVec3::ONE)),
        ("a light less", |scene| scene.lights.truncate(1)),
        ("the ambient light", |scene| scene.ambient = DVec3::splat(0.2)),
        ("the fog", |scene| {
            scene.fog = Some(scenes::Fog { colour: DVec3::ONE, density: 0.1 });
        }),
        ("the background", |scene| scene.background.z = 0.0),
        ("a place", |scene| move_sphere(scene, 5)),
        ("an object less", |scene| scene.objects.truncate(12)),
        ("a shape", halve_the_ground),
    ];
    let (framebuffer, shown) = Recorder::pair(64, 32);
    let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
    let tiles = 2;
    for (what, change) in changes {
        let mut changed = whitted.clone();
        change(&mut changed);
        let mut pictures = [&whitted, &changed].map(|nff| {
            let scene = Scene::from_nff(nff).unwrap();
            let mut retained = || {
                let statistics = engine.render(&scene, &mut |_| ()).unwrap();
                statistics.tiles_retained
            };
            // The previous frame may have shown this scene already.
            retained();
            let first = shown.lock().unwrap().take().unwrap();
            assert_eq!(retained(), tiles, "{what}");
            assert!(shown.lock().unwrap().take().unwrap() == first, "{what}");
            first
        });
        let [before, after] = &mut pictures;
        assert!(before != after, "{what} shows nowhere");
        assert!(*after == render(&changed, 64, 32, Settings::default()), "{what}");
    }
    let scene = Scene::from_nff(&whitted).unwrap();
    engine.render(&scene, &mut |_| ()).unwrap();
    for render_options in [
        RenderOptions { shadows: false, ..RenderOptions::default() },
        RenderOptions { ray_depth: 2, ..RenderOptions::default() },
        RenderOptions { fresnel: true, ..RenderOptions::default() },
    ] {
        let scene = Scene::new(&whitted, render_options, &Program::tracer()).unwrap();
        let traced = [(); 2].map(|()| {
            let statistics = engine.render(&scene, &mut |_| ()).unwrap();
            statistics.tiles_retained
        });
        assert_eq!(traced, [0, tiles], "{render_options:?}");
    }
}

fn move_sphere(scene: &mut scenes::Scene, number: usize) {
    if let Shape::Sphere { centre, .. } = &mut scene.objects[number].shape {
        centre.x += 0.25;
    }
}

/// Turns the parallelogram into the triangle of its first three vertices.
fn halve_the_ground(scene: &mut scenes::Scene) {
    if let Shape::Polygon { vertices } = &mut scene.objects[0].shape {
        vertices.truncate(3);
    }
}

#[test]
fn retain_and_skip_off_trace_every_pixel() {
    let scene = Scene::from_nff(&nff_scene("paper16.nff")).unwrap();
    let retrace = Settings { retain: false, ..Settings::default() };
    let no_skip = Settings { skip: Skip::Nothing, ..Settings::default() };
    for settings in [retrace, no_skip] {
        let (framebuffer, _) = Recorder::pair(200, 100);
        let mut engine = Engine::start(settings, framebuffer).unwrap();
        for _ in 0..2 {
            let statistics = engine.render(&scene, &mut |_| ()).unwrap();
            assert_eq!((statistics.primary_rays(), statistics.tiles_retained), (20_000, 0));
        }
    }
}

#[test]
fn background_is_not_sent_twice() {
    let scene = Scene::from_nff(&nff_scene("paper1.nff")).unwrap();
    let retrace = Settings { retain: false, ..Settings::default() };
    let (framebuffer, shown) = Recorder::pair(640, 360);
    let mut engine = Engine::start(retrace, framebuffer).unwrap();
    let blank = |statistics: &FrameStatistics| -> (u64, u64) {
        let spus = statistics.spus.iter();
        spus.fold((0, 0), |(filled, blank), spu| {
            (filled + spu.tiles_filled, blank + spu.tiles_blank)
        })
    };
    let (filled, before) = blank(engine.render(&scene, &mut |_| ()).unwrap());
    assert!(filled > 100 && before == 0, "{filled} {before}");
    let picture = shown.lock().unwrap().take().unwrap();
    assert_eq!(blank(engine.render(&scene, &mut |_| ()).unwrap()), (filled, filled));
    assert!(shown.lock().unwrap().take().unwrap() == picture);
}

#[test]
fn borrowed_framebuffer_counts_as_drawn_to() {
    let scene = Scene::from_nff(&nff_scene("paper16.nff")).unwrap();
    let (framebuffer, shown) = Recorder::pair(64, 64);
    let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
    engine.render(&scene, &mut |_| ()).unwrap();
    let picture = shown.lock().unwrap().take().unwrap();
    let target = engine.framebuffer().unwrap().target();
    // SAFETY: the target was just obtained, and the SPUs are idle.
    unsafe { target.base.write_bytes(0xee, target.bytes) };
    engine.render(&scene, &mut |_| ()).unwrap();
    assert!(shown.lock().unwrap().take().unwrap() == picture);
}

/// One step of a game: an object moves, changes, appears or disappears, or the view changes.
fn change(random: &mut ChaCha8Rng, scene: &mut scenes::Scene) {
    // The first two stay: see frame_of_depth.
    let count = scene.objects.len();
    let any = random.random_range(2..count);
    let Object { shape: Shape::Sphere { centre, radius }, material, .. } = &mut scene.objects[any]
    else {
        unreachable!("these scenes have only spheres");
    };
    match random.random_range(0..24) {
        0 => {}
        1 => *material = random.random_range(0..scene.materials.len() as u32),
        2 => *radius = libm::exp2(random.random_range(-6.0..0.5f64)),
        3 => {
            scene.objects.remove(any);
            let new = sphere(random, scene.materials.len());
            scene.objects.push(new);
        }
        4 => {
            let new = sphere(random, scene.materials.len());
            scene.objects.push(new);
        }
        5 if count > 4 => {
            scene.objects.remove(any);
        }
        6 => scene.view.from += vector(random, 0.1),
        7 => scene.background = vector(random, 1.0).abs(),
        // In front of the eye, around it and behind the eye.
        8 => *centre = scene.view.from + vector(random, 2.0),
        9 => scene.materials[0].colour = vector(random, 1.0).abs(),
        _ => *centre += vector(random, 0.3),
    }
}

/// Two spheres that set the range of depth shading, so that other objects do not change it.
fn frame_of_depth(scene: &mut scenes::Scene) {
    let place =
        |centre, radius| Object { line: 0, material: 0, shape: Shape::Sphere { centre, radius } };
    scene.objects.insert(0, place(DVec3::new(3.0, -13.0, 0.0), 3.1));
    scene.objects.insert(1, place(DVec3::new(0.0, 30.0, 0.0), 0.5));
}

/// Two pages that are shown in turn, like those of a screen.
struct TwoPages {
    pages: [Memory; 2],
    next: usize,
    shown: Snapshot,
}

impl TwoPages {
    fn pair(width: u32, height: u32) -> (Box<dyn Framebuffer>, Snapshot) {
        let page = || Memory::new(Geometry { width, height }).unwrap();
        let shown: Snapshot = Arc::new(Mutex::new(None));
        let pages = Self { pages: [page(), page()], next: 0, shown: Arc::clone(&shown) };
        (Box::new(pages), shown)
    }
}

impl Framebuffer for TwoPages {
    fn geometry(&self) -> Geometry {
        self.pages[0].geometry()
    }

    fn target(&mut self) -> Target {
        self.pages[self.next].target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        *self.shown.lock().unwrap() = Some(self.pages[self.next].rgb());
        self.next = 1 - self.next;
        Ok(())
    }

    fn keeps_contents(&self) -> bool {
        true
    }

    fn describe(&self) -> String {
        "two pages".into()
    }
}

#[test]
fn retained_frames_equal_full_frames() {
    let mut retained = 0;
    for (seed, (pair, split)) in (41..).zip([
        (Recorder::pair as fn(u32, u32) -> (Box<dyn Framebuffer>, Snapshot), Split::Units),
        (TwoPages::pair, Split::Units),
        (Recorder::pair, Split::Slices),
    ]) {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut scene = random_scene(&mut random, 12);
        frame_of_depth(&mut scene);
        let (width, height) = (330, 170);
        let (framebuffer, shown) = pair(width, height);
        let mut engine =
            Engine::start(Settings { split, ..Settings::default() }, framebuffer).unwrap();
        let (reference, expected) = Recorder::pair(width, height);
        let whole = Settings { retain: false, ..Settings::default() };
        let mut whole = Engine::start(whole, reference).unwrap();
        for step in 0..60 {
            if step % 7 != 6 {
                change(&mut random, &mut scene);
            }
            let scene = Scene::from_nff(&scene).unwrap();
            let statistics = engine.render(&scene, &mut |_| ()).unwrap();
            retained += statistics.tiles_retained;
            whole.render(&scene, &mut |_| ()).unwrap();
            let (shown, expected): (RgbImage, RgbImage) =
                (shown.lock().unwrap().take().unwrap(), expected.lock().unwrap().take().unwrap());
            assert!(shown == expected, "seed {seed}, step {step}");
        }
    }
    // 180 frames of 66 tiles each.
    assert!(retained > 180 * 66 / 4, "{retained}");
}

/// Memory to which others may draw between frames.
struct Shared {
    memory: Memory,
    disturbed: Arc<AtomicBool>,
    shown: Snapshot,
}

impl Framebuffer for Shared {
    fn geometry(&self) -> Geometry {
        self.memory.geometry()
    }

    fn target(&mut self) -> Target {
        self.memory.target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        *self.shown.lock().unwrap() = Some(self.memory.rgb());
        if self.disturbed.load(Ordering::Relaxed) {
            let Target { base, bytes, .. } = self.memory.target();
            // SAFETY: the target was just obtained, and the SPUs have replied.
            unsafe { base.write_bytes(0xee, bytes) };
        }
        Ok(())
    }

    fn keeps_contents(&self) -> bool {
        !self.disturbed.load(Ordering::Relaxed)
    }

    fn describe(&self) -> String {
        "shared".into()
    }
}

#[test]
fn pixels_are_traced_again_after_other_writers() {
    let nff = nff_scene("paper16.nff");
    let expected = render(&nff, 100, 50, Settings::default());
    let (shown, disturbed) = (Snapshot::default(), Arc::new(AtomicBool::new(false)));
    let framebuffer = Box::new(Shared {
        memory: Memory::new(Geometry { width: 100, height: 50 }).unwrap(),
        disturbed: Arc::clone(&disturbed),
        shown: Arc::clone(&shown),
    });
    let scene = Scene::from_nff(&nff).unwrap();
    let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
    for (others_draw, retained) in
        [(false, 0), (false, 8), (true, 0), (true, 0), (false, 0), (false, 8)]
    {
        disturbed.store(others_draw, Ordering::Relaxed);
        let statistics = engine.render(&scene, &mut |_| ()).unwrap();
        assert_eq!(statistics.tiles_retained, retained);
        assert!(shown.lock().unwrap().take().unwrap() == expected);
    }
}

/// A framebuffer whose frames sometimes get lost on the way to the screen.
struct Unsteady {
    memory: Memory,
    presents: u32,
    shown: Snapshot,
}

impl Framebuffer for Unsteady {
    fn geometry(&self) -> Geometry {
        self.memory.geometry()
    }

    fn target(&mut self) -> Target {
        self.memory.target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        self.presents += 1;
        if self.presents == 2 {
            let Target { base, bytes, .. } = self.memory.target();
            // SAFETY: the target was just obtained, and the SPUs have replied.
            unsafe { base.write_bytes(0xee, bytes) };
            return Err(FramebufferError::OutOfMemory { bytes });
        }
        *self.shown.lock().unwrap() = Some(self.memory.rgb());
        Ok(())
    }

    fn keeps_contents(&self) -> bool {
        true
    }

    fn describe(&self) -> String {
        "unsteady".into()
    }
}

#[test]
fn pixels_are_traced_again_after_an_error() {
    let nff = nff_scene("paper16.nff");
    let shown = Snapshot::default();
    let framebuffer = Box::new(Unsteady {
        memory: Memory::new(Geometry { width: 100, height: 50 }).unwrap(),
        presents: 0,
        shown: Arc::clone(&shown),
    });
    let scene = Scene::from_nff(&nff).unwrap();
    let mut engine = Engine::start(Settings::default(), framebuffer).unwrap();
    engine.render(&scene, &mut |_| ()).unwrap();
    let error = engine.render(&scene, &mut |_| ()).unwrap_err();
    assert!(matches!(error, EngineError::Framebuffer(_)), "{error}");
    let statistics = engine.render(&scene, &mut |_| ()).unwrap();
    assert_eq!(statistics.tiles_retained, 0);
    let picture = shown.lock().unwrap().take().unwrap();
    assert!(picture == render(&nff, 100, 50, Settings::default()));
}
