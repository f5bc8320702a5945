//! Twin of `spu/shade/surfaces_r16.s` and `surfaces_same_r16.s`: where a ray has hit an
//! object, and what the surface is there; and of `same_objects_r16.s`.

use spu_emulator::float::single::{fa, fm, fma, fms, fnms, fs};

use super::math::rsqrt;
use super::{SIGN, Single, below_zero, dot, select};
use zerocopy::FromBytes;

/// The share in `leave` of coordinates' distance from 0 and of an object's own numbers: 2^-22.
pub const LEAVE: Single = 0x3480_0000;

/// A ray that has hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes)]
pub struct Ray {
    /// Origin.
    pub origin: [Single; 3],
    /// Unit direction.
    pub direction: [Single; 3],
    /// Distance of the hit; below 0 if the ray is not there.
    pub t: Single,
}

/// An object's surface near any of its points, as `OBJECT` has it.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct Object {
    /// Centre, base, or a point of the plane.
    pub centre: [Single; 3],
    /// Share of the direction off the axis in the normal.
    pub gain: Single,
    /// Unit axis, or 0.
    pub axis: [Single; 3],
    /// Share of the axis in the normal.
    pub slope: Single,
    /// The height's zero.
    pub offset: Single,
    /// The share of the object's own numbers in `leave`.
    pub leave: Single,
    /// `SIDES_` bits.
    pub sides: u32,
}

/// The material of a surface, as in `MATERIAL`.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct Material {
    /// Red, green, blue.
    pub colour: [Single; 3],
    /// Diffuse share.
    pub diffuse: Single,
    /// Share of the highlight.
    pub highlight: Single,
    /// Its exponent.
    pub exponent: Single,
    /// Share that is reflected.
    pub mirror: Single,
    /// Share that is let through.
    pub transmittance: Single,
    /// One over the index of refraction.
    pub inverse_index: Single,
    /// Index of refraction.
    pub index: Single,
    /// Schlick's F0.
    pub schlick: Single,
    /// 1 - F0.
    pub grazing: Single,
    /// The light that it emits.
    pub emission: [Single; 3],
    /// `MATERIAL_` bits.
    pub flags: u32,
}

/// A lane of `SURFACES`; the normal that shades is the plane's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes)]
pub struct Surface {
    /// Where it is hit.
    pub point: [Single; 3],
    /// Unit normal on the ray's side.
    pub plane: [Single; 3],
    /// How far off the surface a ray has to start.
    pub leave: Single,
    /// Red, green, blue.
    pub colour: [Single; 3],
    /// Diffuse share.
    pub diffuse: Single,
    /// Share of the highlight.
    pub highlight: Single,
    /// Its exponent.
    pub exponent: Single,
    /// Share that is reflected.
    pub mirror: Single,
    /// Share that is let through.
    pub transmittance: Single,
    /// Index of refraction on the ray's side over that beyond.
    pub ratio: Single,
    /// Schlick's F0.
    pub schlick: Single,
    /// 1 - F0.
    pub grazing: Single,
    /// The light that is sent back so far.
    pub lit: [Single; 3],
    /// The flags that the lane adds to the packet's.
    pub flags: u32,
}

/// The surface that a ray has hit.
#[must_use]
pub fn surface(ray: &Ray, object: &Object, material: &Material) -> Surface {
    let there = !below_zero(ray.t);
    let share = |value| select(0, value, there);
    let reached: [Single; 3] = std::array::from_fn(|k| fma(ray.t, ray.direction[k], ray.origin[k]));
    let [x, y, z] = reached.map(|component| component & !SIGN);
    let far = fa(fa(x, y), z);

    let from: [Single; 3] = std::array::from_fn(|k| fs(reached[k], object.centre[k]));
    let along = dot(from, object.axis);
    let off: [Single; 3] = std::array::from_fn(|k| fnms(along, object.axis[k], from[k]));
    let squared = dot(off, off);
    let scale = fm(rsqrt(squared), object.gain);
    let normal: [Single; 3] =
        std::array::from_fn(|k| fma(scale, off[k], fm(object.slope, object.axis[k])));
    let height = fma(object.slope, along, fms(squared, scale, object.offset));
    let point = std::array::from_fn(|k| fnms(height, normal[k], reached[k]));

    let against = dot(normal, ray.direction);
    let front = below_zero(against);
    let turned = normal.map(|component| select(component ^ SIGN, component, front));
    Surface {
        point,
        plane: turned,
        leave: fma(far, LEAVE, object.leave),
        colour: material.colour,
        diffuse: share(material.diffuse),
        highlight: share(material.highlight),
        exponent: material.exponent,
        mirror: share(material.mirror),
        transmittance: share(material.transmittance),
        ratio: select(material.index, material.inverse_index, front),
        schlick: material.schlick,
        grazing: material.grazing,
        lit: material.emission,
        flags: share(material.flags | object.sides),
    }
}

/// A bit for each packet whose rays have all hit the same object, the last one's the lowest.
#[must_use]
pub fn same_objects(packets: &[[u32; 16]]) -> u32 {
    let same = |objects: &[u32; 16]| objects.iter().all(|object| *object == objects[0]);
    packets.iter().fold(0, |bits, objects| bits << 1 | u32::from(same(objects)))
}
