//! The table: the positions of its cushions and pockets, in metres. x is along the table, and y is
//! the height above the bed.
//!
//! Invariant: a ball that is not within a pocket's reach can't get past the cushions, because
//! their noses and jaws leave no other gap.

use cellray::game::DVec3;

/// A ball's radius.
pub const RADIUS: f64 = 0.0286;
/// Half the size of the bed between the cushions' noses.
pub const HALF: (f64, f64) = (1.27, 0.635);
/// The distance from a cushion's nose back to the rail.
pub const CUSHION: f64 = 0.055;
/// The height of cushions and rails.
pub const HEIGHT: f64 = 0.04;
/// The width of the rails.
pub const RAIL: f64 = 0.13;
/// The places where the cue ball and the rack's first ball start.
pub const HEAD: DVec3 = DVec3::new(-0.635, RADIUS, 0.0);
/// See [`HEAD`].
pub const FOOT: DVec3 = DVec3::new(0.635, RADIUS, 0.0);

/// The distance from a corner to the nose's end, and how much farther out the jaw ends.
const CORNER: (f64, f64) = (0.085, 0.042);
/// The distance from the middle of a long side to the nose's end, and how much nearer to it the
/// jaw ends.
const SIDE: (f64, f64) = (0.066, 0.014);

/// A pocket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pocket {
    /// Its centre on the bed.
    pub centre: DVec3,
    /// The distance from a ball's centre within which the ball falls.
    pub reach: f64,
}

/// The six pockets.
pub const POCKETS: [Pocket; 6] = [
    corner(-1.0, -1.0),
    side(-1.0),
    corner(1.0, -1.0),
    corner(-1.0, 1.0),
    side(1.0),
    corner(1.0, 1.0),
];

const fn corner(x: f64, z: f64) -> Pocket {
    Pocket { centre: DVec3::new(x * (HALF.0 + 0.016), 0.0, z * (HALF.1 + 0.016)), reach: 0.06 }
}

const fn side(z: f64) -> Pocket {
    Pocket { centre: DVec3::new(0.0, 0.0, z * (HALF.1 + 0.04)), reach: 0.05 }
}

/// A cushion: its nose, from left to right as seen from the middle of the bed, and the ends of its
/// jaws at the rail.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cushion {
    /// The nose's ends.
    pub nose: [DVec3; 2],
    /// The rear ends of the jaws, which begin at the nose's ends.
    pub back: [DVec3; 2],
}

impl Cushion {
    /// The lines that a ball bounces off: jaw, nose, jaw.
    #[must_use]
    pub fn lines(&self) -> [[DVec3; 2]; 3] {
        let ([a, b], [behind_a, behind_b]) = (self.nose, self.back);
        [[behind_a, a], [a, b], [b, behind_b]]
    }
}

/// The six cushions.
pub const CUSHIONS: [Cushion; 6] =
    [long(-1.0, -1.0), long(1.0, -1.0), long(-1.0, 1.0), long(1.0, 1.0), short(-1.0), short(1.0)];

/// Half of the long side at z, on the side of the side pocket that the sign of x gives.
const fn long(x: f64, z: f64) -> Cushion {
    let (nose, back) = (z * HALF.1, z * (HALF.1 + CUSHION));
    let far = [x * (HALF.0 - CORNER.0), x * (HALF.0 - CORNER.0 + CORNER.1)];
    let near = [x * SIDE.0, x * (SIDE.0 - SIDE.1)];
    // Seen from the middle of the bed, x grows to the right where z is negative, and to the left
    // where z is positive.
    let [left, right] = if x * z > 0.0 { [far, near] } else { [near, far] };
    Cushion {
        nose: [DVec3::new(left[0], 0.0, nose), DVec3::new(right[0], 0.0, nose)],
        back: [DVec3::new(left[1], 0.0, back), DVec3::new(right[1], 0.0, back)],
    }
}

/// The short side at x.
const fn short(x: f64) -> Cushion {
    let (nose, back) = (x * HALF.0, x * (HALF.0 + CUSHION));
    let z = [HALF.1 - CORNER.0, HALF.1 - CORNER.0 + CORNER.1];
    Cushion {
        nose: [DVec3::new(nose, 0.0, -x * z[0]), DVec3::new(nose, 0.0, x * z[0])],
        back: [DVec3::new(back, 0.0, -x * z[1]), DVec3::new(back, 0.0, x * z[1])],
    }
}

/// The point of a line nearest to a place.
#[must_use]
pub fn nearest([a, b]: [DVec3; 2], place: DVec3) -> DVec3 {
    let along = b - a;
    let part = (place - a).dot(along) / along.length_squared();
    a + along * part.clamp(0.0, 1.0)
}
