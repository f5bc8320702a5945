//! Wavefront OBJ files.
//!
//! Names are bytes, because files come in all encodings. What only changes how the mesh looks is a
//! note if it can't be understood; what changes its shape is an error.

mod library;
mod materials;

use std::path::Path;

use glam::DVec3;

use self::library::Libraries;
use self::materials::Materials;
use crate::Fault;
use crate::builder::{Builder, MAX_CORNERS, Vertex};
use crate::text::{
    Lines, any_number, first_word, number, shown, without_comment, without_mark, words,
};

/// An index that a corner doesn't have.
const NONE: u32 = u32::MAX;

/// Statements without effect on a picture.
const WITHOUT_EFFECT: [&[u8]; 13] = [
    b"g",
    b"o",
    b"s",
    b"l",
    b"p",
    b"mg",
    b"usemap",
    b"maplib",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"lod",
    b"shadow_obj",
];
/// Statements of free-form curves and surfaces.
const FREE_FORM: [&[u8]; 16] = [
    b"vp", b"cstype", b"deg", b"bmat", b"step", b"curv", b"curv2", b"surf", b"parm", b"trim",
    b"hole", b"scrv", b"sp", b"end", b"con", b"ctech",
];

/// Whether a text without an OBJ file's name is an OBJ file: its first statement is one that NFF
/// has not.
pub(crate) fn is_likely(beginning: &[u8]) -> bool {
    let text = without_mark(beginning).unwrap_or_default();
    let first = Lines::new(text).map(|(_, line)| line).find(|line| {
        let (word, _) = first_word(line);
        !word.is_empty() && !word.starts_with(b"#")
    });
    let Some(first) = first else {
        return false;
    };
    match first_word(&first) {
        (b"v" | b"vn" | b"vt", rest) => words(rest).filter_map(number).count() >= 2,
        (b"mtllib" | b"usemtl" | b"o" | b"g", _) => true,
        _ => false,
    }
}

pub(crate) fn read(bytes: &[u8], name: &Path, builder: &mut Builder) -> Result<(), Fault> {
    let text = without_mark(bytes).map_err(Fault::Encoding)?;
    // The format doesn't specify whether surfaces have a back, and many files are wound both ways.
    builder.two_sided = true;
    let file = name.display().to_string();
    let mut parts = Parts::default();
    let mut libraries = Libraries::new(name);
    for (line, text) in Lines::new(text) {
        parts.statement(line, &text, &file, &mut libraries, builder)?;
    }
    parts.build(&file, &libraries, builder)
}

/// What a file has, as its statements give it.
#[derive(Default)]
struct Parts {
    positions: Vec<DVec3>,
    /// Colours of the positions, as the file has them; empty if it has none. NaN without one.
    colours: Vec<[f32; 3]>,
    coordinates: Vec<[f32; 2]>,
    normals: Vec<DVec3>,
    corners: Vec<[u32; 3]>,
    faces: Vec<Face>,
    /// The names that `usemtl` has, each once.
    names: Vec<Vec<u8>>,
    /// The current one, or `NONE`.
    name: u32,
    is_begun: bool,
}

/// A face: corners of `Parts` from `start` to the next face's start.
struct Face {
    start: u32,
    line: u32,
    name: u32,
}

impl Parts {
    fn statement(
        &mut self,
        line: usize,
        text: &[u8],
        file: &str,
        libraries: &mut Libraries,
        builder: &mut Builder,
    ) -> Result<(), Fault> {
        if !std::mem::replace(&mut self.is_begun, true) {
            self.name = NONE;
        }
        let (word, rest) = first_word(text);
        let numbers = without_comment(rest);
        match word {
            b"v" => self.position(line, numbers)?,
            b"vt" => {
                let place = two(numbers).unwrap_or_else(|| {
                    let text = format!("vt needs numbers, not {}; it is 0 0", shown(numbers));
                    builder.notes.line(file, line, "vt", &text);
                    [0.0; 2]
                });
                self.coordinates.push(place);
            }
            b"vn" => {
                let normal = three(numbers).unwrap_or_else(|| {
                    let text = format!(
                        "vn needs three numbers, not {}; faces with it are flat",
                        shown(numbers)
                    );
                    builder.notes.line(file, line, "vn", &text);
                    DVec3::ZERO
                });
                self.normals.push(normal);
            }
            b"f" | b"fo" => self.face(line, numbers, file, builder)?,
            b"usemtl" => self.use_material(line, rest, file, builder),
            b"mtllib" => libraries.load(line, rest, file, builder)?,
            _ if word.is_empty() || word.starts_with(b"#") => {}
            _ if WITHOUT_EFFECT.contains(&word) => {}
            _ if FREE_FORM.contains(&word) => {
                builder.notes.add("free-form curves and surfaces are ignored");
            }
            _ => {
                let text = format!("unknown statement {}, which is ignored", shown(word));
                builder.notes.line(file, line, "unknown", &text);
            }
        }
        Ok(())
    }

    /// `v x y z`, with a weight or with a colour after it.
    fn position(&mut self, line: usize, text: &[u8]) -> Result<(), Fault> {
        let mut words_of = words(text).map(any_number);
        let mut next = || words_of.next().flatten();
        // Scanners write NaN where they have seen nothing, and no face has these vertices.
        let Some(((x, y), z)) = next().zip(next()).zip(next()) else {
            return Err(Fault::Line {
                line,
                what: format!("a vertex needs three numbers, not {}", shown(text)),
            });
        };
        let colour = words(text).skip(3).take(3).map(number);
        let colour: Option<Vec<f32>> = colour.map(|it| Some(it? as f32)).collect();
        if let Some(&[red, green, blue]) = colour.as_deref() {
            let without = [f32::NAN; 3];
            self.colours.resize(self.positions.len(), without);
            self.colours.push([red, green, blue]);
        }
        self.positions.push(DVec3::new(x, y, z));
        Ok(())
    }

    fn face(
        &mut self,
        line: usize,
        text: &[u8],
        file: &str,
        builder: &mut Builder,
    ) -> Result<(), Fault> {
        let start = self.corners.len();
        for word in words(text) {
            let corner = self.corner(line, word, file, builder)?;
            self.corners.push(corner);
        }
        let count = self.corners.len() - start;
        if count < 3 {
            let text = format!("a face of {count} corners, which is ignored");
            builder.notes.line(file, line, "corners", &text);
            self.corners.truncate(start);
            return Ok(());
        }
        if count > MAX_CORNERS {
            let what = Fault::TooManyCorners(count).to_string();
            return Err(Fault::Line { line, what });
        }
        self.faces.push(Face { start: start as u32, line: line as u32, name: self.name });
        if self.corners.len() > NONE as usize / 2 {
            return Err(Fault::TooManyTriangles);
        }
        Ok(())
    }

    /// The indices of a corner's position, texture coordinates and normal. Whether they exist is
    /// checked at the end of the file.
    fn corner(
        &self,
        line: usize,
        word: &[u8],
        file: &str,
        builder: &mut Builder,
    ) -> Result<[u32; 3], Fault> {
        let wrong = || Fault::Line {
            line,
            what: format!("a face has the corner {}, which is no vertex", shown(word)),
        };
        let counts = [self.positions.len(), self.coordinates.len(), self.normals.len()];
        let mut found = [NONE; 3];
        let mut parts = word.split(|&byte| byte == b'/');
        for ((place, found), count) in found.iter_mut().enumerate().zip(counts) {
            let part = parts.next().unwrap_or_default();
            if part.is_empty() && place > 0 {
                continue;
            }
            let number: Option<i64> = std::str::from_utf8(part).ok().and_then(|it| it.parse().ok());
            let index = match number {
                Some(number) if number < 0 => number.checked_add(count as i64),
                Some(number) => number.checked_sub(1),
                None => None,
            };
            match index.and_then(|index| u32::try_from(index).ok()) {
                Some(index) if index < NONE => *found = index,
                _ if place == 0 => return Err(wrong()),
                _ => self.no_part(line, word, file, builder),
            }
        }
        Ok(found)
    }

    /// Notes a corner whose texture coordinates or normal don't exist.
    fn no_part(&self, line: usize, word: &[u8], file: &str, builder: &mut Builder) {
        let text = format!(
            "the corner {} has texture coordinates or a normal that don't exist; it is drawn without them",
            shown(word)
        );
        builder.notes.line(file, line, "corner", &text);
    }

    fn use_material(&mut self, line: usize, name: &[u8], file: &str, builder: &mut Builder) {
        let name = name.trim_ascii();
        if name.is_empty() {
            let text = "usemtl without a name; what follows is grey";
            builder.notes.line(file, line, "usemtl", text);
            self.name = NONE;
            return;
        }
        let known = self.names.iter().position(|known| known == name);
        self.name = known.unwrap_or_else(|| {
            self.names.push(name.to_vec());
            self.names.len() - 1
        }) as u32;
    }

    fn build(self, file: &str, libraries: &Libraries, builder: &mut Builder) -> Result<(), Fault> {
        let mut materials = Materials::new(&self.names, libraries);
        let mut vertices = Vertices::new(&self);
        let mut numbers = Vec::new();
        for (index, face) in self.faces.iter().enumerate() {
            let line = face.line as usize;
            let end = self.faces.get(index + 1);
            let end = end.map_or(self.corners.len(), |next| next.start as usize);
            let corners = &self.corners[face.start as usize..end];
            let is_placed = |corner: &[u32; 3]| (corner[1] as usize) < self.coordinates.len();
            let is_coloured = |corner: &[u32; 3]| vertices.colour(corner[0]).is_some();
            let has_places = corners.iter().all(is_placed);
            let has_colour = corners.iter().any(is_coloured);
            let material = materials.of(face.name, has_places, has_colour, file, line, builder)?;
            numbers.clear();
            for &corner in corners {
                numbers.push(vertices.number(corner, &material, file, line, builder)?);
            }
            if !builder.face(&numbers, material.number)? {
                let text =
                    "a face whose edges cross, which is drawn as triangles around its first corner";
                builder.notes.line(file, line, "cross", text);
            }
        }
        Ok(())
    }
}

/// The material of a face, as its vertices need it.
#[derive(Clone, Copy)]
struct FaceMaterial {
    number: u32,
    is_textured: bool,
    /// Whether its corners have colours; those without one are white.
    is_coloured: bool,
}

/// The vertices of faces: one for each position, pair of texture coordinates, normal and use of
/// colours that a face's corner has together.
struct Vertices<'a> {
    parts: &'a Parts,
    /// What the colours of the file are divided by.
    scale: f32,
    /// For each position the last of its vertices in `known`, or `NONE`.
    last: Vec<u32>,
    known: Vec<Known>,
}

struct Known {
    coordinates: u32,
    normal: u32,
    is_coloured: bool,
    number: u32,
    /// The one before of the same position, or `NONE`.
    before: u32,
}

impl<'a> Vertices<'a> {
    fn new(parts: &'a Parts) -> Self {
        // Some programs write colours from 0 to 255.
        let most = parts.colours.iter().flatten().fold(0.0, |most: f32, &it| most.max(it));
        Self {
            parts,
            scale: if most > 1.0 { 255.0 } else { 1.0 },
            last: vec![NONE; parts.positions.len()],
            known: Vec::with_capacity(parts.positions.len()),
        }
    }

    /// The colour that the file gives a position.
    fn colour(&self, position: u32) -> Option<[f32; 3]> {
        let colour = self.parts.colours.get(position as usize)?;
        let colour = colour.map(|channel| (channel / self.scale).clamp(0.0, 1.0));
        (!colour[0].is_nan()).then_some(colour)
    }

    fn number(
        &mut self,
        [position, mut coordinates, mut normal]: [u32; 3],
        material: &FaceMaterial,
        file: &str,
        line: usize,
        builder: &mut Builder,
    ) -> Result<u32, Fault> {
        let parts = self.parts;
        let Some(&place) = parts.positions.get(position as usize) else {
            let (number, count) = (u64::from(position) + 1, parts.positions.len());
            return Err(Fault::Line {
                line,
                what: format!(
                    "a face has the vertex {number}, but there are only {count} vertices"
                ),
            });
        };
        if normal != NONE && normal as usize >= parts.normals.len() {
            let text = format!(
                "a face has the normal {}, but there are only {}; it is drawn without it",
                u64::from(normal) + 1,
                parts.normals.len()
            );
            builder.notes.line(file, line, "normal", &text);
            normal = NONE;
        }
        if !material.is_textured {
            coordinates = NONE;
        }
        let mut at = self.last[position as usize];
        while at != NONE {
            let known = &self.known[at as usize];
            if (known.coordinates, known.normal, known.is_coloured)
                == (coordinates, normal, material.is_coloured)
            {
                return Ok(known.number);
            }
            at = known.before;
        }
        // The format counts texture coordinates from the lower edge.
        let places = parts.coordinates.get(coordinates as usize);
        let number = builder.vertex(&Vertex {
            position: place,
            normal: parts.normals.get(normal as usize).copied(),
            coordinates: places.map(|&[u, v]| [u, 1.0 - v]),
            colour: material.is_coloured.then(|| self.colour(position).unwrap_or([1.0; 3])),
        });
        let number = number.map_err(|fault| Fault::Line { line, what: fault.to_string() })?;
        self.known.push(Known {
            coordinates,
            normal,
            is_coloured: material.is_coloured,
            number,
            before: self.last[position as usize],
        });
        self.last[position as usize] = self.known.len() as u32 - 1;
        Ok(number)
    }
}

/// The first three numbers.
fn three(text: &[u8]) -> Option<DVec3> {
    let mut numbers = words(text).map(number);
    Some(DVec3::new(numbers.next()??, numbers.next()??, numbers.next()??))
}

/// The first two numbers; the second one is 0 if there is one alone.
fn two(text: &[u8]) -> Option<[f32; 2]> {
    let mut numbers = words(text).map(number);
    let first = numbers.next()?? as f32;
    let second = numbers.next().unwrap_or(Some(0.0))? as f32;
    (first.is_finite() && second.is_finite()).then_some([first, second])
}
