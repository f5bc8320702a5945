//! Balls that bounce off one another.
//!
//! Invariants: when two balls meet, their total momentum stays the same and their energy never
//! grows. Afterwards they do not overlap; the lighter one is moved by more.

use cellray::game::DVec3;

use crate::steps::STEP;

/// The relative overlap, in squares of distances, that counts as none. Separating two balls leaves
/// an overlap of about 1e-16.
const ROUNDING: f64 = 1e-12;

/// A ball that moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// The position of its centre.
    pub centre: DVec3,
    /// Its movement in a second.
    pub velocity: DVec3,
    /// Its radius.
    pub radius: f64,
    /// Its mass.
    pub mass: f64,
}

impl Body {
    /// A ball at rest with the mass that fits its size.
    #[must_use]
    pub fn new(centre: DVec3, radius: f64) -> Self {
        Self { centre, velocity: DVec3::ZERO, radius, mass: radius * radius * radius }
    }

    /// The energy of its velocity.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.mass * self.velocity.length_squared() / 2.0
    }

    /// Reflects it at a wall with this normal, which it overlaps by `depth`. Returns whether it
    /// was moving towards the wall.
    pub fn rebound(&mut self, normal: DVec3, depth: f64, restitution: f64) -> bool {
        self.centre += normal * depth;
        let towards = -self.velocity.dot(normal);
        if towards > 0.0 {
            self.velocity += normal * ((1.0 + restitution) * towards);
        }
        towards > 0.0
    }

    /// Keeps it within a box by bouncing it off the walls.
    pub fn keep_within(&mut self, low: DVec3, high: DVec3, restitution: f64) {
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            let place = self.centre.dot(axis);
            let below = low.dot(axis) + self.radius - place;
            let above = place - (high.dot(axis) - self.radius);
            if below > 0.0 {
                self.rebound(axis, below, restitution);
            } else if above > 0.0 {
                self.rebound(-axis, above, restitution);
            }
        }
    }
}

/// Bounces two balls off one another if they touch, and returns whether they do.
///
/// Contacts are found after a step, when the balls already overlap. The direction of the bounce is
/// determined at the first contact, because a fast ball moves so far in a step that the line
/// between the centres has turned since then.
pub fn meet(a: &mut Body, b: &mut Body, restitution: f64) -> bool {
    let between = b.centre - a.centre;
    let reach = a.radius + b.radius;
    if between.length_squared() >= reach * reach {
        return false;
    }
    let since = since_contact(between, a.velocity - b.velocity, reach);
    a.centre -= a.velocity * since;
    b.centre -= b.velocity * since;
    let (ease_a, ease_b) = (1.0 / a.mass, 1.0 / b.mass);
    let ease = ease_a + ease_b;
    let (normal, _) = line_between(a, b);
    let closing = (a.velocity - b.velocity).dot(normal);
    if closing > 0.0 {
        let impulse = (1.0 + restitution) * closing / ease;
        a.velocity -= normal * (impulse * ease_a);
        b.velocity += normal * (impulse * ease_b);
    }
    a.centre += a.velocity * since;
    b.centre += b.velocity * since;
    let (normal, distance) = line_between(a, b);
    if distance < reach {
        let overlap = reach - distance;
        a.centre -= normal * (overlap * ease_a / ease);
        b.centre += normal * (overlap * ease_b / ease);
    }
    true
}

/// The direction from one ball to another, and the distance of their centres.
fn line_between(a: &Body, b: &Body) -> (DVec3, f64) {
    let between = b.centre - a.centre;
    let distance = between.length();
    // Two balls in one place may separate in any direction, as long as it is always the same.
    let normal = if distance > 0.0 { between / distance } else { DVec3::X };
    (normal, distance)
}

/// The seconds since two overlapping balls first touched. `between` is the vector from one to the
/// other, which approaches with the velocity `closing`. 0 if the contact was not within the last
/// step: then the balls already overlapped, and their movement did not cause the contact.
fn since_contact(between: DVec3, closing: DVec3, reach: f64) -> f64 {
    // |between + closing t| = reach has exactly one solution before now, because they are nearer
    // than that now.
    let (speed, along) = (closing.length_squared(), between.dot(closing));
    let depth = reach * reach - between.length_squared();
    if along <= 0.0 && depth < ROUNDING * reach * reach {
        // They are moving apart, and overlap only by the rounding of their last contact.
        return 0.0;
    }
    let root = (along * along + speed * depth).sqrt();
    let since = if along > 0.0 { depth / (along + root) } else { (root - along) / speed };
    if since <= STEP { since } else { 0.0 }
}

/// Calls `each` for every pair in a list, in order.
pub fn pairs<T>(list: &mut [T], mut each: impl FnMut(&mut T, &mut T)) {
    let mut rest = list;
    while let Some((first, others)) = rest.split_first_mut() {
        for other in others.iter_mut() {
            each(first, other);
        }
        rest = others;
    }
}

#[cfg(test)]
mod tests {
    use super::{Body, meet, pairs};
    use crate::steps::STEP;
    use cellray::game::DVec3;
    use rand::{Rng as _, SeedableRng as _};
    use rand_xoshiro::Xoshiro256PlusPlus;

    fn random(rng: &mut Xoshiro256PlusPlus, size: f64) -> DVec3 {
        DVec3::new(
            rng.random_range(-size..size),
            rng.random_range(-size..size),
            rng.random_range(-size..size),
        )
    }

    #[test]
    fn momentum_is_conserved_and_energy_does_not_grow() {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(1);
        let mut met = 0;
        for _ in 0..10_000 {
            let mut body = || Body {
                velocity: random(&mut rng, 3.0),
                ..Body::new(random(&mut rng, 1.0), rng.random_range(0.1..1.0))
            };
            let (mut a, mut b) = (body(), body());
            let restitution = rng.random_range(0.0..=1.0);
            let momentum = |a: &Body, b: &Body| a.velocity * a.mass + b.velocity * b.mass;
            let (before, energy) = (momentum(&a, &b), a.energy() + b.energy());
            met += u32::from(meet(&mut a, &mut b, restitution));
            assert!((momentum(&a, &b) - before).length() < 1e-12);
            assert!(a.energy() + b.energy() <= energy * (1.0 + 1e-14));
            assert!(a.centre.distance(b.centre) >= (a.radius + b.radius) * (1.0 - 1e-14));
        }
        assert!(met > 1000, "{met}");
    }

    /// Two balls of a pool ball's size. One moves along x at a speed, and the centre of the other
    /// is off its path by `offset`. They first touched this part of a step ago.
    fn cut(speed: f64, offset: f64, part: f64) -> (Body, Body) {
        let radius = 0.0286;
        let contact = (4.0 * radius * radius - offset * offset).sqrt();
        let moved = speed * STEP * part;
        let a =
            Body { velocity: DVec3::X * speed, ..Body::new(DVec3::X * (moved - contact), radius) };
        (a, Body::new(DVec3::Z * offset, radius))
    }

    #[test]
    fn colliding_balls_separate_along_line_of_centres() {
        for degrees in [0.0, 15.0, 30.0, 45.0, 60.0, 75.0] {
            for speed in [1.0, 2.5, 4.0, 6.0, 7.5] {
                for part in [0.01, 0.2, 0.4, 0.6, 0.8, 0.99] {
                    let (a, b) = cut(speed, 0.0572 * libm::sin(f64::to_radians(degrees)), part);
                    let (mut after_a, mut after_b) = (a, b);
                    assert!(meet(&mut after_a, &mut after_b, 0.95));
                    let went = libm::atan2(after_b.velocity.z, after_b.velocity.x).to_degrees();
                    let what = format!("{degrees} degrees, {speed} m/s, {part}: {went}");
                    assert!((went - degrees).abs() < 0.1, "{what}");
                    // Each has moved in its new direction for the rest of the step.
                    let gone = after_b.centre - b.centre;
                    assert!((gone - after_b.velocity * (part * STEP)).length() < 1e-9);
                }
            }
        }
    }

    #[test]
    fn balls_do_not_collide_twice_after_one_contact() {
        for degrees in [30.0, 60.0, 75.0, 85.0] {
            let (mut a, mut b) = cut(2.0, 0.0572 * libm::sin(f64::to_radians(degrees)), 0.1);
            assert!(meet(&mut a, &mut b, 0.0));
            let velocities = (a.velocity, b.velocity);
            for _ in 0..6 {
                meet(&mut a, &mut b, 0.0);
                assert_eq!((a.velocity, b.velocity), velocities, "{degrees} degrees");
            }
        }
    }

    #[test]
    fn coincident_balls_separate() {
        let mut balls = [Body::new(DVec3::ONE, 0.5); 2];
        let [a, b] = &mut balls;
        assert!(meet(a, b, 1.0));
        assert_eq!(a.centre.distance(b.centre), 1.0);
    }

    #[test]
    fn equal_balls_exchange_velocity_along_line_of_centres() {
        let mut balls = [
            Body { velocity: DVec3::new(2.0, 1.0, 0.0), ..Body::new(DVec3::ZERO, 0.5) },
            Body::new(DVec3::X * 0.9, 0.5),
        ];
        pairs(&mut balls, |a, b| {
            meet(a, b, 1.0);
        });
        assert_eq!(balls[0].velocity, DVec3::Y);
        assert_eq!(balls[1].velocity, DVec3::X * 2.0);
    }

    #[test]
    fn every_pair_is_visited_once() {
        let mut pairs_seen = Vec::new();
        pairs(&mut [0, 1, 2, 3], |a, b| pairs_seen.push((*a, *b)));
        assert_eq!(pairs_seen, [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]);
    }
}
