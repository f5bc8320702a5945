//! A gradient of the background, fog, and the light of a fine day for scenes without lights.

use glam::DVec3;

use crate::view::{self, ViewError, unit};
use crate::{Light, LightKind, View};

/// A sky (`#cellray sky`): a ray that hits nothing sees the background at the horizon and below,
/// and this colour at the zenith. Between them it sees their mixture by the sine of its elevation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sky {
    /// The colour at the zenith: red, green and blue from 0 to 1.
    pub zenith: DVec3,
    /// The direction to the zenith: not 0, and not normalised.
    pub up: DVec3,
}

/// Fog (`#cellray fog`): of what a surface sends, exp(-density distance) arrives at the eye or
/// where the ray has come from, and the rest is the fog's colour. What is beyond all surfaces has
/// none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fog {
    /// Red, green and blue from 0 to 1.
    pub colour: DVec3,
    /// Not below 0.
    pub density: f64,
}

/// The background of a day: the colour at the horizon.
pub const HORIZON: DVec3 = DVec3::new(0.8, 0.87, 0.94);
/// The colour of a day's zenith.
pub const ZENITH: DVec3 = DVec3::new(0.24, 0.45, 0.78);
/// The ambient light of a day, which comes from the sky.
pub const AMBIENT: DVec3 = DVec3::new(0.1, 0.125, 0.17);
/// The brightness of a day's sun.
pub const SUN: DVec3 = DVec3::new(0.9, 0.84, 0.74);

impl Sky {
    /// The sky of a day, above somebody with this direction upwards.
    #[must_use]
    pub fn of_day(up: DVec3) -> Self {
        Self { zenith: ZENITH, up }
    }
}

/// The sun of a day. It is above and behind the eye, on the right.
///
/// # Errors
/// The view has no direction, or none upwards.
pub fn sun(view: &View) -> Result<Light, ViewError> {
    let sight = view::sight(view.from, view.at)?;
    let right = view::right(sight, view.up)?;
    let up = unit(view.up).unwrap_or_default();
    Ok(Light {
        line: 0,
        kind: LightKind::Directional { to_light: right + 2.0 * up - 1.5 * sight },
        colour: Some(SUN),
    })
}
