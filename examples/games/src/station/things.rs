//! The lamps and decorations of a level, as posts with round tops.

use cellray::game::{DVec3, Material, Shape, World, WorldError};

/// What a thing looks like.
#[derive(Clone, Copy, Debug)]
pub struct Decoration {
    radius: f64,
    height: f64,
    colour: [f64; 3],
    /// The colour of its light, if it is a lamp.
    pub light: Option<[f64; 3]>,
}

const IRON: [f64; 3] = [0.3, 0.3, 0.32];
const WOOD: [f64; 3] = [0.35, 0.24, 0.15];
const WARM: [f64; 3] = [1.0, 0.85, 0.6];
const COLD: [f64; 3] = [0.7, 0.85, 1.0];
const RED: [f64; 3] = [1.0, 0.3, 0.2];
const GREEN: [f64; 3] = [0.35, 1.0, 0.4];
const BLUE: [f64; 3] = [0.35, 0.5, 1.0];

/// The kinds of things that stand in a level without being in the way; `None` for all others.
#[must_use]
pub fn decoration(kind: u16) -> Option<Decoration> {
    let lamp =
        |radius, height, light| Decoration { radius, height, colour: IRON, light: Some(light) };
    let post = |radius, height, colour| Decoration { radius, height, colour, light: None };
    Some(match kind {
        2028 => lamp(5.0, 46.0, WARM),
        85 => lamp(6.0, 72.0, COLD),
        86 => lamp(6.0, 54.0, COLD),
        34 => lamp(2.0, 10.0, WARM),
        35 => lamp(5.0, 54.0, WARM),
        70 => lamp(9.0, 30.0, WARM),
        44 => lamp(5.0, 84.0, BLUE),
        45 => lamp(5.0, 84.0, GREEN),
        46 => lamp(5.0, 84.0, RED),
        55 => lamp(4.0, 44.0, BLUE),
        56 => lamp(4.0, 44.0, GREEN),
        57 => lamp(4.0, 44.0, RED),
        2035 => post(9.0, 24.0, [0.3, 0.4, 0.25]),
        48 => post(12.0, 112.0, IRON),
        30 => post(12.0, 44.0, [0.2, 0.4, 0.2]),
        31 => post(12.0, 32.0, [0.2, 0.4, 0.2]),
        32 => post(12.0, 44.0, [0.45, 0.15, 0.15]),
        33 | 36 | 37 => post(12.0, 32.0, [0.45, 0.15, 0.15]),
        43 | 54 => post(10.0, 100.0, WOOD),
        47 => post(8.0, 36.0, WOOD),
        _ => return None,
    })
}

/// Adds a decoration, and returns the place of its light, above its top: its own shadow falls down.
pub fn add(world: &mut World, foot: DVec3, kind: Decoration) -> Result<DVec3, WorldError> {
    let Decoration { radius, height, colour, light } = kind;
    let [red, green, blue] = colour;
    let post = world.add_material(Material::matte(red, green, blue))?;
    let top = foot + DVec3::Y * height;
    let stem =
        |radius| Shape::Cone { base: foot, base_radius: radius, apex: top, apex_radius: radius };
    match light {
        Some([red, green, blue]) => {
            let glow = world.add_material(Material::flat(red, green, blue))?;
            world.add(stem(radius * 0.4), post)?;
            world.add_sphere(top, radius, glow)?;
        }
        None => {
            world.add(stem(radius), post)?;
            world.add_sphere(top, radius, post)?;
        }
    }
    Ok(top + DVec3::Y * (radius + 6.0))
}
