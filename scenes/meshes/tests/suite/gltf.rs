//! glTF files as other programs write them, each beside a plain one that means the same.

use std::fs;

use glam::DVec3;
use image::{ImageFormat, Rgba, RgbaImage};
use scenes::{LightKind, Shader};
use serde_json::{Value, json};

use super::files::container;
use super::pairs::{NamedFile, file, load, refusal, same};

/// A triangle, as floats.
fn triangle() -> Vec<u8> {
    floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0])
}

fn floats(numbers: &[f32]) -> Vec<u8> {
    numbers.iter().flat_map(|it| it.to_le_bytes()).collect()
}

/// The JSON of one triangle, with some members replaced.
fn root(changes: Value) -> Value {
    let mut root = json!({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "materials": [{}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36}]});
    for (name, value) in changes.as_object().expect("an object") {
        root[name] = value.clone();
    }
    root
}

fn glb(changes: Value, data: &[u8]) -> Vec<NamedFile> {
    let text = root(changes).to_string();
    vec![file("x.glb", container(text.as_bytes(), data))]
}

fn plain() -> Vec<NamedFile> {
    glb(json!({}), &triangle())
}

/// A file with an accessor of more properties of the vertices after the triangle.
fn with_attribute(name: &str, accessor: Value, data: &[u8], material: Value) -> Vec<NamedFile> {
    let mut second = accessor;
    second["bufferView"] = json!(1);
    second["count"] = json!(3);
    glb(
        json!({
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, name: 1}, "material": 0}]}],
            "accessors": [root(json!({}))["accessors"][0], second],
            "bufferViews": [{"buffer": 0, "byteLength": 36},
                {"buffer": 0, "byteOffset": 36, "byteLength": data.len()}],
            "materials": [material]}),
        &[&triangle(), data].concat(),
    )
}

#[test]
fn gltf_text_finds_its_buffers() {
    let text = |uri: &str| root(json!({"buffers": [{"byteLength": 36, "uri": uri}]})).to_string();
    let data =
        "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    let encoded: String = triangle().iter().map(|byte| format!("%{byte:02X}")).collect();
    let cases: [(&str, Vec<NamedFile>); 6] = [
        ("base64", vec![file("x.gltf", text(data))]),
        ("percent signs", vec![file("x.gltf", text(&format!("data:,{encoded}")))]),
        ("a byte-order mark", vec![file("x.gltf", format!("\u{feff}{}", text(data)))]),
        ("an encoded name", vec![file("x.gltf", text("x%20y.bin")), file("x y.bin", triangle())]),
        ("a plain name", vec![file("x.gltf", text("x y.bin")), file("x y.bin", triangle())]),
        ("letters", vec![file("x.gltf", text("m%C3%BCll.bin")), file("müll.bin", triangle())]),
    ];
    for (name, files) in cases {
        assert!(same(name, &files, &plain()).is_empty(), "{name}");
    }
    for (uri, expected) in [
        (
            "gone.bin",
            "x.gltf: not a valid glTF file: mesh 0, primitive 0: accessor 0 has buffer 0, but",
        ),
        ("data:;base64,A*", "accessor 0 has buffer 0, but its data URI is not valid base64"),
        ("https://a.example/x.bin", "only files beside this one are read"),
    ] {
        let found = refusal(&[file("x.gltf", text(uri))]);
        assert!(found.contains(expected), "{found}");
    }
    let found = refusal(&[file("x.gltf", "{\n\"asset\": 5\n}")]);
    assert!(found.starts_with("x.gltf:2: not a valid glTF file"), "{found}");
}

#[test]
fn gltf_unknown_members_are_skipped() {
    for extras in [json!(5), json!("text"), json!([1, {}]), json!({"a": {}}), Value::Null] {
        let changes = json!({
            "extras": extras, "materials": [{"extras": extras, "name": ""}],
            "scenes": [{"nodes": [0], "extras": extras}], "extensions": {"EXT_unknown": extras},
            "extensionsUsed": ["EXT_unknown"]});
        assert!(same("extras", &glb(changes, &triangle()), &plain()).is_empty());
    }
}

#[test]
fn gltf_scenes_without_nodes_are_skipped() {
    let cases = [
        json!({"scenes": [{"nodes": [0]}, {"name": "Scene.001"}]}),
        json!({"scenes": [{"name": "empty"}, {"nodes": [0]}]}),
        json!({"scene": 1, "scenes": [{"nodes": []}, {"nodes": [0]}]}),
        json!({"scene": Value::Null}),
        json!({"scenes": [], "scene": Value::Null}),
    ];
    for changes in cases {
        same("scenes", &glb(changes.clone(), &triangle()), &plain());
    }
    let found = refusal(&glb(json!({"scene": 3}), &triangle()));
    assert!(found.ends_with("scene 3 doesn't exist"), "{found}");
}

/// The triangle with a camera in a node of these members, and without lights.
fn with_camera(mut node: Value) -> Vec<NamedFile> {
    node["camera"] = json!(0);
    let changes = json!({
        "scenes": [{"nodes": [0, 1]}], "nodes": [{"mesh": 0}, node],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}]});
    glb(changes, &triangle())
}

#[test]
fn camera_target_is_at_scene_depth() {
    for (name, node, at) in [
        ("far away", json!({"translation": [0, 0, 30]}), DVec3::new(0.0, 0.0, 0.0)),
        // Half the radius of the triangle's box ahead.
        (
            "with its back to the triangle",
            json!({"translation": [0, 0, -30]}),
            DVec3::new(0.0, 0.0, -30.0 - 2.0_f64.sqrt() / 4.0),
        ),
        (
            "in a node of another scale",
            json!({"translation": [0, 0, 30], "scale": [0.1, 0.1, 0.1]}),
            DVec3::new(0.0, 0.0, 0.0),
        ),
    ] {
        let view = load(&with_camera(node)).unwrap().scene.view;
        assert!(view.at.distance(at) < 1e-12, "{name}: {}", view.at);
    }
    // A camera that looks down is upright, so that its horizon stays level when one turns. One that
    // is rolled keeps its own direction up. Both are rotations about one axis, by 0.2.
    let (sine, cosine) = (libm::sin(0.1), libm::cos(0.1));
    for (rotation, up) in [
        ([-sine, 0.0, 0.0, cosine], DVec3::Y),
        ([0.0, 0.0, sine, cosine], DVec3::new(-libm::sin(0.2), libm::cos(0.2), 0.0)),
        ([0.0, 0.0, 1.0, 0.0], DVec3::NEG_Y),
    ] {
        let node = json!({"translation": [0, 0, 30], "rotation": rotation});
        let view = load(&with_camera(node)).unwrap().scene.view;
        assert!(view.up.distance(up) < 1e-12, "{rotation:?}: {}", view.up);
    }
    // So far from the origin that half a radius is lost in rounding, but not a unit.
    let lost = json!({"translation": [0, 0, -8e15]});
    let view = load(&with_camera(lost)).unwrap().scene.view;
    assert_eq!(view.from - view.at, DVec3::Z);
}

#[test]
fn file_without_lights_has_sun_from_upper_left() {
    let seen = |files: &[NamedFile]| {
        let loaded = load(files).unwrap();
        assert!(loaded.added_light);
        let (view, light) = (&loaded.scene.view, &loaded.scene.lights[0]);
        let LightKind::Directional { to_light } = light.kind else {
            panic!("{light:?}");
        };
        let camera = view.camera(64, 64).unwrap();
        let back = (view.from - view.at).normalize();
        let eye = [camera.right.normalize(), -camera.down.normalize(), back];
        eye.map(|axis| to_light.dot(axis))
    };
    let usual = seen(&plain());
    assert!(usual[0] < 0.0 && usual[1] > 0.0 && usual[2] > 0.0);
    // From the back, where a light at a fixed place would be on the other side.
    let turned = json!({"translation": [0, 0, -5], "rotation": [0, 1, 0, 0]});
    for (a, b) in seen(&with_camera(turned)).into_iter().zip(usual) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
}

#[test]
fn gltf_accessors_without_a_view_and_sparse_ones_are_read() {
    let target = json!({
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0, "targets": [{"POSITION": 1}]}]}],
        "accessors": [root(json!({}))["accessors"][0],
            {"componentType": 5126, "count": 3, "type": "VEC3"}]});
    assert!(same("a morph target", &glb(target, &triangle()), &plain()).is_empty());

    // Of three zeros the second and third are replaced.
    let sparse = |view: Value| {
        json!({"accessors": [{"bufferView": view, "componentType": 5126, "count": 3, "type": "VEC3",
            "sparse": {"count": 2, "indices": {"bufferView": 0, "componentType": 5121},
                "values": {"bufferView": 1}}}],
            "bufferViews": [{"buffer": 0, "byteLength": 2},
                {"buffer": 0, "byteOffset": 4, "byteLength": 24},
                {"buffer": 0, "byteOffset": 28, "byteLength": 36}]})
    };
    let values = floats(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    let data = [&[1, 2, 0, 0][..], &values, &[0; 36]].concat();
    for view in [Value::Null, json!(2)] {
        same("sparse", &glb(sparse(view), &data), &plain());
    }
    let beyond = [&[1, 9, 0, 0][..], &values, &[0; 36]].concat();
    let found = refusal(&glb(sparse(Value::Null), &beyond));
    assert!(found.ends_with("accessor 0 has a sparse item 9 of 3"), "{found}");
    let many =
        json!({"accessors": [{"componentType": 5126, "count": 1_u64 << 40, "type": "VEC3"}]});
    let found = refusal(&glb(many, &triangle()));
    assert!(found.contains("accessor 0 has 1099511627776 items; the most is"), "{found}");
}

#[test]
fn gltf_quantised_positions_are_read() {
    let changes = |component: u32, normalized: bool, size: usize, scale: f64| {
        json!({
            "accessors": [{"bufferView": 0, "componentType": component, "count": 3, "type": "VEC3",
                "normalized": normalized}],
            "bufferViews": [{"buffer": 0, "byteLength": 3 * size, "byteStride": size}],
            "nodes": [{"mesh": 0, "scale": [scale, scale, scale]}],
            "extensionsUsed": ["KHR_mesh_quantization"],
            "extensionsRequired": ["KHR_mesh_quantization"]})
    };
    let shorts: Vec<u8> =
        [0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0].into_iter().flat_map(i16::to_le_bytes).collect();
    same("halves", &glb(changes(5122, false, 8, 1.0), &shorts), &plain());
    let bytes = [0, 0, 0, 0, 127, 0, 0, 0, 0, 127, 0, 0];
    same("normalised bytes", &glb(changes(5120, true, 4, 1.0), &bytes), &plain());
    same("bytes", &glb(changes(5120, false, 4, 1.0 / 127.0), &bytes), &plain());
}

#[test]
fn gltf_colours_of_vertices_are_linear_and_multiply_the_base_colour() {
    let red = glb(
        json!({"materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.25, 0, 0, 1]}}]}),
        &triangle(),
    );
    let half = json!({"pbrMetallicRoughness": {"baseColorFactor": [0.25, 1, 1, 1]}});
    let floats_4 = floats(&[1.0, 0.0, 0.0, 0.5].repeat(3));
    let floats_3 = floats(&[1.0, 0.0, 0.0].repeat(3));
    let bytes = [255, 0, 0, 128].repeat(3);
    let shorts = [255, 255, 0, 0, 0, 0, 255, 255].repeat(3);
    for (component, kind, data) in [
        (5126, "VEC4", floats_4),
        (5126, "VEC3", floats_3),
        (5121, "VEC4", bytes),
        (5123, "VEC4", shorts),
    ] {
        let accessor =
            json!({"componentType": component, "type": kind, "normalized": component != 5126});
        same(kind, &with_attribute("COLOR_0", accessor, &data, half.clone()), &red);
    }
    let mixed = floats(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.214_041_14]);
    let accessor = json!({"componentType": 5126, "type": "VEC3"});
    let mesh =
        load(&with_attribute("COLOR_0", accessor, &mixed, json!({}))).unwrap().scene.mesh.unwrap();
    let found = mesh.corner_colours(0).unwrap();
    assert!((found[2].z - 0.5).abs() < 1e-6, "{found:?}");
}

#[test]
fn gltf_unlit_materials_are_flat_and_lamps_emit() {
    let unlit = json!({"materials": [{"extensions": {"KHR_materials_unlit": {}}}],
        "extensionsUsed": ["KHR_materials_unlit"], "extensionsRequired": ["KHR_materials_unlit"]});
    let scene = load(&glb(unlit, &triangle())).unwrap().scene;
    assert_eq!(scene.materials[0].shader, Shader::Flat);
    let lamp = json!({"materials": [{"emissiveFactor": [0.1, 0, 0],
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 10.0}}}]});
    let scene = load(&glb(lamp, &triangle())).unwrap().scene;
    assert!((scene.materials[0].emission - glam::DVec3::X).length() < 1e-9);
    let textured =
        json!({"materials": [{"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0}}]});
    let loaded = load(&glb(textured, &triangle())).unwrap();
    assert_eq!(loaded.scene.materials[0].emission, glam::DVec3::ZERO);
    assert_eq!(loaded.notes, ["light that emissive textures send is ignored"]);
}

/// A picture of two texels, opaque and clear.
fn half_a_leaf() -> Vec<u8> {
    let picture = RgbaImage::from_fn(2, 1, |x, _| Rgba([0, 200, 0, if x == 0 { 255 } else { 0 }]));
    let mut bytes = std::io::Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::Png).unwrap();
    bytes.into_inner()
}

/// A triangle with texture coordinates from 0 to 1, and a texture of half a leaf beside the file.
fn leaf(material: Value) -> Vec<NamedFile> {
    let accessor = json!({"componentType": 5126, "type": "VEC2"});
    let places = floats(&[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let mut files = with_attribute("TEXCOORD_0", accessor, &places, material);
    let text = String::from_utf8_lossy(&files[0].1).into_owned();
    let start = text.find('{').unwrap();
    let json = text[start..].rsplit_once('}').map(|_| ());
    assert!(json.is_some());
    let mut value: Value = serde_json::Deserializer::from_slice(&files[0].1[20..])
        .into_iter()
        .next()
        .unwrap()
        .unwrap();
    value["textures"] = json!([{"source": 0, "sampler": 0}]);
    value["samplers"] = json!([{"wrapS": 33071, "wrapT": 33071}]);
    value["images"] = json!([{"uri": "leaf.png"}]);
    let data = [triangle(), places].concat();
    files[0].1 = container(value.to_string().as_bytes(), &data);
    files.push(file("leaf.png", half_a_leaf()));
    files
}

#[test]
fn gltf_masks_leave_the_surface_where_alpha_is_high() {
    let area = |material: Value| {
        let loaded = load(&leaf(material));
        loaded.map(|loaded| {
            let mesh = loaded.scene.mesh.unwrap();
            let parts = (0..mesh.triangles.len()).map(|triangle| {
                let [a, b, c] = mesh.places(triangle);
                (b - a).cross(c - a).length() / 2.0
            });
            parts.sum::<f64>()
        })
    };
    let textured = |mode: &str, alpha: f64| {
        json!({"alphaMode": mode, "alphaCutoff": 0.5, "pbrMetallicRoughness":
            {"baseColorFactor": [1, 1, 1, alpha], "baseColorTexture": {"index": 0}}})
    };
    // Left of the middle lie three quarters of the triangle's area.
    assert!((area(textured("MASK", 1.0)).unwrap() - 0.375).abs() < 1e-3);
    assert!((area(textured("BLEND", 1.0)).unwrap() - 0.375).abs() < 1e-3);
    assert!((area(textured("OPAQUE", 1.0)).unwrap() - 0.5).abs() < 1e-9);
    assert!(area(textured("MASK", 0.25)).unwrap_err().to_string().ends_with("no triangles"));
    let factor = |alpha: f64| json!({"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, alpha]}});
    assert!(area(factor(0.25)).is_err());
    assert!((area(factor(0.75)).unwrap() - 0.5).abs() < 1e-9);
}

#[test]
fn gltf_textures_are_moved_scaled_and_turned() {
    let moved = |transform: Value| {
        let loaded = load(&leaf(json!({"pbrMetallicRoughness": {"baseColorTexture":
            {"index": 0, "extensions": {"KHR_texture_transform": transform}}}})));
        loaded.unwrap().scene.mesh.unwrap().corner_coordinates(0).unwrap()
    };
    assert_eq!(
        moved(json!({"offset": [0.5, 0], "scale": [2, 3]})),
        [[0.5, 0.0], [2.5, 0.0], [0.5, 3.0]]
    );
    // Counter-clockwise, where v grows downwards.
    let quarter = std::f64::consts::FRAC_PI_2;
    let turned = moved(json!({"rotation": quarter}));
    let expected = [[0.0, 0.0], [0.0, -1.0], [1.0, 0.0]];
    let off = turned.as_flattened().iter().zip(expected.as_flattened());
    assert!(off.map(|(a, b): (&f32, &f32)| (a - b).abs()).all(|it| it < 1e-6), "{turned:?}");
}

#[test]
fn gltf_unsupported_textures_are_notes() {
    let textured = json!({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}});
    let mut files = leaf(textured.clone());
    files.pop();
    let loaded = load(&files).unwrap();
    assert!(loaded.notes[0].starts_with("image 0: "), "{:?}", loaded.notes);
    assert!(loaded.scene.materials.iter().all(|it| it.texture.is_none()));
    let glb = glb(
        json!({"materials": [textured], "textures": [{"source": 0}], "images": [{"uri": "leaf.png"}]}),
        &triangle(),
    );
    let loaded = load(&[glb[0].clone(), file("leaf.png", half_a_leaf())]).unwrap();
    assert!(loaded.notes[0].contains("without texture coordinates"), "{:?}", loaded.notes);
    let webp = json!({"materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"extensions": {"EXT_texture_webp": {"source": 0}}}], "extensionsUsed": ["EXT_texture_webp"]});
    let loaded = load(&self::glb(webp, &triangle())).unwrap();
    assert!(loaded.notes[0].contains("WebP picture (EXT_texture_webp)"), "{:?}", loaded.notes);
}

#[test]
fn gltf_unsupported_extensions_are_named() {
    for (extension, expected) in [
        ("KHR_draco_mesh_compression", "Draco; export the file without compression"),
        ("EXT_meshopt_compression", "meshopt; export the file without compression"),
        ("KHR_texture_basisu", "KTX2 pictures; convert them to PNG or JPEG"),
        ("EXT_texture_webp", "WebP pictures; convert them to PNG or JPEG"),
        ("KHR_materials_pbrSpecularGlossiness", "specular and glossiness; export the file"),
        ("EXT_something", "it requires the extension `EXT_something`, which is not read"),
    ] {
        let found = refusal(&glb(json!({"extensionsRequired": [extension]}), &triangle()));
        assert!(found.contains(extension) && found.contains(expected), "{found}");
    }
    let glossy =
        json!({"materials": [{"extensions": {"KHR_materials_pbrSpecularGlossiness": {}}}]});
    let found = refusal(&glb(glossy, &triangle()));
    assert!(found.contains("KHR_materials_pbrSpecularGlossiness"), "{found}");
    let draco = json!({
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0},
            "extensions": {"KHR_draco_mesh_compression": {"bufferView": 0}}}]}],
        "accessors": [{"componentType": 5126, "count": 3, "type": "VEC3"}]});
    let found = refusal(&glb(draco, &triangle()));
    assert!(found.contains("KHR_draco_mesh_compression"), "{found}");
    let first = root(json!({"asset": {"version": "1.0"}})).to_string();
    let found = refusal(&[file("x.gltf", first)]);
    assert!(found.contains("version `1.0`; only glTF 2.0 is read"), "{found}");
}

#[test]
fn chess_scene_is_same_as_text_with_files() {
    let folder = tempfile::tempdir().unwrap();
    let whole = concat!(env!("CARGO_MANIFEST_DIR"), "/../chess.glb");
    let bytes = fs::read(whole).unwrap();
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    let mut value: Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
    value["buffers"][0]["uri"] = json!("the data.bin");
    fs::write(folder.path().join("the data.bin"), &bytes[28 + length..]).unwrap();
    let text = folder.path().join("x.gltf");
    fs::write(&text, value.to_string()).unwrap();
    let [one, other] = [meshes::load(whole.as_ref()), meshes::load(&text)].map(Result::unwrap);
    assert_eq!(one.scene, other.scene);
}
