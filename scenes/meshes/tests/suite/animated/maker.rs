//! Makes animated glTF files.

use std::fs;

use meshes::Animation;
use serde_json::{Value, json};

use crate::container::container;

/// A glTF file in the making.
pub struct Maker {
    pub root: Value,
    pub data: Vec<u8>,
}

impl Maker {
    pub fn new() -> Self {
        let root = json!({"asset": {"version": "2.0"}, "scene": 0, "accessors": [],
            "bufferViews": [], "scenes": [{"nodes": [0]}], "nodes": [], "meshes": []});
        Self { root, data: Vec::new() }
    }

    /// Adds an accessor of singles.
    pub fn floats<const N: usize>(&mut self, items: &[[f64; N]]) -> usize {
        let kind = ["", "SCALAR", "VEC2", "VEC3", "VEC4"].get(N).copied().unwrap_or("MAT4");
        let start = self.data.len();
        self.data.extend(items.iter().flatten().flat_map(|&it| (it as f32).to_le_bytes()));
        self.accessor(start, json!({"componentType": 5126, "type": kind, "count": items.len()}))
    }

    /// Adds an accessor of four bytes an item.
    pub fn bytes(&mut self, items: &[[u8; 4]]) -> usize {
        let start = self.data.len();
        self.data.extend(items.as_flattened());
        self.accessor(start, json!({"componentType": 5121, "type": "VEC4", "count": items.len()}))
    }

    pub fn accessor(&mut self, start: usize, mut accessor: Value) -> usize {
        let length = self.data.len() - start;
        accessor["bufferView"] = self
            .add("bufferViews", json!({"buffer": 0, "byteOffset": start, "byteLength": length}))
            .into();
        self.add("accessors", accessor)
    }

    pub fn add(&mut self, list: &str, item: Value) -> usize {
        if self.root[list].is_null() {
            self.root[list] = json!([]);
        }
        let list = self.root[list].as_array_mut().unwrap();
        list.push(item);
        list.len() - 1
    }

    /// Adds a channel to the first animation.
    pub fn channel<const N: usize>(
        &mut self,
        (node, path): (usize, &str),
        interpolation: &str,
        times: &[f64],
        values: &[[f64; N]],
    ) {
        let times = times.iter().map(|&time| [time]).collect::<Vec<_>>();
        let (input, output) = (self.floats(&times), self.floats(values));
        let animations = &mut self.root["animations"];
        if animations.is_null() {
            *animations = json!([{"name": "walk", "channels": [], "samplers": []}]);
        }
        let animation = &mut animations[0];
        let samplers = animation["samplers"].as_array_mut().unwrap();
        samplers.push(json!({"input": input, "output": output, "interpolation": interpolation}));
        let sampler = samplers.len() - 1;
        let channel = json!({"sampler": sampler, "target": {"node": node, "path": path}});
        animation["channels"].as_array_mut().unwrap().push(channel);
    }

    pub fn file(&self) -> Vec<u8> {
        let mut root = self.root.clone();
        root["buffers"] = json!([{"byteLength": self.data.len()}]);
        container(root.to_string().as_bytes(), &self.data)
    }

    pub fn load(&self, animation: Option<&str>) -> Result<meshes::Loaded, String> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.glb");
        fs::write(&path, self.file()).unwrap();
        let message =
            |error: meshes::Error| error.to_string().rsplit_once("x.glb: ").unwrap().1.to_owned();
        meshes::load_animated(&path, animation).map_err(message)
    }

    pub fn animation(&self) -> Animation {
        let loaded = self.load(None).unwrap();
        let mut animation = loaded.animation.expect("an animation");
        // The scene is the beginning of the animation.
        let mesh = loaded.scene.mesh.unwrap();
        let (positions, normals) = animation.at(0.0);
        assert_eq!((positions, normals), (&mesh.positions[..], &mesh.normals[..]));
        animation
    }
}

pub const CORNERS: [[f64; 3]; 3] = [[1.0, 0.0, 0.5], [2.0, 1.0, 0.0], [1.0, 3.0, 0.25]];
pub const NORMALS: [[f64; 3]; 3] = [[0.0, 0.6, 0.8], [0.0, 0.0, 1.0], [0.8, 0.0, 0.6]];

/// A triangle in a node, which is in another node.
pub fn triangle() -> Maker {
    let mut maker = Maker::new();
    let (positions, normals) = (maker.floats(&CORNERS), maker.floats(&NORMALS));
    let attributes = json!({"POSITION": positions, "NORMAL": normals});
    maker.add("meshes", json!({"primitives": [{"attributes": attributes}]}));
    maker.add("nodes", json!({"children": [1]}));
    maker.add("nodes", json!({"mesh": 0}));
    maker
}

/// The quaternion of a rotation about z, of any sign and length.
pub fn about_z(angle: f64, scale: f64) -> [f64; 4] {
    [0.0, 0.0, libm::sin(angle / 2.0) * scale, libm::cos(angle / 2.0) * scale]
}
