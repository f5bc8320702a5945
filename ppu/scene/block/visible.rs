//! A block's objects as a picture has them, for whoever asks where two pictures differ.

use glam::DVec3;

use super::SceneBlock;
use super::bounding_sphere::{BoundingSphere, Hull};
use super::bvh::widened;
use super::chains::Chains;
use super::materials::Light;
use super::options::BlockOptions;

/// An object of a picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct VisiblePrimitive {
    /// What it is within, widened for the SPU's rounding.
    pub sphere: BoundingSphere,
    /// The same closer: it is straight between these.
    pub hull: Hull,
    /// A point of the plane that it lies in, and the plane's normal.
    pub plane: Option<(DVec3, DVec3)>,
    /// Address and size of its record, address of its material's.
    pub record: (u32, usize),
    pub material: u32,
    /// Whether others may be seen in it.
    pub sees_others: bool,
    /// Whether it is shaded beside where it is seen.
    pub is_bent: bool,
}

impl SceneBlock {
    /// How it was laid out.
    pub(crate) fn options(&self) -> BlockOptions {
        self.options
    }

    /// What its chains of rays are held to.
    pub(crate) fn chains(&self) -> Chains {
        self.chains
    }

    /// Its lights.
    pub(crate) fn lights(&self) -> &[Light] {
        &self.lights
    }

    /// The addresses at which objects have room, kind after kind, each with what is seen of the
    /// object there.
    pub(crate) fn slots(
        &self,
        eye: DVec3,
    ) -> impl Iterator<Item = (u32, Option<VisiblePrimitive>)> {
        let primitives = self.primitives.iter();
        let slots = primitives.flat_map(|primitives| {
            (0..primitives.slot_count()).map(move |number| primitives.slot(number))
        });
        slots.map(move |(address, object)| {
            let seen = object.map(|(object, material, sphere)| {
                let surface = self.materials.get(object.material as usize);
                VisiblePrimitive {
                    sphere: widened(eye, sphere),
                    hull: object.primitive.hull(),
                    plane: object.primitive.plane(),
                    is_bent: object.primitive.is_bent(),
                    record: (address, object.primitive.size()),
                    material: material.get(),
                    sees_others: surface
                        .and_then(|surface| *surface)
                        .is_none_or(|surface| surface.sends.goes_on()),
                }
            });
            (address, seen)
        })
    }
}
