//! Data under way between local stores: sent by MFC commands, and not there yet.
//!
//! It lies in the local store from the cycle on in which its transfer is complete. The MFC, which
//! could take it either way, finds it from the command on: whoever reads it over the bus, or waits
//! for it with a synchronisation, has it delivered early. Invariant: what was sent to one place is
//! delivered in the order of arrival.

use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering::SeqCst};

use super::time::NEVER;
use crate::lock::lock;
use crate::mfc::timing::Parcel;

/// What is under way in one machine.
pub(crate) struct Arrivals {
    /// The cycle of the next one.
    next: AtomicU64,
    /// By cycle, then in the order of sending.
    parcels: Mutex<BTreeMap<(u64, u64), Parcel>>,
    sent: AtomicU64,
}

impl Default for Arrivals {
    fn default() -> Self {
        Self {
            next: AtomicU64::new(NEVER),
            parcels: Mutex::default(),
            sent: AtomicU64::new(0),
        }
    }
}

impl Arrivals {
    /// When the next parcel is there.
    pub fn next(&self) -> u64 {
        self.next.load(SeqCst)
    }

    /// Sends a parcel that is there from `cycle` on.
    pub fn send(&self, cycle: u64, parcel: Parcel) {
        let mut parcels = lock(&self.parcels);
        let number = self.sent.fetch_add(1, SeqCst);
        parcels.insert((cycle, number), parcel);
        self.note_next(&parcels);
    }

    /// Delivers all that is there at `now`.
    pub fn deliver(&self, now: u64) {
        if self.next() > now {
            return;
        }
        let mut parcels = lock(&self.parcels);
        while let Some(entry) = parcels.first_entry()
            && entry.key().0 <= now
        {
            entry.remove().deliver();
        }
        self.note_next(&parcels);
    }

    /// Delivers at once what is `wanted`.
    pub fn deliver_early(&self, wanted: impl Fn(&Parcel) -> bool) {
        if self.next() == NEVER {
            return;
        }
        let mut parcels = lock(&self.parcels);
        parcels.retain(|_, parcel| {
            let stays = !wanted(parcel);
            if !stays {
                parcel.deliver();
            }
            stays
        });
        self.note_next(&parcels);
    }

    fn note_next(&self, parcels: &BTreeMap<(u64, u64), Parcel>) {
        let next = parcels.first_key_value().map_or(NEVER, |(key, _)| key.0);
        self.next.store(next, SeqCst);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::local_store::LocalStore;
    use std::sync::Arc;

    fn parcel(store: &Arc<LocalStore>, address: u32, bytes: &[u8]) -> Parcel {
        Parcel {
            store: Arc::clone(store),
            address,
            bytes: bytes.into(),
        }
    }

    fn bytes(store: &LocalStore) -> [u8; 4] {
        let mut bytes = [0; 4];
        store.read(0x100, &mut bytes);
        bytes
    }

    #[test]
    fn parcels_lie_there_from_their_cycle_on_and_in_the_order_of_arrival() {
        let (arrivals, store) = (Arrivals::default(), Arc::new(LocalStore::new()));
        assert_eq!(arrivals.next(), NEVER);
        arrivals.send(50, parcel(&store, 0x100, &[1, 1]));
        arrivals.send(30, parcel(&store, 0x101, &[2, 2]));
        arrivals.send(50, parcel(&store, 0x101, &[3]));
        arrivals.deliver(29);
        assert_eq!((bytes(&store), arrivals.next()), ([0; 4], 30));
        arrivals.deliver(49);
        assert_eq!((bytes(&store), arrivals.next()), ([0, 2, 2, 0], 50));
        arrivals.deliver(NEVER);
        assert_eq!((bytes(&store), arrivals.next()), ([1, 3, 2, 0], NEVER));
    }

    #[test]
    fn what_is_wanted_comes_early_and_the_rest_stays() {
        let arrivals = Arrivals::default();
        let (store, other) = (Arc::new(LocalStore::new()), Arc::new(LocalStore::new()));
        arrivals.send(30, parcel(&store, 0x100, &[1]));
        arrivals.send(40, parcel(&store, 0x101, &[2, 2]));
        arrivals.send(20, parcel(&other, 0x101, &[3]));
        arrivals.deliver_early(|parcel| parcel.meets(&store, 0x102, 16));
        assert_eq!((bytes(&store), bytes(&other)), ([0, 2, 2, 0], [0; 4]));
        assert_eq!(arrivals.next(), 20);
        arrivals.deliver(NEVER);
        assert_eq!((bytes(&store), bytes(&other)), ([1, 2, 2, 0], [0, 3, 0, 0]));
    }
}
