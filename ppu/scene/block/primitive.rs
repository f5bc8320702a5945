//! What the shapes of a scene become: the forms that SPUs know, each where the scene has it.

use glam::DVec3;

use super::bounding_sphere::{BoundingSphere, Hull};
use protocol::layout;

/// What vertices may be off their polygon's plane, in parts of its size: no more than numbers of a
/// scene are rounded by. They stay where they are, so that polygons that share them leave no gap.
pub(super) const FLAT: f64 = 1.0 / (1 << 18) as f64;

/// The shapes that SPUs know, in the order of the frame's trees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PrimitiveKind {
    Sphere,
    Rectangle,
    Triangle,
    Cone,
}

impl PrimitiveKind {
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

#[derive(Clone, Debug)]
pub(super) enum Primitive {
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

impl Primitive {
    pub fn kind(&self) -> PrimitiveKind {
        match self {
            Self::Sphere { .. } => PrimitiveKind::Sphere,
            Self::Rectangle { .. } => PrimitiveKind::Rectangle,
            Self::Triangle { .. } => PrimitiveKind::Triangle,
            Self::Cone { .. } => PrimitiveKind::Cone,
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
    pub fn growth(&self) -> f64 {
        match self {
            Self::Cone { radii, height, .. } => (radii[1] - radii[0]) / height,
            _ => 0.0,
        }
    }

    /// Spheres such that a sphere around them is one around the object.
    pub fn hull(&self) -> Hull {
        match *self {
            Self::Sphere { centre, radius } => Hull::of([BoundingSphere {
                centre,
                radius: radius.abs(),
            }]),
            Self::Rectangle {
                corner,
                edges: [u, v],
                ..
            } => Hull::of(
                [corner, corner + u, corner + v, corner + u + v].map(BoundingSphere::point),
            ),
            Self::Triangle { vertices, .. } => Hull::of(vertices.map(BoundingSphere::point)),
            Self::Cone {
                base,
                axis,
                height,
                radii: [low, high],
                ..
            } => {
                // As far from one disc's rim as from the other's, unless one disc is the widest of
                // all.
                let equal = (height * height + (high - low) * (high + low)) / (2.0 * height);
                let middle = equal.clamp(0.0, height);
                Hull::of([BoundingSphere {
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

    /// Whether it is shaded beside where it is hit: a triangle's point is put on the plane through
    /// its first vertex that has the whole polygon's normal, and a small triangle may be off that
    /// by what is nothing to a large polygon.
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
}
