//! A map: lines between sectors, and things.
//!
//! Invariant of a map that [`Map::read`] returned: the vertices and sectors that its lines name
//! exist, and each line has a length and a front side.

use glam::DVec2;
use zerocopy::little_endian::{I16, U16};
use zerocopy::{FromBytes, Immutable, KnownLayout, Unaligned};

use crate::{Error, Fault, Name, Wad};

/// The flags of lines that matter here.
pub mod flags {
    /// Nobody walks through it.
    pub const BLOCKS: u16 = 1;
    /// The upper texture hangs from the ceiling.
    pub const UPPER_UNPEGGED: u16 = 8;
    /// The lower texture goes on where a middle one would be, and a middle one stands on the floor.
    pub const LOWER_UNPEGGED: u16 = 16;
}

/// A map.
#[derive(Clone, Debug, Default)]
pub struct Map {
    /// The corners of lines.
    pub vertices: Vec<DVec2>,
    /// The lines.
    pub lines: Vec<Line>,
    /// The sectors: areas of one height of the floor and one of the ceiling.
    pub sectors: Vec<Sector>,
    /// The things: where players begin, lamps, keys.
    pub things: Vec<Thing>,
    /// Notes about omitted parts, as sentences.
    pub notes: Vec<String>,
}

/// A line from one vertex to another.
#[derive(Clone, Debug)]
pub struct Line {
    /// Its first and its last vertex.
    pub ends: [u32; 2],
    /// Its [`flags`].
    pub flags: u16,
    /// The number of its [`special`](crate::special).
    pub special: u16,
    /// The tag of the sectors that the special changes.
    pub tag: u16,
    /// Its front, which is to the right of who goes from its first vertex to its last one.
    pub front: Side,
    /// Its back; `None` if it is a wall without an opening.
    pub back: Option<Side>,
}

/// A side of a line.
#[derive(Clone, Debug)]
pub struct Side {
    /// The sector on this side.
    pub sector: u32,
    /// How far the textures are moved to the left and up.
    pub offset: DVec2,
    /// The texture above the opening to the other side.
    pub upper: Name,
    /// The texture below it.
    pub lower: Name,
    /// The texture in it, or of the whole wall of a line without a back.
    pub middle: Name,
}

/// A sector.
#[derive(Clone, Debug)]
pub struct Sector {
    /// The height of its floor.
    pub floor: f64,
    /// The height of its ceiling.
    pub ceiling: f64,
    /// The picture of its floor.
    pub floor_flat: Name,
    /// The picture of its ceiling.
    pub ceiling_flat: Name,
    /// How light it is, 0 to 255.
    pub light: f64,
    /// The number of its special.
    pub special: u16,
    /// The tag by which lines name it.
    pub tag: u16,
}

/// A thing.
#[derive(Clone, Copy, Debug)]
pub struct Thing {
    /// Its place.
    pub place: DVec2,
    /// The direction in which it looks, in degrees from east to north.
    pub angle: f64,
    /// The number of its kind.
    pub kind: u16,
}

/// Things that only games of several players have.
const SEVERAL_PLAYERS: u16 = 16;
/// The number of a side that a line does not have.
const NO_SIDE: u16 = u16::MAX;

#[derive(FromBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct ThingRecord {
    x: I16,
    y: I16,
    angle: I16,
    kind: U16,
    flags: U16,
}

#[derive(FromBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct LineRecord {
    ends: [U16; 2],
    flags: U16,
    special: U16,
    tag: U16,
    sides: [U16; 2],
}

#[derive(FromBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct SideRecord {
    x: I16,
    y: I16,
    upper: [u8; 8],
    lower: [u8; 8],
    middle: [u8; 8],
    sector: U16,
}

#[derive(FromBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct VertexRecord {
    x: I16,
    y: I16,
}

#[derive(FromBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
struct SectorRecord {
    floor: I16,
    ceiling: I16,
    floor_flat: [u8; 8],
    ceiling_flat: [u8; 8],
    light: I16,
    special: U16,
    tag: U16,
}

/// The lumps of a map, as far as they are read.
const LUMPS: [&str; 5] = ["THINGS", "LINEDEFS", "SIDEDEFS", "VERTEXES", "SECTORS"];
/// The lumps that nodes' builders and games add, and that a map may lack.
const OTHERS: [&str; 5] = ["SEGS", "SSECTORS", "NODES", "REJECT", "BLOCKMAP"];

fn place(x: I16, y: I16) -> DVec2 {
    DVec2::new(f64::from(x.get()), f64::from(y.get()))
}

impl Map {
    /// Reads a map.
    ///
    /// # Errors
    /// There is no such map, it is in the format of another game, one of its lumps is missing or is
    /// no whole number of records, or a record names something that the map does not have.
    pub fn read(wad: &Wad, name: Name) -> Result<Self, Error> {
        let lumps = lumps(wad, name)?;
        let reader = Reader { wad, name };
        let things: &[ThingRecord] = reader.records(0, lumps[0])?;
        let lines: &[LineRecord] = reader.records(1, lumps[1])?;
        let sides: &[SideRecord] = reader.records(2, lumps[2])?;
        let vertices: &[VertexRecord] = reader.records(3, lumps[3])?;
        let sectors: &[SectorRecord] = reader.records(4, lumps[4])?;

        let mut map = Self {
            vertices: vertices.iter().map(|vertex| place(vertex.x, vertex.y)).collect(),
            sectors: sectors.iter().map(Sector::of).collect(),
            ..Self::default()
        };
        let wanted = things.iter().filter(|thing| thing.flags.get() & SEVERAL_PLAYERS == 0);
        map.things = wanted.map(Thing::of).collect();
        let side = |line: usize, number: U16| -> Result<Side, Error> {
            let Some(record) = sides.get(number.get() as usize) else {
                let what = format!("line {line} has side {number} of {}", sides.len());
                return Err(reader.wrong(1, what));
            };
            if record.sector.get() as usize >= sectors.len() {
                let sector = record.sector;
                let what = format!("side {number} has sector {sector} of {}", sectors.len());
                return Err(reader.wrong(2, what));
            }
            Ok(Side::of(record))
        };
        for (number, line) in lines.iter().enumerate() {
            let ends = line.ends.map(|end| u32::from(end.get()));
            if let Some(end) = ends.iter().find(|end| **end as usize >= vertices.len()) {
                let what = format!("line {number} has vertex {end} of {}", vertices.len());
                return Err(reader.wrong(1, what));
            }
            if map.vertices[ends[0] as usize] == map.vertices[ends[1] as usize] {
                map.notes.push(format!("line {number} has no length"));
                continue;
            }
            let [front, back] = line.sides;
            if front == NO_SIDE {
                return Err(reader.wrong(1, format!("line {number} has no front side")));
            }
            map.lines.push(Line {
                ends,
                flags: line.flags.get(),
                special: line.special.get(),
                tag: line.tag.get(),
                front: side(number, front)?,
                back: if back == NO_SIDE { None } else { Some(side(number, back)?) },
            });
        }
        if map.lines.is_empty() {
            return Err(reader.wrong(1, "the map has no line".to_owned()));
        }
        Ok(map)
    }

    /// The places of a line's ends.
    #[must_use]
    pub fn places(&self, line: &Line) -> [DVec2; 2] {
        line.ends.map(|end| self.vertices[end as usize])
    }

    /// The numbers of the sectors on the other sides of a sector's lines.
    pub fn neighbours(&self, sector: u32) -> impl Iterator<Item = u32> {
        self.lines.iter().filter_map(move |line| {
            let back = line.back.as_ref()?.sector;
            match (line.front.sector == sector, back == sector) {
                (true, false) => Some(back),
                (false, true) => Some(line.front.sector),
                _ => None,
            }
        })
    }
}

impl Sector {
    fn of(record: &SectorRecord) -> Self {
        let floor = f64::from(record.floor.get());
        Self {
            floor,
            // Where a ceiling is below its floor, nothing is between them.
            ceiling: f64::from(record.ceiling.get()).max(floor),
            floor_flat: Name::of(record.floor_flat),
            ceiling_flat: Name::of(record.ceiling_flat),
            light: f64::from(record.light.get()).clamp(0.0, 255.0),
            special: record.special.get(),
            tag: record.tag.get(),
        }
    }
}

impl Side {
    fn of(record: &SideRecord) -> Self {
        Self {
            sector: u32::from(record.sector.get()),
            offset: place(record.x, record.y),
            upper: Name::of(record.upper),
            lower: Name::of(record.lower),
            middle: Name::of(record.middle),
        }
    }
}

impl Thing {
    fn of(record: &ThingRecord) -> Self {
        Self {
            place: place(record.x, record.y),
            angle: f64::from(record.angle.get()),
            kind: record.kind.get(),
        }
    }
}

/// The lumps of a map, in the order of [`LUMPS`].
fn lumps(wad: &Wad, map: Name) -> Result<[&[u8]; LUMPS.len()], Error> {
    let Some(after) = wad.after(map) else {
        let known = wad.maps().iter().map(Name::to_string).collect::<Vec<_>>().join(", ");
        let known = match known.is_empty() {
            true => "the file has no maps".to_owned(),
            false => format!("the file has {known}"),
        };
        return Err(wad.wrong(Fault::NoMap { wanted: map.to_string(), known }));
    };
    let mut found = [None; LUMPS.len()];
    for (name, bytes) in after {
        let foreign = [("TEXTMAP", "the format UDMF"), ("BEHAVIOR", "Hexen's format")];
        if let Some((_, format)) = foreign.iter().find(|(mark, _)| name == Name::new(mark)) {
            return Err(wad.wrong(Fault::Format { map, format }));
        }
        match LUMPS.iter().position(|lump| name == Name::new(lump)) {
            Some(number) if found[number].is_none() => found[number] = Some(bytes),
            None if OTHERS.iter().any(|other| name == Name::new(other)) => {}
            _ => break,
        }
    }
    let mut lumps = [[].as_slice(); LUMPS.len()];
    for ((lump, found), name) in lumps.iter_mut().zip(found).zip(LUMPS) {
        let missing = || wad.wrong_lump(format!("{map} {name}"), "it is missing".to_owned());
        *lump = found.ok_or_else(missing)?;
    }
    Ok(lumps)
}

struct Reader<'a> {
    wad: &'a Wad,
    name: Name,
}

impl<'a> Reader<'a> {
    fn wrong(&self, lump: usize, what: String) -> Error {
        self.wad.wrong_lump(format!("{} {}", self.name, LUMPS[lump]), what)
    }

    /// The records of a lump.
    fn records<T>(&self, lump: usize, bytes: &'a [u8]) -> Result<&'a [T], Error>
    where
        T: FromBytes + Immutable + KnownLayout + Unaligned,
    {
        let record = size_of::<T>();
        let records = <[T]>::ref_from_bytes(bytes).map_err(|_| {
            let bytes = bytes.len();
            self.wrong(lump, format!("{bytes} bytes are no whole number of records of {record}"))
        })?;
        // Numbers of records are words of 16 bits.
        let most = usize::from(u16::MAX);
        if records.len() > most {
            let what = format!("{} records are more than {most}", records.len());
            return Err(self.wrong(lump, what));
        }
        Ok(records)
    }
}
