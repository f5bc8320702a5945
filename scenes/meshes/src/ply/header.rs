//! The header of a PLY file.

use super::TEXTURE;
use crate::Fault;

/// How the data after the header are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    Little,
    Big,
}

/// A type of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Kind {
    fn of(word: &str) -> Option<Self> {
        Some(match word {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes of a number.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// The number that stands for a full channel of a colour.
    pub fn most(self) -> f64 {
        match self {
            Self::I8 => f64::from(i8::MAX),
            Self::U8 => f64::from(u8::MAX),
            Self::I16 => f64::from(i16::MAX),
            Self::U16 => f64::from(u16::MAX),
            // Files with colours of four bytes have them from 0 to 255.
            Self::I32 | Self::U32 => 255.0,
            Self::F32 | Self::F64 => 1.0,
        }
    }
}

#[derive(Debug)]
pub(super) struct Property {
    pub name: String,
    pub kind: Kind,
    /// The type of the list's length, if it is one.
    pub list: Option<Kind>,
}

/// A table of rows with the same properties.
#[derive(Debug)]
pub(super) struct Element {
    pub name: String,
    pub count: usize,
    pub properties: Vec<Property>,
}

#[derive(Debug)]
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// The file of the first texture that a comment names.
    pub texture: Option<String>,
}

impl Header {
    /// Reads the header, and returns where the data begin.
    pub fn parse(bytes: &[u8]) -> Result<(Self, usize), Fault> {
        let mut lines = HeaderLines { bytes, at: 0, line: 0 };
        if lines.next()?.trim() != "ply" {
            return Err(Fault::Ply("it doesn't begin with the line \"ply\"".into()));
        }
        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        let mut texture = None;
        loop {
            let line = lines.next()?;
            let wrong = |what: &str| Fault::Line {
                line: lines.line,
                what: format!("{what}: {}", scenes::Excerpt::of(&line)),
            };
            let mut words = line.split_ascii_whitespace();
            let keyword = words.next().unwrap_or_default();
            let words: Vec<&str> = words.collect();
            match (keyword, words.as_slice()) {
                ("", _) | ("obj_info", _) => {}
                ("comment", words) => {
                    if let Some((&word, file)) = words.split_first()
                        && word == TEXTURE
                        && texture.is_none()
                    {
                        texture = Some(file.join(" "));
                    }
                }
                ("format", &[name, ..]) => {
                    encoding = Some(match name {
                        "ascii" => Encoding::Text,
                        "binary_little_endian" => Encoding::Little,
                        "binary_big_endian" => Encoding::Big,
                        _ => return Err(wrong("unknown format")),
                    });
                }
                ("element", &[name, count]) => elements.push(Element {
                    name: name.to_owned(),
                    count: count
                        .parse()
                        .map_err(|_| wrong("an element's count is no whole number from 0"))?,
                    properties: Vec::new(),
                }),
                ("property", words) => {
                    let element = elements
                        .last_mut()
                        .ok_or_else(|| wrong("a property before the first element"))?;
                    let property = match *words {
                        ["list", length, kind, name] => Kind::of(length)
                            .zip(Kind::of(kind))
                            .map(|(length, kind)| (name, kind, Some(length))),
                        [kind, name] => Kind::of(kind).map(|kind| (name, kind, None)),
                        _ => None,
                    };
                    let (name, kind, list) =
                        property.ok_or_else(|| wrong("not a property of a known type"))?;
                    let name = name.to_owned();
                    element.properties.push(Property { name, kind, list });
                }
                ("end_header", _) => break,
                _ => return Err(wrong("unknown line of the header")),
            }
        }
        // However many rows without a number there are, the data don't have them.
        elements.retain(|element| !element.properties.is_empty() || element.name == "vertex");
        let encoding = encoding.ok_or_else(|| Fault::Ply("its header has no format".into()))?;
        let header = Self { encoding, elements, texture };
        Ok((header, lines.at))
    }
}

/// The lines of a header, which end with LF, CR or both.
struct HeaderLines<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
}

impl HeaderLines<'_> {
    fn next(&mut self) -> Result<String, Fault> {
        let rest = &self.bytes[self.at..];
        let Some(end) = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')) else {
            return Err(Fault::Ply("it ends inside its header".into()));
        };
        let line = String::from_utf8_lossy(&rest[..end]).into_owned();
        // After a CR alone, binary data may begin with the byte of a LF. So the first line decides.
        let is_pair = rest[end..].starts_with(b"\r\n");
        let is_first = self.line == 0;
        let has_pairs = is_first || self.bytes[..self.at].ends_with(b"\r\n");
        self.at += end + if is_pair && has_pairs { 2 } else { 1 };
        self.line += 1;
        Ok(line)
    }
}
