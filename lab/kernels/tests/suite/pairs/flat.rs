//! `isect_rectangle_pairs_r16`, `shear_packets_r16`, `isect_triangle_pairs_r16` and
//! `isect_triangle_mt_pairs_r16`.

use kernels::cases::flat::rectangle;
use kernels::cases::sphere_ray::ray;
use kernels::cases::whitted::isect::rectangle::RectangleObject;
use kernels::cases::whitted::isect::shape::Shape;
use kernels::cases::whitted::isect::triangle::TriangleObject;
use kernels::cases::whitted::isect::triangle_mt::MoellerTrumbore;
use twins::sphere_ray::Ray;

use super::check;
use kernels::prelude::*;

/// Whether sixteen equal rays hit an object.
fn is_hit<S: Shape>(bench: &mut Bench, ray: Ray, object: S) -> bool {
    // The bits of the sides that must have no effect here.
    let [none, all] = [0, u32::MAX].map(|anything| {
        let (rays, objects) = check(bench, &[[ray; 16]], &[object], &[[0, 0]], anything);
        rays[0].map(|ray| ray.object == objects[0])
    });
    assert_eq!(none, all, "other sides matter");
    assert!(none.iter().all(|hit| *hit == none[0]));
    none[0]
}

/// The scene turned together with the ray, along each axis in both directions.
fn turned(from: [f64; 3], turn: usize, way: f64) -> [f64; 3] {
    let mut to = [0.0; 3];
    for axis in 0..3 {
        to[(axis + turn) % 3] = from[axis] * way;
    }
    to
}

#[test]
fn flat_shapes_are_hit_from_visible_sides() {
    let mut bench = Bench::new();
    for turn in 0..3 {
        // A point reflection reverses the orientation of the vertices.
        for (way, front) in [(1.0, true), (-1.0, true), (1.0, false), (-1.0, false)] {
            for both in [false, true] {
                let place = |point: [f64; 3]| turned(point, turn, way);
                let (first, second) = ([2.0, 0.0, 0.0], [0.0, 2.0, 0.0]);
                // Seen along -z, counter-clockwise is from x to y.
                let (first, second) = if front { (first, second) } else { (second, first) };
                let corner = [-0.9, -0.9, -5.0];
                let opposite = [-0.9, -0.9, 5.0];
                let straight = ray(place([0.0; 3]), place([0.0, 0.0, -1.0]), FARTHEST);
                let vertex = |edge: [f64; 3]| {
                    point(place(std::array::from_fn(|axis| corner[axis] + edge[axis])))
                };
                let vertices = [[0.0; 3], first, second].map(vertex);
                let seen = front == (way > 0.0) || both;
                let [first, second] = [first, second].map(place);
                // The normal is first x second. A reflection keeps it, while everything else is
                // reversed.
                let shape = |corner| RectangleObject {
                    rectangle: rectangle(place(corner), first, second),
                    both,
                };
                assert_eq!(is_hit(&mut bench, straight, shape(corner)), seen);
                assert!(!is_hit(&mut bench, straight, shape(opposite)));
                let triangle = TriangleObject { vertices, both };
                let other = MoellerTrumbore(triangle);
                assert_eq!(is_hit(&mut bench, straight, triangle), seen);
                assert_eq!(is_hit(&mut bench, straight, other), seen);
                let away = Ray { direction: point(place([0.0, 0.0, 1.0])), ..straight };
                assert!(!is_hit(&mut bench, away, triangle));
                assert!(!is_hit(&mut bench, away, other));
            }
        }
    }
}

#[test]
fn ray_in_plane_misses() {
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
            let rectangle = RectangleObject { rectangle: flat, both };
            assert!(!is_hit(&mut bench, ray, rectangle));
            let triangle = TriangleObject { vertices, both };
            assert!(!is_hit(&mut bench, ray, triangle));
            assert!(!is_hit(&mut bench, ray, MoellerTrumbore(triangle)));
        }
    }
}

#[test]
fn an_edge_belongs_to_both_triangles_and_to_the_rectangle() {
    let mut bench = Bench::new();
    let straight = ray([0.0; 3], [0.0, 0.0, -1.0], FARTHEST);
    let [a, b] = [[0.0, -1.0, -5.0], [0.0, 1.0, -5.0]];
    for vertices in [[a, b, [-1.0, 0.0, -5.0]], [a, [1.0, 0.0, -5.0], b]] {
        let triangle = TriangleObject { vertices: vertices.map(point), both: false };
        assert!(is_hit(&mut bench, straight, triangle));
        assert!(is_hit(&mut bench, straight, MoellerTrumbore(triangle)));
    }
    let rectangle =
        RectangleObject { rectangle: rectangle(a, [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]), both: false };
    assert!(is_hit(&mut bench, straight, rectangle));
}

/// The faces of a tetrahedron by its vertices, each counter-clockwise as seen from inside.
const FACES: [[usize; 3]; 4] = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];

#[test]
fn no_ray_leaves_a_mesh_that_is_seen_from_within() {
    let mut random = random();
    let mut bench = Bench::new();
    let list: Vec<[usize; 2]> = (0..FACES.len()).map(|face| [face, 0]).collect();
    for round in 0..4000 {
        let far = if round % 2 == 0 { 0.0 } else { 1e5 };
        let corners = loop {
            let corners: [[f64; 3]; 4] = std::array::from_fn(|_| {
                in_cube(10.0, &mut random).map(|component| component + far)
            });
            let [a, b, c, d] = corners;
            let volume = dot(cross(sub(b, a), sub(c, a)), sub(d, a));
            if volume > 100.0 {
                break corners;
            }
        };
        let middle = std::array::from_fn(|axis| {
            corners.iter().map(|corner| corner[axis]).sum::<f64>() / 4.0
        });
        let faces = FACES.map(|mut face| {
            face.rotate_left(random.random_range(0..3));
            TriangleObject { vertices: face.map(|corner| point(corners[corner])), both: false }
        });
        // To vertices, to the middles of edges, and to random points on them.
        let rays = std::array::from_fn(|lane| {
            let [from, to] = [lane % 4, (lane + 1 + lane / 8) % 4].map(|corner| corners[corner]);
            let along = match lane / 4 {
                0 => 0.0,
                1 => 0.5,
                _ => random.random_range(0.0..1.0),
            };
            let target: [f64; 3] =
                std::array::from_fn(|axis| from[axis] + along * (to[axis] - from[axis]));
            ray(middle, unit(sub(target, middle)), FARTHEST)
        });
        let (rays, objects) = check(&mut bench, &[rays], &faces, &list, 0);
        for ray in rays[0] {
            assert!(objects.contains(&ray.object), "{ray:x?} leaks out of {faces:x?}");
        }
    }
}
