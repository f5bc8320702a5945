//! One description a kernel: its inputs, its call and its twin; and the driver that compares the
//! two for every kernel in the same way, for lists of every relevant length, on inputs like those
//! of frames and on random bits, as a hostile caller ([`Bench::call`]).

use std::fmt::{self, Debug};
use std::ops::Range;

use rand::RngCore;
use rand_chacha::ChaCha8Rng;
use thiserror::Error;
use zerocopy::{FromBytes, Immutable, IntoBytes};

use crate::bench::Bench;

/// Everything is a share of nothing: a description that counts nothing has it.
pub const ANY_SHARE: Range<f64> = f64::NEG_INFINITY..f64::INFINITY;

/// Lengths of lists, with that of an empty one. A scheduled loop takes other paths for the short
/// ones.
pub const LENGTHS_FROM_0: &[usize] = &[0, 1, 2, 3, 7, 16, 40];

/// The inputs of one call of a kernel.
pub trait Description: Debug + Sized {
    /// The kernel.
    const KERNEL: &'static str;
    /// The number of calls for each length with sensible inputs, and of all calls with any bits,
    /// which take one length after the other.
    const ROUNDS: [usize; 2];
    /// The lengths of lists.
    const LENGTHS: &'static [usize] = &[1, 2, 3, 7, 16, 40];
    /// Between which limits the part that [`Self::part`] counts must be of the whole, for sensible
    /// inputs and for any bits. Otherwise the inputs test little.
    const SHARES: [Range<f64>; 2] = [ANY_SHARE; 2];

    /// Where the call's buffers are.
    type Placed;
    /// What the kernel finds.
    type Found: PartialEq + Debug;

    /// The same lengths, for a description with more of them than a constant should list.
    fn lengths() -> impl Iterator<Item = usize> {
        Self::LENGTHS.iter().copied()
    }

    /// Inputs like those of frames, for a list of this length.
    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self;

    /// Inputs of any bits that the kernel allows.
    fn any(count: usize, random: &mut ChaCha8Rng) -> Self;

    /// Puts the inputs into local store. Returns the arguments, too.
    fn place(&self, bench: &mut Bench) -> (Self::Placed, Vec<u32>);

    /// Reads what the kernel found, given the word that it returned.
    fn found(&self, bench: &Bench, placed: &Self::Placed, returned: u32) -> Self::Found;

    /// What the twin finds.
    fn twin(&self, placed: &Self::Placed) -> Self::Found;

    /// The part and the whole that [`Self::SHARES`] limits.
    fn part(&self, _found: &Self::Found) -> [usize; 2] {
        [0, 0]
    }

    /// Calls the kernel.
    fn call(&self, bench: &mut Bench) -> Self::Found {
        self.call_placed(bench).1
    }

    /// The same, and where the buffers are.
    fn call_placed(&self, bench: &mut Bench) -> (Self::Placed, Self::Found) {
        bench.reset();
        let (placed, arguments) = self.place(bench);
        let returned = bench.call(Self::KERNEL, &arguments).value;
        let found = self.found(bench, &placed, returned);
        (placed, found)
    }

    /// Calls the kernel, and compares with its twin.
    fn compare(&self, bench: &mut Bench) -> Result<(Self::Placed, Self::Found), Unequal> {
        let (placed, found) = self.call_placed(bench);
        let expected = self.twin(&placed);
        if found == expected {
            return Ok((placed, found));
        }
        Err(Unequal(format!(
            "{}: {found:x?} is not what its twin makes of {self:x?}: {expected:x?}",
            Self::KERNEL
        )))
    }

    /// Calls the kernel, which must find what its twin finds.
    ///
    /// # Panics
    ///
    /// Panics if it does not.
    fn check(&self, bench: &mut Bench) -> Self::Found {
        self.check_placed(bench).1
    }

    /// The same, and where the buffers are.
    ///
    /// # Panics
    ///
    /// As [`Self::check`].
    fn check_placed(&self, bench: &mut Bench) -> (Self::Placed, Self::Found) {
        self.compare(bench).unwrap_or_else(|error| panic!("{error}"))
    }
}

/// A record that is compared by all of its bits.
#[derive(Clone, Copy)]
pub struct Bits<T>(pub T);

impl<T: IntoBytes + Immutable> PartialEq for Bits<T> {
    fn eq(&self, other: &Self) -> bool {
        self.0.as_bytes() == other.0.as_bytes()
    }
}

impl<T: IntoBytes + Immutable> Debug for Bits<T> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.as_bytes().fmt(out)
    }
}

/// How a kernel and its twin differ, or that the inputs do not test it.
#[derive(Debug, Error)]
#[error("{0}")]
pub struct Unequal(String);

/// Compares a kernel with its twin in many calls. Returns their number.
pub type Equal = fn(&mut Bench, &mut ChaCha8Rng) -> Result<usize, Unequal>;

/// The [`Equal`] of a described kernel.
pub fn equal<D: Description>(bench: &mut Bench, random: &mut ChaCha8Rng) -> Result<usize, Unequal> {
    let [sensible, any] = D::ROUNDS;
    let lengths = (0..sensible).flat_map(|_| D::lengths());
    let sensible = series(lengths, &D::SHARES[0], |count| D::sensible(count, random), bench)?;
    let lengths: Vec<usize> = D::lengths().collect();
    let lengths = lengths.into_iter().cycle().take(any);
    let any = series(lengths, &D::SHARES[1], |count| D::any(count, random), bench)?;
    Ok(sensible + any)
}

fn series<D: Description>(
    lengths: impl Iterator<Item = usize>,
    share: &Range<f64>,
    mut inputs: impl FnMut(usize) -> D,
    bench: &mut Bench,
) -> Result<usize, Unequal> {
    let [mut calls, mut part, mut whole] = [0; 3];
    for count in lengths {
        let inputs = inputs(count);
        let (_, found) = inputs.compare(bench)?;
        let [more, of] = inputs.part(&found);
        (calls, part, whole) = (calls + 1, part + more, whole + of);
    }
    // A share of nothing is no number, and within no limits.
    if *share != ANY_SHARE && !share.contains(&(part as f64 / whole as f64)) {
        let kernel = D::KERNEL;
        return Err(Unequal(format!("{kernel}: {part} of {whole}, not a share in {share:?}")));
    }
    Ok(calls)
}

/// A value of random bits.
#[must_use]
pub fn any_bits<T: FromBytes>(random: &mut impl RngCore) -> T {
    let mut bytes = vec![0; size_of::<T>()];
    random.fill_bytes(&mut bytes);
    T::read_from_bytes(&bytes).unwrap_or_else(|_| unreachable!("there are as many bytes"))
}
