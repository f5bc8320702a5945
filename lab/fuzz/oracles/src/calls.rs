//! Library calls with arbitrary arguments, in a library that can do no harm: without files, and
//! with a host that only counts.

use std::sync::Arc;

use spu_emulator::local_store::LocalStore;
use spu_emulator::memory::RegisteredMemory;
use spu_emulator::ppe_call::{Arena, Errno, Host, Library};

/// Effective addresses that a guest can allocate. Few bits of an input reach them.
const HEAP: u64 = 0x1_0000;
const HEAP_SIZE: usize = 0x1_0000;

/// The stop's following word, and the block of arguments.
const OPCODE_WORD: u32 = 0x400;
const BLOCK: u32 = 0x1000;

/// Classes with the opcodes that name no file, no descriptor of the host and no process. Calls that
/// write or read descriptors go to the [`Host`].
const CALLS: [(u8, &[u8]); 3] = [
    (
        0,
        &[
            1, 3, 4, 5, 6, 8, 11, 12, 13, 18, 19, 20, 21, 22, 23, 24, 25, 29, 30, 33, 34, 35, 36,
            37, 38, 39, 40, 41,
        ],
    ),
    (1, &[1, 6, 7, 12, 13, 14, 16, 17, 21, 27, 31, 61, 67, 68]),
    (5, &[1, 2, 3, 4, 5]),
];

/// Gives the same short text again and again, and forgets what is written.
struct Nowhere;

impl Host for Nowhere {
    fn read(&self, descriptor: i32, into: &mut [u8]) -> Result<usize, Errno> {
        const TEXT: &[u8] = b"12 -0x3f 1e5 word [a]\n";
        if descriptor != 0 {
            return Err(Errno(9));
        }
        let length = into.len().min(TEXT.len());
        into[..length].copy_from_slice(&TEXT[..length]);
        Ok(length)
    }

    fn write(&self, _: i32, from: &[u8]) -> Result<usize, Errno> {
        Ok(from.len())
    }

    fn is_terminal(&self, descriptor: i32) -> bool {
        descriptor == 1
    }
}

/// Makes a call for each 64 bytes of the input, the first of which chooses the call. The rest is
/// the block of arguments, and the whole input is also put where small numbers point. No call may
/// panic.
pub fn calls(input: &[u8]) {
    const CALL: usize = 64;
    let memory = Arc::new(RegisteredMemory::new());
    let Ok(heap) = Arena::new(&memory, HEAP, HEAP_SIZE) else {
        return;
    };
    let library = Library::new(Box::new(Nowhere), Box::new(heap));
    let store = LocalStore::new();
    store.write(0, &input[..input.len().min(OPCODE_WORD as usize)]);
    for call in input.chunks(CALL) {
        let (class, opcodes) = CALLS[usize::from(call[0]) % CALLS.len()];
        let opcode = opcodes[usize::from(call[0]) / CALLS.len() % opcodes.len()];
        store.write(BLOCK, &call[1..]);
        let word = u32::from(opcode) << 24 | BLOCK;
        store.write(OPCODE_WORD, &word.to_be_bytes());
        let served = library.serve(class, &store, OPCODE_WORD);
        assert!(served.is_ok(), "{class} {opcode}");
    }
    let _ = library.flush();
}
