//! Binary glTF 2.0 files.
//!
//! The crate `gltf` reads the container and checks the JSON. Its accessors panic on some numbers
//! that this check lets pass, so [`accessor`] reads the buffer instead.

mod accessor;
mod material;
mod texture;

use glam::{DMat3, DMat4, DQuat, DVec3};
use gltf::binary::Glb;
use gltf::json::Root;
use gltf::json::camera::Type as CameraType;
use gltf::json::extensions::scene::khr_lights_punctual::Type as LightType;
use gltf::json::validation::Checked;
use gltf::mesh::Mode;
use gltf::scene::Transform;
use gltf::{Document, Node, Primitive, Semantic};
use nff::{Light, LightKind, View};

use self::texture::Textures;
use crate::Fault;
use crate::builder::Builder;

/// Bytes of the container's header.
const HEADER: usize = 12;
/// The most nodes inside of each other; they are walked by recursion.
const MAX_NESTING: usize = 256;

pub(crate) fn read(bytes: &[u8], builder: &mut Builder) -> Result<(), Fault> {
    check_length(bytes)?;
    let damaged = |error: gltf::Error| wrong(error.to_string());
    let Glb { json, bin, .. } = Glb::from_slice(bytes).map_err(damaged)?;
    let json = Root::from_slice(&json).map_err(|error| wrong(error.to_string()))?;
    check_accessors(&json)?;
    let document = Document::from_json(json).map_err(damaged)?;
    check_kinds(&document)?;
    let mut file = File {
        blob: bin.as_deref().unwrap_or_default(),
        textures: Textures::new(document.as_json(), bin.as_deref().unwrap_or_default()),
        materials: vec![None; document.materials().len() + 1],
        seen: vec![false; document.nodes().len()],
        builder,
    };
    let scene = document
        .default_scene()
        .or_else(|| document.scenes().next());
    let Some(scene) = scene else {
        return Err(wrong("it has no scene".into()));
    };
    for node in scene.nodes() {
        file.node(&node, DMat4::IDENTITY, 0)?;
    }
    if document.animations().len() > 0 || document.skins().len() > 0 {
        file.builder.note("animations and skins are ignored");
    }
    Ok(())
}

fn wrong(what: String) -> Fault {
    Fault::Glb(what)
}

/// Checks the length that the header states.
fn check_length(bytes: &[u8]) -> Result<(), Fault> {
    if !bytes.starts_with(b"glTF") {
        return Err(wrong("it doesn't begin with \"glTF\"".into()));
    }
    let Some(length) = bytes.get(8..HEADER) else {
        return Err(wrong(format!(
            "it has {} bytes, less than a header",
            bytes.len()
        )));
    };
    let length = length
        .iter()
        .rev()
        .fold(0, |sum, &byte| sum << 8 | usize::from(byte));
    if length < HEADER || length > bytes.len() {
        let there = bytes.len();
        return Err(wrong(format!(
            "its header states {length} bytes, but it has {there}"
        )));
    }
    Ok(())
}

/// Checks that the accessors of vertices exist, which `gltf`'s own check takes for granted.
fn check_accessors(json: &Root) -> Result<(), Fault> {
    for (index, mesh) in json.meshes.iter().enumerate() {
        for primitive in &mesh.primitives {
            let mut accessors = primitive.attributes.values();
            if accessors.any(|accessor| accessor.value() >= json.accessors.len()) {
                return Err(wrong(format!(
                    "mesh {index} has an accessor that doesn't exist"
                )));
            }
        }
    }
    Ok(())
}

/// Checks what `gltf` reads without a check.
fn check_kinds(document: &Document) -> Result<(), Fault> {
    let json = document.as_json();
    for (index, camera) in json.cameras.iter().enumerate() {
        let is_there = match camera.type_ {
            Checked::Valid(CameraType::Perspective) => camera.perspective.is_some(),
            Checked::Valid(CameraType::Orthographic) => camera.orthographic.is_some(),
            Checked::Invalid => false,
        };
        if !is_there {
            return Err(wrong(format!("camera {index} lacks its projection")));
        }
    }
    let lights = json
        .extensions
        .as_ref()
        .and_then(|it| it.khr_lights_punctual.as_ref());
    for (index, light) in lights.iter().flat_map(|it| &it.lights).enumerate() {
        let is_whole = match light.type_ {
            Checked::Valid(LightType::Spot) => light.spot.is_some(),
            Checked::Valid(_) => true,
            Checked::Invalid => false,
        };
        if !is_whole {
            return Err(wrong(format!(
                "light {index} has no type, or lacks its spot"
            )));
        }
    }
    let count = lights.map_or(0, |it| it.lights.len());
    for (index, node) in json.nodes.iter().enumerate() {
        let light = node
            .extensions
            .as_ref()
            .and_then(|it| it.khr_lights_punctual.as_ref());
        if light.is_some_and(|it| it.light.value() >= count) {
            return Err(wrong(format!(
                "node {index} has a light that doesn't exist"
            )));
        }
    }
    Ok(())
}

/// A file that is being read.
struct File<'a> {
    blob: &'a [u8],
    textures: Textures<'a>,
    /// The builder's numbers of the file's materials, and the texture coordinates that their
    /// textures are for; the last one is the default's.
    materials: Vec<Option<(u32, Option<u32>)>>,
    /// The nodes that were visited.
    seen: Vec<bool>,
    builder: &'a mut Builder,
}

impl File<'_> {
    fn node(&mut self, node: &Node<'_>, outer: DMat4, nesting: usize) -> Result<(), Fault> {
        let index = node.index();
        if std::mem::replace(&mut self.seen[index], true) || nesting > MAX_NESTING {
            return Err(wrong(format!(
                "node {index} is in the scene twice, in itself, or in more than {MAX_NESTING} others"
            )));
        }
        let place = outer * matrix(&node.transform());
        if !place.is_finite() {
            return Err(wrong(format!(
                "the transform of node {index} is not finite"
            )));
        }
        if node.skin().is_some() {
            self.builder.note("animations and skins are ignored");
        }
        if let Some(mesh) = node.mesh() {
            for primitive in mesh.primitives() {
                self.primitive(&primitive, place)
                    .map_err(|fault| part(fault, mesh.index(), primitive.index()))?;
            }
        }
        if let Some(camera) = node.camera() {
            self.camera(&camera, place);
        }
        if let Some(light) = node.light() {
            self.light(&light, place);
        }
        for child in node.children() {
            self.node(&child, place, nesting + 1)?;
        }
        Ok(())
    }

    fn primitive(&mut self, primitive: &Primitive<'_>, place: DMat4) -> Result<(), Fault> {
        let mode = primitive.mode();
        if !matches!(
            mode,
            Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan
        ) {
            self.builder.note("points and lines are ignored");
            return Ok(());
        }
        if primitive.morph_targets().len() > 0 {
            self.builder.note("morph targets are ignored");
        }
        if primitive.get(&Semantic::Colors(0)).is_some() {
            self.builder.note("colours of vertices are ignored");
        }
        let Some(positions) = primitive.get(&Semantic::Positions) else {
            return Ok(());
        };
        let positions = accessor::vectors(&positions, self.blob)?;
        let normals = match primitive.get(&Semantic::Normals) {
            Some(normals) => accessor::vectors(&normals, self.blob)?,
            None => Vec::new(),
        };
        if !normals.is_empty() && normals.len() != positions.len() {
            let (normals, positions) = (normals.len(), positions.len());
            return Err(wrong(format!("{normals} normals for {positions} vertices")));
        }
        let count = positions.len();
        let corners: Vec<i64> = match primitive.indices() {
            Some(indices) => accessor::indices(&indices, self.blob)?,
            None => (0..count as i64).collect(),
        };
        let (material, set) = self.material(&primitive.material())?;
        let places = match set.map(|set| primitive.get(&Semantic::TexCoords(set))) {
            None => Vec::new(),
            Some(Some(places)) => accessor::coordinates(&places, self.blob)?,
            Some(None) => return Err(no_coordinates()),
        };
        if set.is_some() && places.len() != positions.len() {
            return Err(no_coordinates());
        }

        let linear = DMat3::from_mat4(place);
        // Normals are perpendicular to surfaces also where the scale differs between axes.
        let upright = linear.inverse().transpose();
        let upright = if upright.is_finite() { upright } else { linear };
        let moved = |[x, y, z]: [f32; 3]| {
            let point = DVec3::new(x.into(), y.into(), z.into());
            place.transform_point3(point).as_vec3().to_array()
        };
        let turned = |[x, y, z]: [f32; 3]| {
            let normal = upright * DVec3::new(x.into(), y.into(), z.into());
            nff::unit(normal).unwrap_or_default().as_vec3().to_array()
        };
        // NaN has no direction, and would become a normal of 0.
        if let Some(index) = normals
            .iter()
            .position(|normal| normal.iter().any(|it| !it.is_finite()))
        {
            return Err(Fault::NotFinite {
                what: "normal",
                index,
                value: f32::NAN,
            });
        }
        let first = self.builder.add_vertices(
            positions.into_iter().map(moved),
            normals.into_iter().map(turned),
            places,
        )?;
        // A mirrored mesh is wound the other way.
        let mirrored = linear.determinant() < 0.0;
        for (face, [a, b, c]) in faces(mode, &corners).enumerate() {
            let corners = if mirrored { [a, c, b] } else { [a, b, c] };
            self.builder.face(face, first, &corners, material)?;
        }
        Ok(())
    }

    /// The builder's number of a material, and the set of texture coordinates that its texture is
    /// for.
    fn material(&mut self, material: &gltf::Material<'_>) -> Result<(u32, Option<u32>), Fault> {
        let place = material.index().unwrap_or(self.materials.len() - 1);
        if let Some(known) = self.materials[place] {
            return Ok(known);
        }
        let mut found = material::of(material, |note| self.builder.note(note));
        let mut set = None;
        if let Some(index) = material.index()
            && let Some(colour) = self.textures.of(index, self.builder)?
        {
            found.texture = Some(colour.texture);
            set = Some(colour.set);
        }
        let number = self.builder.material(found)?;
        self.builder.two_sided |= material.double_sided();
        self.materials[place] = Some((number, set));
        Ok((number, set))
    }

    /// Takes the file's first camera as the view.
    fn camera(&mut self, camera: &gltf::Camera<'_>, place: DMat4) {
        if self.builder.view.is_some() {
            self.builder.note("only the first camera is used");
            return;
        }
        let gltf::camera::Projection::Perspective(lens) = camera.projection() else {
            self.builder.note("orthographic cameras are ignored");
            return;
        };
        let from = place.transform_point3(DVec3::ZERO);
        let view = View {
            from,
            at: from + place.transform_vector3(DVec3::NEG_Z),
            up: place.transform_vector3(DVec3::Y),
            angle: f64::from(lens.yfov()).to_degrees(),
            hither: 0.0,
            resolution: match lens.aspect_ratio() {
                Some(aspect) if (0.1..=10.0).contains(&aspect) => {
                    (((512.0 * aspect).round() as u32).max(1), 512)
                }
                _ => (512, 512),
            },
        };
        if view.camera(view.resolution.0, view.resolution.1).is_ok() {
            self.builder.view = Some(view);
        } else {
            self.builder.note("a camera shows nothing, and is ignored");
        }
    }

    /// Adds a light. glTF states luminous intensities, which need a camera's exposure to become
    /// colours, and they fall with the distance. Here a light has its colour's brightness
    /// everywhere.
    fn light(&mut self, light: &gltf::khr_lights_punctual::Light<'_>, place: DMat4) {
        use gltf::khr_lights_punctual::Kind;
        if light.intensity() <= 0.0 {
            return;
        }
        let kind = match light.kind() {
            Kind::Directional => LightKind::Directional {
                to_light: place.transform_vector3(DVec3::Z),
            },
            Kind::Point => LightKind::Point {
                position: place.transform_point3(DVec3::ZERO),
            },
            Kind::Spot { .. } => {
                self.builder.note("spot lights shine in all directions");
                LightKind::Point {
                    position: place.transform_point3(DVec3::ZERO),
                }
            }
        };
        if let LightKind::Directional { to_light } = kind
            && nff::unit(to_light).is_none()
        {
            return;
        }
        self.builder
            .note("lights have their colours, but not their intensities");
        let colour = light.color().map(|it| f64::from(it).clamp(0.0, 1.0));
        self.builder.lights.push(Light {
            line: 0,
            kind,
            colour: Some(colour.into()),
        });
    }
}

fn no_coordinates() -> Fault {
    let part = String::from("its material");
    Fault::NoCoordinates { part }
}

/// Names the part of the file that has a fault.
fn part(fault: Fault, mesh: usize, primitive: usize) -> Fault {
    match fault {
        Fault::TooManyTriangles
        | Fault::TooManyMaterials
        | Fault::TooManyTexels(_)
        | Fault::Texture { .. } => fault,
        _ => wrong(format!("mesh {mesh}, primitive {primitive}: {fault}")),
    }
}

/// The triangles of a list of vertices.
fn faces(mode: Mode, corners: &[i64]) -> Box<dyn Iterator<Item = [i64; 3]> + '_> {
    let rest = corners.get(1..).unwrap_or_default();
    match mode {
        Mode::TriangleStrip => Box::new(corners.windows(3).enumerate().map(|(index, it)| {
            if index % 2 == 0 {
                [it[0], it[1], it[2]]
            } else {
                [it[1], it[0], it[2]]
            }
        })),
        Mode::TriangleFan => Box::new(rest.windows(2).map(|it| [corners[0], it[0], it[1]])),
        _ => Box::new(corners.chunks_exact(3).map(|it| [it[0], it[1], it[2]])),
    }
}

fn matrix(transform: &Transform) -> DMat4 {
    match transform {
        Transform::Matrix { matrix } => {
            DMat4::from_cols_array_2d(&matrix.map(|column| column.map(f64::from)))
        }
        Transform::Decomposed {
            translation,
            rotation,
            scale,
        } => {
            let rotation = DQuat::from_array(rotation.map(f64::from));
            let rotation = if rotation.length_squared() > 0.0 && rotation.is_finite() {
                rotation.normalize()
            } else {
                DQuat::IDENTITY
            };
            DMat4::from_scale_rotation_translation(
                DVec3::from_array(scale.map(f64::from)),
                rotation,
                DVec3::from_array(translation.map(f64::from)),
            )
        }
    }
}
