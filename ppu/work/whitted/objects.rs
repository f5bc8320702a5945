//! Objects: what the shapes of a scene become, and their records.
//!
//! Invariant: an object's numbers are in range; its record is rounded once, from numbers that are
//! relative to the eye.

use glam::DVec3;
use nff::{Material, Shape, unit};
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::{F32, U32};

use super::BlockError;
use super::ball::{Ball, Hull};
use super::polygons::{self, FLAT, check_vertices};
use super::range::Place;
use crate::scene::singles;
use protocol::layout::{self, SIDES_BOTH, SIDES_EXIT, SIDES_SMOOTH};

/// How far from its surface a ray starts for the rounding of the object's own numbers, in parts of
/// their magnitudes.
///
/// A point's height over the surface is a sum of products of them, each of which is truncated by up to
/// 2^-23: eight roundings of them all.
pub(super) const LEAVE: f64 = 1.0 / (1 << 20) as f64;

/// The shapes that SPUs know, in the order of the frame's trees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Sphere,
    Rectangle,
    Triangle,
    Cone,
}

impl Kind {
    pub const ALL: [Self; 4] = [Self::Sphere, Self::Rectangle, Self::Triangle, Self::Cone];

    /// Bytes that an object of this kind takes at least.
    pub fn least_size(self) -> usize {
        match self {
            Self::Sphere => size_of::<layout::Object>(),
            Self::Rectangle => size_of::<layout::Rectangle>(),
            Self::Triangle => size_of::<layout::Triangle>(),
            Self::Cone => size_of::<layout::Cone>(),
        }
    }

    /// Its name in messages, plural.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sphere => "spheres",
            Self::Rectangle => "parallelograms",
            Self::Triangle => "triangles",
            Self::Cone => "cones",
        }
    }
}

/// Bytes of a triangle of a patch.
pub(super) const PATCH_SIZE: usize = size_of::<layout::Patch>();

/// An object where the scene has it.
#[derive(Clone, Debug)]
pub(super) struct Object {
    pub form: Form,
    /// `SIDES_` bits.
    pub sides: u32,
    /// Index of the material in the scene.
    pub material: u32,
}

#[derive(Clone, Debug)]
pub(super) enum Form {
    /// With a radius below 0 the normal points inwards.
    Sphere { centre: DVec3, radius: f64 },
    Rectangle {
        corner: DVec3,
        edges: [DVec3; 2],
        normal: DVec3,
        /// Products with the edges are 1 and 0, and 0 and 1.
        duals: [DVec3; 2],
    },
    Triangle {
        vertices: [DVec3; 3],
        /// That of the whole polygon.
        normal: DVec3,
        /// Those that a patch interpolates, of length 1 or 0.
        smooth: Option<[DVec3; 3]>,
    },
    Cone {
        base: DVec3,
        axis: DVec3,
        height: f64,
        /// At base and apex, not negative.
        radii: [f64; 2],
        /// Whether the normal points inwards.
        hollow: bool,
    },
}

/// What [`layout::Object`] says of a surface.
struct Head {
    centre: DVec3,
    gain: f64,
    axis: DVec3,
    slope: f64,
    offset: f64,
    /// How far the surface reaches from its centre, where the offset does not say.
    extent: f64,
}

/// Of which kind the objects of a shape are, and about how many: exact, but for those of polygons
/// whose edges cross or that have parts without area.
pub(super) fn about(shape: &Shape) -> (Kind, usize) {
    match shape {
        Shape::Sphere { .. } => (Kind::Sphere, 1),
        Shape::Cone { .. } => (Kind::Cone, 1),
        Shape::Polygon { vertices } if polygons::rectangle(vertices).is_some() => {
            (Kind::Rectangle, 1)
        }
        Shape::Polygon { vertices } | Shape::Patch { vertices, .. } => {
            (Kind::Triangle, vertices.len().saturating_sub(2))
        }
    }
}

/// Hands `found` the objects of a shape, none if it has no surface.
pub(super) fn of_shape(
    shape: &Shape,
    material: &Material,
    place: Place<'_>,
    found: &mut impl FnMut(Form, u32) -> Result<(), BlockError>,
) -> Result<(), BlockError> {
    let both = if material.transmittance > 0.0 {
        SIDES_BOTH
    } else {
        0
    };
    match shape {
        &Shape::Sphere { centre, radius } => {
            place.vector("centre", centre)?;
            place.size("radius", radius)?;
            let exit = if radius < 0.0 { SIDES_EXIT } else { 0 };
            let sides = if both != 0 { both } else { exit };
            found(Form::Sphere { centre, radius }, sides)
        }
        &Shape::Cone {
            base,
            base_radius,
            apex,
            apex_radius,
        } => {
            place.vector("base", base)?;
            place.vector("apex", apex)?;
            place.number("base radius", base_radius)?;
            place.number("apex radius", apex_radius)?;
            let Some(axis) = unit(apex - base) else {
                return Ok(());
            };
            let height = (apex - base).dot(axis);
            place.size("height", height)?;
            let form = Form::Cone {
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
            place.number("growth of the radius", form.growth())?;
            found(form, sides)
        }
        Shape::Polygon { vertices } => {
            check_vertices(vertices, place)?;
            match polygons::rectangle(vertices) {
                Some(rectangle) => found(rectangle, both),
                None => polygons::triangles(vertices, None, place, |form| found(form, both)),
            }
        }
        Shape::Patch { vertices, normals } => {
            check_vertices(vertices, place)?;
            polygons::triangles(vertices, Some(normals), place, |form| {
                let is_smooth = matches!(
                    form,
                    Form::Triangle {
                        smooth: Some(_),
                        ..
                    }
                );
                found(form, if is_smooth { both | SIDES_SMOOTH } else { both })
            })
        }
    }
}

impl Form {
    pub fn kind(&self) -> Kind {
        match self {
            Self::Sphere { .. } => Kind::Sphere,
            Self::Rectangle { .. } => Kind::Rectangle,
            Self::Triangle { .. } => Kind::Triangle,
            Self::Cone { .. } => Kind::Cone,
        }
    }

    /// Bytes of its record.
    pub fn size(&self) -> usize {
        match self {
            Self::Triangle {
                smooth: Some(_), ..
            } => PATCH_SIZE,
            _ => self.kind().least_size(),
        }
    }

    /// Growth of a cone's radius with the height; 0 of all else.
    fn growth(&self) -> f64 {
        match self {
            Self::Cone { radii, height, .. } => (radii[1] - radii[0]) / height,
            _ => 0.0,
        }
    }

    /// Balls such that a ball around them is one around the object.
    pub fn hull(&self) -> Hull {
        match *self {
            Self::Sphere { centre, radius } => Hull::of([Ball {
                centre,
                radius: radius.abs(),
            }]),
            Self::Rectangle {
                corner,
                edges: [u, v],
                ..
            } => Hull::of([corner, corner + u, corner + v, corner + u + v].map(Ball::point)),
            Self::Triangle { vertices, .. } => Hull::of(vertices.map(Ball::point)),
            Self::Cone {
                base,
                axis,
                height,
                radii: [low, high],
                ..
            } => {
                // As far from one disc's rim as from the other's, unless one disc is the widest of all.
                let equal = (height * height + (high - low) * (high + low)) / (2.0 * height);
                let middle = equal.clamp(0.0, height);
                Hull::of([Ball {
                    centre: base + middle * axis,
                    radius: libm::hypot(middle, low).max(libm::hypot(height - middle, high)),
                }])
            }
        }
    }

    /// A point of the plane that it lies in, and the plane's normal; nothing for what is round.
    pub fn plane(&self) -> Option<(DVec3, DVec3)> {
        match *self {
            Self::Rectangle { corner, normal, .. } => Some((corner, normal)),
            Self::Triangle {
                vertices: [corner, ..],
                normal,
                ..
            } => Some((corner, normal)),
            Self::Sphere { .. } | Self::Cone { .. } => None,
        }
    }

    /// Whether it is shaded beside where it is hit: a triangle's point is put on the plane through its first vertex that
    /// has the whole polygon's normal, and a small triangle may be off that by what is nothing to a
    /// large polygon.
    pub fn is_bent(&self) -> bool {
        let Self::Triangle {
            vertices: [a, b, c],
            normal,
            ..
        } = *self
        else {
            return false;
        };
        let (ab, ac) = (b - a, c - a);
        let off = ab.dot(normal).abs().max(ac.dot(normal).abs());
        off > FLAT * ab.length().max(ac.length())
    }

    fn head(&self) -> Head {
        match *self {
            Self::Sphere { centre, radius } => Head {
                centre,
                gain: radius.signum(),
                axis: DVec3::ZERO,
                slope: 0.0,
                offset: radius,
                extent: 0.0,
            },
            Self::Rectangle {
                corner,
                edges: [u, v],
                normal,
                ..
            } => {
                let reach = [u, v, u + v].map(taxicab);
                Head::of_plane(corner, normal, reach.into_iter().fold(0.0, f64::max))
            }
            Self::Triangle {
                vertices: [a, b, c],
                normal,
                ..
            } => Head::of_plane(a, normal, taxicab(b - a).max(taxicab(c - a))),
            Self::Cone {
                base,
                axis,
                height,
                radii,
                hollow,
            } => {
                let growth = self.growth();
                let gain = libm::hypot(growth, 1.0).recip() * if hollow { -1.0 } else { 1.0 };
                Head {
                    centre: base,
                    gain,
                    axis,
                    slope: -gain * growth,
                    offset: gain * radii[0],
                    extent: height + radii[0].max(radii[1]),
                }
            }
        }
    }
}

impl Head {
    fn of_plane(corner: DVec3, normal: DVec3, extent: f64) -> Self {
        Self {
            centre: corner,
            gain: 0.0,
            axis: normal,
            slope: 1.0,
            offset: 0.0,
            extent,
        }
    }
}

impl Object {
    /// How far off its surface a ray has to start for the object's own numbers, as seen from `eye`. No
    /// coordinate of a point on it adds more than `leave` to that.
    pub fn leave(&self, eye: DVec3) -> f64 {
        let Head {
            centre,
            offset,
            extent,
            ..
        } = self.form.head();
        LEAVE * (taxicab(centre - eye) + offset.abs() + extent)
    }

    /// Writes the record, as seen from `eye`, to where it lies; `material` is its material's address.
    pub fn write(&self, eye: DVec3, material: U32, bytes: &mut [u8]) {
        let Head {
            centre,
            gain,
            axis,
            slope,
            offset,
            ..
        } = self.form.head();
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
        match self.form {
            Form::Sphere { .. } => {}
            Form::Rectangle { duals, .. } => put(rest, &duals.map(quadword)),
            Form::Triangle {
                vertices, smooth, ..
            } => {
                let corners = vertices.map(|vertex| quadword(vertex - eye));
                let (triangle, normals) = rest.split_at_mut(size_of_val(&corners));
                put(triangle, &corners);
                if let Some(smooth) = smooth {
                    put(normals, &smooth.map(quadword));
                }
            }
            Form::Cone { height, radii, .. } => {
                put(
                    rest,
                    &[[radii[0], self.form.growth(), height, 0.0].map(single)],
                );
            }
        }
    }
}

/// What a ray hits that hits nothing: a plane through the eye.
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

/// Fills `bytes` with quadwords.
fn put(bytes: &mut [u8], quadwords: &[[F32; 4]]) {
    bytes.copy_from_slice(quadwords.as_bytes());
}

fn quadword(vector: DVec3) -> [F32; 4] {
    let [x, y, z] = singles(vector);
    [x, y, z, F32::ZERO]
}

pub(super) fn single(value: f64) -> F32 {
    F32::new(value as f32)
}

/// The sum of a vector's magnitudes.
pub(super) fn taxicab(vector: DVec3) -> f64 {
    vector.abs().element_sum()
}
