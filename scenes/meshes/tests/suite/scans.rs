//! PLY and STL files as other programs write them, each beside a plain one that means the same.

use glam::DVec3;

use super::pairs::{NamedFile, file, load, refusal, same};

const CORNERS: &str = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

fn header(properties: &str, elements: &str) -> String {
    format!(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
         property float z\n{properties}{elements}end_header\n"
    )
}

fn faces(count: usize) -> String {
    format!("element face {count}\nproperty list uchar int vertex_indices\n")
}

fn ply(text: impl AsRef<[u8]>) -> Vec<NamedFile> {
    vec![file("x.ply", text)]
}

fn square() -> Vec<NamedFile> {
    ply(format!("{}{CORNERS}4 0 1 2 3\n", header("", &faces(1))))
}

#[test]
fn ply_text_is_read_in_all_its_forms() {
    let text = format!("{}{CORNERS}4 0 1 2 3\n", header("", &faces(1)));
    let head = header("", &faces(1));
    let cases = [
        ("blank lines", text.replace("end_header\n", "end_header\n\n").replace("4 0 1", "\n4 0 1")),
        ("CR", text.replace('\n', "\r")),
        ("CRLF", text.replace('\n', "\r\n")),
        ("rows over two lines", text.replace("4 0 1 ", "4 0 1\n")),
        (
            "comments",
            text.replace("element face", "comment by M\u{fc}ller\nobj_info n 5\nelement face"),
        ),
        (
            "a face without corners",
            format!("{}{CORNERS}0\n4 0 1 2 3\n", head.replace("face 1", "face 2")),
        ),
        (
            "real numbers",
            text.replace("4 0 1 2 3", "4 0.0 1.0 2.0 3.0").replace("uchar int", "uchar float"),
        ),
        ("another name", text.replace("vertex_indices", "vertex_index")),
        ("doubles", text.replace("float", "double")),
        (
            "other elements",
            text.replace(
                "element face",
                "element edge 1\nproperty list int int v\nproperty int c\nelement face",
            )
            .replace("4 0 1 2 3", "2 7 8 9\n4 0 1 2 3"),
        ),
        (
            "a vertex that no face has",
            text.replace("vertex 4", "vertex 5").replace("4 0 1 2 3", "nan nan inf\n4 0 1 2 3"),
        ),
        (
            "an empty element",
            text.replace("element face", "element other 99999999999\nelement face"),
        ),
    ];
    for (name, text) in cases {
        let notes = same(name, &ply(text), &square());
        assert!(notes.is_empty(), "{name}: {notes:?}");
    }
    let first = format!(
        "ply\nformat ascii 1.0\n{}element vertex 4\nproperty float x\nproperty float y\n\
         property float z\nend_header\n4 0 1 2 3\n{CORNERS}",
        faces(1)
    );
    same("faces first", &ply(first), &square());
    let latin = [b"ply\ncomment M\xfcller\n", &square()[0].1[4..]].concat();
    same("Latin-1", &ply(latin), &square());
}

#[test]
fn ply_strips_begin_again_after_minus_1() {
    let strips = "element tristrips 1\nproperty list int int vertex_indices\n";
    let text = format!("{}{CORNERS}8 0 1 2 -1 0 2 3 3\n", header("", strips));
    let triangles = format!("{}{CORNERS}3 0 1 2\n3 0 2 3\n", header("", &faces(2)));
    same("restarts", &ply(text), &ply(triangles));
    let one = format!("{}{CORNERS}4 0 1 3 2\n", header("", strips));
    let triangles = format!("{}{CORNERS}3 0 1 3\n3 3 1 2\n", header("", &faces(2)));
    same("one strip", &ply(one), &ply(triangles));
}

#[test]
fn ply_lists_of_any_type_are_read_in_both_byte_orders() {
    let number = |kind: &str, value: u8, is_big: bool| {
        let mut bytes = match kind {
            "char" | "uint8" => vec![value],
            "short" | "ushort" => vec![value, 0],
            "int" | "uint32" => vec![value, 0, 0, 0],
            "float" => f32::from(value).to_le_bytes().to_vec(),
            _ => f64::from(value).to_le_bytes().to_vec(),
        };
        if is_big {
            bytes.reverse();
        }
        bytes
    };
    let kinds = ["char", "uint8", "short", "ushort", "int", "uint32", "float", "double"];
    for kind in kinds {
        for is_big in [false, true] {
            let order = if is_big { "binary_big_endian" } else { "binary_little_endian" };
            let list = format!("element face 1\nproperty list {kind} {kind} vertex_indices\n");
            let head = header("", &list).replace("ascii", order).replace("float", "short");
            let head = head
                .replace("list short", &format!("list {kind}"))
                .replace(" short vertex_", &format!(" {kind} vertex_"));
            let mut bytes = head.into_bytes();
            for value in CORNERS.split_whitespace() {
                bytes.extend(number("short", value.parse().unwrap(), is_big));
            }
            for value in [4, 0, 1, 2, 3] {
                bytes.extend(number(kind, value, is_big));
            }
            same(kind, &ply(bytes), &square());
        }
    }
}

#[test]
fn ply_colours_of_vertices_and_faces_are_drawn() {
    let colour = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    let vertices = CORNERS.replace("0\n", "0 255 0 51\n");
    let of_vertices = ply(format!("{}{vertices}4 0 1 2 3\n", header(colour, &faces(1))));
    let of_faces = ply(format!(
        "{}{CORNERS}4 0 1 2 3 255 0 51\n",
        header("", &format!("{}{colour}", faces(1)))
    ));
    let floats = ply(format!(
        "{}{}4 0 1 2 3\n",
        header(&colour.replace("uchar", "float"), &faces(1)),
        vertices.replace("255 0 51", "1 0 0.2")
    ));
    same("faces", &of_faces, &of_vertices);
    same("floats", &floats, &of_vertices);
    let scene = load(&of_vertices).unwrap().scene;
    let expected = DVec3::new(1.0, 0.0, 0.2);
    assert!((scene.materials[0].colour - expected).length() < 1e-6);
    let mixed =
        format!("{}{}4 0 1 2 3\n", header(colour, &faces(1)), vertices.replacen("255", "0", 1));
    let mesh = load(&ply(mixed)).unwrap().scene.mesh.unwrap();
    assert_eq!(mesh.colours.len(), 4);
}

#[test]
fn faults_of_ply_files_name_their_place() {
    let text = String::from_utf8(square()[0].1.clone()).unwrap();
    for (from, to, expected) in [
        ("0 1 0\n4", "0 x 0\n4", "x.ply:13: `x` is not a number"),
        ("3\n", "", "x.ply:14: the file ends inside its data"),
        ("4 0 1 2 3", "4 0 1 2 9", "x.ply: face 0 has the vertex 9, but there are only 4"),
        ("4 0 1 2 3", "4 0 1 2 1.5", "x.ply: face 0 has the vertex 1.5"),
        ("4 0 1 2 3", "-4 0 1 2 3", "x.ply:14: the list vertex_indices has -4 numbers"),
        ("float x", "real x", "x.ply:4: not a property of a known type"),
        ("ascii", "utf8", "x.ply:2: unknown format"),
        ("vertex 4", "vertex many", "x.ply:3: an element's count is no whole number"),
        ("float z", "float w", "x.ply: not a valid PLY file: its vertices lack x, y or z"),
        ("end_header", "end", "x.ply:9: unknown line of the header"),
    ] {
        let found = refusal(&ply(text.replace(from, to)));
        assert!(found.starts_with(expected), "{to}: {found}");
    }
    let notes = load(&ply(text.replace("face 1", "face 2") + "2 0 1\n")).unwrap().notes;
    assert_eq!(notes, ["1 faces of one or two corners are ignored"]);
}

pub const STL: &str = "solid it\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n\
                   vertex 0 1 0\nendloop\nendfacet\nendsolid it\n";

fn stl(bytes: impl AsRef<[u8]>) -> Vec<NamedFile> {
    vec![file("x.stl", bytes)]
}

pub fn binary_stl(title: &[u8]) -> Vec<u8> {
    let mut bytes = title.to_vec();
    bytes.resize(80, b' ');
    bytes.extend(1_u32.to_le_bytes());
    let numbers = [0.0_f32, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    bytes.extend(numbers.into_iter().flat_map(f32::to_le_bytes));
    bytes.extend([0, 0]);
    bytes
}

#[test]
fn both_kinds_of_stl_are_read_in_all_their_forms() {
    let cases: [(&str, Vec<u8>); 8] = [
        ("binary", binary_stl(b"by a printer")),
        ("a binary file that begins as text", binary_stl(b"solid part\n")),
        ("bytes after the end", [binary_stl(b"by a printer"), vec![0; 7]].concat()),
        ("upper case", STL.to_uppercase().into_bytes()),
        ("CR", STL.replace('\n', "\r").into_bytes()),
        ("no name, and no end", STL.replace(" it", "").replace("endsolid", "").into_bytes()),
        ("a normal that is none", STL.replace("normal 0 0 1", "normal nan nan nan").into_bytes()),
        ("blank lines and a mark", format!("\u{feff}\n\n{STL}").into_bytes()),
    ];
    for (name, bytes) in cases {
        assert!(same(name, &stl(bytes), &stl(STL)).is_empty(), "{name}");
    }
    let two = format!("{STL}{}", STL.replace("1 0 0", "-1 0 0"));
    assert_eq!(load(&stl(two)).unwrap().scene.mesh.unwrap().triangles.len(), 2);
    let scene = load(&stl(STL)).unwrap().scene;
    assert_eq!(scene.view.up, DVec3::Z);
}

#[test]
fn faults_of_stl_files_name_their_place() {
    let found = refusal(&stl(STL.replace("1 0 0", "1 0 x")));
    assert!(found.starts_with("x.stl:5: a vertex needs three finite numbers"), "{found}");
    let mut short = binary_stl(b"short");
    short.truncate(120);
    let expected = "x.stl: not a valid STL file: its 1 triangles need 134 bytes, but it has 120";
    assert_eq!(refusal(&stl(short)), expected);
    let found = refusal(&stl(b"short"));
    assert!(found.ends_with("it has 5 bytes, less than a header"), "{found}");
}
