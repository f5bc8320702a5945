//! The words for which the SPU's format is most unusual, in any operand: zeros of both signs,
//! denormals, values that saturate, the smallest and the largest exponents, directions without a
//! component.
//!
//! For every input, a kernel must return its twin's bits, terminate, and find no hit nearer than 0
//! or beyond the one that it was given.

use std::marker::PhantomData;

use crate::stability::prelude::*;
use kernels::cases::formulation::ForAnyRay;
use kernels::cases::whitted::bounce::Sites;
use kernels::cases::whitted::isect::cone::ConeObject;
use kernels::cases::whitted::isect::rectangle::RectangleObject;
use kernels::cases::whitted::isect::sphere::SphereObject;
use rand::SeedableRng as _;
use twins::bounce::{Bounce, Queued};
use twins::pairs::Sides;
use twins::rectangle::Rectangle;
use twins::reflect::reflect;
use twins::refract::refract;
use twins::sphere::{
    Estimate, Factored, InDouble, Interpolated, Newton2, Paper, Refined, Stable, Unnormalised,
};

/// Magnitudes: zero, denormals, the smallest numbers, about 1, around the limits of what can be
/// squared, and everything that saturates or would be infinite or NaN elsewhere.
const MAGNITUDES: [Single; 20] = [
    0,
    1,
    0x007f_ffff,
    0x0080_0000,
    0x0080_0001,
    0x1f80_0000,
    0x2000_0000,
    0x3380_0000,
    0x3f7f_ffff,
    0x3f80_0000,
    0x3f80_0001,
    0x4b7f_ffff,
    0x5f7f_ffff,
    0x5f80_0000,
    0x7e7f_ffff,
    0x7e80_0000,
    0x7f7f_ffff,
    0x7f80_0000,
    0x7fc0_0000,
    0x7fff_ffff,
];

/// One of these, one near it, or any word.
fn word(random: &mut Generator) -> Single {
    let sign = u32::from(random.random::<bool>()) << 31;
    let magnitude = MAGNITUDES[random.random_range(0..MAGNITUDES.len() as u32) as usize];
    match random.random_range(0..8) {
        0 => random.random(),
        1 => sign | (magnitude ^ random.random_range(0..16)),
        _ => sign | magnitude,
    }
}

fn words<const N: usize>(random: &mut Generator) -> [Single; N] {
    std::array::from_fn(|_| word(random))
}

/// Shapes that can be made from words.
trait OfWords: Shape {
    const WORDS: usize;
    fn of_words(words: &[u32]) -> Self;
}

fn take<const N: usize>(words: &mut &[u32]) -> [u32; N] {
    let (first, rest) = words.split_first_chunk().expect("as many words as a shape has");
    *words = rest;
    *first
}

fn one(words: &mut &[u32]) -> u32 {
    let [word] = take(words);
    word
}

fn sides(words: &mut &[u32]) -> Sides {
    let word = one(words);
    Sides { both: word & 1 != 0, exit: word & 2 != 0 }
}

impl<F: ForAnyRay> OfWords for By<F> {
    const WORDS: usize = 5;

    fn of_words(mut words: &[u32]) -> Self {
        let sides = sides(&mut words);
        let [x, y, z, offset] = take(&mut words);
        let centre = [x, y, z];
        SphereObject { centre, offset, sides }.into()
    }
}

impl OfWords for RectangleObject {
    const WORDS: usize = 13;

    fn of_words(mut words: &[u32]) -> Self {
        let both = sides(&mut words).both;
        let rectangle = Rectangle {
            point: take(&mut words),
            normal: take(&mut words),
            dual_u: take(&mut words),
            dual_v: take(&mut words),
        };
        Self { rectangle, both }
    }
}

impl OfWords for TriangleObject {
    const WORDS: usize = 10;

    fn of_words(mut words: &[u32]) -> Self {
        let both = sides(&mut words).both;
        let vertices = [(); 3].map(|()| take(&mut words));
        Self { vertices, both }
    }
}

impl OfWords for ConeObject {
    const WORDS: usize = 10;

    fn of_words(mut words: &[u32]) -> Self {
        let sides = sides(&mut words);
        Self {
            sides,
            base: take(&mut words),
            axis: take(&mut words),
            radius: one(&mut words),
            growth: one(&mut words),
            height: one(&mut words),
        }
    }
}

/// The number of words of a ray: origin, direction, t.
const RAY: usize = 7;
/// The object of a ray that has hit nothing before.
const NOTHING: u32 = 0;

fn ray(words: [u32; RAY]) -> Ray {
    let [ox, oy, oz, dx, dy, dz, t] = words;
    Ray { origin: [ox, oy, oz], direction: [dx, dy, dz], t, object: NOTHING }
}

/// Random rays tested against random objects of a shape.
struct Meeting<S>(PhantomData<fn() -> S>);

impl<S: OfWords> Meeting<S> {
    fn meet(bench: &mut Bench, object: &[u32], rays: &[[u32; RAY]; 16], tally: &mut Tally) {
        let shape = S::of_words(object);
        let before = rays.map(ray);
        let (after, objects) =
            call::pairs(bench, &[call::packet(&before, 0)], &[shape], &[[0, 0]], 0);
        for ((before, after), words) in before.iter().zip(call::rays(&after[0])).zip(rays) {
            let twin = shape.twin(*before, objects[0]);
            // As signed integers, singles above 0 have the same order.
            let within =
                after == *before || (after.t as i32 > 0 && (after.t as i32) < before.t as i32);
            tally.verdict(after == twin && within, || [object, words].concat());
        }
    }
}

impl<S: OfWords> Cases for Meeting<S> {
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        let mut object = Vec::from_iter((0..S::WORDS).map(|_| word(random)));
        // Any combination of sides.
        object[0] = random.random();
        let rays = [(); 16].map(|()| words(random));
        Self::meet(bench, &object, &rays, tally);
    }

    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed {
        need(S::WORDS + RAY, words)?;
        let (object, mut ray) = words.split_at(S::WORDS);
        Self::meet(bench, object, &[take(&mut ray); 16], tally);
        Ok(())
    }
}

/// Random hits, reflected and refracted.
struct Bounces;

/// The number of words of a hit.
const BOUNCE: usize = 20;

fn bounce(words: [u32; BOUNCE], pixel: u32) -> Bounce {
    let mut words = &words[..];
    Bounce {
        pixel,
        direction: take(&mut words),
        point: take(&mut words),
        normal: take(&mut words),
        plane: take(&mut words),
        weight: one(&mut words),
        leave: one(&mut words),
        mirror: one(&mut words),
        transmittance: one(&mut words),
        ratio: one(&mut words),
        schlick: one(&mut words),
        grazing: one(&mut words),
    }
}

impl Bounces {
    fn leave(bench: &mut Bench, hits: &[[u32; BOUNCE]; 16], tally: &mut Tally) {
        let packet: [Bounce; 16] = std::array::from_fn(|lane| bounce(hits[lane], lane as u32));
        bench.reset();
        let sites = Sites::put(bench, &[packet], &mut Generator::seed_from_u64(0));
        let queue = |kernel: &str, bench: &mut Bench| -> [Option<Queued>; 16] {
            let end = bench.call(kernel, &sites.arguments(Limits::NONE)).value;
            let queued = sites.queued(bench, end);
            let of_lane = |ray: &&Queued, lane| ray.pixel == lane as u32 + CHAIN_STEP;
            std::array::from_fn(|lane| queued.iter().find(|ray| of_lane(ray, lane)).copied())
        };
        let back = queue("reflect_r16", bench);
        let through = queue("refract_r16", bench);
        let mirrors = sites.surfaces(bench)[0].mirror.map(bits);
        for lane in 0..16 {
            let expected =
                (reflect(&packet[lane], Limits::NONE), refract(&packet[lane], Limits::NONE));
            let same = expected == (back[lane], (through[lane], mirrors[lane]));
            tally.verdict(same, || hits[lane].to_vec());
        }
    }
}

impl Cases for Bounces {
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        let hits = [(); 16].map(|()| words(random));
        Self::leave(bench, &hits, tally);
    }

    fn replay(&self, bench: &mut Bench, mut words: &[u32], tally: &mut Tally) -> Replayed {
        need(BOUNCE, words)?;
        Self::leave(bench, &[take(&mut words); 16], tally);
        Ok(())
    }
}

fn meeting<S: OfWords + 'static>() -> Family {
    Family {
        name: "extreme-words",
        subject: S::KERNEL.to_owned(),
        unit: "other bits, or hits out of range",
        bound: Bound::none("the twin"),
        rounds: 2000,
        cases: Box::new(Meeting::<S>(PhantomData)),
    }
}

/// A family for each shape, and those of the rays that leave.
pub fn families() -> Vec<Family> {
    vec![
        meeting::<By<Paper>>(),
        meeting::<By<Perpendicular>>(),
        meeting::<By<Estimate>>(),
        meeting::<By<Interpolated>>(),
        meeting::<By<Newton2>>(),
        meeting::<By<Stable>>(),
        meeting::<By<Factored>>(),
        meeting::<By<Refined>>(),
        meeting::<By<Unnormalised>>(),
        meeting::<By<InDouble>>(),
        meeting::<RectangleObject>(),
        meeting::<TriangleObject>(),
        meeting::<ConeObject>(),
        Family {
            name: "extreme-words",
            subject: "reflect_r16, refract_r16".to_owned(),
            unit: "other bits",
            bound: Bound::none("the twins"),
            rounds: 1000,
            cases: Box::new(Bounces),
        },
    ]
}
