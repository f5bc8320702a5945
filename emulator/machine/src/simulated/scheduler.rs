//! The scheduler: it decides which actor may act next, namely the one with the smallest clock.
//!
//! An actor is an SPE or a PPE thread. It is in one of three states. An outside actor is not
//! scheduled. A free actor runs, and its clock is a lower bound of its next act. A waiting actor
//! waits for its turn at a certain time, and another actor may wake it earlier. Invariant: an
//! actor gets its turn only while no other free or waiting actor has a smaller (clock, rank), and
//! it keeps the turn until it publishes a larger clock. So acts never overlap, and clocks never
//! decrease. An actor may defer an act whose outcome it does not need. The act is executed by the
//! thread that finds that all clocks have reached its time. Data that was sent to a local store
//! arrives there as soon as all clocks have reached its arrival time.

use std::sync::atomic::Ordering::{Relaxed, SeqCst};
use std::sync::atomic::{AtomicBool, AtomicU32};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use portable_atomic::AtomicU64;

use super::actor_table::{ActorTable, Deferred, DeferredAct, Entry, Rank, Runner, Status, WaitKey};
use super::arrivals::Arrivals;
use super::host_threads::{self, Wakers};
use super::time::NEVER;
use super::timeout::{Timeout, Verdict};
use crate::in_turn::Turns;
use crate::lock::lock;

/// Cycles between two checks of the other actors' clocks: few enough not to delay them, and many
/// enough that the checks cost nothing.
const CYCLES_BETWEEN_CHECKS: u64 = 1024;

/// The maximum number of cycles that an actor runs ahead of its deferred acts. Then it waits for
/// them, because only a waiting actor detects that another one, whose clock is smaller, may never
/// act again.
const CYCLES_AHEAD: u64 = 1 << 20;

pub(crate) struct Scheduler {
    table: Mutex<ActorTable>,
    /// The earliest time of a waiting actor or of a deferred act. An actor that runs past it must
    /// notify the waiting one, or execute the act.
    first_wait: AtomicU64,
    /// Whether actors not only act one at a time, but also run one at a time.
    serial: AtomicBool,
    /// The minimum number of cycles in which one SPU's data reaches another's local store.
    local_store_delay: u64,
    /// The data in flight between local stores.
    pub arrivals: Arrivals,
    /// The SPEs, if they run on the thread of their PPE.
    turns: Option<Arc<Turns>>,
}

impl Scheduler {
    pub fn new(local_store_delay: u64, turns: Option<Arc<Turns>>) -> Self {
        Self {
            table: Mutex::default(),
            first_wait: AtomicU64::default(),
            serial: AtomicBool::default(),
            local_store_delay,
            arrivals: Arrivals::default(),
            turns,
        }
    }

    /// The time-out of a PPE thread between two calls. On its own thread, SPEs never wait for it.
    fn timeout(&self) -> Option<Timeout> {
        self.turns.is_none().then(Timeout::of_this_thread)
    }

    pub fn new_key(&self) -> WaitKey {
        let mut table = lock(&self.table);
        table.keys += 1;
        WaitKey::new(table.keys)
    }

    /// The number of times that actors stopped waiting for a PPE thread or an SPE that might still
    /// have acted.
    pub fn timeouts(&self) -> u64 {
        lock(&self.table).timeouts
    }

    /// From now on actors run one at a time.
    pub fn serialise(&self) {
        self.serial.store(true, SeqCst);
    }

    /// Moves sleepers on `key` to the cycle after the current act. In the same cycle, those with a
    /// smaller rank would overtake it.
    pub fn wake(&self, key: WaitKey) {
        let mut table = lock(&self.table);
        let now = table.now;
        let mut woken = false;
        for entry in table.actors.values_mut() {
            if let Status::Waiting { wanted, since, key: its } = &mut entry.status
                && *its == Some(key)
            {
                *wanted = (now + 1).max(*since).min(*wanted);
                *its = None;
                woken = true;
            }
        }
        if woken && self.serial.load(SeqCst) {
            // The length of the current time slice does not consider actors that slept.
            let soon = now + 1 + self.local_store_delay;
            for entry in table.actors.values() {
                entry.runner.limit.fetch_min(soon, SeqCst);
            }
        }
        self.notify_next(&table);
    }

    /// Publishes the time up to which actors can run without notifying others, then notifies the
    /// first waiting actor if it has the turn, or if the leader may never act again. The order
    /// matters: a running actor publishes its clock before it reads this time, so at least one of
    /// the two sees the other.
    fn notify_next(&self, table: &ActorTable) {
        let leader = table.leader();
        let deferred = table.deferred.first_key_value();
        let deferred = deferred.map_or(NEVER, |(&(clock, _), _)| clock);
        let time = leader.map_or(NEVER, |(clock, _)| clock).min(deferred);
        self.arrivals.deliver(time);
        let waiting = |(&rank, entry): (&Rank, &Entry)| match entry.status {
            Status::Waiting { wanted, .. } if wanted != NEVER => Some((wanted, rank)),
            _ => None,
        };
        let first = table.actors.iter().filter_map(waiting).min();
        let wanted = first.map_or(NEVER, |(wanted, _)| wanted);
        self.first_wait.store(wanted.min(deferred), SeqCst);
        let (Some(first), Some(leader)) = (first, leader) else {
            return;
        };
        let status = |rank| table.actors.get(&rank).map(|entry| &entry.status);
        let doubtful = matches!(status(leader.1), Some(Status::Free(Some(_))));
        if (first == leader || doubtful)
            && let Some(entry) = table.actors.get(&first.1)
        {
            entry.runner.called.notify_one();
        }
    }

    /// The time up to which `me`, which has the turn at `now`, may run before it checks again. If
    /// actors run one at a time, it is the earliest time at which data could arrive in its local
    /// store.
    fn limit(&self, table: &ActorTable, me: Rank, now: u64) -> u64 {
        let check = now + CYCLES_BETWEEN_CHECKS;
        if !self.serial.load(SeqCst) {
            return check;
        }
        let others = table.actors.iter().filter(|(rank, _)| **rank != me);
        let sent = others.filter_map(|(_, entry)| entry.place()).min();
        let sent = sent.map_or(NEVER, |place| place.saturating_add(self.local_store_delay));
        check.min(sent).min(self.arrivals.next())
    }

    /// Executes the deferred acts that are due, then notifies the next waiting actor.
    ///
    /// The table is not locked during an act, which may wake other actors. But the act stays in it,
    /// so that no other act begins.
    fn proceed<'a>(&'a self, mut table: MutexGuard<'a, ActorTable>) -> MutexGuard<'a, ActorTable> {
        while let Some((key, deferred)) = table.due()
            && let Some(act) = deferred.act.take()
        {
            table.now = key.0;
            drop(table);
            act();
            table = lock(&self.table);
            let done = table.deferred.remove(&key);
            let owner = table.actors.get(&key.1).map(|entry| &entry.runner);
            if let (Some(owner), Some(done)) = (owner, done) {
                owner.deferred.fetch_sub(1, SeqCst);
                if owner.awaited.load(SeqCst) & done.tags != 0 {
                    owner.called.notify_one();
                }
            }
        }
        self.notify_next(&table);
        table
    }

    fn unschedule(&self, table: &mut ActorTable, rank: Rank) {
        table.set(rank, Status::Outside);
        self.notify_next(table);
    }

    /// Removes the leader from the schedule if all threads of the process are blocked by each
    /// other, or if its time-out has `expired`. That counts as a time-out if another thread might
    /// still wake the leader. Threads that act after the leader can't wake it, except while one
    /// holds a lock.
    ///
    /// Meanwhile the table is not locked, because a thread that waits for the lock would seem to
    /// wait for others.
    fn check_leader<'a>(
        &'a self,
        mut table: MutexGuard<'a, ActorTable>,
        leader: Rank,
        expired: bool,
    ) -> MutexGuard<'a, ActorTable> {
        let later = table.threads_after(leader);
        let since = table.timeout(leader).map(|timeout| timeout.since());
        drop(table);
        let wakers = host_threads::wakers(&later);
        let mut table = lock(&self.table);
        let is_the_same = since == table.timeout(leader).map(|timeout| timeout.since());
        if is_the_same && (expired || wakers == Wakers::Blocked) {
            table.timeouts += u64::from(wakers == Wakers::Unknown);
            self.unschedule(&mut table, leader);
        }
        table
    }

    /// Gives `me`, which is the leader at `clock`, the turn.
    fn give_turn(&self, table: &mut ActorTable, me: &Actor, clock: u64) {
        me.runner.clock.store(clock, SeqCst);
        table.now = clock;
        table.set(me.rank, Status::Free(me.timeout()));
        self.notify_next(table);
        let limit = self.limit(table, me.rank, clock);
        me.runner.limit.store(limit, SeqCst);
    }

    /// Lets the SPEs of the PPE's own thread go on until `me`, a PPE thread, has the turn. Returns
    /// its clock then, or [`NEVER`] if all actors sleep.
    fn run_others(&self, turns: &Turns, me: &Actor) -> u64 {
        loop {
            let mut table = self.proceed(lock(&self.table));
            match table.leader() {
                Some((clock, rank)) if rank == me.rank => {
                    self.give_turn(&mut table, me, clock);
                    return clock;
                }
                Some((_, rank)) => {
                    drop(table);
                    match rank.spe_number() {
                        Some(number) => turns.resume(number),
                        None => return NEVER,
                    }
                }
                None => return NEVER,
            }
        }
    }

    /// Waits for `me`'s turn, or until its acts of the tags `deferred` have been executed. Returns
    /// its clock then.
    fn await_turn<'a>(
        &'a self,
        mut table: MutexGuard<'a, ActorTable>,
        me: &Actor,
        mut pause: Option<Duration>,
        deferred: Option<u32>,
    ) -> u64 {
        if let Some(turns) = &self.turns {
            drop(table);
            return self.run_others(turns, me);
        }
        loop {
            table = self.proceed(table);
            if deferred.is_some_and(|tags| !table.is_deferred(me.rank, tags)) {
                table.set(me.rank, Status::Free(me.timeout()));
                self.notify_next(&table);
                return me.clock();
            }
            let mut limit = None;
            // While another thread executes an act, no actor has the turn.
            let leader = match table.due() {
                Some(_) => None,
                None => table.leader(),
            };
            match leader {
                Some((clock, rank)) if rank == me.rank => {
                    match pause.take_if(|_| table.sleeps_alone(rank)) {
                        Some(left) => limit = Some(left),
                        None => {
                            self.give_turn(&mut table, me, clock);
                            return clock;
                        }
                    }
                }
                Some((_, rank)) => {
                    match table.timeout(rank).map(|timeout| timeout.look(Instant::now())) {
                        None => {}
                        Some(Verdict::Wait(time)) => limit = Some(time),
                        Some(Verdict::Ask) => {
                            table = self.check_leader(table, rank, false);
                            continue;
                        }
                        Some(Verdict::GiveUp) => {
                            table = self.check_leader(table, rank, true);
                            continue;
                        }
                    }
                }
                None => {}
            }
            let called = &me.runner.called;
            table = match limit {
                None => called.wait(table).unwrap_or_else(PoisonError::into_inner),
                Some(limit) => {
                    let woken = called.wait_timeout(table, limit);
                    woken.unwrap_or_else(PoisonError::into_inner).0
                }
            };
        }
    }
}

/// One actor. It leaves the table when it is dropped.
pub(crate) struct Actor {
    scheduler: Arc<Scheduler>,
    runner: Arc<Runner>,
    rank: Rank,
    is_ppe: bool,
}

impl Actor {
    fn new(
        scheduler: &Arc<Scheduler>,
        rank: impl FnOnce(&mut ActorTable) -> Rank,
        is_ppe: bool,
        from: Option<u64>,
    ) -> Self {
        let runner = Arc::new(Runner {
            clock: AtomicU64::new(from.unwrap_or(0)),
            thread: AtomicU32::new(host_threads::this_thread().unwrap_or(0)),
            ..Runner::default()
        });
        let mut table = lock(&scheduler.table);
        let rank = rank(&mut table);
        let entry = Entry {
            runner: Arc::clone(&runner),
            status: match from {
                Some(_) => Status::Free(scheduler.timeout()),
                None => Status::Outside,
            },
        };
        table.actors.insert(rank, entry);
        drop(table);
        Self { scheduler: Arc::clone(scheduler), runner, rank, is_ppe }
    }

    pub fn spe(scheduler: &Arc<Scheduler>, rank: Rank) -> Self {
        Self::new(scheduler, |_| rank, false, None)
    }

    /// The calling thread as an actor. It is scheduled from the time `from` on, or is outside
    /// until it first acts.
    pub fn ppe(scheduler: &Arc<Scheduler>, from: Option<u64>) -> Self {
        let next = |table: &mut ActorTable| {
            table.ppe_threads += 1;
            Rank::ppe(table.ppe_threads)
        };
        Self::new(scheduler, next, true, from)
    }

    pub fn clock(&self) -> u64 {
        self.runner.clock.load(SeqCst)
    }

    /// Whether it sleeps, or waits for its turn.
    pub fn waits(&self) -> bool {
        let table = lock(&self.scheduler.table);
        let entry = table.actors.get(&self.rank);
        entry.is_some_and(|entry| matches!(entry.status, Status::Waiting { .. }))
    }

    /// The time-out of a PPE thread, which may end without notice. A running SPE has none.
    fn timeout(&self) -> Option<Timeout> {
        self.is_ppe.then(|| self.scheduler.timeout()).flatten()
    }

    /// Whether SPEs run on the thread of their PPE.
    pub fn is_in_turn(&self) -> bool {
        self.scheduler.turns.is_some()
    }

    /// Has the turn at `clock` if no other actor comes before it. Otherwise it waits for it until
    /// [`resume`](Self::resume).
    pub fn has_turn(&self, clock: u64) -> bool {
        let clock = clock.max(self.clock());
        let table = lock(&self.scheduler.table);
        self.wait_in_turn(table, Status::Waiting { wanted: clock, since: clock, key: None })
    }

    /// Sleeps until another actor wakes `key`, or until `limit`, and then
    /// [`resume`](Self::resume).
    pub fn fall_asleep(&self, key: WaitKey, limit: Option<u64>) {
        let since = self.clock();
        let wanted = limit.map_or(NEVER, |limit| limit.max(since));
        let table = lock(&self.scheduler.table);
        self.wait_in_turn(table, Status::Waiting { wanted, since, key: Some(key) });
    }

    fn wait_in_turn(&self, mut table: MutexGuard<'_, ActorTable>, status: Status) -> bool {
        let sleeps = matches!(status, Status::Waiting { key: Some(_), .. });
        table.set(self.rank, status);
        let mut table = self.scheduler.proceed(table);
        match table.leader() {
            Some((clock, rank)) if rank == self.rank && !sleeps => {
                self.scheduler.give_turn(&mut table, self, clock);
                true
            }
            _ => false,
        }
    }

    /// The leader goes on. Returns its clock.
    pub fn resume(&self) -> u64 {
        let mut table = lock(&self.scheduler.table);
        let place = table.actors.get(&self.rank).and_then(Entry::place);
        let clock = place.unwrap_or_else(|| self.clock());
        self.scheduler.give_turn(&mut table, self, clock);
        clock
    }

    /// Schedules an outside actor again, after everything that has happened in the meantime.
    /// Returns its clock.
    pub fn rejoin(&self) -> u64 {
        let mut table = lock(&self.scheduler.table);
        let now = table.now;
        if let Some(entry) = table.actors.get_mut(&self.rank)
            && matches!(entry.status, Status::Outside)
        {
            self.runner.clock.fetch_max(now, SeqCst);
            entry.status = Status::Free(self.timeout());
        }
        self.clock()
    }

    /// Waits for the turn at `clock`.
    pub fn turn(&self, clock: u64) {
        let clock = clock.max(self.clock());
        let mut table = lock(&self.scheduler.table);
        table.set(self.rank, Status::Waiting { wanted: clock, since: clock, key: None });
        self.scheduler.await_turn(table, self, None, None);
    }

    /// The number of its deferred acts.
    #[inline]
    pub fn deferred(&self) -> usize {
        self.runner.deferred.load(SeqCst)
    }

    /// Schedules `act` for the actor's turn at `clock`. Another thread may execute it later.
    pub fn defer(&self, clock: u64, tags: u32, act: DeferredAct) {
        self.runner.clock.store(clock, SeqCst);
        self.runner.last_deferred.store(clock, Relaxed);
        let mut table = lock(&self.scheduler.table);
        self.runner.deferred.fetch_add(1, SeqCst);
        let act = Some(act);
        let deferred = Deferred { tags, act };
        table.deferred.insert((clock, self.rank), deferred);
        drop(self.scheduler.proceed(table));
    }

    /// Waits at `clock` until its deferred acts of these tags have been executed.
    pub fn await_deferred(&self, clock: u64, tags: u32) {
        let mut table = lock(&self.scheduler.table);
        if !table.is_deferred(self.rank, tags) {
            return;
        }
        self.runner.clock.store(clock, SeqCst);
        self.runner.awaited.store(tags, SeqCst);
        let status = Status::Waiting { wanted: clock, since: clock, key: None };
        table.set(self.rank, status);
        self.scheduler.await_turn(table, self, None, Some(tags));
        self.runner.awaited.store(0, SeqCst);
    }

    /// Sleeps until another actor wakes `key`, or until `limit`. Returns the time of the turn that
    /// it then has. With `pause`, if no other actor is scheduled, that much of the host's time
    /// passes before the clock jumps to the limit.
    pub fn sleep(&self, key: WaitKey, limit: Option<u64>, pause: Option<Duration>) -> u64 {
        let since = self.clock();
        let mut table = lock(&self.scheduler.table);
        let status = Status::Waiting {
            wanted: limit.map_or(NEVER, |limit| limit.max(since)),
            since,
            key: Some(key),
        };
        table.set(self.rank, status);
        self.scheduler.await_turn(table, self, pause, None)
    }

    /// Reports that the actor has run up to `clock`. At its limit, actors with smaller clocks run
    /// first.
    #[inline]
    pub fn run_up_to(&self, clock: u64) {
        if self.is_due(clock) {
            self.yield_to_others(clock);
        }
    }

    /// Whether [`run_up_to`](Self::run_up_to) `clock` would let other actors run first.
    #[inline]
    pub fn is_due(&self, clock: u64) -> bool {
        clock >= self.runner.limit.load(Relaxed)
    }

    /// Whether actors run one at a time.
    #[inline]
    pub fn is_serial(&self) -> bool {
        self.scheduler.serial.load(SeqCst)
    }

    #[cold]
    fn yield_to_others(&self, clock: u64) {
        if self.is_serial() {
            self.turn(clock);
        } else {
            self.progress(clock);
        }
    }

    /// Data that was just sent may be for this actor's own local store.
    pub fn expect_arrivals(&self) {
        let next = self.scheduler.arrivals.next();
        self.runner.limit.fetch_min(next, SeqCst);
    }

    /// Publishes the time up to which it has run without acting.
    pub fn progress(&self, clock: u64) {
        self.runner.clock.store(clock, SeqCst);
        self.runner.limit.store(clock + CYCLES_BETWEEN_CHECKS, SeqCst);
        let deferred = self.runner.last_deferred.load(Relaxed);
        if self.deferred() > 0 && clock > deferred + CYCLES_AHEAD {
            return self.await_deferred(clock, u32::MAX);
        }
        let first_wait = self.scheduler.first_wait.load(SeqCst);
        // Once for each wait is enough, because the last actor that passes it notifies the waiter.
        // Compiled code comes here every few microseconds, and several SPEs would otherwise keep
        // the table locked.
        if clock >= first_wait
            && self.runner.passed_wait.swap(first_wait.wrapping_add(1), SeqCst)
                != first_wait.wrapping_add(1)
        {
            drop(self.scheduler.proceed(lock(&self.scheduler.table)));
        }
    }

    /// Makes the actor an outside actor until it requests a turn again.
    pub fn leave(&self) {
        let mut table = lock(&self.scheduler.table);
        table.set(self.rank, Status::Outside);
        drop(self.scheduler.proceed(table));
    }

    /// Announces that the actor, if it is outside, will soon be scheduled at `clock`. No other
    /// actor may pass that time before.
    pub fn expect(&self, clock: u64) {
        let mut table = lock(&self.scheduler.table);
        if let Some(entry) = table.actors.get_mut(&self.rank)
            && matches!(entry.status, Status::Outside)
        {
            self.runner.clock.fetch_max(clock, SeqCst);
            let timeout = self.scheduler.turns.is_none().then(Timeout::without_thread);
            entry.status = Status::Free(timeout);
        }
    }

    /// Passes the turn to `other`, which continues at `clock` at the earliest, and leaves.
    pub fn hand_over_to(&self, other: &Self, clock: u64) {
        let mut table = lock(&self.scheduler.table);
        other.runner.clock.fetch_max(clock, SeqCst);
        table.set(self.rank, Status::Outside);
        table.set(other.rank, Status::Free(other.timeout()));
        let thread = host_threads::this_thread().unwrap_or(0);
        other.runner.thread.store(thread, SeqCst);
        drop(self.scheduler.proceed(table));
    }
}

impl Drop for Actor {
    fn drop(&mut self) {
        let mut table = lock(&self.scheduler.table);
        table.actors.remove(&self.rank);
        drop(self.scheduler.proceed(table));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulated::MemoryFigures;
    use std::sync::atomic::AtomicUsize;
    use std::thread;

    /// An SPE that is scheduled at `clock`.
    fn free(scheduler: &Arc<Scheduler>, number: u64, clock: u64) -> Actor {
        let actor = Actor::spe(scheduler, Rank::spe(number));
        actor.progress(clock);
        lock(&scheduler.table).set(actor.rank, Status::Free(None));
        actor
    }

    #[test]
    fn acts_come_one_at_a_time_in_the_order_of_clock_and_rank() {
        const ACTORS: u64 = 5;
        const ACTS: u64 = 200;
        let scheduler = Arc::new(Scheduler::new(MemoryFigures::CONSOLE.local_store_delay(), None));
        let acts = Mutex::new(Vec::new());
        let acting = AtomicUsize::new(0);
        let actors: Vec<_> = (0..ACTORS).map(|n| free(&scheduler, n, 0)).collect();
        thread::scope(|scope| {
            for (number, actor) in (0..ACTORS).zip(actors) {
                let (acts, acting) = (&acts, &acting);
                scope.spawn(move || {
                    // Steps have different lengths, with many ties.
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
    fn deferred_acts_come_in_the_same_order() {
        const ACTORS: u64 = 5;
        const ACTS: u64 = 200;
        const TAG: u32 = 1;
        let scheduler = Arc::new(Scheduler::new(MemoryFigures::CONSOLE.local_store_delay(), None));
        let acts = Arc::new(Mutex::new(Vec::new()));
        let actors: Vec<_> = (0..ACTORS).map(|n| free(&scheduler, n, 0)).collect();
        thread::scope(|scope| {
            for (number, actor) in (0..ACTORS).zip(actors) {
                let acts = &acts;
                scope.spawn(move || {
                    for act in 1..=ACTS {
                        let clock = act * (number % 3 + 1);
                        if (act + number) % 4 == 0 {
                            actor.turn(clock);
                            lock(acts).push((clock, number));
                            continue;
                        }
                        let list = Arc::clone(acts);
                        let push = move || lock(&list).push((clock, number));
                        actor.defer(clock, TAG, Box::new(push));
                        if act % 7 == 0 {
                            actor.await_deferred(clock, TAG);
                            assert!(lock(acts).contains(&(clock, number)));
                        }
                    }
                });
            }
        });
        let acts = lock(&acts);
        assert_eq!(acts.len() as u64, ACTORS * ACTS);
        assert!(acts.is_sorted());
    }

    #[test]
    fn sleeper_continues_after_the_waking_act_or_at_its_limit() {
        let scheduler = Arc::new(Scheduler::new(MemoryFigures::CONSOLE.local_store_delay(), None));
        let key = scheduler.new_key();
        let (early, late) = (free(&scheduler, 0, 0), free(&scheduler, 1, 0));
        let other = free(&scheduler, 2, 0);
        thread::scope(|scope| {
            let first = scope.spawn(|| {
                early.turn(10);
                let woken = early.sleep(key, None, None);
                early.leave();
                woken
            });
            let second = scope.spawn(|| {
                late.turn(70);
                let timed_out = late.sleep(scheduler.new_key(), Some(90), None);
                late.leave();
                timed_out
            });
            other.turn(50);
            scheduler.wake(key);
            other.turn(80);
            assert_eq!(first.join().unwrap(), 51);
            other.turn(100);
            assert_eq!(second.join().unwrap(), 90);
        });
    }
}
