//! The memory that the SPUs access by address.

use std::sync::Arc;

use zerocopy::{FromZeros as _, IntoBytes as _};

use super::build::Build;
use super::sort::Sort;
use crate::framebuffer::Framebuffer;
use crate::scene::Scene;
use crate::scene::block::{MaterialTable, SceneBlock};
use crate::scene::height::HeightView;
use crate::scene::mesh::MeshBlocks;
use crate::scene::texture::Textures;
use crate::shared::SharedMemory;
use crate::spe::Program;
use crate::work::{Addresses, MAX_PAGES, Plan, tile_count};
use protocol::layout::{
    BOX_CODE, COLOUR_CODE_CAPACITY, Frame, MAX_CHANGES, MAX_SPHERES, MAX_SPUS, Node,
    PATHS_CAPACITY, SCENE_ADDRESS, SCENE_CAPACITY, Sphere, Statistics, UnitCost, UnitCounter,
    WAITING_SIZE, WorkUnit,
};

/// Memory that must outlive the SPUs.
pub(super) struct Records {
    frame: SharedMemory,
    spheres: SharedMemory,
    scene: SharedMemory,
    /// The program's code that tests boxes.
    box_code: Vec<u8>,
    depth_code: SharedMemory,
    depth_code_bytes: u32,
    mesh_code: SharedMemory,
    mesh_code_bytes: u32,
    texture_code: SharedMemory,
    colour_code: SharedMemory,
    height_code: SharedMemory,
    texture_code_bytes: u32,
    cuts_code: SharedMemory,
    cuts_code_bytes: u32,
    /// The mesh of the last scene, which SPUs read.
    mesh: Option<Arc<MeshBlocks>>,
    build_code: SharedMemory,
    build_code_bytes: u32,
    /// Whether the last scene's mesh is the one that SPUs have refitted.
    is_moved: bool,
    /// The mesh that SPUs have refitted last.
    build: Option<Build>,
    /// Whether the last scene's mesh is the one that SPUs have built.
    is_sorted: bool,
    /// The mesh that SPUs have built last.
    sort: Option<Sort>,
    textures: Option<Arc<Textures>>,
    heights: Option<Arc<HeightView>>,
    /// The mesh's materials, if they are not in the scene.
    materials: Option<Arc<MaterialTable>>,
    unit_counter: SharedMemory,
    statistics: SharedMemory,
    /// The rays of each SPU that do not fit into local store.
    waiting: SharedMemory,
    /// Capacity for the largest possible number of units.
    units: SharedMemory,
    costs: SharedMemory,
    /// The nodes around a frame's changes.
    changes: SharedMemory,
    /// For each page of the framebuffer, the paths of its tiles. They take much memory, so they are
    /// allocated when a frame keeps them.
    paths: [Option<SharedMemory>; MAX_PAGES],
    /// The address of those that the frame keeps; 0 for none.
    kept_paths: u64,
    pub framebuffer: Box<dyn Framebuffer>,
}

impl Records {
    /// Allocates memory for frames of this framebuffer's size.
    pub fn new(framebuffer: Box<dyn Framebuffer>, program: &Program) -> Self {
        let [units, costs] = units_and_costs(framebuffer.as_ref());
        let [
            (depth_code, depth_code_bytes),
            (mesh_code, mesh_code_bytes),
            (texture_code, texture_code_bytes),
            (build_code, build_code_bytes),
            (cuts_code, cuts_code_bytes),
        ] = [
            program.depth_code(),
            program.mesh_code(),
            program.texture_code(),
            program.build_code(),
            program.cuts_code(),
        ]
        .map(|code| {
            let mut memory = SharedMemory::new(code.len());
            memory.write(0, &code);
            (memory, code.len() as u32)
        });
        let mut colour_code = SharedMemory::new(COLOUR_CODE_CAPACITY as usize);
        colour_code.write(0, &program.colour_code());
        let height_code = program.height_code();
        let mut height_memory = SharedMemory::new(height_code.len());
        height_memory.write(0, &height_code);
        Self {
            frame: SharedMemory::new(size_of::<Frame>()),
            spheres: SharedMemory::new(MAX_SPHERES as usize * size_of::<Sphere>()),
            scene: SharedMemory::new(SCENE_CAPACITY as usize),
            box_code: program.box_code(),
            depth_code,
            depth_code_bytes,
            mesh_code,
            mesh_code_bytes,
            texture_code,
            texture_code_bytes,
            cuts_code,
            cuts_code_bytes,
            colour_code,
            height_code: height_memory,
            mesh: None,
            build_code,
            build_code_bytes,
            is_moved: false,
            build: None,
            is_sorted: false,
            sort: None,
            heights: None,
            textures: None,
            materials: None,
            unit_counter: SharedMemory::new(size_of::<UnitCounter>()),
            statistics: SharedMemory::new(MAX_SPUS as usize * size_of::<Statistics>()),
            waiting: SharedMemory::new((MAX_SPUS * WAITING_SIZE) as usize),
            units,
            costs,
            changes: SharedMemory::new(MAX_CHANGES as usize * size_of::<Node>()),
            paths: Default::default(),
            kept_paths: 0,
            framebuffer,
        }
    }

    /// Takes another framebuffer, with memory for its frames, and returns the previous one.
    pub fn show_on(&mut self, framebuffer: Box<dyn Framebuffer>) -> Box<dyn Framebuffer> {
        [self.units, self.costs] = units_and_costs(framebuffer.as_ref());
        self.paths = Default::default();
        std::mem::replace(&mut self.framebuffer, framebuffer)
    }

    /// The addresses of all records.
    pub fn addresses(&self) -> Addresses {
        Addresses {
            spheres: self.spheres.address(),
            scene: self.scene.address(),
            mesh: self.mesh_address(),
            depth_code: self.depth_code.address(),
            depth_code_bytes: self.depth_code_bytes,
            mesh_code: self.mesh_code.address(),
            mesh_code_bytes: self.mesh_code_bytes,
            texture_code: self.texture_code.address(),
            texture_code_bytes: self.texture_code_bytes,
            cuts_code: self.cuts_code.address(),
            cuts_code_bytes: self.cuts_code_bytes,
            colour_code: self.colour_code.address(),
            height_code: self.height_code.address(),
            unit_counter: self.unit_counter.address(),
            statistics: self.statistics.address(),
            waiting: self.waiting.address(),
            units: self.units.address(),
            costs: self.costs.address(),
            paths: self.kept_paths,
            changes: self.changes.address(),
        }
    }

    /// Describes the next frame in which the SPUs refit or build the scene's mesh, if they must.
    /// After it, call [`Records::mesh_is_made`].
    pub fn make_mesh(&mut self, scene: &Scene, number: u32, spus: u32) -> Option<Frame> {
        let mesh = scene.block().and_then(SceneBlock::mesh)?;
        let frame = if let Some(sorted) = mesh.sorted {
            if self.sort.as_ref().is_some_and(|sort| sort.has(sorted)) {
                return None;
            }
            let before = self.sort.take();
            self.sort.insert(Sort::new(before, sorted, mesh.blocks.count())).describe()?
        } else {
            let moved = mesh.moved?;
            let build = self.build.take().filter(|build| build.is_of(mesh.blocks));
            let build = build.unwrap_or_else(|| Build::new(mesh.blocks, spus));
            let build = self.build.insert(build);
            if build.has(moved) {
                return None;
            }
            build.describe(moved)
        };
        Some(Frame {
            number: number.into(),
            spus: spus.into(),
            unit_counter: self.unit_counter.address().into(),
            statistics: self.statistics.address().into(),
            code: self.build_code.address().into(),
            code_bytes: self.build_code_bytes.into(),
            ..frame
        })
    }

    /// Does the PPU's part of refitting or building, after the SPUs' replies.
    pub fn mesh_is_made(&mut self, scene: &Scene) {
        let is_sorted =
            scene.block().and_then(SceneBlock::mesh).is_some_and(|it| it.sorted.is_some());
        if let Some(sort) = self.sort.as_mut().filter(|_| is_sorted) {
            sort.finish();
        } else if let Some(build) = &mut self.build {
            build.finish();
        }
    }

    /// The bytes of the last scene's mesh if SPUs have refitted or built it.
    pub fn made_blocks(&self) -> Option<Vec<u8>> {
        self.sorted().map(Sort::bytes).or_else(|| Some(self.refitted()?.bytes()))
    }

    fn refitted(&self) -> Option<&Build> {
        self.build.as_ref().filter(|_| self.is_moved)
    }

    fn sorted(&self) -> Option<&Sort> {
        self.sort.as_ref().filter(|_| self.is_sorted)
    }

    /// The address of the first block of the last scene's mesh; 0 if it has none.
    fn mesh_address(&self) -> u64 {
        let built = self.mesh.as_ref().map_or(0, |mesh| mesh.address());
        let refitted = self.refitted().map_or(built, Build::address);
        self.sorted().map_or(refitted, Sort::address)
    }

    /// Writes the records of a planned frame. All units' costs are set to 0: a finished unit's
    /// cost is never 0, so a cost other than 0 shows that the unit is finished. `costs` is a
    /// buffer.
    pub fn write(&mut self, scene: &Scene, plan: &Plan, costs: &mut Vec<UnitCost>) {
        self.spheres.write(0, plan.spheres().bytes());
        if let Some(block) = scene.block() {
            self.scene.write(0, block.bytes());
            if block.box_trees() != 0 {
                let offset = (BOX_CODE - SCENE_ADDRESS) as usize;
                self.scene.write(offset, &self.box_code);
            }
            let mesh = block.mesh();
            self.mesh = mesh.map(|mesh| mesh.blocks.clone());
            self.is_moved = mesh.is_some_and(|mesh| mesh.moved.is_some());
            self.is_sorted = mesh.is_some_and(|mesh| mesh.sorted.is_some());
            self.textures = mesh.and_then(|mesh| mesh.textures.cloned());
            self.heights = mesh.and_then(|mesh| mesh.heights.cloned());
            self.materials = mesh.and_then(|mesh| mesh.table.cloned());
        }
        self.changes.write(0, plan.changes().as_bytes());
        let tiles = tile_count(self.framebuffer.geometry()) as usize;
        self.kept_paths = plan.paths().map_or(0, |page| {
            let paths = || SharedMemory::new(tiles * PATHS_CAPACITY as usize);
            self.paths[page].get_or_insert_with(paths).address()
        });
        self.units.write(0, plan.units().bytes());
        costs.clear();
        costs.resize(plan.units().lines().len(), UnitCost::new_zeroed());
        self.costs.write(0, costs.as_bytes());
    }

    /// Writes a frame's record, the unit counter and these lines of statistics. Returns the
    /// record's address.
    pub fn write_frame(&mut self, frame: &Frame, lines: &[Statistics]) -> u64 {
        self.frame.write(0, frame.as_bytes());
        let counter = UnitCounter::new_zeroed();
        self.unit_counter.write(0, counter.as_bytes());
        self.statistics.write(0, lines.as_bytes());
        self.frame.address()
    }

    /// Reads the SPUs' statistics.
    pub fn read_statistics(&self, lines: &mut [Statistics]) {
        self.statistics.read(0, lines.as_mut_bytes());
    }

    /// Reads the units' costs.
    pub fn read_costs(&self, costs: &mut [UnitCost]) {
        self.costs.read(0, costs.as_mut_bytes());
    }

    /// How many units of the frame the SPUs have taken from the counter, and how many they have
    /// finished. The first is 0 if the frame is split into slices, which don't use the counter.
    /// The second is 0 if the frame's costs are written to other memory than these records'.
    pub fn units_done(&self, frame: &Frame) -> (u32, u32) {
        let units = frame.unit_count.get();
        let mut finished = 0;
        if frame.costs.get() == self.costs.address() {
            let lines = 0..units as usize;
            let line = |number| self.costs.peek_word(number * size_of::<UnitCost>());
            finished = lines.filter(|&number| line(number) != 0).count() as u32;
        }
        (self.unit_counter.peek_word(0), finished)
    }
}

/// Capacity for the maximum number of units that a picture can be split into, of one tile each, and
/// their costs.
fn units_and_costs(framebuffer: &dyn Framebuffer) -> [SharedMemory; 2] {
    let most = tile_count(framebuffer.geometry()) as usize;
    [size_of::<WorkUnit>(), size_of::<UnitCost>()].map(|size| SharedMemory::new(most * size))
}
