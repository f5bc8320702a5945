//! `accumulate_r16` and `pack_sums`.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::shade::call;
use kernels::cases::whitted::shade::error::any_shares;
use rand::Rng as _;
use rand::seq::SliceRandom as _;
use spu_emulator::float::single::from_f64;
use twins::Single;
use twins::accumulate::{Share, accumulate};
use twins::pack::pack;

use super::COUNTS;

/// Compares with the twin.
fn check_accumulate(bench: &mut Bench, packets: &[[Share; 16]], sums: &[[Single; 3]]) {
    let found = call::accumulate(bench, packets, sums);
    let mut expected = sums.to_vec();
    for shares in packets.as_flattened().as_chunks().0 {
        accumulate(shares, &mut expected);
    }
    assert_eq!(found, expected, "{packets:x?}");
}

#[test]
fn sums_equal_the_twin_however_many_rays_share_a_pixel() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..20 {
        for count in COUNTS {
            for pixels in [1, 2, 3, 16, 100] {
                let packets = any_shares(&mut random, count, pixels);
                let sums: Vec<[Single; 3]> = (0..pixels)
                    .map(|_| [(); 3].map(|()| from_f64(random.random_range(0.0..1.0))))
                    .collect();
                check_accumulate(&mut bench, &packets, &sums);
            }
        }
    }
}

#[test]
fn any_bits_of_shares_and_sums_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let sums: [[Single; 3]; 20] = random.random();
        let mut packets = any_shares(&mut random, 2, sums.len());
        for share in packets.as_flattened_mut() {
            (share.weight, share.lit) = random.random();
        }
        check_accumulate(&mut bench, &packets, &sums);
    }
}

#[test]
fn absent_ray_changes_no_sum() {
    let mut bench = Bench::new();
    let share = Share { pixel: 0, weight: 0, lit: [0x7fff_ffff, 0xffff_ffff, 0x1234_5678] };
    let sum = [0.25, 0.5, 0.75].map(from_f64);
    let found = call::accumulate(&mut bench, &[[share; 16]], &[sum]);
    assert_eq!(found, [sum]);
}

/// Compares with the twin.
fn check_pack(bench: &mut Bench, rows: &[Vec<[Single; 3]>], shifts: [u32; 3]) {
    let found = call::pack_sums(bench, rows, shifts);
    let expected: Vec<u32> = rows.iter().flatten().map(|&sum| pack(sum, shifts)).collect();
    assert_eq!(found, expected, "{rows:x?}, shifts {shifts:?}");
}

#[test]
fn packed_rows_equal_the_twin_whatever_their_number_and_length() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut shifts = [0, 8, 16, 24];
    for rows in 1..=16 {
        for groups in 1..=16 {
            shifts.shuffle(&mut random);
            let [red, green, blue, _] = shifts;
            let any_bits = random.random_ratio(1, 4);
            let mut channel = || {
                if any_bits { random.random() } else { from_f64(random.random_range(-0.25..1.25)) }
            };
            let rows: Vec<Vec<[Single; 3]>> = (0..rows)
                .map(|_| (0..4 * groups).map(|_| [(); 3].map(|()| channel())).collect())
                .collect();
            check_pack(&mut bench, &rows, [red, green, blue]);
        }
    }
}
