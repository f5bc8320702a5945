//! Writes `scenes/reef.glb`: an anemone whose arms a skin bends, a jellyfish that morph targets
//! press together, and fish on nodes that turn.
//!
//!     cargo run --release -p cellray-meshes --example reef scenes/reef.glb
//!
//! The animation lasts four seconds, and ends as it begins.

mod container;

use std::f64::consts::TAU;
use std::path::PathBuf;

use serde_json::{Value, json};

use container::container;

/// The arms, their length, and the joints of each.
const ARMS: usize = 8;
const LENGTH: f64 = 2.0;
const JOINTS: usize = 6;
const FISH: usize = 5;
/// The seconds of the animation, and its keys for rotations.
const SECONDS: f64 = 4.0;
const KEYS: usize = 9;

/// The lists of a glTF file, and its buffer.
struct Writer {
    root: Value,
    data: Vec<u8>,
}

impl Writer {
    fn push(&mut self, list: &str, item: Value) -> usize {
        let list = self.root[list].as_array_mut().expect("a list");
        list.push(item);
        list.len() - 1
    }

    fn accessor(&mut self, (component, kind): (u32, &str), count: usize, bytes: &[u8]) -> usize {
        self.data.resize(self.data.len().next_multiple_of(4), 0);
        let view = json!({"buffer": 0, "byteOffset": self.data.len(), "byteLength": bytes.len()});
        self.data.extend(bytes);
        let view = self.push("bufferViews", view);
        let is_share = component == 5121 && kind == "VEC4";
        self.push(
            "accessors",
            json!({"bufferView": view, "componentType": component, "type": kind, "count": count,
                "normalized": is_share}),
        )
    }

    fn floats<const N: usize>(&mut self, items: &[[f64; N]]) -> usize {
        let kind = ["", "SCALAR", "", "VEC3", "VEC4"].get(N).copied().unwrap_or("MAT4");
        let numbers = items.iter().flatten();
        let bytes: Vec<u8> = numbers.flat_map(|&it| (it as f32).to_le_bytes()).collect();
        self.accessor((5126, kind), items.len(), &bytes)
    }

    fn shorts(&mut self, kind: &str, width: usize, items: &[u16]) -> usize {
        let bytes: Vec<u8> = items.iter().flat_map(|it| it.to_le_bytes()).collect();
        self.accessor((5123, kind), items.len() / width, &bytes)
    }

    /// A mesh of one colour, with a surface's vertices.
    fn mesh(&mut self, surface: &Surface, colour: [f64; 3], roughness: f64) -> usize {
        let [red, green, blue] = colour;
        let material = json!({"pbrMetallicRoughness": {"metallicFactor": 0,
            "roughnessFactor": roughness, "baseColorFactor": [red, green, blue, 1]}});
        let material = self.push("materials", material);
        let positions = self.floats(&surface.positions);
        let normals = self.floats(&surface.normals);
        let indices = self.shorts("SCALAR", 1, &surface.indices);
        let primitive = json!({"attributes": {"POSITION": positions, "NORMAL": normals},
            "indices": indices, "material": material});
        self.push("meshes", json!({"primitives": [primitive]}))
    }

    /// Adds a channel with keys at equal distances, the last of them the first again.
    fn channel<const N: usize>(
        &mut self,
        (node, path): (usize, &str),
        interpolation: &str,
        (keys, per_key): (usize, usize),
        value: impl Fn(f64) -> Vec<[f64; N]>,
    ) {
        let share = |key: usize| key as f64 / (keys - 1) as f64;
        let times: Vec<[f64; 1]> = (0..keys).map(|key| [SECONDS * share(key)]).collect();
        let values: Vec<[f64; N]> = (0..keys).flat_map(|key| value(share(key))).collect();
        assert_eq!(values.len(), keys * per_key);
        let (input, output) = (self.floats(&times), self.floats(&values));
        let animation = &mut self.root["animations"][0];
        let samplers = animation["samplers"].as_array_mut().expect("a list");
        samplers.push(json!({"input": input, "output": output, "interpolation": interpolation}));
        let sampler = samplers.len() - 1;
        let channel = json!({"sampler": sampler, "target": {"node": node, "path": path}});
        animation["channels"].as_array_mut().expect("a list").push(channel);
    }
}

/// A surface around the y axis.
#[derive(Default)]
struct Surface {
    positions: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    indices: Vec<u16>,
}

impl Surface {
    /// Turns an outline, of which `at` gives the radius and the height from 0 at the top to 1.
    fn new(around: usize, rings: usize, at: impl Fn(f64) -> [f64; 2]) -> Self {
        let mut surface = Self::default();
        for ring in 0..=rings {
            let share = ring as f64 / rings as f64;
            let [radius, height] = at(share);
            let [before, after] = [-1e-4, 1e-4].map(|by| at((share + by).clamp(0.0, 1.0)));
            let (out, up) = (before[1] - after[1], after[0] - before[0]);
            let length = libm::hypot(out, up);
            for step in 0..around {
                let angle = TAU * step as f64 / around as f64;
                let turned = |[across, up]: [f64; 2]| {
                    [across * libm::cos(angle), up, -across * libm::sin(angle)]
                };
                surface.positions.push(turned([radius, height]));
                surface.normals.push(turned([out / length, up / length]));
            }
        }
        for ring in 0..rings {
            for step in 0..around {
                let at = |ring: usize, step: usize| (ring * around + step % around) as u16;
                let [a, b] = [at(ring, step), at(ring, step + 1)];
                let [c, d] = [at(ring + 1, step), at(ring + 1, step + 1)];
                surface.indices.extend([a, c, d, a, d, b]);
            }
        }
        surface
    }

    /// A ball of these half axes.
    fn ball(around: usize, rings: usize, [wide, high, deep]: [f64; 3]) -> Self {
        let mut ball = Self::new(around, rings, |share| {
            let angle = share * TAU / 2.0;
            [libm::sin(angle), libm::cos(angle)]
        });
        for (position, normal) in ball.positions.iter_mut().zip(&mut ball.normals) {
            for (axis, half) in [wide, high, deep].into_iter().enumerate() {
                position[axis] *= half;
                normal[axis] /= half;
            }
        }
        ball
    }
}

fn about(axis: usize, angle: f64) -> [f64; 4] {
    let mut rotation = [0.0, 0.0, 0.0, libm::cos(angle / 2.0)];
    rotation[axis] = libm::sin(angle / 2.0);
    rotation
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args_os().nth(1).map(PathBuf::from);
    let path = path.ok_or("the name of the file to write is missing")?;
    let root = json!({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"children": []}], "meshes": [], "materials": [], "skins": [], "accessors": [],
        "cameras": [{"type": "perspective", "perspective":
            {"yfov": 0.6, "znear": 0.1, "aspectRatio": 16.0 / 9.0}}],
        "bufferViews": [], "animations": [{"name": "swell", "channels": [], "samplers": []}]});
    let mut writer = Writer { root, data: Vec::new() };
    let mut top = Vec::new();
    sand(&mut writer, &mut top);
    anemone(&mut writer, &mut top);
    jellyfish(&mut writer, &mut top);
    fish(&mut writer, &mut top);
    let camera = json!({"camera": 0, "translation": [0, 3.2, 8.5], "rotation": about(0, -0.2)});
    top.push(writer.push("nodes", camera));
    writer.root["nodes"][0]["children"] = json!(top);
    writer.root["buffers"] = json!([{"byteLength": writer.data.len()}]);
    std::fs::write(path, container(writer.root.to_string().as_bytes(), &writer.data))?;
    Ok(())
}

fn sand(writer: &mut Writer, top: &mut Vec<usize>) {
    let corners = [[-9.0, 0.0, 9.0], [9.0, 0.0, 9.0], [9.0, 0.0, -9.0], [-9.0, 0.0, -9.0]];
    let square = Surface {
        positions: corners.to_vec(),
        normals: vec![[0.0, 1.0, 0.0]; 4],
        indices: vec![0, 1, 2, 0, 2, 3],
    };
    let mesh = writer.mesh(&square, [0.62, 0.48, 0.3], 1.0);
    top.push(writer.push("nodes", json!({"mesh": mesh})));
}

/// Arms of one mesh, each with a skin of its own.
fn anemone(writer: &mut Writer, top: &mut Vec<usize>) {
    let foot = Surface::ball(32, 16, [0.7, 0.45, 0.7]);
    let foot = writer.mesh(&foot, [0.35, 0.08, 0.2], 0.5);
    top.push(writer.push("nodes", json!({"mesh": foot})));
    // Its outline begins at the tip, which is round.
    let arm = Surface::new(16, 30, |share| {
        let tip = libm::sqrt((1.0 - (1.0 - 8.0 * share).max(0.0).powi(2)).max(0.0));
        [tip * (0.06 + 0.1 * share), LENGTH * (1.0 - share)]
    });
    let mesh = writer.mesh(&arm, [0.75, 0.25, 0.3], 0.45);
    let place = |height: f64| (height / LENGTH * JOINTS as f64).clamp(0.0, (JOINTS - 1) as f64);
    let heights = || arm.positions.iter().map(|[_, height, _]| place(*height));
    let joints: Vec<u16> = heights()
        .flat_map(|place| [place as u16, (place as u16 + 1).min(JOINTS as u16 - 1), 0, 0])
        .collect();
    let weights: Vec<u8> = heights()
        .flat_map(|place| {
            let second = (place.fract() * 255.0) as u8;
            [255 - second, second, 0, 0]
        })
        .collect();
    let joints = writer.shorts("VEC4", 4, &joints);
    let weights = writer.accessor((5121, "VEC4"), arm.positions.len(), &weights);
    let attributes = &mut writer.root["meshes"][mesh]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = joints.into();
    attributes["WEIGHTS_0"] = weights.into();
    let step = LENGTH / JOINTS as f64;
    let inverse: Vec<[f64; 16]> = (0..JOINTS)
        .map(|joint| {
            let mut matrix = [0.0; 16];
            (0..4).for_each(|axis| matrix[5 * axis] = 1.0);
            matrix[13] = -step * joint as f64;
            matrix
        })
        .collect();
    let inverse = writer.floats(&inverse);
    for arm in 0..ARMS {
        let around = arm as f64 / ARMS as f64;
        let mut chain = Vec::new();
        for joint in (0..JOINTS).rev() {
            let above: Vec<usize> = chain.last().copied().into_iter().collect();
            let translation = if joint == 0 { [0.35, 0.2, 0.0] } else { [0.0, step, 0.0] };
            let node = json!({"translation": translation, "children": above});
            chain.push(writer.push("nodes", node));
        }
        chain.reverse();
        for (joint, &node) in chain.iter().enumerate() {
            // Arms lean outwards, and a wave runs along each and around all.
            writer.channel((node, "rotation"), "LINEAR", (KEYS, 1), |share| {
                let lean = if joint == 0 { -0.5 } else { -0.06 };
                let wave = libm::sin(TAU * (share + around - 0.15 * joint as f64));
                vec![about(2, lean + 0.25 * wave)]
            });
        }
        let base = json!({"rotation": about(1, TAU * around), "children": [chain[0]]});
        top.push(writer.push("nodes", base));
        let skin = writer.push("skins", json!({"joints": chain, "inverseBindMatrices": inverse}));
        top.push(writer.push("nodes", json!({"mesh": mesh, "skin": skin})));
    }
}

/// A bell that closes and opens twice, and rises as it closes.
fn jellyfish(writer: &mut Writer, top: &mut Vec<usize>) {
    let bell = |wide: f64, high: f64| {
        Surface::new(24, 24, move |share| {
            // Over the top to the rim, and back inside.
            let angle = TAU / 3.6 * (1.0 - (2.0 * share - 1.0).abs());
            let scale = if share > 0.5 { 0.9 } else { 1.0 };
            [wide * scale * libm::sin(angle), high * scale * libm::cos(angle)]
        })
    };
    let (open, closed) = (bell(0.8, 0.5), bell(0.5, 0.8));
    let mesh = writer.mesh(&open, [0.5, 0.55, 0.85], 0.25);
    let less = |to: &[[f64; 3]], from: &[[f64; 3]]| -> Vec<[f64; 3]> {
        let pairs = to.iter().zip(from);
        pairs.map(|(to, from)| std::array::from_fn(|axis| to[axis] - from[axis])).collect()
    };
    let positions = writer.floats(&less(&closed.positions, &open.positions));
    let normals = writer.floats(&less(&closed.normals, &open.normals));
    writer.root["meshes"][mesh]["primitives"][0]["targets"] =
        json!([{"POSITION": positions, "NORMAL": normals}]);
    let node = writer.push("nodes", json!({"mesh": mesh}));
    top.push(node);
    writer.channel((node, "weights"), "LINEAR", (KEYS, 1), |share| {
        vec![[0.5 - 0.5 * libm::cos(2.0 * TAU * share)]]
    });
    // A spline of a sine, with its slopes.
    writer.channel((node, "translation"), "CUBICSPLINE", (KEYS, 3), |share| {
        let (sine, cosine) = libm::sincos(2.0 * TAU * share);
        let slope = [0.0, 0.3 * cosine * 2.0 * TAU / SECONDS, 0.0];
        vec![slope, [-0.4, 2.8 + 0.3 * sine, 0.0], slope]
    });
}

/// Fish that swim around, and their tails.
fn fish(writer: &mut Writer, top: &mut Vec<usize>) {
    let body = Surface::ball(16, 12, [0.12, 0.2, 0.4]);
    let body = writer.mesh(&body, [0.9, 0.45, 0.05], 0.3);
    let tail = Surface::ball(12, 8, [0.03, 0.2, 0.16]);
    let tail = writer.mesh(&tail, [0.85, 0.3, 0.03], 0.4);
    for number in 0..FISH {
        let fin = json!({"mesh": tail, "translation": [0, 0, -0.14]});
        let fin = writer.push("nodes", fin);
        let joint = json!({"translation": [0, 0, -0.36], "children": [fin]});
        let joint = writer.push("nodes", joint);
        let height = 0.8 + 0.35 * number as f64;
        let place = [2.0 + 0.2 * (number % 2) as f64, height, 0.0];
        let swimmer = json!({"mesh": body, "translation": place, "children": [joint]});
        let swimmer = writer.push("nodes", swimmer);
        let pivot = writer.push("nodes", json!({"children": [swimmer]}));
        top.push(pivot);
        let start = number as f64 / FISH as f64;
        // A fifth of the way each time, so that the fish are where they began.
        writer.channel((pivot, "rotation"), "LINEAR", (KEYS, 1), |share| {
            vec![about(1, -TAU * (start + share))]
        });
        writer.channel((joint, "rotation"), "LINEAR", (4 * KEYS - 3, 1), |share| {
            vec![about(1, 0.5 * libm::sin(4.0 * TAU * (share + start)))]
        });
    }
}
