//! The SPU registers as values of the emitted function.

use cranelift_codegen::ir::{Endianness, InstBuilder, MemFlagsData, Type, Value, types};

use super::bytes::ShuffleControl;
use super::{Emitter, field};

/// The number of a value that a register has or had. Several registers may share a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Id(usize);

/// Facts about a value that are known when code is emitted.
#[derive(Clone, Copy, Default)]
pub(super) struct Facts {
    /// Every lane is a single that has the same value in IEEE format: zero, or a number whose
    /// exponent field is 1 to 254. This holds only if the next commit succeeds.
    pub plain: bool,
    /// No lane is -0.
    pub no_negative_zero: bool,
    /// Each lane is all ones or all zeros.
    pub mask: bool,
    /// It is the result of `frest` or `frsqest`, so each lane's base is at least its step.
    pub estimate: bool,
    /// The result of a float operation that must be computed even if nobody reads it, because its
    /// exceptions count.
    pub raises: bool,
    /// Flags for its lanes with exponent 255 and its denormal lanes have been noted already.
    pub flags_noted: bool,
}

/// A value, in all forms that were needed so far.
#[derive(Clone, Default)]
pub(super) struct Node {
    /// As four words.
    pub words: Option<Value>,
    /// The four words, if they are known when code is emitted.
    pub constant: Option<[u32; 4]>,
    /// The preferred word.
    pub scalar: Option<Value>,
    /// Another value and a constant, if the preferred word is their sum.
    pub root: Option<(Id, u32)>,
    /// The lanes as doubles: words 0 and 1, words 2 and 3.
    pub doubles: Option<[Value; 2]>,
    /// Whether the value was computed as doubles, so that they are all of it. Doubles that were
    /// made from words have 0 for denormal lanes and for -0.
    pub is_of_doubles: bool,
    /// In double precision: the two slices.
    pub slices: Option<Value>,
    /// As singles, with +0 in place of -0.
    pub canonical: Option<Value>,
    /// As negated singles, with +0 for zeros.
    pub negated: Option<Value>,
    /// Integers that have the same order as the singles.
    pub order: Option<Value>,
    pub shuffle_control: Option<ShuffleControl>,
    pub facts: Facts,
    /// Whether it is certain to be computed: it is stored, written back, or an operand of
    /// arithmetic that is certain to be computed.
    pub computed: bool,
}

pub(super) struct Registers {
    nodes: Vec<Node>,
    slots: [Option<Id>; 128],
    changed: [bool; 128],
}

impl Default for Registers {
    fn default() -> Self {
        Self { nodes: Vec::new(), slots: [None; 128], changed: [false; 128] }
    }
}

impl Registers {
    fn add(&mut self, node: Node) -> Id {
        self.nodes.push(node);
        Id(self.nodes.len() - 1)
    }

    /// The registers whose values differ from those in memory, with their values.
    pub fn changed(&self) -> Vec<(u8, Id)> {
        let changed = (0..128u8).filter(|&register| self.changed[usize::from(register)]);
        changed
            .filter_map(|register| Some((register, self.slots[usize::from(register)]?)))
            .collect()
    }
}

impl Emitter<'_> {
    pub(super) fn node(&mut self, id: Id) -> &mut Node {
        &mut self.file.nodes[id.0]
    }

    pub(super) fn constant(&self, id: Id) -> Option<[u32; 4]> {
        self.file.nodes[id.0].constant
    }

    pub(super) fn facts(&self, id: Id) -> Facts {
        self.file.nodes[id.0].facts
    }

    /// The value of a register, which is loaded at its first use.
    pub(super) fn get(&mut self, register: u8) -> Id {
        let slot = usize::from(register);
        if let Some(id) = self.file.slots[slot] {
            return id;
        }
        let id = self.file.add(Node::default());
        let words = self.load_register(types::I32X4, register);
        self.node(id).words = Some(words);
        self.file.slots[slot] = Some(id);
        id
    }

    fn load_register(&mut self, ty: Type, register: u8) -> Value {
        let flags = MemFlagsData::trusted();
        let offset = 16 * i32::from(register);
        self.b.ins().load(ty, flags, self.registers, offset)
    }

    /// Sets a register to an existing value.
    pub(super) fn put(&mut self, register: u8, id: Id) {
        let slot = usize::from(register);
        let old = self.file.slots[slot].filter(|&old| old != id);
        if let Some(old) = old {
            self.force(old);
        }
        self.file.slots[slot] = Some(id);
        self.file.changed[slot] = true;
    }

    /// Stores a result whose exceptions count, so that it is computed although nobody reads it.
    fn force(&mut self, id: Id) {
        let node = self.node(id);
        if node.facts.raises && !node.computed {
            let words = self.words(id);
            self.store_field(words, field::SINK);
        }
    }

    pub(super) fn put_node(&mut self, register: u8, node: Node) {
        let id = self.file.add(node);
        self.put(register, id);
    }

    /// Sets a register to a value of any vector type.
    pub(super) fn set(&mut self, register: u8, value: Value) {
        self.set_with(register, value, Facts::default());
    }

    pub(super) fn set_with(&mut self, register: u8, value: Value, facts: Facts) {
        let words = self.cast(types::I32X4, value);
        self.put_node(register, Node { words: Some(words), facts, ..Node::default() });
    }

    pub(super) fn set_constant(&mut self, register: u8, words: [u32; 4]) {
        let exponent = |word: u32| word >> 23 & 0xff;
        let plain = |word: &u32| word & 0x7fff_ffff == 0 || (1..=254).contains(&exponent(*word));
        let facts = Facts {
            plain: words.iter().all(plain),
            no_negative_zero: words.iter().all(|&word| word != 1 << 31),
            mask: words.iter().all(|&word| word == 0 || word == u32::MAX),
            ..Facts::default()
        };
        self.put_node(register, Node { constant: Some(words), facts, ..Node::default() });
    }

    pub(super) fn words(&mut self, id: Id) -> Value {
        if let Some(words) = self.node(id).words {
            return words;
        }
        let node = self.node(id).clone();
        let words = match (node.constant, node.doubles) {
            (Some(words), _) => self.vector(words),
            (None, Some(doubles)) => self.narrow(doubles),
            (None, None) => unreachable!("every value has one of these forms"),
        };
        // Emitting a constant again costs no more than keeping it.
        if !self.in_side_exit && node.constant.is_none() {
            self.node(id).words = Some(words);
        }
        words
    }

    /// A register's value as a vector of this type.
    pub(super) fn lanes(&mut self, ty: Type, register: u8) -> Value {
        let id = self.get(register);
        let words = self.words(id);
        self.cast(ty, words)
    }

    /// The preferred word of a value.
    pub(super) fn scalar_of(&mut self, id: Id) -> Value {
        if let Some(scalar) = self.node(id).scalar {
            return scalar;
        }
        let node = self.node(id).clone();
        let scalar = if let Some(words) = node.constant {
            return self.word(words[0]);
        } else if let Some((root, distance)) = node.root {
            let scalar = self.scalar_of(root);
            self.b.ins().iadd_imm_s(scalar, i64::from(distance as i32))
        } else {
            let words = self.words(id);
            self.b.ins().extractlane(words, 0)
        };
        if !self.in_side_exit {
            self.node(id).scalar = Some(scalar);
        }
        scalar
    }

    /// The preferred word of a register.
    pub(super) fn scalar(&mut self, register: u8) -> Value {
        let id = self.get(register);
        self.scalar_of(id)
    }

    /// Sets a register's preferred word, and its other words to 0.
    pub(super) fn set_scalar(&mut self, register: u8, value: Value) {
        let zeros = self.vector([0; 4]);
        let words = self.b.ins().insertlane(zeros, value, 0);
        self.put_node(
            register,
            Node { words: Some(words), scalar: Some(value), ..Node::default() },
        );
    }

    /// Writes all changed registers to memory.
    pub(super) fn write_back(&mut self) {
        let changed = self.file.changed();
        self.write(&changed);
    }

    pub(super) fn write(&mut self, registers: &[(u8, Id)]) {
        for &(register, id) in registers {
            let words = self.words(id);
            self.node(id).computed = true;
            let flags = MemFlagsData::trusted();
            let offset = 16 * i32::from(register);
            self.b.ins().store(flags, words, self.registers, offset);
        }
    }

    /// The same bits as a value of another type.
    pub(super) fn cast(&mut self, ty: Type, value: Value) -> Value {
        if self.b.func.dfg.value_type(value) == ty {
            return value;
        }
        let flags = MemFlagsData::new().with_endianness(Endianness::Little);
        self.b.ins().bitcast(ty, flags, value)
    }

    pub(super) fn vector(&mut self, words: [u32; 4]) -> Value {
        self.constant_bytes(types::I32X4, words.map(u32::to_le_bytes).concat())
    }

    pub(super) fn splat(&mut self, word: u32) -> Value {
        self.vector([word; 4])
    }

    /// A constant of this type. `bytes` are in the order of the host's memory.
    pub(super) fn constant_bytes(&mut self, ty: Type, bytes: Vec<u8>) -> Value {
        let constant = self.b.func.dfg.constants.insert(bytes.into());
        self.b.ins().vconst(ty, constant)
    }

    /// Selects bytes of `a` (0 to 15) and `b` (16 to 31), counted in the host's order. Indices
    /// above 31 give 0.
    pub(super) fn shuffle(&mut self, a: Value, b: Value, from: [u8; 16]) -> Value {
        let (a, b) = (self.cast(types::I8X16, a), self.cast(types::I8X16, b));
        let mask = self.b.func.dfg.immediates.push(from.to_vec().into());
        self.b.ins().shuffle(a, b, mask)
    }
}
