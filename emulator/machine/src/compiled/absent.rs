//! Replaces the compiled engine where this crate was built without its feature `compiler`, or the
//! host has no compiler. The types exist, but have no values.

use std::cell::RefCell;
use std::fmt;
use std::sync::Arc;

use crate::channel::Channels;
use crate::interp::{Observer, Spu};
use crate::local_store::LocalStore;
use crate::simulated::{Marks, SpuClock};
use crate::stop::Stopped;
use spu_isa::Instruction;

#[path = "dispatch.rs"]
mod dispatch;
pub(crate) use dispatch::Dispatch;

/// The translations of a machine.
pub enum Translations {}

impl Translations {
    /// Returns `None`, because there is no compiler.
    #[must_use]
    pub fn new(_: bool, _: bool) -> Option<Arc<Self>> {
        None
    }

    pub(crate) fn with(_: bool, _: bool, _: bool) -> Option<Arc<Self>> {
        None
    }

    /// Sets the compile threshold. Without a compiler it is never called.
    pub fn compile_after(&self, _: u16) {
        match *self {}
    }

    /// Has all code optimized. Without a compiler it is never called.
    pub fn optimize_at_once(&self) {
        match *self {}
    }

    /// Has a thread of its own optimize. Without a compiler it is never called.
    pub fn optimize_in_background(&self) {
        match *self {}
    }

    /// The number of units that were compiled.
    #[must_use]
    pub fn units(&self) -> usize {
        match *self {}
    }

    /// The first difference that was found between compiled and interpreted code.
    #[must_use]
    pub fn difference(&self) -> Option<Difference> {
        match *self {}
    }
}

/// A run of instructions for which compiled code and the interpreter gave different results.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Difference {}

impl Difference {
    pub(crate) fn described(&self) -> (u32, String) {
        match *self {}
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, _: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {}
    }
}

/// Runs one SPU on compiled code and the interpreter.
pub enum Runner {}

impl Runner {
    /// Creates the runner of an SPU of the machine to which these translations belong.
    #[must_use]
    pub fn new(translations: &Arc<Translations>) -> Self {
        match **translations {}
    }

    /// The number of instructions that ran in compiled code.
    #[must_use]
    pub fn compiled(&self) -> u64 {
        match *self {}
    }

    /// Runs at most `limit` instructions. Returns `None` if the SPU can continue.
    pub fn run<C: Channels>(
        &mut self,
        _: &mut Spu,
        _: &LocalStore,
        _: &mut C,
        _: u64,
    ) -> Option<Stopped> {
        match *self {}
    }

    pub(crate) fn watch(&mut self, _: &Arc<Marks>) {
        match *self {}
    }

    pub(crate) fn may_enter(&self, _: u32) -> bool {
        match *self {}
    }

    pub(crate) fn run_timed<C: Channels>(
        &mut self,
        _: &mut Spu,
        _: &LocalStore,
        _: &mut C,
        _: u64,
        _: &RefCell<SpuClock>,
    ) -> Dispatch {
        match *self {}
    }

    pub(crate) fn start_recording_if_hot(&mut self, _: u32, _: &LocalStore) {
        match *self {}
    }

    pub(crate) fn is_recording(&self) -> bool {
        match *self {}
    }

    pub(crate) fn record_interpreted(
        &mut self,
        _: impl Iterator<Item = (u32, Instruction)>,
        _: u32,
        _: &LocalStore,
    ) {
        match *self {}
    }

    pub(crate) fn end_recording(&mut self) {
        match *self {}
    }

    /// As [`run`](Self::run), with calls to an observer.
    pub fn run_observed<C: Channels, O: Observer>(
        &mut self,
        _: &mut Spu,
        _: &LocalStore,
        _: &mut C,
        _: u64,
        _: &mut O,
    ) -> Option<Stopped> {
        match *self {}
    }
}
