//! Makes a scene's block.
//!
//! What doesn't fit local store in one layout is tried in another. `lay_out` makes
//! the block of a layout; the other methods choose among layouts.

use scenes::Scene;
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::U32;

use super::bounds::Bounds;
use super::bvh::Volumes;
use super::bytes::Block;
use super::chains::{Chains, Sends};
use super::error::BlockError;
use super::found::Found;
use super::materials;
use super::objects::{self, Object};
use super::primitive::PrimitiveKind;
use super::primitives::Primitives;
use super::shaders::ShaderEntries;
use super::streamed::{InMainMemory, Streamed, may_stay};
use super::{SceneBlock, Surface, alike};
use crate::scene::mesh::{MeshError, NumberWidth, Numbers};
use crate::scene::render_options::{NodeVolumes, RenderOptions};
use protocol::layout::{self, BOX_CODE_CAPACITY, MAX_DEPTH, SCENE_ADDRESS, SMALL_BATCH};

/// Amounts of spare capacity to try, as divisors of the number of objects: as many again, half as
/// many, a quarter, an eighth.
const PARTS: [usize; 4] = [1, 2, 4, 8];
/// Spare capacity that is added to each of these.
const FEW: usize = 4;

/// What a block is made of.
pub(super) struct Builder<'a> {
    scene: &'a Scene,
    options: RenderOptions,
    /// Looks up the entry of a shader of the SPU program by its name.
    shader: &'a dyn Fn(&str) -> Option<u32>,
    /// For each material of the scene the first one that shares its record.
    firsts: Vec<u32>,
}

/// Spare capacity for materials and primitives.
#[derive(Clone, Copy, Default)]
pub(super) struct Spare {
    materials: usize,
    objects: [usize; 4],
}

impl SceneBlock {
    /// Makes the block of a scene that stays as it is, and writes it for the scene's own view. Its
    /// mesh goes to main memory if it is large, or if it does not fit into local store, and so do
    /// its spheres, its cones or both. `shader` looks up the entry of a shader of the SPU program
    /// by its name.
    ///
    /// # Errors
    /// - The scene doesn't fit the local store, or has more lights, or more primitives of a kind,
    ///   than the SPUs support.
    /// - A number is out of the SPU's range.
    /// - A transparent material has no index of refraction.
    /// - The SPU program lacks a shader that a material names.
    /// - The ray depth is out of range.
    pub fn new(
        scene: &Scene,
        options: RenderOptions,
        shader: &dyn Fn(&str) -> Option<u32>,
    ) -> Result<Self, BlockError> {
        Builder::new(scene, options, shader).fitting()
    }

    /// [`SceneBlock::new`] with spare capacity for objects and materials: as much as makes the
    /// batches no smaller or, if any would, as little as there is, if they stay small batches.
    pub(crate) fn with_spare_capacity(
        scene: &Scene,
        options: RenderOptions,
        shaders: &ShaderEntries,
    ) -> Result<Self, BlockError> {
        Builder::new(scene, options, &|name| shaders.entry(name)).with_spare_capacity()
    }
}

impl<'a> Builder<'a> {
    /// Materials that are alike share a record.
    pub fn new(
        scene: &'a Scene,
        options: RenderOptions,
        shader: &'a dyn Fn(&str) -> Option<u32>,
    ) -> Self {
        Self { scene, options, shader, firsts: alike::firsts(&scene.materials) }
    }

    /// The block with as much in local store as fits: everything; or all but the
    /// mesh; or all but the mesh, and some kinds of objects.
    pub fn fitting(&self) -> Result<SceneBlock, BlockError> {
        let stays = may_stay(self.scene);
        let mesh = InMainMemory::default();
        let mut outcome = match stays {
            true => self.in_local_store(Spare::default()),
            false => self.in_main_memory(mesh),
        };
        let mesh = (stays && self.scene.mesh.is_some()).then_some(mesh);
        for kinds in mesh.into_iter().chain(InMainMemory::choices(self.scene)) {
            match &outcome {
                Err(error) if error.is_out_of_memory() => outcome = self.in_main_memory(kinds),
                _ => break,
            }
        }
        outcome
    }

    /// [`Builder::fitting`], and spare capacity if everything is in local store.
    pub fn with_spare_capacity(mut self) -> Result<SceneBlock, BlockError> {
        // Each material has a record of its own, so that it can be changed alone, unless they take
        // more than local store.
        let own: Vec<u32> = (0..).take(self.firsts.len()).collect();
        let firsts = std::mem::replace(&mut self.firsts, own);
        let mut outcome = self.fitting();
        let is_large = match &outcome {
            Ok(block) => block.streamed.as_ref().is_some_and(|it| it.table.is_some()),
            Err(BlockError::TooLarge { .. } | BlockError::TooManyObjects { .. }) => true,
            Err(BlockError::Mesh { source, .. }) => {
                matches!(source, MeshError::TooManyMaterials(_))
            }
            Err(_) => false,
        };
        if is_large && firsts != self.firsts {
            self.firsts = firsts;
            outcome = self.fitting();
        }
        let tight = outcome?;
        if tight.streamed.is_some() {
            // The mesh's cache takes the capacity that would be spare.
            return Ok(tight);
        }
        // Added objects may reflect, even if nothing does so far.
        let deepest = self.options.ray_depth;
        let mut smallest = None;
        for part in PARTS {
            let more = |count: usize| if count == 0 { 0 } else { count / part + FEW };
            let spare = Spare {
                materials: more(tight.materials.len()),
                objects: tight.primitives.each_ref().map(|primitives| more(primitives.count())),
            };
            match self.in_local_store(spare) {
                Ok(spacious) if spacious.batch_at(deepest) == tight.batch_at(deepest) => {
                    return Ok(spacious);
                }
                Ok(spacious)
                    if spacious.small_batch_at(deepest) == tight.small_batch_at(deepest) =>
                {
                    smallest = Some(spacious)
                }
                Ok(_) | Err(BlockError::TooLarge { .. }) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(smallest.unwrap_or(tight))
    }

    /// A block that has everything in local store. The nodes of a tree become boxes if that is
    /// worth it, and their code and larger nodes take no space that batches need.
    pub fn in_local_store(&self, spare: Spare) -> Result<SceneBlock, BlockError> {
        let spheres = [Volumes::Spheres; 4];
        let plain = self.lay_out(spare, spheres, None)?;
        let bounds = plain.primitives.iter().map(Primitives::bounds);
        let bounds = bounds.fold(Bounds::NOTHING, Bounds::with);
        let primitives = plain.primitives.each_ref();
        let volumes = match self.options.volumes {
            NodeVolumes::Best => primitives.map(|it| it.better_volumes(&bounds)),
            NodeVolumes::Spheres => spheres,
            NodeVolumes::Boxes => primitives.map(Primitives::boxed_volumes),
        };
        if volumes == spheres {
            return Ok(plain);
        }
        // Boxes gain more than a large batch does, but less than a small one loses.
        let deepest = self.options.ray_depth;
        match self.lay_out(spare, volumes, None) {
            Ok(block) if block.small_batch_at(deepest) == plain.small_batch_at(deepest) => {
                Ok(block)
            }
            Ok(_) | Err(BlockError::TooLarge { .. }) => Ok(plain),
            Err(error) => Err(error),
        }
    }

    /// A block whose mesh is in main memory, and so are its objects of these kinds. If local store
    /// lacks space for the materials, or for whole batches beside them, these are in main memory,
    /// too: fetching a few for each batch takes less time than smaller batches do.
    pub fn in_main_memory(&self, kinds: InMainMemory) -> Result<SceneBlock, BlockError> {
        let streamed = |minimum| {
            let numbers = Numbers { firsts: &self.firsts, minimum };
            Streamed::of(self.scene, kinds, numbers, self.options)
        };
        let lay_out = |streamed| self.lay_out(Spare::default(), [Volumes::Spheres; 4], streamed);
        let narrow = streamed(NumberWidth::Byte)?;
        let materials = narrow.as_ref().map_or(0, Streamed::resident_materials);
        let materials = materials * size_of::<layout::Material>();
        let outcome = lay_out(narrow);
        let move_out = match &outcome {
            // What is sorted has no other numbers of materials.
            Ok(block) if block.streamed.as_ref().is_some_and(|it| it.sorted.is_none()) => {
                let deepest = self.options.ray_depth;
                let batch = block.small_batch_at(deepest);
                batch < Some(SMALL_BATCH) && block.small_batch_without(materials, deepest) > batch
            }
            Err(BlockError::TooLarge { needed, capacity, .. }) => needed - capacity <= materials,
            _ => false,
        };
        if move_out { lay_out(streamed(NumberWidth::TwoBytes)?) } else { outcome }
    }

    /// The block with this spare capacity and these volumes in the trees' nodes; with `streamed`,
    /// its mesh is in main memory.
    fn lay_out(
        &self,
        spare: Spare,
        volumes: [Volumes; 4],
        mut streamed: Option<Streamed>,
    ) -> Result<SceneBlock, BlockError> {
        let Self { scene, options, .. } = *self;
        if !(1..=MAX_DEPTH).contains(&options.ray_depth) {
            return Err(BlockError::RayDepth(options.ray_depth));
        }
        let mut block = Block::default();
        self.add_background(&mut block)?;
        if volumes.contains(&Volumes::Boxes) {
            // The code is the program's, which is not known here.
            block.reserve(BOX_CODE_CAPACITY as usize);
        }
        let ambient = materials::ambient(&scene.name, scene.ambient)?;
        let lights = materials::lights(scene)?;
        let light_address = block.reserve(lights.len() * size_of::<layout::Light>());
        let Found { found, objects, mut parts } =
            Found::of(scene, options.ray_depth, streamed.as_ref())?;
        if let Some(streamed) = &mut streamed {
            streamed.add_textures(&mut block);
        }
        let materials = self.add_materials(&found, streamed.as_mut(), &mut block)?;
        let spare_materials =
            (0..spare.materials).map(|_| block.reserve(size_of::<layout::Material>())).collect();
        let material = |object: &Object| {
            let surface = materials[object.material as usize].as_ref();
            U32::new(surface.and_then(|it| it.address).unwrap_or(SCENE_ADDRESS))
        };
        let mut slots = PrimitiveKind::ALL.map(|kind| vec![0; found[kind as usize].len()]);
        let primitives = PrimitiveKind::ALL.map(|kind| {
            let (found, slots) = (&found[kind as usize], &mut slots[kind as usize]);
            let number = |index: usize, slot: usize| slots[index] = slot;
            let spare = spare.objects[kind as usize];
            let volumes = volumes[kind as usize];
            Primitives::new(kind, found, spare, volumes, material, number, &mut block)
        });
        for part in &mut parts {
            part.slot = slots[part.kind as usize][part.slot];
        }
        block.finish();

        let mut scene_block = SceneBlock {
            file: scene.name.clone(),
            options,
            background: materials::brightest(
                scene.background,
                scene.sky,
                scene.fog,
                options.colour,
            ),
            ambient,
            fog: materials::fog(&scene.name, scene.fog, options.colour)?,
            lights,
            light_address,
            materials,
            spare_materials,
            primitives,
            objects,
            parts,
            chains: Chains::UNBOUNDED,
            streamed,
            block,
            eye: None,
            objects_eye: scene.view.from,
        };
        scene_block.bound_chains();
        scene_block.check_size()?;
        scene_block.write_for(scene.view.from)?;
        Ok(scene_block)
    }

    /// Begins a block with the background's object, for rays that hit nothing.
    fn add_background(&self, block: &mut Block) -> Result<(), BlockError> {
        let Scene { name, background, sky, .. } = self.scene;
        let colour = self.options.colour;
        let material = materials::background(name, *background, *sky, colour, self.shader)?;
        let size = size_of::<layout::Object>();
        let address = block.reserve(size);
        let object = objects::background(block.append(material.as_bytes()));
        block.at(address, size).copy_from_slice(object.as_bytes());
        Ok(())
    }

    /// Adds the records of materials that objects have, and returns the materials by their numbers
    /// in the scene. Those of a mesh in main memory come first and are in a row, in the order of
    /// its blocks' numbers: in local store, or in main memory, too.
    fn add_materials(
        &self,
        found: &[Vec<Object>; 4],
        mut streamed: Option<&mut Streamed>,
        block: &mut Block,
    ) -> Result<Vec<Option<Surface>>, BlockError> {
        let Self { scene, options, .. } = *self;
        let record = |streamed: Option<&Streamed>, index: usize| {
            let material = &scene.materials[index];
            let surfacing = streamed.map(|it| it.surfacing(material)).unwrap_or_default();
            let record = materials::record(&scene.name, material, surfacing, options, self.shader)?;
            let surface = Surface {
                address: None,
                is_shared: false,
                sends: Sends::of(&record, material, options.colour),
                texture: material.texture.clone(),
            };
            Ok::<_, BlockError>((record, surface))
        };
        let mut materials: Vec<Option<Surface>> = vec![None; scene.materials.len()];
        let start = block.end();
        let mut table = Vec::new();
        if let Some(streamed) = streamed.as_deref() {
            for &index in streamed.blocks.materials() {
                let (record, mut surface) = record(Some(streamed), index as usize)?;
                match streamed.blocks.width() {
                    NumberWidth::Byte => surface.address = Some(block.append(record.as_bytes())),
                    NumberWidth::TwoBytes => table.push(record),
                }
                materials[index as usize] = Some(surface);
            }
        }
        for object in found.iter().flatten() {
            let index = self.firsts[object.material as usize] as usize;
            if materials[index].as_ref().is_none_or(|it| it.address.is_none()) {
                let (record, mut surface) = record(streamed.as_deref(), index)?;
                surface.address = Some(block.append(record.as_bytes()));
                materials[index] = Some(surface);
            }
        }
        if let Some(streamed) = &mut streamed {
            streamed.place_materials(start, &table);
        }
        for (index, &first) in self.firsts.iter().enumerate() {
            let first = first as usize;
            if first != index
                && let Some(surface) = &mut materials[first]
            {
                surface.is_shared = true;
                materials[index] = materials[first].clone();
            }
        }
        Ok(materials)
    }
}
