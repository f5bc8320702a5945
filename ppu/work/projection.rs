//! The projection of spheres onto a camera's picture, with a bound of the SPU's rounding.
//!
//! All computations are in f64, relative to the eye. Invariant: every result is conservative. It
//! allows for the rounding of the SPU's rays, so it includes every pixel whose ray could hit the
//! sphere.

use std::ops::Range;

use glam::DVec3;
use scenes::Camera;

use crate::framebuffer::Geometry;
use protocol::layout::{TILE_HEIGHT, TILE_WIDTH};

/// The error of a ray's direction on the SPU, relative to the sum of the lengths that it is
/// computed from: two fused steps of 2^-23, the rounding of their operands, and the scaling to
/// length 1.
const DIRECTION_ERROR: f64 = 1.0 / (1 << 21) as f64;

/// By how many pixels a sphere's bounds are widened, because they are compared with pixel centres.
const EDGE: f64 = 1.0;

/// By how much a sphere's radius can seem larger to the kernels, relative to the distance: the
/// error of the perpendicular from the centre to a ray.
const PERPENDICULAR_ROUNDING: f64 = 1.0 / (1 << 20) as f64;

/// The largest radius that a sphere can seem to have in the SPU's arithmetic.
pub(super) fn seen_radius(distance: f64, radius: f64) -> f64 {
    radius + PERPENDICULAR_ROUNDING * (distance + radius)
}

/// A rectangle of pixels, which may be empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rectangle {
    /// The columns.
    pub x: Range<u32>,
    /// The rows.
    pub y: Range<u32>,
}

impl Rectangle {
    /// The pixels in both rectangles.
    #[must_use]
    pub fn intersection(&self, other: &Self) -> Self {
        let both = |a: &Range<u32>, b: &Range<u32>| a.start.max(b.start)..a.end.min(b.end);
        Self { x: both(&self.x, &other.x), y: both(&self.y, &other.y) }
    }

    /// Whether the rectangle has no pixels.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.x.is_empty() || self.y.is_empty()
    }
}

/// A camera and a picture size, in the coordinates of the picture's axes.
#[derive(Clone, Copy, Debug)]
pub struct Projection {
    eye: DVec3,
    geometry: Geometry,
    /// `None` if the camera's steps are too small to have directions in f64.
    axes: Option<Axes>,
}

#[derive(Clone, Copy, Debug)]
struct Axes {
    /// Unit vectors to the right, down and into the picture.
    right: DVec3,
    down: DVec3,
    ahead: DVec3,
    /// The distance of the plane in which the camera's directions end.
    distance: f64,
    /// The direction through pixel (0, 0), along `right` and `down`.
    corner: [f64; 2],
    /// The lengths of the steps to the next pixel.
    step: [f64; 2],
    /// The largest error of a direction on the SPU, before it is scaled.
    error: f64,
}

impl Projection {
    /// Converts a camera with a picture of this size.
    #[must_use]
    pub fn new(camera: &Camera, geometry: Geometry) -> Self {
        Self { eye: camera.eye, geometry, axes: Axes::new(camera, geometry) }
    }

    /// The eye.
    #[must_use]
    pub fn eye(&self) -> DVec3 {
        self.eye
    }

    /// The vector from the eye to a point.
    #[must_use]
    pub fn to(&self, point: DVec3) -> DVec3 {
        point - self.eye
    }

    /// The error of a unit direction on the SPU, as an angle in radians; infinite if there is no
    /// bound.
    #[must_use]
    pub fn direction_error(&self) -> f64 {
        self.axes.map_or(f64::INFINITY, |axes| {
            if axes.error < axes.distance {
                axes.error / (axes.distance - axes.error)
            } else {
                f64::INFINITY
            }
        })
    }

    /// The largest angle in radians between the middle direction of a packet of 4x4 rays and one
    /// of its rays; infinite if there is no bound below a right angle.
    #[must_use]
    pub fn packet_spread(&self) -> f64 {
        let Some(axes) = self.axes else {
            return f64::INFINITY;
        };
        // The packet's middle is a pixel and a half from its outer rays in both directions. Rays
        // end in a plane. If a ray ends within `away` of the end of the middle ray, it is inside a
        // cone about the middle ray with the sine `away` / length. The plane's distance is
        // the minimum length of the middle ray.
        let away = 1.5 * libm::hypot(axes.step[0], axes.step[1]) + 2.0 * axes.error;
        let sine = away / (axes.distance - axes.error);
        if (0.0..1.0).contains(&sine) { libm::asin(sine) } else { f64::INFINITY }
    }

    /// The pixels on which an object may be visible that is inside the convex hull of some
    /// spheres.
    #[must_use]
    pub fn hull(&self, spheres: impl IntoIterator<Item = (DVec3, f64)>) -> Rectangle {
        let Geometry { width, height } = self.geometry;
        let nothing = Rectangle { x: 0..0, y: 0..0 };
        let mut found: Option<Rectangle> = None;
        let mut crosses_eye = false;
        for (centre, radius) in spheres {
            let to_centre = self.to(centre);
            let ahead = self.axes.map_or(0.0, |axes| to_centre.dot(axes.ahead));
            if ahead < -seen_radius(to_centre.length(), radius) {
                crosses_eye = true;
                continue;
            }
            let bounds = self.bounds(centre, radius);
            // If the whole hull is in front of the eye, it is visible only between its spheres'
            // pixels. Spheres beyond the picture's edge count too.
            let both = |a: &Range<u32>, b: &Range<u32>| a.start.min(b.start)..a.end.max(b.end);
            found = Some(match found {
                None => bounds,
                Some(found) => {
                    Rectangle { x: both(&found.x, &bounds.x), y: both(&found.y, &bounds.y) }
                }
            });
        }
        match found {
            None => nothing,
            Some(_) if crosses_eye => Rectangle { x: 0..width, y: 0..height },
            Some(found) => found,
        }
    }

    /// The pixels on which a sphere may be visible: all pixels if the eye is inside the sphere, or
    /// the eye's plane cuts it.
    #[must_use]
    pub fn bounds(&self, centre: DVec3, radius: f64) -> Rectangle {
        let Geometry { width, height } = self.geometry;
        let all = Rectangle { x: 0..width, y: 0..height };
        let Some(axes) = self.axes else {
            return all;
        };
        let to_centre = self.to(centre);
        let radius = seen_radius(to_centre.length(), radius);
        let ahead = to_centre.dot(axes.ahead);
        if axes.error >= axes.distance / 2.0 || ahead.abs() <= radius {
            return all;
        }
        if ahead < 0.0 {
            return Rectangle { x: 0..0, y: 0..0 };
        }
        let range = |axis: usize, aside: f64, pixels: u32| {
            let half = radius * ((aside - radius) * (aside + radius) + ahead * ahead).sqrt();
            let scale = axes.distance / ((ahead - radius) * (ahead + radius));
            let margin = EDGE + 2.0 * axes.error / axes.step[axis];
            let pixel = |tangent: f64| (tangent * scale - axes.corner[axis]) / axes.step[axis];
            let first = (pixel(aside * ahead - half) - margin).ceil();
            let last = (pixel(aside * ahead + half) + margin).floor();
            // NaN must exclude no pixel.
            let first = if first > 0.0 { first } else { 0.0 };
            let last = if last < f64::from(pixels) { last } else { f64::from(pixels) };
            first as u32..((last + 1.0).max(0.0) as u32).min(pixels)
        };
        Rectangle {
            x: range(0, to_centre.dot(axes.right), width),
            y: range(1, to_centre.dot(axes.down), height),
        }
    }
}

impl Axes {
    fn new(camera: &Camera, geometry: Geometry) -> Option<Self> {
        let right = camera.right.try_normalize()?;
        let down = camera.down.try_normalize()?;
        let ahead = right.cross(down).try_normalize()?;
        let distance = camera.corner.dot(ahead);
        let step = [camera.right.length(), camera.down.length()];
        // Packets and tiles extend beyond the picture's edge.
        let columns = f64::from(geometry.width + TILE_WIDTH);
        let rows = f64::from(geometry.height + TILE_HEIGHT);
        let lengths = camera.corner.length() + columns * step[0] + rows * step[1];
        Some(Self {
            right,
            down,
            ahead: ahead * distance.signum(),
            distance: distance.abs(),
            corner: [camera.corner.dot(right), camera.corner.dot(down)],
            step,
            error: DIRECTION_ERROR * lengths,
        })
    }
}

#[cfg(test)]
mod tests;
