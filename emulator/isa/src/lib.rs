//! The instruction set of the Cell's SPU, and the pipelines that issue it.
//!
//! [`Instruction::decode`] decodes a word, [`Instruction::encode`] encodes it again, and
//! [`disassemble`] writes it in assembly syntax. All three are expansions of one table.
//! [`Op::row`] returns a row of it, and [`for_each_instruction`] passes the whole table to a
//! macro. [`timing`] computes the cycle in which each instruction issues, and what delays it.
//!
//! Nothing here depends on a machine: there are no register values, no memory, no files.
//!
//! ```
//! use spu_isa::timing::{Cause, Rules, straight_line};
//! use spu_isa::{Class, Instruction, disassemble};
//!
//! // Load a quadword, and add 1 to its words.
//! let code = [(0, 0x3400_0203), (4, 0x1c00_4184)];
//! let text = code.map(|(address, word)| disassemble(word, address).to_string());
//! assert_eq!(text, ["lqd\t$3,0($4)", "ai\t$4,$3,1"]);
//! assert_eq!(Instruction::decode(code[0].1).map(Instruction::encode), Some(code[0].1));
//!
//! // The sum waits for the load.
//! let schedule = straight_line(&code, Rules::default());
//! let account = schedule.account.expect("both words are instructions");
//! assert_eq!(account.waited(Cause::Operand(Class::Ls)), 5);
//! ```

mod address;
mod instructions;
pub mod timing;

pub use address::{LIMIT_MASK, LOCAL_STORE_SIZE};
pub use instructions::{
    Class, Disassembly, Field, Format, Instruction, Machine, Op, Operand, Pipe, RegisterSet, Row,
    Target, disassemble, feature,
};

/// The examples of the readme.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
