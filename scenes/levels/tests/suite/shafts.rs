//! Which lamps reach triangles, against rays.

use glam::DVec3;
use levels::{Blockers, Lamp};
use randomness::{Random, rounds};
use scenes::{Mesh, Visibility};

const RANGE: f64 = 40.0;

fn mesh(triangles: &[[DVec3; 3]]) -> Mesh {
    let count = triangles.len() as u32;
    Mesh {
        positions: triangles.iter().flatten().map(|it| it.as_vec3().to_array()).collect(),
        triangles: (0..count).map(|number| [3 * number, 3 * number + 1, 3 * number + 2]).collect(),
        materials: vec![0; triangles.len()],
        ..Mesh::default()
    }
}

/// A rectangle that is seen from where its corners go counter-clockwise.
fn rectangle([a, b, c, d]: [[f64; 3]; 4]) -> [[DVec3; 3]; 2] {
    let [a, b, c, d] = [a, b, c, d].map(DVec3::from_array);
    [[a, b, c], [a, c, d]]
}

/// Whether a segment meets the front of a triangle.
fn is_met([a, b, c]: [DVec3; 3], from: DVec3, to: DVec3) -> bool {
    let normal = (b - a).cross(c - a);
    let way = to - from;
    let share = (a - from).dot(normal) / way.dot(normal);
    let place = from + share * way;
    let is_left = |from: DVec3, to: DVec3| (to - from).cross(place - from).dot(normal) > 0.0;
    way.dot(normal) < 0.0
        && (1e-6..1.0).contains(&share)
        && is_left(a, b)
        && is_left(b, c)
        && is_left(c, a)
}

fn known(triangles: &[[DVec3; 3]], add: impl Fn(&mut Blockers), lamps: &[Lamp]) -> Vec<Visibility> {
    let mesh = mesh(triangles);
    let mut blockers = Blockers::default();
    blockers.add_mesh(&mesh, |_| false);
    add(&mut blockers);
    blockers.around(lamps).visibility(&mesh, |_| false)
}

#[test]
fn walls_keep_light_from_floors() {
    let lamps = [Lamp { place: DVec3::new(-5.0, 4.0, 0.5), range: RANGE }];
    let floor = |x: f64| {
        let near = [[x, 0.0, 0.0], [x, 0.0, 1.0], [x + 1.0, 0.0, 1.0], [x + 1.0, 0.0, 0.0]];
        rectangle(near)
    };
    // It is seen from the right, and its lower edge is on the floor.
    let wall = rectangle([[0.0, 0.0, 9.0], [0.0, 0.0, -9.0], [0.0, 2.0, -9.0], [0.0, 2.0, 9.0]]);
    let triangles = [floor(-1.0), floor(0.0), floor(4.5), floor(8.0), wall].concat();
    let found = known(&triangles, |_| (), &lamps);
    let [lit, dark, neither] = [(1, 0), (0, 1), (0, 0)];
    let as_pairs: Vec<_> = found.iter().map(|it| (it.lit, it.dark)).collect();
    assert_eq!(as_pairs[..8], [lit, lit, dark, dark, neither, neither, lit, lit]);
    // The wall's own front is turned away from the lamp, which needs no ray there.
    assert_eq!(as_pairs[8..], [lit, lit]);
    // In a box that something may be in, nothing is known but what is dark.
    let low = DVec3::new(-3.0, 0.5, 0.0);
    let found = known(&triangles, |it| it.add_box(low, low + DVec3::ONE), &lamps);
    assert_eq!((found[0].lit, found[0].dark), neither);
    assert_eq!((found[2].lit, found[2].dark), dark);
    let around =
        known(&triangles, |it| it.add_box(lamps[0].place - 1.0, lamps[0].place + 1.0), &lamps);
    assert!(around[..8].iter().all(|known| known.lit == 0));
}

/// A number from 0 to 1.
fn share(random: &mut Random) -> f64 {
    random.below(1 << 30) as f64 / f64::from(1 << 30)
}

fn place(random: &mut Random, size: f64) -> DVec3 {
    DVec3::from_array([(); 3].map(|()| size * (2.0 * share(random) - 1.0)))
}

/// Rays from what is lit meet nothing, and those from what is dark something.
#[test]
fn rays_agree() {
    let mut random = Random::new("triangles and lamps");
    let mut counts = [0; 3];
    for _ in 0..rounds(40) {
        let triangles: Vec<[DVec3; 3]> = (0..24)
            .map(|at| {
                let middle = place(&mut random, 12.0);
                let size = if at % 3 == 0 { 12.0 } else { 3.0 };
                // As singles have them.
                [(); 3].map(|()| (middle + place(&mut random, size)).as_vec3().as_dvec3())
            })
            .collect();
        let lamps = [(); 18].map(|()| Lamp { place: place(&mut random, 10.0), range: 20.0 });
        let found = known(&triangles, |_| (), &lamps);
        for (corners, known) in triangles.iter().zip(found) {
            let [a, b, c] = *corners;
            let normal = (b - a).cross(c - a);
            for (number, lamp) in lamps.iter().enumerate() {
                let bit = 1 << (number % 16);
                for _ in 0..20 {
                    let (u, v) = (share(&mut random), share(&mut random));
                    let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
                    let from = a + u * (b - a) + v * (c - a);
                    let is_reached = (lamp.place - from).dot(normal) > 0.0
                        && from.distance(lamp.place) < lamp.range;
                    if !is_reached {
                        continue;
                    }
                    let is_blocked = triangles.iter().any(|it| is_met(*it, from, lamp.place));
                    assert!(known.lit & bit == 0 || !is_blocked);
                    assert!(known.dark & bit == 0 || is_blocked);
                    counts[0] += 1;
                    counts[1] += usize::from(known.lit & bit != 0);
                    counts[2] += usize::from(known.dark & bit != 0);
                }
            }
        }
    }
    let [all, lit, dark] = counts;
    assert!(lit * 20 > all && dark * 200 > all, "{counts:?}");
}
