//! The kernels that sort triangles and pack them into leaf blocks.

use twins::mesh_prepare::WORDS;
use twins::sort::{Grid, Packed, Triangle, codes, corners, pack, sort};

use crate::prelude::*;
use protocol::layout::{SIDES_BOTH, SIDES_SMOOTH};

/// The most vertices of a block that `sort_pack` looks at, and the bytes that it needs.
const LIST: usize = 94;
const MEMORY: usize = 10_208 / 4;

pub(super) fn put_triangles(bench: &mut Bench, triangles: &[Triangle]) -> Place {
    put(bench, &triangles.iter().map(|it| it.map(U32::new)).collect::<Vec<_>>())
}

fn read_triangles(bench: &Bench, place: Place) -> Vec<Triangle> {
    bench.read_all::<[U32; 4]>(place).into_iter().map(|it| it.map(U32::get)).collect()
}

pub(super) fn any_triangle(random: &mut ChaCha8Rng) -> Triangle {
    [(); 4].map(|()| random.random())
}

/// A strip: each triangle shares two vertices with the one before it.
fn strip(count: usize) -> Vec<Triangle> {
    (0..count as u32).map(|first| [first, first, first + 1, first + 2]).collect()
}

/// Triangles whose corners are to be fetched.
#[derive(Clone, Debug)]
pub struct CornerList {
    triangles: Vec<Triangle>,
    low: u32,
    vertices: u32,
}

impl CornerList {
    /// A strip of triangles, in twos.
    #[must_use]
    pub fn in_a_row(twos: usize) -> Self {
        Self { triangles: strip(2 * twos), low: 0, vertices: 1 << 24 }
    }
}

impl Description for CornerList {
    const KERNEL: &'static str = "sort_corners";
    const ROUNDS: [usize; 2] = [20, 1000];
    const SHARES: [std::ops::Range<f64>; 2] = [1.0..f64::INFINITY, 0.05..0.9];
    type Placed = Place;
    /// The list, if all vertices exist.
    type Found = Option<Vec<[u32; 2]>>;

    fn sensible(twos: usize, random: &mut ChaCha8Rng) -> Self {
        let vertices = random.random_range(1..1 << 24);
        let mut triangle = || {
            let upper = random.random::<u32>() & 0xff00_0000;
            [(); 4].map(|()| upper | random.random_range(0..vertices))
        };
        let triangles = (0..2 * twos).map(|_| triangle()).collect();
        Self { triangles, low: random.random::<u32>() & !127, vertices }
    }

    /// One vertex, or their number, may be anything.
    fn any(twos: usize, random: &mut ChaCha8Rng) -> Self {
        let mut inputs = Self::sensible(twos, random);
        match random.random_range(0..3) {
            0 => inputs.vertices = random.random_range(0..1 << 24),
            1 => inputs.triangles[random.random_range(0..2 * twos)] = any_triangle(random),
            _ => {}
        }
        inputs
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let triangles = put_triangles(bench, &self.triangles).address;
        let list = put(bench, &vec![[U32::ZERO; 2]; 3 * self.triangles.len()]);
        let twos = self.triangles.len() as u32 / 2;
        (list, vec![triangles, twos, list.address, self.low, self.vertices])
    }

    fn found(&self, bench: &Bench, list: &Place, damaged: u32) -> Self::Found {
        let elements: Vec<[U32; 2]> = bench.read_all(*list);
        (damaged == 0).then(|| elements.into_iter().map(|it| it.map(U32::get)).collect())
    }

    fn twin(&self, _: &Place) -> Self::Found {
        corners(&self.triangles, self.low, self.vertices)
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        [usize::from(found.is_some()), 1]
    }
}

/// Triangles that get codes.
#[derive(Clone, Debug)]
pub struct Codes {
    triangles: Vec<Triangle>,
    corners: Vec<[u32; 4]>,
    grid: Grid,
}

impl Codes {
    /// Triangles in fours, all at one point.
    #[must_use]
    pub fn in_a_row(fours: usize) -> Self {
        let triangles = strip(4 * fours);
        let corners = vec![[0; 4]; 3 * triangles.len()];
        Self { triangles, corners, grid: Grid { low: [0; 3], scale: 0, shift: 0 } }
    }
}

impl Description for Codes {
    const KERNEL: &'static str = "sort_codes";
    const ROUNDS: [usize; 2] = [50, 1000];
    const LENGTHS: &'static [usize] = &[2, 3, 7, 16, 40];
    type Placed = Place;
    type Found = Vec<Triangle>;

    fn sensible(fours: usize, random: &mut ChaCha8Rng) -> Self {
        let mut inputs = Self::any(fours, random);
        let number = |random: &mut ChaCha8Rng| random.random_range(-100.0_f32..100.0).to_bits();
        inputs.corners.fill_with(|| [(); 4].map(|()| number(random)));
        let bits = random.random_range(4..20);
        let scale = (1_u32 << bits) as f32;
        let low = [(-300.0 * scale) as i32 as u32; 3];
        // The cells are below 600 times the scale.
        let shift = bits;
        Self { grid: Grid { low, scale: scale.to_bits(), shift }, ..inputs }
    }

    fn any(fours: usize, random: &mut ChaCha8Rng) -> Self {
        let triangles: Vec<_> = (0..4 * fours).map(|_| any_triangle(random)).collect();
        let corner = |_| [(); 4].map(|()| any_bits(random));
        let corners = (0..3 * triangles.len()).map(corner).collect();
        let low = [(); 3].map(|()| random.random());
        let grid = Grid { low, scale: any_bits(random), shift: random.random_range(0..64) };
        Self { triangles, corners, grid }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let triangles = put_triangles(bench, &self.triangles);
        let corners = put_triangles(bench, &self.corners).address;
        let [x, y, z] = self.grid.low.map(U32::new);
        let build = protocol::layout::Build {
            low: [x, y, z],
            scale: f32::from_bits(self.grid.scale).into(),
            shift: self.grid.shift.into(),
            ..zerocopy::FromZeros::new_zeroed()
        };
        let build = put(bench, &[build]).address;
        let fours = self.triangles.len() as u32 / 4;
        (triangles, vec![triangles.address, fours, corners, build])
    }

    fn found(&self, bench: &Bench, triangles: &Place, _: u32) -> Self::Found {
        read_triangles(bench, *triangles)
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let mut triangles = self.triangles.clone();
        codes(&mut triangles, &self.corners, self.grid);
        triangles
    }
}

/// Triangles that are sorted.
#[derive(Clone, Debug)]
pub struct Sort {
    triangles: Vec<Triangle>,
}

impl Sort {
    /// Triangles in fours, in their order.
    #[must_use]
    pub fn in_a_row(fours: usize) -> Self {
        Self { triangles: strip(4 * fours) }
    }
}

impl Description for Sort {
    const KERNEL: &'static str = "sort_elements";
    const ROUNDS: [usize; 2] = [20, 200];
    type Placed = Place;
    type Found = Vec<Triangle>;

    /// Few codes, so that many are equal.
    fn sensible(fours: usize, random: &mut ChaCha8Rng) -> Self {
        let mut inputs = Self::any(fours, random);
        let mask = random.random::<u32>() & random.random::<u32>() & random.random::<u32>();
        inputs.triangles.iter_mut().for_each(|triangle| triangle[0] &= mask);
        inputs
    }

    fn any(fours: usize, random: &mut ChaCha8Rng) -> Self {
        Self { triangles: (0..4 * fours).map(|_| any_triangle(random)).collect() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let triangles = put_triangles(bench, &self.triangles);
        let other = put_triangles(bench, &vec![[0; 4]; self.triangles.len()]).address;
        let table = bench.junk::<[U32; 1024]>().address;
        let fours = self.triangles.len() as u32 / 4;
        (triangles, vec![triangles.address, fours, other, table])
    }

    fn found(&self, bench: &Bench, triangles: &Place, _: u32) -> Self::Found {
        read_triangles(bench, *triangles)
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let mut triangles = self.triangles.clone();
        sort(&mut triangles);
        triangles
    }
}

/// Sorted triangles that become a block.
#[derive(Clone, Debug)]
pub struct Pack {
    triangles: Vec<Triangle>,
    low: u32,
    vertices: u32,
    number: u32,
}

impl Pack {
    /// A strip of triangles.
    #[must_use]
    pub fn strip(count: usize) -> Self {
        Self { triangles: strip(count), low: 0, vertices: 1 << 24, number: 0 }
    }
}

impl Description for Pack {
    const KERNEL: &'static str = "sort_pack";
    const ROUNDS: [usize; 2] = [100, 1000];
    const LENGTHS: &'static [usize] = &[1, 2, 3, 4, 5, 15, 16, 17, 18, 30, 80, 127, 128, 200];
    const SHARES: [std::ops::Range<f64>; 2] = [1.0..f64::INFINITY, 0.3..0.95];
    type Placed = [Place; 2];
    /// What is packed, with the list; `None` if a vertex does not exist.
    type Found = Option<(Packed, Vec<[u32; 2]>)>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        // From triangles that share all vertices to those that share none.
        let around = random.random_range(1..200);
        let first = random.random_range(0..1 << 23);
        let sides = [0, SIDES_BOTH, SIDES_SMOOTH, SIDES_BOTH | SIDES_SMOOTH];
        let mut sides = sides[random.random_range(0..4)];
        let triangles = (0..count as u32).map(|at| {
            if random.random_ratio(1, 300) {
                sides ^= SIDES_BOTH;
            }
            let [a, b, c] =
                [(); 3].map(|()| first + at * around / 64 + random.random_range(0..around));
            [random.random::<u32>() >> 2, random.random::<u32>() << 24 | a, sides | b, c]
        });
        let triangles = triangles.collect();
        let low = random.random::<u32>() & !127;
        Self { triangles, low, vertices: 1 << 24, number: random.random_range(0..1 << 24) }
    }

    /// Triangles, and the number of vertices, may be anything.
    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut inputs = Self::sensible(count, random);
        match random.random_range(0..3) {
            0 => inputs.vertices = random.random_range(0..1 << 24),
            1 => {
                inputs.triangles.fill_with(|| any_triangle(random));
            }
            _ => {}
        }
        inputs
    }

    fn place(&self, bench: &mut Bench) -> ([Place; 2], Vec<u32>) {
        let with_one_more = [&self.triangles[..], &[[0; 4]]].concat();
        let triangles = put_triangles(bench, &with_one_more).address;
        let block = bench.junk::<[U32; WORDS]>();
        let list = put(bench, &[[U32::ZERO; 2]; LIST]);
        let memory = put(bench, &[U32::ZERO; MEMORY]).address;
        let Self { low, vertices, number, .. } = *self;
        let count = self.triangles.len() as u32;
        let turn = 1 + number % 255;
        let arguments = vec![
            triangles,
            count,
            block.address,
            list.address,
            memory,
            low,
            vertices,
            number,
            turn,
        ];
        ([block, list], arguments)
    }

    fn found(&self, bench: &Bench, &[block, list]: &[Place; 2], triangles: u32) -> Self::Found {
        let block = bench.read::<[U32; WORDS]>(block).map(U32::get);
        let list = bench.read::<[[U32; 2]; LIST]>(list).map(|it| it.map(U32::get));
        let list = list[..(block[6] as usize).min(LIST)].to_vec();
        let vertices = list.iter().map(|it| (it[1].wrapping_sub(self.low)) >> 4).collect();
        let packed = || Packed { block, vertices, triangles: triangles as usize };
        (triangles > 0).then(|| (packed(), list))
    }

    fn twin(&self, _: &[Place; 2]) -> Self::Found {
        let packed = pack(&self.triangles, self.number, self.vertices)?;
        let element = |vertex: &u32| [16, (vertex << 4).wrapping_add(self.low)];
        let list = packed.vertices.iter().map(element).collect();
        Some((packed, list))
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        [usize::from(found.is_some()), 1]
    }
}
