//! Makes a WAD file: a hall and a courtyard with a door between them.

use levels::Wad;

/// A lump and its bytes.
pub type Lump = (&'static str, Vec<u8>);

fn words(values: &[i32]) -> Vec<u8> {
    values.iter().flat_map(|value| (*value as i16).to_le_bytes()).collect()
}

fn name(text: &str) -> [u8; 8] {
    std::array::from_fn(|at| text.as_bytes().get(at).copied().unwrap_or(0))
}

fn thing([x, y]: [i32; 2], kind: i32) -> Vec<u8> {
    words(&[x, y, 90, kind, 7])
}

fn line(ends: [i32; 2], special: i32, tag: i32, sides: [i32; 2]) -> Vec<u8> {
    let flags = if sides[1] < 0 { 1 } else { 4 };
    words(&[ends[0], ends[1], flags, special, tag, sides[0], sides[1]])
}

fn side(sector: i32, textures: [&str; 3]) -> Vec<u8> {
    let names = textures.map(name).concat();
    [words(&[0, 0]), names, words(&[sector])].concat()
}

fn sector(floor: i32, ceiling: i32, flats: [&str; 2], tag: i32) -> Vec<u8> {
    [words(&[floor, ceiling]), flats.map(name).concat(), words(&[160, 0, tag])].concat()
}

/// A patch of one column, three texels high, with a hole above them.
fn patch() -> Vec<u8> {
    let post = [1, 3, 0, 1, 2, 3, 0, 255];
    [words(&[1, 4, 0, 0]), 12_u32.to_le_bytes().to_vec(), post.to_vec()].concat()
}

/// A list with a texture of 2 by 4 texels without holes, and one with them.
fn textures() -> Vec<u8> {
    let texture = |text: &str, patches: &[[i32; 2]]| {
        let head = [name(text).to_vec(), vec![0; 4], words(&[2, 4]), vec![0; 4]].concat();
        let patches: Vec<u8> =
            patches.iter().flat_map(|[x, y]| words(&[*x, *y, 0, 1, 0])).collect();
        let count = words(&[patches.len() as i32 / 10]);
        [head, count, patches].concat()
    };
    let whole = texture("STONE", &[[0, 0], [1, 0], [0, -1], [1, -1]]);
    let holes = texture("GRATE", &[[0, 0]]);
    let offsets = [2, 12, 12 + whole.len() as u32];
    let offsets: Vec<u8> = offsets.iter().flat_map(|offset| offset.to_le_bytes()).collect();
    [offsets, whole, holes].concat()
}

/// The lumps of the file.
///
/// ```text
///   0--1--2--3     sector 0, the hall; 1, the door; 2, the courtyard
///   |  |  |  |
///   4--5--6--7
/// ```
pub fn lumps() -> Vec<Lump> {
    let plain = side(0, ["-", "-", "STONE"]);
    let vertices: Vec<u8> = [0, 128]
        .into_iter()
        .flat_map(|y| [0, 256, 288, 544].map(|x| words(&[x, 128 - y])).concat())
        .collect();
    let one_sided = |sector| side(sector, ["-", "-", "STONE"]);
    let sides = [
        plain,
        one_sided(1),
        one_sided(2),
        side(0, ["STONE", "STONE", "GRATE"]),
        side(1, ["-", "-", "-"]),
        side(2, ["STONE", "STONE", "-"]),
        side(1, ["-", "STONE", "-"]),
    ];
    // The front is to the right of who goes along a line.
    let lines = [
        line([0, 1], 0, 0, [0, -1]),
        line([1, 2], 0, 0, [1, -1]),
        line([2, 3], 0, 0, [2, -1]),
        line([3, 7], 11, 0, [2, -1]),
        line([7, 6], 0, 0, [2, -1]),
        line([6, 5], 0, 0, [1, -1]),
        line([5, 4], 0, 0, [0, -1]),
        line([4, 0], 0, 0, [0, -1]),
        line([1, 5], 1, 0, [3, 4]),
        line([6, 2], 1, 0, [5, 6]),
    ];
    let sectors = [
        sector(0, 128, ["FLOOR", "FLOOR"], 0),
        sector(0, 0, ["FLOOR", "FLOOR"], 0),
        sector(16, 96, ["FLOOR", "F_SKY1"], 0),
    ];
    vec![
        ("PLAYPAL", (0..768_u32).map(|byte| byte as u8).collect()),
        ("PNAMES", [1_u32.to_le_bytes().to_vec(), name("PATCH").to_vec()].concat()),
        ("TEXTURE1", textures()),
        ("P_START", Vec::new()),
        ("PATCH", patch()),
        ("P_END", Vec::new()),
        ("F_START", Vec::new()),
        ("FLOOR", vec![7; 4096]),
        ("F_END", Vec::new()),
        ("S_START", Vec::new()),
        ("COLUA0", patch()),
        ("S_END", Vec::new()),
        ("E1M1", Vec::new()),
        ("THINGS", [thing([64, 64], 1), thing([128, 64], 2028)].concat()),
        ("LINEDEFS", lines.concat()),
        ("SIDEDEFS", sides.concat()),
        ("VERTEXES", vertices),
        ("SEGS", vec![1]),
        ("SECTORS", sectors.concat()),
    ]
}

/// The file of some lumps.
pub fn file(lumps: &[Lump]) -> Vec<u8> {
    let mut data = Vec::new();
    let mut directory = Vec::new();
    for (text, bytes) in lumps {
        directory.extend((12 + data.len() as u32).to_le_bytes());
        directory.extend((bytes.len() as u32).to_le_bytes());
        directory.extend(name(text));
        data.extend(bytes);
    }
    let count = lumps.len() as u32;
    let start = 12 + data.len() as u32;
    [b"PWAD".as_slice(), &count.to_le_bytes(), &start.to_le_bytes(), &data, &directory].concat()
}

/// The file, read.
pub fn wad() -> Wad {
    Wad::parse("made.wad", file(&lumps())).unwrap()
}
