//! The interpreter. It defines the effect of each instruction.
//!
//! Each instruction has one short function, or a line of which a macro makes one. They are grouped
//! as the architecture's chapters are. The dispatch is generated from the instruction table. The
//! interpreter uses local store and the [`Channels`] trait, and does not depend on the units that
//! serve the channels. It counts instructions, not cycles. No guest program can make it panic, or
//! loop without a call of [`Channels::stop_requested`].

/// Defines instructions that use registers only, one a line: `name(i): form(arguments);` calls a
/// method of [`Spu`] with the instruction `i` and the arguments.
macro_rules! instructions {
    ($($(#[$doc:meta])* $name:ident($i:ident): $form:ident($($argument:expr),*);)*) => {$(
        $(#[$doc])*
        #[inline]
        pub(super) fn $name(spu: &mut Spu, $i: Instruction) {
            spu.$form($i, $($argument),*);
        }
    )*};
}

mod block;
mod branch;
mod cache;
mod channel;
mod compare;
mod constant;
mod control;
mod dispatch;
mod float;
mod flow;
mod integer;
mod lanes;
mod load_store;
mod quad;
mod run;
mod shift_rotate;
mod spu;

pub(crate) use block::{Block, LONGEST, ends_block};
pub(crate) use flow::next;
pub use quad::Quad;
pub(crate) use run::Ended;
pub use run::Observer;
pub use spu::{QuadwordAccess, Spu};

#[cfg(doc)]
use crate::channel::Channels;
