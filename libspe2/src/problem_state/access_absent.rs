//! Processors whose loads and stores are not decoded.

use libc::c_void;

pub(super) const SUPPORTED: bool = false;

pub(super) enum Access {
    Load,
    Store(u32),
}

pub(super) struct Decoded {
    pub access: Access,
}

/// # Safety
/// None.
pub(super) unsafe fn decode(_: *mut c_void) -> Option<Decoded> {
    None
}

impl Decoded {
    /// # Safety
    /// None.
    pub unsafe fn set_result(&self, _: *mut c_void, _: u32) {}

    /// # Safety
    /// None.
    pub unsafe fn step(&self, _: *mut c_void) {}
}
