//! Files that are refused, with the messages.

use super::files::{JSON, OBJ, PLY, binary_ply, container, glb, refusal, triangle};

#[test]
fn non_finite_coordinates_are_refused() {
    let mut ply = binary_ply(true);
    let second = ply.len() - 30 - 3 * 12;
    ply[second..second + 4].copy_from_slice(&f32::NAN.to_be_bytes());
    assert_eq!(refusal("t.ply", &ply), "vertex 1 is not finite: NaN");
    let mut blob = triangle();
    blob[12..16].copy_from_slice(&f32::INFINITY.to_le_bytes());
    let found = refusal("t.glb", &container(JSON.as_bytes(), &blob));
    assert!(found.contains("mesh 0, primitive 0") && found.contains("not finite"), "{found}");
    blob = triangle();
    blob[40..44].copy_from_slice(&f32::NAN.to_le_bytes());
    let found = refusal("t.glb", &container(JSON.as_bytes(), &blob));
    assert!(found.contains("normal 0 is not finite"), "{found}");
}

#[test]
fn indices_out_of_range() {
    let found = refusal("t.ply", PLY.replace("3 0 1 2", "3 0 1 4").as_bytes());
    assert_eq!(found, "face 1 has the vertex 4, but there are only 4 vertices");
    let found = refusal("t.ply", PLY.replace("3 0 1 2", "3 0 1 -1").as_bytes());
    assert_eq!(found, "face 1 has the vertex -1, but there are only 4 vertices");
    let mut blob = triangle();
    blob[74] = 7;
    let found = refusal("t.glb", &container(JSON.as_bytes(), &blob));
    assert!(found.contains("the vertex 7, but there are only 3"), "{found}");
}

#[test]
fn files_without_triangles() {
    assert_eq!(refusal("t.obj", b""), "the file has no triangles");
    assert_eq!(refusal("t.obj", b"v 0 0 0\nv 1 0 0\nl 1 2\n"), "the file has no triangles");
    let json = JSON.replace(r#""mesh":0,"#, "");
    assert_eq!(
        refusal("t.glb", &container(json.as_bytes(), &triangle())),
        "the file has no triangles"
    );
}

#[test]
fn truncated_files() {
    let (before, _) = OBJ.split_once("0\nv 0 1 0").unwrap();
    let found = refusal("t.obj", before.as_bytes());
    assert!(found.starts_with(":3: a vertex needs three numbers"), "{found}");
    let found = refusal("t.ply", PLY.trim_end_matches("3 0 1 2\n").as_bytes());
    assert_eq!(found, ":15: the file ends inside its data");
    let binary = binary_ply(false);
    let found = refusal("t.ply", &binary[..binary.len() - 1]);
    assert!(found.starts_with("not a valid PLY file"), "{found}");
    let whole = glb();
    let found = refusal("t.glb", &whole[..whole.len() - 4]);
    assert!(found.contains("its header states"), "{found}");
    assert!(refusal("t.glb", b"glTF").contains("less than a header"));
    assert!(refusal("t.glb", b"GLTF").contains("doesn't begin"));
}

#[test]
fn chunks_of_a_wrong_length() {
    for at in [12, 20 + JSON.len().next_multiple_of(4)] {
        let mut file = glb();
        file[at + 2] = 0x7f;
        let found = refusal("t.glb", &file);
        assert!(found.starts_with("not a valid glTF file"), "{found}");
    }
    let json = JSON.replace(r#""byteLength":72}"#, r#""byteLength":7200}"#);
    let found = refusal("t.glb", &container(json.as_bytes(), &triangle()));
    assert!(
        found
            .contains("accessor 0 has buffer view 0 of 7200 bytes from 0 on, which are not all in"),
        "{found}"
    );
}

#[test]
fn trees_of_nodes_with_a_cycle() {
    let json = JSON.replace(r#"{"camera":0,"#, r#"{"children":[1],"camera":0,"#);
    let found = refusal("t.glb", &container(json.as_bytes(), &triangle()));
    assert!(found.contains("node 1 is in the scene twice"), "{found}");
}

#[test]
fn levels_of_terrains() {
    for level in ["", "12", "-1", "x"] {
        let name = format!("terrain:{level}");
        let found = meshes::load(name.as_ref()).unwrap_err().to_string();
        assert_eq!(found, format!("{name}: the level is not a whole number from 0 to 11"));
    }
}

#[test]
fn missing_files_are_named() {
    let found = meshes::load("/nowhere/x.obj".as_ref()).unwrap_err().to_string();
    assert!(found.starts_with("/nowhere/x.obj: "), "{found}");
}

/// Files of 17 GB take no space on the disk if nothing is in them.
#[test]
fn files_of_17_gigabytes() {
    let folder = tempfile::tempdir().unwrap();
    let huge = |name: &str| {
        let path = folder.path().join(name);
        let file = std::fs::File::create(&path).unwrap();
        file.set_len(17 << 30).unwrap();
        path
    };
    let size = "the file has 18253611008 bytes or more; the most is 2147483648";
    for name in ["t.obj", "t.ply", "t.stl", "t.gltf", "t.glb"] {
        let path = huge(name);
        let found = meshes::load(&path).unwrap_err().to_string();
        assert_eq!(found, format!("{}: {size}", path.display()));
    }
    // Files that an OBJ file names.
    let obj = folder.path().join("t.obj");
    std::fs::write(&obj, OBJ).unwrap();
    let library = huge("m.mtl");
    let found = meshes::load(&obj).unwrap_err().to_string();
    assert_eq!(found, format!("{}: {}: {size}", obj.display(), library.display()));
    let picture = huge("t.png");
    std::fs::write(&obj, super::textures::OBJ).unwrap();
    std::fs::write(&library, "newmtl t\nmap_Kd t.png\n").unwrap();
    let notes = meshes::load(&obj).unwrap().notes;
    let expected = format!(
        "{}: the texture {}: {size}; surfaces are drawn without it",
        obj.display(),
        picture.display()
    );
    assert_eq!(notes, [expected]);
}
