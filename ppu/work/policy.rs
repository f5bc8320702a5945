//! How frames are planned: how they are split among SPUs, and which work is skipped.

use protocol::formulation::EyeRecord;

/// How a frame is split among SPUs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "choices", derive(clap::ValueEnum))]
pub enum Split {
    /// An SPU that has finished a work unit takes the next one.
    #[default]
    Units,
    /// Each SPU has its own consecutive part of the picture, as in the paper.
    Slices,
}

/// Which tests the SPUs may skip.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Skip {
    /// Tests of rays with objects that they can't hit.
    #[default]
    Misses,
    /// None: every ray is tested with every object, as in the paper.
    Nothing,
}

/// How frames are planned.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Policy {
    pub spus: u32,
    pub split: Split,
    pub skip: Skip,
    /// The form of sphere records that the program expects.
    pub record: EyeRecord,
    /// Whether pages keep their contents, so that the background need not be written again.
    pub keeps: bool,
    /// Whether tiles that the pages already show are not traced again.
    pub retain: bool,
    /// The largest number of tiles to trace, if tiles are retained. The others are left for the
    /// next frame.
    pub most_tiles: Option<u32>,
}
