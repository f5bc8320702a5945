//! Primitives: their triangles become those of the scene's mesh.

use super::accessor::Use;
use super::json::{Primitive, TextureTransform};
use super::part::{Part, Skin, check_count};
use super::{File, Made, REFUSED, wrong};
use crate::Fault;
use crate::builder::Vertex;
use crate::colours::encoded;

/// How triangles are made of vertices.
const TRIANGLES: u32 = 4;
const TRIANGLE_STRIP: u32 = 5;
const TRIANGLE_FAN: u32 = 6;

impl File<'_> {
    /// Adds the triangles of a primitive of a node's mesh.
    pub(super) fn primitive(&mut self, node: usize, primitive: &Primitive) -> Result<(), Fault> {
        let mode = primitive.mode;
        if !matches!(mode, TRIANGLES | TRIANGLE_STRIP | TRIANGLE_FAN) {
            self.builder.notes.add("points and lines are ignored");
            return Ok(());
        }
        let attribute = |name: &str| primitive.attributes.get(name).copied();
        let Some(positions) = attribute("POSITION") else {
            return Ok(());
        };
        let has_view = |accessor: usize| {
            let accessor = self.root.accessors.get(accessor);
            accessor.is_some_and(|it| it.buffer_view.is_some() || it.sparse.is_some())
        };
        if primitive.extensions.draco.is_some() && !has_view(positions) {
            let (name, what) = REFUSED[0];
            return Err(Fault::Extension { name, what });
        }
        let made = self.material(primitive.material, true)?;
        let place = (node, self.nodes);
        let mut part = Part::read(self.data, primitive, positions, place, &mut self.morphed_items)?;
        if let Some(index) = self.root.nodes[node].skin {
            part.bind(self.data, primitive, (index, self.skin(index)?))?;
            if attribute("JOINTS_1").is_some() {
                self.builder.notes.add("of more than four joints of a vertex, four move it");
            }
        }
        let count = part.len();
        let colours: Vec<[f64; 4]> = match attribute("COLOR_0") {
            Some(colours) => {
                check_count(self.data, colours, "colours", count)?;
                self.data.read(colours, Use::Shares, &["VEC3", "VEC4"])?
            }
            None => Vec::new(),
        };
        let (material, places) = match made {
            Made::Hidden => return Ok(()),
            Made::Plain(number) => (number, Vec::new()),
            Made::Textured(number, set, transform) => {
                match self.places(attribute(&format!("TEXCOORD_{set}")), count, transform)? {
                    Some(places) => (number, places),
                    None => match self.material(primitive.material, false)? {
                        Made::Plain(number) => (number, Vec::new()),
                        _ => return Ok(()),
                    },
                }
            }
        };
        let corners: Vec<f64> = match primitive.indices {
            Some(indices) => {
                let indices = self.data.read::<1>(indices, Use::Indices, &["SCALAR"])?;
                indices.into_iter().map(|[index]| index).collect()
            }
            None => (0..count).map(|index| index as f64).collect(),
        };

        let mut numbers = Vec::with_capacity(count);
        let mut vertices = Vec::with_capacity(count);
        part.vertices(self.nodes, &self.skins, |position, normal| {
            vertices.push((position, normal));
        });
        for (index, (position, normal)) in vertices.into_iter().enumerate() {
            numbers.push(self.builder.vertex(&Vertex {
                position,
                normal,
                coordinates: places.get(index).copied(),
                colour: colours.get(index).map(|&[red, green, blue, _]| {
                    [red, green, blue].map(|it| encoded(it.clamp(0.0, 1.0)) as f32)
                }),
            })?);
        }
        // A mirrored mesh is wound the other way.
        let mirrored = part.is_mirrored(self.nodes, &self.skins);
        for (face, [a, b, c]) in faces(mode, &corners).enumerate() {
            let corners = if mirrored { [a, c, b] } else { [a, b, c] };
            let mut found = [0; 3];
            for (found, index) in found.iter_mut().zip(corners) {
                let number = numbers.get(index as usize);
                *found = *number.ok_or(Fault::Vertex { face, index, vertices: count })?;
            }
            self.builder.triangle(found, material)?;
        }
        if part.is_moved(&self.moved, &self.skins, &self.morphed) {
            part.first = numbers.first().map_or(0, |&first| first as usize);
            self.parts.push(part);
        }
        Ok(())
    }

    /// A skin of the file, read once.
    fn skin(&mut self, index: usize) -> Result<&Skin, Fault> {
        let missing = || wrong(format!("skin {index} doesn't exist"));
        let known = self.skins.get_mut(index).ok_or_else(missing)?;
        match known {
            Some(known) => Ok(known),
            None => Ok(known.insert(Skin::read(self.data, index, self.nodes)?)),
        }
    }

    /// The texture coordinates of vertices, moved; `None`, with a note, if they lack them.
    fn places(
        &mut self,
        accessor: Option<usize>,
        count: usize,
        transform: Option<TextureTransform>,
    ) -> Result<Option<Vec<[f32; 2]>>, Fault> {
        let places: Vec<[f64; 2]> = match accessor {
            Some(accessor) => self.data.read(accessor, Use::Shares, &["VEC2"])?,
            None => Vec::new(),
        };
        if places.len() != count {
            let note = "parts with a texture, but without texture coordinates, are drawn without the texture";
            self.builder.notes.add(note);
            return Ok(None);
        }
        let transform = transform.unwrap_or_default();
        let (sine, cosine) = (libm::sin(transform.rotation), libm::cos(transform.rotation));
        let [offset_u, offset_v] = transform.offset;
        let moved = |[u, v]: [f64; 2]| {
            let (u, v) = (transform.scale[0] * u, transform.scale[1] * v);
            let turned = [cosine * u + sine * v, cosine * v - sine * u];
            [(turned[0] + offset_u) as f32, (turned[1] + offset_v) as f32]
        };
        Ok(Some(places.into_iter().map(moved).collect()))
    }
}

/// The triangles of a list of vertices.
fn faces(mode: u32, corners: &[f64]) -> Box<dyn Iterator<Item = [f64; 3]> + '_> {
    let rest = corners.get(1..).unwrap_or_default();
    match mode {
        TRIANGLE_STRIP => Box::new(corners.windows(3).enumerate().map(|(index, it)| {
            if index % 2 == 0 { [it[0], it[1], it[2]] } else { [it[1], it[0], it[2]] }
        })),
        TRIANGLE_FAN => Box::new(rest.windows(2).map(|it| [corners[0], it[0], it[1]])),
        _ => Box::new(corners.chunks_exact(3).map(|it| [it[0], it[1], it[2]])),
    }
}
