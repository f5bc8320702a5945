//! `smooth_r16`.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::isect::error::SCALES;
use kernels::cases::whitted::smooth::{Hit, any_hit, normals, smooth, surfaces};
use kernels::flat_records::point;
use kernels::single::single;
use rand::Rng as _;
use spu_emulator::float::single::to_f64;
use twins::smooth::{Patch, smooth as twin};
use zerocopy::IntoBytes as _;

/// Runs the kernel and compares every lane with the twin. No other memory may change. Returns the
/// normals.
fn check(bench: &mut Bench, hits: &[Hit; 16], anything: u32) -> [[u32; 3]; 16] {
    let after = smooth(bench, hits, anything);
    let mut expected = surfaces(hits, anything);
    for (lane, hit) in hits.iter().enumerate().filter(|(_, hit)| hit.smooth) {
        let normal = twin(&hit.patch, hit.point, hit.plane, hit.direction);
        assert_eq!(normals(&after)[lane], normal, "{hit:x?}");
        [expected.normal_x[lane], expected.normal_y[lane], expected.normal_z[lane]] =
            normal.map(single);
    }
    assert_eq!(after.as_bytes(), expected.as_bytes());
    normals(&after)
}

#[test]
fn sensible_hits_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut planes, mut smooths) = (0, 0);
    for _ in 0..200 {
        for scale in SCALES {
            let hits: [Hit; 16] = std::array::from_fn(|_| any_hit(&mut random, scale));
            let found = check(&mut bench, &hits, random.random());
            for (hit, found) in hits.iter().zip(found).filter(|(hit, _)| hit.smooth) {
                let is_plane = found == hit.plane;
                planes += u32::from(is_plane);
                smooths += u32::from(!is_plane);
            }
        }
    }
    println!("{smooths} smooth normals, {planes} planes");
    assert!(planes > 500 && smooths > 5000, "{smooths}, {planes}");
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let hits = std::array::from_fn(|_| Hit {
            patch: Patch { vertices: random.random(), normals: random.random() },
            smooth: random.random(),
            point: random.random(),
            plane: random.random(),
            direction: random.random(),
        });
        check(&mut bench, &hits, random.random());
    }
}

#[test]
fn a_vertex_has_its_own_normal_from_both_sides() {
    let mut bench = Bench::new();
    let vertices = [[-1.0, -1.0, -5.0], [1.0, -1.0, -5.0], [0.0, 1.0, -5.0]];
    let normals = [[-0.6, 0.0, 0.8], [0.6, 0.0, 0.8], [0.0, 0.6, 0.8]];
    for vertex in 0..3 {
        for way in [1.0, -1.0] {
            let hit = Hit {
                patch: Patch { vertices: vertices.map(point), normals: normals.map(point) },
                smooth: true,
                point: point(vertices[vertex]),
                plane: point([0.0, 0.0, way]),
                direction: point([0.0, 0.0, -way]),
            };
            let found = check(&mut bench, &[hit; 16], 0)[0].map(to_f64);
            for (found, expected) in found.iter().zip(normals[vertex]) {
                assert!((found - way * expected).abs() < 1e-6, "{found}, {expected}");
            }
        }
    }
}

#[test]
fn where_it_points_away_or_the_normals_cancel_it_is_the_planes() {
    let mut bench = Bench::new();
    let vertices = [[-1.0, -1.0, -5.0], [1.0, -1.0, -5.0], [0.0, 1.0, -5.0]].map(point);
    let tilted = [0.8, 0.0, 0.6];
    let grazing = [0.96, 0.0, -0.28];
    for (normals, direction) in [
        ([tilted; 3], grazing),
        ([[0.0; 3]; 3], [0.0, 0.0, -1.0]),
        // Exactly edge-on.
        ([[1.0, 0.0, 0.0]; 3], [0.0, 0.0, -1.0]),
    ] {
        let hit = Hit {
            patch: Patch { vertices, normals: normals.map(point) },
            smooth: true,
            point: point([0.0, 0.0, -5.0]),
            plane: point([0.0, 0.0, 1.0]),
            direction: point(direction),
        };
        assert_eq!(check(&mut bench, &[hit; 16], 0)[0], hit.plane);
    }
}
