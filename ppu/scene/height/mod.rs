//! Height fields in the form that SPUs stream from main memory: samples in levels, and for each eye
//! the blocks to trace, under a tree of boxes.
//!
//! A level has half of the samples in a row that the one before has. Near the eye, blocks have the
//! first level; where the distance doubles, the next (Strugar, Continuous Distance-Dependent Level
//! of Detail for Rendering Heightmaps, 2009). Before that distance they fade to it, so blocks of
//! neighbouring levels meet and nothing changes in a step. The SPUs make triangles of the samples
//! (`spu/isect/height_block.s`); here is only what blocks there are.
//!
//! Distances are those across the ground, together with the eye's height above the ground below
//! it. So they don't depend on heights elsewhere, and levels change by one from block to block.

mod levels;
mod samples;
mod shades;
mod shaped;
#[cfg(test)]
mod tests;
mod view;

pub(crate) use shaped::HeightViews;
pub(crate) use view::{HeightView, LEVEL_SQUARES};
