//! The keys of an animation's channel, and the values between them.

use glam::DQuat;

use super::accessor::{Data, Use};
use super::json::AnimationSampler;
use super::wrong;
use crate::Fault;

/// The most numbers that an animation has in its keys.
const MAX_NUMBERS: usize = 1 << 22;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Interpolation {
    Step,
    Linear,
    /// A value has a tangent before and after it.
    CubicSpline,
}

/// The values of a property at some times.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sampler {
    interpolation: Interpolation,
    /// Whether values are rotations, which are interpolated on the shortest arc.
    are_rotations: bool,
    /// In seconds. None is before the one in front of it.
    times: Vec<f64>,
    /// The numbers of a value.
    width: usize,
    numbers: Vec<f64>,
}

impl Sampler {
    /// Reads a sampler whose values have the type `kind` and consist of `width` numbers. `budget`
    /// is how many numbers may still be read.
    pub fn read(
        data: &Data<'_>,
        sampler: &AnimationSampler,
        (kind, width): (&str, usize),
        budget: &mut Budget,
    ) -> Result<Self, Fault> {
        let interpolation = match sampler.interpolation.as_deref() {
            None | Some("LINEAR") => Interpolation::Linear,
            Some("STEP") => Interpolation::Step,
            Some("CUBICSPLINE") => Interpolation::CubicSpline,
            Some(other) => {
                let other = scenes::Excerpt::of(other);
                return Err(wrong(format!(
                    "the interpolation {other} is not LINEAR, STEP or CUBICSPLINE"
                )));
            }
        };
        // Weights are items of one number each.
        let (components, items) = if kind == "SCALAR" { (1, width) } else { (width, 1) };
        let per_key = items * if interpolation == Interpolation::CubicSpline { 3 } else { 1 };
        let keys = data.count(sampler.input);
        let found = data.count(sampler.output);
        if keys.checked_mul(per_key) != Some(found) {
            return Err(wrong(format!(
                "the sampler has {found} values for {keys} keys, each of which needs {per_key}"
            )));
        }
        budget.take(keys.saturating_add(found.saturating_mul(components)))?;
        let times = data.read::<1>(sampler.input, Use::Positions, &["SCALAR"])?;
        let times = times.into_iter().map(|[time]| time).collect();
        let of = |width: usize| -> Result<Vec<f64>, Fault> {
            Ok(match width {
                1 => data.read::<1>(sampler.output, Use::Positions, &[kind])?.into_flattened(),
                3 => data.read::<3>(sampler.output, Use::Positions, &[kind])?.into_flattened(),
                _ => data.read::<4>(sampler.output, Use::Positions, &[kind])?.into_flattened(),
            })
        };
        let are_rotations = kind == "VEC4";
        let numbers = of(components)?;
        let mut read = Self { interpolation, are_rotations, times, width, numbers };
        read.check()?;
        Ok(read)
    }

    /// Checks times and values, and gives rotations a length of 1.
    fn check(&mut self) -> Result<(), Fault> {
        if self.times.is_empty() {
            return Err(wrong("the sampler has no keys".into()));
        }
        let mut before = f64::NEG_INFINITY;
        for (key, &time) in self.times.iter().enumerate() {
            if !time.is_finite() {
                return Err(wrong(format!("key {key} has the time {time}, which is not finite")));
            }
            if time < before {
                return Err(wrong(format!(
                    "key {key} has the time {time}, which is before {before}, that of the last key"
                )));
            }
            before = time;
        }
        let per_key = self.numbers.len() / self.times.len();
        if let Some(place) = self.numbers.iter().position(|it| !it.is_finite()) {
            let (key, value) = (place / per_key, self.numbers[place]);
            return Err(wrong(format!("key {key} has the value {value}, which is not finite")));
        }
        if !self.are_rotations {
            return Ok(());
        }
        for key in 0..self.times.len() {
            let start = self.start(key);
            let value = &mut self.numbers[start..start + 4];
            let rotation = DQuat::from_slice(value);
            let length = rotation.length();
            if length == 0.0 {
                return Err(wrong(format!("key {key} has a rotation of length 0")));
            }
            // The tangents of a spline belong to the value as it is.
            if self.interpolation != Interpolation::CubicSpline {
                (rotation / length).write_to_slice(value);
            }
        }
        Ok(())
    }

    /// Where the value of a key begins.
    fn start(&self, key: usize) -> usize {
        match self.interpolation {
            Interpolation::CubicSpline => (3 * key + 1) * self.width,
            _ => key * self.width,
        }
    }

    /// Whether the product of a value's numbers is negative at some keys and positive at others.
    pub fn changes_sign(&self) -> bool {
        let product = |key: usize| {
            let start = self.start(key);
            self.numbers[start..start + self.width].iter().product::<f64>()
        };
        let keys = || (0..self.times.len()).map(product);
        keys().any(|it| it < 0.0) && keys().any(|it| it > 0.0)
    }

    /// The time of the last key.
    pub fn end(&self) -> f64 {
        self.times.last().copied().unwrap_or_default()
    }

    /// Writes the value at a time: before the first key its value, and after the last one that
    /// one's. Where keys have the same time, the last of them has the value.
    pub fn at(&self, time: f64, value: &mut [f64]) {
        let after = self.times.partition_point(|&key| key <= time);
        let key = after.saturating_sub(1);
        let place = self.start(key);
        let from = &self.numbers[place..place + self.width];
        let is_between = 0 < after && after < self.times.len();
        if !is_between || self.interpolation == Interpolation::Step {
            value.copy_from_slice(from);
            return;
        }
        let next = self.start(after);
        let to = &self.numbers[next..next + self.width];
        let span = self.times[after] - self.times[key];
        let share = (time - self.times[key]) / span;
        if self.interpolation == Interpolation::CubicSpline {
            let outgoing = &self.numbers[place + self.width..place + 2 * self.width];
            let incoming = &self.numbers[next - self.width..next];
            let (square, cube) = (share * share, share * share * share);
            let of_to = 3.0 * square - 2.0 * cube;
            let (of_outgoing, of_incoming) =
                (span * (cube - 2.0 * square + share), span * (cube - square));
            for (index, value) in value.iter_mut().enumerate() {
                *value = (1.0 - of_to) * from[index]
                    + of_outgoing * outgoing[index]
                    + of_to * to[index]
                    + of_incoming * incoming[index];
            }
        } else {
            let (of_from, of_to) = match self.are_rotations {
                true => arc(DQuat::from_slice(from), DQuat::from_slice(to), share),
                false => (1.0 - share, share),
            };
            for (value, (from, to)) in value.iter_mut().zip(from.iter().zip(to)) {
                *value = of_from * from + of_to * to;
            }
        }
    }
}

/// The factors of two rotations of length 1 for the one between them, on the shortest arc. `libm`'s
/// sines are the same on every machine.
fn arc(from: DQuat, to: DQuat, share: f64) -> (f64, f64) {
    let cosine = from.dot(to);
    let sign = if cosine < 0.0 { -1.0 } else { 1.0 };
    let angle = libm::acos(cosine.abs().min(1.0));
    let sine = libm::sin(angle);
    if sine == 0.0 {
        return (1.0 - share, sign * share);
    }
    (libm::sin((1.0 - share) * angle) / sine, sign * libm::sin(share * angle) / sine)
}

/// How many numbers may still be read.
pub(super) struct Budget(usize);

impl Default for Budget {
    fn default() -> Self {
        Self(MAX_NUMBERS)
    }
}

impl Budget {
    fn take(&mut self, numbers: usize) -> Result<(), Fault> {
        let left = self.0.checked_sub(numbers);
        self.0 = left.ok_or_else(|| {
            wrong(format!("the keys of the animation have more than {MAX_NUMBERS} numbers"))
        })?;
        Ok(())
    }
}
