//! The way of the mouse around a scene.

use glam::{DQuat, DVec3};
use scenes::View;
use serde::Deserialize;

/// How far the eye has gone around the point that it looks at.
#[derive(Clone, Copy, Deserialize)]
pub struct Orbit {
    /// Radians about the view's upward axis.
    turn: f64,
    /// Radians towards it.
    rise: f64,
    /// The distance, as a multiple of the scene's own.
    distance: f64,
}

/// The cosine of the smallest angle between the line of sight and the upward axis.
const STEEPEST: f64 = 0.99;

impl Orbit {
    /// The view from there. At the start it is the scene's own, bit for bit.
    pub fn place(self, view: &View) -> View {
        let View { from, at, up, .. } = *view;
        let Self { turn, rise, distance } = self;
        if (turn, rise, distance) == (0.0, 0.0, 1.0) {
            return view.clone();
        }
        let axis = up.normalize();
        let away = DQuat::from_axis_angle(axis, turn) * (from - at);
        let side = axis.cross(away).normalize();
        let risen = DQuat::from_axis_angle(side, -rise) * away;
        let steep = risen.normalize().dot(axis).abs() > STEEPEST;
        let away: DVec3 = if steep { away } else { risen };
        View { from: at + away * distance, ..view.clone() }
    }
}
