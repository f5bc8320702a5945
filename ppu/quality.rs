//! Three points on the front of run time against error that `docs/accuracy.md` measures.

use protocol::formulation::Formulations;

/// How much run time is given for how little error.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quality {
    /// The fastest whose pictures are right to a step of a colour.
    Fast,
    /// The fastest that keeps distances to 2 units in the last place.
    #[default]
    Default,
    /// The least error, in double precision.
    Exact,
}

impl Quality {
    /// The formulations of that point.
    #[must_use]
    pub fn formulations(self) -> Formulations {
        match self {
            Self::Fast => Formulations::fast(),
            Self::Default => Formulations::standard(),
            Self::Exact => Formulations::exact(),
        }
    }
}
