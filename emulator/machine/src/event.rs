//! SPU events: pending bits, the mask, and the count of channel 0.
//!
//! An event is an edge: a count that rises from 0. It stays pending until the SPU acknowledges it.
//! Invariant: the count of channel 0 rises only when an enabled event is pending, and falls only
//! when the channel is read. So an event that is acknowledged or masked before it is read leaves a
//! "phantom", a read that yields 0, as on hardware.

/// A multisource synchronisation is complete.
pub const MULTISOURCE_SYNC: u32 = 0x1000;
/// The lock-line reservation is lost.
pub const RESERVATION_LOST: u32 = 0x0400;
/// Signal-notification register 1 has a value.
pub const SIGNAL_1: u32 = 0x0200;
/// Signal-notification register 2 has a value.
pub const SIGNAL_2: u32 = 0x0100;
/// The outbound mailbox is not full any more.
pub const OUTBOUND_ROOM: u32 = 0x0080;
/// The outbound interrupt mailbox is not full any more.
pub const OUTBOUND_INTERRUPT_ROOM: u32 = 0x0040;
/// The decrementer passed from 0 to negative.
pub const DECREMENTER: u32 = 0x0020;
/// The inbound mailbox has data.
pub const INBOUND_DATA: u32 = 0x0010;
/// The MFC queue is not full any more.
pub const QUEUE_ROOM: u32 = 0x0008;
/// A list command has stalled.
pub const LIST_STALL: u32 = 0x0002;
/// A tag status can be read.
pub const TAG_STATUS: u32 = 0x0001;

#[derive(Debug, Default)]
pub(crate) struct Events {
    pending: u32,
    mask: u32,
    count: bool,
}

impl Events {
    pub(crate) fn raise(&mut self, events: u32) {
        self.pending |= events;
        self.count |= events & self.mask != 0;
    }

    pub(crate) fn mask(&self) -> u32 {
        self.mask
    }

    pub(crate) fn set_mask(&mut self, mask: u32) {
        self.mask = mask;
        self.count |= self.pending & mask != 0;
    }

    pub(crate) fn acknowledge(&mut self, events: u32) {
        self.pending &= !events;
        self.count |= self.pending & self.mask != 0;
    }

    /// The events that have occurred, whether they are enabled or not.
    pub(crate) fn pending(&self) -> u32 {
        self.pending
    }

    /// The count of channel 0.
    pub(crate) fn count(&self) -> bool {
        self.count
    }

    /// The value that channel 0 reads, if its count is not 0.
    pub(crate) fn read(&mut self) -> Option<u32> {
        std::mem::take(&mut self.count).then_some(self.pending & self.mask)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reading_leaves_the_event_pending_until_acknowledged() {
        let mut events = Events::default();
        events.raise(SIGNAL_1);
        assert_eq!(events.read(), None);
        events.set_mask(SIGNAL_1 | INBOUND_DATA);
        assert_eq!(events.read(), Some(SIGNAL_1));
        assert_eq!(events.read(), None);
        events.raise(INBOUND_DATA);
        assert_eq!(events.read(), Some(SIGNAL_1 | INBOUND_DATA));
        events.acknowledge(SIGNAL_1);
        assert_eq!(events.read(), Some(INBOUND_DATA));
        events.acknowledge(INBOUND_DATA);
        assert_eq!(events.read(), None);
    }

    #[test]
    fn an_event_acknowledged_unread_leaves_a_phantom() {
        let mut events = Events::default();
        events.set_mask(TAG_STATUS);
        events.raise(TAG_STATUS);
        events.acknowledge(TAG_STATUS);
        assert!(events.count());
        assert_eq!(events.read(), Some(0));
        assert!(!events.count());
    }
}
