//! Checks that numbers are in the SPUs' range, with errors that name their place in the scene.

use std::fmt;

use glam::DVec3;

use super::error::BlockError;
use crate::scene::single::{is_number, is_size};

/// The place of the numbers that are checked. Error messages begin with it.
#[derive(Clone, Copy)]
pub(super) struct SourceLocation<'a> {
    pub file: &'a str,
    /// `None` for numbers without a line of their own.
    pub line: Option<u32>,
}

impl fmt::Display for SourceLocation<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.file)?;
        // Line 0 stands for shapes that are in no file.
        let line = self.line.filter(|&line| line > 0);
        line.map_or(Ok(()), |line| write!(f, ":{line}"))
    }
}

impl SourceLocation<'_> {
    fn out_of_range(&self, what: &'static str, value: f64, also: &'static str) -> BlockError {
        BlockError::OutOfRange { place: self.to_string(), what, value, also }
    }

    /// Checks that a number can be squared as a single.
    pub fn number(&self, what: &'static str, value: f64) -> Result<(), BlockError> {
        if is_number(value) { Ok(()) } else { Err(self.out_of_range(what, value, "")) }
    }

    /// Checks that all components of a vector are in range.
    pub fn vector(&self, what: &'static str, vector: DVec3) -> Result<(), BlockError> {
        let mut values = vector.to_array().into_iter();
        values.try_for_each(|value| self.number(what, value))
    }

    /// Checks that a size is in range, and that its square is not 0 as a single.
    pub fn size(&self, what: &'static str, value: f64) -> Result<(), BlockError> {
        if is_size(value) {
            Ok(())
        } else {
            Err(self.out_of_range(what, value, " and at least 2^-62"))
        }
    }
}
