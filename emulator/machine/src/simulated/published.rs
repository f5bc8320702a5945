//! The figures and the profile that an SPE publishes at one moment, and its timeline so far.

use super::figures::SimulationOptions;
use super::report::SpeReport;
use super::spu_clock::SpuClock;
use super::timeline::Timeline;
use crate::mfc::Commands;
use crate::profile::{Profile, ProgramId, ProgramProfile, SpeProfile};

/// Invariant: the profile's cycles add up to the report's account.
#[derive(Default)]
pub(super) struct Published {
    report: SpeReport,
    profiles: Option<Profiles>,
    timeline: Option<Timeline>,
}

/// One profile for each program, in the order in which they were loaded.
struct Profiles {
    programs: Vec<(Option<ProgramId>, Profile)>,
    /// The index of the program that is loaded.
    loaded: usize,
}

impl Published {
    pub fn new(options: SimulationOptions) -> Self {
        Self {
            report: SpeReport::default(),
            profiles: options
                .profile
                .then(|| Profiles { programs: vec![(None, Profile::default())], loaded: 0 }),
            timeline: options.timeline.then(Timeline::default),
        }
    }

    pub fn report(&self) -> &SpeReport {
        &self.report
    }

    /// The SPE's timeline so far, if it is recorded.
    pub fn timeline(&mut self) -> Option<&mut Timeline> {
        self.timeline.as_mut()
    }

    /// The profiles of the programs that have run.
    pub fn profile(&self) -> SpeProfile {
        let programs = self.profiles.iter().flat_map(|profiles| &profiles.programs);
        let ran = programs.filter(|(_, profile)| !profile.entries().is_empty());
        SpeProfile {
            programs: ran.map(|(id, profile)| ProgramProfile::new(*id, profile)).collect(),
        }
    }

    /// From now on, figures belong to this program.
    pub fn load(&mut self, id: ProgramId) {
        if let Some(Profiles { programs, loaded }) = &mut self.profiles {
            let known = programs.iter().position(|(known, _)| *known == Some(id));
            *loaded = known.unwrap_or_else(|| {
                programs.push((Some(id), Profile::default()));
                programs.len() - 1
            });
        }
    }

    pub fn publish(&mut self, clock: &mut SpuClock, commands: Commands) {
        self.report = SpeReport {
            clock: clock.now(),
            stopped: clock.stopped(),
            account: clock.account().clone(),
            waits: clock.waits(),
            commands,
        };
        if let Some(Profiles { programs, loaded }) = &mut self.profiles {
            clock.hand_over(&mut programs[*loaded].1);
        }
    }
}
