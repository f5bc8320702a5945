//! `isect_cone_pairs_r16`.

use kernels::cases::sphere_ray::ray;
use kernels::cases::whitted::isect::cone::{Exact, cone};
use twins::pairs::Sides;

use super::check;
use kernels::prelude::*;

const BOTH: Sides = Sides { both: true, exit: false };

/// A name, a ray's origin and direction, and the distances at which it enters and leaves.
type Case = (&'static str, [f64; 3], [f64; 3], Option<f64>, Option<f64>);

/// Checks the cases with the body visible from each side. The crossings must be at the given
/// distances.
fn check_cases(exact: &Exact, cases: &[Case]) {
    let mut bench = Bench::new();
    for &(name, origin, direction, enters, leaves) in cases {
        let direction = unit(direction);
        let nearest = match (enters, leaves) {
            (Some(enters), Some(leaves)) => Some(f64::min(enters, leaves)),
            (enters, leaves) => enters.or(leaves),
        };
        for (both, exit, expected) in [
            (false, false, enters),
            (false, true, leaves),
            (true, false, nearest),
            (true, true, nearest),
        ] {
            let sides = Sides { both, exit };
            let cone = cone(&Exact { sides, ..*exact });
            let ray = ray(origin, direction, FARTHEST);
            let (rays, objects) = check(&mut bench, &[[ray; 16]], &[cone], &[[0, 0]], 0);
            let found = (rays[0][0].object == objects[0]).then(|| to_f64(rays[0][0].t));
            let near = match (found, expected) {
                (Some(found), Some(expected)) => (found - expected).abs() < 1e-5 * expected,
                (found, expected) => found.is_none() && expected.is_none(),
            };
            assert!(near, "{name}, {sides:?}: {found:?}, not {expected:?}");
        }
    }
}

#[test]
fn ray_cylinder_relations_give_expected_hits() {
    let cylinder = Exact {
        base: [0.0, -1.0, -5.0],
        axis: [0.0, 1.0, 0.0],
        radius: 1.0,
        growth: 0.0,
        heights: [0.0, 2.0],
        sides: BOTH,
    };
    let root_2 = 2_f64.sqrt();
    let forward = [0.0, 0.0, -1.0];
    let cases: [Case; 12] = [
        ("ahead", [0.0; 3], forward, Some(4.0), Some(6.0)),
        ("from the opposite side", [0.0, 0.0, -9.0], [0.0, 0.0, 1.0], Some(3.0), Some(5.0)),
        ("behind the origin", [0.0, 0.0, -9.0], forward, None, None),
        ("beside", [1.5, 0.0, 0.0], forward, None, None),
        ("above", [0.0, 1.5, 0.0], forward, None, None),
        ("below", [0.0, -1.5, 0.0], forward, None, None),
        ("from within", [0.0, 0.0, -5.0], forward, None, Some(1.0)),
        ("through the open top", [0.0, 4.0, -8.0], [0.0, -1.0, 1.0], None, Some(4.0 * root_2)),
        ("out at the open top", [0.0, -3.0, -8.5], [0.0, 1.0, 1.0], Some(2.5 * root_2), None),
        ("along the axis", [0.0, 5.0, -5.0], [0.0, -1.0, 0.0], None, None),
        ("beside the axis", [0.5, 5.0, -5.0], [0.0, -1.0, 0.0], None, None),
        ("along it, outside", [1.5, 5.0, -5.0], [0.0, -1.0, 0.0], None, None),
    ];
    check_cases(&cylinder, &cases);
}

#[test]
fn ray_cone_relations_give_expected_hits() {
    let cone = Exact {
        base: [0.0; 3],
        axis: [0.0, 1.0, 0.0],
        radius: 2.0,
        growth: -1.0,
        heights: [0.0, 2.0],
        sides: BOTH,
    };
    let root_2 = 2_f64.sqrt();
    let cases: [Case; 9] = [
        ("across", [9.0, 1.0, 0.0], [-1.0, 0.0, 0.0], Some(8.0), Some(10.0)),
        ("down beside the axis", [1.0, 5.0, 0.0], [0.0, -1.0, 0.0], Some(4.0), None),
        ("up beside the axis", [1.0, -5.0, 0.0], [0.0, 1.0, 0.0], None, Some(6.0)),
        ("along a side, within", [0.0, 0.0, 0.0], [1.0, 1.0, 0.0], None, Some(root_2)),
        ("along a side, into it", [-3.0, 0.0, 0.0], [1.0, 1.0, 0.0], None, None),
        ("along a side, from above", [3.0, 3.0, 0.0], [-1.0, -1.0, 0.0], Some(2.0 * root_2), None),
        ("the mirror image", [9.0, 3.0, 0.0], [-1.0, 0.0, 0.0], None, None),
        ("through both", [-1.0, 4.0, 0.0], [1.0, -1.5, 0.0], Some(2.0 * 3.25_f64.sqrt()), None),
        ("below", [9.0, -1.0, 0.0], [-1.0, 0.0, 0.0], None, None),
    ];
    check_cases(&cone, &cases);
}
