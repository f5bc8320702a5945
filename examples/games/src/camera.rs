//! An eye that follows a goal.

use cellray::game::DVec3;

/// The speed at the goal is that of an exponential approach from this distance, in metres.
const EVEN: f64 = 0.02;

/// Moves towards a goal, the faster the farther away it is, but at least so fast that the eye
/// arrives soon: while it rests, only moving objects must be traced. `part` is the share of a long
/// way that is covered. A position that has arrived stays exactly the same however long the frames
/// are.
#[must_use]
pub fn follow(from: DVec3, to: DVec3, part: f64) -> DVec3 {
    let way = to - from;
    let length = way.length();
    let step = (length + EVEN) * part;
    if step >= length { to } else { from + way * (step / length) }
}

#[cfg(test)]
mod tests {
    use super::follow;
    use cellray::game::DVec3;

    #[test]
    fn arrived_camera_stays_for_any_frame_time() {
        let (mut eye, to) = (DVec3::new(0.3, -7.1, 2.9), DVec3::new(0.1, 0.7, 1.3));
        for frame in 0..400 {
            eye = follow(eye, to, 0.05 + 0.001 * f64::from(frame % 97));
        }
        assert_eq!(eye, to);
        for part in [0.0, 0.013, 0.3, 0.9999, 1.0] {
            assert_eq!(follow(eye, to, part), to);
        }
    }
}
