//! Spheres with difficult inputs, for all formulations: any scale and distance, rays within ulps
//! of a tangent, and eyes within ulps of a surface.
//!
//! A header states the error in a domain. Outside it, the error grows like the formulation's
//! rounding. One factor is how strongly the distance depends on the sphere's position, which is
//! one over the cosine of the ray's incidence. For the difference of the squares of distance and
//! radius, the distance in chords is another factor. Bounds are scaled by these factors and by
//! nothing else.

mod look;
mod make;
mod nearest;

use crate::families::Shot;
use crate::stability::family::Judgement;
use crate::stability::prelude::*;
use crate::subject;
use look::{Look, Stated};

pub use look::TANGENT;

/// The number of spheres in a round.
const SPHERES: u32 = 16;

/// A kind of cases.
struct Kind {
    name: &'static str,
    unit: &'static str,
    forms: &'static [Form],
    make: fn(&mut Generator, Form) -> Shot,
    judge: fn(&Look) -> Judgement,
    bound: fn(&Subject, &Stated) -> Bound,
}

/// A kind of cases for a formulation.
struct Spheres {
    kind: &'static Kind,
    subject: Subject,
    stated: Stated,
}

const KINDS: &[Kind] = &[
    Kind {
        name: "sphere-scales",
        unit: "ulp of t or r, by the condition",
        forms: &[Form::Eye, Form::General],
        make: make::scales,
        judge: distance_error,
        bound: |subject, stated| Bound {
            value: stated.error,
            source: format!("header of {}", subject.kernel),
        },
    },
    Kind {
        name: "sphere-grazing",
        unit: "ulp of the distance, off the tangent",
        forms: &[Form::Eye, Form::General],
        make: make::grazing,
        judge: |look| Judgement::unless(look.agrees(), || look.off_tangent()),
        bound: |_, _| Bound { value: TANGENT, source: "roundings of the discriminant".to_owned() },
    },
    Kind {
        name: "sphere-surface",
        unit: "ulp of r, off surface or tangent",
        forms: &[Form::General],
        make: make::surface,
        judge: side_error,
        bound: |subject, stated| Bound {
            value: stated.surface(),
            source: format!("header of {}, and the side's rounding", subject.kernel),
        },
    },
];

/// All kinds for all formulations whose kernels exist.
pub fn families() -> Families {
    let mut families = Vec::new();
    for kind in KINDS {
        let subjects = subject::all().filter(|subject| kind.forms.contains(&subject.form));
        for subject in subjects.filter(|subject| Source::find(subject.kernel).is_some()) {
            let stated = Stated::of(&subject)?;
            families.push(Family {
                name: kind.name,
                subject: subject.kernel.to_owned(),
                unit: kind.unit,
                bound: (kind.bound)(&subject, &stated),
                rounds: 800,
                cases: Box::new(Spheres { kind, subject, stated }),
            });
        }
    }
    families.extend(nearest::families()?);
    Ok(families)
}

/// Judges whether hits are found exactly where they exist, and the error of their distances.
fn distance_error(look: &Look) -> Judgement {
    match (look.found, look.exact) {
        _ if !look.is_sure() => Judgement::Uncounted,
        (None, None) => Judgement::Error(0.0),
        (Some(found), Some(exact)) if look.has_root() => Judgement::Error(look.ulps(found, exact)),
        (Some(_), Some(_)) => Judgement::Uncounted,
        _ => Judgement::Wrong,
    }
}

/// If the wrong wall or none is hit, how far this is from where rounding may decide it.
fn side_error(look: &Look) -> Judgement {
    let right = match (look.found, look.exact) {
        (Some(found), Some(exact)) => {
            let chord = (-2.0 * look.passing.beyond).max(0.0).sqrt() * look.radius;
            (found - exact).abs() < chord
        }
        (found, exact) => found.is_some() == exact.is_some(),
    };
    Judgement::unless(right, || look.off_surface().min(look.off_tangent()))
}

impl Spheres {
    /// Tries a sphere's rays.
    fn shoot(&self, bench: &mut Bench, shot: &Shot, tally: &mut Tally) {
        let sphere = self.subject.given(shot).sphere();
        let found = self.subject.hits(bench, shot);
        for (ray, found) in shot.packets.iter().flatten().zip(found) {
            let line = Line::new(ray.origin, ray.direction);
            let look = Look::new(self.subject, self.stated, &sphere, &line, found);
            let input = || {
                let words = [&shot.centre[..], &[shot.radius], &ray.origin, &ray.direction];
                words.concat()
            };
            tally.judged((self.kind.judge)(&look), input);
        }
    }
}

impl Cases for Spheres {
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        for _ in 0..SPHERES {
            let shot = (self.kind.make)(random, self.subject.form);
            self.shoot(bench, &shot, tally);
        }
    }

    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed {
        need(10, words)?;
        let point = |at: usize| [0, 1, 2].map(|k| words[at + k]);
        let shot = Shot {
            centre: point(0),
            radius: words[3],
            packets: vec![[fresh(point(4), point(7)); 16]],
        };
        self.shoot(bench, &shot, tally);
        Ok(())
    }
}
