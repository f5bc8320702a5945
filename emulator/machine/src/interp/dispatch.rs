//! Calls the function that implements an instruction, by the instruction table.

use super::flow::Flow;
use super::spu::Spu;
use super::{
    branch, channel, compare, constant, control, float, integer, load_store, shift_rotate,
};
use crate::channel::Channels;
use crate::local_store::LocalStore;
use spu_isa::{Instruction, Op, for_each_instruction};

/// Calls a function with the arguments that the functions of its group take.
macro_rules! call {
    (load_store $name:ident $spu:ident $ls:ident $channels:ident $pc:ident $i:ident) => {
        load_store::$name($spu, $ls, $pc, $i)
    };
    (branch $name:ident $spu:ident $ls:ident $channels:ident $pc:ident $i:ident) => {
        branch::$name($spu, $channels, $pc, $i)
    };
    (channel $name:ident $spu:ident $ls:ident $channels:ident $pc:ident $i:ident) => {
        channel::$name($spu, $channels, $pc, $i)
    };
    (control $name:ident $spu:ident $ls:ident $channels:ident $pc:ident $i:ident) => {
        control::$name($spu, $pc, $i)
    };
    (inert $name:ident $spu:ident $ls:ident $channels:ident $pc:ident $i:ident) => {
        ()
    };
    ($part:ident $name:ident $spu:ident $ls:ident $channels:ident $pc:ident $i:ident) => {
        $part::$name($spu, $i)
    };
}

macro_rules! match_op {
    (($spu:ident $ls:ident $channels:ident $pc:ident $i:ident)
        $($variant:ident $mnemonic:ident $opcode:literal $format:ident ($($operand:ident),*)
        [$($read:ident)*] $target:ident $class:ident $part:ident $machine:ident $summary:literal;)*) => {
        match $i.op {
            $(Op::$variant => Flow::from(call!($part $mnemonic $spu $ls $channels $pc $i)),)*
        }
    };
}

/// Runs the instruction at `pc`.
#[inline(always)]
pub(super) fn execute<C: Channels>(
    spu: &mut Spu,
    ls: &LocalStore,
    channels: &mut C,
    pc: u32,
    i: Instruction,
) -> Flow {
    for_each_instruction!(match_op!(spu ls channels pc i))
}
