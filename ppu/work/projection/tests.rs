use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;

use super::super::arithmetic::{camera, direction, entry, sphere, wide};
use super::super::policy::Skip;
use super::super::spheres::EyeSpheres;
use super::*;
use crate::scene;
use crate::scene::random::{magnitude, unit};
use protocol::formulation::EyeRecord;

const SIZE: Geometry = Geometry { width: 80, height: 50 };

/// The columns and rows of the pixels whose rays enter a sphere in the SPU's arithmetic, among all
/// pixels of the picture.
fn seen(camera: &Camera, projection: &Projection, sphere: &scene::Sphere) -> Vec<(u32, u32)> {
    let mut records = EyeSpheres::default();
    records.cull(std::slice::from_ref(sphere), projection, Skip::Nothing, EyeRecord::Centre);
    let record = records.records()[0];
    let pixels = (0..SIZE.height).flat_map(|y| (0..SIZE.width).map(move |x| (x, y)));
    pixels
        .filter(|&(x, y)| {
            entry(&record, EyeRecord::Centre, direction(camera, x.into(), y.into())).is_some()
        })
        .collect()
}

#[test]
fn pixels_outside_bounds_miss_sphere() {
    let mut random = ChaCha8Rng::seed_from_u64(11);
    let (mut shown, mut bounded) = (0, 0);
    for _ in 0..60 {
        let camera = camera(&mut random, SIZE.width, SIZE.height);
        let projection = Projection::new(&camera, SIZE);
        for _ in 0..5 {
            let pixel = [SIZE.width, SIZE.height].map(|side| random.random_range(0..side));
            let towards = wide(direction(&camera, pixel[0].into(), pixel[1].into())).normalize();
            let sphere = sphere(&mut random, camera.eye, towards);
            let bounds = projection.bounds(sphere.centre, sphere.radius);
            assert!(bounds.x.end <= SIZE.width && bounds.y.end <= SIZE.height);
            let seen = seen(&camera, &projection, &sphere);
            for (x, y) in &seen {
                assert!(bounds.x.contains(x) && bounds.y.contains(y), "{bounds:?} {x} {y}");
            }
            shown += u32::from(!seen.is_empty());
            bounded += u32::from(bounds.x.len() < SIZE.width as usize);
        }
    }
    assert!(shown > 100 && bounded > 50, "{shown} {bounded}");
}

#[test]
fn bounds_are_close() {
    let mut random = ChaCha8Rng::seed_from_u64(12);
    let mut checked = 0;
    while checked < 50 {
        let camera = camera(&mut random, SIZE.width, SIZE.height);
        let projection = Projection::new(&camera, SIZE);
        let towards = wide(direction(&camera, 40.0, 25.0)).normalize();
        let distance = magnitude(&mut random, -5.0, 10.0);
        let sphere = scene::Sphere {
            centre: camera.eye + towards * distance,
            radius: distance * camera.right.length() * random.random_range(3.0..15.0),
            colour: DVec3::ONE,
        };
        if sphere.radius > 0.5 * distance {
            continue;
        }
        checked += 1;
        let seen = seen(&camera, &projection, &sphere);
        let bounds = projection.bounds(sphere.centre, sphere.radius);
        let columns = seen.iter().map(|(x, _)| *x);
        let rows = seen.iter().map(|(_, y)| *y);
        let close = |bound: &Range<u32>, first: u32, last: u32| {
            bound.start + 2 >= first && bound.end <= last + 1 + 2
        };
        assert!(close(&bounds.x, columns.clone().min().unwrap(), columns.max().unwrap()));
        assert!(close(&bounds.y, rows.clone().min().unwrap(), rows.max().unwrap()));
    }
}

#[test]
fn bounds_are_empty_beside_the_view_and_full_around_the_eye() {
    let mut random = ChaCha8Rng::seed_from_u64(13);
    for _ in 0..200 {
        let camera = camera(&mut random, SIZE.width, SIZE.height);
        let projection = Projection::new(&camera, SIZE);
        let ahead = camera.right.cross(camera.down).normalize();
        let centre = camera.eye - ahead * 5.0 + unit(&mut random);
        assert!(projection.bounds(centre, 3.9).is_empty());
        let around = camera.eye + unit(&mut random);
        assert_eq!(projection.bounds(around, 1.5), Rectangle { x: 0..80, y: 0..50 });
        let left = camera.corner - camera.right * 20.0;
        assert!(
            projection.bounds(camera.eye + left * 9.0, 0.01 * camera.right.length()).is_empty()
        );
    }
}

#[test]
fn rays_stay_within_stated_distance_of_packet_centre() {
    let mut random = ChaCha8Rng::seed_from_u64(14);
    let mut limited = 0;
    for _ in 0..300 {
        let camera = camera(&mut random, SIZE.width, SIZE.height);
        let spread = Projection::new(&camera, SIZE).packet_spread();
        limited += u32::from(spread.is_finite());
        for _ in 0..30 {
            let (x, y) = (random.random_range(0..20) * 4, random.random_range(0..13) * 4);
            let (x, y) = (f64::from(x), f64::from(y));
            let middle = wide(direction(&camera, x + 1.5, y + 1.5));
            for (dx, dy) in [(0.0, 0.0), (3.0, 0.0), (0.0, 3.0), (3.0, 3.0), (1.0, 2.0)] {
                let angle = middle.angle_between(wide(direction(&camera, x + dx, y + dy)));
                assert!(angle <= spread + 1e-7, "{angle} {spread}");
            }
        }
    }
    assert!(limited > 200, "{limited}");
}

#[test]
fn too_small_steps_give_no_bound() {
    let camera = Camera {
        eye: DVec3::ZERO,
        corner: DVec3::Z,
        right: DVec3::X * 1e-200,
        down: DVec3::Y * 1e-200,
    };
    let projection = Projection::new(&camera, SIZE);
    assert_eq!(projection.packet_spread(), f64::INFINITY);
    assert_eq!(projection.bounds(DVec3::Z * -9.0, 1.0), Rectangle { x: 0..80, y: 0..50 });
}

#[test]
fn hull_contains_all_spheres_between() {
    let mut random = ChaCha8Rng::seed_from_u64(17);
    let mut bounded = 0;
    for _ in 0..2000 {
        let camera = camera(&mut random, SIZE.width, SIZE.height);
        let projection = Projection::new(&camera, SIZE);
        let mut sphere = || {
            let distance = magnitude(&mut random, -2.0, 6.0);
            let centre = camera.eye + (camera.corner.normalize() + unit(&mut random)) * distance;
            (centre, distance * random.random_range(0.0..0.5))
        };
        let (from, to) = (sphere(), sphere());
        let hull = projection.hull([from, to]);
        bounded += u32::from(hull.x.len() < SIZE.width as usize);
        for part in 0..=20 {
            let part = f64::from(part) / 20.0;
            let bounds =
                projection.bounds(from.0.lerp(to.0, part), from.1 + part * (to.1 - from.1));
            let is_within = |a: &Range<u32>, b: &Range<u32>| a.start >= b.start && a.end <= b.end;
            let within = is_within(&bounds.x, &hull.x) && is_within(&bounds.y, &hull.y);
            assert!(bounds.is_empty() || within, "{bounds:?} of {hull:?}");
        }
    }
    assert!(bounded > 200, "{bounded}");
}
