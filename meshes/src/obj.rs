//! Wavefront OBJ files, and their material libraries.

use std::cell::RefCell;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::{DVec3, Vec3};
use nff::{Material, Texture, Wrap};
use tobj::{LoadError, LoadOptions, MTLLoadResult};

use crate::Fault;
use crate::builder::{Builder, plain};
use crate::texture::decode;

/// The first illumination model with reflection by ray tracing.
const REFLECTS: u8 = 3;

pub(crate) fn read(bytes: &[u8], name: &Path, builder: &mut Builder) -> Result<(), Fault> {
    let options = LoadOptions {
        single_index: true,
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
    };
    // tobj takes libraries through a function that can't fail with our error.
    let trouble: RefCell<Result<(), Fault>> = RefCell::new(Ok(()));
    let notes = RefCell::new(Vec::new());
    let library = |path: &Path| -> MTLLoadResult {
        let path = name.parent().unwrap_or(Path::new("")).join(path);
        match crate::bytes(&path) {
            Ok(text) => match check_library(&path, &text) {
                Ok(()) => {
                    let found = tobj::load_mtl_buf(&mut text.as_slice());
                    found.map(|(materials, numbers)| (beside(&path, materials), numbers))
                }
                Err(fault) => {
                    *trouble.borrow_mut() = Err(fault);
                    Err(LoadError::MaterialParseError)
                }
            },
            Err(Fault::Io(error)) => {
                let file = path.display();
                notes
                    .borrow_mut()
                    .push(format!("{file}: {error}; its materials are grey instead"));
                Ok((Vec::new(), Default::default()))
            }
            Err(fault) => {
                *trouble.borrow_mut() = Err(Fault::Library {
                    file: path.display().to_string(),
                    fault: Box::new(fault),
                });
                Err(LoadError::MaterialParseError)
            }
        }
    };
    check_faces(bytes)?;
    let (models, materials) = tobj::load_obj_buf(&mut &bytes[..], &options, library)?;
    trouble.into_inner()?;
    for note in notes.into_inner() {
        builder.note(note);
    }
    // The format doesn't say whether surfaces have a back, and many files are wound both ways.
    builder.two_sided = true;
    let mut numbers = HashMap::new();
    let mut textures = HashMap::new();
    let materials = materials?;
    for model in models {
        let mesh = model.mesh;
        let triples = |numbers: &[f32]| {
            numbers
                .chunks_exact(3)
                .map(|it| [it[0], it[1], it[2]])
                .collect::<Vec<_>>()
        };
        let positions = triples(&mesh.positions);
        let mut normals = triples(&mesh.normals);
        if normals.len() != positions.len() {
            normals.clear();
        }
        let number = match numbers.get(&mesh.material_id) {
            Some(&number) => number,
            None => {
                let found = mesh.material_id.and_then(|id| materials.get(id));
                let mut made = found.map_or_else(|| plain(DVec3::splat(0.8)), material);
                if let Some(found) = found {
                    tell(found, builder);
                    made.texture = texture(found, &mut textures, builder)?;
                }
                let is_textured = made.texture.is_some();
                let number = (builder.material(made)?, is_textured);
                *numbers.entry(mesh.material_id).or_insert(number)
            }
        };
        let (number, is_textured) = number;
        let mut places = Vec::new();
        if is_textured {
            // The format counts from the lower edge.
            let pairs = mesh.texcoords.chunks_exact(2);
            places.extend(pairs.map(|it| [it[0], 1.0 - it[1]]));
            if places.len() != positions.len() {
                let material = mesh.material_id.and_then(|id| materials.get(id));
                let name = material.map_or("", |material| &material.name);
                let part = format!("the material {name}");
                return Err(Fault::NoCoordinates { part });
            }
        }
        if !mesh.vertex_color.is_empty() {
            builder.note("colours of vertices are ignored");
        }
        let first = builder.add_vertices(positions, normals, places)?;
        for (face, corners) in mesh.indices.chunks_exact(3).enumerate() {
            let corners = [corners[0], corners[1], corners[2]].map(i64::from);
            builder.face(face, first, &corners, number)?;
        }
    }
    Ok(())
}

/// The materials of a library, whose pictures are beside it.
fn beside(library: &Path, mut materials: Vec<tobj::Material>) -> Vec<tobj::Material> {
    let folder = library.parent().unwrap_or(Path::new(""));
    for material in &mut materials {
        if let Some(words) = &mut material.diffuse_texture {
            let (options, file) = split(words);
            let file = folder.join(file.replace('\\', "/"));
            *words = format!("{options}{}", file.display());
        }
    }
    materials
}

/// The options of a texture, with a blank after each word, and its file.
fn split(words: &str) -> (String, &str) {
    let mut options = String::new();
    let mut rest = words.trim();
    while rest.starts_with('-') {
        let (option, after) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
        let most = match option {
            "-o" | "-s" | "-t" => 3,
            "-mm" => 2,
            _ => 1,
        };
        options += option;
        options.push(' ');
        rest = after.trim_start();
        for value in 0..most {
            let (word, after) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
            // The second and third number may be missing.
            if value > 0 && most == 3 && word.parse::<f32>().is_err() {
                break;
            }
            options += word;
            options.push(' ');
            rest = after.trim_start();
        }
    }
    (options, rest)
}

/// The texture of a material's diffuse colour. `known` has those that were decoded.
fn texture(
    material: &tobj::Material,
    known: &mut HashMap<(PathBuf, Wrap), Arc<Texture>>,
    builder: &mut Builder,
) -> Result<Option<Arc<Texture>>, Fault> {
    let Some(words) = &material.diffuse_texture else {
        return Ok(None);
    };
    let (options, file) = split(words);
    let wrap = if options.contains("-clamp on ") {
        Wrap::Clamp
    } else {
        Wrap::Repeat
    };
    if !options.replace("-clamp on ", "").is_empty() {
        builder.note("options of textures other than -clamp are ignored");
    }
    let path = PathBuf::from(file);
    if let Some(texture) = known.get(&(path.clone(), wrap)) {
        return Ok(Some(texture.clone()));
    }
    let bad = |what: String| Fault::Texture {
        name: file.to_owned(),
        what,
    };
    let bytes = crate::bytes(&path).map_err(|fault| bad(fault.to_string()))?;
    let (texture, has_alpha) = decode(&bytes, [wrap; 2]).map_err(bad)?;
    if has_alpha {
        builder.note("the alpha of textures is ignored");
    }
    let texture = builder.texture(texture)?;
    known.insert((path, wrap), texture.clone());
    Ok(Some(texture))
}

/// Notes what a material has and Whitted's model or this tracer doesn't.
fn tell(material: &tobj::Material, builder: &mut Builder) {
    let textures = [
        &material.ambient_texture,
        &material.specular_texture,
        &material.normal_texture,
        &material.shininess_texture,
        &material.dissolve_texture,
    ];
    if textures.iter().any(|texture| texture.is_some()) {
        builder.note("textures other than those of diffuse colours are ignored");
    }
    if material.emissive.is_some_and(|colour| colour != [0.0; 3]) {
        builder.note("emissive colours are ignored");
    }
}

/// The shares of a material. Only illumination models with ray tracing reflect: the highlight and
/// the mirror have one share in Whitted's model, and most files mean the highlight alone.
fn material(found: &tobj::Material) -> Material {
    let share = |value: f32| f64::from(value).clamp(0.0, 1.0);
    // The texture alone is the colour if there is no other.
    let otherwise = if found.diffuse_texture.is_some() {
        1.0
    } else {
        0.8
    };
    let colour = found.diffuse.map_or(DVec3::splat(otherwise), |colour| {
        Vec3::from(colour).as_dvec3().clamp(DVec3::ZERO, DVec3::ONE)
    });
    let reflects = found
        .illumination_model
        .is_some_and(|model| model >= REFLECTS);
    let specular = found.specular.filter(|_| reflects);
    let specular = specular.map_or(0.0, |it| share(it[0].max(it[1]).max(it[2])));
    let shine = found.shininess.filter(|shine| shine.is_finite());
    let index = found.optical_density.filter(|index| index.is_finite());
    Material {
        specular,
        shine: f64::from(shine.unwrap_or(1.0)).clamp(1.0, 1000.0),
        transmittance: 1.0 - found.dissolve.map_or(1.0, share),
        refraction_index: f64::from(index.unwrap_or(1.0)).clamp(1.0, 10.0),
        ..plain(colour)
    }
}

/// Refuses faces that [`tobj::load_obj_buf`] multiplies without a check: corners without a vertex,
/// and numbers that count back beyond the file's beginning. It refuses all other numbers itself.
fn check_faces(text: &[u8]) -> Result<(), Fault> {
    // Vertices, texture coordinates, and normals so far.
    let mut counts = [0_i64; 3];
    for (line, text) in (1..).zip(text.split(|&byte| byte == b'\n')) {
        let text = String::from_utf8_lossy(text);
        let mut words = text.split_whitespace();
        match words.next() {
            Some("v") => counts[0] += 1,
            Some("vt") => counts[1] += 1,
            Some("vn") => counts[2] += 1,
            Some("f") => {
                let is_wrong = |corner: &str| {
                    let mut numbers = corner.split('/').zip(counts).enumerate();
                    numbers.any(|(place, (number, count))| {
                        let known = number.parse::<i64>().unwrap_or(1);
                        let range = -count..=i64::from(u32::MAX);
                        (number.is_empty() && place == 0) || known == 0 || !range.contains(&known)
                    })
                };
                if let Some(corner) = words.find(|corner| is_wrong(corner)) {
                    let corner = corner.to_owned();
                    return Err(Fault::Corner { line, corner });
                }
            }
            _ => {}
        }
    }
    Ok(())
}

/// Refuses lines that [`tobj::load_mtl_buf`] can't take: colours with fewer than three numbers.
fn check_library(path: &Path, text: &[u8]) -> Result<(), Fault> {
    for (number, line) in (1..).zip(text.split(|&byte| byte == b'\n')) {
        let line = String::from_utf8_lossy(line);
        let mut words = line.split_whitespace();
        let word = words.next().unwrap_or_default();
        if matches!(word, "Ka" | "Kd" | "Ks" | "Ke") && words.take(3).count() < 3 {
            return Err(Fault::Mtl {
                file: path.display().to_string(),
                line: number,
                word: word.to_owned(),
            });
        }
    }
    Ok(())
}
