//! Small files for the tests.

use std::fs;
use std::path::Path;

use meshes::{Error, Loaded};

pub use super::container::container;

/// A tetrahedron in each of the formats of text.
pub const OBJ: &str = "\
mtllib m.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
vn 0 0 -1
usemtl red
f 1//1 3//1 2//1
usemtl glass
f 1 2 4
f 1 4 3
f 2 3 4
";
pub const MTL: &str = "newmtl red\nKd 1 0 0\nillum 3\nKs 0.5 0.25 0\nNs 20\n\nnewmtl glass\nKd 0 1 0\nd 0.25\nNi 1.5\n\nnewmtl t\nmap_Kd t.png\n";
pub const PLY: &str = "\
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3
3 0 1 2
";

/// The same square in binary.
pub fn binary_ply(big_endian: bool) -> Vec<u8> {
    let order = if big_endian { "big" } else { "little" };
    let header = PLY.split("0 0 0").next().unwrap();
    let mut bytes = header.replace("ascii", &format!("binary_{order}_endian")).into_bytes();
    let mut put = |mut word: [u8; 4]| {
        if big_endian {
            word.reverse();
        }
        bytes.extend(word);
    };
    for number in [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0] {
        put(number.to_le_bytes());
    }
    for face in [&[0_i32, 1, 2, 3][..], &[0, 1, 2]] {
        bytes.push(face.len() as u8);
        for index in face {
            let word = index.to_le_bytes();
            bytes.extend(if big_endian { index.to_be_bytes() } else { word });
        }
    }
    bytes
}

/// A binary glTF file: a triangle, moved by (10, 0, 0) and mirrored in x, with a camera and a
/// light.
pub fn glb() -> Vec<u8> {
    container(JSON.as_bytes(), &triangle())
}

/// The buffer: three positions, three normals, three 16-bit indices.
pub fn triangle() -> Vec<u8> {
    let mut bytes = Vec::new();
    for number in [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0] {
        bytes.extend(number.to_le_bytes());
    }
    for _ in 0..3 {
        bytes.extend([0.0_f32, 0.0, 1.0].map(f32::to_le_bytes).as_flattened());
    }
    bytes.extend([0_u16, 1, 2, 0].map(u16::to_le_bytes).as_flattened());
    bytes
}

pub const JSON: &str = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1,2]}],
"extensionsUsed":["KHR_lights_punctual"],
"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","color":[1,0.5,0.25],"range":7}]}},
"nodes":[{"mesh":0,"translation":[10,0,0],"scale":[-1,2,1]},
{"camera":0,"translation":[0,0,5]},
{"translation":[0,4,0],"extensions":{"KHR_lights_punctual":{"light":0}}}],
"cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.1,"aspectRatio":2}}],
"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1],"metallicFactor":1,"roughnessFactor":0},
"emissiveFactor":[1,0,0]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2,"material":0}]}],
"accessors":[
{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":8}],
"buffers":[{"byteLength":80}]}"#;

/// Loads bytes as a file of this name, beside a material library.
pub fn load(name: &str, bytes: &[u8]) -> Result<Loaded, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(folder.path().join("m.mtl"), MTL).unwrap();
    fs::write(&path, bytes).unwrap();
    let mut loaded = meshes::load(&path)?;
    without_file(&mut loaded, &path);
    Ok(loaded)
}

/// Removes the file from the notes about the whole of it.
pub fn without_file(loaded: &mut Loaded, path: &Path) {
    let file = format!("{}: ", path.display());
    for note in &mut loaded.notes {
        if let Some(text) = note.strip_prefix(&file) {
            *note = text.to_owned();
        }
    }
}

/// The message of a file that is refused, without its folder.
pub fn refusal(name: &str, bytes: &[u8]) -> String {
    let message = load(name, bytes).expect_err("a refusal").to_string();
    let (folder, rest) = message.split_once(name).expect("the file's name");
    assert!(folder.ends_with('/'), "{message}");
    rest.trim_start_matches(": ").to_owned()
}
