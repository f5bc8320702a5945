//! The map of effective address space. All addresses are below 4 GB, so that their high word is 0.

/// The map as shown by `--help`.
pub const MAP_HELP: &str =
    "  0x10000000  the program's file        0x20000000  heap of malloc_ea and mmap_ea
  0x18000000  arguments                 0x40000000  local store (also in $6 at the start)
  --main-memory adds other regions; addresses from 0x60000000 on are free.";
/// The program's file.
pub const IMAGE_EA: u64 = 0x1000_0000;
/// The program's arguments.
pub const ARGUMENTS_EA: u64 = 0x1800_0000;
/// The heap from which the program allocates main memory.
pub const HEAP_EA: u64 = 0x2000_0000;
/// The SPE's local store.
pub const LOCAL_STORE_EA: u64 = 0x4000_0000;
