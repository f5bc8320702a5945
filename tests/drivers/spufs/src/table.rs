//! The descriptors and mappings that the program has of spufs.
//!
//! Invariant: nothing is dropped while the table is locked, because that closes descriptors, which
//! looks into the table.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard};

use crate::context::{Context, lock};
use crate::file::Kind;

/// The file of a descriptor.
#[derive(Clone)]
pub(crate) enum Open {
    Gang(String),
    Context(String, Arc<Context>),
    File { context: Arc<Context>, kind: Kind, waits: bool },
}

/// Everything that the program has.
pub(crate) struct Table {
    open: BTreeMap<i32, Open>,
    /// Mapped addresses, and the contexts that they keep.
    mapped: Vec<(usize, Arc<Context>)>,
}

static TABLE: Mutex<Table> = Mutex::new(Table { open: BTreeMap::new(), mapped: Vec::new() });

pub(crate) fn table() -> MutexGuard<'static, Table> {
    lock(&TABLE)
}

impl Table {
    pub fn insert(&mut self, descriptor: i32, open: Open) {
        self.open.insert(descriptor, open);
    }

    pub fn paths(&self) -> impl Iterator<Item = &str> {
        self.open.values().filter_map(|open| match open {
            Open::Gang(path) | Open::Context(path, _) => Some(path.as_str()),
            Open::File { .. } => None,
        })
    }

    pub fn gangs(&self) -> impl Iterator<Item = &str> {
        self.open.values().filter_map(|open| match open {
            Open::Gang(path) => Some(path.as_str()),
            _ => None,
        })
    }

    pub fn map(&mut self, address: usize, context: Arc<Context>) {
        self.mapped.push((address, context));
    }
}

pub(crate) fn find(descriptor: i32) -> Option<Open> {
    table().open.get(&descriptor).cloned()
}

/// The program closes a descriptor.
pub(crate) fn close(descriptor: i32) {
    let closed = table().open.remove(&descriptor);
    drop(closed);
}

/// The program ends a mapping. Returns whether it was one of spufs.
pub(crate) fn unmap(address: usize) -> bool {
    let ended = {
        let mapped = &mut table().mapped;
        let at = mapped.iter().position(|(other, _)| *other == address);
        at.map(|at| mapped.swap_remove(at))
    };
    ended.is_some()
}
