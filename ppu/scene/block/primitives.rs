//! The part of a block that has the primitives of one kind: first their records, in the order of
//! the leaves of their BVH, then spare capacity for more records, then the nodes.
//!
//! Invariant: for the same eye only the records that have changed are written again.

use glam::DVec3;
use zerocopy::big_endian::U32;

use super::bounding_sphere::{BoundingSphere, Hull};
use super::bounds::Bounds;
use super::bvh::{self, Bvh, Volumes};
use super::bytes::Block;
use super::cost::{boxes_gain, has_surface};
use super::objects::Object;
use super::primitive::PrimitiveKind;
use protocol::layout;

/// Reserved space for one object.
#[derive(Clone, Debug)]
struct Slot {
    address: u32,
    capacity: usize,
    object: Option<Placed>,
    /// Whether the slot belongs to an object, which may be hidden.
    taken: bool,
    /// Whether the record must be written again.
    stale: bool,
    /// Whether the object has moved since the tree was built or refitted.
    moved: bool,
}

/// An object in a slot.
#[derive(Clone, Debug)]
struct Placed {
    object: Object,
    /// The address of its material.
    material: U32,
    /// Its origin offset, as written last.
    leave: f64,
}

/// The primitives of one kind, and their BVH.
#[derive(Clone, Debug)]
pub(super) struct Primitives {
    kind: PrimitiveKind,
    slots: Vec<Slot>,
    /// The hulls of the slots' objects.
    hulls: Vec<Option<Hull>>,
    bvh: Bvh,
    /// Whether objects were added or removed since the tree was built.
    outgrown: bool,
    /// The address of the nodes, and below it the bytes that are reserved for them.
    nodes: u32,
    nodes_size: usize,
}

impl Primitives {
    /// Reserves space for objects, for `spare` more, and for a tree over all of them. `material`
    /// returns the address of an object's material. The slots' numbers are the objects' places in
    /// the tree; `number` is called with each object's index and its slot.
    pub fn new(
        kind: PrimitiveKind,
        found: &[Object],
        spare: usize,
        volumes: Volumes,
        material: impl Fn(&Object) -> U32,
        mut number: impl FnMut(usize, usize),
        block: &mut Block,
    ) -> Self {
        let hulls: Vec<_> = found.iter().map(|object| Some(object.primitive.hull())).collect();
        let mut bvh = Bvh::new(volumes);
        bvh.build(&hulls);
        let mut slots = Vec::with_capacity(found.len() + spare);
        let mut in_order = Vec::with_capacity(found.len() + spare);
        for &index in bvh.order() {
            number(index, slots.len());
            let object = &found[index];
            let mut slot = Slot::reserve(object.primitive.size(), block);
            slot.taken = true;
            slot.object =
                Some(Placed { object: object.clone(), material: material(object), leave: 0.0 });
            slots.push(slot);
            in_order.push(hulls[index]);
        }
        bvh.renumber();
        for _ in 0..spare {
            slots.push(Slot::reserve(kind.least_size(), block));
            in_order.push(None);
        }
        let nodes_size = bvh::size(slots.len(), volumes);
        Self {
            kind,
            slots,
            hulls: in_order,
            bvh,
            outgrown: false,
            nodes: block.reserve(nodes_size),
            nodes_size,
        }
    }

    /// Takes a free slot with at least `size` bytes, and returns its number.
    pub fn take(&mut self, size: usize) -> Option<usize> {
        let is_free = |slot: &Slot| !slot.taken && slot.capacity >= size;
        let number = self.slots.iter().position(is_free)?;
        self.slots[number].taken = true;
        Some(number)
    }

    /// Frees a slot.
    pub fn free(&mut self, number: usize) {
        self.clear(number);
        self.slots[number].taken = false;
    }

    /// Whether an object fits a slot.
    pub fn fits(&self, number: usize, object: &Object) -> bool {
        object.primitive.kind() == self.kind
            && object.primitive.size() <= self.slots[number].capacity
    }

    /// Puts an object that fits into a slot, in place of another or of none.
    pub fn put(&mut self, number: usize, object: Object, material: U32) {
        let slot = &mut self.slots[number];
        self.hulls[number] = Some(object.primitive.hull());
        slot.stale = true;
        slot.moved = true;
        self.outgrown |= slot.object.is_none();
        slot.object = Some(Placed { object, material, leave: 0.0 });
    }

    /// Removes the object in a slot, if there is one.
    pub fn clear(&mut self, number: usize) {
        let slot = &mut self.slots[number];
        self.hulls[number] = None;
        slot.stale = false;
        slot.moved = false;
        self.outgrown |= slot.object.take().is_some();
    }

    /// The largest origin offset of all objects, as written last.
    pub fn leave(&self) -> f64 {
        let leave = self.placed().map(|placed| placed.leave);
        leave.fold(0.0, f64::max)
    }

    /// Writes the changes relative to `eye`; all records if it is another eye than before.
    pub fn write(&mut self, eye: DVec3, is_other_eye: bool, block: &mut Block) {
        let mut is_changed = self.outgrown || is_other_eye;
        for slot in &mut self.slots {
            is_changed |= slot.moved;
            if !slot.stale && !is_other_eye {
                continue;
            }
            slot.stale = false;
            if let Some(placed) = &mut slot.object {
                placed.leave = placed.object.leave(eye);
                let bytes = block.at(slot.address, placed.object.primitive.size());
                placed.object.write(eye, placed.material, bytes);
            }
        }
        if !is_changed {
            return;
        }
        let Self { slots, hulls, bvh, .. } = self;
        let is_good = !self.outgrown && bvh.refit(|number| slots[number].moved, hulls);
        if !is_good {
            bvh.build(hulls);
        }
        self.outgrown = false;
        let slots = &mut self.slots;
        slots.iter_mut().for_each(|slot| slot.moved = false);
        let object = |number: usize| U32::new(slots[number].address);
        let nodes = block.at(self.nodes, self.nodes_size);
        self.bvh.write(eye, self.nodes, object, nodes);
    }

    /// The BVH's record in the frame. A single object has no node above it, because the test of a
    /// node is not much cheaper than the object's.
    pub fn record(&self) -> layout::Bvh {
        let record = self.bvh.record(self.nodes);
        match *self.bvh.order() {
            [only] => {
                layout::Bvh { roots: self.slots[only].address.into(), levels: 0.into(), ..record }
            }
            _ => record,
        }
    }

    /// The volumes of the BVH's nodes.
    pub fn volumes(&self) -> Volumes {
        self.bvh.volumes()
    }

    /// The volumes with which packets are expected to be traced faster within `scene`: the spheres
    /// that these primitives' tree has, unless one with boxes gains more than what the estimate may
    /// be off by.
    pub fn better_volumes(&self, scene: &Bounds) -> Volumes {
        if self.boxed_volumes() == Volumes::Spheres || !has_surface(scene) {
            return Volumes::Spheres;
        }
        let mut boxes = Bvh::new(Volumes::Boxes);
        boxes.build(&self.hulls);
        let [spheres, boxes] = [&self.bvh, &boxes].map(|bvh| bvh.expected_cycles(self.kind, scene));
        match boxes_gain(spheres, boxes) {
            true => Volumes::Boxes,
            false => Volumes::Spheres,
        }
    }

    /// Boxes if they are possible: spheres are always in spheres, and a single object has no node.
    pub fn boxed_volumes(&self) -> Volumes {
        match self.kind {
            PrimitiveKind::Rectangle | PrimitiveKind::Triangle | PrimitiveKind::Cone
                if self.count() > 1 =>
            {
                Volumes::Boxes
            }
            _ => Volumes::Spheres,
        }
    }

    /// A box around all objects.
    pub fn bounds(&self) -> Bounds {
        let hulls = self.hulls.iter().flatten();
        hulls.map(Hull::bounds).fold(Bounds::NOTHING, Bounds::with)
    }

    pub fn count(&self) -> usize {
        self.placed().count()
    }

    /// The bytes that are reserved for all objects and nodes.
    pub fn size(&self) -> usize {
        let slots: usize = self.slots.iter().map(|slot| slot.capacity).sum();
        slots + self.nodes_size
    }

    /// The number of slots, taken or free.
    pub fn slot_count(&self) -> usize {
        self.slots.len()
    }

    /// A slot's address, and its object with the address of its material and its bounding sphere.
    pub fn slot(&self, number: usize) -> (u32, Option<(&Object, U32, BoundingSphere)>) {
        let slot = &self.slots[number];
        let object = slot.object.as_ref().map(|placed| {
            let sphere = self.bvh.sphere(number);
            (&placed.object, placed.material, sphere)
        });
        (slot.address, object)
    }

    fn placed(&self) -> impl Iterator<Item = &Placed> {
        self.slots.iter().filter_map(|slot| slot.object.as_ref())
    }

    /// The objects in the order of the tree.
    #[cfg(test)]
    pub fn objects(&self) -> Vec<&Object> {
        let order = self.bvh.order().iter();
        let objects = order.map(|&number| self.slots[number].object.as_ref());
        objects.flatten().map(|placed| &placed.object).collect()
    }
}

impl Slot {
    fn reserve(capacity: usize, block: &mut Block) -> Self {
        Self {
            address: block.reserve(capacity),
            capacity,
            object: None,
            taken: false,
            stale: false,
            moved: false,
        }
    }
}
