//! Class 0x2105: memory in effective address space.

use super::guest::{Block, Reply};
use super::{Call, Errno, Library, calls};

/// The alignment of allocations, so that all can be transferred in whole quadwords.
const ALIGNMENT: u64 = 16;

pub(super) const CALLS: &[Call] = calls! {
    calloc => |library, block| {
        let size = block.doubleword(0).checked_mul(block.doubleword(1));
        address(size.and_then(|size| library.heap().allocate(size, ALIGNMENT)))
    },
    free => |library, block| {
        // C does not define freeing anything else. Here it has no effect.
        library.heap().release(block.doubleword(0));
        Reply::Nothing
    },
    malloc => |library, block| address(library.heap().allocate(block.doubleword(0), ALIGNMENT)),
    realloc => |library, block| address(library.reallocate(block.doubleword(0), block.doubleword(1), ALIGNMENT)),
    posix_memalign => |library, block| library.posix_memalign(block),
};

/// The address, or null and `ENOMEM`.
fn address(allocated: Option<u64>) -> Reply {
    match allocated {
        Some(ea) => Reply::Doubleword(ea, 0),
        None => Reply::Doubleword(0, libc::ENOMEM),
    }
}

impl Library {
    /// Allocates memory of another size with the same contents, and frees the memory at `ea`. If
    /// memory is exhausted, the old memory remains. Size 0 frees it.
    pub(super) fn reallocate(&self, ea: u64, size: u64, alignment: u64) -> Option<u64> {
        const PIECE: u64 = 64 << 10;
        let mut heap = self.heap();
        if ea == 0 {
            return heap.allocate(size, alignment);
        }
        let before = heap.size_of(ea)?;
        if size == 0 {
            heap.release(ea);
            return Some(0);
        }
        let after = heap.allocate(size, alignment)?;
        let kept = before.min(size);
        for done in (0..kept).step_by(PIECE as usize) {
            let mut piece = vec![0; (kept - done).min(PIECE) as usize];
            if !heap.read(ea + done, &mut piece) || !heap.write(after + done, &piece) {
                heap.release(after);
                return None;
            }
        }
        heap.release(ea);
        Some(after)
    }

    /// The result is the error number, not -1. The address is written to local store as a
    /// doubleword.
    fn posix_memalign(&self, block: Block<'_>) -> Reply {
        const POINTER: u64 = 8;
        let (alignment, size) = (block.doubleword(1), block.doubleword(2));
        let allocated = if alignment.is_power_of_two() && alignment >= POINTER {
            let ea = self.heap().allocate(size, alignment);
            ea.ok_or(Errno(libc::ENOMEM))
        } else {
            Err(Errno(libc::EINVAL))
        };
        match allocated {
            Ok(ea) => {
                block.guest.write(block.word(0), &ea.to_be_bytes());
                0.into()
            }
            Err(Errno(errno)) => errno.into(),
        }
    }
}
