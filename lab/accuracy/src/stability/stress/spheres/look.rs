//! A ray, a sphere, what is so of them and what a kernel says: in what its header counts errors.

use crate::families::Form;
use crate::space::{length, less};
use crate::stability::statement::{StatementError, says, stated};
use crate::subject::{ANY_LENGTH, Subject};
use crate::truth::sphere::{Passing, Sphere};
use crate::truth::{Line, spacing};

/// The formulation that takes the square of the radius off that of the distance.
const PAPER: &str = "paper";
/// How far from a tangent the verdict may be wrong, in ulps of the larger of distance and radius
/// (and by the paper's formula, times the distance in radii): of the radius and of the
/// perpendicular each coordinate is rounded, and so is each of the discriminant's sums.
pub const TANGENT: f64 = 8.0;
/// How far from the surface, in ulps of the radius, the side of the origin may be taken for the
/// other: the square of the distance less that of the radius is rounded once in each of its sums.
const SURFACE: f64 = 8.0;
/// The part of what decides a tangent beyond which the discriminant has digits for the root.
const ROOT: f64 = 0.25;
/// What a header says of a kernel's error.
#[derive(Clone, Copy, Debug)]
pub struct Stated {
    /// In ulps.
    pub error: f64,
    /// Of the larger of t and r; else of t.
    pub of_larger: bool,
    /// How near to the centre, in radii, the eye may be.
    pub nearest: f64,
    /// How far from the centre, in radii, the origin may be.
    pub radii: f64,
    /// How far from the centre, in radii, the ray may pass.
    pub within: f64,
}

/// One ray, one sphere, what is so and what the kernel says.
pub struct Look {
    /// The kernel.
    pub subject: Subject,
    /// What it says of its error.
    pub stated: Stated,
    /// How the ray passes the sphere.
    pub passing: Passing,
    /// Distance of the origin from the centre.
    pub distance: f64,
    /// The radius.
    pub radius: f64,
    /// How far from 1 the direction's length is.
    off_length: f64,
    /// What is first seen.
    pub exact: Option<f64>,
    /// What the kernel says.
    pub found: Option<f64>,
}

impl Stated {
    /// What the header of a kernel says.
    pub fn of(subject: &Subject) -> Result<Self, StatementError> {
        let kernel = subject.kernel;
        Ok(Self {
            error: stated(kernel, "")?,
            of_larger: says(kernel, "ulp of the larger of t and r"),
            nearest: match subject.form {
                Form::Eye => stated(kernel, "to")?,
                Form::General => 0.0,
            },
            radii: stated(kernel, "radii")?,
            within: stated(kernel, "r of it")?,
        })
    }

    /// How far from the surface, in ulps of the radius, the side of the origin may be taken for
    /// the other, or a hit be lost because its distance, being less than its error, is not above
    /// 0.
    pub fn surface(&self) -> f64 {
        SURFACE + self.error
    }
}

impl Look {
    /// A ray and a sphere, and the distance or parameter that a kernel says.
    pub fn new(
        subject: Subject,
        stated: Stated,
        sphere: &Sphere,
        line: &Line,
        found: Option<f64>,
    ) -> Self {
        let passing = sphere.passing(line);
        let seen = passing
            .crossing
            .and_then(|crossing| subject.form.seen(&crossing));
        let unit = length(line.direction);
        let found = found.map(|t| match subject.formulation.name {
            ANY_LENGTH => t * unit,
            _ => t,
        });
        Self {
            subject,
            stated,
            passing,
            distance: length(less(line.origin, sphere.centre())),
            radius: sphere.radius(),
            off_length: (unit - 1.0).abs(),
            exact: seen.map(|(t, _)| t),
            found,
        }
    }

    /// Whether hit or miss is right.
    pub fn agrees(&self) -> bool {
        self.exact.is_some() == self.found.is_some()
    }

    /// Whether the kernel takes the square of the radius off that of the distance.
    fn squares(&self) -> bool {
        self.subject.formulation.name == PAPER
    }

    /// How far the ray passes from a tangent, in what decides it.
    pub fn off_tangent(&self) -> f64 {
        let larger = self.distance.max(self.radius);
        let grown = if self.squares() {
            larger / self.radius
        } else {
            1.0
        };
        self.passing.beyond.abs() * self.radius / (spacing(larger) * grown)
    }

    /// How far the origin is from the surface, in ulps of the radius.
    pub fn off_surface(&self) -> f64 {
        (self.distance - self.radius).abs() / spacing(self.radius)
    }

    /// By how much more than in the stated domain rounding moves the distance.
    fn condition(&self) -> f64 {
        let edge = 1.0 / (1.0 - self.stated.within * self.stated.within).sqrt();
        // beyond = -root^2 / 2 r^2.
        let steepness = 1.0 / (-2.0 * self.passing.beyond).max(0.0).sqrt();
        if self.squares() {
            // An ulp of a square may be twice as large a part of it as one of the distance.
            let chords = 2.0 * (self.distance / self.radius).max(1.0) * steepness;
            (chords / (self.stated.radii * edge)).max(1.0)
        } else {
            (steepness / edge).max(1.0)
        }
    }

    /// Whether hit or miss is decided by more than rounding, where the kernel is for.
    pub fn is_sure(&self) -> bool {
        self.distance >= self.stated.nearest * self.radius
            && self.off_tangent() >= TANGENT
            && self.off_surface() >= self.stated.surface()
    }

    /// Whether the discriminant has digits for the root, too.
    pub fn has_root(&self) -> bool {
        self.is_sure() && self.off_tangent() * ROOT > TANGENT
    }

    /// The same of a hit; a sure miss needs no root.
    pub fn has_root_or_misses(&self) -> bool {
        self.is_sure() && (self.exact.is_none() || self.has_root())
    }

    /// What the header counts the error of this distance in, at the condition of its domain.
    pub fn unit(&self, exact: f64) -> f64 {
        let least = if self.stated.of_larger {
            self.radius
        } else {
            exact
        };
        spacing(exact.max(least)) * self.condition()
    }

    /// What the direction's own length moves of a distance. Where less than an ulp is stated, it
    /// is not in it: the direction is taken to be of length 1 as it is given.
    pub fn given(&self) -> f64 {
        if self.stated.error < 1.0 {
            self.off_length * self.distance
        } else {
            0.0
        }
    }

    /// Ulps of the header that the distance is off, at the condition of its domain.
    pub fn ulps(&self, found: f64, exact: f64) -> f64 {
        ((found - exact).abs() - self.given()).max(0.0) / self.unit(exact)
    }
}
