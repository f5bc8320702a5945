//! The interconnect that SPEs share: main memory, reservations, and the addresses of signal
//! registers and local stores.
//!
//! Invariant: an atomic command excludes every transfer, because it holds the lock alone. So it
//! sees a line before or after another unit's `put`, never in between. A unit that writes a line
//! ends every reservation on it before it releases the lock. Plain transfers run concurrently. If
//! the PPE itself writes a line, no reservation ends, but the conditional put still fails, because
//! it compares the line with the bytes that were read under the reservation.

use std::sync::atomic::Ordering::SeqCst;
use std::sync::{Arc, RwLock, Weak};

use portable_atomic::AtomicU64;

use super::timing::{InFlight, Peer, PendingWrite};
use crate::local_store::{LocalStore, SIZE};
use crate::lock::{read_lock, write_lock};
use crate::memory::{LINE, MainMemory, MemoryFault};
use crate::signal::SignalRegister;

/// Stands for "no line". It is not a multiple of 128, so no line has this address.
const NO_LINE: u64 = u64::MAX;

/// The line that a unit has reserved.
#[derive(Debug)]
pub(crate) struct Reservation(AtomicU64);

impl Reservation {
    pub(crate) fn new() -> Self {
        Self(AtomicU64::new(NO_LINE))
    }

    fn holds(&self, line: u64) -> bool {
        self.0.load(SeqCst) == line
    }

    fn set(&self, line: u64) {
        self.0.store(line, SeqCst);
    }

    pub(crate) fn clear(&self) {
        self.0.store(NO_LINE, SeqCst);
    }

    /// Ends the reservation if it is on a line of `first..=last`. Returns whether it was.
    fn break_within(&self, first: u64, last: u64) -> bool {
        let held = self.0.load(SeqCst);
        (first..=last).contains(&held)
            && self
                .0
                .compare_exchange(held, NO_LINE, SeqCst, SeqCst)
                .is_ok()
    }

    /// The address of the reserved line, if any.
    pub(crate) fn line(&self) -> Option<u64> {
        let held = self.0.load(SeqCst);
        (held != NO_LINE).then_some(held)
    }
}

/// A unit on the interconnect, as the other units see it.
pub(crate) trait Unit: Send + Sync {
    fn reservation(&self) -> &Reservation;
    /// Another unit wrote the reserved line. The reservation has already ended.
    fn reservation_lost(&self);
    fn signal(&self, register: SignalRegister, word: u32);
    /// In simulated time: the signal word that was just sent arrives in `cycle`.
    fn signal_arrives(&self, register: SignalRegister, cycle: u64);
}

#[derive(Default)]
struct Members {
    units: Vec<Weak<dyn Unit>>,
    signals: Vec<(u64, Weak<dyn Unit>, SignalRegister)>,
    local_stores: Vec<(u64, Weak<LocalStore>)>,
}

impl Members {
    /// The local store that contains all `length` bytes at `ea`, and their offset in it.
    fn local_store(&self, ea: u64, length: usize) -> Option<(Arc<LocalStore>, u32)> {
        self.local_stores.iter().find_map(|(start, store)| {
            let at = ea.checked_sub(*start)?;
            let end = at.checked_add(length as u64)?;
            let within = end <= u64::from(SIZE);
            within.then(|| Some((store.upgrade()?, at as u32)))?
        })
    }

    fn broken(&self, ea: u64, length: usize, except: Option<&Reservation>) {
        self.broken_by_pieces(&[(ea, length)], except);
    }

    fn broken_by_pieces(&self, pieces: &[(u64, usize)], except: Option<&Reservation>) {
        let line = !(LINE as u64 - 1);
        for unit in self.units.iter().filter_map(Weak::upgrade) {
            let reservation = unit.reservation();
            if except.is_some_and(|own| std::ptr::eq(own, reservation)) {
                continue;
            }
            let is_broken = |&(ea, length): &(u64, usize)| {
                let last = ea.saturating_add(length as u64).wrapping_sub(1) & line;
                length > 0 && reservation.break_within(ea & line, last)
            };
            if pieces.iter().any(is_broken) {
                unit.reservation_lost();
            }
        }
    }
}

/// The interconnect of one machine.
pub(crate) struct Interconnect {
    memory: Arc<dyn MainMemory>,
    /// Data in flight between local stores, in simulated time.
    in_flight: Option<Arc<dyn InFlight>>,
    members: RwLock<Members>,
}

impl Interconnect {
    pub(crate) fn new(memory: Arc<dyn MainMemory>, in_flight: Option<Arc<dyn InFlight>>) -> Self {
        Self {
            memory,
            in_flight,
            members: RwLock::default(),
        }
    }

    /// The machine's main memory.
    pub(crate) fn memory(&self) -> &dyn MainMemory {
        &*self.memory
    }

    pub(crate) fn attach(&self, unit: Weak<dyn Unit>) {
        let mut members = write_lock(&self.members);
        members.units.retain(|unit| unit.strong_count() > 0);
        members
            .signals
            .retain(|(_, unit, _)| unit.strong_count() > 0);
        members
            .local_stores
            .retain(|(_, store)| store.strong_count() > 0);
        members.units.push(unit);
    }

    /// From now on, a word that an MFC writes to `ea` is a signal.
    pub(crate) fn map_signal(&self, ea: u64, unit: Weak<dyn Unit>, register: SignalRegister) {
        write_lock(&self.members).signals.push((ea, unit, register));
    }

    /// From now on, transfers to and from the addresses at `ea` count as transfers between local
    /// stores.
    pub(crate) fn map_local_store(&self, ea: u64, store: Weak<LocalStore>) {
        write_lock(&self.members).local_stores.push((ea, store));
    }

    /// In simulated time: prepares the data that an MFC sends to a local store for later delivery.
    /// `None` if there is no local store at `ea`. As with main memory, reservations end when the
    /// command is given.
    pub(crate) fn send_to_local_store(&self, ea: u64, from: &[u8]) -> Option<PendingWrite> {
        let members = read_lock(&self.members);
        let (store, address) = members.local_store(ea, from.len())?;
        members.broken(ea, from.len(), None);
        let bytes = from.into();
        Some(PendingWrite {
            store,
            address,
            bytes,
        })
    }

    /// In simulated time: delivers data in flight to these addresses at once.
    fn await_parcels(&self, members: &Members, ea: u64, length: usize) {
        if let Some(in_flight) = &self.in_flight
            && !in_flight.is_empty()
            && let Some((store, address)) = members.local_store(ea, length)
        {
            in_flight.deliver_early(&store, address, length);
        }
    }

    /// In simulated time: sets the cycle in which the signal that was just sent to `ea` arrives.
    pub(crate) fn signal_arrives(&self, ea: u64, cycle: u64) {
        let members = read_lock(&self.members);
        let target = members.signals.iter().find(|(at, ..)| *at == ea);
        if let Some((_, unit, register)) = target
            && let Some(unit) = unit.upgrade()
        {
            unit.signal_arrives(*register, cycle);
        }
    }

    /// What is at `ea`, for the timing of a transfer.
    pub(crate) fn peer(&self, ea: u64) -> Peer {
        let members = read_lock(&self.members);
        let within = |start: u64| (start..start.saturating_add(u64::from(SIZE))).contains(&ea);
        let stores = members.local_stores.iter().map(|(start, _)| *start);
        let signals = members.signals.iter().map(|(at, ..)| *at);
        stores
            .filter(|start| within(*start))
            .chain(signals.filter(|at| *at == ea))
            .next()
            .map_or(Peer::Memory, Peer::LocalStore)
    }

    pub(crate) fn read(&self, ea: u64, into: &mut [u8]) -> Result<(), MemoryFault> {
        let side_by_side = read_lock(&self.members);
        self.await_parcels(&side_by_side, ea, into.len());
        self.memory.read(ea, into)
    }

    pub(crate) fn write(&self, ea: u64, from: &[u8]) -> Result<(), MemoryFault> {
        let members = read_lock(&self.members);
        if let Ok(word) = <[u8; 4]>::try_from(from) {
            let target = members.signals.iter().find(|(at, ..)| *at == ea);
            if let Some((_, unit, register)) = target {
                let unit = unit.upgrade().ok_or(MemoryFault { ea })?;
                unit.signal(*register, u32::from_be_bytes(word));
                return Ok(());
            }
        }
        let written = self.memory.write(ea, from);
        members.broken(ea, from.len(), None);
        written
    }

    /// Whether these bytes are in main memory only, and in no local store or signal register.
    pub(crate) fn is_memory(&self, ea: u64, length: u32) -> bool {
        let end = ea.saturating_add(length.into());
        let apart = |start: u64, size: u64| end <= start || start.saturating_add(size) <= ea;
        let members = read_lock(&self.members);
        let mut stores = members.local_stores.iter();
        let mut signals = members.signals.iter();
        stores.all(|(start, _)| apart(*start, SIZE.into())) && signals.all(|(at, ..)| apart(*at, 4))
    }

    /// Whether these bytes are in main memory only, and can be written.
    pub(crate) fn is_writable_memory(&self, ea: u64, length: u32) -> bool {
        self.is_memory(ea, length) && self.memory.accepts_write(ea, length as usize)
    }

    /// Writes the pieces of `from`, each to its address, to main memory.
    pub(crate) fn write_pieces(
        &self,
        pieces: &[(u64, usize)],
        from: &[u8],
    ) -> Result<(), MemoryFault> {
        let members = read_lock(&self.members);
        let written = self.memory.write_pieces(pieces, from);
        members.broken_by_pieces(pieces, None);
        written
    }

    /// `getllar`: reads the line and reserves it for `own`.
    pub(crate) fn get_line(&self, ea: u64, own: &Reservation) -> Result<[u8; LINE], MemoryFault> {
        let alone = write_lock(&self.members);
        own.clear();
        self.await_parcels(&alone, ea, LINE);
        let mut line = [0; LINE];
        self.memory.read(ea, &mut line)?;
        own.set(ea);
        Ok(line)
    }

    /// `putllc`: writes the line if it is still reserved and equal to `seen`. Returns whether it
    /// was written.
    pub(crate) fn put_line_conditional(
        &self,
        ea: u64,
        own: &Reservation,
        seen: &[u8; LINE],
        new: &[u8; LINE],
    ) -> Result<bool, MemoryFault> {
        let members = write_lock(&self.members);
        let held = own.holds(ea);
        own.clear();
        self.await_parcels(&members, ea, LINE);
        if !held || !self.memory.compare_exchange_line(ea, seen, new)? {
            return Ok(false);
        }
        members.broken(ea, LINE, Some(own));
        Ok(true)
    }

    /// `putlluc` and `putqlluc`: writes the line. An own reservation on it ends without an event.
    pub(crate) fn put_line(
        &self,
        ea: u64,
        own: &Reservation,
        new: &[u8; LINE],
    ) -> Result<(), MemoryFault> {
        let members = write_lock(&self.members);
        if own.holds(ea) {
            own.clear();
        }
        self.await_parcels(&members, ea, LINE);
        let written = self.memory.write(ea, new);
        members.broken(ea, LINE, Some(own));
        written
    }
}
