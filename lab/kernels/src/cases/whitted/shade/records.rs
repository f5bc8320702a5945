//! Converts the inputs of the surface kernels' twins to records, and records to the twins'
//! results.

use twins::Single;
use twins::surfaces::{Material, Object, Ray, Surface};
use zerocopy::FromZeros as _;
use zerocopy::big_endian::{F32, U32};

use crate::single::{bits, single};
use protocol::layout::{self, RayPacket, Surfaces};

/// A ray of a packet.
#[derive(Clone, Copy, Debug)]
pub struct PacketRay {
    /// The ray and the distance of its hit.
    pub ray: Ray,
    /// The address of the object that it hit.
    pub object: u32,
    /// The share of its colour in its pixel.
    pub weight: Single,
    /// The address of its pixel's sum.
    pub pixel: u32,
}

/// A packet of rays.
#[must_use]
pub fn rays(rays: &[PacketRay; 16]) -> RayPacket {
    let [origin_x, origin_y, origin_z] = components(&rays.map(|lane| lane.ray.origin));
    let [direction_x, direction_y, direction_z] = components(&rays.map(|lane| lane.ray.direction));
    RayPacket {
        origin_x,
        origin_y,
        origin_z,
        direction_x,
        direction_y,
        direction_z,
        t: rays.map(|lane| single(lane.ray.t)),
        object: rays.map(|lane| lane.object.into()),
        weight: rays.map(|lane| single(lane.weight)),
        pixel: rays.map(|lane| lane.pixel.into()),
    }
}

/// The rays of a packet.
#[must_use]
pub fn packet_rays(packet: &RayPacket) -> [PacketRay; 16] {
    let origins = vectors([packet.origin_x, packet.origin_y, packet.origin_z]);
    let directions = vectors([packet.direction_x, packet.direction_y, packet.direction_z]);
    std::array::from_fn(|lane| PacketRay {
        ray: Ray { origin: origins[lane], direction: directions[lane], t: bits(packet.t[lane]) },
        object: packet.object[lane].get(),
        weight: bits(packet.weight[lane]),
        pixel: packet.pixel[lane].get(),
    })
}

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
