//! Measures the formulations of spheres on the scene families.

use kernels::Bench;
use protocol::formulation::EyeRecord;
use serde::{Deserialize, Serialize};
use spu_emulator::float::single::to_f64;

use crate::families::{FAMILIES, Family, Form, Shot};
use crate::figures::{Figures, Hit, Normal, Truth, compare, sensitivity};
use crate::metrics::Summary;
use crate::parallel;
use crate::space::{add_scaled, length, sub};
use crate::subject::{ANY_LENGTH, Given, Subject};
use crate::truth::{Line, spacing};

/// The figures of a kernel on a family.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SphereRow {
    /// The formulation.
    pub formulation: String,
    /// The form of its rays.
    pub form: Form,
    /// The family.
    pub family: String,
    /// The distance over the radius, if the family is about that.
    pub ratio: Option<f64>,
    /// The figures.
    #[serde(flatten)]
    pub figures: Figures,
    /// The largest error of a coordinate of the normal, in ulps of 1.
    pub normal_ulps: Option<Summary>,
}

/// Measures kernels on all families, with this many spheres of each.
///
/// # Panics
///
/// Panics if a kernel breaks the rules for kernels or does not exist.
pub fn measure(subjects: &[Subject], seed: u64, spheres: usize) -> Vec<SphereRow> {
    let families: Vec<(Form, &Family)> = Form::ALL
        .into_iter()
        .flat_map(|form| FAMILIES.iter().map(move |family| (form, family)))
        .filter(|(form, family)| family.forms.contains(form))
        .collect();
    let rows = parallel::map(&families, Bench::new, |bench, (form, family)| {
        let shots = family.shots(*form, seed, spheres);
        let of_form = subjects.iter().filter(|subject| subject.form == *form);
        let any_length = |subject: &&Subject| subject.formulation.name == ANY_LENGTH;
        let fit = of_form.filter(|subject| !family.any_length || any_length(subject));
        of_family(bench, fit, family, &shots)
    });
    rows.into_iter().flatten().collect()
}

fn of_family<'a>(
    bench: &mut Bench,
    subjects: impl Iterator<Item = &'a Subject>,
    family: &Family,
    shots: &[Shot],
) -> Vec<SphereRow> {
    // Formulations with the same record follow each other, so that exact results are computed once
    // for them.
    let mut known: Option<(EyeRecord, Vec<Truth>)> = None;
    let row = |subject: &Subject| {
        let record = subject.formulation.record;
        let truths = match known.take() {
            Some((of, truths)) if of == record => truths,
            _ => shots.iter().flat_map(|shot| truths(family, subject, shot)).collect(),
        };
        let found = shots.iter().flat_map(|shot| subject.hits(bench, shot));
        let (figures, normal_ulps) = compare(family.any_length, found, truths.iter());
        known = Some((record, truths));
        SphereRow {
            formulation: subject.formulation.name.to_owned(),
            form: subject.form,
            family: family.name.to_owned(),
            ratio: family.ratio,
            figures,
            normal_ulps,
        }
    };
    subjects.map(row).collect()
}

/// The exact results for a shot's rays.
fn truths(family: &Family, subject: &Subject, shot: &Shot) -> Vec<Truth> {
    // (l^2 - r^2) / 2 r^2 of a line that passes the centre at `counted` radii.
    let edge = (family.counted * family.counted - 1.0) / 2.0;
    let form = subject.form;
    let sphere = Given::new(form, subject.formulation.record, shot).sphere();
    let (centre, radius) = (sphere.centre(), sphere.radius());
    let truth = |line: Line| {
        let passing = sphere.passing(&line);
        let seen = passing.crossing.and_then(|crossing| form.seen(&crossing));
        let hit = seen.map(|(distance, exact)| Hit {
            distance,
            point: add_scaled(centre, radius, exact),
            condition: (passing.beyond <= edge)
                .then(|| condition(form, shot, &line, (distance, exact))),
            normal: Some(Normal { exact, centre, radius }),
        });
        let scene = length(sub(centre, line.origin)) + radius;
        Truth { line, hit, scene }
    };
    shot.lines().map(truth).collect()
}

/// By how many ulps half an ulp in each input moves a hit's distance. The inputs are those of the
/// centre, of the radius or its square, and of the origin if it is one.
fn condition(form: Form, shot: &Shot, line: &Line, hit: (f64, [f64; 3])) -> f64 {
    let radius = shot.radius();
    let (of_radius, from_origin) = match form {
        Form::Eye => (spacing(radius * radius) / (2.0 * radius), 0.0),
        Form::General => (spacing(radius), 1.0),
    };
    let places =
        |axis: usize| spacing(to_f64(shot.centre[axis])) + from_origin * spacing(line.origin[axis]);
    sensitivity(line, length(line.direction), hit, places, of_radius)
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
        let found = rows.iter().find(|row| row.form == form && row.family == family);
        found.unwrap()
    }

    /// Only primary rays are compared, because the other form has the same bits in Whitted's model
    /// (lab/oracle/tests/forms.rs).
    #[test]
    fn default_formulation_keeps_two_ulps_where_paper_fails() {
        let standard = Formulations::standard();
        for (formulation, from) in [(standard.eye, 4.0), (standard.seen, 16.0)] {
            let rows = measure(&subjects(formulation.name), 1, 8);
            let eye = rows.iter().filter(|row| row.form == Form::Eye);
            let mut counted = 0;
            for row in eye.filter(|row| row.ratio.is_some_and(|ratio| ratio >= from)) {
                let worst = row.figures.sound(|of| of.distance_ulps.unwrap().max);
                let worst = worst.expect("a well-conditioned family");
                assert!(worst > 0.0 && worst <= 2.0, "{row:?}");
                counted += 1;
            }
            assert!(counted >= 8);
            let far = &row(&rows, Form::Eye, FAR).figures;
            assert_eq!((far.wrong_hits, far.wrong_misses), (0, 0), "{far:?}");
        }
        let paper = measure(&subjects("paper"), 1, 8);
        let far = &row(&paper, Form::Eye, FAR).figures;
        assert!(far.wrong_hits + far.wrong_misses > far.rays / 8, "{far:?}");
        let near = &row(&paper, Form::Eye, "ratio 2").figures;
        assert!(near.wrong_hits + near.wrong_misses <= near.rays / 1000);
    }

    #[test]
    fn grazing_rays_are_ill_conditioned() {
        let rows = measure(&subjects("perpendicular"), 1, 2);
        let of = |family| row(&rows, Form::General, family).figures.well_conditioned;
        assert!(of("ratio 16") && of("coherent"));
        assert!(!of("grazing") && !of("ground 1e6"));
    }
}
