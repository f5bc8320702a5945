//! Chains of mirrors: how an error grows with bounces between two spheres and inside one.
//!
//! They use the tracer's own steps: hit, surface, reflected ray. Each chain is compared with the
//! same chain in f64. Its own error grows by the same factors from 2^-53, so it stays below a
//! millionth of what is measured.
//!
//! In radii, let t be the distance from sphere to sphere, c the cosine of incidence, e the error
//! of the place and a that of the angle. The headers state the noise of each step.
//! - Between two spheres, each mirror magnifies the error: e' = (e + t a) / c + noise, a' = a + 2
//!   e' + noise. The factor of a bounce tends to 1 + t + sqrt(t^2 + 2 t), which is 3.7 for spheres
//!   a radius apart.
//! - Inside a sphere, each mirror focuses it again: e' = e + 2 a + noise, a' = a + noise. The
//!   error grows with the square of the number of bounces.

use scenes::Shape;

use crate::stability::prelude::*;
use crate::stability::product::{Kind, Product, Stuff, exactly};
use crate::stability::statement::{StatementError, states};
use crate::stability::steps::{HIT, Lanes, Line, leave, meet};

/// An ulp of 1.
const ULP: f64 = 1.0 / (1 << 23) as f64;
/// How much `OBJECT_leave` and the rounding of a point's coordinates add to a ray's distance from
/// the surface, relative to each.
const LEAVE: f64 = 2.0 * ULP;
/// The number of packets in a call.
const PACKETS: usize = 4;
/// The number of words of a ray.
const LINE: usize = 6;
/// The largest distance, in radii, of the mirrors' centre from the eye on each axis.
const PLACE: f64 = 2.0;

/// How the mirrors are arranged between which a ray bounces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Arrangement {
    /// Between two spheres that are a radius apart, almost along their axis.
    Between,
    /// Inside a hollow sphere.
    Within,
}

struct Chain {
    arrangement: Arrangement,
    bounces: u32,
}

/// The numbers of bounces after which errors are measured.
const BOUNCES: [u32; 4] = [1, 2, 4, 8];

/// A family for each arrangement of mirrors and number of bounces.
pub fn families() -> Families {
    let mut families = Vec::new();
    for arrangement in [Arrangement::Between, Arrangement::Within] {
        let noise = arrangement.noise()?;
        families.extend(BOUNCES.map(|bounces| Family {
            name: "mirror-chain",
            subject: format!("{}, bounce {bounces}", arrangement.name()),
            unit: "ulp of r",
            bound: Bound {
                value: arrangement.carried(&noise, bounces),
                source: "headers of spheres, surfaces and reflections, carried along".to_owned(),
            },
            rounds: 200,
            cases: Box::new(Chain { arrangement, bounces }),
        }));
    }
    Ok(families)
}

/// The error that a bounce adds, in radii.
struct Noise {
    place: f64,
    angle: f64,
    /// The distance from the surface at which a ray starts.
    leave: f64,
}

impl Arrangement {
    fn name(self) -> &'static str {
        match self {
            Self::Between => "two spheres",
            Self::Within => "a hollow sphere",
        }
    }

    /// The smallest cosine of incidence.
    fn cosine(self) -> f64 {
        match self {
            Self::Between => 0.9,
            Self::Within => 0.25,
        }
    }

    fn sine(self) -> f64 {
        (1.0 - self.cosine() * self.cosine()).sqrt()
    }

    /// The largest distance between mirrors.
    fn farthest(self) -> f64 {
        match self {
            Self::Between => 1.25,
            Self::Within => 2.0,
        }
    }

    fn noise(self) -> Result<Noise, StatementError> {
        const NORMALS: &str = "normals 2^-23 + leave/r, each component";
        if !states("surfaces_r16", NORMALS) {
            return Err(StatementError::NoNumber {
                kernel: "surfaces_r16".to_owned(),
                phrase: NORMALS.to_owned(),
            });
        }
        // Two spheres are a radius and a half from the middle.
        let centre = 3_f64.sqrt() * PLACE + 3_f64.sqrt() * 1.5;
        let leave = LEAVE * (2.0 * centre + 3_f64.sqrt() + 1.0);
        let components = 3_f64.sqrt();
        let height = stated("surfaces_r16", "")? * leave;
        // Distances of up to 2 have the ulps of 2.
        let distance = 2.0 * ULP * stated("isect_sphere_pairs_r16", "")?;
        let normal = components * (ULP + leave);
        let direction = components * ULP * stated("reflect_r16", "")?;
        Ok(Noise { place: height + distance * self.sine(), angle: 2.0 * normal + direction, leave })
    }

    /// The error of the place after this many bounces, in ulps of the radius.
    fn carried(self, noise: &Noise, bounces: u32) -> f64 {
        let (sine, cosine) = (self.sine(), self.cosine());
        let (mut place, mut angle) = (0.0, 0.0);
        // The first ray starts exactly at its origin.
        let mut start = 0.0;
        for _ in 0..bounces {
            match self {
                Self::Between => {
                    place = (place + start * sine + self.farthest() * angle) / cosine + noise.place;
                    angle += 2.0 * place + noise.angle;
                }
                Self::Within => {
                    let aside = start * sine / cosine;
                    angle += aside;
                    place += 2.0 * angle + aside + noise.place;
                    angle += noise.angle;
                }
            }
            start = noise.leave;
        }
        place / ULP
    }

    /// The mirrors in the order in which a ray hits them, and sixteen rays.
    fn mirrors(self, bounces: u32, random: &mut Generator) -> Option<([Product; 2], [Line; 16])> {
        let radius = magnitude(-10, 10, random);
        let place: Vector =
            rounded(std::array::from_fn(|_| PLACE * radius * random.random_range(-1.0..1.0)));
        let axis = direction(random);
        let mirror = |centre: Vector, radius: f64| {
            let shape = Shape::Sphere { centre: DVec3::from_array(centre), radius };
            let stuff = Stuff { mirror: 1.0, transmittance: 0.0, index: 1.0 };
            Product::of(Kind::Sphere, shape, stuff)
        };
        let at = |by: f64| rounded(add_scaled(place, by * radius, axis));
        let mirrors = match self {
            Self::Between => [mirror(at(1.5), radius)?, mirror(at(-1.5), radius)?],
            Self::Within => {
                let hollow = mirror(place, -radius)?;
                [hollow.clone(), hollow]
            }
        };
        let lines = std::array::from_fn(|_| {
            let (from, way) = match self {
                Self::Between => {
                    // The direction is so close to the axis that the ray stays between the
                    // spheres.
                    let highest = -4 - 2 * bounces as i32;
                    let tilt = magnitude(highest - 8, highest, random);
                    let [aside, _] = across(axis, random);
                    (place, add_scaled(axis, tilt, aside))
                }
                Self::Within => {
                    let off = direction(random).map(|x| radius * random.random_range(0.0..0.9) * x);
                    (add_scaled(place, 1.0, off), direction(random))
                }
            };
            [rounded(from), unit(way)].map(|v| v.map(from_f64))
        });
        Some((mirrors, lines))
    }
}

/// The same chain without the kernels' rounding.
struct Exact {
    origin: Vector,
    way: Vector,
    /// The smallest cosine of incidence so far.
    cosine: f64,
}

impl Exact {
    fn new([origin, way]: Line) -> Self {
        Self { origin: origin.map(to_f64), way: unit(way.map(to_f64)), cosine: 1.0 }
    }

    /// Follows the ray to the next mirror and reflects it. `None` if it misses.
    fn bounce(&mut self, mirror: &Product) -> Option<()> {
        let head = mirror.head();
        let radius = head.offset;
        let to = sub(head.centre, self.origin);
        let b = dot(to, self.way);
        let aside = add_scaled(to, -b, self.way);
        let disc = radius * radius - dot(aside, aside);
        let root = (disc > 0.0).then(|| disc.sqrt())?;
        let t = if radius < 0.0 { b + root } else { b - root };
        let point = add_scaled(self.origin, t, self.way);
        let normal = unit(sub(point, head.centre));
        let incidence = dot(self.way, normal);
        self.cosine = self.cosine.min(incidence.abs());
        self.way = unit(add_scaled(self.way, -2.0 * incidence, normal));
        self.origin = point;
        (t > 0.0).then_some(())
    }
}

impl Chain {
    fn follow(
        &self,
        bench: &mut Bench,
        mirrors: &[[Product; 2]],
        lines: &[[Line; 16]],
        tally: &mut Tally,
    ) {
        let mut exact: Vec<[Option<Exact>; 16]> =
            lines.iter().map(|lines| lines.map(|line| Some(Exact::new(line)))).collect();
        let rays = |lines: &[Line; 16]| lines.map(|[from, way]| Some(fresh(from, way)));
        let mut rays: Vec<Lanes> = lines.iter().map(rays).collect();
        let mut points = vec![[[0.0; 3]; 16]; lines.len()];
        for bounce in 0..self.bounces as usize {
            let products: Vec<&Product> = mirrors.iter().map(|pair| &pair[bounce % 2]).collect();
            let hits = meet(bench, &products, &rays);
            let leaving = leave(bench, &products, &hits, [0; 3], false);
            for (number, leaving) in leaving.iter().enumerate() {
                let found = &leaving.surfaces;
                for lane in 0..16 {
                    let hit = hits[number][lane].object == HIT;
                    rays[number][lane] = leaving.reflected[lane].filter(|_| hit);
                    points[number][lane] = [&found.point_x, &found.point_y, &found.point_z]
                        .map(|row| exactly(row[lane]));
                    let exact = &mut exact[number][lane];
                    let on = exact.as_mut().and_then(|it| it.bounce(products[number]));
                    if on.is_none() {
                        *exact = None;
                    }
                }
            }
        }
        for number in 0..lines.len() {
            let radius = mirrors[number][0].head().offset.abs();
            for lane in 0..16 {
                let input = || {
                    let words = mirrors[number].iter().flat_map(Product::words);
                    words.chain(lines[number][lane].into_iter().flatten()).collect()
                };
                let exact = exact[number][lane].as_ref();
                match exact.filter(|exact| exact.cosine > self.arrangement.cosine()) {
                    None => tally.uncounted(),
                    Some(_) if rays[number][lane].is_none() => tally.wrong(input),
                    Some(exact) => {
                        let off = length(sub(points[number][lane], exact.origin));
                        tally.error(off / radius / ULP, input);
                    }
                }
            }
        }
    }
}

impl Cases for Chain {
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        let (mut mirrors, mut lines) = (Vec::new(), Vec::new());
        while mirrors.len() < PACKETS {
            if let Some((pair, rays)) = self.arrangement.mirrors(self.bounces, random) {
                mirrors.push(pair);
                lines.push(rays);
            }
        }
        self.follow(bench, &mirrors, &lines, tally);
    }

    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed {
        let of_mirror = Product::word_count(Kind::Sphere);
        need(2 * of_mirror + LINE, words)?;
        let (mirrors, line) = words.split_at(2 * of_mirror);
        let (first, second) = mirrors.split_at(of_mirror);
        let mirrors = [first, second].map(|words| Product::from_words(Kind::Sphere, words));
        self.follow(bench, &[mirrors], &[[points_of(line)?; 16]], tally);
        Ok(())
    }
}
