//! Maps that the tests make themselves, whole and damaged, and those of Freedoom.

mod faults;
mod freedoom;
mod geometry;
mod maker;
mod mutated;
mod shafts;
