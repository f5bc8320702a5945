//! A ray and a sphere, the exact result and the kernel's result, in the units of its header's
//! errors.

use crate::stability::prelude::*;
use crate::stability::statement::{StatementError, states};
use crate::subject::ANY_LENGTH;
use crate::truth::sphere::{Passing, Sphere};

/// The formulation that subtracts the square of the radius from that of the distance.
const PAPER: &str = "paper";
/// How far from a tangent the verdict may be wrong, in ulps of the larger of distance and radius.
/// With the paper's formula, this is multiplied by the distance in radii. The causes are the
/// rounding of the radius, of each coordinate of the perpendicular, and of each sum in the
/// discriminant.
pub const TANGENT: f64 = 8.0;
/// How far from the surface, in ulps of the radius, the origin may be taken to be on the wrong
/// side. The cause is the rounding of each sum in the difference of the squares of distance and
/// radius.
const SURFACE: f64 = 8.0;
/// The share of the tangent's bound above which the discriminant has enough digits for the root.
const ROOT: f64 = 0.25;
/// What a header states about a kernel's error.
#[derive(Clone, Copy, Debug)]
pub struct Stated {
    /// The error in ulps.
    pub error: f64,
    /// Whether these are ulps of the larger of t and r, and not of t.
    pub of_larger: bool,
    /// The smallest distance of the eye from the centre, in radii.
    pub nearest: f64,
    /// The largest distance of the origin from the centre, in radii.
    pub radii: f64,
    /// The largest distance from the centre, in radii, at which the ray may pass.
    pub within: f64,
}

/// One ray, one sphere, the exact result and the kernel's.
pub struct Look {
    /// The kernel.
    pub subject: Subject,
    /// What its header states about its error.
    pub stated: Stated,
    /// How the ray passes the sphere.
    pub passing: Passing,
    /// The distance of the origin from the centre.
    pub distance: f64,
    /// The radius.
    pub radius: f64,
    /// The difference of the direction's length from 1.
    off_length: f64,
    /// The exact distance of the visible hit.
    pub exact: Option<f64>,
    /// The kernel's result.
    pub found: Option<f64>,
}

impl Stated {
    /// Reads a kernel's header.
    pub fn of(subject: &Subject) -> Result<Self, StatementError> {
        let kernel = subject.kernel;
        Ok(Self {
            error: stated(kernel, "")?,
            of_larger: states(kernel, "ulp of the larger of t and r"),
            nearest: match subject.form {
                Form::Eye => stated(kernel, "to")?,
                Form::General => 0.0,
            },
            radii: stated(kernel, "radii")?,
            within: stated(kernel, "r of it")?,
        })
    }

    /// How far from the surface, in ulps of the radius, the origin may be taken to be on the wrong
    /// side. Also how far a hit may be lost because its distance is less than its error and
    /// therefore not above 0.
    pub fn surface(&self) -> f64 {
        SURFACE + self.error
    }
}

impl Look {
    /// A ray, a sphere, and the distance or parameter that a kernel found.
    pub fn new(
        subject: Subject,
        stated: Stated,
        sphere: &Sphere,
        line: &Line,
        found: Option<f64>,
    ) -> Self {
        let passing = sphere.passing(line);
        let seen = passing.crossing.and_then(|crossing| subject.form.seen(&crossing));
        let unit = length(line.direction);
        let found = found.map(|t| match subject.formulation.name {
            ANY_LENGTH => t * unit,
            _ => t,
        });
        Self {
            subject,
            stated,
            passing,
            distance: length(sub(line.origin, sphere.centre())),
            radius: sphere.radius(),
            off_length: (unit - 1.0).abs(),
            exact: seen.map(|(t, _)| t),
            found,
        }
    }

    /// Whether the verdict, hit or miss, is right.
    pub fn agrees(&self) -> bool {
        self.exact.is_some() == self.found.is_some()
    }

    /// Whether the kernel subtracts the square of the radius from that of the distance.
    fn squares(&self) -> bool {
        self.subject.formulation.name == PAPER
    }

    /// How far the ray passes from a tangent, in units of the tangent's bound.
    pub fn off_tangent(&self) -> f64 {
        let larger = self.distance.max(self.radius);
        let grown = if self.squares() { larger / self.radius } else { 1.0 };
        self.passing.beyond.abs() * self.radius / (spacing(larger) * grown)
    }

    /// The distance of the origin from the surface, in ulps of the radius.
    pub fn off_surface(&self) -> f64 {
        (self.distance - self.radius).abs() / spacing(self.radius)
    }

    /// By how much more rounding moves the distance here than in the stated domain.
    fn condition(&self) -> f64 {
        let edge = 1.0 / (1.0 - self.stated.within * self.stated.within).sqrt();
        // beyond = -root^2 / 2 r^2.
        let steepness = 1.0 / (-2.0 * self.passing.beyond).max(0.0).sqrt();
        if self.squares() {
            // Relative to its number, an ulp of a square may be twice as large as an ulp of the
            // distance.
            let chords = 2.0 * (self.distance / self.radius).max(1.0) * steepness;
            (chords / (self.stated.radii * edge)).max(1.0)
        } else {
            (steepness / edge).max(1.0)
        }
    }

    /// Whether the verdict is decided by more than rounding, in the domain of the kernel.
    pub fn is_sure(&self) -> bool {
        self.distance >= self.stated.nearest * self.radius
            && self.off_tangent() >= TANGENT
            && self.off_surface() >= self.stated.surface()
    }

    /// Whether the discriminant also has enough digits for the root.
    pub fn has_root(&self) -> bool {
        self.is_sure() && self.off_tangent() * ROOT > TANGENT
    }

    /// The same for a hit. A clear miss needs no root.
    pub fn has_root_or_misses(&self) -> bool {
        self.is_sure() && (self.exact.is_none() || self.has_root())
    }

    /// The unit in which the header states the error of this distance, under the condition of its
    /// domain.
    pub fn unit(&self, exact: f64) -> f64 {
        let minimum = if self.stated.of_larger { self.radius } else { exact };
        spacing(exact.max(minimum)) * self.condition()
    }

    /// By how much the direction's length moves a distance. Headers that state less than an ulp
    /// exclude this: they treat the given direction as having length 1.
    pub fn given(&self) -> f64 {
        if self.stated.error < 1.0 { self.off_length * self.distance } else { 0.0 }
    }

    /// The error of the distance in the header's ulps, under the condition of its domain.
    pub fn ulps(&self, found: f64, exact: f64) -> f64 {
        ((found - exact).abs() - self.given()).max(0.0) / self.unit(exact)
    }
}
