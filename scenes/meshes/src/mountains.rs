//! Generates mountains with lakes: a height field of noise that is flatter where it is steep, as
//! if water had worn it.
//!
//! Invariant: the same level gives the same numbers on every host.

use std::sync::Arc;

use glam::{DMat2, DVec2, DVec3};
use scenes::daylight::{AMBIENT, HORIZON, SUN};
use scenes::{Fog, HeightField, Light, LightKind, Material, Object, Scene, Shape, Sky, View};

use crate::terrain::lattice;
use crate::{Fault, Loaded};

/// The prefix of the name of generated mountains: `mountains:LEVEL`.
pub(crate) const PREFIX: &str = "mountains:";
/// The smallest level, of 64 by 64 squares.
const MIN_LEVEL: u32 = 6;
/// The largest level.
const MAX_LEVEL: u32 = 12;
/// The distance between samples, in metres.
const STEP: f64 = 10.0;
/// The length of a height of 1.
const UNIT: f64 = 0.05;
/// The side of the largest mountains, in samples.
const LARGEST: f64 = 420.0;
/// The height of the highest summits.
const SUMMITS: f64 = 2000.0;
/// The height of the lakes.
pub const LAKES: f64 = 480.0;
/// Haze, which leaves half of the light at 28 km.
pub const HAZE: Fog = Fog { colour: HORIZON, density: 2.5e-5 };
/// Octaves of noise, the last one about two samples large.
const OCTAVES: usize = 9;
/// What an octave's place is turned and scaled by, so that lattices don't coincide.
const TURNED: DMat2 = DMat2::from_cols_array(&[1.6, 1.2, -1.2, 1.6]);

/// Mountains of 2^level by 2^level squares, with a lake, a sun and a sky.
pub(crate) fn generate(name: &str, level: &str) -> Result<Loaded, Fault> {
    let level = level.parse().ok().filter(|level| (MIN_LEVEL..=MAX_LEVEL).contains(level));
    let level: u32 = level.ok_or(Fault::Mountains { minimum: MIN_LEVEL, maximum: MAX_LEVEL })?;
    let field = field(1 << level);
    let (low, high) = field.bounds();
    let water = Shape::Polygon {
        vertices: [(low.x, low.z), (low.x, high.z), (high.x, high.z), (high.x, low.z)]
            .map(|(x, z)| DVec3::new(x, LAKES, z))
            .to_vec(),
    };
    let from = DVec3::new(-0.2 * high.x, 0.0, 0.6 * high.z);
    let from = DVec3::new(from.x, field.ground(from).max(LAKES) + 700.0, from.z);
    let view = View {
        from,
        at: from + DVec3::new(300.0, -330.0, -1000.0),
        up: DVec3::Y,
        angle: 42.0,
        hither: 0.0,
        resolution: (1280, 720),
    };
    let materials = vec![Material::matte(DVec3::ONE), lake()];
    let objects = vec![Object { line: 0, material: 1, shape: water }];
    let mut scene = lit(name.to_owned(), view, field, materials, objects);
    scene.fog = Some(HAZE);
    Ok(Loaded { scene, added_light: false, animation: None, notes: Vec::new() })
}

/// Ground and what is on it by day.
pub(crate) fn lit(
    name: String,
    view: View,
    field: HeightField,
    materials: Vec<Material>,
    objects: Vec<Object>,
) -> Scene {
    Scene {
        name,
        view,
        background: HORIZON,
        sky: Some(Sky::of_day(DVec3::Y)),
        fog: None,
        ambient: AMBIENT,
        lights: vec![Light {
            line: 0,
            kind: LightKind::Directional { to_light: DVec3::new(-0.8, 0.55, -0.25) },
            colour: Some(SUN),
        }],
        materials,
        objects,
        mesh: None,
        heights: Some(Arc::new(field)),
        height_map: None,
    }
}

/// Water that shows the sky and the mountains.
#[must_use]
pub fn lake() -> Material {
    Material {
        diffuse: 0.35,
        specular: 0.6,
        shine: 200.0,
        ..Material::matte(DVec3::new(0.10, 0.22, 0.30))
    }
}

/// The height field of mountains with `squares` by `squares` squares of 10 m, without a scene.
///
/// # Panics
/// There is no such height field: `squares` is 0 or more than 4096.
#[must_use]
pub fn field(squares: u32) -> HeightField {
    let side = squares + 1;
    let half = f64::from(squares) / 2.0;
    let mut metres = Vec::with_capacity((side * side) as usize);
    let mut cells = Cells::default();
    for row in 0..side {
        for column in 0..side {
            let place = DVec2::new(f64::from(column), f64::from(row)) - half;
            metres.push(height(place, &mut cells));
        }
    }
    let colours = colours([side; 2], &metres, STEP, |height| height);
    let heights = metres.iter().map(|height| (height / UNIT).clamp(0.0, 65535.0) as u16);
    HeightField::new([side; 2], heights.collect(), colours, STEP, UNIT)
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The colours of ground by its heights and slopes. `metres` is the height in these mountains where
/// the ground would have the same colour.
pub(crate) fn colours(
    [columns, rows]: [u32; 2],
    heights: &[f64],
    step: f64,
    metres: impl Fn(f64) -> f64,
) -> Vec<[u8; 3]> {
    let at = |column: u32, row: u32| {
        heights[row.min(rows - 1) as usize * columns as usize + column.min(columns - 1) as usize]
    };
    let colour = |column: u32, row: u32| {
        let east = at(column + 1, row) - at(column.saturating_sub(1), row);
        let south = at(column, row + 1) - at(column, row.saturating_sub(1));
        let slope = DVec2::new(east, south).length() / (2.0 * step);
        colour(metres(at(column, row)), slope, lattice(column, row, 77))
    };
    (0..rows)
        .flat_map(|row| (0..columns).map(move |column| (column, row)))
        .map(|(column, row)| colour(column, row))
        .collect()
}

/// The colour of ground at a height in metres, with a slope of its tangent, and a grain from 0 to
/// 1: sand at lakes, then woods, meadows, rock and snow, and on slopes rock.
fn colour(height: f64, slope: f64, grain: f64) -> [u8; 3] {
    let ease = |from: f64, to: f64, at: f64| {
        let part = ((at - from) / (to - from)).clamp(0.0, 1.0);
        part * part * (3.0 - 2.0 * part)
    };
    let height = height + 120.0 * (grain - 0.5);
    let sand = DVec3::new(0.62, 0.56, 0.44);
    let wood = DVec3::new(0.20, 0.30, 0.14);
    let meadow = DVec3::new(0.40, 0.47, 0.22);
    let rock = DVec3::new(0.47, 0.43, 0.40);
    let snow = DVec3::new(0.95, 0.96, 0.98);
    let mut colour = sand.lerp(wood, ease(LAKES + 5.0, LAKES + 50.0, height));
    colour = colour.lerp(meadow, ease(700.0, 950.0, height));
    colour = colour.lerp(rock, ease(1050.0, 1300.0, height));
    colour = colour.lerp(rock * 0.9, ease(0.65, 1.0, slope));
    colour = colour.lerp(snow, ease(1200.0, 1450.0, height) * (1.0 - ease(0.8, 1.25, slope)));
    (255.0 * colour * (0.93 + 0.1 * grain)).to_array().map(|part| part.clamp(0.0, 255.0) as u8)
}

/// The height of a place, whose unit is the distance between samples. An octave is the lower, the
/// steeper the octaves before it are there (Quilez, Elevated, 2008).
fn height(place: DVec2, cells: &mut Cells) -> f64 {
    let mut place = place / LARGEST;
    let (mut sum, mut slope, mut share) = (0.0, DVec2::ZERO, 1.0);
    for (octave, cell) in cells.iter_mut().enumerate() {
        let (value, steepness) = noise(place, octave as u32, cell);
        slope += steepness;
        sum += share * value / (1.0 + slope.length_squared());
        share *= 0.5;
        place = TURNED * place;
    }
    SUMMITS * sum
}

/// For each octave, the corner and the numbers of the lattice's cell that the last place was in.
/// Most places of a row are in the same one as the place before.
type Cells = [Option<([i32; 2], [f64; 4])>; OCTAVES];

/// Noise from 0 to 1, and its slope.
fn noise(place: DVec2, octave: u32, cell: &mut Option<([i32; 2], [f64; 4])>) -> (f64, DVec2) {
    let corner = place.floor();
    let part = place - corner;
    let ease = part * part * part * (part * (part * 6.0 - 15.0) + 10.0);
    let rise = 30.0 * part * part * (part * (part - 2.0) + 1.0);
    let (x, y) = (corner.x as i32, corner.y as i32);
    let [a, b, c, d] = match *cell {
        Some((of, numbers)) if of == [x, y] => numbers,
        _ => {
            let at = |x: i32, y: i32| lattice(x as u32, y as u32, octave);
            let numbers = [at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)];
            *cell = Some(([x, y], numbers));
            numbers
        }
    };
    let twist = a - b - c + d;
    let value = a + (b - a) * ease.x + (c - a) * ease.y + twist * ease.x * ease.y;
    let slope = rise * DVec2::new(b - a + twist * ease.y, c - a + twist * ease.x);
    (value, slope)
}
