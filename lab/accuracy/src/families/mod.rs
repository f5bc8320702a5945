//! Scene families: named generators of one sphere and the rays that are sent to it.
//!
//! Invariant: everything consists of singles, made by basic arithmetic and roots from a seed, so a
//! family is the same on every host. [`FAMILIES`] describes each family in one row.

mod make;
pub mod triangles;

use crate::generator::{Generator, generator};
use protocol::formulation::SphereFormulation;
use serde::{Deserialize, Serialize};
use spu_emulator::float::single::to_f64;
use twins::Single;
use twins::sphere_ray::Ray;

use crate::truth::sphere::Crossing;
use crate::truth::{Line, Vector};

/// The number of packets with which a sphere is tested.
pub const PACKETS: usize = 16;

/// The origin of a kernel's rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Form {
    /// All rays start at 0, the eye. The sphere is only hit from outside.
    Eye,
    /// Rays start anywhere. The sphere is hit from inside, too.
    General,
}

impl Form {
    /// Both forms, in the tables' order.
    pub const ALL: [Self; 2] = [Self::Eye, Self::General];

    /// The form's name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Eye => "eye",
            Self::General => "general",
        }
    }

    /// The kernel that a formulation has for this form.
    pub const fn kernel(self, formulation: &SphereFormulation) -> Option<&'static str> {
        match self {
            Self::Eye => formulation.eye,
            Self::General => formulation.general,
        }
    }

    /// Of the points where a line crosses a sphere, the hit that this form's kernels must find,
    /// and the normal there.
    pub fn seen(self, crossing: &Crossing) -> Option<(f64, Vector)> {
        match self {
            Self::Eye => Some((crossing.entry, crossing.entry_normal)).filter(|(t, _)| *t > 0.0),
            Self::General => crossing.first(),
        }
    }
}

/// A family of scenes.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// The family's name.
    pub name: &'static str,
    /// A description of its contents.
    pub doc: &'static str,
    /// The forms in which it exists.
    pub forms: &'static [Form],
    /// The distance over the radius, if the family is about that.
    pub ratio: Option<f64>,
    /// The largest distance from the centre, in radii, at which a ray may pass for the error of
    /// its distance to count.
    pub counted: f64,
    /// Whether directions may have any length.
    pub any_length: bool,
    /// Makes a sphere and its rays.
    make: fn(&mut Generator, Form, f64) -> Shot,
    /// The generator's parameter: the ratio, or a size.
    parameter: f64,
}

/// A sphere and the rays sent to it.
#[derive(Clone, Debug)]
pub struct Shot {
    pub centre: [Single; 3],
    pub radius: Single,
    /// The rays.
    pub packets: Vec<[Ray; 16]>,
}

const BOTH: &[Form] = &[Form::Eye, Form::General];
const GENERAL: &[Form] = &[Form::General];

/// A family with one value of distance over radius.
const fn ratio(name: &'static str, ratio: f64) -> Family {
    Family {
        name,
        doc: "over the disc within 2 r",
        forms: BOTH,
        ratio: Some(ratio),
        counted: 0.9,
        any_length: false,
        make: make::at_ratio,
        parameter: ratio,
    }
}

/// A huge sphere used as a ground.
const fn ground(name: &'static str, radius: f64) -> Family {
    Family {
        name,
        doc: "eye 1 to 100 above, rays to within 20 times that",
        forms: BOTH,
        ratio: None,
        counted: 1.0,
        any_length: false,
        make: make::ground,
        parameter: radius,
    }
}

/// The family in which the paper's formula has no correct digits left.
pub const FAR: &str = "ratio 4096";

/// All families of spheres.
pub const FAMILIES: &[Family] = &[
    ratio("ratio 2", 2.0),
    ratio("ratio 4", 4.0),
    ratio("ratio 16", 16.0),
    ratio("ratio 64", 64.0),
    ratio("ratio 256", 256.0),
    ratio("ratio 1024", 1024.0),
    ratio(FAR, 4096.0),
    ratio("ratio 16384", 16384.0),
    ratio("ratio 65536", 65536.0),
    ratio("ratio 1e6", 1e6),
    Family {
        name: "grazing",
        doc: "8 r away, passing the centre at 0.999 to 1.001 r",
        counted: 1.0,
        ratio: None,
        make: make::grazing,
        ..ratio("", 8.0)
    },
    Family {
        name: "inside",
        doc: "from within half a radius of the centre",
        forms: GENERAL,
        counted: 1.0,
        ratio: None,
        make: make::inside,
        ..ratio("", 1.0)
    },
    ground("ground 1e4", 1e4),
    ground("ground 1e5", 1e5),
    ground("ground 1e6", 1e6),
    Family {
        name: "tiny",
        doc: "radius 1e-3, 1e3 away, over the disc within 2 r",
        ratio: None,
        make: make::tiny,
        ..ratio("", 1e-3)
    },
    Family {
        name: "coherent",
        doc: "packets of 4 x 4 neighbours with an origin each, 16 r away",
        forms: GENERAL,
        ratio: None,
        make: make::coherent,
        ..ratio("", 16.0)
    },
    Family {
        name: "incoherent",
        doc: "every ray with an origin of its own, 2 to 128 r away",
        forms: GENERAL,
        ratio: None,
        make: make::incoherent,
        ..ratio("", 0.0)
    },
    Family {
        name: "lengths",
        doc: "16 r away, directions of lengths 1/16 to 16",
        ratio: None,
        any_length: true,
        make: make::lengths,
        ..ratio("", 16.0)
    },
];

impl Family {
    /// This many spheres with [`PACKETS`] packets each.
    pub fn shots(&self, form: Form, seed: u64, spheres: usize) -> Vec<Shot> {
        let mut random = generator(seed, &[self.name, form.name()], 0);
        (0..spheres).map(|_| (self.make)(&mut random, form, self.parameter)).collect()
    }
}

/// The lines of the packets' rays.
fn lines(packets: &[[Ray; 16]]) -> impl Iterator<Item = Line> {
    let rays = packets.iter().flatten();
    rays.map(|ray| Line::new(ray.origin, ray.direction))
}

impl Shot {
    /// The rays as exact numbers.
    pub fn lines(&self) -> impl Iterator<Item = Line> {
        lines(&self.packets)
    }

    /// The exact centre.
    pub fn centre(&self) -> Vector {
        self.centre.map(to_f64)
    }

    /// The exact radius.
    pub fn radius(&self) -> f64 {
        to_f64(self.radius)
    }
}

#[cfg(test)]
mod tests;
