//! Shapes whose hits follow from geometry, and rays that leave surfaces.

use glam::DVec3;
use scenes::Shape;

use super::*;
use crate::random::Random;

/// Some shape in the cube from -1 to 1, about `size` large.
pub(crate) fn random_shape(random: &mut Random, size: f64) -> Shape {
    let centre = random.point();
    let sign = if random.next().is_multiple_of(4) { -1.0 } else { 1.0 };
    let length = |random: &mut Random| size * (0.05 + 0.5 * random.real().abs());
    match random.next() % 4 {
        0 => Shape::Sphere { centre, radius: sign * length(random) },
        1 => {
            let radii = [length(random), length(random)];
            let pointed = random.next().is_multiple_of(2);
            Shape::Cone {
                base: centre,
                base_radius: sign * radii[0],
                apex: centre + size * random.direction(),
                apex_radius: if pointed { 0.0 } else { sign * radii[1] },
            }
        }
        kind => {
            let normal = random.direction();
            let (right, up) = normal.any_orthonormal_pair();
            // A star around the centre: convex or not, never crossing itself.
            let corners = 3 + random.next() % 7;
            let vertices: Vec<DVec3> = (0..corners)
                .map(|corner| {
                    let angle = std::f64::consts::TAU * corner as f64 / corners as f64;
                    let radius = size * (0.15 + random.real().abs());
                    centre + radius * (libm::cos(angle) * right + libm::sin(angle) * up)
                })
                .collect();
            if kind == 2 {
                Shape::Polygon { vertices }
            } else {
                let normals = vertices.iter().map(|_| normal + 0.5 * random.point());
                Shape::Patch { normals: normals.collect(), vertices }
            }
        }
    }
}

fn surface(shape: &Shape, transmits: bool) -> Surface {
    Surface::new(shape, transmits).expect("a surface")
}

/// Distance and normal of the hit of a ray that need not be normalised.
fn hit(surface: &Surface, from: [f64; 3], direction: [f64; 3]) -> Option<(f64, DVec3)> {
    let ray = Ray::new(from.into(), DVec3::from(direction).normalize());
    let distance = surface.hit(&ray, f64::INFINITY)?;
    Some((distance, surface.place(&ray, distance).normal))
}

fn cone(base_radius: f64, apex_radius: f64, transmits: bool) -> Surface {
    let shape = Shape::Cone { base: DVec3::ZERO, base_radius, apex: DVec3::Z * 2.0, apex_radius };
    surface(&shape, transmits)
}

fn close(found: Option<(f64, DVec3)>, distance: f64, normal: [f64; 3]) {
    let (found, at) = found.expect("a hit");
    assert!((found - distance).abs() < 1e-14 * distance, "{found}");
    assert!(at.distance(DVec3::from(normal).normalize()) < 1e-14, "{at}");
}

#[test]
fn sphere_is_visible_from_one_side() {
    let sphere = |radius: f64, transmits| {
        let centre = DVec3::ZERO;
        surface(&Shape::Sphere { centre, radius }, transmits)
    };
    let along = [0.0, 1.0, 0.0];
    let (outside, inside) = ([0.0, -5.0, 0.0], [0.0; 3]);
    close(hit(&sphere(2.0, false), outside, along), 3.0, [0.0, -1.0, 0.0]);
    assert_eq!(hit(&sphere(2.0, false), inside, along), None);
    close(hit(&sphere(-2.0, false), outside, along), 7.0, [0.0, -1.0, 0.0]);
    close(hit(&sphere(-2.0, false), inside, along), 2.0, [0.0, -1.0, 0.0]);
    close(hit(&sphere(2.0, true), inside, along), 2.0, [0.0, 1.0, 0.0]);
    close(hit(&sphere(-2.0, true), outside, along), 3.0, [0.0, 1.0, 0.0]);
    assert_eq!(hit(&sphere(2.0, true), [0.0, 5.0, 0.0], along), None);
}

#[test]
fn a_small_far_sphere_keeps_its_edge() {
    let shape = Shape::Sphere { centre: DVec3::new(0.0, 1e8, 0.0), radius: 1e-3 };
    let passes = |x: f64| hit(&surface(&shape, false), [x, 0.0, 0.0], [0.0, 1.0, 0.0]).is_some();
    assert!(passes(0.000_999_999) && !passes(0.001_000_001));
}

#[test]
fn cylinders_and_cones_are_open_sheets() {
    let cylinder = cone(1.0, 1.0, false);
    close(hit(&cylinder, [-4.0, 0.0, 1.0], [1.0, 0.0, 0.0]), 3.0, [-1.0, 0.0, 0.0]);
    close(hit(&cylinder, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]), 1.0, [1.0, 0.0, 0.0]);
    // Through the open end onto the inside, and along the axis onto nothing.
    close(hit(&cylinder, [-1.0, 0.0, 3.0], [1.0, 0.0, -1.0]), 8f64.sqrt(), [1.0, 0.0, 0.0]);
    assert_eq!(hit(&cylinder, [0.5, 0.0, 9.0], [0.0, 0.0, -1.0]), None);
    assert_eq!(hit(&cylinder, [-4.0, 0.0, 2.1], [1.0, 0.0, 0.0]), None);
    let hollow = cone(-1.0, -1.0, false);
    close(hit(&hollow, [-4.0, 0.0, 1.0], [1.0, 0.0, 0.0]), 5.0, [-1.0, 0.0, 0.0]);

    let pointed = cone(1.0, 0.0, false);
    // Half way up the radius is 1/2; the normal leans up by the slope.
    close(hit(&pointed, [-4.0, 0.0, 1.0], [1.0, 0.0, 0.0]), 3.5, [-2.0, 0.0, 1.0]);
    // From within, parallel to the generator on the left: the equation is linear, and the other
    // nappe is not met.
    close(hit(&pointed, [0.0, 0.0, 0.5], [1.0, 0.0, 2.0]), 0.375 * 5f64.sqrt(), [2.0, 0.0, 1.0]);
    assert_eq!(hit(&pointed, [-4.0, 0.0, 2.5], [1.0, 0.0, 0.0]), None);
    // From above onto the apex, just beside it.
    let (distance, normal) = hit(&pointed, [1e-9, 0.0, 5.0], [0.0, 0.0, -1.0]).expect("a hit");
    assert!((distance - 3.0 - 2e-9).abs() < 1e-14);
    assert!(normal.distance(DVec3::new(2.0, 0.0, 1.0).normalize()) < 1e-6);
    let at_apex = hit(&pointed, [0.0, -3.0, 5.0], [0.0, 1.0, -1.0]).expect("a hit");
    assert!(at_apex.1.dot(DVec3::new(0.0, 1.0, -1.0)) < 0.0);
}

#[test]
fn concave_polygon_is_missed_in_its_notch() {
    let shape = Shape::Polygon {
        vertices: [
            (0.0, 0.0),
            (3.0, 0.0),
            (3.0, 1.0),
            (1.0, 1.0),
            (1.0, 2.0),
            (3.0, 2.0),
            (3.0, 3.0),
            (0.0, 3.0),
        ]
        .map(|(x, y)| DVec3::new(x, y, 1.0))
        .to_vec(),
    };
    let letter = surface(&shape, false);
    let falls = |x: f64, y: f64| hit(&letter, [x, y, 4.0], [0.0, 0.0, -1.0]).is_some();
    for (x, y) in [(0.5, 1.5), (2.5, 0.5), (2.5, 2.5), (0.999, 1.5)] {
        assert!(falls(x, y), "{x} {y}");
    }
    for (x, y) in [(1.001, 1.5), (2.5, 1.5), (3.5, 0.5), (-0.1, 1.5), (2.0, 3.1)] {
        assert!(!falls(x, y), "{x} {y}");
    }
    close(hit(&letter, [0.5, 0.5, 4.0], [0.0, 0.0, -1.0]), 3.0, [0.0, 0.0, 1.0]);
    assert_eq!(hit(&letter, [0.5, 0.5, -4.0], [0.0, 0.0, 1.0]), None);
    assert!(hit(&surface(&shape, true), [0.5, 0.5, -4.0], [0.0, 0.0, 1.0]).is_some());
}

#[test]
fn polygons_are_filled_by_the_even_odd_rule() {
    let corners = [(0.0, 9.0), (-5.0, -7.0), (9.0, 2.0), (-9.0, 2.0), (5.0, -7.0)];
    let vertices: Vec<DVec3> = corners.map(|(x, y)| DVec3::new(x, y, 1.0)).to_vec();
    let normals = vec![DVec3::new(1.0, 1.0, 1.0); 5];
    let polygon = Shape::Polygon { vertices: vertices.clone() };
    let patch = Shape::Patch { vertices, normals };
    for shape in [polygon, patch] {
        let star = surface(&shape, false);
        let falls = |x: f64, y: f64| hit(&star, [x, y, 4.0], [0.0, 0.0, -1.0]).is_some();
        for (x, y) in [(0.0, 6.0), (-6.0, 1.5), (6.0, 1.5), (-4.0, -5.5), (4.0, -5.5)] {
            assert!(falls(x, y), "{x} {y}");
        }
        for (x, y) in [(0.0, 0.0), (0.0, -6.0), (5.0, 5.0), (-5.0, 5.0), (7.0, -3.0)] {
            assert!(!falls(x, y), "{x} {y}");
        }
        let ray = Ray::new(DVec3::new(0.0, 6.0, 4.0), DVec3::NEG_Z);
        let place = star.place(&ray, 3.0);
        assert_eq!(place.smooth, DVec3::Z, "also that of a patch");
    }
}

#[test]
fn bent_polygon_is_projected_to_plane() {
    let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
    let bent = |off: f64| {
        let lift = |(x, y): (f64, f64)| DVec3::new(x, y, if x == y { off } else { -off });
        let vertices = corners.map(lift).to_vec();
        surface(&Shape::Polygon { vertices }, false)
    };
    // From a flat angle: the edges are seen where they lie in the plane.
    let slanting = |surface: &Surface, x: f64| hit(surface, [x - 9.0, 0.5, 1.0], [9.0, 0.0, -1.0]);
    for (x, falls) in [(-0.01, false), (0.01, true), (1.99, true), (2.01, false)] {
        assert_eq!(slanting(&bent(0.5), x).is_some(), falls, "{x}");
    }
    // Rounded numbers are left as they are.
    assert!(bent(1e-6).bounds().high.z > 0.0);
    assert_eq!(bent(0.5).bounds().high.z, 0.0);
}

/// The faces of a cube around 0, each of two triangles, turned and scaled.
fn cube(turn: glam::DQuat, size: f64) -> Vec<Surface> {
    let mut faces = Vec::new();
    for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
        for normal in [axis, -axis] {
            let (right, up) = normal.any_orthonormal_pair();
            // Counter-clockwise from outside.
            let up = if right.cross(up).dot(normal) > 0.0 { up } else { -up };
            let corner = |x: f64, y: f64| turn * (normal + x * right + y * up) * size;
            let [a, b, c, d] =
                [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
            for vertices in [vec![a, b, c], vec![a, c, d]] {
                faces.push(surface(&Shape::Polygon { vertices }, true));
            }
        }
    }
    faces
}

#[test]
fn closed_mesh_is_tight_at_edges_and_corners() {
    let mut random = Random(3);
    let mut misses = 0;
    for round in 0..40_000 {
        let axis = random.direction();
        let turn = glam::DQuat::from_axis_angle(axis, random.real() * 3.0);
        let faces = cube(turn, 1.0);
        // From within, exactly at a point of an edge or a corner as it comes out in f64.
        let along = if round % 4 == 0 { 1.0 } else { random.real() };
        let target = turn * DVec3::new(1.0, along, 1.0);
        let origin = 0.5 * random.point();
        let ray = Ray::new(origin, (target - origin).normalize());
        let met = faces.iter().any(|face| face.hit(&ray, f64::INFINITY).is_some());
        misses += usize::from(!met);
    }
    // Corners computed face by face differ in their last digits: only that may leak.
    assert!(misses <= 4, "{misses} of 40000");
}

#[test]
fn rays_leave_surfaces_at_any_scale() {
    let mut random = Random(11);
    let mut left = [0; 2];
    for round in 0..200_000 {
        let scale = 10f64.powi(round % 25 - 12);
        let away = if round % 2 == 0 { 0.0 } else { 1e5 * scale };
        let shape = moved(&random_shape(&mut random, 1.0), scale, DVec3::splat(away));
        let transmits = random.next().is_multiple_of(2);
        let surface = surface(&shape, transmits);
        let bounds = surface.bounds();
        let middle = bounds.low.midpoint(bounds.high);
        let origin = middle + 3.0 * scale * random.direction();
        let aim = middle + 0.4 * scale * random.point();
        let ray = Ray::new(origin, (aim - origin).normalize());
        let Some(distance) = surface.hit(&ray, f64::INFINITY) else {
            continue;
        };
        let place = surface.place(&ray, distance);
        assert!((place.normal.length() - 1.0).abs() < 1e-12);
        let moved = place.point.distance(ray.at(distance));
        // The first hit is off by roundings of its distance and of how far away the shape is.
        assert!(moved <= 1e-9 * (scale + away), "{shape:?}: {moved}");
        // A plane is never met again; a quadric only as far away as its curvature has it, not
        // nearby.
        let way = random.direction();
        let again = surface.hit(&Ray::new(place.point, way), f64::INFINITY);
        left[usize::from(again.is_some())] += 1;
        if let Some(again) = again {
            let slope = way.dot(place.normal).abs();
            assert!(!matches!(surface, Surface::Polygon(_)), "{shape:?}");
            assert!(
                again > 1e-4 * scale * slope,
                "{shape:?} is met again after {again}, slope {slope}"
            );
        }
    }
    assert!(left.iter().all(|&count| count > 10_000), "{left:?}");
}

fn moved(shape: &Shape, scale: f64, by: DVec3) -> Shape {
    let place = |point: DVec3| scale * point + by;
    match shape {
        &Shape::Sphere { centre, radius } => {
            Shape::Sphere { centre: place(centre), radius: scale * radius }
        }
        &Shape::Cone { base, base_radius, apex, apex_radius } => Shape::Cone {
            base: place(base),
            base_radius: scale * base_radius,
            apex: place(apex),
            apex_radius: scale * apex_radius,
        },
        Shape::Polygon { vertices } => {
            Shape::Polygon { vertices: vertices.iter().copied().map(place).collect() }
        }
        Shape::Patch { vertices, normals } => Shape::Patch {
            vertices: vertices.iter().copied().map(place).collect(),
            normals: normals.clone(),
        },
    }
}
