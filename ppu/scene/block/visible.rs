//! A block's objects as they appear in a picture, used to find where two pictures differ.

use super::SceneBlock;
use super::bounding_sphere::{BoundingSphere, Hull};
use super::chains::Chains;
use super::materials::Light;
use crate::scene::render_options::RenderOptions;

/// A primitive that may be visible in a picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct VisiblePrimitive {
    /// Its bounding sphere.
    pub sphere: BoundingSphere,
    /// A closer bound: the primitive is within the convex hull of these spheres.
    pub hull: Hull,
    /// The address and the size of its record. `material` is the address of its material.
    pub record: (u32, usize),
    pub material: u32,
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
                hull: object.primitive.hull(),
                record: (address, object.primitive.size()),
                material: material.get(),
            });
            (address, seen)
        })
    }
}
