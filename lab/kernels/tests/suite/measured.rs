//! The present measurements equal those in `lab/kernels/measured.txt` and are within their bounds.

use std::path::Path;
use std::sync::OnceLock;

use kernels::catalogue;
use kernels::document::check;
use kernels::loops::Form;
use kernels::measure::{Measured, Timed, measure_all};
use kernels::set::Kernels;
use kernels::table::markdown;
use spu_isa::timing::{Rules, find_loops};
use spu_scheduler::code::Code;

fn measured() -> &'static [Measured] {
    static MEASURED: OnceLock<Vec<Measured>> = OnceLock::new();
    MEASURED.get_or_init(|| {
        let measured = measure_all(catalogue::kernels());
        measured.unwrap_or_else(|error| panic!("{error}"))
    })
}

fn timed(kernel: &str, case: &str) -> &'static Timed {
    let mut kernels = measured().iter();
    let found = kernels.find(|measured| measured.kernel == kernel);
    let mut cases = found.expect("a kernel").cases.iter();
    cases.find(|timed| timed.case == case).expect("a case")
}

/// The cycles of the scheduled version for one more object.
fn in_stream(kernel: &str, case: &str) -> f64 {
    let stream = timed(kernel, case).scheduled.stream.expect("a list");
    stream.time.cycles as f64 / f64::from(stream.objects)
}

#[test]
fn the_document_is_up_to_date() {
    let document = Path::new(env!("CARGO_MANIFEST_DIR")).join("measured.txt");
    check(&document, &markdown(measured())).unwrap_or_else(|error| panic!("{error}"));
}

/// Kernels whose loops are not pipelined, to save local store: their headers state the cost.
const NOT_PIPELINED: [&str; 23] = [
    "cuts_cells",
    "cuts_rays_r16",
    "cuts_ground_r16",
    "height_block",
    "height_corners",
    "refine_hits_r16",
    "smooth_r16",
    "texture_places_r16",
    "texture_filter_r16",
    "colour_vertices_r16",
    "isect_mesh_pairs_r16",
    "filter_boxes_r16",
    "mesh_farthest_r16",
    "mesh_eye_bounds_r16",
    "mesh_list_hits_r16",
    "mesh_flat_patches",
    "shader_depth",
    "shader_portal",
    "cuts_follow",
    "cuts_extent_r16",
    "cuts_shades_r16",
    "sample_rays_r16",
    "objects_boxes",
];

/// Kernels some of whose loops have branches or other loops in them, and so no interval.
const HAVE_BRANCHES: [&str; 6] = [
    "build_leaf",
    "mesh_filter_rays",
    "mesh_few_rays",
    "mesh_prepare",
    "sort_elements",
    "sort_pack",
];

/// The shares that others reach: loops of three cycles that run rarely, and one with too few
/// registers.
const REACH_LESS: [(&str, f64); 3] =
    [("build_leaf", 0.75), ("refract_r16", 0.87), ("sort_pack", 0.5)];

#[test]
fn loops_reach_nine_tenths_of_their_bounds() {
    let mut loops = 0;
    let pipelined = |kernel: &&Measured| !NOT_PIPELINED.contains(&kernel.kernel);
    for kernel in measured().iter().filter(pipelined) {
        for found in &kernel.loops {
            let at = format!("{}: {}", kernel.kernel, found.name);
            let Some(cycles) = found.form.cycles() else {
                assert!(HAVE_BRANCHES.contains(&kernel.kernel), "{at}: {:?}", found.form);
                continue;
            };
            loops += 1;
            let less = REACH_LESS.iter().find(|(name, _)| *name == kernel.kernel);
            let expected = less.map_or(0.9, |(_, share)| *share);
            assert!(cycles.reached() >= expected, "{at}: {cycles:?}");
            assert!(cycles.bound >= cycles.even.max(cycles.odd), "{at}: {cycles:?}");
        }
    }
    assert!(loops >= 13, "only {loops} loops");
}

/// The intervals that the scheduler reports are those in the images.
#[test]
fn the_model_finds_the_same_intervals() {
    let kernels = Kernels::here().unwrap_or_else(|error| panic!("{error}"));
    let code = Code::parse(kernels.scheduled).expect("an image");
    for kernel in measured() {
        let functions = code.functions();
        let mut functions = functions.iter();
        let function = functions.find(|function| function.name == kernel.kernel);
        let function = function.expect("a function");
        let words = code.words(function.start, function.end);
        let steady: Vec<f64> = find_loops(&words, Rules::default())
            .iter()
            .filter_map(|found| Some(found.steady.as_ref()?.cycles_a_pass()))
            .collect();
        for found in &kernel.loops {
            if let Form::Pipelined(cycles) = found.form {
                assert!(
                    steady.contains(&((cycles.passes * cycles.interval) as f64)),
                    "{}: {found:?}, {steady:?}",
                    kernel.kernel
                );
            }
        }
    }
}

#[test]
fn primary_ray_kernels_keep_their_bounds() {
    let filter = in_stream("filter_spheres_r16", "all miss");
    assert!(filter <= 24.0, "{filter} cycles a packet and sphere");
    let pairs = in_stream("isect_pairs_r16", "all hit, each nearer");
    assert!(pairs <= 80.0, "{pairs} cycles a packet");
    for case in ["all outside", "all within"] {
        let frustum = in_stream("frustum_spheres", case);
        assert!(frustum <= 16.0, "{frustum} cycles a sphere, {case}");
        let plain = timed("frustum_spheres", case).plain.stream.expect("a list");
        let instructions = (plain.time.even + plain.time.odd) as f64 / f64::from(plain.objects);
        assert!(instructions <= 21.0, "{instructions} instructions a sphere, {case}");
    }
}
