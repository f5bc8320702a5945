//! An eye that follows a goal.

use cellray::game::DVec3;

/// Below this distance, the eye counts as arrived, because the difference is invisible.
const ARRIVED: f64 = 1e-5;

/// Moves this part of the way. A position that has arrived stays exactly the same however long the
/// frames are. Otherwise a picture without movement would be traced again and again.
#[must_use]
pub fn follow(from: DVec3, to: DVec3, part: f64) -> DVec3 {
    let way = to - from;
    if way.length_squared() < ARRIVED * ARRIVED { to } else { from + way * part }
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
