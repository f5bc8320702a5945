//! Records of height fields: the same bytes on any number of SPUs, and an error for what is not as
//! it should be.

use std::ptr::with_exposed_provenance;

use protocol::layout::{FEATURE_CUTS, HEIGHT_CODE, HEIGHT_LEVELS, Heights};

use crate::frames::fixture::{Fixture, Spoil, is_the_same_with_spus};
use crate::prelude::*;

/// Ground of 64 by 64 squares.
fn scene() -> scenes::Scene {
    let text = "v\nfrom 0 9 30\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\n\
        b 0.3 0.4 0.6\nl 40 60 30 0.9 0.9 0.9\nf 1 1 1 1 0 1 0 1\n";
    let mut scene = scenes::parse(text.as_bytes(), "ground", &scenes::Limits::default()).unwrap();
    let heights = (0..65 * 65).map(|at| ((at % 65 * 7) ^ (at / 65 * 13)) as u16).collect();
    let colours = (0..65 * 65).map(|at| [at as u8, (at / 65) as u8, 99]).collect();
    let field = scenes::HeightField::new([65, 65], heights, colours, 1.0, 0.005).unwrap();
    scene.heights = Some(Arc::new(field));
    scene
}

#[test]
fn picture_is_same_with_any_number_of_spus() {
    is_the_same_with_spus(&scene(), [2, 5], 100);
}

#[test]
fn invalid_height_fields_are_refused() {
    let cases: [(&str, &str, Spoil); 5] = [
        ("heights", "heights", |frame| frame.heights = (frame.heights.get() + 64).into()),
        ("colour_code", "a multiple of 128", |frame| {
            frame.colour_code = (frame.colour_code.get() + 64).into()
        }),
        ("mesh_cache", "before the code", |frame| {
            frame.mesh_cache = (HEIGHT_CODE - 3 * MESH_BLOCK).into();
            frame.mesh_slots = 4.into();
        }),
        ("cut_fours", "1 to 48", |frame| {
            frame.features = (frame.features.get() | FEATURE_CUTS).into();
            frame.cut_fours = 49.into();
        }),
        ("cut_code", "a multiple of 128", |frame| {
            frame.features = (frame.features.get() | FEATURE_CUTS).into();
            frame.cut_fours = 1.into();
            frame.cut_code = (frame.cut_code.get() + 64).into();
        }),
    ];
    Fixture::of(&scene(), 2).refuses(&cases);
}

/// Changes a record to a wrong one.
type SpoilRecord = fn(&mut Heights);

#[test]
fn damaged_records_are_refused() {
    let cases: [(&str, &str, SpoilRecord); 7] = [
        ("no level", "heights", |record| record.levels = 0.into()),
        ("too many levels", "heights", |record| record.levels = (HEIGHT_LEVELS + 1).into()),
        ("one block too few", "block", |record| record.blocks = 1.into()),
        ("no inner block", "block", |record| record.tree_blocks = 0.into()),
        ("other inner blocks", "block", |record| {
            record.tree = (record.tree.get() + u64::from(MESH_BLOCK)).into()
        }),
        ("fewer columns", "block", |record| record.levels_of[0].across = 0.into()),
        ("fewer rows", "block", |record| record.levels_of[0].down = 0.into()),
    ];
    let mut fixture = Fixture::of(&scene(), 2);
    let good = fixture.frame;
    // SAFETY: the fixture keeps the scene, whose record this is, and nothing changes it.
    let record = unsafe {
        with_exposed_provenance::<[u8; size_of::<Heights>()]>(good.heights.get() as usize).read()
    };
    for (what, part, spoil) in cases {
        let mut record: Heights = zerocopy::transmute!(record);
        spoil(&mut record);
        let mut memory = SharedMemory::new(size_of::<Heights>());
        memory.write(0, record.as_bytes());
        let mut frame = good;
        frame.heights = memory.address().into();
        let refusal = fixture.refused(&frame).to_string();
        assert!(refusal.contains(part), "{what}: {refusal}");
        fixture.submit(&good).unwrap_or_else(|error| panic!("after {what}: {error}"));
    }
}
