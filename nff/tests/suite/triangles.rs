//! Triangles of convex, concave and degenerate polygons.

use glam::DVec3;
use nff::{area_vector, triangles};

fn polygon(corners: &[(f64, f64)]) -> Vec<DVec3> {
    let lift = |&(x, y): &(f64, f64)| DVec3::new(x, y, 3.0 + 0.5 * x - y);
    corners.iter().map(lift).collect()
}

fn area(vertices: &[DVec3], triangle: [u32; 3]) -> DVec3 {
    area_vector(&triangle.map(|index| vertices[index as usize]))
}

#[test]
fn a_convex_polygon_gives_a_fan() {
    let hexagon = polygon(&[
        (2.0, 0.0),
        (1.0, 2.0),
        (-1.0, 2.0),
        (-2.0, 0.0),
        (-1.0, -2.0),
        (1.0, -2.0),
    ]);
    assert_eq!(
        triangles(&hexagon),
        [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]
    );
}

#[test]
fn a_concave_polygon_is_covered_once() {
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
        let parts = triangles(&vertices);
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
fn the_area_is_that_of_the_polygon_far_away_too() {
    let square = [DVec3::ZERO, DVec3::X, DVec3::ONE.with_z(0.0), DVec3::Y];
    let far = square.map(|corner| corner + 1e9);
    assert_eq!(area_vector(&square), DVec3::Z * 2.0);
    assert!(area_vector(&far).distance(DVec3::Z * 2.0) < 1e-5);
    assert_eq!(area_vector(&[]), DVec3::ZERO);
}

#[test]
fn degenerate_polygons_still_give_their_triangles() {
    let line = polygon(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 0.0)]);
    let bow_tie = polygon(&[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)]);
    let point = vec![DVec3::ONE; 5];
    for vertices in [line, bow_tie, point] {
        assert_eq!(triangles(&vertices).len(), vertices.len() - 2);
    }
    assert_eq!(triangles(&[DVec3::X, DVec3::Y]), [[0u32; 3]; 0]);
}
