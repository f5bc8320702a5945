//! The machine around the SPU's instructions, by small programs that the GNU assembler makes here
//! and now. Every wait of these tests ends: a program that does not stop in time fails its test.

mod atomics;
mod channels;
mod dma;
mod elf;
mod errors;
mod events;
mod lists;
mod mailboxes;
mod ordering;
mod random;
mod support;
