//! The view and the lights of a file that has none, and the target of a view that has none.

use glam::{DMat3, DVec3};
use scenes::{Light, LightKind, View};

pub(crate) const BACKGROUND: DVec3 = DVec3::new(0.55, 0.65, 0.8);
pub(crate) const AMBIENT: DVec3 = DVec3::splat(0.2);
/// The angle of the view in degrees.
const ANGLE: f64 = 40.0;
/// The distance of the eye, relative to the nearest from which all is in the picture.
const MARGIN: f64 = 1.02;
/// The sine of the angle up to which a horizon counts as level. Over a picture of 8192 pixels, that
/// is a tenth of a pixel.
const LEVEL: f64 = 1e-5;
/// The direction from the middle to the eye: to the right, up, and towards the viewer.
const TO_EYE: [f64; 3] = [0.4, 0.35, 1.0];
/// The direction to the sun, in the same way.
const TO_SUN: [f64; 3] = [-0.5, 1.0, 0.8];

/// The axis that points up in a file.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) enum Up {
    /// As glTF has it and OBJ files mostly do, with z towards the viewer.
    #[default]
    Y,
    /// As programs for construction and printing have it, with y away from the viewer.
    Z,
}

impl Up {
    /// The direction in a file of one that is to the right, up and towards the viewer.
    fn direction(self, [right, up, near]: [f64; 3]) -> DVec3 {
        match self {
            Self::Y => DVec3::new(right, up, near),
            Self::Z => DVec3::new(right, -near, up),
        }
    }
}

/// A view of everything in a box, from the front, to the right and above.
pub(crate) fn view(low: DVec3, high: DVec3, up: Up) -> View {
    let middle = low.midpoint(high);
    let radius = (high.distance(low) / 2.0).max(f64::MIN_POSITIVE);
    let distance = MARGIN * radius / libm::sin((ANGLE / 2.0).to_radians());
    View {
        from: middle + distance * up.direction(TO_EYE).normalize(),
        at: middle,
        up: up.direction([0.0, 1.0, 0.0]),
        angle: ANGLE,
        hither: 0.0,
        resolution: (512, 512),
    }
}

/// The view of a camera that has a direction but no target, which now looks at the point in that
/// direction that is nearest to the middle of everything in a box. That is where the box is in the
/// picture, so that one can turn around it, as one could not around a point close to the eye. If
/// the camera is upright, its direction up becomes the file's, for the same reason.
pub(crate) fn aimed(view: View, low: DVec3, high: DVec3, up: Up) -> View {
    let Some(sight) = scenes::unit(view.at - view.from) else {
        return view;
    };
    let middle = low.midpoint(high);
    let depth = sight.dot(middle - view.from);
    // Whoever looks out of the box or away from it sees something at about its size.
    let distance = depth.max(low.distance(high) / 4.0);
    let pole = up.direction([0.0, 1.0, 0.0]);
    let right = sight.cross(view.up).normalize_or_zero();
    let is_upright = right.dot(pole).abs() < LEVEL && view.up.dot(pole) > 0.0;
    let aimed = View {
        at: view.from + distance * sight,
        up: if is_upright { pole } else { view.up },
        ..view
    };
    // The distance may be less than the rounding error of a position far from the origin.
    let (width, height) = aimed.resolution;
    match aimed.camera(width, height) {
        Ok(_) => aimed,
        Err(_) => view,
    }
}

/// A sun and the ambient light. For the view of a box the sun is to the left above. Any other view
/// has it at the same place as seen from the eye: a sun at the back would leave the visible side
/// in the dark.
pub(crate) fn lights(up: Up, view: Option<&View>) -> (Vec<Light>, DVec3) {
    let sun = up.direction(TO_SUN);
    let usual = axes(up.direction(TO_EYE), up.direction([0.0, 1.0, 0.0]));
    let to_light = match view {
        Some(view) => axes(view.from - view.at, view.up) * (usual.transpose() * sun),
        None => sun,
    };
    let sun = Light {
        line: 0,
        kind: LightKind::Directional { to_light },
        colour: Some(DVec3::splat(0.8)),
    };
    (vec![sun], AMBIENT)
}

/// The directions to the right, up and back of an eye, from that from its target to it.
fn axes(back: DVec3, up: DVec3) -> DMat3 {
    let back = back.normalize();
    let right = up.cross(back).normalize();
    DMat3::from_cols(right, back.cross(right), back)
}
