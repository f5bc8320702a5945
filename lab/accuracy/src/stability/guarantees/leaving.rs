//! Rays that leave a surface do not meet it where they leave: reflected, refracted and shadow
//! rays, started as the tracer starts them.
//!
//! What a ray has to meet next is worked out in f64 for the very singles that it starts with. On
//! the outer side of a convex body, and on a plane, that is nothing. Within a body it is the wall
//! across, which may neither be lost nor be the one that the ray has just left.
//!
//! Known weakness: where a ray meets a body at its very edge, so that the cosine of its incidence
//! is below `leave` over the radius, rounding may take the outer side for the inner one. Such hits
//! are tried, and nothing is asked of what leaves from there.

use crate::generator::Generator;
use glam::DVec3;
use kernels::Bench;
use nff::Shape;
use rand::Rng as _;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::Single;
use twins::sphere_ray::Ray;

use crate::space::{along, cross, direction, dot, fresh, in_cube, length, less, unit};
use crate::stability::family::{Cases, Family, Replayed, Tally, need, points_of};
use crate::stability::product::{Kind, Product, Stuff, exactly, next_hit};
use crate::stability::random::{across, either_side, magnitude, rounded, towards};
use crate::stability::statement::Bound;
use crate::stability::steps::{HIT, Lanes, Leaving, Line, leave, meet};
use crate::truth::Vector;

/// Packets of a call, each with an object of its own.
const PACKETS: usize = 4;
/// Calls of a round.
const CALLS: usize = 8;
/// Words of a ray and of the light.
const LINES: usize = 9;
/// How near to an end of a cone, in parts of its size, the wall across may be missed.
const END: f64 = 1e-3;

/// A body, and points of its surface that rays are sent to.
struct Body {
    product: Product,
    targets: Vec<Target>,
}

/// A point of a surface and the normal there, outwards where there is an outside.
struct Target {
    point: Vector,
    normal: Vector,
}

/// How bodies of a kind are made.
struct Leave {
    kind: Kind,
    body: fn(&mut Generator) -> Option<Body>,
}

/// A family for each kind of body.
pub fn families() -> impl Iterator<Item = Family> {
    type Make = fn(&mut Generator) -> Option<Body>;
    let kinds: [(_, _, _, Make); 5] = [
        ("leave-spheres", "spheres", Kind::Sphere, sphere),
        ("leave-triangles", "triangles", Kind::Triangle, triangle),
        (
            "leave-rectangles",
            "parallelograms",
            Kind::Rectangle,
            rectangle,
        ),
        ("leave-cones", "cones", Kind::Cone, stout_cone),
        ("leave-thin-cones", "cones", Kind::Cone, thin_cone),
    ];
    kinds.into_iter().map(|(name, shapes, kind, body)| Family {
        name,
        subject: format!("surfaces, bounces, {shapes}"),
        unit: "rays lost or stuck",
        bound: Bound::none("rays start by SURFACES_leave off"),
        rounds: 250,
        cases: Box::new(Leave { kind, body }),
    })
}

fn vector(v: Vector) -> DVec3 {
    DVec3::from_array(v)
}

/// Where a body may be: around the eye, near and far.
fn place(random: &mut Generator) -> Vector {
    let distance = magnitude(-3, 10, random);
    rounded(direction(random).map(|x| distance * x))
}

/// Glass of any index with a mirror's shine; a quarter lets nothing through.
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
    let shape = Shape::Sphere {
        centre: vector(centre),
        radius,
    };
    body(Kind::Sphere, shape, random, |random| {
        let normal = direction(random);
        Target {
            point: along(centre, radius, normal),
            normal,
        }
    })
}

/// A flat body: its corners, and a point of it by two shares.
fn flat(kind: Kind, vertices: Vec<Vector>, random: &mut Generator) -> Option<Body> {
    let (corner, first) = (vertices[0], less(vertices[1], vertices[0]));
    let second = less(vertices[vertices.len() - 1], corner);
    let across = cross(first, second);
    let normal = (dot(across, across) > 0.0).then(|| unit(across))?;
    let shape = Shape::Polygon {
        vertices: vertices.into_iter().map(vector).collect(),
    };
    body(kind, shape, random, |random| {
        let [mut u, mut v] = [(); 2].map(|()| random.random_range(0.01..0.99));
        if kind == Kind::Triangle && u + v > 1.0 {
            [u, v] = [1.0 - u, 1.0 - v];
        }
        Target {
            point: along(along(corner, u, first), v, second),
            normal,
        }
    })
}

fn triangle(random: &mut Generator) -> Option<Body> {
    let (corner, size) = (place(random), magnitude(-7, 5, random));
    let vertices = [(); 3].map(|()| along(corner, 1.0, in_cube(size, random)));
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

/// A cone or cylinder not thinner than 1 to 64, nor tapering to less than a hundredth.
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

/// A cone as thin as 1 to 4096 that tapers to a thousandth or to nothing.
fn thin_cone(random: &mut Generator) -> Option<Body> {
    let height = magnitude(-5, 5, random);
    let widest = height * magnitude(-12, -6, random);
    let share = if random.random() { 0.0 } else { 1e-3 };
    cone(height, [widest, share * widest], random)
}

/// A cone with these radii at its ends, whichever way round.
fn cone(height: f64, mut radii: [f64; 2], random: &mut Generator) -> Option<Body> {
    let base = place(random);
    let axis = direction(random);
    if random.random() {
        radii.reverse();
    }
    let shape = Shape::Cone {
        base: vector(base),
        base_radius: radii[0],
        apex: vector(along(base, height, axis)),
        apex_radius: radii[1],
    };
    let growth = (radii[1] - radii[0]) / height;
    body(Kind::Cone, shape, random, |random| {
        let h = height * random.random_range(0.01..0.99);
        let [out, _] = across(axis, random);
        let radius = radii[0] + growth * h;
        Target {
            point: along(along(base, h, axis), radius, out),
            normal: unit(along(out, -growth, axis)),
        }
    })
}

/// A ray to a point of a surface, from the eye or from anywhere, half of them along the surface.
fn aimed_at(target: &Target, random: &mut Generator) -> Line {
    let distance = magnitude(-6, 7, random);
    let back = match random.random_range(0..4) {
        0 => target.point.map(|x| -x),
        1 => direction(random),
        _ => {
            let [level, _] = across(target.normal, random);
            let rise = magnitude(-18, -3, random);
            let rise = either_side(rise, random);
            along(level, rise, target.normal).map(|x| distance * x)
        }
    };
    let origin = rounded(along(target.point, 1.0, back));
    // Next to the eye the eye itself may be meant.
    let way = towards(origin, target.point, [0.0, 0.0, -1.0]);
    [origin, way].map(|v| v.map(from_f64))
}

/// What rays leave.
#[derive(Clone, Copy)]
enum Start {
    Reflected,
    Refracted,
    Shadow,
}

/// What a ray that leaves has to do.
enum Expected {
    /// Meet nothing.
    Nothing,
    /// Meet the wall across, about there.
    Wall(f64),
    /// Either: the wall ends too near to where it would be met.
    Anything,
}

/// What a ray has to do that leaves a body on this side of the surface.
fn expected(product: &Product, inner: bool, start: &Ray) -> Expected {
    if !inner || matches!(product.kind, Kind::Rectangle | Kind::Triangle) {
        return Expected::Nothing;
    }
    let origin = start.origin.map(to_f64);
    let way = unit(start.direction.map(to_f64));
    let Some(t) = next_hit(product, origin, way) else {
        return match product.kind {
            // A ray that starts within leaves it somewhere: it can't have started within.
            Kind::Sphere => Expected::Wall(f64::INFINITY),
            _ => Expected::Anything,
        };
    };
    if product.kind == Kind::Cone {
        let head = product.head();
        let height = to_f64(product.rest()[2]);
        let reached = less(along(origin, t, way), head.centre);
        let share = dot(reached, head.axis) / height;
        if !(END..=1.0 - END).contains(&share) {
            return Expected::Anything;
        }
    }
    Expected::Wall(t)
}

/// Tries packets, each of rays to its own body, by a light.
fn try_packets(
    bench: &mut Bench,
    products: &[&Product],
    lines: &[[Line; 16]],
    light: [Single; 3],
    tally: &mut Tally,
) {
    let rays = |lines: &[Line; 16]| lines.map(|[from, way]| Some(fresh(from, way)));
    let rays: Vec<Lanes> = lines.iter().map(rays).collect();
    let hits = meet(bench, products, &rays);
    let leaving = leave(bench, products, &hits, light);
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
            // What is let through goes on behind the surface that the ray has met.
            let (before, edge) = side(product, &leaving[number], lane, &lines[number][lane]);
            if edge {
                tally.uncounted();
                continue;
            }
            let inner = before == matches!(kind, Start::Refracted);
            let after = &after[number][lane];
            let met = (after.object == HIT).then(|| to_f64(after.t));
            let input = || {
                let line = lines[number][lane];
                let rest = line.into_iter().chain([light]).flatten();
                product.words().chain(rest).collect()
            };
            match (expected(product, inner, &start), met) {
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

/// Whether a lane's ray has met its body from the outer side, and whether so near to the body's
/// edge that rounding decides that.
fn side(product: &Product, leaving: &Leaving, lane: usize, line: &Line) -> (bool, bool) {
    let found = &leaving.surfaces;
    let [point, plane] = [
        [&found.point_x, &found.point_y, &found.point_z],
        [&found.plane_x, &found.plane_y, &found.plane_z],
    ]
    .map(|rows| rows.map(|row| exactly(row[lane])));
    let head = product.head();
    let from = less(point, head.centre);
    let off = along(from, -dot(from, head.axis), head.axis);
    let distance = length(off);
    let scale = if head.gain == 0.0 {
        0.0
    } else {
        head.gain / distance
    };
    let normal = along(off.map(|x| scale * x), head.slope, head.axis);
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
            let light = along(around, far, direction(random)).map(from_f64);
            let products: Vec<&Product> = bodies.iter().map(|body| &body.product).collect();
            try_packets(bench, &products, &lines, light, tally);
        }
    }

    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed {
        let of_product = Product::word_count(self.kind);
        need(of_product + LINES, words)?;
        let (object, lines) = words.split_at(of_product);
        let product = Product::from_words(self.kind, object);
        let [origin, direction, light] = points_of(lines)?;
        let lines = [[[origin, direction]; 16]];
        try_packets(bench, &[&product], &lines, light, tally);
        Ok(())
    }
}
