//! glTF 2.0 files: binary ones, and JSON with files beside it or data in it.

mod accessor;
mod animation;
mod container;
mod json;
mod material;
mod nodes;
mod part;
mod primitive;
mod resource;
mod sampler;
mod texture;

use std::borrow::Cow;
use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use glam::{DMat4, DVec3};
use scenes::{Light, LightKind, View};

use self::accessor::Data;
pub use self::animation::Animation;
use self::animation::Channels;
pub(crate) use self::animation::NONE;
use self::json::{Root, TextureTransform};
use self::material::Alpha;
use self::nodes::Nodes;
use self::part::{Part, Skin};
use self::texture::Textures;
use crate::builder::Builder;
use crate::mask::Mask;
use crate::texture::Decoded;
use crate::{Fault, Loaded};

/// The alpha from which on a blended texture is drawn.
const BLENDED: f64 = 0.5;

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

/// Reads a binary file, with its `animation` of this name or number.
pub(crate) fn read_binary(
    bytes: &[u8],
    name: &Path,
    animation: Option<&str>,
) -> Result<Loaded, Fault> {
    let chunks = container::chunks(bytes)?;
    let root: Root =
        serde_json::from_slice(chunks.json).map_err(|error| wrong(error.to_string()))?;
    read(&root, chunks.binary, name, animation)
}

/// The same for a file of text.
pub(crate) fn read_text(
    bytes: &[u8],
    name: &Path,
    animation: Option<&str>,
) -> Result<Loaded, Fault> {
    let text = crate::text::without_mark(bytes).map_err(Fault::Encoding)?;
    let root: Root = serde_json::from_slice(text).map_err(|error| Fault::Line {
        line: error.line(),
        what: format!("not a valid glTF file: {error}"),
    })?;
    read(&root, None, name, animation)
}

fn wrong(what: String) -> Fault {
    Fault::Gltf(what)
}

fn read(
    root: &Root,
    binary: Option<&[u8]>,
    name: &Path,
    animation: Option<&str>,
) -> Result<Loaded, Fault> {
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
    let mut builder = Builder::default();
    let scene = scene(root, &mut builder)?;
    let mut nodes = Nodes::new(root, &scene)?;
    let channels = Channels::read(&data, animation, &mut builder.notes)?;
    channels.set(&mut nodes, 0.0);
    builder.two_sided = channels.mirror();
    builder.keeps_vertices = !channels.are_none();
    let [moved, morphed] = channels.moved(&nodes);
    let mut file = File {
        root,
        data: &data,
        folder,
        textures: Textures::default(),
        materials: HashMap::new(),
        nodes: &nodes,
        moved,
        morphed,
        morphed_items: 0,
        skins: vec![None; root.skins.len()],
        parts: Vec::new(),
        builder: &mut builder,
    };
    for node in nodes.of_scene() {
        file.node(node)?;
    }
    let File { mut skins, parts, .. } = file;
    let cuts = std::mem::take(&mut builder.cuts);
    if !channels.are_none() && parts.is_empty() {
        builder.notes.add("the animation moves no triangles");
    }
    builder.reach = channels.reach(&mut nodes, &mut skins, &parts);
    let mut loaded = builder.finish(&name.display().to_string())?;
    if let Some(mesh) = loaded.scene.mesh.as_mut().filter(|_| !parts.is_empty()) {
        let parts = (nodes, skins, parts);
        loaded.animation = Some(Animation::new(channels, parts, cuts, Arc::make_mut(mesh)));
    }
    Ok(loaded)
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

/// The nodes of the scene to show: the file's default, or the first one that has any. Without
/// scenes, all nodes that are in no other.
fn scene(root: &Root, builder: &mut Builder) -> Result<Vec<usize>, Fault> {
    let scenes = &root.scenes;
    if scenes.is_empty() {
        return Ok(nodes::tops(root));
    }
    let index = root.scene.unwrap_or(0);
    let chosen = scenes.get(index);
    let chosen = chosen.ok_or_else(|| wrong(format!("scene {index} doesn't exist")))?;
    if !chosen.nodes.is_empty() {
        return Ok(chosen.nodes.clone());
    }
    let mut others = scenes.iter().enumerate();
    let other = others.find(|(_, scene)| !scene.nodes.is_empty());
    if let Some((number, scene)) = other {
        let note = format!("scene {index} is empty; scene {number} is shown");
        builder.notes.add(note);
        return Ok(scene.nodes.clone());
    }
    Ok(Vec::new())
}

/// A file that is being read.
struct File<'a> {
    root: &'a Root,
    data: &'a Data<'a>,
    folder: &'a Path,
    textures: Textures,
    /// By the number of a material, and whether it is drawn with its texture.
    materials: HashMap<(Option<usize>, bool), Made>,
    nodes: &'a Nodes,
    /// The nodes that the animation moves, and those whose morph targets it does.
    moved: Vec<bool>,
    morphed: Vec<bool>,
    /// Positions and normals of morph targets so far.
    morphed_items: usize,
    /// Those that a node has.
    skins: Vec<Option<Skin>>,
    /// Those that the animation moves.
    parts: Vec<Part>,
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
    fn node(&mut self, index: usize) -> Result<(), Fault> {
        let (node, place) = (&self.root.nodes[index], self.nodes.places[index]);
        if !place.is_finite() {
            return Err(wrong(format!("the transform of node {index} is not finite")));
        }
        if node.extensions.instances.is_some() {
            let note = "of nodes with instances (EXT_mesh_gpu_instancing) one is drawn";
            self.builder.notes.add(note);
        }
        if let Some(number) = node.mesh {
            let mesh = self.root.meshes.get(number);
            let mesh = mesh.ok_or_else(|| wrong(format!("mesh {number} doesn't exist")))?;
            for (part, primitive) in mesh.primitives.iter().enumerate() {
                self.primitive(index, primitive)
                    .map_err(|fault| within(&format!("mesh {number}, primitive {part}"), fault))?;
            }
        }
        if self.moved[index] && (node.camera.is_some() || node.extensions.light.is_some()) {
            self.builder.notes.add("the animation moves no cameras and no lights");
        }
        if let Some(camera) = node.camera {
            self.camera(camera, place)?;
        }
        if let Some(light) = &node.extensions.light {
            self.light(light.light, place)?;
        }
        Ok(())
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
fn within(part: &str, fault: Fault) -> Fault {
    match fault {
        Fault::TooManyTriangles
        | Fault::TooManyVertices
        | Fault::TooManyMaterials
        | Fault::Extension { .. } => fault,
        Fault::Gltf(what) => wrong(format!("{part}: {what}")),
        _ => wrong(format!("{part}: {fault}")),
    }
}
