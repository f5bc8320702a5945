//! `surfaces_r16`, `surfaces_same_r16` and `same_objects_r16`.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::shade::call::{self, Hit};
use kernels::cases::whitted::shade::error::{any_hits, any_material};
use kernels::cases::whitted::shade::records;
use kernels::cases::whitted::shade::shapes::Shape;
use kernels::description::any_bits;
use kernels::vector::{dot, sub};
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::FARTHEST;
use twins::surfaces::{Material, Object, Ray, Surface, same_objects, surface};

use super::{COUNTS, assert_same, vector};

/// Compares with the twin, and returns the twin's surfaces.
fn check(
    bench: &mut Bench,
    kernel: &str,
    hits: &[[Hit; 16]],
    objects: &[(Object, usize)],
    materials: &[Material],
) -> Vec<[Surface; 16]> {
    let (found, addresses, counts) = call::surfaces(bench, kernel, hits, objects, materials);
    let mut expected_counts = [0; 4];
    let mut all = Vec::new();
    for (hits, found) in hits.iter().zip(&found) {
        let expected = hits.map(|hit| {
            let (object, material) = &objects[hit.object];
            surface(&hit.ray, object, &materials[*material])
        });
        let at = hits.map(|hit| addresses[objects[hit.object].1]);
        let record = records::surfaces(&expected, &expected.map(|lane| lane.plane), at);
        assert_same(found, &record, &format!("{kernel}: {hits:x?}"));
        for (lane, hit) in hits.iter().enumerate() {
            expected_counts[lane % 4] += u32::from(hit.object != 0 && hit.ray.t >> 31 == 0);
        }
        all.push(expected);
    }
    assert_eq!(counts, expected_counts, "rays that hit something");
    all
}

/// The ray of a hit, or an absent ray.
fn perhaps(hit: Hit, random: &mut ChaCha8Rng) -> Hit {
    let mut hit = hit;
    match random.random_range(0..8) {
        0 => hit.ray.t = from_f64(-1.0),
        1 => (hit.ray.t, hit.object) = (FARTHEST, 0),
        _ => {}
    }
    hit
}

#[test]
fn scenes_equal_the_twin_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..20 {
        for count in COUNTS {
            let (_, mut objects, first) = any_hits(&mut random);
            let materials: Vec<Material> = (0..5).map(|_| any_material(&mut random)).collect();
            for (object, material) in &mut objects {
                object.sides = random.random::<u32>() << 29;
                *material = random.random_range(0..materials.len());
            }
            let hits: Vec<[Hit; 16]> =
                (0..count).map(|_| first.map(|hit| perhaps(hit, &mut random))).collect();
            check(&mut bench, "surfaces_r16", &hits, &objects, &materials);
            // Both kernels give the same results for packets that are valid for both.
            let object = random.random_range(0..objects.len());
            let mut hits = hits;
            for hit in hits.iter_mut().flatten() {
                hit.object = object;
            }
            for kernel in ["surfaces_r16", "surfaces_same_r16"] {
                check(&mut bench, kernel, &hits, &objects, &materials);
            }
        }
    }
}

#[test]
fn packets_of_one_object_are_detected() {
    let mut random = random();
    let mut bench = Bench::new();
    for count in [1, 2, 3, 8, 32] {
        for _ in 0..100 {
            let packets: Vec<[u32; 16]> = (0..count)
                .map(|_| {
                    let mut objects = [random.random(); 16];
                    // Another object in one lane is enough.
                    if random.random() {
                        let lane: usize = random.random_range(0..16);
                        objects[lane] ^= 1 << random.random_range(0..32);
                    }
                    objects
                })
                .collect();
            let found = call::same_objects(&mut bench, &packets);
            assert_eq!(found, same_objects(&packets), "{packets:x?}");
        }
    }
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let materials: [Material; 3] = [(); 3].map(|()| any_bits(&mut random));
        let objects: Vec<(Object, usize)> =
            (0..6).map(|number| (any_bits(&mut random), number % 3)).collect();
        let hits = [[(); 16]; 2].map(|packet| {
            packet.map(|()| Hit { ray: any_bits(&mut random), object: random.random_range(0..6) })
        });
        check(&mut bench, "surfaces_r16", &hits, &objects, &materials);
        let same = hits.map(|packet| {
            let object = packet[0].object;
            packet.map(|hit| Hit { object, ..hit })
        });
        check(&mut bench, "surfaces_same_r16", &same, &objects, &materials);
    }
}

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
    let hits: [Hit; 16] = std::array::from_fn(|lane| Hit { ray, object: lane % 2 });
    let objects = [(sphere, 0), (cone, 0)];
    let found = check(&mut bench, "surfaces_r16", &[hits], &objects, &[material]);
    assert_eq!(vector(found[0][0].plane), [0.0; 3]);
    let cosine = to_f64(from_f64(0.5_f64.sqrt()));
    assert_eq!(vector(found[0][1].plane), [0.0, 0.0, -cosine]);
}
