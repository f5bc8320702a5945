//! The inputs over which the kernels of each formulation of spheres are measured, as their headers
//! state.

use std::fmt::Debug;

use crate::prelude::*;
use twins::sphere::{
    Constants, Estimate, Eye, Factored, General, InDouble, Interpolated, Newton2, Paper,
    Perpendicular, Refined, Stable, Unnormalised,
};

/// The rays and spheres for which a formulation's stated error holds.
#[derive(Clone, Debug)]
pub struct Domain {
    /// The distance of the eye from the centre, in radii.
    pub eye: Range<f64>,
    /// The largest distance of other origins from the centre, in radii.
    pub farthest: f64,
    /// The smallest distance between a ray and the sphere's outline, as disc / r^2, for which the
    /// root counts.
    pub outline: f64,
    /// The smallest distance of another origin from the surface, in radii.
    pub surface: f64,
    /// The lengths of directions.
    pub lengths: Range<f64>,
    /// Whether a ray certainly hits a sphere that it touches, if only roots and quotients need
    /// rounding.
    pub touches: bool,
    /// The relative error that is expected for rays from distances at which no digits are lost.
    pub rough: f64,
}

const PERPENDICULAR: Domain = Domain {
    eye: 1.5..30.0,
    farthest: 30.0,
    outline: 0.01,
    surface: 1e-5,
    lengths: 1.0..1.0,
    touches: true,
    rough: 1e-6,
};

/// A formulation and its domain.
pub trait Formulation: Copy + Debug + 'static {
    /// The domain.
    const DOMAIN: Domain = PERPENDICULAR;
}

impl Formulation for Perpendicular {}
impl Formulation for Newton2 {}
impl Formulation for Stable {}

impl Formulation for Factored {
    const DOMAIN: Domain = Domain { touches: false, ..PERPENDICULAR };
}

impl Formulation for Paper {
    const DOMAIN: Domain = Domain { eye: 1.5..3.0, farthest: 3.0, ..PERPENDICULAR };
}

impl Formulation for Estimate {
    const DOMAIN: Domain = Domain { surface: 0.1, rough: 0.05, ..PERPENDICULAR };
}

impl Formulation for Interpolated {
    const DOMAIN: Domain = Domain { surface: 1e-3, rough: 4e-4, ..PERPENDICULAR };
}

impl Formulation for Refined {
    const DOMAIN: Domain = Domain { eye: 2.0..1e6, outline: 0.19, ..PERPENDICULAR };
}

impl Formulation for Constants {
    const DOMAIN: Domain = Refined::DOMAIN;
}

impl Formulation for InDouble {
    const DOMAIN: Domain = Domain { eye: 1.5..1e6, ..PERPENDICULAR };
}

impl Formulation for Unnormalised {
    const DOMAIN: Domain = Domain { lengths: 1e-6..1e6, touches: false, ..PERPENDICULAR };
}

/// A formulation that has a kernel for rays from anywhere.
pub trait ForAnyRay: Formulation + General {}
impl<F: Formulation + General> ForAnyRay for F {}

/// A formulation that has a kernel for primary rays.
pub trait ForTheEye: Formulation + Eye {}
impl<F: Formulation + Eye> ForTheEye for F {}
