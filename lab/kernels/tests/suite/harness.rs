//! The harness detects kernels that break a rule. There is one for each rule.

use std::fs;
use std::path::Path;

use kernels::bench::Returned;
use kernels::prelude::*;
use kernels::set::Kernels;
use kernels::source::Source;
use spu_build::{Image, Tools};

const SOURCES: [Source; 8] = [
    source("good", include_str!("harness/plain/good.s")),
    source("greedy", include_str!("harness/plain/greedy.s")),
    source("lost", include_str!("harness/plain/lost.s")),
    source("endless", include_str!("harness/plain/endless.s")),
    source("beside", include_str!("harness/plain/beside.s")),
    source("follows", include_str!("harness/plain/follows.s")),
    source("writes", include_str!("harness/plain/writes.s")),
    source("returns", include_str!("harness/plain/returns.s")),
];

const fn source(name: &'static str, text: &'static str) -> Source {
    Source { name, file: name, text }
}

/// The plain kernels, with files of `versions` replacing those of the same names.
fn image(versions: &str) -> &'static [u8] {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let harness = here.join("tests/suite/harness");
    let work = tempfile::tempdir().expect("a folder");
    let elf = work.path().join("kernels.elf");
    let image = Image::new(&here.join("../../linker/spu.ld")).folder(&here.join("image"));
    let versions = SOURCES.map(|source| {
        let [plain, version] = ["plain", versions]
            .map(|folder| harness.join(folder).join(format!("{}.s", source.name)));
        if version.is_file() { version } else { plain }
    });
    image
        .map(|image| versions.iter().fold(image, |image, version| image.source(version)))
        .and_then(|image| image.build(&Tools::find()?, work.path(), &elf))
        .unwrap_or_else(|error| panic!("{error}"));
    fs::read(elf).expect("the image").leak()
}

fn bench() -> Bench {
    Bench::of(Kernels {
        plain: image("plain"),
        scheduled: image("scheduled"),
        sources: SOURCES.to_vec(),
    })
}

fn call(kernel: &str) -> Returned {
    let mut bench = bench();
    let place = bench.place(&[0; 16]);
    bench.call(kernel, &[place.address])
}

#[test]
fn valid_kernel_is_called() {
    let mut bench = bench();
    let place = bench.place(&41_u32.to_be_bytes().repeat(4));
    let returned = bench.call("good", &[place.address]);
    assert_eq!(returned, Returned { value: 42, instructions: 5 });
    assert_eq!(bench.read::<[u8; 16]>(place)[..4], 42_u32.to_be_bytes());
}

#[test]
fn kernel_writes_are_visible_to_next_call() {
    let mut bench = bench();
    let place = bench.place(&40_u32.to_be_bytes().repeat(4));
    for (kernel, value) in [("good", 41), ("follows", 43), ("good", 44)] {
        assert_eq!(bench.call(kernel, &[place.address]).value, value);
    }
}

#[test]
#[should_panic(expected = "greedy lost $90")]
fn a_lost_register_is_seen() {
    call("greedy");
}

#[test]
#[should_panic(expected = "lost: ")]
fn a_lost_kernel_is_seen() {
    call("lost");
}

#[test]
#[should_panic(expected = "endless does not end")]
fn an_endless_kernel_is_seen() {
    call("endless");
}

#[test]
#[should_panic(expected = "beside wrote after the buffer")]
fn a_write_beside_a_buffer_is_seen() {
    call("beside");
}

#[test]
#[should_panic(expected = "writes: plain and scheduled differ")]
fn a_scheduled_version_that_writes_something_else_is_seen() {
    call("writes");
}

#[test]
#[should_panic(expected = "returns: plain and scheduled return")]
fn a_scheduled_version_that_returns_something_else_is_seen() {
    call("returns");
}
