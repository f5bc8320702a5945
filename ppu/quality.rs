//! Three qualities: points on the Pareto front of run time and error that `docs/accuracy.md`
//! measures.

use protocol::formulation::Formulations;

/// A trade-off between run time and error.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "choices", derive(clap::ValueEnum))]
pub enum Quality {
    /// The fastest formulations with pictures that are right to a step of a colour.
    Fast,
    /// The fastest formulations with distances that are right to 2 units in the last place.
    #[default]
    Default,
    /// The formulations with the smallest error, in double precision.
    Exact,
}

impl Quality {
    /// The formulations of this quality.
    #[must_use]
    pub fn formulations(self) -> Formulations {
        match self {
            Self::Fast => Formulations::fast(),
            Self::Default => Formulations::standard(),
            Self::Exact => Formulations::exact(),
        }
    }
}
