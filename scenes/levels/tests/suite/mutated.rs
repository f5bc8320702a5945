//! Files in which some bytes are others: reading ends, with a level or with an error.

use levels::{Graphics, Level, Map, Name, Plan, Wad};
use randomness::{Random, rounds};

use crate::maker::{file, lumps};

/// Reads a file, and checks what the level promises.
fn read(bytes: Vec<u8>) -> Result<(), levels::Error> {
    let wad = Wad::parse("made.wad", bytes)?;
    let map = Map::read(&wad, Name::new("E1M1"))?;
    let plan = Plan::of(&map);
    assert_eq!(plan.pieces.len(), map.lines.len());
    let level = Level::build(&map, &plan, &Graphics::read(&wad)?)?;
    for part in &level.parts {
        let mesh = &part.mesh;
        let vertices = mesh.positions.len();
        assert!(mesh.triangles.iter().flatten().all(|vertex| (*vertex as usize) < vertices));
        let materials = level.materials.len();
        assert!(mesh.materials.iter().all(|material| (*material as usize) < materials));
        assert_eq!(mesh.triangles.len(), mesh.materials.len());
        assert!(mesh.positions.iter().flatten().all(|number| number.is_finite()));
        assert!(mesh.texture_coordinates.iter().flatten().all(|number| number.is_finite()));
        assert!(mesh.colours.iter().flatten().all(|channel| (0.0..=1.0).contains(channel)));
    }
    Ok(())
}

#[test]
fn reading_of_damaged_files_ends() {
    let mut random = Random::new("damaged WAD files");
    let whole = file(&lumps());
    let mut outcomes = [0, 0];
    for _ in 0..rounds(3000) {
        let mut bytes = whole.clone();
        for _ in 0..=random.below(4) {
            // Most bytes are those of the flat, which can't be wrong.
            let at = loop {
                let at = random.below(bytes.len() as u64) as usize;
                if bytes[at] != 7 || random.below(50) == 0 {
                    break at;
                }
            };
            bytes[at] = match random.below(4) {
                0 => 0,
                1 => u8::MAX,
                2 => bytes[at] ^ 1 << random.below(8),
                _ => random.bits() as u8,
            };
        }
        if random.below(8) == 0 {
            bytes.truncate(random.below(bytes.len() as u64) as usize);
        }
        match read(bytes) {
            Ok(()) => outcomes[0] += 1,
            Err(error) => {
                assert!(error.to_string().starts_with("made.wad: "), "{error}");
                outcomes[1] += 1;
            }
        }
    }
    assert!(outcomes.iter().all(|count| *count > 50), "{outcomes:?}");
}

/// Lines between any vertices cross one another, and sectors are not closed.
#[test]
fn maps_of_any_lines_are_read() {
    let mut random = Random::new("maps of any lines");
    for _ in 0..rounds(40) {
        let mut all = lumps();
        let vertices = 3 + random.below(60);
        let extent = [8, 300, 65_536][random.below(3) as usize];
        for (name, bytes) in &mut all {
            match *name {
                "VERTEXES" => {
                    let word = |_| (random.below(extent) as u16).to_le_bytes();
                    *bytes = (0..2 * vertices).flat_map(word).collect();
                }
                "LINEDEFS" => {
                    *bytes = (0..random.below(200) + 1)
                        .flat_map(|_| {
                            let mut vertex = || random.below(vertices) as u16;
                            let (from, to) = (vertex(), vertex());
                            let special = [0, 1, 62, 7, 64][random.below(5) as usize];
                            let back = [0xffff, random.below(7) as u16][random.below(2) as usize];
                            [from, to, 4, special, 0, random.below(7) as u16, back]
                        })
                        .flat_map(u16::to_le_bytes)
                        .collect();
                }
                _ => {}
            }
        }
        match read(file(&all)) {
            Ok(()) => {}
            Err(error) => assert!(error.to_string().contains("no line"), "{error}"),
        }
    }
}
