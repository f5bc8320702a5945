//! Addresses: an SPU has 18 bits of them.

/// Bytes that an address reaches: the local store.
pub const LOCAL_STORE_SIZE: u32 = 256 * 1024;
/// The local-store limit register's value: every address is ANDed with it.
pub const LIMIT_MASK: u32 = LOCAL_STORE_SIZE - 1;
