//! Writes `scenes/chess.glb`: an end of a game of chess, in silver, glass and jade on a board of
//! marble.
//!
//!     cargo run --release -p cellray-meshes --example chess scenes/chess.glb
//!
//! The pieces are surfaces of revolution, a mesh for each kind, at as many nodes as there are
//! pieces. The pictures of the board and of the table are computed here, too.

mod container;

use std::f64::consts::TAU;
use std::path::PathBuf;

use image::{ExtendedColorType, ImageEncoder as _, codecs::jpeg::JpegEncoder};

use container::container;

/// Steps around a piece.
const AROUND: usize = 32;
/// The height of pieces above the board: surfaces at one place would be hit by chance.
const GAP: f64 = 0.03;
/// Texels of the board and of the table.
const BOARD: u32 = 576;
const TABLE: u32 = 320;

/// The outlines of the pieces from the middle of the foot to the top: distances from the axis, and
/// heights. A square of the board is 1.
const PAWN: &[[f64; 2]] = &[
    [0.0, 0.0],
    [0.30, 0.0],
    [0.33, 0.03],
    [0.33, 0.08],
    [0.27, 0.13],
    [0.20, 0.18],
    [0.14, 0.27],
    [0.11, 0.40],
    [0.10, 0.50],
    [0.17, 0.53],
    [0.18, 0.56],
    [0.11, 0.59],
    [0.15, 0.64],
    [0.18, 0.72],
    [0.17, 0.80],
    [0.12, 0.87],
    [0.06, 0.90],
    [0.0, 0.91],
];
const ROOK: &[[f64; 2]] = &[
    [0.0, 0.0],
    [0.35, 0.0],
    [0.38, 0.03],
    [0.38, 0.10],
    [0.32, 0.16],
    [0.25, 0.22],
    [0.21, 0.34],
    [0.19, 0.55],
    [0.19, 0.70],
    [0.27, 0.75],
    [0.28, 0.79],
    [0.28, 1.00],
    [0.20, 1.00],
    [0.20, 0.90],
    [0.0, 0.90],
];
const BISHOP: &[[f64; 2]] = &[
    [0.0, 0.0],
    [0.33, 0.0],
    [0.36, 0.03],
    [0.36, 0.09],
    [0.30, 0.15],
    [0.21, 0.21],
    [0.15, 0.33],
    [0.11, 0.55],
    [0.10, 0.75],
    [0.19, 0.79],
    [0.20, 0.82],
    [0.12, 0.86],
    [0.15, 0.93],
    [0.18, 1.02],
    [0.16, 1.12],
    [0.10, 1.22],
    [0.05, 1.28],
    [0.07, 1.32],
    [0.05, 1.36],
    [0.0, 1.38],
];
const QUEEN: &[[f64; 2]] = &[
    [0.0, 0.0],
    [0.37, 0.0],
    [0.40, 0.04],
    [0.40, 0.10],
    [0.33, 0.17],
    [0.24, 0.24],
    [0.17, 0.38],
    [0.13, 0.65],
    [0.12, 0.95],
    [0.22, 1.00],
    [0.23, 1.03],
    [0.14, 1.07],
    [0.15, 1.15],
    [0.20, 1.30],
    [0.25, 1.42],
    [0.19, 1.42],
    [0.13, 1.46],
    [0.07, 1.49],
    [0.08, 1.54],
    [0.05, 1.59],
    [0.0, 1.60],
];
const KING: &[[f64; 2]] = &[
    [0.0, 0.0],
    [0.37, 0.0],
    [0.40, 0.04],
    [0.40, 0.10],
    [0.33, 0.17],
    [0.24, 0.24],
    [0.18, 0.38],
    [0.14, 0.65],
    [0.13, 1.00],
    [0.23, 1.05],
    [0.24, 1.08],
    [0.15, 1.12],
    [0.16, 1.22],
    [0.21, 1.42],
    [0.22, 1.50],
    [0.13, 1.58],
    [0.05, 1.61],
    [0.05, 1.67],
    [0.08, 1.73],
    [0.05, 1.79],
    [0.0, 1.81],
];

#[derive(Default)]
struct Arrays {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    coordinates: Vec<[f32; 2]>,
    indices: Vec<u16>,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args_os().nth(1).map(PathBuf::from);
    let path = path.ok_or("the name of the file to write is missing")?;
    std::fs::write(path, file()?)?;
    Ok(())
}

fn file() -> Result<Vec<u8>, image::ImageError> {
    let mut chunk = Chunk::default();
    let mut meshes = Vec::new();
    // Each kind is there of silver, and of glass or jade.
    let (silver, glass, jade) = (2, 3, 5);
    for (outline, other) in
        [(PAWN, jade), (ROOK, jade), (BISHOP, jade), (QUEEN, glass), (KING, glass)]
    {
        let arrays = chunk.arrays(&turned(outline));
        meshes.extend([silver, other].map(|material| mesh(&arrays, material)));
    }
    let board = chunk.arrays(&square(4.5, 0.0, 1.0));
    meshes.push(mesh(&board, 0));
    let table = chunk.arrays(&square(40.0, -0.25, 10.0));
    meshes.push(mesh(&table, 1));
    let side = chunk.arrays(&rim(4.5, 0.25));
    meshes.push(mesh(&side, 4));

    let (white, black) = (0, 1);
    let (pawn, rook, bishop, queen, king) = (0, 2, 4, 6, 8);
    let mut nodes: Vec<String> = [
        (king + white, 6, 0),
        (rook + white, 5, 0),
        (pawn + white, 5, 1),
        (pawn + white, 6, 1),
        (pawn + white, 7, 2),
        (queen + white, 3, 3),
        (bishop + white, 2, 4),
        (pawn + white, 1, 3),
        (king + black, 6, 7),
        (rook + black, 3, 7),
        (pawn + black, 5, 6),
        (pawn + black, 6, 5),
        (pawn + black, 7, 6),
        (bishop + black, 4, 4),
        (queen + black, 1, 5),
    ]
    .iter()
    .map(|&(mesh, file, rank): &(usize, i32, i32)| {
        let [x, z] = [file, 7 - rank].map(|it| f64::from(it) - 3.5);
        format!(r#"{{"mesh":{mesh},"translation":[{x},{GAP},{z}]}}"#)
    })
    .collect();
    nodes.extend((10..13).map(|mesh| format!(r#"{{"mesh":{mesh}}}"#)));
    let eye = [-3.3, 3.6, 8.2];
    let rotation = towards(eye, [0.0, 0.3, 0.0]);
    nodes.push(format!(r#"{{"camera":0,"translation":{eye:?},"rotation":{rotation:?}}}"#));
    let light =
        |light: usize| format!(r#""extensions":{{"KHR_lights_punctual":{{"light":{light}}}}}"#);
    let rotation = towards([-6.0, 8.0, 3.0], [0.0; 3]);
    nodes.push(format!(r#"{{"rotation":{rotation:?},{}}}"#, light(0)));
    nodes.push(format!(r#"{{"translation":[7,9,1],{}}}"#, light(1)));
    let numbers: Vec<String> = (0..nodes.len()).map(|node| node.to_string()).collect();

    let pictures = [chunk.picture(BOARD, &marble)?, chunk.picture(TABLE, &wood)?];
    let images = pictures.map(|view| format!(r#"{{"bufferView":{view},"mimeType":"image/jpeg"}}"#));
    let json = format!(
        r#"{{"asset":{{"version":"2.0","generator":"cellray's example chess"}},
"extensionsUsed":["KHR_lights_punctual","KHR_materials_ior","KHR_materials_transmission"],
"extensions":{{"KHR_lights_punctual":{{"lights":[
{{"type":"directional","color":[0.62,0.6,0.55]}},{{"type":"point","color":[0.25,0.27,0.33]}}]}}}},
"scene":0,"scenes":[{{"nodes":[{}]}}],
"nodes":[{}],
"cameras":[{{"type":"perspective","perspective":{{"yfov":0.62,"znear":0.1,"aspectRatio":1.7777778}}}}],
"materials":[
{{"name":"marble","pbrMetallicRoughness":{{"baseColorTexture":{{"index":0}},"metallicFactor":0.22,"roughnessFactor":0.1}}}},
{{"name":"wood","pbrMetallicRoughness":{{"baseColorTexture":{{"index":1}},"metallicFactor":0,"roughnessFactor":0.3}}}},
{{"name":"silver","pbrMetallicRoughness":{{"baseColorFactor":[0.55,0.53,0.5,1],"metallicFactor":1,"roughnessFactor":0.08}}}},
{{"name":"glass","pbrMetallicRoughness":{{"baseColorFactor":[0.9,0.95,0.93,1],"metallicFactor":0.05,"roughnessFactor":0.05}},
"extensions":{{"KHR_materials_transmission":{{"transmissionFactor":0.85}},"KHR_materials_ior":{{"ior":1.5}}}}}},
{{"name":"rim","pbrMetallicRoughness":{{"baseColorFactor":[0.05,0.03,0.02,1],"metallicFactor":0,"roughnessFactor":0.2}}}},
{{"name":"jade","pbrMetallicRoughness":{{"baseColorFactor":[0.02,0.12,0.07,1],"metallicFactor":0.2,"roughnessFactor":0.1}}}}],
"textures":[{{"source":0,"sampler":0}},{{"source":1,"sampler":1}}],
"samplers":[{{"wrapS":33071,"wrapT":33071}},{{"wrapS":33648,"wrapT":33648}}],
"images":[{}],
"meshes":[{}],
"accessors":[{}],
"bufferViews":[{}],
"buffers":[{{"byteLength":{}}}]}}"#,
        numbers.join(","),
        nodes.join(",\n"),
        images.join(","),
        meshes.join(",\n"),
        chunk.accessors.join(",\n"),
        chunk.views.join(",\n"),
        chunk.bytes.len(),
    );
    Ok(container(json.as_bytes(), &chunk.bytes))
}

/// The rotation, as a quaternion, that turns -z to the direction between two points, with y up.
fn towards(from: [f64; 3], to: [f64; 3]) -> [f64; 4] {
    let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| to[axis] - from[axis]);
    let half_turn = libm::atan2(-x, -z) / 2.0;
    let half_rise = libm::atan2(y, libm::hypot(x, z)) / 2.0;
    let (turn, rise) = (libm::sincos(half_turn), libm::sincos(half_rise));
    [turn.1 * rise.0, turn.0 * rise.1, -turn.0 * rise.0, turn.1 * rise.1]
}

/// The binary chunk, and what is in it.
#[derive(Default)]
struct Chunk {
    bytes: Vec<u8>,
    views: Vec<String>,
    accessors: Vec<String>,
}

/// The accessors of a mesh: positions, normals, texture coordinates if it has any, indices.
struct Accessors {
    attributes: Vec<(&'static str, usize)>,
    indices: usize,
}

impl Chunk {
    fn view(&mut self, bytes: &[u8]) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let (start, length) = (self.bytes.len(), bytes.len());
        self.bytes.extend_from_slice(bytes);
        self.views.push(format!(r#"{{"buffer":0,"byteOffset":{start},"byteLength":{length}}}"#));
        self.views.len() - 1
    }

    fn accessor(&mut self, bytes: &[u8], count: usize, kind: &str, more: &str) -> usize {
        let view = self.view(bytes);
        self.accessors.push(format!(r#"{{"bufferView":{view},"count":{count},{kind}{more}}}"#));
        self.accessors.len() - 1
    }

    fn floats<const N: usize>(&mut self, vectors: &[[f32; N]], more: &str) -> usize {
        let bytes: Vec<u8> =
            vectors.as_flattened().iter().flat_map(|it| it.to_le_bytes()).collect();
        let kind = format!(r#""componentType":5126,"type":"VEC{N}""#);
        self.accessor(&bytes, vectors.len(), &kind, more)
    }

    fn arrays(&mut self, arrays: &Arrays) -> Accessors {
        let bound = |pick: fn(f32, f32) -> f32| {
            let vectors = arrays.positions.iter().copied();
            let bound = vectors.reduce(|a, b| std::array::from_fn(|axis| pick(a[axis], b[axis])));
            bound.unwrap_or_default()
        };
        let bounds = format!(r#","min":{:?},"max":{:?}"#, bound(f32::min), bound(f32::max));
        let mut attributes = vec![("POSITION", self.floats(&arrays.positions, &bounds))];
        attributes.push(("NORMAL", self.floats(&arrays.normals, "")));
        if !arrays.coordinates.is_empty() {
            attributes.push(("TEXCOORD_0", self.floats(&arrays.coordinates, "")));
        }
        let bytes: Vec<u8> = arrays.indices.iter().flat_map(|it| it.to_le_bytes()).collect();
        let kind = r#""componentType":5123,"type":"SCALAR""#;
        Accessors { indices: self.accessor(&bytes, arrays.indices.len(), kind, ""), attributes }
    }

    /// Adds a square picture whose colours are functions of places in it.
    fn picture(
        &mut self,
        side: u32,
        colour: &dyn Fn(f64, f64) -> [f64; 3],
    ) -> Result<usize, image::ImageError> {
        let mut pixels = Vec::new();
        for (y, x) in (0..side).flat_map(|y| (0..side).map(move |x| (y, x))) {
            let [x, y] = [x, y].map(|it| (f64::from(it) + 0.5) / f64::from(side));
            pixels.extend(colour(x, y).map(|it| (255.0 * it.clamp(0.0, 1.0)).round() as u8));
        }
        let mut bytes = Vec::new();
        let encoder = JpegEncoder::new_with_quality(&mut bytes, 82);
        encoder.write_image(&pixels, side, side, ExtendedColorType::Rgb8)?;
        Ok(self.view(&bytes))
    }
}

fn mesh(accessors: &Accessors, material: usize) -> String {
    let attributes: Vec<String> = accessors
        .attributes
        .iter()
        .map(|(name, accessor)| format!(r#""{name}":{accessor}"#))
        .collect();
    format!(
        r#"{{"primitives":[{{"attributes":{{{}}},"indices":{},"material":{material}}}]}}"#,
        attributes.join(","),
        accessors.indices
    )
}

/// A surface of revolution around y.
fn turned(outline: &[[f64; 2]]) -> Arrays {
    let mut arrays = Arrays::default();
    let line = smoothed(outline);
    for (place, [radius, height]) in line.iter().enumerate() {
        let before = line[place.saturating_sub(1)];
        let after = line[(place + 1).min(line.len() - 1)];
        let (out, up) = (after[1] - before[1], before[0] - after[0]);
        let length = libm::hypot(out, up);
        for step in 0..AROUND {
            let angle = TAU * step as f64 / AROUND as f64;
            let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
            let at = |radius: f64, height: f64| {
                [radius * cosine, height, -radius * sine].map(|it| it as f32)
            };
            arrays.positions.push(at(*radius, *height));
            arrays.normals.push(at(out / length, up / length));
        }
    }
    for ring in 0..line.len() - 1 {
        for step in 0..AROUND {
            let at = |ring: usize, step: usize| (ring * AROUND + step % AROUND) as u16;
            let (a, b) = (at(ring, step), at(ring, step + 1));
            let (c, d) = (at(ring + 1, step), at(ring + 1, step + 1));
            arrays.indices.extend([a, b, d, a, d, c]);
        }
    }
    arrays
}

/// An outline with a point more between any two, on Catmull and Rom's curve. Its first edge and
/// those between points of one height stay straight.
fn smoothed(outline: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut line = Vec::new();
    for place in 0..outline.len() - 1 {
        let at =
            |offset: isize| outline[place.saturating_add_signed(offset).min(outline.len() - 1)];
        let [before, from, to, after] = [at(-1), at(0), at(1), at(2)];
        line.push(from);
        let is_flat = from[1] == to[1];
        let middle = std::array::from_fn(|axis| {
            let straight = (from[axis] + to[axis]) / 2.0;
            let bent = (9.0 * (from[axis] + to[axis]) - before[axis] - after[axis]) / 16.0;
            if is_flat || place < 2 { straight } else { bent }
        });
        line.push(middle);
    }
    line.extend(outline.last());
    line
}

/// A square in the plane of this height, `repeats` times as wide as its picture.
fn square(half: f32, height: f32, repeats: f32) -> Arrays {
    Arrays {
        positions: [[-half, half], [half, half], [half, -half], [-half, -half]]
            .map(|[x, z]| [x, height, z])
            .into(),
        normals: vec![[0.0, 1.0, 0.0]; 4],
        coordinates: vec![[0.0, repeats], [repeats, repeats], [repeats, 0.0], [0.0, 0.0]],
        indices: vec![0, 1, 2, 0, 2, 3],
    }
}

/// The sides of a slab that is this deep.
fn rim(half: f32, depth: f32) -> Arrays {
    let mut arrays = Arrays::default();
    for [x, z] in [[0.0, 1.0], [1.0, 0.0], [0.0, -1.0], [-1.0, 0.0_f32]] {
        let first = arrays.positions.len() as u16;
        for (along, y) in [(-half, -depth), (half, -depth), (half, 0.0), (-half, 0.0)] {
            arrays.positions.push([half * x + along * z, y, half * z - along * x]);
            arrays.normals.push([x, 0.0, z]);
        }
        arrays.indices.extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
    }
    arrays
}

/// The board: squares of light and dark marble, a line of brass, and a margin.
fn marble(x: f64, y: f64) -> [f64; 3] {
    let [file, rank] = [x, y].map(|it| 9.0 * it - 0.5);
    let edge = [file, rank].map(|it| (it - 4.0).abs()).into_iter().fold(0.0, f64::max);
    if (4.04..4.10).contains(&edge) {
        return [0.72, 0.57, 0.25];
    }
    let is_light = (libm::floor(file) + libm::floor(rank)).rem_euclid(2.0) != 0.0;
    let inside = edge < 4.04;
    let [u, v] = [7.0 * x, 7.0 * y];
    let turbulence = cloud(u, v, 6);
    let vein = 1.0 - (libm::sin(3.0 * (u + 0.6 * v) + 7.0 * turbulence)).abs();
    let vein = vein * vein * vein;
    let grain = 0.5 + 0.5 * cloud(4.0 * u + 30.0, 4.0 * v, 3);
    if inside && is_light {
        let shade = 0.93 - 0.09 * grain;
        mixed([shade, 0.97 * shade, 0.92 * shade], [0.62, 0.58, 0.55], 0.55 * vein)
    } else {
        let shade = if inside { 0.16 } else { 0.11 } + 0.07 * grain;
        mixed([0.75 * shade, shade, 0.85 * shade], [0.62, 0.70, 0.64], 0.5 * vein * vein)
    }
}

/// The table: rings of a tree, in boards.
fn wood(x: f64, y: f64) -> [f64; 3] {
    let board = libm::floor(4.0 * x);
    let [u, v] = [x + 3.7 * board, 0.18 * y + 1.3 * board];
    let bend = cloud(5.0 * u, 9.0 * v, 4);
    let ring = libm::sin(70.0 * (libm::hypot(u - 0.4 - 3.9 * board, v) + 0.06 * bend));
    let fibre = cloud(160.0 * u, 14.0 * v, 3);
    let share = 0.5 + 0.32 * ring + 0.3 * fibre;
    let colour = mixed([0.42, 0.24, 0.12], [0.64, 0.42, 0.23], share);
    let gap = (4.0 * x - board).min(1.0 - (4.0 * x - board));
    colour.map(|it| if gap < 0.012 { 0.4 * it } else { it })
}

fn mixed(from: [f64; 3], to: [f64; 3], share: f64) -> [f64; 3] {
    std::array::from_fn(|channel| from[channel] + share * (to[channel] - from[channel]))
}

/// Noise between -1 and 1, of as many octaves.
fn cloud(x: f64, y: f64, octaves: u32) -> f64 {
    (0..octaves)
        .map(|octave| {
            let scale = f64::from(1 << octave);
            noise(x * scale, y * scale + 17.0 * f64::from(octave)) / (2.0 * scale)
        })
        .sum()
}

fn noise(x: f64, y: f64) -> f64 {
    let corner = [x, y].map(libm::floor);
    let [u, v] = [x - corner[0], y - corner[1]].map(|it| it * it * (3.0 - 2.0 * it));
    let value = |right: f64, down: f64| {
        let [x, y] = [corner[0] + right, corner[1] + down].map(|it| it as i64 as u64);
        let mut mixed =
            x.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ y.wrapping_mul(0xc2b2_ae3d_27d4_eb4f);
        mixed = (mixed ^ (mixed >> 31)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        (mixed >> 40) as f64 / f64::from(1 << 23) - 1.0
    };
    let above = value(0.0, 0.0) + u * (value(1.0, 0.0) - value(0.0, 0.0));
    let below = value(0.0, 1.0) + u * (value(1.0, 1.0) - value(0.0, 1.0));
    above + v * (below - above)
}
