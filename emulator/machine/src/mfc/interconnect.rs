//! The interconnect that SPEs share: main memory, reservations, and the addresses of signal
//! registers and local stores.
//!
//! Invariant: a plain transfer and an atomic command see a line before or after another unit's
//! write, never in between, because all of them hold its lock. A unit that writes a line ends every
//! reservation on it before it releases the lock. If the PPE itself writes a line, no reservation
//! ends, but the conditional put still fails, because it compares the line with the bytes that were
//! read under the reservation. The PPE's own loads and stores take no lock.
//!
//! A line that is mapped twice has two addresses. A reservation is of the line, whatever the
//! address by which it is written, and a write by one address excludes an atomic command by the
//! other. Plain transfers by different addresses don't exclude each other.
//!
//! Locks are taken in this order: the members, of which transfers only read, then the lines.

use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::SeqCst;
use std::sync::{Arc, Mutex, RwLock, Weak};

use portable_atomic::AtomicU64;

use super::line_locks::{Held, LineLocks};
use super::timing::{InFlight, Peer, PendingWrite};
use crate::local_store::{LocalStore, SIZE};
use crate::lock::{lock, read_lock, write_lock};
use crate::memory::{LINE, MainMemory, MemoryFault, PLACE_PAGE, Place};
use crate::signal::SignalRegister;

/// Stands for "no line". It is not a multiple of 128, so no line has this address.
const NO_LINE: u64 = u64::MAX;

/// The line that a unit has reserved.
#[derive(Debug)]
pub(crate) struct Reservation {
    line: AtomicU64,
    /// Where the line is, if it may have other addresses.
    place: Mutex<Option<Place>>,
}

impl Reservation {
    pub(crate) fn new() -> Self {
        Self { line: AtomicU64::new(NO_LINE), place: Mutex::default() }
    }

    fn holds(&self, line: u64) -> bool {
        self.line.load(SeqCst) == line
    }

    fn set(&self, line: u64, place: Option<Place>) {
        *lock(&self.place) = place;
        self.line.store(line, SeqCst);
    }

    pub(crate) fn clear(&self) {
        self.line.store(NO_LINE, SeqCst);
    }

    /// Ends the reservation if it is on a line of `first..=last`. Returns whether it was.
    fn break_within(&self, first: u64, last: u64) -> bool {
        let held = self.line.load(SeqCst);
        (first..=last).contains(&held)
            && self.line.compare_exchange(held, NO_LINE, SeqCst, SeqCst).is_ok()
    }

    /// The address of the reserved line, if any.
    pub(crate) fn line(&self) -> Option<u64> {
        let held = self.line.load(SeqCst);
        (held != NO_LINE).then_some(held)
    }

    /// The address of the reserved line if it is among these bytes, of which this is not the
    /// address.
    fn line_at_other_address(
        &self,
        (ea, length): (u64, usize),
        memory: &dyn MainMemory,
    ) -> Option<u64> {
        let held = self.line().filter(|_| length > 0)?;
        let place = (*lock(&self.place))?;
        let start = ea & !(LINE as u64 - 1);
        let to_first = held.wrapping_sub(start) % PLACE_PAGE;
        let span = ea.saturating_add(length as u64) - start;
        let mut candidates = (to_first..span).step_by(PLACE_PAGE as usize);
        candidates
            .any(|at| start + at != held && memory.place(start + at) == Some(place))
            .then_some(held)
    }
}

/// A unit on the interconnect, as the other units see it.
pub(crate) trait Unit: Send + Sync {
    fn reservation(&self) -> &Arc<Reservation>;
    /// Another unit wrote the reserved line. The reservation has already ended.
    fn reservation_lost(&self);
    fn signal(&self, register: SignalRegister, word: u32);
    /// In simulated time: the signal word that was just sent arrives in `cycle`.
    fn signal_arrives(&self, register: SignalRegister, cycle: u64);
}

#[derive(Default)]
struct Members {
    units: Vec<(Arc<Reservation>, Weak<dyn Unit>)>,
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

    /// Ends the reservations on these bytes, and notifies their units.
    fn broken(&self, pieces: &[(u64, usize)], except: Option<&Reservation>) {
        let line = !(LINE as u64 - 1);
        self.break_where(except, |reservation| {
            pieces.iter().any(|&(ea, length)| {
                let last = ea.saturating_add(length as u64).wrapping_sub(1) & line;
                length > 0 && reservation.break_within(ea & line, last)
            })
        });
    }

    fn break_where(&self, except: Option<&Reservation>, ends: impl Fn(&Reservation) -> bool) {
        for (reservation, unit) in &self.units {
            let is_excepted = except.is_some_and(|own| std::ptr::eq(own, &**reservation));
            if !is_excepted
                && ends(reservation)
                && let Some(unit) = unit.upgrade()
            {
                unit.reservation_lost();
            }
        }
    }

    /// The addresses of the reserved lines that are among these bytes, but by another address.
    fn at_other_addresses(&self, pieces: &[(u64, usize)], memory: &dyn MainMemory) -> Vec<u64> {
        let reservations = self.units.iter().map(|(reservation, _)| reservation);
        reservations
            .filter_map(|reservation| {
                let mut pieces = pieces.iter();
                pieces.find_map(|&piece| reservation.line_at_other_address(piece, memory))
            })
            .collect()
    }
}

pub(crate) struct Interconnect {
    memory: Arc<dyn MainMemory>,
    /// Data in flight between local stores, in simulated time.
    in_flight: Option<Arc<dyn InFlight>>,
    members: RwLock<Members>,
    lines: LineLocks,
    /// A line that may have several addresses was reserved. Without that, no write looks for them.
    reserves_places: AtomicBool,
}

impl Interconnect {
    pub(crate) fn new(memory: Arc<dyn MainMemory>, in_flight: Option<Arc<dyn InFlight>>) -> Self {
        Self {
            memory,
            in_flight,
            members: RwLock::default(),
            lines: LineLocks::default(),
            reserves_places: AtomicBool::new(false),
        }
    }

    pub(crate) fn memory(&self) -> &dyn MainMemory {
        &*self.memory
    }

    pub(crate) fn attach(&self, unit: &Arc<dyn Unit>) {
        let mut members = write_lock(&self.members);
        members.units.retain(|(_, unit)| unit.strong_count() > 0);
        members.signals.retain(|(_, unit, _)| unit.strong_count() > 0);
        members.local_stores.retain(|(_, store)| store.strong_count() > 0);
        let reservation = Arc::clone(unit.reservation());
        members.units.push((reservation, Arc::downgrade(unit)));
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
        self.written(&members, &[(ea, from.len())], None);
        let bytes = from.into();
        Some(PendingWrite { store, address, bytes })
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

    /// Waits until these pieces may be written.
    fn lock_for_write(&self, members: &Members, pieces: &[(u64, usize)]) -> Held<'_> {
        let others = self.at_other_addresses(members, pieces);
        let others = others.into_iter().map(|line| (line, LINE));
        self.lines.write(pieces.iter().copied().chain(others))
    }

    /// Ends the reservations on bytes that have just been written.
    fn written(&self, members: &Members, pieces: &[(u64, usize)], except: Option<&Reservation>) {
        members.broken(pieces, except);
        for line in self.at_other_addresses(members, pieces) {
            members.broken(&[(line, LINE)], except);
        }
    }

    fn at_other_addresses(&self, members: &Members, pieces: &[(u64, usize)]) -> Vec<u64> {
        if self.reserves_places.load(SeqCst) {
            members.at_other_addresses(pieces, self.memory())
        } else {
            Vec::new()
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
        let members = read_lock(&self.members);
        self.await_parcels(&members, ea, into.len());
        let _whole = self.lines.read(&[(ea, into.len())]);
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
        let piece = [(ea, from.len())];
        let _whole = self.lock_for_write(&members, &piece);
        let written = self.memory.write(ea, from);
        self.written(&members, &piece, None);
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

    /// Reads the pieces of `into`, each from its address, from main memory.
    pub(crate) fn read_pieces(
        &self,
        pieces: &[(u64, usize)],
        into: &mut [u8],
    ) -> Result<(), MemoryFault> {
        let _whole = self.lines.read(pieces);
        self.memory.read_pieces(pieces, into)
    }

    /// Writes the pieces of `from`, each to its address, to main memory.
    pub(crate) fn write_pieces(
        &self,
        pieces: &[(u64, usize)],
        from: &[u8],
    ) -> Result<(), MemoryFault> {
        let members = read_lock(&self.members);
        let _whole = self.lock_for_write(&members, pieces);
        let written = self.memory.write_pieces(pieces, from);
        self.written(&members, pieces, None);
        written
    }

    /// `getllar`: reads the line and reserves it for `own`.
    pub(crate) fn get_line(&self, ea: u64, own: &Reservation) -> Result<[u8; LINE], MemoryFault> {
        let members = read_lock(&self.members);
        own.clear();
        self.await_parcels(&members, ea, LINE);
        let place = self.memory.place(ea);
        if place.is_some() {
            self.reserves_places.store(true, SeqCst);
        }
        let _whole = self.lines.read(&[(ea, LINE)]);
        // Set before the line is read, because who writes it by another address holds another lock:
        // a write that comes too late to be read must find the reservation.
        own.set(ea, place);
        let mut line = [0; LINE];
        let read = self.memory.read(ea, &mut line);
        read.inspect_err(|_| own.clear()).map(|()| line)
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
        let members = read_lock(&self.members);
        self.await_parcels(&members, ea, LINE);
        let line = [(ea, LINE)];
        let _whole = self.lock_for_write(&members, &line);
        // The reservation lasts until the line is written, so that who writes it by another address
        // finds it and waits.
        let held = own.holds(ea);
        let exchange = || self.memory.compare_exchange_line(ea, seen, new);
        let exchanged = held.then(exchange).unwrap_or(Ok(false));
        own.clear();
        if exchanged? {
            self.written(&members, &line, Some(own));
            return Ok(true);
        }
        Ok(false)
    }

    /// `putlluc` and `putqlluc`: writes the line. An own reservation on it ends without an event.
    pub(crate) fn put_line(
        &self,
        ea: u64,
        own: &Reservation,
        new: &[u8; LINE],
    ) -> Result<(), MemoryFault> {
        let members = read_lock(&self.members);
        self.await_parcels(&members, ea, LINE);
        let line = [(ea, LINE)];
        let _whole = self.lock_for_write(&members, &line);
        if own.holds(ea) {
            own.clear();
        }
        let written = self.memory.write(ea, new);
        self.written(&members, &line, Some(own));
        written
    }
}
