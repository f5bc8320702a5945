//! What can be wrong with a scene file, each fault by name.

use std::fmt;
use std::io;

use thiserror::Error;

use crate::words::MAX_MAGNITUDE;
use crate::{ViewError, sphereflake, tetra};

/// Why there is no scene.
#[derive(Debug, Error)]
pub enum Error {
    /// The file could not be opened or read.
    #[error("{file}: {source}")]
    Io {
        /// The file.
        file: String,
        /// What the system said.
        source: io::Error,
    },
    /// The file's text is wrong.
    #[error("{file}:{line}: {fault}")]
    Text {
        /// The file.
        file: String,
        /// The line at fault, from 1; for a file that ends too early its last line.
        line: u32,
        /// What is wrong there.
        fault: Fault,
    },
    /// A sphereflake that can't be generated.
    #[error(transparent)]
    Sphereflake(#[from] sphereflake::Error),
    /// Tetrahedra that can't be generated.
    #[error(transparent)]
    Tetra(#[from] tetra::Error),
}

/// What is wrong with a line.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Fault {
    /// An entity that the format does not have.
    #[error("unknown entity {0} (known: v b l f s c p pp)")]
    UnknownEntity(Excerpt),
    /// A directive that there is not.
    #[error("unknown directive {0} (known: ambient sun shader)")]
    UnknownDirective(Excerpt),
    /// A name that can't be a shader's.
    #[error("shader {0} is not a name: letters, digits and _, a letter first")]
    ShaderName(Excerpt),
    /// A range of depth shading that is none.
    #[error("depth far {far} is not more than near {near}")]
    DepthRange {
        /// Where all is black.
        far: f64,
        /// Where it begins to fade.
        near: f64,
    },
    /// A direction that points nowhere.
    #[error("{0} is 0 0 0")]
    NoDirection(&'static str),
    /// A number that must be above 0 is not.
    #[error("{field} {value} is not above 0")]
    NotPositive {
        /// What was to be given.
        field: &'static str,
        /// What is there.
        value: f64,
    },
    /// A word that is no number.
    #[error("{field} {value} is not a number")]
    NotANumber {
        /// What was to be given.
        field: &'static str,
        /// What is there.
        value: Excerpt,
    },
    /// An infinite number or none at all.
    #[error("{field} {value} is not a finite number")]
    NotFinite {
        /// What was to be given.
        field: &'static str,
        /// What is there.
        value: Excerpt,
    },
    /// A number whose square is beyond an `f64`.
    #[error("{field} {value:e} is larger than {MAX_MAGNITUDE:e}")]
    TooLarge {
        /// What was to be given.
        field: &'static str,
        /// What is there.
        value: f64,
    },
    /// A number that must not be negative is.
    #[error("{field} {value} is negative")]
    Negative {
        /// What was to be given.
        field: &'static str,
        /// What is there.
        value: f64,
    },
    /// A word that is no whole number from 0.
    #[error("{field} {value} is not a whole number from 0")]
    NotACount {
        /// What was to be given.
        field: &'static str,
        /// What is there.
        value: Excerpt,
    },
    /// A whole number that is too large.
    #[error("{field} {value} is more than {limit}")]
    LargeCount {
        /// What was to be given.
        field: &'static str,
        /// What is there.
        value: Excerpt,
        /// The most that it may be.
        limit: usize,
    },
    /// A directive's line ends before all is given.
    #[error("{0} is missing")]
    Missing(&'static str),
    /// Another entity begins before all is given.
    #[error(
        "{field} of the {entity} that starts on line {start} is missing: {value} is in its place"
    )]
    Incomplete {
        /// What was to be given.
        field: &'static str,
        /// The entity.
        entity: &'static str,
        /// Where it starts.
        start: u32,
        /// The keyword that is there.
        value: Excerpt,
    },
    /// More words after all is given.
    #[error("{entity} is followed by {value}, which does not belong there")]
    Extra {
        /// What they follow.
        entity: &'static str,
        /// The first word too many.
        value: Excerpt,
    },
    /// Another part of a view was expected.
    #[error("the view's `{expected}` is expected here, not {value}")]
    ViewLine {
        /// The keyword that comes next.
        expected: &'static str,
        /// What is there.
        value: Excerpt,
    },
    /// The view shows nothing.
    #[error("{0}")]
    View(#[from] ViewError),
    /// An entity that may be given once was given again.
    #[error("a second {entity}; the first is on line {first}")]
    Second {
        /// The entity.
        entity: &'static str,
        /// The first one's line.
        first: u32,
    },
    /// An object before what it needs.
    #[error("{entity} before the {needed}")]
    TooEarly {
        /// The object.
        entity: &'static str,
        /// What must come first.
        needed: &'static str,
    },
    /// The file ends inside an entity.
    #[error("the file ends inside the {entity} that starts on line {start}: {field} is missing")]
    Truncated {
        /// The entity.
        entity: &'static str,
        /// Where it starts.
        start: u32,
        /// What was to be given next.
        field: &'static str,
    },
    /// The file ends without a view.
    #[error("the file has no view (v)")]
    NoView,
    /// A radius of 0.
    #[error("{0} is 0")]
    ZeroRadius(&'static str),
    /// Radii of a cone of which one shows the inside and the other the outside.
    #[error("base radius {base} and apex radius {apex} have different signs")]
    MixedRadii {
        /// The radius at the base.
        base: f64,
        /// The radius at the apex.
        apex: f64,
    },
    /// A cone without height.
    #[error("the cone's base and apex are the same point")]
    FlatCone,
    /// A polygon with too few vertices.
    #[error("{entity} with {count} vertices, fewer than 3")]
    FewVertices {
        /// `polygon` or `patch`.
        entity: &'static str,
        /// How many it says it has.
        count: usize,
    },
    /// More of something than [`Limits`](crate::Limits) allow.
    #[error("more than {limit} {what}")]
    TooMany {
        /// What there are too many of.
        what: &'static str,
        /// How many are allowed.
        limit: usize,
    },
    /// A line longer than [`Limits`](crate::Limits) allow.
    #[error("the line is longer than {0} bytes")]
    LongLine(usize),
    /// Bytes that are not UTF-8.
    #[error("byte {0} of the line is not UTF-8 text")]
    NotText(usize),
}

/// A word of the file, quoted and cut to what a message can hold.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excerpt(String);

impl Excerpt {
    /// Most characters of a word that a message repeats.
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
    /// Control characters are escaped: a file must not be able to write to a terminal.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}`", self.0.escape_debug())
    }
}
