//! The stored images equal those that the sources make.

#[test]
fn committed_images_are_what_the_sources_make() {
    kernels::images::check().unwrap();
}
