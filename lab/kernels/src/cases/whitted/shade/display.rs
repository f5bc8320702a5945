//! The kernels that convert rows of sums for a display.

use crate::prelude::*;
use twins::display::{encode_srgb, roll_off};

/// Values that are overwritten by those of `encode_srgb`, or by those of `roll_off`.
#[derive(Clone, Debug)]
pub struct Values<const ROLL_OFF: bool> {
    /// The values.
    pub values: Vec<[Single; 4]>,
}

impl<const ROLL_OFF: bool> Description for Values<ROLL_OFF> {
    const KERNEL: &'static str = if ROLL_OFF { "roll_off" } else { "encode_srgb" };
    const ROUNDS: [usize; 2] = [10, 200];
    type Placed = Place;
    type Found = Vec<[Single; 4]>;

    /// Multiples of four.
    fn lengths() -> impl Iterator<Item = usize> {
        [1, 2, 3, 5, 8, 16, 100].into_iter().map(|fours| 4 * fours)
    }

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut value = || from_f64(random.random_range(-0.25..2.0));
        Self { values: (0..count).map(|_| [(); 4].map(|()| value())).collect() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self { values: (0..count).map(|_| random.random()).collect() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let quads: Vec<_> = self.values.iter().map(|quad| quad.map(single)).collect();
        let place = put(bench, &quads);
        (place, vec![place.address, quads.len() as u32])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Self::Found {
        bench.read_all::<[F32; 4]>(*placed).into_iter().map(|quad| quad.map(bits)).collect()
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let twin = if ROLL_OFF { roll_off } else { encode_srgb };
        self.values.iter().map(|quad| quad.map(twin)).collect()
    }
}
