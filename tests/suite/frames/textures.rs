//! Textures in main memory: the same bytes on any number of SPUs, and an error for every record
//! that is not as it should be.

use protocol::layout::{EYE_CODE_CAPACITY, Material, TEXTURE_CODE, WRAP_BITS};
use scenes::{Texture, Wrap};

use crate::frames::fixture::{Fixture, Spoil, is_the_same_with_spus};
use crate::prelude::*;

/// Words of a texture's and a level's record.
const WRAPS: usize = 3;
const LAST: usize = 1;
const ACROSS: usize = 2;
const FIRST: usize = 3;

/// A floor of 18 triangles with a texture of numbers, repeated, and a wall with another one.
fn scene() -> scenes::Scene {
    let text = "v\nfrom 1 2.5 6\nat 0 -0.1 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\n\
        b 0.3 0.4 0.6\nl 4 6 3 0.9 0.9 0.9\n\
        f 0.9 0.9 0.9 0.7 0.3 30 0 1\nf 1 1 1 1 0 0 0 1\nf 0.3 0.9 0.2 1 0 0 0 1\n";
    let mut scene = scenes::parse(text.as_bytes(), "floor", &scenes::Limits::default()).unwrap();
    let mut random = ChaCha8Rng::seed_from_u64(3);
    let mut texture = |width: u32, height: u32, wrap: [Wrap; 2]| {
        let texels = (0..width * height).map(|_| random.random());
        Texture::new(width, texels.collect(), wrap).map(Arc::new)
    };
    scene.materials[0].texture = texture(50, 30, [Wrap::Repeat, Wrap::Mirror]);
    scene.materials[1].texture = texture(17, 40, [Wrap::Clamp, Wrap::Repeat]);
    let mut mesh = scenes::Mesh { two_sided: true, ..scenes::Mesh::default() };
    let at = |row: u32, column: u32| row * 4 + column;
    for (row, column) in (0..8).flat_map(|row| (0..4).map(move |column| (row, column))) {
        let (x, z) = (f64::from(column) - 1.5, f64::from(row % 4) - 1.5);
        let point =
            if row < 4 { [2.0 * x, -1.0, -2.0 * z] } else { [2.0 * x, 0.7 * z + 1.0, -3.0] };
        mesh.positions.push(point.map(|it| it as f32));
        mesh.texture_coordinates.push([1.3 * x, 0.9 * z].map(|it| it as f32));
    }
    for (row, column) in (0..7).flat_map(|row| (0..3).map(move |column| (row, column))) {
        if row == 3 {
            continue;
        }
        let (a, b) = (at(row, column), at(row, column + 1));
        let (c, d) = (at(row + 1, column), at(row + 1, column + 1));
        mesh.triangles.extend([[a, b, d], [a, d, c]]);
        let material = if row == 5 { 2 } else { u32::from(row > 3) };
        mesh.materials.extend([material; 2]);
    }
    scene.mesh = Some(Arc::new(mesh));
    scene
}

#[test]
fn picture_is_same_with_any_number_of_spus() {
    is_the_same_with_spus(&scene(), 2..=6, 300);
}

#[test]
fn invalid_texture_fields_are_refused() {
    let cases: [(&str, &str, Spoil); 15] = [
        ("texture_code", "a multiple of 128", |frame| {
            frame.texture_code = (frame.texture_code.get() + 64).into()
        }),
        ("texture_code_bytes", "at most 4096", |frame| frame.texture_code_bytes = 4112.into()),
        ("texture_code_bytes", "a multiple of 16", |frame| {
            frame.texture_code_bytes = (frame.texture_code_bytes.get() - 4).into()
        }),
        ("textures", "a multiple of 128", |frame| {
            frame.textures = (frame.textures.get() + 16).into()
        }),
        ("texture_tiles", "1 to 2^20 tiles", |frame| frame.texture_tiles = 0.into()),
        ("texture_tiles", "1 to 2^20 tiles", |frame| frame.texture_tiles = 0x10_0001.into()),
        ("texture_count", "1 to 256 textures", |frame| frame.texture_count = 0.into()),
        ("texture_count", "1 to 256 textures", |frame| frame.texture_count = 257.into()),
        ("texture_level_count", "up to 1024 levels", |frame| frame.texture_level_count = 0.into()),
        ("texture_level_count", "of the scene", |frame| frame.texture_level_count = 1024.into()),
        ("texture_records", "on quadwords", |frame| {
            frame.texture_records = (frame.texture_records.get() + 4).into()
        }),
        ("texture_records", "of the scene", |frame| {
            frame.texture_records = (SCENE_ADDRESS - 16).into()
        }),
        ("texture_records", "among its tiles", |frame| frame.texture_tiles = 1.into()),
        ("texture_records", "one of the textures", |frame| {
            frame.texture_records = (frame.texture_records.get() + 16).into()
        }),
        ("mesh_cache", "before the code", |frame| {
            frame.mesh_cache = (TEXTURE_CODE - 3 * MESH_BLOCK).into();
            frame.mesh_slots = 4.into();
        }),
    ];
    Fixture::of(&scene(), 2).refuses(&cases);
}

#[test]
fn scene_without_memory_for_tiles_is_refused() {
    let leaves: Spoil = |frame: &mut Frame| {
        // Whole lines up to the tiles, without space for the queued rays.
        frame.scene_bytes = (TEXTURE_CODE - SCENE_ADDRESS).into();
    };
    Fixture::of(&scene(), 1).refuses(&[("scene_bytes", "leave space", leaves)]);
}

/// The records of textures in the scene's block.
struct Records {
    fixture: Fixture,
}

impl Records {
    fn get(&self, at: usize) -> u32 {
        let mut word = [0; 4];
        self.fixture.scene.read(at, &mut word);
        u32::from_be_bytes(word)
    }

    fn traced_with(&mut self, at: usize, value: u32) -> Result<RgbImage, EngineError> {
        let good = self.get(at);
        self.fixture.scene.write(at, &value.to_be_bytes());
        let frame = self.fixture.frame;
        let outcome = self.fixture.submit(&frame);
        self.fixture.scene.write(at, &good.to_be_bytes());
        outcome.map(|()| self.fixture.picture())
    }
}

#[test]
fn invalid_texture_records_are_refused() {
    let fixture = Fixture::of(&scene(), 2);
    let frame = fixture.frame;
    let mut records = Records { fixture };
    let table = (frame.texture_records.get() - SCENE_ADDRESS) as usize;
    let levels = table + 16 * frame.texture_count.get() as usize;
    let material = (frame.mesh_materials.get() - SCENE_ADDRESS) as usize
        + std::mem::offset_of!(Material, texture);
    let (address, tiles) = (records.get(table), frame.texture_tiles.get());
    let count = frame.texture_level_count.get();
    let texture = |word: usize| table + 4 * word;
    let level = |word: usize| levels + 4 * word;
    let cases = [
        ("levels before the first", texture(0), address - 16),
        ("levels between records", texture(0), address + 4),
        ("levels after the last", texture(0), address + 16 * count),
        ("levels anywhere", texture(0), u32::MAX),
        ("too many levels", texture(LAST), count),
        ("levels without number", texture(LAST), u32::MAX),
        ("tiles of a texture after the last", texture(WRAPS), tiles << WRAP_BITS),
        ("no width", level(0), 0),
        ("a negative width", level(0), (-50.0_f32).to_bits()),
        ("a large width", level(0), 4097.0_f32.to_bits()),
        ("another width", level(0), 60.0_f32.to_bits()),
        ("no height", level(1), 0),
        ("a large height", level(1), 1e30_f32.to_bits()),
        ("other tiles across", level(ACROSS), 3),
        ("tiles after the last", level(FIRST), tiles),
        ("some tiles after the last", level(FIRST), tiles - 8),
        ("tiles without number", level(FIRST), u32::MAX),
        ("a material's texture between records", material, records.get(material) + 4),
        ("a material's texture after the last", material, address),
        ("a material's texture anywhere", material, 16),
    ];
    for (what, at, value) in cases {
        match records.traced_with(at, value) {
            Err(error @ EngineError::Refused { .. }) => {
                let text = error.to_string();
                assert!(
                    text.contains("a material must have one of the textures"),
                    "{what}: {text}"
                );
            }
            Err(error) => panic!("{what}: {error}"),
            Ok(_) => panic!("{what} was traced"),
        }
        let frame = records.fixture.frame;
        records.fixture.submit(&frame).unwrap();
    }
    let without = records.traced_with(material, 0).unwrap();
    let frame = records.fixture.frame;
    records.fixture.submit(&frame).unwrap();
    assert!(without != records.fixture.picture(), "a material without its texture");
}

/// Blocks may have texture coordinates only in frames with textures, and must have space for them.
#[test]
fn blocks_with_texture_coordinates() {
    let mut fixture = Fixture::of(&scene(), 1);
    let frame = fixture.frame;
    let mut word = [0; 4];
    // The only blocks with triangles are leaves; the last one has the texture coordinates.
    let leaf = (0..frame.mesh_blocks.get() as usize)
        .filter(|block| {
            fixture.mesh.read(block * MESH_BLOCK as usize + 8, &mut word);
            u32::from_be_bytes(word) == MESH_LEAF
        })
        .last()
        .unwrap();
    let at = leaf * MESH_BLOCK as usize;
    fixture.mesh.read(at + 28, &mut word);
    let sides = u32::from_be_bytes(word);
    assert!(sides & protocol::layout::SIDES_TEXTURED != 0);
    let mut plain = frame;
    plain.features = (frame.features.get() & !protocol::layout::FEATURE_TEXTURES).into();
    // Such a frame has the code for eye rays, which is in front of the rest.
    plain.code = (frame.code.get() - u64::from(EYE_CODE_CAPACITY)).into();
    plain.code_bytes = (frame.code_bytes.get() + EYE_CODE_CAPACITY).into();
    let refused = fixture.refused(&plain).to_string();
    assert!(refused.contains(&format!("block {leaf} of the mesh")), "{refused}");
    fixture.mesh.read(at + 24, &mut word);
    let vertices = u32::from_be_bytes(word);
    // The block holds 80 vertices without their coordinates only.
    fixture.mesh.write(at + 24, &80_u32.to_be_bytes());
    let refused = fixture.refused(&frame).to_string();
    assert!(refused.contains(&format!("block {leaf} of the mesh")), "{refused}");
    fixture.mesh.write(at + 24, &vertices.to_be_bytes());
    fixture.submit(&frame).unwrap();
}
