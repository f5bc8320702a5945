//! Generates a fractal terrain: a height field of smooth noise in octaves.
//!
//! Invariant: the same level gives the same numbers on every host.

use glam::{DVec2, DVec3, Vec3};
use scenes::{Light, LightKind, View};

use crate::builder::{Builder, Vertex};
use crate::{Fault, MAX_TRIANGLES};

/// The prefix of a generated terrain's name: `terrain:LEVEL`.
pub(crate) const PREFIX: &str = "terrain:";
/// The largest level, which has [`MAX_TRIANGLES`].
const MAX_LEVEL: u32 = 11;
/// Half of the terrain's side.
const HALF: f64 = 10.0;
/// Sides of the largest hills, as parts of the terrain.
const HILLS: f64 = 4.0;
/// The height of the largest hills.
const HEIGHT: f64 = 4.0;
/// Octaves of noise. The smallest is about as large as a square of the largest level.
const OCTAVES: u32 = 10;
/// The height of an octave relative to the one before.
const ROUGHNESS: f64 = 0.45;
/// Above this height there is snow where it is not steep.
const SNOW: f32 = 2.3;
/// Cosine of the slope from which on there is only rock.
const STEEP: f32 = 0.82;

const _: () = assert!(2 << (2 * MAX_LEVEL) == MAX_TRIANGLES);

/// Generates 2^level by 2^level squares of two triangles each.
pub(crate) fn generate(level: &str, builder: &mut Builder) -> Result<(), Fault> {
    let found = level.parse::<u32>().ok();
    let found = found.filter(|&level| level <= MAX_LEVEL);
    let Some(level) = found else {
        return Err(Fault::Level { most: MAX_LEVEL });
    };
    let side = 1_u32 << level;
    let colours = [[0.30, 0.45, 0.16], [0.44, 0.40, 0.36], [0.93, 0.94, 0.97]];
    let [grass, rock, snow] =
        colours.map(|colour| builder.material(scenes::Material::matte(colour.into()), None));
    let (grass, rock, snow) = (grass?, rock?, snow?);

    let coordinate = |step: u32| (2.0 * f64::from(step) / f64::from(side) - 1.0) * HALF;
    let mut positions = Vec::with_capacity(((side + 1) * (side + 1)) as usize);
    for row in 0..=side {
        for column in 0..=side {
            let (x, z) = (coordinate(column), coordinate(row));
            positions.push(DVec3::new(x, height(DVec2::new(x, z)), z).as_vec3().to_array());
        }
    }
    for &position in &positions {
        builder
            .vertex(&Vertex { position: position.map(f64::from).into(), ..Vertex::default() })?;
    }
    for row in 0..side {
        for column in 0..side {
            let a = row * (side + 1) + column;
            let (b, c) = (a + 1, a + side + 1);
            for triangle in [[a, c, b], [b, c, c + 1]] {
                let [p, q, r] = triangle.map(|vertex| Vec3::from(positions[vertex as usize]));
                let up = (q - p).cross(r - p).normalize().y;
                let material = if up < STEEP {
                    rock
                } else if (p.y + q.y + r.y) / 3.0 > SNOW {
                    snow
                } else {
                    grass
                };
                builder.triangle(triangle, material)?;
            }
        }
    }
    builder.view = Some(View {
        from: DVec3::new(-8.5, 5.2, 9.0),
        at: DVec3::new(1.0, 1.0, -1.5),
        up: DVec3::Y,
        angle: 42.0,
        hither: 0.0,
        resolution: (1280, 720),
    });
    builder.lights.push(Light {
        line: 0,
        kind: LightKind::Directional { to_light: DVec3::new(0.9, 0.6, 0.35) },
        colour: Some(DVec3::new(1.0, 0.95, 0.85)),
    });
    Ok(())
}

fn height(place: DVec2) -> f64 {
    let mut sum = 0.0;
    let (mut scale, mut share) = (HILLS / (2.0 * HALF), 1.0);
    for octave in 0..OCTAVES {
        sum += share * noise(place * scale, octave);
        scale *= 2.0;
        share *= ROUGHNESS;
    }
    HEIGHT * sum * (1.0 - ROUGHNESS)
}

/// Noise from 0 to 1 that is smooth between the points of a lattice with side 1.
fn noise(place: DVec2, octave: u32) -> f64 {
    let corner = place.floor();
    let part = place - corner;
    let ease = part * part * (3.0 - 2.0 * part);
    let (x, y) = (corner.x as i32, corner.y as i32);
    let at = |x: i32, y: i32| lattice(x as u32, y as u32, octave);
    let along = |y: i32| at(x, y) + ease.x * (at(x + 1, y) - at(x, y));
    along(y) + ease.y * (along(y + 1) - along(y))
}

/// A number from 0 to 1 for a point of the lattice. The bits of its coordinates are mixed by
/// multiplications with odd numbers.
pub(crate) fn lattice(x: u32, y: u32, octave: u32) -> f64 {
    let mut bits = x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77);
    bits ^= octave.wrapping_mul(0xc2b2_ae3d);
    for factor in [0x2c1b_3c6d_u32, 0x297a_2d39] {
        bits = (bits ^ bits >> 15).wrapping_mul(factor);
    }
    f64::from(bits ^ bits >> 15) / f64::from(u32::MAX)
}
