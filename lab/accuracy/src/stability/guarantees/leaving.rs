//! Rays that leave a surface do not hit it at their origin. These are reflected, refracted and
//! shadow rays, started in the same way as in the tracer.
//!
//! What a ray must hit next is computed in f64 from the same singles that it starts with. On the
//! outer side of a convex body, and on a plane, it must hit nothing. Inside a body it must hit the
//! opposite wall. It must neither miss this wall nor hit the wall that it has just left.
//!
//! Three kinds of rays are tried, but nothing is required of them, because rounding decides:
//!
//! - A ray meets a body so close to its edge that the cosine of its incidence is below `leave` over
//!   the radius. Whether it has met the outer or the inner side is uncertain.
//! - A ray in a cone passes the rim by less than `leave`. Whether it meets the wall or leaves
//!   through the open end is uncertain. If it nearly follows the wall, it meets it far from there.
//! - A body is so thin that a ray starts at its opposite wall, to the last digit of coordinates.

use scenes::Shape;

use crate::stability::prelude::*;
use crate::stability::product::{Kind, Product, Stuff, exactly, next_hit};
use crate::stability::random::either_side;
use crate::stability::steps::{HIT, Lanes, Leaving, Line, leave, meet};

/// The number of packets in a call, each with its own object.
const PACKETS: usize = 4;
/// The number of calls in a round.
const CALLS: usize = 8;
/// The number of words of a ray and of the light.
const LINES: usize = 9;
/// The distance to an end of a cone, relative to its size, within which a ray may miss the
/// opposite wall.
const END: f64 = 1e-3;

/// A body, and the points of its surface that rays are sent to.
struct Body {
    product: Product,
    targets: Vec<Target>,
}

/// A point of a surface and the normal there, which points outwards if the body has an outside.
struct Target {
    point: Vector,
    normal: Vector,
}

/// How bodies of one kind are made.
struct Leave {
    kind: Kind,
    body: fn(&mut Generator) -> Option<Body>,
    /// Whether it is streamed, so that its hits are refined.
    streamed: bool,
}

/// A family for each kind of body.
pub fn families() -> impl Iterator<Item = Family> {
    type Make = fn(&mut Generator) -> Option<Body>;
    let kinds: [(_, _, _, _, Make); 7] = [
        ("leave-spheres", "spheres", Kind::Sphere, false, sphere),
        ("leave-streamed-spheres", "spheres", Kind::Sphere, true, sphere),
        ("leave-triangles", "triangles", Kind::Triangle, false, triangle),
        ("leave-rectangles", "parallelograms", Kind::Rectangle, false, rectangle),
        ("leave-cones", "cones", Kind::Cone, false, stout_cone),
        ("leave-streamed-cones", "cones", Kind::Cone, true, stout_cone),
        ("leave-thin-cones", "cones", Kind::Cone, false, thin_cone),
    ];
    kinds.into_iter().map(|(name, shapes, kind, streamed, body)| Family {
        name,
        subject: format!("surfaces, bounces, {shapes}"),
        unit: "rays lost or stuck",
        bound: Bound::none("rays start by SURFACES_leave off"),
        rounds: 250,
        cases: Box::new(Leave { kind, body, streamed }),
    })
}

fn vector(v: Vector) -> DVec3 {
    DVec3::from_array(v)
}

/// A random position for a body: around the eye, near or far.
fn place(random: &mut Generator) -> Vector {
    let distance = magnitude(-3, 10, random);
    rounded(direction(random).map(|x| distance * x))
}

/// Glass with a random index that also reflects. A quarter of the materials are opaque.
fn stuff(random: &mut Generator) -> Stuff {
    let index = random.random_range(1.01..2.5);
    Stuff {
        mirror: 0.5,
        transmittance: if random.random_ratio(1, 4) { 0.0 } else { 0.5 },
        index: if random.random() { index } else { 1.0 / index },
    }
}

fn body(
    kind: Kind,
    shape: Shape,
    random: &mut Generator,
    mut target: impl FnMut(&mut Generator) -> Target,
) -> Option<Body> {
    let product = Product::of(kind, shape, stuff(random))?;
    let targets = (0..16).map(|_| target(random)).collect();
    Some(Body { product, targets })
}

fn sphere(random: &mut Generator) -> Option<Body> {
    let centre = place(random);
    let radius = magnitude(-7, 5, random);
    let shape = Shape::Sphere { centre: vector(centre), radius };
    body(Kind::Sphere, shape, random, |random| {
        let normal = direction(random);
        Target { point: add_scaled(centre, radius, normal), normal }
    })
}

/// A flat body: its corners, and a random point on it.
fn flat(kind: Kind, vertices: Vec<Vector>, random: &mut Generator) -> Option<Body> {
    let (corner, first) = (vertices[0], sub(vertices[1], vertices[0]));
    let second = sub(vertices[vertices.len() - 1], corner);
    let across = cross(first, second);
    let normal = (dot(across, across) > 0.0).then(|| unit(across))?;
    let shape = Shape::Polygon { vertices: vertices.into_iter().map(vector).collect() };
    body(kind, shape, random, |random| {
        let [mut u, mut v] = [(); 2].map(|()| random.random_range(0.01..0.99));
        if kind == Kind::Triangle && u + v > 1.0 {
            [u, v] = [1.0 - u, 1.0 - v];
        }
        Target { point: add_scaled(add_scaled(corner, u, first), v, second), normal }
    })
}

fn triangle(random: &mut Generator) -> Option<Body> {
    let (corner, size) = (place(random), magnitude(-7, 5, random));
    let vertices = [(); 3].map(|()| add_scaled(corner, 1.0, in_cube(size, random)));
    flat(Kind::Triangle, vertices.to_vec(), random)
}

fn rectangle(random: &mut Generator) -> Option<Body> {
    let (corner, size) = (place(random), magnitude(-7, 5, random));
    let [u, v] = [(); 2].map(|()| in_cube(size, random));
    let sum = |edges: &[Vector]| -> Vector {
        std::array::from_fn(|k| corner[k] + edges.iter().map(|edge| edge[k]).sum::<f64>())
    };
    let vertices = vec![corner, sum(&[u]), sum(&[u, v]), sum(&[v])];
    flat(Kind::Rectangle, vertices, random)
}

/// A cone or cylinder whose radius is at least 1/64 of its height, and which tapers to no less
/// than a hundredth.
fn stout_cone(random: &mut Generator) -> Option<Body> {
    let height = magnitude(-5, 5, random);
    let widest = height * magnitude(-6, 3, random);
    let narrowest = widest
        * match random.random_range(0..3) {
            0 => 1.0,
            _ => random.random_range(0.01..1.0),
        };
    cone(height, [widest, narrowest], random)
}

/// A cone as thin as 1/4096 that tapers to a thousandth or to a point.
fn thin_cone(random: &mut Generator) -> Option<Body> {
    let height = magnitude(-5, 5, random);
    let widest = height * magnitude(-12, -6, random);
    let share = if random.random() { 0.0 } else { 1e-3 };
    cone(height, [widest, share * widest], random)
}

/// A cone with these radii at its ends, in random order.
fn cone(height: f64, mut radii: [f64; 2], random: &mut Generator) -> Option<Body> {
    let base = place(random);
    let axis = direction(random);
    if random.random() {
        radii.reverse();
    }
    let shape = Shape::Cone {
        base: vector(base),
        base_radius: radii[0],
        apex: vector(add_scaled(base, height, axis)),
        apex_radius: radii[1],
    };
    let growth = (radii[1] - radii[0]) / height;
    body(Kind::Cone, shape, random, |random| {
        let h = height * random.random_range(0.01..0.99);
        let [out, _] = across(axis, random);
        let radius = radii[0] + growth * h;
        Target {
            point: add_scaled(add_scaled(base, h, axis), radius, out),
            normal: unit(add_scaled(out, -growth, axis)),
        }
    })
}

/// A ray to a point of a surface, from the eye or from anywhere. Half of the rays are nearly
/// parallel to the surface.
fn aimed_at(target: &Target, random: &mut Generator) -> Line {
    let distance = magnitude(-6, 7, random);
    let back = match random.random_range(0..4) {
        0 => target.point.map(|x| -x),
        1 => direction(random),
        _ => {
            let [level, _] = across(target.normal, random);
            let rise = magnitude(-18, -3, random);
            let rise = either_side(rise, random);
            add_scaled(level, rise, target.normal).map(|x| distance * x)
        }
    };
    let origin = rounded(add_scaled(target.point, 1.0, back));
    // Next to the eye, the ray may start at the eye itself.
    let way = towards(origin, target.point, [0.0, 0.0, -1.0]);
    [origin, way].map(|v| v.map(from_f64))
}

/// The kind of ray that leaves.
#[derive(Clone, Copy)]
enum Start {
    Reflected,
    Refracted,
    Shadow,
}

/// What a ray that leaves must do.
enum Expected {
    /// Hit nothing.
    Nothing,
    /// Hit the opposite wall at about this distance.
    Wall(f64),
    /// Either, because the wall ends close to the expected hit.
    Anything,
}

/// What a ray must do that leaves a body on this side of the surface, by this distance.
fn expected(product: &Product, inner: bool, start: &Ray, leave: f64) -> Expected {
    if !inner || matches!(product.kind, Kind::Rectangle | Kind::Triangle) {
        return Expected::Nothing;
    }
    let origin = start.origin.map(to_f64);
    let way = unit(start.direction.map(to_f64));
    let Some(t) = next_hit(product, origin, way) else {
        return match product.kind {
            // A ray that starts inside must hit the body. If it does not, it did not start inside.
            Kind::Sphere => Expected::Wall(f64::INFINITY),
            _ => Expected::Anything,
        };
    };
    let last_digit = 0.5_f64.powi(23) * origin.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if t < last_digit {
        return Expected::Anything;
    }
    if product.kind == Kind::Cone {
        let head = product.head();
        let height = to_f64(product.rest()[2]);
        let from = sub(origin, head.centre);
        let (along, rise) = (dot(from, head.axis), dot(way, head.axis));
        let passes_rim = [0.0, height].into_iter().any(|end| {
            let there = add_scaled(from, (end - along) / rise, way);
            let off = length(add_scaled(there, -end, head.axis));
            (head.offset - head.slope * end - head.gain * off).abs() < leave
        });
        let share = (along + t * rise) / height;
        if passes_rim || !(END..=1.0 - END).contains(&share) {
            return Expected::Anything;
        }
    }
    Expected::Wall(t)
}

/// Tries packets of rays, each to its own body, with a light.
fn try_packets(
    bench: &mut Bench,
    products: &[&Product],
    lines: &[[Line; 16]],
    light: [Single; 3],
    streamed: bool,
    tally: &mut Tally,
) {
    let rays = |lines: &[Line; 16]| lines.map(|[from, way]| Some(fresh(from, way)));
    let rays: Vec<Lanes> = lines.iter().map(rays).collect();
    let hits = meet(bench, products, &rays);
    let leaving = leave(bench, products, &hits, light, streamed);
    for kind in [Start::Reflected, Start::Refracted, Start::Shadow] {
        let of_kind = |(leaving, hits): (&Leaving, &[Ray; 16])| {
            let rays = match kind {
                Start::Reflected => &leaving.reflected,
                Start::Refracted => &leaving.refracted,
                Start::Shadow => &leaving.shadow,
            };
            std::array::from_fn(|lane| rays[lane].filter(|_| hits[lane].object == HIT))
        };
        let starts: Vec<Lanes> = leaving.iter().zip(&hits).map(of_kind).collect();
        let after = meet(bench, products, &starts);
        for (number, lane) in (0..products.len()).flat_map(|p| (0..16).map(move |lane| (p, lane))) {
            let Some(start) = starts[number][lane] else {
                continue;
            };
            let product = products[number];
            let by = exactly(leaving[number].surfaces.leave[lane]);
            let (before, edge) = side(product, &leaving[number], lane, &lines[number][lane]);
            if edge {
                tally.uncounted();
                continue;
            }
            // A refracted ray continues on the other side of the surface that it hit.
            let inner = before == matches!(kind, Start::Refracted);
            let after = &after[number][lane];
            let met = (after.object == HIT).then(|| to_f64(after.t));
            let input = || {
                let line = lines[number][lane];
                let rest = line.into_iter().chain([light]).flatten();
                product.words().chain(rest).collect()
            };
            match (expected(product, inner, &start, by), met) {
                (Expected::Anything, _) => tally.uncounted(),
                (Expected::Nothing, met) => tally.verdict(met.is_none(), input),
                // The light may be nearer than the wall.
                (Expected::Wall(t), None) => {
                    let light = matches!(kind, Start::Shadow);
                    tally.verdict(light && to_f64(start.t) < 2.0 * t, input);
                }
                (Expected::Wall(t), Some(met)) => tally.verdict((met - t).abs() < t / 2.0, input),
            }
        }
    }
}

/// Whether a lane's ray has hit its body from the outer side, and whether this is so close to the
/// body's edge that rounding decides it.
fn side(product: &Product, leaving: &Leaving, lane: usize, line: &Line) -> (bool, bool) {
    let found = &leaving.surfaces;
    let [point, plane] = [
        [&found.point_x, &found.point_y, &found.point_z],
        [&found.plane_x, &found.plane_y, &found.plane_z],
    ]
    .map(|rows| rows.map(|row| exactly(row[lane])));
    let head = product.head();
    let from = sub(point, head.centre);
    let off = add_scaled(from, -dot(from, head.axis), head.axis);
    let distance = length(off);
    let scale = if head.gain == 0.0 { 0.0 } else { head.gain / distance };
    let normal = add_scaled(off.map(|x| scale * x), head.slope, head.axis);
    let cosine = dot(normal, line[1].map(to_f64)).abs();
    let edge = head.gain != 0.0 && cosine * distance < exactly(found.leave[lane]);
    (dot(normal, plane) > 0.0, edge)
}

impl Cases for Leave {
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        for _ in 0..CALLS {
            let mut bodies = Vec::new();
            while bodies.len() < PACKETS {
                bodies.extend((self.body)(random));
            }
            let lines: Vec<[Line; 16]> = bodies
                .iter()
                .map(|body| std::array::from_fn(|lane| aimed_at(&body.targets[lane], random)))
                .collect();
            let around = bodies[0].targets[0].point;
            let far = magnitude(-2, 10, random);
            let light = add_scaled(around, far, direction(random)).map(from_f64);
            let products: Vec<&Product> = bodies.iter().map(|body| &body.product).collect();
            try_packets(bench, &products, &lines, light, self.streamed, tally);
        }
    }

    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed {
        let of_product = Product::word_count(self.kind);
        need(of_product + LINES, words)?;
        let (object, lines) = words.split_at(of_product);
        let product = Product::from_words(self.kind, object);
        let [origin, direction, light] = points_of(lines)?;
        let lines = [[[origin, direction]; 16]];
        try_packets(bench, &[&product], &lines, light, self.streamed, tally);
        Ok(())
    }
}
