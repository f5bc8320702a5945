//! Frames in which SPUs build a mesh, or blocks of spheres and cones: damaged records are refused,
//! and no byte is written beside what is to be made.

use protocol::layout::{
    BUILD_CONE, BUILD_PACK, BUILD_PACK_OBJECTS, BUILD_SORT, Build, BuildBounds, BuildTriangle,
    BuildUnit, MeshHeader, MeshVertex, SIDES_SMOOTH, UnitCounter,
};
use zerocopy::big_endian::{F32, U32};
use zerocopy::{FromZeros as _, Immutable};

use super::build::{build_frame, is_refused, shared};
use super::mesh::scene;
use crate::frames::fixture::Fixture;
use crate::prelude::*;

const VERTICES: u32 = 900;
/// Triangles, or spheres and cones.
const TRIANGLES: u32 = 1000;
/// Quadwords of the records of spheres and cones.
const RECORDS: u32 = 4 * TRIANGLES;
const CHUNK: u32 = 250;
/// The blocks that each range of triangles may take.
const MOST: u32 = 100;
/// Bytes on either side of what is made.
const GUARD: usize = 2048;
const JUNK: u8 = 0xa5;

/// Memory between guards.
struct Guarded {
    memory: SharedMemory,
    bytes: usize,
}

impl Guarded {
    fn new(bytes: usize) -> Self {
        let mut guarded = Self { memory: SharedMemory::new(bytes + 2 * GUARD), bytes };
        guarded.reset();
        guarded
    }

    fn reset(&mut self) {
        self.memory.write(0, &vec![JUNK; self.bytes + 2 * GUARD]);
    }

    fn address(&self) -> u64 {
        self.memory.address() + GUARD as u64
    }

    /// The bytes between the guards, which must not have been written.
    fn read(&self) -> Vec<u8> {
        let mut bytes = vec![0; self.bytes + 2 * GUARD];
        self.memory.read(0, &mut bytes);
        let (before, rest) = bytes.split_at(GUARD);
        let (own, after) = rest.split_at(self.bytes);
        assert!([before, after].concat().iter().all(|byte| *byte == JUNK), "a guard was written");
        own.to_vec()
    }
}

/// The records of frames that build a mesh, and what they make.
struct Sort {
    fixture: Fixture,
    frame: Frame,
    record: SharedMemory,
    build: Build,
    units: SharedMemory,
    chunks: Vec<BuildUnit>,
    ranges: Vec<BuildUnit>,
    words: Vec<U32>,
    word_memory: SharedMemory,
    counter: SharedMemory,
    sorted: Guarded,
    blocks: Guarded,
    bounds: Guarded,
    /// The triangles or objects to sort.
    elements: Vec<BuildTriangle>,
    triangles: SharedMemory,
    vertices: SharedMemory,
    /// The task of the second frame.
    pack: u32,
    _code: SharedMemory,
}

/// Triangles all over the vertices, some of them with normals.
fn triangles() -> Vec<BuildTriangle> {
    let vertex = |number: u32| number * 7919 % VERTICES;
    let sides = |number: u32| if number.is_multiple_of(3) { SIDES_SMOOTH } else { 0 };
    let triangle = |number: u32| BuildTriangle {
        code: U32::ZERO,
        first: (vertex(3 * number) | number << 24).into(),
        second: (vertex(3 * number + 1) | sides(number)).into(),
        third: vertex(3 * number + 2).into(),
    };
    (0..TRIANGLES).map(triangle).collect()
}

/// Spheres and cones in turn.
fn objects() -> Vec<BuildTriangle> {
    let object = |number: u32| {
        // A sphere has three quadwords, and a cone five.
        let (first, point, kind) = match number % 2 {
            0 => (4 * number, 4 * number, 0),
            _ => (4 * number - 1, 4 * number + 3, BUILD_CONE),
        };
        BuildTriangle {
            code: U32::ZERO,
            first: first.into(),
            second: (point | kind).into(),
            third: point.into(),
        }
    };
    (0..TRIANGLES).map(object).collect()
}

fn list<T: IntoBytes + Immutable>(records: &[T]) -> SharedMemory {
    shared(records.as_bytes())
}

impl Sort {
    fn triangles(spus: u32) -> Self {
        Self::of(spus, BUILD_PACK, triangles(), VERTICES)
    }

    fn objects(spus: u32) -> Self {
        Self::of(spus, BUILD_PACK_OBJECTS, objects(), RECORDS)
    }

    fn of(spus: u32, pack: u32, elements: Vec<BuildTriangle>, count: u32) -> Self {
        let fixture = Fixture::of(&scene(), spus);
        let position = |vertex: u32| [1, 3, 7].map(|it| F32::new((it * vertex % 97) as f32 - 40.0));
        let vertices: Vec<MeshVertex> = (0..count)
            .map(|vertex| MeshVertex { position: position(vertex), normal: vertex.into() })
            .collect();
        let chunks: Vec<BuildUnit> = (0..TRIANGLES)
            .step_by(CHUNK as usize)
            .map(|first| BuildUnit {
                first: first.into(),
                triangles: CHUNK.into(),
                ..BuildUnit::new_zeroed()
            })
            .collect();
        // Each range has a tenth of each chunk.
        let part = CHUNK / 10;
        let word = |chunk: u32, range: u32| U32::new(part << 24 | (chunk * CHUNK + range * part));
        let words: Vec<U32> = (0..40).map(|it| word(it % 4, it / 4)).collect();
        let ranges: Vec<BuildUnit> = (0..10)
            .map(|range| BuildUnit {
                first: (range * MOST).into(),
                count: MOST.into(),
                source: (4 * range).into(),
                source_count: 4.into(),
                triangles: (4 * part).into(),
                ..BuildUnit::new_zeroed()
            })
            .collect();
        let blocks = ranges.len() * MOST as usize;
        let code = shared(&Program::tracer().build_code());
        let (triangles, vertices, word_memory) = (list(&elements), list(&vertices), list(&words));
        let sorted = Guarded::new(TRIANGLES as usize * size_of::<BuildTriangle>());
        let bounds = Guarded::new(blocks * size_of::<BuildBounds>());
        let blocks = Guarded::new(blocks * MESH_BLOCK as usize);
        let (record, counter) = (SharedMemory::new(128), SharedMemory::new(128));
        let units = SharedMemory::new(16 * size_of::<BuildUnit>());
        let build = Build {
            blocks: blocks.address().into(),
            vertices: vertices.address().into(),
            sources: word_memory.address().into(),
            bounds: bounds.address().into(),
            vertex_count: count.into(),
            source_count: (words.len() as u32).into(),
            triangle_count: TRIANGLES.into(),
            triangles: triangles.address().into(),
            sorted: sorted.address().into(),
            scale: 1024.0.into(),
            low: [U32::new((-3 * 40 * 1024_i32) as u32); 3],
            shift: 9.into(),
            ..Build::new_zeroed()
        };
        let frame = Frame {
            mesh: 0.into(),
            mesh_blocks: (10 * MOST).into(),
            ..build_frame(fixture.frame, [&units, &counter, &record, &code])
        };
        Self {
            fixture,
            frame,
            record,
            build,
            units,
            chunks,
            ranges,
            words,
            word_memory,
            counter,
            sorted,
            blocks,
            bounds,
            elements,
            triangles,
            vertices,
            pack,
            _code: code,
        }
    }

    fn submit(&mut self, task: u32) -> Result<(), EngineError> {
        let units = if task == BUILD_SORT { &self.chunks } else { &self.ranges };
        self.units.write(0, units.as_bytes());
        let frame = Frame { unit_count: (units.len() as u32).into(), ..self.frame };
        self.counter.write(0, UnitCounter::new_zeroed().as_bytes());
        self.record.write(0, Build { task: task.into(), ..self.build }.as_bytes());
        let outcome = self.fixture.submit(&frame);
        self.sorted.read();
        self.blocks.read();
        self.bounds.read();
        outcome
    }

    /// Builds the mesh. Returns the blocks.
    fn made(&mut self) -> Vec<u8> {
        self.blocks.reset();
        self.bounds.reset();
        self.submit(BUILD_SORT).unwrap();
        self.submit(self.pack).unwrap();
        self.blocks.read()
    }

    /// Checks that records that are damaged meanwhile are refused, but not the right ones.
    fn refused(&mut self, what: &str, task: u32, spoil: impl FnOnce(&mut Self)) {
        let (frame, build) = (self.frame, self.build);
        let (chunks, ranges) = (self.chunks.clone(), self.ranges.clone());
        self.submit(BUILD_SORT).unwrap();
        spoil(self);
        let outcome = self.submit(task);
        (self.frame, self.build, self.chunks, self.ranges) = (frame, build, chunks, ranges);
        self.triangles.write(0, self.elements.as_bytes());
        self.word_memory.write(0, self.words.as_bytes());
        is_refused(what, outcome.map(|()| Vec::new()));
        self.made();
    }

    fn refused_unit(&mut self, what: &str, task: u32, spoil: impl FnOnce(&mut BuildUnit)) {
        self.refused(what, task, |it| {
            let units = if task == BUILD_SORT { &mut it.chunks } else { &mut it.ranges };
            spoil(&mut units[2]);
        });
    }
}

const KINDS: [fn(u32) -> Sort; 2] = [Sort::triangles, Sort::objects];

#[test]
fn blocks_are_the_same_by_any_number_of_spus() {
    for make in KINDS {
        let mut one = make(1);
        let made = one.made();
        let sorted = one.sorted.read();
        let sorted = <[BuildTriangle]>::ref_from_bytes(&sorted).unwrap();
        assert!(sorted.chunks(CHUNK as usize).all(|it| it.is_sorted_by_key(|it| it.code.get())));
        let headers = made.chunks(MESH_BLOCK as usize).map(|block| &block[..4]);
        let count = headers.filter(|magic| *magic == b"MESH").count();
        assert!((20..10 * MOST as usize).contains(&count), "{count}");
        for spus in 2..=6 {
            assert!(make(spus).made() == made, "{spus}");
        }
    }
}

#[test]
fn damaged_records_are_refused() {
    for mut sort in KINDS.map(|make| make(2)) {
        let pack = sort.pack;
        for task in [BUILD_SORT, pack] {
            sort.refused("blocks beside a line", task, |it| it.build.blocks = 16.into());
            sort.refused("triangles beside a line", task, |it| it.build.triangles = 16.into());
            sort.refused("sorted ones beside a line", task, |it| it.build.sorted = 64.into());
            sort.refused("fewer triangles", task, |it| it.build.triangle_count = 700.into());
            sort.refused("very many triangles", task, |it| {
                it.build.triangle_count = u32::MAX.into()
            });
            sort.refused("fewer vertices", task, |it| it.build.vertex_count = 100.into());
            sort.refused("very many vertices", task, |it| it.build.vertex_count = u32::MAX.into());
            sort.refused("sorted ones across 4 GB", task, |it| {
                it.build.sorted = 0xffff_ff80.into()
            });
        }
        sort.refused("no such task", 4, |_| ());
        sort.refused("fewer blocks", pack, |it| it.frame.mesh_blocks = 100.into());
        sort.refused("fewer words", pack, |it| it.build.source_count = 8.into());
    }
}

#[test]
fn one_triangle_is_built_and_none_is_refused() {
    for (make, vertices) in KINDS.into_iter().zip([3, 0]) {
        let mut sort = make(6);
        for task in [BUILD_SORT, sort.pack] {
            sort.refused("no triangle", task, |it| it.build.triangle_count = 0.into());
        }
        let triangles = U32::new(1);
        sort.build.triangle_count = triangles;
        sort.chunks = vec![BuildUnit { triangles, ..sort.chunks[0] }];
        sort.ranges = vec![BuildUnit { triangles, ..sort.ranges[0] }];
        sort.word_memory.write(0, [1 << 24, 0, 0, 0].map(U32::new).as_bytes());
        let made = sort.made();
        let (header, _) = MeshHeader::ref_from_prefix(&made).unwrap();
        assert_eq!(
            [header.triangles, header.vertices, header.nodes],
            [1, vertices, 1].map(U32::new)
        );
        assert!(made[MESH_BLOCK as usize..].iter().all(|byte| *byte == JUNK));
    }
}

#[test]
fn damaged_units_are_refused() {
    for mut sort in KINDS.map(|make| make(2)) {
        let pack = sort.pack;
        for task in [BUILD_SORT, pack] {
            sort.refused_unit("no triangle", task, |unit| unit.triangles = 0.into());
            sort.refused_unit("4,097 triangles", task, |unit| unit.triangles = 4097.into());
            sort.refused_unit("any number of them", task, |unit| unit.triangles = u32::MAX.into());
            sort.refused_unit("one beyond any", task, |unit| unit.first = u32::MAX.into());
        }
        sort.refused_unit("one beyond the last", BUILD_SORT, |it| {
            it.first = (TRIANGLES - 9).into()
        });
        sort.refused_unit("no block", pack, |unit| unit.count = 0.into());
        sort.refused_unit("too few blocks", pack, |unit| unit.count = 1.into());
        sort.refused_unit("256 blocks", pack, |unit| unit.count = 256.into());
        sort.refused_unit("blocks beyond the last", pack, |unit| {
            unit.first = (9 * MOST + 1).into()
        });
        sort.refused_unit("fewer triangles", pack, |unit| unit.triangles -= 1);
        sort.refused_unit("words between quadwords", pack, |unit| unit.source += 2);
        sort.refused_unit("no words", pack, |unit| unit.source_count = 0.into());
        sort.refused_unit("516 words", pack, |unit| unit.source_count = 516.into());
        sort.refused_unit("words beyond the last", pack, |it| it.source = 0x4000_0000.into());
    }
}

#[test]
fn damaged_words_and_triangles_are_refused() {
    for mut sort in KINDS.map(|make| make(2)) {
        let pack = sort.pack;
        for word in [0, u32::MAX, 25 << 24 | TRIANGLES, 24 << 24, 26 << 24] {
            sort.refused("another word", pack, |it| {
                it.word_memory.write(24, &word.to_be_bytes());
            });
        }
        // The points of spheres and cones are only needed for their codes.
        let packed = if pack == BUILD_PACK { 1..4 } else { 1..2 };
        let damage = (sort.build.vertex_count.get() | 0x4000_0000).to_be_bytes();
        for corner in 1..4 {
            sort.refused("a triangle's vertex", BUILD_SORT, |it| {
                it.triangles.write(16 * 777 + 4 * corner, &damage);
            });
        }
        for corner in packed {
            sort.refused("a sorted triangle's vertex", pack, |it| {
                it.sorted.memory.write(GUARD + 16 * 777 + 4 * corner, &damage);
            });
        }
    }
    let mut sort = Sort::objects(2);
    sort.refused("a record that ends beyond the last", BUILD_PACK_OBJECTS, |it| {
        it.sorted.memory.write(GUARD + 16 * 777 + 4, &(RECORDS - 2).to_be_bytes());
    });
}

/// Damage that only the codes and boxes get wrong by: it ends, and nothing else is written.
#[test]
fn other_damage_is_harmless() {
    for mut sort in KINDS.map(|make| make(2)) {
        let numbers = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e38, -0.0, 1e-42];
        let vertices: Vec<MeshVertex> = (0..sort.build.vertex_count.get() as usize)
            .map(|it| MeshVertex {
                position: [it, it + 1, it + 3].map(|it| F32::new(numbers[it % numbers.len()])),
                normal: u32::MAX.into(),
            })
            .collect();
        sort.vertices.write(0, vertices.as_bytes());
        let made = sort.made();
        assert!(made.chunks(MESH_BLOCK as usize).any(|block| &block[..4] == b"MESH"));
        let junk = [u32::MAX, 0, 1 << 31, 0x7f80_0000];
        for (number, &word) in junk.iter().enumerate() {
            sort.build.scale = F32::new(f32::from_bits(word));
            sort.build.shift = junk[(number + 1) % 4].into();
            sort.build.low = [U32::new(junk[(number + 2) % 4]); 3];
            sort.made();
        }
        // Codes in no order.
        sort.submit(BUILD_SORT).unwrap();
        for at in 0..TRIANGLES as usize {
            let code = (at as u32).wrapping_mul(0x9e37_79b9);
            sort.sorted.memory.write(GUARD + 16 * at, &code.to_be_bytes());
        }
        sort.submit(sort.pack).unwrap();
    }
    // Codes of another kind than the objects are.
    let mut sort = Sort::objects(2);
    sort.submit(BUILD_SORT).unwrap();
    for at in (0..TRIANGLES as usize).step_by(3) {
        sort.sorted.memory.write(GUARD + 16 * at, &u32::MAX.to_be_bytes());
    }
    sort.submit(BUILD_PACK_OBJECTS).unwrap();
}
