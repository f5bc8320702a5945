//! How frames are made: split among SPUs, and what is left out of them.

use protocol::formulation::EyeRecord;

/// How a frame is split among SPUs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Split {
    /// Each SPU takes the next work unit when it has finished one.
    #[default]
    Units,
    /// Each SPU has its own consecutive part of the picture, as in the paper.
    Slices,
}

/// What need not be tested.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Skip {
    /// What can't be hit.
    #[default]
    Misses,
    /// Every ray is tested with every object, as in the paper.
    Nothing,
}

/// How frames are planned.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Policy {
    pub spus: u32,
    pub split: Split,
    pub skip: Skip,
    /// How the program takes spheres.
    pub record: EyeRecord,
    /// Whether pages keep what was written to them, so that the background need not be sent twice.
    pub keeps: bool,
    /// Whether what they show need not be traced again.
    pub retain: bool,
}
