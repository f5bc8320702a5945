//! Spheres under stress, by all formulations: any scale and distance, rays within ulps of a tangent, eyes
//! within ulps of a surface.
//!
//! A header states the error of a domain. Beyond it the error grows as the formulation's rounding does: by
//! how steeply the distance changes with the sphere's place, which is one over the cosine of the ray's
//! incidence; and for the square of the distance less that of the radius, by the distance in chords
//! besides. Bounds are scaled by that, and only by that.

use kernels::Bench;
use kernels::source::Source;
use kernels::vector::{Vector, dot, less, unit};
use oracle::twin::FARTHEST;
use oracle::twin::ball::Ray;
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, to_f64};

use super::family::{Family, NoCaseError, Tally, words_of};
use super::random::{across, magnitude, rounded};
use super::statement::{Bound, StatementError, says, stated};
use crate::families::space::direction;
use crate::families::{Form, Shot};
use crate::subject::{self, ANY_LENGTH, Subject};
use crate::truth::sphere::Passing;
use crate::truth::{Line, spacing};

/// The formulation that takes the square of the radius off that of the distance.
const PAPER: &str = "paper";
/// How far from a tangent the verdict may be wrong, in ulps of the larger of distance and radius (and for
/// [`PAPER`] times the distance in radii): of the radius and of the perpendicular each coordinate is
/// rounded, and so is each of the discriminant's sums.
pub const TANGENT: f64 = 8.0;
/// How far from the surface, in ulps of the radius, the side of the origin may be taken for the other: the
/// square of the distance less that of the radius is rounded once in each of its sums.
const SURFACE: f64 = 8.0;
/// The part of what decides a tangent beyond which the discriminant has digits for the root.
const ROOT: f64 = 0.25;
/// Spheres of a round.
const SPHERES: u32 = 16;
/// Packets of a sphere.
const PACKETS: usize = 2;

/// What a header says of a kernel's error.
#[derive(Clone, Copy, Debug)]
struct Stated {
    /// In ulps.
    error: f64,
    /// Of the larger of t and r; else of t.
    of_larger: bool,
    /// How far from the centre, in radii, the origin may be.
    radii: f64,
    /// How far from the centre, in radii, the ray may pass.
    within: f64,
}

/// A kind of cases.
struct Kind {
    name: &'static str,
    unit: &'static str,
    forms: &'static [Form],
    make: fn(&mut ChaCha8Rng, Form) -> Shot,
    judge: fn(&Look) -> Judgement,
    bound: fn(&Subject, &Stated) -> Bound,
}

/// A kind of cases on a formulation.
struct Spheres {
    kind: &'static Kind,
    subject: Subject,
    stated: Stated,
}

/// One ray, one sphere, what is so and what the kernel says.
struct Look {
    subject: Subject,
    stated: Stated,
    passing: Passing,
    /// Distance of the origin from the centre.
    distance: f64,
    radius: f64,
    /// What is first seen.
    exact: Option<f64>,
    found: Option<f64>,
}

enum Judgement {
    Uncounted,
    Wrong,
    Error(f64),
}

const KINDS: &[Kind] = &[
    Kind {
        name: "sphere-scales",
        unit: "ulp of t or r, by the condition",
        forms: &[Form::Eye, Form::General],
        make: scales,
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
        make: grazing,
        judge: |look| Judgement::Error(if look.agrees() { 0.0 } else { look.off_tangent() }),
        bound: |_, _| Bound {
            value: TANGENT,
            source: "roundings of the discriminant".to_owned(),
        },
    },
    Kind {
        name: "sphere-surface",
        unit: "ulp of r, off surface or tangent",
        forms: &[Form::General],
        make: surface,
        judge: side_error,
        bound: |_, _| Bound {
            value: SURFACE,
            source: "roundings of the distance's square".to_owned(),
        },
    },
];

/// All kinds on all formulations whose kernels there are.
///
/// # Errors
/// A header does not state its error, or of what domain.
pub fn families() -> Result<Vec<Box<dyn Family>>, StatementError> {
    let mut families: Vec<Box<dyn Family>> = Vec::new();
    for kind in KINDS {
        for subject in subject::all() {
            if kind.forms.contains(&subject.form) && Source::find(subject.kernel).is_some() {
                families.push(Box::new(Spheres {
                    kind,
                    subject,
                    stated: Stated::of(subject.kernel)?,
                }));
            }
        }
    }
    Ok(families)
}

impl Stated {
    fn of(kernel: &str) -> Result<Self, StatementError> {
        Ok(Self {
            error: stated(kernel, "")?,
            of_larger: says(kernel, "ulp of the larger of t and r"),
            radii: stated(kernel, "radii")?,
            within: stated(kernel, "r of it")?,
        })
    }
}

impl Look {
    /// Whether hit or miss is right.
    fn agrees(&self) -> bool {
        self.exact.is_some() == self.found.is_some()
    }

    /// Whether the kernel takes the square of the radius off that of the distance.
    fn squares(&self) -> bool {
        self.subject.formulation.name == PAPER
    }

    /// How far the ray passes from a tangent, in what decides it.
    fn off_tangent(&self) -> f64 {
        let larger = self.distance.max(self.radius);
        let grown = if self.squares() { larger / self.radius } else { 1.0 };
        self.passing.beyond.abs() * self.radius / (spacing(larger) * grown)
    }

    /// How far the origin is from the surface, in ulps of the radius.
    fn off_surface(&self) -> f64 {
        (self.distance - self.radius).abs() / spacing(self.radius)
    }

    /// By how much more than in the stated domain rounding moves the distance.
    fn condition(&self) -> f64 {
        let edge = 1.0 / (1.0 - self.stated.within * self.stated.within).sqrt();
        // beyond = -root^2 / 2 r^2.
        let steepness = 1.0 / (-2.0 * self.passing.beyond).max(0.0).sqrt();
        if self.squares() {
            let chords = (self.distance / self.radius).max(1.0) * steepness;
            (chords / (self.stated.radii * edge)).max(1.0)
        } else {
            (steepness / edge).max(1.0)
        }
    }

    /// Ulps of the header that the distance is off, at the condition of its domain.
    fn ulps(&self, found: f64, exact: f64) -> f64 {
        let size = if self.stated.of_larger {
            exact.max(self.radius)
        } else {
            exact
        };
        (found - exact).abs() / spacing(size) / self.condition()
    }
}

/// Hits where they are and only there, and their distances.
fn distance_error(look: &Look) -> Judgement {
    let decided = look.off_tangent();
    match (look.found, look.exact) {
        _ if decided < TANGENT || look.off_surface() < SURFACE => Judgement::Uncounted,
        (None, None) => Judgement::Error(0.0),
        (Some(found), Some(exact)) if decided * ROOT > TANGENT => {
            Judgement::Error(look.ulps(found, exact))
        }
        (Some(_), Some(_)) => Judgement::Uncounted,
        _ => Judgement::Wrong,
    }
}

/// How far from where rounding may decide it the wrong wall is taken, or none.
fn side_error(look: &Look) -> Judgement {
    let right = match (look.found, look.exact) {
        (Some(found), Some(exact)) => {
            let chord = (-2.0 * look.passing.beyond).max(0.0).sqrt() * look.radius;
            (found - exact).abs() < chord
        }
        (found, exact) => found.is_some() == exact.is_some(),
    };
    Judgement::Error(if right {
        0.0
    } else {
        look.off_surface().min(look.off_tangent())
    })
}

fn ray(origin: Vector, way: Vector) -> Ray {
    Ray {
        origin: origin.map(from_f64),
        direction: way.map(from_f64),
        t: FARTHEST,
        object: 0,
    }
}

/// A sphere about a place that singles have, and the rays that `make` makes of origin and centre.
fn shot(
    centre: Vector,
    radius: f64,
    random: &mut ChaCha8Rng,
    make: impl Fn(&mut ChaCha8Rng) -> (Vector, Vector),
) -> Shot {
    let packets = (0..PACKETS).map(|_| {
        std::array::from_fn(|_| {
            let (origin, way) = make(random);
            ray(origin, way)
        })
    });
    Shot {
        centre: centre.map(from_f64),
        radius: from_f64(radius),
        packets: packets.collect(),
    }
}

/// Radii from 1e-6 to 1e6, origins from the surface to 1e6 radii away, rays to all of the sphere and past it.
fn scales(random: &mut ChaCha8Rng, form: Form) -> Shot {
    let radius = magnitude(-20, 20, random);
    // The eye is outside, and of its header's domain at least.
    let distance = radius * if form == Form::Eye { 1.5 } else { 1.001 } * magnitude(0, 20, random);
    let centre = match form {
        Form::Eye => rounded(direction(random).map(|x| distance * x)),
        // As far off the world's origin as that lets the ray's begin on singles.
        Form::General => rounded(direction(random).map(|x| magnitude(-20, 20, random) * x)),
    };
    shot(centre, radius, random, |random| {
        let origin = match form {
            Form::Eye => [0.0; 3],
            Form::General => {
                let inside = random.random_ratio(1, 4);
                let away = if inside { radius * random.random_range(0.0..0.999) } else { distance };
                let from = direction(random);
                rounded(std::array::from_fn(|k| centre[k] + away * from[k]))
            }
        };
        let [first, _] = across(unit_or(less(centre, origin)), random);
        let reach = radius * random.random_range(0.0..1.2);
        let target: Vector = std::array::from_fn(|k| centre[k] + reach * first[k]);
        (origin, unit_or(less(target, origin)))
    })
}

/// The vector at length 1; some direction for one that has none.
fn unit_or(vector: Vector) -> Vector {
    if dot(vector, vector) > 0.0 {
        unit(vector)
    } else {
        [0.0, 0.0, -1.0]
    }
}

/// Rays within 64 ulps of the distance from a tangent.
fn grazing(random: &mut ChaCha8Rng, form: Form) -> Shot {
    let radius = magnitude(-20, 20, random);
    let distance = 1.5 * radius * magnitude(0, 16, random);
    let way = direction(random);
    let [out, _] = across(way, random);
    let along = (distance * distance - radius * radius).sqrt();
    let centre = match form {
        // Where the ray from 0 along the way passes it at the radius.
        Form::Eye => std::array::from_fn(|k| along * way[k] + radius * out[k]),
        Form::General => direction(random).map(|x| distance * x),
    };
    let centre = rounded(centre);
    shot(centre, radius, random, |random| {
        let off = random.random_range(-64.0..64.0) * spacing(distance);
        let (origin, way) = match form {
            Form::Eye => {
                let target: Vector = std::array::from_fn(|k| along * way[k] - off * out[k]);
                ([0.0; 3], target)
            }
            Form::General => {
                let way = direction(random);
                let [out, _] = across(way, random);
                let reach = radius + off;
                let back = |k: usize| centre[k] + reach * out[k] - along * way[k];
                (std::array::from_fn(back), way)
            }
        };
        (rounded(origin), unit(way))
    })
}

/// Origins on the surface and some ulps to either side of it, and farther by powers of two.
fn surface(random: &mut ChaCha8Rng, _: Form) -> Shot {
    let radius = to_f64(from_f64(magnitude(-20, 20, random)));
    let centre = rounded(direction(random).map(|x| radius * random.random_range(0.0..4.0) * x));
    shot(centre, radius, random, |random| {
        let out = direction(random);
        let off = match random.random_range(0..3) {
            0 => 0.0,
            1 => random.random_range(0.0..64.0) * spacing(radius),
            _ => radius * magnitude(-20, -2, random),
        };
        let height = if random.random() { radius + off } else { radius - off };
        let origin = std::array::from_fn(|k| centre[k] + height * out[k]);
        let way = if random.random() {
            direction(random)
        } else {
            let rise = magnitude(-20, -2, random);
            let rise = if random.random() { rise } else { -rise };
            let [along, _] = across(out, random);
            std::array::from_fn(|k| along[k] + rise * out[k])
        };
        (rounded(origin), unit(way))
    })
}

impl Spheres {
    /// Tries a sphere's rays.
    fn shoot(&self, bench: &mut Bench, shot: &Shot, tally: &mut Tally) {
        let sphere = self.subject.given(shot).sphere();
        let found = self.subject.hits(bench, shot);
        for (ray, found) in shot.packets.iter().flatten().zip(found) {
            let line = Line::new(ray.origin, ray.direction);
            let passing = sphere.passing(&line);
            let exact = passing.crossing.and_then(|crossing| match self.subject.form {
                Form::Eye => Some(crossing.entry).filter(|t| *t > 0.0),
                Form::General => crossing.first().map(|(t, _)| t),
            });
            let found = found.map(|t| match self.subject.formulation.name {
                ANY_LENGTH => t * dot(line.direction, line.direction).sqrt(),
                _ => t,
            });
            let from_centre = less(line.origin, sphere.centre());
            let look = Look {
                subject: self.subject,
                stated: self.stated,
                passing,
                distance: dot(from_centre, from_centre).sqrt(),
                radius: sphere.radius(),
                exact,
                found,
            };
            let input = || {
                let words = [&shot.centre[..], &[shot.radius], &ray.origin, &ray.direction];
                words.concat()
            };
            match (self.kind.judge)(&look) {
                Judgement::Uncounted => tally.uncounted(),
                Judgement::Wrong => tally.wrong(input),
                Judgement::Error(error) => tally.error(error, input),
            }
        }
    }
}

impl Family for Spheres {
    fn name(&self) -> &'static str {
        self.kind.name
    }

    fn subject(&self) -> &str {
        self.subject.kernel
    }

    fn unit(&self) -> &'static str {
        self.kind.unit
    }

    fn bound(&self) -> Bound {
        (self.kind.bound)(&self.subject, &self.stated)
    }

    fn rounds(&self) -> u32 {
        80
    }

    fn round(&self, bench: &mut Bench, random: &mut ChaCha8Rng, tally: &mut Tally) {
        for _ in 0..SPHERES {
            let shot = (self.kind.make)(random, self.subject.form);
            self.shoot(bench, &shot, tally);
        }
    }

    fn replay(
        &self,
        bench: &mut Bench,
        words: &[u32],
        tally: &mut Tally,
    ) -> Result<(), NoCaseError> {
        let [x, y, z, radius, ox, oy, oz, dx, dy, dz] = words_of(words)?;
        let ray = Ray {
            origin: [ox, oy, oz],
            direction: [dx, dy, dz],
            t: FARTHEST,
            object: 0,
        };
        let shot = Shot {
            centre: [x, y, z],
            radius,
            packets: vec![[ray; 16]],
        };
        self.shoot(bench, &shot, tally);
        Ok(())
    }
}
