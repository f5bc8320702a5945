//! What the headers say holds, and the records are what the assembler thinks they are.

use std::collections::BTreeSet;

use kernels::bench::{Bench, random};
use kernels::catalogue;
use kernels::records::{Ball, Ray, Rays};
use kernels::source::{SOURCES, Source};
use std::mem::offset_of;

#[test]
fn every_header_can_be_read() {
    for source in SOURCES {
        let header = source.header().unwrap_or_else(|| {
            panic!(
                "{}: no line `# {}   what it does`, or no `#   C`",
                source.file, source.name
            )
        });
        let called = format!("{}(", source.name);
        assert!(
            header.prototype.contains(&called) && header.prototype.ends_with(';'),
            "{}: {}",
            source.file,
            header.prototype
        );
    }
}

#[test]
fn a_header_is_read_with_its_further_lines() {
    let source = Source {
        name: "k",
        file: "k.s",
        text: "# k   does it\n#   C       int k(int,\n#                 int);\n#   Out     $3\n\
               #   Error   2.5 ulp\n        bi $lr\n",
        scheduled: false,
    };
    let header = source.header().expect("a header");
    assert_eq!(header.doc, "does it");
    assert_eq!(header.prototype, "int k(int, int);");
    assert_eq!(header.stated_error(), Some(2.5));
    assert_eq!(header.returned_words(), 1);
}

#[test]
fn measured_errors_are_within_what_the_headers_state() {
    let mut bench = Bench::new();
    let mut random = random();
    for kernel in catalogue::kernels() {
        let Some(error) = kernel.error else { continue };
        let header = Source::find(kernel.name).and_then(Source::header);
        let stated = header.and_then(|header| header.stated_error());
        let stated = stated.unwrap_or_else(|| panic!("{} states no error", kernel.name));
        let measured = error(&mut bench, &mut random);
        println!("{}: {measured:.3}, stated {stated}", kernel.name);
        assert!(measured <= stated, "{}: {measured}", kernel.name);
    }
}

#[test]
fn every_case_can_be_called() {
    let mut bench = Bench::new();
    for kernel in catalogue::kernels() {
        assert!(Source::find(kernel.name).is_some(), "no {}", kernel.name);
        for case in kernel.cases {
            bench.reset();
            let arguments = (case.place)(&mut bench, case.objects.first());
            bench.call(kernel.name, &arguments);
        }
    }
}

/// Every `.set NAME_field,offset` of `rays.inc`, against the records in Rust.
#[test]
fn the_records_are_the_assemblers() {
    let text = include_str!("../../spu/include/rays.inc");
    let found: BTreeSet<(&str, usize)> = text
        .lines()
        .filter_map(|line| line.trim_start().strip_prefix(".set"))
        .map(|line| {
            let (name, value) = line.trim().split_once(',').expect("a value");
            let value = value.split_whitespace().next().expect("a value");
            (name, value.parse().expect("a number"))
        })
        .collect();
    let expected = BTreeSet::from([
        ("RAYS_origin_x", offset_of!(Rays, origin_x)),
        ("RAYS_origin_y", offset_of!(Rays, origin_y)),
        ("RAYS_origin_z", offset_of!(Rays, origin_z)),
        ("RAYS_direction_x", offset_of!(Rays, direction_x)),
        ("RAYS_direction_y", offset_of!(Rays, direction_y)),
        ("RAYS_direction_z", offset_of!(Rays, direction_z)),
        ("RAYS_t", offset_of!(Rays, t)),
        ("RAYS_object", offset_of!(Rays, object)),
        ("RAYS_SIZE", size_of::<Rays>()),
        ("RAY_origin", offset_of!(Ray, origin)),
        ("RAY_direction", offset_of!(Ray, direction)),
        ("RAY_t", offset_of!(Ray, t)),
        ("RAY_object", offset_of!(Ray, object)),
        ("RAY_SIZE", size_of::<Ray>()),
        ("BALL_centre", offset_of!(Ball, centre)),
        ("BALL_radius_squared", offset_of!(Ball, radius_squared)),
        ("BALL_SIZE", size_of::<Ball>()),
    ]);
    assert_eq!(found, expected);
}
