//! Where the shadow of a ball may fall.
//!
//! Behind a ball, as a light sees it, is a row of balls of which each point in the shadow is in one: along the ray
//! from the light through the centre, all touching the cone that the light sees the first one fill. Invariant: the
//! answers hold every pixel in the shadow, with much room for the rounding of the SPU's shadow rays.

use glam::DVec3;
use nff::{LightKind, unit};

use super::ball::Ball;
use super::shown::Seen;
use crate::work::lens::{Lens, Rectangle};

/// By how much a ball that throws a shadow is widened, in parts of all distances that its shadow rays take: they
/// are off by some 2^-20 of these.
const SLACK: f64 = 1.0 / (1 << 15) as f64;

/// Pieces into which the row of balls on an object is cut: a shadow that runs across the picture then needs
/// not all of the rectangle around it.
const PIECES: u32 = 8;

/// The row: ball k is `growth` k + `radius` large, at `from` + k `way`, for k from `first` on.
pub(super) struct Shadow {
    from: DVec3,
    way: DVec3,
    growth: f64,
    radius: f64,
    first: f64,
    /// The sum of the distances that the slack is a part of, but for those of the object that it falls on.
    reach: f64,
}

impl Shadow {
    /// The shadow of an object; nothing where the light is in it or nearly so: it falls anywhere.
    pub fn of(seen: &Seen, light: LightKind, lens: &Lens) -> Option<Self> {
        let Ball { centre, radius } = seen.ball;
        let reach = lens.to(centre).length() + radius;
        match light {
            LightKind::Point { position } => {
                let way = centre - position;
                let reach = reach + way.length();
                let growth = radius + SLACK * reach;
                (way.length() > 2.0 * growth).then_some(Self {
                    from: position,
                    way,
                    growth,
                    radius: 0.0,
                    first: 1.0,
                    reach,
                })
            }
            LightKind::Directional { to_light } => Some(Self {
                from: centre,
                way: -unit(to_light)?,
                growth: 0.0,
                radius,
                first: 0.0,
                reach,
            }),
        }
    }

    /// Hands out the pixels on which it may fall on an object.
    pub fn on(&self, seen: &Seen, lens: &Lens, found: &mut impl FnMut(&Rectangle)) {
        let distances = self.reach + self.from.distance(seen.ball.centre) + seen.ball.radius;
        let wider = Self {
            radius: self.radius + SLACK * (distances + lens.to(seen.ball.centre).length()),
            ..*self
        };
        let Some((first, last)) = wider.touching(seen) else {
            return;
        };
        let at = |piece: u32| {
            let k = first + (last - first) * f64::from(piece) / f64::from(PIECES);
            (wider.from + k * wider.way, wider.growth * k + wider.radius)
        };
        for piece in 0..PIECES {
            found(&lens.sweep([at(piece), at(piece + 1)]));
        }
    }

    /// The first and the last of the balls that may touch an object.
    fn touching(&self, seen: &Seen) -> Option<(f64, f64)> {
        // |to - k way| <= growth k + radius + the object's radius, squared.
        let to = seen.ball.centre - self.from;
        let sum = self.radius + seen.ball.radius;
        let square = self.way.length_squared() - self.growth * self.growth;
        let half = to.dot(self.way) + self.growth * sum;
        let rest = to.length_squared() - sum * sum;
        let under = half * half - square * rest;
        if under < 0.0 {
            return None;
        }
        let root = under.sqrt();
        let mut first = ((half - root) / square).max(self.first);
        let mut last = (half + root) / square;
        if let Some((point, normal)) = seen.plane {
            // |height + k rise| <= growth k + radius, on either side.
            let height = (self.from - point).dot(normal);
            let rise = self.way.dot(normal);
            for side in [1.0, -1.0] {
                let (slope, least) = (side * rise - self.growth, side * height - self.radius);
                if slope < 0.0 {
                    first = first.max(-least / slope);
                } else if slope > 0.0 {
                    last = last.min(-least / slope);
                } else if least > 0.0 {
                    return None;
                }
            }
        }
        (first <= last).then_some((first, last))
    }
}
