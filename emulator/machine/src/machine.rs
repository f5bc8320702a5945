//! A machine: main memory, a time base, and everything else that its SPEs share.

use std::sync::Arc;

use crate::compiled::{Difference, Translations};
use crate::decrementer::{Clock, HostClock};
use crate::engine::Engine;
use crate::in_turn::Turns;
use crate::memory::MainMemory;
use crate::mfc::interconnect::Interconnect;
use crate::mfc::timing::InFlight;
use crate::simulated::{Simulation, SimulationOptions, Timing};

/// The machine on which [`Spe`](crate::spe::Spe)s are created.
pub struct Machine {
    interconnect: Interconnect,
    clock: Arc<dyn Clock>,
    simulation: Option<Arc<Simulation>>,
    translations: Option<Arc<Translations>>,
    turns: Option<Arc<Turns>>,
}

fn translations(engine: Engine, timed: bool, watches: bool) -> Option<Arc<Translations>> {
    match engine {
        Engine::Interpreter => None,
        Engine::Compiler => Translations::with(false, timed, watches),
        Engine::Check => Translations::with(true, timed, watches),
    }
}

impl Machine {
    fn made(
        memory: Arc<dyn MainMemory>,
        clock: Arc<dyn Clock>,
        simulation: Option<Arc<Simulation>>,
        translations: Option<Arc<Translations>>,
        turns: Option<Arc<Turns>>,
    ) -> Arc<Self> {
        let in_flight = simulation.clone().map(|simulation| simulation as Arc<dyn InFlight>);
        let interconnect = Interconnect::new(memory, in_flight);
        Arc::new(Self { interconnect, clock, simulation, translations, turns })
    }

    /// A machine with this memory. Its time base is the host's time.
    #[must_use]
    pub fn new(memory: Arc<dyn MainMemory>) -> Arc<Self> {
        Self::with_engine(memory, Engine::default())
    }

    /// A machine with this memory and time base.
    #[must_use]
    pub fn with_clock(memory: Arc<dyn MainMemory>, clock: Arc<dyn Clock>) -> Arc<Self> {
        Self::made(memory, clock, None, translations(Engine::default(), false, false), None)
    }

    /// A machine with this memory, whose time base is the host's time and whose SPEs run their
    /// instructions so.
    #[must_use]
    pub fn with_engine(memory: Arc<dyn MainMemory>, engine: Engine) -> Arc<Self> {
        Self::made(memory, Arc::new(HostClock), None, translations(engine, false, false), None)
    }

    /// A machine with this memory, in simulated time with these latencies and rates.
    ///
    /// # Panics
    ///
    /// If no transfer could ever end, because `timing` has no cycles for a line or allows no line
    /// in flight.
    #[must_use]
    pub fn simulated(memory: Arc<dyn MainMemory>, timing: Timing) -> Arc<Self> {
        Self::simulated_with(memory, timing, SimulationOptions::default())
    }

    /// As [`simulated`](Self::simulated). `options` select the records and the method of counting.
    ///
    /// # Panics
    ///
    /// As [`simulated`](Self::simulated) does.
    #[must_use]
    pub fn simulated_with(
        memory: Arc<dyn MainMemory>,
        timing: Timing,
        options: SimulationOptions,
    ) -> Arc<Self> {
        let simulation = Simulation::new(timing, options);
        let translations = translations(options.engine, true, options.races);
        Self::made(memory, Arc::new(HostClock), Some(simulation), translations, None)
    }

    /// A machine with this memory and time base whose SPEs run [in turn](crate::in_turn).
    #[must_use]
    pub fn in_turn(memory: Arc<dyn MainMemory>, clock: Arc<dyn Clock>) -> Arc<Self> {
        let translations = translations(Engine::default(), false, false);
        Self::made(memory, clock, None, translations, Some(Arc::default()))
    }

    /// As [`simulated_with`](Self::simulated_with), with SPEs that run [in turn](crate::in_turn)
    /// and are interpreted.
    ///
    /// # Panics
    ///
    /// As [`simulated`](Self::simulated) does.
    #[must_use]
    pub fn simulated_in_turn(
        memory: Arc<dyn MainMemory>,
        timing: Timing,
        options: SimulationOptions,
    ) -> Arc<Self> {
        let turns = Arc::<Turns>::default();
        let simulation = Simulation::in_turn(timing, options, Arc::clone(&turns));
        Self::made(memory, Arc::new(HostClock), Some(simulation), None, Some(turns))
    }

    /// The machine's simulated time, if it has one.
    #[must_use]
    pub fn simulation(&self) -> Option<&Arc<Simulation>> {
        self.simulation.as_ref()
    }

    /// The number of times that an SPU reaches an address before the code there is compiled, by
    /// default 200. Compiling takes about a thousand times as long as interpreting.
    pub fn compile_after(&self, times: u16) {
        if let Some(translations) = &self.translations {
            translations.compile_after(times);
        }
    }

    /// From now on all code is optimized as soon as it is compiled, as tests want it.
    pub fn optimize_at_once(&self) {
        if let Some(translations) = &self.translations {
            translations.optimize_at_once();
        }
    }

    /// From now on code that runs often is optimized by a thread of its own, beside the SPUs.
    pub fn optimize_in_background(&self) {
        if let Some(translations) = &self.translations {
            translations.optimize_in_background();
        }
    }

    /// The first difference that [`Engine::Check`] has found.
    #[must_use]
    pub fn difference(&self) -> Option<Difference> {
        self.translations.as_ref()?.difference()
    }

    /// The SPEs, if they run [in turn](crate::in_turn).
    #[must_use]
    pub fn turns(&self) -> Option<&Arc<Turns>> {
        self.turns.as_ref()
    }

    pub(crate) fn translations(&self) -> Option<&Arc<Translations>> {
        self.translations.as_ref()
    }

    /// The machine's main memory.
    #[must_use]
    pub fn memory(&self) -> &dyn MainMemory {
        self.interconnect.memory()
    }

    pub(crate) fn interconnect(&self) -> &Interconnect {
        &self.interconnect
    }

    pub(crate) fn clock(&self) -> &dyn Clock {
        &*self.clock
    }
}
