//! Primitives: the forms that the SPUs intersect, in the scene's coordinates.
//!
//! Long cones are not cut into pieces: pieces no longer than they are wide make `mirrors` faster by
//! 3.5 % but `shapes` slower by 2 %.

use glam::DVec3;

use super::bounding_sphere::{BoundingSphere, Hull};
use super::bounds::Bounds;
use protocol::layout;

/// How far vertices may be off their polygon's plane, relative to its size, without being moved
/// onto it. The bound allows for the rounding of a scene file's numbers. Vertices that stay in
/// place leave no gap to polygons that share them.
pub(super) const FLAT: f64 = 1.0 / (1 << 18) as f64;

/// The kinds of primitives, in the order of the frame's trees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PrimitiveKind {
    Sphere,
    Rectangle,
    Triangle,
    Cone,
}

impl PrimitiveKind {
    pub const ALL: [Self; 4] = [Self::Sphere, Self::Rectangle, Self::Triangle, Self::Cone];

    /// The size in bytes of this kind's smallest record.
    pub fn least_size(self) -> usize {
        match self {
            Self::Sphere => size_of::<layout::Object>(),
            Self::Rectangle => size_of::<layout::Rectangle>(),
            Self::Triangle => size_of::<layout::Triangle>(),
            Self::Cone => size_of::<layout::Cone>(),
        }
    }

    /// The kind's name in messages, in plural.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sphere => "spheres",
            Self::Rectangle => "parallelograms",
            Self::Triangle => "triangles",
            Self::Cone => "cones",
        }
    }
}

/// The size in bytes of a patch's triangle.
pub(super) const PATCH_SIZE: usize = size_of::<layout::Patch>();

#[derive(Clone, Debug)]
pub(super) enum Primitive {
    /// If the radius is negative, the normal points inwards.
    Sphere { centre: DVec3, radius: f64 },
    Rectangle {
        corner: DVec3,
        edges: [DVec3; 2],
        normal: DVec3,
        /// The dual basis: the first one's products with the edges are 1 and 0, the second's 0 and
        /// 1.
        duals: [DVec3; 2],
    },
    Triangle {
        vertices: [DVec3; 3],
        /// The normal of the whole polygon.
        normal: DVec3,
        /// The vertices' normals that a patch interpolates, of length 1 or 0.
        smooth: Option<[DVec3; 3]>,
    },
    Cone {
        base: DVec3,
        axis: DVec3,
        height: f64,
        /// The radii at base and apex, not negative.
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

    /// The size of its record in bytes.
    pub fn size(&self) -> usize {
        match self {
            Self::Triangle { smooth: Some(_), .. } => PATCH_SIZE,
            _ => self.kind().least_size(),
        }
    }

    /// A cone's growth of the radius with the height; 0 for other primitives.
    pub fn growth(&self) -> f64 {
        match self {
            Self::Cone { radii, height, .. } => (radii[1] - radii[0]) / height,
            _ => 0.0,
        }
    }

    /// Two spheres that have the primitive in their convex hull, if it may be long.
    pub fn ends(&self) -> Option<[BoundingSphere; 2]> {
        match *self {
            Self::Cone { base, axis, height, radii: [low, high], .. } => Some([
                BoundingSphere { centre: base, radius: low },
                BoundingSphere { centre: base + height * axis, radius: high },
            ]),
            _ => None,
        }
    }

    /// Up to four spheres with the property that a sphere around all of them contains the
    /// primitive.
    pub fn hull(&self) -> Hull {
        match *self {
            Self::Sphere { centre, radius } => {
                Hull::of([BoundingSphere { centre, radius: radius.abs() }])
            }
            Self::Rectangle { corner, edges: [u, v], .. } => Hull::of(
                [corner, corner + u, corner + v, corner + u + v].map(BoundingSphere::point),
            ),
            Self::Triangle { vertices, .. } => Hull::of(vertices.map(BoundingSphere::point)),
            Self::Cone { base, axis, height, radii: [low, high], .. } => {
                // The centre is equally far from both discs' rims, unless that point is outside of
                // the cone.
                let equal = (height * height + (high - low) * (high + low)) / (2.0 * height);
                let middle = equal.clamp(0.0, height);
                // How far a disc of radius 1 across the axis reaches.
                let across = (DVec3::ONE - axis * axis).max(DVec3::ZERO).map(f64::sqrt);
                let disc = |centre: DVec3, radius: f64| Bounds {
                    low: centre - radius * across,
                    high: centre + radius * across,
                };
                Hull::of([BoundingSphere {
                    centre: base + middle * axis,
                    radius: libm::hypot(middle, low).max(libm::hypot(height - middle, high)),
                }])
                .within(disc(base, low).with(disc(base + height * axis, high)))
            }
        }
    }
}

/// A primitive: an object, or a part of one.
#[derive(Clone, Copy, Debug)]
pub(super) struct PrimitiveId {
    pub kind: PrimitiveKind,
    /// Number of its slot in the [`Primitives`](super::primitives::Primitives) of its kind.
    pub slot: usize,
}
