//! `ray_setup_r16`.

use cellray::work::layout::{Basis, Packet};
use oracle::twin::ray_setup::{self, ray_setup};
use oracle::twin::{FARTHEST, Single};
use rand::Rng as _;
use spu_emulator::float::single::to_f64;
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::F32;

use crate::harness::{self, Bench};

const SOURCE: &str = include_str!("../../spu/trace/ray_setup_r16.s");

fn splat(vector: [f32; 3]) -> [[F32; 4]; 3] {
    vector.map(|value| [F32::new(value); 4])
}

/// Runs the kernel over 4x4 pixels and compares it with its twin; gives the largest error of a
/// direction's component, in ulps of 1.
fn check(
    bench: &mut Bench,
    corner: [f32; 3],
    right: [f32; 3],
    down: [f32; 3],
    x: i32,
    y: i32,
) -> f64 {
    bench.reset();
    let basis = Basis {
        corner: splat(corner),
        right: splat(right),
        down: splat(down),
    };
    let basis_place = bench.place(basis.as_bytes());
    let packet = bench.junk::<Packet>();
    bench.call(
        "ray_setup_r16",
        &[basis_place.address, x as u32, y as u32, packet.address],
    );
    let packet: Packet = bench.read(packet);

    let bits = |vector: [f32; 3]| vector.map(f32::to_bits);
    let twin = ray_setup::Basis {
        corner: bits(corner),
        right: bits(right),
        down: bits(down),
    };
    let mut worst = 0.0_f64;
    for lane in 0..16 {
        let (px, py) = (x + lane as i32 % 4, y + lane as i32 / 4);
        let found: [Single; 3] = [packet.direction_x, packet.direction_y, packet.direction_z]
            .map(|component| component[lane].get().to_bits());
        let expected = ray_setup(&twin, px, py);
        assert_eq!(
            found, expected,
            "{corner:x?} {right:x?} {down:x?}, pixel {px}, {py}"
        );
        assert_eq!(packet.t[lane].get().to_bits(), FARTHEST);
        assert_eq!(packet.object[lane].get(), 0);

        let exact: [f64; 3] = std::array::from_fn(|axis| {
            f64::from(corner[axis])
                + f64::from(px) * f64::from(right[axis])
                + f64::from(py) * f64::from(down[axis])
        });
        let length = exact
            .iter()
            .map(|component| component * component)
            .sum::<f64>()
            .sqrt();
        for (found, exact) in found.iter().zip(exact) {
            worst = worst.max((to_f64(*found) - exact / length).abs() * 2_f64.powi(23));
        }
    }
    worst
}

#[test]
fn equals_its_twin_and_keeps_its_error_bound() {
    let mut random = harness::random();
    let mut bench = Bench::new();
    let mut worst = 0.0_f64;
    for _ in 0..2000 {
        // A camera: the picture plane at distance 1, fields of view from narrow to wide.
        let field: f32 = random.random_range(0.01..2.0);
        let step = field / 1280.0;
        let corner = [
            random.random_range(-0.5..0.5) * field,
            random.random_range(-0.5..0.5) * field,
            -1.0,
        ];
        let turn: f32 = random.random_range(0.0..std::f32::consts::TAU);
        let (sin, cos) = turn.sin_cos();
        let rotate = |[x, y, z]: [f32; 3]| [x * cos - z * sin, y, x * sin + z * cos];
        let (x, y) = (
            random.random_range(0..2048) * 4,
            random.random_range(0..2048) * 4,
        );
        let error = check(
            &mut bench,
            rotate(corner),
            rotate([step, 0.0, 0.0]),
            [0.0, -step, 0.0],
            x,
            y,
        );
        worst = worst.max(error);
    }
    harness::keeps_stated_error(SOURCE, worst);
}

#[test]
fn directions_with_zeros_and_extreme_lengths() {
    let mut bench = Bench::new();
    for scale in [1e-9_f32, 1.0, 1e9] {
        for axis in 0..3 {
            let mut corner = [0.0; 3];
            corner[axis] = scale;
            let error = check(&mut bench, corner, [0.0; 3], [-0.0; 3], 0, 8188);
            harness::keeps_stated_error(SOURCE, error);
        }
    }
}
