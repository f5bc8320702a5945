//! Where nothing is compiled: the crate was built without its feature `compiler`, or the host has
//! no compiler. The types are there, and none of their values.

use std::cell::RefCell;
use std::fmt;
use std::sync::Arc;

use crate::channel::Channels;
use crate::interp::{Observer, Spu};
use crate::local_store::LocalStore;
use crate::simulated::SpuClock;
use crate::stop::Stopped;
use spu_isa::Instruction;

#[path = "turn.rs"]
mod turn;
pub(crate) use turn::Turn;

/// The translations of a machine.
pub enum Translations {}

impl Translations {
    /// `None`: there is no compiler for this host.
    #[must_use]
    pub fn new(_: bool, _: bool) -> Option<Arc<Self>> {
        None
    }

    /// Nothing is compiled at all.
    pub fn compile_after(&self, _: u8) {
        match *self {}
    }

    /// How many pieces of code were compiled.
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

/// A run of instructions that came out differently when it was compiled.
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

/// Runs one SPU.
pub enum Runner {}

impl Runner {
    /// An SPU of the machine that these translations are of.
    #[must_use]
    pub fn new(translations: &Arc<Translations>) -> Self {
        match **translations {}
    }

    /// How many instructions have run compiled, and not by the interpreter.
    #[must_use]
    pub fn compiled(&self) -> u64 {
        match *self {}
    }

    /// Runs at most `limit` instructions; `None` if the SPU would go on.
    pub fn run<C: Channels>(
        &mut self,
        _: &mut Spu,
        _: &LocalStore,
        _: &mut C,
        _: u64,
    ) -> Option<Stopped> {
        match *self {}
    }

    pub(crate) fn has(&self, _: u32) -> bool {
        match *self {}
    }

    pub(crate) fn run_timed<C: Channels>(
        &mut self,
        _: &mut Spu,
        _: &LocalStore,
        _: &mut C,
        _: u64,
        _: &RefCell<SpuClock>,
    ) -> Turn {
        match *self {}
    }

    pub(crate) fn come_to(&mut self, _: u32, _: &LocalStore) {
        match *self {}
    }

    pub(crate) fn records(&self) -> bool {
        match *self {}
    }

    pub(crate) fn interpreted(
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

    /// The same under the eyes of an observer.
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
