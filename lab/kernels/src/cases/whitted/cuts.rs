//! The kernels that find a height field by cuts: cells of its samples, the cuts over these, and the
//! rays and surfaces of the ground that they have found.

use std::array;

use crate::catalogue::sensible;
use crate::prelude::*;
use protocol::layout::MATERIAL_LIT;
use rand::RngCore as _;
use twins::cuts::{self, CELLS, Cells, Cuts, Level, SAMPLES, SIDE};

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of::<CutCells>([sensible("block", Objects::Fixed(1))]).rays(1).error(height_error),
        Kernel::of::<CutFour>([sensible("a tile", Objects::Fixed(1))])
            .rays(4)
            .error(distance_error),
        Kernel::of::<CutRays>([sensible("all hit", Objects::List(4, 8))]).error(ray_error),
        Kernel::of::<CutGround>([sensible("all hit", Objects::List(4, 8))]).error(normal_error),
    ]
}

/// Puts numbers into local store, each in all lanes of a quadword.
fn splats(bench: &mut Bench, numbers: &[u32]) -> Place {
    let quads: Vec<[U32; 4]> = numbers.iter().map(|&number| [number.into(); 4]).collect();
    put(bench, &quads)
}

/// An address in a case's buffers, whichever the bench takes.
fn quads(words: &[[u32; 4]]) -> Vec<[U32; 4]> {
    words.iter().map(|quad| quad.map(U32::new)).collect()
}

/// Both arrays of cells, one after the other.
fn put_cells(bench: &mut Bench, cells: &Cells) -> Place {
    put(bench, &quads(&cells.concat()))
}

/// The samples of a block, and its level.
#[derive(Debug)]
pub struct CutCells {
    samples: [u32; SAMPLES],
    level: Level,
    corner: [u32; 2],
}

impl CutCells {
    fn nothing() -> Cells {
        [vec![[0; 4]; CELLS * CELLS], vec![[0; 4]; CELLS * CELLS]]
    }

    /// The cells of the block.
    fn own(&self, cells: &Cells) -> Vec<[u32; 4]> {
        let at = |index: usize| {
            let [column, row] = self.corner.map(|at| at as usize);
            (row + index / SIDE) % CELLS * CELLS + (column + index % SIDE) % CELLS
        };
        cells.iter().flat_map(|of| (0..SIDE * SIDE).map(move |index| of[at(index)])).collect()
    }
}

/// The largest error of a height, in lengths of a height of 1: half of the samples fade.
fn height_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..20 {
        let block = CutCells::sensible(1, random);
        let found = block.call(bench);
        let level = &block.level;
        let [side, above, from, fade, unit] =
            [level.side, level.above, level.from, level.fade, level.unit].map(to_f64);
        let corner = level.corner.map(to_f64);
        for (index, cell) in found[..SIDE * SIDE].iter().enumerate() {
            let (down, across) = (index / SIDE, index % SIDE);
            let height = |word: u32| f64::from(word >> 16);
            let own = height(block.samples[12 * down + across]);
            let coarse =
                |down: usize, across: usize| height(block.samples[108 + 8 * down + across]);
            let other = [down / 2, down.div_ceil(2)]
                .into_iter()
                .flat_map(|down| [across / 2, across.div_ceil(2)].map(|across| (down, across)));
            let other = other.map(|(down, across)| coarse(down, across)).sum::<f64>() / 4.0;
            let place =
                |first: u32, at: usize, corner: f64| corner + side * (f64::from(first) + at as f64);
            let x = place(block.corner[0], across, corner[0]);
            let z = place(block.corner[1], down, corner[2]);
            let part = ((x * x + z * z + above - from) * fade).clamp(0.0, 1.0);
            let exact = corner[1] + unit * (own + part * (other - own));
            worst = worst.max((to_f64(cell[0]) - exact).abs() / unit);
        }
    }
    worst
}

impl Description for CutCells {
    const KERNEL: &'static str = "cuts_cells";
    const ROUNDS: [usize; 2] = [60, 100];
    const LENGTHS: &'static [usize] = &[1];
    type Placed = Place;
    type Found = Vec<[u32; 4]>;

    fn sensible(_: usize, random: &mut ChaCha8Rng) -> Self {
        let base = random.random_range(0..60000_u32);
        let samples = array::from_fn(|_| {
            (base + random.random_range(0..3000)) << 16 | random.random_range(0..0x1_0000)
        });
        let side = random.random_range(0.1..300.0);
        let corner = [(); 2].map(|()| SIDE as u32 * random.random_range(0..512_u32));
        let mut away =
            |index: u32| random.random_range(-40.0..40.0) * side - side * f64::from(index);
        let [x, z] = [away(corner[0]), away(corner[1])];
        let from = (20.0 * side) * (20.0 * side);
        let level = Level {
            side: from_f64(side),
            corner: [x, random.random_range(-900.0..0.0), z].map(from_f64),
            above: from_f64(random.random_range(0.0..from)),
            from: from_f64(from),
            fade: from_f64(1.0 / from),
            unit: from_f64(0.05),
        };
        Self { samples, level, corner }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let mut number = || random.next_u32();
        let level = Level {
            side: number(),
            corner: [(); 3].map(|()| number()),
            above: number(),
            from: number(),
            fade: number(),
            unit: number(),
        };
        let corner = [(); 2].map(|()| SIDE as u32 * (number() % 512));
        Self { samples: array::from_fn(|_| number()), level, corner }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let samples = put(bench, &self.samples.map(U32::new)).address;
        let Level { side, corner: [x, y, z], above, from, fade, unit } = self.level;
        let level = splats(bench, &[side, x, y, z, above, from, fade, unit]).address;
        let cells = put_cells(bench, &Self::nothing());
        (cells, vec![samples, level, self.corner[0], self.corner[1], cells.address])
    }

    fn found(&self, bench: &Bench, cells: &Place, _: u32) -> Self::Found {
        let all: Vec<[U32; 4]> = bench.read_all(*cells);
        let all: Vec<[u32; 4]> = all.into_iter().map(|quad| quad.map(U32::get)).collect();
        let (heights, colours) = all.split_at(CELLS * CELLS);
        self.own(&[heights.to_vec(), colours.to_vec()])
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let mut cells = Self::nothing();
        cuts::cells(&self.samples, &self.level, self.corner, &mut cells);
        self.own(&cells)
    }
}

/// Pixels of a row of the test's tile: those of four cuts.
const ACROSS: u32 = 4;
/// Rows of the test's tile. Others have the pixels of these: there is no memory for more.
const ROWS: u32 = 4;
/// Squares across and down.
const SQUARES: usize = CELLS - 4;
/// The pixels.
const PIXELS: usize = (ACROSS * ROWS) as usize;

/// Four cuts over waves, from their middle.
#[derive(Debug)]
pub struct CutFour {
    cells: Cells,
    cuts: Cuts,
    column: i32,
    states: [[u32; 4]; 2],
}

impl CutFour {
    /// The cuts with their rows' pixels at an address.
    fn at(&self, pixels: u32) -> Cuts {
        let mut cuts = self.cuts;
        for (row, words) in cuts.rows.iter_mut().enumerate() {
            let first = 16 * ((row as u32 % ROWS * ACROSS) as i32 - self.column);
            words[2] = pixels.wrapping_add_signed(first);
        }
        cuts
    }
}

/// The largest error of a distance, in squares: how far a point of the kernel's is from where the
/// ray meets the patches, by small steps.
fn distance_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..10 {
        let four = CutFour::sensible(1, random);
        let (_, pixels) = four.call(bench);
        let cuts = &four.cuts;
        let [lat, den_m, den, num] = cuts.linear.map(|pair| pair.map(to_f64));
        for (index, pixel) in pixels.iter().enumerate().filter(|(_, pixel)| pixel[0] != 0) {
            let (row, lane) = (index / 4, index % 4);
            let column = f64::from(four.column + lane as i32);
            let of = |pair: [f64; 2]| pair[0] + column * pair[1];
            let [more_num, more_den, ..] = cuts.rows[row].map(to_f64);
            let slope = (of(num) + more_num) / (of(den) + more_den);
            let tangent = of(lat) / of(den_m);
            let along: [f64; 2] = array::from_fn(|axis| {
                to_f64(cuts.per_side)
                    * (to_f64(cuts.ahead[axis]) + tangent * to_f64(cuts.aside[axis]))
            });
            let ground = |s: f64| {
                let at: [f64; 2] =
                    array::from_fn(|axis| to_f64(cuts.origin[axis]) + s * along[axis]);
                let [x, z] = at.map(f64::floor);
                let [fx, fz] = [at[0] - x, at[1] - z];
                let cell = four.cells[0][z as usize % CELLS * CELLS + x as usize % CELLS];
                let [a, b, c, d] = cell.map(to_f64);
                (a + (b - a) * fx) * (1.0 - fz) + (c + (d - c) * fx) * fz
            };
            let s = to_f64(pixel[0]);
            worst = worst.max((ground(s) - s * slope).abs() * to_f64(cuts.per_side));
        }
    }
    worst
}

impl Description for CutFour {
    const KERNEL: &'static str = "cuts_follow";
    const ROUNDS: [usize; 2] = [100, 60];
    const LENGTHS: &'static [usize] = &[1];
    type Placed = [Place; 2];
    /// Where the cuts are, and the pixels.
    type Found = ([[u32; 4]; 2], Vec<[u32; 4]>);

    fn sensible(_: usize, random: &mut ChaCha8Rng) -> Self {
        let side = random.random_range(0.5..20.0);
        let size = side * random.random_range(0.2..2.0);
        let [wave_x, wave_z] = [(); 2].map(|()| random.random_range(0.2..0.6));
        let ground = move |column: usize, row: usize| {
            let [x, z] = [column % CELLS, row % CELLS].map(|at| at as f64);
            size * (libm::sin(wave_x * x) * libm::cos(wave_z * z) - 1.5)
        };
        let corners = |at: usize| {
            [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(x, z)| (at % CELLS + x, at / CELLS + z))
        };
        let heights = (0..CELLS * CELLS).map(|at| corners(at).map(|(x, z)| from_f64(ground(x, z))));
        let colour = |(x, z): (usize, usize)| {
            let at = (z % CELLS * CELLS + x % CELLS) as u32;
            at.wrapping_mul(2_654_435_761) & !3
        };
        let colours = (0..CELLS * CELLS).map(|at| corners(at).map(colour));
        let cells = [heights.collect(), colours.collect()];
        let turn = random.random_range(0.0..std::f64::consts::TAU);
        let (sine, cosine) = (libm::sin(turn), libm::cos(turn));
        let pixel = random.random_range(0.001..0.02);
        let first = random.random_range(-0.9..0.3);
        let column = 4 * random.random_range(-2..17);
        let den = [1.0, random.random_range(-0.001..0.001)];
        let linear =
            [[-32.0 * pixel, pixel], den, den, [first, random.random_range(-0.001..0.001)]];
        let mut row = |row: u32| {
            let aside = random.random_range(-2_i32..3);
            let num = from_f64(-f64::from(row) * pixel);
            [num, from_f64(f64::from(row) * 0.0003), 0, aside.cast_unsigned()]
        };
        let cuts = Cuts {
            rows: array::from_fn(|number| row(number as u32)),
            linear: linear.map(|pair| pair.map(from_f64)),
            ahead: [cosine, sine].map(from_f64),
            aside: [-sine, cosine].map(from_f64),
            per_side: from_f64(1.0 / side),
            origin: [(); 2].map(|()| from_f64(random.random_range(8.0..24.0))),
            end: [from_f64(SQUARES as f64); 2],
            limit: from_f64(side * random.random_range(4.0..40.0)),
            slope: from_f64(0.5 / side),
        };
        let from = array::from_fn(|_| from_f64(random.random_range(0.0..2.0) * side));
        let rows = array::from_fn(|_| random.random_range(-1..16_i32).cast_unsigned());
        Self { cells, cuts, column, states: [from, rows] }
    }

    /// Directions are sensible, so that cuts end.
    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut four = Self::sensible(count, random);
        for cell in four.cells.iter_mut().flatten() {
            *cell = [(); 4].map(|()| random.next_u32());
        }
        for row in &mut four.cuts.rows {
            (row[0], row[1]) = (random.next_u32(), random.next_u32());
        }
        four.states[0] = [(); 4].map(|()| random.next_u32());
        four
    }

    fn place(&self, bench: &mut Bench) -> ([Place; 2], Vec<u32>) {
        // There is no memory for the last colours, which no cut gets to.
        let cells = self.cells.concat();
        let cells = put(bench, &quads(&cells[..CELLS * (CELLS + SQUARES)])).address;
        let pixels = put(bench, &quads(&[[0; 4]; PIXELS + 4]));
        let cuts = self.at(pixels.address);
        let nowhere = pixels.address + 16 * PIXELS as u32;
        let [[lat, lat_x], [den_m, den_x], [den, _], [num, num_x]] = cuts.linear;
        let numbers = [
            [lat, lat_x, den_m, den_x, den, num, num_x].to_vec(),
            [cuts.ahead, cuts.aside].concat(),
            vec![cuts.per_side],
            [cuts.origin, cuts.end].concat(),
            vec![cuts.limit, cuts.slope],
        ];
        let mut all = quads(&self.states);
        all.extend(numbers.concat().iter().map(|&number| [U32::new(number); 4]));
        all.push(array::from_fn(|lane| (nowhere + 16 * lane as u32).into()));
        all.extend(quads(&cuts.rows));
        let all = put(bench, &all);
        let arguments = vec![all.address + 32, all.address, self.column.cast_unsigned(), cells];
        ([all.first(32), pixels], arguments)
    }

    fn found(&self, bench: &Bench, &[states, pixels]: &[Place; 2], _: u32) -> Self::Found {
        let states: [[U32; 4]; 2] = bench.read(states);
        let pixels: Vec<[U32; 4]> = bench.read_all(pixels);
        let pixels = pixels[..PIXELS].iter();
        (states.map(|quad| quad.map(U32::get)), pixels.map(|it| it.map(U32::get)).collect())
    }

    fn twin(&self, [_, place]: &[Place; 2]) -> Self::Found {
        let cuts = self.at(place.address);
        let [mut first, mut second] = self.states;
        let mut all = vec![[0; 4]; PIXELS];
        for (column, (one, two)) in (self.column..).zip(first.iter_mut().zip(&mut second)) {
            let (state, pixels) = cuts::cut(&cuts, &self.cells, column, [*one, *two]);
            [*one, *two] = state;
            for (address, pixel) in pixels {
                all[(address - place.address) as usize / 16] = pixel;
            }
        }
        ([first, second], all)
    }

    fn part(&self, (_, pixels): &Self::Found) -> [usize; 2] {
        [pixels.iter().filter(|pixel| pixel[0] != 0).count(), pixels.len()]
    }

    const SHARES: [std::ops::Range<f64>; 2] = [0.1..0.9, 0.0..1.0];
}

/// Packets of primary rays and their pixels. Absent rays have a distance of -1.
#[derive(Debug)]
struct Packets {
    rays: Vec<[[u32; 16]; 4]>,
    pixels: Vec<[u32; 4]>,
}

/// The address of the ground's object, and that of another.
const GROUND: u32 = 0x1230;
const OTHER: u32 = 0x4560;

impl Packets {
    fn new(count: usize, random: &mut ChaCha8Rng, is_hit: bool) -> Self {
        let mut packet = || {
            let mut rays = [[0; 4]; 16];
            for ray in &mut rays {
                let direction = [0.0, 0.0, -1.0].map(|part| part + random.random_range(-0.7..0.7));
                let direction = unit(direction);
                let t = match (random.random_range(0..8), is_hit) {
                    (0, false) => -1.0,
                    (_, false) => 1e18,
                    (_, true) => random.random_range(1.0..2e4),
                };
                let [x, _, z] = direction.map(from_f64);
                let object = if is_hit && random.random() { GROUND } else { OTHER };
                *ray = [x, z, from_f64(t), object];
            }
            [0, 1, 2, 3].map(|row| rays.map(|ray| ray[row]))
        };
        let rays = (0..count).map(|_| packet()).collect();
        let mut pixel = || {
            let s = if random.random_range(0..4) > 0 { random.random_range(1.0..2e4) } else { 0.0 };
            let slopes = [(); 2].map(|()| from_f64(random.random_range(-3.0..3.0)));
            [from_f64(s), slopes[0], slopes[1], random.next_u32()]
        };
        let pixels = (0..16 * count).map(|_| pixel()).collect();
        Self { rays, pixels }
    }

    /// The rays, whose pixels are at an address.
    fn put(&self, bench: &mut Bench) -> [Place; 2] {
        let pixels = put(bench, &quads(&self.pixels));
        let packets = self.rays.iter().enumerate().map(|(number, rows)| {
            let mut packet = RayPacket::new_zeroed();
            let single = |bits: u32| zerocopy::big_endian::F32::from_bytes(bits.to_be_bytes());
            packet.direction_x = rows[0].map(single);
            packet.direction_z = rows[1].map(single);
            packet.t = rows[2].map(single);
            packet.object = rows[3].map(U32::new);
            packet.pixel =
                array::from_fn(|lane| (pixels.address + 16 * (16 * number + lane) as u32).into());
            packet
        });
        let packets: Vec<RayPacket> = packets.collect();
        [put(bench, &packets), pixels]
    }
}

/// Rays that hit the ground.
#[derive(Debug)]
pub struct CutRays {
    packets: Packets,
    ahead: [u32; 2],
}

impl Description for CutRays {
    const KERNEL: &'static str = "cuts_rays_r16";
    const ROUNDS: [usize; 2] = [20, 20];
    const LENGTHS: &'static [usize] = &[1, 2, 3, 8];
    type Placed = Place;
    /// Distances and objects.
    type Found = Vec<[[u32; 16]; 2]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let turn = random.random_range(-0.4..0.4);
        let ahead = [libm::sin(turn), -libm::cos(turn)].map(from_f64);
        Self { packets: Packets::new(count, random, false), ahead }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut rays = Self::sensible(count, random);
        rays.ahead = [(); 2].map(|()| random.next_u32());
        rays
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let [rays, _] = self.packets.put(bench);
        let ahead = put(bench, &[[self.ahead[0], self.ahead[1], 0, 0].map(U32::new)]).address;
        (rays, vec![rays.address, self.packets.rays.len() as u32, ahead, GROUND])
    }

    fn found(&self, bench: &Bench, rays: &Place, _: u32) -> Self::Found {
        let rays: Vec<RayPacket> = bench.read_all(*rays);
        let bits = |packet: &RayPacket| {
            [packet.t.map(|t| u32::from_be_bytes(t.to_bytes())), packet.object.map(U32::get)]
        };
        rays.iter().map(bits).collect()
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let packets = self.packets.rays.iter().zip(self.packets.pixels.chunks(16));
        packets
            .map(|([x, z, t, object], pixels)| {
                let hit = |lane: usize| {
                    let direction = [x[lane], 0, z[lane]];
                    cuts::hit(direction, self.ahead, t[lane], pixels[lane][0])
                };
                [
                    array::from_fn(|lane| hit(lane).unwrap_or(t[lane])),
                    array::from_fn(|lane| hit(lane).map_or(object[lane], |_| GROUND)),
                ]
            })
            .collect()
    }
}

/// Surfaces some of which are ground.
#[derive(Debug)]
pub struct CutGround {
    packets: Packets,
    is_root: bool,
    colours: Vec<[[u32; 16]; 3]>,
}

/// The largest error of a ray's distance, in its ulps.
fn ray_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..20 {
        let rays = CutRays::sensible(8, random);
        let [ahead_x, ahead_z] = rays.ahead.map(to_f64);
        for (number, [found, objects]) in rays.call(bench).iter().enumerate() {
            let [x, z, ..] = rays.packets.rays[number];
            for lane in (0..16).filter(|&lane| objects[lane] == GROUND) {
                let along = to_f64(x[lane]) * ahead_x + to_f64(z[lane]) * ahead_z;
                let exact = to_f64(rays.packets.pixels[16 * number + lane][0]) / along;
                worst = worst.max((to_f64(found[lane]) / exact - 1.0).abs() * 2_f64.powi(23));
            }
        }
    }
    worst
}

/// The largest error of a part of a normal, in ulps of 1.
fn normal_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..20 {
        let ground = CutGround::sensible(8, random);
        let made = ground.call(bench);
        for (ray, (surface, pixel)) in made.0.iter().zip(&ground.packets.pixels).enumerate() {
            if ground.packets.rays[ray / 16][3][ray % 16] == GROUND {
                let exact = unit([-to_f64(pixel[1]), 1.0, -to_f64(pixel[2])]);
                let normal = &surface[..3];
                for (found, exact) in normal.iter().zip(exact) {
                    worst = worst.max((to_f64(*found) - exact).abs());
                }
            }
        }
    }
    worst * 2_f64.powi(23)
}

impl Description for CutGround {
    const KERNEL: &'static str = "cuts_ground_r16";
    const ROUNDS: [usize; 2] = [20, 20];
    const LENGTHS: &'static [usize] = &[1, 2, 3, 8];
    type Placed = [Place; 2];
    /// Of each ray: normal, plane's normal, colour and leave; and the pixels' sums.
    type Found = (Vec<[u32; 10]>, Vec<[u32; 4]>);

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let packets = Packets::new(count, random, true);
        let mut part = || from_f64(random.random_range(0.0..1.0));
        let colours = (0..count).map(|_| [(); 3].map(|()| [(); 16].map(|()| part()))).collect();
        Self { packets, is_root: random.random(), colours }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut ground = Self::sensible(count, random);
        for pixel in &mut ground.packets.pixels {
            *pixel = [(); 4].map(|()| random.next_u32());
        }
        ground
    }

    fn place(&self, bench: &mut Bench) -> ([Place; 2], Vec<u32>) {
        let [rays, pixels] = self.packets.put(bench);
        let surfaces = self.colours.iter().map(|[red, green, blue]| {
            let mut surfaces = Surfaces::new_zeroed();
            let single = |bits: u32| zerocopy::big_endian::F32::from_bytes(bits.to_be_bytes());
            surfaces.red = red.map(single);
            surfaces.green = green.map(single);
            surfaces.blue = blue.map(single);
            surfaces.flags = [MATERIAL_LIT.into(); 4];
            surfaces
        });
        let surfaces: Vec<Surfaces> = surfaces.collect();
        let count = surfaces.len() as u32;
        let is_root = if self.is_root { u32::MAX } else { 0 };
        let surfaces = put(bench, &surfaces);
        ([surfaces, pixels], vec![rays.address, surfaces.address, count, GROUND, is_root])
    }

    fn found(&self, bench: &Bench, &[surfaces, pixels]: &[Place; 2], _: u32) -> Self::Found {
        let surfaces: Vec<Surfaces> = bench.read_all(surfaces);
        let of = |it: &Surfaces, lane: usize| {
            [
                it.normal_x,
                it.normal_y,
                it.normal_z,
                it.plane_x,
                it.plane_y,
                it.plane_z,
                it.red,
                it.green,
                it.blue,
                it.leave,
            ]
            .map(|row| u32::from_be_bytes(row[lane].to_bytes()))
        };
        let of_rays = surfaces.iter().flat_map(|it| (0..16).map(move |lane| of(it, lane)));
        let sums: Vec<[U32; 4]> = bench.read_all(pixels);
        (of_rays.collect(), sums.into_iter().map(|it| it.map(U32::get)).collect())
    }

    fn twin(&self, _: &[Place; 2]) -> Self::Found {
        let of_rays = self.packets.pixels.iter().enumerate().map(|(ray, &pixel)| {
            let (packet, lane) = (ray / 16, ray % 16);
            let [_, _, t, object] = &self.packets.rays[packet];
            let colour = self.colours[packet].map(|channel| channel[lane]);
            if object[lane] != GROUND {
                let [red, green, blue] = colour;
                return [0, 0, 0, 0, 0, 0, red, green, blue, 0];
            }
            let (normal, colour, leave) = cuts::ground(pixel, t[lane], colour, self.is_root);
            let [x, y, z] = normal;
            let [red, green, blue] = colour;
            [x, y, z, x, y, z, red, green, blue, leave]
        });
        (of_rays.collect(), vec![[0; 4]; self.packets.pixels.len()])
    }
}
