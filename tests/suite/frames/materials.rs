//! Materials in main memory: the same bytes on any number of SPUs, and an error for every number
//! that no material has.

use std::fmt::Write as _;

use protocol::layout::{MESH_SPHERES, MESH_UPPER, MeshHeader, Object, SIDES_WIDE};

use crate::frames::fixture::{Fixture, Spoil, is_the_same_with_spus};
use crate::prelude::*;

const VIEW: &str = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\n\
                    b 0.3 0.4 0.6\nl 4 6 9 0.9 0.9 0.9\n";

/// 1,500 triangles or spheres with a material each.
fn scene(is_of_spheres: bool) -> scenes::Scene {
    let mut text = VIEW.to_owned();
    for number in 0..1500 {
        let (x, y) = (f64::from(number % 50) * 0.2 - 5.0, f64::from(number / 50) * 0.2 - 3.0);
        let colour = f64::from(number) / 1500.0;
        writeln!(text, "f {colour} 0.5 {} 0.8 0.2 9 0 0", 1.0 - colour).unwrap();
        if is_of_spheres {
            writeln!(text, "s {x} {y} 0 0.15").unwrap();
        } else {
            writeln!(text, "p 3\n{x} {y} 0\n{} {y} 0\n{x} {} 0", x + 0.3, y + 0.3).unwrap();
        }
    }
    scenes::parse(text.as_bytes(), "fills", &scenes::Limits::default()).unwrap()
}

/// The first block of a kind, and its header.
fn first(fixture: &Fixture, kind: u32) -> (usize, MeshHeader) {
    let blocks = 0..fixture.frame.mesh_blocks.get() as usize;
    let header = |block: usize| {
        let mut bytes = [0; size_of::<MeshHeader>()];
        fixture.mesh.read(block * MESH_BLOCK as usize, &mut bytes);
        MeshHeader::read_from_bytes(&bytes).unwrap()
    };
    let mut found = blocks.map(|block| (block, header(block)));
    let found = found.find(|(_, header)| header.kind.get() == kind);
    found.expect("the scene has blocks of this kind")
}

#[test]
fn picture_is_same_with_any_number_of_spus() {
    for is_of_spheres in [false, true] {
        let scene = scene(is_of_spheres);
        assert!(Fixture::of(&scene, 1).frame.materials.get() != 0);
        is_the_same_with_spus(&scene, [2, 6], 100);
    }
}

#[test]
fn invalid_material_fields_are_refused() {
    let cases: [(&str, &str, Spoil); 5] = [
        ("materials", "a multiple of 128", |frame| {
            frame.materials = (frame.materials.get() + 64).into()
        }),
        ("mesh_material_count", "a multiple of 256", |frame| frame.mesh_material_count = 0.into()),
        ("mesh_material_count", "a multiple of 256", |frame| {
            frame.mesh_material_count = 1500.into()
        }),
        ("mesh_material_count", "up to 65536", |frame| frame.mesh_material_count = 0x1_0100.into()),
        ("mesh", "as the work unit's document has it", |frame| {
            // The blocks have numbers of two bytes.
            frame.features = (frame.features.get() & !protocol::layout::FEATURE_MATERIALS).into();
            frame.mesh_material_count = 1.into();
            frame.mesh_materials = protocol::layout::SCENE_ADDRESS.into();
        }),
    ];
    Fixture::of(&scene(false), 2).refuses(&cases);
}

/// Traces with bytes of a block replaced, and then with the right ones.
fn refused(fixture: &mut Fixture, block: usize, at: usize, bytes: &[u8]) {
    let frame = fixture.frame;
    let at = block * MESH_BLOCK as usize + at;
    let mut good = vec![0; bytes.len()];
    fixture.mesh.read(at, &mut good);
    fixture.mesh.write(at, bytes);
    let outcome = fixture.submit(&frame);
    fixture.mesh.write(at, &good);
    match outcome {
        Err(error @ EngineError::Refused { .. }) => {
            let text = error.to_string();
            let part = format!("refused block {block} of the mesh: ");
            assert!(text.contains(&part), "{text}");
        }
        Err(error) => panic!("{error}"),
        Ok(()) => panic!("the damaged block {block} was traced"),
    }
    fixture.submit(&frame).unwrap();
}

#[test]
fn invalid_material_numbers_are_refused() {
    let mut fixture = Fixture::of(&scene(false), 1);
    assert_eq!(fixture.frame.mesh_material_count.get(), 1536);
    let (leaf, header) = first(&fixture, MESH_LEAF);
    assert!(header.sides.get() & SIDES_WIDE != 0);
    for upper in [6, 7, 0x80, 0xff] {
        let upper = vec![upper; header.triangles.get() as usize];
        refused(&mut fixture, leaf, MESH_UPPER as usize, &upper);
    }

    let mut fixture = Fixture::of(&scene(true), 1);
    let (leaf, header) = first(&fixture, MESH_SPHERES);
    let first = size_of::<MeshHeader>()
        + header.nodes.get() as usize * size_of::<protocol::layout::Boxes>();
    let at = first + std::mem::offset_of!(Object, material);
    for number in [1536, 0x1_0000, u32::MAX] {
        refused(&mut fixture, leaf, at, &number.to_be_bytes());
    }
}

/// The table decides on the colours, and its last records may be any that a number can have.
#[test]
fn records_are_those_of_the_table() {
    let mut fixture = Fixture::of(&scene(false), 2);
    let frame = fixture.frame;
    let expected = fixture.traced();
    let black = vec![0; 1536 * protocol::layout::MATERIAL_STRIDE as usize];
    fixture.materials.write(0, &black);
    fixture.submit(&frame).unwrap();
    let dark = fixture.picture();
    let black = dark.pixels().filter(|pixel| pixel.0 == [0; 3]).count();
    assert!(black * 3 > dark.pixels().len(), "{black} black pixels");
    assert!(dark != expected);
}
