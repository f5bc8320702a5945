//! The surfaces that `surfaces_r16` gathers.

use kernels::cases::whitted::shade::error::{any_hits, any_material};
use kernels::cases::whitted::shade::gather::{Hit, Hits};
use kernels::cases::whitted::shade::shapes::Shape;
use twins::refine_hits::refine;
use twins::surfaces::{Ray, surface};

use super::vector;
use kernels::prelude::*;

#[test]
fn normals_are_the_shapes_on_the_rays_side() {
    let mut random = random();
    let material = any_material(&mut random);
    let mut worst = 0.0_f64;
    for _ in 0..2000 {
        let (shapes, objects, hits) = any_hits(&mut random);
        for (lane, (shape, hit)) in shapes.iter().zip(&hits).enumerate() {
            let found = surface(&hit.ray, &objects[lane + 1].0, &material);
            let (_, normal) = shape.at(vector(found.point));
            let towards = dot(normal, vector(hit.ray.direction));
            let plane = vector(found.plane);
            if towards.abs() > 1e-3 {
                let side = -towards.signum();
                let ratio = if side > 0.0 { material.inverse_index } else { material.index };
                assert_eq!(found.ratio, ratio, "{hit:x?}");
                // The error that the singles of the coordinates leave, as seen from the centre.
                let leave = to_f64(found.leave);
                let radius = if shape.gain == 0.0 {
                    f64::INFINITY
                } else {
                    ((shape.offset
                        - shape.slope * dot(sub(vector(found.point), shape.centre), shape.axis))
                        / shape.gain)
                        .abs()
                };
                for k in 0..3 {
                    let error = (plane[k] - side * normal[k]).abs();
                    worst = worst.max(error / (2_f64.powi(-21) + leave / radius));
                }
            }
            assert!(dot(plane, vector(hit.ray.direction)) <= 1e-6, "{hit:x?}");
        }
    }
    println!("normals: {worst:.3}");
    // 2^-23 + leave / (4 r)
    assert!(worst <= 0.25, "{worst}");
}

#[test]
fn refined_hits_have_the_normals_of_the_exact_hits() {
    let mut random = random();
    let material = any_material(&mut random);
    let [mut refined, mut before, mut aside] = [0.0_f64; 3];
    for _ in 0..2000 {
        let (shapes, objects, hits) = any_hits(&mut random);
        for (lane, (shape, hit)) in shapes.iter().zip(&hits).enumerate() {
            let object = &objects[lane + 1].0;
            let Some([point, normal]) = refine(&hit.ray, object) else {
                continue;
            };
            let [origin, direction] = [hit.ray.origin, hit.ray.direction].map(vector);
            let mut t = to_f64(hit.ray.t);
            let at = |t: f64| std::array::from_fn(|k| origin[k] + t * direction[k]);
            for _ in 0..6 {
                let (height, normal) = shape.at(at(t));
                t -= height / dot(normal, direction);
            }
            let (_, exact) = shape.at(at(t));
            let cosine = dot(exact, direction);
            if cosine.abs() < 0.1 {
                continue;
            }
            let from = sub(at(t), shape.centre);
            let radius = (shape.offset - shape.slope * dot(from, shape.axis)) / shape.gain;
            let start = sub(origin, shape.centre);
            let size = dot(start, start).sqrt() + dot(from, from).sqrt();
            let unit = 2_f64.powi(-23) * (1.0 + size / radius.abs()) / cosine.abs();
            let error = |found: [u32; 3]| {
                let found = vector(found);
                let off = sub(found, exact.map(|x| -cosine.signum() * x));
                dot(off, off).sqrt() / unit
            };
            refined = refined.max(error(normal));
            before = before.max(error(surface(&hit.ray, object, &material).plane));
            let point = sub(vector(point), at(t));
            let along = dot(point, direction);
            let off: [f64; 3] = std::array::from_fn(|k| point[k] - along * direction[k]);
            let far = at(t).iter().fold(0.0, |far: f64, x| far.max(x.abs()));
            // Three roundings of three coordinates.
            aside = aside.max(dot(off, off).sqrt() / (2_f64.powi(-23) * far));
        }
    }
    println!("normals: {refined:.2}, before {before:.2}; points beside their rays: {aside:.2} ulp");
    assert!(
        refined <= 1.5 && before >= 3.0 * refined && aside <= 5.2,
        "{refined} {before} {aside}"
    );
}

#[test]
fn a_point_in_the_centre_has_a_finite_normal() {
    let sphere = Shape::sphere([1.0, 2.0, 3.0], 1.0).object();
    let cone = Shape::cone([1.0, 2.0, 3.0], [0.0, 0.0, 1.0], 1.0, -1.0).object();
    let mut bench = Bench::new();
    let material = any_material(&mut random());
    let ray = Ray {
        origin: [1.0, 2.0, 2.0].map(from_f64),
        direction: [0.0, 0.0, 1.0].map(from_f64),
        t: from_f64(1.0),
    };
    let packets = vec![std::array::from_fn(|lane| Hit { ray, object: lane % 2 })];
    let objects = vec![(sphere, 0), (cone, 0)];
    let (found, _) =
        Hits::<false> { packets, objects, materials: vec![material] }.check(&mut bench);
    let Bits(Surfaces { plane_x, plane_y, plane_z, .. }) = found[0];
    let plane = |lane: usize| vector([plane_x, plane_y, plane_z].map(|row| bits(row[lane])));
    assert_eq!(plane(0), [0.0; 3]);
    let cosine = to_f64(from_f64(0.5_f64.sqrt()));
    assert_eq!(plane(1), [0.0, 0.0, -cosine]);
}
