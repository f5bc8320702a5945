//! Axes: the position of a value, and the values that are written along the axis.

/// The share of a logarithmic axis that is reserved for 0, if it has one.
const ZERO: f64 = 0.09;

/// An axis with its range of values.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Scale {
    kind: Kind,
    low: f64,
    high: f64,
    /// Whether a logarithmic axis includes 0, which gets a place of its own.
    zero: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Linear,
    Log,
}

impl Scale {
    /// A scale for these values. A logarithmic one must not have values below 0.
    pub fn new(kind: Kind, values: impl Iterator<Item = f64> + Clone) -> Self {
        let zero = kind == Kind::Log && values.clone().any(|value| value == 0.0);
        let values = values.filter(|value| kind == Kind::Linear || *value > 0.0);
        let low = values.clone().fold(f64::INFINITY, f64::min);
        let high = values.fold(f64::NEG_INFINITY, f64::max);
        let (low, high) = if low <= high { (low, high) } else { (1.0, 1.0) };
        let (low, high) = match kind {
            Kind::Linear => {
                let margin =
                    if high > low { 0.08 * (high - low) } else { 0.5 * high.abs().max(1.0) };
                (low - margin, high + margin)
            }
            Kind::Log => {
                let margin = libm::pow(high / low, 0.08).max(1.25);
                (low / margin, high * margin)
            }
        };
        Self { kind, low, high, zero }
    }

    /// The position of a value, from 0 to 1.
    pub fn place(&self, value: f64) -> f64 {
        match self.kind {
            Kind::Linear => (value - self.low) / (self.high - self.low),
            Kind::Log if value == 0.0 => ZERO / 3.0,
            Kind::Log => {
                let start = if self.zero { ZERO } else { 0.0 };
                let part = libm::log(value / self.low) / libm::log(self.high / self.low);
                start + part * (1.0 - start)
            }
        }
    }

    /// The values that are written along the axis.
    pub fn ticks(&self) -> Vec<f64> {
        let mut ticks = match self.kind {
            Kind::Linear => self.linear_ticks(),
            Kind::Log => self.log_ticks(),
        };
        if self.zero {
            ticks.insert(0, 0.0);
        }
        ticks
    }

    fn linear_ticks(&self) -> Vec<f64> {
        let rough = (self.high - self.low) / 6.0;
        let decade = libm::pow(10_f64, libm::log10(rough).floor());
        let steps = [1.0, 2.0, 5.0, 10.0].map(|step| step * decade);
        let step = steps.into_iter().find(|step| *step >= rough).unwrap_or(rough);
        let first = (self.low / step).ceil() as i64;
        let last = (self.high / step).floor() as i64;
        (first..=last).map(|number| number as f64 * step).collect()
    }

    fn log_ticks(&self) -> Vec<f64> {
        let decades = libm::log10(self.high / self.low);
        let first = libm::log10(self.low).floor() as i32;
        let last = libm::log10(self.high).ceil() as i32;
        // About as many as fit.
        let (every, within): (i32, &[f64]) = if decades > 8.0 {
            ((decades / 6.0).ceil() as i32, &[1.0])
        } else if decades > 2.5 {
            (1, &[1.0])
        } else if decades > 1.0 {
            (1, &[1.0, 2.0, 5.0])
        } else {
            (1, &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0])
        };
        (first..=last)
            .filter(|decade| decade.rem_euclid(every) == 0)
            .flat_map(|decade| within.iter().map(move |part| part * 10_f64.powi(decade)))
            .filter(|tick| (self.low..=self.high).contains(tick))
            .collect()
    }
}

/// The text of a value along the axis.
pub(super) fn written(value: f64) -> String {
    if value != 0.0 && !(1e-3..1e5).contains(&value.abs()) {
        return format!("{value:.0e}");
    }
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scale(kind: Kind, values: &[f64]) -> Scale {
        Scale::new(kind, values.iter().copied())
    }

    #[test]
    fn all_values_lie_on_the_axis_in_their_order() {
        for kind in [Kind::Linear, Kind::Log] {
            let values = [0.02, 3.0, 41.0, 5e6];
            let scale = scale(kind, &values);
            let places = values.map(|value| scale.place(value));
            assert!(places.is_sorted() && places[0] > 0.0 && places[3] < 1.0);
            assert!(scale.ticks().iter().all(|tick| (0.0..=1.0).contains(&scale.place(*tick))));
            assert!((3..12).contains(&scale.ticks().len()), "{:?}", scale.ticks());
        }
    }

    #[test]
    fn log_scale_puts_zero_below_all_values() {
        let scale = scale(Kind::Log, &[0.0, 0.5, 20.0]);
        assert!(scale.place(0.0) < scale.place(0.4) && scale.place(0.0) > 0.0);
        assert_eq!(scale.ticks()[0], 0.0);
    }

    #[test]
    fn axis_exists_for_one_value_and_none() {
        for kind in [Kind::Linear, Kind::Log] {
            for values in [&[7.0][..], &[]] {
                let scale = scale(kind, values);
                assert!((0.0..1.0).contains(&scale.place(7.0_f64.min(scale.high * 0.99))));
                assert!(!scale.ticks().is_empty());
            }
        }
    }

    #[test]
    fn values_are_written_short() {
        let texts = [0.0, 0.25, 5.0, 1024.0, 2e6, 1e-5].map(written);
        assert_eq!(texts, ["0", "0.25", "5", "1024", "2e6", "1e-5"]);
    }
}
