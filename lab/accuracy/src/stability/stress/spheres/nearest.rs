//! Two spheres of which the nearer one is difficult to determine: they have one centre, touch,
//! or are nested, or one is ten million times as large as the other.

use super::look::{Look, Stated};
use super::make::ANYWHERE;
use crate::stability::prelude::*;
use crate::subject;
use crate::subject::sphere;
use crate::truth::sphere::Sphere;

/// The number of pairs in a round.
const PAIRS: u32 = 16;

struct Nearest {
    subject: Subject,
    stated: Stated,
}

/// The centre and radius of each sphere.
type Pair = [([Single; 3], Single); 2];

/// A family for each formulation whose kernels exist.
pub fn families() -> Families {
    let general = subject::all().filter(|subject| subject.form == Form::General);
    let there = general.filter(|subject| Source::find(subject.kernel).is_some());
    let family = |subject: Subject| {
        let stated = Stated::of(&subject)?;
        Ok(Family {
            name: "sphere-nearest",
            subject: subject.kernel.to_owned(),
            unit: "ulp of t or r, by the condition, farther than the nearest",
            bound: Bound {
                value: 2.0 * stated.error,
                source: format!("header of {}, for each sphere", subject.kernel),
            },
            rounds: 600,
            cases: Box::new(Nearest { subject, stated }),
        })
    };
    there.map(family).collect()
}

/// Two spheres close to each other.
fn pair(random: &mut Generator) -> Pair {
    let radius = to_f64(from_f64(magnitude(-10, 10, random)));
    let place = rounded(direction(random).map(|x| radius * random.random_range(0.0..4.0) * x));
    let way = direction(random);
    let ulps = f64::from(random.random_range(-8..=8_i32)) * spacing(radius);
    let (other, apart) = match random.random_range(0..4) {
        0 => (radius + ulps, 0.0),
        1 => {
            let other = radius * magnitude(-3, 3, random);
            (other, radius + other + ulps)
        }
        2 => {
            let other = radius * magnitude(-3, 3, random);
            (other, radius + other * random.random_range(-1.0..1.0))
        }
        _ => (1e7 * radius, 1e7 * radius + radius * random.random_range(-1.0..2.0)),
    };
    [(place, radius), (add_scaled(place, apart, way), other)]
        .map(|(centre, radius)| (centre.map(from_f64), from_f64(radius)))
}

/// A ray to the region of both spheres, from outside or from between.
fn aimed(pair: &Pair, random: &mut Generator) -> Ray {
    let (centre, radius) = (pair[0].0.map(to_f64), to_f64(pair[0].1));
    let off = direction(random).map(|x| radius * random.random_range(0.0..1.2) * x);
    let back = direction(random).map(|x| radius * magnitude(-4, 5, random) * x);
    let target = add_scaled(centre, 1.0, off);
    let origin = rounded(add_scaled(target, 1.0, back));
    let [aside, _] = across(towards([0.0; 3], back, ANYWHERE), random);
    let way = towards(origin, target, aside);
    fresh(origin.map(from_f64), way.map(from_f64))
}

impl Nearest {
    fn shoot(&self, bench: &mut Bench, pair: &Pair, rays: &[Ray; 16], tally: &mut Tally) {
        // All formulations use the same record.
        let objects =
            pair.map(|(centre, radius)| By::<Perpendicular>::from(sphere(centre, radius)));
        bench.reset();
        let packets = [call::packet(rays, 0)];
        let placed = call::place(bench, &packets, &objects, &[[0, 0], [1, 0]], 0);
        bench.call(self.subject.kernel, &[placed.candidates, 2]);
        let after = call::rays(&bench.read_all(placed.packets)[0]);
        for (ray, after) in rays.iter().zip(after) {
            let line = Line::new(ray.origin, ray.direction);
            let chosen = placed.objects.iter().position(|object| *object == after.object);
            let looks = pair.map(|(centre, radius)| {
                let sphere = Sphere::of_radius(centre, radius);
                Look::new(self.subject, self.stated, &sphere, &line, None)
            });
            let input = || {
                let spheres =
                    pair.iter().flat_map(|(centre, radius)| [&centre[..], &[*radius]].concat());
                spheres.chain(ray.origin).chain(ray.direction).collect()
            };
            if !looks.iter().all(Look::has_root_or_misses) {
                tally.uncounted();
                continue;
            }
            let [first, second] = [0, 1].map(|k| looks[k].exact.unwrap_or(f64::INFINITY));
            let nearest = first.min(second);
            match chosen {
                None => tally.verdict(nearest == f64::INFINITY, input),
                Some(chosen) => match looks[chosen].exact {
                    None => tally.wrong(input),
                    Some(exact) if exact == nearest => tally.error(0.0, input),
                    // The difference is compared with the rounding of each, in the larger of their
                    // units.
                    Some(exact) => {
                        let units = looks.iter().map(|look| look.unit(exact));
                        let given: f64 = looks.iter().map(Look::given).sum();
                        let farther = (exact - nearest - given).max(0.0);
                        tally.error(farther / units.fold(0.0, f64::max), input);
                    }
                },
            }
        }
    }
}

impl Cases for Nearest {
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        for _ in 0..PAIRS {
            let pair = pair(random);
            let rays = std::array::from_fn(|_| aimed(&pair, random));
            self.shoot(bench, &pair, &rays, tally);
        }
    }

    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed {
        need(14, words)?;
        let point = |at: usize| [0, 1, 2].map(|k| words[at + k]);
        let pair = [(point(0), words[3]), (point(4), words[7])];
        let ray = fresh(point(8), point(11));
        self.shoot(bench, &pair, &[ray; 16], tally);
        Ok(())
    }
}
