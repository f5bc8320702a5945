//! The kernels that bound rays, together with those that test nodes' children: none is culled that
//! a ray of the packet meets, by f64 from the singles of the records.

use kernels::cases::whitted::rays::bounds::{Fans, Origins, Point};
use kernels::cases::whitted::rays::fans::{self, FANS, Fan, SCALES};
use kernels::cases::whitted::rays::nodes::{
    BareBox, BareSphere, Child, CullNodes, FilterChildren, Listed, Volume,
};
use kernels::cases::whitted::rays::paths::{PathBounds, PathsMeet};
use kernels::prelude::*;
use twins::bound::Bound;
use twins::primary_rays::Ray;

/// By how much a child's radius must exceed its sphere's, as a share of |c| + R.
const SLACK: f64 = 1.0 / (1 << 18) as f64;
/// More than a radius can lose by rounding to a single.
const ROUNDING: f64 = 1.0 + 1.0 / (1 << 22) as f64;
const NODES: usize = 16;
/// The fewest paths that `paths_meet` takes.
const PATHS: usize = 8;
const PACKETS: usize = 300;

/// The result of the kernels for one packet's children.
#[derive(Clone, Copy, Debug, Default)]
struct Outcome {
    tested: usize,
    kept: usize,
    met: usize,
    /// Met by a ray, but culled.
    lost: usize,
}

fn at(from: Vector, direction: Vector, distance: f64) -> Vector {
    std::array::from_fn(|axis| from[axis] + direction[axis] * distance)
}

/// Volumes near rays.
trait Near: Volume {
    /// By what part of |c| + R a volume of this sort, tested by the packets' bounds, must be too
    /// small for some to be left out.
    const TOO_SMALL: f64;

    /// A volume near a ray of the packet: its edge is a tiny distance away from the ray, its origin
    /// or its end, or it is at a random place. Larger by `slack`, a part of |c| + R. Also whether a
    /// part of a ray up to its t is in it.
    fn near(rays: &[&Ray], scale: f64, slack: f64, random: &mut ChaCha8Rng) -> (Self, bool);
}

/// A point on a ray of the packet, most of them near its origin or its end, and the ray's
/// direction.
fn place(rays: &[&Ray], scale: f64, random: &mut ChaCha8Rng) -> (Vector, Vector, f64) {
    let ray = rays[random.random_range(0..rays.len())];
    let (origin, direction) = (ray.origin.map(to_f64), unit(ray.direction.map(to_f64)));
    let end = to_f64(ray.t).min(scale * 1000.0);
    (origin, direction, end)
}

/// 1, and a tiny bit more or less.
fn nearly_one(random: &mut ChaCha8Rng) -> f64 {
    let hair = magnitude(1e-9..1e-1, random);
    if random.random() { 1.0 - hair } else { 1.0 + hair }
}

/// A distance up to the end of a ray, often a small one.
fn along(end: f64, random: &mut ChaCha8Rng) -> f64 {
    let share: f64 = random.random_range(0.0..1.0);
    end * share.powi(random.random_range(1..8))
}

impl Near for BareSphere {
    const TOO_SMALL: f64 = SLACK / 4.0;

    fn near(rays: &[&Ray], scale: f64, slack: f64, random: &mut ChaCha8Rng) -> (Self, bool) {
        let (origin, direction, end) = place(rays, scale, random);
        let radius = scale * magnitude(1e-4..30.0, random);
        let edge = radius * nearly_one(random);
        let along = along(end, random);
        let across = unit(cross(direction, any_direction(random)));
        let centre = match random.random_range(0..5) {
            0 => at(origin, direction, -edge),
            1 => at(origin, direction, end + edge),
            2 => at(origin, in_cube(1.0, random), 100.0 * scale),
            _ => at(at(origin, direction, along), across, edge),
        };
        let centre = centre.map(from_f64);
        let stored = centre.map(to_f64);
        let is_met = rays.iter().any(|ray| {
            let to_centre = sub(stored, ray.origin.map(to_f64));
            let direction = unit(ray.direction.map(to_f64));
            let nearest = dot(to_centre, direction).clamp(0.0, to_f64(ray.t));
            let apart = at(to_centre, direction, -nearest);
            dot(apart, apart) <= radius * radius
        });
        let slack = slack * (dot(stored, stored).sqrt() + radius);
        let radius = from_f64((radius + slack) * ROUNDING);
        (Self { centre, radius }, is_met)
    }
}

impl Near for BareBox {
    const TOO_SMALL: f64 = SLACK;

    fn near(rays: &[&Ray], scale: f64, slack: f64, random: &mut ChaCha8Rng) -> (Self, bool) {
        let (origin, direction, end) = place(rays, scale, random);
        let half: Vector = std::array::from_fn(|_| match random.random_range(0..8) {
            0 => 0.0,
            _ => scale * magnitude(1e-4..30.0, random),
        });
        let edge = nearly_one(random);
        // Towards the middle of the box from the place that its corner, edge or face touches.
        let inwards: Vector = any_direction(random);
        let mut to_centre: Vector =
            std::array::from_fn(|axis| half[axis] * edge.copysign(inwards[axis]));
        for axis in 0..random.random_range(0..3) {
            to_centre[axis] = half[axis] * random.random_range(-1.0..1.0);
        }
        to_centre.rotate_left(random.random_range(0..3));
        let mut half = half;
        if random.random() {
            half.rotate_left(1);
            to_centre.rotate_left(1);
        }
        let touched = match random.random_range(0..5) {
            0 => origin,
            1 => at(origin, direction, end),
            2 => at(origin, in_cube(1.0, random), 100.0 * scale),
            _ => at(origin, direction, along(end, random)),
        };
        let centre = at(touched, to_centre, 1.0).map(from_f64);
        let stored = centre.map(to_f64);
        let is_met = rays.iter().any(|ray| {
            let origin = ray.origin.map(to_f64);
            let direction = unit(ray.direction.map(to_f64));
            let (mut enters, mut leaves) = (0.0_f64, to_f64(ray.t));
            for axis in 0..3 {
                let to = stored[axis] - origin[axis];
                if direction[axis] == 0.0 {
                    if to.abs() > half[axis] {
                        return false;
                    }
                    continue;
                }
                let [one, other] =
                    [to - half[axis], to + half[axis]].map(|to| to / direction[axis]);
                enters = enters.max(one.min(other));
                leaves = leaves.min(one.max(other));
            }
            enters <= leaves
        });
        let slack = slack * (dot(stored, stored).sqrt() + dot(half, half).sqrt());
        let half = half.map(|half| from_f64((half + slack) * ROUNDING));
        (Self { centre, half }, is_met)
    }
}

/// Rays and their bounds.
type Bounded = ([Ray; 16], Vec<Bound>);

/// The test of nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Test {
    /// `cull_nodes`, by the packets' bounds.
    Bounds,
    /// `filter_children_r16`, by the rays themselves.
    Rays,
}

/// Makes rays for a scene of some scale.
type Source<'a> = &'a dyn Fn(&mut Bench, f64, &mut ChaCha8Rng) -> Bounded;

/// Rays from anywhere.
fn anywhere(fan: Fan) -> impl Fn(&mut Bench, f64, &mut ChaCha8Rng) -> Bounded {
    move |bench, scale, random| {
        let packet = fans::packet(fan, scale, random);
        (packet, Origins { packets: vec![packet] }.call(bench))
    }
}

/// Rays from the eye.
fn from_eye(bench: &mut Bench, scale: f64, random: &mut ChaCha8Rng) -> Bounded {
    let packet = fans::packet(Fan::Eye, scale, random);
    (packet, Fans { packets: vec![packet], point: Point::EYE }.call(bench))
}

/// Rays to a light.
fn to_light(bench: &mut Bench, scale: f64, random: &mut ChaCha8Rng) -> Bounded {
    let (packet, light) = fans::to_light(scale, random);
    (packet, Fans { packets: vec![packet], point: light }.call(bench))
}

fn outcome<V: Near>(
    bench: &mut Bench,
    test: Test,
    source: Source<'_>,
    slack: f64,
    random: &mut ChaCha8Rng,
) -> Outcome {
    let scale = magnitude(SCALES, random);
    let (packet, bounds) = source(bench, scale, random);
    let rays: Vec<&Ray> = packet.iter().filter(|ray| ray.t >> 31 == 0).collect();
    let mut outcome = Outcome::default();
    if rays.is_empty() {
        return outcome;
    }
    let mut met = Vec::new();
    let mut child = || {
        let (volume, is_met) = V::near(&rays, scale, slack, random);
        met.push(is_met);
        Child { volume, address: met.len() as u32 - 1 }
    };
    let nodes = (0..NODES).map(|_| [(); 4].map(|()| child())).collect();
    let pairs = (0..NODES).map(|node| [node, 0]).collect();
    let packets = vec![packet];
    let found = match test {
        Test::Bounds => CullNodes { nodes, bounds, pairs, what: Listed::Address }.call(bench),
        Test::Rays => FilterChildren { nodes, bounds, packets, pairs, in_place: true }.call(bench),
    };
    let mut kept = [false; 4 * NODES];
    for [child, ..] in &found {
        kept[*child as usize] = true;
    }
    for (met, kept) in met.iter().zip(kept) {
        outcome.tested += 1;
        outcome.met += usize::from(*met);
        outcome.kept += usize::from(kept);
        outcome.lost += usize::from(*met && !kept);
    }
    outcome
}

fn sum<V: Near>(name: &str, test: Test, source: Source<'_>, slack: f64) -> Outcome {
    let mut random = random();
    let mut bench = Bench::new();
    let mut sum = Outcome::default();
    for _ in 0..PACKETS {
        let one = outcome::<V>(&mut bench, test, source, slack, &mut random);
        sum.tested += one.tested;
        sum.kept += one.kept;
        sum.met += one.met;
        sum.lost += one.lost;
    }
    println!("{name}, {}, {test:?}, slack {slack:.1e}: {sum:?}", V::CULL);
    sum
}

#[test]
fn met_children_are_kept() {
    none_is_left_out::<BareSphere>();
    none_is_left_out::<BareBox>();
}

fn none_is_left_out<V: Near>() {
    let check = |name: &str, source: Source<'_>| {
        let sum = sum::<V>(name, Test::Bounds, source, SLACK);
        assert_eq!(sum.lost, 0, "{name}");
        assert!(sum.met > sum.tested / 10, "{name}: {sum:?}");
    };
    for fan in FANS {
        check(&format!("{fan:?}"), &anywhere(fan));
    }
    check("from the eye", &from_eye);
    check("to a light", &to_light);
}

/// No path is left out that crosses a sphere, up to where its rays end; and of narrow cones many
/// that miss one are.
#[test]
fn crossing_paths_are_met() {
    let check = |name: &str, is_narrow: bool, to_hits: bool, source: Source<'_>| {
        let (mut random, mut bench) = (random(), Bench::new());
        let mut sum = Outcome::default();
        for _ in 0..PACKETS / 4 {
            let scale = magnitude(SCALES, &mut random);
            let (packet, bounds) = source(&mut bench, scale, &mut random);
            let rays: Vec<&Ray> = packet.iter().filter(|ray| ray.t >> 31 == 0).collect();
            if rays.is_empty() {
                continue;
            }
            let bounds = vec![bounds[0]; PATHS];
            let made = PathBounds { bounds, ..PathBounds::of(vec![packet; PATHS], to_hits) };
            let paths = made.call(&mut bench);
            for _ in 0..NODES {
                let (volume, is_met) = BareSphere::near(&rays, scale, SLACK, &mut random);
                let nodes = vec![[Child { volume, address: 0 }; 4]];
                let kept = PathsMeet { paths: paths.clone(), nodes }.call(&mut bench) != 0;
                sum.tested += 1;
                sum.met += usize::from(is_met);
                sum.kept += usize::from(kept);
                sum.lost += usize::from(is_met && !kept);
            }
        }
        println!("{name}, paths: {sum:?}");
        assert_eq!(sum.lost, 0, "{name}");
        assert!(sum.met > sum.tested / 10, "{name}: {sum:?}");
        let (missed, left_out) = (sum.tested - sum.met, sum.tested - sum.kept);
        assert!(!is_narrow || 3 * left_out > missed, "{name}: {sum:?}");
    };
    for fan in FANS {
        let is_narrow =
            matches!(fan, Fan::Eye | Fan::Coherent | Fan::Shadow | Fan::One | Fan::Half);
        check(&format!("{fan:?}"), is_narrow, true, &anywhere(fan));
    }
    check("from the eye", true, true, &from_eye);
    check("to a light", true, false, &to_light);
}

/// The volumes are so near to the rays, and the bounds so tight, that slightly smaller ones are not
/// enough.
#[test]
fn volumes_slightly_too_small_are_culled() {
    some_are_left_out::<BareSphere>();
    some_are_left_out::<BareBox>();
}

fn some_are_left_out<V: Near>() {
    let check = |name: &str, source: Source<'_>| {
        let sum = sum::<V>(name, Test::Bounds, source, -V::TOO_SMALL);
        assert!(sum.lost > sum.met / 1000, "{name}: {sum:?}");
    };
    for fan in [Fan::Eye, Fan::Incoherent, Fan::One, Fan::Wide] {
        check(&format!("{fan:?}"), &anywhere(fan));
    }
    check("from the eye", &from_eye);
}

/// For rays in similar directions, many children that they miss are culled, although most of these
/// volumes almost touch a ray.
#[test]
fn coherent_packets_cull_many_missed_children() {
    much_is_left_out::<BareSphere>(3);
    much_is_left_out::<BareBox>(6);
}

/// At least one in `part` of the missed ones.
fn much_is_left_out<V: Near>(part: usize) {
    let check = |name: &str, source: Source<'_>| {
        let sum = sum::<V>(name, Test::Bounds, source, SLACK);
        let (missed, left_out) = (sum.tested - sum.met, sum.tested - sum.kept);
        assert!(part * left_out > missed, "{name}: {sum:?}");
    };
    for fan in [Fan::Eye, Fan::Coherent, Fan::Shadow, Fan::One, Fan::Half] {
        check(&format!("{fan:?}"), &anywhere(fan));
    }
    check("from the eye", &from_eye);
    check("to a light", &to_light);
}

/// By the rays themselves, a child is kept if and only if a ray meets it or nearly does, in
/// whatever directions they go.
#[test]
fn ray_filter_keeps_few_missed_children() {
    hardly_anything_else_is_kept::<BareSphere>();
    hardly_anything_else_is_kept::<BareBox>();
}

fn hardly_anything_else_is_kept<V: Near>() {
    for fan in FANS {
        let sum = sum::<V>(&format!("{fan:?}"), Test::Rays, &anywhere(fan), SLACK);
        assert_eq!(sum.lost, 0, "{fan:?}");
        assert!(sum.met > sum.tested / 10, "{fan:?}: {sum:?}");
        let (missed, left_out) = (sum.tested - sum.met, sum.tested - sum.kept);
        assert!(3 * left_out > missed, "{fan:?}: {sum:?}");
    }
}

/// The same as for the packets' bounds: volumes a hair too small are not enough.
#[test]
fn ray_filter_culls_volumes_slightly_too_small() {
    for fan in [Fan::Eye, Fan::Incoherent, Fan::One, Fan::Wide] {
        let name = format!("{fan:?}");
        let spheres = sum::<BareSphere>(&name, Test::Rays, &anywhere(fan), -SLACK);
        let boxes = sum::<BareBox>(&name, Test::Rays, &anywhere(fan), -SLACK);
        assert!(spheres.lost > 0, "{fan:?}: {spheres:?}");
        assert!(boxes.lost > 0, "{fan:?}: {boxes:?}");
    }
}
