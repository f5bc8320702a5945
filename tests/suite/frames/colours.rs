//! Colours of vertices in main memory: the same bytes on any number of SPUs, and an error for what
//! is not as it should be.

use protocol::layout::{COLOUR_CODE, FEATURE_COLOURS, MeshHeader, SIDES_COLOURED};

use crate::frames::fixture::{Fixture, Spoil, is_the_same_with_spus};
use crate::prelude::*;

/// A sheet of 800 triangles, each vertex of another colour.
fn scene() -> scenes::Scene {
    let text = "v\nfrom 0 1 6\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\n\
        b 0.3 0.4 0.6\nl 4 6 3 0.9 0.9 0.9\nf 1 1 1 0.8 0.2 30 0 1\n";
    let mut scene = scenes::parse(text.as_bytes(), "sheet", &scenes::Limits::default()).unwrap();
    let mut mesh = scenes::Mesh { two_sided: true, ..scenes::Mesh::default() };
    for (row, column) in (0..=20_u16).flat_map(|row| (0..=20_u16).map(move |column| (row, column)))
    {
        let [x, y] = [column, row].map(|it| f32::from(it) * 0.2 - 2.0);
        mesh.positions.push([x, y, 0.2 * x * y]);
        mesh.colours.push([row % 3, column % 4, (row + column) % 5].map(|it| f32::from(it) / 4.0));
    }
    for (row, column) in (0..20).flat_map(|row| (0..20).map(move |column| (row, column))) {
        let [a, b, c, d] = [0, 1, 21, 22].map(|corner| row * 21 + column + corner);
        mesh.triangles.extend([[a, b, d], [a, d, c]]);
        mesh.materials.extend([0, 0]);
    }
    scene.mesh = Some(Arc::new(mesh));
    scene
}

#[test]
fn picture_is_same_with_any_number_of_spus() {
    is_the_same_with_spus(&scene(), [2, 5], 200);
}

#[test]
fn invalid_colour_fields_are_refused() {
    let cases: [(&str, &str, Spoil); 2] = [
        ("colour_code", "a multiple of 128", |frame| {
            frame.colour_code = (frame.colour_code.get() + 64).into()
        }),
        ("mesh_cache", "before the code", |frame| {
            frame.mesh_cache = (COLOUR_CODE - 3 * MESH_BLOCK).into();
            frame.mesh_slots = 4.into();
        }),
    ];
    Fixture::of(&scene(), 2).refuses(&cases);
}

/// Blocks may have colours only in frames with colours.
#[test]
fn blocks_with_colours() {
    let mut fixture = Fixture::of(&scene(), 1);
    let mut frame = fixture.frame;
    assert!(frame.features.get() & FEATURE_COLOURS != 0);
    let header = |fixture: &Fixture, block: usize| {
        let mut bytes = [0; size_of::<MeshHeader>()];
        fixture.mesh.read(block * MESH_BLOCK as usize, &mut bytes);
        MeshHeader::read_from_bytes(&bytes).unwrap()
    };
    let blocks = 0..frame.mesh_blocks.get() as usize;
    let coloured =
        blocks.filter(|&block| header(&fixture, block).sides.get() & SIDES_COLOURED != 0);
    assert!(coloured.count() > 5);
    frame.features = (frame.features.get() & !FEATURE_COLOURS).into();
    let refused = fixture.refused(&frame).to_string();
    assert!(refused.contains("of the mesh"), "{refused}");
    let good = fixture.frame;
    fixture.submit(&good).unwrap();
}
