//! The scene of Whitted's model in the SPUs' format: one block of records, at `SCENE_ADDRESS` of
//! every local store.
//!
//! All addresses, the materials and the trees are determined once, when the scene is loaded. For
//! each eye only the records with positions are written again. Positions are relative to the eye,
//! computed in `f64` and rounded once, so a scene far from its origin loses no precision near the
//! eye. The block begins with the background's object, for rays that hit nothing.
//!
//! The block of a scene that changes has spare room, and is edited in place.
//!
//! Invariant: a block fits the local store together with the queue of rays, and all addresses in
//! it are within it. The order of the file is not kept: a ray that hits several surfaces at equal
//! distance may take any of them.

mod alike;
mod bounding_sphere;
mod bounds;
mod bvh;
mod bytes;
mod chains;
mod cost;
mod edit;
mod error;
mod material_table;
mod materials;
mod memory_use;
mod objects;
mod offsets;
mod options;
mod polygons;
mod primitive;
mod primitives;
mod source_location;
mod streamed;
mod visible;

use std::collections::HashSet;
use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;
use scenes::{Scene, Sky, Texture};
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::{F32, U32};

use self::bounds::Bounds;
use self::bvh::Volumes;
use self::bytes::Block;
use self::chains::{Sends, greatest};
use self::materials::Surfacing;
use self::memory_use::MemoryUse;
use self::objects::{Object, sides_seen_from};
use self::primitive::PrimitiveKind;
use self::primitives::Primitives;
use self::source_location::SourceLocation;
use self::streamed::{InMainMemory, Streamed, may_stay};
use crate::scene::Colour;
use crate::scene::mesh::NumberWidth;
use crate::scene::render_options::NodeVolumes;
use crate::scene::single::singles;
use protocol::layout::{
    self, BOX_CODE_ROOM, BVH_TRIANGLES, Bvh, LARGE_OBJECTS, MAX_BATCH, MAX_DEPTH, MAX_LIGHTS,
    MAX_OBJECTS, QueuedRay, RayPacket, SCENE_ADDRESS, SCENE_ROOM, SMALL_BATCH, Shear,
};

pub(crate) use bounding_sphere::BoundingSphere;
pub(crate) use bvh::widened;
pub(crate) use chains::Chains;
pub use error::BlockError;
pub use material_table::MaterialTable;
pub(crate) use materials::Light;
pub(crate) use offsets::offset_note;
pub use options::BlockOptions;
pub(crate) use options::ShaderEntries;
pub use streamed::MeshPlace;
pub(crate) use visible::VisiblePrimitive;

/// The number of rays in a packet.
const PACKET: usize = 16;

/// A scene's block of records. Its buffers are reused for every eye.
#[derive(Clone, Debug)]
pub struct SceneBlock {
    file: String,
    options: BlockOptions,
    /// The greatest channel of the background's light.
    background: f64,
    ambient: [F32; 4],
    lights: Vec<Light>,
    light_address: u32,
    /// The materials by their numbers in the scene; `None` for materials that no object has.
    materials: Vec<Option<Surface>>,
    /// Addresses of spare room for materials.
    material_room: Vec<u32>,
    primitives: [Primitives; 4],
    /// For each object, by its number in the scene, the range of its primitives in `parts`.
    objects: Vec<Range<usize>>,
    parts: Vec<PrimitiveId>,
    chains: Chains,
    /// The mesh, if it is in main memory.
    streamed: Option<Streamed>,
    block: Block,
    /// The eye that the block is written for.
    eye: Option<DVec3>,
    /// The eye that the objects are made for: spheres that are seen from both sides are two if it
    /// is on their surface.
    objects_eye: DVec3,
}

/// A material in the block.
#[derive(Clone, Debug)]
struct Surface {
    /// The address of its record; `None` if it is only in main memory.
    address: Option<u32>,
    /// Whether other materials of the scene have the same record.
    is_shared: bool,
    sends: Sends,
    texture: Option<Arc<Texture>>,
}

/// What a block is made of.
#[derive(Clone, Copy)]
struct Source<'a> {
    scene: &'a Scene,
    options: BlockOptions,
    /// Looks up the entry of a shader of the SPU program by its name.
    shader: &'a dyn Fn(&str) -> Option<u32>,
    /// For each material of the scene the first one that shares its record.
    firsts: &'a [u32],
}

/// A primitive: an object, or a part of one.
#[derive(Clone, Copy, Debug)]
struct PrimitiveId {
    kind: PrimitiveKind,
    /// Number of its slot in the [`Primitives`] of its kind.
    slot: usize,
}

/// Room for materials and primitives that may be added.
#[derive(Clone, Copy, Debug, Default)]
struct Spare {
    materials: usize,
    objects: [usize; 4],
}

impl SceneBlock {
    /// Makes the block of a scene, and writes it for the scene's own view. `shader` looks up the
    /// entry of a shader of the SPU program by its name.
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
        options: BlockOptions,
        shader: &dyn Fn(&str) -> Option<u32>,
    ) -> Result<Self, BlockError> {
        Self::of(Source { scene, options, shader, firsts: &alike::firsts(&scene.materials) })
    }

    fn of(source: Source<'_>) -> Result<Self, BlockError> {
        let scene = source.scene;
        if may_stay(scene) {
            match Self::with_spare(source, Spare::default(), None) {
                Err(error) if error.is_lack_of_room() && scene.mesh.is_some() => {}
                done => return done,
            }
        }
        Self::streaming(source, InMainMemory::default())
    }

    /// A block whose mesh is in main memory, and so are its objects of these kinds. If local store
    /// lacks room for the materials, these are in main memory, too.
    fn streaming(source: Source<'_>, kinds: InMainMemory) -> Result<Self, BlockError> {
        let with = |streamed| Self::with_spare(source, Spare::default(), streamed);
        let streamed = Streamed::of(source, kinds, NumberWidth::Byte)?;
        let materials = streamed.as_ref().map_or(0, Streamed::resident_materials);
        let outcome = with(streamed);
        match outcome {
            Err(BlockError::TooLarge { needed, room, .. })
                if needed - room <= materials * size_of::<layout::Material>() =>
            {
                with(Streamed::of(source, kinds, NumberWidth::TwoBytes)?)
            }
            outcome => outcome,
        }
    }

    /// [`SceneBlock::new`] of a scene that stays as it is. Its spheres, its cones or both go to
    /// main memory if local store has no room for them.
    ///
    /// # Errors
    /// As for [`SceneBlock::new`].
    pub fn unchanging(
        scene: &Scene,
        options: BlockOptions,
        shader: &dyn Fn(&str) -> Option<u32>,
    ) -> Result<Self, BlockError> {
        Self::unchanging_of(Source {
            scene,
            options,
            shader,
            firsts: &alike::firsts(&scene.materials),
        })
    }

    fn unchanging_of(source: Source<'_>) -> Result<Self, BlockError> {
        let mut outcome = Self::of(source);
        for kinds in InMainMemory::choices(source.scene) {
            match &outcome {
                Err(error) if error.is_lack_of_room() => {}
                _ => break,
            }
            outcome = Self::streaming(source, kinds);
        }
        outcome
    }

    /// Without `streamed`, a mesh is in local store. The nodes of a tree become boxes if that is
    /// worth it, and their code and larger nodes take no room that batches need.
    fn with_spare(
        source: Source<'_>,
        spare: Spare,
        streamed: Option<Streamed>,
    ) -> Result<Self, BlockError> {
        let options = source.options;
        let is_streamed = streamed.is_some();
        let spheres = [Volumes::Spheres; 4];
        let plain = Self::with_volumes(source, spare, spheres, streamed)?;
        if is_streamed {
            return Ok(plain);
        }
        let bounds = plain.primitives.iter().map(Primitives::bounds);
        let bounds = bounds.fold(Bounds::NOTHING, Bounds::with);
        let primitives = plain.primitives.each_ref();
        let volumes = match options.volumes {
            NodeVolumes::Best => primitives.map(|it| it.better_volumes(&bounds)),
            NodeVolumes::Spheres => spheres,
            NodeVolumes::Boxes => primitives.map(Primitives::boxed_volumes),
        };
        if volumes == spheres {
            return Ok(plain);
        }
        // Boxes gain more than a large batch does, but less than a small one loses.
        let deepest = options.ray_depth;
        match Self::with_volumes(source, spare, volumes, None) {
            Ok(block) if block.small_batch_at(deepest) == plain.small_batch_at(deepest) => {
                Ok(block)
            }
            Ok(_) | Err(BlockError::TooLarge { .. }) => Ok(plain),
            Err(error) => Err(error),
        }
    }

    /// [`SceneBlock::with_spare`] with these volumes in the trees' nodes.
    fn with_volumes(
        source: Source<'_>,
        spare: Spare,
        volumes: [Volumes; 4],
        mut streamed: Option<Streamed>,
    ) -> Result<Self, BlockError> {
        let Source { scene, options, shader, firsts } = source;
        if !(1..=MAX_DEPTH).contains(&options.ray_depth) {
            return Err(BlockError::RayDepth(options.ray_depth));
        }
        let mut block = Block::default();
        add_background(scene, options.colour, shader, &mut block)?;
        if volumes.contains(&Volumes::Boxes) {
            // The code is the program's, which is not known here.
            block.reserve(BOX_CODE_ROOM as usize);
        }
        let ambient = ambient(&scene.name, scene.ambient)?;
        let lights = lights(scene)?;
        let light_address = block.reserve(lights.len() * size_of::<layout::Light>());

        let Found { found, objects, mut parts } =
            Found::of(scene, options.ray_depth, streamed.as_ref())?;
        let mut materials: Vec<Option<Surface>> = vec![None; scene.materials.len()];
        if let Some(streamed) = &mut streamed
            && let Some(textures) = &streamed.textures
        {
            streamed.texture_records = block.append(&textures.records(block.end()));
        }
        let record = |index: usize| {
            let material = &scene.materials[index];
            let surfacing = surfacing(streamed.as_ref(), material);
            let record = materials::record(&scene.name, material, surfacing, options, shader)?;
            let surface = Surface {
                address: None,
                is_shared: false,
                sends: Sends::of(&record, material, options.colour),
                texture: material.texture.clone(),
            };
            Ok::<_, BlockError>((record, surface))
        };
        // Those of a mesh in main memory are in a row, in the order of its blocks' numbers: in
        // local store, or in main memory, too.
        let start = block.end();
        let mut table = Vec::new();
        if let Some(streamed) = &streamed {
            for &index in streamed.blocks.materials() {
                let (record, mut surface) = record(index as usize)?;
                match streamed.blocks.width() {
                    NumberWidth::Byte => surface.address = Some(block.append(record.as_bytes())),
                    NumberWidth::TwoBytes => table.push(record),
                }
                materials[index as usize] = Some(surface);
            }
        }
        for object in found.iter().flatten() {
            let index = firsts[object.material as usize] as usize;
            if materials[index].as_ref().is_none_or(|it| it.address.is_none()) {
                let (record, mut surface) = record(index)?;
                surface.address = Some(block.append(record.as_bytes()));
                materials[index] = Some(surface);
            }
        }
        if let Some(streamed) = &mut streamed {
            streamed.place_materials(start, &table);
        }
        for (index, &first) in firsts.iter().enumerate() {
            let first = first as usize;
            if first != index
                && let Some(surface) = &mut materials[first]
            {
                surface.is_shared = true;
                materials[index] = materials[first].clone();
            }
        }
        let material_room =
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

        let mut scene_block = Self {
            file: scene.name.clone(),
            options,
            background: brightest(scene.background, scene.sky, options.colour),
            ambient,
            lights,
            light_address,
            materials,
            material_room,
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
        scene_block.check_room()?;
        scene_block.write_for(scene.view.from)?;
        Ok(scene_block)
    }

    /// Writes the block for an eye: only the changes if the eye is the last one, otherwise all
    /// records with positions.
    ///
    /// # Errors
    /// The eye is out of range; the block stays as it was.
    pub fn write_for(&mut self, eye: DVec3) -> Result<(), BlockError> {
        let place = SourceLocation { file: &self.file, line: None };
        place.vector("eye", eye)?;
        let is_other_eye = self.eye.replace(eye) != Some(eye);
        for primitives in &mut self.primitives {
            primitives.write(eye, is_other_eye, &mut self.block);
        }
        let leave = self.primitives.iter().map(Primitives::leave);
        let streamed = self.streamed.as_ref();
        let leave = leave.chain(streamed.map(|streamed| streamed.leave(eye)));
        let leave = leave.fold(0.0, f64::max);
        let size = size_of::<layout::Light>();
        let places = (self.light_address..).step_by(size);
        for (address, light) in places.zip(&self.lights) {
            let record = light.record(eye, leave);
            self.block.at(address, size).copy_from_slice(record.as_bytes());
        }
        Ok(())
    }

    /// The block's bytes, in whole lines, as they are copied to local store.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.block.bytes()
    }

    /// The BVHs of spheres, parallelograms, triangles and cones.
    #[must_use]
    pub fn bvhs(&self) -> [Bvh; 4] {
        self.primitives.each_ref().map(Primitives::record)
    }

    /// The trees whose nodes are boxes, as the frame has them. With any, the block has room for the
    /// code that tests boxes, at `BOX_CODE`.
    #[must_use]
    pub fn box_trees(&self) -> u32 {
        let trees = (0..).zip(&self.primitives);
        let bits = trees.map(|(tree, primitives)| match primitives.volumes() {
            Volumes::Spheres => 0,
            Volumes::Boxes => 1 << tree,
        });
        bits.sum()
    }

    /// The ambient light's brightness: red, green, blue, and 0.
    #[must_use]
    pub fn ambient(&self) -> [F32; 4] {
        self.ambient
    }

    /// The local-store address of the first light.
    #[must_use]
    pub fn light_address(&self) -> u32 {
        self.light_address
    }

    /// The number of lights.
    #[must_use]
    pub fn light_count(&self) -> u32 {
        self.lights.len() as u32
    }

    /// The longest chain of rays. It is the requested ray depth, or less if the scene's materials
    /// give no longer chain enough weight.
    #[must_use]
    pub fn ray_depth(&self) -> u32 {
        self.chains.ray_depth
    }

    /// The least weight of a secondary ray; lighter rays are not sent.
    #[must_use]
    pub fn least_weight(&self) -> f32 {
        self.chains.least_weight
    }

    /// The number of packets in a batch: as many as there is room for.
    #[must_use]
    pub fn batch(&self) -> u32 {
        self.batch_at(self.ray_depth()).unwrap_or(1)
    }

    /// The number of packets in a batch that there is room for with chains of `ray_depth` rays.
    fn batch_at(&self, ray_depth: u32) -> Option<u32> {
        let fits = |batch: &u32| self.bytes().len() <= self.room(*batch, ray_depth);
        let counts = self.primitives.iter().map(Primitives::count);
        let may_be_large = self.streamed.is_none() && counts.max() <= Some(LARGE_OBJECTS as usize);
        // Batches between these gained nothing in the scenes that have no room for the largest.
        let large = may_be_large.then_some(MAX_BATCH);
        large.into_iter().chain((1..=SMALL_BATCH).rev()).find(fits)
    }

    /// The same, of which only the size of a small batch counts.
    fn small_batch_at(&self, ray_depth: u32) -> Option<u32> {
        let batch = self.batch_at(ray_depth)?;
        Some(batch.min(SMALL_BATCH))
    }

    /// The bytes that the queue of rays, the buffers of a large batch, and a mesh's cache and code
    /// leave for the scene.
    fn room(&self, batch: u32, ray_depth: u32) -> usize {
        let mesh = self.streamed.as_ref().map_or(0, Streamed::least_room);
        let has_triangles = self.primitives[BVH_TRIANGLES as usize].count() > 0;
        let large = large_batch_bytes(batch, has_triangles);
        room(batch, ray_depth).saturating_sub(mesh + large)
    }

    /// The mesh that SPUs stream from main memory; `None` if the scene has none, or if it is small
    /// enough to be in local store.
    #[must_use]
    pub fn mesh(&self) -> Option<MeshPlace<'_>> {
        let streamed = self.streamed.as_ref()?;
        let queue = queue_bytes(self.batch(), self.ray_depth());
        let eye = self.eye.unwrap_or_default();
        Some(streamed.place(self.bytes().len() + queue, eye, self.options.mesh_cache))
    }

    /// Computes the bounds of the chains from the scene's materials and lights. Call it after
    /// these have changed. Returns whether there is room for the chains' rays.
    pub(crate) fn bound_chains(&mut self) -> bool {
        let lights = self.lights.iter().map(Light::brightness).sum();
        let bright = [self.background, greatest(&self.ambient), lights];
        let materials = self.materials.iter().flatten();
        let sends = materials.map(|surface| surface.sends);
        self.chains = Chains::of(self.options, sends, bright);
        self.batch_at(self.ray_depth()).is_some()
    }

    fn check_room(&self) -> Result<(), BlockError> {
        let (needed, room) = (self.bytes().len(), self.room(1, self.ray_depth()));
        if needed <= room {
            return Ok(());
        }
        let objects = self.primitives.each_ref();
        let objects = objects.map(|primitives| (primitives.count(), primitives.size()));
        let addresses = self.materials.iter().flatten();
        let addresses: HashSet<u32> = addresses.filter_map(|it| it.address).collect();
        let materials = addresses.len();
        let memory_use = MemoryUse::new(objects, materials, self.lights.len());
        Err(BlockError::TooLarge {
            file: self.file.clone(),
            needed,
            room,
            ray_depth: self.ray_depth(),
            consumers: memory_use.consumers(),
            fits: memory_use.fits(room),
        })
    }
}

/// What the streamed mesh has for a material.
fn surfacing(streamed: Option<&Streamed>, material: &scenes::Material) -> Surfacing {
    let Some(streamed) = streamed else {
        return Surfacing::default();
    };
    let texture = material.texture.as_ref();
    let address = texture.and_then(|texture| streamed.texture_address(texture));
    Surfacing { texture: address.unwrap_or_default(), is_coloured: streamed.blocks.is_coloured() }
}

/// The bytes that the queue of rays leaves for a scene.
fn room(batch: u32, ray_depth: u32) -> usize {
    (SCENE_ROOM as usize).saturating_sub(queue_bytes(batch, ray_depth))
}

/// The bytes of the queue of rays in local store: three batches, if chains have more than one ray.
fn queue_bytes(batch: u32, ray_depth: u32) -> usize {
    let batches = if ray_depth > 1 { 3 } else { 0 };
    PACKET * size_of::<QueuedRay>() * (batch * batches) as usize
}

/// The bytes of a batch's buffers that are not in the arena: the rays and, if there are triangles,
/// the shears of its packets.
fn large_batch_bytes(batch: u32, has_triangles: bool) -> usize {
    if batch <= SMALL_BATCH {
        return 0;
    }
    let shears = if has_triangles { size_of::<Shear>() } else { 0 };
    (2 * size_of::<RayPacket>() + shears) * batch as usize
}

/// The greatest channel of light that a ray which hits nothing can see.
fn brightest(background: DVec3, sky: Option<Sky>, colour: Colour) -> f64 {
    let zenith = sky.map_or(background, |sky| sky.zenith);
    colour.light(background.max(zenith)).max_element()
}

/// Begins a block with the background's object, for rays that hit nothing.
fn add_background(
    scene: &Scene,
    colour: Colour,
    shader: &dyn Fn(&str) -> Option<u32>,
    block: &mut Block,
) -> Result<(), BlockError> {
    let material = materials::background(&scene.name, scene.background, scene.sky, colour, shader)?;
    let size = size_of::<layout::Object>();
    let address = block.reserve(size);
    let object = objects::background(block.append(material.as_bytes()));
    block.at(address, size).copy_from_slice(object.as_bytes());
    Ok(())
}

fn ambient(file: &str, brightness: DVec3) -> Result<[F32; 4], BlockError> {
    let place = SourceLocation { file, line: None };
    place.vector("ambient light", brightness)?;
    let [red, green, blue] = singles(brightness);
    Ok([red, green, blue, F32::ZERO])
}

fn lights(scene: &Scene) -> Result<Vec<Light>, BlockError> {
    if let Some(light) = scene.lights.get(MAX_LIGHTS as usize) {
        return Err(BlockError::TooManyLights { file: scene.name.clone(), line: light.line });
    }
    let light = |light: &scenes::Light| {
        let place = SourceLocation { file: &scene.name, line: Some(light.line) };
        Light::of(light.kind, scene.brightness(light), place)
    };
    scene.lights.iter().map(light).collect()
}

/// A mesh's triangles as shapes, each with its material, and whether it is seen from both sides.
fn of_mesh(mesh: &Arc<scenes::Mesh>) -> impl Iterator<Item = (scenes::Shape, u32, bool)> {
    let triangles = mesh.materials.iter().enumerate();
    triangles.map(|(triangle, &material)| (mesh.shape(triangle), material, mesh.two_sided))
}

/// The primitives of a scene's objects.
#[derive(Default)]
struct Found {
    /// The primitives of each kind.
    found: [Vec<Object>; 4],
    /// For each object the range of its primitives in `parts`. There `slot` is an index in `found`.
    objects: Vec<Range<usize>>,
    parts: Vec<PrimitiveId>,
}

impl Found {
    /// What is in main memory is left out here.
    fn of(scene: &Scene, ray_depth: u32, streamed: Option<&Streamed>) -> Result<Self, BlockError> {
        let in_main_memory = streamed.map(|it| it.kinds).unwrap_or_default();
        let is_streamed = |shape: &scenes::Shape| in_main_memory.holds(shape);
        let Self { mut found, mut objects, mut parts } = Self::default();
        let eye = scene.view.from;
        let most = MAX_OBJECTS as usize;
        let mut counts = [0; 4];
        // The first object that exceeds the limit, and its kind.
        let mut too_many = None;
        for object in &scene.objects {
            let first = parts.len();
            let material = scene.materials.get(object.material as usize);
            if let Some(material) = material.filter(|_| !is_streamed(&object.shape)) {
                let place = SourceLocation { file: &scene.name, line: Some(object.line) };
                let (kind, about) = objects::about(&object.shape);
                // Above the limit, objects are still counted, but not split into triangles, which
                // takes time.
                if about > most || counts[kind as usize] > most {
                    counts[kind as usize] += about;
                    too_many.get_or_insert((place, kind));
                    continue;
                }
                objects::of_shape(&object.shape, material, place, &mut |primitive, sides| {
                    let kind = primitive.kind();
                    let found = &mut found[kind as usize];
                    for sides in sides_seen_from(eye, &primitive, sides) {
                        counts[kind as usize] += 1;
                        if found.len() == most {
                            too_many.get_or_insert((place, kind));
                            return Ok(());
                        }
                        parts.push(PrimitiveId { kind, slot: found.len() });
                        found.push(Object {
                            primitive: primitive.clone(),
                            sides,
                            material: object.material,
                        });
                    }
                    Ok(())
                })?;
            }
            objects.push(first..parts.len());
        }
        // A mesh in local store: its triangles are no objects of the scene, and come after them.
        for triangle in scene.mesh.iter().filter(|_| streamed.is_none()).flat_map(of_mesh) {
            let (shape, index, two_sided) = triangle;
            let kind = PrimitiveKind::Triangle;
            let place = SourceLocation { file: &scene.name, line: None };
            let Some(material) = scene.materials.get(index as usize) else {
                continue;
            };
            objects::of_shape(&shape, material, place, &mut |primitive, sides| {
                counts[kind as usize] += 1;
                if found[kind as usize].len() == most {
                    too_many.get_or_insert((place, kind));
                    return Ok(());
                }
                parts.push(PrimitiveId { kind, slot: found[kind as usize].len() });
                found[kind as usize].push(Object {
                    primitive,
                    sides: if two_sided { sides | layout::SIDES_BOTH } else { sides },
                    material: index,
                });
                Ok(())
            })?;
        }
        if let Some((place, kind)) = too_many {
            return Err(BlockError::TooManyObjects {
                place: place.to_string(),
                what: kind.name(),
                count: counts[kind as usize],
                fits: MemoryUse::of(scene, counts).fits(room(1, ray_depth)),
            });
        }
        Ok(Self { found, objects, parts })
    }
}

#[cfg(test)]
mod tests;
