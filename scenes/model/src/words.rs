//! Reads the words of a file, and checks their values.
//!
//! NFF is read word by word, and the end of a line is only a blank. Directives, which other
//! programs take for comments, are the exception: they end with their line.
//!
//! Invariant: numbers are finite, with a magnitude of at most [`MAX_MAGNITUDE`].

use std::io::BufRead;
use std::str::FromStr;

use glam::DVec3;

use crate::error::Excerpt;
use crate::lines::{DIRECTIVE, LineError, Lines};
use crate::{Fault, LightKind, Limits, MAX_SIDE, Material, Shader, Shape};

/// The largest magnitude of a number in a scene. The squares of such numbers' differences, and
/// sums of these squares, are still finite in an `f64`.
pub const MAX_MAGNITUDE: f64 = 1e150;

/// The words that begin an entity or a part of the view. No number equals one of them.
const KEYWORDS: [&str; 15] = [
    "v",
    "b",
    "l",
    "f",
    "s",
    "c",
    "p",
    "pp",
    DIRECTIVE,
    "from",
    "at",
    "up",
    "angle",
    "hither",
    "resolution",
];

/// The entity that words belong to.
#[derive(Clone, Copy)]
struct Entity {
    name: &'static str,
    /// Line of its first word.
    start: u32,
    /// Line of its last word so far.
    last: u32,
}

/// A reader's words, one at a time.
pub(crate) struct Words<R> {
    lines: Lines<R>,
    /// The position in the current line where the next word may begin.
    at: usize,
    entity: Entity,
}

impl<R: BufRead> Words<R> {
    pub(crate) fn new(reader: R, limits: &Limits) -> Self {
        Self {
            lines: Lines::new(reader, limits),
            at: 0,
            entity: Entity { name: "", start: 0, last: 0 },
        }
    }

    /// The number of the current line, from 1: that of the last word, or of a search for the next.
    pub(crate) fn line(&self) -> u32 {
        self.lines.number()
    }

    /// Line of the entity's first word.
    pub(crate) fn start(&self) -> u32 {
        self.entity.start
    }

    /// Reads the next entity's keyword, and returns the name that `known` has for it; `None` at
    /// the end of the file.
    pub(crate) fn entity(
        &mut self,
        known: impl FnOnce(&str) -> Option<&'static str>,
    ) -> Result<Option<&'static str>, LineError> {
        if !self.seek()? {
            return Ok(None);
        }
        let before = self.entity;
        let line = self.line();
        let word = self.take()?;
        let Some(name) = known(word) else {
            let value = Excerpt::of(word);
            let goes_on = before.last == line || is_like_a_number(word);
            return Err(if goes_on && before.last > 0 {
                Fault::Extra { entity: before.name, value }.into()
            } else {
                Fault::UnknownEntity(value).into()
            });
        };
        self.entity = Entity { name, start: line, last: line };
        Ok(Some(name))
    }

    /// The next word, which gives a field of the entity.
    pub(crate) fn word(&mut self, field: &'static str) -> Result<&str, LineError> {
        let Entity { name, start, .. } = self.entity;
        if name == DIRECTIVE {
            if !self.seek_in_line() {
                return Err(Fault::Missing(field).into());
            }
        } else if !self.seek()? {
            return Err(Fault::Truncated { entity: name, start, field }.into());
        }
        self.entity.last = self.line();
        self.take()
    }

    /// [`Self::word`], except that a keyword belongs to the next entity.
    fn number(&mut self, field: &'static str) -> Result<&str, LineError> {
        let Entity { name, start, .. } = self.entity;
        let word = self.word(field)?;
        if KEYWORDS.contains(&word) && name != DIRECTIVE {
            return Err(
                Fault::Incomplete { field, entity: name, start, value: Excerpt::of(word) }.into()
            );
        }
        Ok(word)
    }

    /// Reads the next word, which must be this keyword of the view.
    pub(crate) fn expect(&mut self, expected: &'static str) -> Result<(), LineError> {
        let found = self.word(expected)?;
        if found == expected {
            return Ok(());
        }
        let value = Excerpt::of(found);
        Err(Fault::ViewLine { expected, value }.into())
    }

    pub(crate) fn real(&mut self, field: &'static str) -> Result<f64, LineError> {
        Ok(real(field, self.number(field)?)?)
    }

    pub(crate) fn not_negative(&mut self, field: &'static str) -> Result<f64, LineError> {
        let value = self.real(field)?;
        if value < 0.0 { Err(Fault::Negative { field, value }.into()) } else { Ok(value) }
    }

    pub(crate) fn point(&mut self, fields: [&'static str; 3]) -> Result<DVec3, LineError> {
        let [x, y, z] = fields;
        Ok(DVec3::new(self.real(x)?, self.real(y)?, self.real(z)?))
    }

    pub(crate) fn vertex(&mut self) -> Result<DVec3, LineError> {
        self.point(["vertex x", "vertex y", "vertex z"])
    }

    pub(crate) fn colour(&mut self, fields: [&'static str; 3]) -> Result<DVec3, LineError> {
        let [red, green, blue] = fields;
        Ok(DVec3::new(self.not_negative(red)?, self.not_negative(green)?, self.not_negative(blue)?))
    }

    /// Reads a side of the resolution, without checking its range.
    pub(crate) fn side(&mut self, field: &'static str) -> Result<u32, LineError> {
        self.whole(field, MAX_SIDE as usize)
    }

    /// Reads a number of vertices, at most `limit`.
    pub(crate) fn count(&mut self, limit: usize) -> Result<usize, LineError> {
        let field = "number of vertices";
        let count: usize = self.whole(field, limit)?;
        if count > limit {
            let value = count.to_string();
            return Err(large(field, &value, limit).into());
        }
        Ok(count)
    }

    /// Reads a whole number, not negative. One that its type can't hold is above the limit too.
    fn whole<T: FromStr>(&mut self, field: &'static str, limit: usize) -> Result<T, LineError> {
        let word = self.number(field)?;
        let digits = word.strip_prefix('+').unwrap_or(word);
        if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
            let value = Excerpt::of(word);
            return Err(Fault::NotACount { field, value }.into());
        }
        Ok(digits.parse().map_err(|_| large(field, word, limit))?)
    }

    pub(crate) fn light(&mut self) -> Result<(LightKind, Option<DVec3>), LineError> {
        let position = self.point(["light x", "light y", "light z"])?;
        let colour = self.light_colour()?;
        Ok((LightKind::Point { position, range: f64::INFINITY }, colour))
    }

    /// Reads a light's colour, if there is one.
    pub(crate) fn light_colour(&mut self) -> Result<Option<DVec3>, LineError> {
        if self.more()? {
            let colour = self.colour(["light red", "light green", "light blue"])?;
            Ok(Some(colour))
        } else {
            Ok(None)
        }
    }

    /// Whether the entity continues with optional fields: with any word except a keyword on its
    /// line, or with a number on a later line.
    pub(crate) fn more(&mut self) -> Result<bool, LineError> {
        if self.seek_in_line() {
            return Ok(!KEYWORDS.contains(&self.peek()?));
        }
        Ok(self.entity.name != DIRECTIVE && self.seek()? && is_like_a_number(self.peek()?))
    }

    /// Reads a material. The caller fills in its line.
    pub(crate) fn material(&mut self) -> Result<Material, LineError> {
        Ok(Material {
            line: 0,
            colour: self.colour(["material red", "material green", "material blue"])?,
            diffuse: self.not_negative("Kd")?,
            specular: self.not_negative("Ks")?,
            shine: self.not_negative("shine")?,
            transmittance: self.not_negative("T")?,
            refraction_index: self.not_negative("index of refraction")?,
            emission: DVec3::ZERO,
            shader: Shader::Phong,
            texture: None,
        })
    }

    pub(crate) fn sphere(&mut self) -> Result<Shape, LineError> {
        let centre = self.point(["centre x", "centre y", "centre z"])?;
        let radius = self.real("radius")?;
        if radius == 0.0 {
            Err(Fault::ZeroRadius("radius").into())
        } else {
            Ok(Shape::Sphere { centre, radius })
        }
    }

    /// Checks that a directive's line has no more words.
    pub(crate) fn end(&mut self, directive: &'static str) -> Result<(), LineError> {
        if !self.seek_in_line() {
            return Ok(());
        }
        let value = Excerpt::of(self.take()?);
        Err(Fault::Extra { entity: directive, value }.into())
    }

    /// Goes to the next word, on any line; false at the end of the file.
    fn seek(&mut self) -> Result<bool, LineError> {
        while !self.seek_in_line() {
            self.at = 0;
            if !self.lines.advance()? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Goes to the next word of the current line; false at the line's end.
    fn seek_in_line(&mut self) -> bool {
        let rest = &self.lines.bytes()[self.at..];
        self.at += rest.len() - rest.trim_ascii_start().len();
        self.at < self.lines.bytes().len()
    }

    /// The current word.
    fn peek(&self) -> Result<&str, Fault> {
        word_at(self.lines.bytes(), self.at)
    }

    /// Returns the current word, and moves on to the next.
    fn take(&mut self) -> Result<&str, LineError> {
        let word = word_at(self.lines.bytes(), self.at)?;
        self.at += word.len();
        Ok(word)
    }
}

/// The word that begins at a byte of a line.
fn word_at(line: &[u8], at: usize) -> Result<&str, Fault> {
    let rest = &line[at..];
    let end = rest.iter().position(u8::is_ascii_whitespace);
    let word = &rest[..end.unwrap_or(rest.len())];
    str::from_utf8(word).map_err(|error| Fault::NotText(at + error.valid_up_to() + 1))
}

/// The fault that a whole number is above a limit.
fn large(field: &'static str, value: &str, limit: usize) -> Fault {
    let value = Excerpt::of(value);
    Fault::LargeCount { field, value, limit }
}

/// Whether a word can only be meant as a number.
fn is_like_a_number(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
}

/// Parses a real number.
fn real(field: &'static str, token: &str) -> Result<f64, Fault> {
    let value: f64 =
        token.parse().map_err(|_| Fault::NotANumber { field, value: Excerpt::of(token) })?;
    if !value.is_finite() {
        return Err(Fault::NotFinite { field, value: Excerpt::of(token) });
    }
    if value.abs() > MAX_MAGNITUDE {
        return Err(Fault::TooLarge { field, value });
    }
    Ok(value)
}
