//! The statements in headers hold, and the records have the layout that the assembler uses.

use std::collections::BTreeSet;

use kernels::catalogue;
use kernels::flat_records;
use kernels::prelude::*;
use kernels::records::{BareSphere, Ray, Rays};
use kernels::set::Kernels;
use kernels::source::Source;
use std::mem::offset_of;

#[test]
fn every_kernel_has_a_row() {
    let rows: Vec<&str> = catalogue::kernels().map(|kernel| kernel.name).collect();
    let named: BTreeSet<&str> = rows.iter().copied().collect();
    assert_eq!(rows.len(), named.len(), "one row each: {rows:?}");
    let set = Kernels::here().unwrap_or_else(|error| panic!("{error}"));
    let kernels: BTreeSet<&str> = set.sources.iter().map(|source| source.name).collect();
    assert_eq!(named, kernels);
    for kernel in catalogue::kernels() {
        assert!(!kernel.cases.is_empty(), "{} has no case", kernel.name);
        let stated = Source::find(kernel.name).and_then(Source::header);
        let stated = stated.and_then(|header| header.stated_error());
        let counts = stated.is_some_and(|error| error > 0.0);
        assert_eq!(kernel.error.is_some(), counts, "{}", kernel.name);
    }
}

#[test]
fn every_header_can_be_read() {
    let set = Kernels::here().unwrap_or_else(|error| panic!("{error}"));
    for source in &set.sources {
        let header = source.header().unwrap_or_else(|| {
            panic!("{}: no line `# {}   what it does`, or no `#   C`", source.file, source.name)
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
        let Some(error) = &kernel.error else { continue };
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
        for case in &kernel.cases {
            bench.reset();
            let arguments = (case.place)(&mut bench, case.objects.first());
            bench.call(kernel.name, &arguments);
        }
    }
}

/// Every `.set NAME_field,offset` in an included file.
fn offsets(text: &'static str) -> BTreeSet<(&'static str, usize)> {
    text.lines()
        .filter_map(|line| line.trim_start().strip_prefix(".set"))
        .map(str::trim)
        .filter(|line| line.starts_with(|first: char| first.is_ascii_uppercase()))
        .map(|line| {
            let (name, value) = line.split_once(',').expect("a value");
            let value = value.split_whitespace().next().expect("a value");
            (name, value.parse().expect("a number"))
        })
        .collect()
}

#[test]
fn the_records_of_rays_are_the_assemblers() {
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
        ("BARE_SPHERE_centre", offset_of!(BareSphere, centre)),
        ("BARE_SPHERE_radius_squared", offset_of!(BareSphere, radius_squared)),
        ("BARE_SPHERE_SIZE", size_of::<BareSphere>()),
    ]);
    assert_eq!(offsets(include_str!("../../../spu/include/rays.inc")), expected);
}

#[test]
fn the_records_of_flat_shapes_are_the_assemblers() {
    const QUADWORD: usize = 16;
    let expected = BTreeSet::from([
        ("RAYS_u", offset_of!(flat_records::Rays, u)),
        ("RAYS_v", offset_of!(flat_records::Rays, v)),
        ("RAY_u", offset_of!(flat_records::OneRay, u)),
        ("RAY_v", offset_of!(flat_records::OneRay, v)),
        ("TRIANGLE_a", 0),
        ("TRIANGLE_b", QUADWORD),
        ("TRIANGLE_c", 2 * QUADWORD),
        ("TRIANGLE_SIZE", 3 * QUADWORD),
        ("RECTANGLE_point", 0),
        ("RECTANGLE_normal", QUADWORD),
        ("RECTANGLE_dual_u", 2 * QUADWORD),
        ("RECTANGLE_dual_v", 3 * QUADWORD),
        ("RECTANGLE_SIZE", 4 * QUADWORD),
    ]);
    assert_eq!(offsets(include_str!("../../../../spu/include/flat.inc")), expected);
}
