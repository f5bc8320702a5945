//! The view and the lights of a file that has none.

use glam::DVec3;
use nff::{Light, LightKind, View};

/// The colour behind the mesh.
pub(crate) const BACKGROUND: DVec3 = DVec3::new(0.55, 0.65, 0.8);
/// The ambient light.
pub(crate) const AMBIENT: DVec3 = DVec3::splat(0.2);
/// The direction to the eye from the middle of the mesh: from the front, to the right and above,
/// where y is up and z towards the viewer, as glTF has it and OBJ files mostly do.
const TO_EYE: DVec3 = DVec3::new(0.4, 0.35, 1.0);
/// The angle of the view in degrees.
const ANGLE: f64 = 40.0;
/// The distance of the eye, relative to the nearest from which all is in the picture.
const MARGIN: f64 = 1.02;

/// A view of everything in a box.
pub(crate) fn view(low: DVec3, high: DVec3) -> View {
    let middle = low.midpoint(high);
    let radius = high.distance(low) / 2.0;
    // A mesh of a single point is looked at from a distance that its coordinates can tell from 0.
    let radius = radius.max(1e-3 * middle.abs().max_element()).max(1e-6);
    let distance = MARGIN * radius / libm::sin((ANGLE / 2.0).to_radians());
    View {
        from: middle + distance * TO_EYE.normalize(),
        at: middle,
        up: DVec3::Y,
        angle: ANGLE,
        hither: 0.0,
        resolution: (512, 512),
    }
}

/// A sun from the left above, and the ambient light.
pub(crate) fn lights() -> (Vec<Light>, DVec3) {
    let sun = Light {
        line: 0,
        kind: LightKind::Directional {
            to_light: DVec3::new(-0.5, 1.0, 0.8),
        },
        colour: Some(DVec3::splat(0.8)),
    };
    (vec![sun], AMBIENT)
}
