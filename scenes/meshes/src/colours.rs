//! Colours as values for the screen (sRGB) and as light, and colours of vertices that are colours
//! of materials.

use std::collections::HashMap;

use glam::DVec3;
use scenes::Material;

use crate::MAX_MATERIALS;

/// Encodes light for the screen (sRGB).
pub(crate) fn encoded(light: f64) -> f64 {
    let light = light.max(0.0);
    if light == 1.0 {
        // The sum below is a rounding less.
        1.0
    } else if light <= 0.003_130_8 {
        12.92 * light
    } else {
        1.055 * libm::pow(light, 1.0 / 2.4) - 0.055
    }
}

/// The light of a value for the screen.
fn decoded(value: f64) -> f64 {
    if value <= 0.040_45 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
}

/// The colour whose light is the product of two colours' light.
fn product(one: DVec3, other: DVec3) -> DVec3 {
    let channel = |one: f64, other: f64| match (one, other) {
        // Exact, where nothing is multiplied.
        (1.0, _) => other,
        (_, 1.0) => one,
        _ => encoded(decoded(one) * decoded(other)),
    };
    DVec3::new(channel(one.x, other.x), channel(one.y, other.y), channel(one.z, other.z))
}

/// Gives triangles of one colour a material of that colour, if all triangles have one each, and
/// these are few enough. Returns whether that is so; otherwise nothing changes.
pub(crate) fn fold(
    colours: &[[f32; 3]],
    triangles: &[[u32; 3]],
    triangle_materials: &mut [u32],
    materials: &mut Vec<Material>,
) -> bool {
    let mut known: HashMap<(u32, [u32; 3]), u32> = HashMap::new();
    let mut folded: Vec<Material> = Vec::new();
    let mut numbers = Vec::with_capacity(triangles.len());
    for (corners, &material) in triangles.iter().zip(&*triangle_materials) {
        let [a, b, c] = corners.map(|corner| colours[corner as usize]);
        if a != b || b != c {
            return false;
        }
        let number = *known.entry((material, a.map(f32::to_bits))).or_insert_with(|| {
            let colour = DVec3::from(a.map(f64::from));
            let old = &materials[material as usize];
            folded.push(Material { colour: product(old.colour, colour), ..old.clone() });
            folded.len() as u32 - 1
        });
        if folded.len() > MAX_MATERIALS {
            return false;
        }
        numbers.push(number);
    }
    triangle_materials.copy_from_slice(&numbers);
    *materials = folded;
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn product_of_light_is_commutative_and_keeps_white() {
        let (one, other) = (DVec3::new(0.2, 0.5, 1.0), DVec3::new(1.0, 0.25, 0.75));
        assert_eq!(product(one, other), product(other, one));
        assert_eq!(product(one, DVec3::ONE), one);
        let half = encoded(0.5);
        let quarter = product(DVec3::splat(half), DVec3::splat(half)).x;
        assert!((quarter - encoded(0.25)).abs() < 1e-15, "{quarter}");
    }

    #[test]
    fn triangles_of_one_colour_get_a_material_each() {
        let red = [1.0, 0.0, 0.0];
        let colours = [red, red, red, [1.0; 3], [1.0; 3]];
        let mut materials = vec![Material::matte(DVec3::splat(0.5))];
        let mut numbers = [0, 0];
        assert!(!fold(&colours, &[[0, 1, 2], [1, 2, 3]], &mut numbers, &mut materials));
        assert_eq!(materials.len(), 1);
        assert!(fold(&colours, &[[0, 1, 2], [4, 3, 3]], &mut numbers, &mut materials));
        let found: Vec<DVec3> = materials.iter().map(|it| it.colour).collect();
        assert_eq!(found, [DVec3::new(0.5, 0.0, 0.0), DVec3::splat(0.5)]);
        assert_eq!(numbers, [0, 1]);
    }
}
