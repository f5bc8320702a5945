//! Files as other programs write them, each beside a plain one that means the same.

use std::fs;

use glam::DVec3;
use meshes::{Error, Loaded};
use scenes::Material;

use super::files::without_file;

/// A file in a folder: its name and its bytes.
pub type NamedFile = (&'static str, Vec<u8>);

pub fn file(name: &'static str, text: impl AsRef<[u8]>) -> NamedFile {
    (name, text.as_ref().to_vec())
}

/// Loads the first of some files.
pub fn load(files: &[NamedFile]) -> Result<Loaded, Error> {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    let path = folder.path().join(files[0].0);
    let mut loaded = meshes::load(&path)?;
    without_file(&mut loaded, &path);
    Ok(loaded)
}

/// The message of files that are refused, without their folder.
pub fn refusal(files: &[NamedFile]) -> String {
    let message = load(files).expect_err("a refusal").to_string();
    let (_, rest) = message.split_once(files[0].0).expect("the file's name");
    format!("{}{rest}", files[0].0)
}

/// The triangles of a mesh with all that is shown of them, in an order of their own.
fn shown(loaded: &Loaded) -> Vec<String> {
    let scene = &loaded.scene;
    let mesh = scene.mesh.as_ref().unwrap();
    let triangle = |triangle: usize| {
        let material =
            Material { line: 0, ..scene.materials[mesh.materials[triangle] as usize].clone() };
        format!(
            "{:?} {:?} {:?} {:?} {material:?}",
            mesh.places(triangle),
            mesh.corner_normals(triangle),
            mesh.corner_coordinates(triangle),
            mesh.corner_colours(triangle),
        )
    };
    let mut found: Vec<String> = (0..mesh.triangles.len()).map(triangle).collect();
    found.sort();
    found
}

/// Checks that two files show the same, and returns the first one's notes.
pub fn same(name: &str, files: &[NamedFile], plain: &[NamedFile]) -> Vec<String> {
    let one = load(files).unwrap_or_else(|error| panic!("{name}: {error}"));
    let other = load(plain).unwrap_or_else(|error| panic!("{name}: the plain file: {error}"));
    assert_eq!(shown(&one), shown(&other), "{name}");
    one.notes
}

const CORNERS: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
const RED: &str = "newmtl red\nKd 0.9 0.1 0.1\n";

fn obj(text: impl AsRef<[u8]>) -> Vec<NamedFile> {
    vec![file("x.obj", text)]
}

/// A square of the material `red`, and its library.
fn red(library: impl AsRef<[u8]>) -> Vec<NamedFile> {
    let text = format!("mtllib a.mtl\n{CORNERS}usemtl red\nf 1 2 3 4\n");
    vec![file("x.obj", text), file("a.mtl", library)]
}

#[test]
fn obj_text_of_any_encoding_and_line_end_is_read() {
    let plain = obj(format!("{CORNERS}f 1 2 3 4\n"));
    let bytes = |parts: &[&[u8]]| obj(parts.concat());
    let square = format!("{CORNERS}f 1 2 3 4\n");
    let cases = [
        ("Latin-1", bytes(&[b"# M\xfcller\n", square.as_bytes()])),
        ("GBK", bytes(&[b"o \xc4\xa3\xd0\xcd\\\n", square.as_bytes()])),
        ("a byte-order mark", bytes(&[b"\xef\xbb\xbf", square.as_bytes()])),
        ("CR", obj(square.replace('\n', "\r"))),
        ("CRLF", obj(square.replace('\n', "\r\n"))),
        ("tabs and blanks", obj(square.replace(' ', " \t ").replace('\n', "  \n"))),
        ("a continued line", obj(format!("{CORNERS}f 1 2 \\\n 3 4\n"))),
        ("a line continued after a number", obj(format!("{CORNERS}f 1 2\\\r\n 3 4\n"))),
        (
            "comments after data",
            obj(square.replace("0\n", "0 # here\n").replace("4\n", "4 #quad\n")),
        ),
        ("negative numbers", obj(format!("{CORNERS}f -4 -3 -2 -1\n"))),
        ("a face before its vertices", obj(format!("f 1 2 3 4\n{CORNERS}"))),
        ("a weight", obj(square.replace("0\n", "0 1.0\n"))),
        ("slashes without numbers", obj(format!("{CORNERS}f 1/ 2// 3 4\n"))),
        ("a vertex that no face has", obj(format!("{CORNERS}v nan -inf 1e300\nf 1 2 3 4\n"))),
    ];
    for (name, files) in cases {
        let notes = same(name, &files, &plain);
        assert!(notes.is_empty(), "{name}: {notes:?}");
    }
}

#[test]
fn utf16_text_is_refused_by_name() {
    let text = [&[0xff, 0xfe][..], &[b'v', 0, b' ', 0]].concat();
    let expected = "x.obj: the file is UTF-16 text; save it as UTF-8";
    assert_eq!(refusal(&obj(&text)), expected);
}

#[test]
fn obj_unknown_statements_are_notes_with_line() {
    let plain = obj(format!("{CORNERS}f 1 2 3 4\n"));
    let cases = [
        ("usemtl", "usemtl\n", "x.obj:5: usemtl without a name"),
        ("usemtl gone", "usemtl gone\n", "x.obj:6: no library has the material `gone`"),
        ("mtllib", "mtllib\n", "x.obj:5: mtllib without a name"),
        ("vn", "vn a b c\n", "x.obj:5: vn needs three numbers, not `a b c`"),
        ("vt", "vt\n", "x.obj:5: vt needs numbers"),
        ("unknown", "hello there\n", "x.obj:5: unknown statement `hello`"),
        ("a line as a face", "f 1 2\n", "x.obj:5: a face of 2 corners"),
        ("curves", "cstype bezier\n", "free-form curves and surfaces are ignored"),
    ];
    for (name, line, note) in cases {
        let notes = same(name, &obj(format!("{CORNERS}{line}f 1 2 3 4\n")), &plain);
        assert!(notes.iter().any(|it| it.contains(note)), "{name}: {notes:?}");
    }
    let many = format!("{CORNERS}{}f 1 2 3 4\n", "hello\n".repeat(5));
    let notes = same("many", &obj(many), &plain);
    assert_eq!(notes.len(), 1);
    assert!(notes[0].ends_with("(and 4 more of this kind)"), "{notes:?}");
}

#[test]
fn obj_corners_with_normals_and_without_are_mixed() {
    let text = format!("{CORNERS}vn 0 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n");
    let loaded = load(&obj(&text)).unwrap();
    let mesh = loaded.scene.mesh.as_ref().unwrap();
    assert!(mesh.corner_normals(0).is_some());
    assert!(mesh.corner_normals(1).is_none());
    let wrong = text.replace("3//1", "3//9");
    let notes = load(&obj(wrong)).unwrap().notes;
    assert!(notes[0].contains("x.obj:6: a face has the normal 9"), "{notes:?}");
}

#[test]
fn faults_of_obj_geometry_name_their_line() {
    for (from, to, expected) in [
        ("v 1 1 0", "v 1 x 0", "x.obj:3: a vertex needs three numbers, not `1 x 0`"),
        ("v 1 1 0", "v 1 nan 0", "x.obj:5: vertex 2 is not finite: NaN"),
        ("v 1 1 0", "v 1 1e39 0", "x.obj:5: vertex 2 is at [1.0, 1e39, 0.0]; coordinates must"),
        ("f 1 2 3 4", "f 1 2 0", "x.obj:5: a face has the corner `0`, which is no vertex"),
        ("f 1 2 3 4", "f 1 2 -9", "x.obj:5: a face has the corner `-9`, which is no vertex"),
        ("f 1 2 3 4", "f 1 2 9", "x.obj:5: a face has the vertex 9, but there are only 4"),
        ("f 1 2 3 4", "f 1 2 99999999999", "x.obj:5: a face has the corner `99999999999`"),
        ("f 1 2 3 4", "", "x.obj: the file has no triangles"),
        ("f 1 2 3 4", "f 1 1 2", "x.obj: no triangle has an area, of 1 in the file"),
    ] {
        let text = format!("{CORNERS}f 1 2 3 4\n").replace(from, to);
        let found = refusal(&obj(text));
        assert!(found.starts_with(expected), "{to}: {found}");
    }
    let many = format!("{CORNERS}f{}\n", " 1 2 3".repeat(1366));
    let expected = "x.obj:5: a face has 4098 corners; the most is 4096";
    assert_eq!(refusal(&obj(many)), expected);
}

/// Checks that triangles fill a polygon: their areas are its area, and their middles are in it.
fn fills(name: &str, files: &[NamedFile], area: f64, is_inside: &dyn Fn(DVec3) -> bool) {
    let mesh = load(files).unwrap().scene.mesh.unwrap();
    let mut sum = 0.0;
    for triangle in 0..mesh.triangles.len() {
        let [a, b, c] = mesh.places(triangle);
        sum += (b - a).cross(c - a).length() / 2.0;
        assert!(is_inside((a + b + c) / 3.0), "{name}: {:?}", [a, b, c]);
    }
    assert!((sum - area).abs() < 1e-6 * area, "{name}: {sum}, not {area}");
}

#[test]
fn concave_polygons_are_filled_in_any_plane() {
    let corners = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)];
    let is_u = |x: f64, y: f64| {
        (0.0..=3.0).contains(&x)
            && (0.0..=3.0).contains(&y)
            && !((1.0..=2.0).contains(&x) && y > 1.0)
    };
    for first in 0..corners.len() {
        let turned = corners.iter().cycle().skip(first).take(corners.len());
        let numbers: Vec<usize> = (1..=corners.len()).collect();
        let text = |place: &dyn Fn(i32, i32) -> String, numbers: &[usize]| {
            let vertices: String = turned.clone().map(|&(x, y)| place(x, y)).collect();
            let face: String = numbers.iter().map(|it| format!(" {it}")).collect();
            format!("{vertices}f{face}\n")
        };
        let flat = |x: i32, y: i32| format!("v {x} {y} 0\n");
        let upright = |x: i32, y: i32| format!("v 7 {x} {y}\n");
        let sloping = |x: i32, y: i32| format!("v {x} {} {y}\n", 2 * y);
        let backwards: Vec<usize> = numbers.iter().rev().copied().collect();
        for numbers in [&numbers, &backwards] {
            fills("flat", &obj(text(&flat, numbers)), 7.0, &|at| is_u(at.x, at.y));
            fills("upright", &obj(text(&upright, numbers)), 7.0, &|at| is_u(at.y, at.z));
            let area = 7.0 * 5.0_f64.sqrt();
            fills("sloping", &obj(text(&sloping, numbers)), area, &|at| is_u(at.x, at.z));
        }
    }
    let ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
               property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n\
               0 0 0\n4 0 0\n1 1 0\n0 4 0\n4 0 1 2 3\n";
    fills("a dart", &[file("x.ply", ply)], 4.0, &|at| {
        at.x + 3.0 * at.y <= 4.0 || 3.0 * at.x + at.y <= 4.0
    });
}

#[test]
fn crossing_edges_are_noted() {
    let notes = load(&obj(format!("{CORNERS}f 1 3 2 4\n"))).unwrap().notes;
    assert!(notes[0].contains("x.obj:5: a face whose edges cross"), "{notes:?}");
}

#[test]
fn obj_colours_of_vertices_multiply_the_materials() {
    let coloured =
        "mtllib a.mtl\nusemtl red\nv -1 -1 0 0 1 0\nv 1 -1 0 0 1 0\nv 1 1 0 0 1 0\nf 1 2 3\n";
    let white = "newmtl red\nKd 1 1 1\n";
    let green = red("newmtl red\nKd 0 1 0\n");
    let triangle = green[0].1.clone();
    let triangle = String::from_utf8(triangle).unwrap().replace("f 1 2 3 4", "f 1 2 3");
    let plain = [file("x.obj", &triangle), green[1].clone()];
    same("one colour", &[file("x.obj", coloured), file("a.mtl", white)], &plain);
    let bytes = coloured.replace("0 0 1 0", "0 0 255 0");
    same("bytes", &[file("x.obj", bytes), file("a.mtl", white)], &plain);
    let some = coloured.replace("v 1 1 0 0 1 0", "v 1 1 0");
    let mesh = load(&[file("x.obj", some), file("a.mtl", white)]).unwrap().scene.mesh.unwrap();
    let found = mesh.corner_colours(0).unwrap().map(|it| it.to_array());
    assert_eq!(found, [[0.0, 1.0, 0.0], [0.0, 1.0, 0.0], [1.0; 3]]);
}

#[test]
fn libraries_are_found_by_all_their_names() {
    let plain = red(RED);
    let square = |mtllib: &str, usemtl: &str| {
        format!("mtllib {mtllib}\n{CORNERS}usemtl {usemtl}\nf 1 2 3 4\n")
    };
    let green = "newmtl green\nKd 0 1 0\n";
    let spaced = RED.replace("red", "dark red");
    let cases: [(&str, Vec<NamedFile>); 8] = [
        (
            "two on a line",
            vec![
                file("x.obj", square("g.mtl a.mtl", "red")),
                file("g.mtl", green),
                file("a.mtl", RED),
            ],
        ),
        (
            "blanks",
            vec![file("x.obj", square("my house.mtl", "dark red")), file("my house.mtl", &spaced)],
        ),
        ("other case", vec![file("x.obj", square("A.MTL", "RED")), file("a.mtl", RED)]),
        (
            "a folder of another computer's",
            vec![file("x.obj", square(".\\a.mtl", "red")), file("a.mtl", RED)],
        ),
        ("quotes", vec![file("x.obj", square("\"a.mtl\"", "red")), file("a.mtl", RED)]),
        (
            "a comment",
            vec![file("x.obj", square("a.mtl # here", "red # not blue")), file("a.mtl", RED)],
        ),
        (
            "a sign of comments",
            vec![
                file("x.obj", square("a.mtl", "Material #25")),
                file("a.mtl", RED.replace("red", "Material #25")),
            ],
        ),
        (
            "Latin-1",
            vec![
                file(
                    "x.obj",
                    [b"mtllib a.mtl\n", CORNERS.as_bytes(), b"usemtl gr\xfcn\nf 1 2 3 4\n"]
                        .concat(),
                ),
                file("a.mtl", b"newmtl gr\xfcn\nKd 0.9 0.1 0.1\n"),
            ],
        ),
    ];
    for (name, files) in cases {
        let notes = same(name, &files, &plain);
        assert!(notes.is_empty(), "{name}: {notes:?}");
    }
    let both = vec![file("x.obj", square("g.mtl gone.mtl", "red")), file("g.mtl", green)];
    let notes = load(&both).unwrap().notes;
    assert!(notes.iter().any(|it| it.contains("gone.mtl: ")), "{notes:?}");
}

#[test]
fn faulty_libraries_keep_valid_values() {
    let plain = red(RED);
    let cases = [
        ("map_Kd\n", "a.mtl:3: map_Kd without the name of a picture"),
        ("map_Kd gone.png\n", "texture coordinates"),
        ("Ns abc\n", "a.mtl:3: Ns needs a number, not `abc`"),
        ("Ks 1 2\n", "a.mtl:3: Ks needs one number or three"),
        ("Kd xyz 1 2 3\n", "a.mtl:3: Kd needs one number or three"),
        ("hello\n", "a.mtl:3: unknown statement `hello`"),
        ("newmtl\n", "a.mtl:3: newmtl without a name"),
        ("map_Bump b.png\n", "a.mtl:3: textures other than those of diffuse colours"),
    ];
    for (line, note) in cases {
        let notes = same(line, &red(format!("{RED}{line}")), &plain);
        assert!(notes.iter().any(|it| it.contains(note)), "{line}: {notes:?}");
    }
    for line in ["illum 2.0\n", "illum 2\n", "Ka 1 1 1\n", "Tf 1 1 1\n", "  \n"] {
        let notes = same(line, &red(format!("{RED}{line}")), &plain);
        assert!(notes.is_empty(), "{line}: {notes:?}");
    }
    let mark = [b"\xef\xbb\xbf", RED.as_bytes()].concat();
    same("a byte-order mark", &red(mark), &plain);
    same("CR", &red(RED.replace('\n', "\r")), &plain);
}

#[test]
fn values_of_libraries_are_read_in_all_their_forms() {
    let mirror = |lines: &str| red(format!("{RED}illum 3\n{lines}"));
    same("Ks of one number", &mirror("Ks 0.5\n"), &mirror("Ks 0.5 0.5 0.5\n"));
    let clear = |lines: &str| red(format!("{RED}{lines}"));
    same("Tr", &clear("Tr 0.75\n"), &clear("d 0.25\n"));
    same("Tr beside d", &clear("Tr 1.0\nd 0.25\n"), &clear("d 0.25\n"));
    same("a halo", &clear("d -halo 0.25\n"), &clear("d 0.25\n"));
    same("words in other case", &clear("NI 1.5\nTR 0.5\n"), &clear("Ni 1.5\nTr 0.5\n"));
    let lamp = load(&clear("Ke 1 0.5 0\n")).unwrap().scene;
    assert_eq!(lamp.materials[0].emission, DVec3::new(1.0, 0.5, 0.0));
}

#[test]
fn meshes_far_from_the_origin_keep_their_shape_and_are_in_view() {
    let far = |x: f64, y: f64| format!("v {} {} 100.5\n", 458_000.0 + x, 5_428_000.25 + y);
    let corners = [(0.0, 0.0), (0.125, 0.0), (0.125, 0.125)].map(|(x, y)| far(x, y));
    let scene = load(&obj(format!("{}f 1 2 3\n", corners.concat()))).unwrap().scene;
    let mesh = scene.mesh.as_ref().unwrap();
    let [a, b, c] = mesh.places(0);
    assert_eq!(a, DVec3::new(458_000.0, 5_428_000.25, 100.5));
    assert_eq!([b - a, c - b], [DVec3::new(0.125, 0.0, 0.0), DVec3::new(0.0, 0.125, 0.0)]);
    assert!(scene.view.at.distance(a) < 0.2, "{:?}", scene.view.at);
    assert!(scene.view.from.distance(a) < 1.0, "{:?}", scene.view.from);
    let near = load(&obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).unwrap().scene;
    assert_eq!(near.mesh.unwrap().origin, DVec3::ZERO);
}

#[test]
fn files_of_other_programs_are_named() {
    let cases: [(&'static str, &[u8], &str); 14] = [
        ("x.fbx", b"Kaydara FBX Binary  \0", "an FBX file"),
        ("x.obj", b"; FBX 7.3.0 project file\n", "an FBX file"),
        ("x.nff", b"nff\nversion 2.1\n", "a Sense8 (WorldToolKit) NFF file"),
        ("x.blend", b"BLENDER-v300", "a Blender (.blend) file"),
        ("x.dae", b"<?xml version=\"1.0\"?>\n<COLLADA>", "a COLLADA (.dae) file"),
        ("x.3ds", b"MM\0\0", "a 3D Studio (.3ds) file"),
        ("x.nff", b"#VRML V2.0 utf8\n", "a VRML file"),
        ("x.stl", b"ISO-10303-21;\n", "a STEP file"),
        ("x.zip", b"PK\x03\x04", "a ZIP archive"),
        ("x.nff", b"\xff\xd8\xff\xe0", "a JPEG picture"),
        ("x.nff", b"{\"version\": 1}", "a JSON file that is not glTF"),
        ("x.mtl", b"newmtl a\n", "a material library of OBJ files"),
        ("x.pov", b"camera {\n", "a POV-Ray scene"),
        ("scene", b"\0\x01\x02", "a binary file of an unknown format"),
    ];
    for (name, bytes, expected) in cases {
        let found = refusal(&[file(name, bytes)]);
        let expected = format!("{name}: this is {expected}");
        assert!(found.starts_with(&expected), "{found}");
    }
}

#[test]
fn content_overrides_extension() {
    let square = format!("# a square\n{CORNERS}f 1 2 3 4\n");
    let plain = obj(&square);
    same("OBJ as NFF", &[file("x.nff", &square)], &plain);
    same("OBJ without an end", &[file("square", &square)], &plain);
    let stl = super::scans::STL;
    same("STL as NFF", &[file("x.nff", stl)], &[file("x.stl", stl)]);
    let binary = super::scans::binary_stl(b"; FBX is not what this is");
    same("binary STL as OBJ", &[file("x.obj", &binary)], &[file("x.stl", &binary)]);
    let glb = super::files::glb();
    same("GLB as glTF", &[file("x.gltf", &glb)], &[file("x.glb", &glb)]);
    let tetra = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\nf 1 1 1 1 0 0 0 0\ns 0 0 0 1\n";
    let loaded = load(&[file("x.nff", tetra)]).unwrap();
    assert_eq!(loaded.scene.objects.len(), 1);
}
