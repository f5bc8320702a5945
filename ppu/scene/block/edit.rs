//! Changes a block in place.
//!
//! Invariant: a change returns `false` if it doesn't fit the block's layout. Then, and after an
//! error, a new block must be made of the scene. A change allocates no memory, and the next
//! [`SceneBlock::write_for`] writes it. Call [`SceneBlock::bound_chains`] before that.

use std::sync::Arc;

use glam::DVec3;
use scenes::{Fog, HeightField, HeightRegion, LightKind, Material, Mesh, Shape, Sky};
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::U32;

use super::chains::Sends;
use super::error::BlockError;
use super::materials::{self, Light, ambient, brightest};
use super::objects::{self, Object, has_on_surface, sides_seen_from};
use super::primitive::{PrimitiveId, PrimitiveKind};
use super::shaders::ShaderEntries;
use super::source_location::SourceLocation;
use super::streamed::{InMainMemory, MovingSpheres, Streamed};
use super::{SceneBlock, Surface};
use crate::scene::RefitBy;
use protocol::layout::{self, MAX_OBJECTS, SCENE_ADDRESS, SIDES_BOTH};

/// The most objects or materials. It includes removed ones, because their numbers are not reused.
const MAX_NUMBERS: usize = 4 * MAX_OBJECTS as usize;

impl SceneBlock {
    /// Moves the triangles of the scene's mesh: it has the same ones, with other positions and
    /// normals. `false` if a new tree is needed.
    pub(crate) fn refit_mesh(&mut self, mesh: &Mesh, by: RefitBy) -> bool {
        let most = self.options.refit_pictures;
        let streamed = self.streamed.as_mut();
        streamed.is_some_and(|streamed| streamed.refit(mesh, by) && streamed.is_worth_keeping(most))
    }

    /// How many times the tests rays make that they made when the mesh's tree was built, as far as
    /// that is known: of vertices that no SPU has got yet, it is not.
    #[must_use]
    pub fn wear(&self) -> Option<f64> {
        self.streamed.as_ref().map(Streamed::wear)
    }

    /// Whether the mesh's tree lacks a triangle that had no area and has one now.
    pub(crate) fn lacks_triangles(&self, mesh: &Mesh) -> bool {
        self.streamed.as_ref().is_some_and(|it| it.blocks.lacks_triangles(mesh))
    }

    /// Counts a picture in which the mesh has not moved. `false` if a new tree is needed.
    pub(crate) fn keep_mesh(&mut self) -> bool {
        let most = self.options.refit_pictures;
        let worn = self.streamed.as_mut().filter(|it| it.wear() > 1.0);
        worn.is_none_or(|streamed| streamed.is_worth_keeping(most))
    }

    /// Takes over a region of a changed height field. The first time, that allocates memory.
    pub(crate) fn shape_ground(&mut self, field: &HeightField, region: &HeightRegion) {
        if let Some(heights) = self.streamed.as_mut().and_then(|it| it.heights.as_mut()) {
            heights.shape(field, region);
        }
    }

    /// Whether spheres or cones are in main memory.
    pub(crate) fn streams_objects(&self) -> bool {
        let streamed = self.streamed.as_ref();
        streamed.is_some_and(|streamed| streamed.kinds != InMainMemory::default())
    }

    /// Whether objects can be changed in place: those in main memory only if their blocks are made
    /// in the order of codes.
    pub(crate) fn may_change_objects(&self) -> bool {
        !self.streams_objects() || self.streamed.as_ref().is_some_and(Streamed::moves_objects)
    }

    /// The spheres in main memory, if they can be changed in place now.
    pub(crate) fn moving_spheres(&mut self) -> Option<MovingSpheres<'_>> {
        self.streamed.as_mut()?.moving_spheres()
    }

    /// Brings the changed objects into the blocks in main memory. Call it after the last change.
    /// `false` if a new tree is needed.
    pub(crate) fn move_objects(&mut self) -> bool {
        self.streamed.as_mut().is_none_or(Streamed::move_objects)
    }

    /// Sets the background, its gradient, and the fog.
    pub(crate) fn set_background(
        &mut self,
        background: DVec3,
        sky: Option<Sky>,
        fog: Option<Fog>,
        shaders: &ShaderEntries,
    ) -> Result<(), BlockError> {
        let shader = |name: &str| shaders.entry(name);
        let colour = self.options.colour;
        let record = materials::background(&self.file, background, sky, colour, &shader)?;
        // The background's material follows the background's object.
        let address = SCENE_ADDRESS + size_of::<layout::Object>() as u32;
        let bytes = self.block.at(address, size_of::<layout::Material>());
        bytes.copy_from_slice(record.as_bytes());
        self.background = brightest(background, sky, fog, colour);
        self.fog = materials::fog(&self.file, fog, colour)?;
        Ok(())
    }

    /// Sets the ambient light.
    pub(crate) fn set_ambient(&mut self, brightness: DVec3) -> Result<(), BlockError> {
        self.ambient = ambient(&self.file, brightness)?;
        Ok(())
    }

    /// Changes a light of the scene; without a brightness, it keeps its own.
    pub(crate) fn set_light(
        &mut self,
        number: usize,
        kind: LightKind,
        brightness: Option<DVec3>,
    ) -> Result<bool, BlockError> {
        let place = SourceLocation { file: &self.file, line: Some(number as u32 + 1) };
        let Some(light) = self.lights.get_mut(number) else {
            return Ok(false);
        };
        *light = match brightness {
            Some(brightness) => Light::of(kind, brightness, place)?,
            None => light.moved(kind, place)?,
        };
        Ok(true)
    }

    /// Changes a material of the scene, whether or not objects have it.
    pub(crate) fn set_material(
        &mut self,
        number: usize,
        material: &Material,
        shaders: &ShaderEntries,
    ) -> Result<bool, BlockError> {
        match self.materials.get(number) {
            None => Ok(false),
            // The record is written when an object needs it.
            Some(None) => Ok(true),
            // Other materials keep the record.
            Some(Some(Surface { is_shared: true, .. })) => Ok(false),
            Some(Some(Surface { address, texture, .. })) => {
                let (old, new) = (texture.as_ref(), material.texture.as_ref());
                if old.map(Arc::as_ptr) != new.map(Arc::as_ptr) {
                    // The mesh's blocks and tiles are made for the textures.
                    return Ok(false);
                }
                self.write_material(number, *address, material, shaders)?;
                Ok(true)
            }
        }
    }

    fn write_material(
        &mut self,
        number: usize,
        address: Option<u32>,
        material: &Material,
        shaders: &ShaderEntries,
    ) -> Result<(), BlockError> {
        let shader = |name: &str| shaders.entry(name);
        let streamed = self.streamed.as_ref();
        let surfacing = streamed.map(|it| it.surfacing(material)).unwrap_or_default();
        let record = materials::record(&self.file, material, surfacing, self.options, &shader)?;
        if let Some(address) = address {
            let bytes = self.block.at(address, record.as_bytes().len());
            bytes.copy_from_slice(record.as_bytes());
        }
        if let Some(streamed) = &mut self.streamed {
            streamed.set_material(number, &record);
        }
        self.materials[number] = Some(Surface {
            address,
            is_shared: false,
            sends: Sends::of(&record, material, self.options.colour),
            texture: material.texture.clone(),
        });
        Ok(())
    }

    /// Adds a material, which no object has yet, and returns its number; `None` if there is no
    /// space.
    pub(crate) fn add_material(&mut self) -> Option<usize> {
        let number = self.materials.len();
        if number == MAX_NUMBERS {
            return None;
        }
        self.materials.push(None);
        Some(number)
    }

    /// The address of a material. A material without an address gets one of the spare ones.
    fn material_address(
        &mut self,
        number: usize,
        material: &Material,
        shaders: &ShaderEntries,
    ) -> Result<Option<u32>, BlockError> {
        match self.materials.get(number) {
            None => Ok(None),
            Some(Some(Surface { address: Some(address), .. })) => Ok(Some(*address)),
            Some(_) => {
                let Some(address) = self.spare_materials.pop() else {
                    return Ok(None);
                };
                self.write_material(number, Some(address), material, shaders)?;
                Ok(Some(address))
            }
        }
    }

    /// Sets the eye for which objects are changed or added from now on. `false` if some object
    /// needs more or fewer primitives for it.
    pub(crate) fn set_eye(&mut self, eye: DVec3) -> bool {
        if self.objects_eye == eye {
            return true;
        }
        self.objects_eye = eye;
        let is_on = |slot: usize| {
            let spheres = &self.primitives[PrimitiveKind::Sphere as usize];
            let object = spheres.slot(slot).1?.0;
            Some((has_on_surface(eye, &object.primitive), object.sides))
        };
        self.objects.iter().all(|range| {
            let [PrimitiveId { kind: PrimitiveKind::Sphere, slot }, rest @ ..] =
                &self.parts[range.clone()]
            else {
                return true;
            };
            // Only spheres that are seen from both sides are two for an eye on them.
            let is_two = !rest.is_empty();
            is_on(*slot).is_none_or(|(is_on, sides)| {
                let may_be_two = is_two || sides == SIDES_BOTH;
                is_two == (is_on && may_be_two)
            })
        })
    }

    /// Gives an object of the scene another shape or another material.
    pub(crate) fn set_object(
        &mut self,
        number: usize,
        shape: &Shape,
        (material_number, material): (usize, &Material),
        shaders: &ShaderEntries,
    ) -> Result<bool, BlockError> {
        let place = SourceLocation { file: &self.file, line: Some(number as u32 + 1) };
        if let Some(streamed) = self.streamed.as_mut().filter(|it| it.kinds.holds(shape)) {
            return streamed.set_object(number, shape, (material_number, material), place);
        }
        let address = self.material_address(material_number, material, shaders)?;
        let (Some(address), Some(range)) = (address, self.objects.get(number)) else {
            return Ok(false);
        };
        let place = SourceLocation { file: &self.file, line: Some(number as u32 + 1) };
        let mut parts = self.parts[range.clone()].iter();
        let eye = self.objects_eye;
        let primitives = &mut self.primitives;
        let mut fits = true;
        objects::of_shape(shape, material, place, &mut |primitive, sides| {
            for sides in sides_seen_from(eye, &primitive, sides) {
                let object = Object {
                    primitive: primitive.clone(),
                    sides,
                    material: material_number as u32,
                };
                match parts.next() {
                    Some(&PrimitiveId { kind, slot })
                        if primitives[kind as usize].fits(slot, &object) =>
                    {
                        primitives[kind as usize].put(slot, object, U32::new(address));
                    }
                    _ => fits = false,
                }
            }
            Ok(())
        })?;
        Ok(fits && parts.next().is_none())
    }

    /// Takes an object out of the scene, and keeps its space reserved.
    pub(crate) fn hide_object(&mut self, number: usize) {
        if let Some(streamed) = &mut self.streamed {
            streamed.hide_object(number);
        }
        if let Some(range) = self.objects.get(number) {
            for &PrimitiveId { kind, slot } in &self.parts[range.clone()] {
                self.primitives[kind as usize].clear(slot);
            }
        }
    }

    /// Takes an object out of the scene, and frees its space. Its number stays unused.
    pub(crate) fn remove_object(&mut self, number: usize) {
        if let Some(streamed) = &mut self.streamed {
            streamed.hide_object(number);
        }
        if let Some(range) = self.objects.get_mut(number) {
            for &PrimitiveId { kind, slot } in &self.parts[range.clone()] {
                self.primitives[kind as usize].free(slot);
            }
            *range = 0..0;
        }
    }

    /// Adds an object, and returns its number; `None` if there is no space.
    pub(crate) fn add_object(
        &mut self,
        shape: &Shape,
        (material_number, material): (usize, &Material),
        shaders: &ShaderEntries,
    ) -> Result<Option<usize>, BlockError> {
        let number = self.objects.len();
        let is_streamed = self.streamed.as_ref().is_some_and(|it| it.kinds.holds(shape));
        if is_streamed || number == MAX_NUMBERS {
            return Ok(None);
        }
        let first = self.parts.len();
        let place = SourceLocation { file: &self.file, line: Some(number as u32 + 1) };
        let eye = self.objects_eye;
        let Self { primitives, parts, .. } = self;
        let mut fits = true;
        objects::of_shape(shape, material, place, &mut |primitive, sides| {
            let kind = primitive.kind();
            let primitives = &mut primitives[kind as usize];
            for _ in sides_seen_from(eye, &primitive, sides) {
                if primitives.count() == MAX_OBJECTS as usize {
                    return Err(BlockError::FullTree {
                        place: place.to_string(),
                        what: kind.name(),
                    });
                }
                match primitives.take(primitive.size()) {
                    Some(slot) => parts.push(PrimitiveId { kind, slot }),
                    None => fits = false,
                }
            }
            Ok(())
        })?;
        self.objects.push(first..self.parts.len());
        let fits = fits && self.set_object(number, shape, (material_number, material), shaders)?;
        Ok(fits.then_some(number))
    }
}
