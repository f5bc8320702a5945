//! PLY files, in text and binary of both byte orders.

use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};

use crate::Fault;
use crate::builder::Builder;

pub(crate) fn read(bytes: &[u8], builder: &mut Builder) -> Result<(), Fault> {
    let mut reader = Reader::new(bytes);
    let vertices = Parser::<Vertex>::new();
    let header = vertices.read_header(&mut reader).map_err(wrong)?;
    let (faces, others) = (Parser::<Face>::new(), Parser::<Other>::new());
    // The format doesn't say whether surfaces have a back.
    builder.two_sided = true;
    let mut found = Vec::new();
    for (name, element) in &header.elements {
        match name.as_str() {
            "vertex" => {
                let names: Vec<&str> = element.properties.keys().map(String::as_str).collect();
                let has = |wanted: [&str; 3]| wanted.iter().all(|name| names.contains(name));
                if !has(["x", "y", "z"]) {
                    return Err(Fault::Ply("its vertices lack x, y or z".into()));
                }
                if has(["red", "green", "blue"]) {
                    builder.note("colours of vertices are ignored");
                }
                let list = vertices.read_payload_for_element(&mut reader, element, &header);
                let list = list.map_err(wrong)?;
                let normals = list.iter().map(|vertex| vertex.normal);
                let count = if has(["nx", "ny", "nz"]) {
                    list.len()
                } else {
                    0
                };
                builder.add_vertices(
                    list.iter().map(|vertex| vertex.position),
                    normals.take(count),
                    [],
                )?;
            }
            "face" => {
                let list = faces.read_payload_for_element(&mut reader, element, &header);
                found = list.map_err(wrong)?;
            }
            _ => {
                let list = others.read_payload_for_element(&mut reader, element, &header);
                list.map_err(wrong)?;
            }
        }
    }
    for (index, face) in found.iter().enumerate() {
        builder.face(index, 0, &face.corners, 0)?;
    }
    Ok(())
}

fn wrong(error: impl std::fmt::Display) -> Fault {
    Fault::Ply(error.to_string())
}

#[derive(Default)]
struct Vertex {
    position: [f32; 3],
    normal: [f32; 3],
}

impl Vertex {
    fn set(&mut self, name: &str, value: f32) -> PropertyAccessResult {
        let place = match name {
            "x" => &mut self.position[0],
            "y" => &mut self.position[1],
            "z" => &mut self.position[2],
            "nx" => &mut self.normal[0],
            "ny" => &mut self.normal[1],
            "nz" => &mut self.normal[2],
            _ => return PropertyAccessResult::Ignored,
        };
        *place = value;
        PropertyAccessResult::Set
    }
}

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        match property.to_f32_lossy() {
            Some(value) => self.set(name, value),
            None => PropertyAccessResult::Ignored,
        }
    }

    fn set_float(&mut self, name: &str, value: f32) -> PropertyAccessResult {
        self.set(name, value)
    }
}

#[derive(Default)]
struct Face {
    corners: Vec<i64>,
}

impl PropertyAccess for Face {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if !matches!(name, "vertex_indices" | "vertex_index") {
            return PropertyAccessResult::Ignored;
        }
        self.corners = match property {
            Property::ListChar(list) => list.into_iter().map(i64::from).collect(),
            Property::ListUChar(list) => list.into_iter().map(i64::from).collect(),
            Property::ListShort(list) => list.into_iter().map(i64::from).collect(),
            Property::ListUShort(list) => list.into_iter().map(i64::from).collect(),
            Property::ListInt(list) => list.into_iter().map(i64::from).collect(),
            Property::ListUInt(list) => list.into_iter().map(i64::from).collect(),
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

/// An element that is not needed.
struct Other;

impl PropertyAccess for Other {
    fn new() -> Self {
        Self
    }
}
