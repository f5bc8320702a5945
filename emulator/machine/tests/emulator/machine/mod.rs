//! Tests of the machine around the SPU, with small programs that the GNU assembler assembles
//! during the test. A program that does not stop in time fails its test.

mod atomics;
mod channels;
mod dma;
mod elf;
mod events;
mod lists;
mod mailboxes;
mod random;
