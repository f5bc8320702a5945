//! The pictures of our own level, drawn by rules, and the materials that are more than a picture.

use cellray::game::{DVec3, Material};
use levels::{Error, Name, Picture, Pictures, Sprite, Surface};

/// Texels across and down.
const SIDE: usize = 64;

/// The pictures of our own level.
pub struct Drawn;

/// A number from 0 to 1 that looks random, and is the same for the same texel.
fn noise(x: usize, y: usize, salt: usize) -> f64 {
    let mut bits = (x + 64 * y + 4096 * salt) as u32;
    for factor in [0x7feb_352d, 0x846c_a68b] {
        bits = (bits ^ bits >> 15).wrapping_mul(factor);
    }
    f64::from((bits ^ bits >> 16) % 1024) / 1023.0
}

/// Whether a texel is on the line between tiles of a size.
fn is_seam(x: usize, y: usize, across: usize, down: usize) -> bool {
    x.is_multiple_of(across) || y.is_multiple_of(down)
}

/// The colour of a texel; `None` if there is no picture of this name.
fn texel(name: &str, x: usize, y: usize) -> Option<DVec3> {
    let grain = |amount: f64, salt| 1.0 - amount * noise(x, y, salt);
    let grey = DVec3::splat;
    let dark = |is: bool, by: f64| if is { by } else { 1.0 };
    Some(match name {
        "BRICK" => {
            let row = y / 8;
            let shifted = x + 8 * (row % 2);
            let seam = dark(is_seam(shifted, y, 16, 8), 0.55);
            let brick = 0.8 + 0.2 * noise(shifted / 16 % 4, row, 1);
            DVec3::new(0.72, 0.42, 0.32) * brick * grain(0.2, 2) * seam
        }
        "STONE" => {
            let seam = dark(is_seam(x + 16 * (y / 16 % 2), y, 32, 16), 0.6);
            DVec3::new(0.62, 0.6, 0.54) * grain(0.3, 3) * seam
        }
        "PANEL" => {
            let seam = dark(is_seam(x, y, 32, 64), 0.45);
            let stripe = if (28..34).contains(&y) { DVec3::new(0.9, 0.6, 0.2) } else { grey(0.66) };
            stripe * grain(0.08, 4) * seam
        }
        "STEEL" => {
            let rivet = x % 16 == 8 && y % 16 == 8;
            let seam = dark(is_seam(x, y, 64, 32), 0.6);
            grey(if rivet { 0.85 } else { 0.5 }) * grain(0.12, 5) * seam
        }
        "DOOR" => {
            let bar = if (y / 8).is_multiple_of(2) { 0.95 } else { 0.75 };
            let seam = dark(x % 64 < 2 || x % 64 == 31 || x % 64 == 32, 0.4);
            DVec3::new(0.35, 0.55, 0.7) * bar * grain(0.1, 6) * seam
        }
        "TILES" => {
            let light = (x / 32 + y / 32).is_multiple_of(2);
            let seam = dark(is_seam(x, y, 32, 32), 0.6);
            grey(if light { 0.72 } else { 0.5 }) * grain(0.1, 7) * seam
        }
        "PLATES" => grey(0.62) * grain(0.08, 8) * dark(is_seam(x, y, 64, 64), 0.5),
        "GRASS" => DVec3::new(0.32, 0.55, 0.22) * grain(0.45, 9),
        "WATER" => DVec3::new(0.2, 0.42, 0.5) * grain(0.1, 10),
        "MIRROR" => grey(0.9),
        "GLASS" => DVec3::new(0.75, 0.9, 0.88),
        "EXIT" => {
            let is_frame = !(8..56).contains(&x) || !(8..56).contains(&y);
            let is_arrow = (16..36).contains(&x) && (28..36).contains(&y)
                || (36..52).contains(&x) && y.abs_diff(32) < 52 - x;
            let sign = if is_arrow { grey(1.0) } else { DVec3::new(0.1, 0.6, 0.25) };
            if is_frame { grey(0.4) * grain(0.1, 11) } else { sign }
        }
        _ => return None,
    })
}

fn picture(name: Name) -> Option<Picture> {
    let name = name.to_string();
    let places = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)));
    let bytes = |colour: DVec3| colour.to_array().map(|it| (255.0 * it.clamp(0.0, 1.0)) as u8);
    let texels = places.map(|(x, y)| texel(&name, x, y).map(bytes));
    let texels: Vec<_> = texels.collect();
    texels[0].is_some().then_some(Picture { width: SIDE, texels })
}

impl Pictures for Drawn {
    fn wall(&self, name: Name) -> Result<Option<Picture>, Error> {
        Ok(picture(name))
    }

    fn flat(&self, name: Name) -> Result<Option<Picture>, Error> {
        Ok(picture(name))
    }

    fn sprite(&self, _: Name) -> Result<Option<Sprite>, Error> {
        Ok(None)
    }
}

/// A material with its mirror, its glass or its water.
#[must_use]
pub fn finished(material: Material, surface: Surface) -> Material {
    let (Surface::Wall(name) | Surface::Flat(name)) = surface else {
        return material;
    };
    match name.to_string().as_str() {
        "MIRROR" => Material { diffuse: 0.08, specular: 0.9, shine: 100.0, ..material },
        "WATER" => Material { diffuse: 0.6, specular: 0.4, shine: 60.0, ..material },
        "GLASS" => Material {
            diffuse: 0.12,
            specular: 0.12,
            shine: 100.0,
            transmittance: 0.8,
            refraction_index: 1.0,
            ..material
        },
        _ => material,
    }
}
