//! The part of a scene that SPUs stream from main memory: its mesh, and spheres or cones if there
//! are too many; and what of these is in local store.

use std::collections::HashSet;
use std::sync::Arc;

use glam::DVec3;
use protocol::layout::{
    self, COLOUR_CODE, EYE_CODE, HEIGHT_CODE, MESH_BLOCK, MESH_MAX_SLOTS, MESH_TEXTURES,
    SCENE_ADDRESS, SCENE_CAPACITY, TEXTURE_CODE,
};
use scenes::{Material, Mesh, Scene, Shape, Texture};
use zerocopy::big_endian::F32;

use super::bytes::Block;
use super::error::BlockError;
use super::material_table::MaterialTable;
use super::materials::Surfacing;
use super::objects::{self, taxicab};
use super::primitive::Primitive;
use super::source_location::SourceLocation;
use crate::scene::colour::Colour;
use crate::scene::height::{HeightView, HeightViews};
use crate::scene::mesh::{
    Ground, MeshBlocks, MeshCone, MeshObject, MeshObjects, MeshSphere, MovedVertices,
    MovingObjects, NumberWidth, Numbers, RESIDENT, SortedMesh,
};
use crate::scene::render_options::{BuildBy, RefitBy, RenderOptions};
use crate::scene::single::singles;
use crate::scene::texture::Textures;

/// As `Object::leave`, for what is in blocks. Rays that leave a flat face thus start outside its
/// box, whose slack is as large, and skip the boxes of all that lies in its plane.
const LEAVE: f64 = 1.0 / (1 << 19) as f64;
/// The minimum capacity of the cache, in blocks.
const MIN_SLOTS: usize = 6;

/// About how many times the tests rays make with a tree in the order of codes that they make with
/// one by the surface area heuristic. `docs/meshes.md` has the measurements.
const WEAR_OF_CODES: f64 = 1.25;

/// The kinds of a scene's objects that are in main memory beside its mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct InMainMemory {
    spheres: bool,
    cones: bool,
}

impl InMainMemory {
    const SPHERES: Self = Self { spheres: true, cones: false };
    const CONES: Self = Self { spheres: false, cones: true };
    const BOTH: Self = Self { spheres: true, cones: true };

    /// What may be in main memory of a scene that does not fit into local store, in the order in
    /// which it is to be tried: one kind if that is enough, as objects in local store are quicker.
    /// Choices that leave more there than it could ever hold are left out, for a tree of very many
    /// spheres takes time.
    pub fn choices(scene: &Scene) -> Vec<Self> {
        let count = |kind: Self| {
            let objects = scene.objects.iter();
            objects.filter(|object| kind.holds(&object.shape)).count()
        };
        let [spheres, cones] = [Self::SPHERES, Self::CONES].map(count);
        let capacity = (EYE_CODE - SCENE_ADDRESS) as usize - MIN_SLOTS * MESH_BLOCK as usize;
        let mut choices = Vec::new();
        if spheres > 0 && cones * size_of::<layout::Cone>() <= capacity {
            choices.push(Self::SPHERES);
        }
        if cones > 0 && spheres * size_of::<layout::Object>() <= capacity {
            choices.push(Self::CONES);
        }
        if spheres > 0 && cones > 0 {
            choices.push(Self::BOTH);
        }
        choices
    }

    /// Whether a shape is among them.
    pub fn holds(self, shape: &Shape) -> bool {
        match shape {
            Shape::Sphere { .. } => self.spheres,
            Shape::Cone { .. } => self.cones,
            Shape::Polygon { .. } | Shape::Patch { .. } => false,
        }
    }
}

/// A scene's mesh in main memory.
#[derive(Clone, Debug)]
pub(super) struct Streamed {
    pub blocks: Arc<MeshBlocks>,
    /// Its vertices, if SPUs are to refit the blocks with them.
    moved: Option<Arc<MovedVertices>>,
    /// What its blocks are made of, if that is done in the order of codes, and by SPUs or not.
    pub(super) sorted: Option<(Arc<SortedMesh>, BuildBy)>,
    /// Its spheres and cones, if these are what is sorted.
    moving: Option<MovingObjects>,
    /// What its refitted tree has cost since it was built: tests of rays that a new one would not
    /// have needed, in pictures.
    wasted_pictures: f64,
    /// The point of the scene that positions in blocks are relative to.
    origin: DVec3,
    /// The corners of the box around it.
    bounds: [DVec3; 2],
    /// The scene's objects that are there, too.
    pub kinds: InMainMemory,
    /// The address of the first of its materials, which are in a row, if they are in local store.
    materials: u32,
    /// Its materials, if they are in main memory.
    pub table: Option<Arc<MaterialTable>>,
    /// The textures of these, if there are any.
    textures: Option<Arc<Textures>>,
    /// The scene's height field, if it has one.
    pub heights: Option<HeightViews>,
    /// Whether it has nothing else, and its material is in local store.
    is_ground: bool,
    /// The address of their records.
    texture_records: u32,
}

/// The part of a frame that describes a scene's mesh to the SPUs.
#[derive(Clone, Copy, Debug)]
pub struct MeshPlace<'a> {
    /// The blocks in main memory.
    pub blocks: &'a Arc<MeshBlocks>,
    /// The vertices with which SPUs refit the blocks before they trace them, if they do.
    pub moved: Option<&'a Arc<MovedVertices>>,
    /// What SPUs make the blocks of before they trace them, if they do.
    pub sorted: Option<&'a Arc<SortedMesh>>,
    /// The local-store address of the first material, if they are there.
    pub materials: u32,
    /// The materials, if they are in main memory.
    pub table: Option<&'a Arc<MaterialTable>>,
    /// The number of materials.
    pub material_count: u32,
    /// The local-store address of the cache.
    pub cache: u32,
    /// The capacity of the cache, in blocks.
    pub slots: u32,
    /// The textures in main memory, if there are any.
    pub textures: Option<&'a Arc<Textures>>,
    /// Whether the height field is all that is in main memory.
    pub is_ground: bool,
    /// The height field as the eye sees it, if there is one.
    pub(crate) heights: Option<&'a Arc<HeightView>>,
    /// The local-store address of their records.
    pub texture_records: u32,
    /// The eye relative to the blocks' origin, and 0.
    pub eye: [F32; 4],
}

/// The spheres in main memory, which may be very many: what all of them need is looked up once.
pub(crate) struct MovingSpheres<'a> {
    sorted: &'a mut SortedMesh,
    moving: &'a mut MovingObjects,
    origin: DVec3,
}

impl MovingSpheres<'_> {
    /// Does what [`SceneBlock::set_object`](super::SceneBlock::set_object) does, for a sphere whose
    /// numbers are in range. `false` if a new tree is needed.
    #[inline]
    pub fn set(
        &mut self,
        number: usize,
        (centre, radius): (DVec3, f64),
        (material_number, material): (usize, &Material),
    ) -> bool {
        let sphere = MeshSphere {
            centre: (centre - self.origin).as_vec3(),
            radius: radius as f32,
            sides: objects::sides_of_sphere(radius, material),
            material: material_number as u32,
        };
        self.moving.set_sphere(self.sorted, number, &sphere)
    }
}

impl Streamed {
    /// The blocks of a scene's mesh, and of its objects of these kinds; `None` if there is nothing
    /// for these.
    pub fn of(
        scene: &Scene,
        kinds: InMainMemory,
        numbers: Numbers<'_>,
        options: RenderOptions,
    ) -> Result<Option<Self>, BlockError> {
        let colour = options.colour;
        let origin = match &scene.mesh {
            Some(mesh) => mesh.origin,
            None => match &scene.heights {
                Some(field) => field.corner,
                None => origin_of_objects(scene),
            },
        };
        let found = objects(scene, kinds, origin)?;
        let objects = MeshObjects::of(found.iter().map(|(_, object)| *object));
        if scene.mesh.is_none() && objects.is_empty() && scene.heights.is_none() {
            return Ok(None);
        }
        let wrong = |source| BlockError::Mesh { file: scene.name.clone(), source };
        let nothing = Mesh::default();
        let mesh = scene.mesh.as_deref().unwrap_or(&nothing);
        let heights = scene.heights.as_ref();
        let heights =
            heights.map(|field| (HeightViews::new(field, origin, colour), field.material));
        let ground = heights.as_ref().map(|(heights, material)| {
            Ground::new(heights.bounds().map(|corner| corner - origin), *material)
        });
        let materials = &scene.materials;
        let is_alone_ground = objects.is_empty() && scene.mesh.is_none();
        let by = options.build_by.filter(|by| *by != BuildBy::PpuSurfaces && ground.is_none());
        let to_sort = by.and_then(|by| match (&scene.mesh, objects.is_empty()) {
            (_, true) => {
                let (blocks, sorted) = MeshBlocks::to_sort(mesh, materials, numbers)?;
                Some((by, blocks, sorted, None))
            }
            (None, false) => {
                let count = materials.len();
                let (blocks, sorted, moving) = MeshBlocks::objects_to_sort(&found, count, numbers)?;
                Some((by, blocks, sorted, Some(moving)))
            }
            (Some(_), false) => None,
        });
        let (blocks, sorted, moving) = match to_sort {
            Some((by, mut blocks, sorted, moving)) => {
                if by == BuildBy::PpuCodes {
                    blocks.make_sorted(mesh, &sorted);
                }
                (blocks, Some((Arc::new(sorted), by)), moving)
            }
            None => {
                let of = MeshBlocks::numbered(mesh, &objects, ground, materials, numbers, colour);
                (of.map_err(wrong)?, None, None)
            }
        };
        let corners = found.iter().flat_map(|(_, object)| object.corners());
        let of_ground = heights.iter().flat_map(|(heights, _)| heights.bounds());
        let corners = corners.map(|corner| origin + corner).chain(of_ground);
        let bounds = mesh.bounds().map(|(low, high)| [low, high]);
        let bounds = corners.fold(bounds, |bounds, corner| {
            let [low, high] = bounds.unwrap_or([corner; 2]);
            Some([low.min(corner), high.max(corner)])
        });
        Ok(Some(Self {
            wasted_pictures: 0.0,
            origin,
            bounds: bounds.unwrap_or_default(),
            kinds,
            textures: textures(scene, &blocks, colour)?,
            is_ground: is_alone_ground,
            heights: heights.map(|(heights, _)| heights),
            blocks: Arc::new(blocks),
            moved: None,
            sorted,
            moving,
            materials: SCENE_ADDRESS,
            table: None,
            texture_records: SCENE_ADDRESS,
        }))
    }

    /// How many materials it has in local store.
    pub fn resident_materials(&self) -> usize {
        match self.blocks.width() {
            NumberWidth::Byte => self.blocks.materials().len(),
            NumberWidth::TwoBytes => 0,
        }
    }

    /// Sets where its materials are: at this address, unless main memory is to have them.
    pub fn place_materials(&mut self, address: u32, table: &[layout::Material]) {
        self.materials = address;
        let has_table = self.blocks.width() == NumberWidth::TwoBytes;
        self.table = has_table.then(|| Arc::new(MaterialTable::new(table)));
    }

    /// Adds its textures' records to the scene's block.
    pub fn add_textures(&mut self, block: &mut Block) {
        if let Some(textures) = &self.textures {
            self.texture_records = block.append(&textures.records(block.end()));
        }
    }

    /// What it has for a material.
    pub fn surfacing(&self, material: &Material) -> Surfacing {
        let texture = material.texture.as_ref();
        let address = texture.and_then(|texture| self.texture_address(texture));
        Surfacing { texture: address.unwrap_or_default(), is_coloured: self.is_coloured() }
    }

    /// Whether triangles have colours at their vertices.
    fn is_coloured(&self) -> bool {
        self.blocks.is_coloured() || self.heights.is_some()
    }

    /// Replaces the record that main memory has of a material of the scene, if it has one.
    pub fn set_material(&mut self, material: usize, record: &layout::Material) {
        let mut materials = self.blocks.materials().iter();
        if let Some(table) = &mut self.table
            && let Some(number) = materials.position(|&it| it as usize == material)
        {
            Arc::make_mut(table).set(number, record);
        }
    }

    /// Moves the triangles, or leaves that to SPUs; `false` if a new tree is needed.
    pub fn refit(&mut self, mesh: &Mesh, by: RefitBy) -> bool {
        if let Some((sorted, by)) = &mut self.sorted {
            // An engine that has made the blocks no longer has the vertices.
            let (Some(sorted), Some((low, high))) = (Arc::get_mut(sorted), mesh.bounds()) else {
                return false;
            };
            if !sorted.move_to(mesh, &self.blocks) {
                return false;
            }
            if *by == BuildBy::PpuCodes {
                Arc::make_mut(&mut self.blocks).make_sorted(mesh, sorted);
            }
            self.bounds = [low, high];
            return true;
        }
        // An engine that has refitted the blocks no longer has the vertices.
        let moved = self.moved.take().filter(|it| Arc::strong_count(it) == 1);
        if by == RefitBy::Spus {
            let mut moved = moved.unwrap_or_default();
            let vertices = Arc::get_mut(&mut moved);
            let bounds = vertices.and_then(|vertices| self.blocks.move_vertices(mesh, vertices));
            if let Some(bounds) = bounds {
                self.moved = Some(moved);
                self.bounds = bounds;
                return true;
            }
        }
        let (Some(blocks), Some((low, high))) = (self.blocks.refitted(mesh), mesh.bounds()) else {
            return false;
        };
        self.blocks = Arc::new(blocks);
        let ground = self.heights.as_ref().map(HeightViews::bounds);
        let [other_low, other_high] = ground.unwrap_or([low, high]);
        self.bounds = [low.min(other_low), high.max(other_high)];
        true
    }

    /// Gives a sphere or a cone of the scene another shape or another material; `false` if a new
    /// tree is needed.
    pub fn set_object(
        &mut self,
        number: usize,
        shape: &Shape,
        (material_number, material): (usize, &Material),
        place: SourceLocation<'_>,
    ) -> Result<bool, BlockError> {
        let object = mesh_object(shape, (material_number as u32, material), self.origin, place)?;
        let (Some(object), Some((sorted, moving))) = (object, self.moving()) else {
            return Ok(false);
        };
        Ok(moving.set(sorted, number, &object))
    }

    /// Its spheres, if they can be changed in place now.
    pub fn moving_spheres(&mut self) -> Option<MovingSpheres<'_>> {
        let (origin, has_spheres) = (self.origin, self.kinds.spheres);
        let (sorted, moving) = self.moving().filter(|_| has_spheres)?;
        Some(MovingSpheres { sorted, moving, origin })
    }

    /// What is sorted, if it is spheres and cones, unless an engine still has their blocks made.
    fn moving(&mut self) -> Option<(&mut SortedMesh, &mut MovingObjects)> {
        let sorted = self.sorted.as_mut().and_then(|(sorted, _)| Arc::get_mut(sorted))?;
        Some((sorted, self.moving.as_mut()?))
    }

    /// Whether its spheres and cones can be changed in place.
    pub fn moves_objects(&self) -> bool {
        self.moving.is_some()
    }

    /// Takes a sphere or a cone out of the picture.
    pub fn hide_object(&mut self, number: usize) {
        if let Some(moving) = &mut self.moving {
            moving.hide(number);
        }
    }

    /// Brings changed spheres and cones into its blocks, or leaves that to SPUs; `false` if a new
    /// tree is needed, because none is left, or because positions would lose precision.
    pub fn move_objects(&mut self) -> bool {
        if self.moving.as_ref().is_none_or(|moving| !moving.are_changed()) {
            return true;
        }
        let bounds = self.moving().and_then(|(sorted, moving)| moving.apply(sorted));
        let (Some([low, high]), Some((sorted, by))) = (bounds, &self.sorted) else {
            return false;
        };
        if !is_near(DVec3::ZERO, [low, high]) {
            return false;
        }
        if self.blocks.count() != sorted.most_blocks() {
            Arc::make_mut(&mut self.blocks).make_space(sorted);
        }
        if *by == BuildBy::PpuCodes {
            Arc::make_mut(&mut self.blocks).make_sorted(&Mesh::default(), sorted);
        }
        self.bounds = [low, high].map(|corner| self.origin + corner);
        self.wasted_pictures = 0.0;
        true
    }

    /// [`SceneBlock::wear`](super::SceneBlock::wear).
    pub fn wear(&self) -> f64 {
        match (&self.moved, &self.sorted) {
            (Some(moved), _) => self.blocks.wear_of(moved).unwrap_or(1.0),
            (None, Some(_)) => WEAR_OF_CODES,
            (None, None) => self.blocks.wear(),
        }
    }

    /// Counts a picture, and returns whether rays have wasted fewer tests than they make in `most`
    /// pictures with a new tree. So what refitting has cost is never much more than a new tree
    /// would have, whether a tree is worn a little for long or much at once.
    pub fn is_worth_keeping(&mut self, most: u32) -> bool {
        self.wasted_pictures += (self.wear() - 1.0).max(0.0);
        self.wasted_pictures < f64::from(most)
    }

    /// The largest origin offset of its triangles, as the SPUs compute it for one.
    pub fn leave(&self, eye: DVec3) -> f64 {
        let [low, high] = self.bounds;
        let farthest = (low - eye).abs().max((high - eye).abs());
        LEAVE * (taxicab(farthest) + taxicab(high - low))
    }

    /// Where the mesh's cache ends: before the code that it needs.
    fn end(&self) -> u32 {
        match &self.textures {
            _ if self.heights.is_some() => HEIGHT_CODE,
            _ if self.blocks.is_coloured() => COLOUR_CODE,
            Some(_) => TEXTURE_CODE,
            None => EYE_CODE,
        }
    }

    /// The minimum number of bytes that the mesh takes from the space of a scene and its queue.
    pub fn minimum_size(&self) -> usize {
        let code = SCENE_ADDRESS + SCENE_CAPACITY - self.end();
        code as usize + MIN_SLOTS * MESH_BLOCK as usize
    }

    /// The address of a texture's record, if it is one of the mesh's.
    fn texture_address(&self, texture: &Arc<Texture>) -> Option<u32> {
        let number = self.textures.as_ref()?.number_of(texture)?;
        let size = size_of::<protocol::layout::Texture>();
        Some(self.texture_records + (number * size) as u32)
    }

    /// Its place beside a scene's block and queue of these sizes, with at most `most` blocks
    /// in the cache.
    pub fn place(&self, used: usize, eye: DVec3, most: u32) -> MeshPlace<'_> {
        let capacity = (self.end() - SCENE_ADDRESS).saturating_sub(used as u32);
        let slots = (capacity / MESH_BLOCK).min(MESH_MAX_SLOTS).min(most);
        let [x, y, z] = singles(eye - self.origin);
        MeshPlace {
            blocks: &self.blocks,
            moved: self.moved.as_ref(),
            sorted: self.sorted.as_ref().filter(|it| it.1 == BuildBy::SpuCodes).map(|it| &it.0),
            materials: self.materials,
            table: self.table.as_ref(),
            material_count: self
                .table
                .as_ref()
                .map_or(self.blocks.materials().len() as u32, |table| table.count()),
            cache: self.end() - slots * MESH_BLOCK,
            slots,
            textures: self.textures.as_ref(),
            is_ground: self.is_ground && self.table.is_none(),
            heights: self.heights.as_ref().map(HeightViews::view),
            texture_records: self.texture_records,
            eye: [x, y, z, F32::ZERO],
        }
    }
}

/// The textures of a mesh's materials, if it has texture coordinates.
fn textures(
    scene: &Scene,
    blocks: &MeshBlocks,
    colour: Colour,
) -> Result<Option<Arc<Textures>>, BlockError> {
    let mesh = scene.mesh.as_ref();
    if mesh.is_none_or(|mesh| mesh.texture_coordinates.is_empty()) {
        return Ok(None);
    }
    let mut known = HashSet::new();
    let mut found: Vec<Arc<Texture>> = Vec::new();
    for &number in blocks.materials() {
        let texture = scene.materials[number as usize].texture.as_ref();
        if let Some(texture) = texture.filter(|it| known.insert(Arc::as_ptr(it))) {
            found.push(texture.clone());
        }
    }
    if found.len() > MESH_TEXTURES as usize {
        return Err(BlockError::TooManyTextures { file: scene.name.clone(), count: found.len() });
    }
    Ok((!found.is_empty()).then(|| Arc::new(Textures::new(found, colour))))
}

/// The origin for the spheres and cones of a scene that has no mesh: the eye of the scene's view,
/// as then neither the eye nor what is near it is rounded much. Far away, the objects themselves
/// matter more.
fn origin_of_objects(scene: &Scene) -> DVec3 {
    let boxes = scene.objects.iter().filter_map(|object| match object.shape {
        Shape::Sphere { centre, radius } => Some([centre - radius.abs(), centre + radius.abs()]),
        Shape::Cone { base, apex, .. } => Some([base.min(apex), base.max(apex)]),
        Shape::Polygon { .. } | Shape::Patch { .. } => None,
    });
    let around = boxes
        .reduce(|[low, high], [other_low, other_high]| [low.min(other_low), high.max(other_high)]);
    let eye = scene.view.from;
    around.map_or(DVec3::ZERO, |[low, high]| {
        if is_near(eye, [low, high]) { eye } else { Mesh::origin_for(low, high) }
    })
}

/// Whether a point is no farther from a box than this is large.
fn is_near(point: DVec3, [low, high]: [DVec3; 2]) -> bool {
    let away = (point - point.clamp(low, high)).abs().max_element();
    away <= (high - low).max_element()
}

/// A scene's objects of these kinds and their numbers, with single precision, relative to an
/// origin.
fn objects(
    scene: &Scene,
    kinds: InMainMemory,
    origin: DVec3,
) -> Result<Vec<(usize, MeshObject)>, BlockError> {
    let mut found = Vec::new();
    for (number, object) in scene.objects.iter().enumerate() {
        let Some(material) = scene.materials.get(object.material as usize) else {
            continue;
        };
        if !kinds.holds(&object.shape) {
            continue;
        }
        let place = SourceLocation { file: &scene.name, line: Some(object.line) };
        let material = (object.material, material);
        found.extend(
            mesh_object(&object.shape, material, origin, place)?.map(|object| (number, object)),
        );
    }
    Ok(found)
}

/// A sphere or a cone of a material, whose number comes first; `None` if it has no surface.
fn mesh_object(
    shape: &Shape,
    (number, material): (u32, &Material),
    origin: DVec3,
    place: SourceLocation<'_>,
) -> Result<Option<MeshObject>, BlockError> {
    let mut found = None;
    objects::of_shape(shape, material, place, &mut |primitive, sides| {
        match primitive {
            Primitive::Sphere { centre, radius } => {
                found = Some(MeshObject::Sphere(MeshSphere {
                    centre: (centre - origin).as_vec3(),
                    radius: radius as f32,
                    sides,
                    material: number,
                }));
            }
            Primitive::Cone { base, axis, height, radii, hollow } => {
                let growth = primitive.growth() as f32;
                found = Some(MeshObject::Cone(MeshCone {
                    base: (base - origin).as_vec3(),
                    axis: axis.as_vec3(),
                    height: height as f32,
                    radius: radii[0] as f32,
                    growth,
                    hollow,
                    sides,
                    material: number,
                }));
            }
            Primitive::Rectangle { .. } | Primitive::Triangle { .. } => {}
        }
        Ok(())
    })?;
    Ok(found)
}

/// Whether a scene's mesh is small enough to be tried in local store, where it is faster, and has
/// no texture and no colours of vertices.
pub(super) fn may_stay(scene: &Scene) -> bool {
    let is_textured = |mesh: &Mesh| {
        let of = |&number: &u32| scene.materials.get(number as usize)?.texture.as_ref();
        !mesh.texture_coordinates.is_empty() && mesh.materials.iter().any(|it| of(it).is_some())
    };
    let mesh = scene.mesh.as_deref();
    let is_small = mesh.is_none_or(|mesh| {
        mesh.triangles.len() <= RESIDENT && mesh.colours.is_empty() && !is_textured(mesh)
    });
    is_small && scene.heights.is_none()
}
