//! The expected cost of a packet's tests of a tree, which decides the volumes of its nodes.
//!
//! As in the surface area heuristic, the probability of a test is that of a random ray through the
//! scene to meet a volume. A packet is wider than a ray, so volumes are widened first; the surface
//! of a convex body that is widened by w is its surface + w times its integrated mean curvature +
//! 4 pi w^2 (Steiner). There are two sorts of packets:
//!
//! - Rays from the eye, and to lights, are tested by their cone alone. A sphere is left out if the
//!   cone misses it. A box, however, is only left out if a plane that touches the cone towards its
//!   middle separates both. So of a box counts not its shadow, but how far it reaches.
//! - The cones of scattered rays are so wide that most children pass. These are tested with the
//!   rays, which meet a volume about as often as a few independent rays do.
//!
//! The constants are such that the estimates agree with frames of the scenes in `scenes/`, traced
//! with spheres and with boxes (docs/whitted.md).
//!
//! Trees of cones are left to the packets' cones: testing the single rays with the children, too,
//! makes eye rays slower by 0.2 to 0.9 %, and with the shadow rays of later rays `mirrors` by 6 %.

use std::f64::consts::PI;

use glam::DVec3;

use super::bounding_sphere::BoundingSphere;
use super::bounds::Bounds;
use super::bvh::Volumes;
use super::primitive::PrimitiveKind;

/// Cycles of the kernels' loops, from lab/kernels/measured.txt: of a node's four children with a
/// packet's cone, and of a child with the packet's rays.
struct Cycles {
    cull: f64,
    filter: f64,
}

/// The width of a packet of rays from the eye or to a light, and that of the cone of scattered
/// rays, as parts of the scene's mean size.
const NARROW: f64 = 0.02;
const WIDE: f64 = 0.5;
/// The part of the packets whose rays are scattered.
const SCATTERED: f64 = 0.3;
/// As many independent rays meet a volume about as often as the sixteen of a scattered packet.
const INDEPENDENT: i32 = 4;
/// The cycles a packet by which the estimate may be off.
const MARGIN: f64 = 32.0;

/// The part of the faces that remain after backface culling.
const FACES: f64 = 0.6;
/// The cycles of backface culling.
const CULL_FACES: f64 = 16.0;

impl Volumes {
    fn cycles(self) -> Cycles {
        match self {
            Self::Spheres => Cycles { cull: 33.0, filter: 65.0 },
            Self::Boxes => Cycles { cull: 51.0, filter: 140.0 },
        }
    }
}

/// The cycles of a packet's test with an object.
fn object_cycles(kind: PrimitiveKind) -> f64 {
    match kind {
        PrimitiveKind::Sphere => 110.0,
        PrimitiveKind::Rectangle => CULL_FACES + FACES * 101.0,
        PrimitiveKind::Triangle => CULL_FACES + FACES * 194.0,
        PrimitiveKind::Cone => 364.0,
    }
}

/// The sizes of a volume, on which its probability to be met depends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    /// The surface.
    area: f64,
    /// 4 pi times the mean over all directions of the squared distance that it reaches from its
    /// middle: of a sphere, the surface.
    reach: f64,
    /// The surface's integrated mean curvature.
    curvature: f64,
}

impl Extent {
    pub fn of_sphere(sphere: &BoundingSphere) -> Self {
        let area = 4.0 * PI * sphere.radius * sphere.radius;
        Self { area, reach: area, curvature: 8.0 * PI * sphere.radius }
    }

    pub fn of_box(bounds: &Bounds) -> Self {
        let size = bounds.size();
        Self {
            area: 2.0 * bounds.half_area(),
            // With half sizes h and a unit vector w, the mean of (h.|w|)^2: that of a component's
            // square is 1/3, and that of two components' product 2 / (3 pi).
            reach: 4.0 * PI * (size.length_squared() / 12.0 + bounds.half_area() / (3.0 * PI)),
            curvature: 2.0 * PI * size.element_sum(),
        }
    }
}

/// The part of a scene's rays that meet a volume.
struct Chances {
    scene: Extent,
    /// The scene's mean size.
    size: f64,
}

impl Chances {
    fn of(scene: &Bounds) -> Self {
        Self { scene: Extent::of_box(scene), size: scene.size().element_sum() / 3.0 }
    }

    /// The probability that a packet's cone, this wide, is not found to miss a volume.
    fn cone(&self, volume: Extent, width: f64) -> f64 {
        let width = width * self.size;
        let widened =
            |surface: f64, curvature: f64| surface + width * curvature + 4.0 * PI * width * width;
        let scene = widened(self.scene.area, self.scene.curvature);
        (widened(volume.reach, volume.curvature) / scene).min(1.0)
    }

    /// The probability that one of a scattered packet's rays meets a volume.
    fn rays(&self, volume: Extent) -> f64 {
        let one = (volume.area / self.scene.area).min(1.0);
        1.0 - (1.0 - one).powi(INDEPENDENT)
    }
}

/// The expected cycles of a packet's tests with a tree over objects of a kind. `levels` has the
/// nodes' children of every level, from the lowest up.
pub(super) fn expected_cycles(
    kind: PrimitiveKind,
    volumes: Volumes,
    levels: &[Vec<Extent>],
    scene: &Bounds,
) -> f64 {
    let Cycles { cull, filter } = volumes.cycles();
    let chances = Chances::of(scene);
    // As the SPU program decides it.
    let is_filtered = levels.len() > 1 || kind == PrimitiveKind::Cone;
    let roots = levels.last().map_or(0, |top| top.len().div_ceil(4));
    let mut all = roots as f64 * cull;
    // For each node of the level below, the probabilities for both sorts of packets.
    let mut parents = vec![[1.0; 2]; roots];
    for (number, level) in levels.iter().enumerate().rev() {
        let test = match number {
            0 => object_cycles(kind),
            _ => cull,
        };
        let mut children = Vec::with_capacity(level.len());
        for (place, &volume) in level.iter().enumerate() {
            let [narrow, scattered] = parents[place / 4];
            let narrow = chances.cone(volume, NARROW).min(narrow);
            let passing = chances.cone(volume, WIDE).min(scattered);
            let scattered = if is_filtered {
                all += SCATTERED * passing * filter;
                chances.rays(volume).min(scattered)
            } else {
                passing
            };
            all += ((1.0 - SCATTERED) * narrow + SCATTERED * scattered) * test;
            children.push([narrow, scattered]);
        }
        parents = children;
    }
    all
}

/// Whether a tree with boxes is expected to gain for certain.
pub(super) fn boxes_gain(spheres: f64, boxes: f64) -> bool {
    boxes + MARGIN < spheres
}

/// A scene's box has a surface, even if all of it is in a plane or on a line.
pub(super) fn has_surface(scene: &Bounds) -> bool {
    let size = scene.size();
    size.is_finite() && size.cmpge(DVec3::ZERO).all() && scene.half_area() > 0.0
}
