//! The numbers after the header of a PLY file.

use super::header::{Element, Encoding, Kind};
use crate::Fault;
use crate::text::{any_number, shown};

/// The most numbers of a list.
const LONGEST: f64 = (1 << 26) as f64;

/// Reads rows of elements, one after another.
pub(super) struct Values<'a> {
    bytes: &'a [u8],
    at: usize,
    encoding: Encoding,
}

impl<'a> Values<'a> {
    pub fn new(bytes: &'a [u8], at: usize, encoding: Encoding) -> Self {
        Self { bytes, at, encoding }
    }

    /// Reads a row: for each property its numbers, one unless it is a list.
    pub fn row(&mut self, element: &Element, row: &mut Vec<Vec<f64>>) -> Result<(), Fault> {
        row.resize_with(element.properties.len(), Vec::new);
        for (property, numbers) in element.properties.iter().zip(row) {
            numbers.clear();
            let count = match property.list {
                None => 1.0,
                Some(length) => self.number(length)?,
            };
            if !(0.0..=LONGEST).contains(&count) || count.fract() != 0.0 {
                let name = &property.name;
                return Err(self.wrong(format!("the list {name} has {count} numbers")));
            }
            for _ in 0..count as usize {
                numbers.push(self.number(property.kind)?);
            }
        }
        Ok(())
    }

    fn wrong(&self, what: String) -> Fault {
        match self.encoding {
            Encoding::Text => {
                let before = &self.bytes[..self.at];
                let ends = before.iter().filter(|byte| **byte == b'\n').count();
                let line = if ends > 0 {
                    ends + 1
                } else {
                    1 + before.iter().filter(|byte| **byte == b'\r').count()
                };
                Fault::Line { line, what }
            }
            Encoding::Little | Encoding::Big => Fault::Ply(format!("at byte {}: {what}", self.at)),
        }
    }

    fn number(&mut self, kind: Kind) -> Result<f64, Fault> {
        if self.encoding == Encoding::Text {
            return self.word();
        }
        let size = kind.size();
        let Some(part) = self.bytes.get(self.at..self.at + size) else {
            let size = self.bytes.len();
            return Err(Fault::Ply(format!("it ends after {size} bytes, inside its data")));
        };
        self.at += size;
        let mut word = [0; 8];
        word[..size].copy_from_slice(part);
        if self.encoding == Encoding::Big {
            word[..size].reverse();
        }
        let bits = u64::from_le_bytes(word);
        Ok(match kind {
            Kind::I8 => f64::from(bits as i8),
            Kind::U8 => f64::from(bits as u8),
            Kind::I16 => f64::from(bits as i16),
            Kind::U16 => f64::from(bits as u16),
            Kind::I32 => f64::from(bits as i32),
            Kind::U32 => f64::from(bits as u32),
            Kind::F32 => f64::from(f32::from_bits(bits as u32)),
            Kind::F64 => f64::from_bits(bits),
        })
    }

    fn word(&mut self) -> Result<f64, Fault> {
        let rest = &self.bytes[self.at..];
        let blanks = rest.iter().take_while(|byte| byte.is_ascii_whitespace());
        let start = self.at + blanks.count();
        let rest = &self.bytes[start..];
        let length = rest.iter().take_while(|byte| !byte.is_ascii_whitespace());
        let word = &rest[..length.count()];
        self.at = start;
        if word.is_empty() {
            return Err(self.wrong("the file ends inside its data".into()));
        }
        let Some(number) = any_number(word) else {
            return Err(self.wrong(format!("{} is not a number", shown(word))));
        };
        self.at = start + word.len();
        Ok(number)
    }
}
