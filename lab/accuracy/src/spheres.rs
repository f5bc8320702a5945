//! The formulations of spheres on the scene families.
//!
//! Invariant: a row is of one kernel and one family; its errors are of the rays that the kernel and exact
//! arithmetic both let hit, its verdicts of all rays.

use kernels::Bench;
use protocol::formulation::EyeRecord;
use serde::{Deserialize, Serialize};
use spu_emulator::float::single::to_f64;

use crate::families::space::{along, dot, largest, less};
use crate::families::{FAMILIES, Family, Form, Shot};
use crate::metrics::Summary;
use crate::parallel;
use crate::subject::{ANY_LENGTH, Given, Subject};
use crate::truth::{Line, Vector, spacing};

/// Ulps of a distance that half an ulp in what is given may move in the mean, for a family to be
/// well-conditioned.
pub const WELL_CONDITIONED: f64 = 1.5;

/// A kernel on a family.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SphereRow {
    /// The formulation.
    pub formulation: String,
    /// Whose rays.
    pub form: Form,
    /// The family.
    pub family: String,
    /// Distance over radius, where that is what the family is about.
    pub ratio: Option<f64>,
    /// Ulps of the distance that half an ulp in each of the numbers given moves, of what counts.
    pub condition: Option<Summary>,
    /// Whether that is little in the mean.
    pub well_conditioned: bool,
    /// Rays.
    pub rays: usize,
    /// Of these, those that hit by exact arithmetic.
    pub hits: usize,
    /// Rays that the kernel lets hit, and exact arithmetic does not.
    pub wrong_hits: usize,
    /// Rays that exact arithmetic lets hit, and the kernel does not.
    pub wrong_misses: usize,
    /// Error of the distance in ulps; of what counts, as all that follows.
    pub distance_ulps: Option<Summary>,
    /// The same in parts of the scene: of its farthest point's distance.
    pub distance_relative: Option<Summary>,
    /// Error of the hit's point, at its worst coordinate, in ulps of the largest from the origin.
    pub point_ulps: Option<Summary>,
    /// The same in parts of the scene.
    pub point_relative: Option<Summary>,
    /// Error of the normal, at its worst coordinate, in ulps of 1.
    pub normal_ulps: Option<Summary>,
}

/// What is so of a ray.
struct Truth {
    line: Line,
    hit: Option<Hit>,
}

struct Hit {
    distance: f64,
    normal: Vector,
    /// Ulps that half an ulp in what is given moves, if errors count.
    condition: Option<f64>,
}

/// What is so of a shot.
struct Target {
    centre: Vector,
    radius: f64,
    rays: Vec<Truth>,
}

/// Measures kernels on all families, so many spheres of each.
///
/// # Panics
///
/// If a kernel does not behave as kernels have to, or there is no such kernel.
#[must_use]
pub fn measure(subjects: &[Subject], seed: u64, spheres: usize) -> Vec<SphereRow> {
    let families: Vec<(Form, &Family)> = [Form::Eye, Form::General]
        .into_iter()
        .flat_map(|form| FAMILIES.iter().map(move |family| (form, family)))
        .filter(|(form, family)| family.forms.contains(form))
        .collect();
    let rows = parallel::map(&families, Bench::new, |bench, (form, family)| {
        of_family(bench, subjects, *form, family, seed, spheres)
    });
    rows.into_iter().flatten().collect()
}

fn of_family(
    bench: &mut Bench,
    subjects: &[Subject],
    form: Form,
    family: &Family,
    seed: u64,
    spheres: usize,
) -> Vec<SphereRow> {
    let shots = family.shots(form, seed, spheres);
    let subjects = subjects.iter().filter(|subject| {
        let suits = !family.any_length || subject.formulation.name == ANY_LENGTH;
        subject.form == form && suits
    });
    let mut known: Option<(EyeRecord, Vec<Target>)> = None;
    let row = |subject: &Subject| {
        let record = subject.formulation.record;
        let targets = match known.take() {
            Some((of, targets)) if of == record => targets,
            _ => targets(family, form, record, &shots),
        };
        let row = of_subject(bench, subject, family, &shots, &targets);
        known = Some((record, targets));
        row
    };
    subjects.map(row).collect()
}

fn targets(family: &Family, form: Form, record: EyeRecord, shots: &[Shot]) -> Vec<Target> {
    // (l^2 - r^2) / 2 r^2 of a line that comes to `counted` radii.
    let edge = (family.counted * family.counted - 1.0) / 2.0;
    let target = |shot: &Shot| {
        let sphere = Given::new(form, record, shot).sphere();
        let rays = shot.packets.iter().flatten().map(|ray| {
            let line = Line::new(ray.origin, ray.direction);
            let passing = sphere.passing(&line);
            let hit = passing.crossing.and_then(|crossing| match form {
                Form::Eye => {
                    (crossing.entry > 0.0).then_some((crossing.entry, crossing.entry_normal))
                }
                Form::General => crossing.first(),
            });
            let counts = passing.beyond <= edge;
            let hit = hit.map(|(distance, normal)| Hit {
                distance,
                normal,
                condition: counts.then(|| sensitivity(form, shot, &line, distance, normal)),
            });
            Truth { line, hit }
        });
        Target {
            rays: rays.collect(),
            centre: sphere.centre(),
            radius: sphere.radius(),
        }
    };
    shots.iter().map(target).collect()
}

/// Ulps of a hit's distance that half an ulp in each of the numbers given moves, all at their worst.
///
/// From |o + t d - c|^2 = r^2: the normal n has n.(do + t dd + d dt - dc) = dr.
fn sensitivity(form: Form, shot: &Shot, line: &Line, distance: f64, normal: Vector) -> f64 {
    let length = dot(line.direction, line.direction).sqrt();
    let ahead = line.direction.map(|component| component / length);
    let slant = dot(normal, ahead);
    let radius = shot.radius();
    let of_radius = match form {
        Form::Eye => spacing(radius * radius) / (2.0 * radius),
        Form::General => spacing(radius),
    };
    let origin_spacing = |axis: usize| match form {
        Form::Eye => 0.0,
        Form::General => spacing(line.origin[axis]),
    };
    // A direction's length is of no account: what moves the hit is what is across.
    let turned = along(normal, -slant, ahead);
    let moved: f64 = (0..3)
        .map(|axis| {
            let places = spacing(to_f64(shot.centre[axis])) + origin_spacing(axis);
            let turn = spacing(line.direction[axis]) / length;
            normal[axis].abs() * places + distance * turned[axis].abs() * turn
        })
        .sum();
    (moved + of_radius) / 2.0 / slant.abs() / spacing(distance)
}

fn of_subject(
    bench: &mut Bench,
    subject: &Subject,
    family: &Family,
    shots: &[Shot],
    targets: &[Target],
) -> SphereRow {
    let mut errors = Errors::default();
    let (mut hits, mut wrong_hits, mut wrong_misses) = (0, 0, 0);
    for (shot, target) in shots.iter().zip(targets) {
        let found = subject.hits(bench, shot);
        for (found, truth) in found.into_iter().zip(&target.rays) {
            hits += usize::from(truth.hit.is_some());
            match (found, &truth.hit) {
                (Some(t), Some(hit)) if hit.condition.is_some() => {
                    errors.add(family.any_length, t, target, truth, hit);
                }
                (Some(_), None) => wrong_hits += 1,
                (None, Some(_)) => wrong_misses += 1,
                _ => {}
            }
        }
    }
    let hits_that_count = targets.iter().flat_map(|target| &target.rays);
    let conditions = hits_that_count.filter_map(|truth| truth.hit.as_ref()?.condition);
    let condition = Summary::of(conditions.collect());
    SphereRow {
        formulation: subject.formulation.name.to_owned(),
        form: subject.form,
        family: family.name.to_owned(),
        ratio: family.ratio,
        condition,
        well_conditioned: condition.is_some_and(|condition| condition.mean <= WELL_CONDITIONED),
        rays: targets.iter().map(|target| target.rays.len()).sum(),
        hits,
        wrong_hits,
        wrong_misses,
        distance_ulps: Summary::of(errors.distance_ulps),
        distance_relative: Summary::of(errors.distance_relative),
        point_ulps: Summary::of(errors.point_ulps),
        point_relative: Summary::of(errors.point_relative),
        normal_ulps: Summary::of(errors.normal_ulps),
    }
}

#[derive(Default)]
struct Errors {
    distance_ulps: Vec<f64>,
    distance_relative: Vec<f64>,
    point_ulps: Vec<f64>,
    point_relative: Vec<f64>,
    normal_ulps: Vec<f64>,
}

impl Errors {
    /// Adds those of a hit that a kernel found at `t`.
    fn add(&mut self, any_length: bool, t: f64, target: &Target, truth: &Truth, hit: &Hit) {
        let Truth { line, .. } = truth;
        let length = dot(line.direction, line.direction).sqrt();
        // Where directions have length 1 but for their rounding, what a kernel finds is a distance.
        let distance = if any_length { t * length } else { t };
        let off = (distance - hit.distance).abs();
        let to_centre = less(target.centre, line.origin);
        let scene = dot(to_centre, to_centre).sqrt() + target.radius;
        self.distance_ulps.push(off / spacing(hit.distance));
        self.distance_relative.push(off / scene);

        let point = along(line.origin, t, line.direction);
        let exact = along(target.centre, target.radius, hit.normal);
        let off = largest(less(point, exact));
        let reach = largest(less(exact, line.origin));
        self.point_ulps.push(off / spacing(reach));
        self.point_relative.push(off / scene);

        let outward = less(point, target.centre);
        let normal = outward.map(|component| component / target.radius);
        let off = largest(less(normal, hit.normal));
        self.normal_ulps.push(off / spacing(1.0));
    }
}

#[cfg(test)]
mod tests {
    use protocol::formulation::{Formulations, SPHERES};

    use super::*;
    use crate::families::FAR;
    use crate::subject;

    fn subjects(name: &str) -> Vec<Subject> {
        assert!(SPHERES.iter().any(|formulation| formulation.name == name));
        let of_name = |subject: &Subject| subject.formulation.name == name;
        subject::all().filter(of_name).collect()
    }

    fn row<'a>(rows: &'a [SphereRow], form: Form, family: &str) -> &'a SphereRow {
        let found = rows
            .iter()
            .find(|row| row.form == form && row.family == family);
        found.unwrap()
    }

    /// Of the eye's rays: what Whitted's model has of another form is the same bits (oracle/tests/forms.rs).
    #[test]
    fn the_default_keeps_two_ulps_and_the_verdict_where_the_paper_s_formula_is_lost() {
        let standard = Formulations::standard();
        for (formulation, from) in [(standard.eye, 4.0), (standard.seen, 16.0)] {
            let rows = measure(&subjects(formulation.name), 1, 8);
            let eye = rows.iter().filter(|row| row.form == Form::Eye);
            let mut counted = 0;
            for row in eye.filter(|row| row.ratio.is_some_and(|ratio| ratio >= from)) {
                assert!(row.well_conditioned, "{row:?}");
                let worst = row.distance_ulps.unwrap().max;
                assert!(worst > 0.0 && worst <= 2.0, "{row:?}");
                counted += 1;
            }
            assert!(counted >= 8);
            let far = row(&rows, Form::Eye, FAR);
            assert_eq!((far.wrong_hits, far.wrong_misses), (0, 0), "{far:?}");
        }
        let paper = measure(&subjects("paper"), 1, 8);
        let far = row(&paper, Form::Eye, FAR);
        assert!(far.wrong_hits + far.wrong_misses > far.rays / 8, "{far:?}");
        let near = row(&paper, Form::Eye, "ratio 2");
        assert!(near.wrong_hits + near.wrong_misses <= near.rays / 1000);
    }

    #[test]
    fn what_hangs_on_roundings_of_what_is_given_is_ill_conditioned() {
        let rows = measure(&subjects("perpendicular"), 1, 2);
        let of = |family| row(&rows, Form::General, family).well_conditioned;
        assert!(of("ratio 16") && of("coherent"));
        assert!(!of("grazing") && !of("ground 1e6"));
    }

    #[test]
    fn errors_are_those_of_what_was_found() {
        // From 0 along x to the sphere around 8 with radius 2: at 6, found an ulp too far.
        let hit = Hit {
            distance: 6.0,
            normal: [-1.0, 0.0, 0.0],
            condition: Some(1.0),
        };
        let truth = Truth {
            line: Line {
                origin: [0.0; 3],
                direction: [1.0, 0.0, 0.0],
            },
            hit: None,
        };
        let target = Target {
            centre: [8.0, 0.0, 0.0],
            radius: 2.0,
            rays: Vec::new(),
        };
        let ulp = spacing(6.0);
        let mut errors = Errors::default();
        errors.add(false, 6.0 + ulp, &target, &truth, &hit);
        assert_eq!(errors.distance_ulps, [1.0]);
        assert_eq!(errors.distance_relative, [ulp / 10.0]);
        assert_eq!(errors.point_ulps, [1.0]);
        assert_eq!(errors.normal_ulps, [2.0]);
    }
}
