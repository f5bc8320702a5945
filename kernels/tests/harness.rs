//! The harness sees what it is there for: kernels that break a rule, one each.

use std::fs;
use std::path::Path;

use kernels::bench::{Bench, Kernels, Returned};
use kernels::source::Source;
use spu_build::{Image, Tools, Version};

const SOURCES: &[Source] = &[
    source("good", include_str!("harness/plain/room/good.s"), false),
    source("greedy", include_str!("harness/plain/room/greedy.s"), false),
    source("lost", include_str!("harness/plain/room/lost.s"), false),
    source(
        "endless",
        include_str!("harness/plain/room/endless.s"),
        false,
    ),
    source("beside", include_str!("harness/plain/room/beside.s"), false),
    source(
        "follows",
        include_str!("harness/plain/room/follows.s"),
        true,
    ),
    source("writes", include_str!("harness/plain/room/writes.s"), true),
    source(
        "returns",
        include_str!("harness/plain/room/returns.s"),
        true,
    ),
];

const fn source(name: &'static str, text: &'static str, scheduled: bool) -> Source {
    Source {
        name,
        file: name,
        text,
        scheduled,
    }
}

fn image(version: Version) -> &'static [u8] {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let work = tempfile::tempdir().expect("a folder");
    let elf = work.path().join("kernels.elf");
    Image::new(&here.join("../linker/spu.ld"))
        .folder(&here.join("image"))
        .and_then(|image| image.kernels(&here.join("tests/harness"), version))
        .and_then(|image| image.build(&Tools::find()?, work.path(), &elf))
        .unwrap_or_else(|error| panic!("{error}"));
    fs::read(elf).expect("the image").leak()
}

fn bench() -> Bench {
    Bench::of(Kernels {
        plain: image(Version::Plain),
        scheduled: image(Version::Scheduled),
        sources: SOURCES,
    })
}

fn call(kernel: &str) -> Returned {
    let mut bench = bench();
    let place = bench.place(&[0; 16]);
    bench.call(kernel, &[place.address])
}

#[test]
fn a_good_kernel_is_called() {
    let mut bench = bench();
    let place = bench.place(&41_u32.to_be_bytes().repeat(4));
    let returned = bench.call("good", &[place.address]);
    assert_eq!(
        returned,
        Returned {
            value: 42,
            instructions: 5
        }
    );
    assert_eq!(bench.read::<[u8; 16]>(place)[..4], 42_u32.to_be_bytes());
}

#[test]
fn what_a_kernel_without_scheduled_version_writes_is_there_for_the_next() {
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
#[should_panic(expected = "endless does not come to an end")]
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
