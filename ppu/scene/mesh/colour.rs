//! Colours of vertices in blocks: three numbers of ten bits in a word.

use glam::DVec3;

use crate::scene::colour::Colour;

const MAX_CHANNEL: f64 = 1023.0;

/// A colour of a scene as SPUs get it: its light or, if it is sRGB's, the square root of that,
/// which has as many steps in the dark as a screen. It is off by at most a fifth of a step of 8
/// bits.
pub(super) fn packed(colour: [f32; 3], meaning: Colour) -> u32 {
    let light = meaning.light(DVec3::from_array(colour.map(f64::from)));
    let [red, green, blue] = light.to_array().map(|light| {
        let value = match meaning {
            Colour::Linear => light,
            Colour::Srgb => light.max(0.0).sqrt(),
        };
        // Beyond the range, and where it is no number, this is its end.
        (MAX_CHANNEL * value).round().clamp(0.0, MAX_CHANNEL) as u32
    });
    red << 22 | green << 12 | blue << 2
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An sRGB value of light.
    fn encoded(light: f64) -> f64 {
        match light <= 0.003_130_8 {
            true => 12.92 * light,
            false => 1.055 * libm::pow(light, 1.0 / 2.4) - 0.055,
        }
    }

    #[test]
    fn colours_keep_more_than_eight_bits() {
        let mut worst = [0.0_f64; 2];
        for step in 0..=4000 {
            let value = step as f32 / 4000.0;
            for (worst, meaning) in worst.iter_mut().zip([Colour::Linear, Colour::Srgb]) {
                let word = packed([value, 0.0, 1.0], meaning);
                assert_eq!(word & 0x003f_ffff, 1023 << 2);
                let part = f64::from(word >> 22) / MAX_CHANNEL;
                let found = match meaning {
                    Colour::Linear => part,
                    Colour::Srgb => encoded(part * part),
                };
                *worst = worst.max(255.0 * (found - f64::from(value)).abs());
            }
        }
        println!("steps of 8 bits: {worst:?}");
        assert!(worst[0] < 0.126 && worst[1] < 0.2, "{worst:?}");
    }

    #[test]
    fn out_of_range_colours_are_clamped() {
        assert_eq!(packed([-1.0, 2.0, 0.0], Colour::Srgb), 1023 << 12);
        assert_eq!(packed([f32::NAN; 3], Colour::Srgb), 0);
    }
}
