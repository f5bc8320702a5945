//! The part of a block that the objects of one shape take: first they, in the order of their tree,
//! then its nodes.

use glam::DVec3;
use zerocopy::big_endian::U32;

use super::block::Block;
use super::objects::{Kind, Object};
use super::tree::Topology;
use crate::work::layout::Tree;

/// Objects of one shape and their tree.
#[derive(Clone, Debug)]
pub(super) struct Planted {
    kind: Kind,
    /// In the order of the tree.
    objects: Vec<Object>,
    /// Their materials' addresses.
    materials: Vec<U32>,
    /// Their own.
    addresses: Vec<U32>,
    topology: Topology,
    /// Where the nodes begin.
    nodes: u32,
}

impl Planted {
    /// Takes room for the objects, whose materials have these addresses, and for a tree over them.
    pub fn new(
        kind: Kind,
        found: &[Object],
        materials: impl Fn(&Object) -> U32,
        block: &mut Block,
    ) -> Self {
        let hulls: Vec<_> = found.iter().map(|object| object.form.hull()).collect();
        let topology = Topology::new(&hulls);
        let in_order = topology.order().iter().map(|&index| found[index].clone());
        let objects: Vec<Object> = in_order.collect();
        let addresses = objects
            .iter()
            .map(|object| U32::new(block.reserve(object.form.size())))
            .collect();
        Self {
            kind,
            materials: objects.iter().map(materials).collect(),
            objects,
            addresses,
            nodes: block.reserve(topology.size()),
            topology,
        }
    }

    /// The farthest that any object's own numbers have rays start off it.
    pub fn leave(&self, eye: DVec3) -> f64 {
        let leave = self.objects.iter().map(|object| object.leave(eye));
        leave.fold(0.0, f64::max)
    }

    /// Writes all records as seen from `eye`.
    pub fn write(&self, eye: DVec3, block: &mut Block) {
        let places = self.addresses.iter().zip(&self.materials);
        for (object, (address, material)) in self.objects.iter().zip(places) {
            object.write(eye, *material, block.at(address.get(), object.form.size()));
        }
        let nodes = block.at(self.nodes, self.topology.size());
        self.topology.write(eye, self.nodes, &self.addresses, nodes);
    }

    /// What the frame says of the tree. An object that is alone needs no node above it: the test of a
    /// node is not much cheaper than its own.
    pub fn tree(&self) -> Tree {
        let tree = self.topology.record(self.nodes);
        match self.addresses[..] {
            [only] => Tree {
                roots: only,
                levels: 0.into(),
                ..tree
            },
            _ => tree,
        }
    }

    pub fn kind(&self) -> Kind {
        self.kind
    }

    pub fn count(&self) -> usize {
        self.objects.len()
    }

    /// Bytes of all objects and nodes.
    pub fn size(&self) -> usize {
        let objects: usize = self.objects.iter().map(|object| object.form.size()).sum();
        objects + self.topology.size()
    }

    /// The objects in the order of the tree.
    #[cfg(test)]
    pub fn objects(&self) -> &[Object] {
        &self.objects
    }
}
