//! Glass near the critical angle, from both sides of it, and rays parallel to surfaces in the
//! medium with the lower index: the refracted direction, whether it exists, and Schlick's share.

use crate::stability::prelude::*;
use kernels::cases::whitted::bounce::{Sites, off};
use kernels::vector::{Vector, dot, unit};
use rand::SeedableRng as _;
use twins::ONE;
use twins::bounce::Bounce;

const KERNEL: &str = "refract_r16";
/// An ulp of 1.
const ULP: f64 = 1.0 / (1 << 23) as f64;
/// The largest derivative of Schlick's share by the cosine, from (1 - c)^5.
const STEEPEST: f64 = 5.0;
/// The refracted cosine up to which the header states the error over the cosine.
const STEEP: f64 = 0.1;
/// The number of packets in a round.
const PACKETS: u32 = 16;

/// Whether the ray leaves the denser medium or enters it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    /// It leaves near the critical angle.
    Out,
    /// It enters along the surface.
    Into,
}

struct Critical {
    way: Way,
    /// If the square of the cosine is below this, in ulps of 1, the ray may be reflected totally
    /// or not.
    undecided: f64,
}

/// A family for each of the two.
pub fn families() -> Families {
    let undecided = stated(KERNEL, "ulp, all may be reflected")?;
    let family = |way, name, unit, bound| Family {
        name,
        subject: KERNEL.to_owned(),
        unit,
        bound,
        rounds: 200,
        cases: Box::new(Critical { way, undecided }),
    };
    Ok(vec![
        family(
            Way::Out,
            "refract-critical",
            "ulp of 1 over the cosine; Schlick's share by its slope",
            Bound::before(KERNEL, "ulp over the cosine")?,
        ),
        family(
            Way::Into,
            "refract-grazing",
            "ulp of 1; Schlick's share by its slope",
            Bound::of(KERNEL)?,
        ),
    ])
}

/// A hit with this cosine on the thinner side, which is either the ray's side or the other one.
fn hit(way: Way, random: &mut Generator) -> Bounce {
    let dense: f64 = random.random_range(1.05..4.0);
    let cosine = magnitude(-14, -3, random) * 0.75;
    let beyond = random.random_ratio(1, 3);
    let square = cosine * cosine * if beyond { -1.0 } else { 1.0 };
    // The sine on the ray's side, and the ratio of the indices.
    let (sine, ratio) = match way {
        Way::Out => ((1.0 - square).sqrt() / dense, dense),
        Way::Into => ((1.0 - cosine * cosine).sqrt(), 1.0 / dense),
    };
    let normal = direction(random);
    let [aside, _] = across(normal, random);
    let incidence = (1.0 - sine * sine).sqrt();
    let ray = add_scaled(aside.map(|x| sine * x), -incidence, normal);
    let head_on = ((1.0 - dense) / (1.0 + dense)) * ((1.0 - dense) / (1.0 + dense));
    bounce([ray, normal].map(|v| v.map(from_f64)), [ratio, head_on, 1.0 - head_on].map(from_f64))
}

/// A hit from this direction with this normal.
fn bounce([direction, normal]: [[Single; 3]; 2], [ratio, schlick, grazing]: [Single; 3]) -> Bounce {
    Bounce {
        direction,
        weight: ONE,
        pixel: 0,
        point: [0; 3],
        normal,
        plane: normal,
        leave: 0,
        mirror: 0,
        transmittance: ONE,
        ratio,
        schlick,
        grazing,
    }
}

/// The exact result of a hit.
struct Truth {
    /// The square of the refracted cosine. Below 0, reflection is total.
    squared: f64,
    direction: Vector,
    /// Schlick's share, and the cosine that it depends on.
    share: f64,
    thinner: f64,
}

fn truth(hit: &Bounce) -> Truth {
    let [ray, normal] = [hit.direction, hit.normal].map(|v| unit(v.map(to_f64)));
    let [ratio, schlick, grazing] = [hit.ratio, hit.schlick, hit.grazing].map(to_f64);
    let head_on = dot(ray, normal);
    let sine = add_scaled(ray, -head_on, normal).map(|x| ratio * x);
    let squared = 1.0 - dot(sine, sine);
    let cosine = squared.max(0.0).sqrt();
    let thinner = if ratio > 1.0 { cosine } else { -head_on };
    let off = 1.0 - thinner;
    let fifth = off * off * off * off * off;
    Truth {
        squared,
        direction: add_scaled(sine, -cosine, normal),
        share: if squared < 0.0 { 1.0 } else { schlick + grazing * fifth },
        thinner,
    }
}

impl Critical {
    fn try_hits(&self, bench: &mut Bench, hits: &[Bounce; 16], tally: &mut Tally) {
        let packet: [Bounce; 16] =
            std::array::from_fn(|lane| Bounce { pixel: lane as u32, ..hits[lane] });
        bench.reset();
        // Fills the parts of the records that the kernel does not read.
        let mut junk = Generator::seed_from_u64(0);
        let sites = Sites::put(bench, &[packet], &mut junk);
        let end = bench.call(KERNEL, &sites.arguments(Limits::NONE)).value;
        let queued = sites.queued(bench, end);
        let mirrors = sites.surfaces(bench)[0].mirror.map(|share| to_f64(bits(share)));
        for (hit, mirror) in packet.iter().zip(mirrors) {
            let truth = truth(hit);
            let ray = queued.iter().find(|ray| ray.pixel == hit.pixel + CHAIN_STEP);
            let input = || {
                let words =
                    [&hit.direction[..], &hit.normal, &[hit.ratio, hit.schlick, hit.grazing]];
                words.concat()
            };
            let cosine = truth.squared.max(0.0).sqrt();
            let out = self.way == Way::Out;
            if truth.squared.abs() < self.undecided * ULP || (out && cosine > STEEP) {
                tally.uncounted();
                continue;
            }
            let (scale, share_scale) = if out { (cosine, truth.thinner) } else { (1.0, 1.0) };
            let share_error = (mirror - truth.share).abs() / ULP / STEEPEST;
            match ray {
                None => {
                    let right = truth.squared < 0.0 && mirror == 1.0;
                    tally.verdict(right, input);
                }
                Some(_) if truth.squared < 0.0 => tally.wrong(input),
                Some(ray) => {
                    let error = off(ray, truth.direction) * scale;
                    tally.error(error.max(share_error * share_scale), input);
                }
            }
        }
    }
}

impl Cases for Critical {
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        for _ in 0..PACKETS {
            let hits = [(); 16].map(|()| hit(self.way, random));
            self.try_hits(bench, &hits, tally);
        }
    }

    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed {
        let [direction, normal, shares] = points_of(words)?;
        let hit = bounce([direction, normal], shares);
        self.try_hits(bench, &[hit; 16], tally);
        Ok(())
    }
}
