//! The formulas for light at a surface: reflection, refraction and brightness.
//!
//! Invariant: directions have length 1; normals are on the side that the ray comes from.

use glam::DVec3;

use super::finish::Finish;
use super::weight;

/// Blinn's exponent for a highlight of about the same size, as a multiple of Phong's. Near the
/// mirror direction the angle from the normal to the halfway vector is half of Phong's angle, and
/// cos(x/2)^(4 n) equals cos(x)^n up to the fourth order.
const BLINN: f64 = 4.0;

/// The direction that a mirror with this normal reflects.
pub(super) fn reflected(direction: DVec3, normal: DVec3) -> DVec3 {
    (direction - 2.0 * direction.dot(normal) * normal).normalize()
}

/// The refracted direction by Snell's law, and the cosine of its angle to the normal; `None` for
/// total reflection. `ratio` is the index of refraction on this side over that on the other side.
pub(super) fn refracted(direction: DVec3, normal: DVec3, ratio: f64) -> Option<(DVec3, f64)> {
    let cosine = -direction.dot(normal);
    // The length of the tangential part is the sine; 1 - cosine² would cancel for a steep ray.
    let along = ratio * (direction + cosine * normal);
    let squared = 1.0 - along.length_squared();
    (squared >= 0.0).then(|| {
        let beyond = squared.sqrt();
        ((along - beyond * normal).normalize(), beyond)
    })
}

/// The share that a surface between media of this ratio reflects, by Schlick's approximation.
/// `near` and `beyond` are the cosines on this side and on the other; the thinner medium's is
/// used.
pub(super) fn schlick(ratio: f64, near: f64, beyond: f64) -> f64 {
    let head_on = ((1.0 - ratio) / (1.0 + ratio)).powi(2);
    let cosine = if ratio > 1.0 { beyond } else { near };
    head_on + (1.0 - head_on) * (1.0 - cosine).clamp(0.0, 1.0).powi(5)
}

/// The share of a light with a range that is left at a distance.
pub(super) fn fade(distance: f64, range: f64) -> f64 {
    (1.0 - (distance / range).powi(2)).max(0.0).powi(2)
}

/// A bound of [`shine`]'s channels, by the cosine of the light's angle to the normal.
pub(super) fn bound(finish: &Finish, facing: f64) -> f64 {
    finish.diffuse * facing * weight::most(finish.colour) + finish.highlight
}

/// The light of a source in front of the surface, with brightness 1 and the direction `to_light`,
/// that the surface sends back along `direction`: Lambert's term in the material's colour, and
/// Blinn's highlight in the light's colour.
pub(super) fn shine(finish: &Finish, normal: DVec3, direction: DVec3, to_light: DVec3) -> DVec3 {
    let lambert = finish.diffuse * normal.dot(to_light) * finish.colour;
    if finish.highlight == 0.0 {
        return lambert;
    }
    let halfway = scenes::unit(to_light - direction).unwrap_or(normal);
    let cosine = normal.dot(halfway).clamp(0.0, 1.0);
    lambert + finish.highlight * libm::pow(cosine, BLINN * finish.shine)
}
