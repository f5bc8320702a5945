//! The eye (`v`) and the rays that leave it.
//!
//! Invariant: a [`Camera`] has finite vectors, `right` and `down` at right angles to each other
//! and of one length.

use glam::DVec3;
use thiserror::Error;

/// Most pixels on a side of a picture, whoever makes it.
pub const MAX_SIDE: u32 = 8192;

/// Sine of the smallest angle between the line of sight and `up` that still tells where up is:
/// far above what rounding does to two parallel vectors (some 1e-16).
const MIN_UP_SINE: f64 = 1e-9;

/// The eye as the file gives it.
#[derive(Debug, Clone, PartialEq)]
pub struct View {
    /// Where the eye is.
    pub from: DVec3,
    /// What it looks at.
    pub at: DVec3,
    /// Which way is up; need not be perpendicular to the line of sight.
    pub up: DVec3,
    /// Degrees between the centres of the top and the bottom pixel row.
    pub angle: f64,
    /// Distance of the hither plane, which a ray tracer does not need.
    pub hither: f64,
    /// Width and height of the picture that the file asks for, in pixels.
    pub resolution: (u32, u32),
}

/// The rays of a picture: the direction through the centre of pixel (x, y), y downwards, is
/// `corner + x * right + y * down`, which is not normalised.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Where every ray starts.
    pub eye: DVec3,
    /// Direction through the centre of the top left pixel.
    pub corner: DVec3,
    /// From a pixel to its right neighbour.
    pub right: DVec3,
    /// From a pixel to its lower neighbour.
    pub down: DVec3,
}

/// Why a view shows nothing.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ViewError {
    /// The eye looks at itself.
    #[error("from and at are the same point, {0}")]
    NoSight(DVec3),
    /// `up` is 0 or lies along the line of sight.
    #[error("up {0} is zero or parallel to the line of sight")]
    NoUp(DVec3),
    /// The angle is not between 0 and 180 degrees.
    #[error("angle {0} is not between 0 and 180 degrees")]
    Angle(f64),
    /// The hither plane is behind the eye.
    #[error("hither {0} is negative")]
    Hither(f64),
    /// A picture with no pixels or with too many.
    #[error("a picture of {0} pixels: each side must be 1 to {MAX_SIDE}")]
    Size(String),
}

impl View {
    /// The rays of a `width` x `height` picture. Pixels are square: the angle is that of the
    /// height, whatever the width. A picture one pixel high has the angle along its width.
    ///
    /// # Errors
    /// A view without a line of sight, an up or a sensible angle, and a size that is none.
    pub fn camera(&self, width: u32, height: u32) -> Result<Camera, ViewError> {
        check_size(width, height)?;
        check_angle(self.angle)?;
        let sight = sight(self.from, self.at)?;
        let right = right(sight, self.up)?;
        let down = sight.cross(right);

        let gaps = if height > 1 {
            height - 1
        } else {
            width.max(2) - 1
        };
        let spacing = 2.0 * libm::tan(self.angle.to_radians() / 2.0) / f64::from(gaps);
        let (right, down) = (right * spacing, down * spacing);
        let to_left = f64::from(width - 1) / 2.0;
        let to_top = f64::from(height - 1) / 2.0;
        Ok(Camera {
            eye: self.from,
            corner: sight - to_left * right - to_top * down,
            right,
            down,
        })
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

/// The unit direction to the right of who looks along `sight`.
pub(crate) fn right(sight: DVec3, up: DVec3) -> Result<DVec3, ViewError> {
    let right = sight.cross(unit(up).ok_or(ViewError::NoUp(up))?);
    if right.length() < MIN_UP_SINE {
        Err(ViewError::NoUp(up))
    } else {
        Ok(right.normalize())
    }
}

/// Whether a view can have this angle; NaN is none.
pub(crate) fn check_angle(angle: f64) -> Result<(), ViewError> {
    if angle > 0.0 && angle < 180.0 {
        Ok(())
    } else {
        Err(ViewError::Angle(angle))
    }
}

/// Whether the hither plane can be here; NaN is nowhere.
pub(crate) fn check_hither(hither: f64) -> Result<(), ViewError> {
    if hither >= 0.0 {
        Ok(())
    } else {
        Err(ViewError::Hither(hither))
    }
}

/// Whether a picture can have this size.
///
/// # Errors
/// A side of no pixels or of more than [`MAX_SIDE`].
pub fn check_size(width: u32, height: u32) -> Result<(), ViewError> {
    let sides = 1..=MAX_SIDE;
    let fits = sides.contains(&width) && sides.contains(&height);
    if fits {
        Ok(())
    } else {
        Err(ViewError::Size(format!("{width}x{height}")))
    }
}

/// `vector` at length 1; nothing where it has no direction. Its largest component is brought to 1
/// first, because the squares of tiny ones are 0 and those of huge ones infinite.
#[must_use]
pub fn unit(vector: DVec3) -> Option<DVec3> {
    let largest = vector.abs().max_element();
    (largest > 0.0 && vector.is_finite()).then(|| (vector / largest).normalize())
}
