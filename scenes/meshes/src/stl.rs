//! STL files, in text and binary. Normals of facets are those of the triangles, so they are not
//! read.

use glam::DVec3;

use crate::Fault;
use crate::builder::{Builder, Vertex};
use crate::framing::Up;
use crate::text::{Lines, number, shown, without_mark, words};

/// Bytes of the header of a binary file, with the number of triangles at its end.
const HEADER: usize = 84;
/// Bytes of a triangle.
const TRIANGLE: usize = 50;

pub(crate) fn read(bytes: &[u8], builder: &mut Builder) -> Result<(), Fault> {
    // Some files show both sides of surfaces, and some have triangles the wrong way round.
    builder.two_sided = true;
    builder.up = Up::Z;
    let material = builder.material(scenes::Material::matte(DVec3::splat(0.8)), None)?;
    if is_text(bytes) { text(bytes, material, builder) } else { binary(bytes, material, builder) }
}

/// Whether a file is text. Headers of binary files may begin with "solid", too, but then the size
/// fits the number of triangles.
fn is_text(bytes: &[u8]) -> bool {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let begins = bytes.trim_ascii_start().get(..5);
    let begins = begins.is_some_and(|it| it.eq_ignore_ascii_case(b"solid"));
    begins && !is_binary(bytes, bytes.len() as u64)
}

/// Whether the beginning of a file and its size are those of a binary file.
pub(crate) fn is_binary(beginning: &[u8], size: u64) -> bool {
    let triangles = count(beginning).filter(|count| *count > 0);
    triangles.is_some_and(|count| (HEADER + count * TRIANGLE) as u64 == size)
}

/// The number of triangles that a binary file's header states.
fn count(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(HEADER - 4..HEADER)?;
    Some(u32::from_le_bytes(count.try_into().ok()?) as usize)
}

fn binary(bytes: &[u8], material: u32, builder: &mut Builder) -> Result<(), Fault> {
    let there = bytes.len();
    let Some(count) = count(bytes) else {
        return Err(Fault::Stl(format!("it has {there} bytes, less than a header")));
    };
    let Some(rows) = bytes.get(HEADER..HEADER + count * TRIANGLE) else {
        let needed = HEADER + count * TRIANGLE;
        return Err(Fault::Stl(format!(
            "its {count} triangles need {needed} bytes, but it has {there}"
        )));
    };
    for row in rows.chunks_exact(TRIANGLE) {
        let number = |at: usize| {
            f64::from(f32::from_le_bytes([row[at], row[at + 1], row[at + 2], row[at + 3]]))
        };
        let mut corners = [0; 3];
        for (corner, at) in corners.iter_mut().zip([12, 24, 36]) {
            let position = DVec3::new(number(at), number(at + 4), number(at + 8));
            *corner = builder.vertex(&Vertex { position, ..Vertex::default() })?;
        }
        builder.triangle(corners, material)?;
    }
    Ok(())
}

fn text(bytes: &[u8], material: u32, builder: &mut Builder) -> Result<(), Fault> {
    let text = without_mark(bytes).map_err(Fault::Encoding)?;
    let mut corners = Vec::new();
    for (line, text) in Lines::new(text) {
        let mut words = words(&text);
        let keyword = words.next().unwrap_or_default().to_ascii_lowercase();
        match keyword.as_slice() {
            b"vertex" => {
                let mut next = || words.next().and_then(number);
                let position = next().zip(next()).zip(next());
                let Some(((x, y), z)) = position else {
                    let what = format!("a vertex needs three finite numbers, not {}", shown(&text));
                    return Err(Fault::Line { line, what });
                };
                corners.push(
                    builder
                        .vertex(&Vertex { position: DVec3::new(x, y, z), ..Vertex::default() })?,
                );
            }
            b"endloop" => {
                builder.face(&corners, material)?;
                corners.clear();
            }
            _ => {}
        }
    }
    Ok(())
}
