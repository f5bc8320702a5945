//! Every fault gives an error that names the file, the lump and the value.

use levels::{Graphics, Level, Map, Name, Plan, Wad};

use crate::maker::{Lump, file, lumps};

/// The error of a file, as its user sees it.
fn error(bytes: Vec<u8>) -> String {
    let read = || {
        let wad = Wad::parse("made.wad", bytes)?;
        let map = Map::read(&wad, Name::new("E1M1"))?;
        Level::build(&map, &Plan::of(&map), &Graphics::read(&wad)?)
    };
    read().map_or_else(|error| error.to_string(), |_| "none".to_owned())
}

/// The error of the file in which one lump is another one.
fn with(lump: &str, change: impl Fn(&mut Vec<u8>)) -> String {
    let mut all = lumps();
    let bytes = all.iter_mut().find(|(name, _)| *name == lump).map(|(_, bytes)| bytes);
    change(bytes.unwrap());
    error(file(&all))
}

/// Puts a word of 16 bits into a lump.
fn word(at: usize, value: u16) -> impl Fn(&mut Vec<u8>) {
    move |bytes| bytes[at..at + 2].copy_from_slice(&value.to_le_bytes())
}

fn without(lump: &str) -> String {
    error(file(&lumps().into_iter().filter(|(name, _)| *name != lump).collect::<Vec<Lump>>()))
}

#[test]
fn file_without_fault_is_read() {
    assert_eq!(error(file(&lumps())), "none");
}

#[test]
fn damaged_files_are_named() {
    assert_eq!(
        error(b"PNG".to_vec()),
        "made.wad: this is no WAD file: it begins with \"PNG\" instead of IWAD or PWAD"
    );
    let whole = file(&lumps());
    let size = whole.len();
    let start = size - 16 * lumps().len();
    assert_eq!(
        error(whole[..size - 1].to_vec()),
        format!(
            "made.wad: the directory has 19 lumps from byte {start} on, but the file has only {} bytes",
            size - 1
        )
    );
    let patched = |at: usize, value: u32| {
        let mut bytes = whole.clone();
        bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
        error(bytes)
    };
    for (at, value) in [(4, u32::MAX), (8, u32::MAX)] {
        let text = patched(at, value);
        assert!(text.contains("4294967295") && text.contains("directory"), "{text}");
    }
    assert_eq!(
        patched(start + 4, u32::MAX),
        format!(
            "made.wad: lump 0, PLAYPAL, has 4294967295 bytes from byte 12 on, but the file has only {size} bytes"
        )
    );
}

#[test]
fn damaged_maps_are_named() {
    let wrong = |lump: &str, change: &dyn Fn(&mut Vec<u8>), what: &str| {
        assert_eq!(with(lump, change), format!("made.wad: lump E1M1 {lump}: {what}"));
    };
    let shorter = |bytes: &mut Vec<u8>| {
        bytes.pop();
    };
    wrong("LINEDEFS", &shorter, "139 bytes are no whole number of records of 14");
    wrong("VERTEXES", &shorter, "31 bytes are no whole number of records of 4");
    wrong("LINEDEFS", &|bytes| bytes.clear(), "the map has no line");
    wrong("LINEDEFS", &word(14, 77), "line 1 has vertex 77 of 8");
    wrong("LINEDEFS", &word(14 + 10, 700), "line 1 has side 700 of 7");
    wrong("LINEDEFS", &word(14 + 10, 0xffff), "line 1 has no front side");
    wrong("SIDEDEFS", &word(28, 3), "side 0 has sector 3 of 3");
    assert_eq!(without("SECTORS"), "made.wad: lump E1M1 SECTORS: it is missing");
    assert_eq!(without("E1M1"), "made.wad: there is no map E1M1; the file has S_END");
    let mut other = lumps();
    other.push(("BEHAVIOR", vec![0]));
    assert_eq!(
        error(file(&other)),
        "made.wad: map E1M1 is in Hexen's format, which is not read; only Doom's own format is"
    );
}

#[test]
fn damaged_pictures_are_named() {
    let thing = |change: &dyn Fn(&mut Vec<u8>)| with("COLUA0", change);
    assert_eq!(
        thing(&|bytes| bytes.truncate(9)),
        "made.wad: lump COLUA0: 9 bytes are too few for a patch"
    );
    assert_eq!(
        thing(&word(2, 0)),
        "made.wad: lump COLUA0: 1 by 0 texels; each must be from 1 to 4096"
    );
    assert_eq!(
        with("PLAYPAL", |bytes| bytes.truncate(9)),
        "made.wad: lump PLAYPAL: 9 bytes are less than the 768 of a palette"
    );
    assert_eq!(
        with("PNAMES", word(2, 9)),
        "made.wad: lump PNAMES: 12 bytes are too few for its list of names"
    );
    let size = lumps()[2].1.len();
    assert_eq!(
        with("TEXTURE1", word(4, 900)),
        format!("made.wad: lump TEXTURE1: texture 0 at byte 900 is not within {size} bytes")
    );
    assert_eq!(
        with("TEXTURE1", word(24, 0)),
        "made.wad: lump TEXTURE1: texture STONE has 0 by 4 texels; each must be from 1 to 4096"
    );
    assert_eq!(
        with("TEXTURE1", word(12 + 22 + 4, 5)),
        "made.wad: lump PNAMES: texture STONE has patch 5 of 1"
    );
    assert_eq!(
        with("PATCH", word(8, 99)),
        "made.wad: lump PATCH: column 0 at byte 99 is not within 20 bytes"
    );
    assert_eq!(
        with("FLOOR", |bytes| bytes.truncate(64)),
        "made.wad: lump FLOOR: 64 bytes are less than the 4096 of a flat"
    );
}
