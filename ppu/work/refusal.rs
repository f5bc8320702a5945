//! What an SPU's status means: the field that it refused, and what stood there.

use std::fmt;

use zerocopy::IntoBytes as _;

use super::layout::{Frame, Status};

/// An SPU's answer other than "done".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The status word.
    pub status: u32,
    /// Field of the frame descriptor or of a work unit that it is about; empty if the status is
    /// unknown.
    pub field: &'static str,
    rule: &'static str,
    values: Vec<u64>,
}

impl Refusal {
    /// Reads an answer; `None` is "done".
    #[must_use]
    pub fn of(answer: u32, frame: &Frame, address: u64) -> Option<Self> {
        if answer == Status::Done as u32 {
            return None;
        }
        let known = Status::ALL
            .iter()
            .find(|(_, status, ..)| *status as u32 == answer);
        let Some(&(_, status, field, rule)) = known else {
            return Some(Self {
                status: answer,
                field: "",
                rule: "",
                values: Vec::new(),
            });
        };
        let values = if status == Status::Address {
            vec![address]
        } else {
            field
                .split(", ")
                .filter_map(|field| value_of(frame, field))
                .collect()
        };
        Some(Self {
            status: answer,
            field,
            rule: rule.trim(),
            values,
        })
    }
}

/// A number of the descriptor by its field's name.
fn value_of(frame: &Frame, name: &str) -> Option<u64> {
    let field = Frame::RECORD
        .fields
        .iter()
        .find(|field| field.name == name)?;
    let bytes = frame
        .as_bytes()
        .get(field.offset..field.offset + field.size)?;
    Some(
        bytes
            .iter()
            .fold(0, |value, byte| value << 8 | u64::from(*byte)),
    )
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.field.is_empty() {
            return write!(f, "answered with the unknown status {}", self.status);
        }
        if self.values.is_empty() {
            write!(f, "refused the work units: {}", self.field)?;
        } else {
            write!(f, "refused the frame descriptor: {} is ", self.field)?;
        }
        for (number, value) in self.values.iter().enumerate() {
            let comma = if number == 0 { "" } else { ", " };
            write!(f, "{comma}{value} ({value:#x})")?;
        }
        let mut rule = self.rule.chars();
        let first = rule.next().map(|first| first.to_ascii_lowercase());
        write!(
            f,
            ": {}{}",
            first.into_iter().collect::<String>(),
            rule.as_str().trim_end_matches('.')
        )
    }
}
