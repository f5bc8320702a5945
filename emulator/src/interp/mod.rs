//! The interpreter: the definition of what each instruction does.
//!
//! One short function an instruction, grouped as the architecture's chapters are; the dispatch is
//! generated from the instruction table. It knows local store and the [`Channels`] trait, and
//! nothing of what answers behind the channels. It counts instructions, not cycles. No guest
//! program can make it panic or loop without asking [`Channels::stop_requested`].

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
pub use spu::Spu;

#[cfg(doc)]
use crate::channel::Channels;
