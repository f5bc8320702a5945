//! The SPU's side of the work-unit protocol: what it refuses, and that it continues afterwards.

use crate::frames::fixture::{Fixture, Spoil};
use crate::prelude::*;
use protocol::layout::{BOX_CODE, BOX_CODE_CAPACITY, SCENE_CAPACITY, WorkUnit};
use zerocopy::FromZeros as _;
use zerocopy::big_endian::U32;

const WHITTED: &[u8] = b"\
v
from 0.6 -14.2 3.7
at 0.25 0 1.15
up 0 0 1
angle 31
hither 0.01
resolution 64 32
b 0.4 0.6 0.8
l -26 -36 50
f 0.8 0.7 0.7 0.8 0.2 20 0 1
s 0 1 1.9 1.9
p 4
9 -4 0
9 9 0
-9 9 0
-9 -4 0
p 3
-3 -3 0
-1 -3 0
-2 -3 2
c
3 0 0 1
3 0 2 0
";

fn fixture(spus: u32) -> Fixture {
    Fixture::of(&nff_scene("paper13.nff"), spus)
}

/// A frame of Whitted's model with spheres, parallelograms, triangles and a cone.
fn whitted_fixture(spus: u32) -> Fixture {
    let scene = scenes::parse(WHITTED, "all shapes", &scenes::Limits::default()).unwrap();
    Fixture::of(&scene, spus)
}

#[test]
fn invalid_field_is_named_and_next_frame_is_traced() {
    let cases: [(&str, &str, Spoil); 35] = [
        ("magic", "0x43524119", |frame| frame.magic = (0x4352_4159_u32 ^ 0x40).into()),
        ("version", "1 (0x1)", |frame| frame.version = 1.into()),
        ("size", "256 (0x100)", |frame| frame.size = 256.into()),
        ("features", "2147483649", |frame| frame.features = 0x8000_0001_u32.into()),
        ("spus", "0 (0x0)", |frame| frame.spus = 0.into()),
        ("spus", "17 (0x11)", |frame| frame.spus = 17.into()),
        ("spus", "1 (0x1)", |frame| frame.spus = 1.into()),
        ("split", "2 (0x2)", |frame| frame.split = 2.into()),
        ("width", "0 (0x0)", |frame| frame.width = 0.into()),
        ("width", "8193 (0x2001)", |frame| frame.width = 8193.into()),
        ("height", "0 (0x0)", |frame| frame.height = 0.into()),
        ("height", "4294967295", |frame| frame.height = u32::MAX.into()),
        ("stride", "260 (0x104)", |frame| frame.stride = 260.into()),
        ("stride", "240 (0xf0)", |frame| frame.stride = 240.into()),
        ("stride", "65536 (0x10000)", |frame| frame.stride = 65536.into()),
        ("framebuffer", "8)", |frame| frame.framebuffer = (frame.framebuffer.get() + 8).into()),
        ("spheres", "", |frame| frame.spheres = (frame.spheres.get() + 64).into()),
        ("code", "a multiple of 128", |frame| frame.code = (frame.code.get() + 64).into()),
        ("code_bytes", "at most 19968", |frame| frame.code_bytes = 19984.into()),
        ("code_bytes", "a multiple of 16", |frame| {
            frame.code_bytes = (frame.code_bytes.get() - 4).into()
        }),
        ("unit_counter", "", |frame| frame.unit_counter = (frame.unit_counter.get() + 4).into()),
        ("units", "", |frame| frame.units = (frame.units.get() + 64).into()),
        ("costs", "", |frame| frame.costs = (frame.costs.get() + 8).into()),
        ("unit_count", "3 (0x3)", |frame| frame.unit_count = 3.into()),
        ("unit_count", "4294967295", |frame| frame.unit_count = u32::MAX.into()),
        ("skip", "2 (0x2)", |frame| frame.skip = 2.into()),
        ("statistics", "", |frame| frame.statistics = (frame.statistics.get() + 16).into()),
        ("sphere_count", "2049 (0x801)", |frame| frame.sphere_count = 2049.into()),
        ("sphere_count", "1073741824", |frame| frame.sphere_count = 0x4000_0000.into()),
        ("sphere_count", "13 (0xd)", |frame| frame.features = 0.into()),
        ("red_shift", "8 (0x8)", |frame| frame.red_shift = 8.into()),
        ("green_shift", "4 (0x4)", |frame| frame.green_shift = 4.into()),
        ("red_shift", "25 (0x19)", |frame| frame.red_shift = 25.into()),
        ("green_shift", "25 (0x19)", |frame| frame.green_shift = 25.into()),
        ("blue_shift", "4294967295", |frame| frame.blue_shift = u32::MAX.into()),
    ];
    fixture(2).refuses(&cases);
}

#[test]
fn invalid_whitted_field_is_named() {
    let cases: [(&str, &str, Spoil); 35] = [
        ("scene", "must be a multiple of 128", |frame| {
            frame.scene = (frame.scene.get() + 64).into()
        }),
        ("paths", "must be a multiple of 128", |frame| frame.paths = 64.into()),
        ("changes", "must be a multiple of 16", |frame| frame.changes = 8.into()),
        ("changes", "at most 9 nodes", |frame| frame.change_count = 10.into()),
        ("waiting", "must be a multiple of 128", |frame| {
            frame.waiting = (frame.waiting.get() + 64).into()
        }),
        ("scene_bytes", "must be a multiple of 128 and leave", |frame| {
            frame.scene_bytes = (frame.scene_bytes.get() + 64).into()
        }),
        ("scene_bytes", "leave space", |frame| frame.scene_bytes = (SCENE_CAPACITY + 128).into()),
        ("scene_bytes", "4294967168", |frame| frame.scene_bytes = 0xffff_ff80.into()),
        ("scene_bytes", "4294967295", |frame| frame.scene_bytes = u32::MAX.into()),
        // Three batches of eight packets need 12288 bytes.
        ("ray_depth", "16 (0x10), 8 (0x8): must be a multiple", |frame| {
            frame.ray_depth = 16.into();
            frame.batch = 8.into();
            frame.scene_bytes = (SCENE_CAPACITY - 12288 + 128).into();
        }),
        ("ray_depth", "0 (0x0): must be 1 to 16", |frame| frame.ray_depth = 0.into()),
        ("ray_depth", "17 (0x11): must be 1 to 16", |frame| frame.ray_depth = 17.into()),
        ("ray_depth", "4294967295", |frame| frame.ray_depth = u32::MAX.into()),
        // Sixteen packets need 24576 bytes, and 29696 for their buffers.
        ("scene_bytes", "1 (0x1), 16 (0x10): must be a multiple", |frame| {
            frame.ray_depth = 1.into();
            frame.batch = 16.into();
            frame.scene_bytes = (SCENE_CAPACITY - 29696 + 128).into();
        }),
        ("batch", "0 (0x0): must be 1 to 16, and at most 8 with a mesh", |frame| {
            frame.batch = 0.into()
        }),
        ("batch", "17 (0x11): must be 1 to 16", |frame| frame.batch = 17.into()),
        ("batch", "more than 512 objects", |frame| {
            frame.ray_depth = 1.into();
            frame.batch = 9.into();
            frame.trees[0].objects = 513.into();
        }),
        ("light_count", "65 (0x41): must be at most 64", |frame| frame.light_count = 65.into()),
        ("lights", "on quadwords of the scene", |frame| frame.lights = (SCENE_ADDRESS - 16).into()),
        ("lights", "on quadwords of the scene", |frame| {
            frame.lights = (frame.lights.get() + 8).into()
        }),
        ("lights", "on quadwords of the scene", |frame| {
            frame.lights = (SCENE_ADDRESS + frame.scene_bytes.get() - 16).into()
        }),
        ("light_count", "4294967295", |frame| frame.light_count = u32::MAX.into()),
        ("sphere_count", "1 (0x1)", |frame| frame.sphere_count = 1.into()),
        // The scene is too short for its declared contents.
        ("trees", "lie in the scene", |frame| {
            frame.scene_bytes = 0.into();
            frame.lights = SCENE_ADDRESS.into();
            frame.light_count = 0.into();
        }),
        ("box_trees", "16 (0x10), 896 (0x380): must be bits of the 4 trees", |frame| {
            frame.box_trees = 16.into()
        }),
        ("box_trees", "4294967295", |frame| frame.box_trees = u32::MAX.into()),
        // The scene ends 16 bytes before the end of the code for boxes.
        ("scene_bytes", "the code for boxes", |frame| {
            frame.box_trees = 2.into();
            frame.scene_bytes = (BOX_CODE + BOX_CODE_CAPACITY - SCENE_ADDRESS - 16).into();
        }),
        ("trees", "1024 objects", |frame| frame.trees[0].objects = 1025.into()),
        ("trees", "1024 objects", |frame| frame.trees[3].objects = u32::MAX.into()),
        ("trees", "at most 4 nodes at the top", |frame| frame.trees[1].root_count = 0.into()),
        ("trees", "at most 4 nodes at the top", |frame| frame.trees[2].root_count = 5.into()),
        ("trees", "6 levels", |frame| frame.trees[0].levels = 7.into()),
        ("trees", "lie in the scene", |frame| frame.trees[1].roots = (SCENE_ADDRESS - 128).into()),
        ("trees", "lie in the scene", |frame| {
            frame.trees[2].roots = (SCENE_ADDRESS + frame.scene_bytes.get()).into()
        }),
        ("trees", "lie in the scene", |frame| {
            frame.trees[3].roots = (frame.trees[3].roots.get() + 8).into()
        }),
    ];
    whitted_fixture(2).refuses(&cases);
}

#[test]
fn maximum_values_of_whitteds_model_are_traced() {
    let mut fixture = whitted_fixture(1);
    let good = fixture.frame;
    let most: [Spoil; 5] = [
        |frame| {
            frame.ray_depth = 16.into();
            frame.batch = 1.into();
        },
        |frame| {
            frame.ray_depth = 1.into();
            frame.batch = 8.into();
        },
        |frame| {
            frame.ray_depth = 1.into();
            frame.batch = 16.into();
            frame.scene_bytes = (SCENE_CAPACITY - 29696).into();
        },
        |frame| frame.light_count = 0.into(),
        // A tree without objects is not checked.
        |frame| {
            frame.trees[0].objects = 0.into();
            frame.trees[0].roots = u32::MAX.into();
        },
    ];
    for change in most {
        let mut frame = good;
        change(&mut frame);
        fixture.submit(&frame).unwrap();
    }
}

#[test]
fn descriptor_at_odd_address_is_refused() {
    let mut fixture = fixture(1);
    let frame = fixture.frame;
    for address in [0x1_0000_0040_u64, 0x1001, 0x7f] {
        // SAFETY: the SPU must refuse the address without using it. The test checks that it does.
        let error = unsafe { fixture.engine.mail(address, &frame, &mut |_| ()) }.unwrap_err();
        let EngineError::Refused { refusal, .. } = &error else { panic!("{error}") };
        assert_eq!(refusal.field, "address");
        assert!(error.to_string().contains(&format!("{address:#x}")), "{error}");
    }
    fixture.submit(&frame).unwrap();
}

#[test]
fn invalid_work_unit_is_refused() {
    let mut fixture = fixture(1);
    let frame = fixture.frame;
    let mut good = WorkUnit::new_zeroed();
    fixture.units.read(0, good.as_mut_bytes());
    let spoils: [fn(&mut WorkUnit); 5] = [
        |unit| unit.count = 0.into(),
        |unit| unit.count = 32.into(),
        |unit| unit.count = u32::MAX.into(),
        |unit| unit.tiles[0] = 2.into(),
        |unit| unit.tiles[0] = u32::MAX.into(),
    ];
    for spoil in spoils {
        let mut unit = good;
        spoil(&mut unit);
        fixture.units.write(0, unit.as_bytes());
        let refusal = fixture.refused(&frame);
        assert_eq!(refusal.field, "tiles");
        assert_eq!(
            refusal.to_string(),
            "refused the work units: tiles: a unit's tiles must be 1 to 31, each within the picture"
        );
        fixture.units.write(0, good.as_bytes());
        fixture.submit(&frame).unwrap();
    }
}

#[test]
fn invalid_slices_stay_within_the_picture() {
    let mut fixture = fixture(2);
    let mut frame = fixture.frame;
    for slices in [[U32::new(u32::MAX); 17], [U32::ZERO; 17]] {
        frame.slices = slices;
        fixture.submit(&frame).unwrap();
    }
}

#[test]
fn unmapped_frame_memory_is_a_dma_error() {
    let spoils: [(&str, Spoil); 5] = [
        ("framebuffer", |frame| frame.framebuffer = 0x1000.into()),
        ("spheres", |frame| frame.spheres = 0x1000.into()),
        ("statistics", |frame| frame.statistics = 0x1000.into()),
        ("units", |frame| frame.units = 0x1000.into()),
        ("costs", |frame| frame.costs = 0x1000.into()),
    ];
    let plain = spoils.into_iter().map(|(name, spoil)| (name, spoil, fixture(2)));
    let scene: Spoil = |frame| frame.scene = 0x1000.into();
    let whitted = std::iter::once(("scene", scene, whitted_fixture(2)));
    for (name, spoil, mut fixture) in plain.chain(whitted) {
        let mut frame = fixture.frame;
        spoil(&mut frame);
        let error = fixture.submit(&frame).unwrap_err();
        assert!(matches!(error, EngineError::Ended { .. }), "{name}: {error}");
        let text = error.to_string();
        assert!(text.contains("DMA") && text.contains("unmapped memory"), "{name}: {text}");
        assert!(matches!(fixture.submit(&frame), Err(EngineError::Lost)), "{name}");
    }
}
