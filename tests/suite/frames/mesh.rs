//! Meshes, spheres and cones in main memory: the same bytes whatever the cache holds, and an error
//! for every block that is not as it should be.

use protocol::layout::{EYE_CODE, MESH_CONES, MESH_INNER, MESH_MIN_SLOTS, MESH_SPHERES, NO_BOX};

use crate::frames::fixture::{Fixture, Spoil};
use crate::prelude::*;

/// Words of a block's header.
const NUMBER: usize = 1;
const KIND: usize = 2;
const LEVELS: usize = 3;
const NODES: usize = 4;
const TRIANGLES: usize = 5;
const VERTICES: usize = 6;
const SIDES: usize = 7;
/// The first node's words in a block: its corners, then its children.
const FIRST: usize = 8;
const CHILDREN: usize = FIRST + 24;

/// A ball of 1,800 smooth triangles that reflects, on a floor.
pub fn scene() -> scenes::Scene {
    let text = "v\nfrom 1 2.5 6\nat 0 -0.1 0\nup 0 1 0\nangle 30\nhither 0\nresolution 8 8\n\
        b 0.3 0.4 0.6\nl 4 6 3 0.9 0.9 0.9\n\
        f 0.9 0.3 0.2 0.7 0.3 30 0 1\n\
        p 4\n-9 -1 9\n9 -1 9\n9 -1 -9\n-9 -1 -9\n";
    let mut scene = scenes::parse(text.as_bytes(), "ball", &scenes::Limits::default()).unwrap();
    let mut mesh = scenes::Mesh::default();
    let (rows, columns) = (30_u32, 30_u32);
    for row in 0..=rows {
        for column in 0..columns {
            let down = std::f64::consts::PI * f64::from(row) / f64::from(rows);
            let around = std::f64::consts::TAU * f64::from(column) / f64::from(columns);
            let (ring, height) = (libm::sin(down), libm::cos(down));
            let point = [ring * libm::cos(around), height, -ring * libm::sin(around)];
            mesh.positions.push(point.map(|number| number as f32));
        }
    }
    mesh.normals = mesh.positions.clone();
    for row in 0..rows {
        for column in 0..columns {
            let at = |row: u32, column: u32| row * columns + column % columns;
            let (a, b) = (at(row, column), at(row, column + 1));
            let (c, d) = (at(row + 1, column), at(row + 1, column + 1));
            mesh.triangles.extend([[a, c, d], [a, d, b]]);
            mesh.materials.extend([0, 0]);
        }
    }
    scene.mesh = Some(Arc::new(mesh));
    scene
}

/// 1,500 spheres, some of which reflect.
fn spheres() -> scenes::Scene {
    let mut text = String::from(
        "v\nfrom 0 0 30\nat 0 0 0\nup 0 1 0\nangle 30\nhither 0\nresolution 8 8\n\
         b 0.3 0.4 0.6\nl 20 30 40\n",
    );
    let mut random = ChaCha8Rng::seed_from_u64(5);
    for number in 0..1500 {
        if number % 750 == 0 {
            text += &format!("f 0.9 {} 0.2 0.7 0.{number} 30 0 1\n", number / 750);
        }
        let [x, y, z] = std::array::from_fn(|_| random.random_range(-10.0..10.0));
        text += &format!("s {x} {y} {z} 0.4\n");
    }
    scenes::parse(text.as_bytes(), "spheres", &scenes::Limits::default()).unwrap()
}

/// 1,200 cones and 1,100 spheres, some of which reflect.
fn cones() -> scenes::Scene {
    let mut scene = spheres();
    let mut random = ChaCha8Rng::seed_from_u64(6);
    scene.name = "cones".into();
    for (number, object) in scene.objects.iter_mut().enumerate().skip(300) {
        let [x, y, z]: [f64; 3] = std::array::from_fn(|_| random.random_range(-10.0..10.0));
        let [u, v, w]: [f64; 3] = std::array::from_fn(|_| random.random_range(-1.2..1.2));
        let apex_radius = [0.0, 0.4, 0.2, -0.1][number % 4];
        object.shape = scenes::Shape::Cone {
            base: [x, y, z].into(),
            base_radius: if apex_radius < 0.0 { -0.4 } else { 0.4 },
            apex: [x + u, y + v, z + w].into(),
            apex_radius,
        };
    }
    scene.objects.extend(spheres().objects.drain(..800));
    scene
}

fn word(block: u32, index: usize) -> usize {
    block as usize * MESH_BLOCK as usize + 4 * index
}

/// Blocks of a fixture that can be changed and restored.
struct Blocks {
    fixture: Fixture,
    good: Vec<u8>,
}

impl Blocks {
    fn new(spus: u32) -> Self {
        Self::of(&scene(), spus)
    }

    fn of(scene: &scenes::Scene, spus: u32) -> Self {
        let fixture = Fixture::of(scene, spus);
        let mut good = vec![0; fixture.frame.mesh_blocks.get() as usize * MESH_BLOCK as usize];
        fixture.mesh.read(0, &mut good);
        Self { fixture, good }
    }

    fn get(&self, at: usize) -> u32 {
        u32::from_be_bytes(self.good[at..at + 4].try_into().unwrap())
    }

    fn first(&self, kind: u32) -> u32 {
        let blocks = 0..self.fixture.frame.mesh_blocks.get();
        let found = blocks.into_iter().find(|&block| self.get(word(block, KIND)) == kind);
        found.expect("the mesh has blocks of this kind")
    }

    /// The first block of a kind that some ray needs.
    fn first_needed(&mut self, kind: u32) -> u32 {
        let blocks = 0..self.fixture.frame.mesh_blocks.get();
        let of_kind: Vec<u32> =
            blocks.filter(|&block| self.get(word(block, KIND)) == kind).collect();
        let mut of_kind = of_kind.into_iter();
        let found = of_kind.find(|&block| self.traced_with(&[(word(block, 0), 0)]).is_err());
        found.expect("rays need blocks of this kind")
    }

    /// Traces the frame with words of the blocks replaced.
    fn traced_with(&mut self, words: &[(usize, u32)]) -> Result<RgbImage, EngineError> {
        for &(at, value) in words {
            self.fixture.mesh.write(at, &value.to_be_bytes());
        }
        let frame = self.fixture.frame;
        let outcome = self.fixture.submit(&frame);
        for &(at, _) in words {
            self.fixture.mesh.write(at, &self.good[at..at + 4]);
        }
        outcome.map(|()| self.picture())
    }

    fn picture(&self) -> RgbImage {
        self.fixture.framebuffer.picture().unwrap()
    }

    /// Checks that these words are refused with the block's number, and the good ones traced after.
    fn refused(&mut self, what: &str, block: u32, words: &[(usize, u32)]) {
        match self.traced_with(words) {
            Err(error @ EngineError::Refused { .. }) => {
                let text = error.to_string();
                let part = format!("refused block {block} of the mesh: ");
                assert!(text.contains(&part), "{what}: {text}");
            }
            Err(error) => panic!("{what}: {error}"),
            Ok(_) => panic!("{what} was traced"),
        }
        self.traced_with(&[]).unwrap();
    }
}

#[test]
fn picture_is_same_for_all_sizes_of_cache() {
    for scene in [scene(), spheres(), cones()] {
        let mut one = Blocks::of(&scene, 1);
        let picture = one.traced_with(&[]).unwrap();
        let background = picture.get_pixel(0, 0);
        let seen = picture.pixels().filter(|pixel| *pixel != background);
        assert!(seen.count() > 500, "{} is in the picture", scene.name);
        for slots in [MESH_MIN_SLOTS, 5, 7, one.fixture.frame.mesh_slots.get()] {
            let mut frame = one.fixture.frame;
            frame.mesh_slots = slots.into();
            one.fixture.submit(&frame).unwrap();
            assert!(one.picture() == picture, "{}: {slots} slots", scene.name);
        }
        let mut six = Blocks::of(&scene, 6);
        assert!(six.traced_with(&[]).unwrap() == picture, "{}", scene.name);
    }
}

#[test]
fn invalid_mesh_fields_are_refused() {
    let cases: [(&str, &str, Spoil); 20] = [
        ("mesh", "a multiple of 128", |frame| frame.mesh = (frame.mesh.get() + 16).into()),
        ("mesh_blocks", "1 to 2^24 blocks", |frame| frame.mesh_blocks = 0.into()),
        ("mesh_blocks", "1 to 2^24 blocks", |frame| frame.mesh_blocks = 0x100_0001.into()),
        ("code", "a multiple of 128", |frame| frame.code = (frame.code.get() + 64).into()),
        ("code_bytes", "39040 for a mesh", |frame| frame.code_bytes = 39056.into()),
        ("code_bytes", "a multiple of 16", |frame| {
            frame.code_bytes = (frame.code_bytes.get() - 4).into()
        }),
        ("code_bytes", "4294967280", |frame| frame.code_bytes = 0xffff_fff0.into()),
        ("mesh_material_count", "1 to 256", |frame| frame.mesh_material_count = 0.into()),
        ("mesh_material_count", "1 to 256", |frame| frame.mesh_material_count = 257.into()),
        ("mesh_material_count", "of the scene", |frame| frame.mesh_material_count = 256.into()),
        ("mesh_materials", "of the scene", |frame| {
            frame.mesh_materials = (SCENE_ADDRESS - 16).into()
        }),
        ("mesh_materials", "on quadwords", |frame| {
            frame.mesh_materials = (frame.mesh_materials.get() + 8).into()
        }),
        ("mesh_materials", "of the scene", |frame| {
            frame.mesh_materials = (SCENE_ADDRESS + frame.scene_bytes.get() - 80).into()
        }),
        ("mesh_slots", "4 to 20 blocks", |frame| frame.mesh_slots = 3.into()),
        ("mesh_slots", "4 to 20 blocks", |frame| frame.mesh_slots = 29.into()),
        ("mesh_slots", "4294967295", |frame| frame.mesh_slots = u32::MAX.into()),
        ("batch", "at most 8 with a mesh", |frame| {
            frame.batch = 9.into();
        }),
        ("mesh_cache", "before the code", |frame| {
            frame.mesh_cache = (frame.mesh_cache.get() + 128).into()
        }),
        ("mesh_cache", "behind the rays that wait", |frame| {
            frame.mesh_cache = SCENE_ADDRESS.into()
        }),
        ("mesh_cache", "a multiple of 128", |frame| {
            frame.mesh_cache = (EYE_CODE - 4 * MESH_BLOCK - 16).into();
            frame.mesh_slots = 4.into();
        }),
    ];
    Fixture::of(&scene(), 2).refuses(&cases);
}

#[test]
fn scene_without_memory_for_code_is_refused() {
    let mut fixture = Fixture::of(&scene(), 1);
    let leaves: Spoil = |frame: &mut Frame| {
        // Whole lines up to the code, without space for the queued rays.
        frame.scene_bytes = (EYE_CODE - SCENE_ADDRESS).into();
    };
    fixture.refuses(&[("scene_bytes", "leave space", leaves)]);
}

#[test]
fn invalid_blocks_are_refused() {
    let mut blocks = Blocks::new(2);
    assert_eq!(blocks.get(word(0, KIND)), MESH_INNER, "the root");
    let leaf = blocks.first(MESH_LEAF);
    // A child that is met wherever the ball is.
    let child = blocks.get(word(0, CHILDREN));
    let last = blocks.fixture.frame.mesh_blocks.get();
    let levels = blocks.get(word(0, LEVELS));
    let [nodes, triangles, vertices] =
        [NODES, TRIANGLES, VERTICES].map(|index| blocks.get(word(leaf, index)));
    let mut header = |what: &str, index: usize, value: u32| {
        blocks.refused(what, 0, &[(word(0, index), value)]);
    };
    header("another magic", 0, 0x4d45_5347);
    header("another number", NUMBER, 1);
    header("an unknown kind", KIND, 4);
    header("a kind that has no blocks", KIND, MESH_SPHERES);
    header("another such kind", KIND, MESH_CONES);
    header("no levels", LEVELS, 0);
    header("more levels", LEVELS, 4);
    header("other levels", LEVELS, levels % 3 + 1);
    header("no nodes", NODES, 0);
    header("more nodes than a block holds", NODES, 19);
    header("nodes without number", NODES, u32::MAX);
    header("triangles in an inner block", TRIANGLES, 1);
    header("vertices in an inner block", VERTICES, 1);
    header("unknown sides", SIDES, 1);
    header("a child that is the block itself", CHILDREN, 0);
    header("a child after the last block", CHILDREN, last);
    header("a child without number", CHILDREN, u32::MAX);
    header("a child in the middle of a node", CHILDREN, child + 16);

    let header = |index: usize| word(leaf, index);
    let children = FIRST + 28 * (nodes as usize - 1) + 24;
    let run = |first: u32, count: u32| (header(children), (4 * first) | (count << 16));
    let faces = FIRST + 28 * nodes as usize + 4 * vertices as usize;
    let cases = [
        ("a leaf without triangles", (header(TRIANGLES), 0)),
        ("a leaf without vertices", (header(VERTICES), 0)),
        ("more triangles", (header(TRIANGLES), 128)),
        ("more vertices", (header(VERTICES), 256)),
        ("too much for a block", (header(VERTICES), 127)),
        ("a run without triangles", run(0, 0)),
        ("an empty run that begins", run(1, 0)),
        ("a long run", run(0, 9)),
        ("a run behind the triangles", run(triangles - 1, 2)),
        ("a run between triangles", (header(children), (1 << 16) | 2)),
        ("a vertex that is not there", (header(faces), vertices << 24)),
        ("a material that is not there", (header(faces), 1)),
        ("a leaf that is marked as inner", (header(KIND), MESH_INNER)),
    ];
    for (what, case) in cases {
        blocks.refused(what, leaf, &[case]);
    }
    // The lane is empty now, but has a box.
    let lane = (0..4).rfind(|lane| blocks.get(header(children - 24 + lane)) != NO_BOX);
    let lane = lane.unwrap();
    blocks.refused("a box without a child", leaf, &[(header(children + lane), 0)]);
}

#[test]
fn invalid_sphere_blocks_are_refused() {
    objects_are_refused(&spheres(), MESH_SPHERES, 48);
}

#[test]
fn invalid_cone_blocks_are_refused() {
    objects_are_refused(&cones(), MESH_CONES, 64);
}

/// Damages a leaf of objects whose records have this size.
fn objects_are_refused(scene: &scenes::Scene, kind: u32, size: u32) {
    let mut blocks = Blocks::of(scene, 2);
    let leaf = blocks.first_needed(kind);
    let header = |index: usize| word(leaf, index);
    let [nodes, count] = [NODES, TRIANGLES].map(|index| blocks.get(header(index)));
    let child = header(FIRST + 28 * (nodes as usize - 1) + 24);
    let first = 32 + 112 * nodes;
    // The words of an object: its material is the second last.
    let material = header(first as usize / 4 + 10);
    let cases = [
        ("no objects", (header(TRIANGLES), 0)),
        ("too much for a block", (header(TRIANGLES), 40)),
        ("vertices", (header(VERTICES), 1)),
        ("an object before the first", (child, first - size)),
        ("an object after the last", (child, first + size * count)),
        ("an object between objects", (child, first + 16)),
        ("an object between quadwords", (child, first + 4)),
        ("an object in another block", (child, u32::MAX)),
        ("a material that is not there", (material, 2)),
        ("a leaf that is marked as one of triangles", (header(KIND), MESH_LEAF)),
    ];
    for (what, case) in cases {
        blocks.refused(what, leaf, &[case]);
    }
}

/// Whatever a block has, the SPU replies: it refuses the block, or draws its content.
#[test]
fn any_block_is_drawn_or_refused() {
    // With its cache there, a damaged sphere leads to numbers of blocks that the mesh does not
    // have.
    for (scene, lower) in [(scene(), 0), (spheres(), 256), (cones(), 0)] {
        any_block_of(&scene, lower);
    }
}

fn any_block_of(scene: &scenes::Scene, lower: u32) {
    let mut blocks = Blocks::of(scene, 1);
    let cache = blocks.fixture.frame.mesh_cache.get();
    blocks.fixture.frame.mesh_cache = (cache - lower).into();
    let mut random = ChaCha8Rng::seed_from_u64(20);
    let picture = blocks.traced_with(&[]).unwrap();
    let (mut drawn, mut refused) = (0, 0);
    let rounds = randomness::rounds(75);
    for number in 0..rounds {
        let block = random.random_range(0..blocks.fixture.frame.mesh_blocks.get());
        let used = match random.random_range(0..3) {
            0 => 8,
            1 => CHILDREN + 4,
            _ => MESH_BLOCK as usize / 4,
        };
        let at = word(block, random.random_range(0..used));
        let value = match random.random_range(0..4) {
            0 => random.random(),
            1 => blocks.get(at) ^ (1 << random.random_range(0..32)),
            2 => blocks.get(at).wrapping_add(random.random_range(0..9)).wrapping_sub(4),
            _ => (random.random_range(0..130) << 16) | random.random_range(0..2048),
        };
        match blocks.traced_with(&[(at, value)]) {
            Ok(_) => drawn += 1,
            Err(EngineError::Refused { .. }) => refused += 1,
            Err(error) => panic!("{number}: {value:#x} at {at:#x}: {error}"),
        }
    }
    assert!(drawn > rounds / 6 && refused > rounds / 6, "{drawn} drawn, {refused} refused");
    assert!(blocks.traced_with(&[]).unwrap() == picture);
}
