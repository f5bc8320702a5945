//! "teapot": Newell's teapot with a bottom, of triangles with smooth normals, on a checkerboard.
//!
//! Its 32 patches are bicubic Bézier surfaces. Body, lid and bottom are profiles that are turned
//! around the axis in four quarters; handle and spout are tubes that are the same on both sides.
//!
//! All of it is a mesh, because an object can't be seen from both sides. So each of SPD's squares
//! is two triangles.

use glam::{DMat4, DVec3, DVec4};

use super::Generator;
use super::builder::{Builder, opaque, view};
use crate::Mesh;

pub(super) const GENERATOR: Generator = Generator {
    name: "teapot",
    // SPD's program has 6.
    default: 12,
    most: u32::MAX,
    objects: |size| {
        let size = u128::from(size);
        // Of the pot, without those of no area, and of the board.
        64 * size * size - 8 * size + 2 * size * size
    },
    build,
};

const LIGHTS: [DVec3; 2] = [DVec3::new(-3.1, 9.8, 12.1), DVec3::new(11.3, 5.1, 8.8)];

/// The control points of a profile: radius, height, and how far the control points beside it are,
/// relative to the radius.
type Profile = [(f64, f64, f64); 4];

/// Of a curve that is nearly a quarter of a circle.
const ROUND: f64 = 0.56;

const RIM: Profile =
    [(1.4, 2.4, ROUND), (1.3375, 2.53125, ROUND), (1.4375, 2.53125, ROUND), (1.5, 2.4, ROUND)];
const UPPER_BODY: Profile =
    [(1.5, 2.4, ROUND), (1.75, 1.875, ROUND), (2.0, 1.35, ROUND), (2.0, 0.9, ROUND)];
const LOWER_BODY: Profile =
    [(2.0, 0.9, ROUND), (2.0, 0.45, ROUND), (1.5, 0.225, ROUND), (1.5, 0.15, ROUND)];
const KNOB: Profile =
    [(0.0, 3.15, ROUND), (0.8, 3.15, 0.5625), (0.0, 2.85, ROUND), (0.2, 2.7, ROUND)];
const LID: Profile = [(0.2, 2.7, ROUND), (0.4, 2.55, ROUND), (1.3, 2.55, ROUND), (1.3, 2.4, ROUND)];
const BOTTOM: Profile =
    [(0.0, 0.0, ROUND), (1.425, 0.0, ROUND), (1.5, 0.075, ROUND), (1.5, 0.15, ROUND)];

/// The control points of a tube: x and z of its inner and its outer side, and half its width.
type Tube = [([f64; 2], [f64; 2], f64); 4];

const UPPER_HANDLE: Tube = [
    ([-1.6, 2.025], [-1.5, 2.25], 0.3),
    ([-2.3, 2.025], [-2.5, 2.25], 0.3),
    ([-2.7, 2.025], [-3.0, 2.25], 0.3),
    ([-2.7, 1.8], [-3.0, 1.8], 0.3),
];
const LOWER_HANDLE: Tube = [
    ([-2.7, 1.8], [-3.0, 1.8], 0.3),
    ([-2.7, 1.575], [-3.0, 1.35], 0.3),
    ([-2.5, 1.125], [-2.65, 0.9375], 0.3),
    ([-2.0, 0.9], [-1.9, 0.6], 0.3),
];
const SPOUT: Tube = [
    ([1.7, 1.425], [1.7, 0.6], 0.66),
    ([2.6, 1.425], [3.1, 0.825], 0.66),
    ([2.3, 2.1], [2.4, 2.025], 0.25),
    ([2.7, 2.4], [3.3, 2.4], 0.25),
];
const SPOUT_TIP: Tube = [
    ([2.7, 2.4], [3.3, 2.4], 0.25),
    ([2.8, 2.475], [3.525, 2.49375], 0.25),
    ([2.9, 2.475], [3.45, 2.5125], 0.15),
    ([2.8, 2.4], [3.2, 2.4], 0.15),
];

/// Points nearer to the axis than this are on it.
const ON_AXIS: f64 = 0.0001;

fn build(size: u32) -> Builder {
    let from = DVec3::new(4.86, 7.2, 5.4);
    let mut builder = Builder::new(view(from, DVec3::ZERO), &LIGHTS);
    // The lid leaves a gap through which one sees the inside.
    builder.two_sided();
    for (grey, parity) in [(1.0, 1), (0.5, 0)] {
        builder.material(opaque(DVec3::splat(grey), 0.5, 0.5, 30.0));
        builder.triangles(&squares(size, parity));
    }
    builder.material(opaque(DVec3::new(1.0, 0.5, 0.1), 0.75, 0.25, 37.0));
    let mut pot = Mesh::default();
    for surface in surfaces() {
        surface.triangles(&mut pot, size);
    }
    builder.triangles(&pot);
    builder
}

/// The light or the dark squares of the checkerboard.
fn squares(size: u32, parity: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let squares = (0..size).flat_map(|x| (0..size).map(move |y| (x, y)));
    for (x, y) in squares.filter(|(x, y)| (x + y) % 2 == parity) {
        let first = mesh.positions.len() as u32;
        for (right, up) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
            let place = |index: u32| 8.0 * f64::from(index) / f64::from(size) - 4.0;
            let corner = DVec3::new(place(x + right), place(y + up), 0.0);
            mesh.positions.push(corner.as_vec3().to_array());
            // Flat.
            mesh.normals.push([0.0; 3]);
        }
        let halves = [[0, 1, 2], [2, 3, 0]];
        let halves = halves.map(|half| half.map(|corner| first + corner));
        mesh.triangles.extend(halves);
    }
    mesh
}

/// The control points of a surface.
struct Surface([[DVec3; 4]; 4]);

fn surfaces() -> Vec<Surface> {
    let mut surfaces = Vec::new();
    for profile in [RIM, UPPER_BODY, LOWER_BODY] {
        surfaces.extend(turned(&profile, -1.0));
    }
    for tube in [UPPER_HANDLE, LOWER_HANDLE, SPOUT, SPOUT_TIP] {
        surfaces.extend(halves(&tube));
    }
    for profile in [KNOB, LID] {
        surfaces.extend(turned(&profile, -1.0));
    }
    surfaces.extend(turned(&BOTTOM, 1.0));
    surfaces
}

/// The four quarters of a profile that is turned, from above clockwise (-1) or counter-clockwise.
fn turned(profile: &Profile, direction: f64) -> [Surface; 4] {
    let side = DVec3::new(0.0, direction, 0.0);
    let mut ways = (DVec3::X, side);
    std::array::from_fn(|_| {
        let (from, to) = ways;
        ways = (to, -from);
        Surface(profile.map(|(radius, height, round)| {
            let points = [from, from + round * to, round * from + to, to];
            points.map(|point| radius * point + height * DVec3::Z)
        }))
    })
}

/// The two halves of a tube.
fn halves(tube: &Tube) -> [Surface; 2] {
    [-1.0, 1.0].map(|side| {
        Surface(tube.map(|([inner_x, inner_z], [outer_x, outer_z], width)| {
            let inner = DVec3::new(inner_x, 0.0, inner_z);
            let outer = DVec3::new(outer_x, 0.0, outer_z);
            let aside = side * width * DVec3::Y;
            let mut points = [inner, inner + aside, outer + aside, outer];
            if side > 0.0 {
                points.reverse();
            }
            points
        }))
    })
}

impl Surface {
    /// The point and the normal at a place of the surface, from 0 to 1 each way.
    fn at(&self, s: f64, t: f64) -> (DVec3, DVec3) {
        let mix = |along: DVec4, across: DVec4| -> DVec3 {
            let rows = self.0.map(|row| {
                let columns = row.into_iter().zip(across.to_array());
                columns.map(|(point, weight)| weight * point).sum::<DVec3>()
            });
            let rows = rows.into_iter().zip(along.to_array());
            rows.map(|(point, weight)| weight * point).sum()
        };
        let (s, s_slope) = bernstein(s);
        let (t, t_slope) = bernstein(t);
        let normal = mix(s, t_slope).cross(mix(s_slope, t));
        (mix(s, t), normal.normalize_or_zero())
    }

    /// Adds the triangles of `size` squares each way, except those with two corners on the axis,
    /// which have no area.
    fn triangles(&self, mesh: &mut Mesh, size: u32) {
        let first = mesh.positions.len() as u32;
        let place = |index: u32| f64::from(index) / f64::from(size);
        let mut on_axis = Vec::new();
        for (s, t) in (0..=size).flat_map(|s| (0..=size).map(move |t| (s, t))) {
            let (point, mut normal) = self.at(place(s), place(t));
            let is_on_axis = point.x.abs() <= ON_AXIS && point.y.abs() <= ON_AXIS;
            if is_on_axis {
                // The knob's end, or the bottom's.
                normal = if point.z > 1.5 { DVec3::Z } else { -DVec3::Z };
            }
            on_axis.push(is_on_axis);
            mesh.positions.push(point.as_vec3().to_array());
            mesh.normals.push(normal.as_vec3().to_array());
        }
        let at = |s: u32, t: u32| s * (size + 1) + t;
        for (s, t) in (0..size).flat_map(|s| (0..size).map(move |t| (s, t))) {
            let [a, b, c, d] = [at(s, t), at(s, t + 1), at(s + 1, t + 1), at(s + 1, t)];
            for corners in [[a, b, c], [c, d, a]] {
                let on_axis = corners.iter().filter(|&&corner| on_axis[corner as usize]);
                if on_axis.count() < 2 {
                    mesh.triangles.push(corners.map(|corner| first + corner));
                }
            }
        }
    }
}

/// Bernstein's polynomials of third degree, and their derivatives.
fn bernstein(at: f64) -> (DVec4, DVec4) {
    let powers = DVec4::new(1.0, at, at * at, at * at * at);
    let slopes = DVec4::new(0.0, 1.0, 2.0 * at, 3.0 * at * at);
    let coefficients = DMat4::from_cols_array(&[
        1.0, 0.0, 0.0, 0.0, -3.0, 3.0, 0.0, 0.0, 3.0, -6.0, 3.0, 0.0, -1.0, 3.0, -3.0, 1.0,
    ]);
    (coefficients * powers, coefficients * slopes)
}
