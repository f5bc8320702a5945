//! The kernels for textures: hits on textured triangles, texels, their cases and errors.

use twins::sphere_ray::Ray;
use twins::texture::{Hit, Level, Texel, Texture, filter, texel};

use super::isect::call;
use super::isect::error::SCALES;
use super::isect::shape::head_words;
use super::isect::sphere::FRONT;
use super::smooth;
use crate::prelude::*;
use protocol::layout::{SIDES_TEXTURED, TEXTURE_SIDE, Texels, WRAP_BITS};

/// The angle of a pixel, in the cases and for the errors.
const ANGLE: f64 = 1e-3;
/// A texture of one level of 64x64 texels.
const SMALL: f64 = 64.0;

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of([case("a packet", Objects::Fixed(1), |_| {
            let hit = Hit {
                vertices: [[-1.0, -1.0, -5.0], [1.0, -1.0, -5.0], [0.0, 1.0, -5.0]].map(point),
                coordinates: [[0.0, 1.0], [1.0, 1.0], [0.5, 0.0]].map(|it| it.map(from_f64)),
                point: point([0.0, 0.0, -5.0]),
                plane: point([0.0, 0.0, 1.0]),
                origin: [0; 3],
                direction: point([0.0, 0.0, -1.0]),
                t: from_f64(5.0),
            };
            Places { hits: [Some(hit); 16], table: small(), anything: 0 }
        })])
        .error(place_error),
        Kernel::of([case("a packet", Objects::Fixed(1), |_| {
            let lane = Filtered { texels: [0xff80_4000; 4], right: 0, down: 0, colour: [ONE; 3] };
            Filter { lanes: [Some(lane); 16], are_roots: true, anything: 0 }
        })])
        .error(filter_error),
    ]
}

/// A texture and its levels.
#[derive(Clone, Debug)]
pub struct Table {
    /// The texture.
    pub texture: Texture,
    /// Its levels.
    pub levels: Vec<Level>,
}

fn small() -> Table {
    table(&[(64, 64)], 0)
}

/// A table of levels of these sizes.
#[must_use]
pub fn table(sizes: &[(u32, u32)], wraps: u32) -> Table {
    let mut first = 0;
    let level = |&(width, height): &(u32, u32)| {
        let level = Level {
            width: from_f64(width.into()),
            height: from_f64(height.into()),
            across: width / 8 + 1,
            first,
        };
        first += level.across * (height / 8 + 1);
        level
    };
    let (width, height) = sizes[0];
    Table {
        texture: Texture {
            last: sizes.len() as u32 - 1,
            texels: from_f64(f64::from(width) * f64::from(height)),
            wraps,
        },
        levels: sizes.iter().map(level).collect(),
    }
}

/// The record of a patch. Without a hit its numbers are anything, and it has no texture.
fn record(hit: Option<&Hit>, anything: u32) -> layout::Patch {
    let vertices = hit.map_or([[anything; 3]; 3], |hit| hit.vertices);
    let coordinates = hit.map_or([[anything; 2]; 3], |hit| hit.coordinates);
    let [a, b, c] = [0, 1, 2].map(|corner| quad(vertices[corner], coordinates[corner][0]));
    let [normal_a, normal_b, normal_c] = coordinates.map(|[_, v]| quad([anything; 3], v));
    let textured = if hit.is_some() { SIDES_TEXTURED } else { 0 };
    let mut object = head_words([anything; 3], [anything; 3], anything, FRONT, anything);
    object[11] = U32::new(anything & !SIDES_TEXTURED | textured);
    let triangle = layout::Triangle { object, a, b, c };
    layout::Patch { triangle: zerocopy::transmute!(triangle), normal_a, normal_b, normal_c }
}

/// Hits of a packet, all on triangles with one texture. Lanes without a hit have one on something
/// without a texture: an object, or a material.
#[derive(Clone, Debug)]
pub struct Places {
    /// The hits.
    pub hits: [Option<Hit>; 16],
    /// The texture.
    pub table: Table,
    /// Fills everything else.
    pub anything: u32,
}

/// A texture of 20x36 texels with all of its levels, continued in any way, whose tiles come after
/// any number of others.
fn any_table(random: &mut ChaCha8Rng) -> Table {
    let sizes = [(20, 36), (10, 18), (5, 9), (2, 4), (1, 2), (1, 1)];
    table(&sizes, random.random_range(0..16 << 10))
}

impl Description for Places {
    const KERNEL: &'static str = "texture_places_r16";
    const ROUNDS: [usize; 2] = [300, 1000];
    const LENGTHS: &'static [usize] = &[1];
    /// All tiles are those of the texture.
    const SHARES: [Range<f64>; 2] = [1.0..1.1, 1.0..1.1];
    type Placed = Place;
    type Found = [Option<Texel>; 16];

    fn sensible(_: usize, random: &mut ChaCha8Rng) -> Self {
        let scale = SCALES[random.random_range(0..SCALES.len())];
        let hits = [(); 16].map(|()| random.random_ratio(3, 4).then(|| any_hit(random, scale)));
        Self { hits, table: any_table(random), anything: random.random() }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let hits = [(); 16].map(|()| Some(any_bits(random)));
        Self { hits, table: any_table(random), anything: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let Self { hits, table, anything } = self;
        let anything = *anything;
        let levels: Vec<layout::TextureLevel> = table
            .levels
            .iter()
            .map(|level| layout::TextureLevel {
                width: single(level.width),
                height: single(level.height),
                across: level.across.into(),
                first: level.first.into(),
            })
            .collect();
        let levels = put(bench, &levels);
        let texture = layout::Texture {
            levels: levels.address.into(),
            last: table.texture.last.into(),
            texels: single(table.texture.texels),
            wraps: table.texture.wraps.into(),
        };
        let texture = put(bench, &[texture]);
        let material = |texture: u32| layout::Material {
            texture: texture.into(),
            ..layout::Material::new_zeroed()
        };
        let materials = put(bench, &[material(0), material(texture.address)]);
        // Every second lane without a texture has it because of its material.
        let plain = |lane: usize| hits[lane].is_none() && lane.is_multiple_of(2);
        let known = Hit {
            vertices: [[0; 3]; 3],
            coordinates: [[0; 2]; 3],
            point: [0; 3],
            plane: [0; 3],
            origin: [0; 3],
            direction: [0; 3],
            t: 0,
        };
        let records: [layout::Patch; 16] = std::array::from_fn(|lane| {
            let hit = if plain(lane) { Some(&known) } else { hits[lane].as_ref() };
            record(hit, anything)
        });
        let records = put(bench, &records);
        let rays = std::array::from_fn(|lane| {
            let hit = hits[lane].unwrap_or(known);
            Ray {
                origin: hit.origin,
                direction: hit.direction,
                t: hit.t,
                object: address::<layout::Patch>(records, lane),
            }
        });
        let rays = put(bench, &[call::packet(&rays, anything)]);
        let mut surfaces = any_surfaces(anything);
        for (lane, hit) in hits.iter().enumerate() {
            let hit = hit.unwrap_or(known);
            let rows = &mut surfaces;
            [rows.point_x[lane], rows.point_y[lane], rows.point_z[lane]] = hit.point.map(single);
            [rows.plane_x[lane], rows.plane_y[lane], rows.plane_z[lane]] = hit.plane.map(single);
            let number = usize::from(!plain(lane));
            surfaces.material[lane] = address::<layout::Material>(materials, number).into();
        }
        let surfaces = put(bench, &[surfaces]);
        let texels = put(bench, &[any_texels(anything)]);
        let arguments = vec![rays.address, surfaces.address, texels.address, from_f64(ANGLE)];
        (texels, arguments)
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Self::Found {
        let texels: Texels = bench.read(*placed);
        std::array::from_fn(|lane| {
            let tile = texels.tile[lane].get();
            (tile != u32::MAX).then(|| Texel {
                tile,
                place: texels.place[lane].get(),
                right: bits(texels.right[lane]),
                down: bits(texels.down[lane]),
            })
        })
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let Table { texture, levels } = &self.table;
        self.hits.map(|hit| hit.map(|hit| texel(&hit, from_f64(ANGLE), texture, levels)))
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        let first = self.table.texture.wraps >> WRAP_BITS;
        let count = self.table.levels.last().map_or(0, |level| level.first + level.across);
        let texels = found.iter().flatten();
        let own = texels.clone().filter(|texel| (first..first + count).contains(&texel.tile));
        [own.count(), texels.count()]
    }
}

pub(super) fn any_surfaces(anything: u32) -> Surfaces {
    zerocopy::transmute!([U32::new(anything); size_of::<Surfaces>() / 4])
}

fn any_texels(anything: u32) -> Texels {
    zerocopy::transmute!([U32::new(anything); size_of::<Texels>() / 4])
}

/// A hit from the stated domain, in a scene scaled by `scale`.
pub fn any_hit(random: &mut ChaCha8Rng, scale: f64) -> Hit {
    let hit = smooth::any_hit(random, scale);
    let span = libm::exp2(random.random_range(-6.0..3.0));
    let middle: [f64; 2] = std::array::from_fn(|_| random.random_range(-2.0..2.0));
    let coordinates = std::array::from_fn(|_| {
        middle.map(|middle| from_f64(middle + span * random.random_range(-1.0..1.0)))
    });
    let distance = dot(hit.point.map(to_f64), hit.point.map(to_f64)).sqrt();
    let part = random.random_range(0.0..1.0);
    Hit {
        vertices: hit.patch.vertices,
        coordinates,
        point: hit.point,
        plane: hit.plane,
        origin: hit.point.map(|it| from_f64(part * to_f64(it))),
        direction: hit.direction,
        t: from_f64(distance),
    }
}

/// The texture coordinates of a hit, and the width of a pixel there in widths of the texture.
#[must_use]
pub fn truth(hit: &Hit, angle: f64) -> ([f64; 2], f64) {
    let wide = |it: [Single; 3]| -> Vector { it.map(to_f64) };
    let [a, b, c] = hit.vertices.map(wide);
    let p = wide(hit.point);
    let normal = cross(sub(b, a), sub(c, a));
    let part = |from: Vector, to: Vector| {
        dot(cross(sub(from, p), sub(to, p)), normal) / dot(normal, normal)
    };
    let shares = [part(b, c), part(c, a), part(a, b)];
    let coordinates = hit.coordinates.map(|it| it.map(to_f64));
    let place =
        [0, 1].map(|axis| (0..3).map(|corner| shares[corner] * coordinates[corner][axis]).sum());
    let edge = |corner: usize| [0, 1].map(|axis| coordinates[corner][axis] - coordinates[0][axis]);
    let (first, second) = (edge(1), edge(2));
    let area = (first[0] * second[1] - first[1] * second[0]).abs();
    let origin = wide(hit.origin);
    let far = dot(origin, origin).sqrt() + to_f64(hit.t);
    let cosine = dot(wide(hit.plane), wide(hit.direction)).abs();
    let stretch = (area / dot(normal, normal).sqrt()).sqrt();
    (place, stretch * far * angle / cosine)
}

/// The largest error of texture coordinates, of the size that the header names.
fn place_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..300 {
        for scale in SCALES {
            let hits = std::array::from_fn(|_| Some(any_hit(random, scale)));
            let inputs = Places { hits, table: small(), anything: random.random() };
            for (hit, found) in hits.iter().flatten().zip(inputs.call(bench).iter().flatten()) {
                worst = worst.max(off(hit, found) / size(hit));
            }
        }
    }
    worst
}

/// How far a texel of the small, clamped texture is off the hit's texture coordinates.
#[must_use]
pub fn off(hit: &Hit, found: &Texel) -> f64 {
    let (truth, _) = truth(hit, ANGLE);
    let across = 64 / 8 + 1;
    let column = 8 * (found.tile % across) + found.place / 4 % TEXTURE_SIDE;
    let row = 8 * (found.tile / across) + found.place / 4 / TEXTURE_SIDE;
    let places = [(column, found.right), (row, found.down)];
    (0..2)
        .map(|axis| {
            let (texel, part) = places[axis];
            let place = (f64::from(texel) + to_f64(part) - 0.5) / SMALL;
            (place - truth[axis].clamp(0.0, 1.0)).abs()
        })
        .fold(0.0, f64::max)
}

/// The largest texture coordinate, or 1, plus the largest difference between vertices.
fn size(hit: &Hit) -> f64 {
    let coordinates = hit.coordinates.map(|it| it.map(to_f64));
    let axis = |axis: usize| coordinates.map(|it| it[axis]);
    let span = |[a, b, c]: [f64; 3]| (a.max(b).max(c)) - (a.min(b).min(c));
    let largest = coordinates.as_flattened().iter().fold(0.0_f64, |sum, it| sum.max(it.abs()));
    span(axis(0)).max(span(axis(1))) + largest.max(1.0)
}

/// A surface and its four texels: left and right, above and below.
#[derive(Clone, Copy, Debug)]
pub struct Filtered {
    /// The texels' words.
    pub texels: [u32; 4],
    /// Part of the way to the right.
    pub right: Single,
    /// Part of the way down.
    pub down: Single,
    /// The surface's colour.
    pub colour: [Single; 3],
}

/// Puts surfaces and their texels into local store. Lanes without any have no texture, and colours
/// of `anything`.
fn put_filtered(
    bench: &mut Bench,
    lanes: &[Option<Filtered>; 16],
    are_roots: bool,
    anything: u32,
) -> (Vec<u32>, Place) {
    // Each lane's texels begin at another word of a quadword.
    let mut words = [[U32::new(anything); 15]; 16];
    for (words, lane) in words.iter_mut().zip(lanes) {
        let side = TEXTURE_SIDE as usize;
        for (place, texel) in
            [0, 1, side, side + 1].into_iter().zip(lane.map_or([0; 4], |it| it.texels))
        {
            words[place] = texel.into();
        }
    }
    let words = put(bench, &words.map(Words));
    let mut texels = any_texels(anything);
    for (lane, filtered) in lanes.iter().enumerate() {
        texels.tile[lane] = if filtered.is_some() { 7 } else { u32::MAX }.into();
        texels.place[lane] = address::<Words>(words, lane).into();
        let filtered = filtered.as_ref();
        texels.right[lane] = single(filtered.map_or(anything, |it| it.right));
        texels.down[lane] = single(filtered.map_or(anything, |it| it.down));
    }
    let texels = put(bench, &[texels]);
    let surfaces = put(bench, &[coloured(lanes, anything)]);
    let are_roots = if are_roots { u32::MAX } else { 0 };
    (vec![texels.address, surfaces.address, are_roots], surfaces)
}

/// The texels of a lane.
#[derive(Clone, Copy, zerocopy::FromBytes, zerocopy::IntoBytes, zerocopy::Immutable)]
#[repr(transparent)]
struct Words([U32; 15]);

/// Surfaces with the lanes' colours, and `anything` otherwise.
#[must_use]
pub fn coloured(lanes: &[Option<Filtered>; 16], anything: u32) -> Surfaces {
    let mut surfaces = any_surfaces(anything);
    for (lane, filtered) in lanes.iter().enumerate() {
        if let Some(filtered) = filtered {
            set_colour(&mut surfaces, lane, filtered.colour);
        }
    }
    surfaces
}

/// Sets the colour of a lane.
pub fn set_colour(surfaces: &mut Surfaces, lane: usize, colour: [Single; 3]) {
    [surfaces.red[lane], surfaces.green[lane], surfaces.blue[lane]] = colour.map(single);
}

/// Lanes of a packet with texels.
#[derive(Clone, Debug)]
pub struct Filter {
    /// The lanes.
    pub lanes: [Option<Filtered>; 16],
    /// Whether the texels are square roots of light.
    pub are_roots: bool,
    /// Fills everything else.
    pub anything: u32,
}

impl Description for Filter {
    const KERNEL: &'static str = "texture_filter_r16";
    const ROUNDS: [usize; 2] = [500, 500];
    const LENGTHS: &'static [usize] = &[1];
    type Placed = Place;
    type Found = Bits<Surfaces>;

    fn sensible(_: usize, random: &mut ChaCha8Rng) -> Self {
        let lanes = [(); 16].map(|()| random.random_ratio(3, 4).then(|| any_filtered(random)));
        Self { lanes, are_roots: random.random(), anything: random.random() }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let mut inputs = Self::sensible(0, random);
        for lane in inputs.lanes.iter_mut().flatten() {
            (lane.right, lane.down, lane.colour) = random.random();
        }
        inputs
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let (arguments, surfaces) = put_filtered(bench, &self.lanes, self.are_roots, self.anything);
        (surfaces, arguments)
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Bits<Surfaces> {
        Bits(bench.read(*placed))
    }

    fn twin(&self, _: &Place) -> Bits<Surfaces> {
        let mut expected = coloured(&self.lanes, self.anything);
        for (lane, given) in self.lanes.iter().enumerate() {
            if let Some(Filtered { texels, right, down, colour }) = *given {
                let colour = filter(colour, texels, self.are_roots, right, down);
                set_colour(&mut expected, lane, colour);
            }
        }
        Bits(expected)
    }
}

/// Any surface and texels of the stated domain.
pub fn any_filtered(random: &mut ChaCha8Rng) -> Filtered {
    Filtered {
        texels: random.random(),
        right: from_f64(random.random_range(0.0..1.0)),
        down: from_f64(random.random_range(0.0..1.0)),
        colour: std::array::from_fn(|_| from_f64(random.random_range(0.0..1.0))),
    }
}

/// The largest error of a channel, of 1.
fn filter_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for round in 0..2000 {
        let lanes = std::array::from_fn(|_| Some(any_filtered(random)));
        let power = 1 + round % 2;
        let anything = random.random();
        let Bits(surfaces) = Filter { lanes, are_roots: power == 2, anything }.call(bench);
        for (lane, given) in lanes.iter().flatten().enumerate() {
            let rows = [surfaces.red, surfaces.green, surfaces.blue];
            for (channel, row) in rows.iter().enumerate() {
                let [a, b, c, d] = given
                    .texels
                    .map(|texel| f64::from(texel >> (24 - 8 * channel) & 255) / 255.0)
                    .map(|part| part.powi(power));
                let (right, down) = (to_f64(given.right), to_f64(given.down));
                let above = a + right * (b - a);
                let below = c + right * (d - c);
                let exact = (above + down * (below - above)) * to_f64(given.colour[channel]);
                worst = worst.max((to_f64(bits(row[lane])) - exact).abs());
            }
        }
    }
    worst
}
