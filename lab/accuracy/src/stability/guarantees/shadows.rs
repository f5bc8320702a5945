//! Shadows are symmetric: a point sees a light exactly if the light sees the point. The only
//! exceptions are lines that pass an object's edge within the rounding of the rays.

use std::marker::PhantomData;

use kernels::cases::whitted::isect::sphere::{FRONT, SphereObject, sphere};
use kernels::cases::whitted::shade::light::{Shadows, Site};
use kernels::description::Description as _;
use twins::ONE;
use twins::shadow_rays::Place;
use twins::surfaces::Surface;

use crate::stability::prelude::*;
use crate::stability::random::nearby;
use crate::stability::steps::{NO_RAY, NOT_THERE};
use crate::stability::stress::spheres::TANGENT;
use crate::stability::stress::triangles::{EDGE, off_edges};
use crate::truth;

/// An object that may be between a point and a light.
trait Blocker: Shape + Sync {
    const NAME: &'static str;
    /// The number of words that describe it.
    const WORDS: usize;
    /// A random object of about this size at this place.
    fn any(place: Vector, size: f64, random: &mut Generator) -> Self;
    /// A point on its outline as seen along a direction, and the direction away from the outline
    /// there.
    fn outline(&self, random: &mut Generator) -> [Vector; 2];
    /// The distance between a line and its outline.
    fn off_outline(&self, from: Point, to: Point) -> f64;
    fn words(&self) -> Vec<u32>;
    fn from_words(words: &[u32]) -> Self;
}

impl Blocker for By<Perpendicular> {
    const NAME: &'static str = "shadow-spheres";
    const WORDS: usize = 4;

    fn any(place: Vector, size: f64, _: &mut Generator) -> Self {
        sphere(place, size, FRONT).into()
    }

    fn outline(&self, random: &mut Generator) -> [Vector; 2] {
        let normal = direction(random);
        let [level, _] = across(normal, random);
        let radius = to_f64(self.sphere.offset);
        [add_scaled(self.sphere.centre.map(to_f64), radius, normal), level]
    }

    fn off_outline(&self, from: Point, to: Point) -> f64 {
        let sphere = truth::sphere::Sphere::of_radius(self.sphere.centre, self.sphere.offset);
        let line =
            Line { origin: from.map(to_f64), direction: sub(to.map(to_f64), from.map(to_f64)) };
        sphere.passing(&line).beyond.abs() * sphere.radius()
    }

    fn words(&self) -> Vec<u32> {
        let [x, y, z] = self.sphere.centre;
        vec![x, y, z, self.sphere.offset]
    }

    fn from_words(words: &[u32]) -> Self {
        let sphere =
            SphereObject { centre: [words[0], words[1], words[2]], offset: words[3], sides: FRONT };
        sphere.into()
    }
}

impl Blocker for TriangleObject {
    const NAME: &'static str = "shadow-triangles";
    const WORDS: usize = 9;

    fn any(place: Vector, size: f64, random: &mut Generator) -> Self {
        let offsets = [(); 3].map(|()| in_cube(size, random));
        two_sided(offsets.map(|offset| add_scaled(place, 1.0, offset).map(from_f64)))
    }

    fn outline(&self, random: &mut Generator) -> [Vector; 2] {
        let from = random.random_range(0..3_usize);
        let [a, b] = [from, (from + 1) % 3].map(|k| self.vertices[k].map(to_f64));
        let share = random.random_range(0.0..1.0);
        [add_scaled(a, share, sub(b, a)), direction(random)]
    }

    fn off_outline(&self, from: Point, to: Point) -> f64 {
        let from = from.map(to_f64);
        off_edges(&self.vertices, from, sub(to.map(to_f64), from))
    }

    fn words(&self) -> Vec<u32> {
        self.vertices.as_flattened().to_vec()
    }

    fn from_words(words: &[u32]) -> Self {
        let corner = |at: usize| [words[at], words[at + 1], words[at + 2]];
        two_sided([corner(0), corner(3), corner(6)])
    }
}

/// Points and lights with one kind of object between them.
struct Symmetric<B>(PhantomData<fn() -> B>);

/// A family for each kind of object.
pub fn families() -> Families {
    // A direction has an error of this many ulps of 1 in each component, in either direction of
    // the ray. An ulp of the distance may be as little as half as large, relative to the distance.
    let direction = stated("shadow_rays_r16", "ulp of 1")?;
    let bound = |outline: f64| Bound {
        value: 2.0 * (2.0 * 3_f64.sqrt() * direction + outline),
        source: "header of shadow_rays_r16, and what decides at outlines, both ways".to_owned(),
    };
    Ok(vec![family::<By<Perpendicular>>(bound(TANGENT)), family::<TriangleObject>(bound(EDGE))])
}

fn family<B: Blocker + 'static>(bound: Bound) -> Family {
    Family {
        name: B::NAME,
        subject: B::KERNEL.to_owned(),
        unit: "ulp of the distance, off the outline",
        bound,
        rounds: 60,
        cases: Box::new(Symmetric::<B>(PhantomData)),
    }
}

/// Sixteen points that face along an axis, as a site.
fn site(points: &[Point; 16], axis: Vector) -> Site {
    let plane = axis.map(from_f64);
    let surface = |point: Point| Surface {
        point,
        plane,
        leave: 0,
        colour: [0; 3],
        diffuse: ONE,
        highlight: 0,
        exponent: 0,
        mirror: 0,
        transmittance: 0,
        ratio: ONE,
        schlick: 0,
        grazing: 0,
        lit: [0; 3],
        flags: 0,
    };
    let unasked = twins::surfaces::Ray { origin: [0; 3], direction: [0; 3], t: NOT_THERE };
    Site {
        surfaces: points.map(surface),
        normals: [plane; 16],
        directions: [plane.map(|x| x ^ 0x8000_0000); 16],
        weights: [ONE; 16],
        shines: false,
        shadow: [(unasked, false); 16],
    }
}

/// For each point and light, whether an object blocks the ray between them. `None` if there is no
/// such ray.
fn blocked<B: Blocker>(
    bench: &mut Bench,
    object: &B,
    points: &[Point; 16],
    lights: &[Point; 16],
    axis: Vector,
) -> Vec<[Option<bool>; 16]> {
    let site = site(points, axis);
    let packets: Vec<_> = lights
        .iter()
        .map(|light| {
            let light = Place { position: *light, falloff: 0 };
            let rays = Shadows { sites: vec![site.clone()], light, min_share: 0 }.call(bench);
            let rays = rays.packets.first().map(|packet| {
                packet.map(|ray| Ray {
                    origin: ray.origin,
                    direction: ray.direction,
                    t: ray.t,
                    object: 0,
                })
            });
            call::packet(&rays.unwrap_or([NO_RAY; 16]), 0)
        })
        .collect();
    let list: Vec<[usize; 2]> = (0..16).map(|packet| [0, packet]).collect();
    let (after, _) = call::pairs(bench, &packets, &[*object], &list, 0);
    let blocked = |ray: Ray| (ray.t as i32 > 0).then_some(ray.object != 0);
    after.iter().map(|packet| call::rays(packet).map(blocked)).collect()
}

/// Tries all pairs of points and lights.
fn try_pairs<B: Blocker>(
    bench: &mut Bench,
    object: &B,
    points: &[Point; 16],
    lights: &[Point; 16],
    axis: Vector,
    tally: &mut Tally,
) {
    let there = blocked(bench, object, points, lights, axis);
    let back = blocked(bench, object, lights, points, axis.map(|x| -x));
    for (p, l) in (0..16).flat_map(|p| (0..16).map(move |l| (p, l))) {
        let (Some(there), Some(back)) = (there[l][p], back[p][l]) else {
            tally.uncounted();
            continue;
        };
        let (point, light) = (points[p], lights[l]);
        let error = if there == back {
            0.0
        } else {
            let way = sub(light.map(to_f64), point.map(to_f64));
            object.off_outline(point, light) / spacing(length(way))
        };
        tally.error(error, || [object.words(), point.to_vec(), light.to_vec()].concat());
    }
}

impl<B: Blocker> Cases for Symmetric<B> {
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        let size = magnitude(-10, 10, random);
        let place = in_cube(4.0 * size, random);
        let object = B::any(place, size, random);
        let axis = direction(random);
        let mut points = [[0; 3]; 16];
        let mut lights = [[0; 3]; 16];
        for (point, light) in points.iter_mut().zip(&mut lights) {
            let [edge, way] = object.outline(random);
            let towards = if dot(way, axis) < 0.0 { -1.0 } else { 1.0 };
            let reach = [(); 2].map(|()| size * magnitude(-2, 4, random));
            *point = nearby(add_scaled(edge, -towards * reach[0], way), random);
            *light = nearby(add_scaled(edge, towards * reach[1], way), random);
        }
        try_pairs(bench, &object, &points, &lights, axis, tally);
    }

    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed {
        need(B::WORDS + 6, words)?;
        let (object, ends) = words.split_at(B::WORDS);
        let [point, light] = points_of(ends)?;
        let axis = unit(sub(light.map(to_f64), point.map(to_f64)));
        let object = B::from_words(object);
        try_pairs(bench, &object, &[point; 16], &[light; 16], axis, tally);
        Ok(())
    }
}
