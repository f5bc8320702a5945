//! Generates the other scenes of the Standard Procedural Databases (SPD): all but the sphereflake
//! and the tetrahedra, which have modules of their own.
//!
//! Owns the table of scenes, the names of their sizes, and what they have in common. Sources: SPD
//! 3.14, dedicated to the public, for formulas and parameters. Invariant: a generated scene's
//! line numbers are those of its own text, and all its numbers are finite.

mod builder;
mod gears;
mod jacks;
mod lattice;
mod mount;
mod rings;
mod shells;
mod sombrero;
mod teapot;
mod tree;

use crate::names::{Count, largest};
use crate::{Excerpt, Limits, Scene};
use builder::Builder;

/// A kind of scene that is generated in any of several sizes, by the name `NAME` or `NAME:SIZE`.
#[derive(Debug)]
pub struct Generator {
    /// SPD's name.
    pub name: &'static str,
    /// The size if none is given: that of SPD's published statistics, or of its program if there
    /// are none.
    pub default: u32,
    /// The largest size for which SPD's recipe is defined.
    most: u32,
    /// The number of objects of a size, or a large number if that is larger.
    objects: fn(u32) -> u128,
    build: fn(u32) -> Builder,
}

/// All kinds of scenes.
pub const GENERATORS: [Generator; 9] = [
    gears::GENERATOR,
    mount::GENERATOR,
    rings::GENERATOR,
    tree::GENERATOR,
    teapot::GENERATOR,
    lattice::GENERATOR,
    jacks::GENERATOR,
    shells::GENERATOR,
    sombrero::GENERATOR,
];

/// Why a scene can't be generated.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// The size is not a number above 0.
    #[error("{name} size {size} is not a whole number from 1")]
    Size {
        /// The kind of scene.
        name: &'static str,
        /// The requested size.
        size: Excerpt,
    },
    /// SPD's recipe is not defined for the size.
    #[error("{name} of size {size}: SPD defines sizes up to {most}")]
    Undefined {
        /// The kind of scene.
        name: &'static str,
        /// The requested size.
        size: u32,
        /// The largest size.
        most: u32,
    },
    /// The scene exceeds the default [`Limits`].
    #[error(
        "{name} of size {size} has {} objects, more than {limit}; the largest size is {largest}", Count(*count)
    )]
    TooMany {
        /// The kind of scene.
        name: &'static str,
        /// The requested size.
        size: u32,
        /// The number of its objects, or `u128::MAX` if that is larger.
        count: u128,
        /// The most objects.
        limit: usize,
        /// The largest size within the limit.
        largest: u32,
    },
}

impl Generator {
    /// The number of objects of a size, or `u128::MAX` if that is larger.
    #[must_use]
    pub fn object_count(&self, size: u32) -> u128 {
        (self.objects)(size)
    }

    /// Generates the scene of a size from 1.
    ///
    /// # Errors
    /// SPD does not define the size, or it has more objects than the default [`Limits`] allow.
    pub fn generate(&self, size: u32) -> Result<Scene, Error> {
        let Self { name, most, .. } = *self;
        if size == 0 {
            let size = Excerpt::of("0");
            return Err(Error::Size { name, size });
        }
        if size > most {
            return Err(Error::Undefined { name, size, most });
        }
        let limit = Limits::default().objects;
        let count = self.object_count(size);
        // Below the limit all numbers of objects, vertices and lines fit a u32.
        if count > limit as u128 {
            return Err(Error::TooMany {
                name,
                size,
                count,
                limit,
                largest: largest(limit, self.objects),
            });
        }
        Ok((self.build)(size).finish(format!("{name}:{size}")))
    }
}

/// The scene of a name `NAME` or `NAME:SIZE`; `None` if the name is not one of a kind of scene.
pub(crate) fn named(text: &str) -> Option<Result<Scene, Error>> {
    let (name, size) = match text.split_once(':') {
        Some((name, size)) => (name, Some(size)),
        None => (text, None),
    };
    let generator = GENERATORS.iter().find(|generator| generator.name == name)?;
    let size = match size {
        None => Ok(generator.default),
        Some(size) => {
            size.parse().map_err(|_| Error::Size { name: generator.name, size: Excerpt::of(size) })
        }
    };
    Some(size.and_then(|size| generator.generate(size)))
}
