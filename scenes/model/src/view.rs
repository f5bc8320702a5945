//! The view (`v`) and its camera.
//!
//! Invariant: a [`Camera`]'s vectors are finite, and `right` and `down` are perpendicular and of
//! equal length.

use glam::DVec3;
use thiserror::Error;

/// The largest width and height of a picture in pixels.
pub const MAX_SIDE: u32 = 8192;

/// The sine of the smallest allowed angle between the line of sight and `up`. It is far above the
/// rounding error for two parallel vectors, about 1e-16.
const MIN_UP_SINE: f64 = 1e-9;

/// The view of a file: the eye, its target, and the picture's angle and size.
#[derive(Debug, Clone, PartialEq)]
pub struct View {
    /// The position of the eye.
    pub from: DVec3,
    /// The point that the eye looks at.
    pub at: DVec3,
    /// The up direction. It need not be perpendicular to the line of sight.
    pub up: DVec3,
    /// The angle in degrees between the centres of the top and the bottom row of pixels.
    pub angle: f64,
    /// The distance of the hither plane, which a ray tracer does not need.
    pub hither: f64,
    /// The picture's width and height in pixels, as the file requests.
    pub resolution: (u32, u32),
}

/// The rays of a picture: the direction through the centre of pixel (x, y), y downwards, is
/// `corner + x * right + y * down`, which is not normalised.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// The origin of every ray.
    pub eye: DVec3,
    /// The direction through the centre of the top left pixel.
    pub corner: DVec3,
    /// The step from a pixel to its right neighbour.
    pub right: DVec3,
    /// The step from a pixel to its lower neighbour.
    pub down: DVec3,
}

/// Why a view shows nothing.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ViewError {
    /// The eye is at its target.
    #[error("from and at are the same point, {0}")]
    NoSight(DVec3),
    /// `up` is 0 or parallel to the line of sight.
    #[error("up {0} is zero or parallel to the line of sight")]
    NoUp(DVec3),
    /// The angle is not between 0 and 180 degrees.
    #[error("angle {0} is not between 0 and 180 degrees")]
    Angle(f64),
    /// The hither plane is behind the eye.
    #[error("hither {0} is negative")]
    Hither(f64),
    /// A side of the picture has no pixels or too many.
    #[error("a picture of {0} pixels: each side must be 1 to {MAX_SIDE}")]
    Size(String),
}

impl View {
    /// The camera for a picture of `width` x `height` pixels. Pixels are square, so the angle is
    /// that of the height, whatever the width. A picture that is one pixel high has the angle
    /// along its width.
    ///
    /// # Errors
    /// - The eye is at its target, or `up` is 0 or parallel to the line of sight.
    /// - The angle, the hither plane or the size is out of range.
    pub fn camera(&self, width: u32, height: u32) -> Result<Camera, ViewError> {
        check_size(width, height)?;
        check_angle(self.angle)?;
        let sight = sight(self.from, self.at)?;
        let right = right(sight, self.up)?;
        let down = sight.cross(right);

        let gaps = if height > 1 { height - 1 } else { width.max(2) - 1 };
        let spacing = 2.0 * libm::tan(self.angle.to_radians() / 2.0) / f64::from(gaps);
        let (right, down) = (right * spacing, down * spacing);
        let to_left = f64::from(width - 1) / 2.0;
        let to_top = f64::from(height - 1) / 2.0;
        Ok(Camera { eye: self.from, corner: sight - to_left * right - to_top * down, right, down })
    }
}

impl Camera {
    /// The (unnormalised) direction of the ray through the centre of a pixel.
    #[must_use]
    pub fn direction(&self, x: u32, y: u32) -> DVec3 {
        self.corner + f64::from(x) * self.right + f64::from(y) * self.down
    }
}

/// The unit direction in which the eye looks.
pub(crate) fn sight(from: DVec3, at: DVec3) -> Result<DVec3, ViewError> {
    unit(at - from).ok_or(ViewError::NoSight(from))
}

/// The unit direction to the right of an observer that looks along `sight`.
pub(crate) fn right(sight: DVec3, up: DVec3) -> Result<DVec3, ViewError> {
    let right = sight.cross(unit(up).ok_or(ViewError::NoUp(up))?);
    if right.length() < MIN_UP_SINE { Err(ViewError::NoUp(up)) } else { Ok(right.normalize()) }
}

/// Checks that a view can have this angle; NaN is refused.
pub(crate) fn check_angle(angle: f64) -> Result<(), ViewError> {
    if angle > 0.0 && angle < 180.0 { Ok(()) } else { Err(ViewError::Angle(angle)) }
}

/// Checks that the hither plane can have this distance; NaN is refused.
pub(crate) fn check_hither(hither: f64) -> Result<(), ViewError> {
    if hither >= 0.0 { Ok(()) } else { Err(ViewError::Hither(hither)) }
}

/// Checks that a picture can have this size in pixels.
///
/// # Errors
/// A side is 0 or above [`MAX_SIDE`].
pub fn check_size(width: u32, height: u32) -> Result<(), ViewError> {
    let sides = 1..=MAX_SIDE;
    let fits = sides.contains(&width) && sides.contains(&height);
    if fits { Ok(()) } else { Err(ViewError::Size(format!("{width}x{height}"))) }
}

/// Normalises `vector`; `None` if it has no direction. The largest component is scaled to 1 first,
/// because the squares of tiny components are 0 and those of huge ones infinite.
#[must_use]
pub fn unit(vector: DVec3) -> Option<DVec3> {
    let largest = vector.abs().max_element();
    (largest > 0.0 && vector.is_finite()).then(|| (vector / largest).normalize())
}
