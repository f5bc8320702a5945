//! Records in local store by which primary rays are traced to spheres.

use zerocopy::big_endian::{F32, U32};
use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

use super::{Field, Record};

record! {
    /// Local store: sixteen primary rays and what they have hit; arrays of 16 in rows of four.
    Packet as "PACKET" {
        /// Unit directions, x.
        direction_x: [F32; 16],
        /// Unit directions, y.
        direction_y: [F32; 16],
        /// Unit directions, z.
        direction_z: [F32; 16],
        /// Distance of the nearest hit so far; `FARTHEST` if none.
        t: [F32; 16],
        /// Address of the record of the object that was hit; of the background's if none was.
        object: [U32; 16],
    }
}

record! {
    /// Local store: camera of the frame, every value in all four lanes.
    Basis as "BASIS" {
        /// Direction through pixel (0, 0): x, y, z.
        corner: [[F32; 4]; 3],
        /// Step to the next pixel: x, y, z.
        right: [[F32; 4]; 3],
        /// Step to the next row: x, y, z.
        down: [[F32; 4]; 3],
    }
}

record! {
    /// Local store: a packet of the current group, and the place of its pixels.
    Place as "PLACE" {
        /// Address of the packet.
        packet: U32,
        /// Address of its top left pixel in the tile buffer.
        pixels: U32,
        /// Column of that pixel in the picture.
        x: U32,
        /// Row of that pixel.
        y: U32,
    }
}

record! {
    /// Local store: an object and a packet to test with it.
    Pair as "PAIR" {
        /// Address of the object's record.
        object: U32,
        /// Address of the packet.
        packet: U32,
        /// Anything.
        unused: [U32; 2],
    }
}

record! {
    /// Local store: four planes through the eye, one a lane; their normals point inwards.
    Frustum as "FRUSTUM" {
        /// Unit normals, x.
        normal_x: [F32; 4],
        /// Unit normals, y.
        normal_y: [F32; 4],
        /// Unit normals, z.
        normal_z: [F32; 4],
    }
}

record! {
    /// Local store: depth shading of the frame, every value in all four lanes.
    Depth as "DEPTH" {
        /// Distance at which everything is black.
        far: [F32; 4],
        /// One over the distance in which it fades.
        scale: [F32; 4],
    }
}

record! {
    /// Local store: colours of a packet, 0 to 1 (more is shown as 1).
    Colours as "COLOURS" {
        /// Red.
        red: [F32; 16],
        /// Green.
        green: [F32; 16],
        /// Blue.
        blue: [F32; 16],
    }
}

record! {
    /// Local store: shuffles that turn three quadwords of colour bytes into the framebuffer's
    /// words.
    PixelShuffle as "PIXELS" {
        /// Takes red and green to their places in the word.
        red_green: [U32; 4],
        /// Takes blue to its place.
        blue: [U32; 4],
    }
}
