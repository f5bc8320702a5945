//! Rays, with what the tests of shapes and boxes want of each.
//!
//! Invariant: the direction has length 1.

use glam::{DVec2, DVec3};

/// Replaces a component of 0 in a divisor: so small that a plane that is not at
/// the origin itself is beyond every distance.
const TINY: f64 = 1e-300;

#[derive(Debug, Clone, Copy)]
pub(crate) struct Ray {
    pub origin: DVec3,
    pub direction: DVec3,
    /// 1 / direction, finite.
    pub inverse: DVec3,
    /// The axes of the shear: the one most along the ray last.
    axes: [usize; 3],
    /// How far along the first two axes a step along the last leads.
    shear: DVec2,
}

impl Ray {
    /// A ray in a unit direction.
    pub(crate) fn new(origin: DVec3, direction: DVec3) -> Self {
        let size = direction.abs();
        let main = if size.x > size.y && size.x > size.z {
            0
        } else if size.y > size.z {
            1
        } else {
            2
        };
        let axes = [(main + 1) % 3, (main + 2) % 3, main];
        let [right, up, along] = axes.map(|axis| direction[axis]);
        let inverse = direction.map(|component| {
            let tiny = component.abs() < TINY;
            (if tiny { TINY } else { component }).recip()
        });
        Self { origin, direction, inverse, axes, shear: DVec2::new(right, up) / along }
    }

    pub(crate) fn at(&self, distance: f64) -> DVec3 {
        self.origin + distance * self.direction
    }

    /// A point as seen along the ray: the line of the ray goes through 0.
    pub(crate) fn sheared(&self, point: DVec3) -> DVec2 {
        let from_origin = point - self.origin;
        let [right, up, along] = self.axes.map(|axis| from_origin[axis]);
        DVec2::new(right, up) - self.shear * along
    }
}
