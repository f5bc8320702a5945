//! A block's objects as they appear in a picture, used to find where two pictures differ.

use super::SceneBlock;
use super::bounding_sphere::BoundingSphere;
use super::chains::Chains;
use super::materials::Light;
use crate::scene::render_options::RenderOptions;

/// A primitive that may be visible in a picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct VisiblePrimitive {
    /// Its bounding sphere.
    pub sphere: BoundingSphere,
    /// A closer bound of some: the primitive is within the convex hull of these spheres.
    pub ends: Option<[BoundingSphere; 2]>,
    /// The address and the size of its record. `material` is the address of its material.
    pub record: (u32, usize),
    pub material: u32,
}

/// The most spheres around one primitive.
const MAX_PIECES: f64 = 8.0;

impl VisiblePrimitive {
    /// Adds spheres that the primitive is within: one, or a row of smaller ones if it is long.
    pub fn cover(&self, into: &mut Vec<BoundingSphere>) {
        let Some([from, to]) = self.ends else { return into.push(self.sphere) };
        let (way, radius) = (to.centre - from.centre, from.radius.max(to.radius));
        let length = way.length();
        let pieces = (length / radius).min(MAX_PIECES).floor();
        if pieces.is_nan() || pieces < 2.0 {
            return into.push(self.sphere);
        }
        let radius = radius + 0.5 * length / pieces;
        into.extend((0..pieces as usize).map(|piece| {
            let centre = from.centre + way * ((piece as f64 + 0.5) / pieces);
            BoundingSphere { centre, radius }.rounded()
        }));
    }
}

impl SceneBlock {
    /// The settings of the block.
    pub(crate) fn options(&self) -> RenderOptions {
        self.options
    }

    /// The bounds of its chains of rays.
    pub(crate) fn chains(&self) -> Chains {
        self.chains
    }

    pub(crate) fn lights(&self) -> &[Light] {
        &self.lights
    }

    /// The addresses of all slots, kind after kind, each with its object.
    pub(crate) fn slots(&self) -> impl Iterator<Item = (u32, Option<VisiblePrimitive>)> {
        let primitives = self.primitives.iter();
        let slots = primitives.flat_map(|primitives| {
            (0..primitives.slot_count()).map(move |number| primitives.slot(number))
        });
        slots.map(move |(address, object)| {
            let seen = object.map(|(object, material, sphere)| VisiblePrimitive {
                sphere,
                ends: object.primitive.ends(),
                record: (address, object.primitive.size()),
                material: material.get(),
            });
            (address, seen)
        })
    }
}
