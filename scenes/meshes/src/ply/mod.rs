//! PLY files, in text and binary of both byte orders.

mod data;
mod header;

use std::path::Path;

use glam::DVec3;

use self::data::Values;
use self::header::{Element, Header, Property};
use crate::Fault;
use crate::builder::{Builder, Vertex};
use crate::texture::decode;

/// The names that texture coordinates have.
const COORDINATES: [[&str; 2]; 3] = [["s", "t"], ["u", "v"], ["texture_u", "texture_v"]];
/// What begins the comment that names a texture.
const TEXTURE: &str = "TextureFile";

pub(crate) fn read(bytes: &[u8], name: &Path, builder: &mut Builder) -> Result<(), Fault> {
    let (header, start) = Header::parse(bytes)?;
    // The format doesn't specify whether surfaces have a back.
    builder.two_sided = true;
    let mut values = Values::new(bytes, start, header.encoding);
    let mut file = File { columns: Columns::default(), vertices: Vec::new(), faces: Vec::new() };
    for element in &header.elements {
        match element.name.as_str() {
            "vertex" => file.read_vertices(element, &mut values)?,
            "face" => file.read_faces(element, &mut values)?,
            "tristrips" | "tristrip" => file.read_strips(element, &mut values)?,
            _ => {
                let mut ignored = Vec::new();
                for _ in 0..element.count {
                    values.row(element, &mut ignored)?;
                }
            }
        }
    }
    file.build(&header, name, builder)
}

/// Where a vertex has its numbers.
#[derive(Default)]
struct Columns {
    normal: Option<[usize; 3]>,
    colour: Option<[usize; 3]>,
    colour_scale: f64,
    coordinates: Option<[usize; 2]>,
}

struct File {
    columns: Columns,
    vertices: Vec<Vertex>,
    faces: Vec<Face>,
}

/// A face; its number in its element is for messages.
struct Face {
    number: usize,
    corners: Vec<f64>,
    /// Texture coordinates of its corners, in pairs, or none.
    coordinates: Vec<f64>,
    colour: Option<[f32; 3]>,
}

/// The columns of numbers with these names.
fn columns<const N: usize>(element: &Element, names: [&str; N]) -> Option<[usize; N]> {
    let mut found = [0; N];
    for (place, name) in found.iter_mut().zip(names) {
        let is_it = |property: &Property| property.name == name && property.list.is_none();
        *place = element.properties.iter().position(is_it)?;
    }
    Some(found)
}

/// The columns of colours, and what divides them.
fn colour_columns(element: &Element) -> (Option<[usize; 3]>, f64) {
    let names = [
        ["red", "green", "blue"],
        ["diffuse_red", "diffuse_green", "diffuse_blue"],
        ["r", "g", "b"],
    ];
    let found = names.into_iter().find_map(|names| columns(element, names));
    let scale = found.map_or(1.0, |[red, ..]| element.properties[red].kind.most());
    (found, scale)
}

/// The list with one of these names.
fn list(element: &Element, names: &[&str]) -> Option<usize> {
    let mut properties = element.properties.iter();
    properties.position(|it| it.list.is_some() && names.contains(&it.name.as_str()))
}

fn pick<const N: usize>(row: &[Vec<f64>], columns: [usize; N]) -> [f64; N] {
    columns.map(|column| row[column].first().copied().unwrap_or_default())
}

fn colour(row: &[Vec<f64>], columns: Option<[usize; 3]>, scale: f64) -> Option<[f32; 3]> {
    let channels = pick(row, columns?);
    Some(channels.map(|it| (it / scale).clamp(0.0, 1.0) as f32))
}

impl File {
    fn read_vertices(&mut self, element: &Element, values: &mut Values<'_>) -> Result<(), Fault> {
        let Some(position) = columns(element, ["x", "y", "z"]) else {
            return Err(Fault::Ply("its vertices lack x, y or z".into()));
        };
        let (colour_columns, colour_scale) = colour_columns(element);
        self.columns = Columns {
            normal: columns(element, ["nx", "ny", "nz"]),
            colour: colour_columns,
            colour_scale,
            coordinates: COORDINATES.into_iter().find_map(|it| columns(element, it)),
        };
        let mut row = Vec::new();
        for _ in 0..element.count {
            values.row(element, &mut row)?;
            let places = self.columns.coordinates.map(|columns| pick(&row, columns));
            self.vertices.push(Vertex {
                position: DVec3::from(pick(&row, position)),
                normal: self.columns.normal.map(|it| DVec3::from(pick(&row, it))),
                // The lower edge is 0.
                coordinates: places.map(|[u, v]| [u as f32, 1.0 - v as f32]),
                colour: colour(&row, self.columns.colour, self.columns.colour_scale),
            });
        }
        Ok(())
    }

    fn read_faces(&mut self, element: &Element, values: &mut Values<'_>) -> Result<(), Fault> {
        let corners = list(element, &["vertex_indices", "vertex_index"]);
        let coordinates = list(element, &["texcoord"]);
        let (columns, scale) = colour_columns(element);
        let mut row = Vec::new();
        for number in 0..element.count {
            values.row(element, &mut row)?;
            self.faces.push(Face {
                number,
                corners: corners.map_or(Vec::new(), |it| std::mem::take(&mut row[it])),
                coordinates: coordinates.map_or(Vec::new(), |it| std::mem::take(&mut row[it])),
                colour: colour(&row, columns, scale),
            });
        }
        Ok(())
    }

    /// Strips of triangles; -1 begins another strip.
    fn read_strips(&mut self, element: &Element, values: &mut Values<'_>) -> Result<(), Fault> {
        let corners = list(element, &["vertex_indices", "vertex_index"]);
        let mut row = Vec::new();
        for number in 0..element.count {
            values.row(element, &mut row)?;
            let strips = corners.map_or(&[][..], |it| &row[it]);
            for strip in strips.split(|&index| index == -1.0) {
                for (turn, triangle) in strip.windows(3).enumerate() {
                    let [a, b, c] = [triangle[0], triangle[1], triangle[2]];
                    let corners = if turn % 2 == 0 { [a, b, c] } else { [b, a, c] };
                    // Strips are lengthened by repeated corners.
                    if a != b && b != c && c != a {
                        self.faces.push(Face {
                            number,
                            corners: corners.to_vec(),
                            coordinates: Vec::new(),
                            colour: None,
                        });
                    }
                }
            }
        }
        Ok(())
    }

    fn build(self, header: &Header, name: &Path, builder: &mut Builder) -> Result<(), Fault> {
        let faces_have_places = self.faces.iter().any(|face| !face.coordinates.is_empty());
        let has_places = self.columns.coordinates.is_some() || faces_have_places;
        let texture = match header.texture.as_ref().filter(|_| has_places) {
            Some(file) => texture(file, name, builder),
            None => None,
        };
        let faces_have_colours = self.faces.iter().any(|face| face.colour.is_some());
        let has_colours = self.columns.colour.is_some() || faces_have_colours;
        let grey = if has_colours || texture.is_some() { 1.0 } else { 0.8 };
        let material = scenes::Material { texture, ..scenes::Material::matte(DVec3::splat(grey)) };
        let is_textured = material.texture.is_some();
        let material = builder.material(material, None)?;

        let count = self.vertices.len();
        let of_faces = (faces_have_places && is_textured) || faces_have_colours;
        let mut added = vec![None; count];
        let mut numbers = Vec::new();
        let (mut short, mut crossed) = (0, 0);
        for face in &self.faces {
            numbers.clear();
            for (place, &corner) in face.corners.iter().enumerate() {
                let index = corner as i64;
                let known = usize::try_from(index).ok().filter(|it| *it < count);
                let Some(vertex) = known.filter(|_| corner.fract() == 0.0) else {
                    return Err(Fault::Vertex {
                        face: face.number,
                        index: corner,
                        vertices: count,
                    });
                };
                // Vertices of no face are left out: scanners write NaN where they see nothing.
                if let Some(number) = added[vertex].filter(|_| !of_faces) {
                    numbers.push(number);
                    continue;
                }
                let mut own = self.vertices[vertex];
                if let Some(&[u, v]) = face.coordinates.get(2 * place..2 * place + 2) {
                    own.coordinates = Some([u as f32, 1.0 - v as f32]);
                }
                own.colour = face.colour.or(own.colour);
                let number = builder.vertex(&own)?;
                added[vertex] = Some(number);
                numbers.push(number);
            }
            if (1..3).contains(&numbers.len()) {
                short += 1;
            }
            if !builder.face(&numbers, material)? {
                crossed += 1;
            }
        }
        if short > 0 {
            let note = format!("{short} faces of one or two corners are ignored");
            builder.notes.add(note);
        }
        if crossed > 0 {
            builder.notes.add(format!(
                "the edges of {crossed} faces cross; each is drawn as triangles around its first corner"
            ));
        }
        Ok(())
    }
}

/// The texture that a comment names; if there is none, a note gives the reason.
fn texture(
    file: &str,
    name: &Path,
    builder: &mut Builder,
) -> Option<std::sync::Arc<scenes::Texture>> {
    let path = name.parent().unwrap_or(Path::new("")).join(file);
    let bytes = crate::bytes(&path).map_err(|fault| fault.to_string());
    match bytes.and_then(|bytes| decode(&bytes, [scenes::Wrap::Repeat; 2])) {
        Ok(found) => {
            if let Some(note) = found.note {
                builder.notes.add(format!("the texture {file}: {note}"));
            }
            Some(found.texture)
        }
        Err(what) => {
            let note = format!("the texture {file}: {what}; surfaces are drawn without it");
            builder.notes.add(note);
            None
        }
    }
}
