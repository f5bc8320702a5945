//! The common imports of the families of cases.

pub(super) use glam::DVec3;
pub(super) use kernels::Bench;
pub(super) use kernels::cases::whitted::isect::call;
pub(super) use kernels::cases::whitted::isect::shape::Shape;
pub(super) use kernels::cases::whitted::isect::sphere::By;
pub(super) use kernels::cases::whitted::isect::triangle::TriangleObject;
pub(super) use kernels::flat_records::Point;
pub(super) use kernels::single::bits;
pub(super) use kernels::source::Source;
pub(super) use rand::Rng;
pub(super) use spu_emulator::float::single::{from_f64, to_f64};
pub(super) use thiserror::Error;
pub(super) use twins::Single;
pub(super) use twins::bounce::{CHAIN_STEP, Limits};
pub(super) use twins::sphere::Perpendicular;
pub(super) use twins::sphere_ray::Ray;

pub(super) use crate::families::Form;
pub(super) use crate::generator::Generator;
pub(super) use crate::space::{
    add_scaled, cross, direction, dot, fresh, in_cube, length, sub, two_sided, unit,
};
pub(super) use crate::stability::family::{
    Cases, Families, Family, Replayed, Tally, need, points_of,
};
pub(super) use crate::stability::random::{across, magnitude, rounded, towards};
pub(super) use crate::stability::statement::{Bound, stated};
pub(super) use crate::subject::Subject;
pub(super) use crate::truth::{Line, Vector, spacing};
