//! Converts the inputs of the twins of the kernels for primary rays to records, and records to the
//! twins' results.

use twins::Single;
use twins::isect_pairs::Hit;
use twins::sphere_ray::BareSphere;
use twins::{ray_setup, shade_depth};
use zerocopy::FromZeros as _;
use zerocopy::big_endian::F32;

use crate::single::{bits, single};
use protocol::layout::{Basis, Colours, Depth, Packet, Pair, PixelShuffle, Sphere};

/// The unit directions, or the colours, of a packet's rays.
pub type Vectors = [[Single; 3]; 16];

/// The hits of a packet's rays.
pub type Hits = [Hit; 16];

/// A packet.
#[must_use]
pub fn packet(directions: &Vectors, hits: &Hits) -> Packet {
    let [direction_x, direction_y, direction_z] = components(directions);
    Packet {
        direction_x,
        direction_y,
        direction_z,
        t: hits.map(|hit| single(hit.t)),
        object: hits.map(|hit| hit.object.into()),
    }
}

/// The directions in a packet.
#[must_use]
pub fn directions(packet: &Packet) -> Vectors {
    vectors([packet.direction_x, packet.direction_y, packet.direction_z])
}

/// The hits in a packet.
#[must_use]
pub fn hits(packet: &Packet) -> Hits {
    std::array::from_fn(|lane| Hit { t: bits(packet.t[lane]), object: packet.object[lane].get() })
}

/// A sphere of which only the position and the size are set.
#[must_use]
pub fn sphere(bare: &BareSphere) -> Sphere {
    Sphere {
        centre: bare.centre.map(single),
        radius_squared: single(bare.radius_squared),
        ..Sphere::new_zeroed()
    }
}

/// The position and the size of a sphere.
#[must_use]
pub fn bare_sphere(sphere: &Sphere) -> BareSphere {
    BareSphere { centre: sphere.centre.map(bits), radius_squared: bits(sphere.radius_squared) }
}

/// A pair.
#[must_use]
pub fn pair(object: u32, packet: u32) -> Pair {
    Pair { object: object.into(), packet: packet.into(), ..Pair::new_zeroed() }
}

/// A camera.
#[must_use]
pub fn basis(basis: &ray_setup::Basis) -> Basis {
    Basis {
        corner: basis.corner.map(splat),
        right: basis.right.map(splat),
        down: basis.down.map(splat),
    }
}

/// Depth shading.
#[must_use]
pub fn depth(depth: shade_depth::Depth) -> Depth {
    Depth { far: splat(depth.far), scale: splat(depth.scale) }
}

/// The colours of a packet.
#[must_use]
pub fn colours(colours: &Vectors) -> Colours {
    let [red, green, blue] = components(colours);
    Colours { red, green, blue }
}

/// The colours in a record.
#[must_use]
pub fn colour_vectors(colours: &Colours) -> Vectors {
    vectors([colours.red, colours.green, colours.blue])
}

/// The shuffle that turns colour bytes into words. `shifts` are the positions of red, green and
/// blue: different multiples of 8 up to 24.
#[must_use]
pub fn pixel_shuffle(shifts: [u32; 3]) -> PixelShuffle {
    const ZERO_BYTE: u8 = 0x80;
    const SECOND_OPERAND: u8 = 0x10;
    let [red, green, blue] = shifts.map(|shift| 3 - shift as usize / 8);
    let words = |make: &dyn Fn(u8, &mut [u8; 4])| {
        [0, 4, 8, 12].map(|first| {
            let mut bytes = [ZERO_BYTE; 4];
            make(first, &mut bytes);
            u32::from_be_bytes(bytes).into()
        })
    };
    PixelShuffle {
        red_green: words(&|first, bytes| {
            bytes[red] = first;
            bytes[green] = first + SECOND_OPERAND;
        }),
        blue: words(&|first, bytes| {
            *bytes = [first, first + 1, first + 2, first + 3];
            bytes[blue] = first + SECOND_OPERAND;
        }),
    }
}

fn splat(value: Single) -> [F32; 4] {
    [single(value); 4]
}

fn components(vectors: &Vectors) -> [[F32; 16]; 3] {
    [0, 1, 2].map(|axis| vectors.map(|vector| single(vector[axis])))
}

fn vectors(components: [[F32; 16]; 3]) -> Vectors {
    std::array::from_fn(|lane| components.map(|component| bits(component[lane])))
}
