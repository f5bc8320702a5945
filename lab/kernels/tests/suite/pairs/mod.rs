//! The kernels that intersect candidates: tests that all of them share, bit for bit against their
//! twins, and a file with further tests for each shape.

mod colour;
mod cone;
mod flat;
mod smooth;
mod sphere;
mod texture;

use kernels::cases::sphere_ray::case_rays;
use kernels::cases::whitted::isect::call::{self, Pairs};
use kernels::cases::whitted::isect::cone::ConeObject;
use kernels::cases::whitted::isect::error::SCALES;
use kernels::cases::whitted::isect::rectangle::RectangleObject;
use kernels::cases::whitted::isect::shape::Shape;
use kernels::cases::whitted::isect::sphere::By;
use kernels::cases::whitted::isect::triangle::TriangleObject;
use kernels::cases::whitted::isect::triangle_mt::MoellerTrumbore;
use kernels::prelude::*;
use twins::sphere::{
    Estimate, Factored, InDouble, Interpolated, Newton2, Paper, Perpendicular, Refined, Stable,
    Unnormalised,
};
use twins::sphere_ray::Ray;

/// Lengths of lists. A scheduled loop takes other paths for the short ones.
const COUNTS: [usize; 7] = [0, 1, 2, 3, 7, 16, 40];

/// The object of a ray that has hit nothing.
const NOTHING: u32 = 0x0002_9000;

/// The t of an absent ray, -1.
const ABSENT: u32 = 0xbf80_0000;

/// Runs the kernel, which must equal its twin. Returns the rays and the objects' addresses.
fn check<S: Shape>(
    bench: &mut Bench,
    packets: &[[Ray; 16]],
    objects: &[S],
    list: &[[usize; 2]],
    anything: u32,
) -> (Vec<[Ray; 16]>, Vec<u32>) {
    let (packets, objects, list) = (packets.to_vec(), objects.to_vec(), list.to_vec());
    let (placed, _) = Pairs { packets, objects, list, anything }.check_placed(bench);
    (bench.read_all(placed.packets).iter().map(call::rays).collect(), placed.objects)
}

/// The sine of the angle between this lane's ray and a tangent: some ulps, or more for
/// formulations that lose digits.
fn around_a_tangent(lane: usize) -> f64 {
    let step = if lane.is_multiple_of(2) { -26 } else { -20 };
    (lane as f64 - 8.0) * 2_f64.powi(step)
}

/// The rays of the cases, which have hit nothing yet.
fn straight() -> [Ray; 16] {
    case_rays().map(|ray| Ray { t: FARTHEST, object: NOTHING, ..ray })
}

fn a_packet_in_candidate_after_candidate_keeps_its_nearest_hit<S: Shape>() {
    let mut random = random();
    let mut bench = Bench::new();
    let objects: Vec<S> = (0..40).map(|step| S::ahead(0.0, 5.0 + f64::from(step))).collect();
    for count in COUNTS.into_iter().filter(|count| *count > 0) {
        let farther: Vec<[usize; 2]> = (0..count).map(|object| [object, 0]).collect();
        let nearer: Vec<[usize; 2]> = farther.iter().rev().copied().collect();
        for list in [farther, nearer] {
            let (rays, addresses) = check(&mut bench, &[straight()], &objects, &list, 0);
            assert!(rays[0].iter().all(|ray| ray.object == addresses[0]));
        }
        // In runs of random length, mixed with other packets.
        let mut packet = 0;
        let list: Vec<[usize; 2]> = (0..count)
            .map(|_| {
                if random.random_range(0..3) == 0 {
                    packet = random.random_range(0..3);
                }
                [random.random_range(0..objects.len()), packet]
            })
            .collect();
        check(&mut bench, &[straight(); 3], &objects, &list, 0);
    }
}

fn the_first_of_equally_near_objects_stays<S: Shape>() {
    let mut bench = Bench::new();
    let objects = [S::ahead(0.0, 5.0); 3];
    let list = [[1, 0], [0, 0], [2, 0]];
    let (rays, addresses) = check(&mut bench, &[straight()], &objects, &list, 0);
    assert!(rays[0].iter().all(|ray| ray.object == addresses[1]));
}

fn a_ray_that_is_not_there_stays_so<S: Shape>() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut hits = 0;
    for _ in 0..200 {
        for scale in SCALES {
            let (object, mut rays) = S::around(&mut random, scale);
            for ray in rays.iter_mut().step_by(3) {
                ray.t = ABSENT;
                ray.object = NOTHING;
            }
            // With any bits in the ignored fields.
            rays[3].origin = random.random();
            rays[3].direction = random.random();
            let anything = random.random();
            let (after, _) = check(&mut bench, &[rays], &[object], &[[0, 0]], anything);
            for (before, after) in rays.iter().zip(&after[0]).step_by(3) {
                assert_eq!(before, after);
            }
            hits += rays.iter().zip(&after[0]).filter(|(b, a)| b != a).count();
        }
    }
    assert!(hits > 500, "only {hits} hits");
}

/// The tests of every shape.
macro_rules! tests_of_formulations {
    ($module:ident, $shape:ty: $($test:ident)*) => {
        mod $module {
            use super::*;
            $(
                #[test]
                fn $test() {
                    super::$test::<$shape>();
                }
            )*
        }
    };
    ($($module:ident: $shape:ty;)*) => {
        $(tests_of_formulations! { $module, $shape:
            a_packet_in_candidate_after_candidate_keeps_its_nearest_hit
            the_first_of_equally_near_objects_stays
            a_ray_that_is_not_there_stays_so
        })*
    };
}

tests_of_formulations! {
    all_of_spheres: By<Perpendicular>;
    all_of_spheres_by_paper: By<Paper>;
    all_of_spheres_by_estimate: By<Estimate>;
    all_of_spheres_by_interpolated: By<Interpolated>;
    all_of_spheres_by_newton2: By<Newton2>;
    all_of_spheres_by_stable: By<Stable>;
    all_of_spheres_by_factored: By<Factored>;
    all_of_spheres_by_refined: By<Refined>;
    all_of_spheres_by_unnormalised: By<Unnormalised>;
    all_of_spheres_in_double: By<InDouble>;
    all_of_rectangles: RectangleObject;
    all_of_triangles: TriangleObject;
    all_of_triangles_mt: MoellerTrumbore;
    all_of_cones: ConeObject;
}
