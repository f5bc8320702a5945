//! `smooth_r16`.

use kernels::cases::whitted::smooth::{Hit, Smooth, normals};
use kernels::flat_records::Point;
use kernels::prelude::*;
use twins::smooth::Patch;

/// The normals that the kernel finds for sixteen equal hits, as its twin does.
fn check(bench: &mut Bench, hit: Hit) -> Point {
    normals(&Smooth { hits: [hit; 16], anything: 0 }.check(bench).0)[0]
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
            let found = check(&mut bench, hit).map(to_f64);
            for (found, expected) in found.iter().zip(normals[vertex]) {
                assert!((found - way * expected).abs() < 1e-6, "{found}, {expected}");
            }
        }
    }
}

#[test]
fn averted_or_zero_normal_falls_back_to_plane() {
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
        assert_eq!(check(&mut bench, hit), hit.plane);
    }
}
