//! Who may act next: the actor with the smallest clock.
//!
//! An actor is an SPE or a PPE thread. It is outside the race, or it runs freely with a clock that
//! is a lower bound of its next act, or it waits: for its turn at a time, and perhaps for somebody
//! to wake it before. Invariant: an actor gets its turn only while no other free or waiting actor
//! has a smaller (clock, rank), and it keeps the turn until it shows a larger clock, so acts never
//! overlap; and nobody's clock runs back. Data that was sent to a local store lies there as soon
//! as no clock is before its arrival.

use std::sync::atomic::Ordering::{Relaxed, SeqCst};
use std::sync::atomic::{AtomicBool, AtomicU64};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use super::absence::{LOOK_EVERY, Patience};
use super::arrivals::Arrivals;
use super::race::{Entry, Race, Rank, Runner, Status, WaitKey};
use super::time::NEVER;
use crate::lock::lock;

/// Cycles between two looks at the others' clocks: often enough not to hold them up, seldom enough
/// to cost nothing.
const CYCLES_A_LOOK: u64 = 1024;

/// The race of one machine.
pub(crate) struct Turnstile {
    race: Mutex<Race>,
    /// The smallest time at which somebody waits: whoever runs past it has to let go.
    impatient: AtomicU64,
    /// Whether runners run one at a time too, not only act so.
    serial: AtomicBool,
    /// Cycles in which one SPU reaches another's local store at the earliest.
    local_store_delay: u64,
    /// What was sent to local stores.
    pub arrivals: Arrivals,
}

impl Turnstile {
    pub fn new(local_store_delay: u64) -> Self {
        Self {
            race: Mutex::default(),
            impatient: AtomicU64::default(),
            serial: AtomicBool::default(),
            local_store_delay,
            arrivals: Arrivals::default(),
        }
    }

    pub fn new_key(&self) -> WaitKey {
        let mut race = lock(&self.race);
        race.keys += 1;
        WaitKey::new(race.keys)
    }

    /// How often the race went on without a PPE thread or an SPE that was expected.
    pub fn absences(&self) -> u64 {
        lock(&self.race).absences
    }

    /// From now on runners run one at a time.
    pub fn serialise(&self) {
        self.serial.store(true, SeqCst);
    }

    /// Moves sleepers on `key` to the cycle after the act that goes on: in the same cycle they
    /// would overtake it if they come first by rank.
    pub fn wake(&self, key: WaitKey) {
        let mut race = lock(&self.race);
        let now = race.now;
        let mut woken = false;
        for entry in race.actors.values_mut() {
            if let Status::Waiting {
                wanted,
                since,
                key: its,
            } = &mut entry.status
                && *its == Some(key)
            {
                *wanted = (now + 1).max(*since).min(*wanted);
                *its = None;
                woken = true;
            }
        }
        if woken && self.serial.load(SeqCst) {
            // The spell that goes on was given out without regard to who slept.
            let soon = now + 1 + self.local_store_delay;
            for entry in race.actors.values() {
                entry.runner.limit.fetch_min(soon, SeqCst);
            }
        }
        self.hand_on(&race);
    }

    /// Says for how long runners need not look up, then calls the first waiter if it is its turn,
    /// or if somebody is before it of whom nobody knows whether he comes back. In this order: a
    /// runner shows its clock before it looks, so that one of the two sees the other.
    fn hand_on(&self, race: &Race) {
        let leader = race.leader();
        self.arrivals
            .deliver(leader.map_or(NEVER, |(clock, _)| clock));
        let waiting = |(&rank, entry): (&Rank, &Entry)| match entry.status {
            Status::Waiting { wanted, .. } if wanted != NEVER => Some((wanted, rank)),
            _ => None,
        };
        let first = race.actors.iter().filter_map(waiting).min();
        self.impatient
            .store(first.map_or(NEVER, |(wanted, _)| wanted), SeqCst);
        let (Some(first), Some(leader)) = (first, leader) else {
            return;
        };
        let status = |rank| race.actors.get(&rank).map(|entry| &entry.status);
        let doubtful = matches!(status(leader.1), Some(Status::Free(Some(_))));
        if (first == leader || doubtful)
            && let Some(entry) = race.actors.get(&first.1)
        {
            entry.runner.called.notify_one();
        }
    }

    /// How far `me`, who has the turn at `now`, may run before it asks again: where runners run
    /// one at a time, up to where something could arrive in its local store.
    fn limit(&self, race: &Race, me: Rank, now: u64) -> u64 {
        let look = now + CYCLES_A_LOOK;
        if !self.serial.load(SeqCst) {
            return look;
        }
        let others = race.actors.iter().filter(|(rank, _)| **rank != me);
        let sent = others.filter_map(|(_, entry)| entry.place()).min();
        let sent = sent.map_or(NEVER, |place| place.saturating_add(self.local_store_delay));
        look.min(sent).min(self.arrivals.next())
    }

    fn await_turn(
        &self,
        mut race: MutexGuard<'_, Race>,
        me: &Actor,
        mut pause: Option<Duration>,
    ) -> u64 {
        self.hand_on(&race);
        loop {
            let mut limit = None;
            match race.leader() {
                Some((clock, rank)) if rank == me.rank => {
                    match pause.take_if(|_| race.sleeps_alone(rank)) {
                        Some(left) => limit = Some(left),
                        None => {
                            me.runner.clock.store(clock, SeqCst);
                            race.now = clock;
                            race.set(rank, Status::Free(me.patience()));
                            self.hand_on(&race);
                            let limit = self.limit(&race, rank, clock);
                            me.runner.limit.store(limit, SeqCst);
                            return clock;
                        }
                    }
                }
                Some((_, rank)) => {
                    if let Some(entry) = race.actors.get_mut(&rank)
                        && let Status::Free(Some(patience)) = &mut entry.status
                    {
                        if patience.is_over() {
                            entry.status = Status::Outside;
                            race.absences += 1;
                            self.hand_on(&race);
                            continue;
                        }
                        limit = Some(LOOK_EVERY);
                    }
                }
                None => {}
            }
            let called = &me.runner.called;
            race = match limit {
                None => called.wait(race).unwrap_or_else(PoisonError::into_inner),
                Some(limit) => {
                    let woken = called.wait_timeout(race, limit);
                    woken.unwrap_or_else(PoisonError::into_inner).0
                }
            };
        }
    }
}

/// One actor. It leaves the race for good when it is dropped.
pub(crate) struct Actor {
    turnstile: Arc<Turnstile>,
    runner: Arc<Runner>,
    rank: Rank,
    is_ppe: bool,
}

impl Actor {
    fn new(
        turnstile: &Arc<Turnstile>,
        rank: impl FnOnce(&mut Race) -> Rank,
        is_ppe: bool,
        from: Option<u64>,
    ) -> Self {
        let runner = Arc::new(Runner {
            clock: AtomicU64::new(from.unwrap_or(0)),
            ..Runner::default()
        });
        let mut race = lock(&turnstile.race);
        let rank = rank(&mut race);
        let entry = Entry {
            runner: Arc::clone(&runner),
            status: match from {
                Some(_) => Status::Free(Some(Patience::with_this_thread())),
                None => Status::Outside,
            },
        };
        race.actors.insert(rank, entry);
        drop(race);
        Self {
            turnstile: Arc::clone(turnstile),
            runner,
            rank,
            is_ppe,
        }
    }

    pub fn spe(turnstile: &Arc<Turnstile>, rank: Rank) -> Self {
        Self::new(turnstile, |_| rank, false, None)
    }

    /// The calling thread as an actor: in the race from some time on, or outside until it first
    /// acts.
    pub fn ppe(turnstile: &Arc<Turnstile>, from: Option<u64>) -> Self {
        let next = |race: &mut Race| {
            race.ppe_threads += 1;
            Rank::ppe(race.ppe_threads)
        };
        Self::new(turnstile, next, true, from)
    }

    pub fn clock(&self) -> u64 {
        self.runner.clock.load(SeqCst)
    }

    /// PPE threads may go away without a word; an SPE that runs does not.
    fn patience(&self) -> Option<Patience> {
        self.is_ppe.then(Patience::with_this_thread)
    }

    /// If it was outside, it comes back, after what has happened in the meantime. Gives its clock.
    pub fn rejoin(&self) -> u64 {
        let mut race = lock(&self.turnstile.race);
        let now = race.now;
        if let Some(entry) = race.actors.get_mut(&self.rank)
            && matches!(entry.status, Status::Outside)
        {
            self.runner.clock.fetch_max(now, SeqCst);
            entry.status = Status::Free(self.patience());
        }
        self.clock()
    }

    /// Waits for the turn at `clock`.
    pub fn turn(&self, clock: u64) {
        let clock = clock.max(self.clock());
        let mut race = lock(&self.turnstile.race);
        race.set(
            self.rank,
            Status::Waiting {
                wanted: clock,
                since: clock,
                key: None,
            },
        );
        self.turnstile.await_turn(race, self, None);
    }

    /// Sleeps until somebody wakes `key` or until `limit`; gives the time of the turn that it has
    /// then. With `pause`, somebody who is left alone in the race lets that much of the host's
    /// time pass before its clock jumps to the limit.
    pub fn sleep(&self, key: WaitKey, limit: Option<u64>, pause: Option<Duration>) -> u64 {
        let since = self.clock();
        let mut race = lock(&self.turnstile.race);
        let status = Status::Waiting {
            wanted: limit.map_or(NEVER, |limit| limit.max(since)),
            since,
            key: Some(key),
        };
        race.set(self.rank, status);
        self.turnstile.await_turn(race, self, pause)
    }

    /// Has run up to `clock`: lets others go first who are behind, once it is at its limit.
    #[inline]
    pub fn run_up_to(&self, clock: u64) {
        if self.is_due(clock) {
            self.look(clock);
        }
    }

    /// Whether [`run_up_to`](Self::run_up_to) `clock` would let others go first.
    #[inline]
    pub fn is_due(&self, clock: u64) -> bool {
        clock >= self.runner.limit.load(Relaxed)
    }

    /// Whether runners run one at a time.
    #[inline]
    pub fn is_serial(&self) -> bool {
        self.turnstile.serial.load(SeqCst)
    }

    #[cold]
    fn look(&self, clock: u64) {
        if self.is_serial() {
            self.turn(clock);
        } else {
            self.progress(clock);
        }
    }

    /// Something that was just sent may be for its own local store.
    pub fn expect_arrivals(&self) {
        let next = self.turnstile.arrivals.next();
        self.runner.limit.fetch_min(next, SeqCst);
    }

    /// Shows how far it has run without acting.
    pub fn progress(&self, clock: u64) {
        self.runner.clock.store(clock, SeqCst);
        self.runner.limit.store(clock + CYCLES_A_LOOK, SeqCst);
        if clock >= self.turnstile.impatient.load(SeqCst) {
            self.turnstile.hand_on(&lock(&self.turnstile.race));
        }
    }

    /// Leaves the race until it asks for a turn again.
    pub fn leave(&self) {
        let mut race = lock(&self.turnstile.race);
        race.set(self.rank, Status::Outside);
        self.turnstile.hand_on(&race);
    }

    /// It is about to come into the race at `clock`, if it is not in it: nobody may pass that time
    /// before.
    pub fn expect(&self, clock: u64) {
        let mut race = lock(&self.turnstile.race);
        if let Some(entry) = race.actors.get_mut(&self.rank)
            && matches!(entry.status, Status::Outside)
        {
            self.runner.clock.fetch_max(clock, SeqCst);
            entry.status = Status::Free(Some(Patience::with_nobody()));
        }
    }

    /// Hands its place to `other`, which goes on from `clock` at the earliest.
    pub fn give_way_to(&self, other: &Self, clock: u64) {
        let mut race = lock(&self.turnstile.race);
        other.runner.clock.fetch_max(clock, SeqCst);
        race.set(self.rank, Status::Outside);
        race.set(other.rank, Status::Free(other.patience()));
        self.turnstile.hand_on(&race);
    }
}

impl Drop for Actor {
    fn drop(&mut self) {
        let mut race = lock(&self.turnstile.race);
        race.actors.remove(&self.rank);
        self.turnstile.hand_on(&race);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulated::MemoryFigures;
    use std::sync::atomic::AtomicUsize;
    use std::thread;

    /// An SPE that is in the race at `clock`.
    fn free(turnstile: &Arc<Turnstile>, number: u64, clock: u64) -> Actor {
        let actor = Actor::spe(turnstile, Rank::spe(number));
        actor.progress(clock);
        lock(&turnstile.race).set(actor.rank, Status::Free(None));
        actor
    }

    #[test]
    fn acts_come_one_at_a_time_in_the_order_of_clock_and_rank() {
        const ACTORS: u64 = 5;
        const ACTS: u64 = 200;
        let turnstile = Arc::new(Turnstile::new(MemoryFigures::CONSOLE.local_store_delay()));
        let acts = Mutex::new(Vec::new());
        let acting = AtomicUsize::new(0);
        let actors: Vec<_> = (0..ACTORS).map(|n| free(&turnstile, n, 0)).collect();
        thread::scope(|scope| {
            for (number, actor) in (0..ACTORS).zip(actors) {
                let (acts, acting) = (&acts, &acting);
                scope.spawn(move || {
                    // Steps of different lengths, with many ties.
                    for clock in (1..=ACTS).map(|act| act * (number % 3 + 1)) {
                        actor.turn(clock);
                        assert_eq!(acting.fetch_add(1, SeqCst), 0);
                        lock(acts).push((clock, number));
                        thread::yield_now();
                        acting.fetch_sub(1, SeqCst);
                    }
                });
            }
        });
        let acts = acts.into_inner().unwrap();
        assert_eq!(acts.len() as u64, ACTORS * ACTS);
        assert!(acts.is_sorted());
    }

    #[test]
    fn a_sleeper_wakes_after_the_act_that_wakes_it_and_not_before_it_slept() {
        let turnstile = Arc::new(Turnstile::new(MemoryFigures::CONSOLE.local_store_delay()));
        let key = turnstile.new_key();
        let (early, late) = (free(&turnstile, 0, 0), free(&turnstile, 1, 0));
        let other = free(&turnstile, 2, 0);
        thread::scope(|scope| {
            let first = scope.spawn(|| {
                early.turn(10);
                let woken = early.sleep(key, None, None);
                early.leave();
                woken
            });
            let second = scope.spawn(|| {
                late.turn(70);
                let timed_out = late.sleep(turnstile.new_key(), Some(90), None);
                late.leave();
                timed_out
            });
            other.turn(50);
            turnstile.wake(key);
            other.turn(80);
            assert_eq!(first.join().unwrap(), 51);
            other.turn(100);
            assert_eq!(second.join().unwrap(), 90);
        });
    }
}
