//! Colours from hues.

use cellray::game::DVec3;

/// The colour of a hue, where 1 is a full circle, mixed with this share of grey.
#[must_use]
pub fn hue(turn: f64, grey: f64) -> DVec3 {
    let sixth = (turn - turn.floor()) * 6.0;
    let pure =
        DVec3::new((sixth - 3.0).abs() - 1.0, 2.0 - (sixth - 2.0).abs(), 2.0 - (sixth - 4.0).abs());
    pure.clamp(DVec3::ZERO, DVec3::ONE).lerp(DVec3::splat(0.75), grey)
}

#[cfg(test)]
mod tests {
    use super::hue;
    use cellray::game::DVec3;

    #[test]
    fn hues_120_degrees_apart_are_red_green_and_blue() {
        assert_eq!(hue(0.0, 0.0), DVec3::X);
        assert_eq!(hue(-2.0, 0.0), DVec3::X);
        assert!(hue(1.0 / 3.0, 0.0).distance(DVec3::Y) < 1e-12);
        assert!(hue(2.0 / 3.0, 0.0).distance(DVec3::Z) < 1e-12);
        assert_eq!(hue(0.3, 1.0), DVec3::splat(0.75));
    }
}
