//! `isect_rectangle_pairs_r16`, `shear_packets_r16` and `isect_triangle_pairs_r16`.

use kernels::bench::{Bench, random};
use kernels::cases::ball::ray;
use kernels::cases::flat::rectangle;
use kernels::cases::whitted::isect::call;
use kernels::cases::whitted::isect::rectangle::RectangleObject;
use kernels::cases::whitted::isect::shape::Shape;
use kernels::cases::whitted::isect::triangle::TriangleObject;
use kernels::flat_records::{Shears, point};
use oracle::twin::FARTHEST;
use oracle::twin::ball::Ray;
use oracle::twin::triangle::shear;
use rand::Rng as _;

use crate::{COUNTS, check, straight};

/// Whether an object is hit by sixteen rays alike.
fn is_hit<S: Shape>(bench: &mut Bench, ray: Ray, object: S) -> bool {
    // Bits of the sides that mean nothing here.
    let [none, all] = [0, u32::MAX].map(|anything| {
        let (rays, objects) = check(bench, &[[ray; 16]], &[object], &[[0, 0]], anything);
        rays[0].map(|ray| ray.object == objects[0])
    });
    assert_eq!(none, all, "other sides matter");
    assert!(none.iter().all(|hit| *hit == none[0]));
    none[0]
}

/// The scene turned with the ray, along each axis and either way.
fn turned(from: [f64; 3], turn: usize, way: f64) -> [f64; 3] {
    let mut to = [0.0; 3];
    for axis in 0..3 {
        to[(axis + turn) % 3] = from[axis] * way;
    }
    to
}

#[test]
fn from_before_and_from_behind() {
    let mut bench = Bench::new();
    for turn in 0..3 {
        // Point reflection turns the order of the vertices round.
        for (way, front) in [(1.0, true), (-1.0, true), (1.0, false), (-1.0, false)] {
            for both in [false, true] {
                let place = |point: [f64; 3]| turned(point, turn, way);
                let (first, second) = ([2.0, 0.0, 0.0], [0.0, 2.0, 0.0]);
                // Seen along -z, counter-clockwise is from x to y.
                let (first, second) = if front {
                    (first, second)
                } else {
                    (second, first)
                };
                let corner = [-0.9, -0.9, -5.0];
                let behind = [-0.9, -0.9, 5.0];
                let straight = ray(place([0.0; 3]), place([0.0, 0.0, -1.0]), FARTHEST);
                let vertex = |edge: [f64; 3]| {
                    point(place(std::array::from_fn(|axis| corner[axis] + edge[axis])))
                };
                let vertices = [[0.0; 3], first, second].map(vertex);
                let seen = front == (way > 0.0) || both;
                let [first, second] = [first, second].map(place);
                // The normal is first x second: a reflection keeps it while all else turns round.
                let shape = |corner| RectangleObject {
                    rectangle: rectangle(place(corner), first, second),
                    both,
                };
                assert_eq!(is_hit(&mut bench, straight, shape(corner)), seen);
                assert!(!is_hit(&mut bench, straight, shape(behind)));
                let triangle = TriangleObject { vertices, both };
                assert_eq!(is_hit(&mut bench, straight, triangle), seen);
                let away = Ray {
                    direction: point(place([0.0, 0.0, 1.0])),
                    ..straight
                };
                assert!(!is_hit(&mut bench, away, triangle));
            }
        }
    }
}

#[test]
fn along_the_plane_and_from_within_it_is_no_hit() {
    let mut bench = Bench::new();
    let corner = [-1.0, -1.0, -5.0];
    let flat = rectangle(corner, [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]);
    let vertices = [corner, [1.0, -1.0, -5.0], [-1.0, 1.0, -5.0]].map(point);
    for (origin, direction) in [
        ([-3.0, 0.0, -5.0], [1.0, 0.0, 0.0]),
        ([-0.5, -0.5, -5.0], [0.0, 0.0, -1.0]),
        ([-0.5, -0.5, -5.0], [0.0, 0.0, 1.0]),
    ] {
        for both in [false, true] {
            let ray = ray(origin, direction, FARTHEST);
            let rectangle = RectangleObject {
                rectangle: flat,
                both,
            };
            assert!(!is_hit(&mut bench, ray, rectangle));
            assert!(!is_hit(&mut bench, ray, TriangleObject { vertices, both }));
        }
    }
}

#[test]
fn an_edge_belongs_to_both_triangles_and_to_the_rectangle() {
    let mut bench = Bench::new();
    let straight = ray([0.0; 3], [0.0, 0.0, -1.0], FARTHEST);
    let [a, b] = [[0.0, -1.0, -5.0], [0.0, 1.0, -5.0]];
    for vertices in [[a, b, [-1.0, 0.0, -5.0]], [a, [1.0, 0.0, -5.0], b]] {
        let triangle = TriangleObject {
            vertices: vertices.map(point),
            both: false,
        };
        assert!(is_hit(&mut bench, straight, triangle));
    }
    let rectangle = RectangleObject {
        rectangle: rectangle(a, [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]),
        both: false,
    };
    assert!(is_hit(&mut bench, straight, rectangle));
}

#[test]
fn shears_of_packets_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for round in 0..100 {
        for count in COUNTS.into_iter().map(|count| count.min(24)) {
            let packets: Vec<[Ray; 16]> = (0..count)
                .map(|_| match round % 2 {
                    0 => straight().map(|ray| Ray {
                        origin: random.random(),
                        direction: random.random(),
                        ..ray
                    }),
                    _ => TriangleObject::around(&mut random, 1.0).1,
                })
                .collect();
            let records: Vec<_> = packets
                .iter()
                .map(|rays| call::packet(rays, random.random()))
                .collect();
            bench.reset();
            let placed = call::place::<TriangleObject>(&mut bench, &records, &[], &[], 0);
            let shears: Vec<Shears> = bench.read_all(placed.shears.expect("triangles take shears"));
            for (shears, rays) in shears.iter().zip(packets) {
                for (lane, ray) in rays.iter().enumerate() {
                    let expected = shear(ray.origin, ray.direction);
                    assert_eq!(shears.lane(lane), expected, "{ray:x?}");
                }
            }
        }
    }
}
