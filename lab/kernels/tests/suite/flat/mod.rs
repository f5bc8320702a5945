//! The kernels of flat shapes: triangles, rectangles, planes.

mod leaks;
mod rectangle;
mod triangle;
mod watertight;

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
