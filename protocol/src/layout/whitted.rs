//! Records of Whitted's model: the scene as the PPU sends it, and what rays and hits are in local
//! store.
//!
//! All positions are relative to the eye. An address in a record of the scene is one of local store:
//! the scene is fetched to `SCENE_ADDRESS`, always.

use zerocopy::big_endian::{F32, U32};
use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

use super::{Field, Record};

record! {
    /// How every object begins: its surface near any of its points, whatever its shape.
    Object as "OBJECT" {
        /// Centre of a sphere, base of a cone, a point of a plane: x, y, z.
        centre: [F32; 3],
        /// 1 for a sphere, 1 / sqrt(1 + growth^2) for a cone, with the normal inwards negative; 0 for a plane.
        gain: F32,
        /// 0 for a sphere, unit axis of a cone, unit normal of a plane: x, y, z.
        axis: [F32; 3],
        /// 0 for a sphere, -gain growth for a cone, 1 for a plane.
        slope: F32,
        /// Radius of a sphere, gain times radius at the base for a cone, with the sign of gain; 0 for a plane.
        offset: F32,
        /// What the object's own numbers add to `leave` of `SURFACES`.
        leave: F32,
        /// Address of its `MATERIAL`.
        material: U32,
        /// `SIDES_` bits.
        sides: U32,
    }
}

record! {
    /// A parallelogram: follows its `OBJECT`, whose centre is a corner.
    Rectangle as "RECT" {
        /// The head.
        object: [U32; 12],
        /// With u 1 along the first edge and 0 along the second: u = dual_u . (point - corner).
        dual_u: [F32; 4],
        /// The same for v and the second edge.
        dual_v: [F32; 4],
    }
}

record! {
    /// A triangle: follows its `OBJECT`. With `SIDES_SMOOTH` the normals of its vertices follow it.
    Triangle as "TRI" {
        /// The head.
        object: [U32; 12],
        /// First vertex: x, y, z, 0.
        a: [F32; 4],
        /// Second.
        b: [F32; 4],
        /// Third: counter-clockwise as seen from where the normal points.
        c: [F32; 4],
    }
}

record! {
    /// A triangle with normals at its vertices.
    Patch as "PATCH" {
        /// The triangle.
        triangle: [U32; 24],
        /// Unit normal at the first vertex: x, y, z, 0.
        normal_a: [F32; 4],
        /// At the second.
        normal_b: [F32; 4],
        /// At the third.
        normal_c: [F32; 4],
    }
}

record! {
    /// A cone or cylinder without its discs: follows its `OBJECT`, whose axis points to the apex.
    Cone as "CONE" {
        /// The head.
        object: [U32; 12],
        /// Radius at the base, not negative.
        radius: F32,
        /// Growth of the radius with the height.
        growth: F32,
        /// Height.
        height: F32,
        /// 0.
        reserved: F32,
    }
}

record! {
    /// What a surface is made of.
    Material as "MATERIAL" {
        /// Colour: red, green, blue.
        colour: [F32; 3],
        /// Diffuse share, Kd.
        diffuse: F32,
        /// Share of the highlight.
        highlight: F32,
        /// Exponent of Blinn's highlight.
        exponent: F32,
        /// Share that is reflected as by a mirror.
        mirror: F32,
        /// Share that is let through, T.
        transmittance: F32,
        /// One over the index of refraction.
        inverse_index: F32,
        /// Index of refraction.
        index: F32,
        /// Schlick's F0; 0 where transmitting surfaces shall not reflect.
        schlick: F32,
        /// 1 - F0; 0 likewise.
        grazing: F32,
        /// What it sends of itself: red, green, blue.
        emission: [F32; 3],
        /// `MATERIAL_` bits.
        flags: U32,
        /// For the shader.
        parameters: [F32; 4],
        /// Entry of the shader, in `SHADER_` order.
        shader: U32,
        /// 0.
        reserved: [U32; 3],
    }
}

record! {
    /// A light.
    Light as "LIGHT" {
        /// Where it stands, or with `directional` the unit direction to it: x, y, z.
        position: [F32; 3],
        /// All ones if it is infinitely far, else 0.
        directional: U32,
        /// Brightness: red, green, blue.
        brightness: [F32; 3],
        /// How near to it shadow rays end, and with what slack: see `bound_fan_r16`.
        near: F32,
    }
}

record! {
    /// Four bounding spheres of what is below them in the tree. A lane that holds nothing has minus the largest single for a radius.
    Node as "NODE" {
        /// Centres, x.
        x: [F32; 4],
        /// Centres, y.
        y: [F32; 4],
        /// Centres, z.
        z: [F32; 4],
        /// Radii, with the rounding of the test.
        radius: [F32; 4],
        /// Addresses of nodes, or at the lowest level of objects.
        child: [U32; 4],
    }
}

record! {
    /// Objects of one shape, under nodes.
    Bvh as "BVH" {
        /// Address of the first of the nodes at the top, which follow one another; with no level, of objects.
        roots: U32,
        /// How many of them; 0 if there is no object.
        root_count: U32,
        /// Levels of nodes.
        levels: U32,
        /// Objects.
        objects: U32,
    }
}

record! {
    /// Local store: sixteen rays from anywhere, and what they have hit; arrays of 16 in rows of four.
    RayPacket as "RAYS16" {
        /// Origins, x.
        origin_x: [F32; 16],
        /// Origins, y.
        origin_y: [F32; 16],
        /// Origins, z.
        origin_z: [F32; 16],
        /// Unit directions, x.
        direction_x: [F32; 16],
        /// Unit directions, y.
        direction_y: [F32; 16],
        /// Unit directions, z.
        direction_z: [F32; 16],
        /// The farthest distance that counts, then the nearest hit's; -1 for a ray that is not there.
        t: [F32; 16],
        /// Address of the record of the object hit; of the background's if none.
        object: [U32; 16],
        /// Share that the ray's colour has in its pixel's.
        weight: [F32; 16],
        /// Address of its pixel's sum: a quadword of red, green, blue, anything.
        pixel: [U32; 16],
    }
}

record! {
    /// Local store: one ray that waits to be traced.
    QueuedRay as "QUEUED" {
        /// Origin: x, y, z.
        origin: [F32; 3],
        /// Share that the ray's colour has in its pixel's.
        weight: F32,
        /// Unit direction: x, y, z.
        direction: [F32; 3],
        /// Address of its pixel's sum.
        pixel: U32,
    }
}

record! {
    /// Local store: what a packet's rays are within, a sphere moved along a cone; every value in all four lanes, the last fields but once.
    Bound as "BOUND" {
        /// Middle of the rays' origins, x.
        apex_x: [F32; 4],
        /// The same, y.
        apex_y: [F32; 4],
        /// The same, z.
        apex_z: [F32; 4],
        /// Unit vector about which the directions are, x; 0 if they go every way.
        axis_x: [F32; 4],
        /// The same, y.
        axis_y: [F32; 4],
        /// The same, z.
        axis_z: [F32; 4],
        /// Cosine of the largest angle between a direction and the axis, rounded down; 0 if they go every way.
        cosine: [F32; 4],
        /// Its sine, rounded up; 0 if they go every way.
        sine: [F32; 4],
        /// Largest distance of an origin from the middle, rounded up; far below 0 if there is no ray.
        radius: [F32; 4],
        /// Largest distance that a ray counts to.
        farthest: [F32; 4],
        /// The middle once more: x, y, z, anything.
        apex: [F32; 4],
        /// The vector once more: x, y, z, anything.
        axis: [F32; 4],
        /// Sine, radius, anything, anything.
        limits: [F32; 4],
    }
}

record! {
    /// Local store: a node or an object, and a packet that is to be tested with it.
    Candidate as "CANDIDATE" {
        /// Address of the node's or the object's record.
        object: U32,
        /// Address of the packet.
        packet: U32,
        /// Address of the packet's bound.
        bound: U32,
        /// Address of the packet's shear, if there are triangles.
        shear: U32,
    }
}

record! {
    /// Local store: rays' own axes for the triangle test, made by `shear_packets_r16`; rows of four.
    Shear as "SHEARS" {
        /// Shuffle that takes a vertex's component along each axis, in every lane.
        axis_x: [[U32; 4]; 4],
        /// The same, second axis.
        axis_y: [[U32; 4]; 4],
        /// The same, the longest.
        axis_z: [[U32; 4]; 4],
        /// Origin in the ray's own order, x.
        origin_x: [F32; 16],
        /// The same, y.
        origin_y: [F32; 16],
        /// The same, z.
        origin_z: [F32; 16],
        /// Direction x / z in that order.
        slope_x: [F32; 16],
        /// Direction y / z.
        slope_y: [F32; 16],
        /// -1 / direction z.
        minus_per_z: [F32; 16],
    }
}

record! {
    /// Local store: where sixteen rays have hit, and what the surface is there. Of a ray that hits nothing it is the background.
    Surfaces as "SURFACES" {
        /// Points on the surfaces, x.
        point_x: [F32; 16],
        /// Points, y.
        point_y: [F32; 16],
        /// Points, z.
        point_z: [F32; 16],
        /// Unit normals that shade, on the ray's side, x.
        normal_x: [F32; 16],
        /// The same, y.
        normal_y: [F32; 16],
        /// The same, z.
        normal_z: [F32; 16],
        /// Unit normals of the surfaces themselves, on the ray's side, x.
        plane_x: [F32; 16],
        /// The same, y.
        plane_y: [F32; 16],
        /// The same, z.
        plane_z: [F32; 16],
        /// How far off the surface a ray has to start, so that it does not meet it again.
        leave: [F32; 16],
        /// Colour, red.
        red: [F32; 16],
        /// Colour, green.
        green: [F32; 16],
        /// Colour, blue.
        blue: [F32; 16],
        /// Diffuse share.
        diffuse: [F32; 16],
        /// Share of the highlight.
        highlight: [F32; 16],
        /// Exponent of the highlight.
        exponent: [F32; 16],
        /// Share that is reflected.
        mirror: [F32; 16],
        /// Share that is let through.
        transmittance: [F32; 16],
        /// Index of refraction on the ray's side over that beyond.
        ratio: [F32; 16],
        /// Schlick's F0.
        schlick: [F32; 16],
        /// 1 - F0, or 0.
        grazing: [F32; 16],
        /// What is sent back along the ray so far, red.
        lit_red: [F32; 16],
        /// The same, green.
        lit_green: [F32; 16],
        /// The same, blue.
        lit_blue: [F32; 16],
        /// Address of the material.
        material: [U32; 16],
        /// All bits that a ray's material and object have: `MATERIAL_` and `SIDES_` bits of any lane, in the first word.
        flags: [U32; 4],
    }
}

record! {
    /// Local store: a packet of hits that is to be lit.
    Site as "SITE" {
        /// Address of the `SURFACES`.
        surfaces: U32,
        /// Address of the rays that hit there.
        rays: U32,
        /// Address of the packet of shadow rays.
        shadow: U32,
        /// Anything.
        unused: U32,
    }
}

record! {
    /// Local store: what shaders are told of the frame.
    ShaderContext as "SHADING" {
        /// The eye in the scene's coordinates: x, y, z, 0. Points are relative to it.
        eye: [F32; 4],
        /// Lights.
        light_count: U32,
        /// Address of the first `LIGHT`.
        lights: U32,
        /// 0.
        reserved: [U32; 2],
    }
}
