//! Bounding spheres, and what few of them bound.
//!
//! Invariant: what [`enclose`] gives holds every ball that it was given, `f64`'s rounding
//! included.

use glam::DVec3;

/// Steps towards the farthest ball: a test holds the radius to 2 % above the smallest there is.
const STEPS: u32 = 100;

/// By how much a radius is rounded up, in parts of the centre's coordinates and the radius.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// All points up to a distance from a centre; a point, if that is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ball {
    pub centre: DVec3,
    pub radius: f64,
}

impl Ball {
    pub fn point(centre: DVec3) -> Self {
        Self {
            centre,
            radius: 0.0,
        }
    }

    /// The farthest that any of its points is from here.
    fn farthest(&self, from: DVec3) -> f64 {
        from.distance(self.centre) + self.radius
    }
}

/// Up to four balls.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hull {
    balls: [Ball; 4],
    count: usize,
}

impl Hull {
    pub fn of<const COUNT: usize>(found: [Ball; COUNT]) -> Self {
        let mut balls = [Ball::point(DVec3::ZERO); 4];
        balls[..COUNT].copy_from_slice(&found);
        Self {
            balls,
            count: COUNT,
        }
    }

    pub fn balls(&self) -> &[Ball] {
        &self.balls[..self.count]
    }
}

/// A ball around all of `balls`, nearly the smallest; nothing around none.
///
/// By Bădoiu and Clarkson's steps of falling length to the farthest point, from the middle of the
/// box; the best place on the way is taken.
pub(super) fn enclose(balls: &[Ball]) -> Option<Ball> {
    let (&first, others) = balls.split_first()?;
    if others.is_empty() {
        return Some(first);
    }
    let low = |ball: &Ball| ball.centre - ball.radius;
    let high = |ball: &Ball| ball.centre + ball.radius;
    let low = others.iter().map(low).fold(low(&first), DVec3::min);
    let high = others.iter().map(high).fold(high(&first), DVec3::max);
    let mut centre = low.midpoint(high);
    let mut best = (f64::INFINITY, centre);
    for step in 1..=STEPS {
        let start = (first.farthest(centre), &first);
        let (radius, ball) = others.iter().fold(start, |found, ball| {
            let radius = ball.farthest(centre);
            if radius > found.0 {
                (radius, ball)
            } else {
                found
            }
        });
        if radius < best.0 {
            best = (radius, centre);
        }
        let way = ball.centre - centre;
        let beyond = way.try_normalize().unwrap_or(DVec3::X) * ball.radius;
        centre += (way + beyond) / f64::from(step + 1);
    }
    let (radius, centre) = best;
    let rounding = ROUNDING * (centre.abs().max_element() + radius);
    Some(Ball {
        centre,
        radius: radius + rounding,
    })
}

#[cfg(test)]
mod tests {
    use rand::{Rng as _, SeedableRng as _};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::scene::random::{magnitude, unit};

    #[test]
    fn every_ball_is_inside() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        for _ in 0..2000 {
            let place = unit(&mut random) * magnitude(&mut random, -4.0, 30.0);
            let spread = magnitude(&mut random, -10.0, 10.0);
            let balls: Vec<Ball> = (0..random.random_range(1..12))
                .map(|_| Ball {
                    centre: place + unit(&mut random) * spread,
                    radius: spread * random.random_range(0.0..2.0),
                })
                .collect();
            let around = enclose(&balls).expect("a ball");
            for ball in &balls {
                assert!(ball.farthest(around.centre) <= around.radius, "{balls:?}");
            }
        }
        assert_eq!(enclose(&[]), None);
    }

    #[test]
    fn a_ball_is_nearly_the_smallest() {
        let mut random = ChaCha8Rng::seed_from_u64(2);
        for _ in 0..200 {
            // The ends of a diameter and anything in the sphere: that is the smallest.
            let (centre, axis) = (unit(&mut random) * 5.0, unit(&mut random));
            let mut balls = vec![Ball::point(centre + axis), Ball::point(centre - axis)];
            for _ in 0..random.random_range(0..10) {
                let share = random.random_range(0.0..1.0);
                balls.push(Ball {
                    centre: centre + unit(&mut random) * share,
                    radius: (1.0 - share) * random.random_range(0.0..1.0),
                });
            }
            let around = enclose(&balls).expect("a ball");
            assert!(around.radius < 1.02, "{}", around.radius);
        }
    }
}
