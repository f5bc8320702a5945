//! The signs of lanes, for every host.

/// Whether the top bit of any lane is set.
#[inline(always)]
pub(super) fn any(lanes: [u32; 4]) -> bool {
    ((lanes[0] | lanes[1] | lanes[2] | lanes[3]) as i32) < 0
}
