//! Data in flight between local stores: sent by MFC commands, but not yet arrived.
//!
//! The SPU finds the data in its local store from the cycle in which the transfer is complete. The
//! MFC's operations may see it earlier: a read over the bus or a synchronisation delivers it
//! early. Both orders are legal for the MFC. Invariant: data that was sent to the same place is
//! delivered in the order of arrival.

use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::Ordering::SeqCst;

use portable_atomic::AtomicU64;

use super::time::NEVER;
use crate::lock::lock;
use crate::mfc::timing::PendingWrite;

/// The data in flight in one machine.
pub(crate) struct Arrivals {
    /// The cycle of the next arrival.
    next: AtomicU64,
    /// The pending writes by cycle of arrival, then in the order of sending.
    pending: Mutex<BTreeMap<(u64, u64), PendingWrite>>,
    sent: AtomicU64,
}

impl Default for Arrivals {
    fn default() -> Self {
        Self { next: AtomicU64::new(NEVER), pending: Mutex::default(), sent: AtomicU64::new(0) }
    }
}

impl Arrivals {
    /// The cycle of the next arrival.
    pub fn next(&self) -> u64 {
        self.next.load(SeqCst)
    }

    /// Sends data that arrives in `cycle`.
    pub fn send(&self, cycle: u64, write: PendingWrite) {
        let mut pending = lock(&self.pending);
        let number = self.sent.fetch_add(1, SeqCst);
        pending.insert((cycle, number), write);
        self.note_next(&pending);
    }

    /// Delivers all data that has arrived at `now`.
    pub fn deliver(&self, now: u64) {
        if self.next() > now {
            return;
        }
        let mut pending = lock(&self.pending);
        while let Some(entry) = pending.first_entry()
            && entry.key().0 <= now
        {
            entry.remove().deliver();
        }
        self.note_next(&pending);
    }

    /// Delivers the selected data at once.
    pub fn deliver_early(&self, wanted: impl Fn(&PendingWrite) -> bool) {
        if self.next() == NEVER {
            return;
        }
        let mut pending = lock(&self.pending);
        pending.retain(|_, write| {
            let stays = !wanted(write);
            if !stays {
                write.deliver();
            }
            stays
        });
        self.note_next(&pending);
    }

    fn note_next(&self, pending: &BTreeMap<(u64, u64), PendingWrite>) {
        let next = pending.first_key_value().map_or(NEVER, |(key, _)| key.0);
        self.next.store(next, SeqCst);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::local_store::LocalStore;
    use std::sync::Arc;

    fn write(store: &Arc<LocalStore>, address: u32, bytes: &[u8]) -> PendingWrite {
        PendingWrite { store: Arc::clone(store), address, bytes: bytes.into() }
    }

    fn bytes(store: &LocalStore) -> [u8; 4] {
        let mut bytes = [0; 4];
        store.read(0x100, &mut bytes);
        bytes
    }

    #[test]
    fn data_arrives_in_its_cycle_and_in_the_order_of_arrival() {
        let (arrivals, store) = (Arrivals::default(), Arc::new(LocalStore::new()));
        assert_eq!(arrivals.next(), NEVER);
        arrivals.send(50, write(&store, 0x100, &[1, 1]));
        arrivals.send(30, write(&store, 0x101, &[2, 2]));
        arrivals.send(50, write(&store, 0x101, &[3]));
        arrivals.deliver(29);
        assert_eq!((bytes(&store), arrivals.next()), ([0; 4], 30));
        arrivals.deliver(49);
        assert_eq!((bytes(&store), arrivals.next()), ([0, 2, 2, 0], 50));
        arrivals.deliver(NEVER);
        assert_eq!((bytes(&store), arrivals.next()), ([1, 3, 2, 0], NEVER));
    }

    #[test]
    fn requested_data_is_delivered_early_and_the_rest_stays() {
        let arrivals = Arrivals::default();
        let (store, other) = (Arc::new(LocalStore::new()), Arc::new(LocalStore::new()));
        arrivals.send(30, write(&store, 0x100, &[1]));
        arrivals.send(40, write(&store, 0x101, &[2, 2]));
        arrivals.send(20, write(&other, 0x101, &[3]));
        arrivals.deliver_early(|write| write.overlaps(&store, 0x102, 16));
        assert_eq!((bytes(&store), bytes(&other)), ([0, 2, 2, 0], [0; 4]));
        assert_eq!(arrivals.next(), 20);
        arrivals.deliver(NEVER);
        assert_eq!((bytes(&store), bytes(&other)), ([1, 2, 2, 0], [0, 3, 0, 0]));
    }
}
