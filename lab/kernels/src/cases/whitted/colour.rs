//! The kernel for colours of vertices: hits on coloured triangles, its case and its error.

use twins::colour::{Hit, interpolated};
use twins::sphere_ray::Ray;

use super::isect::call;
use super::isect::error::SCALES;
use super::isect::shape::head_words;
use super::isect::sphere::FRONT;
use super::smooth;
use super::texture::{any_surfaces, set_colour};
use crate::prelude::*;
use protocol::layout::{SIDES_COLOURED, SIDES_VISIBILITY};

/// Patches of a batch.
const PATCHES: usize = 128;
/// The largest value of a packed channel.
const MOST: f64 = 1023.0;

/// The kernel in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of([case("a packet", Objects::Fixed(1), |_| {
            let hit = Hit {
                vertices: [[-1.0, -1.0, -5.0], [1.0, -1.0, -5.0], [0.0, 1.0, -5.0]].map(point),
                colours: [0xff80_4000, 0x0123_4567, 0x89ab_cdef],
                point: point([0.0, 0.0, -5.0]),
                plane: point([0.0, 0.0, 1.0]),
                colour: [ONE; 3],
            };
            let known = [Some(5); 16];
            Coloured { hits: [Some(hit); 16], known, are_roots: true, anything: 0 }
        })])
        .error(error),
    ]
}

/// The patch of each lane: they are anywhere among those of a batch.
fn slot(lane: usize) -> usize {
    lane * 37 % PATCHES
}

fn record(hit: Option<&Hit>, is_known: bool, anything: u32) -> layout::Patch {
    let vertices = hit.map_or([[anything; 3]; 3], |hit| hit.vertices);
    let [a, b, c] = vertices.map(|vertex| quad(vertex, anything));
    let coloured = if hit.is_some() { SIDES_COLOURED } else { 0 };
    let mut object = head_words([anything; 3], [anything; 3], anything, FRONT, anything);
    let known = if is_known { SIDES_VISIBILITY } else { 0 };
    let sides = anything & !(SIDES_COLOURED | SIDES_VISIBILITY) | coloured | known;
    object[11] = U32::new(sides);
    let triangle = layout::Triangle { object, a, b, c };
    let [normal_a, normal_b, normal_c] = [quad([anything; 3], anything); 3];
    layout::Patch { triangle: zerocopy::transmute!(triangle), normal_a, normal_b, normal_c }
}

/// Hits of a packet. Lanes without one hit something without colours.
#[derive(Clone, Debug)]
pub struct Coloured {
    /// The hits.
    pub hits: [Option<Hit>; 16],
    /// The visibility of lights there, if it is known.
    pub known: [Option<u32>; 16],
    /// Whether the vertices' colours are square roots of light.
    pub are_roots: bool,
    /// Fills everything else.
    pub anything: u32,
}

impl Description for Coloured {
    const KERNEL: &'static str = "colour_vertices_r16";
    const ROUNDS: [usize; 2] = [300, 1000];
    const LENGTHS: &'static [usize] = &[1];
    type Placed = [Place; 2];
    type Found = (Bits<Surfaces>, [u32; 16], u32);

    fn sensible(_: usize, random: &mut ChaCha8Rng) -> Self {
        let scale = SCALES[random.random_range(0..SCALES.len())];
        let hits = [(); 16].map(|()| random.random_ratio(3, 4).then(|| any_hit(random, scale)));
        let known = [(); 16].map(|()| random.random_ratio(1, 2).then(|| random.random()));
        Self { hits, known, are_roots: random.random(), anything: random.random() }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let hits = [(); 16].map(|()| Some(any_bits(random)));
        let known = [(); 16].map(|()| Some(random.random()));
        Self { hits, known, are_roots: random.random(), anything: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> ([Place; 2], Vec<u32>) {
        let Self { hits, known, are_roots, anything } = self;
        let anything = *anything;
        let mut patches = [record(None, false, anything); PATCHES];
        let mut colours = [[U32::new(anything); 4]; PATCHES];
        for (lane, hit) in hits.iter().enumerate() {
            patches[slot(lane)] = record(hit.as_ref(), known[lane].is_some(), anything);
            let words = hit.map_or([anything; 3], |hit| hit.colours);
            let [a, b, c] = words.map(U32::new);
            colours[slot(lane)] = [a, b, c, U32::new(known[lane].unwrap_or(anything))];
        }
        let patches = put(bench, &patches);
        let colours = put(bench, &colours);
        let rays = std::array::from_fn(|lane| Ray {
            origin: [anything; 3],
            direction: [anything; 3],
            t: anything,
            object: address::<layout::Patch>(patches, slot(lane)),
        });
        let rays = put(bench, &[call::packet(&rays, anything)]);
        let surfaces = put(bench, &[surfaces(hits, anything)]);
        let found = put(bench, &[[U32::new(anything); 16]]);
        let are_roots = if *are_roots { u32::MAX } else { 0 };
        let arguments = [rays, surfaces, colours, patches].map(|place| place.address);
        ([surfaces, found], [&arguments[..], &[are_roots, found.address]].concat())
    }

    fn found(&self, bench: &Bench, placed: &[Place; 2], returned: u32) -> Self::Found {
        let known: [U32; 16] = bench.read(placed[1]);
        (Bits(bench.read(placed[0])), known.map(U32::get), returned)
    }

    fn twin(&self, _: &[Place; 2]) -> Self::Found {
        let mut expected = surfaces(&self.hits, self.anything);
        for (lane, hit) in self.hits.iter().enumerate() {
            if let Some(hit) = hit {
                set_colour(&mut expected, lane, interpolated(hit, self.are_roots));
            }
        }
        let known = self.known.map(Option::unwrap_or_default);
        (Bits(expected), known, known.iter().fold(0, |all, mask| all | mask))
    }
}

/// The surfaces of these hits, and `anything` otherwise.
#[must_use]
pub fn surfaces(hits: &[Option<Hit>; 16], anything: u32) -> Surfaces {
    let mut surfaces = any_surfaces(anything);
    for (lane, hit) in hits.iter().enumerate() {
        let Some(hit) = hit else { continue };
        let rows = &mut surfaces;
        [rows.point_x[lane], rows.point_y[lane], rows.point_z[lane]] = hit.point.map(single);
        [rows.plane_x[lane], rows.plane_y[lane], rows.plane_z[lane]] = hit.plane.map(single);
        set_colour(rows, lane, hit.colour);
    }
    surfaces
}

/// A hit from the stated domain, in a scene scaled by `scale`.
pub fn any_hit(random: &mut ChaCha8Rng, scale: f64) -> Hit {
    let hit = smooth::any_hit(random, scale);
    Hit {
        vertices: hit.patch.vertices,
        colours: random.random(),
        point: hit.point,
        plane: hit.plane,
        colour: std::array::from_fn(|_| from_f64(random.random_range(0.0..1.0))),
    }
}

/// The colour of a hit.
fn truth(hit: &Hit, are_roots: bool) -> [f64; 3] {
    let wide = |it: [Single; 3]| -> Vector { it.map(to_f64) };
    let [a, b, c] = hit.vertices.map(wide);
    let p = wide(hit.point);
    let normal = cross(sub(b, a), sub(c, a));
    let part = |from: Vector, to: Vector| {
        dot(cross(sub(from, p), sub(to, p)), normal) / dot(normal, normal)
    };
    let shares = [part(b, c), part(c, a), part(a, b)];
    std::array::from_fn(|channel| {
        let light = hit.colours.map(|packed| {
            let value = f64::from(packed >> (22 - 10 * channel) & 1023) / MOST;
            if are_roots { value * value } else { value }
        });
        let mixed: f64 = (0..3).map(|corner| shares[corner] * light[corner]).sum();
        mixed * to_f64(hit.colour[channel])
    })
}

/// The largest error of a channel, of 1.
fn error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for round in 0..300 {
        let are_roots = round % 2 == 0;
        for scale in SCALES {
            let hits: [Hit; 16] = std::array::from_fn(|_| any_hit(random, scale));
            let anything = random.random();
            let hits_of = hits.map(Some);
            let call = Coloured { hits: hits_of, known: [None; 16], are_roots, anything };
            let (Bits(surfaces), ..) = call.call(bench);
            let rows = [surfaces.red, surfaces.green, surfaces.blue];
            for (lane, hit) in hits.iter().enumerate() {
                for (row, exact) in rows.iter().zip(truth(hit, are_roots)) {
                    worst = worst.max((to_f64(bits(row[lane])) - exact).abs());
                }
            }
        }
    }
    worst
}
