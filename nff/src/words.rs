//! The words of a line and what each may be.
//!
//! Invariant: a number that comes from here is finite and at most [`MAX_MAGNITUDE`] in size.

use std::str::SplitAsciiWhitespace;

use glam::DVec3;

use crate::error::Excerpt;
use crate::{Fault, LightKind, Material, Shader, Shape};

/// Largest magnitude of a number in a scene: the squares of differences of such numbers, and sums
/// of those, stay finite in an `f64`.
pub const MAX_MAGNITUDE: f64 = 1e150;

/// The words of a line: its keyword, if it has one, and what follows.
pub(crate) struct Words<'a> {
    rest: SplitAsciiWhitespace<'a>,
}

impl<'a> Words<'a> {
    pub(crate) fn of(text: &'a str) -> Self {
        Self {
            rest: text.split_ascii_whitespace(),
        }
    }

    /// The first word.
    pub(crate) fn keyword(&mut self) -> &'a str {
        self.rest.next().unwrap_or_default()
    }

    pub(crate) fn word(&mut self, field: &'static str) -> Result<&'a str, Fault> {
        self.rest.next().ok_or(Fault::Missing(field))
    }

    pub(crate) fn real(&mut self, field: &'static str) -> Result<f64, Fault> {
        real(field, self.word(field)?)
    }

    pub(crate) fn not_negative(&mut self, field: &'static str) -> Result<f64, Fault> {
        let value = self.real(field)?;
        if value < 0.0 {
            Err(Fault::Negative { field, value })
        } else {
            Ok(value)
        }
    }

    pub(crate) fn point(&mut self, fields: [&'static str; 3]) -> Result<DVec3, Fault> {
        let [x, y, z] = fields;
        Ok(DVec3::new(self.real(x)?, self.real(y)?, self.real(z)?))
    }

    pub(crate) fn vertex(&mut self) -> Result<DVec3, Fault> {
        self.point(["vertex x", "vertex y", "vertex z"])
    }

    pub(crate) fn colour(&mut self, fields: [&'static str; 3]) -> Result<DVec3, Fault> {
        let [red, green, blue] = fields;
        Ok(DVec3::new(
            self.not_negative(red)?,
            self.not_negative(green)?,
            self.not_negative(blue)?,
        ))
    }

    /// A side of the resolution; one beyond a u32 is as absurd as the largest u32.
    pub(crate) fn side(&mut self, field: &'static str) -> Result<u32, Fault> {
        Ok(u32::try_from(whole(field, self.word(field)?)?).unwrap_or(u32::MAX))
    }

    pub(crate) fn light(&mut self) -> Result<(LightKind, Option<DVec3>), Fault> {
        let position = self.point(["light x", "light y", "light z"])?;
        let colour = self.light_colour()?;
        self.end("light")?;
        Ok((LightKind::Point { position }, colour))
    }

    /// A light's colour, if there is one.
    pub(crate) fn light_colour(&mut self) -> Result<Option<DVec3>, Fault> {
        if self.more() {
            let colour = self.colour(["light red", "light green", "light blue"])?;
            Ok(Some(colour))
        } else {
            Ok(None)
        }
    }

    /// Whether the line goes on.
    pub(crate) fn more(&self) -> bool {
        self.rest.clone().next().is_some()
    }

    /// A material, for who knows its line to fill that in.
    pub(crate) fn material(&mut self) -> Result<Material, Fault> {
        let material = Material {
            line: 0,
            colour: self.colour(["material red", "material green", "material blue"])?,
            diffuse: self.not_negative("Kd")?,
            specular: self.not_negative("Ks")?,
            shine: self.not_negative("shine")?,
            transmittance: self.not_negative("T")?,
            refraction_index: self.not_negative("index of refraction")?,
            shader: Shader::Phong,
        };
        self.end("material")?;
        Ok(material)
    }

    pub(crate) fn sphere(&mut self) -> Result<Shape, Fault> {
        let centre = self.point(["centre x", "centre y", "centre z"])?;
        let radius = self.real("radius")?;
        self.end("sphere")?;
        if radius == 0.0 {
            Err(Fault::ZeroRadius("radius"))
        } else {
            Ok(Shape::Sphere { centre, radius })
        }
    }

    pub(crate) fn count(&mut self, entity: &'static str) -> Result<u64, Fault> {
        let count = whole("number of vertices", self.word("number of vertices")?)?;
        self.end(entity)?;
        Ok(count)
    }

    pub(crate) fn end(&mut self, entity: &'static str) -> Result<(), Fault> {
        match self.rest.next() {
            Some(word) => Err(Fault::Extra {
                entity,
                value: Excerpt::of(word),
            }),
            None => Ok(()),
        }
    }
}

/// The real number that `token` is.
fn real(field: &'static str, token: &str) -> Result<f64, Fault> {
    let value: f64 = token.parse().map_err(|_| Fault::NotANumber {
        field,
        value: Excerpt::of(token),
    })?;
    if !value.is_finite() {
        return Err(Fault::NotFinite {
            field,
            value: Excerpt::of(token),
        });
    }
    if value.abs() > MAX_MAGNITUDE {
        return Err(Fault::TooLarge { field, value });
    }
    Ok(value)
}

/// The whole number, not negative, that `token` is.
fn whole(field: &'static str, token: &str) -> Result<u64, Fault> {
    token.parse().map_err(|_| Fault::NotACount {
        field,
        value: Excerpt::of(token),
    })
}
