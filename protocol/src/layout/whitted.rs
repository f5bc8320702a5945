//! Records of Whitted's model: the scene as the PPU sends it, and what rays and hits are in local
//! store.
//!
//! All positions are relative to the eye. An address in a record of the scene is one of local store:
//! the scene is fetched to `SCENE_ADDRESS`, always.

use zerocopy::big_endian::{F32, U32};
use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

use super::{Field, Record};

record! {
    /// The beginning of every object: its surface near any of its points, in one form for all
    /// shapes.
    Object as "OBJECT" {
        /// Centre of a sphere, base of a cone, a point of a plane: x, y, z.
        centre: [F32; 3],
        /// 1 for a sphere, 1 / sqrt(1 + growth^2) for a cone, with the normal inwards negative; 0
        /// for a plane.
        gain: F32,
        /// 0 for a sphere, unit axis of a cone, unit normal of a plane: x, y, z.
        axis: [F32; 3],
        /// 0 for a sphere, -gain growth for a cone, 1 for a plane.
        slope: F32,
        /// Radius of a sphere, gain times radius at the base for a cone, with the sign of gain; 0
        /// for a plane.
        offset: F32,
        /// The part of `leave` in `SURFACES` that comes from the object's own numbers.
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
        /// The common beginning.
        object: [U32; 12],
        /// With u 1 along the first edge and 0 along the second: u = dual_u . (point - corner).
        dual_u: [F32; 4],
        /// The same for v and the second edge.
        dual_v: [F32; 4],
    }
}

record! {
    /// A triangle: follows its `OBJECT`. With `SIDES_SMOOTH` the normals of its vertices follow it.
    /// With `SIDES_TEXTURED` they follow it, too, and may be anything; then the last words of the
    /// vertices are the texture coordinates across, and those of the normals the ones down.
    Triangle as "TRI" {
        /// The common beginning.
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
        /// The common beginning.
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
    /// The material of a surface.
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
        /// Share that is transmitted, T.
        transmittance: F32,
        /// One over the index of refraction.
        inverse_index: F32,
        /// Index of refraction.
        index: F32,
        /// Schlick's F0; 0 where transmitting surfaces shall not reflect.
        schlick: F32,
        /// 1 - F0; 0 where transmitting surfaces shall not reflect.
        grazing: F32,
        /// Light that it emits: red, green, blue.
        emission: [F32; 3],
        /// `MATERIAL_` bits.
        flags: U32,
        /// Parameters of the shader.
        parameters: [F32; 4],
        /// Entry of the shader, in `SHADER_` order.
        shader: U32,
        /// Address of its `TEXTURE`; 0 if it has none.
        texture: U32,
        /// 0.
        reserved: [U32; 2],
    }
}

record! {
    /// A light.
    Light as "LIGHT" {
        /// Position, or the unit direction to a light that is infinitely far: x, y, z.
        position: [F32; 3],
        /// All ones if it is infinitely far. Else one over the square of its range, as a single's
        /// bits, which are 0 if it has none.
        falloff: U32,
        /// Brightness: red, green, blue.
        brightness: [F32; 3],
        /// Distance from the light at which shadow rays end, and its slack: see `bound_fan_r16`.
        near: F32,
    }
}

record! {
    /// Four bounding spheres, each around everything below it in the tree. An empty lane has
    /// -`FARTHEST` as its radius.
    Node as "NODE" {
        /// Centres, x.
        x: [F32; 4],
        /// Centres, y.
        y: [F32; 4],
        /// Centres, z.
        z: [F32; 4],
        /// Radii, with the rounding of the test.
        radius: [F32; 4],
        /// Addresses of nodes or, at the lowest level, of objects.
        child: [U32; 4],
    }
}

record! {
    /// Four boxes along the axes, each around everything below it in the tree. An empty lane has
    /// -`FARTHEST` as its half sizes.
    BoxNode as "BOX_NODE" {
        /// Centres, x.
        x: [F32; 4],
        /// Centres, y.
        y: [F32; 4],
        /// Centres, z.
        z: [F32; 4],
        /// Half of the sizes along x, with the rounding of the test.
        half_x: [F32; 4],
        /// The same along y.
        half_y: [F32; 4],
        /// The same along z.
        half_z: [F32; 4],
        /// Addresses of nodes or, at the lowest level, of objects.
        child: [U32; 4],
    }
}

record! {
    /// Objects of one shape, under nodes.
    Bvh as "BVH" {
        /// Address of the first node at the top of the tree, which the others follow; without
        /// levels, of the first object.
        roots: U32,
        /// Number of these nodes or objects; 0 if there is no object.
        root_count: U32,
        /// Levels of nodes.
        levels: U32,
        /// Objects.
        objects: U32,
    }
}

record! {
    /// Local store: sixteen rays from anywhere, and what they have hit; arrays of 16 in rows of
    /// four.
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
        /// The farthest distance that counts, later that of the nearest hit; -1 in a lane without a
        /// ray.
        t: [F32; 16],
        /// Address of the record of the object that was hit; of the background's if none was.
        object: [U32; 16],
        /// Weight of the ray's colour in its pixel.
        weight: [F32; 16],
        /// Address of its pixel's sum, a quadword of red, green, blue, anything, plus `CHAIN_STEP`
        /// for each ray of its chain that came before.
        pixel: [U32; 16],
    }
}

record! {
    /// Local store: one ray that waits to be traced.
    QueuedRay as "QUEUED" {
        /// Origin: x, y, z.
        origin: [F32; 3],
        /// Weight of the ray's colour in its pixel.
        weight: F32,
        /// Unit direction: x, y, z.
        direction: [F32; 3],
        /// As in `RAYS16`.
        pixel: U32,
    }
}

record! {
    /// Local store: the volume that holds a packet's rays, a sphere moved along a cone. Every value
    /// is in all four lanes, except in the last fields.
    Bound as "BOUND" {
        /// Middle of the rays' origins, x.
        apex_x: [F32; 4],
        /// The same, y.
        apex_y: [F32; 4],
        /// The same, z.
        apex_z: [F32; 4],
        /// Axis of the directions, a unit vector, x; 0 if they go every way.
        axis_x: [F32; 4],
        /// The same, y.
        axis_y: [F32; 4],
        /// The same, z.
        axis_z: [F32; 4],
        /// Cosine of the largest angle between a direction and the axis, rounded down; 0 if they go
        /// every way.
        cosine: [F32; 4],
        /// Its sine, rounded up; 0 if they go every way.
        sine: [F32; 4],
        /// Largest distance of an origin from the middle, rounded up; far below 0 if there is no
        /// ray.
        radius: [F32; 4],
        /// Largest distance that a ray counts to.
        farthest: [F32; 4],
        /// The middle again: x, y, z, anything.
        apex: [F32; 4],
        /// The axis again: x, y, z, anything.
        axis: [F32; 4],
        /// Sine, radius, anything, anything.
        limits: [F32; 4],
    }
}

record! {
    /// The head of a tile's `PATH` records.
    Paths as "PATHS" {
        /// Records that follow.
        count: U32,
        /// 0.
        reserved: [U32; 3],
    }
}

record! {
    /// The volume that a packet's rays have crossed up to where they hit: a `BOUND` in short, and
    /// the part of the tile that depends on them.
    Path as "PATH" {
        /// Middle of the rays' origins: x, y, z.
        apex: [F32; 3],
        /// As in `BOUND`.
        radius: F32,
        /// Axis of the directions: x, y, z.
        axis: [F32; 3],
        /// As in `BOUND`.
        cosine: F32,
        /// As in `BOUND`.
        sine: F32,
        /// Largest distance that a ray has gone.
        farthest: F32,
        /// The subtiles whose pixels the rays belong to, a bit each: row by row from the
        /// top left, from the lowest bit.
        subtiles: U32,
        /// 0.
        reserved: U32,
    }
}

record! {
    /// Local store: a node or an object, and a packet to test with it.
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
    /// Local store: rays' own axes for the triangle test, made by `shear_packets_r16`; rows of
    /// four.
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
    /// Local store: the points that sixteen rays have hit, and the surfaces there. For a ray that
    /// hits nothing this is the background.
    Surfaces as "SURFACES" {
        /// Points on the surfaces, x.
        point_x: [F32; 16],
        /// Points, y.
        point_y: [F32; 16],
        /// Points, z.
        point_z: [F32; 16],
        /// Shading normals, unit vectors on the ray's side, x.
        normal_x: [F32; 16],
        /// The same, y.
        normal_y: [F32; 16],
        /// The same, z.
        normal_z: [F32; 16],
        /// Normals of the surfaces themselves, unit vectors on the ray's side, x.
        plane_x: [F32; 16],
        /// The same, y.
        plane_y: [F32; 16],
        /// The same, z.
        plane_z: [F32; 16],
        /// Distance from the surface at which a ray must start, so that it does not meet it again.
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
        /// Share that is transmitted.
        transmittance: [F32; 16],
        /// Index of refraction on the ray's side over that beyond.
        ratio: [F32; 16],
        /// Schlick's F0.
        schlick: [F32; 16],
        /// 1 - F0, or 0.
        grazing: [F32; 16],
        /// Light sent back along the ray so far, red.
        lit_red: [F32; 16],
        /// The same, green.
        lit_green: [F32; 16],
        /// The same, blue.
        lit_blue: [F32; 16],
        /// Address of the material.
        material: [U32; 16],
        /// The `MATERIAL_` and `SIDES_` bits that the material or object of any lane has. In the
        /// second word, the bits of `MESH_VISIBILITY` of all lanes. If there are any, `origin_x` of
        /// the rays has those of each lane when the surfaces are lit.
        flags: [U32; 4],
    }
}

record! {
    /// Local store: a packet of hits to light.
    Site as "SITE" {
        /// Address of the `SURFACES`.
        surfaces: U32,
        /// Address of the rays that hit there.
        rays: U32,
        /// `SITE_SHINES` if a surface of the packet may have a highlight, else 0.
        shines: U32,
        /// Address of the packet's rays to the light; anything before these are traced.
        shadow: U32,
    }
}

record! {
    /// Local store: the data of the frame that shaders get.
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
