//! The part of a block that the objects of one shape take: first they, in the order of their tree,
//! then its nodes. Behind the objects there may be room for others, which the tree takes in when
//! they come.
//!
//! Invariant: what was written for an eye is written again only where it has changed.

use glam::DVec3;
use zerocopy::big_endian::U32;

use super::ball::{Ball, Hull};
use super::bytes::Block;
use super::form::Kind;
use super::objects::Object;
use super::tree::{self, Topology};
use protocol::layout::Tree;

/// Room for an object.
#[derive(Clone, Debug)]
struct Plot {
    address: u32,
    room: usize,
    object: Option<Planting>,
    /// Whether the room is kept for an object, be it there or not.
    taken: bool,
    /// Whether the record is of another object, or another eye.
    stale: bool,
    /// Whether the object is somewhere else than the tree has it.
    moved: bool,
}

/// An object where it is.
#[derive(Clone, Debug)]
struct Planting {
    object: Object,
    /// Address of its material.
    material: U32,
    /// As far as its rays start off it.
    leave: f64,
}

/// Objects of one shape and their tree.
#[derive(Clone, Debug)]
pub(super) struct Planted {
    kind: Kind,
    plots: Vec<Plot>,
    /// What the plots' objects are within.
    hulls: Vec<Option<Hull>>,
    topology: Topology,
    /// Whether the tree is over other objects.
    outgrown: bool,
    /// Where the nodes begin, and the bytes they may take.
    nodes: u32,
    nodes_room: usize,
}

impl Planted {
    /// Takes room for the objects, whose materials have these addresses, for `spare` others, and
    /// for a tree over them. The plots' numbers are the objects' places in the tree; `number` is
    /// told them.
    pub fn new(
        kind: Kind,
        found: &[Object],
        spare: usize,
        material: impl Fn(&Object) -> U32,
        mut number: impl FnMut(usize, usize),
        block: &mut Block,
    ) -> Self {
        let hulls: Vec<_> = found
            .iter()
            .map(|object| Some(object.form.hull()))
            .collect();
        let mut topology = Topology::default();
        topology.plant(&hulls);
        let mut plots = Vec::with_capacity(found.len() + spare);
        let mut in_order = Vec::with_capacity(found.len() + spare);
        for &index in topology.order() {
            number(index, plots.len());
            let object = &found[index];
            let mut plot = Plot::reserve(object.form.size(), block);
            plot.taken = true;
            plot.object = Some(Planting {
                object: object.clone(),
                material: material(object),
                leave: 0.0,
            });
            plots.push(plot);
            in_order.push(hulls[index]);
        }
        topology.renumber();
        for _ in 0..spare {
            plots.push(Plot::reserve(kind.least_size(), block));
            in_order.push(None);
        }
        let nodes_room = tree::size(plots.len());
        Self {
            kind,
            plots,
            hulls: in_order,
            topology,
            outgrown: false,
            nodes: block.reserve(nodes_room),
            nodes_room,
        }
    }

    /// A plot of so much room that is nobody's, which is taken from then on.
    pub fn take(&mut self, size: usize) -> Option<usize> {
        let is_free = |plot: &Plot| !plot.taken && plot.room >= size;
        let number = self.plots.iter().position(is_free)?;
        self.plots[number].taken = true;
        Some(number)
    }

    /// Gives a plot back.
    pub fn give_back(&mut self, number: usize) {
        self.clear(number);
        self.plots[number].taken = false;
    }

    /// Whether an object fits a plot.
    pub fn fits(&self, number: usize, object: &Object) -> bool {
        object.form.kind() == self.kind && object.form.size() <= self.plots[number].room
    }

    /// Puts an object that fits where another was, or none.
    pub fn put(&mut self, number: usize, object: Object, material: U32) {
        let plot = &mut self.plots[number];
        self.hulls[number] = Some(object.form.hull());
        plot.stale = true;
        plot.moved = true;
        self.outgrown |= plot.object.is_none();
        plot.object = Some(Planting {
            object,
            material,
            leave: 0.0,
        });
    }

    /// Takes an object away, if there is one.
    pub fn clear(&mut self, number: usize) {
        let plot = &mut self.plots[number];
        self.hulls[number] = None;
        plot.stale = false;
        plot.moved = false;
        self.outgrown |= plot.object.take().is_some();
    }

    /// The farthest that any object's own numbers have rays start off it, as written last.
    pub fn leave(&self) -> f64 {
        let leave = self.plantings().map(|planting| planting.leave);
        leave.fold(0.0, f64::max)
    }

    /// Writes what has changed as seen from `eye`; all records, if that is another eye.
    pub fn write(&mut self, eye: DVec3, is_other_eye: bool, block: &mut Block) {
        let mut is_changed = self.outgrown || is_other_eye;
        for plot in &mut self.plots {
            is_changed |= plot.moved;
            if !plot.stale && !is_other_eye {
                continue;
            }
            plot.stale = false;
            if let Some(planting) = &mut plot.object {
                planting.leave = planting.object.leave(eye);
                let bytes = block.at(plot.address, planting.object.form.size());
                planting.object.write(eye, planting.material, bytes);
            }
        }
        if !is_changed {
            return;
        }
        let Self {
            plots,
            hulls,
            topology,
            ..
        } = self;
        let is_good = !self.outgrown && topology.refit(|number| plots[number].moved, hulls);
        if !is_good {
            topology.plant(hulls);
        }
        self.outgrown = false;
        let plots = &mut self.plots;
        plots.iter_mut().for_each(|plot| plot.moved = false);
        let object = |number: usize| U32::new(plots[number].address);
        let nodes = block.at(self.nodes, self.nodes_room);
        self.topology.write(eye, self.nodes, object, nodes);
    }

    /// What the frame says of the tree. An object that is alone needs no node above it: the test
    /// of a node is not much cheaper than its own.
    pub fn tree(&self) -> Tree {
        let tree = self.topology.record(self.nodes);
        match *self.topology.order() {
            [only] => Tree {
                roots: self.plots[only].address.into(),
                levels: 0.into(),
                ..tree
            },
            _ => tree,
        }
    }

    pub fn count(&self) -> usize {
        self.plantings().count()
    }

    /// Bytes of all objects and nodes.
    pub fn size(&self) -> usize {
        let plots: usize = self.plots.iter().map(|plot| plot.room).sum();
        plots + self.nodes_room
    }

    /// How many plots there are.
    pub fn plot_count(&self) -> usize {
        self.plots.len()
    }

    /// Where a plot is, and the object there with its address, its material's and what it is
    /// within.
    pub fn plot(&self, number: usize) -> (u32, Option<(&Object, U32, Ball)>) {
        let plot = &self.plots[number];
        let object = plot.object.as_ref().map(|planting| {
            let ball = self.topology.ball(number);
            (&planting.object, planting.material, ball)
        });
        (plot.address, object)
    }

    fn plantings(&self) -> impl Iterator<Item = &Planting> {
        self.plots.iter().filter_map(|plot| plot.object.as_ref())
    }

    /// The objects in the order of the tree.
    #[cfg(test)]
    pub fn objects(&self) -> Vec<&Object> {
        let order = self.topology.order().iter();
        let objects = order.map(|&number| self.plots[number].object.as_ref());
        objects.flatten().map(|planting| &planting.object).collect()
    }
}

impl Plot {
    fn reserve(room: usize, block: &mut Block) -> Self {
        Self {
            address: block.reserve(room),
            room,
            object: None,
            taken: false,
            stale: false,
            moved: false,
        }
    }
}
