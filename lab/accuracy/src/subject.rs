//! The subjects of measurements: a formulation in a form, its kernel, and how it is called.

use kernels::Bench;
use kernels::cases::spheres::{self, EyeSphere};
use kernels::cases::whitted::isect::sphere::SphereObject;
use kernels::eye_records::Vectors;
use protocol::formulation::{EyeRecord, SPHERES, SphereFormulation};
use spu_emulator::float::single::to_f64;
use twins::Single;
use twins::pairs::Sides;

use crate::families::{Form, Shot};
use crate::space::{dot, nearest, point, unit};
use crate::truth::sphere::Sphere;

/// The only formulation for directions of any length. Its `t` is a parameter, not a distance.
pub const ANY_LENGTH: &str = "unnormalised";

/// A formulation of a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Subject {
    /// The formulation.
    pub formulation: &'static SphereFormulation,
    /// The form of its rays.
    pub form: Form,
    /// The kernel.
    pub kernel: &'static str,
}

/// All formulations in all of their forms.
pub fn all() -> impl Iterator<Item = Subject> {
    Form::ALL.into_iter().flat_map(|form| {
        SPHERES.iter().filter_map(move |formulation| {
            Some(Subject { formulation, form, kernel: form.kernel(formulation)? })
        })
    })
}

/// A shot's sphere in the form that a kernel receives.
#[derive(Clone, Copy, Debug)]
pub enum Given {
    /// As a record for primary rays.
    Eye(EyeSphere),
    /// As an object of a scene.
    General(SphereObject),
}

/// A sphere that is visible from inside and outside.
pub fn sphere(centre: [Single; 3], radius: Single) -> SphereObject {
    SphereObject { centre, offset: radius, sides: Sides { both: true, exit: false } }
}

impl Given {
    /// A shot's sphere for a form and a type of record.
    pub fn new(form: Form, record: EyeRecord, shot: &Shot) -> Self {
        let radius = shot.radius();
        match (form, record) {
            (Form::Eye, EyeRecord::Centre) => Self::Eye(EyeSphere::Centre {
                centre: shot.centre,
                radius_squared: nearest(radius * radius),
            }),
            (Form::Eye, EyeRecord::Axis) => {
                let centre = shot.centre();
                let square = dot(centre, centre);
                Self::Eye(EyeSphere::Axis {
                    axis: point(unit(centre)),
                    k: nearest(radius * radius / square),
                    distance: nearest(square.sqrt()),
                })
            }
            (Form::General, _) => Self::General(sphere(shot.centre, shot.radius)),
        }
    }

    /// The exact sphere that the record represents.
    pub fn sphere(&self) -> Sphere {
        match *self {
            Self::Eye(EyeSphere::Centre { centre, radius_squared }) => {
                Sphere::of_radius_squared(centre, radius_squared)
            }
            Self::Eye(EyeSphere::Axis { axis, k, distance }) => Sphere::of_axis(axis, k, distance),
            Self::General(object) => Sphere::of_radius(object.centre, object.offset),
        }
    }
}

impl Subject {
    /// A shot's sphere in the form that this kernel receives.
    pub fn given(&self, shot: &Shot) -> Given {
        Given::new(self.form, self.formulation.record, shot)
    }

    /// The kernel's result for each ray of a shot: the distance or parameter of its hit.
    pub fn hits(&self, bench: &mut Bench, shot: &Shot) -> Vec<Option<f64>> {
        let hits = match self.given(shot) {
            Given::Eye(sphere) => {
                let directions = shot.packets.iter();
                let directions: Vec<Vectors> =
                    directions.map(|rays| rays.map(|ray| ray.direction)).collect();
                spheres::eye(bench, self.kernel, &directions, &sphere)
            }
            Given::General(sphere) => spheres::general(bench, self.kernel, &shot.packets, &sphere),
        };
        let hits = hits.into_iter().flatten();
        hits.map(|t| t.map(to_f64)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulation_for_any_length_is_in_table() {
        assert!(all().any(|subject| subject.formulation.name == ANY_LENGTH));
    }

    #[test]
    fn every_formulation_has_its_forms() {
        for formulation in SPHERES {
            let forms = all().filter(|subject| subject.formulation == formulation);
            let kernels = [formulation.eye, formulation.general].into_iter().flatten();
            assert_eq!(forms.count(), kernels.count(), "{}", formulation.name);
        }
    }
}
