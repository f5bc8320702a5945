//! The functions that were called, by the ABI's back chain.
//!
//! The word at a function's stack pointer is its caller's. A function that calls others keeps its
//! return address 16 bytes above the stack pointer that it was entered with. Whether it has done
//! that yet, or ever will, is found in its instructions between its symbol and the program counter.
//! Hand-written code without frames shows one caller at most.

use spu_emulator::elf::Image;
use spu_emulator::interp::Spu;
use spu_emulator::local_store::{LocalStore, SIZE};
use spu_isa::{Instruction, LIMIT_MASK, Op};

const LINK: u8 = 0;
const STACK: u8 = 1;
/// Where the return address is, above the caller's stack pointer.
const LINK_SAVE: u32 = 16;
/// The longest chain, and the longest way from a symbol, that is believed.
const MOST: usize = 64;
const FARTHEST: u32 = 0x4000;

/// The effects of a function up to the program counter.
#[derive(Clone, Copy, Default)]
struct Prologue {
    has_kept_link: bool,
    has_frame: bool,
}

fn prologue(image: &Image<'_>, store: &LocalStore, pc: u32) -> Prologue {
    let mut found = Prologue::default();
    // The state that is restored after a return, where another path continues.
    let mut body = None;
    let Some((_, distance)) = image.nearest_symbol(pc).filter(|found| found.1 <= FARTHEST) else {
        return found;
    };
    for address in (pc - distance..pc).step_by(4) {
        let Some(i) = Instruction::decode(store.load_word(address)) else {
            continue;
        };
        match i.op {
            Op::Stqd if i.rt == LINK && i.ra == STACK => found.has_kept_link = true,
            Op::Ai | Op::A | Op::Sf if i.rt == STACK => {
                let before = *body.get_or_insert(found);
                found.has_frame = !before.has_frame;
                if found.has_frame {
                    body = None;
                }
            }
            Op::Lqd if i.ra == STACK && matches!(i.rt, STACK | LINK) => {
                body.get_or_insert(found);
                if i.rt == STACK {
                    found.has_frame = false;
                } else {
                    found.has_kept_link = false;
                }
            }
            Op::Bi => found = body.take().unwrap_or(found),
            _ => {}
        }
    }
    found
}

/// The program counter, and the return addresses of the functions that it is in.
pub fn backtrace(image: &Image<'_>, store: &LocalStore, spu: &Spu) -> Vec<u32> {
    let is_stack = |address: u32| address != 0 && address < SIZE && address.is_multiple_of(16);
    let mut frames = vec![spu.pc()];
    let found = prologue(image, store, spu.pc());
    let mut stack = spu.register(STACK).preferred();
    if !found.has_kept_link {
        let link = spu.register(LINK).preferred() & LIMIT_MASK;
        if link != 0 {
            frames.push(link);
        }
        if found.has_frame {
            stack = store.load_word(stack);
        }
    } else if !found.has_frame {
        let link = store.load_word(stack.wrapping_add(LINK_SAVE)) & LIMIT_MASK;
        frames.push(link);
    }
    while frames.len() < MOST && is_stack(stack) {
        let caller = store.load_word(stack);
        // The chain ends with 0, and goes up.
        if !is_stack(caller) || caller <= stack {
            break;
        }
        let link = store.load_word(caller.wrapping_add(LINK_SAVE)) & LIMIT_MASK;
        if link == 0 {
            break;
        }
        frames.push(link);
        stack = caller;
    }
    frames
}
