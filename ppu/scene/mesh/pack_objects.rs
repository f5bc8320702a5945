//! Packs spheres and cones in the order of their codes into leaf blocks, as SPUs do
//! (`spu/build/objects_pack.s`, `objects_boxes.s`). Their numbers are truncated as there.

use protocol::layout::{
    BUILD_CONE, BUILD_FEWEST, BUILD_MOST, BuildTriangle, Cone, MESH_BLOCK, MESH_CONES,
    MESH_SPHERES, MeshHeader, Object,
};
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::F32;

use super::Block;
use super::leaf::WIDTH;
use super::moved::MovedVertices;
use super::pack::corners;
use super::refit::put;
use super::tree::{Bounds, LEAF_NODES};
use super::write::{coordinate, header, no_boxes, offset};

/// Tangents to a square root: how steep they are, and a little more than how high they begin.
const TANGENTS: [[f32; 2]; 5] =
    [[0.5, 0.5], [1.0, 0.25], [2.0, 0.125], [4.0, 0.0625], [8.0, 0.031_25]];
const MORE: f32 = 1.0 + 1.0 / 128.0;

/// The block of the first objects, the box around them, and how many there are.
pub(super) fn pack_objects(
    objects: &[BuildTriangle],
    number: u32,
    records: &MovedVertices,
) -> (Block, Bounds, usize) {
    let is_cone = |object: &BuildTriangle| object.second.get() & BUILD_CONE != 0;
    let most = BUILD_MOST as usize;
    let of_cones = is_cone(&objects[0]);
    let such = objects.iter().take_while(|object| is_cone(object) == of_cones);
    let mut count = such.take(most + 1).count();
    if count > most {
        // Of the places where codes differ most, the last.
        let differs = |end: &usize| objects[*end].code.get() ^ objects[end - 1].code.get();
        count = (BUILD_FEWEST as usize..=most).max_by_key(differs).unwrap_or(most);
    }
    let lowest = count.div_ceil(WIDTH);
    let (levels, first) = if lowest > 1 { (2, 1) } else { (1, 0) };
    let mut nodes = [no_boxes(); LEAF_NODES];
    let nodes = &mut nodes[..first + lowest];
    let (kind, size) = match of_cones {
        false => (MESH_SPHERES, size_of::<Object>()),
        true => (MESH_CONES, size_of::<Cone>()),
    };
    let mut around = [Bounds::EMPTY; WIDTH];
    let mut bytes = Vec::with_capacity(count * size);
    let first_record = offset(nodes.len());
    for (at, object) in objects[..count].iter().enumerate() {
        let [place, ..] = corners(object);
        let quadword = |of: u32| *records.record(place + of);
        let bounds = match of_cones {
            false => {
                let record: Object = zerocopy::transmute!([0, 1, 2].map(quadword));
                bytes.extend(record.as_bytes());
                of_sphere(&record)
            }
            true => {
                let record: Cone = zerocopy::transmute!([0, 1, 2, 3].map(quadword));
                let object: Object = zerocopy::transmute!([0, 1, 2].map(quadword));
                bytes.extend(record.as_bytes());
                of_cone(&object, &record)
            }
        };
        let (group, lane) = (at / WIDTH, at % WIDTH);
        put(&mut nodes[first + group], lane, bounds);
        nodes[first + group].child[lane] = (first_record + (at * size) as u32).into();
        around[group] = around[group].with(bounds);
    }
    if levels > 1 {
        for (lane, bounds) in around[..lowest].iter().enumerate() {
            put(&mut nodes[0], lane, *bounds);
            nodes[0].child[lane] = offset(1 + lane).into();
        }
    }
    let header = MeshHeader {
        triangles: (count as u32).into(),
        ..header(number, kind, levels, nodes.len())
    };
    let mut block = Block([0; MESH_BLOCK as usize]);
    let all = [header.as_bytes(), nodes.as_bytes(), &bytes].concat();
    block.0[..all.len()].copy_from_slice(&all);
    (block, around.into_iter().fold(Bounds::EMPTY, Bounds::with), count)
}

fn of_sphere(record: &Object) -> Bounds {
    let radius = record.offset.get().abs();
    let corner = |sign: f32| record.centre.map(|it| fma(sign, radius, it.get())).into();
    Bounds { low: corner(-1.0), high: corner(1.0) }
}

/// The box around the two rims, a little larger.
fn of_cone(object: &Object, cone: &Cone) -> Bounds {
    let [radius, growth, height] = [cone.radius, cone.growth, cone.height].map(F32::get);
    let top = fma(growth, height, radius).max(0.0);
    let axes = [0, 1, 2].map(|axis| {
        let [base, along] = [object.centre[axis], object.axis[axis]].map(F32::get);
        // How far a disc of radius 1 across the axis reaches, or a little farther.
        let square = fma(-along, along, 1.0);
        let tangents = TANGENTS.map(|[slope, start]| fma(square, slope, MORE * start));
        let across = tangents.into_iter().fold(f32::INFINITY, f32::min);
        let apex = fma(along, height, base);
        [
            fma(-across, radius, base).min(fma(-across, top, apex)),
            fma(across, radius, base).max(fma(across, top, apex)),
        ]
    });
    Bounds { low: axes.map(|[low, _]| low).into(), high: axes.map(|[_, high]| high).into() }
}

/// a b + c as SPUs compute it: truncated once.
fn fma(a: f32, b: f32, c: f32) -> f32 {
    let [a, b, c] = [a, b, c].map(|it| f64::from(coordinate(it).get()));
    // The product of two singles is exact, and so is the error of the sum.
    let product = a * b;
    let sum = product + c;
    let part = sum - product;
    let error = (product - (sum - part)) + (c - part);
    let is_beyond = error != 0.0 && (error < 0.0) != (sum < 0.0);
    let truncated = f64::from_bits(sum.to_bits() - u64::from(is_beyond));
    let nearest = truncated as f32;
    let is_beyond = f64::from(nearest).abs() > truncated.abs();
    coordinate(f32::from_bits(nearest.to_bits() - u32::from(is_beyond))).get()
}
