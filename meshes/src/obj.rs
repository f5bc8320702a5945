//! Wavefront OBJ files, and their material libraries.

use std::cell::RefCell;
use std::collections::HashMap;
use std::fs;
use std::path::Path;

use glam::{DVec3, Vec3};
use nff::Material;
use tobj::{LoadError, LoadOptions, MTLLoadResult};

use crate::Fault;
use crate::builder::{Builder, plain};

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
        match fs::read(&path) {
            Ok(text) => match check_library(&path, &text) {
                Ok(()) => tobj::load_mtl_buf(&mut text.as_slice()),
                Err(fault) => {
                    *trouble.borrow_mut() = Err(fault);
                    Err(LoadError::MaterialParseError)
                }
            },
            Err(error) => {
                let file = path.display();
                notes
                    .borrow_mut()
                    .push(format!("{file}: {error}; its materials are grey instead"));
                Ok((Vec::new(), Default::default()))
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
                if let Some(found) = found {
                    tell(found, builder);
                }
                let number =
                    builder.material(found.map_or_else(|| plain(DVec3::splat(0.8)), material))?;
                *numbers.entry(mesh.material_id).or_insert(number)
            }
        };
        if !mesh.vertex_color.is_empty() {
            builder.note("colours of vertices are ignored");
        }
        let first = builder.add_vertices(positions, normals)?;
        for (face, corners) in mesh.indices.chunks_exact(3).enumerate() {
            let corners = [corners[0], corners[1], corners[2]].map(i64::from);
            builder.face(face, first, &corners, number)?;
        }
    }
    Ok(())
}

/// Notes what a material has and Whitted's model or this tracer doesn't.
fn tell(material: &tobj::Material, builder: &mut Builder) {
    let textures = [
        &material.ambient_texture,
        &material.diffuse_texture,
        &material.specular_texture,
        &material.normal_texture,
        &material.shininess_texture,
        &material.dissolve_texture,
    ];
    if textures.iter().any(|texture| texture.is_some()) {
        builder.note("textures are ignored");
    }
    if material.emissive.is_some_and(|colour| colour != [0.0; 3]) {
        builder.note("emissive colours are ignored");
    }
}

/// The shares of a material. Only illumination models with ray tracing reflect: the highlight and
/// the mirror have one share in Whitted's model, and most files mean the highlight alone.
fn material(found: &tobj::Material) -> Material {
    let share = |value: f32| f64::from(value).clamp(0.0, 1.0);
    let colour = found.diffuse.map_or(DVec3::splat(0.8), |colour| {
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
