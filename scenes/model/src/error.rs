//! The errors of scene files.

use std::fmt;
use std::io;

use thiserror::Error;

use crate::words::MAX_MAGNITUDE;
use crate::{ViewError, spd, sphereflake, tetra};

/// Why a scene can't be read or generated.
#[derive(Debug, Error)]
pub enum Error {
    /// The file could not be opened or read.
    #[error("{file}: {source}")]
    Io {
        /// The file.
        file: String,
        /// The system's error.
        source: io::Error,
    },
    /// The file's text has a fault.
    #[error("{file}:{line}: {fault}")]
    Text {
        /// The file.
        file: String,
        /// The line of the fault, from 1. If the file ends too early, its last line.
        line: u32,
        /// The fault.
        fault: Fault,
    },
    /// A sphereflake that can't be generated.
    #[error(transparent)]
    Sphereflake(#[from] sphereflake::Error),
    /// Tetrahedra that can't be generated.
    #[error(transparent)]
    Tetra(#[from] tetra::Error),
    /// Another scene of SPD that can't be generated.
    #[error(transparent)]
    Spd(#[from] spd::Error),
}

/// A fault in a line.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Fault {
    /// The format has no such entity.
    #[error("unknown entity {0} (known: v b l f s c p pp)")]
    UnknownEntity(Excerpt),
    /// There is no such directive.
    #[error("unknown directive {0} (known: ambient daylight fog heights lamp shader sky sun)")]
    UnknownDirective(Excerpt),
    /// A shader's name has characters that are not allowed.
    #[error("shader {0} is not a name: letters, digits and _, a letter first")]
    ShaderName(Excerpt),
    /// A range of depth shading has no width.
    #[error("depth far {far} is not more than near {near}")]
    DepthRange {
        /// The distance at which the surface is black.
        far: f64,
        /// The distance at which the surface begins to fade.
        near: f64,
    },
    /// A direction is 0.
    #[error("{0} is 0 0 0")]
    NoDirection(&'static str),
    /// A number that must be above 0 is not.
    #[error("{field} {value} is not above 0")]
    NotPositive {
        /// The name of the field.
        field: &'static str,
        /// The value in the file.
        value: f64,
    },
    /// A word is not a number.
    #[error("{field} {value} is not a number")]
    NotANumber {
        /// The name of the field.
        field: &'static str,
        /// The value in the file.
        value: Excerpt,
    },
    /// A number is infinite or NaN.
    #[error("{field} {value} is not a finite number")]
    NotFinite {
        /// The name of the field.
        field: &'static str,
        /// The value in the file.
        value: Excerpt,
    },
    /// A number is so large that its square exceeds an `f64`.
    #[error("{field} {value:e} is larger than {MAX_MAGNITUDE:e}")]
    TooLarge {
        /// The name of the field.
        field: &'static str,
        /// The value in the file.
        value: f64,
    },
    /// A number that must not be negative is.
    #[error("{field} {value} is negative")]
    Negative {
        /// The name of the field.
        field: &'static str,
        /// The value in the file.
        value: f64,
    },
    /// A word is not a whole number from 0.
    #[error("{field} {value} is not a whole number from 0")]
    NotACount {
        /// The name of the field.
        field: &'static str,
        /// The value in the file.
        value: Excerpt,
    },
    /// A whole number is too large.
    #[error("{field} {value} is more than {limit}")]
    LargeCount {
        /// The name of the field.
        field: &'static str,
        /// The value in the file.
        value: Excerpt,
        /// The largest allowed value.
        limit: usize,
    },
    /// A directive's line ends before all its fields.
    #[error("{0} is missing")]
    Missing(&'static str),
    /// Another entity begins before all fields of this one.
    #[error(
        "{field} of the {entity} that starts on line {start} is missing: found {value} instead"
    )]
    Incomplete {
        /// The name of the field.
        field: &'static str,
        /// The entity.
        entity: &'static str,
        /// The line that it starts on.
        start: u32,
        /// The keyword that was found.
        value: Excerpt,
    },
    /// A directive's line has more words than fields.
    #[error("{entity} is followed by {value}, which does not belong there")]
    Extra {
        /// The name of the directive.
        entity: &'static str,
        /// The first extra word.
        value: Excerpt,
    },
    /// Another part of a view was expected.
    #[error("the view's `{expected}` is expected here, not {value}")]
    ViewLine {
        /// The expected keyword.
        expected: &'static str,
        /// The value in the file.
        value: Excerpt,
    },
    /// The view shows nothing.
    #[error("{0}")]
    View(#[from] ViewError),
    /// An entity that may occur once occurs again.
    #[error("a second {entity}; the first is on line {first}")]
    Second {
        /// The entity.
        entity: &'static str,
        /// The first one's line.
        first: u32,
    },
    /// An object comes before an entity that it needs.
    #[error("{entity} before the {needed}")]
    TooEarly {
        /// The object.
        entity: &'static str,
        /// The entity that must come first.
        needed: &'static str,
    },
    /// The file ends inside an entity.
    #[error("the file ends inside the {entity} that starts on line {start}: {field} is missing")]
    Truncated {
        /// The entity.
        entity: &'static str,
        /// The line that it starts on.
        start: u32,
        /// The next field.
        field: &'static str,
    },
    /// The file ends without a view.
    #[error("the file has no view (v)")]
    NoView,
    /// A radius is 0.
    #[error("{0} is 0")]
    ZeroRadius(&'static str),
    /// A cone's radii have different signs.
    #[error("base radius {base} and apex radius {apex} have different signs")]
    MixedRadii {
        /// The radius at the base.
        base: f64,
        /// The radius at the apex.
        apex: f64,
    },
    /// A cone has no height.
    #[error("the cone's base and apex are the same point")]
    FlatCone,
    /// A polygon has too few vertices.
    #[error("{entity} with {count} vertices, fewer than 3")]
    FewVertices {
        /// `polygon` or `patch`.
        entity: &'static str,
        /// The number of vertices that the file states.
        count: usize,
    },
    /// The scene has more of something than [`Limits`](crate::Limits) allow.
    #[error("more than {limit} {what}")]
    TooMany {
        /// The name of the things that are too many.
        what: &'static str,
        /// The allowed number.
        limit: usize,
    },
    /// A line is longer than [`Limits`](crate::Limits) allow.
    #[error("the line is longer than {0} bytes")]
    LongLine(usize),
    /// A line has bytes that are not UTF-8.
    #[error("byte {0} of the line is not UTF-8 text")]
    NotText(usize),
}

/// A word of the file, quoted and shortened for a message.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excerpt(String);

impl Excerpt {
    /// The most characters of a word that a message repeats.
    const MAX_CHARS: usize = 40;

    /// The excerpt of `word`.
    #[must_use]
    pub fn of(word: &str) -> Self {
        let mut kept: String = word.chars().take(Self::MAX_CHARS).collect();
        if kept.len() < word.len() {
            kept.push('…');
        }
        Self(kept)
    }
}

impl fmt::Display for Excerpt {
    /// Control characters are escaped, so that a file can't control a terminal.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}`", self.0.escape_debug())
    }
}
