//! The physics of the balls: they slide, roll, bounce and fall.
//!
//! Each ball has a velocity and a roll, which is the velocity at which it would roll without
//! sliding at its present spin. While the two differ, the ball slides on the cloth, which makes
//! them equal. Follow and draw shots result from this. There is no spin about the vertical axis.
//! Invariants: energy never grows; all centres on the bed are at one height; balls at rest overlap
//! by no more than rounding.

use cellray::game::DVec3;
use rand::seq::SliceRandom as _;
use rand_xoshiro::Xoshiro256PlusPlus;

use super::rules::{EIGHT, Shot};
use super::table::{CUSHIONS, FOOT, HALF, HEAD, POCKETS, RADIUS, nearest};
use crate::bodies::{Body, meet, pairs};
use crate::steps::STEP;

/// The number of balls including the cue ball, which is number 0.
pub const BALLS: usize = 16;

const GRAVITY: f64 = 9.81;
/// Coefficients of friction for a ball that slides, and for one that rolls.
const SLIDING: f64 = 0.2;
const ROLLING: f64 = 0.014;
/// Coefficients of restitution between two balls, and between a ball and a cushion.
const BALL_RESTITUTION: f64 = 0.95;
const CUSHION_RESTITUTION: f64 = 0.8;
/// The share of the velocity along a cushion, and of the roll, that remains after a bounce.
const CUSHION_GRIP: f64 = 0.96;
const CUSHION_ROLL: f64 = 0.55;
/// The gap between balls in the rack.
const GAP: f64 = 0.0004;
/// How often contacts are searched for in a step as long as there are any, because a rack passes
/// an impact on from ball to ball.
const ROUNDS: usize = 6;
/// How often a step is halved to find a moment in it. The position is then exact to less than an
/// atom's width at any speed.
const HALVINGS: usize = 28;
/// A ball in a pocket that is lower than this has been pocketed.
const DEPTH: f64 = 2.0 * RADIUS;

/// Where a ball is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// On the bed.
    Bed,
    /// Falling into the pocket with this index.
    Falling(usize),
    /// Pocketed.
    Gone,
}

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// 0 for the cue ball.
    pub number: usize,
    /// Its position and velocity.
    pub body: Body,
    /// The velocity at which it would roll without sliding at its present spin.
    pub roll: DVec3,
    /// A unit vector that turns with the ball.
    pub axis: DVec3,
    /// Where it is.
    pub place: Place,
}

impl Ball {
    fn new(number: usize, centre: DVec3) -> Self {
        Self {
            number,
            body: Body { mass: 1.0, ..Body::new(centre, RADIUS) },
            roll: DVec3::ZERO,
            // Each ball starts with another orientation, which is the same in every game, so that
            // the paint on most of them is visible.
            axis: tipped(number),
            place: Place::Bed,
        }
    }

    /// The energy of its velocity and its spin. The mass is 1.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.body.energy() + self.roll.length_squared() / 5.0
    }

    fn moves(&self) -> bool {
        match self.place {
            Place::Bed => self.body.velocity != DVec3::ZERO || self.roll != DVec3::ZERO,
            Place::Falling(_) => true,
            Place::Gone => false,
        }
    }

    /// Moves it for one step on the bed, ignoring the other balls.
    fn run(&mut self) {
        let body = &mut self.body;
        let slip = body.velocity - self.roll;
        let (speed, grip) = (slip.length(), SLIDING * GRAVITY * STEP);
        // The friction that slows the ball increases the roll by the same impulse, and the roll
        // changes two and a half times as much.
        if speed > 3.5 * grip {
            let push = slip * (grip / speed);
            body.velocity -= push;
            self.roll += push * 2.5;
        } else {
            body.velocity -= slip / 3.5;
            let (speed, drag) = (body.velocity.length(), ROLLING * GRAVITY * STEP);
            if speed > drag {
                body.velocity *= 1.0 - drag / speed;
            } else {
                body.velocity = DVec3::ZERO;
            }
            self.roll = body.velocity;
        }
        body.centre += body.velocity * STEP;
        let spin = DVec3::new(self.roll.z, 0.0, -self.roll.x) / RADIUS;
        let axis = self.axis + spin.cross(self.axis) * STEP;
        self.axis = axis / axis.length();
    }

    /// Bounces it off the cushions that it touches. Returns whether there are any.
    fn bounce(&mut self) -> bool {
        let DVec3 { x, z, .. } = self.body.centre;
        if x.abs() < HALF.0 - RADIUS && z.abs() < HALF.1 - RADIUS {
            return false;
        }
        let mut touched = false;
        for line in CUSHIONS.iter().flat_map(|cushion| cushion.lines()) {
            let away_before = |seconds: f64| {
                let place = self.body.centre - self.body.velocity * seconds;
                let on_bed = DVec3::new(place.x, 0.0, place.z);
                on_bed - nearest(line, on_bed)
            };
            if away_before(0.0).length() >= RADIUS {
                continue;
            }
            let since = since_contact(|seconds| away_before(seconds).length());
            let away = away_before(since);
            let distance = away.length();
            if distance == 0.0 {
                continue;
            }
            touched = true;
            let normal = away / distance;
            self.body.centre -= self.body.velocity * since;
            if self.body.rebound(normal, RADIUS - distance, CUSHION_RESTITUTION) {
                let across = normal * self.body.velocity.dot(normal);
                let along = self.body.velocity - across;
                self.body.velocity = across + along * CUSHION_GRIP;
                self.roll *= CUSHION_ROLL;
            }
            self.body.centre += self.body.velocity * since;
        }
        touched
    }

    /// The pocket that the ball falls into.
    fn pocket(&self) -> Option<usize> {
        let on_bed = DVec3::new(self.body.centre.x, 0.0, self.body.centre.z);
        let far = |pocket: usize| POCKETS[pocket].centre.distance(on_bed);
        let near = (0..POCKETS.len()).min_by(|&a, &b| far(a).total_cmp(&far(b)))?;
        // A ball that has passed the jaws can only fall.
        let past = on_bed.x.abs() > HALF.0 + RADIUS || on_bed.z.abs() > HALF.1 + RADIUS;
        (past || far(near) < POCKETS[near].reach).then_some(near)
    }

    /// Moves it for one step down a pocket.
    fn fall(&mut self, pocket: usize) {
        let body = &mut self.body;
        let middle = POCKETS[pocket].centre;
        let on_bed = DVec3::new(body.centre.x, 0.0, body.centre.z);
        // The pocket's wall stops a ball that would fly on.
        body.velocity.x = (middle.x - on_bed.x) * 8.0;
        body.velocity.z = (middle.z - on_bed.z) * 8.0;
        body.velocity.y -= GRAVITY * STEP;
        body.centre += body.velocity * STEP;
        if body.centre.y < -DEPTH {
            self.place = Place::Gone;
            self.body.velocity = DVec3::ZERO;
            self.roll = DVec3::ZERO;
        }
    }
}

/// All balls.
#[derive(Clone, Debug, PartialEq)]
pub struct Balls(pub [Ball; BALLS]);

impl Balls {
    /// The rack in random order, with the eight in the middle and balls of different groups in the
    /// back corners.
    #[must_use]
    pub fn rack(chance: &mut Xoshiro256PlusPlus) -> Self {
        const MIDDLE: usize = 4;
        const CORNERS: [usize; 2] = [10, 14];
        let mut order = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15];
        order.shuffle(chance);
        let place_of = |order: &[usize], number| order.iter().position(|&ball| ball == number);
        if let Some(eight) = place_of(&order, EIGHT) {
            order.swap(eight, MIDDLE);
        }
        let striped = |ball: usize| ball > EIGHT;
        if striped(order[CORNERS[0]]) == striped(order[CORNERS[1]]) {
            let wanted = !striped(order[CORNERS[0]]);
            let other =
                (0..order.len()).find(|&place| place != MIDDLE && striped(order[place]) == wanted);
            if let Some(other) = other {
                order.swap(other, CORNERS[1]);
            }
        }
        let mut balls = [Ball::new(0, HEAD); BALLS];
        let (mut row, mut column) = (0, 0);
        for number in order {
            let apart = 2.0 * RADIUS + GAP;
            let centre = FOOT
                + DVec3::new(
                    f64::from(row) * apart * 3.0_f64.sqrt() / 2.0,
                    0.0,
                    (f64::from(column) - f64::from(row) / 2.0) * apart,
                );
            balls[number] = Ball::new(number, centre);
            (row, column) = if column == row { (row + 1, 0) } else { (row, column + 1) };
        }
        Self(balls)
    }

    /// Whether no ball moves.
    #[must_use]
    pub fn are_at_rest(&self) -> bool {
        !self.0.iter().any(Ball::moves)
    }

    /// Whether the ball with this number is on the bed.
    #[must_use]
    pub fn on_bed(&self, number: usize) -> bool {
        self.0[number].place == Place::Bed
    }

    /// The energy of all balls.
    #[must_use]
    pub fn energy(&self) -> f64 {
        let on_bed = self.0.iter().filter(|ball| ball.place == Place::Bed);
        on_bed.map(Ball::energy).sum()
    }

    /// Strikes the cue ball with a speed in a direction. The height, -1 to 1, is where the tip
    /// hits: above the middle the ball follows, and below it the ball is drawn back.
    pub fn strike(&mut self, direction: DVec3, speed: f64, height: f64) {
        let ball = &mut self.0[0];
        ball.body.velocity = direction * speed;
        // Half a radius off the middle is the limit at which chalk prevents a miscue.
        ball.roll = direction * (speed * height * 1.25);
    }

    /// Puts the cue ball on the head spot, or as near to it as other balls allow.
    pub fn bring_back(&mut self) {
        let free = |place: DVec3| {
            self.0[1..]
                .iter()
                .filter(|ball| ball.place == Place::Bed)
                .all(|ball| ball.body.centre.distance(place) > 2.0 * RADIUS)
        };
        // Fifteen balls can't cover all of these places.
        let places = (0..32).map(|step| {
            let side = if step % 2 == 0 { 1.0 } else { -1.0 };
            HEAD + DVec3::Z * (side * f64::from(step / 2) * RADIUS * 1.2)
        });
        let place = places.clone().find(|&place| free(place)).unwrap_or(HEAD);
        self.0[0] = Ball::new(0, place);
    }

    /// Moves all balls for one step, and records the events of the shot.
    pub fn step(&mut self, shot: &mut Shot) {
        for ball in &mut self.0 {
            match ball.place {
                Place::Bed => ball.run(),
                Place::Falling(pocket) => ball.fall(pocket),
                Place::Gone => {}
            }
        }
        for _ in 0..ROUNDS {
            if !self.bounce(shot) {
                break;
            }
        }
        for ball in &mut self.0 {
            if ball.place == Place::Bed
                && let Some(pocket) = ball.pocket()
            {
                ball.place = Place::Falling(pocket);
                shot.pocket(ball.number);
            }
        }
    }

    /// Bounces balls off one another and off the cushions. Returns whether anything touched.
    fn bounce(&mut self, shot: &mut Shot) -> bool {
        let mut touched = false;
        pairs(&mut self.0, |a, b| {
            if a.place == Place::Bed
                && b.place == Place::Bed
                && meet(&mut a.body, &mut b.body, BALL_RESTITUTION)
            {
                touched = true;
                if a.number == 0 {
                    shot.touch(b.number);
                }
            }
        });
        for ball in &mut self.0 {
            if ball.place == Place::Bed {
                touched |= ball.bounce();
            }
        }
        touched
    }
}

/// The seconds since a ball first touched a cushion that it now overlaps. `distance_before`
/// returns its distance from the cushion a number of seconds ago. 0 if the contact was more than a
/// step ago. At an end of a line, the ball bounces according to its position at the contact,
/// because it passes a jaw's corner within a step.
fn since_contact(distance_before: impl Fn(f64) -> f64) -> f64 {
    let (mut within, mut out) = (0.0, STEP);
    if distance_before(out) < RADIUS {
        return 0.0;
    }
    // Along a straight path, the distance from a line has only one minimum, so there is only one
    // moment to find.
    for _ in 0..HALVINGS {
        let middle = (within + out) / 2.0;
        if distance_before(middle) < RADIUS {
            within = middle;
        } else {
            out = middle;
        }
    }
    out
}

/// A direction for each number, far from those of the other numbers.
fn tipped(number: usize) -> DVec3 {
    let turn = number as f64 * 2.4;
    let (sine, cosine) = libm::sincos(turn);
    let axis = DVec3::new(cosine, 0.55, sine);
    axis / axis.length()
}

#[cfg(test)]
mod tests {
    use super::{Ball, CUSHION_GRIP, CUSHION_RESTITUTION};
    use crate::billiards::table::{CUSHIONS, RADIUS};
    use crate::steps::STEP;
    use cellray::game::DVec3;

    #[test]
    fn ball_bounces_off_jaw_corner_along_contact_normal() {
        // The end of a long cushion next to the side pocket at negative z.
        let [corner, _] = CUSHIONS[1].nose;
        for degrees in [10.0, 25.0, 40.0, 55.0, 70.0] {
            let (sine, cosine) = libm::sincos(f64::to_radians(degrees));
            let normal = DVec3::new(-sine, 0.0, cosine);
            for speed in [1.0, 3.0, 7.0] {
                for part in [0.01, 0.3, 0.6, 0.99] {
                    let before = DVec3::NEG_Z * speed;
                    let moved = before * (part * STEP);
                    let mut ball = Ball::new(1, corner + normal * RADIUS + DVec3::Y * RADIUS);
                    ball.body.centre += moved;
                    ball.body.velocity = before;
                    assert!(ball.bounce());
                    let across = normal * before.dot(normal);
                    let after = (before - across) * CUSHION_GRIP - across * CUSHION_RESTITUTION;
                    let off = (ball.body.velocity - after).length();
                    assert!(off < 1e-5 * speed, "{degrees} degrees, {speed} m/s, {part}: {off}");
                }
            }
        }
    }
}
