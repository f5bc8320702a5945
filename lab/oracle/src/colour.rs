//! Colour spaces of a scene's colours and of pixels.

use glam::DVec3;

/// The meaning of channels.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Colour {
    /// They are proportional to light.
    #[default]
    Linear,
    /// They have sRGB's values, by the definition of IEC 61966-2-1.
    Srgb,
}

impl Colour {
    /// The share of light with which a surface shows this share of the colours in it.
    #[must_use]
    pub fn share(self, share: f64) -> f64 {
        self.light(DVec3::splat(share)).x
    }

    /// The light that a colour of the scene stands for.
    #[must_use]
    pub fn light(self, colour: DVec3) -> DVec3 {
        let light = |value: f64| {
            if value > 0.04045 { libm::pow((value + 0.055) / 1.055, 2.4) } else { value / 12.92 }
        };
        match self {
            Self::Linear => colour,
            Self::Srgb => colour.to_array().map(light).into(),
        }
    }

    /// The channels of a pixel that shows this light, from 0 to 1.
    #[must_use]
    pub fn shown(self, light: DVec3) -> DVec3 {
        let value = |light: f64| {
            if light > 0.003_130_8 {
                1.055 * libm::pow(light, 1.0 / 2.4) - 0.055
            } else {
                12.92 * light
            }
        };
        match self {
            Self::Linear => light,
            Self::Srgb => light.to_array().map(value).into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn display_keeps_colour() {
        for step in 0..=255 {
            let colour = DVec3::splat(f64::from(step) / 255.0);
            let shown = Colour::Srgb.shown(Colour::Srgb.light(colour));
            assert!(shown.distance(colour) < 1e-4, "{step}: {shown}");
        }
        // Half of the light of white is far above half of its value.
        let half = Colour::Srgb.shown(DVec3::splat(0.5)).x;
        assert!((half - 0.735).abs() < 0.001, "{half}");
    }
}
