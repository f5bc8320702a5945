//! Converts the inputs of the surface kernels' twins to records, and records to the twins'
//! results.

use crate::prelude::*;
use twins::surfaces::{Material, Object, Surface};

/// An object whose material is at `material`.
#[must_use]
pub fn object(object: &Object, material: u32) -> layout::Object {
    layout::Object {
        centre: object.centre.map(single),
        gain: single(object.gain),
        axis: object.axis.map(single),
        slope: single(object.slope),
        offset: single(object.offset),
        leave: single(object.leave),
        material: material.into(),
        sides: object.sides.into(),
    }
}

/// A material, without a shader.
#[must_use]
pub fn material(material: &Material) -> layout::Material {
    layout::Material {
        colour: material.colour.map(single),
        diffuse: single(material.diffuse),
        highlight: single(material.highlight),
        exponent: single(material.exponent),
        mirror: single(material.mirror),
        transmittance: single(material.transmittance),
        inverse_index: single(material.inverse_index),
        index: single(material.index),
        schlick: single(material.schlick),
        grazing: single(material.grazing),
        emission: material.emission.map(single),
        flags: material.flags.into(),
        ..layout::Material::new_zeroed()
    }
}

/// A packet of surfaces with `normals` as shading normals and the flags of all lanes.
#[must_use]
pub fn surfaces(
    lanes: &[Surface; 16],
    normals: &[[Single; 3]; 16],
    materials: [u32; 16],
) -> Surfaces {
    let [point_x, point_y, point_z] = components(&lanes.map(|lane| lane.point));
    let [normal_x, normal_y, normal_z] = components(normals);
    let [plane_x, plane_y, plane_z] = components(&lanes.map(|lane| lane.plane));
    let [red, green, blue] = components(&lanes.map(|lane| lane.colour));
    let [lit_red, lit_green, lit_blue] = components(&lanes.map(|lane| lane.lit));
    let flags = lanes.iter().fold(0, |flags, lane| flags | lane.flags);
    Surfaces {
        point_x,
        point_y,
        point_z,
        normal_x,
        normal_y,
        normal_z,
        plane_x,
        plane_y,
        plane_z,
        leave: lanes.map(|lane| single(lane.leave)),
        red,
        green,
        blue,
        diffuse: lanes.map(|lane| single(lane.diffuse)),
        highlight: lanes.map(|lane| single(lane.highlight)),
        exponent: lanes.map(|lane| single(lane.exponent)),
        mirror: lanes.map(|lane| single(lane.mirror)),
        transmittance: lanes.map(|lane| single(lane.transmittance)),
        ratio: lanes.map(|lane| single(lane.ratio)),
        schlick: lanes.map(|lane| single(lane.schlick)),
        grazing: lanes.map(|lane| single(lane.grazing)),
        lit_red,
        lit_green,
        lit_blue,
        material: materials.map(U32::new),
        flags: [flags, 0, 0, 0].map(U32::new),
    }
}

/// The light that each lane sends back.
#[must_use]
pub fn lit(surfaces: &Surfaces) -> [[Single; 3]; 16] {
    vectors([surfaces.lit_red, surfaces.lit_green, surfaces.lit_blue])
}

/// Surfaces of which only the light that they send back is set.
#[must_use]
pub fn lit_surfaces(lit: &[[Single; 3]; 16]) -> Surfaces {
    let [lit_red, lit_green, lit_blue] = components(lit);
    Surfaces { lit_red, lit_green, lit_blue, ..Surfaces::new_zeroed() }
}

fn components(vectors: &[[Single; 3]; 16]) -> [[F32; 16]; 3] {
    [0, 1, 2].map(|axis| vectors.map(|vector| single(vector[axis])))
}

fn vectors(components: [[F32; 16]; 3]) -> [[Single; 3]; 16] {
    std::array::from_fn(|lane| components.map(|component| bits(component[lane])))
}
