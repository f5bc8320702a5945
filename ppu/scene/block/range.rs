//! Which numbers the SPUs take: singles with room to be squared.

use std::fmt;

use glam::DVec3;

use super::error::BlockError;
use crate::scene::single::{LARGEST, SMALLEST};

/// Where the numbers stand that are checked: messages begin with it.
#[derive(Clone, Copy)]
pub(super) struct SourceLocation<'a> {
    pub file: &'a str,
    /// None for what has no line of its own.
    pub line: Option<u32>,
}

impl fmt::Display for SourceLocation<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.file)?;
        self.line.map_or(Ok(()), |line| write!(f, ":{line}"))
    }
}

impl SourceLocation<'_> {
    fn out_of_range(&self, what: &'static str, value: f64, also: &'static str) -> BlockError {
        BlockError::OutOfRange {
            place: self.to_string(),
            what,
            value,
            also,
        }
    }

    /// Whether a number is in range.
    pub fn number(&self, what: &'static str, value: f64) -> Result<(), BlockError> {
        // NaN is not.
        if value.abs() <= LARGEST {
            Ok(())
        } else {
            Err(self.out_of_range(what, value, ""))
        }
    }

    /// Whether all numbers of a vector are.
    pub fn vector(&self, what: &'static str, vector: DVec3) -> Result<(), BlockError> {
        let mut values = vector.to_array().into_iter();
        values.try_for_each(|value| self.number(what, value))
    }

    /// Whether a size is in range and not too small.
    pub fn size(&self, what: &'static str, value: f64) -> Result<(), BlockError> {
        if (SMALLEST..=LARGEST).contains(&value.abs()) {
            Ok(())
        } else {
            Err(self.out_of_range(what, value, " and at least 2^-62"))
        }
    }
}
