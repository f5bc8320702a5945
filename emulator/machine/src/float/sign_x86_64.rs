//! The signs of lanes, with the x86-64 instruction for them.

use std::arch::x86_64::{_mm_castsi128_ps, _mm_movemask_ps, _mm_set_epi32};

/// Whether the top bit of any lane is set.
#[inline(always)]
pub(super) fn any(lanes: [u32; 4]) -> bool {
    let [a, b, c, d] = lanes.map(|lane| lane as i32);
    // SAFETY: the intrinsics need SSE2, which every x86-64 has.
    let signs = unsafe { _mm_movemask_ps(_mm_castsi128_ps(_mm_set_epi32(d, c, b, a))) };
    signs != 0
}
