//! Errors and warnings, and where they are in a source.

use std::fmt;

/// A place in a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Position {
    /// Line, counted from 1.
    pub line: u32,
    /// Column in characters, counted from 1.
    pub column: u32,
}

/// An error or a warning.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The source's name, as it was given.
    pub file: String,
    /// The place.
    pub position: Position,
    /// What is wrong there.
    pub message: String,
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Position { line, column } = self.position;
        write!(f, "{}:{line}:{column}: {}", self.file, self.message)
    }
}

/// Why a source can't be assembled or linked. There is at least one error.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Errors {
    /// In the order of the source.
    pub errors: Vec<Diagnostic>,
    /// Whether the source uses macros, conditions or other files, which only the SPU binutils
    /// understand.
    pub uses_macros: bool,
}

impl fmt::Display for Errors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, error) in self.errors.iter().enumerate() {
            write!(f, "{}{error}", if index > 0 { "\n" } else { "" })?;
        }
        Ok(())
    }
}

impl std::error::Error for Errors {}

/// A message and the byte of the source that it is about.
#[derive(Clone, Debug)]
pub(crate) struct Fault {
    pub at: usize,
    pub message: String,
}

impl Fault {
    pub(crate) fn new(at: usize, message: impl Into<String>) -> Self {
        Self { at, message: message.into() }
    }
}

/// The name of `known` that is most similar to one that is unknown, as advice.
pub(crate) fn advice<'a>(asked: &str, known: impl Iterator<Item = &'a str>) -> String {
    let asked = asked.to_lowercase();
    let near = known.map(|name| (strsim::osa_distance(&asked, &name.to_lowercase()), name));
    match near.min_by_key(|&(distance, _)| distance) {
        Some((distance, name)) if distance <= asked.len().div_ceil(4) => {
            format!("; did you mean {name}?")
        }
        _ => String::new(),
    }
}
