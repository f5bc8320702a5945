//! The SPU's side of the work-unit protocol: what it refuses, and that it goes on afterwards.

use std::time::Duration;

use crate::recorder::{Recorder, nff_scene};
use cellray::framebuffer::{Framebuffer as _, Geometry, Memory};
use cellray::work::layout::{Frame, Sphere, Statistics, TileCounter};
use cellray::work::{self, Addresses, Split};
use cellray::{Engine, EngineError, Scene, Settings, SharedMemory};
use zerocopy::big_endian::U32;

/// Makes one field of a descriptor wrong.
type Spoil = fn(&mut Frame);

/// An engine, and a good frame descriptor with all that it points to.
struct Fixture {
    engine: Engine,
    frame: Frame,
    _memory: Vec<SharedMemory>,
    _framebuffer: Memory,
}

fn fixture(spus: u32) -> Fixture {
    let scene = Scene::from_nff(&nff_scene("paper13.nff")).unwrap();
    let mut framebuffer = Memory::new(Geometry {
        width: 64,
        height: 32,
    })
    .unwrap();
    let target = framebuffer.target();
    let mut spheres = SharedMemory::new(size_of::<Sphere>() * scene.sphere_count() as usize);
    spheres.write(0, scene.sphere_bytes());
    let tile_counter = SharedMemory::new(size_of::<TileCounter>());
    let statistics = SharedMemory::new(size_of::<Statistics>() * spus as usize);
    let addresses = Addresses {
        spheres: spheres.address(),
        tile_counter: tile_counter.address(),
        statistics: statistics.address(),
    };
    let camera = scene.camera(64, 32).unwrap();
    let frame = work::describe(&scene, &camera, &target, addresses, 1, spus, Split::Slices);
    let settings = Settings {
        spus,
        timeout: Duration::from_secs(30),
        ..Settings::default()
    };
    let (recorder, _) = Recorder::pair(4, 4);
    Fixture {
        engine: Engine::start(settings, recorder).unwrap(),
        frame,
        _memory: vec![spheres, tile_counter, statistics],
        _framebuffer: framebuffer,
    }
}

impl Fixture {
    fn submit(&mut self, frame: &Frame) -> Result<(), EngineError> {
        // SAFETY: every address is either one of the fixture's memory, which lives on, or one that
        // the SPUs must refuse without using it, which is what is tested.
        unsafe { self.engine.submit(frame, &mut |_| ()) }.map(|_| ())
    }

    fn refused(&mut self, frame: &Frame) -> work::Refusal {
        match self.submit(frame) {
            Err(EngineError::Refused { refusal, .. }) => refusal,
            Ok(()) => panic!("accepted {frame:?}"),
            Err(error) => panic!("{error}"),
        }
    }
}

#[test]
fn every_wrong_field_is_refused_by_name_and_the_next_frame_is_traced() {
    let cases: [(&str, &str, Spoil); 25] = [
        ("magic", "0x43524119", |frame| {
            frame.magic = (0x4352_4159_u32 ^ 0x40).into()
        }),
        ("version", "2 (0x2)", |frame| frame.version = 2.into()),
        ("size", "256 (0x100)", |frame| frame.size = 256.into()),
        ("features", "2147483649", |frame| {
            frame.features = 0x8000_0001_u32.into()
        }),
        ("spus", "0 (0x0)", |frame| frame.spus = 0.into()),
        ("spus", "17 (0x11)", |frame| frame.spus = 17.into()),
        ("spus", "1 (0x1)", |frame| frame.spus = 1.into()),
        ("split", "2 (0x2)", |frame| frame.split = 2.into()),
        ("width", "0 (0x0)", |frame| frame.width = 0.into()),
        ("width", "8193 (0x2001)", |frame| frame.width = 8193.into()),
        ("height", "0 (0x0)", |frame| frame.height = 0.into()),
        ("height", "4294967295", |frame| {
            frame.height = u32::MAX.into()
        }),
        ("stride", "260 (0x104)", |frame| frame.stride = 260.into()),
        ("stride", "240 (0xf0)", |frame| frame.stride = 240.into()),
        ("stride", "65536 (0x10000)", |frame| {
            frame.stride = 65536.into()
        }),
        ("framebuffer", "8)", |frame| {
            frame.framebuffer = (frame.framebuffer.get() + 8).into()
        }),
        ("spheres", "", |frame| {
            frame.spheres = (frame.spheres.get() + 64).into()
        }),
        ("tile_counter", "", |frame| {
            frame.tile_counter = (frame.tile_counter.get() + 4).into()
        }),
        ("statistics", "", |frame| {
            frame.statistics = (frame.statistics.get() + 16).into()
        }),
        ("sphere_count", "2049 (0x801)", |frame| {
            frame.sphere_count = 2049.into()
        }),
        ("sphere_count", "1073741824", |frame| {
            frame.sphere_count = 0x4000_0000.into()
        }),
        ("sphere_count", "13 (0xd)", |frame| {
            frame.features = 0.into()
        }),
        ("red_shift", "25 (0x19)", |frame| {
            frame.red_shift = 25.into()
        }),
        ("green_shift", "25 (0x19)", |frame| {
            frame.green_shift = 25.into()
        }),
        ("blue_shift", "4294967295", |frame| {
            frame.blue_shift = u32::MAX.into()
        }),
    ];
    let mut fixture = fixture(2);
    let good = fixture.frame;
    for (field, value, spoil) in cases {
        let mut frame = good;
        spoil(&mut frame);
        let refusal = fixture.refused(&frame);
        let text = refusal.to_string();
        assert!(
            refusal.field.split(", ").any(|name| name == field),
            "{field}: {text}"
        );
        assert!(text.contains(value), "{field}: {text}");
        fixture
            .submit(&good)
            .unwrap_or_else(|error| panic!("after {field}: {error}"));
    }
}

#[test]
fn a_descriptor_at_an_odd_address_is_refused() {
    let mut fixture = fixture(1);
    let frame = fixture.frame;
    for address in [0x1_0000_0040_u64, 0x1001, 0x7f] {
        // SAFETY: the SPU must refuse the address without using it, which is what is tested.
        let error = unsafe { fixture.engine.mail(address, &frame, &mut |_| ()) }.unwrap_err();
        let EngineError::Refused { refusal, .. } = &error else {
            panic!("{error}")
        };
        assert_eq!(refusal.field, "address");
        assert!(
            error.to_string().contains(&format!("{address:#x}")),
            "{error}"
        );
    }
    fixture.submit(&frame).unwrap();
}

#[test]
fn slices_that_make_no_sense_stay_within_the_picture() {
    let mut fixture = fixture(2);
    let mut frame = fixture.frame;
    for slices in [[U32::new(u32::MAX); 17], [U32::ZERO; 17]] {
        frame.slices = slices;
        fixture.submit(&frame).unwrap();
    }
}

#[test]
fn a_frame_whose_memory_is_not_there_is_a_dma_error() {
    let spoils: [(&str, Spoil); 3] = [
        ("framebuffer", |frame| frame.framebuffer = 0x1000.into()),
        ("spheres", |frame| frame.spheres = 0x1000.into()),
        ("statistics", |frame| frame.statistics = 0x1000.into()),
    ];
    for (name, spoil) in spoils {
        let mut fixture = fixture(2);
        let mut frame = fixture.frame;
        spoil(&mut frame);
        let error = fixture.submit(&frame).unwrap_err();
        assert!(
            matches!(error, EngineError::Ended { .. }),
            "{name}: {error}"
        );
        let text = error.to_string();
        assert!(
            text.contains("DMA") && text.contains("memory that is not there"),
            "{name}: {text}"
        );
        assert!(
            matches!(fixture.submit(&frame), Err(EngineError::Lost)),
            "{name}"
        );
    }
}
