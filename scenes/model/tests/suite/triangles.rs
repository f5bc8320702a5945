//! Triangles of convex, concave, crossing and degenerate polygons.

use glam::DVec3;
use proptest::collection::vec;
use proptest::prelude::*;
use scenes::{area_vector, even_odd, triangles};

fn polygon(corners: &[(f64, f64)]) -> Vec<DVec3> {
    let lift = |&(x, y): &(f64, f64)| DVec3::new(x, y, 3.0 + 0.5 * x - y);
    corners.iter().map(lift).collect()
}

fn area(vertices: &[DVec3], triangle: [u32; 3]) -> DVec3 {
    area_vector(&triangle.map(|index| vertices[index as usize]))
}

#[test]
fn convex_polygon_gives_fan() {
    let hexagon =
        polygon(&[(2.0, 0.0), (1.0, 2.0), (-1.0, 2.0), (-2.0, 0.0), (-1.0, -2.0), (1.0, -2.0)]);
    assert_eq!(
        triangles(&hexagon).expect("no edges cross"),
        [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]
    );
}

#[test]
fn concave_polygon_is_covered_once() {
    // A comb of 40 teeth and a star, each triangle counter-clockwise and their areas the whole.
    let mut comb: Vec<(f64, f64)> = vec![(0.0, 0.0), (80.0, 0.0)];
    for tooth in (0..40).rev() {
        let x = f64::from(tooth) * 2.0;
        comb.extend([(x + 1.0, 5.0), (x + 0.5, 1.0)]);
    }
    let star: Vec<(f64, f64)> = (0..14)
        .map(|point| {
            let angle = f64::from(point) * std::f64::consts::PI / 7.0;
            let radius = if point % 2 == 0 { 3.0 } else { 1.0 };
            (radius * libm::cos(angle), radius * libm::sin(angle))
        })
        .collect();
    for corners in [comb, star] {
        let vertices = polygon(&corners);
        let whole = area_vector(&vertices);
        let parts = triangles(&vertices).expect("no edges cross");
        assert_eq!(parts.len(), vertices.len() - 2);
        let mut sum = 0.0;
        for part in parts {
            let part = area(&vertices, part);
            assert!(part.dot(whole) > 0.0, "{part}");
            sum += part.length();
        }
        assert!((sum / whole.length() - 1.0).abs() < 1e-12, "{sum}");
    }
}

#[test]
fn area_equals_polygon_area_far_from_origin() {
    let square = [DVec3::ZERO, DVec3::X, DVec3::ONE.with_z(0.0), DVec3::Y];
    let far = square.map(|corner| corner + 1e9);
    assert_eq!(area_vector(&square), DVec3::Z * 2.0);
    assert!(area_vector(&far).distance(DVec3::Z * 2.0) < 1e-5);
    assert_eq!(area_vector(&[]), DVec3::ZERO);
}

#[test]
fn degenerate_polygons_still_give_their_triangles() {
    let line = polygon(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 0.0)]);
    let point = vec![DVec3::ONE; 5];
    for vertices in [line, point] {
        let parts = triangles(&vertices).expect("no edges cross");
        assert_eq!(parts.len(), vertices.len() - 2);
        assert_eq!(even_odd(&vertices, 9).expect("few"), [[DVec3::ZERO; 3]; 0]);
    }
    assert_eq!(triangles(&[DVec3::X, DVec3::Y]), Some(Vec::new()));
    assert_eq!(even_odd(&[], 9), Some(Vec::new()));
}

/// Points of a circle, each `step` steps on from the last.
fn star(points: u32, step: u32) -> Vec<(f64, f64)> {
    let point = |index: u32| {
        let angle = f64::from(index * step % points) / f64::from(points) * std::f64::consts::TAU;
        (libm::cos(angle), libm::sin(angle))
    };
    (0..points).map(point).collect()
}

fn sum_of_areas(parts: &[[DVec3; 3]]) -> f64 {
    parts.iter().map(|part| area_vector(part).length()).sum()
}

#[test]
fn pentagram_is_filled_except_centre() {
    let vertices = polygon(&star(5, 2));
    assert_eq!(triangles(&vertices), None);
    let parts = even_odd(&vertices, 5).expect("few");
    assert_eq!(parts.len(), 5);
    let front = area_vector(&vertices);
    for part in &parts {
        assert!(area_vector(part).dot(front) > 0.0);
        assert_eq!(part.iter().filter(|corner| vertices.contains(corner)).count(), 1);
    }
    // Neighbouring tips share the crossing between them to the bit.
    let shared = |one: &[DVec3; 3], other: &[DVec3; 3]| one.iter().any(|it| other.contains(it));
    let neighbours = |part| parts.iter().filter(|other| shared(part, other)).count() - 1;
    assert_eq!(parts.iter().map(neighbours).collect::<Vec<_>>(), [2; 5]);
    // The pentagon in the middle counts twice in the area by windings, and not at all here.
    let inner = polygon(&star(5, 1));
    let ratio = (3.0 - 5f64.sqrt()) / 2.0;
    let middle = ratio.powi(2) * area_vector(&inner).length();
    let expected = front.length() - 2.0 * middle;
    assert!((sum_of_areas(&parts) / expected - 1.0).abs() < 1e-12);
    assert_eq!(even_odd(&vertices, 4), None);
}

#[test]
fn area_enclosed_twice_is_outside() {
    let twice = [star(3, 1), star(3, 1)].concat();
    let vertices = polygon(&twice);
    assert_eq!(triangles(&vertices), None);
    assert_eq!(even_odd(&vertices, 9), Some(Vec::new()));
}

#[test]
fn hole_may_be_joined_by_double_edge() {
    let outer = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, 0.0)];
    // A hole that goes round the other way is found by ears, one that goes round the same way is
    // not.
    let hole = [(1.0, 1.0), (1.0, 2.0), (2.0, 2.0), (2.0, 1.0), (1.0, 1.0)];
    let mut other_way = hole;
    other_way.reverse();
    let with_hole = polygon(&[&outer[..], &hole].concat());
    assert!(triangles(&with_hole).is_some());
    let other_way = polygon(&[&outer[..], &other_way].concat());
    assert_eq!(triangles(&other_way), None);
    let parts = even_odd(&other_way, 99).expect("few");
    let whole = area_vector(&with_hole).length();
    assert!((sum_of_areas(&parts) / whole - 1.0).abs() < 1e-12);
}

#[test]
fn too_many_crossings_stop_early() {
    let vertices = polygon(&star(1025, 512));
    assert_eq!(even_odd(&vertices, 1024), None);
    let spokes: Vec<(f64, f64)> = (0..501)
        .flat_map(|index| {
            let angle = f64::from(index) / 501.0 * std::f64::consts::PI;
            let (x, y) = (libm::cos(angle), libm::sin(angle));
            let ends = [(x, y), (-x, -y)];
            if index % 2 == 0 { ends } else { [ends[1], ends[0]] }
        })
        .collect();
    // All go through the middle.
    let parts = even_odd(&polygon(&spokes), 1024).expect("one crossing");
    assert_eq!(parts.len(), 501);
}

/// Whether a point is in a triangle, by how much at least; negative outside.
fn depth(part: &[DVec3; 3], point: DVec3) -> f64 {
    let [a, b, c] = part.map(|corner| (corner - point).truncate());
    let side = |from: glam::DVec2, to: glam::DVec2| from.perp_dot(to) / from.distance(to);
    side(a, b).min(side(b, c)).min(side(c, a))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    /// Few places, so that vertices and edges meet in all the ways there are, and any places.
    #[test]
    fn inside_is_odd_number_of_crossings(
        rough in vec((0..5i32, 0..5i32), 3..14),
        fine in vec((0.0..4.0f64, 0.0..4.0f64), 3..14),
        is_rough in any::<bool>(),
        samples in vec((-0.5..4.5f64, -0.5..4.5f64), 100),
    ) {
        let rough = rough.iter().map(|&(x, y)| (f64::from(x), f64::from(y))).collect();
        let mut corners: Vec<(f64, f64)> = if is_rough { rough } else { fine };
        let area = |corners: &[(f64, f64)]| -> f64 {
            let next = corners.iter().cycle().skip(1);
            corners.iter().zip(next).map(|(a, b)| a.0 * b.1 - a.1 * b.0).sum()
        };
        if area(&corners) < 0.0 {
            corners.reverse();
        }
        if area(&corners) < 1e-3 {
            // It has no front.
            return Ok(());
        }
        let vertices = polygon(&corners);
        let parts = match triangles(&vertices) {
            Some(parts) => parts
                .iter()
                .map(|part| part.map(|index| vertices[index as usize]))
                .collect(),
            None => even_odd(&vertices, 10_000).expect("few"),
        };
        for (x, y) in samples {
            let point = DVec3::new(x, y, 0.0);
            let next = corners.iter().cycle().skip(1);
            let crossed = corners.iter().zip(next).filter(|(a, b)| {
                (a.1 > y) != (b.1 > y) && x < a.0 + (y - a.1) / (b.1 - a.1) * (b.0 - a.0)
            });
            let is_inside = crossed.count() % 2 == 1;
            let near = |part: &&[DVec3; 3]| depth(part, point) > -1e-9;
            let within = |part: &&[DVec3; 3]| depth(part, point) > 1e-9;
            let (min, max) = (parts.iter().filter(within).count(), parts.iter().filter(near).count());
            prop_assert!(
                min <= usize::from(is_inside) && max >= usize::from(is_inside),
                "{point} is in {min} to {max} triangles of {corners:?}"
            );
        }
    }

    /// Seen from its middle each corner of a star is farther than the last: no edges cross,
    /// wherever it is.
    #[test]
    fn simple_polygon_gets_no_new_vertices(
        radii in vec(0.01..1.0f64, 3..40),
        (size, away) in (-6..6i32, -1e6..1e6f64),
    ) {
        let size = 10f64.powi(size);
        let corners: Vec<(f64, f64)> = (0..)
            .zip(&radii)
            .map(|(index, radius)| {
                let angle = f64::from(index) / radii.len() as f64 * std::f64::consts::TAU;
                (radius * size * libm::cos(angle), radius * size * libm::sin(angle))
            })
            .collect();
        let vertices: Vec<DVec3> = polygon(&corners).iter().map(|at| *at + away * size).collect();
        let parts = triangles(&vertices);
        prop_assert_eq!(parts.map(|parts| parts.len()), Some(vertices.len() - 2));
    }
}
