//! Converts shapes to primitives, and writes their records.
//!
//! Invariant: an object's numbers are in range. The numbers of its record are computed relative to
//! the eye, and rounded once.

use glam::DVec3;
use scenes::{Material, Shape, unit};
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::{F32, U32};

use super::error::BlockError;
use super::polygons::{self, check_vertices};
use super::primitive::{Primitive, PrimitiveKind};
use super::source_location::SourceLocation;
use crate::scene::eye_side::EyeSide;
use crate::scene::mesh::Slant;
use crate::scene::single::{single, singles};
use protocol::layout::{self, SIDES_BOTH, SIDES_EXIT, SIDES_SMOOTH};

/// The part of the origin offset that covers the rounding of the object's numbers, relative to
/// their magnitudes.
///
/// A point's height over the surface is a sum of products of these numbers, each truncated by up
/// to 2^-23. This constant covers two such roundings of all of them. Rays are lost with half of it:
/// docs/whitted.md has the measurement.
const LEAVE: f64 = 1.0 / (1 << 22) as f64;

/// A primitive with its sides and its material, in the scene's coordinates.
#[derive(Clone, Debug)]
pub(super) struct Object {
    pub primitive: Primitive,
    /// `SIDES_` bits.
    pub sides: u32,
    /// Index of the material in the scene.
    pub material: u32,
}

/// The numbers of [`layout::Object`] that describe the surface.
struct Head {
    centre: DVec3,
    gain: f64,
    axis: DVec3,
    slope: f64,
    offset: f64,
    /// How far the surface extends from its centre, if the offset doesn't determine it.
    extent: f64,
}

/// The kind of primitive that a shape becomes, and about how many of them. The count is exact
/// except for polygons whose edges cross, or which have parts without area.
pub(super) fn about(shape: &Shape) -> (PrimitiveKind, usize) {
    match shape {
        Shape::Sphere { .. } => (PrimitiveKind::Sphere, 1),
        Shape::Cone { .. } => (PrimitiveKind::Cone, 1),
        Shape::Polygon { vertices } if polygons::rectangle(vertices).is_some() => {
            (PrimitiveKind::Rectangle, 1)
        }
        Shape::Polygon { vertices } | Shape::Patch { vertices, .. } => {
            (PrimitiveKind::Triangle, vertices.len().saturating_sub(2))
        }
    }
}

/// Calls `found` with each primitive of a shape and its sides; never if the shape has no surface.
pub(super) fn of_shape(
    shape: &Shape,
    material: &Material,
    place: SourceLocation<'_>,
    found: &mut impl FnMut(Primitive, u32) -> Result<(), BlockError>,
) -> Result<(), BlockError> {
    let both = if material.transmittance > 0.0 { SIDES_BOTH } else { 0 };
    match shape {
        &Shape::Sphere { centre, radius } => {
            place.vector("centre", centre)?;
            place.size("radius", radius)?;
            found(Primitive::Sphere { centre, radius }, sides_of_sphere(radius, material))
        }
        &Shape::Cone { base, base_radius, apex, apex_radius } => {
            place.vector("base", base)?;
            place.vector("apex", apex)?;
            place.number("base radius", base_radius)?;
            place.number("apex radius", apex_radius)?;
            let Some(axis) = unit(apex - base) else {
                return Ok(());
            };
            let height = (apex - base).dot(axis);
            place.size("height", height)?;
            let primitive = Primitive::Cone {
                base,
                axis,
                height,
                radii: [base_radius.abs(), apex_radius.abs()],
                hollow: base_radius.min(apex_radius) < 0.0,
            };
            let sides = if both != 0 || base_radius.max(apex_radius) > 0.0 {
                SIDES_BOTH
            } else {
                SIDES_EXIT
            };
            place.number("growth of the radius", primitive.growth())?;
            found(primitive, sides)
        }
        Shape::Polygon { vertices } => {
            check_vertices(vertices, place)?;
            match polygons::rectangle(vertices) {
                Some(rectangle) => found(rectangle, both),
                None => {
                    polygons::triangles(vertices, None, place, |primitive| found(primitive, both))
                }
            }
        }
        Shape::Patch { vertices, normals } => {
            check_vertices(vertices, place)?;
            polygons::triangles(vertices, Some(normals), place, |primitive| {
                let is_smooth = matches!(primitive, Primitive::Triangle { smooth: Some(_), .. });
                found(primitive, if is_smooth { both | SIDES_SMOOTH } else { both })
            })
        }
    }
}

/// The sides of a sphere of a material.
#[inline]
pub(super) fn sides_of_sphere(radius: f64, material: &Material) -> u32 {
    match () {
        () if material.transmittance > 0.0 => SIDES_BOTH,
        () if radius < 0.0 => SIDES_EXIT,
        () => 0,
    }
}

/// The sides of the objects that stand for a primitive with these sides: usually one. A sphere
/// that is seen from both sides is hit where a ray enters it, or from inside where the ray leaves.
/// For an eye on its surface that is two spheres, an entrance and an exit, because in singles only
/// these can be moved away from the eye without changing what the eye sees of them.
pub(super) fn sides_seen_from(
    eye: DVec3,
    primitive: &Primitive,
    sides: u32,
) -> impl Iterator<Item = u32> + use<> {
    let is_split = sides == SIDES_BOTH && has_on_surface(eye, primitive);
    let both = if is_split { [Some(0), Some(SIDES_EXIT)] } else { [Some(sides), None] };
    both.into_iter().flatten()
}

/// Whether the eye is on a sphere's surface.
pub(super) fn has_on_surface(eye: DVec3, primitive: &Primitive) -> bool {
    match *primitive {
        Primitive::Sphere { centre, radius } => EyeSide::of(eye, centre, radius) == EyeSide::On,
        _ => false,
    }
}

impl Head {
    fn of(primitive: &Primitive) -> Self {
        match *primitive {
            Primitive::Sphere { centre, radius } => Self {
                centre,
                gain: radius.signum(),
                axis: DVec3::ZERO,
                slope: 0.0,
                offset: radius,
                extent: 0.0,
            },
            Primitive::Rectangle { corner, edges: [u, v], normal, .. } => {
                let reach = [u, v, u + v].map(taxicab);
                Self::of_plane(corner, normal, reach.into_iter().fold(0.0, f64::max))
            }
            Primitive::Triangle { vertices: [a, b, c], normal, .. } => {
                Self::of_plane(a, normal, taxicab(b - a).max(taxicab(c - a)))
            }
            Primitive::Cone { base, axis, height, radii, hollow } => {
                let Slant { gain, slope } = Slant::of(primitive.growth(), hollow);
                Self {
                    centre: base,
                    gain,
                    axis,
                    slope,
                    offset: gain * radii[0],
                    extent: height + radii[0].max(radii[1]),
                }
            }
        }
    }

    fn of_plane(corner: DVec3, normal: DVec3, extent: f64) -> Self {
        Self { centre: corner, gain: 0.0, axis: normal, slope: 1.0, offset: 0.0, extent }
    }
}

impl Object {
    /// The part of the origin offset that covers the rounding of the object's numbers relative to
    /// `eye`. The coordinates of a point on the object add at most `leave` each to it.
    pub fn leave(&self, eye: DVec3) -> f64 {
        let Head { centre, offset, extent, .. } = Head::of(&self.primitive);
        LEAVE * (taxicab(centre - eye) + offset.abs() + extent)
    }

    /// A sphere's radius, moved away from an eye that is too near the surface for singles. An eye
    /// on the surface is inside an entrance and outside an exit: it sees neither where it is.
    fn radius_seen_from(&self, eye: DVec3) -> Option<f64> {
        let Primitive::Sphere { centre, radius } = self.primitive else {
            return None;
        };
        let side = match EyeSide::of(eye, centre, radius) {
            EyeSide::On if self.sides & (SIDES_BOTH | SIDES_EXIT) == 0 => EyeSide::Inside,
            EyeSide::On => EyeSide::Outside,
            side => side,
        };
        Some(side.clear_radius((centre - eye).length(), radius))
    }

    /// Writes the record relative to `eye`; `material` is the address of the object's material.
    pub fn write(&self, eye: DVec3, material: U32, bytes: &mut [u8]) {
        let Head { centre, gain, axis, slope, offset, .. } = Head::of(&self.primitive);
        let offset = self.radius_seen_from(eye).unwrap_or(offset);
        let centre = centre - eye;
        let head = layout::Object {
            centre: singles(centre),
            gain: single(gain),
            axis: singles(axis),
            slope: single(slope),
            offset: single(offset),
            leave: single(self.leave(eye)),
            material,
            sides: self.sides.into(),
        };
        let (first, rest) = bytes.split_at_mut(size_of::<layout::Object>());
        first.copy_from_slice(head.as_bytes());
        match self.primitive {
            Primitive::Sphere { .. } => {}
            Primitive::Rectangle { duals, .. } => put(rest, &duals.map(quadword)),
            Primitive::Triangle { vertices, smooth, .. } => {
                let corners = vertices.map(|vertex| quadword(vertex - eye));
                let (triangle, normals) = rest.split_at_mut(size_of_val(&corners));
                put(triangle, &corners);
                if let Some(smooth) = smooth {
                    put(normals, &smooth.map(quadword));
                }
            }
            Primitive::Cone { height, radii, .. } => {
                put(rest, &[[radii[0], self.primitive.growth(), height, 0.0].map(single)]);
            }
        }
    }
}

/// The object of the background, for rays that hit nothing: a plane through the eye.
pub(super) fn background(material: u32) -> layout::Object {
    layout::Object {
        centre: singles(DVec3::ZERO),
        gain: F32::ZERO,
        axis: singles(DVec3::Z),
        slope: single(1.0),
        offset: F32::ZERO,
        leave: F32::ZERO,
        material: material.into(),
        sides: SIDES_BOTH.into(),
    }
}

/// Writes quadwords to `bytes`.
fn put(bytes: &mut [u8], quadwords: &[[F32; 4]]) {
    bytes.copy_from_slice(quadwords.as_bytes());
}

fn quadword(vector: DVec3) -> [F32; 4] {
    let [x, y, z] = singles(vector);
    [x, y, z, F32::ZERO]
}

/// The sum of the magnitudes of a vector's components.
pub(super) fn taxicab(vector: DVec3) -> f64 {
    vector.abs().element_sum()
}
