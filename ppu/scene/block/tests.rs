//! Tests that read blocks back in the SPUs' format.

mod bvh;
mod chains;
mod records;
mod refusals;
mod streamed;
mod traced;

use zerocopy::{FromBytes, Immutable, KnownLayout, Unaligned};

use super::*;
use protocol::layout::{FARTHEST, Node};

const VIEW: &str =
    "v\nfrom 0 0 0\nat 0 0 -1\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\nf 1 1 1 1 0 0 0 1\n";

/// A scene whose `rest` begins on line 9, after a material.
fn scene(rest: &str) -> Scene {
    let text = format!("{VIEW}{rest}");
    nff::parse(text.as_bytes(), "t.nff", &nff::Limits::default()).expect("a scene")
}

fn block(rest: &str) -> SceneBlock {
    of(&scene(rest), BlockOptions::default())
}

fn of(scene: &Scene, options: BlockOptions) -> SceneBlock {
    SceneBlock::new(scene, options, &entry).expect("a block")
}

/// The table of a program with four shaders.
fn entry(name: &str) -> Option<u32> {
    let names = ["checker", "depth", "rings", "sky"];
    let at = names.iter().position(|known| *known == name)?;
    Some(at as u32)
}

impl SceneBlock {
    /// The record at an address.
    fn at<T: FromBytes + KnownLayout + Immutable + Unaligned>(&self, address: U32) -> &T {
        let start = (address.get() - SCENE_ADDRESS) as usize;
        T::ref_from_prefix(&self.bytes()[start..])
            .expect("a record within the block")
            .0
    }

    /// The addresses of the objects of a kind, from left to right, found by walking down the tree.
    fn leaves(&self, kind: PrimitiveKind) -> Vec<U32> {
        let mut found = Vec::new();
        self.walk(kind, &mut |address, _| found.push(address));
        found
    }

    /// Calls `found` with every object's address and the bounding spheres above it, from the top.
    fn walk(&self, kind: PrimitiveKind, found: &mut impl FnMut(U32, &[(DVec3, f64)])) {
        let tree = self.bvhs()[kind as usize];
        let size = size_of::<Node>() as u32;
        for root in 0..tree.root_count.get() {
            let address = U32::new(tree.roots.get() + root * size);
            self.descend(address, tree.levels.get(), &mut Vec::new(), found);
        }
    }

    fn descend(
        &self,
        address: U32,
        levels: u32,
        above: &mut Vec<(DVec3, f64)>,
        found: &mut impl FnMut(U32, &[(DVec3, f64)]),
    ) {
        if levels == 0 {
            return found(address, above);
        }
        let node: &Node = self.at(address);
        for lane in 0..4 {
            let radius = f64::from(node.radius[lane].get());
            if radius < 0.0 {
                assert_eq!(node.radius[lane].get(), -f32::from_bits(FARTHEST));
                assert_eq!(node.child[lane].get(), SCENE_ADDRESS);
                continue;
            }
            let centre = wide([node.x[lane], node.y[lane], node.z[lane]]);
            above.push((centre, radius));
            self.descend(node.child[lane], levels - 1, above, found);
            above.pop();
        }
    }
}

fn wide(vector: [F32; 3]) -> DVec3 {
    DVec3::from_array(vector.map(|value| f64::from(value.get())))
}
