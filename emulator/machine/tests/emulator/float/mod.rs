//! The SPU's arithmetic.

mod corners;
mod double;
mod exact;
mod ordinary;
mod single;
mod soft;
