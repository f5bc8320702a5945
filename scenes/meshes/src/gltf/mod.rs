//! glTF 2.0 files: binary ones, and JSON with files beside it or data in it.

mod accessor;
mod container;
mod json;
mod material;
mod resource;
mod texture;

use std::borrow::Cow;
use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use glam::{DMat3, DMat4, DQuat, DVec3};
use scenes::{Light, LightKind, View};

use self::accessor::{Data, Use};
use self::json::{Primitive, Root, TextureTransform};
use self::material::Alpha;
use self::texture::Textures;
use crate::Fault;
use crate::builder::{Builder, Vertex};
use crate::colours::encoded;
use crate::mask::Mask;
use crate::texture::Decoded;

/// The most nodes inside of each other; they are walked by recursion.
const MAX_NESTING: usize = 256;
/// The alpha from which on a blended texture is drawn.
const BLENDED: f64 = 0.5;
/// How triangles are made of vertices.
const TRIANGLES: u32 = 4;
const TRIANGLE_STRIP: u32 = 5;
const TRIANGLE_FAN: u32 = 6;

/// Extensions that a file may require, beside those of materials.
const READ: [&str; 3] = ["KHR_lights_punctual", "KHR_mesh_quantization", "KHR_texture_transform"];
/// Extensions of materials, all of which may be required: what can't be drawn is left out.
const MATERIALS: &str = "KHR_materials_";
/// Extensions without which a file can't be read, with what a user can do.
const REFUSED: [(&str, &str); 7] = [
    (
        "KHR_draco_mesh_compression",
        "the meshes are compressed with Draco; export the file without compression",
    ),
    (
        "EXT_meshopt_compression",
        "the buffers are compressed with meshopt; export the file without compression",
    ),
    (
        "KHR_meshopt_compression",
        "the buffers are compressed with meshopt; export the file without compression",
    ),
    ("KHR_texture_basisu", "the textures are KTX2 pictures; convert them to PNG or JPEG"),
    ("EXT_texture_webp", "the textures are WebP pictures; convert them to PNG or JPEG"),
    ("EXT_texture_avif", "the textures are AVIF pictures; convert them to PNG or JPEG"),
    (SPECULAR_GLOSSINESS, CONVERT_SPECULAR_GLOSSINESS),
];
const SPECULAR_GLOSSINESS: &str = "KHR_materials_pbrSpecularGlossiness";
const CONVERT_SPECULAR_GLOSSINESS: &str = "the materials are of specular and glossiness; export the file with metallic-roughness materials";

pub(crate) fn read_binary(bytes: &[u8], name: &Path, builder: &mut Builder) -> Result<(), Fault> {
    let chunks = container::chunks(bytes)?;
    let root: Root =
        serde_json::from_slice(chunks.json).map_err(|error| wrong(error.to_string()))?;
    read(&root, chunks.binary, name, builder)
}

pub(crate) fn read_text(bytes: &[u8], name: &Path, builder: &mut Builder) -> Result<(), Fault> {
    let text = crate::text::without_mark(bytes).map_err(Fault::Encoding)?;
    let root: Root = serde_json::from_slice(text).map_err(|error| Fault::Line {
        line: error.line(),
        what: format!("not a valid glTF file: {error}"),
    })?;
    read(&root, None, name, builder)
}

fn wrong(what: String) -> Fault {
    Fault::Gltf(what)
}

fn read(
    root: &Root,
    binary: Option<&[u8]>,
    name: &Path,
    builder: &mut Builder,
) -> Result<(), Fault> {
    check_version(root)?;
    check_extensions(root)?;
    let folder = name.parent().unwrap_or(Path::new(""));
    let buffers = root.buffers.iter().enumerate();
    let buffers = buffers.map(|(index, buffer)| match (&buffer.uri, binary) {
        (Some(uri), _) => resource::bytes(uri, folder),
        (None, Some(binary)) if index == 0 => Ok(Cow::Borrowed(binary)),
        (None, _) => Err("it has no URI".into()),
    });
    let data = Data {
        root,
        buffers: buffers.collect(),
        is_quantised: uses(root, "KHR_mesh_quantization"),
    };
    let mut file = File {
        root,
        data: &data,
        folder,
        textures: Textures::default(),
        materials: HashMap::new(),
        seen: vec![false; root.nodes.len()],
        builder,
    };
    for &node in &file.scene()? {
        file.node(node, DMat4::IDENTITY, 0)?;
    }
    if !root.animations.is_empty() || !root.skins.is_empty() {
        file.builder.notes.add("animations and skins are ignored");
    }
    Ok(())
}

fn uses(root: &Root, extension: &str) -> bool {
    root.extensions_used.iter().any(|used| used == extension)
}

fn check_version(root: &Root) -> Result<(), Fault> {
    let version = &root.asset.version;
    if version.starts_with("2.") || version.is_empty() {
        return Ok(());
    }
    Err(wrong(format!("it has version {}; only glTF 2.0 is read", scenes::Excerpt::of(version))))
}

fn check_extensions(root: &Root) -> Result<(), Fault> {
    for extension in &root.extensions_required {
        if let Some((name, what)) = REFUSED.iter().find(|(name, _)| name == extension) {
            return Err(Fault::Extension { name, what });
        }
        if !READ.contains(&extension.as_str()) && !extension.starts_with(MATERIALS) {
            return Err(wrong(format!(
                "it requires the extension {}, which is not read",
                scenes::Excerpt::of(extension)
            )));
        }
    }
    Ok(())
}

/// A file that is being read.
struct File<'a> {
    root: &'a Root,
    data: &'a Data<'a>,
    folder: &'a Path,
    textures: Textures,
    /// By the number of a material, and whether it is drawn with its texture.
    materials: HashMap<(Option<usize>, bool), Made>,
    seen: Vec<bool>,
    builder: &'a mut Builder,
}

/// A material of a file as the builder has it.
#[derive(Clone, Copy)]
enum Made {
    /// Alpha hides all of it.
    Hidden,
    Plain(u32),
    /// With the set of texture coordinates, and what moves these.
    Textured(u32, u32, Option<TextureTransform>),
}

impl File<'_> {
    /// The nodes of the scene to show: the file's default, or the first one that has any. Without
    /// scenes, all nodes that are in no other.
    fn scene(&mut self) -> Result<Vec<usize>, Fault> {
        let scenes = &self.root.scenes;
        if scenes.is_empty() {
            let mut is_child = vec![false; self.root.nodes.len()];
            for &child in self.root.nodes.iter().flat_map(|node| &node.children) {
                if let Some(is_child) = is_child.get_mut(child) {
                    *is_child = true;
                }
            }
            let all = is_child.iter().enumerate();
            return Ok(all.filter(|(_, is)| !**is).map(|(node, _)| node).collect());
        }
        let index = self.root.scene.unwrap_or(0);
        let chosen = scenes.get(index);
        let chosen = chosen.ok_or_else(|| wrong(format!("scene {index} doesn't exist")))?;
        if !chosen.nodes.is_empty() {
            return Ok(chosen.nodes.clone());
        }
        let mut others = scenes.iter().enumerate();
        let other = others.find(|(_, scene)| !scene.nodes.is_empty());
        if let Some((number, scene)) = other {
            let note = format!("scene {index} is empty; scene {number} is shown");
            self.builder.notes.add(note);
            return Ok(scene.nodes.clone());
        }
        Ok(Vec::new())
    }

    fn node(&mut self, index: usize, outer: DMat4, nesting: usize) -> Result<(), Fault> {
        let Some(node) = self.root.nodes.get(index) else {
            return Err(wrong(format!("node {index} doesn't exist")));
        };
        if std::mem::replace(&mut self.seen[index], true) || nesting > MAX_NESTING {
            return Err(wrong(format!(
                "node {index} is in the scene twice, in itself, or in more than {MAX_NESTING} others"
            )));
        }
        let place = outer * matrix(node);
        if !place.is_finite() {
            return Err(wrong(format!("the transform of node {index} is not finite")));
        }
        if node.skin.is_some() {
            self.builder.notes.add("animations and skins are ignored");
        }
        if node.extensions.instances.is_some() {
            let note = "of nodes with instances (EXT_mesh_gpu_instancing) one is drawn";
            self.builder.notes.add(note);
        }
        if let Some(index) = node.mesh {
            let mesh = self.root.meshes.get(index);
            let mesh = mesh.ok_or_else(|| wrong(format!("mesh {index} doesn't exist")))?;
            for (number, primitive) in mesh.primitives.iter().enumerate() {
                self.primitive(primitive, place).map_err(|fault| part(fault, index, number))?;
            }
        }
        if let Some(camera) = node.camera {
            self.camera(camera, place)?;
        }
        if let Some(light) = &node.extensions.light {
            self.light(light.light, place)?;
        }
        for &child in &node.children {
            self.node(child, place, nesting + 1)?;
        }
        Ok(())
    }

    fn primitive(&mut self, primitive: &Primitive, place: DMat4) -> Result<(), Fault> {
        let mode = primitive.mode;
        if !matches!(mode, TRIANGLES | TRIANGLE_STRIP | TRIANGLE_FAN) {
            self.builder.notes.add("points and lines are ignored");
            return Ok(());
        }
        if !primitive.targets.is_empty() {
            self.builder.notes.add("morph targets are ignored");
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
        let positions: Vec<[f64; 3]> = self.data.read(positions, Use::Positions, &["VEC3"])?;
        let count = positions.len();
        let of_all = |what: &str, found: usize| match found == count {
            true => Ok(()),
            false => Err(wrong(format!("{found} {what} for {count} vertices"))),
        };
        let normals: Vec<[f64; 3]> = match attribute("NORMAL") {
            Some(normals) => self.data.read(normals, Use::Shares, &["VEC3"])?,
            None => Vec::new(),
        };
        if !normals.is_empty() {
            of_all("normals", normals.len())?;
        }
        let colours: Vec<[f64; 4]> = match attribute("COLOR_0") {
            Some(colours) => self.data.read(colours, Use::Shares, &["VEC3", "VEC4"])?,
            None => Vec::new(),
        };
        if !colours.is_empty() {
            of_all("colours", colours.len())?;
        }
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

        let linear = DMat3::from_mat4(place);
        // Normals are perpendicular to surfaces also where the scale differs between axes.
        let upright = linear.inverse().transpose();
        let upright = if upright.is_finite() { upright } else { linear };
        let mut numbers = Vec::with_capacity(count);
        for (index, &position) in positions.iter().enumerate() {
            let normal = normals.get(index).map(|&normal| upright * DVec3::from(normal));
            let colour = colours.get(index);
            numbers.push(self.builder.vertex(&Vertex {
                position: place.transform_point3(position.into()),
                // NaN has no direction, and would become a normal of 0.
                normal: normal.map(|it| {
                    scenes::unit(it).unwrap_or(if it.is_nan() { it } else { DVec3::ZERO })
                }),
                coordinates: places.get(index).copied(),
                colour: colour.map(|&[red, green, blue, _]| {
                    [red, green, blue].map(|it| encoded(it.clamp(0.0, 1.0)) as f32)
                }),
            })?);
        }
        // A mirrored mesh is wound the other way.
        let mirrored = linear.determinant() < 0.0;
        for (face, [a, b, c]) in faces(mode, &corners).enumerate() {
            let corners = if mirrored { [a, c, b] } else { [a, b, c] };
            let mut found = [0; 3];
            for (found, index) in found.iter_mut().zip(corners) {
                let number = numbers.get(index as usize);
                *found = *number.ok_or(Fault::Vertex { face, index, vertices: count })?;
            }
            self.builder.triangle(found, material)?;
        }
        Ok(())
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

    fn material(&mut self, index: Option<usize>, with_texture: bool) -> Result<Made, Fault> {
        if let Some(&known) = self.materials.get(&(index, with_texture)) {
            return Ok(known);
        }
        let otherwise = json::Material::default();
        let material = match index {
            None => &otherwise,
            Some(index) => {
                let found = self.root.materials.get(index);
                found.ok_or_else(|| wrong(format!("material {index} doesn't exist")))?
            }
        };
        let made = self.make(material, with_texture)?;
        self.materials.insert((index, with_texture), made);
        Ok(made)
    }

    fn make(&mut self, material: &json::Material, with_texture: bool) -> Result<Made, Fault> {
        if material.extensions.specular_glossiness.is_some() {
            return Err(Fault::Extension {
                name: SPECULAR_GLOSSINESS,
                what: CONVERT_SPECULAR_GLOSSINESS,
            });
        }
        let mut found = material::of(material, &mut self.builder.notes);
        self.builder.two_sided |= material.double_sided;
        let model = &material.pbr_metallic_roughness;
        let factor = model.base_color_factor[3];
        let alpha = Alpha::of(material);
        let info = model.base_color_texture.as_ref().filter(|_| with_texture);
        let texture = info.and_then(|info| {
            let texture = self.textures.of(info, self.data, self.folder, self.builder);
            Some((info, texture?))
        });
        let Some((info, Decoded { texture, alpha: holes, .. })) = texture else {
            return Ok(match alpha {
                Alpha::Mask(limit) if factor < limit => Made::Hidden,
                _ => Made::Plain(self.builder.material(found, None)?),
            });
        };
        let limits = match alpha {
            Alpha::Opaque => None,
            Alpha::Mask(limit) => Some((factor, limit)),
            Alpha::Blend => Some((1.0, BLENDED)),
        };
        let mask = match (holes, limits) {
            (Some(holes), Some((factor, limit))) => {
                let wrap = texture.wrap();
                let mask = Mask::new(texture.width(), &holes, factor, limit, wrap);
                Some(Arc::new(mask)).filter(|mask| !mask.is_whole())
            }
            (None, Some((factor, limit))) if factor < limit => return Ok(Made::Hidden),
            _ => None,
        };
        if mask.is_some() && alpha == Alpha::Blend {
            let note = "blended textures have holes where their alpha is below 1/2, and are opaque elsewhere";
            self.builder.notes.add(note);
        }
        found.texture = Some(texture);
        let number = self.builder.material(found, mask)?;
        let transform = info.extensions.transform;
        let set = transform.and_then(|it| it.tex_coord);
        Ok(Made::Textured(number, set.unwrap_or(info.tex_coord), transform))
    }

    /// Takes the file's first camera as the view.
    fn camera(&mut self, index: usize, place: DMat4) -> Result<(), Fault> {
        let camera = self.root.cameras.get(index);
        let camera = camera.ok_or_else(|| wrong(format!("camera {index} doesn't exist")))?;
        if self.builder.view.is_some() {
            self.builder.notes.add("only the first camera is used");
            return Ok(());
        }
        let Some(lens) = &camera.perspective else {
            self.builder.notes.add("orthographic cameras are ignored");
            return Ok(());
        };
        let from = place.transform_point3(DVec3::ZERO);
        let view = View {
            from,
            at: from + place.transform_vector3(DVec3::NEG_Z),
            up: place.transform_vector3(DVec3::Y),
            angle: lens.yfov.to_degrees(),
            hither: 0.0,
            resolution: match lens.aspect_ratio {
                Some(aspect) if (0.1..=10.0).contains(&aspect) => {
                    (((512.0 * aspect).round() as u32).max(1), 512)
                }
                _ => (512, 512),
            },
        };
        if view.camera(view.resolution.0, view.resolution.1).is_ok() {
            self.builder.view = Some(view);
        } else {
            let note = "a camera shows nothing, and is ignored";
            self.builder.notes.add(note);
        }
        Ok(())
    }

    /// Adds a light. glTF states luminous intensities, which need a camera's exposure to become
    /// colours, and they fall with the distance. Here a light has its colour's brightness
    /// everywhere, unless it has a range.
    fn light(&mut self, index: usize, place: DMat4) -> Result<(), Fault> {
        let lights = &self.root.extensions.lights.lights;
        let light = lights.get(index);
        let light = light.ok_or_else(|| wrong(format!("light {index} doesn't exist")))?;
        if light.intensity <= 0.0 {
            return Ok(());
        }
        let position = place.transform_point3(DVec3::ZERO);
        let range = light.range.unwrap_or(f64::INFINITY);
        if range <= 0.0 {
            return Err(wrong(format!(
                "light {index}: the range is {range}, which is not above 0"
            )));
        }
        let kind = match light.kind.as_str() {
            "directional" => LightKind::Directional { to_light: place.transform_vector3(DVec3::Z) },
            "point" => LightKind::Point { position, range },
            "spot" => {
                let note = "spot lights shine in all directions";
                self.builder.notes.add(note);
                LightKind::Point { position, range }
            }
            other => {
                let note = format!("lights of the type {} are ignored", scenes::Excerpt::of(other));
                self.builder.notes.add(note);
                return Ok(());
            }
        };
        if let LightKind::Directional { to_light } = kind
            && scenes::unit(to_light).is_none()
        {
            return Ok(());
        }
        let note = "lights have their colours, but not their intensities";
        self.builder.notes.add(note);
        let colour = light.color.map(|it| it.clamp(0.0, 1.0));
        self.builder.lights.push(Light { line: 0, kind, colour: Some(colour.into()) });
        Ok(())
    }
}

/// Names the part of the file that has a fault.
fn part(fault: Fault, mesh: usize, primitive: usize) -> Fault {
    match fault {
        Fault::TooManyTriangles
        | Fault::TooManyVertices
        | Fault::TooManyMaterials
        | Fault::Extension { .. } => fault,
        Fault::Gltf(what) => wrong(format!("mesh {mesh}, primitive {primitive}: {what}")),
        _ => wrong(format!("mesh {mesh}, primitive {primitive}: {fault}")),
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

fn matrix(node: &json::Node) -> DMat4 {
    if let Some(matrix) = &node.matrix {
        return DMat4::from_cols_array(matrix);
    }
    let rotation = DQuat::from_array(node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]));
    let rotation = if rotation.length_squared() > 0.0 && rotation.is_finite() {
        rotation.normalize()
    } else {
        DQuat::IDENTITY
    };
    DMat4::from_scale_rotation_translation(
        node.scale.unwrap_or([1.0; 3]).into(),
        rotation,
        node.translation.unwrap_or_default().into(),
    )
}
