//! `accumulate_r16`.

use kernels::cases::whitted::shade::sums::Shares;
use kernels::prelude::*;
use twins::accumulate::Share;

#[test]
fn a_ray_that_is_not_there_changes_no_sum() {
    let share = Share { pixel: 0, weight: 0, lit: [0x7fff_ffff, 0xffff_ffff, 0x1234_5678] };
    let sums = vec![[0.25, 0.5, 0.75].map(from_f64)];
    let shares = Shares { packets: vec![[share; 16]], sums };
    assert_eq!(shares.call(&mut Bench::new()), shares.sums);
}
