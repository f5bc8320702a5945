//! Functions that the tests of triangles and of rectangles share.

use kernels::Bench;
use kernels::flat_records::{Rays, Shears};
use zerocopy::IntoBytes as _;

/// The packets' shears. Empties the bench.
pub fn sheared(bench: &mut Bench, packets: &[Rays]) -> Vec<Shears> {
    bench.reset();
    let records = packets
        .iter()
        .map(|rays| {
            let rays = bench.place(rays.as_bytes());
            let record = bench.junk::<Shears>();
            bench.call("shear_r16", &[rays.address, record.address]);
            bench.read(record)
        })
        .collect();
    bench.reset();
    records
}

/// The bits for a condition on sixteen rays, in the format of the any-hit kernels' results.
pub fn code(blocked: [bool; 16]) -> u32 {
    blocked.into_iter().fold(0, |code, blocked| code << 1 | u32::from(blocked))
}

/// Checks that a kernel's worst errors are within the numbers after `Error` in its header.
pub fn keeps_stated_errors(kernel: &str, worst: &[f64]) {
    let source = kernels::source::Source::find(kernel).expect("a kernel");
    let header = source.header().expect("a header");
    let words = header.error.split_whitespace().filter_map(|word| word.parse().ok());
    let stated: Vec<f64> = words.take(worst.len()).collect();
    println!("{kernel}: worst errors {worst:?}, stated {stated:?}");
    assert_eq!(stated.len(), worst.len(), "{}", header.error);
    for (worst, stated) in worst.iter().zip(stated) {
        assert!(*worst <= stated, "{kernel}: error {worst}, stated {stated}");
    }
}
