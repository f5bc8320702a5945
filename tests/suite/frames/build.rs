//! Frames in which SPUs refit a mesh: damaged records are refused, and no byte is written beside
//! the new blocks.

use protocol::layout::{
    Build, BuildBounds, BuildUnit, FEATURE_BUILD, MAX_SIDE, MeshVertex, SPLIT_UNITS, UnitCounter,
};
use zerocopy::FromZeros as _;
use zerocopy::big_endian::{F32, U32};

use super::mesh::scene;
use crate::frames::fixture::Fixture;
use crate::prelude::*;

const SIZE: usize = MESH_BLOCK as usize;
/// The bytes of a block that must not be written. There is one on either side of the new blocks.
const GUARD: [u8; SIZE] = [0xa5; SIZE];
/// Vertices of the mesh.
const VERTICES: u32 = 900;

/// The records of a frame that refits the mesh of [`scene`], and what it makes.
struct Refit {
    fixture: Fixture,
    frame: Frame,
    record: SharedMemory,
    build: Build,
    units: SharedMemory,
    counter: SharedMemory,
    /// A unit for each leaf block.
    good: Vec<BuildUnit>,
    blocks: Vec<u8>,
    made: SharedMemory,
    bounds: SharedMemory,
    vertices: SharedMemory,
    _memory: [SharedMemory; 2],
}

pub fn is_refused(what: &str, outcome: Result<Vec<u8>, EngineError>) {
    match outcome {
        Err(EngineError::Refused { .. }) => {}
        Err(error) => panic!("{what}: {error}"),
        Ok(_) => panic!("{what} was refitted"),
    }
}

pub fn shared(bytes: &[u8]) -> SharedMemory {
    let mut memory = SharedMemory::new(bytes.len());
    memory.write(0, bytes);
    memory
}

/// A frame that refits or builds a mesh, with these units, their counter, its record and its code.
pub fn build_frame(frame: Frame, [units, counter, record, code]: [&SharedMemory; 4]) -> Frame {
    Frame {
        features: FEATURE_BUILD.into(),
        split: SPLIT_UNITS.into(),
        width: MAX_SIDE.into(),
        height: MAX_SIDE.into(),
        stride: (4 * MAX_SIDE).into(),
        units: units.address().into(),
        unit_counter: counter.address().into(),
        scene: record.address().into(),
        code: code.address().into(),
        code_bytes: (Program::tracer().build_code().len() as u32).into(),
        ..frame
    }
}

impl Refit {
    fn new(spus: u32) -> Self {
        let fixture = Fixture::of(&scene(), spus);
        let count = fixture.frame.mesh_blocks.get();
        let mut blocks = vec![0; count as usize * SIZE];
        fixture.mesh.read(0, &mut blocks);
        let word = |block: u32, index: usize| {
            let at = block as usize * SIZE + 4 * index;
            u32::from_be_bytes(blocks[at..at + 4].try_into().unwrap())
        };
        let mut sources = Vec::new();
        let mut good = Vec::new();
        for block in (0..count).filter(|&block| word(block, 2) == MESH_LEAF) {
            let first = sources.len() as u32;
            // Runs of three vertices, and of what is left.
            let vertices = word(block, 6);
            let runs = (0..vertices).step_by(3);
            sources.push(U32::new(runs.len() as u32));
            sources.extend(runs.map(|it| {
                let run = (7 * it + block) % (VERTICES - 2);
                U32::new((vertices - it).min(3) << 24 | run)
            }));
            sources.resize(sources.len().next_multiple_of(4), U32::ZERO);
            good.push(BuildUnit {
                first: block.into(),
                count: 1.into(),
                source: first.into(),
                source_count: (sources.len() as u32 - first).into(),
                ..BuildUnit::new_zeroed()
            });
        }
        let position = |vertex: u32| [1, 3, 7].map(|it| F32::new((it * vertex % 97) as f32 - 40.0));
        let vertices: Vec<MeshVertex> = (0..VERTICES)
            .map(|vertex| MeshVertex { position: position(vertex), normal: vertex.into() })
            .collect();
        let vertices = shared(vertices.as_bytes());
        let made = SharedMemory::new((count as usize + 2) * SIZE);
        let bounds = SharedMemory::new(count as usize * size_of::<BuildBounds>());
        let record = SharedMemory::new(size_of::<Build>());
        let units = shared(good.as_bytes());
        let counter = SharedMemory::new(size_of::<UnitCounter>());
        let sources_memory = shared(sources.as_bytes());
        let code = shared(&Program::tracer().build_code());
        let build = Build {
            blocks: (made.address() + SIZE as u64).into(),
            vertices: vertices.address().into(),
            sources: sources_memory.address().into(),
            bounds: bounds.address().into(),
            vertex_count: VERTICES.into(),
            source_count: (sources.len() as u32).into(),
            ..Build::new_zeroed()
        };
        let frame = Frame {
            unit_count: (good.len() as u32).into(),
            ..build_frame(fixture.frame, [&units, &counter, &record, &code])
        };
        let memory = [sources_memory, code];
        Self {
            fixture,
            frame,
            record,
            build,
            units,
            counter,
            good,
            blocks,
            made,
            bounds,
            vertices,
            _memory: memory,
        }
    }

    /// Refits the mesh with a changed frame, and returns the new blocks.
    fn with(&mut self, spoil: impl FnOnce(&mut Frame)) -> Result<Vec<u8>, EngineError> {
        let mut frame = self.frame;
        spoil(&mut frame);
        self.record.write(0, self.build.as_bytes());
        self.counter.write(0, UnitCounter::new_zeroed().as_bytes());
        let guarded = vec![GUARD[0]; self.blocks.len() + 2 * SIZE];
        self.made.write(0, &guarded);
        let outcome = self.fixture.submit(&frame);
        let mut made = guarded;
        self.made.read(0, &mut made);
        let (before, rest) = made.split_at(SIZE);
        let (made, after) = rest.split_at(self.blocks.len());
        assert!(before == GUARD && after == GUARD, "bytes beside the blocks were written");
        outcome.map(|()| made.to_vec())
    }

    /// Checks that a changed frame is refused, and the right one is not.
    fn refused(&mut self, what: &str, field: &str, spoil: impl FnOnce(&mut Frame)) {
        let outcome = self.with(spoil);
        let text = outcome.as_ref().err().map(ToString::to_string).unwrap_or_default();
        is_refused(what, outcome);
        assert!(text.contains(field), "{what}: {text}");
        self.with(|_| ()).unwrap();
    }

    /// The same with a record that is damaged meanwhile.
    fn refused_build(&mut self, what: &str, spoil: impl FnOnce(&mut Build)) {
        let good = self.build;
        spoil(&mut self.build);
        let outcome = self.with(|_| ());
        self.build = good;
        is_refused(what, outcome);
        self.with(|_| ()).unwrap();
    }

    fn refused_unit(&mut self, what: &str, spoil: impl FnOnce(&mut BuildUnit)) {
        let mut units = self.good.clone();
        let middle = units.len() / 2;
        spoil(&mut units[middle]);
        self.units.write(0, units.as_bytes());
        let outcome = self.with(|_| ());
        self.units.write(0, self.good.as_bytes());
        is_refused(what, outcome);
        self.with(|_| ()).unwrap();
    }

    fn refused_word(&mut self, what: &str, index: usize, value: u32) {
        let block = self.good[self.good.len() / 2].first.get() as usize;
        let at = block * SIZE + 4 * index;
        self.fixture.mesh.write(at, &value.to_be_bytes());
        let outcome = self.with(|_| ());
        self.fixture.mesh.write(at, &self.blocks[at..at + 4]);
        is_refused(what, outcome);
        self.with(|_| ()).unwrap();
    }
}

#[test]
fn blocks_are_the_same_by_any_number_of_spus() {
    let made = Refit::new(1).with(|_| ()).unwrap();
    for spus in 2..=6 {
        assert!(Refit::new(spus).with(|_| ()).unwrap() == made, "{spus}");
    }
    // Inner blocks are not the SPUs'.
    assert!(made[..SIZE] == GUARD);
}

#[test]
fn no_block_is_written_without_units() {
    let mut refit = Refit::new(2);
    let made = refit.with(|frame| frame.unit_count = 0.into()).unwrap();
    assert!(made.chunks(SIZE).all(|block| block == GUARD));
}

#[test]
fn damaged_frames_are_refused() {
    let mut refit = Refit::new(2);
    refit.refused("no code", "code_bytes", |frame| frame.code_bytes = 0.into());
    refit.refused("too much code", "code_bytes", |frame| frame.code_bytes = 16_400.into());
    refit.refused("a record beside a line", "scene", |frame| {
        frame.scene = (frame.scene.get() + 16).into();
    });
    refit.refused("blocks beside a line", "scene", |frame| {
        frame.mesh = (frame.mesh.get() + 64).into();
    });
    refit.refused("fewer blocks", "units", |frame| frame.mesh_blocks = 3.into());
    refit.refused("too many blocks", "scene", |frame| frame.mesh_blocks = 0x100_0001.into());
}

#[test]
fn damaged_records_are_refused() {
    let mut refit = Refit::new(2);
    refit.refused_build("new blocks beside a line", |it| it.blocks = (it.blocks.get() + 16).into());
    refit.refused_build("vertices beside a line", |it| {
        it.vertices = (it.vertices.get() + 16).into()
    });
    refit.refused_build("words beside a line", |it| it.sources = (it.sources.get() + 4).into());
    refit.refused_build("bounds beside a line", |it| it.bounds = (it.bounds.get() + 32).into());
    refit.refused_build("fewer vertices", |it| it.vertex_count = 7.into());
    refit.refused_build("no vertices", |it| it.vertex_count = 0.into());
    refit.refused_build("vertices across 4 GB", |it| it.vertices = 0xffff_ff80.into());
    refit.refused_build("very many vertices", |it| it.vertex_count = u32::MAX.into());
    refit.refused_build("fewer words", |it| it.source_count = (it.source_count.get() / 2).into());
}

#[test]
fn damaged_units_are_refused() {
    let mut refit = Refit::new(2);
    let blocks = refit.frame.mesh_blocks.get();
    refit.refused_unit("no block", |unit| unit.count = 0.into());
    refit.refused_unit("17 blocks", |unit| unit.count = 17.into());
    refit.refused_unit("a block beyond the last", |unit| unit.first = blocks.into());
    refit.refused_unit("blocks beyond the last", |unit| {
        unit.first = (blocks - 1).into();
        unit.count = 2.into();
    });
    refit.refused_unit("a number beyond any", |unit| unit.first = u32::MAX.into());
    refit.refused_unit("the root", |unit| unit.first = 0.into());
    refit.refused_unit("a list between quadwords", |unit| unit.source += 2);
    refit.refused_unit("too short a list", |unit| unit.source_count -= 4);
    refit.refused_unit("too long a list", |unit| unit.source_count = 4100.into());
    refit.refused_unit("a list beyond the last", |unit| unit.source = 0x4000_0000.into());
    refit.refused_unit("a list far beyond the last", |unit| unit.source = 0xffff_fffc.into());
}

#[test]
fn damaged_blocks_are_refused() {
    let mut refit = Refit::new(2);
    for (what, index, value) in [
        ("another number", 1, 1),
        ("an inner block", 2, 0),
        ("spheres", 2, 2),
        ("no node", 4, 0),
        ("19 nodes", 4, 19),
        ("nodes in place of the vertices", 4, 18),
        ("no triangle", 5, 0),
        ("128 triangles", 5, 128),
        ("no vertex", 6, 0),
        ("256 vertices", 6, 256),
        ("vertices beyond the block", 6, 120),
        ("a number of vertices beyond any", 6, u32::MAX),
    ] {
        refit.refused_word(what, index, value);
    }
}

/// Damage that a block's boxes only get wrong by: it ends, and nothing else is written.
#[test]
fn other_damage_is_harmless() {
    let mut refit = Refit::new(2);
    let block = refit.good[refit.good.len() / 2].first.get() as usize;
    for start in 8..SIZE / 4 {
        let at = block * SIZE + 4 * start;
        refit.fixture.mesh.write(at, &u32::MAX.to_be_bytes());
        if start % 16 == 7 {
            refit.with(|_| ()).unwrap();
        }
    }
    let numbers = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e38, -0.0, 1e-42];
    let vertices: Vec<MeshVertex> = (0..VERTICES as usize)
        .map(|it| MeshVertex {
            position: [it, it + 1, it + 3].map(|it| F32::new(numbers[it % numbers.len()])),
            normal: u32::MAX.into(),
        })
        .collect();
    refit.vertices.write(0, vertices.as_bytes());
    refit.with(|_| ()).unwrap();
    let mut bounds = BuildBounds::new_zeroed();
    refit.bounds.read(block * size_of::<BuildBounds>(), bounds.as_mut_bytes());
    assert_eq!(bounds.unused.get(), 0);
}
