//! Checks that numbers are in the SPUs' range, and that shapes have a surface.
//!
//! Invariant: if all parts of a world have passed, no frame is refused because of a number in it.
//! The exceptions are numbers that are computed from others, such as the growth of a very flat
//! cone.

use glam::{DAffine3, DMat3, DVec3, Vec3};
use scenes::{LightKind, Mesh, Shader, Shape};

use super::error::WorldErrorKind;
use super::material::{Light, Material};
use super::meshes::corners;
use crate::scene::single::{is_number, is_size};

fn out_of_range(what: &'static str, value: f64, also: &'static str) -> WorldErrorKind {
    WorldErrorKind::OutOfRange { what, value, also }
}

/// Whether a number can be squared as a single.
fn number(what: &'static str, value: f64) -> Result<(), WorldErrorKind> {
    if is_number(value) { Ok(()) } else { Err(out_of_range(what, value, "")) }
}

/// Whether all components of a vector can be squared as singles.
pub(super) fn vector(what: &'static str, vector: DVec3) -> Result<(), WorldErrorKind> {
    vector.to_array().into_iter().try_for_each(|value| number(what, value))
}

fn size(what: &'static str, value: f64) -> Result<(), WorldErrorKind> {
    if is_size(value) { Ok(()) } else { Err(out_of_range(what, value, " and at least 2^-62")) }
}

pub(super) fn shape(shape: &Shape) -> Result<(), WorldErrorKind> {
    match shape {
        Shape::Sphere { centre, radius } => {
            vector("centre", *centre)?;
            size("radius", *radius)
        }
        Shape::Cone { base, base_radius, apex, apex_radius } => {
            vector("base", *base)?;
            vector("apex", *apex)?;
            number("base radius", *base_radius)?;
            number("apex radius", *apex_radius)?;
            if *base_radius == 0.0 && *apex_radius == 0.0 {
                return Err(WorldErrorKind::NoSurface("both radii of a cone are 0"));
            }
            if base_radius * apex_radius < 0.0 {
                return Err(WorldErrorKind::NoSurface(
                    "one radius of a cone is negative and the other positive",
                ));
            }
            size("height", base.distance(*apex))
        }
        Shape::Polygon { vertices } => polygon(vertices),
        Shape::Patch { vertices, normals } => {
            if vertices.len() != normals.len() {
                return Err(WorldErrorKind::NoSurface("a patch needs one normal for each vertex"));
            }
            polygon(vertices)?;
            normals.iter().try_for_each(|normal| vector("normal", *normal))
        }
    }
}

/// Whether a shape is still in range when it is moved by `by`.
pub(super) fn moved(shape: &Shape, by: DVec3) -> Result<(), WorldErrorKind> {
    match shape {
        Shape::Sphere { .. } => Ok(()),
        Shape::Cone { apex, .. } => vector("apex", *apex + by),
        Shape::Polygon { vertices } | Shape::Patch { vertices, .. } => {
            vertices.iter().try_for_each(|vertex| vector("vertex", *vertex + by))
        }
    }
}

/// Checks that the parts of a mesh belong together, and that `materials` materials are enough.
/// Returns the numbers of those that its triangles have.
pub(super) fn mesh(mesh: &Mesh, materials: usize) -> Result<Vec<usize>, WorldErrorKind> {
    let bad = |message: String| Err(WorldErrorKind::BadMesh(message));
    let (vertices, triangles) = (mesh.positions.len(), mesh.triangles.len());
    if triangles == 0 {
        return bad("it has no triangles".into());
    }
    if mesh.materials.len() != triangles {
        let count = mesh.materials.len();
        return bad(format!("{triangles} triangles need as many materials, not {count}"));
    }
    if !mesh.visibility.is_empty() && mesh.visibility.len() != triangles {
        let count = mesh.visibility.len();
        return bad(format!(
            "{triangles} triangles need their visibility each, or none, not {count}"
        ));
    }
    if !mesh.normals.is_empty() && mesh.normals.len() != vertices {
        let count = mesh.normals.len();
        return bad(format!("{vertices} vertices need as many normals, or none, not {count}"));
    }
    if !mesh.texture_coordinates.is_empty() && mesh.texture_coordinates.len() != vertices {
        let count = mesh.texture_coordinates.len();
        return bad(format!(
            "{vertices} vertices need as many texture coordinates, or none, not {count}"
        ));
    }
    if !mesh.colours.is_empty() && mesh.colours.len() != vertices {
        let count = mesh.colours.len();
        return bad(format!("{vertices} vertices need as many colours, or none, not {count}"));
    }
    for (vertex, colour) in mesh.colours.iter().enumerate() {
        let is_right = |channel: &f32| (0.0..=1.0).contains(channel);
        if let Some(channel) = colour.iter().find(|channel| !is_right(channel)) {
            return bad(format!(
                "vertex {vertex} has {channel} in its colour: channels must be from 0 to 1"
            ));
        }
    }
    for (number, triangle) in mesh.triangles.iter().enumerate() {
        if let Some(vertex) = triangle.iter().find(|vertex| **vertex as usize >= vertices) {
            return bad(format!("triangle {number} has vertex {vertex} of {vertices}"));
        }
    }
    let mut used = vec![false; materials];
    for (number, &material) in mesh.materials.iter().enumerate() {
        match used.get_mut(material as usize) {
            Some(used) => *used = true,
            None => {
                return bad(format!("triangle {number} has material {material} of {materials}"));
            }
        }
    }
    vector("origin of the mesh", mesh.origin)?;
    for (what, vectors) in [("vertex", &mesh.positions), ("normal", &mesh.normals)] {
        for &value in vectors.iter().flatten() {
            number(what, f64::from(value))?;
        }
    }
    for &value in mesh.texture_coordinates.iter().flatten() {
        number("texture coordinate", f64::from(value))?;
    }
    let used = used.into_iter().enumerate();
    Ok(used.filter_map(|(number, used)| used.then_some(number)).collect())
}

/// Checks new positions and normals of a mesh's vertices at a place. Returns the corners of the box
/// around them.
pub(super) fn vertices(
    mesh: &Mesh,
    positions: &[[f32; 3]],
    normals: &[[f32; 3]],
    place: DAffine3,
) -> Result<(DVec3, DVec3), WorldErrorKind> {
    let bad = |message: String| Err(WorldErrorKind::BadMesh(message));
    for (what, old, new) in
        [("positions", &mesh.positions, positions), ("normals", &mesh.normals, normals)]
    {
        if old.len() != new.len() {
            return bad(format!("it has {} {what}, not {}", old.len(), new.len()));
        }
        let is_wrong =
            |vector: &[f32; 3]| vector.iter().any(|it| number("", f64::from(*it)).is_err());
        if let Some(vertex) = new.iter().position(is_wrong) {
            let vector = new[vertex];
            return bad(format!("{what} of vertex {vertex}: {vector:?} is not at most 2^62"));
        }
    }
    let points = positions.iter().map(|&position| Vec3::from(position));
    let first = Vec3::from(positions.first().copied().unwrap_or_default());
    let (low, high) =
        points.fold((first, first), |(low, high), point| (low.min(point), high.max(point)));
    let bounds = (mesh.origin + low.as_dvec3(), mesh.origin + high.as_dvec3());
    in_range(bounds, place)?;
    Ok(bounds)
}

fn in_range(bounds: (DVec3, DVec3), place: DAffine3) -> Result<(), WorldErrorKind> {
    corners(bounds)
        .try_for_each(|corner| vector("transformed vertex", place.transform_point3(corner)))
}

/// Whether a mesh has a volume, or an area, and is in range at a place.
pub(super) fn place(bounds: (DVec3, DVec3), place: DAffine3) -> Result<(), WorldErrorKind> {
    in_range(bounds, place)?;
    let DMat3 { x_axis, y_axis, z_axis } = place.matrix3;
    for axis in [x_axis, y_axis, z_axis] {
        vector("axis of the place", axis)?;
    }
    let volume = place.matrix3.determinant();
    if volume == 0.0 || !volume.is_finite() {
        return Err(WorldErrorKind::NoSurface("the place of a mesh makes it flat"));
    }
    Ok(())
}

fn polygon(vertices: &[DVec3]) -> Result<(), WorldErrorKind> {
    if vertices.len() < 3 {
        return Err(WorldErrorKind::NoSurface("a polygon needs at least three vertices"));
    }
    vertices.iter().try_for_each(|vertex| vector("vertex", *vertex))
}

pub(super) fn material(material: &Material) -> Result<(), WorldErrorKind> {
    vector("colour", material.colour)?;
    vector("emission", material.emission)?;
    number("diffuse share", material.diffuse)?;
    number("specular share", material.specular)?;
    number("shine", material.shine)?;
    number("transmittance", material.transmittance)?;
    if material.transmittance > 0.0 {
        size("index of refraction", material.refraction_index)?;
    }
    match &material.shader {
        Shader::Flat | Shader::Lambert | Shader::Phong => Ok(()),
        Shader::Checker { other, size: edge } => {
            vector("colour", *other)?;
            if *edge < 0.0 {
                return Err(out_of_range("edge of a cube", *edge, " and more than 0"));
            }
            size("edge of a cube", *edge)
        }
        Shader::Depth { far, near } => {
            number("far", *far)?;
            number("near", *near)?;
            fade(*near, *far)
        }
        Shader::Portal { by, turn } => {
            vector("move of a portal", *by)?;
            number("turn of a portal", *turn)
        }
        Shader::Own { parameters, .. } => {
            parameters.iter().try_for_each(|value| number("parameter of the shader", *value))
        }
    }
}

/// Whether brightness can fade from `near` to `far`.
pub(super) fn fade(near: f64, far: f64) -> Result<(), WorldErrorKind> {
    number("far", far)?;
    number("near", near)?;
    if near < 0.0 {
        return Err(out_of_range("near", near, " and not negative"));
    }
    size("far - near", far - near)?;
    if near > far {
        return Err(out_of_range("far", far, " and more than near"));
    }
    Ok(())
}

pub(super) fn light(light: &Light) -> Result<(), WorldErrorKind> {
    match light.kind {
        LightKind::Point { position, range } => {
            vector("light", position)?;
            if range != f64::INFINITY {
                size("range", range)?;
            }
            if range < 0.0 {
                return Err(out_of_range("range", range, " and above 0"));
            }
        }
        LightKind::Directional { to_light } => {
            vector("direction to the light", to_light)?;
            if to_light == DVec3::ZERO {
                return Err(WorldErrorKind::NoDirection);
            }
        }
    }
    vector("brightness", light.colour.unwrap_or_default())
}
