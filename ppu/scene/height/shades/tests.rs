//! The states of cells, compared with all the triangles that a ray to the light could meet.

use glam::DVec3;
use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use scenes::{HeightField, HeightRegion, HeightSample};

use super::{Cells, ENDLESS, SIDE, Shades, Sun, bit};
use crate::scene::height::samples::Four;

/// A field of a few waves and of noise.
fn field(size: [u32; 2], random: &mut ChaCha8Rng) -> HeightField {
    let waves: [[f64; 3]; 3] =
        std::array::from_fn(|_| std::array::from_fn(|_| random.random_range(-0.4..0.4)));
    let noise = random.random_range(0.0..500.0);
    let heights = (0..size[0] * size[1]).map(|at| {
        let [x, z] = [at % size[0], at / size[0]].map(f64::from);
        let wave = |[a, b, c]: [f64; 3]| 2000.0 * c * libm::sin(a * x + b * z + c);
        let height = 3000.0 + waves.map(wave).iter().sum::<f64>();
        (height + noise * random.random::<f64>()) as u16
    });
    HeightField::new(size, heights.collect(), Vec::new(), 2.0, 0.01).expect("a field")
}

/// A light from anywhere, also along a side of the field or near the horizon.
fn to_light(random: &mut ChaCha8Rng) -> DVec3 {
    let mut part = |most: f64| random.random_range(-most..most);
    let height = part(1.0).abs().powi(2) + 0.01;
    let [mut x, mut z] = [part(1.0), part(1.0)];
    match random.random_range(0..6) {
        0 => x = 0.0,
        1 => z = 0.0,
        2 => z = x,
        _ => (),
    }
    DVec3::new(x, height, z).normalize().as_vec3().as_dvec3()
}

/// The height of the triangles at a place that is given in squares.
fn ground(field: &HeightField, x: f64, z: f64) -> f64 {
    let [columns, rows] = field.size().map(|side| f64::from(side) - 2.0);
    let [column, row] = [x.floor().clamp(0.0, columns), z.floor().clamp(0.0, rows)];
    let at = |right: i64, down: i64| {
        f64::from(field.sample(column as i64 + right, row as i64 + down)) * field.unit()
    };
    let (x, z) = (x - column, z - row);
    let [first, last] = [at(0, 0), at(1, 1)];
    if x > z {
        first + x * (at(1, 0) - first) + z * (last - at(1, 0))
    } else {
        first + z * (at(0, 1) - first) + x * (last - at(0, 1))
    }
}

/// By how much the highest ground before a point is above its ray to the light, between distances.
fn above(field: &HeightField, point: DVec3, to_light: DVec3, from: f64, to: f64) -> f64 {
    let [columns, rows] = field.size().map(|side| f64::from(side) - 1.0);
    let way = to_light / field.step();
    let mut crossings = Vec::new();
    for number in -i32::from(u16::MAX >> 8)..=255 {
        // Sides of squares, and the diagonals.
        let number = f64::from(number);
        crossings.push((number - point.x) / way.x);
        crossings.push((number - point.z) / way.z);
        crossings.push((number - (point.x - point.z)) / (way.x - way.z));
    }
    let inside = |t: &f64| {
        let [x, z] = [point.x + t * way.x, point.z + t * way.z];
        let within = |at: f64, last: f64| (-1e-9..=last + 1e-9).contains(&at);
        *t > from && *t <= to && within(x, columns) && within(z, rows)
    };
    let heights = crossings.into_iter().filter(|t| t.is_finite()).filter(inside).map(|t| {
        ground(field, point.x + t * way.x, point.z + t * way.z) - point.y - t * to_light.y
    });
    heights.fold(f64::MIN, f64::max)
}

/// A point's state by the cell of a level: whether it is lit, whether it is dark, and how far away
/// the ground may hide the light otherwise. Places are computed as SPUs do.
fn state(shades: &Shades, field: &HeightField, level: usize, point: DVec3) -> (bool, bool, f64) {
    let eye = DVec3::new(3.3, 9.0, -4.7);
    let record = shades.sun.record(field, eye);
    let at = (field.corner + DVec3::new(point.x, 0.0, point.z) * field.step()) - eye;
    let at = at.with_y(point.y + field.corner.y - eye.y).as_vec3();
    let [line, place] = [record.line, record.place]
        .map(|of| of.map(f32::from))
        .map(|[x, start, z, _]| at.x * x + start + at.z * z);
    let [slant, shift, fall, start] = record.lane.map(f32::from);
    let lane = place - line * slant + shift;
    let height = at.y + line * fall + start;
    let [line, lane] = [line, lane].map(|at| at as usize >> level);
    let index = shades.sun.index(level, line / SIDE, lane / SIDE).expect("a block");
    let cells = Cells::of(Four(shades.memory[index].0));
    let is_lit = cells.lit & bit(line, lane) != 0 || height > cells.high;
    let lines = (cells.reach as usize + line % SIDE + 1) << level;
    let is_endless = cells.reach == ENDLESS;
    let end = if is_endless { f64::INFINITY } else { lines as f64 * shades.sun.length };
    (is_lit, !is_lit && height < cells.low, end)
}

/// Checks a point's state by the cells of each level against the ground before it. Returns whether
/// it is lit and whether it is dark by the first level.
fn check(shades: &Shades, field: &HeightField, to_light: DVec3, point: DVec3) -> (bool, bool) {
    let hidden = above(field, point, to_light, 0.0, f64::INFINITY);
    let states = [0, 1, 2].map(|level| {
        let (is_lit, is_dark, end) = state(shades, field, level, point);
        let what = format!("level {level}: {:?} {to_light} {point}", field.size());
        assert!(!is_lit || hidden <= 0.0, "{what} is said to be lit: {hidden}");
        assert!(!is_dark || hidden > 0.0, "{what} is said to be dark: {hidden}");
        if !is_lit && !is_dark {
            let near = above(field, point, to_light, 0.0, end);
            let is_right = (near > 0.0) == (hidden > 0.0);
            assert!(is_right, "{what} is said to be free from {end} on: {hidden}");
        }
        (is_lit, is_dark)
    });
    states[0]
}

#[test]
fn states_of_cells_hold() {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let (mut lit, mut dark, mut points) = (0, 0, 0);
    for round in 0..60 {
        let mut side = || random.random_range(2..90);
        let size = [side(), side()];
        let mut field = field(size, &mut random);
        let to_light = to_light(&mut random);
        let Some(sun) = Sun::new(&field, to_light) else {
            continue;
        };
        let mut shades = Shades::new(&field, sun);
        if round % 2 == 1 {
            let mut range = |count: u32| {
                let start = random.random_range(0..count);
                start..random.random_range(start..count) + 1
            };
            let region = HeightRegion { columns: range(size[0]), rows: range(size[1]) };
            field.shape(&region, |_, was| HeightSample { height: was.height ^ 0x300, ..was });
            shades.update(&field, &region);
            assert!(shades == Shades::new(&field, sun), "round {round}: {size:?}, {region:?}");
        }
        for _ in 0..1000 {
            let mut along = |side: u32| random.random::<f64>() * f64::from(side - 1);
            let [x, z] = size.map(&mut along);
            let high = [0.0, 0.0, 0.3, 3.0][random.random_range(0..4)] * random.random::<f64>();
            let point = DVec3::new(x, ground(&field, x, z) + high + 1e-3, z);
            let (is_lit, is_dark) = check(&shades, &field, to_light, point);
            lit += u32::from(is_lit);
            dark += u32::from(is_dark);
            points += 1;
        }
    }
    println!("{lit} lit and {dark} dark of {points}");
    assert!(lit * 4 > points && dark * 20 > points, "{lit} lit and {dark} dark of {points}");
}

/// Points in the shadow of a summit of one sample, or of a wall with a notch of one sample, which
/// are higher or lower than the ground between the sides of a lane.
#[test]
fn bends_in_lanes_count() {
    const SIDE: u32 = 40;
    const MIDDLE: u32 = SIDE / 2;
    let mut random = ChaCha8Rng::seed_from_u64(2);
    for round in 0..300 {
        let is_summit = round % 2 == 0;
        let heights = (0..SIDE * SIDE).map(|at| {
            let is_middle = at == MIDDLE * SIDE + MIDDLE;
            let is_wall = !is_summit && at % SIDE == MIDDLE;
            100 + 400 * u16::from(is_wall && !is_middle) + 200 * u16::from(is_middle)
        });
        let field = HeightField::new([SIDE; 2], heights.collect(), Vec::new(), 2.0, 0.01);
        let field = field.expect("a field");
        let mut part = |range: std::ops::Range<f64>| random.random_range(range);
        let to_light = DVec3::new(1.0, part(0.1..0.4), part(-0.9..0.9)).normalize();
        let to_light = to_light.as_vec3().as_dvec3();
        let shades = Shades::new(&field, Sun::new(&field, to_light).expect("a sun"));
        let sample = DVec3::splat(f64::from(MIDDLE)).with_y(3.0);
        let away = part(1.0..10.0) * to_light / DVec3::new(2.0, 1.0, 2.0);
        let point = sample - away + part(-0.3..0.3) * DVec3::Y;
        if point.y > ground(&field, point.x, point.z) + 1e-3 {
            check(&shades, &field, to_light, point);
        }
    }
}
