//! Changing a block in place.
//!
//! Invariant: what is asked for has been done, or does not fit where the block has its things:
//! then the answer is `false`, and the scene has to be laid out anew. After an error it has to be
//! as well. What was changed is written by the next [`SceneBlock::write_for`], and takes no
//! memory; [`SceneBlock::bound_chains`] comes before it.

use glam::DVec3;
use nff::{LightKind, Material, Scene, Shape};
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::U32;

use super::chains::Sends;
use super::error::BlockError;
use super::materials::{self, Light};
use super::objects::{self, Object};
use super::options::{BlockOptions, ShaderEntries};
use super::range::SourceLocation;
use super::{PrimitiveId, SceneBlock, Spare, Surface, ambient};
use protocol::layout::{self, MAX_OBJECTS, SCENE_ADDRESS};

/// For one object of each kind that there are, the room for how many others is tried: as many
/// again, half, a quarter, an eighth.
const PARTS: [usize; 4] = [1, 2, 4, 8];
/// Room that is taken in any case.
const FEW: usize = 4;
/// Most objects or materials, those counted that were removed: their numbers are not given again.
const MOST_NUMBERS: usize = 4 * MAX_OBJECTS as usize;

impl SceneBlock {
    /// As [`SceneBlock::new`], with room for further objects and materials, as far as no fewer
    /// packets are traced together for it.
    pub(crate) fn with_room(
        scene: &Scene,
        options: BlockOptions,
        shaders: &ShaderEntries,
    ) -> Result<Self, BlockError> {
        let shader = |name: &str| shaders.entry(name);
        let tight = Self::new(scene, options, &shader)?;
        // What is added may reflect, even if nothing does as yet.
        let deepest = options.ray_depth;
        for part in PARTS {
            let more = |count: usize| if count == 0 { 0 } else { count / part + FEW };
            let spare = Spare {
                materials: more(tight.materials.len()),
                objects: tight
                    .primitives
                    .each_ref()
                    .map(|primitives| more(primitives.count())),
            };
            match Self::with_spare(scene, options, &shader, spare) {
                Ok(roomy) if roomy.batch_at(deepest) == tight.batch_at(deepest) => {
                    return Ok(roomy);
                }
                Ok(_) | Err(BlockError::TooLarge { .. }) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(tight)
    }

    /// Changes the colour where nothing is hit.
    pub(crate) fn set_background(&mut self, colour: DVec3) -> Result<(), BlockError> {
        let record = materials::background(&self.file, colour)?;
        // It follows the background's object.
        let address = SCENE_ADDRESS + size_of::<layout::Object>() as u32;
        let bytes = self.block.at(address, size_of::<layout::Material>());
        bytes.copy_from_slice(record.as_bytes());
        self.background = colour.max_element();
        Ok(())
    }

    /// Changes the light that is everywhere.
    pub(crate) fn set_ambient(&mut self, brightness: DVec3) -> Result<(), BlockError> {
        self.ambient = ambient(&self.file, brightness)?;
        Ok(())
    }

    /// Moves a light of the scene; without a brightness it stays as bright as it is.
    pub(crate) fn set_light(
        &mut self,
        number: usize,
        kind: LightKind,
        brightness: Option<DVec3>,
    ) -> Result<bool, BlockError> {
        let place = SourceLocation {
            file: &self.file,
            line: Some(number as u32 + 1),
        };
        let Some(light) = self.lights.get_mut(number) else {
            return Ok(false);
        };
        *light = match brightness {
            Some(brightness) => Light::of(kind, brightness, place)?,
            None => light.moved(kind, place)?,
        };
        Ok(true)
    }

    /// Changes a material of the scene that objects may be made of.
    pub(crate) fn set_material(
        &mut self,
        number: usize,
        material: &Material,
        shaders: &ShaderEntries,
    ) -> Result<bool, BlockError> {
        match self.materials.get(number) {
            None => Ok(false),
            // Its record is written when it is needed.
            Some(None) => Ok(true),
            Some(&Some(Surface { address, .. })) => {
                self.write_material(number, address, material, shaders)?;
                Ok(true)
            }
        }
    }

    fn write_material(
        &mut self,
        number: usize,
        address: u32,
        material: &Material,
        shaders: &ShaderEntries,
    ) -> Result<(), BlockError> {
        let shader = |name: &str| shaders.entry(name);
        let record = materials::record(&self.file, material, self.options, &shader)?;
        let bytes = self.block.at(address, record.as_bytes().len());
        bytes.copy_from_slice(record.as_bytes());
        self.materials[number] = Some(Surface {
            address,
            sends: Sends::of(&record, material),
        });
        Ok(())
    }

    /// Adds a material to the scene, of which no object is made as yet; its number, if there is
    /// room.
    pub(crate) fn add_material(&mut self) -> Option<usize> {
        let number = self.materials.len();
        if number == MOST_NUMBERS {
            return None;
        }
        self.materials.push(None);
        Some(number)
    }

    /// Address of a material, for which room is taken if it has none.
    fn material_address(
        &mut self,
        number: usize,
        material: &Material,
        shaders: &ShaderEntries,
    ) -> Result<Option<u32>, BlockError> {
        match self.materials.get(number) {
            None => Ok(None),
            Some(&Some(Surface { address, .. })) => Ok(Some(address)),
            Some(None) => {
                let Some(address) = self.material_room.pop() else {
                    return Ok(None);
                };
                self.write_material(number, address, material, shaders)?;
                Ok(Some(address))
            }
        }
    }

    /// Gives an object of the scene another shape or another material.
    pub(crate) fn set_object(
        &mut self,
        number: usize,
        shape: &Shape,
        (material_number, material): (usize, &Material),
        shaders: &ShaderEntries,
    ) -> Result<bool, BlockError> {
        let address = self.material_address(material_number, material, shaders)?;
        let (Some(address), Some(range)) = (address, self.objects.get(number)) else {
            return Ok(false);
        };
        let place = SourceLocation {
            file: &self.file,
            line: Some(number as u32 + 1),
        };
        let mut parts = self.parts[range.clone()].iter();
        let primitives = &mut self.primitives;
        let mut fits = true;
        objects::of_shape(shape, material, place, &mut |primitive, sides| {
            let object = Object {
                primitive,
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
            Ok(())
        })?;
        Ok(fits && parts.next().is_none())
    }

    /// Takes an object of the scene out of it; its room is kept.
    pub(crate) fn hide_object(&mut self, number: usize) {
        if let Some(range) = self.objects.get(number) {
            for &PrimitiveId { kind, slot } in &self.parts[range.clone()] {
                self.primitives[kind as usize].clear(slot);
            }
        }
    }

    /// Takes an object of the scene out of it for good: its number stands for nothing.
    pub(crate) fn remove_object(&mut self, number: usize) {
        if let Some(range) = self.objects.get_mut(number) {
            for &PrimitiveId { kind, slot } in &self.parts[range.clone()] {
                self.primitives[kind as usize].give_back(slot);
            }
            *range = 0..0;
        }
    }

    /// Adds an object to the scene; its number, if there is room.
    pub(crate) fn add_object(
        &mut self,
        shape: &Shape,
        (material_number, material): (usize, &Material),
        shaders: &ShaderEntries,
    ) -> Result<Option<usize>, BlockError> {
        let number = self.objects.len();
        if number == MOST_NUMBERS {
            return Ok(None);
        }
        let first = self.parts.len();
        let place = SourceLocation {
            file: &self.file,
            line: Some(number as u32 + 1),
        };
        let Self {
            primitives, parts, ..
        } = self;
        let mut fits = true;
        objects::of_shape(shape, material, place, &mut |primitive, _| {
            let kind = primitive.kind();
            let primitives = &mut primitives[kind as usize];
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
            Ok(())
        })?;
        self.objects.push(first..self.parts.len());
        let fits = fits && self.set_object(number, shape, (material_number, material), shaders)?;
        Ok(fits.then_some(number))
    }
}
