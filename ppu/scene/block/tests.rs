//! Tests that read blocks back in the SPUs' format.

mod bvh;
mod chains;
mod records;
mod refusals;
mod streamed;
mod traced;

use scenes::Scene;
use zerocopy::big_endian::U32;
use zerocopy::{FromBytes, Immutable, KnownLayout, Unaligned};

use super::build::{Builder, Spare};
use super::primitive::PrimitiveKind;
use super::streamed::InMainMemory;
use super::*;
use crate::scene::Colour;
use crate::scene::render_options::NodeVolumes;
use crate::scene::single::singles;
use protocol::layout::{self, BoxNode, FARTHEST, Node, SCENE_ADDRESS, SCENE_CAPACITY};

const VIEW: &str =
    "v\nfrom 0 0 0\nat 0 0 -1\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\nf 1 1 1 1 0 0 0 1\n";

/// A scene whose `rest` begins on line 9, after a material.
fn scene(rest: &str) -> Scene {
    let text = format!("{VIEW}{rest}");
    scenes::parse(text.as_bytes(), "t.nff", &scenes::Limits::default()).expect("a scene")
}

fn block(rest: &str) -> SceneBlock {
    of(&scene(rest), RenderOptions::default())
}

fn of(scene: &Scene, options: RenderOptions) -> SceneBlock {
    SceneBlock::new(scene, options, &entry).expect("a block")
}

/// The block of a scene that does not fit as a whole, with everything in local store.
fn in_local_store(scene: &Scene, options: RenderOptions) -> Result<SceneBlock, BlockError> {
    Builder::new(scene, options, &entry).in_local_store(Spare::default())
}

/// A volume above an object, from the eye.
#[derive(Clone, Copy, Debug)]
enum Above {
    Sphere(DVec3, f64),
    /// The middle and half of the sizes.
    Box(DVec3, DVec3),
}

impl Above {
    fn holds(self, point: DVec3) -> bool {
        match self {
            Self::Sphere(centre, radius) => point.distance(centre) <= radius,
            Self::Box(centre, half) => (point - centre).abs().cmple(half).all(),
        }
    }

    /// Whether a ray from the eye misses it.
    fn is_missed(self, direction: DVec3) -> bool {
        match self {
            Self::Sphere(centre, radius) => {
                let along = centre.dot(direction).max(0.0);
                (centre - along * direction).length() > radius
            }
            Self::Box(centre, half) => {
                // An axis across the ray gives infinities, and no number if it is in the face.
                let [one, other] = [centre - half, centre + half].map(|corner| corner / direction);
                let enters = one.min(other).max_element().max(0.0);
                enters > one.max(other).min_element()
            }
        }
    }
}

/// The table of a program with five shaders.
fn entry(name: &str) -> Option<u32> {
    let names = ["checker", "depth", "portal", "rings", "sky"];
    let at = names.iter().position(|known| *known == name)?;
    Some(at as u32)
}

impl SceneBlock {
    /// The record at an address.
    fn at<T: FromBytes + KnownLayout + Immutable + Unaligned>(&self, address: U32) -> &T {
        let start = (address.get() - SCENE_ADDRESS) as usize;
        T::ref_from_prefix(&self.bytes()[start..]).expect("a record within the block").0
    }

    /// The addresses of the objects of a kind, from left to right, found by walking down the tree.
    fn leaves(&self, kind: PrimitiveKind) -> Vec<U32> {
        let mut found = Vec::new();
        self.walk(kind, &mut |address, _| found.push(address));
        found
    }

    /// Calls `found` with every object's address and the volumes above it, from the top.
    fn walk(&self, kind: PrimitiveKind, found: &mut impl FnMut(U32, &[Above])) {
        let tree = self.bvhs()[kind as usize];
        let volumes = self.primitives[kind as usize].volumes();
        let size = match volumes {
            Volumes::Spheres => size_of::<Node>(),
            Volumes::Boxes => size_of::<BoxNode>(),
        } as u32;
        for root in 0..tree.root_count.get() {
            let address = U32::new(tree.roots.get() + root * size);
            self.descend(address, volumes, tree.levels.get(), &mut Vec::new(), found);
        }
    }

    fn descend(
        &self,
        address: U32,
        volumes: Volumes,
        levels: u32,
        above: &mut Vec<Above>,
        found: &mut impl FnMut(U32, &[Above]),
    ) {
        if levels == 0 {
            return found(address, above);
        }
        let none = -f32::from_bits(FARTHEST);
        for lane in 0..4 {
            let (volume, child) = match volumes {
                Volumes::Spheres => {
                    let node: &Node = self.at(address);
                    let centre = wide([node.x[lane], node.y[lane], node.z[lane]]);
                    let radius = node.radius[lane].get();
                    let sphere = Above::Sphere(centre, f64::from(radius));
                    ((radius != none).then_some(sphere), node.child[lane])
                }
                Volumes::Boxes => {
                    let node: &BoxNode = self.at(address);
                    let centre = wide([node.x[lane], node.y[lane], node.z[lane]]);
                    let half = [node.half_x[lane], node.half_y[lane], node.half_z[lane]];
                    let is_none = half.map(F32::get) == [none; 3];
                    let volume = Above::Box(centre, wide(half));
                    ((!is_none).then_some(volume), node.child[lane])
                }
            };
            let Some(volume) = volume else {
                assert_eq!(child.get(), SCENE_ADDRESS);
                continue;
            };
            above.push(volume);
            self.descend(child, volumes, levels - 1, above, found);
            above.pop();
        }
    }
}

fn wide(vector: [F32; 3]) -> DVec3 {
    DVec3::from_array(vector.map(|value| f64::from(value.get())))
}
