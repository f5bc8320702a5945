//! What a camera's picture can show: where a sphere may appear on it, and how far the singles that
//! the SPUs make their rays from are off.
//!
//! All in f64, relative to the eye. Invariant: every answer is on the safe side: it counts the
//! rounding of the SPU's rays, so a sphere that one of them could meet is never said to be
//! elsewhere.

use std::ops::Range;

use glam::DVec3;
use nff::Camera;

use crate::framebuffer::Geometry;
use protocol::layout::{TILE_HEIGHT, TILE_WIDTH};

/// Error of a ray's direction as the SPU makes it, in parts of the sum of lengths it is made of:
/// two fused steps of 2^-23, the rounding of their operands, and the scaling to length 1.
const DIRECTION_ERROR: f64 = 1.0 / (1 << 21) as f64;

/// Pixels by which a sphere's bounds are widened: they are compared with pixel centres.
const EDGE: f64 = 1.0;

/// Radius, in parts of the distance, by which a sphere can seem larger to the kernels: that of the
/// perpendicular from the centre to a ray.
const PERPENDICULAR_ROUNDING: f64 = 1.0 / (1 << 20) as f64;

/// Largest radius that a sphere can seem to have for the SPU's arithmetic.
pub(super) fn seen_radius(distance: f64, radius: f64) -> f64 {
    radius + PERPENDICULAR_ROUNDING * (distance + radius)
}

/// Pixels that a sphere may touch; empty if none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rectangle {
    /// Columns.
    pub x: Range<u32>,
    /// Rows.
    pub y: Range<u32>,
}

impl Rectangle {
    /// Pixels of both.
    #[must_use]
    pub fn intersection(&self, other: &Self) -> Self {
        let both = |a: &Range<u32>, b: &Range<u32>| a.start.max(b.start)..a.end.min(b.end);
        Self {
            x: both(&self.x, &other.x),
            y: both(&self.y, &other.y),
        }
    }

    /// Whether there is no pixel in it.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.x.is_empty() || self.y.is_empty()
    }
}

/// A camera with a picture size, taken apart along the picture's own axes.
#[derive(Clone, Copy, Debug)]
pub struct Projection {
    eye: DVec3,
    geometry: Geometry,
    /// `None` where the camera's steps are too small to have directions in f64.
    axes: Option<Axes>,
}

#[derive(Clone, Copy, Debug)]
struct Axes {
    /// Unit vectors to the right, down and into the picture.
    right: DVec3,
    down: DVec3,
    ahead: DVec3,
    /// Distance of the plane in which the camera's directions end.
    distance: f64,
    /// Of the direction through pixel (0, 0), along `right` and `down`.
    corner: [f64; 2],
    /// Lengths of the steps to the next pixel.
    step: [f64; 2],
    /// Largest error of a direction as the SPU makes it, before it is scaled.
    error: f64,
}

impl Projection {
    /// Takes a camera apart.
    #[must_use]
    pub fn new(camera: &Camera, geometry: Geometry) -> Self {
        Self {
            eye: camera.eye,
            geometry,
            axes: Axes::new(camera, geometry),
        }
    }

    /// Where the rays begin.
    #[must_use]
    pub fn eye(&self) -> DVec3 {
        self.eye
    }

    /// From the eye to a point.
    #[must_use]
    pub fn to(&self, point: DVec3) -> DVec3 {
        point - self.eye
    }

    /// Error of a unit direction as the SPU makes it, as an angle; infinite if there is no bound.
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

    /// Largest angle between the middle direction of a packet of 4x4 rays and a ray of it;
    /// infinite if there is no bound below a right angle.
    #[must_use]
    pub fn packet_spread(&self) -> f64 {
        let Some(axes) = self.axes else {
            return f64::INFINITY;
        };
        // The packet's middle is a pixel and a half from its outer rays both ways. A ray that ends
        // within `away` of where the middle one ends is inside a cone about the middle one whose
        // sine is `away` over the middle one's length, and that is no less than the plane's
        // distance.
        let away = 1.5 * libm::hypot(axes.step[0], axes.step[1]) + 2.0 * axes.error;
        let sine = away / (axes.distance - axes.error);
        if (0.0..1.0).contains(&sine) {
            libm::asin(sine)
        } else {
            f64::INFINITY
        }
    }

    /// Pixels on which something may be seen that is within some spheres and all that is straight
    /// between them.
    #[must_use]
    pub fn hull(&self, spheres: impl IntoIterator<Item = (DVec3, f64)>) -> Rectangle {
        let Geometry { width, height } = self.geometry;
        let nothing = Rectangle { x: 0..0, y: 0..0 };
        let mut found: Option<Rectangle> = None;
        let mut behind = false;
        for (centre, radius) in spheres {
            let to_centre = self.to(centre);
            let ahead = self.axes.map_or(0.0, |axes| to_centre.dot(axes.ahead));
            if ahead < -seen_radius(to_centre.length(), radius) {
                behind = true;
                continue;
            }
            let bounds = self.bounds(centre, radius);
            // What is in front of the eye throughout is seen between the places of its spheres,
            // also of those that are beyond the picture's edge.
            let both = |a: &Range<u32>, b: &Range<u32>| a.start.min(b.start)..a.end.max(b.end);
            found = Some(match found {
                None => bounds,
                Some(found) => Rectangle {
                    x: both(&found.x, &bounds.x),
                    y: both(&found.y, &bounds.y),
                },
            });
        }
        match found {
            None => nothing,
            Some(_) if behind => Rectangle {
                x: 0..width,
                y: 0..height,
            },
            Some(found) => found,
        }
    }

    /// Pixels on which a sphere may be seen; all of them if the eye is inside or its plane cuts
    /// the sphere.
    #[must_use]
    pub fn bounds(&self, centre: DVec3, radius: f64) -> Rectangle {
        let Geometry { width, height } = self.geometry;
        let all = Rectangle {
            x: 0..width,
            y: 0..height,
        };
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
            // Whatever is no number excludes nothing.
            let first = if first > 0.0 { first } else { 0.0 };
            let last = if last < f64::from(pixels) {
                last
            } else {
                f64::from(pixels)
            };
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
        // Packets and tiles go beyond the picture's edge.
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
