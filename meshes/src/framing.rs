//! The view and the lights of a file that has none.

use glam::DVec3;
use nff::{Light, LightKind, View};

/// The colour behind the mesh.
pub(crate) const BACKGROUND: DVec3 = DVec3::new(0.55, 0.65, 0.8);
/// The ambient light.
pub(crate) const AMBIENT: DVec3 = DVec3::splat(0.2);
/// The angle of the view in degrees.
const ANGLE: f64 = 40.0;
/// The distance of the eye, relative to the nearest from which all is in the picture.
const MARGIN: f64 = 1.02;

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
    fn direction(self, right: f64, up: f64, near: f64) -> DVec3 {
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
        from: middle + distance * up.direction(0.4, 0.35, 1.0).normalize(),
        at: middle,
        up: up.direction(0.0, 1.0, 0.0),
        angle: ANGLE,
        hither: 0.0,
        resolution: (512, 512),
    }
}

/// A sun from the left above, and the ambient light.
pub(crate) fn lights(up: Up) -> (Vec<Light>, DVec3) {
    let sun = Light {
        line: 0,
        kind: LightKind::Directional {
            to_light: up.direction(-0.5, 1.0, 0.8),
        },
        colour: Some(DVec3::splat(0.8)),
    };
    (vec![sun], AMBIENT)
}
