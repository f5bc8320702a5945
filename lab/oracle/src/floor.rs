//! The scene that a tracer in single precision gets: its numbers rounded relative to the eye.
//!
//! A picture of the rounded scene, traced in double precision, differs from the scene's own where
//! no tracer in single precision can be expected to be right.

use std::sync::Arc;

use glam::DVec3;
use scenes::{LightKind, Mesh, Scene, Shape};

/// The scene with the numbers of its objects and the positions of its lights rounded to the
/// nearest single. Positions are rounded relative to the eye, as `cellray` sends them to its SPUs.
#[must_use]
pub fn rounded_to_singles(scene: &Scene) -> Scene {
    let eye = scene.view.from;
    let position = |position: &mut DVec3| *position = eye + vector(*position - eye);
    let mut rounded = scene.clone();
    for object in &mut rounded.objects {
        match &mut object.shape {
            Shape::Sphere { centre, radius } => {
                position(centre);
                *radius = single(*radius);
            }
            Shape::Cone { base, base_radius, apex, apex_radius } => {
                position(base);
                position(apex);
                *base_radius = single(*base_radius);
                *apex_radius = single(*apex_radius);
            }
            Shape::Polygon { vertices } => vertices.iter_mut().for_each(position),
            Shape::Patch { vertices, normals } => {
                vertices.iter_mut().for_each(position);
                normals.iter_mut().for_each(|normal| *normal = vector(*normal));
            }
        }
    }
    for light in &mut rounded.lights {
        match &mut light.kind {
            LightKind::Point { position: place, range } => {
                position(place);
                *range = single(*range);
            }
            LightKind::Directional { to_light } => *to_light = vector(*to_light),
        }
    }
    rounded.mesh = scene.mesh.as_deref().map(|mesh| Arc::new(seen_from(mesh, eye)));
    rounded
}

/// The mesh with its vertices relative to the eye.
fn seen_from(mesh: &Mesh, eye: DVec3) -> Mesh {
    let from_eye = mesh.origin - eye;
    let positions = mesh.positions.iter().map(|position| {
        let [x, y, z] = position.map(f64::from);
        (from_eye + DVec3::new(x, y, z)).as_vec3().to_array()
    });
    Mesh { origin: eye, positions: positions.collect(), ..mesh.clone() }
}

fn vector(exact: DVec3) -> DVec3 {
    exact.as_vec3().as_dvec3()
}

fn single(exact: f64) -> f64 {
    f64::from(exact as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(eye: &str, objects: &str) -> Scene {
        let text = format!(
            "v\nfrom {eye}\nat 0 0 0\nup 0 0 1\nangle 40\nhither 0\nresolution 64 48\nb 0 0 1\n\
             l 0.1 0 0\nf 1 1 1 1 0 0 0 1\n{objects}"
        );
        scenes::parse(text.as_bytes(), "t.nff", &scenes::Limits::default()).expect("a scene")
    }

    #[test]
    fn singles_relative_to_eye_are_unchanged() {
        // An eye whose coordinates are no singles, and spheres a whole number of units from it.
        let exact = scene("0 -16777217.0 0", "s 2 -16777214.0 1 0.5\np 3\n1 0 0\n0 1 0\n0 0 1\n");
        let rounded = rounded_to_singles(&exact);
        assert_eq!(rounded.objects[0].shape, exact.objects[0].shape);
        // The triangle is too far from the eye for its heights of 1 in y to be kept.
        assert_ne!(rounded.objects[1].shape, exact.objects[1].shape);
    }

    #[test]
    fn other_numbers_become_the_nearest_singles() {
        let objects = "s 0.1 0 0 0.3\nc\n0 0 0.2 0.7\n0 0 9 0\n";
        let rounded = rounded_to_singles(&scene("0 -8 0", objects));
        let nearest = |number: f32| f64::from(number);
        let Shape::Sphere { centre, radius } = rounded.objects[0].shape else {
            panic!("the sphere became another shape")
        };
        assert_eq!((centre, radius), (DVec3::new(nearest(0.1), 0.0, 0.0), nearest(0.3)));
        let Shape::Cone { base, base_radius, .. } = rounded.objects[1].shape else {
            panic!("the cone became another shape")
        };
        assert_eq!((base.z, base_radius), (nearest(0.2), nearest(0.7)));
        let light =
            LightKind::Point { position: DVec3::new(nearest(0.1), 0.0, 0.0), range: f64::INFINITY };
        assert_eq!(rounded.lights[0].kind, light);
    }
}
