//! Textures of base and diffuse colours: what is read, and every fault.

use std::fs;
use std::io::Cursor;
use std::path::Path;

use image::{ImageFormat, Rgb, RgbImage};
use scenes::{Texture, Wrap};

use super::files::{container, load, refusal, triangle, without_file};

/// A file with a picture of 2x1 texels, red and blue. After the triangle's bytes come three
/// texture coordinates as floats, bytes and halves, then the picture.
const JSON: &str = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
"textures":[{"source":0,"sampler":0}],
"samplers":[{"wrapS":33071,"wrapT":33648}],
"images":[{"bufferView":3,"mimeType":"image/png"}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":0}]}],
"accessors":[
{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"},
{"bufferView":2,"componentType":5126,"count":3,"type":"VEC2"}],
"bufferViews":[{"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":6},
{"buffer":0,"byteOffset":80,"byteLength":44},{"buffer":0,"byteOffset":124,"byteLength":LENGTH}],
"buffers":[{"byteLength":1000}]}"#;

fn two_texels() -> RgbImage {
    RgbImage::from_fn(2, 1, |x, _| Rgb(if x == 0 { [255, 0, 0] } else { [0, 0, 255] }))
}

fn encoded(picture: &RgbImage, format: ImageFormat) -> Vec<u8> {
    let mut bytes = Vec::new();
    picture.write_to(&mut Cursor::new(&mut bytes), format).expect("a picture");
    bytes
}

pub fn png() -> Vec<u8> {
    encoded(&two_texels(), ImageFormat::Png)
}

/// A file with this picture and some of the JSON replaced.
pub fn glb(picture: &[u8], from: &str, to: &str) -> Vec<u8> {
    let json = JSON.replace("LENGTH", &picture.len().to_string());
    assert!(json.contains(from), "{from}");
    let mut blob = triangle();
    for number in [0.0_f32, 0.25, 1.0, 0.25, 0.0, 2.0] {
        blob.extend(number.to_le_bytes());
    }
    blob.extend([0, 255, 51, 0, 0, 102, 0, 0]);
    blob.extend([0_u16, 65535, 13107, 0, 0, 26214].map(u16::to_le_bytes).as_flattened());
    blob.extend(picture);
    container(json.replace(from, to).as_bytes(), &blob)
}

fn texture(file: &str, bytes: &[u8]) -> (Texture, Vec<[f32; 2]>) {
    let scene = load(file, bytes).expect("a scene").scene;
    let texture = scene.materials[0].texture.as_deref().expect("a texture");
    let mesh = scene.mesh.as_ref().expect("a mesh");
    (texture.clone(), mesh.texture_coordinates.clone())
}

#[test]
fn png_in_binary_chunk_is_read() {
    let (found, coordinates) = texture("t.glb", &glb(&png(), "33071", "33071"));
    assert_eq!((found.width(), found.height()), (2, 1));
    assert_eq!(found.texels(), [[255, 0, 0], [0, 0, 255]]);
    assert_eq!(found.wrap(), [Wrap::Clamp, Wrap::Mirror]);
    assert_eq!(coordinates, [[0.0, 0.25], [1.0, 0.25], [0.0, 2.0]]);
    let (found, _) = texture("t.glb", &glb(&png(), r#","sampler":0"#, ""));
    assert_eq!(found.wrap(), [Wrap::Repeat; 2]);
}

#[test]
fn jpeg_texture_is_read() {
    let grey = RgbImage::from_pixel(16, 8, Rgb([90; 3]));
    let bytes = glb(&encoded(&grey, ImageFormat::Jpeg), "image/png", "image/jpeg");
    let (found, _) = texture("t.glb", &bytes);
    assert_eq!((found.width(), found.height()), (16, 8));
    assert!(found.texels().iter().flatten().all(|byte| byte.abs_diff(90) < 3));
}

#[test]
fn coordinates_of_bytes_and_halves() {
    let floats = r#"{"bufferView":2,"componentType":5126,"count":3,"type":"VEC2"}"#;
    for (kind, stride, offset) in [(5121, 2, 24), (5123, 4, 32)] {
        let parts = format!(
            r#"{{"bufferView":2,"byteOffset":{offset},"normalized":true,"componentType":{kind},"count":3,"type":"VEC2"}}"#
        );
        let (_, found) = texture("t.glb", &glb(&png(), floats, &parts));
        let expected = [[0.0, 1.0], [0.2, 0.0], [0.0, 0.4]];
        let off = found.as_flattened().iter().zip(expected.as_flattened());
        let largest = off.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(largest < 1e-6, "{stride}: {found:?}");
    }
}

#[test]
fn vertices_are_joined_only_if_their_coordinates_agree() {
    let obj = |second: &str| {
        format!(
            "mtllib m.mtl\nusemtl t\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n\
             vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n{second}\nf 1/1 2/2 3/3\nf 4/5 5/4 6/3\n"
        )
    };
    let count = |second: &str| {
        let (_, coordinates) = textured_obj(&obj(second), "map_Kd t.png", &png()).expect("a mesh");
        coordinates.len()
    };
    assert_eq!(count("vt 1 0"), 4);
    assert_eq!(count("vt 1 0.5"), 5);
}

/// An OBJ file with a library that has the texture's line, and the picture beside it.
fn textured_obj(obj: &str, line: &str, picture: &[u8]) -> Result<(Texture, Vec<[f32; 2]>), String> {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, bytes).expect("a file");
    };
    write("o.obj", obj.as_bytes());
    write("m.mtl", format!("newmtl t\n{line}\n").as_bytes());
    write("t.png", picture);
    write("in/a b.png", picture);
    let loaded = meshes::load(&folder.path().join("o.obj"));
    let scene = loaded.map_err(|error| {
        let folder = format!("{}/", folder.path().display());
        error.to_string().replace(&folder, "")
    })?;
    let mut scene = scene;
    without_file(&mut scene, &folder.path().join("o.obj"));
    let (scene, notes) = (scene.scene, scene.notes);
    let Some(texture) = scene.materials[0].texture.as_deref() else {
        let folder = format!("{}/", folder.path().display());
        return Err(notes.join("\n").replace(&folder, ""));
    };
    let mesh = scene.mesh.as_ref().expect("a mesh");
    Ok((texture.clone(), mesh.texture_coordinates.clone()))
}

/// A triangle of the material `t`.
pub const OBJ: &str = "mtllib m.mtl\nusemtl t\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0.25\nvt 0 1\n\
                   f 1/1 2/2 3/3\n";

#[test]
fn obj_texture_origin_is_at_bottom() {
    for (line, wrap) in [
        ("map_Kd t.png", Wrap::Repeat),
        ("map_Kd -clamp on t.png", Wrap::Clamp),
        ("map_Kd -s 1 1 -o 0.5 -clamp off -mm 0 1 in\\a b.png", Wrap::Repeat),
    ] {
        let (found, coordinates) = textured_obj(OBJ, line, &png()).expect(line);
        assert_eq!(found.texels(), [[255, 0, 0], [0, 0, 255]]);
        assert_eq!(found.wrap(), [wrap; 2], "{line}");
        assert_eq!(coordinates, [[0.0, 1.0], [1.0, 0.75], [0.0, 0.0]]);
    }
}

#[test]
fn mesh_without_textures_has_no_coordinates() {
    let plain = glb(&png(), r#""baseColorTexture":{"index":0}"#, "");
    let mesh = load("t.glb", &plain).expect("a scene").scene.mesh.expect("a mesh");
    assert!(mesh.texture_coordinates.is_empty());
}

/// The notes on a file whose texture can't be shown; it is drawn without it.
fn notes(bytes: &[u8]) -> Vec<String> {
    let loaded = load("t.glb", bytes).expect("a scene");
    let materials = &loaded.scene.materials;
    assert!(materials.iter().all(|material| material.texture.is_none()));
    loaded.notes
}

#[test]
fn glb_unsupported_textures_are_notes() {
    let whole = png();
    let broken = &whole[..whole.len() - 20];
    let view = r#"{"bufferView":3,"mimeType":"image/png"}"#;
    let last = format!(r#""byteOffset":124,"byteLength":{}"#, whole.len());
    let cases: [(&[u8], &str, &str, &str); 13] = [
        (&whole, r#""source":0"#, r#""source":1"#, "image 1: it doesn't exist"),
        (&whole, r#"{"index":0}"#, r#"{"index":1}"#, "texture 1: it doesn't exist"),
        (&whole, r#""sampler":0"#, r#""sampler":1"#, "texture 0: sampler 1 doesn't exist"),
        (&whole, r#""source":0,"#, "", "texture 0: it has no image"),
        (
            &whole,
            r#""bufferView":3"#,
            r#""bufferView":9"#,
            "image 0: it has buffer view 9, which doesn't exist",
        ),
        (&whole, view, "{}", "image 0: it has neither a buffer view nor a URI"),
        (
            &whole,
            &last,
            r#""byteOffset":124,"byteLength":7000"#,
            "image 0: it has buffer view 3 of 7000 bytes from 124 on, which are not all in",
        ),
        (
            &whole,
            &last,
            r#""byteOffset":18446744073709551615,"byteLength":70"#,
            "image 0: it has buffer view 3 of 70 bytes from 18446744073709551615 on",
        ),
        (broken, "{", "{", "image 0: "),
        (
            b"RIFF\x20\0\0\0WEBPVP8 ",
            "{",
            "{",
            "image 0: it is a WebP picture; convert it to PNG or JPEG",
        ),
        (b"no picture", "{", "{", "image 0: it is neither a PNG nor a JPEG"),
        (&whole, r#","TEXCOORD_0":2"#, "", "parts with a texture, but without texture coordinates"),
        (
            &whole,
            r#"5126,"count":3,"type":"VEC2""#,
            r#"5126,"count":2,"type":"VEC2""#,
            "parts with a texture, but without texture coordinates",
        ),
    ];
    for (picture, from, to, expected) in cases {
        let file = glb(picture, from, to);
        if expected.starts_with("parts") {
            let loaded = load("t.glb", &file).expect("a scene");
            let mesh = loaded.scene.mesh.expect("a mesh");
            let number = mesh.materials[0] as usize;
            assert!(loaded.scene.materials[number].texture.is_none());
            assert!(loaded.notes[0].starts_with(expected), "{:?}", loaded.notes);
        } else {
            let found = notes(&file);
            assert!(found[0].starts_with(expected), "{to}: {found:?}");
        }
    }
}

#[test]
fn faults_of_texture_coordinates() {
    let cases = [
        (
            r#"{"bufferView":2,"componentType":5126"#,
            r#"{"bufferView":2,"componentType":5130"#,
            "accessor 2 has components of the type 5130, which is not one for this use",
        ),
        (
            r#"5126,"count":3,"type":"VEC2""#,
            r#"5126,"count":3,"type":"VEC3""#,
            "accessor 2 has items of the type \"VEC3\", not of VEC2",
        ),
        (
            r#"{"bufferView":2,"componentType":5126"#,
            r#"{"bufferView":2,"byteOffset":40,"componentType":5126"#,
            "accessor 2 has 3 items, which are not all in the 44 bytes of buffer view 2",
        ),
    ];
    for (from, to, expected) in cases {
        let found = refusal("t.glb", &glb(&png(), from, to));
        let expected = format!("not a valid glTF file: mesh 0, primitive 0: {expected}");
        assert_eq!(found, expected);
    }
}

#[test]
fn too_large_texture_is_reduced() {
    let wide = encoded(&RgbImage::new(8192, 2), ImageFormat::Png);
    let loaded = load("t.glb", &glb(&wide, "{", "{")).expect("a scene");
    let texture = loaded.scene.materials[0].texture.as_ref().expect("one");
    assert_eq!((texture.width(), texture.height()), (4096, 1));
    assert_eq!(loaded.notes, ["image 0: it has 8192x2 pixels and is drawn with 4096x1"]);
}

#[test]
fn non_finite_texture_coordinates_are_refused() {
    let mut file = glb(&png(), "{", "{");
    let place =
        file.windows(8).position(|it| it == [0.0_f32, 2.0].map(f32::to_le_bytes).as_flattened());
    let place = place.expect("the last coordinates");
    file[place..place + 4].copy_from_slice(&f32::NAN.to_le_bytes());
    let found = refusal("t.glb", &file);
    assert!(found.ends_with("texture coordinate 2 is not finite: NaN"), "{found}");
}

#[test]
fn obj_unsupported_textures_are_notes() {
    let whole = png();
    let without = OBJ.replace("f 1/1 2/2 3/3", "f 1 2 3");
    let cases: [(&str, &str, &[u8], &str); 6] = [
        (OBJ, "map_Kd gone.png", &whole, "the texture gone.png: No such file or directory"),
        (OBJ, "map_Kd", &whole, "m.mtl:2: map_Kd without the name of a picture"),
        (OBJ, "map_Kd -clamp on", &whole, "m.mtl:2: map_Kd without the name of a picture"),
        (OBJ, "map_Kd t.png", b"P6", "the texture t.png: it is neither a PNG nor a JPEG"),
        (OBJ, "map_Kd t.png", &whole[..40], "the texture t.png: "),
        (
            &without,
            "map_Kd t.png",
            &whole,
            "o.obj:9: the material `t` has a texture, but a face has no texture coordinates",
        ),
    ];
    for (obj, line, picture, expected) in cases {
        let found = textured_obj(obj, line, picture).expect_err(line);
        assert!(found.starts_with(expected), "{line}: {found}");
    }
    let some = format!("{OBJ}f 1 2 3\n");
    textured_obj(&some, "map_Kd t.png", &whole).expect("a texture on the first face");
}

#[test]
fn mask_of_obj_material_makes_holes() {
    let obj = OBJ.replace("vt 1 0.25", "vt 1 0");
    let masked = |line: &str| {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("o.obj");
        fs::write(&path, &obj).expect("a file");
        fs::write(folder.path().join("m.mtl"), format!("newmtl t\nmap_d {line}\n"))
            .expect("a file");
        let mut picture = RgbImage::new(2, 1);
        picture.put_pixel(0, 0, Rgb([255; 3]));
        let bytes = encoded(&picture, ImageFormat::Png);
        fs::write(folder.path().join("t.png"), bytes).expect("a file");
        let mesh = meshes::load(&path).expect("a scene").scene.mesh;
        let mesh = mesh.expect("a mesh");
        let areas = (0..mesh.triangles.len()).map(|triangle| {
            let [a, b, c] = mesh.places(triangle);
            (b - a).cross(c - a).length() / 2.0
        });
        areas.sum::<f64>()
    };
    let found = masked("-clamp on t.png");
    assert!((found - 0.375).abs() < 1e-3, "{found}");
    assert_eq!(masked("gone.png"), 0.5);
}

#[test]
fn textures_over_the_limit_in_total() {
    let picture = encoded(&RgbImage::new(4096, 2048), ImageFormat::Png);
    let texture = r#"{"source":0,"sampler":0}"#;
    let pictures = [r#"{"source":0}"#, texture, r#"{"source":0,"sampler":1}"#].join(",");
    let materials = [0, 1, 2].map(|index| {
        format!(r#"{{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":{index}}}}}}}"#)
    });
    let primitive = |material: usize| {
        format!(
            r#"{{"attributes":{{"POSITION":0,"TEXCOORD_0":2}},"indices":1,"material":{material}}}"#
        )
    };
    let json = JSON
        .replace("LENGTH", &picture.len().to_string())
        .replace(texture, &pictures)
        .replace(
            r#"{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}"#,
            &materials.join(","),
        )
        .replace(r#"{"wrapS":33071,"wrapT":33648}"#, r#"{"wrapS":33071},{"wrapT":33071}"#)
        .replace(&primitive(0), &[0, 1, 2].map(primitive).join(","));
    let mut blob = triangle();
    blob.resize(124, 0);
    blob.extend(&picture);
    let loaded = load("t.glb", &container(json.as_bytes(), &blob)).expect("a scene");
    let all = loaded.scene.materials.iter();
    let texels = all.map(|it| it.texture.as_ref().map_or(0, |it| it.texels().len()));
    assert_eq!(texels.sum::<usize>(), 12_582_912);
    let expected =
        "the textures have 25165824 texels, more than 16777216; they are drawn with 12582912";
    assert_eq!(loaded.notes, [expected]);
}

#[test]
fn chess_scene_has_textures_glass_silver_and_lights() {
    let committed = Path::new(env!("CARGO_MANIFEST_DIR")).join("../chess.glb");
    let scene = meshes::load(&committed).expect("a scene").scene;
    let textured = scene.materials.iter().filter(|it| it.texture.is_some());
    assert_eq!(textured.count(), 2);
    assert_eq!(scene.lights.len(), 2);
    assert!(scene.materials.iter().any(|it| it.transmittance > 0.5));
    assert!(scene.materials.iter().any(|it| it.specular > 0.4));
}
