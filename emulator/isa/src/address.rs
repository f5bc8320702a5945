//! Local-store addresses. They have 18 bits.

/// Size of the address space, which is that of local store, in bytes.
pub const LOCAL_STORE_SIZE: u32 = 256 * 1024;
/// The value of the local-store limit register. Every address is ANDed with it.
pub const LIMIT_MASK: u32 = LOCAL_STORE_SIZE - 1;
